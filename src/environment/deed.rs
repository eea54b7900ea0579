//! What bodies do for each effect of the transition rule.

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Action, Edge, Effect, Kind, NodeId, Place, Pose, Property, Relation, SceneGraph, State, Verb, rule};
use vc_physics::{BodyPlan, Floor, Hand, Order, Posture, Shapes, Stand, World};

use super::beat::Beat;
use super::make::room_at;
use super::undo::Step;
use super::{ActionError, Impossible};

/// How far ahead of the body a hand puts things down, metres.
const AHEAD: f32 = 0.45;
/// Steps after which a door that moves counts as stuck.
const DRIVING: u32 = 300;
/// Least part of its way a door has to open.
const WIDE: f32 = 0.35;
/// Free floor that agents keep from each other, metres.
const APART: f32 = 0.55;
/// How full a vessel is that has been filled.
const FULL: f32 = 0.8;
/// How long a gesture takes, seconds.
const GESTURE: f32 = 1.5;

/// An agent at its action: it moves bodies and notes what it did.
pub(super) struct Deed<'a> {
    pub(super) world: &'a mut World,
    pub(super) floor: &'a mut Floor,
    pub(super) shapes: &'a Shapes,
    /// The scene before, and as the rule says it is after.
    pub(super) before: &'a SceneGraph,
    pub(super) after: &'a SceneGraph,
    pub(super) agent: NodeId,
    pub(super) run: bool,
    pub(super) beats: Vec<Beat>,
}

type Done = Result<(), Impossible>;

impl<'a> Deed<'a> {
    pub(super) fn new(world: &'a mut World, floor: &'a mut Floor, shapes: &'a Shapes, step: &'a Step) -> Self {
        let Step { before, after, agent, action } = step;
        let run = action.verb == Verb::Run;
        Self { world, floor, shapes, before, after, agent: *agent, run, beats: Vec::new() }
    }
}

impl Deed<'_> {
    /// Does what the rule says of an action.
    pub(super) fn all(&mut self, action: &Action) -> Result<(), ActionError> {
        let effects = rule::effects(action);
        let done = self.come_near(action).and_then(|()| effects.iter().try_for_each(|e| self.one(e)));
        done.map_err(|why| ActionError::Impossible { action: action.describe(self.before).to_string(), why })?;
        if effects.is_empty() || matches!(effects[0], Effect::Enter(..) if !self.moved_anything()) {
            self.beats.push(Beat::Gesture(action.verb, GESTURE));
        }
        Ok(())
    }

    fn moved_anything(&self) -> bool {
        self.beats.iter().any(|b| matches!(b, Beat::Drive(..)))
    }

    fn one(&mut self, effect: &Effect<NodeId>) -> Done {
        match *effect {
            Effect::Enter(id, State::Open) => self.drive(id, 1.0),
            Effect::Enter(id, State::Closed) => self.drive(id, 0.0),
            Effect::Approach(id) if self.before.near(self.agent, id) => self.face(id),
            Effect::GoTo(id) | Effect::Approach(id) => self.go_to(id),
            Effect::Face(id) => self.face(id),
            Effect::Hold(id) => self.hold(id),
            Effect::PutOn(id, at) => self.put(id, Place { relation: Relation::On, at }),
            Effect::PutInto(id, at) => self.put(id, Place { relation: Relation::Inside, at }),
            Effect::PutWhereItWas(id) => match self.after.place(id) {
                Some(place) => self.put(id, place),
                None => self.let_go(id),
            },
            Effect::LetGo(id) => self.let_go(id),
            Effect::SitOn(id) => self.rest_on(id, false),
            Effect::LieOn(id) => self.rest_on(id, true),
            Effect::StandUp => self.get_up(),
            Effect::PourInto(id, into) => self.pour(id, into),
            Effect::FillWithWater(id) => {
                self.level(id, FULL);
                Ok(())
            }
            Effect::PutOnBody(id) => self.dress(id),
            Effect::Board(_) | Effect::Alight | Effect::DriveTo(..) => {
                Err(Impossible::NotModelled("nobody gets into vehicles here yet: `World::add_vehicle` drives them"))
            }
            // Dirt, heat, sleep: states that no body has.
            _ => Ok(()),
        }
    }

    /// Steps within reach of what the action is done to, if the agent stands.
    fn come_near(&mut self, action: &Action) -> Done {
        use Verb::{
            Dance, Drive, Enter, Exercise, Find, Greet, LookAt, PointAt, Run, Stretch, TurnTo, Walk, Watch, Wave,
        };
        let by_hand = !matches!(
            action.verb,
            Walk | Run
                | Find
                | TurnTo
                | LookAt
                | PointAt
                | Watch
                | Greet
                | Enter
                | Drive
                | Dance
                | Wave
                | Exercise
                | Stretch
        );
        let rests = matches!(action.verb, Verb::Sit | Verb::Lie);
        // One puts things where there is room, which is looked for later.
        let puts = matches!(action.verb, Verb::Place | Verb::PutIn | Verb::PutBack);
        match action.things().find(|id| !self.is_mine(*id)) {
            // What hangs under the ceiling is switched at the wall, wherever the switch is.
            Some(id) if matches!(action.verb, Verb::SwitchOn | Verb::SwitchOff) && self.is_overhead(id) => {
                self.face(id)
            }
            Some(id) if by_hand && !rests && !puts && !matches!(action.verb, Verb::Open | Verb::Close) => {
                self.reach(id)
            }
            _ => Ok(()),
        }
    }

    /// Whether the agent holds or wears a thing, or what it is on.
    fn is_mine(&self, id: NodeId) -> bool {
        self.before.rests_at(id, self.agent)
    }

    fn plan(&self) -> BodyPlan {
        self.world.body_plan(self.agent).copied().unwrap_or_default()
    }

    fn feet(&self) -> Pose {
        self.world.pose(self.agent).unwrap_or_else(Pose::identity)
    }

    fn stands(&self) -> bool {
        self.world.posture(self.agent) == Some(Posture::Standing)
    }

    /// Brings a thing within reach of the hands: by turning, by a step or by a walk.
    fn reach(&mut self, id: NodeId) -> Done {
        let body = self.body_of(id)?;
        let reach = self.plan().reach;
        if self.world.reach_to(self.agent, body)? <= reach {
            return self.face(body);
        }
        if !self.stands() {
            let distance = self.world.reach_to(self.agent, body)?;
            return Err(vc_physics::AgentError::OutOfReach { agent: self.agent, id: body, distance, reach }.into());
        }
        self.floor.update(self.world);
        let stand = self.stand_at(body, self.before.room_of(self.agent))?;
        self.walk(stand.ok_or_else(|| Impossible::NoStand(self.before.label(id)))?);
        Ok(())
    }

    /// Whether a thing is higher than one reaches.
    fn is_overhead(&self, id: NodeId) -> bool {
        let top = self.feet().translation.z + self.plan().shoulder() + self.plan().reach;
        self.world.aabb(id).is_some_and(|aabb| aabb.min.z > top)
    }

    /// The thing itself, or what it is on or in if it has no body.
    fn body_of(&self, id: NodeId) -> Result<NodeId, Impossible> {
        let chain = std::iter::once(id).chain(self.before.support_chain(id));
        let body = chain.into_iter().find(|id| self.world.aabb(*id).is_some());
        body.ok_or_else(|| Impossible::NoBody(self.before.label(id)))
    }

    /// A spot in a room from which the agent reaches a thing: where it sees it too, if
    /// there is one.
    fn stand_at(&self, id: NodeId, room: Option<NodeId>) -> Result<Option<Stand>, Impossible> {
        let sees = |feet: &Pose| self.floor.sees(self.world, &self.plan(), feet, id);
        let found = self.stand_where(id, room, sees)?;
        if found.is_some() { Ok(found) } else { self.stand_where(id, room, |_| true) }
    }

    fn stand_where(
        &self,
        id: NodeId,
        room: Option<NodeId>,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<Stand>, Impossible> {
        let from = self.feet().translation.vector.xy().into();
        let good = |feet: &Pose| self.is_good(feet, room) && admits(feet);
        Ok(self.floor.stand_where(self.world, &self.plan(), from, id, good)?)
    }

    /// Whether the agent may stand somewhere: in a room, where nobody else is, and free.
    fn is_good(&self, feet: &Pose, room: Option<NodeId>) -> bool {
        let spot = Point2::from(feet.translation.vector.xy());
        let level = self.floor.plan().level;
        room.is_none_or(|r| room_at(self.before, self.world, &spot, level) == Some(r))
            && self.is_unclaimed(&spot)
            && self.world.stands_free(self.agent, feet).unwrap_or(false)
    }

    /// Whether no other agent is at a spot.
    fn is_unclaimed(&self, spot: &Point2<f32>) -> bool {
        let others = self.world.agents().filter(|a| *a != self.agent);
        others.filter_map(|a| self.world.pose(a)).all(|p| (p.translation.vector.xy() - spot.coords).norm() >= APART)
    }

    /// Walks to a spot at once.
    fn walk(&mut self, stand: Stand) {
        let Stand { feet, route } = stand;
        // The pose is finite and the agent is there.
        let _ = self.world.teleport(self.agent, feet);
        self.beats.push(Beat::Walk { points: route.points, doors: route.doors, feet, run: self.run });
    }

    fn go_to(&mut self, id: NodeId) -> Done {
        self.floor.update(self.world);
        let kind = self.before.node(id).map(vc_graph::Node::kind);
        let stand = match kind {
            Some(Kind::Room) => self.stand_in(id),
            Some(Kind::Agent) => self.stand_beside(id),
            _ => self.stand_before(id)?,
        };
        let stand = stand.ok_or_else(|| Impossible::NoStand(self.before.label(id)))?;
        self.walk(stand);
        Ok(())
    }

    /// Before a thing: within reach, else beside it, else the same for what it is on or in.
    fn stand_before(&self, id: NodeId) -> Result<Option<Stand>, Impossible> {
        for id in std::iter::once(id).chain(self.before.support_chain(id)) {
            let reach = match self.world.aabb(id) {
                Some(_) => self.stand_at(id, self.before.room_of(id))?,
                None => None,
            };
            if let Some(stand) = reach.or_else(|| self.stand_beside(id)) {
                return Ok(Some(stand));
            }
        }
        Ok(None)
    }

    /// As near as possible to the middle of a room.
    fn stand_in(&self, room: NodeId) -> Option<Stand> {
        let from: Point2<f32> = self.feet().translation.vector.xy().into();
        let aabb = self.before.node(room)?.aabb()?;
        if self.before.room_of(self.agent) == Some(room) {
            let route = self.floor.route(from, from)?;
            return Some(Stand { feet: self.feet(), route });
        }
        self.nearest_stand(Some(room), aabb.centre(), f32::INFINITY, |_| true)
    }

    /// Near a thing that is out of reach of the hands, as near as one gets.
    fn stand_beside(&self, id: NodeId) -> Option<Stand> {
        let node = self.before.node(id)?;
        let centre = node.aabb().map_or_else(|| node.position(), |b| Some(b.centre()))?;
        self.nearest_stand(self.before.room_of(id), centre, vc_graph::NEAR, |_| true)
    }

    /// The spot nearest to a point, in a room, to which there is a way.
    fn nearest_stand(
        &self,
        room: Option<NodeId>,
        to: Point3<f32>,
        within: f32,
        admits: impl Fn(&Pose) -> bool,
    ) -> Option<Stand> {
        let from: Point2<f32> = self.feet().translation.vector.xy().into();
        let middle = to.xy();
        let step = |i: i32| i as f32 * 0.15;
        let all = (-24..=24).flat_map(|i| (-24..=24).map(move |j| Point2::new(middle.x + step(i), middle.y + step(j))));
        let near = |p: &Point2<f32>| (p - middle).norm() <= within && self.floor.is_free(*p);
        let mut spots: Vec<Point2<f32>> = all.filter(near).collect();
        let far = |p: &Point2<f32>| (p - middle).norm_squared();
        spots.sort_by(|a, b| far(a).total_cmp(&far(b)));
        let level = self.floor.plan().level;
        let good = spots.into_iter().filter(|p| {
            let feet = Pose::translation(p.x, p.y, level);
            admits(&feet) && self.is_good(&feet, room)
        });
        let (spot, route) = good.take(64).find_map(|p| Some((p, self.floor.route(from, p)?)))?;
        let way = to.xy() - spot;
        let back = route.points.iter().rev().map(|p| spot - p).find(|w| w.norm() > 1e-3);
        let front = if way.norm() > 0.2 { Some(way) } else { back };
        let turn = front.map_or(self.feet().rotation, towards);
        let at = nalgebra::Translation3::new(spot.x, spot.y, self.floor.plan().level);
        Some(Stand { feet: Pose::from_parts(at, turn), route })
    }

    /// Turns to a thing where the agent stands.
    fn face(&mut self, id: NodeId) -> Done {
        if !self.stands() {
            return Ok(());
        }
        let node = self.before.node(id);
        let centre = self.world.aabb(id).or_else(|| node?.aabb()).map(|b| b.centre());
        let Some(centre) = centre.or_else(|| node?.position()) else { return Ok(()) };
        if (centre.xy() - Point2::from(self.feet().translation.vector.xy())).norm() > 0.05 {
            self.world.face(self.agent, centre)?;
            self.beats.push(Beat::Turn(self.feet()));
        }
        Ok(())
    }

    /// The hand in which a graph has a thing.
    fn hand(&self, graph: &SceneGraph, id: NodeId) -> Option<Hand> {
        Hand::BOTH.into_iter().find(|h| graph.has(Edge::new(self.agent, h.relation(), id)))
    }

    fn hold(&mut self, id: NodeId) -> Done {
        if self.hand(self.before, id).is_some() {
            return Ok(());
        }
        let hand = self.hand(self.after, id).ok_or(Impossible::NotModelled("the rule gives it into no hand"))?;
        if self.world.pose(id).is_none() {
            return self.undress(hand, id);
        }
        self.world.grab(self.agent, hand, id)?;
        self.beats.push(Beat::Take(hand, id));
        Ok(())
    }

    fn undress(&mut self, hand: Hand, id: NodeId) -> Done {
        let worn = self.before.related(id, Relation::WornBy).next() == Some(self.agent);
        if !worn {
            return Err(Impossible::NoBody(self.before.label(id)));
        }
        self.world.insert(self.before, id, self.shapes)?;
        self.world.place(id, self.feet() * Pose::translation(0.3, 0.0, 1.0))?;
        self.world.grab(self.agent, hand, id)?;
        self.beats.push(Beat::Undress(hand, id));
        Ok(())
    }

    fn dress(&mut self, id: NodeId) -> Done {
        self.world.remove(id)?;
        self.beats.push(Beat::Dress(id));
        Ok(())
    }

    /// Puts a held thing where there is room for it, nearest to the hands; after a step, where
    /// there is room nearest to them then.
    fn put(&mut self, id: NodeId, place: Place) -> Done {
        let hand = self.hand(self.before, id).ok_or(Impossible::NotModelled("it is in no hand"))?;
        let mut spot = self.spot(id, place)?;
        if self.stands() && !self.puts_from(&self.feet(), id, &spot) {
            self.step_to(place.at, id, &spot)?;
            if !self.puts_from(&self.feet(), id, &spot) {
                spot = self.spot(id, place)?;
            }
        }
        self.turn_to(&spot);
        self.world.put(self.agent, hand, spot)?;
        self.beats.push(Beat::Put(hand, id, spot));
        Ok(())
    }

    fn spot(&self, id: NodeId, place: Place) -> Result<Pose, Impossible> {
        let inside = place.relation == Relation::Inside;
        let hands = self.feet() * Point3::new(AHEAD, 0.0, 1.0);
        let spot = self.world.free_spot_at(id, place.at, inside, Order::Near(hands))?;
        let missing = || Impossible::NoSpot {
            thing: self.before.label(id),
            where_: if inside { "in" } else { "on" },
            at: self.before.label(place.at),
        };
        spot.ok_or_else(missing)
    }

    /// Whether a thing can be put at a pose by an agent with its feet somewhere.
    fn puts_from(&self, feet: &Pose, id: NodeId, spot: &Pose) -> bool {
        self.world.reach_to_put(self.agent, feet, id, spot).is_ok_and(|far| far <= self.plan().reach)
    }

    /// Walks to where a spot on or in a thing can be reached, else as near to it as one gets.
    fn step_to(&mut self, at: NodeId, id: NodeId, spot: &Pose) -> Done {
        self.floor.update(self.world);
        let (room, target) = (self.before.room_of(self.agent), Point3::from(spot.translation.vector));
        let within = self.nearest_stand(room, target, vc_graph::NEAR, |feet| self.puts_from(feet, id, spot));
        let stand = within.or_else(|| self.nearest_stand(room, target, vc_graph::NEAR, |_| true));
        let stand = stand.ok_or_else(|| Impossible::NoStand(self.before.label(at)))?;
        self.walk(stand);
        Ok(())
    }

    fn turn_to(&mut self, spot: &Pose) {
        let to = Point3::from(spot.translation.vector);
        if self.stands() && self.world.face(self.agent, to).is_ok() {
            self.beats.push(Beat::Turn(self.feet()));
        }
    }

    fn let_go(&mut self, id: NodeId) -> Done {
        let hand = self.hand(self.before, id).ok_or(Impossible::NotModelled("it is in no hand"))?;
        // Where it falls it may hang on a table's edge until something shakes it, or lie on a
        // book: on the floor beside these it stays.
        if let Some(spot) = self.floor_spot(id).filter(|spot| self.puts_from(&self.feet(), id, spot))
            && self.world.put(self.agent, hand, spot).is_ok()
        {
            self.beats.push(Beat::Put(hand, id, spot));
            return Ok(());
        }
        self.world.drop(self.agent, hand)?;
        self.beats.push(Beat::LetGo(hand));
        Ok(())
    }

    /// A free spot for a thing on the floor before the agent's feet.
    fn floor_spot(&self, id: NodeId) -> Option<Pose> {
        let ground = self.before.place(self.agent).filter(|_| self.stands())?;
        let toes = self.feet() * Point3::new(AHEAD, 0.0, 0.0);
        self.world.free_spot_at(id, ground.at, false, Order::Near(toes)).ok().flatten()
    }

    /// Opens or closes whatever moves of a thing, from where nobody is in the way.
    fn drive(&mut self, id: NodeId, open: f32) -> Done {
        if self.is_mine(id) || self.world.moving_parts(id).is_empty() {
            if !self.is_mine(id) {
                self.reach(id)?;
            }
            return Ok(());
        }
        let body = self.body_of(id)?;
        if self.stands() {
            self.stand_clear(body, open)?;
        }
        if !self.world.leap_open(id, open)? {
            self.push_open(id, open)?;
        }
        self.beats.push(Beat::Drive(id, open));
        let now = self.world.openness(id).unwrap_or(open);
        let arrived = if open > 0.5 { now >= WIDE } else { self.world.open_state(id) == Some(State::Closed) };
        let stuck = || Impossible::Stuck { thing: self.before.label(id), open: 100.0 * now };
        if arrived { Ok(()) } else { Err(stuck()) }
    }

    /// Opens or closes against what is in the way, which is pushed aside, or is not.
    fn push_open(&mut self, id: NodeId, open: f32) -> Done {
        for part in 0..self.world.moving_parts(id).len() {
            self.world.drive(id, part, open)?;
        }
        for _ in 0..DRIVING {
            self.world.step();
            if !self.world.is_driven(id) {
                break;
            }
        }
        Ok(())
    }

    /// Stands where a door is reached, and not in its way while it opens or closes; if there
    /// is no such spot, at least not in its way then.
    fn stand_clear(&mut self, id: NodeId, open: f32) -> Done {
        let swing = [open, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0 - open];
        let clear_here = self.world.stands_clear(self.agent, &self.feet(), id, &swing)?;
        let free = |feet: &Pose, at: &[f32]| self.world.stands_clear(self.agent, feet, id, at).unwrap_or(false);
        let clear = |feet: &Pose| free(feet, &swing);
        if self.world.reach_to(self.agent, id)? <= self.plan().reach && clear_here {
            return self.face(id);
        }
        self.floor.update(self.world);
        let sees = |feet: &Pose| self.floor.sees(self.world, &self.plan(), feet, id);
        let ends = |feet: &Pose| free(feet, &swing[..1]);
        let room = self.before.room_of(self.agent);
        let mut found = self.stand_where(id, room, |feet| clear(feet) && sees(feet))?;
        for at_the_end in [false, true] {
            if found.is_none() {
                found = self.stand_where(id, room, |feet| if at_the_end { ends(feet) } else { clear(feet) })?;
            }
        }
        let stand = found.ok_or_else(|| Impossible::NoStand(self.before.label(id)))?;
        self.walk(stand);
        Ok(())
    }

    fn rest_on(&mut self, id: NodeId, lying: bool) -> Done {
        if !self.stands() {
            self.get_up()?;
        }
        let places = if lying { self.world.beds(id) } else { self.world.seats(id) };
        let from = self.feet().translation.vector.xy();
        let nearest = places.iter().map(|p| (p.translation.vector.xy() - from).norm()).fold(f32::INFINITY, f32::min);
        if nearest > 1.4 {
            self.floor.update(self.world);
            let target = places.first().map(|p| Point3::from(p.translation.vector));
            let stand = target.and_then(|t| self.nearest_stand(self.before.room_of(id), t, 1.4, |_| true));
            self.walk(stand.ok_or_else(|| Impossible::NoStand(self.before.label(id)))?);
        }
        if lying {
            self.world.lie(self.agent, id)?
        } else {
            self.world.sit(self.agent, id)?
        }
        self.beats.push(Beat::Rest(id, lying));
        Ok(())
    }

    fn get_up(&mut self) -> Done {
        self.world.stand_up(self.agent)?;
        self.beats.push(Beat::GetUp);
        Ok(())
    }

    fn pour(&mut self, id: NodeId, into: NodeId) -> Done {
        let is_water = self.before.node(id).is_some_and(|n| &**n.class() == "water");
        if is_water {
            return self.put(id, Place { relation: Relation::Inside, at: into });
        }
        let emptied = self.after.node(id).is_some_and(|n| n.contents().is_none());
        if emptied {
            self.level(id, 0.0);
        }
        self.level(into, FULL);
        Ok(())
    }

    /// Sets how full a vessel is, if its shape says that it holds liquids.
    fn level(&mut self, id: NodeId, level: f32) {
        let holds = self.before.node(id).is_some_and(|n| n.affords(Property::Recipient));
        if holds {
            // A vessel without a body has no level.
            let _ = self.world.fill(id, level);
        }
    }
}

/// The turn around the vertical whose X points along a way.
pub(super) fn towards(way: nalgebra::Vector2<f32>) -> nalgebra::UnitQuaternion<f32> {
    use vc_graph::portable::Portable;
    nalgebra::UnitQuaternion::from_axis_angle(&Vector3::z_axis(), way.y.angle_to(way.x))
}

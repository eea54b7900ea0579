//! Execution of the effects of the transition rule by bodies.

mod hands;
mod stance;

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::asset::JointKind;
use vc_graph::{Action, Condition, Effect, NodeId, Place, Pose, Property, Relation, SceneGraph, State, Verb, rule};
use vc_physics::{AgentError, BodyPlan, BodyRole, Floor, MovingPart, PhysicsWorld, Posture};

use super::course::{BodyMotion, Course, Drive};
use super::settle::come_to_rest;
use super::step::{RetryOptions, Step};
use super::{ActionError, PhysicalRefusal, Start};

pub(super) use hands::{comes_along, load_of};

/// Number of steps after which a moving door counts as stuck.
const DRIVING: u32 = 300;
/// The smallest share of its range that a door has to open.
const WIDE: f32 = 0.35;
/// The farthest that a loose thing may shift while it is opened, metres, and the cosine of its largest tilt.
const SHIFT: f32 = 0.1;
const UPRIGHT: f32 = 0.9;
/// The fill level of a vessel that has been filled.
const FULL: f32 = 0.8;
/// Duration of a gesture, seconds.
const GESTURE: f32 = 1.5;

/// The execution of an agent's action: moves bodies and records the course of the action.
pub(super) struct Execution<'a> {
    pub(super) world: &'a mut PhysicsWorld,
    pub(super) floor: &'a mut Floor,
    pub(super) start: &'a Start,
    /// The scene before the action, and the scene that the rule predicts after it.
    pub(super) before: &'a SceneGraph,
    pub(super) after: &'a SceneGraph,
    pub(super) agent: NodeId,
    pub(super) run: bool,
    /// Whether open doors and drawers count as out of the way.
    pub(super) nudges: bool,
    pub(super) course: Course,
    care: &'a RetryOptions,
    /// Cloth that was folded, with its scale now.
    pub(super) folded: Vec<(NodeId, Vector3<f32>)>,
}

type Done = Result<(), PhysicalRefusal>;

impl<'a> Execution<'a> {
    pub(super) fn new(world: &'a mut PhysicsWorld, floor: &'a mut Floor, start: &'a Start, step: &'a Step) -> Self {
        let Step { before, after, agent, action, care } = step;
        let run = action.verb == Verb::Run;
        let (course, folded) = (Course::default(), Vec::new());
        Self { world, floor, start, before, after, agent: *agent, run, nudges: false, course, care, folded }
    }
}

impl Execution<'_> {
    /// Executes all effects that the rule gives for an action.
    pub(super) fn all(&mut self, action: &Action) -> Result<(), ActionError> {
        let effects = rule::effects(action);
        self.hold_still();
        let done = self.come_near(action).and_then(|()| effects.iter().try_for_each(|e| self.note(e)));
        done.map_err(|why| {
            let (action, why) = (action.describe(self.before).to_string(), why.in_scene(self.before));
            ActionError::Impossible { action, why }
        })?;
        // Effects without a motion of bodies are shown by a gesture.
        let unseen = self.course.effects.iter().any(|(beat, _)| beat.is_none());
        if unseen || effects.is_empty() {
            self.course.push(BodyMotion::Gesture(*action, GESTURE));
        }
        Ok(())
    }

    fn hold_still(&mut self) {
        // The thing is loose, so it can be pinned.
        let steadied = &self.care.steadied;
        steadied.iter().for_each(|id| drop(self.world.pin(*id)));
        if !steadied.is_empty() {
            self.course.push(BodyMotion::Steady(steadied.clone()));
        }
    }

    /// Executes one effect and records the beat with which it comes true.
    fn note(&mut self, effect: &Effect<NodeId>) -> Done {
        let first = self.course.beats.len();
        self.one(effect)?;
        // Stepping up to a thing does nothing to it.
        let goes = matches!(effect, Effect::GoTo(_) | Effect::Approach(_) | Effect::Face(_));
        let does = |beat: &BodyMotion| {
            goes || !matches!(beat, BodyMotion::Walk { .. } | BodyMotion::Turn(_) | BodyMotion::Nudge(_))
        };
        let beat = self.course.beats.iter().skip(first).rposition(does).map(|i| first + i);
        self.course.effects.push((beat, *effect));
        Ok(())
    }

    fn one(&mut self, effect: &Effect<NodeId>) -> Done {
        match *effect {
            Effect::Enter(id, State::Open) => self.drive(id, 1.0),
            Effect::Enter(id, State::Closed) => self.drive(id, 0.0),
            Effect::Approach(id) if self.before.near(self.agent, id) => {
                if self.care.stays {
                    Ok(())
                } else {
                    self.face(id)
                }
            }
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
            Effect::Board(_) | Effect::Alight | Effect::DriveTo(..) => Err(PhysicalRefusal::NotModelled(
                "nobody gets into vehicles here yet: `World::add_vehicle` drives them",
            )),
            // States such as dirt, heat and sleep have no body.
            _ => Ok(()),
        }
    }

    /// Moves the agent within reach of the action's objects if it stands.
    fn come_near(&mut self, action: &Action) -> Done {
        // Actions that require nearness are done by hand.
        let by_hand = rule::preconditions(action).iter().any(|c| matches!(c, Condition::Near(_)));
        let rests = matches!(action.verb, Verb::Sit | Verb::Lie);
        // Things are put down where there is room, and that spot is searched later.
        let puts = matches!(action.verb, Verb::Place | Verb::PutIn | Verb::PutBack);
        match action.things().find(|id| !self.is_mine(*id)) {
            // A lamp under the ceiling is switched at the wall, wherever the switch is.
            Some(id) if matches!(action.verb, Verb::SwitchOn | Verb::SwitchOff) && self.is_overhead(id) => {
                self.face(id)
            }
            Some(id) if by_hand && !rests && !puts && !matches!(action.verb, Verb::Open | Verb::Close) => {
                self.reach(id)
            }
            _ => Ok(()),
        }
    }

    /// Whether the agent holds or wears a thing, or a thing on which it rests.
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

    /// The thing itself, or the nearest thing with a body in its support chain.
    fn body_of(&self, id: NodeId) -> Result<NodeId, PhysicalRefusal> {
        let chain = std::iter::once(id).chain(self.before.support_chain(id));
        let body = chain.into_iter().find(|id| self.world.aabb(*id).is_some());
        body.ok_or_else(|| PhysicalRefusal::NoBody(self.before.label(id)))
    }

    /// Opens or closes all moving parts of a thing, from a position where the agent is not in the way.
    fn drive(&mut self, id: NodeId, open: f32) -> Done {
        if self.is_mine(id) {
            return self.open_in_hand(id, open);
        }
        if self.world.moving_parts(id).is_empty() {
            let drawn = self.has_cord(id) && self.stands();
            return if drawn { self.stand_clear(id, open) } else { self.reach(id) };
        }
        let body = self.body_of(id)?;
        if self.stands() {
            self.stand_clear(body, open)?;
        }
        let before = self.world.pose(id);
        // A standing agent gives way to a part that swings past it.
        let past = if self.stands() { std::slice::from_ref(&self.agent) } else { &[] };
        let pushes = self.care.pushes || !self.world.set_openness_ignoring(id, open, past)?;
        if pushes {
            self.push_open(id, open)?;
        }
        self.note_drive(id, open, pushes);
        let now = self.world.openness(id).unwrap_or(open);
        let arrived = if open > 0.5 { now >= WIDE } else { self.world.open_state(id) == Some(State::Closed) };
        // The part may have stopped where the agent stands.
        let squeezed = now < 1.0 && self.stands() && !self.world.can_stand(self.agent, &self.feet())?;
        if arrived && !squeezed { self.keeps_balance(id, before) } else { Err(self.stuck(id, open, now)?) }
    }

    /// The error for a thing that is stuck at its present opening.
    fn stuck(&self, id: NodeId, open: f32, now: f32) -> Result<PhysicalRefusal, PhysicalRefusal> {
        let by = self.world.blockers(id, open)?.into_iter().map(|by| self.before.label(by)).collect();
        Ok(PhysicalRefusal::Stuck { thing: self.before.label(id), open: 100.0 * now, by })
    }

    /// Refuses an opening that makes the thing fall over, so that it would lie in another place or another
    /// pose.
    fn keeps_balance(&mut self, id: NodeId, before: Option<Pose>) -> Done {
        if self.world.role(id) != Some(BodyRole::Loose) {
            return Ok(());
        }
        come_to_rest(self.world);
        let moved = before.zip(self.world.pose(id)).is_some_and(|(before, now)| {
            let far = (now.translation.vector - before.translation.vector).norm();
            far > SHIFT || (before.rotation * Vector3::z()).dot(&(now.rotation * Vector3::z())) < UPRIGHT
        });
        if moved { Err(PhysicalRefusal::Topples(self.before.label(id))) } else { Ok(()) }
    }

    /// Opens or closes a thing that the agent holds: nothing is in its way.
    fn open_in_hand(&mut self, id: NodeId, open: f32) -> Done {
        if !self.world.moving_parts(id).is_empty() {
            self.world.put_all_open(id, open)?;
            self.note_drive(id, open, false);
        }
        Ok(())
    }

    fn note_drive(&mut self, id: NodeId, open: f32, pushes: bool) {
        let end = self.world.moving_parts(id).iter().map(|part| part.open).collect();
        self.course.push(BodyMotion::Drive(Drive { id, open, pushes, end }));
    }

    /// Opens or closes a thing against obstacles, which may be pushed aside. A part without a motor pushes
    /// nothing. Drawers behind doors stay where they are if no door opens.
    fn push_open(&mut self, id: NodeId, open: f32) -> Done {
        let turns = |part: &MovingPart| part.kind == JointKind::Hinge;
        if open > 0.0 {
            self.push_parts(id, open, turns)?;
            let parts = self.world.moving_parts(id);
            if parts.iter().any(turns) && !parts.iter().any(|p| turns(p) && p.open >= WIDE) {
                return Ok(());
            }
        }
        self.push_parts(id, open, |_| true)
    }

    fn push_parts(&mut self, id: NodeId, open: f32, which: impl Fn(&MovingPart) -> bool) -> Done {
        let parts = self.world.moving_parts(id);
        for (part, _) in parts.iter().enumerate().filter(|(_, p)| p.has_motor && which(p)) {
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

    fn rest_on(&mut self, id: NodeId, lying: bool) -> Done {
        if !self.stands() {
            self.get_up()?;
        }
        let places = if lying { self.world.beds(id) } else { self.world.seats(id) };
        let from = self.feet().translation.vector.xy();
        let nearest = places.iter().map(|p| (p.translation.vector.xy() - from).norm()).fold(f32::INFINITY, f32::min);
        if nearest > 1.4 {
            self.floor.update(self.world);
            let room = self.before.room_of(id);
            let stand = goals(&places, lying).find_map(|to| self.nearest_stand(room, to, 1.4, |_| true));
            self.walk(stand.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(id)))?)?;
        }
        if lying {
            self.world.lie(self.agent, id)?
        } else {
            self.world.sit(self.agent, id)?
        }
        self.course.push(BodyMotion::Rest(id, lying));
        Ok(())
    }

    /// Gets up to a spot from which the floor is reached on which the agent stood before; else to where it stood.
    fn get_up(&mut self) -> Done {
        self.floor.update(self.world);
        let stood = self.world.stood_before(self.agent).unwrap_or_else(|| self.feet());
        let at = |feet: &Pose| Point2::from(feet.translation.vector.xy());
        let back = |feet: &Pose| self.floor.route(at(feet), at(&stood)).is_some();
        let exit = self.world.exit_where(self.agent, back);
        let feet = match exit {
            Err(AgentError::NoExit(_)) if self.world.can_stand(self.agent, &stood)? => stood,
            exit => exit?,
        };
        self.world.teleport(self.agent, feet)?;
        self.course.push(BodyMotion::GetUp(feet));
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

    /// Sets the fill level of a vessel if its shape says that it holds liquids.
    fn level(&mut self, id: NodeId, level: f32) {
        let holds = self.before.node(id).is_some_and(|n| n.affords(Property::Recipient));
        if holds {
            // A vessel without a body has no fill level.
            let _ = self.world.fill(id, level);
        }
    }
}

/// The points beside which an agent sits or lies down, best first: the middles of the places, and for lying
/// also the positions of feet and head.
fn goals(places: &[Pose], lying: bool) -> impl Iterator<Item = Point3<f32>> {
    const END: f32 = 0.8;
    let along: &[f32] = if lying { &[0.0, END, -END] } else { &[0.0] };
    along.iter().flat_map(|x| places.iter().map(move |place| place * Point3::new(*x, 0.0, 0.0)))
}

/// The rotation around the vertical that turns X to the given direction.
pub(in crate::environment) fn towards(way: nalgebra::Vector2<f32>) -> nalgebra::UnitQuaternion<f32> {
    use vc_graph::portable::Portable;
    nalgebra::UnitQuaternion::from_axis_angle(&Vector3::z_axis(), way.y.angle_to(way.x))
}

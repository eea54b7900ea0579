//! Where to stand for what is to be done, and getting there.

use nalgebra::{Point2, Point3, Vector2};
use vc_graph::asset::JointKind;
use vc_graph::{Motion, NodeId, NodeKind, Place, Pose, Property};
use vc_physics::{PhysicsWorld, ShutDoors, StandingPose};

use super::planner::{Plan, Planner, Planning};
use super::towards;
use crate::environment::PhysicalRefusal;
use crate::environment::motion::BodyMotion;
use crate::environment::outlook;

/// Distance between agents that stand, metres: two bodies side by side.
pub(in crate::environment) const APART: f32 = 0.55;
/// How far an agent keeps from where the next room begins, metres, so that it is plain in which room it is.
const INNER: f32 = 0.1;
/// Within this distance a thing counts as near to the agent that walked up to it, metres.
const NEAR: f32 = vc_graph::NEAR - 0.02;
/// Distance of the spots on the floor that are tried, metres.
const BETWEEN: f32 = 0.15;
/// How many of the points in a container must be visible to the agent that opens it.
const SHOWN: usize = 6;

impl Planner<'_> {
    /// Brings a thing within reach of the hands: by turning, by a step or by a walk.
    pub(super) fn reach(&mut self, id: NodeId) -> Planning {
        let body = self.body_of(id)?;
        let reach = self.body().reach;
        if self.world.agent(self.agent)?.reach_distance(body)? <= reach {
            return Ok(self.face(body));
        }
        if !self.stands() {
            let distance = self.world.agent(self.agent)?.reach_distance(body)?;
            return Err(vc_physics::AgentError::OutOfReach { agent: self.agent, id: body, distance, reach }.into());
        }
        self.floor.update(self.world);
        let stand = self.stand_at(body, self.before.room_of(self.agent))?;
        self.walk(stand.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(id)))?)
    }

    /// Whether there is a spot from which hands get at a thing.
    pub(in crate::environment) fn can_get_at(&mut self, id: NodeId) -> bool {
        let Ok(body) = self.body_of(id) else { return false };
        if self.is_overhead(body) || self.has_cord(body) {
            return matches!(self.stand_before(id), Ok(Some(_)));
        }
        let here = self
            .world
            .agent(self.agent)
            .is_ok_and(|me| me.reach_distance(body).is_ok_and(|far| far <= self.body().reach));
        here || matches!(self.stand_at(body, self.before.room_of(body)), Ok(Some(_)))
    }

    /// Whether a thing is higher than one reaches.
    pub(super) fn is_overhead(&self, id: NodeId) -> bool {
        let top = self.feet().translation.z + self.body().shoulder() + self.body().reach;
        self.world.aabb(id).is_some_and(|aabb| aabb.min.z > top)
    }

    /// A spot in a room from which the agent reaches a thing: where it sees it too, if
    /// there is one.
    pub(super) fn stand_at(
        &mut self,
        id: NodeId,
        room: Option<NodeId>,
    ) -> Result<Option<StandingPose>, PhysicalRefusal> {
        self.at_need_nudging(|planner| {
            let found = planner.stand_where(id, room, |feet| planner.sees(feet, id))?;
            if found.is_some() { Ok(found) } else { planner.stand_where(id, room, |_| true) }
        })
    }

    /// Looks for something, first such that doors and drawers that stand open are in the way, then
    /// such that they are moved out of it.
    pub(super) fn at_need_nudging<T>(
        &mut self,
        find: impl Fn(&Self) -> Result<Option<T>, PhysicalRefusal>,
    ) -> Result<Option<T>, PhysicalRefusal> {
        let found = find(self)?;
        if found.is_some() {
            return Ok(found);
        }
        self.nudges = true;
        let found = find(self);
        self.nudges = false;
        found
    }

    /// Whether one who stands somewhere sees a thing.
    fn sees(&self, feet: &Pose, id: NodeId) -> bool {
        self.floor.sees(self.world, &self.body(), feet, id)
    }

    pub(super) fn stand_where(
        &self,
        id: NodeId,
        room: Option<NodeId>,
        admits: impl Fn(&Pose) -> bool,
    ) -> Result<Option<StandingPose>, PhysicalRefusal> {
        let from = self.feet().translation.vector.xy().into();
        let good = |feet: &Pose| self.is_good(feet, room) && admits(feet);
        Ok(self.floor.standing_pose_where(self.world, &self.body(), from, id, good)?)
    }

    /// Whether the agent may stand somewhere: in a room, where nobody else is, and free, or by
    /// nudging what stands open.
    pub(super) fn is_good(&self, feet: &Pose, room: Option<NodeId>) -> bool {
        let spot = Point2::from(feet.translation.vector.xy());
        let inner = |room: NodeId| {
            let around = [(0.0, 0.0), (INNER, 0.0), (-INNER, 0.0), (0.0, INNER), (0.0, -INNER)];
            let at = |(x, y): &(f32, f32)| self.start.room_at(spot + Vector2::new(*x, *y));
            around.iter().all(|offset| at(offset).is_none_or(|r| r == room)) && at(&around[0]) == Some(room)
        };
        let free = || match self.nudges {
            false => self.world.standing(self.agent, feet).is_ok_and(|there| there.is_free()),
            true => self
                .world
                .standing(self.agent, feet)
                .is_ok_and(|there| there.parts_to_move_aside(ShutDoors::Stay).is_some()),
        };
        room.is_none_or(inner) && self.is_unclaimed(&spot) && free()
    }

    /// Whether no other agent is at a spot.
    pub(super) fn is_unclaimed(&self, spot: &Point2<f32>) -> bool {
        let others = self.world.agents().filter(|a| *a != self.agent).filter_map(|a| self.world.pose(a));
        let stand = others.map(|feet| Point2::from(feet.translation.vector.xy()));
        stand.chain(self.claims.iter().copied()).all(|at| (at - spot).norm() >= APART)
    }

    /// A walk to a spot; what stands open in its way there gives way.
    pub(super) fn walk(&self, stand: StandingPose) -> Planning {
        let StandingPose { feet, mut route } = stand;
        // A way begins on the free floor, somebody perhaps a step beside it.
        let from = Point2::from(self.feet().translation.vector.xy());
        if route.points.first().is_some_and(|first| (first - from).norm() > 0.01) {
            route.points.insert(0, from);
        }
        let aside = self.world.standing(self.agent, &feet)?.parts_to_move_aside(ShutDoors::Stay).unwrap_or_default();
        let run = self.motion() == Some(Motion::Run);
        let walk = BodyMotion::Walk { points: route.points, doors: route.doors, feet, run };
        let nudge = (!aside.is_empty()).then_some(BodyMotion::Nudge(aside));
        Ok(Plan::of(nudge.into_iter().chain([walk])))
    }

    pub(super) fn go_to(&mut self, id: NodeId) -> Planning {
        if let Some(point) = self.action.aim.point() {
            return self.go_to_point(point);
        }
        self.floor.update(self.world);
        let kind = self.before.node(id).map(vc_graph::Node::kind);
        let stand = self.at_need_nudging(|planner| match kind {
            Some(NodeKind::Room) => Ok(planner.stand_in(id)),
            Some(NodeKind::Agent) => Ok(planner.stand_beside(id, |_| true)),
            _ => planner.stand_before(id),
        })?;
        self.walk(stand.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(id)))?)
    }

    /// Before a thing: within reach of it and not only of its open door, else near it; else the
    /// same for what it is on or in, as long as that is near the thing itself.
    pub(super) fn stand_before(&self, id: NodeId) -> Result<Option<StandingPose>, PhysicalRefusal> {
        for at in std::iter::once(id).chain(self.before.support_chain(id)) {
            for far in [self.body().stretch(), NEAR] {
                let reach = self.stand_within(id, at, far)?;
                if reach.is_some() {
                    return Ok(reach);
                }
            }
            let beside = self.stand_beside(at, |feet| self.is_within(feet, id, NEAR));
            if beside.is_some() {
                return Ok(beside);
            }
        }
        Ok(None)
    }

    /// Within reach of one thing, so near to another: where it is seen too, if there is such a
    /// spot.
    fn stand_within(&self, id: NodeId, at: NodeId, far: f32) -> Result<Option<StandingPose>, PhysicalRefusal> {
        if self.world.aabb(at).is_none() {
            return Ok(None);
        }
        let (room, near) = (self.before.room_of(at), |feet: &Pose| self.is_within(feet, id, far));
        let seen = self.stand_where(at, room, |feet| near(feet) && self.sees(feet, at))?;
        if seen.is_some() { Ok(seen) } else { self.stand_where(at, room, near) }
    }

    /// Whether somebody who stands somewhere is so near to a thing, measured as the rule does.
    fn is_within(&self, feet: &Pose, id: NodeId, far: f32) -> bool {
        let Some(aabb) = self.before.node(id).and_then(vc_graph::Node::aabb) else { return true };
        let feet = Point3::from(feet.translation.vector);
        (aabb.nearest(&feet) - feet).xy().norm() < far
    }

    /// As near as possible to the middle of a room.
    pub(super) fn stand_in(&self, room: NodeId) -> Option<StandingPose> {
        let from: Point2<f32> = self.feet().translation.vector.xy().into();
        let aabb = self.before.node(room)?.aabb()?;
        if self.before.room_of(self.agent) == Some(room) {
            let route = self.floor.route(from, from)?;
            return Some(StandingPose { feet: self.feet(), route });
        }
        self.nearest_stand(Some(room), aabb.centre(), f32::INFINITY, |_| true)
    }

    /// Near a thing that is out of reach of the hands, as near as one gets.
    fn stand_beside(&self, id: NodeId, admits: impl Fn(&Pose) -> bool) -> Option<StandingPose> {
        let node = self.before.node(id)?;
        let centre = node.aabb().map_or_else(|| node.position(), |b| Some(b.centre()))?;
        self.nearest_stand(self.before.room_of(id), centre, f32::INFINITY, |feet| {
            self.is_within(feet, id, NEAR) && admits(feet)
        })
    }

    /// The spot nearest to a point, in a room, to which there is a way.
    pub(super) fn nearest_stand(
        &self,
        room: Option<NodeId>,
        to: Point3<f32>,
        within: f32,
        admits: impl Fn(&Pose) -> bool,
    ) -> Option<StandingPose> {
        let from: Point2<f32> = self.feet().translation.vector.xy().into();
        let middle = to.xy();
        let step = |i: i32| i as f32 * BETWEEN;
        let all = (-24..=24).flat_map(|i| (-24..=24).map(move |j| Point2::new(middle.x + step(i), middle.y + step(j))));
        let near = |p: &Point2<f32>| (p - middle).norm() <= within && self.floor.is_free(*p);
        // The raster may miss a narrow spot: at least where one is, one may stay.
        let mut spots: Vec<Point2<f32>> = all.chain([from]).filter(near).collect();
        let far = |p: &Point2<f32>| (p - middle).norm_squared();
        spots.sort_by(|a, b| far(a).total_cmp(&far(b)));
        let level = self.floor.options().level;
        let good = spots.into_iter().filter(|p| {
            let feet = Pose::translation(p.x, p.y, level);
            admits(&feet) && self.is_good(&feet, room)
        });
        good.take(64).find_map(|spot| self.stand_facing(spot, to))
    }

    /// Standing at a spot, turned to a point; `None` if there is no way to the spot.
    fn stand_facing(&self, spot: Point2<f32>, to: Point3<f32>) -> Option<StandingPose> {
        let route = self.floor.route(self.feet().translation.vector.xy().into(), spot)?;
        let way = to.xy() - spot;
        let back = route.points.iter().rev().map(|p| spot - p).find(|w| w.norm() > 1e-3);
        let front = if way.norm() > 0.2 { Some(way) } else { back };
        let turn = front.map_or(self.feet().rotation, towards);
        let at = nalgebra::Translation3::new(spot.x, spot.y, self.floor.options().level);
        Some(StandingPose { feet: Pose::from_parts(at, turn), route })
    }

    /// Turns to a thing where the agent stands.
    pub(super) fn face(&self, id: NodeId) -> Plan {
        let node = self.before.node(id);
        let centre = self.world.aabb(id).or_else(|| node?.aabb()).map(|b| b.centre());
        let centre = centre.or_else(|| node?.position());
        let aside = |at: &Point3<f32>| (at.xy() - Point2::from(self.feet().translation.vector.xy())).norm() > 0.05;
        centre.filter(aside).map_or_else(Plan::default, |at| self.turn_to(at))
    }

    /// Turns to a point where the agent stands.
    pub(super) fn turn_to(&self, to: Point3<f32>) -> Plan {
        Plan::of(self.world.agent(self.agent).and_then(|agent| agent.turned_to(to)).map(BodyMotion::Turn).ok())
    }

    /// Whether a thing can be put at a pose by an agent with its feet somewhere: within reach, and not where its
    /// own body is.
    pub(super) fn puts_from(&self, feet: &Pose, id: NodeId, spot: &Pose) -> bool {
        let Ok(there) = self.world.standing(self.agent, feet) else { return false };
        there.put_distance(id, spot).is_ok_and(|far| far <= self.body().reach)
            && (!self.stands() || there.is_clear_of(id, spot).unwrap_or(false))
    }

    /// As [`Self::puts_from`], where the agent does not shut itself in: in the dead end of a corridor, say.
    fn puts_down_from(&self, feet: &Pose, id: NodeId, spot: &Pose) -> bool {
        let at = Point2::from(feet.translation.vector.xy());
        self.puts_from(feet, id, spot) && self.floor.stays_open(self.world, id, spot, &[at]).unwrap_or(true)
    }

    /// A walk to where a spot at a place can be reached, else to where another one can, else as near to it as one gets;
    /// and the spot.
    pub(super) fn step_to(&mut self, id: NodeId, place: Place, spot: Pose) -> Result<(Plan, Pose), PhysicalRefusal> {
        self.floor.update(self.world);
        let (room, target) = (self.before.room_of(self.agent), Point3::from(spot.translation.vector));
        if let Some((stand, reached)) = self.stand_for(room, id, place, spot)? {
            return Ok((self.walk(stand)?, reached));
        }
        let near = self.nearest_stand(room, target, NEAR, |_| true);
        Ok((self.walk(near.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(place.at)))?)?, spot))
    }

    /// Where to stand to put a thing to a spot at a place; if there is no such spot on the floor, to another one, which
    /// is nearest to the hands among those that can be reached.
    pub(in crate::environment) fn stand_for(
        &mut self,
        room: Option<NodeId>,
        id: NodeId,
        place: Place,
        spot: Pose,
    ) -> Result<Option<(StandingPose, Pose)>, PhysicalRefusal> {
        if let Some(stand) = self.stand_to_put(room, id, &spot)? {
            return Ok(Some((stand, spot)));
        }
        let stands = self.stands_around(room, place.at);
        let reached = |spot: &Pose| stands.iter().any(|stand| self.puts_down_from(&stand.feet, id, spot));
        let found = self.spot_where(id, place, self.near_hands(), reached)?;
        let stand = |spot: &Pose| stands.iter().find(|stand| self.puts_down_from(&stand.feet, id, spot)).cloned();
        Ok(found.and_then(|spot| Some((stand(&spot)?, spot))))
    }

    /// All spots in a room around a thing, to which there is a way.
    fn stands_around(&self, room: Option<NodeId>, at: NodeId) -> Vec<StandingPose> {
        let Some(aabb) = self.world.aabb(at) else { return Vec::new() };
        let (low, high, level) = (aabb.min.xy(), aabb.max.xy(), self.floor.options().level);
        let steps = |axis: usize| {
            let count = ((high[axis] - low[axis] + 2.0 * NEAR) / BETWEEN) as usize;
            (0..=count).map(move |i| low[axis] - NEAR + BETWEEN * i as f32)
        };
        let spots = steps(0).flat_map(|x| steps(1).map(move |y| Point2::new(x, y)));
        let good = |p: &Point2<f32>| self.floor.is_free(*p) && self.is_good(&Pose::translation(p.x, p.y, level), room);
        spots.filter(good).filter_map(|p| self.stand_facing(p, aabb.centre())).collect()
    }

    /// The spot in a room nearest to where a thing is to be put, from where it can be.
    pub(super) fn stand_to_put(
        &mut self,
        room: Option<NodeId>,
        id: NodeId,
        spot: &Pose,
    ) -> Result<Option<StandingPose>, PhysicalRefusal> {
        let target = Point3::from(spot.translation.vector);
        self.at_need_nudging(|planner| {
            Ok(planner.nearest_stand(room, target, NEAR, |feet| planner.puts_down_from(feet, id, spot)))
        })
    }

    /// Moves the agent to a spot from which it reaches a door and where it is not in the door's way while that opens
    /// or closes; if there is no such spot, to one where it is at least not in the way. An agent that opens a
    /// container stands where it sees into it, if there is such a spot.
    pub(super) fn stand_clear(&mut self, id: NodeId, open: f32) -> Planning {
        let swing = [open, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0 - open];
        let clear_here = self.world.standing(self.agent, &self.feet())?.is_free_with_open(id, &swing)?;
        let free = |feet: &Pose, at: &[f32]| {
            self.world
                .standing(self.agent, feet)
                .and_then(|there| Ok(there.is_free_with_open(id, at)?))
                .unwrap_or(false)
        };
        let clear = |feet: &Pose| free(feet, &swing);
        self.floor.update(self.world);
        let stays = self.world.agent(self.agent)?.reach_distance(id)? <= self.body().reach && clear_here;
        let opened = if open > 0.5 { self.opened(id)? } else { None };
        let shows = |feet: &Pose| opened.as_ref().is_none_or(|opened| self.shows_inside(opened, feet, id));
        if stays && shows(&self.feet()) {
            return Ok(self.face(id));
        }
        let ends = |feet: &Pose| free(feet, &swing[..1]);
        let room = self.before.room_of(self.agent);
        let mut found = self.stand_where(id, room, |feet| clear(feet) && shows(feet))?;
        if found.is_none() && stays {
            return Ok(self.face(id));
        }
        if found.is_none() {
            found = self.stand_where(id, room, |feet| clear(feet) && self.sees(feet, id))?;
        }
        for at_the_end in [false, true] {
            if found.is_none() {
                found = self.stand_where(id, room, |feet| if at_the_end { ends(feet) } else { clear(feet) })?;
            }
        }
        // Blinds and curtains are drawn by a cord, which hangs down.
        if found.is_none() && self.has_cord(id) {
            found = self.stand_beside(id, clear);
        }
        self.walk(found.ok_or_else(|| PhysicalRefusal::NoStand(self.before.label(id)))?)
    }

    /// The world with a container standing open, if it has a door that turns.
    fn opened(&self, id: NodeId) -> Result<Option<PhysicsWorld>, PhysicalRefusal> {
        let turns = self.world.parts(id).all().iter().any(|part| part.kind == JointKind::Hinge);
        if !turns || !self.before.node(id).is_some_and(|n| n.affords(Property::Container)) {
            return Ok(None);
        }
        let mut opened = self.world.clone();
        opened.put_open(id, None, 1.0)?;
        Ok(Some(opened))
    }

    /// Whether somebody who stands somewhere sees into a thing when it stands open.
    fn shows_inside(&self, opened: &PhysicsWorld, feet: &Pose, id: NodeId) -> bool {
        let Some(closed) = self.world.aabb(id) else { return false };
        outlook::into_thing(opened, self.before, (id, &closed), (feet, self.body().eye())) >= SHOWN
    }

    /// Whether a thing covers a window from above.
    pub(super) fn has_cord(&self, id: NodeId) -> bool {
        let high = self.feet().translation.z + self.body().shoulder();
        self.before.covers_windows(id) && self.world.aabb(id).is_some_and(|aabb| aabb.max.z > high)
    }
}

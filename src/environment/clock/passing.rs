//! Ways past others: round those who stand, behind those who walk; and steps aside for those who cannot pass.

use nalgebra::Point2;
use vc_graph::clock::Tick;
use vc_graph::{Label, NodeId, Pose};
use vc_physics::{Posture, Route};

use super::Interruption;
use super::conflict::{WAIT, WAITS, ticks};
use super::schedule::Phase;
use super::track::{Leaf, Passage, Track, Way};
use crate::environment::motion::BodyMotion;
use crate::environment::{ActionError, Environment};

/// Distance that walkers keep from each other, and from those who stand, metres: two bodies.
pub(super) const APART: f32 = 0.5;
pub(super) const NARROW: f32 = 0.4;
/// Distance at which one squeezes past somebody who does not leave, metres: both turn their shoulders.
pub(super) const SQUEEZED: f32 = 0.3;
/// How much wider the way round somebody is planned, metres: it leads along cells.
const CELL: f32 = 0.04;
/// The farthest that a way may end from where it is to, metres.
const END: f32 = 0.15;

/// A walk as it is planned.
#[derive(Clone, Copy)]
pub(super) struct Walk<'a> {
    pub(super) points: &'a [Point2<f32>],
    pub(super) doors: &'a [NodeId],
    pub(super) feet: Pose,
    pub(super) run: bool,
}

impl<'a> Walk<'a> {
    /// The walk of a motion.
    pub(super) fn of(motion: &'a BodyMotion) -> Option<Self> {
        match motion {
            BodyMotion::Walk { points, doors, feet, run } => Some(Self { points, doors, feet: *feet, run: *run }),
            BodyMotion::StepAside { points, doors, feet } => Some(Self { points, doors, feet: *feet, run: false }),
            _ => None,
        }
    }
}

pub(super) fn spot(feet: &Pose) -> Point2<f32> {
    feet.translation.vector.xy().into()
}

impl Environment {
    /// The way of a walk that ends first: straight or round others, now or when they have passed. `None` where somebody
    /// who stands is in the way; whoever has waited for that one squeezes past.
    pub(super) fn way(&mut self, agent: NodeId, walk: Walk<'_>) -> Option<Way> {
        let has_waited = self.clock.running.get(&agent).is_some_and(|schedule| schedule.waits.is_some());
        let least = if has_waited { SQUEEZED } else { NARROW };
        let anew = self.anew(agent, walk)?;
        let walk = anew.as_ref().map_or(walk, |route| Walk { points: &route.points, doors: &route.doors, ..walk });
        let straight = self.straight(agent, walk);
        if self.is_clear(agent, &straight, least) {
            return Some(straight);
        }
        let round = self.ways_round(agent, walk, least);
        let all = std::iter::once(straight).chain(round);
        let found = all.filter_map(|way| self.when_clear(agent, way, least)).min_by_key(Way::end);
        found.or_else(|| self.way_made(agent, walk))
    }

    /// The route of a walk of one who has stepped aside since it was planned; `None` if there is none.
    #[allow(clippy::option_option, reason = "no new route is needed, or none is found")]
    fn anew(&mut self, agent: NodeId, walk: Walk<'_>) -> Option<Option<Route>> {
        let here = spot(&self.world.pose(agent)?);
        if walk.points.first().is_none_or(|first| (first - here).norm() < END) {
            return Some(None);
        }
        self.floor.update(&self.world);
        self.floor.route(here, spot(&walk.feet)).map(Some)
    }

    /// The way of a walk if nobody else were there.
    pub(super) fn straight(&self, agent: NodeId, walk: Walk<'_>) -> Way {
        let plan = self.world.agent(agent).map(|agent| *agent.plan()).unwrap_or_default();
        let passage = |door: &NodeId| Passage::new(&self.world, &self.graph, walk.points, *door);
        let mut doors: Vec<Passage> = walk.doors.iter().filter_map(passage).collect();
        for passage in &mut doors {
            passage.own = self.own_openness(agent, passage);
        }
        let speed = if walk.run { plan.run } else { plan.walk };
        let from = self.world.pose(agent).unwrap_or_else(Pose::identity);
        Way { points: walk.points.to_vec(), begin: self.tick(), speed, from, to: walk.feet, doors, aside: Vec::new() }
    }

    /// Ways round those who stand, and where others are going to stand.
    fn ways_round(&mut self, agent: NodeId, walk: Walk<'_>, least: f32) -> Vec<Way> {
        self.floor.update(&self.world);
        let standing: Vec<Point2<f32>> = self.standers(agent).into_iter().map(|(_, at)| at).collect();
        let claimed = [standing.clone(), self.claims(agent)].concat();
        let mut all = vec![claimed];
        if all[0].len() > standing.len() {
            all.push(standing);
        }
        let route = |circles: &Vec<Point2<f32>>| self.route_past(agent, spot(&walk.feet), circles, least);
        let routes: Vec<_> = all.iter().filter_map(route).collect();
        routes.iter().map(|r| self.straight(agent, Walk { points: &r.points, doors: &r.doors, ..walk })).collect()
    }

    /// A route to a point at a distance from others.
    pub(super) fn route_past(
        &self,
        agent: NodeId,
        to: Point2<f32>,
        others: &[Point2<f32>],
        least: f32,
    ) -> Option<Route> {
        let circles: Vec<(Point2<f32>, f32)> = others.iter().map(|at| (*at, least + CELL)).collect();
        let route = self.floor.route_around(spot(&self.world.pose(agent)?), to, &circles)?;
        route.points.last().is_some_and(|last| (last - to).norm() < END).then_some(route)
    }

    /// A way from the first tick in which it is clear.
    fn when_clear(&self, agent: NodeId, mut way: Way, least: f32) -> Option<Way> {
        let walkers = self.ways(agent).map(|(_, theirs)| theirs.end());
        let last = walkers.chain(self.leaves(agent).map(Leaf::end)).max().unwrap_or(way.begin) + WAIT;
        while way.begin <= last {
            if self.is_clear(agent, &way, least) {
                return Some(way);
            }
            way.begin += WAIT;
        }
        None
    }

    /// Whether a way meets nobody, and no leaf.
    pub(super) fn is_clear(&self, agent: NodeId, way: &Way, least: f32) -> bool {
        self.ways(agent).all(|(_, theirs)| is_apart(way, theirs, least))
            && self.in_the_way(agent, way, least).is_empty()
            && self.leaves(agent).all(|leaf| self.is_past(agent, way, leaf))
    }

    /// Whether a way meets a leaf that somebody moves only when that has stopped, if at all.
    fn is_past(&self, agent: NodeId, way: &Way, leaf: &Leaf) -> bool {
        match way.in_doorway(leaf.id) {
            Some((from, _)) => from > leaf.end(),
            None => way.begin > leaf.end() || !self.meets(agent, way, leaf.id, leaf.openness(), self.tick()),
        }
    }

    /// Others who stand, and where.
    pub(super) fn standers(&self, agent: NodeId) -> Vec<(NodeId, Point2<f32>)> {
        let walkers = self.walkers(agent);
        let stands = |id: &NodeId| *id != agent && self.world.posture(*id) == Some(Posture::Standing);
        let all = self.world.agents().filter(|id| stands(id) && !walkers.contains(id));
        all.filter_map(|id| Some((id, spot(&self.world.pose(id)?)))).collect()
    }

    /// Those who stand in the way.
    pub(super) fn in_the_way(&self, agent: NodeId, way: &Way, least: f32) -> Vec<NodeId> {
        let mut others = self.standers(agent);
        others.retain(|(other, _)| way.aside.iter().all(|step| step.agent != *other));
        if others.is_empty() {
            return Vec::new();
        }
        let steps: Vec<Point2<f32>> = ticks(way.begin, way.end()).map(|tick| spot(&way.feet(tick))).collect();
        let begins = spot(&way.from);
        let meets = |at: &Point2<f32>| {
            let least = room_for(least, (begins - at).norm());
            steps.iter().any(|step| (step - at).norm() < least)
        };
        others.into_iter().filter(|(_, at)| meets(at)).map(|(id, _)| id).collect()
    }

    /// Waits for those who stand in the way of a walk, after a step aside where that helps; ends the action of one who
    /// has waited long enough.
    pub(super) fn wait(&mut self, agent: NodeId, walk: BodyMotion) -> Result<(), ActionError> {
        let now = self.tick();
        let aside = if matches!(walk, BodyMotion::Walk { .. }) { self.steps_aside(agent) } else { None };
        let blockers = Walk::of(&walk).map_or_else(Vec::new, |walk| self.blockers(agent, walk));
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        let since = *schedule.waits.get_or_insert(now);
        if aside.is_none() && now - since >= WAITS {
            let action = schedule.action;
            return Err(self.interrupted(&action, Interruption::Blocked { by: blockers }));
        }
        (schedule.motion, schedule.done) = (None, None);
        schedule.motions.push_front(walk);
        let until = if aside.is_some() { now } else { now + WAIT };
        aside.into_iter().for_each(|step| schedule.motions.push_front(step));
        (schedule.phase, schedule.begin, schedule.until) = (Phase::Waits, now, until);
        schedule.track = Track::Still;
        Ok(())
    }

    fn blockers(&self, agent: NodeId, walk: Walk<'_>) -> Vec<Label> {
        let mut by = self.in_the_way(agent, &self.straight(agent, walk), NARROW);
        if by.is_empty() {
            // They are in the way of all ways round.
            by = self.standers(agent).into_iter().map(|(id, _)| id).collect();
        }
        by.into_iter().map(|id| self.graph.label(id)).collect()
    }
}

/// The distance to keep from somebody from whom one begins at a distance.
fn room_for(wanted: f32, first: f32) -> f32 {
    // Whoever is nearer already goes away.
    wanted.min(first) - 0.01
}

/// Whether two ways keep apart from when the first one begins until both have ended; by less when one has.
fn is_apart(way: &Way, theirs: &Way, least: f32) -> bool {
    let far = |tick: Tick| (spot(&way.feet(tick)) - spot(&theirs.feet(tick))).norm();
    let first = far(way.begin);
    let both = way.end().min(theirs.end());
    let meet = ticks(way.begin, both).all(|tick| far(tick) >= room_for(APART, first));
    meet && ticks(both.max(way.begin), way.end().max(theirs.end())).all(|tick| far(tick) >= room_for(least, first))
}

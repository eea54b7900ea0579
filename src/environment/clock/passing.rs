//! Ways past others: round those who stand, behind those who walk; and waiting for those who cannot be passed.

use nalgebra::{Point2, Point3};
use vc_graph::clock::Span;
use vc_graph::{Label, NodeId, NodeKind, Pose};
use vc_physics::{FloorOptions, Route};

use super::Interruption;
use super::apart::APART;
use super::aside::PATIENCE;
use super::conflict::{WAIT, WAITS, ticks};
use super::schedule::Phase;
use super::track::{Leaf, Passage, Track, Way};
use crate::environment::motion::BodyMotion;
use crate::environment::{ActionError, Environment};

/// Distances at which one passes somebody who stands, metres, and how long one has waited before that: bodies side by
/// side; shoulders turned; squeezed past somebody who does not leave.
pub(in crate::environment) const DISTANCES: [(f32, Span); 3] =
    [(APART, Span(0)), (NARROW, Span(45)), (SQUEEZED, Span(120))];
const NARROW: f32 = 0.4;
const SQUEEZED: f32 = 0.3;
/// How much wider the way round somebody is planned, metres: it leads along cells.
const CELL: f32 = 0.04;
/// The farthest that a way may end from where it is to, metres, and from which it is another way.
const END: f32 = 0.15;
const HERE: f32 = 0.01;

/// A walk as it is planned.
#[derive(Clone, Copy)]
pub(super) struct Walk<'a> {
    pub(super) points: &'a [Point2<f32>],
    pub(super) doors: &'a [NodeId],
    pub(super) feet: Pose,
    pub(super) run: bool,
    /// The distance to keep from those who stand, metres.
    pub(super) apart: f32,
}

impl<'a> Walk<'a> {
    /// The walk of a motion.
    pub(super) fn of(motion: &'a BodyMotion) -> Option<Self> {
        let walk = |points, doors, feet, run| Self { points, doors, feet, run, apart: APART };
        match motion {
            BodyMotion::Walk { points, doors, feet, run } => Some(walk(points, doors, *feet, *run)),
            BodyMotion::StepAside { points, doors, feet } => Some(walk(points, doors, *feet, false)),
            _ => None,
        }
    }
}

pub(super) fn spot(feet: &Pose) -> Point2<f32> {
    feet.translation.vector.xy().into()
}

impl Environment {
    /// The way of a walk that ends first: straight or round others, now or when they have passed. `None` where somebody
    /// who stands is in the way; whoever has waited for that one passes nearer.
    pub(super) fn way(&mut self, agent: NodeId, walk: Walk<'_>) -> Option<Way> {
        let anew = self.anew(agent, walk)?;
        let walk = anew.as_ref().map_or(walk, |route| Walk { points: &route.points, doors: &route.doors, ..walk });
        let walk = Walk { apart: self.distance(agent), ..walk };
        let straight = self.straight(agent, walk);
        if self.is_clear(agent, &straight) {
            return Some(straight);
        }
        let round = self.ways_round(agent, walk);
        let all = std::iter::once(straight).chain(round);
        let found = all.filter_map(|way| self.when_clear(agent, way)).min_by_key(Way::end);
        found.or_else(|| self.way_made(agent, walk))
    }

    /// The distance at which an agent passes those who stand, by how long it has waited for them.
    pub(super) fn distance(&self, agent: NodeId) -> f32 {
        let since = self.clock.running.get(&agent).and_then(|schedule| schedule.waits);
        let waited = since.map_or(Span(0), |since| self.tick() - since);
        let allowed = DISTANCES.into_iter().rev().find(|(_, after)| waited >= *after);
        allowed.map_or(APART, |(distance, _)| distance)
    }

    /// The route of a walk of one who is elsewhere by now; `None` if there is none.
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
        let speed = if walk.run { plan.run } else { plan.walk };
        let from = self.world.pose(agent).unwrap_or_else(Pose::identity);
        let points = from_here(spot(&from), walk.points);
        let passage = |door: &NodeId| Passage::new(&self.world, &self.graph, &points, *door);
        let mut doors: Vec<Passage> = walk.doors.iter().filter_map(passage).collect();
        for passage in &mut doors {
            passage.own = self.own_openness(agent, passage);
        }
        let (begin, apart, aside) = (self.tick(), walk.apart, Vec::new());
        Way { points, begin, speed, from, to: walk.feet, apart, doors, aside }
    }

    /// Ways round those who stand, and where others are going to stand.
    fn ways_round(&mut self, agent: NodeId, walk: Walk<'_>) -> Vec<Way> {
        self.floor.update(&self.world);
        let standing: Vec<Point2<f32>> = self.standers(agent).into_iter().map(|(_, at)| at).collect();
        let claimed = [standing.clone(), self.claims(agent)].concat();
        let mut all = vec![claimed];
        if all[0].len() > standing.len() {
            all.push(standing);
        }
        let route = |circles: &Vec<Point2<f32>>| self.route_past(agent, spot(&walk.feet), circles, walk.apart);
        let routes: Vec<_> = all.iter().filter_map(route).collect();
        routes.iter().map(|r| self.straight(agent, Walk { points: &r.points, doors: &r.doors, ..walk })).collect()
    }

    /// A route to a point at a distance from others.
    pub(super) fn route_past(
        &self,
        agent: NodeId,
        to: Point2<f32>,
        others: &[Point2<f32>],
        apart: f32,
    ) -> Option<Route> {
        let circles: Vec<(Point2<f32>, f32)> = others.iter().map(|at| (*at, apart + CELL)).collect();
        let route = self.floor.route_around(spot(&self.world.pose(agent)?), to, &circles)?;
        route.points.last().is_some_and(|last| (last - to).norm() < END).then_some(route)
    }

    /// A way from the first tick in which it is clear.
    fn when_clear(&self, agent: NodeId, mut way: Way) -> Option<Way> {
        let walkers = self.ways(agent).map(|(_, theirs)| theirs.end());
        let last = walkers.chain(self.leaves(agent).map(Leaf::end)).max().unwrap_or(way.begin) + WAIT;
        while way.begin <= last {
            if self.is_clear(agent, &way) {
                return Some(way);
            }
            way.begin += WAIT;
        }
        None
    }

    /// Waits for those who stand in the way of a walk, after a step aside where that helps; looks for another spot every
    /// two seconds, and ends the action of one who has waited long enough.
    pub(super) fn wait(&mut self, agent: NodeId, walk: BodyMotion) -> Result<(), ActionError> {
        let now = self.tick();
        let aside = if matches!(walk, BodyMotion::Walk { .. }) { self.steps_aside(agent) } else { None };
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        let (action, waited) = (schedule.action, now - *schedule.waits.get_or_insert(now));
        if aside.is_none() && waited >= WAITS {
            let by = Walk::of(&walk).map_or_else(Vec::new, |walk| self.blockers(agent, walk));
            return Err(self.interrupted(&action, Interruption::Blocked { by }));
        }
        let looks = aside.is_none() && waited >= PATIENCE && waited.0 % PATIENCE.0 < WAIT.0;
        let elsewhere = if looks { self.tasks_elsewhere(agent, &walk) } else { None };
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        (schedule.motion, schedule.done) = (None, None);
        match elsewhere {
            Some(tasks) => schedule.tasks = tasks,
            None => schedule.motions.push_front(walk),
        }
        let until = if aside.is_some() { now } else { now + WAIT };
        aside.into_iter().for_each(|step| schedule.motions.push_front(step));
        (schedule.phase, schedule.begin, schedule.until) = (Phase::Waits, now, until);
        schedule.track = Track::Still;
        Ok(())
    }

    /// Those who are in the way of a walk for which there is no way.
    fn blockers(&self, agent: NodeId, walk: Walk<'_>) -> Vec<Label> {
        let way = self.straight(agent, Walk { apart: NARROW, ..walk });
        let mut by = self.in_the_way(agent, &way);
        if by.is_empty() {
            // They are in the way of all ways round, or walk about there.
            let walk_or_stand = self.standers(agent).into_iter().map(|(id, _)| id).chain(self.walkers(agent));
            by = walk_or_stand.collect();
        }
        if self.floor.route(spot(&way.from), spot(&walk.feet)).is_none() {
            by = self.thing_in_the_way(&way).into_iter().collect();
        }
        by.into_iter().map(|id| self.graph.label(id)).collect()
    }

    /// The thing next to the first spot of a way where the floor is not free, or next to its begin.
    fn thing_in_the_way(&self, way: &Way) -> Option<NodeId> {
        let mut spots = ticks(way.begin, way.end()).map(|tick| spot(&way.feet(tick)));
        let at = spots.find(|at| !self.floor.is_free(*at)).unwrap_or_else(|| spot(&way.from));
        let FloorOptions { level, step, height, .. } = *self.floor.options();
        let far = |id: NodeId| {
            let aabb = self.world.aabb(id).filter(|b| b.max.z > level + step && b.min.z < level + height)?;
            let nearest = aabb.nearest(&Point3::new(at.x, at.y, aabb.min.z));
            Some(((nearest.xy() - at).norm(), id))
        };
        let things = self.graph.nodes().filter(|node| node.kind() != NodeKind::Agent).filter_map(|node| far(node.id()));
        things.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| id)
    }
}

/// The points of a way that begins where one is: ways lead over the free floor, and one may be a step beside it.
fn from_here(here: Point2<f32>, points: &[Point2<f32>]) -> Vec<Point2<f32>> {
    let elsewhere = points.first().is_some_and(|first| (first - here).norm() > HERE);
    elsewhere.then_some(here).into_iter().chain(points.iter().copied()).collect()
}

//! Distances between those who are on their way, and from those who stand: no way leads through anybody.

use std::collections::VecDeque;

use nalgebra::Point2;
use vc_graph::NodeId;
use vc_graph::clock::{Span, Tick};
use vc_physics::Posture;

use super::passing::spot;
use super::schedule::Phase;
use super::track::{Leaf, RATE, Sidestep, Track, Way};
use crate::environment::Environment;
use crate::environment::execute::{self, Task};
use crate::environment::motion::BodyMotion;

/// Distance between two bodies, metres: as far as agents stand from each other, and what ways may be short of that.
pub(super) const APART: f32 = execute::APART + SHORT;
/// How much nearer than it should, a way may lead past somebody, metres.
const SHORT: f32 = 0.01;

/// Somebody who walks, or makes way for a walker.
struct Mover<'a> {
    way: &'a Way,
    aside: Option<&'a Sidestep>,
}

impl Mover<'_> {
    fn at(&self, tick: Tick) -> Point2<f32> {
        spot(&self.aside.map_or_else(|| self.way.feet(tick), |step| step.feet(tick)))
    }

    /// Metres per tick, at most.
    fn speed(&self) -> f32 {
        self.way.speed.max(self.aside.map_or(0.0, |step| step.now(self.way.begin).speed)) / RATE
    }
}

impl Environment {
    /// Whether a way meets nobody, and no leaf.
    pub(super) fn is_clear(&self, agent: NodeId, way: &Way) -> bool {
        self.meets_no_mover(agent, way)
            && self.in_the_way(agent, way).is_empty()
            && self.leaves(agent).all(|leaf| self.is_past(agent, way, leaf))
    }

    /// Others who are on their way, or make way.
    fn movers(&self, agent: NodeId) -> impl Iterator<Item = Mover<'_>> {
        self.ways(agent).flat_map(move |(_, way)| {
            let aside = way.aside.iter().filter(move |step| step.agent != agent);
            std::iter::once(Mover { way, aside: None }).chain(aside.map(move |step| Mover { way, aside: Some(step) }))
        })
    }

    /// Whether a way, and the steps of those who make way for it, keep apart from all others who move.
    fn meets_no_mover(&self, agent: NodeId, way: &Way) -> bool {
        let steps = || way.aside.iter().map(|step| Mover { way, aside: Some(step) });
        let ours = || std::iter::once(Mover { way, aside: None }).chain(steps());
        let now = self.tick();
        self.movers(agent).all(|theirs| ours().all(|ours| are_apart(&ours, &theirs, now)))
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
        let moving: Vec<NodeId> =
            self.ways(agent).flat_map(|(id, way)| way.aside.iter().map(|s| s.agent).chain([id])).collect();
        let stands = |id: &NodeId| *id != agent && self.world.posture(*id) == Some(Posture::Standing);
        let all = self.world.agents().filter(|id| stands(id) && !moving.contains(id));
        all.filter_map(|id| Some((id, spot(&self.world.pose(id)?)))).collect()
    }

    /// Those who stand in the way, from now on.
    pub(super) fn in_the_way(&self, agent: NodeId, way: &Way) -> Vec<NodeId> {
        let mut others = self.standers(agent);
        others.retain(|(other, _)| way.aside.iter().all(|step| step.agent != *other));
        let walker = Mover { way, aside: None };
        let (now, end) = (self.tick(), way.end());
        let meets = |at: &Point2<f32>| {
            let far = |tick| (walker.at(tick) - at).norm();
            !stays_over(room_for(way.apart, far(now)), now, end, walker.speed(), far)
        };
        others.into_iter().filter(|(_, at)| meets(at)).map(|(id, _)| id).collect()
    }

    /// Walkers whose ways lead through somebody who stands there by now stop, and plan anew in the next tick: somebody
    /// may have stopped, been sent elsewhere or got up since they set out.
    pub(super) fn heed_standers(&mut self) {
        // Whoever stops may be in the way of others.
        while let Some(agent) = self.led_through_somebody() {
            self.plans_anew(agent);
        }
    }

    fn led_through_somebody(&self) -> Option<NodeId> {
        let mut ways = self.clock.running.iter().filter_map(|(agent, s)| Some((*agent, s.track.way()?)));
        ways.find(|(agent, way)| !self.in_the_way(*agent, way).is_empty()).map(|(agent, _)| agent)
    }

    fn plans_anew(&mut self, agent: NodeId) {
        let now = self.tick();
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return };
        let track = std::mem::replace(&mut schedule.track, Track::Still);
        let walk = schedule.motion.take().filter(|motion| matches!(motion, BodyMotion::Walk { .. }));
        (schedule.phase, schedule.begin, schedule.until) = (Phase::Waits, now, now);
        self.stay(agent, &track);
        let elsewhere = walk.as_ref().and_then(|walk| self.tasks_elsewhere(agent, walk));
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return };
        match elsewhere {
            Some(tasks) => schedule.tasks = tasks,
            None => walk.into_iter().for_each(|walk| schedule.motions.push_front(walk)),
        }
    }

    /// The tasks of an action of which nothing is done but a part of its walk, begun anew: it may end at another spot.
    pub(super) fn tasks_elsewhere(&mut self, agent: NodeId, walk: &BodyMotion) -> Option<VecDeque<Task>> {
        let words = self.graph.vocabulary();
        let schedule = self.clock.running.get(&agent).filter(|s| s.truth.is_none() && s.motions.is_empty())?;
        let tasks = Task::of(words, &schedule.action);
        let is_first = schedule.comes_true_with(words, walk) || tasks.iter().skip(1).eq(&schedule.tasks);
        let is_planned = is_first && tasks.iter().all(|task| self.plan(agent, task.clone()).is_ok());
        is_planned.then_some(tasks)
    }
}

/// Whether two keep apart from a tick until both have ended, the first of whom is planned now: by two bodies while both
/// move, by the distance of whoever moves else.
fn are_apart(ours: &Mover<'_>, theirs: &Mover<'_>, now: Tick) -> bool {
    let far = |tick: Tick| (ours.at(tick) - theirs.at(tick)).norm();
    let (begin, first, closing) = (ours.way.begin, far(now), ours.speed() + theirs.speed());
    let (both, all) = (ours.way.end().min(theirs.way.end()), ours.way.end().max(theirs.way.end()));
    let parts = [(now, begin, theirs.way.apart), (begin, both, APART), (both.max(begin), all, ours.way.apart)];
    parts.iter().all(|(from, to, least)| stays_over(room_for(*least, first), *from, *to, closing, far))
}

/// The distance to keep from somebody from whom one begins at a distance.
fn room_for(wanted: f32, first: f32) -> f32 {
    // Whoever is nearer already goes away.
    wanted.min(first) - SHORT
}

/// Whether a distance that changes by at most `speed` in a tick stays over a least one from a tick to another.
fn stays_over(least: f32, from: Tick, to: Tick, speed: f32, far: impl Fn(Tick) -> f32) -> bool {
    let mut at = from;
    while at <= to {
        let spare = far(at) - least;
        if spare < 0.0 {
            return false;
        }
        // Nobody is there before.
        at += Span((spare / speed.max(1e-3)) as u64 + 1);
    }
    true
}

//! Making way: of two who wait for each other one steps aside; whoever stands with nothing to do steps aside and back.

use nalgebra::Point2;
use vc_graph::clock::Span;
use vc_graph::{NodeId, Pose};
use vc_physics::{Posture, Route};

use super::apart::APART;
use super::conflict::WAIT;
use super::passing::{Walk, spot};
use super::schedule::{Phase, Schedule};
use super::track::{Sidestep, Track, Way};
use crate::environment::Environment;
use crate::environment::motion::BodyMotion;

/// The time in which one who waits looks each time whether somebody can make way, and afterwards the time between.
const EAGER: Span = Span(60);
/// The time after which the first of two who wait for each other makes way, and one who waits looks for another spot.
pub(super) const PATIENCE: Span = Span(120);
/// How far one steps aside, and the distance of the spots that are tried, metres.
const ASIDE: f32 = 4.0;
const BETWEEN: f32 = 0.15;
/// The distance in metres, and the angle in radians, from which on a body is elsewhere.
const SAME: f32 = 1e-3;
/// The number of spots to which a way is looked for.
const SPOTS: usize = 24;

impl Environment {
    /// A way for one who has waited, for which somebody who stands with nothing to do steps aside, and back in the end.
    pub(super) fn way_made(&mut self, agent: NodeId, walk: Walk<'_>) -> Option<Way> {
        let other = self.idle_in_the_way(agent, walk)?;
        let (from, to) = (spot(&self.world.pose(agent)?), spot(&walk.feet));
        let standing = self.standers(agent).into_iter().filter(|(id, _)| *id != other).map(|(_, at)| at);
        let rest: Vec<Point2<f32>> = standing.chain(self.claims(agent)).collect();
        let is_good = |p: &Point2<f32>| rest.iter().chain([&from, &to]).all(|at| (at - p).norm() >= walk.apart);
        let straight = [&[from], walk.points].concat();
        let clear = self.spots_around(other, |p| off(&straight, p) >= walk.apart && is_good(p));
        let near = self.spots_around(other, is_good);
        clear.into_iter().chain(near).find_map(|p| self.way_beside((agent, walk), (other, p), &rest))
    }

    /// The one who stands in the way of a walk, if it is one only, has nothing to do, and it is time to look.
    fn idle_in_the_way(&self, agent: NodeId, walk: Walk<'_>) -> Option<NodeId> {
        let waited = self.tick() - self.clock.running.get(&agent)?.waits?;
        // It takes long to find that there is no room.
        if waited > EAGER && waited.0 % PATIENCE.0 >= WAIT.0 {
            return None;
        }
        let met = self.in_the_way(agent, &self.straight(agent, walk));
        // Whoever stands where the walk ends could not step back.
        let leaves_room = |other: &NodeId| {
            self.world.pose(*other).is_some_and(|at| (spot(&at) - spot(&walk.feet)).norm() >= walk.apart)
        };
        met.first().copied().filter(|other| met.len() == 1 && self.is_idle(*other) && leaves_room(other))
    }

    /// Whether an agent has nothing to do, and makes way for nobody yet.
    pub(in crate::environment) fn is_idle(&self, agent: NodeId) -> bool {
        let makes_way = self.ways(agent).flat_map(|(_, way)| &way.aside).any(|step| step.agent == agent);
        self.current_action(agent).is_none() && self.controlled(agent).is_none() && !makes_way
    }

    /// The way of a walk past somebody who steps to a spot first, through no door.
    fn way_beside(
        &self,
        (agent, walk): (NodeId, Walk<'_>),
        (other, aside): (NodeId, Point2<f32>),
        rest: &[Point2<f32>],
    ) -> Option<Way> {
        let past = self.route_past(agent, spot(&walk.feet), &[rest, &[aside]].concat(), walk.apart)?;
        let from = spot(&self.world.pose(agent)?);
        let step = self.route_past(other, aside, &[rest, &[from, spot(&walk.feet)]].concat(), walk.apart)?;
        let feet = at(&self.world.pose(other)?, &aside);
        let out = self.straight(other, Walk { points: &step.points, doors: &[], feet, run: false, ..walk });
        let mut way = self.straight(agent, Walk { points: &past.points, doors: &past.doors, ..walk });
        way.begin = out.end();
        way.aside.push(Sidestep::new(other, out, way.end()));
        (step.doors.is_empty() && self.is_clear(agent, &way)).then_some(way)
    }

    /// Free spots around an agent, the nearest first.
    fn spots_around(&self, agent: NodeId, is_good: impl Fn(&Point2<f32>) -> bool) -> Vec<Point2<f32>> {
        let Some(feet) = self.world.pose(agent) else { return Vec::new() };
        let stands = |p: &Point2<f32>| self.world.standing(agent, &at(&feet, p)).is_ok_and(|there| there.is_free());
        let all = around(spot(&feet)).into_iter();
        all.filter(|p| self.floor.is_free(*p) && is_good(p) && stands(p)).take(SPOTS).collect()
    }

    /// Puts those who make way for walkers where they are in this tick.
    pub(super) fn put_aside(&mut self) {
        let now = self.tick();
        let ways = self.clock.running.values().filter_map(|schedule| schedule.track.way());
        let steps: Vec<(NodeId, Pose)> =
            ways.flat_map(|way| &way.aside).map(|step| (step.agent, step.feet(now))).collect();
        steps.into_iter().for_each(|(agent, feet)| self.step_to(agent, feet));
    }

    pub(super) fn step_to(&mut self, agent: NodeId, feet: Pose) {
        let stands = self.world.posture(agent) == Some(Posture::Standing) && self.controlled(agent).is_none();
        let is_there = self.world.pose(agent).is_none_or(|now| {
            (now.translation.vector - feet.translation.vector).norm() < SAME
                && now.rotation.angle_to(&feet.rotation) < SAME
        });
        if stands && !is_there && self.world.teleport(agent, feet).is_ok() {
            self.clock.changed.push(agent);
            self.clock.stirred = true;
            // Nobody's action answers for the room to which that leads.
            self.excuse(&self.graph.carried_with(agent));
        }
    }

    /// An agent that begins something, or is moved by somebody, makes way no longer: it goes on from where it has stepped.
    pub(in crate::environment) fn stays_aside(&mut self, agent: NodeId) {
        let now = self.tick();
        let ways = self.clock.running.values().filter_map(|schedule| schedule.track.way());
        let step = ways.flat_map(|way| &way.aside).find(|step| step.agent == agent).map(|step| step.feet(now));
        step.into_iter().for_each(|feet| self.step_to(agent, feet));
        for schedule in self.clock.running.values_mut() {
            if let Track::Way(way) = &mut schedule.track {
                way.aside.retain(|step| step.agent != agent);
            }
        }
    }

    /// A step out of the way of somebody who waits for this agent: of two who wait for each other the one with the larger
    /// number makes way, or the other one if it cannot.
    pub(super) fn steps_aside(&mut self, agent: NodeId) -> Option<BodyMotion> {
        let here = self.world.pose(agent)?;
        let way = self.wanted_past(agent).into_iter().find(|way| off(way, &spot(&here)) < APART)?;
        let apart = self.distance(agent);
        self.floor.update(&self.world);
        let others: Vec<Point2<f32>> = self.standers(agent).into_iter().map(|(_, at)| at).collect();
        let taken = [others.clone(), self.claims(agent)].concat();
        let is_good = |p: &Point2<f32>| off(&way, p) >= APART && taken.iter().all(|at| (at - p).norm() >= APART);
        self.spots_around(agent, is_good).into_iter().find_map(|p| {
            let Route { points, doors, .. } = self.route_past(agent, p, &others, apart)?;
            let step = BodyMotion::StepAside { points, doors, feet: at(&here, &p) };
            self.is_clear(agent, &self.straight(agent, Walk { apart, ..Walk::of(&step)? })).then_some(step)
        })
    }

    /// The ways on which others wait for whom an agent has to make way.
    fn wanted_past(&self, agent: NodeId) -> Vec<Vec<Point2<f32>>> {
        let has_waited = |s: &Schedule| s.waits.is_some_and(|since| self.tick() - since >= PATIENCE);
        let goes_first = |other: NodeId, s: &Schedule| s.phase == Phase::Waits && (other < agent || has_waited(s));
        let wanted = self.others(agent).filter(|(other, schedule)| goes_first(*other, schedule));
        let way = |(other, schedule): (NodeId, &Schedule)| {
            let from = spot(&self.world.pose(other)?);
            Some([&[from], Walk::of(schedule.motions.front()?)?.points].concat())
        };
        wanted.filter_map(way).collect()
    }
}

/// A pose at another point.
fn at(feet: &Pose, p: &Point2<f32>) -> Pose {
    Pose::from_parts([p.x, p.y, feet.translation.z].into(), feet.rotation)
}

/// The distance of a point from a path.
fn off(way: &[Point2<f32>], p: &Point2<f32>) -> f32 {
    let near = |pair: &[Point2<f32>]| {
        let along = pair[1] - pair[0];
        let share = (p - pair[0]).dot(&along) / along.norm_squared().max(1e-9);
        (pair[0] + along * share.clamp(0.0, 1.0) - p).norm()
    };
    way.windows(2).map(near).fold(f32::INFINITY, f32::min)
}

/// Spots around a point, the nearest first.
fn around(middle: Point2<f32>) -> Vec<Point2<f32>> {
    let most = (ASIDE / BETWEEN) as i32;
    let offset = |i: i32| i as f32 * BETWEEN;
    let all = (-most..=most).flat_map(|i| (-most..=most).map(move |j| (i, j)));
    let mut all: Vec<(i32, i32)> = all.filter(|(i, j)| i * i + j * j <= most * most).collect();
    all.sort_by_key(|(i, j)| (i * i + j * j, *i, *j));
    all.into_iter().map(|(i, j)| Point2::new(middle.x + offset(i), middle.y + offset(j))).collect()
}

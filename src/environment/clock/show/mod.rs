//! A tick as it is seen: feet and doors where their motions have them, [hands] at what they take, bodies
//! that [settle] down, and [gestures](gesture).

mod gesture;
mod hands;
mod settle;

use std::collections::BTreeMap;

use nalgebra::Point3;
use vc_graph::{NodeId, Pose};
use vc_people::Activity;
use vc_physics::{Hand, Posture};

use super::Clock;
use super::schedule::{Phase, Schedule};
use super::track::{RATE, REACHING, Track, Way};
use crate::environment::Environment;
use crate::environment::motion::BodyMotion;

pub(super) use settle::Settling;

/// The time in which a hand goes out, seconds.
const OUT: f32 = REACHING.0 as f32 / RATE;
/// Duration of the transition from standing to walking, seconds.
const SETTING_OFF: f32 = 0.3;

impl Environment {
    /// The environment in this tick, as it is seen: walkers on their way, doors half open, hands at what they take. A
    /// still copy for observations and pictures, in which nobody is doing anything; whatever is done to it changes
    /// nothing here.
    ///
    /// Between two events of an action the world itself is not touched, so that watching cannot change the outcome: only
    /// this copy shows the moment. Costs a copy of the bodies and the relations of what moves: half a millisecond.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::clock::Span;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// home.give(me, format!("walk fridge.{}", fridge.0).parse()?);
    /// let mut way = Vec::new();
    /// while home.is_busy() {
    ///     home.step(Span(6));
    ///     way.extend(home.moment().world().pose(me).map(|feet| feet.translation));
    /// }
    /// println!("{} points, a tenth of a second apart", way.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn moment(&self) -> Self {
        let (zero, processes) = (self.clock.zero, self.clock.processes.clone());
        let clock = Clock { zero, processes, controls: self.clock.controls.clone(), ..Clock::default() };
        let mut still = Self { clock, poses: BTreeMap::new(), ..self.clone() };
        still.clock.changed.clone_from(&self.clock.changed);
        still.clock.unseen = true;
        for (&agent, schedule) in &self.clock.running {
            still.clock.changed.push(agent);
            still.show_track(agent, &schedule.track);
            still.show_body(self, agent, schedule);
        }
        // Doors and drawers are there and can be open so far.
        for (door, open) in self.passed_doors() {
            let parts = still.world.parts(door).all().len();
            still.put_parts(door, &vec![open; parts]);
        }
        // For the moment between two ticks things may be where no relation can be told; then those before hold.
        drop(still.read_moved());
        still
    }

    fn show_track(&mut self, agent: NodeId, track: &Track) {
        let now = self.tick();
        if let Some(feet) = track.feet(now) {
            // It stood there before.
            let _ = self.world.teleport(agent, feet);
        }
        match track {
            Track::Leaf(leaf) => {
                // The part is there, and nothing is in its way.
                leaf.open(now)
                    .into_iter()
                    .for_each(|(part, open)| drop(self.world.put_open(leaf.id, Some(part), open)));
            }
            Track::Way(way) => {
                for step in &way.aside {
                    // It stood there before.
                    let _ = self.world.teleport(step.agent, step.feet(now));
                    self.clock.changed.push(step.agent);
                }
            }
            Track::Turn(_) | Track::Reach(_) | Track::Still => {}
        }
    }

    /// Shows what the body of an agent does, and moves what its hands hold. `before` is the environment itself.
    fn show_body(&mut self, before: &Self, agent: NodeId, schedule: &Schedule) {
        if let Track::Way(way) = &schedule.track {
            way.aside.iter().for_each(|step| self.show_walking(before, step.agent, step.now(self.tick())));
            return self.show_walking(before, agent, way);
        }
        let since = (self.tick() - schedule.begin).seconds() as f32;
        if let Some(settling) = schedule.settling.as_ref().filter(|_| schedule.phase == Phase::Back) {
            return settling.show(self, agent, since);
        }
        let Some(motion) = schedule.motion.as_ref().or(schedule.done.as_ref()) else { return };
        let time = match schedule.phase {
            Phase::Out => since,
            Phase::Back => OUT + since,
            Phase::Leaf | Phase::Pushes(..) => OUT,
            Phase::Waits | Phase::Rests | Phase::Ends => return,
        };
        let mut figure = Figure { agent, time, at: None, rest: None, out: schedule.picked };
        match motion {
            // Its effects take longer than it is shown.
            BodyMotion::Gesture(action, _) => {
                let seconds = (schedule.until - schedule.begin).seconds() as f32;
                figure.gesture(self, action, seconds);
            }
            BodyMotion::Take(hand, id, _) | BodyMotion::Undress(hand, id) => figure.take(self, *hand, *id),
            BodyMotion::Put(put) => figure.put(self, put),
            BodyMotion::Drive(drive) => figure.drive(self, drive.id),
            _ => {}
        }
    }

    /// Shows legs that walk, gradually from standing.
    fn show_walking(&mut self, before: &Self, agent: NodeId, way: &Way) {
        // One who has arrived stands, though the walk lasts until others are back or a door is shut.
        if self.tick() <= way.begin || self.tick() >= way.arrival() {
            return;
        }
        let since = (self.tick() - way.begin).seconds() as f32;
        let from = before.skeleton(agent).filter(|_| since < SETTING_OFF);
        let transition = from.map(|from| (from, since / SETTING_OFF));
        let walked = Some(way.speed * since);
        self.poses.insert(agent, Activity { walked, transition, ..Activity::default() });
    }
}

/// The body of an agent in the course of a motion, as it is seen.
struct Figure {
    agent: NodeId,
    /// The time since the motion began, seconds.
    time: f32,
    /// The point that a hand reaches for.
    at: Option<Point3<f32>>,
    /// Where a hand holds what it holds when it does nothing with it, against the feet, and where it is brought.
    rest: Option<Pose>,
    out: Option<Pose>,
}

impl Figure {
    /// An agent's feet, or its seat.
    fn feet(&self, home: &Environment) -> Pose {
        home.world.pose(self.agent).unwrap_or_else(Pose::identity)
    }

    /// Where a hand is when it does nothing, about: from there one reaches.
    fn side(&self, home: &Environment, hand: Hand) -> Point3<f32> {
        let side = if hand == Hand::Right { -0.2 } else { 0.2 };
        let up = if home.world.posture(self.agent) == Some(Posture::Standing) { 1.05 } else { 0.4 };
        self.feet(home) * Point3::new(0.3, side, up)
    }
}

/// A share of the way from one pose to another.
fn between(from: &Pose, to: &Pose, share: f32) -> Pose {
    let turn = from.rotation.try_slerp(&to.rotation, share, 1e-6).unwrap_or(to.rotation);
    Pose::from_parts(from.translation.vector.lerp(&to.translation.vector, share).into(), turn)
}

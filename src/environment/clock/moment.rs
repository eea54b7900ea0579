//! A tick as it is seen: feet, doors and hands where their motions have them.

use std::collections::BTreeMap;

use vc_graph::NodeId;
use vc_people::Activity;

use super::Clock;
use super::schedule::{Phase, Schedule};
use super::track::{REACHING, Track};
use crate::environment::Environment;
use crate::environment::course::BodyMotion;
use crate::environment::playback::Player;

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
        let mut still = Self { clock: Clock::default(), poses: BTreeMap::new(), ..self.clone() };
        still.clock.changed.clone_from(&self.clock.changed);
        still.clock.unseen = true;
        let mut doors: BTreeMap<NodeId, f32> = BTreeMap::new();
        for (&agent, schedule) in &self.clock.running {
            still.clock.changed.push(agent);
            still.show_track(agent, &schedule.track, &mut doors);
            still.show_body(agent, schedule);
        }
        // Doors and drawers are there and can be open so far.
        doors.into_iter().for_each(|(door, open)| drop(still.world.put_open(door, None, open)));
        // For the moment between two ticks things may be where no relation can be told; then those before hold.
        drop(still.read_moved());
        still
    }

    fn show_track(&mut self, agent: NodeId, track: &Track, doors: &mut BTreeMap<NodeId, f32>) {
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
            // A door is as open as the one who needs it widest has it.
            Track::Way(way) => {
                for (door, open) in way.passes(now) {
                    let widest = doors.entry(door).or_insert(open);
                    *widest = widest.max(open);
                }
            }
            Track::Turn(_) | Track::Still => {}
        }
    }

    /// Shows what the body of an agent does, and moves what its hands hold.
    fn show_body(&mut self, agent: NodeId, schedule: &Schedule) {
        if let Track::Way(way) = &schedule.track {
            let walked = way.speed * (self.tick() - way.begin).seconds() as f32;
            let activity = Activity { walked: Some(walked), ..Activity::default() };
            self.poses.extend((self.tick() > way.begin).then_some((agent, activity)));
            return;
        }
        let since = (self.tick() - schedule.begin).seconds() as f32;
        let Some(motion) = schedule.motion.as_ref().or(schedule.done.as_ref()) else { return };
        let time = match schedule.phase {
            Phase::Out => since,
            Phase::Back => REACHING.seconds() as f32 + since,
            _ => REACHING.seconds() as f32,
        };
        let mut player = Player::at(agent, time, schedule.picked);
        match motion {
            // Its effects take longer than it is shown.
            BodyMotion::Gesture(action, _) => {
                let seconds = (schedule.until - schedule.begin).seconds() as f32;
                player.gesture(self, action, seconds);
            }
            BodyMotion::Take(hand, id, _) | BodyMotion::Undress(hand, id) => player.show_taking(self, *hand, *id),
            BodyMotion::Put(put) => player.show_putting(self, put),
            BodyMotion::Drive(drive) => player.show_driving(self, drive.id),
            _ => {}
        }
    }
}

//! Coming to rest, step by step.

use serde::{Deserialize, Serialize};
use vc_graph::NodeId;

use crate::world::PhysicsWorld;

/// Steps after which things that only tremble or creep are held still.
const ROUND: u32 = 120;
/// Number of rounds after which fast things are held still too.
const ROUNDS: u32 = 4;
/// Steps between checks for things that rest already; at first there is one after each.
const CHECK: u32 = 3;
/// The speed below which a thing is held still then, metres a second.
const SLOW: f32 = 0.05;

/// How long a world has been coming to rest, for [`step_awake`](PhysicsWorld::step_awake). Begin a new one when
/// something is disturbed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct RestProgress {
    /// Steps since something was disturbed.
    steps: u32,
}

impl RestProgress {
    /// Steps since something was disturbed; none while all rests.
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// Whether it is time to check for things that rest already.
    fn is_check(self) -> bool {
        self.steps % ROUND < CHECK || self.steps.is_multiple_of(CHECK)
    }

    /// Whether a round has ended, after which slow things are held still.
    fn is_round(self) -> bool {
        self.steps.is_multiple_of(ROUND)
    }
}

impl PhysicsWorld {
    /// One step of coming to rest, if anything is awake; returns whether there was such a step. Things that certainly
    /// rest fall asleep soon ([`put_to_sleep`](Self::put_to_sleep)). After 120 steps things that are slower than 5 cm/s
    /// are held where they are ([`pin`](Self::pin)) if all are that slow, and after 480 steps all, so that it ends after
    /// 480 steps at most.
    ///
    /// A thing that has lost its support since the last step learns so with the next [`step`](Self::step) only: let that
    /// come first.
    ///
    /// Costs a [`step`](Self::step) and some microseconds for each awake thing.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let mut progress = vc_physics::RestProgress::default();
    /// while world.step_awake(&mut progress) {
    ///     assert!(progress.steps() <= 480);
    /// }
    /// assert!(world.awake() == 0 && progress.steps() == 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn step_awake(&mut self, progress: &mut RestProgress) -> bool {
        if self.engine.is_still() {
            *progress = RestProgress::default();
            return false;
        }
        self.step();
        progress.steps += 1;
        // Things that surely rest need not be watched for longer.
        if progress.is_check() {
            self.put_to_sleep();
        }
        if progress.is_round() {
            self.hold_slow(progress.steps >= ROUND * ROUNDS);
        }
        true
    }

    /// Holds still what only trembles or creeps, if nothing moves fast, or in any case.
    fn hold_slow(&mut self, in_any_case: bool) {
        let restless = self.restless();
        let fast = |id: &NodeId| self.thing(*id).is_ok_and(|thing| self.velocity(thing).norm() > SLOW);
        if !in_any_case && restless.iter().any(fast) {
            return;
        }
        for id in restless {
            // It is loose, so it can be held.
            let _ = self.pin(id, None);
        }
        if !self.engine.is_at_rest() {
            // The step that finds contacts is no time that passes: this tick has had its own.
            let now = self.ticks;
            self.rest();
            self.ticks = now;
        }
    }

    /// Loose things that are awake.
    fn restless(&self) -> Vec<NodeId> {
        if self.engine.is_at_rest() {
            return Vec::new();
        }
        self.loose().filter(|thing| !self.is_asleep(thing)).map(|thing| thing.id).collect()
    }
}

//! The passing of time.

use rapier3d::dynamics::RigidBodyHandle;

use crate::state::Agent;
use crate::world::PhysicsWorld;
use crate::{BodyRole, group};

/// # Time
impl PhysicsWorld {
    /// Lets one step of time pass: agents walk, vehicles drive, water carries, motors turn, bodies fall.
    ///
    /// Costs a microsecond or two while everything sleeps.
    pub fn step(&mut self) {
        let awake: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        let fixed = self.engine.fixed_among(&awake);
        let ridden = self.ridden(&awake);
        self.move_agents();
        self.work_hands();
        for _ in 0..self.settings.substeps {
            self.push_vehicles();
            self.push_floating();
            self.resist_rolling();
            let stopped = self.engine.step().to_vec();
            stopped.into_iter().for_each(|b| self.stop(b));
        }
        self.engine.keep(&fixed);
        self.take_riders_along(ridden);
        self.follow_hands();
        self.tend_motors();
        self.watch();
        self.record_sleepers(&awake);
        self.ticks += 1;
    }

    /// Lets a number of steps pass.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.run(30);
    /// assert_eq!(world.ticks(), 30);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&mut self, steps: u32) {
        (0..steps).for_each(|_| self.step());
    }

    /// Lets a number of steps pass in which nothing happens; returns whether it did. It does not where a step would
    /// move something: while a thing is [awake](Self::awake), a motor drives, or an agent walks or falls.
    ///
    /// All is then as after [`run`](Self::run), except that standing agents have not looked for the ground below their
    /// feet meanwhile. A thing that has lost its support since the last step learns so with the next [`step`](Self::step)
    /// only: let that come first.
    ///
    /// Costs as much for a year as for a step: about a microsecond for a home.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(!world.pass(60)); // The cup is about to settle.
    /// world.settle(300);
    /// let before = world.ticks();
    /// assert!(world.pass(3600));
    /// assert_eq!(world.ticks(), before + 3600);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pass(&mut self, ticks: u64) -> bool {
        let idle = self.engine.is_still() && self.driven.is_empty() && self.agents.values().all(Agent::is_still);
        if idle {
            self.ticks = self.ticks.saturating_add(ticks);
        }
        idle
    }

    /// Stops and lists a body that has become non-finite.
    fn stop(&mut self, body: RigidBodyHandle) {
        let Some(id) = self.engine.bodies.get(body).map(|b| group::marked(b.user_data).0) else { return };
        if let Ok(thing) = self.thing_mut(id) {
            thing.state.role = BodyRole::Stopped;
        }
        if !self.stopped.contains(&id) {
            self.stopped.push(id);
        }
    }
}

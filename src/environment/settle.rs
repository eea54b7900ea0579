//! Bodies come to rest after an action, a reset or another change.

use vc_physics::{PhysicsWorld, RestProgress};

/// Lets what was disturbed come to rest; what only trembles or creeps is held where it is.
pub(super) fn come_to_rest(world: &mut PhysicsWorld) {
    // A thing that has lost its support wakes in this step.
    world.step();
    let mut progress = RestProgress::default();
    while world.step_awake(&mut progress) {}
}

//! Bodies come to rest after an action, a reset or another change.

use vc_graph::NodeId;
use vc_physics::{BodyRole, PhysicsWorld};

/// Steps in which what an action has disturbed comes to rest.
const CALM: u32 = 120;
/// How often that is tried while something still moves fast.
const AGAIN: u32 = 4;
/// Steps between looks for what rests already; at first there is one after each.
const DOZE: u32 = 3;
/// The speed below which a thing is held still then, metres a second.
const SLOW: f32 = 0.05;

/// Lets what was disturbed come to rest; what only trembles or creeps is held where it is.
pub(super) fn come_to_rest(world: &mut PhysicsWorld) {
    world.step();
    for _ in 0..AGAIN {
        let mut left = CALM;
        while left > 0 && world.awake() > 0 {
            world.step();
            left -= 1;
            // Things that surely rest need not be watched for longer.
            if left.is_multiple_of(DOZE) || left + DOZE > CALM {
                world.put_to_sleep();
            }
        }
        let fast = |id: &NodeId| world.velocity(*id).is_some_and(|v| v.norm() > SLOW);
        if !restless(world).iter().any(fast) {
            break;
        }
    }
    for id in restless(world) {
        // It is loose, so it can be held.
        let _ = world.pin(id);
    }
    if world.awake() > 0 {
        world.rest();
    }
}

/// Loose things that are awake.
fn restless(world: &PhysicsWorld) -> Vec<NodeId> {
    let loose = |id: &NodeId| world.role(*id) == Some(BodyRole::Loose) && !world.is_asleep(*id);
    if world.awake() == 0 { Vec::new() } else { world.nodes().into_iter().filter(loose).collect() }
}

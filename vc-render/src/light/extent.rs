//! The extents of rooms.

use vc_graph::ObjectRole;

use crate::math::{self, three};
use crate::scene::Snapshot;

/// Boxes around rooms, from their floors and walls.
pub(super) fn rooms(snapshot: &Snapshot) -> Vec<([f32; 3], [f32; 3])> {
    let count = snapshot.rooms.len() + 1;
    let mut all = vec![([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]); count];
    let mut floors = vec![false; count];
    let mut ceilings = vec![f32::INFINITY; count];
    for body in &snapshot.bodies {
        let room = usize::from(body.room).min(count - 1);
        let floor = body.role == ObjectRole::Floor;
        let map = math::Affine::from_pose(&body.pose).narrow();
        let around = body.bounds.mapped(&map);
        let (low, high) = (three(|i| around.centre[i] - around.half[i]), three(|i| around.centre[i] + around.half[i]));
        // In the plan, the floor alone gives the extent if there is one; upwards, all bodies do.
        let (from, to) = &mut all[room];
        if floor && !floors[room] {
            floors[room] = true;
            for i in 0..2 {
                (from[i], to[i]) = (low[i], high[i]);
            }
        } else if floor || !floors[room] {
            for i in 0..2 {
                (from[i], to[i]) = (from[i].min(low[i]), to[i].max(high[i]));
            }
        }
        from[2] = from[2].min(if floor { high[2] } else { low[2].max(from[2].min(high[2])) });
        // A room ends at its ceiling.
        if body.role == ObjectRole::Ceiling {
            ceilings[room] = ceilings[room].min(low[2]);
        }
        to[2] = to[2].max(high[2]);
    }
    for ((low, high), known) in all.iter_mut().zip(snapshot.bounds.iter()) {
        let Some(known) = known else { continue };
        // Floors go on under walls and doors, beyond which there may be daylight.
        for i in 0..2 {
            let (from, to) = (low[i].max(known.min[i]), high[i].min(known.max[i]));
            (low[i], high[i]) = if from < to { (from, to) } else { (low[i], high[i]) };
        }
    }
    for ((low, high), ceiling) in all.iter_mut().zip(ceilings) {
        high[2] = high[2].min(ceiling);
        if low.iter().chain(high.iter()).any(|v| !v.is_finite()) {
            (*low, *high) = ([0.0; 3], [1.0; 3]);
        }
        high[2] = high[2].max(low[2] + 0.1);
    }
    all
}

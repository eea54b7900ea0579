//! Doors of lifts, and their buttons.

use vc_graph::asset::JointKind;

use super::door::{PROUD, frame_of};
use crate::material::*;
use crate::solid::{Build, fit, half_dims};

/// Two leaves that slide apart behind the wall; X points to who comes in.
pub(super) fn lift_door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.02, 0.4, 0.9]);
    let (x, y, h) = half_dims(b);
    let (post, lap, gap) = (0.03 * u, 0.02 * u, 0.004 * u);
    let leaf = b.choose(&[STEEL, STEEL, ALUMINIUM, ANTHRACITE, BRASS]);
    let trim = b.choose(&[STEEL, ANTHRACITE, BLACK_GRANITE]);
    frame_of(b, post, trim, PROUD * u);
    let front = -x - PROUD * u - gap;
    let (back, clear) = (front - 0.03 * u, y - post);
    let middle = 0.0015 * u;
    for (side, way) in [(1.0, [0.0, 1.0, 0.0]), (-1.0, [0.0, -1.0, 0.0])] {
        let (near, far) = (side * middle, side * (clear + lap));
        b.jointed(JointKind::Slide, [0.0; 3], way, (0.0, clear), |b| {
            let (low, high) = ([back, near.min(far), 0.012 * u], [front, near.max(far), h - post + lap]);
            b.block("leaf", low, high, leaf);
            // The rubber along the edge at which the leaves meet.
            let (inner, seam) = (side * 0.0005 * u, near);
            b.block(
                "edge",
                [back + 0.008 * u, inner.min(seam), low[2]],
                [front - 0.008 * u, inner.max(seam), high[2]],
                RUBBER,
            );
        });
    }
}

/// A plate with a button in a ring that shines while the lift is called.
pub(super) fn call_button(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let plate = b.choose(&[STEEL, ALUMINIUM, BRASS, BLACK_METAL]);
    b.rounded_block("plate", [-x, -y, 0.0], [0.0, y, h], x * 0.4, plate);
    let radius = 0.6 * y.min(h / 2.0);
    button(b, (-x * 0.2, x), h / 2.0, radius);
}

/// A round button in a ring that shines while its storey is asked for.
pub(super) fn floor_button(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    button(b, (-x, x), h / 2.0, y.min(h / 2.0));
}

/// The plate of a cabin in which its buttons are.
pub(super) fn lift_panel(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let plate = b.choose(&[STEEL, ALUMINIUM, BLACK_GLASS]);
    b.rounded_block("plate", [-x, -y, 0.0], [x, y, h], x * 0.4, plate);
}

/// A button that stands out of its ring.
fn button(b: &mut Build<'_>, (back, front): (f32, f32), z: f32, radius: f32) {
    let cap = b.choose(&[STEEL, WHITE_PLASTIC, BLACK_PLASTIC]);
    let face = back + 0.7 * (front - back);
    b.rod("ring", [back, 0.0, z], [face, 0.0, z], radius, LED);
    b.rod("cap", [back, 0.0, z], [front, 0.0, z], 0.75 * radius, cap);
}

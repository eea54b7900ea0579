//! Hinged doors of furniture.

use std::f32::consts::FRAC_PI_2;

use super::{Front, GAP, Handle, Swing, front_panel, gapped, handle, swing};
use crate::material::MaterialId;
use crate::solid::{Build, P};

/// The place of a handle across a front: away from the hinge, `inset` from the edge.
pub(super) fn opposite(side: Swing, (low, high): (P, P), inset: f32) -> f32 {
    match side {
        Swing::Left => low[1] + inset,
        Swing::Right => high[1] - inset,
        _ => f32::midpoint(low[1], high[1]),
    }
}

/// A hinged front that fills the rectangle `low..high` (its thickness along X) with a gap around
/// it; it opens outwards by up to about 100 degrees.
pub(in crate::object) fn door(
    b: &mut Build<'_>,
    name: &str,
    low: P,
    high: P,
    side: Swing,
    kind: Handle,
    mats: (MaterialId, MaterialId),
) {
    let (low, high) = gapped(low, high, GAP / 2.0);
    let grip = opposite(side, (low, high), 0.04);
    swing(b, side, low, high, FRAC_PI_2 * 1.1, |b| {
        b.block(name, low, high, mats.0);
        let tall = high[2] - low[2];
        let length = (tall * 0.35).min(0.16);
        // Low units have the handle at the top, high ones at the bottom, tall ones in the middle.
        let z = if tall > 1.1 {
            f32::midpoint(low[2], high[2])
        } else if low[2] > 1.2 {
            low[2] + length * 0.5 + 0.04
        } else {
            high[2] - length * 0.5 - 0.04
        };
        handle(b, kind, [high[0], grip, z], length, true, mats.1);
    });
}

/// A hinged front of a given design that fills a rectangle with a gap around it.
pub(in crate::object) fn leaf(
    b: &mut Build<'_>,
    name: &str,
    (low, high): (P, P),
    side: Swing,
    (design, kind): (Front, Handle),
    mats: (MaterialId, MaterialId),
) {
    let (low, high) = gapped(low, high, GAP / 2.0);
    let inset = 0.035_f32.min((high[1] - low[1]) * 0.2);
    let grip = opposite(side, (low, high), inset);
    swing(b, side, low, high, FRAC_PI_2 * 1.1, |b| {
        front_panel(b, name, low, high, design, mats.0);
        let tall = high[2] - low[2];
        let length = (tall * 0.35).min(0.18);
        // At hand height, as far as the door extends that far.
        let margin = (length / 2.0 + 0.04).min(tall / 2.0);
        let z = 1.05_f32.min(high[2] - margin).max(low[2] + margin);
        handle(b, kind, [high[0], grip, z], length, true, mats.1);
    });
}

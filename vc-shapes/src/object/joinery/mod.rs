//! Cabinet-making elements: handles, fronts, doors, drawers and legs, used by furniture, kitchens, appliances and
//! bathrooms alike.
//!
//! Fronts face X. Those of case furniture ([`front`]) have one thickness and gap in metres; those of fitted units and
//! appliances ([`fitted`]) scale with the unit.

mod door;
mod drawer;
mod fitted;
mod front;
mod handle;
mod swing;

pub(super) use door::{door, leaf};
pub(super) use drawer::drawer;
pub(super) use fitted::{Fitted, Panel, cupboard_door, cupboard_doors, drawers, panel, pull_out};
pub(super) use front::{Front, frame, front_panel};
pub(super) use handle::{Handle, handle};
pub(super) use swing::{Swing, gapped, lid, swing};

use crate::material::MaterialId;
use crate::solid::{Build, CORNERS};

/// The thickness of boards, metres.
pub(super) const BOARD: f32 = 0.018;

/// The gap between fronts, metres.
pub(super) const GAP: f32 = 0.003;

/// Four straight legs under a rectangle of half lengths `half`, from the floor to `height`, square
/// or round, inside the edges.
pub(super) fn legs(b: &mut Build<'_>, half: (f32, f32), height: f32, thickness: f32, round: bool, mat: MaterialId) {
    let (x, y) = (half.0 - thickness / 2.0, half.1 - thickness / 2.0);
    let r = thickness / 2.0;
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * x, sy * y);
        if round {
            b.lathe("leg", [cx, cy, 0.0], &[(r * 0.7, 0.0), (r, height * 0.9), (r, height)], mat);
        } else {
            b.block("leg", [cx - r, cy - r, 0.0], [cx + r, cy + r, height], mat);
        }
    }
}

//! Tables and desks.

use super::build::Build;
use super::joinery::legs;
use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[indoor("dining_table", 37, dining_table)];

/// A top on four legs with aprons between them.
fn dining_table(b: &mut Build<'_>) {
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (top, leg) = (b.vary(0.02, 0.04), b.vary(0.05, 0.08));
    let wood = b.style.wood;
    let round = b.rng.chance(0.4);
    b.soft("top", [-x, -y, h - top], [x, y, h], 0.006, wood);
    legs(b, (x - 0.03, y - 0.03), h - top, leg, round, wood);
    let (ax, ay, low) = (x - 0.03 - leg, y - 0.03 - leg, h - top - 0.08);
    for side in [-1.0_f32, 1.0] {
        let cy = side * (y - 0.05);
        b.block("apron", [-ax, cy - 0.01, low], [ax, cy + 0.01, h - top], wood);
        let cx = side * (x - 0.05);
        b.block("apron", [cx - 0.01, -ay, low], [cx + 0.01, ay, h - top], wood);
    }
    b.top("top", [0.0, 0.0, h], (x - 0.02, y - 0.02));
}

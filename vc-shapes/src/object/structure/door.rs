//! Doors in their frames.
//!
//! The origin is the centre of the wall at floor level, and the size is that of the opening: trims
//! and handles protrude from it.

use vc_graph::asset::JointKind;

use crate::material::*;
use crate::object::cooker::fitting::*;
use crate::object::joinery::{Swing, swing};
use crate::solid::{Axis, Build, P, fit, half_dims, plate_with_hole};

/// How far trims protrude from the wall, and how far they overlap it.
pub(super) const PROUD: f32 = 0.01;
const OVERLAP: f32 = 0.05;

/// The properties of a leaf.
#[derive(Debug, Clone, Copy)]
struct Leaf<'a> {
    /// The relative heights of the panels from below; empty for a plain leaf.
    rows: &'a [f32],
    columns: usize,
    /// The width of the frame around panels.
    border: f32,
    infill: MaterialId,
    mat: MaterialId,
}

/// A door inside a home.
pub(super) fn door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.02, 0.3, 0.8]);
    let mat = b.style.joinery;
    let (infill, rows): (MaterialId, &[f32]) = match b.rng.below(8) {
        0 | 1 => (mat, &[]),
        2 => (mat, &[1.0]),
        3 => (mat, &[0.8, 1.0]),
        4 => (mat, &[0.9, 0.5, 1.0]),
        5 => (mat, &[0.8, 0.8, 0.8]),
        6 => (FROSTED_GLASS, &[1.0]),
        _ => (GLASS, &[1.0, 1.0, 1.0, 1.0]),
    };
    let columns = if rows.len() > 1 { b.rng.count(1, 2) } else { 1 };
    let border = b.vary(0.09, 0.12) * u;
    frame(b, 0.035 * u, mat, u);
    let handle = b.style.metal;
    hinged(b, &Leaf { rows, columns, border, infill, mat }, (0.035 * u, 0.04), Swing::Left, (handle, u));
}

/// The door of a home: heavy, with a lock, a peephole and a slot for letters.
pub(super) fn main_door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.025, 0.4, 0.9]);
    let mat = b.choose(&[b.style.wood, FOREST, NAVY, RED, ANTHRACITE, WALNUT, WHITE]);
    let rows: &[f32] = b.choose(&[&[1.0, 1.0, 0.6], &[1.0, 1.4], &[0.7, 0.7, 0.7, 0.7], &[]]);
    let columns = if rows.is_empty() { 1 } else { b.rng.count(1, 2) };
    let border = b.vary(0.11, 0.14) * u;
    let post = 0.05 * u;
    frame(b, post, b.style.joinery, u);
    let (x, y, h) = half_dims(b);
    let t = 0.055_f32.min(x * 1.8);
    let metal = b.style.metal;
    hinged(b, &Leaf { rows, columns, border, infill: mat, mat }, (post, 0.055), Swing::Left, (metal, u));
    let slot = b.rng.chance(0.6);
    let (low, high) = leaf_box((x, y, h), post, t);
    swing(b, Swing::Left, low, high, 1.65, |b| {
        let eye = h * 0.72;
        b.rod("peephole", [low[0] - 0.006, 0.0, eye], [high[0] + 0.006, 0.0, eye], 0.014 * u, metal);
        let lock = [-y + post + 0.055 * u, (h * 0.49).min(1.03) + 0.14 * u];
        b.rod("lock", [low[0] - 0.01, lock[0], lock[1]], [high[0] + 0.01, lock[0], lock[1]], 0.024 * u, metal);
        if slot {
            let z = h * 0.4;
            b.block("letter_slot", [low[0] - 0.006, -0.13 * u, z], [high[0] + 0.006, 0.13 * u, z + 0.05 * u], metal);
        } else {
            let z = h * 0.68;
            b.lathe_along(
                "knocker",
                [low[0] + t * 0.3, 0.0, z],
                [low[0] - 1.0, 0.0, z],
                &[(0.04 * u, 0.0), (0.03 * u, 0.02 + t * 0.3)],
                metal,
            );
        }
    });
    b.block("threshold", [-x, -y + post, 0.0], [x - 0.06_f32.min(x), y - post, 0.006 * u], metal);
}

/// A glazed door to the balcony, with two leaves in a wide opening.
pub(super) fn balcony_door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.03, 0.4, 0.9]);
    let mat = b.choose(&[WHITE_PLASTIC, b.style.joinery, ANTHRACITE]);
    let post = 0.05 * u;
    frame(b, post, mat, u);
    let (x, y, h) = half_dims(b);
    let sill = if y < 0.55 { 0.003 } else { 0.02 };
    b.block("sill", [-x, -y + post, 0.0], [x, y - post, sill * u], mat);
    let rows: &[f32] = b.choose(&[&[1.0], &[1.0], &[0.45, 1.3], &[0.6, 1.0, 1.0]]);
    let (border, metal) = (0.085 * u, b.style.metal);
    let leaf = Leaf { rows, columns: 1, border, infill: GLASS, mat };
    if y < 0.55 {
        return hinged(b, &leaf, (post, 0.06), Swing::Left, (metal, u));
    }
    let t = 0.06_f32.min(x * 1.8);
    let (low, high) = leaf_box((x, y, h), post, t);
    for (at, y0, y1) in [(Swing::Right, low[1], -0.0015), (Swing::Left, 0.0015, high[1])] {
        let (from, to) = ([low[0], y0, 0.022 * u], [high[0], y1, high[2]]);
        swing(b, at, from, to, 1.65, |b| {
            leaf_of(b, &leaf, from, to);
            if at == Swing::Left {
                levers(b, (low[0], high[0]), (y0 + border * 0.5, 1.0), (h * 0.49).min(1.03), (metal, u));
            }
        });
    }
}

/// A leaf that hangs from a rail in front of the wall and slides to the left.
pub(super) fn sliding_door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.02, 0.4, 0.9]);
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[b.style.joinery, b.style.wood, b.style.wood]);
    let iron = b.choose(&[IRON, b.style.metal]);
    let lining = 0.025 * u;
    frame_of(b, lining, mat, PROUD);
    let (infill, rows): (MaterialId, &[f32]) = b.choose(&[
        (mat, &[1.0, 1.0][..]),
        (GLASS, &[1.0, 1.0, 1.0]),
        (mat, &[]),
        (FROSTED_GLASS, &[1.0]),
        (mat, &[1.0, 0.4, 1.0]),
    ]);
    let back = x + PROUD + 0.004 * u;
    let front = back + 0.035 * u;
    let reach = y + 0.03 * u;
    let leaf = Leaf { rows, columns: 1, border: 0.11 * u, infill, mat };
    let rail = h + 0.07 * u;
    b.block("rail", [back + 0.012 * u, -y - 0.05 * u, rail], [back + 0.02 * u, 3.0 * y, rail + 0.04 * u], iron);
    for cy in [-y * 0.9, 0.0, y, 2.0 * y, 2.9 * y] {
        b.rod("bolt", [x - 0.002, cy, rail + 0.02 * u], [back + 0.026 * u, cy, rail + 0.02 * u], 0.01 * u, iron);
    }
    b.jointed(JointKind::Slide, [back, -reach, 0.0], [0.0, 1.0, 0.0], (0.0, 1.9 * y), |b| {
        leaf_of(b, &leaf, [back, -reach, 0.012 * u], [front, reach, h + 0.03 * u]);
        for cy in [-y * 0.7, y * 0.7] {
            b.block(
                "hanger",
                [front - 0.001, cy - 0.02 * u, h - 0.1 * u],
                [front + 0.006 * u, cy + 0.02 * u, rail + 0.05 * u],
                iron,
            );
            b.rod(
                "wheel",
                [back + 0.022 * u, cy, rail + 0.052 * u],
                [front + 0.002 * u, cy, rail + 0.052 * u],
                0.022 * u,
                iron,
            );
        }
        let z = (h * 0.49).min(1.03);
        grab(b, [front, -reach + 0.055 * u, z], 0.24 * u, true, 0.05 * u, iron);
        b.block(
            "pull",
            [back - 0.002, -reach + 0.035 * u, z - 0.06 * u],
            [back + 0.001, -reach + 0.075 * u, z + 0.06 * u],
            iron,
        );
    });
}

/// One wide leaf of ribbed panels that swings up and in.
pub(super) fn garage_door(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.02, 1.0, 0.8]);
    let mat = b.choose(&[WHITE_METAL, SILVER_METAL, BROWN_PLASTIC, ANTHRACITE]);
    let post = 0.06 * u;
    frame_of(b, post, mat, PROUD);
    let (x, y, h) = half_dims(b);
    let t = 0.04_f32.min(x * 1.8);
    let (low, high) = leaf_box((x, y, h), post, t);
    let rows = b.rng.count(4, 6);
    let windows = b.rng.chance(0.4);
    swing(b, Swing::Up, low, high, 1.5, |b| {
        let (inner, outer) = (low[0] + t * 0.25, high[0] - t * 0.25);
        b.block("leaf", [inner, low[1], low[2]], [outer, high[1], high[2]], mat);
        let step = (high[2] - low[2]) / rows as f32;
        for i in 0..rows {
            let z = low[2] + step * i as f32;
            let (from, to) = ([low[0], low[1], z + step * 0.04], [high[0], high[1], z + step * 0.96]);
            if windows && i + 1 == rows {
                for k in 0..4 {
                    let w = (high[1] - low[1]) / 4.0;
                    let cy = low[1] + w * k as f32;
                    b.block(
                        "pane",
                        [from[0], cy + w * 0.12, from[2] + step * 0.15],
                        [to[0], cy + w * 0.88, to[2] - step * 0.15],
                        BLACK_GLASS,
                    );
                }
            } else {
                b.block("panel", from, to, mat);
            }
        }
        grab(b, [high[0], 0.0, h * 0.35], 0.2 * u, false, 0.05 * u, BLACK_METAL);
    });
}

/// A frame without its door.
pub(super) fn doorjamb(b: &mut Build<'_>) {
    b.anchored();
    let u = fit(b, [0.05, 0.4, 0.9]);
    frame(b, 0.04 * u, b.style.joinery, u);
}

/// A knob on a rose.
pub(super) fn doorknob(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = (h / 2.0).min(y);
    let mat = b.style.metal;
    b.lathe_along("rose", [-x, 0.0, r], [x, 0.0, r], &[(r, 0.0), (r * 0.9, x * 0.2)], mat);
    if y > r * 1.4 {
        let neck = 2.0 * x - r * 0.3;
        b.rod("neck", [-x, 0.0, r], [-x + neck, 0.0, r], r * 0.35, mat);
        b.bar("lever", [x - r * 0.3, 0.0, r], [x - r * 0.3, y - r * 0.3, r], r * 0.3, mat);
        b.rod("lever", [x - r * 0.3, -y, r], [x - r * 0.3, 0.0, r], r * 0.28, mat);
    } else {
        let grip = [(r * 0.4, 0.0), (r * 0.35, x * 0.8), (r * 0.9, x * 1.3), (r * 0.95, x * 1.6), (r * 0.6, x * 2.0)];
        b.lathe_along("knob", [-x, 0.0, r], [x, 0.0, r], &grip, mat);
    }
}

/// Lining, trims on both sides of the wall and a stop behind the leaf.
fn frame(b: &mut Build<'_>, post: f32, mat: MaterialId, u: f32) {
    frame_of(b, post, mat, PROUD * u);
    let (x, y, h) = half_dims(b);
    let (front, t) = (x - 0.062_f32.min(x * 1.85), 0.012 * u);
    if front - t > -x {
        let inner = y - post;
        for cy in [(-inner, -inner + t), (inner - t, inner)] {
            b.block("stop", [front - t, cy.0, 0.0], [front, cy.1, h - post], mat);
        }
        b.block("stop", [front - t, -inner + t, h - post - t], [front, inner - t, h - post], mat);
    }
}

/// The lining of the opening, `post` thick, and the trims.
pub(super) fn frame_of(b: &mut Build<'_>, post: f32, mat: MaterialId, proud: f32) {
    let (x, y, h) = half_dims(b);
    let over = OVERLAP * (proud / PROUD);
    for cy in [(-y, -y + post), (y - post, y)] {
        b.block("jamb", [-x, cy.0, 0.0], [x, cy.1, h], mat);
    }
    b.block("head", [-x, -y + post, h - post], [x, y - post, h], mat);
    let inner = y - post * 0.8;
    for cx in [(-x - proud, -x), (x, x + proud)] {
        for cy in [(-y - over, -inner), (inner, y + over)] {
            b.block("trim", [cx.0, cy.0, 0.0], [cx.1, cy.1, h - post * 0.8], mat);
        }
        b.block("trim", [cx.0, -y - over, h - post * 0.8], [cx.1, y + over, h + over], mat);
    }
}

/// The box of a leaf between posts, flush with the front.
fn leaf_box((x, y, h): (f32, f32, f32), post: f32, t: f32) -> (P, P) {
    let gap = post * 0.05;
    ([x - t, -y + post + gap, gap * 2.0], [x, y - post - gap, h - post - gap])
}

/// A leaf with handles, hinged at one side. `post` and thickness are given together.
fn hinged(b: &mut Build<'_>, leaf: &Leaf<'_>, (post, thick): (f32, f32), at: Swing, (metal, u): (MaterialId, f32)) {
    let (x, y, h) = half_dims(b);
    let (low, high) = leaf_box((x, y, h), post, thick.min(x * 1.8));
    swing(b, at, low, high, 1.65, |b| {
        leaf_of(b, leaf, low, high);
        levers(b, (low[0], high[0]), (low[1] + 0.055 * u, 1.0), (h * 0.49).min(1.03), (metal, u));
    });
    // Placed beside the leaf, which swings past them.
    for z in [h * 0.12, h * 0.85] {
        b.cylinder("hinge", [x + 0.003 * u, high[1] + 0.0075 * u + 0.0005, z], 0.007 * u, 0.09 * u, metal);
    }
}

/// The boards of a leaf: plain, or panels in a frame that are visible on both sides.
fn leaf_of(b: &mut Build<'_>, leaf: &Leaf<'_>, low: P, high: P) {
    let w = leaf.border.min((high[1] - low[1]) * 0.2);
    if leaf.rows.is_empty() {
        return b.block("leaf", low, high, leaf.mat);
    }
    let bottom = w * 1.5;
    let hole = ((low[1] + w, low[2] + bottom), (high[1] - w, high[2] - w));
    plate_with_hole(b, "leaf", Axis::X, (low, high), hole, leaf.mat);
    let t = high[0] - low[0];
    let set = if leaf.infill == leaf.mat { 0.25 } else { 0.42 };
    let ((y0, z0), (y1, z1)) = hole;
    b.block("infill", [low[0] + t * set, y0, z0], [high[0] - t * set, y1, z1], leaf.infill);
    let bar = if leaf.infill == leaf.mat { w * 0.9 } else { w * 0.35 };
    let total: f32 = leaf.rows.iter().sum();
    let mut z = z0;
    for share in leaf.rows.iter().take(leaf.rows.len() - 1) {
        z += (z1 - z0) * share / total;
        b.block("rail", [low[0], y0, z - bar / 2.0], [high[0], y1, z + bar / 2.0], leaf.mat);
    }
    for i in 1..leaf.columns {
        let y = y0 + (y1 - y0) * i as f32 / leaf.columns as f32;
        let (from, to) = ([low[0] + 0.002, y - bar / 2.0, z0], [high[0] - 0.002, y + bar / 2.0, z1]);
        b.block("stile", from, to, leaf.mat);
    }
}

/// A lever on either side of a leaf, pointing along Y in the direction `way`.
fn levers(b: &mut Build<'_>, (back, front): (f32, f32), (y, way): (f32, f32), z: f32, (metal, u): (MaterialId, f32)) {
    let plate = b.rng.chance(0.5);
    for (x, out) in [(front, 1.0), (back, -1.0)] {
        let at = |d: f32| x + out * d * u;
        let (a, c) = (at(-0.001), at(0.006));
        if plate {
            b.block("plate", [a.min(c), y - 0.02 * u, z - 0.12 * u], [a.max(c), y + 0.02 * u, z + 0.05 * u], metal);
        } else {
            b.rod("rose", [a, y, z], [c, y, z], 0.025 * u, metal);
        }
        b.rod("neck", [at(0.0), y, z], [at(0.05), y, z], 0.009 * u, metal);
        b.rod("lever", [at(0.046), y - way * 0.008 * u, z], [at(0.046), y + way * 0.12 * u, z], 0.009 * u, metal);
    }
}

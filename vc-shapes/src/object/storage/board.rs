//! Boards and screens.

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::joinery::{Front, frame, front_panel};
use crate::solid::{Build, at_least};

/// A folding screen of three or four leaves in a zigzag.
pub(super) fn room_divider(b: &mut Build<'_>) {
    at_least(b, [0.01, 0.5, 0.6]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let count = if y > 0.8 { 4 } else { 3 };
    let wood = b.choose(&[b.style.wood, BLACK, WHITE, b.style.wood]);
    let filling = b.choose(&[Some(CREAM_PAPER), Some(WICKER), Some(b.style.linen), None]);
    let look = b.choose(&[Front::Louvred, Front::Reeded, Front::Framed]);
    let t = (2.0 * x).min(0.024);
    let run = 2.0 * y / count as f32;
    // The corners of a leaf stay within the depth, of which its thickness takes some.
    let rise = (2.0 * x - t * 1.05).max(0.0).min(run * 0.8);
    let angle = (rise / (run + t)).arc_tangent();
    let length = (run - t * angle.sine()) / angle.cosine();
    // Pins join the leaves where they touch, alternately in front and behind.
    for i in 1..count {
        let out = if i % 2 == 0 { 0.5 } else { -0.5 } * length * angle.sine();
        for z in [h * 0.15, h * 0.8] {
            b.cylinder("hinge", [out, run * i as f32 - y, z], t * 0.35, h * 0.05, b.style.metal);
        }
    }
    for i in 0..count {
        let turn = if i % 2 == 0 { angle } else { -angle };
        let y0 = run * (i as f32 + 0.5) - y;
        b.at([0.0, y0, 0.0], turn, |b| {
            let (low, high) = ([-t / 2.0, -length / 2.0 + 0.001, 0.0], [t / 2.0, length / 2.0 - 0.001, h]);
            let Some(mat) = filling else { return front_panel(b, "leaf", low, high, look, wood) };
            frame(b, "leaf", low, high, 0.03, wood);
            let (w, q) = (0.029, t * 0.2);
            b.block("panel", [low[0] + q, low[1] + w, w], [high[0] - q, high[1] - w, h - w], mat);
            for k in 1..4 {
                let z = h * k as f32 / 4.0;
                b.block(
                    "bar",
                    [low[0] + q * 0.4, low[1] + w - 0.002, z - 0.008],
                    [high[0] - q * 0.4, high[1] - w + 0.002, z + 0.008],
                    wood,
                );
            }
        });
    }
}

/// The sheet of a board within its frame, which takes a share of the depth; returns the X of the
/// sheet's face.
fn framed(b: &mut Build<'_>, rim: MaterialId, sheet: MaterialId, w: f32, share: f32) -> f32 {
    at_least(b, [0.01, 0.15, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let deep = 2.0 * x * share;
    frame(b, "frame", [-x, -y, 0.0], [deep - x, y, h], w, rim);
    let face = deep * 0.7 - x;
    b.block("board", [0.001 - x, w - y - 0.001, w - 0.001], [face, y - w + 0.001, h - w + 0.001], sheet);
    face
}

/// A white board with a tray of pens and some writing.
pub(super) fn whiteboard(b: &mut Build<'_>) {
    let face = framed(b, ALUMINIUM, PORCELAIN, 0.016, 0.5);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let wide = y * 0.5;
    b.block("tray", [face - 0.001, -wide, 0.004], [x, wide, 0.012], ALUMINIUM);
    for (i, ink) in [RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC].into_iter().enumerate() {
        let y0 = wide * (0.1 + 0.25 * i as f32);
        let r = 0.005_f32.min((x - face) * 0.3);
        b.rod("pen", [face + r + 0.001, y0, 0.012 + r], [face + r + 0.001, y0 + wide * 0.2, 0.012 + r], r, ink);
    }
    let lines = b.rng.count(2, 5);
    for i in 0..lines {
        let (z, from) = (h * (0.85 - 0.13 * i as f32), -y * b.vary(0.5, 0.8));
        let to = from + y * b.vary(0.5, 1.2);
        let ink = b.choose(&[BLUE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC]);
        b.block("writing", [face - 0.001, from, z - 0.006], [face + 0.001, to.min(y * 0.9), z + 0.006], ink);
    }
}

/// A cork board with notes pinned to it.
pub(super) fn bulletin_board(b: &mut Build<'_>) {
    let rim = b.choose(&[b.style.wood, ALUMINIUM, WHITE, BLACK]);
    let sheet = b.choose(&[CORK, CORK, GREY_FABRIC, b.style.accent]);
    let face = framed(b, rim, sheet, 0.022, 1.0);
    let (y, h) = (b.size.y / 2.0, b.size.z);
    let (rows, across) = (2, (y / 0.12).clamp(2.0, 5.0) as usize);
    for (i, k) in (0..across).flat_map(|i| (0..rows).map(move |k| (i, k))) {
        if b.rng.chance(0.25) {
            continue;
        }
        let (dy, dz) = (2.0 * (y - 0.04) / across as f32, (h - 0.08) / rows as f32);
        let cy = 0.04 - y + dy * (i as f32 + b.vary(0.42, 0.58));
        let cz = 0.04 + dz * (k as f32 + b.vary(0.42, 0.58));
        let (w, t) = (dy * b.vary(0.22, 0.38), dz * b.vary(0.22, 0.38));
        let note = b.choose(&[WHITE_PAPER, YELLOW_CARD, PINK_CARD, TEAL_CARD, CREAM_PAPER]);
        let pin = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, YELLOW_PLASTIC]);
        b.block("note", [face - 0.001, cy - w, cz - t], [face + 0.0012, cy + w, cz + t], note);
        b.rod("pin", [face, cy, cz + t * 0.75], [face + 0.005, cy, cz + t * 0.75], 0.005, pin);
    }
}

/// A perforated board with hooks and a shelf for tools.
pub(super) fn pegboard(b: &mut Build<'_>) {
    at_least(b, [0.01, 0.3, 0.25]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let sheet = b.choose(&[WHITE, b.style.wood, BIRCH, GREY, BLACK]);
    let t = (x * 0.7).min(0.012).min(2.0 * x - 0.014);
    let face = t - x;
    b.block("board", [-x, -y, 0.0], [face, y, h], sheet);
    let (rows, across) = ((h / 0.11).clamp(2.0, 8.0) as usize, (y / 0.065).clamp(3.0, 12.0) as usize);
    let spot = |i: usize, of: usize, length: f32| length * (i as f32 + 0.5) / of as f32;
    for k in 0..rows {
        // A row of small holes.
        let z = spot(k, rows, h);
        for i in (k % 2..across).step_by(2) {
            let cy = spot(i, across, 2.0 * y) - y;
            b.block("hole", [face - 0.002, cy - 0.004, z - 0.004], [face + 0.0008, cy + 0.004, z + 0.004], BLACK);
        }
    }
    let hooks = b.rng.count(6, 10);
    let reach = 2.0 * x - t;
    for i in 0..hooks {
        let (cy, z) = (spot(i, hooks, 2.0 * y) - y, h * if i % 2 == 0 { 0.82 } else { 0.6 });
        let r = 0.002;
        b.pipe("hook", &[[face, cy, z], [x - r, cy, z], [x - r, cy, z + reach.min(0.02)]], r, STEEL);
        b.hook(&format!("hook_{}", i + 1), [x - 2.5 * r, cy, z + r], h * 0.3);
    }
    let (z, wide) = (h * 0.1, y * 0.5);
    b.block("shelf", [face - 0.001, -wide, z], [x, wide, z + 0.006], STEEL);
    b.block("lip", [x - 0.004, 0.001 - wide, z + 0.005], [x - 0.001, wide - 0.001, z + 0.025], STEEL);
    let half = (x - 0.004 - face) / 2.0;
    b.inside("rack", [face + half, 0.0, z + 0.006], ((half - 0.0005).max(0.001), wide - 0.01), h * 0.15);
}

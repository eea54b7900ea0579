//! Sinks: in a kitchen unit, bare, on a wall, or deep ones for laundry.

use super::fitting::*;
use super::unit::{plinth, unit_look};
use crate::material::*;
use crate::object::joinery::{Fitted, gapped, handle, panel};
use crate::solid::{Axis, Build, P, fit, floor_of, half_dims, pit, plate_with_hole};

/// A sink unit: fixed fronts below, a worktop around one or two bowls, a ledge behind for the tap.
/// A sink lower than 0.4 m is the bare bowl.
pub(super) fn kitchen_sink(b: &mut Build<'_>) {
    let u = fit(b, [0.22, 0.25, 0.09]);
    if b.size.z < 0.4 {
        let farmhouse = b.rng.chance(0.4);
        return if farmhouse { apron(b, u) } else { inset(b, u) };
    }
    let look = unit_look(b, u);
    sink_unit(b, u, &look);
}

/// A sink unit with fronts of a design.
pub(super) fn sink_unit(b: &mut Build<'_>, u: f32, look: &Fitted) {
    let (x, y, h) = half_dims(b);
    let (slab, kick) = (0.035 * u, 0.1 * u);
    let (front, under) = (x - RUN * u, h - slab);
    let (low, high) = ([-x, -y, kick], [front - look.t, y, under]);
    plinth(b, low, high, u);
    for cy in [(-y, -y + look.t), (y - look.t, y)] {
        b.block("side", [-x, cy.0, kick], [high[0], cy.1, under], look.mat);
    }
    b.block("bottom", [-x, -y + look.t, kick], [high[0], y - look.t, kick + look.t], look.mat);
    b.block("back", [-x, -y + look.t, kick + look.t], [-x + 0.008 * u, y - look.t, under], look.mat);
    let halves = if y > 0.3 { 2 } else { 1 };
    let step = 2.0 * y / halves as f32;
    for i in 0..halves {
        let (y0, y1) = (-y + step * i as f32, -y + step * (i + 1) as f32);
        let (l, t) = gapped([high[0], y0, kick], [front, y1, under], 0.0015 * u);
        panel(b, look.panel, "front", (l, t), look.mat);
        let edge = if i == 0 { y1 - step * 0.1 } else { y0 + step * 0.1 };
        handle(b, look.handle, [front, edge, under - 0.14 * u], 0.14 * u, true, look.metal);
    }
    let steel = b.choose(&[STEEL, STEEL, PORCELAIN, BLACK_GRANITE]);
    let depth = b.vary(0.15, 0.19).min(h * 0.25);
    let wide = (y - 0.05 * u).min(b.vary(0.36, 0.46));
    let shift = if y - wide > 0.1 { b.vary(-1.0, 1.0) * (y - wide - 0.05) } else { 0.0 };
    let bowls = ([-x + 0.125 * u, shift - wide, h], [x - 0.075 * u, shift + wide, h]);
    let edge = 0.012 * u;
    let hole = ((bowls.0[0], bowls.0[1]), (bowls.1[0], bowls.1[1]));
    plate_with_hole(b, "worktop", Axis::Z, ([-x, -y, under], [x, y, h]), hole, b.style.worktop);
    basins(b, bowls, (h + 0.0008, depth), edge, steel);
    b.top("ledge", [-x + 0.065 * u, 0.0, h], (0.045 * u, (y - 0.02 * u).min(0.14)));
    for (name, from, to) in [("worktop_right", -y, bowls.0[1]), ("worktop_left", bowls.1[1], y)] {
        if to - from > 0.12 {
            let half = ((bowls.1[0] - bowls.0[0]) / 2.0, (to - from) / 2.0 - edge - 0.015);
            b.top(name, [f32::midpoint(bowls.0[0], bowls.1[0]), f32::midpoint(from, to), h], half);
        }
    }
}

/// One bowl, one and a half, or a bowl and a draining board, within `low..high`; their rim lies on
/// the worktop up to `top`.
fn basins(b: &mut Build<'_>, (low, high): (P, P), (top, depth): (f32, f32), edge: f32, mat: MaterialId) {
    let wide = high[1] - low[1];
    let design = if wide < 0.55 { 0 } else { b.rng.below(3) };
    let split = low[1] + wide * if design == 2 { 0.56 } else { 0.66 };
    let lip = ([low[0] - edge, low[1] - edge, top - 0.002], [high[0] + edge, high[1] + edge, top]);
    let t = edge * 0.4;
    let first = if design == 0 { high[1] } else { split };
    bowl(b, "basin", (low, [high[0], first, top]), depth, t, mat);
    plate_with_hole(
        b,
        "rim",
        Axis::Z,
        lip,
        ((low[0] + t, low[1] + t), (high[0] - t, if design == 0 { high[1] - t } else { split - t })),
        mat,
    );
    match design {
        1 => {
            // The half bowl is on the other side of the bridge.
            let from = [low[0], split + edge, low[2]];
            bowl(b, "small_basin", (from, [high[0], high[1], top]), depth * 0.6, t, mat);
        }
        2 => {
            b.block("drainer", [low[0], split, top - 0.02], [high[0], high[1], top - 0.0025], mat);
            let step = (high[1] - split) / 7.0;
            for i in 1..6 {
                let y = split + step * i as f32;
                b.block(
                    "groove",
                    [low[0] + edge * 2.0, y, top - 0.004],
                    [high[0] - edge * 2.0, y + step * 0.4, top - 0.0008],
                    mat,
                );
            }
            let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(split, high[1]), top - 0.0008];
            b.top("drainer", centre, ((high[0] - low[0]) * 0.44, (high[1] - split) * 0.42));
        }
        _ => {}
    }
}

/// A bowl hanging under `high[2]` with its drain.
fn bowl(b: &mut Build<'_>, name: &str, (low, high): (P, P), depth: f32, t: f32, mat: MaterialId) {
    let from = [low[0], low[1], high[2] - depth];
    let to = [high[0], high[1], high[2] - 0.002];
    pit(b, name, from, to, t, mat);
    let middle = [f32::midpoint(from[0], to[0]), f32::midpoint(from[1], to[1]), from[2] + t];
    let r = (to[0] - from[0]).min(to[1] - from[1]) * 0.11;
    b.cylinder("waste", [middle[0], middle[1], from[2] - t * 2.0], r, t * 3.0 + 0.001, CHROME);
    floor_of(b, name, [from[0] + t, from[1] + t, from[2] + t + 0.0015], [to[0] - t, to[1] - t, high[2]]);
}

/// A steel bowl with a rim for a worktop cut-out.
fn inset(b: &mut Build<'_>, u: f32) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[STEEL, STEEL, PORCELAIN, BLACK_GRANITE]);
    let (rim, edge) = (0.004 * u, 0.012 * u);
    let (low, high) = ([-x + 0.1 * u, -y + 0.03 * u, h], [x - 0.03 * u, y - 0.03 * u, h]);
    let hole = ((low[0] - edge, low[1] - edge), (high[0] + edge, high[1] + edge));
    plate_with_hole(b, "deck", Axis::Z, ([-x, -y, h - rim], [x, y, h - 0.0015 * u]), hole, mat);
    basins(b, (low, high), (h, h - 0.012 * u), edge, mat);
    b.top("ledge", [-x + 0.045 * u, 0.0, h - 0.0015 * u], (0.035 * u, (y * 0.7).min(0.14)));
}

/// A thick ceramic trough with a plain front.
fn apron(b: &mut Build<'_>, u: f32) {
    let (x, y, h) = half_dims(b);
    let t = 0.022 * u;
    let ledge = 0.1 * u;
    let basin = [-x + ledge, -y, 0.0];
    b.block("ledge", [-x, -y, 0.0], [-x + ledge, y, h], PORCELAIN);
    let double = y > 0.36 && b.rng.chance(0.5);
    let split = if double { b.vary(-0.1, 0.1) * y } else { y };
    for (i, (y0, y1)) in [(-y, split), (split, y)].into_iter().enumerate().take(if double { 2 } else { 1 }) {
        let (low, high) = ([basin[0], y0, 0.0], [x, y1, h]);
        pit(b, "trough", low, high, t, PORCELAIN);
        let waste = [f32::midpoint(low[0], x), f32::midpoint(y0, y1), t - 0.001 * u];
        b.cylinder("waste", waste, 0.04 * u, 0.002, CHROME);
        let name = if i == 0 { "basin" } else { "second_basin" };
        floor_of(b, name, [low[0] + t, y0 + t, t + 0.0015 * u], [x - t, y1 - t, h]);
    }
    b.top("ledge", [-x + ledge * 0.5, 0.0, h], (ledge * 0.42, (y * 0.7).min(0.14)));
}

/// A separate sink: on legs or a bracket at the wall, or a low bowl.
pub(super) fn sink(b: &mut Build<'_>) {
    let u = fit(b, [0.2, 0.22, 0.07]);
    if b.size.z < 0.4 { inset(b, u) } else { standing(b, u, b.size.z * 0.22) }
}

/// A deep tub on legs.
pub(super) fn utility_sink(b: &mut Build<'_>) {
    let u = fit(b, [0.22, 0.25, 0.4]);
    let deep = b.size.z * b.vary(0.36, 0.44);
    standing(b, u, deep);
}

/// A tub on four legs with a ledge behind, sometimes with a splashback.
fn standing(b: &mut Build<'_>, u: f32, deep: f32) {
    let (x, y, h) = half_dims(b);
    let mat = b.choose(&[WHITE_PLASTIC, STEEL, PORCELAIN]);
    let splash = if b.rng.chance(0.4) { (h * 0.1).min(0.1) } else { 0.0 };
    let (rim, t, ledge) = (h - splash, 0.012 * u, 0.09 * u);
    if splash > 0.0 {
        b.block("splashback", [-x, -y, rim - 0.02 * u], [-x + 0.012 * u, y, h], mat);
    }
    let (low, high) = ([-x + ledge, -y, rim - deep], [x, y, rim]);
    pit(b, "tub", low, high, t, mat);
    b.block("ledge", [-x + if splash > 0.0 { 0.012 * u } else { 0.0 }, -y, rim - 0.03 * u], [low[0], y, rim], mat);
    b.top(
        "ledge",
        [-x + 0.012 * u + (ledge - 0.012 * u) / 2.0, 0.0, rim],
        ((ledge - 0.016 * u) / 2.0, (y * 0.8).min(0.16)),
    );
    let middle = [f32::midpoint(low[0], x), 0.0];
    b.cylinder("waste", [middle[0], 0.0, low[2] - 0.001 * u], 0.03 * u, t + 0.002 * u, CHROME);
    let r = 0.018 * u;
    b.pipe(
        "trap",
        &[[middle[0], 0.0, low[2] - r * 0.8], [middle[0], 0.0, low[2] * 0.72], [-x + 0.02 * u, 0.0, low[2] * 0.72]],
        r,
        CHROME,
    );
    floor_of(b, "basin", [low[0] + t, -y + t, low[2] + t + 0.0015 * u], [x - t, y - t, rim]);
    let (leg, pole) = (0.018 * u, if mat == PORCELAIN { CHROME } else { STEEL });
    for cx in [-x + 0.03 * u, x - 0.04 * u] {
        for cy in [-y + 0.03 * u, y - 0.03 * u] {
            let top = if cx < low[0] { rim - 0.028 * u } else { low[2] + 0.002 * u };
            b.rod("leg", [cx, cy, 0.0], [cx, cy, top], leg, pole);
        }
    }
    for cy in [-y + 0.03 * u, y - 0.03 * u] {
        b.rod("rail", [-x + 0.03 * u, cy, h * 0.2], [x - 0.04 * u, cy, h * 0.2], leg * 0.6, pole);
    }
}

//! Countertop cooking appliances: hot plates, fryers, grills, electric pots.

use super::fitting::*;
use super::heat::foot_row;
use crate::material::*;
use crate::object::joinery::{Fitted, Handle, Panel, drawers, lid};
use crate::solid::{
    Axis, Build, CORNERS, P, basket, case, collar, fit, half_dims, loft_levels, pit, plate_with_hole, round_floor,
};
use vc_graph::asset::JointKind;

/// One or two iron plates on a flat box.
pub(super) fn hot_plate(b: &mut Build<'_>) {
    let u = fit(b, [0.176, 0.192, 0.048]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_METAL, BLACK_METAL, STEEL]);
    let (feet, top) = (h * 0.18, h * 0.78);
    foot_row(b, (x * 0.8, y * 0.85), 0.012 * u, feet);
    let face = x - 0.015 * u;
    b.rounded_block("body", [-x, -y, feet], [face, y, top], 0.008 * u, body);
    let count = if y > x * 1.3 { 2 } else { 1 };
    let step = 2.0 * y / count as f32;
    for i in 0..count {
        let cy = -y + step * (i as f32 + 0.5);
        let r = (x * 0.72).min(step * 0.42) * if i == 1 { 0.82 } else { 1.0 };
        let cx = -x * 0.12;
        collar(b, "rim", ([cx, cy, top - 0.001 * u], [cx, cy, top + (h - top) * 0.4]), (r * 1.0, r * 1.1), STEEL);
        b.lathe("plate", [cx, cy, top - 0.001 * u], &[(r * 0.98, 0.0), (r * 0.94, h - top + 0.001 * u)], IRON);
        let half = r * 0.9;
        b.top(&format!("burner_{}", i + 1), [cx, cy, h], (half, half));
        knob(b, [face, cy, f32::midpoint(feet, top)], (top - feet) * 0.32, 0.013 * u, (BLACK_PLASTIC, WHITE));
    }
}

/// One or two oil baths with wire baskets; commercial ones of steel with taps.
pub(super) fn deep_fryer(b: &mut Build<'_>) {
    let u = fit(b, [0.224, 0.192, 0.176]);
    let (x, y, h) = half_dims(b);
    let round = x < 0.17 && b.rng.chance(0.5);
    let body = if round { b.choose(&[BLACK_PLASTIC, WHITE_PLASTIC]) } else { STEEL };
    let (feet, face, rim) = (0.015 * u, x - 0.05 * u, h * 0.74);
    foot_row(b, (x * 0.6, y * 0.7), 0.015 * u, feet);
    let (wall, back) = (0.008 * u, -x + 0.06 * u);
    // The bath: walls, oil, one basket in each half.
    pit(b, "bath", [back, -y, feet], [face, y, rim], wall, body);
    let head = [back, y * 0.7, h];
    b.block("head", [-x, -y * 0.7, feet], head, body);
    display(b, back, (-y * 0.2, rim + (h - rim) * 0.3), (y * 0.2, rim + (h - rim) * 0.7), SIGNAL_RED);
    let oil = feet + (rim - feet) * 0.45;
    b.block("oil", [back + wall, -y + wall, feet + wall], [face - wall, y - wall, oil], YELLOW_GLAZE);
    let baths = if y > 0.16 && !round { 2 } else { 1 };
    let step = 2.0 * (y - wall) / baths as f32;
    for i in 0..baths {
        let y0 = -y + wall + step * i as f32;
        let w = 0.003 * u;
        let (low, high) = (
            [back + wall * 3.0, y0 + step * 0.07, oil + 0.002 * u],
            [face - wall * 3.0, y0 + step * 0.93, rim + 0.01 * u],
        );
        let name = if baths == 1 { "basin".to_owned() } else { format!("basin_{}", i + 1) };
        basket(b, &name, low, high, w, STEEL);
        let cy = y0 + step / 2.0;
        let z = high[2] - 0.006 * u;
        b.pipe(
            "handle",
            &[[high[0] + 0.004 * u, cy, z], [face + 0.005 * u, cy, z + 0.01 * u], [x - 0.008 * u, cy, z + 0.012 * u]],
            0.0065 * u,
            BLACK_PLASTIC,
        );
    }
    knobs(b, [face, 0.0, feet + (rim - feet) * 0.4], y, baths, (rim - feet) * 0.12, (BLACK_PLASTIC, WHITE));
    let wide = 2.0 * y / baths as f32;
    for i in 0..baths {
        // Its own anchor distinguishes its joint from the other one's.
        let (from, low) = (-y + wide * i as f32, rim + 0.0115 * u);
        lid(b, [back + 0.006 * u, from, rim + 0.023 * u], 1.3, |b| {
            let to = [face - 0.02 * u, from + wide - 0.001 * u, rim + 0.023 * u];
            b.block("lid", [back + 0.006 * u, from + 0.001 * u, low], to, STEEL);
        });
    }
}

/// A pod with a drawer for food.
pub(super) fn air_fryer(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.208, 0.224]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, WHITE_PLASTIC, GREY_PLASTIC, SAGE]);
    let face = x - 0.065 * u;
    let (bottom, head, wall) = (h * 0.05, h * b.vary(0.55, 0.62), y * 0.1);
    b.rounded_block("base", [-x, -y, 0.0], [face, y, bottom + wall], wall * 0.5, body);
    b.block("back", [-x, -y * 0.96, bottom], [-x + wall, y * 0.96, head + 0.002 * u], body);
    for side in [-1.0, 1.0] {
        let (a, z) = (side * y * 0.98, side * (y - wall));
        b.block("side", [-x + wall, a.min(z), bottom + wall * 0.8], [face, a.max(z), head + 0.002 * u], body);
    }
    let radius = b.vary(0.02, 0.07) * u;
    b.rounded_block("head", [-x, -y, head], [face, y, h], radius, body);
    // The edge of the head is round, so its support is further in.
    b.block("neck", [-x + 0.02 * u, -y * 0.9, head - 0.004 * u], [face - 0.003, y * 0.9, head + 0.01 * u], body);
    let trim = b.choose(&[STEEL, BLACK_GLASS, BROWN_PLASTIC]);
    let round = b.rng.chance(0.5);
    let z = f32::midpoint(head, h);
    if round {
        knob(b, [face - 0.004 * u, 0.0, z], (h - head) * 0.3, 0.025 * u, (trim, WHITE));
    } else {
        display(b, face, (-y * 0.4, z - (h - head) * 0.15), (y * 0.4, z + (h - head) * 0.15), COOL_BULB);
    }
    let (low, high) =
        ([-x + wall * 1.2, -y + wall * 1.1, bottom + wall * 1.1], [face, y - wall * 1.1, head - 0.006 * u]);
    b.jointed(JointKind::Slide, low, [1.0, 0.0, 0.0], (0.0, (face + x) * 0.7), |b| {
        basket(b, "drawer_1", low, high, 0.005 * u, BLACK_METAL);
        let plate = ([face, -y * 0.96, bottom + wall], [face + 0.012 * u, y * 0.96, head - 0.004 * u]);
        b.rounded_block("front", plate.0, plate.1, 0.006 * u, body);
        let z = f32::midpoint(low[2], high[2]);
        b.rounded_block(
            "grip",
            [face + 0.01 * u, -y * 0.14, z - 0.022 * u],
            [x, y * 0.14, z + 0.022 * u],
            0.01 * u,
            trim,
        );
    });
}

/// A commercial griddle: a thick plate with raised sides over a box with knobs.
pub(super) fn griddle(b: &mut Build<'_>) {
    let u = fit(b, [0.32, 0.4, 0.16]);
    let (x, y, h) = half_dims(b);
    let (feet, plate, guard) = (h * 0.14, h * 0.74, 0.012 * u);
    let face = x - 0.035 * u;
    for (sx, sy) in [(0.75, 0.85), (-0.75, 0.85), (-0.75, -0.85), (0.75, -0.85)] {
        b.cylinder("foot", [x * sx, y * sy, 0.0], 0.022 * u, feet, BLACK_PLASTIC);
    }
    b.block("body", [-x, -y, feet], [face, y, plate - 0.02 * u], STEEL);
    let iron = b.choose(&[IRON, STEEL]);
    b.block("plate", [-x + guard, -y + guard, plate - 0.02 * u], [face - 0.05 * u, y - guard, plate], iron);
    b.block("back_guard", [-x, -y, plate - 0.02 * u], [-x + guard, y, h], STEEL);
    let slope =
        [(-x + guard, 0.0), (face - 0.05 * u, 0.0), (face - 0.05 * u, 0.022 * u), (-x + guard, h - plate + 0.02 * u)];
    for cy in [-y, y - guard] {
        b.prism("guard", Axis::Y, [0.0, cy, plate - 0.02 * u], &slope, guard, STEEL);
    }
    pit(b, "gutter", [face - 0.05 * u, -y, plate - 0.02 * u], [face, y, plate - 0.002 * u], 0.006 * u, STEEL);
    if b.rng.chance(0.4) {
        for i in 0..8 {
            let cy = y * (0.1 + 0.1 * i as f32);
            b.block(
                "rib",
                [-x + guard * 1.5, cy, plate - 0.001 * u],
                [face - 0.055 * u, cy + y * 0.04, plate + 0.005 * u],
                iron,
            );
        }
        b.top(
            "griddle",
            [(face - 0.05 * u - x) / 2.0, -y * 0.45, plate],
            ((face - 0.05 * u + x) / 2.0 - 0.02 * u, y * 0.48),
        );
    } else {
        b.top(
            "griddle",
            [(face - 0.05 * u - x) / 2.0, 0.0, plate],
            ((face - 0.05 * u + x) / 2.0 - 0.02 * u, y - 0.03 * u),
        );
    }
    let count = b.rng.count(2, 4);
    knobs(
        b,
        [face, 0.0, f32::midpoint(feet, plate) - 0.01 * u],
        y * 1.7,
        count,
        (plate - feet) * 0.22,
        (BLACK_PLASTIC, WHITE),
    );
    for cy in [-y * 0.93, y * 0.93] {
        b.rod("light", [face, cy, feet + 0.02 * u], [face + 0.003 * u, cy, feet + 0.02 * u], 0.005 * u, SIGNAL_AMBER);
    }
}

/// Two ribbed plates that close like a book.
pub(super) fn electric_grill(b: &mut Build<'_>) {
    let u = fit(b, [0.208, 0.224, 0.08]);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL]);
    clamshell(b, u, body, false);
}

/// Two plates with a grid that close like a book, square or round.
pub(super) fn waffle_maker(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.16, 0.072]);
    let body = b.choose(&[STEEL, BLACK_PLASTIC, WHITE_PLASTIC, RED_METAL]);
    clamshell(b, u, body, true);
}

fn clamshell(b: &mut Build<'_>, u: f32, body: MaterialId, waffle: bool) {
    let (x, y, h) = half_dims(b);
    let (feet, seam, front) = (h * 0.1, h * 0.5, x - 0.05 * u);
    let round = waffle && b.rng.chance(0.5);
    let r = y.min((front + x) / 2.0);
    let cx = (front - x) / 2.0;
    let (rear, edge) = if round { (cx - r + 0.01 * u, cx + r) } else { (-x, front) };
    let stance = if round { (r * 0.5, r * 0.55) } else { ((front + x) * 0.4, y * 0.8) };
    b.at([cx, 0.0, 0.0], 0.0, |b| foot_row(b, stance, 0.01 * u, feet));
    let plate = (seam - feet) * 0.5;
    let half = if round { (r * 0.68, r * 0.68) } else { ((front + x) * 0.44, y * 0.88) };
    if round {
        b.lathe("base", [cx, 0.0, feet], &[(r * 0.9, 0.0), (r, (seam - feet) * 0.4), (r, seam - feet - plate)], body);
    } else {
        b.rounded_block("base", [-x, -y, feet], [front, y, seam - plate], 0.02 * u, body);
    }
    let low = [cx - half.0, -half.1, seam - plate - 0.002 * u];
    b.block("plate", low, [cx + half.0, half.1, seam - plate * 0.8], BLACK_METAL);
    let count = if waffle { 6 } else { 9 };
    for i in 0..count {
        let cy = half.1 * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        b.block(
            "rib",
            [cx - half.0 * 0.95, cy - half.1 * 0.04, seam - plate * 0.82],
            [cx + half.0 * 0.95, cy + half.1 * 0.04, seam - plate * 0.66],
            BLACK_METAL,
        );
    }
    let gap = plate * 0.64;
    b.inside("slot_1", [cx, 0.0, seam - plate * 0.66], (half.0 * 0.9, half.1 * 0.9), gap);
    b.block(
        "hinge",
        [-x, -y * 0.5, seam - plate - 0.002 * u],
        [rear.max(-x + 0.018 * u), y * 0.5, seam + 0.004 * u],
        BLACK_PLASTIC,
    );
    let grip = b.choose(&[STEEL, BLACK_PLASTIC]);
    lid(b, [-x, 0.0, seam], 1.6, |b| {
        if round {
            b.lathe(
                "lid",
                [cx, 0.0, seam + 0.001 * u],
                &[(r, 0.0), (r, (h - seam) * 0.5), (r * 0.85, h - seam - 0.001 * u)],
                body,
            );
        } else {
            b.rounded_block("lid", [-x, -y, seam + 0.001 * u], [front, y, h], 0.02 * u, body);
        }
        let z = f32::midpoint(seam, h);
        if waffle {
            b.rounded_block(
                "grip",
                [edge - 0.01 * u, -y * 0.2, z - 0.008 * u],
                [x, y * 0.2, z + 0.008 * u],
                0.006 * u,
                grip,
            );
        } else {
            let points = [
                [front - 0.01 * u, -y * 0.8, z],
                [x - 0.012 * u, -y * 0.7, z],
                [x - 0.012 * u, y * 0.7, z],
                [front - 0.01 * u, y * 0.8, z],
            ];
            b.pipe("grip", &points, 0.008 * u, grip);
        }
        b.cylinder("light", [cx, 0.0, h - 0.003 * u], 0.006 * u, 0.003, SIGNAL_GREEN);
        if !waffle {
            b.top("lid", [cx, y * 0.5, h], ((front + x) * 0.3, y * 0.3));
        }
    });
    if !waffle {
        knob(
            b,
            [front - 0.002 * u, 0.0, f32::midpoint(feet, seam - plate)],
            (seam - feet) * 0.24,
            0.02 * u,
            (BLACK_PLASTIC, WHITE),
        );
    }
}

/// A round pot in a shell with a hinged lid and one switch.
pub(super) fn rice_cooker(b: &mut Build<'_>) {
    let u = fit(b, [0.176, 0.176, 0.16]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, STEEL, BLACK_METAL, RED_METAL]);
    let r = y.min(x);
    let cx = x - r;
    let (foot, rim, wall) = (h * 0.05, h * 0.74, 0.01 * u);
    b.cylinder("foot", [cx, 0.0, 0.0], r * 0.8, foot, BLACK_PLASTIC);
    let (tall, wide) = (rim - foot, r - 0.012 * u);
    let shell = [
        (wide * 0.86, 0.0),
        (wide, tall * 0.3),
        (wide, tall),
        (wide - wall, tall),
        (wide - wall, tall * 0.35),
        (wide * 0.86 - wall, wall),
    ];
    b.lathe("body", [cx, 0.0, foot], &shell, body);
    round_floor(b, "compartment_1", [cx, 0.0, foot + wall], wide * 0.84 - wall, tall - wall * 1.2);
    b.block("hinge", [cx - wide - 0.012 * u, -r * 0.3, rim * 0.6], [cx - wide + 0.01 * u, r * 0.3, rim], body);
    if x - r > 0.02 {
        b.rounded_block("cord_box", [-x, -r * 0.35, foot], [cx - wide + 0.01 * u, r * 0.35, rim * 0.8], 0.01 * u, body);
    }
    let glass = b.rng.chance(0.4);
    let trim = if glass { GLASS } else { body };
    lid(b, [cx - wide, 0.0, rim + 0.002 * u], 1.4, |b| {
        let dome = h * 0.93 - rim;
        b.lathe(
            "lid",
            [cx, 0.0, rim + 0.001 * u],
            &[(wide, 0.0), (wide, dome * 0.3), (wide * 0.8, dome * 0.8), (wide * 0.4, dome)],
            trim,
        );
        b.lathe(
            "vent",
            [cx, 0.0, rim + dome * 0.98],
            &[(wide * 0.14, 0.0), (wide * 0.2, h - rim - dome * 0.98)],
            BLACK_PLASTIC,
        );
    });
    switch_plate(b, [cx + wide * 0.985, foot + tall * 0.35], (r * 0.3, tall * 0.2), u);
    for side in [-1.0, 1.0] {
        let cy = side * (wide + 0.002 * u);
        b.rounded_block(
            "ear",
            [cx - r * 0.2, cy - 0.009 * u, rim * 0.78],
            [cx + r * 0.2, cy + 0.009 * u, rim * 0.85],
            0.004 * u,
            BLACK_PLASTIC,
        );
    }
}

/// A panel with a light and a lever in front of a round body.
fn switch_plate(b: &mut Build<'_>, at: [f32; 2], half: (f32, f32), u: f32) {
    let [x, z] = at;
    b.block("panel", [x - half.0 * 0.3, -half.0, z - half.1], [x + 0.004 * u, half.0, z + half.1], BLACK_PLASTIC);
    b.block(
        "lever",
        [x + 0.003 * u, -half.0 * 0.3, z - half.1 * 0.6],
        [x + 0.01 * u, half.0 * 0.3, z - half.1 * 0.2],
        WHITE_PLASTIC,
    );
    b.block(
        "light",
        [x + 0.003 * u, -half.0 * 0.1, z + half.1 * 0.3],
        [x + 0.005 * u, half.0 * 0.1, z + half.1 * 0.5],
        SIGNAL_AMBER,
    );
}

/// An oval crock in a shell with ears and a glass lid.
pub(super) fn slow_cooker(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.24, 0.176]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL, CREAM]);
    let (feet, rim, wall) = (h * 0.05, h * 0.72, 0.014 * u);
    let (depth, side) = (x - 0.015 * u, y - 0.04 * u);
    foot_row(b, (depth * 0.6, side * 0.7), 0.014 * u, feet);
    oval_shell(b, "body", (depth, side), (feet, rim * 0.96), wall * 0.5, body);
    oval_shell(b, "crock", (depth - wall * 0.5, side - wall * 0.5), (feet + wall * 0.5, rim), wall, b.style.crockery);
    b.inside("compartment_1", [0.0, 0.0, feet + wall * 1.5], (depth * 0.6, side * 0.62), rim - feet - wall * 2.0);
    for s in [-1.0_f32, 1.0] {
        let (a, z) = (s * (side - 0.004 * u), s * y);
        b.rounded_block(
            "ear",
            [-x * 0.3, a.min(z), rim * 0.76],
            [x * 0.3, a.max(z), rim * 0.84],
            0.008 * u,
            BLACK_PLASTIC,
        );
    }
    knob(b, [depth - 0.002 * u, 0.0, h * 0.22], h * 0.08, 0.014 * u, (BLACK_PLASTIC, WHITE));
    lid(b, [-depth, 0.0, rim + 0.002 * u], 1.2, |b| {
        oval_lid(b, (depth * 0.97, side * 0.97), (rim + 0.001 * u, h * 0.88), GLASS);
        b.lathe(
            "knob",
            [0.0, 0.0, h * 0.879],
            &[(x * 0.08, 0.0), (x * 0.2, h * 0.08), (x * 0.16, h * 0.121)],
            BLACK_PLASTIC,
        );
    });
}

/// Twelve corners of an oval.
fn twelve(half: (f32, f32)) -> Vec<(f32, f32)> {
    let quarter = [(1.0, 0.27), (0.73, 0.73), (0.27, 1.0)];
    let corner = |i: usize| {
        let (q, k) = (i / 3, i % 3);
        let p = quarter[if q % 2 == 0 { k } else { 2 - k }];
        (p.0 * CORNERS[q].0 * half.0, p.1 * CORNERS[q].1 * half.1)
    };
    (0..12).map(corner).collect()
}

/// A flat-bottomed shell with twelve sides.
fn oval_shell(b: &mut Build<'_>, name: &str, half: (f32, f32), (z0, z1): (f32, f32), wall: f32, mat: MaterialId) {
    let (outer, inner) = (twelve(half), twelve((half.0 - wall, half.1 - wall)));
    loft_levels(b, name, &[(outer.clone(), z0), (outer, z1), (inner.clone(), z1), (inner, z0 + wall)], mat);
}

/// A low dome over an oval.
fn oval_lid(b: &mut Build<'_>, half: (f32, f32), (z0, z1): (f32, f32), mat: MaterialId) {
    let level = |k: f32, z: f32| twelve((half.0 * k, half.1 * k)).into_iter().map(move |c| [c.0, c.1, z]);
    let points: Vec<P> = level(1.0, z0).chain(level(0.6, z1)).collect();
    b.hull("lid", &points, mat);
}

/// A tall box with a lid over a bread pan, a display on its slope.
pub(super) fn bread_maker(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.24, 0.224]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, STEEL, BLACK_METAL]);
    let (feet, rim, wall) = (h * 0.04, h * 0.84, 0.014 * u);
    foot_row(b, (x * 0.75, y * 0.8), 0.012 * u, feet);
    let split = y * 0.3;
    b.rounded_block("body", [-x, split, feet], [x, y, rim], 0.012 * u, body);
    pit(b, "body", [-x, -y, feet], [x, split + 0.004 * u, rim], wall, body);
    let low = [-x * 0.6, -y + wall * 3.0, feet + wall];
    basket(b, "compartment_1", low, [x * 0.6, split - wall * 2.0, rim - 0.03 * u], 0.003 * u, GREY_PLASTIC);
    let panel_top = rim + 0.002 * u;
    b.block(
        "panel",
        [x * 0.1, split + (y - split) * 0.1, rim - 0.002 * u],
        [x * 0.9, y * 0.95, panel_top],
        BLACK_PLASTIC,
    );
    b.block("display", [x * 0.3, split + (y - split) * 0.3, rim], [x * 0.6, y * 0.82, panel_top + 0.002 * u], LED);
    lid(b, [-x, 0.0, rim + 0.003 * u], 1.4, |b| {
        b.rounded_block("lid", [-x, -y, rim + 0.003 * u], [x, split, h], ((h - rim) * 0.4).min(0.008 * u), body);
        b.block("window", [-x * 0.4, -y * 0.6, h - 0.003 * u], [x * 0.4, -y * 0.05, h], BROWN_GLASS);
    });
}

/// Pans in a heated steel bath, each with its own lid; a tap and a dial in front.
pub(super) fn bain_marie(b: &mut Build<'_>) {
    let u = fit(b, [0.272, 0.4, 0.192]);
    let (x, y, h) = half_dims(b);
    let (feet, rim, wall) = (h * 0.08, h * 0.82, 0.008 * u);
    let face = x - 0.05 * u;
    foot_row(b, (x * 0.75, y * 0.85), 0.018 * u, feet);
    let pans = (y / 0.13).clamp(2.0, 5.0) as usize;
    let step = 2.0 * y / pans as f32;
    pit(b, "bath", [-x, -y, feet], [face, y, rim - 0.004 * u], wall, STEEL);
    let covered = b.rng.below(pans);
    for i in 0..pans {
        let (y0, y1) = (-y + step * i as f32 + wall * 0.6, -y + step * (i + 1) as f32 - wall * 0.6);
        let (low, high) =
            ([-x + wall, y0 + wall, feet + (rim - feet) * 0.25], [face - wall, y1 - wall, rim - 0.003 * u]);
        basket(b, &format!("basin_{}", i + 1), low, high, 0.003 * u, ALUMINIUM);
        let hole = ((-x + wall * 2.2, y0 + wall * 1.6), (face - wall * 2.2, y1 - wall * 1.6));
        plate_with_hole(
            b,
            "rim",
            Axis::Z,
            ([-x, y0 - wall * 0.6, rim - 0.003 * u], [face, y1 + wall * 0.6, rim]),
            hole,
            STEEL,
        );
        if i <= covered {
            lid(b, [-x + wall, 0.0, rim + 0.001 * u], 1.3, |b| {
                b.at([(face - x) / 2.0, f32::midpoint(y0, y1), rim + 0.001 * u], 0.0, |b| {
                    let half = ((face + x) / 2.0 - wall, (y1 - y0) / 2.0 - wall * 0.5);
                    b.taper("lid", [0.0; 3], half, (half.0 * 0.9, half.1 * 0.85), (h - rim) * 0.5, STEEL);
                    b.block(
                        "knob",
                        [-half.0 * 0.25, -0.008 * u, (h - rim) * 0.49],
                        [half.0 * 0.25, 0.008 * u, h - rim - 0.001 * u],
                        BLACK_PLASTIC,
                    );
                });
            });
        }
    }
    let z = f32::midpoint(feet, rim);
    knob(b, [face, y * 0.7, z], (rim - feet) * 0.18, 0.025 * u, (BLACK_PLASTIC, WHITE));
    b.rod("tap", [face - 0.002 * u, -y * 0.7, z * 0.7], [x - 0.015 * u, -y * 0.7, z * 0.7], 0.01 * u, BRASS);
    b.rod("tap", [x - 0.015 * u, -y * 0.7, z * 0.45], [x - 0.015 * u, -y * 0.7, z * 0.7 + 0.01 * u], 0.01 * u, BRASS);
    b.block(
        "tap_lever",
        [x - 0.03 * u, -y * 0.72, z * 0.7 + 0.01 * u],
        [x, -y * 0.68, z * 0.7 + 0.018 * u],
        RED_PLASTIC,
    );
}

/// Plate-warming drawers: one built in, or several one below the other.
pub(super) fn plate_warmer(b: &mut Build<'_>) {
    let u = fit(b, [0.4, 0.352, 0.112]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, STEEL, BLACK_GLASS]);
    let (face, t) = (x - 0.032, 0.02 * u);
    let feet = if h > 0.4 { 0.08 * u } else { 0.0 };
    if feet > 0.0 {
        super::cool::steel_legs(b, (x * 0.75, y * 0.85), feet, b.size.z > 0.6, u);
    }
    let low = [-x, -y, feet];
    case(b, low, [face - t, y, h], 0.01 * u, STEEL);
    let look = Fitted { panel: Panel::Slab, handle: Handle::Bar, mat: body, metal: STEEL, t };
    let count = (h / 0.24).round().clamp(1.0, 4.0) as usize;
    let strip = (h * 0.2).min(0.06 * u);
    drawers(b, &look, "drawer", ([-x + 0.02 * u, -y, feet + 0.006 * u], [face, y, h - strip]), (count, 1.0));
    b.block("controls", [face - t - 0.001 * u, -y, h - strip], [face, y, h], body);
    knob(b, [face, y * 0.8, h - strip * 0.5], strip * 0.35, 0.018 * u, (BLACK_PLASTIC, WHITE));
    if h > 0.4 {
        b.top("top", [0.0, 0.0, h], (x - 0.04 * u, y - 0.02 * u));
    }
}

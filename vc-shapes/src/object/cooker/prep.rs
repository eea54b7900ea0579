//! Machines that chop, mix, press, weigh and cool food and drink.

use super::fitting::*;
use super::heat::foot_row;
use crate::material::*;
use crate::object::joinery::lid;
use crate::solid::{Axis, Build, P, cup_profile, fit, floor_of, half_dims, pit, plate_with_hole, round_floor};

/// The enamel colour of kitchen machines.
fn machine_mat(b: &mut Build<'_>) -> MaterialId {
    b.choose(&[WHITE_METAL, RED_METAL, BLACK_METAL, STEEL, CREAM, BLUE_METAL, GREEN_METAL])
}

/// A jug with a lid and a handle on a motor with a dial.
pub(super) fn blender(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.112, 0.272]);
    let (x, y, h) = half_dims(b);
    let body = machine_mat(b);
    let r = x.min(y) * 0.86;
    let (base, top, wall) = (h * b.vary(0.3, 0.36), h * 0.92, 0.004 * u);
    if b.rng.chance(0.5) {
        b.lathe("base", [0.0; 3], &[(r, 0.0), (r * 0.95, base * 0.4), (r * 0.62, base)], body);
    } else {
        b.taper("base", [0.0; 3], (x * 0.9, y * 0.9), (x * 0.6, y * 0.6), base, body);
    }
    knob(b, [r * 0.86, 0.0, base * 0.36], base * 0.2, (x - r * 0.86) * 0.8, (STEEL, BLACK));
    b.cylinder("collar", [0.0, 0.0, base - 0.001 * u], r * 0.6, h * 0.03, BLACK_PLASTIC);
    let low = base + h * 0.028;
    jug(b, [0.0, 0.0, low], (r * 0.58, r * 0.86), top - low, wall);
    b.lathe("blade", [0.0, 0.0, low + wall], &[(r * 0.3, 0.0), (r * 0.34, wall), (r * 0.05, wall * 2.5)], STEEL);
    round_floor(b, "jug", [0.0, 0.0, low + wall * 3.6], r * 0.55, top - low - wall * 4.0);
    let edge = -r * 0.72;
    let points = [
        [0.0, edge - r * 0.06, top - h * 0.04],
        [0.0, -y + 0.01 * u, top - h * 0.08],
        [0.0, -y + 0.01 * u, low + (top - low) * 0.35],
        [0.0, edge + r * 0.08, low + (top - low) * 0.22],
    ];
    b.pipe("handle", &points, 0.009 * u, BLACK_PLASTIC);
    lid(b, [-r * 0.86, 0.0, top], 1.4, |b| {
        b.lathe(
            "lid",
            [0.0, 0.0, top],
            &[(r * 0.88, 0.0), (r * 0.84, h * 0.04), (r * 0.4, h * 0.045), (r * 0.36, h - top)],
            BLACK_PLASTIC,
        );
    });
}

/// A clear jug that is wider at the top.
fn jug(b: &mut Build<'_>, base: P, (low, high): (f32, f32), tall: f32, wall: f32) {
    b.lathe("jug", base, &cup_profile(low, high, tall, wall), CLEAR_PLASTIC);
}

/// A motor with a stem and a bell-shaped guard around its blade, standing on the guard.
pub(super) fn hand_blender(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let r = x.min(y);
    let body = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, STEEL, RED_PLASTIC]);
    let (bell, stem) = (h * b.vary(0.08, 0.13), h * b.vary(0.26, 0.4));
    b.lathe(
        "bell",
        [0.0; 3],
        &[
            (r, 0.0),
            (r * 0.92, bell * 0.6),
            (r * 0.3, bell),
            (r * 0.26, bell),
            (r * 0.86, bell * 0.5),
            (r * 0.92, 0.0),
            (r, 0.0),
        ],
        STEEL,
    );
    b.cylinder("stem", [0.0, 0.0, bell * 0.95], r * 0.32, stem, STEEL);
    let z = bell * 0.94 + stem;
    let grip =
        [(r * 0.5, 0.0), (r * 0.8, h * 0.06), (r * 0.72, (h - z) * 0.5), (r * 0.85, (h - z) * 0.9), (r * 0.6, h - z)];
    b.lathe("grip", [0.0, 0.0, z], &grip, body);
    for i in 0..2 {
        let z = h * (0.72 + 0.07 * i as f32);
        b.rod("button", [r * 0.6, 0.0, z], [r * 0.9, 0.0, z], r * 0.2, GREY_PLASTIC);
    }
}

/// A head over a bowl on a foot; large ones have a cage and a lever.
pub(super) fn stand_mixer(b: &mut Build<'_>) {
    let u = fit(b, [0.272, 0.176, 0.256]);
    let (x, y, h) = half_dims(b);
    let large = h > 0.45;
    let body = if large { b.choose(&[STEEL, WHITE_METAL, SILVER_METAL]) } else { machine_mat(b) };
    let foot = h * 0.1;
    let column = -x * 0.45;
    b.rounded_block("foot", [-x, -y * 0.8, 0.0], [x * 0.92, y * 0.8, foot], 0.02 * u, body);
    b.taper(
        "column",
        [(-x + column) / 2.0, 0.0, foot - 0.005 * u],
        ((column + x) / 2.0, y * 0.55),
        ((column + x) * 0.42, y * 0.45),
        h * 0.56 + 0.007 * u,
        body,
    );
    let r = y.min((x * 0.96 - column) / 2.0) * 0.96;
    let cx = (x * 0.94 - r).max(column + r);
    let tall = h * 0.42;
    let bowl = [
        (r * 0.55, 0.0),
        (r * 0.62, tall * 0.08),
        (r * 0.96, tall * 0.6),
        (r, tall),
        (r - 0.003 * u, tall),
        (r * 0.94, tall * 0.6),
        (r * 0.6, tall * 0.1),
    ];
    b.lathe("bowl", [cx, 0.0, foot - 0.002 * u], &bowl, STEEL);
    round_floor(b, "bowl", [cx, 0.0, foot + tall * 0.12], r * 0.55, tall * 0.35);
    if large {
        b.bar("lever", [column, y * 0.5, h * 0.4], [column + x * 0.2, y * 0.9, h * 0.55], 0.012 * u, BLACK_PLASTIC);
    }
    let (low, anchor) = (h * 0.66, [-x * 0.97, 0.0, h * 0.66]);
    let head = y * if large { 0.62 } else { 0.52 };
    lid(b, anchor, 0.7, |b| {
        b.rounded_block("head", [-x, -head, low], [x - 0.003 * u, head, h], (h - low) * 0.42, body);
        b.cylinder("hub", [cx, 0.0, low - h * 0.05], r * 0.26, h * 0.06, STEEL);
        b.lathe(
            "whisk",
            [cx, 0.0, foot + tall * 0.55],
            &[
                (0.0, 0.0),
                (r * 0.4, tall * 0.1),
                (r * 0.42, tall * 0.3),
                (r * 0.1, low - h * 0.05 - foot - tall * 0.55 + 0.002 * u),
            ],
            b.style.metal,
        );
        b.rod(
            "badge",
            [x - 0.006 * u, 0.0, f32::midpoint(low, h)],
            [x, 0.0, f32::midpoint(low, h)],
            head * 0.35,
            CHROME,
        );
        if large {
            for k in [-0.75, 0.0, 0.75] {
                let foot = [cx + r * 0.6, r * k * 0.8, foot + tall * 0.98];
                b.rod("guard", foot, [cx + r * 0.5, r * k * 0.6, h * 0.74], 0.004 * u, STEEL);
            }
        }
    });
    knob(b, [column - x * 0.02, -y * 0.3, h * 0.3], 0.018 * u, 0.015 * u, (BLACK_PLASTIC, WHITE));
}

/// A motor with a loop for a handle and two beaters; it stands on its end.
pub(super) fn hand_mixer(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, RED_PLASTIC, BLACK_PLASTIC, BLUE_PLASTIC]);
    let (low, middle) = (h * 0.45, h * 0.74);
    b.rounded_block("body", [-x, -y, low], [x, y, middle], y * 0.5, body);
    let r = (y * 0.32).min(h * 0.06);
    let edge = r * 1.45;
    let points =
        [[-x * 0.7, 0.0, middle - r], [-x * 0.7, 0.0, h - edge], [x * 0.3, 0.0, h - edge], [x * 0.7, 0.0, middle - r]];
    b.pipe("handle", &points, r, body);
    b.rounded_block("switch", [x * 0.05, -r * 0.7, h - r * 1.2], [x * 0.3, r * 0.7, h], r * 0.3, GREY_PLASTIC);
    for side in [-1.0, 1.0] {
        let cy = side * y * 0.5;
        b.cylinder("shaft", [x * 0.55, cy, low * 0.4], y * 0.07, low * 0.62, STEEL);
        let w = (y * 0.42).min(x * 0.44);
        b.lathe(
            "beater",
            [x * 0.55, cy, 0.0],
            &[
                (w * 0.3, 0.0),
                (w, low * 0.12),
                (w * 0.9, low * 0.38),
                (w * 0.2, low * 0.5),
                (w * 0.1, low * 0.48),
                (w * 0.75, low * 0.35),
                (w * 0.85, low * 0.14),
                (w * 0.2, low * 0.03),
            ],
            STEEL,
        );
    }
}

/// A drum with a lid and a chute over a motor.
pub(super) fn food_processor(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.16, 0.288]);
    let (x, y, h) = half_dims(b);
    let body = machine_mat(b);
    let (base, top, wall) = (h * 0.34, h * 0.72, 0.004 * u);
    b.rounded_block("base", [-x, -y * 0.94, 0.0], [x - 0.013 * u, y * 0.94, base], 0.025 * u, body);
    knob(b, [x - 0.014 * u, 0.0, base * 0.5], base * 0.2, 0.012 * u, (STEEL, BLACK));
    let r = x.min(y) * 0.8;
    b.lathe("drum", [0.0, 0.0, base - 0.001 * u], &cup_profile(r * 0.96, r, top - base, wall), CLEAR_PLASTIC);
    b.cylinder("hub", [0.0, 0.0, base + wall], r * 0.14, (top - base) * 0.2, STEEL);
    let z = base + wall + (top - base) * 0.2 + 0.001 * u;
    b.cylinder("disc", [0.0, 0.0, z - 0.004 * u], r * 0.88, 0.004 * u, STEEL);
    b.inside("compartment_1", [0.0, 0.0, z], (r * 0.6, r * 0.6), top - z - 0.004 * u);
    let points = [
        [0.0, r * 0.95, top - 0.02 * u],
        [0.0, y - 0.012 * u, top - 0.03 * u],
        [0.0, y - 0.012 * u, base + 0.05 * u],
        [0.0, r * 0.94, base + 0.03 * u],
    ];
    b.pipe("handle", &points, 0.01 * u, BLACK_PLASTIC);
    lid(b, [-r, 0.0, top], 1.3, |b| {
        b.lathe("lid", [0.0, 0.0, top], &[(r, 0.0), (r * 0.97, h * 0.03), (r * 0.7, h * 0.06)], CLEAR_PLASTIC);
        b.cylinder("chute", [r * 0.3, 0.0, top + h * 0.05], r * 0.34, h * 0.2, CLEAR_PLASTIC);
        b.cylinder("pusher", [r * 0.3, 0.0, top + h * 0.1], r * 0.28, h - top - h * 0.1, body);
    });
}

/// A chute over a strainer, a spout and jugs for juice and pulp.
pub(super) fn juicer(b: &mut Build<'_>) {
    let u = fit(b, [0.16, 0.144, 0.24]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_METAL, RED_METAL]);
    let r = y.min(x * 0.6) * 0.9;
    let cx = -x + r;
    let (base, top) = (h * 0.42, h * 0.7);
    b.lathe("base", [cx, 0.0, 0.0], &[(r, 0.0), (r * 0.94, base * 0.5), (r * 0.78, base)], body);
    b.lathe("bowl", [cx, 0.0, base - 0.001 * u], &[(r * 0.8, 0.0), (r, (top - base) * 0.4), (r, top - base)], body);
    let glass = (x - cx - r * 0.86).max(r * 0.3);
    let at = [x - glass * 0.5, 0.0, 0.0];
    let wide = (glass * 0.5).min(y);
    let tray = 0.008 * u;
    b.block("tray", [cx, -wide * 0.7, 0.0], [x, wide * 0.7, tray], body);
    b.lathe(
        "jug",
        [at[0], 0.0, tray - 0.001 * u],
        &cup_profile(wide * 0.9, wide, base * 0.84 - tray, 0.003 * u),
        CLEAR_PLASTIC,
    );
    round_floor(b, "jug", [at[0], 0.0, tray + 0.0025 * u], wide * 0.8, base * 0.8 - tray);
    b.bar("spout", [cx + r * 0.9, 0.0, base * 1.12], [at[0], 0.0, base * 0.95], r * 0.14, STEEL);
    lid(b, [cx - r, 0.0, top], 1.2, |b| {
        b.lathe("lid", [cx, 0.0, top], &[(r, 0.0), (r * 0.9, h * 0.05), (r * 0.4, h * 0.09)], CLEAR_PLASTIC);
        b.cylinder("chute", [cx, 0.0, top + h * 0.06], r * 0.42, h * 0.17, CLEAR_PLASTIC);
        b.cylinder("pusher", [cx, 0.0, top + h * 0.1], r * 0.34, h - top - h * 0.1, BLACK_PLASTIC);
    });
    knob(b, [cx + r * 0.92, r * 0.3, base * 0.4], r * 0.16, 0.01 * u, (STEEL, BLACK));
}

/// A ribbed cone over a cup with a spout.
pub(super) fn citrus_juicer(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.128, 0.144]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, STEEL, ORANGE_PLASTIC, BLACK_METAL]);
    let r = x.min(y) * 0.84;
    let (base, rim) = (h * 0.46, h * 0.66);
    b.lathe("base", [0.0; 3], &[(r * 0.95, 0.0), (r * 0.8, base)], body);
    let wall = 0.004 * u;
    b.lathe("cup", [0.0, 0.0, base - 0.001 * u], &cup_profile(r * 0.8, r, rim - base, wall), CLEAR_PLASTIC);
    b.lathe(
        "sieve",
        [0.0, 0.0, base + wall],
        &[(r * 0.76, 0.0), (r * 0.9, (rim - base) * 0.5), (r * 0.3, (rim - base) * 0.55)],
        body,
    );
    // The shaft of the cone stands in the sieve.
    let root = base + wall + (rim - base) * 0.5;
    let shaft = (rim - 0.012 * u - root).max(0.001 * u);
    let cone = [(0.42, 0.0), (0.4, 0.3), (0.26, 0.75), (0.05, 1.0)].map(|(a, z)| (a * r, z * (h - rim) + shaft));
    b.lathe("cone", [0.0, 0.0, rim - 0.012 * u - shaft], &[&[(r * 0.3, 0.0)], &cone[..]].concat(), body);
    for (c, s) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.7, 0.7), (-0.7, 0.7), (0.7, -0.7), (-0.7, -0.7)]
    {
        b.bar("rib", [c * r * 0.42, s * r * 0.42, rim], [c * r * 0.1, s * r * 0.1, h - 0.014 * u], r * 0.05, body);
    }
    let z = base + (rim - base) * 0.4;
    b.hull(
        "spout",
        &[
            [r * 0.7, -r * 0.15, z],
            [r * 0.7, r * 0.15, z],
            [x, 0.0, z - 0.004 * u],
            [r * 0.7, 0.0, z - 0.02 * u],
            [x, 0.0, z + 0.004 * u],
        ],
        body,
    );
    b.pipe(
        "handle",
        &[
            [0.0, -r * 0.8, base * 0.9],
            [0.0, -y + 0.008 * u, base * 0.8],
            [0.0, -y + 0.008 * u, base * 0.3],
            [0.0, -r * 0.85, base * 0.2],
        ],
        0.007 * u,
        body,
    );
}

/// A round blade behind a carriage that slides, on a base with a dial.
pub(super) fn meat_slicer(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.272, 0.192]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, ALUMINIUM, WHITE_METAL, RED_METAL]);
    let (feet, deck) = (h * 0.07, h * 0.3);
    b.at([-x * 0.15, -y * 0.2, 0.0], 0.0, |b| foot_row(b, (x * 0.65, y * 0.6), 0.018 * u, feet * 1.1));
    b.rounded_block("base", [-x, -y, feet], [x * 0.7, y * 0.6, deck], 0.02 * u, body);
    let r = ((h - deck) * 0.5).min(x * 0.6);
    let (z, blade) = (deck + (h - deck) * 0.46, y * 0.02);
    b.rounded_block(
        "motor",
        [-x * 0.75, blade + 0.012 * u, deck - 0.01 * u],
        [x * 0.1, y * 0.58, z + r * 0.5],
        0.03 * u,
        body,
    );
    b.lathe_along(
        "blade",
        [-x * 0.2, blade - 0.003 * u, z],
        [-x * 0.2, blade + 1.0, z],
        &[(r, 0.0), (r * 0.96, 0.004 * u), (r * 0.7, 0.018 * u)],
        STEEL,
    );
    b.rod("cover", [-x * 0.2, blade - 0.006 * u, z], [-x * 0.2, blade, z], r * 0.6, body);
    b.block(
        "gauge",
        [x * 0.16 + r * 0.2, blade - 0.002 * u, deck - 0.005 * u],
        [x * 0.68, blade + 0.006 * u, z + r * 0.6],
        STEEL,
    );
    knob(b, [x * 0.69, y * 0.35, deck * 0.65], deck * 0.25, 0.02 * u, (BLACK_PLASTIC, WHITE));
    let tray = ([-x * 0.9, -y * 0.9, deck + 0.012 * u], [x * 0.75, blade - 0.03 * u, deck + 0.02 * u]);
    b.jointed(vc_graph::asset::JointKind::Slide, [0.0; 3], [1.0, 0.0, 0.0], (0.0, x * 0.4), |b| {
        b.block("carriage", tray.0, tray.1, STEEL);
        b.block(
            "fence",
            [tray.0[0], tray.0[1], tray.1[2]],
            [tray.0[0] + 0.006 * u, tray.1[1], tray.1[2] + (h - deck) * 0.35],
            STEEL,
        );
        b.block("rail", [x * 0.0, -y * 0.6, deck - 0.002 * u], [x * 0.3, -y * 0.5, deck + 0.013 * u], STEEL);
        b.bar(
            "grip",
            [tray.0[0] + 0.02 * u, tray.0[1] + 0.02 * u, tray.1[2]],
            [tray.0[0] + 0.02 * u, tray.0[1] + 0.02 * u, h - 0.015 * u],
            0.012 * u,
            BLACK_PLASTIC,
        );
        let centre = [(tray.0[0] + tray.1[0]) / 2.0 + 0.03 * u, (tray.0[1] + tray.1[1]) / 2.0 + 0.02 * u, tray.1[2]];
        b.top("carriage", centre, ((tray.1[0] - tray.0[0]) * 0.42, (tray.1[1] - tray.0[1]) * 0.38));
    });
    b.block("catch_plate", [-x * 0.8, y * 0.59, feet], [x * 0.6, y, feet + 0.012 * u], STEEL);
    b.block("switch", [x * 0.69, -y * 0.5, deck * 0.5], [x * 0.71, -y * 0.35, deck * 0.8], SIGNAL_GREEN);
}

/// A hopper over a screw, with a perforated plate in front.
pub(super) fn meat_grinder(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.128, 0.24]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, WHITE_METAL, RED_METAL, BLACK_METAL]);
    let middle = h * 0.56;
    let r = y * 0.36;
    b.at([-x * 0.4, 0.0, 0.0], 0.0, |b| foot_row(b, (x * 0.45, y * 0.65), 0.015 * u, h * 0.045));
    b.rounded_block("motor", [-x, -y * 0.9, h * 0.04], [x * 0.2, y * 0.9, middle + r], 0.03 * u, body);
    b.rod("tube", [x * 0.18, 0.0, middle], [x * 0.9, 0.0, middle], r, STEEL);
    b.rod("ring", [x * 0.82, 0.0, middle], [x, 0.0, middle], r * 1.2, STEEL);
    b.rod("plate", [x - 0.002 * u, 0.0, middle], [x + 0.0008 * u, 0.0, middle], r * 0.95, BLACK_METAL);
    let tray = h * 0.86;
    b.cylinder("neck", [x * 0.45, 0.0, middle], r * 0.7, tray - middle + 0.002 * u, STEEL);
    let (low, high) = ([-x * 0.5, -y, tray], [x * 0.95, y, h]);
    pit(b, "tray", low, high, 0.005 * u, STEEL);
    floor_of(
        b,
        "tray",
        [low[0] + 0.006 * u, -y + 0.006 * u, tray + 0.005 * u],
        [high[0] - 0.006 * u, y - 0.006 * u, h],
    );
    knob(b, [x * 0.2, y * 0.55, h * 0.22], h * 0.05, 0.015 * u, (BLACK_PLASTIC, WHITE));
}

/// A bowl in a cooling case with a clear lid and a motor on top.
pub(super) fn ice_cream_maker(b: &mut Build<'_>) {
    let u = fit(b, [0.192, 0.176, 0.176]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, STEEL, PINK_PLASTIC, SKY]);
    let (rim, wall) = (h * 0.72, 0.02 * u);
    let r = y.min(x) * 0.84;
    let cx = x - y.min(x);
    let deep = rim - 0.02 * u;
    pit(b, "case", [-x, -y, 0.0], [x - 0.003 * u, y, rim - 0.002 * u], wall * 0.6, body);
    plate_with_hole(
        b,
        "deck",
        Axis::Z,
        ([-x, -y, rim - 0.004 * u], [x, y, rim]),
        ((cx - r * 0.74, -r * 0.74), (cx + r * 0.74, r * 0.74)),
        body,
    );
    let bowl = [(r * 0.84, 0.0), (r, deep), (r * 0.84, deep), (r * 0.76, wall)];
    b.lathe("bowl", [cx, 0.0, 0.016 * u], &bowl, STEEL);
    round_floor(b, "bowl", [cx, 0.0, 0.016 * u + wall], r * 0.74, deep - wall * 1.4);
    display(b, x - 0.003 * u, (-y * 0.4, rim * 0.4), (y * 0.4, rim * 0.65), COOL_BULB);
    lid(b, [cx - r, 0.0, rim + 0.017 * u], 1.3, |b| {
        b.lathe(
            "lid",
            [cx, 0.0, rim + 0.001 * u],
            &[(r, 0.0), (r * 0.97, h * 0.04), (r * 0.5, h * 0.07)],
            CLEAR_PLASTIC,
        );
        b.rounded_block(
            "motor",
            [cx - r * 0.5, -r * 0.35, rim + h * 0.06],
            [cx + r * 0.5, r * 0.35, h],
            0.015 * u,
            body,
        );
    });
}

/// A long flat case whose top opens along its back.
pub(super) fn vacuum_sealer(b: &mut Build<'_>) {
    let u = fit(b, [0.112, 0.288, 0.064]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, BLACK_PLASTIC, WHITE_PLASTIC]);
    let seam = h * 0.55;
    foot_row(b, (x * 0.75, y * 0.9), 0.01 * u, h * 0.06);
    b.rounded_block("base", [-x, -y, h * 0.05], [x, y, seam], 0.012 * u, body);
    b.block("seal", [x * 0.2, -y * 0.9, seam - 0.002 * u], [x * 0.5, y * 0.9, seam + 0.001 * u], RUBBER);
    lid(b, [-x, 0.0, seam + 0.002 * u], 1.1, |b| {
        b.rounded_block("lid", [-x, -y, seam + 0.002 * u], [x, y, h - 0.004 * u], 0.012 * u, body);
        b.block("panel", [-x * 0.7, -y * 0.5, h - 0.006 * u], [-x * 0.2, y * 0.5, h - 0.003 * u], BLACK_PLASTIC);
        for i in 0..3 {
            let cy = y * 0.25 * (i as f32 - 1.0);
            b.cylinder("button", [-x * 0.45, cy, h - 0.004 * u], x * 0.1, 0.0035 * u, LED);
        }
        b.top("lid", [x * 0.35, 0.0, h - 0.004 * u], (x * 0.5, y * 0.8));
        b.block("latch", [x - 0.004 * u, -y * 0.2, seam + 0.004 * u], [x, y * 0.2, seam + h * 0.12], GREY_PLASTIC);
    });
}

/// A flat plate with a display, of glass or with a bowl's ring.
pub(super) fn kitchen_scale(b: &mut Build<'_>) {
    let u = fit(b, [0.144, 0.112, 0.016]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[STEEL, WHITE_PLASTIC, BLACK_PLASTIC, RED_PLASTIC, GREEN_PLASTIC]);
    let thin = (h * 0.4).min(0.008 * u);
    let top = h - thin;
    foot_row(b, (x * 0.75, y * 0.75), 0.008 * u, h * 0.15);
    b.rounded_block("body", [-x, -y, h * 0.12], [x, y, top], 0.01 * u, body);
    let cx = -x * 0.22;
    let plate = b.choose(&[GLASS, STEEL, BLACK_GLASS]);
    if b.rng.chance(0.5) {
        let r = (x * 0.72).min(y * 0.92);
        b.cylinder("plate", [cx, 0.0, top - 0.001 * u], r, thin + 0.001 * u, plate);
        b.top("plate", [cx, 0.0, h], (r * 0.69, r * 0.69));
    } else {
        b.block("plate", [-x * 0.95, -y * 0.94, top - 0.001 * u], [x * 0.5, y * 0.94, h], plate);
        b.top("plate", [cx, 0.0, h], (x * 0.7, y * 0.88));
    }
    b.block("display", [x * 0.6, -y * 0.45, top - 0.002 * u], [x * 0.9, y * 0.45, top + 0.001 * u], SCREEN);
    for i in 0..3 {
        let cy = y * 0.2 * (i as f32 - 1.0);
        b.block("figure", [x * 0.68, cy - y * 0.06, top], [x * 0.82, cy + y * 0.06, top + 0.0016 * u], COOL_BULB);
    }
}

/// An inverted bottle on a column with two taps and a niche for a cup.
pub(super) fn water_dispenser(b: &mut Build<'_>) {
    let u = fit(b, [0.24, 0.224, 0.72]);
    let (x, y, h) = half_dims(b);
    let body = b.choose(&[WHITE_PLASTIC, WHITE_METAL, STEEL, BLACK_METAL]);
    let top = h * 0.72;
    let (low, high) = (top * 0.66, top * 0.88);
    let niche = x * 0.3;
    b.block("case", [-x, -y, 0.0], [x, y, low], body);
    b.block("case", [-x, -y, low], [niche, y, high], body);
    b.rounded_block("head", [-x, -y, high - 0.001 * u], [x, y, top], 0.015 * u, body);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * y * 0.86);
        b.block("cheek", [niche, a.min(c), low], [x * 0.98, a.max(c), high], body);
    }
    for (cy, dot) in [(-y * 0.35, SIGNAL_RED), (y * 0.35, BLUE_PLASTIC)] {
        b.rod("tap", [niche, cy, high - 0.045 * u], [niche + 0.045 * u, cy, high - 0.045 * u], 0.012 * u, body);
        b.cylinder("tap", [niche + 0.04 * u, cy, high - 0.075 * u], 0.008 * u, 0.035 * u, CHROME);
        b.block(
            "lever",
            [niche + 0.03 * u, cy - 0.012 * u, high - 0.034 * u],
            [niche + 0.07 * u, cy + 0.012 * u, high - 0.026 * u],
            dot,
        );
    }
    b.block(
        "drip_tray",
        [niche + 0.005 * u, -y * 0.8, low - 0.001 * u],
        [x * 0.95, y * 0.8, low + 0.008 * u],
        GREY_PLASTIC,
    );
    let r = x.min(y) * 0.88;
    let z = h - top;
    let bottle = [
        (r * 0.25, 0.0),
        (r * 0.3, z * 0.08),
        (r * 0.95, z * 0.3),
        (r, z * 0.4),
        (r * 0.95, z * 0.62),
        (r, z * 0.68),
        (r, z * 0.95),
        (r * 0.9, z),
    ];
    b.lathe("bottle", [0.0, 0.0, top - 0.001 * u], &bottle, BLUE_GLASS);
    super::cool::grille(b, x - 0.0004, (-y * 0.6, low * 0.15), (y * 0.6, low * 0.3), 4);
}

/// A drum with an inlet at the top and a pipe at its side, standing free.
pub(super) fn garbage_disposal(b: &mut Build<'_>) {
    let u = fit(b, [0.128, 0.128, 0.24]);
    let (x, y, h) = half_dims(b);
    let r = x.min(y) * 0.88;
    let body = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC, SILVER_METAL]);
    let profile =
        [(r * 0.8, 0.0), (r, h * 0.1), (r, h * 0.45), (r * 0.85, h * 0.52), (r * 0.9, h * 0.72), (r * 0.5, h * 0.82)];
    b.lathe("drum", [0.0; 3], &profile, body);
    let neck = [
        (r * 0.48, 0.0),
        (r * 0.5, h * 0.12),
        (r * 0.7, h * 0.14),
        (r * 0.72, h * 0.19),
        (r * 0.46, h * 0.19),
        (r * 0.42, h * 0.04),
    ];
    b.lathe("mouth", [0.0, 0.0, h * 0.81], &neck, STEEL);
    round_floor(b, "mouth", [0.0, 0.0, h * 0.851], r * 0.4, h * 0.14);
    b.pipe(
        "pipe",
        &[[r * 0.7, 0.0, h * 0.6], [x - 0.02 * u, 0.0, h * 0.6], [x - 0.02 * u, 0.0, h * 0.45]],
        0.018 * u,
        BLACK_PLASTIC,
    );
    b.block("label", [-r * 0.3, -r - 0.001 * u, h * 0.2], [r * 0.3, -r * 0.9, h * 0.4], SILVER_METAL);
}

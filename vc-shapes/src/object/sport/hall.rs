//! Equipment of a gym or training room.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, CORNERS, Proportional, SIDES, rounded_between};

/// A pull-up bar for a doorway or on wall brackets.
pub(super) fn pull_up_bar(b: &mut Build<'_>) {
    let mat = b.choose(&[CHROME, BLACK_METAL, STEEL]);
    if b.size.z < 0.15 {
        let r = (b.size.x.min(b.size.z) / 2.0).min(0.018);
        b.pole("bar", [0.0, -0.97, 0.5], [0.0, 0.97, 0.5], r * 0.85, mat);
        let cup = b.size.x.min(b.size.z) / 2.0;
        for y in SIDES {
            b.pole("cup", [0.0, y, 0.5], [0.0, y * 0.95, 0.5], cup, RUBBER);
            b.pole("grip", [0.0, y * 0.3, 0.5], [0.0, y * 0.75, 0.5], r, FOAM);
        }
        return;
    }
    for y in SIDES.map(|s| s * 0.7) {
        b.slab("plate", [-1.0, y - 0.05, 0.0], [-0.97, y + 0.05, 1.0], mat);
        b.plank("arm", [-0.98, y, 0.92], [0.86, y, 0.92], (0.04, (b.size.z * 0.1).min(0.04)), mat);
        b.plank("brace", [-0.97, y, 0.12], [0.4, y, 0.9], (0.035, (b.size.z * 0.1).min(0.035)), mat);
    }
    let r = (b.size.z * 0.06).min(0.018);
    for x in [0.82, 0.3] {
        b.pole("bar", [x, -0.97, 0.92], [x, 0.97, 0.92], r, mat);
    }
    for y in SIDES {
        b.pole("grip", [0.82, y, 0.92], [0.82, y * 0.76, 0.92], r * 1.3, FOAM);
        b.pole("grip", [0.2, y * 0.3, 0.93], [0.82, y * 0.3, 0.93], r * 1.2, FOAM);
    }
}

/// A dip station, with a back pad and a bar on top if it is tall.
pub(super) fn dip_station(b: &mut Build<'_>) {
    let mat = b.choose(&[BLACK_METAL, SILVER_METAL, RED_METAL]);
    let tall = b.size.z > 1.5;
    let bar = if tall { 1.2 / b.size.z } else { 0.96 };
    let t = 0.05;
    for y in SIDES.map(|s| s * 0.85) {
        b.plank("foot", [-0.97, y, 0.03], [0.97, y, 0.03], (t, t), mat);
        b.plank("upright", [-0.5, y, 0.03], [-0.5, y, if tall { 0.97 } else { bar }], (t, t), mat);
        if !tall {
            b.plank("upright", [0.6, y, 0.03], [0.6, y, bar], (t, t), mat);
        }
        b.pole("dip_bar", [-0.5, y, bar], [0.9, y, bar], 0.02, mat);
        b.pole("grip", [0.3, y, bar], [0.92, y, bar], 0.024, RUBBER);
        b.plank("brace", [0.6, y, 0.05], [-0.46, y, 0.4], (t * 0.8, t * 0.8), mat);
    }
    b.plank("tie", [-0.8, -0.85, 0.032], [-0.8, 0.85, 0.032], (t, t), mat);
    if tall {
        b.plank("cross", [-0.5, -0.85, bar - 0.02], [-0.5, 0.85, bar - 0.02], (t, t), mat);
        b.pad("back_pad", [-0.48, -0.4, bar - 0.16], [-0.32, 0.4, bar + 0.1], 0.02, BLACK_LEATHER);
        b.pole("pull_up_bar", [-0.4, -0.98, 0.97], [-0.4, 0.98, 0.97], 0.016, CHROME);
        for y in SIDES {
            b.plank("head", [-0.52, y * 0.85, 0.965], [-0.36, y * 0.85, 0.965], (t, t), mat);
            b.pad(
                "arm_pad",
                [-0.3, y * 0.85 - 0.1, bar + 0.015 / b.size.z],
                [0.25, y * 0.85 + 0.1, bar + 0.05],
                0.012,
                BLACK_LEATHER,
            );
        }
    }
}

/// A heavy punching bag on chains, or a standing one on a base.
pub(super) fn punching_bag(b: &mut Build<'_>) {
    let (hide, trim) =
        (b.choose(&[BLACK_LEATHER, RED, BROWN_LEATHER, BLUE]), b.choose(&[WHITE_LEATHER, RED, BLACK_LEATHER]));
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    let standing = h > 1.35 && b.rng.chance(0.6);
    let (low, high, wide) = if standing { (0.32, 1.0, 0.72) } else { (0.0, 0.72, 0.97) };
    if standing {
        b.lathe(
            "base",
            [0.0; 3],
            &[(r * 0.95, 0.0), (r, h * 0.03), (r * 0.9, h * 0.16), (r * 0.5, h * 0.21)],
            BLACK_PLASTIC,
        );
        b.cylinder("neck", [0.0, 0.0, h * 0.2], r * 0.35, h * 0.15, STEEL);
    } else {
        for (x, y) in CORNERS {
            b.rod("chain", [x * r * 0.55, y * r * 0.55, h * high * 0.99], [0.0, 0.0, h * 0.93], 0.006, STEEL);
        }
        b.cylinder("swivel", [0.0, 0.0, h * 0.915], 0.018, h * 0.05, CHROME);
        b.torus("ring", Axis::X, [0.0, 0.0, 0.975], (h * 0.017, h * 0.006), CHROME);
    }
    let (z0, z1, w) = (h * low, h * high, r * wide);
    b.lathe(
        "bag",
        [0.0, 0.0, z0],
        &[(w * 0.9, 0.0), (w, (z1 - z0) * 0.04), (w, (z1 - z0) * 0.96), (w * 0.9, z1 - z0)],
        hide,
    );
    for share in [0.16, 0.5, 0.84] {
        b.cylinder("band", [0.0, 0.0, z0 + (z1 - z0) * share], w * 1.012, h * 0.03, trim);
    }
}

/// A speed bag under a round board with its bracket.
pub(super) fn speed_bag(b: &mut Build<'_>) {
    let (hide, wood) = (b.choose(&[RED, BLACK_LEATHER, BROWN_LEATHER]), b.style.wood);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, b.size.z);
    b.lathe(
        "board",
        [0.0, 0.0, h * 0.66],
        &[(r * 0.97, 0.0), (r, h * 0.02), (r, h * 0.07), (r * 0.97, h * 0.09)],
        wood,
    );
    let w = (r * 0.34).min(h * 0.22);
    let pear = [
        (0.0, 0.0),
        (w * 0.5, h * 0.02),
        (w * 0.9, h * 0.1),
        (w, h * 0.2),
        (w * 0.8, h * 0.34),
        (w * 0.4, h * 0.5),
        (w * 0.22, h * 0.56),
    ];
    b.lathe("bag", [0.0; 3], &pear, hide);
    b.cylinder("swivel", [0.0, 0.0, h * 0.55], w * 0.2, h * 0.13, CHROME);
    for y in SIDES.map(|s| s * 0.4) {
        b.plank("arm", [-0.96, y, 0.79], [0.7, y, 0.79], (0.04, h * 0.09), BLACK_METAL);
        b.plank("brace", [-0.96, y, 0.97], [0.2, y, 0.8], (0.035, 0.035), BLACK_METAL);
    }
    b.slab("plate", [-1.0, -0.5, 0.72], [-0.95, 0.5, 1.0], BLACK_METAL);
}

/// Wall bars: rungs between posts against the wall, the top rung further out.
pub(super) fn wall_bars(b: &mut Build<'_>) {
    let wood = b.choose(&[BEECH, PINE, OAK]);
    let wide = b.size.y > 1.4;
    let posts: &[f32] = if wide { &[-1.0, 0.0, 1.0] } else { &[-1.0, 1.0] };
    for &y in posts {
        let at = y * (1.0 - 0.035 / b.size.y);
        let half = 0.03 / b.size.y;
        b.side_outline(
            "post",
            (at - half, at + half),
            &[(-1.0, 0.0), (0.2, 0.0), (0.3, 0.84), (0.98, 0.9), (0.98, 1.0), (-1.0, 1.0)],
            wood,
        );
    }
    let count = (b.size.z / 0.16).clamp(6.0, 18.0) as usize;
    for i in 0..count {
        let z = 0.05 + 0.9 * i as f32 / (count as f32 - 1.0);
        let x = if i + 1 == count { 0.68 } else { -0.15 };
        b.pole("rung", [x, -0.96, z], [x, 0.96, z], (b.size.x * 0.14).min(0.02), wood);
    }
}

/// A climbing panel with coloured holds: upright or, if the size is deep, overhanging.
pub(super) fn climbing_wall(b: &mut Build<'_>) {
    let board = b.choose(&[BIRCH, LIGHT_GREY, SKY, CREAM]);
    let thick = b.size.x > 0.25;
    let lean = if thick { 0.35 } else { -0.55 };
    let back = if thick { -0.75 } else { -0.6 };
    let face = |z: f32| if z < 0.4 { back } else { back + (lean - back) * (z - 0.4) / 0.6 };
    b.side_outline("wall", (-0.995, 0.995), &[(-1.0, 0.0), (back, 0.0), (back, 0.4), (lean, 1.0), (-1.0, 1.0)], board);
    let (rows, columns) = (6, (b.size.y / 0.45).clamp(3.0, 8.0) as usize);
    let room = (b.size.x * (0.95 - lean) / 4.0).min(b.size.x * (1.0 + back) / 1.3);
    let (hold, deep) = ((b.size.x * (0.95 - lean) / 4.0).min(0.045), room.min(0.045) * 2.0 / b.size.x);
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        if b.rng.chance(0.2) {
            continue;
        }
        let (dy, dz, size) = (b.vary(-0.3, 0.3), b.vary(-0.04, 0.04), b.vary(0.6, 1.0));
        let y = -1.0 + 2.0 * (j as f32 + 0.5 + dy) / columns as f32;
        let z = 0.1 + 0.15 * i as f32 + dz;
        let mat = b.one_of(BRIGHT);
        let half = [deep, hold * size * 2.6 / b.size.y, hold * size * 0.9 / b.size.z];
        b.ellipsoid("hold", [face(z) + 0.4 * deep, y.clamp(-0.9, 0.9), z], half, mat);
    }
    b.slab("mat", [-0.98, -0.99, 0.0], [0.99, 0.99, 0.03], BLUE_FABRIC);
}

/// A balance beam on feet, or low on the floor.
pub(super) fn balance_beam(b: &mut Build<'_>) {
    let top = b.choose(&[TAN_LEATHER, BLUE_FABRIC, BEIGE_FABRIC, PURPLE_FABRIC]);
    let (thick, wide) = ((0.13 / b.size.z).min(0.8), (0.05 / (b.size.x / 2.0)).clamp(0.3, 0.62));
    b.pad("beam", [-wide, -1.0, 1.0 - thick], [wide, 1.0, 1.0], 0.015, top);
    b.deck("beam", [0.0, 0.0, 1.0], (wide * 0.85, 0.97));
    let steel = b.choose(&[GALVANISED, BLACK_METAL, BLUE_METAL]);
    for y in SIDES.map(|s| s * 0.78) {
        let reach = 0.025 / b.size.y;
        b.slab("foot", [-0.99, y - reach * 1.5, 0.0], [0.99, y + reach * 1.5, (0.05 / b.size.z).min(0.15)], steel);
        if b.size.z > 0.3 {
            b.slab("post", [-wide * 0.6, y - reach, 0.01], [wide * 0.6, y + reach, 1.0 - thick * 0.9], steel);
            for s in SIDES {
                b.plank("brace", [s * 0.85, y, 0.05], [s * wide * 0.5, y, 0.6], (0.03, 0.03), steel);
            }
        } else {
            b.slab("post", [-wide * 0.9, y - reach, 0.01], [wide * 0.9, y + reach, 1.0 - thick * 0.98], steel);
        }
    }
}

/// A pair of gymnastic rings on straps.
pub(super) fn rings(b: &mut Build<'_>) {
    let (ring, strap) = (b.choose(&[BEECH, BIRCH, BLACK_PLASTIC]), b.choose(&[BLACK_FABRIC, RED_FABRIC, BLUE_FABRIC]));
    let r = (b.size.x * 0.48).min(0.015);
    let wheel = (b.size.y * 0.18).min(0.105);
    let y = 1.0 - 2.0 * wheel / b.size.y;
    b.pole("hanger", [0.0, -1.0, 1.0 - 0.012 / b.size.z], [0.0, 1.0, 1.0 - 0.012 / b.size.z], r.min(0.012), STEEL);
    for s in SIDES {
        b.torus("ring", Axis::X, [0.0, s * y, wheel / b.size.z], (wheel - r, r), ring);
        let top = (2.0 * wheel - 2.0 * r) / b.size.z;
        let half = (0.019 / (b.size.y / 2.0)).min(0.1);
        b.slab("strap", [-0.1, s * y - half, top], [0.1, s * y + half, 0.999], strap);
        b.slab(
            "buckle",
            [-0.4, s * y - half * 1.4, top + 0.2],
            [0.4, s * y + half * 1.4, top + 0.2 + 0.04 / b.size.z],
            STEEL,
        );
    }
}

/// A vaulting horse: a padded body on legs, with or without two pommels.
pub(super) fn pommel_horse(b: &mut Build<'_>) {
    let (hide, leg) = (b.choose(&[TAN_LEATHER, BROWN_LEATHER, BLUE_FABRIC]), b.choose(&[BLACK_METAL, GALVANISED, OAK]));
    let pommels = b.rng.chance(0.6);
    let top = if pommels { 0.88 } else { 0.99 };
    let ring = |y: f32, s: f32| ([0.0, y, top - 0.13], 0.72 * s, 0.125 * s);
    b.skin(
        "body",
        Axis::Y,
        &[ring(-1.0, 0.75), ring(-0.94, 0.95), ring(-0.6, 1.0), ring(0.6, 1.0), ring(0.94, 0.95), ring(1.0, 0.75)],
        hide,
    );
    for (x, y) in CORNERS {
        b.plank("leg", [x * 0.92, y * 0.8, 0.02], [x * 0.4, y * 0.6, top - 0.16], (0.06, 0.06), leg);
        b.slab("foot", [x * 0.9 - 0.1, y * 0.8 - 0.03, 0.0], [x * 0.9 + 0.1, y * 0.8 + 0.03, 0.02], RUBBER);
    }
    for y in SIDES {
        b.plank("stretcher", [-0.75, y * 0.74, 0.24], [0.75, y * 0.74, 0.24], (0.04, 0.04), leg);
        if pommels {
            let z = 0.985 - 0.017 / b.size.z;
            let bow =
                [[-0.6, y * 0.28, top - 0.07], [-0.4, y * 0.28, z], [0.4, y * 0.28, z], [0.6, y * 0.28, top - 0.07]];
            b.bent_rod("pommel", &bow, 0.017, b.style.wood);
        }
    }
}

/// A wooden or padded plyo box with a number on its front.
pub(super) fn plyo_box(b: &mut Build<'_>) {
    let soft = b.rng.chance(0.4);
    let mat = if soft { b.choose(&[RED, BLACK_LEATHER, BLUE, YELLOW]) } else { b.choose(&[BIRCH, PINE, OAK]) };
    if soft {
        b.pad("box", [-0.98, -1.0, 0.0], [0.98, 1.0, 1.0], 0.03, mat);
    } else {
        b.slab("box", [-0.98, -1.0, 0.0], [0.98, 1.0, 1.0], mat);
        for y in SIDES {
            b.pad("grip_hole", [-0.3, y * 0.98 - 0.018, 0.7], [0.3, y * 0.98 + 0.018, 0.8], 0.01, BLACK);
        }
    }
    for (low, high) in [
        ((-0.4, 0.3), (-0.3, 0.7)),
        ((0.0, 0.3), (0.1, 0.7)),
        ((0.3, 0.3), (0.4, 0.7)),
        ((0.05, 0.3), (0.35, 0.36)),
        ((0.05, 0.64), (0.35, 0.7)),
    ] {
        b.slab("number", [0.97, low.0, low.1], [1.0, high.0, high.1], if soft { WHITE } else { BLACK });
    }
    b.deck("top", [0.0, 0.0, 1.0], (0.9, 0.9));
}

/// An aerobic step: a ribbed top on risers.
pub(super) fn aerobic_step(b: &mut Build<'_>) {
    let (mat, riser) = (b.choose(&[GREY_PLASTIC, BLACK_PLASTIC, PURPLE_PLASTIC, BLUE_PLASTIC]), b.one_of(BRIGHT));
    let thick = (0.08 / b.size.z).min(0.6);
    let outline = rounded_between((-1.0, -1.0), (1.0, 1.0), (0.3, 0.12));
    b.plan_outline("step", (1.0 - thick, 0.97), &outline, mat);
    let inner: Vec<_> = outline.iter().map(|&(x, y)| (x * 0.88, y * 0.95)).collect();
    b.plan_outline("tread", (0.9, 1.0), &inner, RUBBER);
    let levels = (((1.0 - thick) * b.size.z / 0.05).round() as usize).clamp(1, 4);
    for y in SIDES {
        for i in 0..levels {
            let pitch = (1.0 - thick) / levels as f32;
            let shrink = 0.04 * (levels - i) as f32 * 0.3;
            b.pad(
                "riser",
                [-0.95 + shrink, y * 0.72 - 0.24, pitch * i as f32],
                [0.95 - shrink, y * 0.72 + 0.24, pitch * (i as f32 + 1.0)],
                0.008,
                riser,
            );
        }
    }
    b.deck("step", [0.0, 0.0, 1.0], (0.8, 0.9));
}

/// A small trampoline on legs, sometimes with a bar to hold.
pub(super) fn rebounder(b: &mut Build<'_>) {
    let (pad, bar) = (b.choose(&[BLACK_FABRIC, BLUE_FABRIC, PURPLE_FABRIC, RED_FABRIC]), b.size.z > 0.6);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0, (b.size.z * 0.98).min(0.26));
    let tube = 0.014;
    b.torus("frame", Axis::Z, [0.0, 0.0, (h - 0.03) / b.size.z], (r * 0.97 - tube, tube), BLACK_METAL);
    b.cylinder("mat", [0.0, 0.0, h - 0.03], r * 0.78, 0.012, BLACK_FABRIC);
    b.lathe(
        "pad",
        [0.0, 0.0, h - 0.03],
        &[(r * 0.76, 0.0), (r, 0.0), (r * 0.98, 0.03), (r * 0.78, 0.03), (r * 0.76, 0.0)],
        pad,
    );
    for i in 0..6 {
        let (s, c) = (PI * i as f32 / 3.0 + 0.3).sine_cosine();
        let at = r * 0.92;
        b.rod("leg", [at * c, at * s, 0.01], [at * c, at * s, h - 0.025], tube, BLACK_METAL);
        b.cylinder("foot", [at * c, at * s, 0.0], tube * 1.6, 0.02, RUBBER);
    }
    b.top("mat", [0.0, 0.0, h - 0.018], (r * 0.5, r * 0.5));
    if bar {
        let high = b.size.z - 0.03;
        let foot = |s: f32| [r * 0.8, s * r * 0.45, h * 0.3];
        let head = |s: f32| [r * 0.8, s * r * 0.45, high];
        for s in SIDES {
            b.rod("post", foot(s), head(s), tube, BLACK_METAL);
        }
        b.rod("bar", [r * 0.8, -r * 0.62, high], [r * 0.8, r * 0.62, high], 0.02, FOAM);
        b.rod("brace", [r * 0.8, -r * 0.45, h * 0.5], [r * 0.8, r * 0.45, h * 0.5], tube, BLACK_METAL);
    }
}

/// A sectioned gymnastics mat, spread out or folded, or one thick crash mat.
pub(super) fn gym_mat(b: &mut Build<'_>) {
    let (mat, other) = (
        b.choose(&[BLUE_FABRIC, RED_FABRIC, GREEN_FABRIC, BLACK_LEATHER, NAVY_FABRIC]),
        b.choose(&[GREY_FABRIC, BLUE_FABRIC, MUSTARD_FABRIC]),
    );
    let parts = if b.size.z > 0.15 { 1 } else { 4 };
    let pitch = 2.0 / parts as f32;
    let round = b.size.z * 0.2;
    for i in 0..parts {
        let y = -1.0 + pitch * i as f32;
        let gap = 0.004;
        b.pad(
            "section",
            [-1.0, y + gap, 0.0],
            [1.0, y + pitch - gap, 1.0],
            round,
            if i % 2 == 0 { mat } else { other },
        );
        if i > 0 {
            b.slab("hinge", [-0.96, y - 0.01, 0.02], [0.96, y + 0.01, 0.3], mat);
        }
    }
    if parts == 1 {
        for x in [-0.5, 0.5] {
            b.slab("handle", [x - 0.15, -1.0, 0.4], [x + 0.15, -0.98, 0.55], WHITE_COTTON);
        }
        b.slab("seam", [-0.995, -0.995, 0.48], [0.995, 0.995, 0.52], other);
    }
    b.deck("mat", [0.0, 0.0, 1.0], (0.92, 0.95));
}

/// A strip of artificial turf with a slope, a hole, a flag and lines.
pub(super) fn putting_green(b: &mut Build<'_>) {
    let edge = b.choose(&[BLACK_PLASTIC, OAK, PINE]);
    let mat = 0.2;
    let half = (0.006 / b.size.x).min(0.1);
    b.slab("turf", [-0.99, -0.95, 0.0], [0.6, 0.95, mat], GRASS);
    b.side_outline("ramp", (-0.95, 0.95), &[(0.6, 0.0), (0.99, 0.0), (0.99, 0.7), (0.86, 0.7)], GRASS);
    for y in SIDES {
        b.slab("border", [-1.0, y * 0.975 - 0.024, 0.0], [1.0, y * 0.975 + 0.024, 0.76], edge);
    }
    b.slab("end", [0.97, -0.95, 0.0], [1.0, 0.95, 1.0], edge);
    let r = (b.size.y * 0.17).min(0.054);
    let at = b.p([0.92, 0.0, 0.0]);
    let z = b.size.z;
    b.lathe(
        "cup",
        [at[0], 0.0, z * 0.66],
        &[(r.min(b.size.x * 0.03), 0.0), (r.min(b.size.x * 0.03), z * 0.06), (0.0, z * 0.065)],
        BLACK_PLASTIC,
    );
    for x in [-0.8, -0.4, 0.0, 0.4] {
        b.slab("line", [x - half, -0.9, 0.1], [x + half, 0.9, mat + 0.03], WHITE_PLASTIC);
    }
    let ball = (z * 0.38).min(0.0213);
    let start = b.p([-0.8, 0.0, mat + 0.03]);
    b.ball("ball", [start[0], 0.0, start[2] + ball], ball, WHITE_PLASTIC);
    b.deck("turf", [-0.2, 0.0, mat + 0.03], (0.5, 0.85));
}

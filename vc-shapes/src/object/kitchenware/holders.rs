//! Kitchen storage: blocks, racks, trays, jars and boxes.

use std::f32::consts::{FRAC_PI_2, TAU};

use vc_graph::portable::Portable;

use super::dishes::KNOB;
use crate::material::*;
use crate::solid::{
    Axis, Build, arch, dims, flat_ring, loft_columns, planar_tube, rounded_by_share, rounded_ring, tub, turn, vessel,
};

/// A slanted wooden block with knives in it.
pub(super) fn knife_block(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let mat = b.choose(&[b.style.wood, BEECH, WALNUT, BLACK_PLASTIC]);
    let (hx, h) = (x / 2.0, z * 0.72);
    // Knives lean back; the block's opening faces forward and up.
    let outline = [(-hx, 0.0), (hx * 0.5, 0.0), (hx * 0.9, h * 0.55), (-hx * 0.4, h), (-hx, h * 0.4)];
    let hy = y / 2.0;
    b.prism("block", Axis::Y, [0.0, -hy, 0.0], &outline, y, mat);
    let handle = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, WALNUT, STEEL]);
    let count = ((y / 0.03) as usize).clamp(3, 6);
    for row in 0..2 {
        // The left half of the back row is free.
        for i in 0..if row == 0 { count } else { count.div_ceil(2) } {
            let at = hy * 0.8 * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
            let k = 0.3 + 0.4 * row as f32;
            let (mx, mz) = (hx * (0.9 - 1.3 * k), h * (0.55 + 0.45 * k));
            let long = (z - mz) * if row == 0 { 0.75 } else { 0.97 };
            let w = (hy * 0.5 / count as f32).min(hx * 0.12);
            let (ux, uz) = ((0.35 * long).min(hx * 0.35), long);
            let points: Vec<_> = [(0.0, 1.0), (1.0, 0.8)]
                .iter()
                .flat_map(|&(k, s)| {
                    let (cx, cz) = (mx + ux * k - ux * 0.1 * (1.0 - k), mz + uz * k - uz * 0.1 * (1.0 - k));
                    [
                        [cx - w * 1.4 * s, at - w, cz],
                        [cx + w * 1.4 * s, at - w, cz],
                        [cx - w * 1.4 * s, at + w, cz],
                        [cx + w * 1.4 * s, at + w, cz],
                    ]
                })
                .collect();
            b.hull("knife", &points, handle);
        }
    }
    let lift = 0.45 * h / (1.3 * hx) * 0.0045;
    b.inside("slot", [-hx * 0.01, hy * 0.45, h * 0.865 + lift], (0.0045, (hy * 0.3).max(0.0045)), z - h);
}

/// A crock or wire basket for spoons and whisks.
pub(super) fn utensil_holder(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[b.style.crockery, STEEL, b.style.wood, WHITE_METAL, BLUE_GLAZE, BLACK_METAL]);
    let shape: [(f32, f32); 4] = b.choose(&[
        [(0.96, 0.0), (1.0, 0.04), (1.0, 0.5), (1.0, 1.0)],
        [(0.8, 0.0), (0.82, 0.03), (0.95, 0.7), (1.0, 1.0)],
        [(0.8, 0.0), (1.0, 0.3), (0.95, 0.7), (0.98, 1.0)],
    ]);
    let r = r - 0.0006;
    vessel(b, "crock", (r, z - (z * 0.02).min(0.001)), &shape, (r * 0.07).min(0.005), mat);
    let band = b.choose(&[mat, STEEL, b.style.wood]);
    flat_ring(b, "rim", (z * 0.94, z), (r * 0.9, r + 0.0005), band);
}

/// A tray with compartments for cutlery.
pub(super) fn cutlery_tray(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BAMBOO, BEECH, BLACK_PLASTIC]);
    let t = (x * 0.015).min(z * 0.15).min(0.008);
    tub(b, "tray", &[(0.0, hx, hy), (z, hx, hy)], 0.08, t, mat);
    // One compartment across the front, the others side by side behind it.
    let cross = hx * b.vary(0.35, 0.5);
    let lanes = b.rng.count(3, 4);
    let high = z * 0.9;
    b.block("wall", [cross - t, -hy + t * 0.5, t * 0.5], [cross, hy - t * 0.5, high], mat);
    b.inside(
        "compartment_1",
        [f32::midpoint(cross, hx - t), 0.0, t],
        (((hx - t - cross) / 2.0 * 0.9).max(1e-4), hy * 0.9 - t),
        z - t,
    );
    let pitch = (y - 2.0 * t) / lanes as f32;
    for i in 0..lanes {
        let at = -hy + t + pitch * i as f32;
        if i > 0 {
            b.block("wall", [-hx + t * 0.5, at - t / 2.0, t * 0.5], [cross - t * 0.5, at + t / 2.0, high * 0.97], mat);
        }
        let name = format!("compartment_{}", i + 2);
        let half = (((cross - 2.0 * t + hx) / 2.0 * 0.94).max(1e-4), (pitch / 2.0 - t).max(1e-4) * 0.95);
        b.inside(&name, [f32::midpoint(-hx + t, cross - t), at + pitch / 2.0, t], half, z - t);
    }
}

/// A wire drying rack for plates over a tray.
pub(super) fn dish_rack(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[STEEL, CHROME, BLACK_METAL, WHITE_METAL]);
    let under = b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLACK_PLASTIC, STEEL]);
    let w = (z * 0.02).min(0.0025);
    let base = (z * 0.12).min(0.02);
    tub(b, "tray", &[(0.0, hx * 0.92, hy * 0.95), (base, hx, hy)], 0.15, base * 0.15, under);
    let floor = base * 1.2;
    let (gx, gy) = (hx * 0.93, hy * 0.93);
    let high = z.min(0.16).max(z * 0.55);
    for side in [-1.0, 1.0] {
        for level in [floor, high - w] {
            b.rod("wire", [side * gx, -gy, level], [side * gx, gy, level], w, mat);
            b.rod("wire", [-gx, side * gy, level], [gx, side * gy, level], w, mat);
        }
        for end in [-1.0, 1.0] {
            b.rod("post", [side * gx, end * gy, base * 0.2], [side * gx, end * gy, z], w * 1.3, mat);
        }
    }
    let count = 13;
    for i in 0..count {
        let at = gy * (2.0 * (i as f32 + 0.5) / count as f32 - 1.0);
        b.block("wire", [-gx, at - w * 0.7, floor - w * 0.7], [gx, at + w * 0.7, floor + w * 0.7], mat);
        // Plate dividers on the back half.
        if at < gy * 0.3 {
            let finger = arch([-gx * 0.45, at, floor], [gx * 0.35, 0.0, 0.0], [0.0, 0.0, (high - floor) * 0.75]);
            for pair in finger.windows(2) {
                b.rod("finger", pair[0], pair[1], w * 0.7, mat);
            }
        }
    }
    b.top("rack", [gx * 0.45, 0.0, floor + w], (gx * 0.4, gy * 0.9));
    b.ledge("plates", [-gx * 0.45, gy * 0.65, floor + w], (gx * 0.4, gy * 0.2), (high - floor) * 0.8);
}

/// A small standing or hanging shelf for spices.
pub(super) fn spice_rack(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[b.style.wood, b.style.cabinet, BAMBOO, BLACK_METAL]);
    let rail = b.choose(&[mat, STEEL, BRASS]);
    let t = (z * 0.05).min(0.012).min(x * 0.12);
    let tiers = ((z / 0.14).round() as usize).clamp(1, 3);
    for side in [-1.0, 1.0] {
        let (y0, y1) = if side < 0.0 { (-hy, -hy + t) } else { (hy - t, hy) };
        b.block("side", [-hx, y0, 0.0], [hx, y1, z], mat);
    }
    b.block("back", [-hx, -hy + t, 0.0], [-hx + t * 0.5, hy - t, z], mat);
    let pitch = z / tiers as f32;
    let room = hy - t;
    for i in 0..tiers {
        let floor = pitch * i as f32 + t;
        b.block("shelf", [-hx + t * 0.5, -room, floor - t], [hx - 0.001, room, floor], mat);
        b.rod(
            "rail",
            [hx - t * 0.4, -room, floor + pitch * 0.25],
            [hx - t * 0.4, room, floor + pitch * 0.25],
            t * 0.3,
            rail,
        );
        let centre = [-t * 0.2, 0.0, floor];
        let half = ((hx - t).max(hx * 0.3) * 0.85, room * 0.97);
        if i + 1 == tiers {
            b.top("top", centre, half);
        }
        let name = format!("shelf_{}", i + 1);
        b.inside(&name, centre, half, (pitch - t).max(0.0) * 0.98);
    }
}

/// Two plates with napkins between them.
pub(super) fn napkin_holder(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[b.style.wood, STEEL, BLACK_METAL, CHROME]);
    let t = (x * 0.06).min(0.006);
    b.rounded_block("base", [-hx, -hy, 0.0], [hx, hy, t], t * 0.4, mat);
    let arched = b.rng.chance(0.5);
    for side in [-1.0, 1.0] {
        let at = side * (hx * 0.8 - t / 2.0) - t / 2.0;
        let outline: Vec<_> = if arched {
            (0..=10)
                .map(|i| {
                    let (s, c) = (std::f32::consts::PI * i as f32 / 10.0).sine_cosine();
                    (hy * 0.97 * c, (z - t) * (0.4 + 0.6 * s))
                })
                .chain([(-hy * 0.97, 0.0), (hy * 0.97, 0.0)])
                .collect()
        } else {
            rounded_by_share((hy * 0.97, (z - t) / 2.0), 0.2).iter().map(|p| (p.0, p.1 + (z - t) / 2.0)).collect()
        };
        b.prism("plate", Axis::X, [at, 0.0, t * 0.9], &outline, t, mat);
    }
    let napkin = b.choose(&[WHITE_PAPER, CREAM_PAPER, RED_CARD, TEAL_CARD]);
    let inner = hx * 0.8 - t;
    b.block("napkins", [-inner, -hy * 0.9, t], [inner * 0.2, hy * 0.9, z * 0.85], napkin);
    b.inside("slot", [inner * 0.6, 0.0, t], ((inner * 0.35).max(1e-4), hy * 0.85), z - t);
}

/// A paper towel holder: a disc with a rod for the roll.
pub(super) fn paper_towel_holder(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let mat = b.choose(&[STEEL, b.style.wood, BLACK_METAL, CHROME, MARBLE]);
    let rod = b.choose(&[STEEL, mat, BLACK_METAL]);
    let base = (z * 0.05).min(0.015);
    turn(b, "base", [0.0; 3], (r, base), &[(0.98, 0.0), (1.0, 0.3), (1.0, 0.8), (0.95, 1.0)], mat);
    b.cylinder("rod", [0.0, 0.0, base * 0.9], r * 0.09, z * 0.93 - base * 0.9, rod);
    turn(b, "knob", [0.0, 0.0, z * 0.92], (r * 0.18, z * 0.08), KNOB, rod);
    b.inside("rod", [0.0, r * 0.55, base], (r * 0.3, r * 0.3), z * 0.8);
}

/// Food boxes of plastic or glass with a lid, one of them a lunch box.
pub(super) fn food_container(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let lunch = b.class == "lunch_box";
    let body = if lunch {
        b.choose(&[BLUE_PLASTIC, PINK_PLASTIC, GREEN_PLASTIC, STEEL, BAMBOO, WHITE_PLASTIC])
    } else {
        b.choose(&[CLEAR_PLASTIC, GLASS, WHITE_PLASTIC, CLEAR_PLASTIC])
    };
    let cap = b.choose(&[RED_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, GREY_PLASTIC, ORANGE_PLASTIC, WHITE_PLASTIC]);
    let round = b.choose(&[0.25, 0.4, 0.15]);
    let t = (hx * 0.04).min(z * 0.06).min(0.002);
    let h = z * 0.86;
    tub(
        b,
        "box",
        &[(0.0, hx * 0.84, hy * 0.88), (h * 0.96, hx * 0.94, hy * 0.95), (h, hx * 0.97, hy * 0.97)],
        round,
        t,
        body,
    );
    let (ix, iy) = (hx * 0.84 - 2.0 * t, hy * 0.88 - 2.0 * t);
    if lunch {
        b.block("divider", [-ix, iy * 0.2 - t, t * 0.5], [ix, iy * 0.2, h * 0.85], cap);
        b.inside("compartment_1", [0.0, -iy * 0.4 - t, t], (ix * 0.88, iy * 0.5), h * 0.8);
        b.inside("compartment_2", [0.0, iy * 0.58, t], (ix * 0.88, iy * 0.3), h * 0.8);
    } else {
        b.inside("inside", [0.0, 0.0, t], (ix * 0.92, iy * 0.92), (h - 2.0 * t).max(0.0));
    }
    b.slide([0.0, 0.0, 1.0], z * 1.2, |b| {
        let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), round);
        loft_columns(
            b,
            "lid",
            &[
                at(h + 0.0003, 0.975),
                at(h + (z - h) * 0.2, 0.985),
                at(z - (z - h) * 0.3, 0.985),
                at(z - (z - h) * 0.3, 0.9),
                at(z, 0.86),
            ],
            cap,
        );
        for side in [-1.0, 1.0] {
            let (x0, x1) = if side < 0.0 { (-hx, -hx * 0.97) } else { (hx * 0.97, hx) };
            b.block("clip", [x0, -hy * 0.3, h * 0.8], [x1, hy * 0.3, z - (z - h) * 0.4], cap);
        }
    });
}

/// Glass jars with a lid: screwed, clipped or of cork.
pub(super) fn jar(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let cookie = b.class == "cookie_jar";
    let canister = b.class == "canister";
    let body = match (cookie, canister) {
        (true, _) => b.choose(&[b.style.crockery, GLASS, BLUE_GLAZE, YELLOW_GLAZE, WHITE_METAL]),
        (_, true) => b.choose(&[STEEL, WHITE_METAL, RED_METAL, b.style.crockery, BLACK_METAL, GREEN_METAL]),
        _ => GLASS,
    };
    let cap = if cookie || canister {
        b.choose(&[body, b.style.wood, CORK, STEEL])
    } else {
        b.choose(&[STEEL, b.style.wood, CORK, GLASS, BRASS, RED_METAL])
    };
    let h = z * b.vary(0.82, 0.88);
    let shape: [(f32, f32); 5] = if canister {
        [(0.97, 0.0), (1.0, 0.02), (1.0, 0.5), (1.0, 0.98), (0.98, 1.0)]
    } else if cookie {
        b.choose(&[
            [(0.7, 0.0), (0.95, 0.25), (1.0, 0.55), (0.9, 0.9), (0.88, 1.0)],
            [(0.95, 0.0), (1.0, 0.05), (1.0, 0.8), (0.85, 0.95), (0.85, 1.0)],
        ])
    } else {
        b.choose(&[
            [(0.93, 0.0), (1.0, 0.04), (1.0, 0.8), (0.84, 0.92), (0.84, 1.0)],
            [(0.85, 0.0), (1.0, 0.2), (0.98, 0.7), (0.8, 0.9), (0.8, 1.0)],
            [(0.95, 0.0), (1.0, 0.03), (1.0, 0.5), (0.98, 0.97), (0.97, 1.0)],
        ])
    };
    let r = r - 0.0022_f32.min(r * 0.1);
    vessel(b, b.class, (r, h), &shape, (r * 0.06).min(0.004), body);
    let rim = (shape[4].0 * r * 1.05).min(r);
    if canister && b.rng.chance(0.6) {
        let k: f32 = 0.5;
        let card = b.choose(&[WHITE_PAPER, CREAM_PAPER, BLACK_CARD]);
        super::super::pack::label::wrap(b, r, (h * 0.3, h * (0.3 + k * 0.7)), (card, BLACK_PLASTIC));
    }
    b.slide([0.0, 0.0, 1.0], z, |b| {
        let top = z - h;
        if cookie {
            turn(
                b,
                "lid",
                [0.0, 0.0, h + 0.0004],
                (rim, top * 0.5),
                &[(1.0, 0.0), (1.0, 0.2), (0.7, 0.7), (0.1, 1.0)],
                cap,
            );
            turn(b, "knob", [0.0, 0.0, h + top * 0.48], (r * 0.2, top * 0.52), KNOB, cap);
        } else {
            turn(
                b,
                "lid",
                [0.0, 0.0, h + 0.0004],
                (rim, top - 0.0004_f32.min(top * 0.5)),
                &[(1.0, 0.0), (1.0, 0.75), (0.93, 1.0)],
                cap,
            );
        }
    });
}

/// A flat biscuit tin, round or rectangular, with a lid in a second colour.
pub(super) fn biscuit_tin(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let round = if (x / y - 1.0).abs() < 0.2 { 1.0 } else { 0.2 };
    let (mat, cap) =
        (b.choose(&[BLUE_METAL, RED_METAL, GREEN_METAL, GOLD]), b.choose(&[BLUE_METAL, RED_METAL, GOLD, WHITE_METAL]));
    let t = (z * 0.03).min(0.0015);
    let h = z * 0.9;
    tub(b, "tin", &[(0.0, hx * 0.97, hy * 0.97), (h, hx * 0.97, hy * 0.97)], round, t, mat);
    let k = if round > 0.5 { 0.64 } else { 0.88 };
    b.inside("inside", [0.0, 0.0, t], (hx * k, hy * k), h * 0.97);
    b.slide([0.0, 0.0, 1.0], z * 1.2, |b| {
        let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * k), round);
        let skirt = [
            at(h + 0.0003, 0.965),
            at(h + 0.0002, 0.975),
            at(z * 0.76, 0.975),
            at(z * 0.76, 1.0),
            at(z * 0.97, 1.0),
            at(z * 0.985, 0.97),
        ];
        loft_columns(b, "lid", &skirt, cap);
        loft_columns(b, "picture", &[at(z * 0.98, 0.6), at(z, 0.58)], mat);
    });
}

/// A bread box with a roll top or a hinged front.
pub(super) fn bread_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (mat, front) = (
        b.choose(&[b.style.wood, BAMBOO, STEEL, WHITE_METAL, b.style.cabinet]),
        b.choose(&[b.style.wood, STEEL, BLACK_METAL, WHITE_METAL]),
    );
    let t = (z * 0.05).min(0.01);
    let knob = (x * 0.06).min(0.018);
    let face = hx - knob;
    // Sides with a slanted front edge; the lid is hinged at the top edge.
    let shelf = -hx * 0.05;
    let side = [(-hx, 0.0), (face, 0.0), (face, z * 0.25), (shelf, z), (-hx, z)];
    for at in [-hy, hy - t] {
        b.prism("side", Axis::Y, [0.0, at, 0.0], &side, t, mat);
    }
    let y0 = hy - t;
    b.block("bottom", [-hx, -y0, 0.0], [face, y0, t], mat);
    b.block("back", [-hx, -y0, t], [-hx + t, y0, z], mat);
    b.block("roof", [-hx + t, -y0, z - t], [shelf, y0, z], mat);
    b.block("sill", [face - t, -y0, t], [face, y0, z * 0.24], mat);
    b.inside("inside", [(-hx + face) / 2.0, 0.0, t], ((face + hx) / 2.0 - t * 1.5, y0 * 0.96), z * 0.22);
    b.top("top", [(-hx + shelf) / 2.0, 0.0, z], ((shelf + hx) / 2.0 * 0.9, hy * 0.92));
    b.hinge([shelf, 0.0, z], [0.0, -1.0, 0.0], 1.6, |b| {
        let lid = [(face, z * 0.25 + 0.001), (shelf + 0.001, z), (shelf + 0.001, z - t), (face - t, z * 0.25 + 0.001)];
        b.prism("lid", Axis::Y, [0.0, -y0 + 0.001, 0.0], &lid, 2.0 * y0 - 0.002, front);
        let (kx, kz) = (face - (face - shelf) * 0.12, z * 0.25 + z * 0.09);
        b.rod("knob", [kx - knob * 0.3, 0.0, kz], [(kx + knob * 0.9).min(hx), 0.0, kz + knob * 0.8], knob * 0.45, mat);
    });
}

/// A woven bread basket with a napkin.
pub(super) fn bread_basket(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let mat = b.choose(&[WICKER, JUTE, BAMBOO, WICKER]);
    let round = b.choose(&[1.0, 0.5, 0.99]);
    let t = (x * 0.02).min(z * 0.1);
    let rows = 6;
    let mut sides = vec![(0.0, hx * 0.78, hy * 0.8)];
    for i in 0..rows {
        let k = 0.8 + 0.18 * i as f32 / rows as f32;
        let (low, high) = (z * (i as f32 + 0.25) / rows as f32, z * (i as f32 + 0.85) / rows as f32);
        sides.extend([(low, hx * k + t * 0.5, hy * k + t * 0.5), (high, hx * k - t * 0.3, hy * k - t * 0.3)]);
    }
    sides.push((z, hx, hy));
    b.visual_only(|b| tub(b, "basket", &sides, round, t, mat));
    b.collision_only(|b| tub(b, "basket", &[sides[0], (z, hx, hy)], round, t, mat));
    let linen = b.style.linen;
    let cloth = |b: &mut Build<'_>, k: f32| {
        let at = |z: f32, grow: f32| rounded_ring(z, (hx * k * grow, hy * k * grow), round);
        loft_columns(b, "napkin", &[at(t * 0.5, 0.9), at(t * 1.5, 0.95)], linen);
    };
    cloth(b, 0.76);
    b.inside("inside", [0.0, 0.0, t * 1.5], (hx * 0.5, hy * 0.5), z - 1.5 * t);
}

/// A cool box with a hinged lid and a bail.
pub(super) fn ice_box(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let (body, cap) =
        (b.choose(&[BLUE_PLASTIC, RED_PLASTIC, GREY_PLASTIC, GREEN_PLASTIC]), b.choose(&[WHITE_PLASTIC, LIGHT_GREY]));
    let t = (x * 0.09).min(0.03);
    let h = z * 0.8;
    tub(b, "box", &[(0.0, hx * 0.9, hy * 0.88), (h, hx * 0.97, hy * 0.92)], 0.2, t, body);
    b.inside("inside", [0.0, 0.0, t], ((hx * 0.9 - t) * 0.93, (hy * 0.88 - t) * 0.95), (h - t - 0.002).max(0.0));
    b.hinge([-hx, 0.0, z], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        let at = |z: f32, k: f32| rounded_ring(z, (hx * k, hy * 0.95 * k), 0.2);
        loft_columns(b, "lid", &[at(h + 0.001, 0.98), at(h + (z - h) * 0.2, 1.0), at(z * 0.97, 1.0), at(z, 0.95)], cap);
        b.top("top", [0.0, 0.0, z], (hx * 0.85, hy * 0.8));
    });
    let w = (hy * 0.03).min(0.01);
    for side in [-1.0_f32, 1.0] {
        let (y0, y1) = (side * (hy * 0.88), side * (hy - w * 0.1));
        b.rounded_block("pivot", [-hx * 0.12, y0.min(y1), h * 0.62], [hx * 0.12, y0.max(y1), h * 0.8], w, cap);
        b.bar("grip", [-hx * 0.4, side * (hy - w), h * 0.7], [hx * 0.4, side * (hy - w), h * 0.7], w, cap);
    }
}

/// Mats and coasters under plates, glasses and pots: of cloth, cork, wood or metal.
pub(super) fn mat(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let (hx, hy) = (x / 2.0, y / 2.0);
    let placemat = b.class == "placemat";
    let colour = if placemat {
        b.choose(&[b.style.accent, b.style.linen, JUTE, BAMBOO, BLACK_LEATHER, CORK])
    } else {
        b.choose(&[CORK, b.style.wood, SLATE_TILE, b.style.accent, MARBLE, BLACK_LEATHER])
    };
    let edge = b.choose(&[colour, b.style.accent, WENGE]);
    let round = if placemat { b.choose(&[0.05, 0.3, 1.0]) } else { b.choose(&[1.0, 1.0, 0.1, 0.3]) };
    let striped = placemat && round < 0.2;
    let low = z * if striped { 0.6 } else { 0.75 };
    b.prism("mat", Axis::Z, [0.0; 3], &rounded_by_share((hx, hy), round), low, edge);
    b.prism(
        "middle",
        Axis::Z,
        [0.0, 0.0, low * 0.5],
        &rounded_by_share((hx * 0.93, hy * 0.93), round),
        (if striped { z * 0.85 } else { z }) - low * 0.5,
        colour,
    );
    b.top("top", [0.0, 0.0, z], (hx * 0.66, hy * 0.66));
    if striped {
        for i in 0..10 {
            let at = hy * 0.86 * (i as f32 / 4.5 - 1.0);
            b.block("stripe", [-hx * 0.9, at - hy * 0.015, low], [hx * 0.9, at + hy * 0.015, z], edge);
        }
    }
}

/// A trivet: a disc of cork, rings or a star of bars.
pub(super) fn trivet(b: &mut Build<'_>) {
    let (x, y, z) = dims(b);
    let r = x.min(y) / 2.0;
    let colour = b.choose(&[IRON, b.style.wood, BAMBOO, STEEL, BLACK_METAL]);
    match b.rng.below(3) {
        0 => {
            turn(b, "disc", [0.0; 3], (r, z), &[(0.97, 0.0), (1.0, 0.2), (1.0, 0.8), (0.97, 1.0)], CORK);
            b.top("top", [0.0, 0.0, z], (r * 0.66, r * 0.66));
            return;
        }
        1 => {
            let (rings, bars) = (b.rng.count(2, 4), b.rng.count(3, 6));
            for i in 0..rings {
                let k = 0.25 + 0.72 * i as f32 / (rings - 1) as f32;
                flat_ring(b, "ring", (z * 0.2, z), (r * (k - 0.1), r * k), colour);
            }
            for i in 0..bars {
                b.at([0.0; 3], TAU * i as f32 / bars as f32, |b| {
                    let top = z * (0.82 + 0.15 * i as f32 / bars as f32);
                    b.block("bar", [0.0, -r * 0.05, 0.0], [r * 0.99, r * 0.05, top], colour)
                });
            }
        }
        _ => {
            let bars = b.rng.count(5, 8);
            for i in 0..bars {
                let at = r * (2.0 * i as f32 / (bars - 1) as f32 - 1.0) * 0.88;
                b.block("bar", [at - r * 0.08, -r, z * 0.4], [at + r * 0.08, r, z], colour);
            }
            for side in [-0.7, 0.7] {
                b.block("foot", [-r, r * (side - 0.1), 0.0], [r, r * (side + 0.1), z * 0.5], colour);
            }
        }
    }
    b.top("top", [0.0, 0.0, z], (r * 0.6, r * 0.6));
}

/// A wire handle over a bucket, rising from two points of its rim.
pub(in crate::object) fn bail(b: &mut Build<'_>, r: f32, (z, top): (f32, f32), w: f32, mat: MaterialId) {
    let path = arch([0.0, 0.0, z], [0.0, r, 0.0], [0.0, 0.0, (top - z - w).max(w)]);
    planar_tube(b, "bail", &path, w, [1.0, 0.0, 0.0], mat);
}

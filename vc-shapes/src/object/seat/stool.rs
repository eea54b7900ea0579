//! Stools, benches and soft seats without a back.

use crate::material::*;
use crate::object::joinery::{Front, Handle};
use crate::object::storage::case::{Case, Cell};
use crate::object::storage::chest::{Chest, chest};
use crate::object::table::frame::{Four, STAR, baluster};
use crate::solid::{Axis, Build, CORNERS, Cut, at_least, disc, leg, ribbon};

/// Half depth, half width, height, and the thickness of legs.
fn measures(b: &mut Build<'_>) -> (f32, f32, f32, f32) {
    at_least(b, [0.12, 0.12, 0.1]);
    let (x, y) = (b.size.x / 2.0, b.size.y / 2.0);
    let r = b.vary(0.09, 0.13) * x.min(y);
    (x, y, b.size.z, r)
}

/// A stool with a round or square seat on three or four legs, or on a column.
pub(super) fn stool(b: &mut Build<'_>) {
    let (x, y, h, r) = measures(b);
    let wood = b.choose(&[b.style.wood, b.style.wood, b.style.cabinet]);
    let cloth = b.style.accent;
    let round = x.max(y) < x.min(y) * 1.12 && b.rng.chance(0.8);
    let soft = b.rng.chance(0.35);
    let t = if soft { h * 0.13 } else { h * 0.07 };
    let mat = if soft { cloth } else { wood };
    let radius = x.min(y);
    let side = if round { radius * 0.7 } else { radius };
    if round {
        disc(b, "seat", [0.0, 0.0, h], radius, t, mat);
        b.top("seat", [0.0, 0.0, h], (side - 0.012, side - 0.012));
    } else {
        b.rounded_block("seat", [-x, -y, h - t], [x, y, h], if soft { 0.02 } else { 0.006 }, mat);
        b.top("seat", [0.0, 0.0, h], (x - 0.022, y - 0.022));
    }
    let (half, under) = (if round { (radius, radius) } else { (x, y) }, h - t + 0.002);
    let metal = b.style.metal;
    match b.rng.below(4) {
        0 if round => {
            // Three legs.
            let reach = radius - r;
            for (dx, dy) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866)] {
                let (foot, head) = ([dx * reach, dy * reach, 0.0], [dx * reach * 0.6, dy * reach * 0.6, under]);
                leg(b, "leg", (foot, r * 0.7), (head, r), Cut::Round, wood);
            }
        }
        1 => {
            let legs = Four::upright((side * 0.95, side * 0.95), under, (0.009, 0.009), Cut::Round);
            legs.build(b, metal);
            for i in 0..4 {
                legs.rung(b, i, (i + 1) % 4, h * 0.3, 0.007, metal);
            }
        }
        2 => {
            let (a, c) = ((half.0 * 0.95, half.1 * 0.95), (side * 0.75, side * 0.75));
            let four = Four {
                feet: if round { (side, side) } else { a },
                heads: c,
                height: under,
                radii: (r * 0.65, r),
                cut: Cut::Round,
            };
            four.build(b, wood);
            for i in 0..4 {
                four.rung(b, i, (i + 1) % 4, h * (0.3 + 0.05 * (i % 2) as f32), r * 0.4, wood);
            }
        }
        _ => {
            let four = Four::upright((side * 0.96, side * 0.96), under, (r * 0.8, r), Cut::Square);
            four.build(b, wood);
            for i in 0..4 {
                four.rung(b, i, (i + 1) % 4, under - h * 0.1, r * 0.5, wood);
            }
        }
    }
}

/// A tall stool with a footrest: on legs, on a column, with a low back or none.
pub(super) fn bar_stool(b: &mut Build<'_>) {
    at_least(b, [0.18, 0.18, 0.3]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let tall = h > 0.84 || b.rng.chance(0.3);
    let seat = if tall { h * 0.76 } else { h };
    let cloth = b.choose(&[b.style.accent, BLACK_LEATHER, TAN_LEATHER, b.style.wood]);
    let (wood, metal) = (b.style.wood, b.choose(&[b.style.metal, CHROME, BLACK_METAL]));
    let column = b.rng.chance(0.4);
    let (t, w) = (0.06_f32.min(seat * 0.1), x.min(y));
    let round = !tall && x.max(y) < w * 1.12 && b.rng.chance(0.6);
    let side = if round { w * 0.7 } else { w * 0.9 };
    if round {
        let at = if column { w * 0.9 } else { w };
        disc(b, "seat", [0.0, 0.0, seat], at, t, cloth);
    } else {
        b.rounded_block("seat", [-x * 0.9, -y * 0.95, seat - t], [x * 0.95, y * 0.95, seat], t * 0.45, cloth);
    }
    b.top("seat", [if tall { 0.02 } else { 0.0 }, 0.0, seat], (side * 0.75, side * 0.85));
    if tall {
        let line = [(-x * 0.86, seat - t * 0.8), (-x * 0.9, seat + (h - seat) * 0.4), (-x + 0.004, h - 0.002)];
        let (thick, wide) = (0.03_f32.min(x * 0.16), y * b.vary(0.7, 0.95));
        let front: Vec<(f32, f32)> = line.iter().rev().map(|p| (p.0 + thick, p.1)).collect();
        let outline: Vec<(f32, f32)> = line.iter().copied().chain(front).collect();
        b.prism("back", Axis::Y, [0.0, -wide, 0.0], &outline, 2.0 * wide, cloth);
    }
    let under = seat - t + 0.002;
    if column {
        let foot = w * 0.98;
        b.lathe("foot", [0.0; 3], &[(foot, 0.0), (foot, 0.01), (foot * 0.6, 0.025), (0.03, 0.045)], metal);
        b.cylinder("column", [0.0, 0.0, 0.02], 0.024, under * 0.6, metal);
        b.cylinder("column", [0.0, 0.0, under * 0.55], 0.016, under * 0.45, CHROME);
        let z = seat * 0.36;
        b.lathe(
            "footrest",
            [0.0, 0.0, z],
            &[(w * 0.7, -0.01), (w * 0.7, 0.01), (w * 0.64, 0.01), (w * 0.64, -0.01), (w * 0.7, -0.01)],
            metal,
        );
        b.rod("spoke", [-w * 0.66, 0.0, z], [w * 0.66, 0.0, z], 0.008, metal);
        return;
    }
    let mat = b.choose(&[wood, wood, metal]);
    let r = if mat == metal { 0.012 } else { w * 0.1 };
    let feet = if round { (w * 0.9, w * 0.9) } else { (x * 0.98, y * 0.98) };
    let four = Four { feet, heads: (side * 0.75, side * 0.75), height: under, radii: (r * 0.7, r), cut: Cut::Round };
    four.build(b, mat);
    for i in 0..4 {
        four.rung(b, i, (i + 1) % 4, seat * (0.32 + 0.08 * (i % 2) as f32), r * 0.55, mat);
    }
}

/// One or two treads for climbing up to a shelf.
pub(super) fn step_stool(b: &mut Build<'_>) {
    let (x, y, h, _) = measures(b);
    let wood = b.choose(&[b.style.wood, WHITE, BEECH]);
    let t = 0.02_f32.min(h * 0.08);
    if h < 0.28 {
        let plastic = b.rng.chance(0.5);
        let mat = if plastic { b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC]) } else { wood };
        let top = (x * 0.86, y * 0.9);
        b.rounded_block("tread", [-top.0, -top.1, h - t], [top.0, top.1, h], 0.006, mat);
        b.top("tread", [0.0, 0.0, h], (top.0 - 0.01, top.1 - 0.01));
        for side in [-1.0, 1.0] {
            let (a, c) = (side * y, side * top.1 * 0.97);
            b.prism(
                "side",
                Axis::X,
                [-x, 0.0, 0.0],
                &[(a, 0.0), (a - side * t, 0.0), (c - side * t, h - t), (c, h - t)],
                2.0 * x,
                mat,
            );
        }
        b.block("apron", [-0.01, -top.1 * 0.97, h * 0.4], [0.01, top.1 * 0.97, h - t], mat);
        return;
    }
    // Two treads between cheeks cut as a stair.
    let (step, middle) = (h * 0.5, x * 0.05);
    for side in [-1.0_f32, 1.0] {
        let outline = [(-x, 0.0), (x, 0.0), (x, step - t), (middle, step - t), (middle, h - t), (-x, h - t)];
        let y0 = (side * (y - 0.012)).min(side * (y - 0.012 - t));
        b.prism("cheek", Axis::Y, [0.0, y0, 0.0], &outline, t, wood);
    }
    b.rounded_block("tread", [-x, -y, h - t], [middle + 0.01, y, h], 0.005, wood);
    b.rounded_block("tread", [middle - 0.02, -y, step - t], [x, y, step], 0.005, wood);
    b.block("back", [-x + 0.004, 0.012 + t - y, h * 0.5], [-x + 0.004 + t, y - 0.012 - t, h - t], wood);
    b.top("tread_2", [f32::midpoint(-x, middle), 0.0, h], ((x + middle) / 2.0 - 0.008, y - 0.01));
    b.top("tread_1", [f32::midpoint(middle + 0.01, x), 0.0, step], ((x - middle - 0.01) / 2.0 - 0.008, y - 0.01));
}

/// A bench of wood or padded, without a back.
pub(super) fn bench(b: &mut Build<'_>) {
    let (x, y, h, _) = measures(b);
    let wood = b.style.wood;
    let r = (x * 0.17).min(0.035);
    let padded = b.rng.chance(0.4);
    let t = if padded { h * 0.2 } else { h * 0.08 };
    let under = h - t + 0.002;
    if padded {
        let cloth = b.choose(&[b.style.upholstery, b.style.accent]);
        b.rounded_block("seat", [-x, -y, h - t], [x, y, h], 0.03, cloth);
        let buttons = (y / 0.16) as usize;
        for i in 0..buttons {
            let cy = y * (2.0 * (i as f32 + 0.5) / buttons as f32 - 1.0);
            b.cylinder("button", [0.0, cy, h - 0.006], 0.01, 0.0065, cloth);
        }
    } else if b.rng.chance(0.35) {
        let count = b.rng.count(3, 5);
        let pitch = 2.0 * x / count as f32;
        for i in 0..count {
            let x0 = -x + pitch * i as f32;
            b.block("slat", [x0, -y, h - t], [x0 + pitch * 0.86, y, h], wood);
        }
        for side in [-1.0_f32, 1.0] {
            let cy = side * y * 0.8;
            b.block("batten", [-x * 0.95, cy - 0.02, h - t - 0.025], [x * 0.85, cy + 0.02, h - t + 0.001], wood);
        }
    } else {
        b.rounded_block("seat", [-x, -y, h - t], [x, y, h], 0.006, wood);
    }
    b.top("seat", [0.0, 0.0, h], (x - 0.015, y - 0.02));
    let metal = b.style.metal;
    match b.rng.below(5) {
        0 => {
            let four = Four {
                feet: (x, y * 0.96),
                heads: (x * 0.8, y * 0.88),
                height: under,
                radii: (r * 0.6, r),
                cut: Cut::Round,
            };
            four.build(b, wood);
            // A beam supports the slats where they leave no board above the legs.
            b.block("beam", [-x * 0.7, r - y * 0.86, under - 0.03], [x * 0.7, y * 0.86 - r, under - 0.012], wood);
        }
        1 => {
            for side in [-1.0_f32, 1.0] {
                let (a, c) = (side * (y - 0.04), side * (y - 0.04 - r));
                b.block("panel", [-x * 0.94, a.min(c), 0.0], [x * 0.94, a.max(c), under], wood);
            }
            b.block("stretcher", [-0.012, 0.045 - y, h * 0.4], [0.012, y - 0.045, h * 0.6], wood);
        }
        2 => {
            for side in [-1.0_f32, 1.0] {
                let cy = side * y * 0.8;
                for (low, high) in [
                    ([-x * 0.95, cy - 0.015, 0.0], [x * 0.95, cy + 0.015, 0.02]),
                    ([-x * 0.95, cy - 0.015, 0.02], [-x * 0.95 + 0.02, cy + 0.015, under]),
                    ([x * 0.95 - 0.02, cy - 0.015, 0.02], [x * 0.95, cy + 0.015, under]),
                ] {
                    b.block("tube", low, high, metal);
                }
                b.block(
                    "tube",
                    [0.02 - x * 0.95, cy - 0.015, under - 0.02],
                    [x * 0.95 - 0.02, cy + 0.015, under - 0.001],
                    metal,
                );
            }
        }
        3 => {
            for (sx, sy) in CORNERS {
                baluster(b, "leg", [sx * (x - r - 0.005), sy * (y - r - 0.02), 0.0], r, under, wood);
            }
            aprons(b, (x - r, y - r - 0.02), under, wood);
        }
        _ => {
            Four::upright((x - 0.005, y - 0.015), under, (r * 0.8, r), Cut::Square).build(b, wood);
            aprons(b, (x - r, y - r - 0.015), under, wood);
        }
    }
}

fn aprons(b: &mut Build<'_>, half: (f32, f32), under: f32, wood: MaterialId) {
    let drop = under * 0.84;
    for side in [-1.0_f32, 1.0] {
        let (cx, cy) = (side * half.0, side * half.1);
        b.block("apron", [cx - 0.01, -half.1, drop], [cx + 0.01, half.1, under], wood);
        b.block("apron", [-half.0, cy - 0.01, drop + 0.001], [half.0, cy + 0.01, under - 0.001], wood);
    }
}

/// A hall bench: a chest with a padded lid, or open compartments below a cushion.
pub(super) fn storage_bench(b: &mut Build<'_>) {
    let (x, y, h, _) = measures(b);
    let body = b.choose(&[b.style.cabinet, b.style.wood]);
    let cloth = b.choose(&[b.style.accent, b.style.upholstery]);
    if b.rng.chance(0.55) {
        chest(b, &Chest { body, lid: cloth, padded: true, feet: b.style.wood });
        return;
    }
    let pad = 0.05_f32.min(h * 0.15);
    let count = (y / 0.2).clamp(1.0, 4.0) as usize;
    let cell = b.choose(&[Cell::Drawers(1), Cell::Drawers(1), Cell::Doors(Front::Flat, 1)]);
    let handle = Handle::Knob;
    let grip = handle.depth();
    let case = Case {
        low: [-x, -y, 0.0],
        high: [x - grip, y, h - pad],
        columns: vec![(1.0, vec![(1.0, cell)]); count],
        handle,
        body,
        front: body,
        lid: body,
        metal: b.style.metal,
    };
    case.build(b);
    b.rounded_block("cushion", [-x + 0.003, -y + 0.003, h - pad], [x - grip - 0.003, y - 0.003, h], 0.02, cloth);
    b.top("seat", [-grip / 2.0, 0.0, h], (x - grip / 2.0 - 0.025, y - 0.025));
}

/// A padded bench at a piano, its legs straight or turned.
pub(super) fn piano_bench(b: &mut Build<'_>) {
    let (x, y, h, _) = measures(b);
    let wood = b.choose(&[BLACK, WHITE, b.style.wood, MAHOGANY, WALNUT]);
    let (pad, box_, r) = (h * 0.11, h * 0.16, (x * 0.14).min(0.026));
    let leather = b.choose(&[BLACK_LEATHER, BROWN_LEATHER, RED_FABRIC]);
    b.rounded_block("seat", [0.012 - x, 0.012 - y, h - pad], [x - 0.012, y - 0.012, h], 0.022, leather);
    b.top("seat", [0.0, 0.0, h], (x - 0.04, y - 0.04));
    b.block("frame", [-x, -y, h - pad - box_ * 0.55], [x, y, h - pad + 0.006], wood);
    let under = h - pad - box_ * 0.5;
    if b.rng.chance(0.4) {
        for (sx, sy) in CORNERS {
            baluster(b, "leg", [sx * (x - r - 0.006), sy * (y - r - 0.006), 0.0], r, under, wood);
        }
    } else {
        Four::upright((x - 0.006, y - 0.006), under, (r * 0.6, r), Cut::Square).build(b, wood);
    }
    for side in [-1.0, 1.0] {
        b.rod(
            "knob",
            [0.0, side * (y - 0.005), h - pad - box_ * 0.2],
            [0.0, side * (y - 0.001), h - pad - box_ * 0.2],
            0.018,
            b.style.metal,
        );
    }
}

/// A padded footstool: square on legs, a drum, or a knitted pouf.
pub(super) fn ottoman(b: &mut Build<'_>) {
    let (x, y, h, r) = measures(b);
    let cloth = b.choose(&[b.style.upholstery, b.style.accent]);
    let radius = x.min(y);
    let round = x.max(y) < radius * 1.1 && b.rng.chance(0.8);
    if round && b.rng.chance(0.5) {
        // A pouf bulges and has seams towards its middle.
        let k = |w: f32, z: f32| (radius * w, h * z);
        b.lathe(
            "pouf",
            [0.0; 3],
            &[k(0.7, 0.0), k(0.93, 0.14), k(1.0, 0.4), k(1.0, 0.6), k(0.93, 0.85), k(0.75, 1.0)],
            cloth,
        );
        for (dx, dy) in STAR {
            let (r, t) = (radius - 0.012, 0.007);
            let line = |w: f32, z: f32| [dx * r * w, dy * r * w, t * 1.5 + (h - 3.0 * t) * z];
            b.pipe("seam", &[line(0.75, 0.0), line(1.0, 0.4), line(1.0, 0.6), line(0.78, 1.0)], t, cloth);
        }
        b.top("seat", [0.0, 0.0, h], (radius * 0.5, radius * 0.5));
        return;
    }
    let wood = b.choose(&[b.style.wood, b.style.metal]);
    let lift = b.vary(0.0, 0.35) * h;
    let lift = if lift < 0.06 { 0.012 } else { lift };
    let (foot, inset) = (r * 0.7, if round { radius * 0.3 } else { 0.02 });
    Four::upright((x - inset, y - inset), lift + 0.01, (foot * 0.7, foot), Cut::Round).build(b, wood);
    if round {
        b.lathe(
            "body",
            [0.0, 0.0, lift],
            &[(radius * 0.97, 0.0), (radius, 0.03), (radius, (h - lift) * 0.8), (radius * 0.9, h - lift)],
            cloth,
        );
        b.top("seat", [0.0, 0.0, h], (radius * 0.62, radius * 0.62));
        return;
    }
    let middle = lift + (h - lift) * 0.45;
    b.rounded_block("body", [-x + 0.006, -y + 0.006, lift], [x - 0.006, y - 0.006, middle + 0.01], 0.015, cloth);
    b.rounded_block("cushion", [-x, -y, middle], [x, y, h], 0.04, cloth);
    b.top("seat", [0.0, 0.0, h], (x - 0.04, y - 0.04));
}

/// A slumping bag: wide at the bottom, with a hollow to sit in, gathered at the top.
pub(super) fn bean_bag(b: &mut Build<'_>) {
    let (x, y, h, _) = measures(b);
    let cloth = b.choose(&[b.style.accent, b.style.upholstery, DENIM, RED_FABRIC, GREY_FABRIC]);
    let r = x.min(y);
    if x.max(y) < r * 1.1 && b.rng.chance(0.7) {
        let k = |w: f32, z: f32| (r * w, h * z);
        let profile = [
            k(0.6, 0.0),
            k(0.9, 0.06),
            k(1.0, 0.22),
            k(0.95, 0.42),
            k(0.74, 0.62),
            k(0.45, 0.8),
            k(0.22, 0.93),
            k(0.14, 1.0),
        ];
        b.lathe("bag", [0.0; 3], &profile, cloth);
        b.cylinder("button", [0.0, 0.0, h * 0.985], r * 0.1, h * 0.014, cloth);
        return;
    }
    let seat = h * 0.5;
    b.rounded_block("bag", [-x, -y, 0.0], [x, y, seat], seat * 0.49, cloth);
    b.rounded_block(
        "back",
        [-x * 0.98, -y * 0.86, seat * 0.3],
        [-x * 0.1, y * 0.86, h],
        (h * 0.3).min(x * 0.42),
        cloth,
    );
    let line = [(x * 0.2, seat * 1.02), (-x * 0.05, seat * 1.08)];
    ribbon(b, "seam", &line, 0.02, (-y * 0.5, y * 0.5), cloth);
}

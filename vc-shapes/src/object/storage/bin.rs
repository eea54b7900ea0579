//! Chests, bins, baskets, and furniture for pets.

use super::chest::{Chest, bin, chest, walls};
use crate::material::*;
use crate::solid::{Axis, Build, CORNERS, at_least, disc, rounded_by_radius};

/// A blanket chest: plain, banded with metal, or with a padded lid.
pub(super) fn trunk(b: &mut Build<'_>) {
    let body = b.choose(&[b.style.wood, b.style.cabinet, BROWN_LEATHER, b.style.wood]);
    let padded = b.rng.chance(0.25);
    let lid = if padded { b.style.accent } else { body };
    chest(b, &Chest { body, lid, padded, feet: b.style.wood });
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    if !padded && b.rng.chance(0.6) {
        let metal = b.choose(&[BRASS, IRON, b.style.metal]);
        for side in [-1.0, 1.0] {
            let cy = side * y * 0.6;
            b.block("band", [x - 0.012, cy - 0.02, 0.021], [x - 0.006, cy + 0.02, h - 0.034], metal);
        }
        b.block("lock", [x - 0.012, -0.025, h - 0.09], [x - 0.002, 0.025, h - 0.034], metal);
    }
}

/// A colourful children's chest.
pub(super) fn toy_box(b: &mut Build<'_>) {
    let body = b.choose(&[WHITE, b.style.wood, SKY, DUSTY_ROSE, YELLOW, SAGE, BIRCH]);
    let lid = b.choose(&[body, RED, BLUE, GREEN, b.style.wood, MUSTARD]);
    chest(b, &Chest { body, lid, padded: false, feet: lid });
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    // Coloured shapes on the front.
    let x0 = x - 0.009;
    let r = (h * 0.14).min(y * 0.16);
    let z = h * 0.48;
    b.rod("dot", [x0, -y * 0.55, z], [x - 0.003, -y * 0.55, z], r, b.style.accent);
    b.block("square", [x0, -r, z - r], [x - 0.003, r, z + r], YELLOW);
    let triangle = [(y * 0.55 - r, z - r), (y * 0.55 + r, z - r), (y * 0.55, z + r)];
    b.prism("triangle", Axis::X, [x0, 0.0, 0.0], &triangle, 0.006, GREEN);
}

/// A round vessel with a wall and a bottom, and the surface inside.
fn vessel(b: &mut Build<'_>, at: f32, radii: (f32, f32), height: f32, wall: f32, mat: MaterialId) {
    let (r0, r1) = radii;
    let profile = [(r0, 0.0), (r1, height), (r1 - wall, height), (r0 - wall, wall * 1.5)];
    b.lathe("bin", [0.0, 0.0, at], &profile, mat);
    let half = (r0.min(r1) - wall) * 0.69;
    b.inside("inside", [0.0, 0.0, at + wall * 1.5], (half, half), (height - wall * 1.5 - 0.006).max(0.01));
}

/// A laundry basket with a lid: woven, of cloth in a frame, or of wood.
pub(super) fn hamper(b: &mut Build<'_>) {
    at_least(b, [0.16, 0.16, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[WICKER, WHITE_PLASTIC, BAMBOO, LINEN, GREY_FABRIC]);
    let lid = 0.025;
    let r = x.min(y);
    let round = x.max(y) < r * 1.1 && b.rng.chance(0.7);
    if round {
        vessel(b, 0.0, (r * 0.88, r * 0.97), h - lid, 0.012, mat);
        for k in [0.25, 0.5, 0.75] {
            let (z, rr) = (h * k, r * (0.88 + 0.09 * k * h / (h - lid)));
            b.lathe(
                "weave",
                [0.0, 0.0, z],
                &[
                    (rr + 0.002, -0.012),
                    (rr + 0.007, 0.0),
                    (rr + 0.002, 0.012),
                    (rr - 0.004, 0.012),
                    (rr - 0.004, -0.012),
                    (rr + 0.002, -0.012),
                ],
                mat,
            );
        }
    } else {
        bin(b, [0.006 - x, 0.006 - y, 0.0], [x - 0.006, y - 0.006, h - lid], 0.012, "inside", mat);
        let slats = (h / 0.08).clamp(3.0, 9.0) as usize;
        for i in 0..slats {
            let z = (h - lid) * (i as f32 + 0.5) / slats as f32;
            b.block("weave", [0.002 - x, 0.002 - y, z - 0.02], [0.008 - x, y - 0.002, z + 0.02], mat);
            b.block("weave", [x - 0.008, 0.002 - y, z - 0.02], [x - 0.002, y - 0.002, z + 0.02], mat);
            for side in [-1.0_f32, 1.0] {
                let (a, c) = (side * (y - 0.002), side * (y - 0.008));
                b.block("weave", [0.009 - x, a.min(c), z - 0.02], [x - 0.009, a.max(c), z + 0.02], mat);
            }
        }
    }
    let back = if round { -r } else { -x };
    b.hinge([back, 0.0, h], [0.0, -1.0, 0.0], 1.5, |b| {
        if round {
            disc(b, "lid", [0.0, 0.0, h], r, lid - 0.002, mat);
        } else {
            b.rounded_block("lid", [-x, -y, h - lid + 0.002], [x, y, h], 0.01, mat);
        }
    });
}

/// A bin with a pedal, a swing lid, a dome or a flat lid. As on all furniture in front of a wall,
/// the lid turns about its upper edge: about the lower one it would swing behind the bin.
pub(super) fn trash_can(b: &mut Build<'_>) {
    at_least(b, [0.12, 0.12, 0.15]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[STEEL, STEEL, WHITE_METAL, BLACK_METAL, GREY_PLASTIC, RED_METAL]);
    let trim = b.choose(&[BLACK_PLASTIC, GREY_PLASTIC]);
    let pedal = b.rng.chance(0.7);
    let reach = if pedal { 0.03 } else { 0.0 };
    let r = (x - reach / 2.0).min(y);
    let round = (x - reach / 2.0).max(y) < r * 1.12 && b.rng.chance(0.8);
    let (base, top) = (0.03, h - 0.045_f32.min(h * 0.2));
    let cx = -reach / 2.0;
    if round {
        b.at([cx, 0.0, 0.0], 0.0, |b| {
            b.lathe("base", [0.0; 3], &[(r, 0.0), (r, base * 0.8), (r * 0.98, base)], trim);
            vessel(b, base - 0.002, (r * 0.97, r * 0.97), top - base, 0.004, mat);
            let dome = h - top - 0.002;
            b.hinge([-0.9 * r, 0.0, top + dome * 0.5], [0.0, -1.0, 0.0], 1.4, |b| {
                b.lathe(
                    "lid",
                    [0.0, 0.0, top + 0.001],
                    &[(r, 0.0), (r, dome * 0.3), (r * 0.8, dome * 0.75), (r * 0.4, dome)],
                    trim,
                );
            });
        });
    } else {
        let (x0, x1) = (-x, x - reach);
        b.block("base", [x0 + 0.001, 0.001 - y, 0.0], [x1 - 0.001, y - 0.001, base], trim);
        bin(b, [x0 + 0.004, 0.004 - y, base - 0.002], [x1 - 0.004, y - 0.004, top], 0.005, "inside", mat);
        b.hinge([x0, 0.0, h], [0.0, -1.0, 0.0], 1.4, |b| {
            b.rounded_block("lid", [x0, -y, top + 0.002], [x1, y, h], 0.014, trim);
        });
    }
    if pedal {
        b.rounded_block("pedal", [cx, -0.04, 0.008], [x, 0.04, 0.02], 0.004, b.style.metal);
    }
}

/// An open wastepaper basket of wire, wickerwork or sheet metal.
pub(super) fn wastebasket(b: &mut Build<'_>) {
    at_least(b, [0.11, 0.11, 0.12]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = x.min(y);
    let mat = b.choose(&[BLACK_METAL, WICKER, WHITE_PLASTIC, b.style.metal, GREY_PLASTIC, b.style.accent]);
    if x.max(y) > r * 1.1 || b.rng.chance(0.3) {
        bin(b, [-x, -y, 0.0], [x, y, h], 0.006, "inside", mat);
        return;
    }
    let foot = r * b.vary(0.72, 0.9);
    vessel(b, 0.0, (foot, r * 0.985), h, 0.005, mat);
    let bead = 0.006;
    b.lathe(
        "rim",
        [0.0, 0.0, h - bead],
        &[(r * 0.98, -bead), (r, 0.0), (r * 0.98, bead), (r * 0.96, bead), (r * 0.96, -bead), (r * 0.98, -bead)],
        mat,
    );
}

/// Bins for paper, glass and plastic side by side, or one with a flap.
pub(super) fn recycling_bin(b: &mut Build<'_>) {
    at_least(b, [0.14, 0.15, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let count = (y / 0.12).clamp(1.0, 3.0) as usize;
    let body = b.choose(&[GREY_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC]);
    let colours = [BLUE_PLASTIC, YELLOW_PLASTIC, GREEN_PLASTIC];
    let (wide, lid) = (2.0 * y / count as f32, 0.05_f32.min(h * 0.15));
    let first = b.rng.below(3);
    for i in 0..count {
        let (y0, y1) = (wide * i as f32 - y, wide * (i + 1) as f32 - y - 0.004);
        let colour = colours[(first + i) % 3];
        let top = h - lid;
        bin(
            b,
            [0.006 - x, y0 + 0.005, 0.0],
            [x - 0.006, y1 - 0.005, top],
            0.006,
            &format!("compartment_{}", i + 1),
            body,
        );
        let middle = f32::midpoint(y0, y1);
        b.block(
            "sign",
            [x - 0.0065, middle - wide * 0.2, h * 0.4],
            [x - 0.003, middle + wide * 0.2, h * 0.4 + wide * 0.4],
            colour,
        );
        b.hinge([-x, 0.0, h], [0.0, -1.0, 0.0], 1.4, |b| {
            b.rounded_block("lid", [-x, y0, top + 0.002], [x, y1, h], 0.012, colour);
            b.block("grip", [x - 0.03, middle - 0.04, h - 0.003], [x - 0.01, middle + 0.04, h - 0.0005], body);
        });
    }
}

/// A tube or a square frame that umbrellas stand in.
pub(super) fn umbrella_stand(b: &mut Build<'_>) {
    at_least(b, [0.1, 0.1, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let r = x.min(y);
    let metal = b.choose(&[BLACK_METAL, BRASS, b.style.metal, COPPER]);
    if x.max(y) < r * 1.12 && b.rng.chance(0.75) {
        let mat = b.choose(&[BLUE_GLAZE, PORCELAIN, metal, WICKER, GREEN_GLAZE]);
        let foot = r * b.vary(0.85, 0.97);
        vessel(b, 0.0, (foot, r * 0.985), h, 0.008, mat);
        b.lathe(
            "rim",
            [0.0, 0.0, h - 0.012],
            &[(r * 0.97, 0.0), (r, 0.004), (r, 0.01), (r * 0.94, 0.0115), (r * 0.94, 0.0), (r * 0.97, 0.0)],
            mat,
        );
        return;
    }
    let t = 0.006;
    walls(b, [-x, -y, 0.0], [x, y, h * 0.12], t, metal);
    b.inside("inside", [0.0, 0.0, t], (x - 2.0 * t - 0.003, y - 2.0 * t - 0.003), h * 0.48);
    for (sx, sy) in CORNERS {
        let (cx, cy) = (sx * (x - t), sy * (y - t));
        b.block("post", [cx - t * 0.9, cy - t * 0.9, 0.01], [cx + t * 0.9, cy + t * 0.9, h], metal);
    }
    for z in [h * 0.5, h - 2.0 * t - 0.001] {
        for side in [-1.0, 1.0] {
            let (cx, cy) = (side * (x - t), side * (y - t));
            b.block("rail", [cx - t * 0.7, 2.0 * t - y, z], [cx + t * 0.7, y - 2.0 * t, z + t * 1.6], metal);
            b.block("rail", [2.0 * t - x, cy - t * 0.7, z + 0.001], [x - 2.0 * t, cy + t * 0.7, z + t * 1.5], metal);
        }
    }
    b.block("rail", [-t * 0.5, 2.0 * t - y, h - t * 1.5], [t * 0.5, y - 2.0 * t, h - t * 0.6], metal);
}

/// A litter tray, open or under a hood with a door.
pub(super) fn litter_box(b: &mut Build<'_>) {
    at_least(b, [0.18, 0.2, 0.065]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, hood) = (
        b.choose(&[GREY_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC]),
        b.choose(&[WHITE_PLASTIC, GREY_PLASTIC, PINK_PLASTIC]),
    );
    let covered = h > 0.28;
    let tray = if covered { h * 0.36 } else { h };
    let t = 0.008;
    walls(b, [0.006 - x, 0.006 - y, 0.0], [x - 0.006, y - 0.006, tray - 0.006], t, mat);
    b.block("litter", [t + 0.007 - x, t + 0.007 - y, t], [x - t - 0.007, y - t - 0.007, t + tray * 0.22], GRAVEL);
    b.inside(
        "litter",
        [0.0, 0.0, t + tray * 0.22],
        (x - t - 0.02, y - t - 0.02),
        if covered { h - tray } else { tray * 0.6 },
    );
    for (low, high) in [
        ([-x, -y, tray - 0.012], [x, 0.012 - y, tray]),
        ([-x, y - 0.012, tray - 0.012], [x, y, tray]),
        ([-x, 0.012 - y, tray - 0.012], [0.012 - x, y - 0.012, tray]),
        ([x - 0.012, 0.012 - y, tray - 0.012], [x, y - 0.012, tray]),
    ] {
        b.block("rim", low, high, mat);
    }
    if covered {
        let (x0, y0, z0) = (x - 0.012, y - 0.012, tray - 0.002);
        b.block("hood", [-x0, -y0, z0], [-x0 + t, y0, h - t], hood);
        for side in [-1.0_f32, 1.0] {
            let (a, c) = (side * y0, side * (y0 - t));
            b.block("hood", [-x0 + t, a.min(c), z0], [x0 - t, a.max(c), h - t], hood);
            let (a, c) = (side * y0, side * y0 * 0.5);
            b.block("hood", [x0 - t, a.min(c), z0], [x0, a.max(c), h - t], hood);
        }
        b.block("hood", [x0 - t, -y0 * 0.5, h - 0.06_f32.min(h * 0.2)], [x0, y0 * 0.5, h - t], hood);
        b.rounded_block("hood", [-x0, -y0, h - t - 0.001], [x0, y0, h - 0.001], 0.003, hood);
        b.hinge([x0 - t / 2.0, 0.0, h - 0.06_f32.min(h * 0.2)], [0.0, -1.0, 0.0], 1.2, |b| {
            let (w, top) = (y0 * 0.49, h - 0.062_f32.min(h * 0.205));
            b.block("flap", [x0 - t * 0.7, -w, tray + 0.006], [x0 - t * 0.3, w, top], CLEAR_PLASTIC);
        });
        let z = h - 0.004;
        b.pipe("handle", &[[0.0, -0.06, z - 0.004], [0.0, 0.06, z - 0.004]], 0.004, mat);
    }
}

/// A cushion within a soft rim that is lower in front.
pub(super) fn pet_bed(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.25, 0.07]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (cloth, inner) = (
        b.choose(&[b.style.accent, GREY_FABRIC, BROWN_FABRIC, DENIM, WICKER]),
        b.choose(&[WOOL, WHITE_COTTON, BEIGE_FABRIC]),
    );
    let w = (x * 0.3).min(0.13).min(h * 0.7);
    let r = x.min(y);
    let cushion = h * 0.45;
    if x.max(y) < r * 1.12 && b.rng.chance(0.8) {
        // A ring with a flat inside.
        let k = |d: f32, z: f32| (r - w * d, h * z);
        b.lathe(
            "rim",
            [0.0; 3],
            &[k(0.3, 0.0), k(0.0, 0.3), k(0.0, 0.65), k(0.3, 1.0), k(0.7, 1.0), k(1.0, 0.6), k(1.0, 0.02)],
            cloth,
        );
        disc(b, "cushion", [0.0, 0.0, cushion], r - w + 0.004, cushion - 0.004, inner);
        let free = (r - w) * 0.68;
        b.top("cushion", [0.0, 0.0, cushion], (free, free));
        return;
    }
    let radius = w * 0.48;
    b.prism("base", Axis::Z, [0.0; 3], &rounded_by_radius((x * 0.97, y * 0.97), w), 0.02, cloth);
    b.rounded_block("rim", [-x, -y, 0.004], [w - x, y, h], radius, cloth);
    for side in [-1.0_f32, 1.0] {
        let (a, c) = (side * y, side * (y - w));
        b.rounded_block("rim", [-x, a.min(c), 0.005], [x, a.max(c), h * 0.97], radius, cloth);
    }
    b.rounded_block("rim", [x - w, w * 0.5 - y, 0.006], [x, y - w * 0.5, h * 0.62], radius, cloth);
    b.rounded_block("cushion", [w * 0.8 - x, w * 0.8 - y, 0.018], [x - w * 0.8, y - w * 0.8, cushion], 0.03, inner);
    b.top("cushion", [0.0, 0.0, cushion], (x - w - 0.02, y - w - 0.02));
}

/// A rope-wound post on a base; tall ones have perches and a box.
pub(super) fn scratching_post(b: &mut Build<'_>) {
    at_least(b, [0.17, 0.17, 0.28]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let cloth = b.choose(&[BEIGE_FABRIC, GREY_FABRIC, WOOL, BROWN_FABRIC]);
    let (t, r) = (0.03, 0.045_f32.min(x * 0.22));
    b.rounded_block("base", [-x, -y, 0.0], [x, y, t], 0.008, cloth);
    let rope = |b: &mut Build<'_>, at: [f32; 2], z: (f32, f32)| {
        b.cylinder("post", [at[0], at[1], z.0 - 0.002], r, z.1 - z.0 + 0.004, JUTE);
    };
    if h < 0.85 {
        rope(b, [0.0, 0.0], (t, h - 0.04));
        disc(b, "perch", [0.0, 0.0, h], x.min(y) * 0.75, 0.042, cloth);
        b.top("perch", [0.0, 0.0, h], (x.min(y) * 0.5, x.min(y) * 0.5));
        b.ball("toy", [x.min(y) * 0.62, 0.0, h * 0.72], 0.022, b.style.accent);
        b.rod("string", [x.min(y) * 0.62, 0.0, h * 0.72], [x.min(y) * 0.62, 0.0, h - 0.03], 0.002, LINEN);
        return;
    }
    // The perches spiral around a post; a box to sleep in stands halfway up.
    let spots = [[-x * 0.55, -y * 0.55], [x * 0.4, y * 0.5], [-x * 0.5, y * 0.5]];
    let levels = [h * 0.36, h * 0.66, h];
    let posts = [(0, t, h - t), (1, t, levels[1] - t), (2, t, levels[0] - 0.02)];
    for (i, from, to) in posts {
        rope(b, spots[i], (from, to));
    }
    let (bx, by) = (x * 0.98, y * 0.98);
    b.rounded_block("perch_1", [-bx, -by * 0.25, levels[0] - t], [bx, by, levels[0]], 0.01, cloth);
    b.top("perch_1", [-bx * 0.45, by * 0.45, levels[0]], (bx * 0.3, by * 0.45));
    b.rounded_block("perch_2", [-bx * 0.08, -by * 0.1, levels[1] - t], [bx, by, levels[1]], 0.01, cloth);
    b.top("perch_2", [bx * 0.45, by * 0.45, levels[1]], (bx * 0.5, by * 0.5));
    let (cx, cy, w) = (spots[0][0], spots[0][1], (x * 0.45).min(y * 0.45));
    b.rounded_block("perch_3", [cx - w, cy - w, h - t], [cx + w, cy + w, h], 0.012, cloth);
    b.top("perch_3", [cx, cy, h], (w - 0.02, w - 0.02));
}

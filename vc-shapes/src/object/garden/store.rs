//! Boxes, composters and barrels of the garden.

use std::f32::consts::{FRAC_PI_2, TAU};

use crate::material::*;
use crate::solid::{Build, CORNERS, at_least, polar, spaced, tapered_tub};

/// A box for cushions and toys with a lid hinged at the back.
pub(super) fn storage_box(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.4, 0.22]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let mat = b.choose(&[GREY_PLASTIC, BROWN_PLASTIC, BLACK_PLASTIC, WICKER, TEAK, PINE, GREY_OAK]);
    let (lid, t) = (h * b.vary(0.06, 0.12), 0.02);
    let rim = h - lid;
    let lean = b.vary(0.92, 0.97);
    tapered_tub(b, "box", [0.0, 0.0, 0.0], (x * lean, y * 0.97), (x - 0.012, y - 0.012), rim - 0.002, t, mat);
    let ribs = b.rng.count(0, 7);
    for cy in spaced(ribs, -y * 0.85, y * 0.85) {
        b.block("rib", [x * 0.9, cy - 0.02, 0.03], [x - 0.004, cy + 0.02, rim - 0.03], mat);
    }
    b.hinge([-x, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.rounded_block("lid", [-x, -y, rim], [x, y, h], 0.015, mat);
        b.top("lid", [0.0, 0.0, h], (x - 0.03, y - 0.03));
    });
    for side in [-1.0, 1.0] {
        b.block(
            "handle",
            [-0.08, side * (y - 0.012) - 0.011, rim * 0.7],
            [0.08, side * (y - 0.012) + 0.011, rim * 0.76],
            mat,
        );
    }
    b.inside("compartment", [0.0, 0.0, t], (x * 0.92 - t - 0.01, y * 0.97 - t - 0.01), rim - t - 0.01);
}

/// A composter: slatted wood, or tapered plastic with a lid.
pub(super) fn composter(b: &mut Build<'_>) {
    at_least(b, [0.3, 0.3, 0.4]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    if b.rng.chance(0.5) {
        let mat = b.choose(&[PINE, OAK, GREY_OAK, TEAK]);
        let post = 0.025;
        for (sx, sy) in CORNERS {
            let (cx, cy) = (sx * (x - post - 0.015), sy * (y - post - 0.015));
            b.block("post", [cx - post, cy - post, 0.0], [cx + post, cy + post, h - 0.035], mat);
        }
        let rows = b.rng.count(5, 8);
        let pitch = (h - 0.06) / rows as f32;
        for z in spaced(rows, pitch * 0.5 + 0.02, h - 0.04 - pitch * 0.5) {
            let half = pitch * 0.36;
            for side in [-1.0, 1.0] {
                b.block(
                    "slat",
                    [side * (x - 0.009) - 0.009, -y + 0.002, z - half],
                    [side * (x - 0.009) + 0.009, y - 0.002, z + half],
                    mat,
                );
                b.block(
                    "slat",
                    [-x + 0.018, side * (y - 0.009) - 0.009, z - half],
                    [x - 0.018, side * (y - 0.009) + 0.009, z + half],
                    mat,
                );
            }
        }
        b.hinge([-x, 0.0, h - 0.034], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.block("lid", [-x, -y, h - 0.034], [x, y, h - 0.012], mat);
            b.block("handle", [x * 0.7, -0.08, h - 0.014], [x * 0.76, 0.08, h], mat);
        });
        let soil = h * 0.3;
        b.block("compost", [-x + 0.02, -y + 0.02, 0.0], [x - 0.02, y - 0.02, soil], SOIL);
        b.inside("compartment", [0.0, 0.0, soil], (x - 0.09, y - 0.09), h - 0.05 - soil);
    } else {
        let mat = b.choose(&[GREEN_PLASTIC, BLACK_PLASTIC, FOREST, BROWN_PLASTIC]);
        let lid = h * b.vary(0.08, 0.14);
        let rim = h - lid;
        let small = b.vary(0.68, 0.82);
        tapered_tub(b, "bin", [0.0; 3], (x - 0.004, y), (x * small, y * small), rim, 0.012, mat);
        for z in spaced(4, rim * 0.25, rim * 0.85) {
            let share = 1.0 - (1.0 - small) * z / rim;
            for side in [-1.0, 1.0] {
                b.block(
                    "rib",
                    [-x * share * 0.8, side * y * share - 0.006, z],
                    [x * share * 0.8, side * y * share + 0.003, z + 0.02],
                    mat,
                );
            }
        }
        b.hinge([-x * small, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
            b.taper(
                "lid",
                [0.0, 0.0, rim + 0.001],
                (x * small * 1.02, y * small * 1.02),
                (x * small * 0.6, y * small * 0.6),
                lid - 0.02,
                mat,
            );
            b.rounded_block("knob", [-0.04, -0.06, h - 0.022], [0.04, 0.06, h], 0.01, mat);
        });
        b.block("hatch", [x * 0.9, -y * 0.45, 0.03], [x, y * 0.45, rim * 0.1], GREY_PLASTIC);
        b.inside("compartment", [0.0, 0.0, 0.012], (x * small - 0.02, y * small - 0.02), rim - 0.03);
    }
}

/// A rain barrel with a tap and a lid.
pub(super) fn rain_barrel(b: &mut Build<'_>) {
    at_least(b, [0.2, 0.2, 0.35]);
    let (r, h) = (b.size.x.min(b.size.y) / 2.0 - 0.03, b.size.z);
    let mat = b.choose(&[GREEN_PLASTIC, BLUE_PLASTIC, GREY_PLASTIC, OAK, BROWN_PLASTIC, POTTERY]);
    let (stand, lid) = (if b.rng.chance(0.5) { h * 0.15 } else { 0.0 }, 0.025);
    let rim = h - lid;
    let waist = b.vary(0.8, 0.95);
    let inner = r * waist - 0.012;
    let profile = [
        (r * waist, stand),
        (r, stand + (rim - stand) * 0.4),
        (r, stand + (rim - stand) * 0.6),
        (r * waist, rim),
        (inner, rim),
        (inner, stand + 0.02),
        (0.0, stand + 0.02),
    ];
    b.lathe("barrel", [0.0; 3], &profile, mat);
    for share in [0.14, 0.86] {
        let z = stand + (rim - stand) * share;
        let out = r * (waist + (1.0 - waist) * 0.36) + 0.004;
        b.lathe(
            "hoop",
            [0.0, 0.0, z - 0.02],
            &[(out, 0.0), (out, 0.04), (out - 0.02, 0.04), (out - 0.02, 0.0), (out, 0.0)],
            if mat == OAK { IRON } else { mat },
        );
    }
    if stand > 0.0 {
        for i in 0..4 {
            let (px, py) = polar(TAU * i as f32 / 4.0 + 0.78, r * waist * 0.75);
            b.block("foot", [px - 0.05, py - 0.05, 0.0], [px + 0.05, py + 0.05, stand + 0.003], CONCRETE);
        }
    }
    let z = stand + (rim - stand) * 0.18;
    b.rod("tap", [r * waist * 0.9, 0.0, z], [r + 0.025, 0.0, z], 0.014, BRASS);
    b.cylinder("tap", [r + 0.015, 0.0, z - 0.04], 0.01, 0.04, BRASS);
    b.block("tap", [r + 0.005, -0.025, z + 0.012], [r + 0.02, 0.025, z + 0.022], RED_PLASTIC);
    b.hinge([-r * waist, 0.0, rim], [0.0, -1.0, 0.0], FRAC_PI_2, |b| {
        b.lathe(
            "lid",
            [0.0, 0.0, rim],
            &[(r * waist + 0.012, 0.0), (r * waist + 0.012, lid * 0.5), (r * 0.2, lid)],
            mat,
        );
    });
    b.inside("water", [0.0, 0.0, stand + 0.02], (inner * 0.68, inner * 0.68), rim - stand - 0.03);
}

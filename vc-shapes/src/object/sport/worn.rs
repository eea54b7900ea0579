//! Worn and carried gear.

use crate::material::*;
use crate::object::palette::*;
use crate::solid::{Axis, Build, Proportional, SIDES, arc_outline};

/// A boot standing on a sole at height `sole`, toe to the front.
pub(in crate::object) fn boot(b: &mut Build<'_>, sole: f32, mat: MaterialId, trim: MaterialId) {
    let ring = |x: f32, y: f32, low: f32, high: f32| ([x, 0.0, (low + high) / 2.0], y, (high - low) / 2.0);
    let foot = [
        ([-0.98, 0.0, sole + 0.12], 0.0, 0.0),
        ring(-0.85, 0.7, sole, sole + 0.3),
        ring(-0.3, 0.8, sole, sole + 0.38),
        ring(0.3, 0.95, sole, sole + 0.3),
        ring(0.75, 0.9, sole, sole + 0.24),
        ([0.99, 0.0, sole + 0.08], 0.0, 0.0),
    ];
    b.skin("boot", Axis::X, &foot, mat);
    let shaft =
        [([-0.38, 0.0, sole + 0.16], 0.5, 0.7), ([-0.42, 0.0, sole + 0.4], 0.46, 0.66), ([-0.42, 0.0, 0.99], 0.5, 0.8)];
    b.skin("shaft", Axis::Z, &shaft, mat);
    b.slab("sole", [-0.9, -0.6, sole - 0.02], [0.9, 0.6, sole + 0.05], trim);
    for i in 0..3 {
        let (x, z) = (0.12 - 0.1 * i as f32, sole + 0.3 + 0.14 * i as f32);
        b.slab("buckle", [x - 0.2, -0.5, z], [x, 0.5, z + 0.05], trim);
    }
}

/// A leather mitt standing on its wrist, palm to the front.
pub(super) fn baseball_glove(b: &mut Build<'_>) {
    let (hide, lace) =
        (b.choose(&[TAN_LEATHER, BROWN_LEATHER, BLACK_LEATHER]), b.choose(&[WHITE_LEATHER, BROWN_LEATHER]));
    b.ellipsoid("palm", [-0.2, 0.0, 0.38], [0.75, 0.78, 0.36], hide);
    b.ellipsoid("pocket", [0.42, 0.05, 0.42], [0.3, 0.45, 0.2], lace);
    b.slab("wrist", [-0.7, -0.5, 0.0], [0.3, 0.5, 0.14], hide);
    for (i, y) in [-0.62, -0.28, 0.06, 0.38].into_iter().enumerate() {
        let tip = [0.86, 0.95, 0.98, 0.92][i];
        let finger = [
            ([-0.3, y * 0.8, 0.45], 0.3, 0.2),
            ([-0.1, y, 0.72], 0.28, 0.18),
            ([0.15, y * 1.1, tip - 0.05], 0.2, 0.14),
            ([0.2, y * 1.1, tip], 0.0, 0.0),
        ];
        b.skin("finger", Axis::Z, &finger, hide);
    }
    let thumb = [
        ([0.1, 0.5, 0.25], 0.4, 0.3),
        ([0.4, 0.76, 0.5], 0.35, 0.2),
        ([0.75, 0.82, 0.76], 0.2, 0.14),
        ([0.8, 0.82, 0.82], 0.0, 0.0),
    ];
    b.skin("thumb", Axis::Z, &thumb, hide);
    b.slab("web", [0.2, 0.36, 0.55], [0.36, 0.78, 0.84], lace);
    for z in [0.6, 0.7, 0.8] {
        b.slab("lace", [0.16, 0.3, z - 0.012], [0.42, 0.84, z + 0.012], hide);
    }
}

/// A pair of ankle weights with straps across.
pub(super) fn ankle_weights(b: &mut Build<'_>) {
    let (cloth, strap) = (b.one_of(CLOTHS), BLACK_FABRIC);
    for y in SIDES {
        let (low, high) = (y * 0.52 - 0.44, y * 0.52 + 0.44);
        for i in 0..5 {
            let z = 0.005 + 0.197 * i as f32;
            b.pad("pouch", [-0.9, low, z], [0.5, high, z + 0.185], 0.012, cloth);
        }
        b.slab("back", [-0.98, low + 0.02, 0.0], [-0.6, high - 0.02, 1.0], strap);
        b.slab("strap", [0.3, y * 0.52 - 0.12, 0.03], [0.7, y * 0.52 + 0.12, 0.97], strap);
        b.slab("buckle", [0.6, y * 0.52 - 0.18, 0.42], [0.98, y * 0.52 + 0.18, 0.54], GREY_PLASTIC);
    }
}

/// A pair of boxing gloves side by side.
pub(super) fn boxing_gloves(b: &mut Build<'_>) {
    let (hide, cuff) =
        (b.choose(&[RED, BLACK_LEATHER, BLUE, WHITE_LEATHER]), b.choose(&[WHITE_LEATHER, BLACK_LEATHER]));
    for y in SIDES {
        let at = y * 0.52;
        b.ellipsoid("fist", [0.1, at, 0.72], [0.88, 0.42, 0.28], hide);
        b.ellipsoid("palm", [0.0, at, 0.5], [0.68, 0.4, 0.24], hide);
        let thumb = [
            ([-0.1, at - y * 0.36, 0.4], 0.2, 0.08),
            ([0.3, at - y * 0.4, 0.55], 0.28, 0.1),
            ([0.5, at - y * 0.38, 0.72], 0.0, 0.0),
        ];
        b.skin("thumb", Axis::Z, &thumb, hide);
        let ring = |z: f32, s: f32| ([-0.05, at, z], 0.62 * s, 0.38 * s);
        b.skin("cuff", Axis::Z, &[ring(0.0, 1.0), ring(0.3, 0.9), ring(0.36, 0.86)], cuff);
        b.skin("strap", Axis::Z, &[ring(0.14, 1.02), ring(0.24, 0.99)], hide);
        b.ellipsoid("lace", [0.55, at, 0.08], [0.1, 0.14, 0.05], WHITE_COTTON);
    }
}

/// A helmet: an elongated one with vents, or a round skater's one; straps at the bottom.
pub(super) fn helmet(b: &mut Build<'_>) {
    let (shell, trim) = (
        b.choose(&[RED_PLASTIC, BLUE_PLASTIC, WHITE_PLASTIC, BLACK_PLASTIC, GREEN_PLASTIC, PINK_PLASTIC]),
        b.choose(&[BLACK_PLASTIC, GREY_PLASTIC]),
    );
    let round = b.rng.chance(0.35);
    let base = 0.2;
    let ring = |z: f32, s: f32, x: f32| ([x, 0.0, z], s * 0.98, s * 0.98);
    let tail = if round { 0.0 } else { -0.02 };
    let dome = [
        ring(base, 0.94, 0.0),
        ring(base + 0.14, 1.0, 0.0),
        ring(0.58, 0.93, tail),
        ring(0.78, 0.74, tail),
        ring(0.92, 0.48, tail),
        ring(0.985, 0.2, tail),
        ([tail, 0.0, 1.0], 0.0, 0.0),
    ];
    b.skin("shell", Axis::Z, &dome, shell);
    b.skin("rim", Axis::Z, &[ring(base - 0.03, 0.88, 0.0), ring(base + 0.05, 0.99, 0.0)], trim);
    if round {
        for (x, y) in [(0.45, 0.3), (0.45, -0.3), (-0.45, 0.3), (-0.45, -0.3)] {
            let at = b.p([x, y, 0.86]);
            b.ball("vent", at, b.size.z * 0.06, BLACK_PLASTIC);
        }
    } else {
        for (y, half) in [(-0.5, 0.38), (-0.17, 0.5), (0.17, 0.5), (0.5, 0.38)] {
            for x in [-0.48, 0.42] {
                let z = 0.93 - 0.28 * y * y - 0.12 * x * x * 2.0;
                let rib = [
                    ([x - half * 0.62, y, z - 0.1], 0.0, 0.0),
                    ([x - half * 0.2, y, z - 0.01], 0.07, 0.07),
                    ([x + half * 0.2, y, z - 0.01], 0.07, 0.07),
                    ([x + half * 0.62, y, z - 0.1], 0.0, 0.0),
                ];
                b.skin("vent", Axis::X, &rib, BLACK_PLASTIC);
            }
        }
        b.chunk(
            "visor",
            &[
                [0.7, 0.6, base + 0.08],
                [0.7, -0.6, base + 0.08],
                [0.98, 0.3, base + 0.12],
                [0.98, -0.3, base + 0.12],
                [0.7, 0.6, base + 0.14],
                [0.7, -0.6, base + 0.14],
            ],
            trim,
        );
    }
    for y in SIDES {
        b.plank("strap", [0.35, y * 0.8, base + 0.02], [0.1, y * 0.3, 0.015], (0.012, 0.003), BLACK_FABRIC);
        b.plank("strap", [-0.35, y * 0.8, base + 0.02], [0.05, y * 0.3, 0.015], (0.012, 0.003), BLACK_FABRIC);
    }
    b.slab("buckle", [0.0, -0.34, 0.0], [0.14, 0.34, 0.03], GREY_PLASTIC);
}

/// A pair of knee pads with caps to the front.
pub(super) fn knee_pads(b: &mut Build<'_>) {
    let (cap, cloth) = (b.one_of(BRIGHT), BLACK_FABRIC);
    for y in SIDES {
        let at = y * 0.52;
        let ring = |z: f32, s: f32| ([-0.3, at, z], 0.68 * s, 0.46 * s);
        b.skin("sleeve", Axis::Z, &[ring(0.0, 0.92), ring(0.5, 1.0), ring(1.0, 1.0)], cloth);
        b.ellipsoid("cap", [0.3, at, 0.5], [0.66, 0.38, 0.3], cap);
        for z in [0.14, 0.86] {
            b.skin("strap", Axis::Z, &[ring(z - 0.05, 1.03), ring(z + 0.05, 1.03)], GREY_FABRIC);
        }
    }
}

/// A holdall with two handles, pockets at its ends and a lid with a zip.
pub(super) fn bag(b: &mut Build<'_>) {
    let (cloth, trim) = (b.choose(&[BLACK_FABRIC, NAVY_FABRIC, RED_FABRIC, GREY_FABRIC, OLIVE_FABRIC]), b.style.accent);
    let body = 0.72;
    let t = 0.05;
    b.pad("bottom", [-0.94, -0.98, 0.0], [0.94, 0.98, 0.06], 0.01, BLACK_FABRIC);
    for s in SIDES {
        b.slab("wall", [s * 0.9 - t, -0.9, 0.03], [s * 0.9 + t, 0.9, body], cloth);
        let end = arc_outline((0.0, body), (0.95, 0.12), (0.0, std::f32::consts::PI), 9);
        let outline: Vec<_> = [(-0.95, 0.03), (0.95, 0.03)].into_iter().chain(end).collect();
        b.within([-1.0, s * 0.93 - 0.03, 0.0], [1.0, s * 0.93 + 0.03, 1.0], |b| {
            b.side_outline("end", (-1.0, 1.0), &outline, cloth)
        });
        b.pad("pocket", [-0.6, s * 0.975 - 0.024, 0.12], [0.6, s * 0.975 + 0.024, 0.55], 0.01, trim);
    }
    b.inner_floor("inside", [0.0, 0.0, 0.06], (0.82, 0.86), body - 0.08);
    let anchor = b.p([-0.95, 0.0, body]);
    b.hinge(anchor, [0.0, -1.0, 0.0], 1.9, |b| {
        let top = arc_outline((0.0, body), (0.95, 0.12), (0.0, std::f32::consts::PI), 9);
        b.side_outline("lid", (-0.895, 0.895), &top, cloth);
        b.slab("zip", [-0.03, -0.85, body + 0.11], [0.03, 0.85, body + 0.128], STEEL);
    });
    for s in SIDES {
        let strap = [
            [s * 0.965, -0.36, 0.2],
            [s * 0.965, -0.34, 0.52],
            [s * 0.965, -0.2, 0.64],
            [s * 0.965, 0.2, 0.64],
            [s * 0.965, 0.34, 0.52],
            [s * 0.965, 0.36, 0.2],
        ];
        for pair in strap.windows(2) {
            b.plank("handle", pair[0], pair[1], (0.008, 0.022), trim);
        }
    }
}

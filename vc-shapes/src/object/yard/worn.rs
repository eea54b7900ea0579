//! Equipment worn by swimmers and divers.

use super::BRIGHT;
use crate::material::*;
use crate::solid::{Axis, Build, P, at_least, limb, spaced};

/// A diving mask with a snorkel beside it, or swimming goggles if the size is low.
pub(super) fn diving_mask(b: &mut Build<'_>) {
    at_least(b, [0.025, 0.075, 0.02]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, strap) = (b.one_of(BRIGHT), b.choose(&[BLACK_PLASTIC, GREY_RUBBER]));
    let glass = BLUE_GLASS;
    let snorkel = h > 0.16;
    let tall = if h > 0.07 { h.min(0.11) } else { h };
    let wide = if snorkel { y * 0.86 } else { y };
    let cy = wide - y;
    let pair = !snorkel && h < 0.07;
    let frame = |half: f32, z: f32, high: f32| {
        vec![
            (-half, z + high * 0.3),
            (-half * 0.8, z),
            (-half * 0.25, z + high * 0.06),
            (half * 0.25, z + high * 0.06),
            (half * 0.8, z),
            (half, z + high * 0.3),
            (half, z + high * 0.8),
            (half * 0.8, z + high),
            (-half * 0.8, z + high),
            (-half, z + high * 0.8),
        ]
    };
    if pair {
        for s in [-1.0, 1.0] {
            let half = wide * 0.46;
            b.prism("frame", Axis::X, [-x * 0.2, cy + s * wide * 0.54, 0.0], &frame(half, 0.0, tall), x * 1.1, mat);
            b.prism(
                "lens",
                Axis::X,
                [x * 0.7, cy + s * wide * 0.54, 0.0],
                &frame(half * 0.82, tall * 0.1, tall * 0.8),
                x * 0.3,
                glass,
            );
        }
        b.block("bridge", [0.0, cy - wide * 0.12, tall * 0.45], [x * 0.6, cy + wide * 0.12, tall * 0.62], strap);
    } else {
        b.prism("skirt", Axis::X, [-x * 0.6, cy, 0.0], &frame(wide * 0.92, 0.002, tall * 0.95), x * 1.2, strap);
        b.prism("frame", Axis::X, [x * 0.4, cy, 0.0], &frame(wide, 0.0, tall), x * 0.45, mat);
        b.prism("lens", Axis::X, [x * 0.6, cy, 0.0], &frame(wide * 0.84, tall * 0.1, tall * 0.82), x * 0.4, glass);
        b.hull(
            "nose",
            &[
                [x * 0.8, cy - wide * 0.2, tall * 0.02],
                [x * 0.8, cy + wide * 0.2, tall * 0.02],
                [x * 0.8, cy, tall * 0.45],
                [x, cy, tall * 0.1],
            ],
            strap,
        );
    }
    let z = tall * 0.5;
    for s in [-1.0, 1.0] {
        b.rod("strap", [-x * 0.2, cy + s * wide * 0.95, z], [-x + 0.003, cy + s * wide * 0.5, z], 0.003, strap);
    }
    b.rod("strap", [-x + 0.003, cy - wide * 0.5, z], [-x + 0.003, cy + wide * 0.5, z], 0.003, strap);
    if snorkel {
        let r = (y - wide * 0.98).clamp(0.005, 0.011);
        let side = y - r * 1.2;
        b.pipe(
            "snorkel",
            &[
                [x * 0.3, side - 0.03, r * 1.2],
                [0.0, side, r * 1.2],
                [-x * 0.2, side, h * 0.3],
                [-x * 0.4, side, h - r * 1.2],
            ],
            r,
            mat,
        );
        b.rod("clip", [-x * 0.2, cy + wide * 0.9, z], [-x * 0.1, side, z], 0.004, strap);
        b.rod("band", [-x * 0.38, side, h - h * 0.16], [-x * 0.395, side, h - h * 0.06], r * 1.25, BLACK_PLASTIC);
    }
}

/// A pair of fins lying side by side, blades to the front.
pub(super) fn swim_fins(b: &mut Build<'_>) {
    at_least(b, [0.15, 0.08, 0.03]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, rubber) = (b.one_of(BRIGHT), b.choose(&[BLACK_PLASTIC, GREY_RUBBER, RUBBER]));
    let half = y * 0.49;
    let shoe = -x + 2.0 * x * b.vary(0.38, 0.46);
    for s in [-1.0, 1.0] {
        let cy = s * (y - half);
        let foot = half * 0.75;
        let body = [
            [-x, 0.5, 0.0, 0.2],
            [-x, 0.5, 0.55, 0.4],
            [shoe, 1.0, 0.0, 0.0],
            [shoe, 0.8, 0.5, 0.0],
            [shoe - (shoe + x) * 0.5, 0.95, 0.0, 0.0],
            [shoe - (shoe + x) * 0.55, 0.75, 1.0, 0.0],
        ];
        b.hull(
            "shoe",
            &body
                .iter()
                .flat_map(|p| [[p[0], cy + foot * p[1], h * p[2]], [p[0], cy - foot * p[1], h * p[2]]])
                .collect::<Vec<P>>(),
            rubber,
        );
        let blade = [
            (shoe - 0.02, -foot * 0.9),
            (shoe + (x - shoe) * 0.7, -half),
            (x, -half * 0.9),
            (x - (x - shoe) * 0.06, 0.0),
            (x, half * 0.9),
            (shoe + (x - shoe) * 0.7, half),
            (shoe - 0.02, foot * 0.9),
        ];
        b.prism("blade", Axis::Z, [0.0, cy, h * 0.1], &blade, h * 0.1, mat);
        for k in [-1.0, 0.0, 1.0] {
            let reach = shoe + (x - shoe) * if k == 0.0 { 0.75 } else { 0.9 };
            b.hull(
                "rib",
                &limb(
                    [shoe - 0.03, cy + k * foot * 0.7, h * 0.2],
                    [reach, cy + k * (half * 0.88).min(half - h * 0.07), h * 0.15],
                    h * 0.12,
                    h * 0.06,
                ),
                rubber,
            );
        }
    }
    b.rod("clip", [shoe - 0.01, -y * 0.25, h * 0.2], [shoe - 0.01, y * 0.25, h * 0.2], h * 0.04, BLACK_PLASTIC);
}

/// A life jacket, upright: two front panels, a back, a collar, straps with buckles.
pub(super) fn life_jacket(b: &mut Build<'_>) {
    at_least(b, [0.05, 0.17, 0.2]);
    let (x, y, h) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
    let (mat, strap) = (
        b.choose(&[ORANGE_PLASTIC, RED_FABRIC, YELLOW_PLASTIC, BLUE_FABRIC]),
        b.choose(&[BLACK_FABRIC, GREY_FABRIC, NAVY_FABRIC]),
    );
    let (chest, shoulder) = (h * b.vary(0.62, 0.7), y * 0.7);
    let t = x * 0.62;
    let gap = 0.006;
    for s in [-1.0, 1.0] {
        let outline = [
            (s * gap, 0.0),
            (s * y, h * 0.02),
            (s * y, chest * 0.75),
            (s * shoulder, chest),
            (s * shoulder * 0.9, h * 0.93),
            (s * shoulder * 0.45, h * 0.93),
            (s * y * 0.3, chest * 0.95),
            (s * gap, chest * 0.8),
        ];
        b.prism("front", Axis::X, [x - t - 0.006, 0.0, 0.0], &outline, t, mat);
        b.rounded_block(
            "shoulder",
            [-x * 0.8, (s * shoulder * 0.45).min(s * shoulder * 0.9), h * 0.88],
            [x - 0.012, (s * shoulder * 0.45).max(s * shoulder * 0.9), h * 0.99],
            h * 0.04,
            mat,
        );
    }
    let back = [
        (-y * 0.98, 0.0),
        (y * 0.98, 0.0),
        (y * 0.98, chest * 0.75),
        (shoulder, chest),
        (shoulder * 0.9, h * 0.92),
        (-shoulder * 0.9, h * 0.92),
        (-shoulder, chest),
        (-y * 0.98, chest * 0.75),
    ];
    b.prism("back", Axis::X, [-x, 0.0, 0.0], &back, t * 0.8, mat);
    b.rounded_block("collar", [-x, -shoulder * 0.6, h * 0.86], [-x * 0.3, shoulder * 0.6, h], h * 0.05, mat);
    let straps = b.rng.count(2, 3);
    for z in spaced(straps, h * 0.14, chest * 0.66) {
        b.block("strap", [-x * 0.9, -y + 0.0005, z - 0.012], [x - 0.004, y - 0.0005, z + 0.012], strap);
        b.block(
            "buckle",
            [x - 0.008, -0.022_f32.min(y * 0.2), z - 0.016],
            [x, 0.022_f32.min(y * 0.2), z + 0.016],
            BLACK_PLASTIC,
        );
    }
    b.block("reflector", [x - 0.008, y * 0.4, chest * 0.82], [x - 0.004, y * 0.65, chest * 0.88], SILVER_METAL);
}

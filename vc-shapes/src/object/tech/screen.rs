//! Televisions, monitors and projectors.

use super::super::decor::picture::{Canvas, Inks, motif};
use super::lens;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims};

/// A flat screen with a picture, on a foot, a stand or two feet.
pub(super) fn screen(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let monitor = b.class == "monitor";
    let rim = b.choose(&[BLACK_PLASTIC, BLACK_PLASTIC, SILVER_METAL, WHITE_PLASTIC]);
    let metal = b.choose(&[BLACK_METAL, SILVER_METAL, STEEL]);
    let thick = (x * 0.35).min(if monitor { 0.03 } else { 0.045 });
    let low = if monitor { h * b.vary(0.22, 0.32) } else { h * b.vary(0.06, 0.12) };
    let (back, front) = (-thick * 0.35, thick * 0.65);
    b.rounded_block("panel", [back, -y, low], [front, y, h], thick * 0.2, rim);
    let bezel = y * b.vary(0.008, 0.025);
    let chin = bezel * b.vary(1.0, 3.0);
    let face = front + 0.0003;
    b.block("screen", [back + thick * 0.3, -y + bezel, low + chin], [face, y - bezel, h - bezel], SCREEN);
    let half = (y - bezel * 1.3, (h - low - chin - bezel) / 2.0 * 0.985);
    let at = [face, 0.0, low + chin + (h - low - chin - bezel) / 2.0];
    motif(b, Canvas { half, step: 0.001 }, at, Inks::screen());
    b.rounded_block(
        "back",
        [(-x * 0.5).max(back - thick), -y * 0.6, low + (h - low) * 0.15],
        [back + 0.002, y * 0.6, low + (h - low) * 0.75],
        thick * 0.2,
        BLACK_PLASTIC,
    );
    stand(b, low, back, metal);
    b.block("light", [front - 0.001, -y * 0.03, low + chin * 0.3], [face + h * 0.002, y * 0.03, low + chin * 0.5], LED);
}

fn stand(b: &mut Build<'_>, low: f32, back: f32, metal: MaterialId) {
    let (x, y, h) = half_dims(b);
    let monitor = b.class == "monitor";
    let flat = (h * 0.02).min(0.012).min(low * 0.4);
    match b.rng.below(3) {
        0 if !monitor => {
            let feet: Vec<(P, P)> =
                [-0.72, 0.72].map(|s| ([-x, y * s - y * 0.02, 0.0], [x, y * s + y * 0.02, flat])).to_vec();
            blocks(b, "foot", &feet, metal);
            for s in [-0.72, 0.72] {
                b.taper(
                    "foot",
                    [0.0, y * s, flat * 0.5],
                    (x * 0.5, y * 0.02),
                    ((x * 0.12).max(0.004), y * 0.018),
                    low + h * 0.03 - flat * 0.5,
                    metal,
                );
            }
        }
        1 if !monitor => {
            for s in [-0.7, 0.7] {
                let top = low + h * 0.02;
                let leg = [
                    (-x, 0.0),
                    (-x * 0.85, 0.0),
                    (0.0, top * 0.9),
                    (x * 0.85, 0.0),
                    (x, 0.0),
                    (x * 0.12, top),
                    (-x * 0.12, top),
                ];
                b.prism("foot", Axis::Y, [0.0, y * s - y * 0.012, 0.0], &leg, y * 0.024, metal);
            }
        }
        _ => {
            let wide = y * b.vary(0.32, 0.5);
            b.rounded_block("foot", [-x, -wide, 0.0], [x, wide, flat], flat * 0.4, metal);
            let neck = y * b.vary(0.06, 0.14);
            let top = if monitor { low + (h - low) * 0.5 } else { low + (h - low) * 0.2 };
            b.block("neck", [back - (x + back).min(0.03) * 0.8, -neck, flat * 0.5], [back + 0.003, neck, top], metal);
        }
    }
}

/// A projector: lens, vents, knobs, small feet.
pub(super) fn projector(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[WHITE_PLASTIC, BLACK_PLASTIC, GREY_PLASTIC]);
    let (foot, out) = (h * 0.08, x * 0.12);
    let front = x - out;
    b.rounded_block("case", [-x, -y, foot], [front, y, h], h * 0.14, case);
    let r = (h * 0.33).min(y * 0.3);
    lens(
        b,
        [front - out, -y * 0.45, foot + (h - foot) * 0.5],
        [x, -y * 0.45, foot + (h - foot) * 0.5],
        r,
        BLACK_PLASTIC,
    );
    let vents: Vec<(P, P)> = (0..6)
        .map(|i| foot + (h - foot) * (0.22 + 0.1 * i as f32))
        .map(|z| ([front - 0.004, y * 0.1, z], [front + 0.0012, y * 0.85, z + h * 0.045]))
        .collect();
    blocks(b, "vent", &vents, SCREEN);
    let keys: Vec<(P, P)> = (0..4)
        .map(|i| x * (-0.3 + 0.16 * i as f32))
        .map(|a| ([a, y * 0.4, h - 0.003], [a + x * 0.09, y * 0.55, h + 0.0008]))
        .collect();
    blocks(b, "key", &keys, GREY_PLASTIC);
    let mut feet = MeshBuilder::default();
    for (sx, sy) in [(-0.75, -0.75), (-0.75, 0.75), (0.55, -0.75), (0.55, 0.75)] {
        feet.block([x * sx - foot, y * sy - foot, 0.0], [x * sx + foot, y * sy + foot, foot * 1.6]);
    }
    feet.put(b, "foot", RUBBER);
}

/// A projection screen pulled out of its case, on a stand or for hanging.
pub(super) fn projector_screen(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let case = b.choose(&[WHITE_METAL, BLACK_METAL]);
    let r = x.min(h * 0.04);
    b.rod("case", [0.0, -y, h - r], [0.0, y, h - r], r, case);
    let low = h * 0.04;
    let thin = (x * 0.05).min(0.002);
    b.block("cloth", [-thin, -y * 0.96, low], [thin, y * 0.96, h - r], BLACK_FABRIC);
    b.block(
        "picture",
        [thin * 0.5, -y * 0.92, low + h * 0.05],
        [thin + 0.001, y * 0.92, h - 2.0 * r - h * 0.04],
        WHITE_COTTON,
    );
    b.rod("weight", [0.0, -y * 0.97, low], [0.0, y * 0.97, low], (h * 0.012).min(x * 0.4).min(low), case);
    let feet = [-0.5, 0.5].map(|s| ([-x, y * s - x * 0.15, 0.0], [x, y * s + x * 0.15, low * 0.3]));
    blocks(b, "foot", &feet, case);
    let posts = [-0.5, 0.5].map(|s| ([-x * 0.6, y * s - x * 0.12, low * 0.2], [-x * 0.3, y * s + x * 0.12, h - r]));
    blocks(b, "post", &posts, case);
}

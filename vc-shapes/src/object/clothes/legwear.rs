//! Trousers, shorts and skirts.

use super::super::textile::{Fold, folded};
use super::accessory::clip_hanger;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, loft, oval};

fn cloth(b: &mut Build<'_>) -> MaterialId {
    match b.class {
        "jeans" => b.choose(&[DENIM, DENIM, NAVY_FABRIC, BLACK_FABRIC]),
        "shorts" => b.choose(&[BEIGE_FABRIC, DENIM, NAVY_FABRIC, RED_FABRIC, OLIVE_FABRIC, BLUE_FABRIC]),
        "skirt" => {
            b.choose(&[b.style.accent, RED_FABRIC, NAVY_FABRIC, BLACK_FABRIC, DENIM, MUSTARD_FABRIC, ROSE_FABRIC])
        }
        _ => b.choose(&[CHARCOAL_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, BLACK_FABRIC, OLIVE_FABRIC, BROWN_FABRIC]),
    }
}

/// Trousers, jeans or shorts.
pub(super) fn trousers(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = cloth(b);
    if h < x.max(y) {
        return lying(b, cloth);
    }
    let waist = clip_hanger(b, h);
    let (crotch, deep) = (if b.class == "shorts" { waist * 0.4 } else { waist * 0.68 }, x * 0.9);
    let (hem, wide) = if b.class == "shorts" { (0.46, 0.47) } else { (b.vary(0.26, 0.38), 0.45) };
    let ring = |z: f32, c: f32, w: f32, d: f32| oval(Axis::Z, [0.0, y * c, z], (deep * d, y * w), 1, 16);
    let mut legs = MeshBuilder::default();
    for side in [-1.0_f32, 1.0] {
        let lean = side * (1.0 - hem * 1.02).min(0.58);
        legs.loft(&[
            ring(0.0, lean, hem, 0.75),
            ring(crotch * 0.5, f32::midpoint(lean, side * 0.5), f32::midpoint(hem, wide), 0.85),
            ring(crotch, side * 0.49, wide * 1.02, 0.96),
        ]);
    }
    legs.loft(&[
        ring(crotch * 0.97, 0.0, 0.94, 0.95),
        ring(crotch + (waist - crotch) * 0.4, 0.0, 0.94, 1.0),
        ring(waist, 0.0, 0.8, 0.8),
    ]);
    legs.put(b, "leg", cloth);
    let band = |z: f32| oval(Axis::Z, [0.0, 0.0, z], (deep * 0.86, y * 0.815), 1, 24);
    let trim = if b.class == "jeans" { BROWN_LEATHER } else { cloth };
    loft(b, "waistband", &[band(waist * 0.955), band(waist * 0.995)], cloth);
    let (step, fly) = (x, (waist - crotch) * 0.6);
    let loops: Vec<(P, P)> = [-0.5, 0.5]
        .map(|s| ([0.0, y * s - y * 0.025, waist * 0.945], [deep * 0.9, y * s + y * 0.025, waist * 0.997]))
        .to_vec();
    blocks(b, "loop", &loops, trim);
    b.block("fly", [0.0, -y * 0.04, waist - fly], [deep + (step - deep) * 0.4, y * 0.03, waist * 0.95], cloth);
    let pocket = |s: f32| {
        (
            [0.0, s * y * 0.56 - y * 0.14, waist - fly * 0.95],
            [deep + (step - deep) * 0.5, s * y * 0.56 + y * 0.1, waist - fly * 0.85],
        )
    };
    blocks(b, "pocket", &[pocket(-1.0), pocket(1.0)], if b.class == "jeans" { MUSTARD_FABRIC } else { cloth });
    b.rod("button", [0.0, 0.0, waist * 0.975], [step, 0.0, waist * 0.975], y * 0.03, BRASS);
}

/// A skirt: straight, flared or pleated.
pub(super) fn skirt(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = cloth(b);
    if h < x.max(y) * 0.6 {
        return lying(b, cloth);
    }
    let waist = clip_hanger(b, h);
    let pleats = b.rng.chance(0.5);
    let (n, hem) = (32, b.vary(0.8, 1.0));
    let ring = |z: f32, w: f32, jag: f32| -> Vec<P> {
        let rim = oval(Axis::Z, [0.0, 0.0, z], (x * 0.95, y * w), 1, n);
        let fold = |i: usize| if i.is_multiple_of(2) { 1.0 } else { 1.0 - jag };
        rim.iter().enumerate().map(|(i, p)| [p[0] * fold(i), p[1] * (1.0 - (1.0 - fold(i)) * 0.2), p[2]]).collect()
    };
    let jag = if pleats { 0.35 } else { 0.08 };
    loft(
        b,
        "skirt",
        &[
            ring(0.0, hem, jag),
            ring(waist * 0.5, f32::midpoint(hem, 0.7), jag * 0.8),
            ring(waist * 0.85, 0.66, jag * 0.4),
            ring(waist * 0.99, 0.6, 0.0),
        ],
        cloth,
    );
    let band = oval(Axis::Z, [0.0, 0.0, waist * 0.97], (x * 0.9, y * 0.6), 1, n);
    let trim = b.choose(&[cloth, BLACK_FABRIC, WHITE_COTTON]);
    hoop(b, "waistband", &band, (x * 0.1).min(waist * 0.02), trim);
}

/// Folded into a flat stack, the waistband in front.
fn lying(b: &mut Build<'_>, cloth: MaterialId) {
    let (x, y, h) = half_dims(b);
    let layers = ((h / 0.02) as usize).clamp(2, 5);
    folded(b, "garment", Fold { low: [-x, -y, 0.0], high: [x, y, h - 0.001], layers, soft: 0.6 }, cloth);
    let thick = h / layers as f32;
    let trim = if b.class == "jeans" { BROWN_LEATHER } else { b.choose(&[BLACK_FABRIC, BROWN_FABRIC, GREY_FABRIC]) };
    let top = h - thick * 0.3;
    blocks(b, "label", &[([-x * 0.6, y * 0.3, top], [-x * 0.35, y * 0.6, h])], trim);
    blocks(b, "seam", &[([-x * 0.9, y * 0.78, top], [x - thick * 0.6, y * 0.8, h])], MUSTARD_FABRIC);
}

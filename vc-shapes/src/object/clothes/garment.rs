//! Shirts, coats and dresses: on a hanger, hanging by their loop, or folded.

use vc_graph::portable::Portable;

use super::super::textile::{Fold, folded};
use super::accessory::hook;
use crate::material::*;
use crate::solid::{Axis, Build, MeshBuilder, P, blocks, half_dims, hoop, loft, oval, spline, tube};

/// The cut of a garment, as fractions of the half width and of the height below the hook.
struct Cut {
    /// Half widths at hem, waist and chest.
    hem: f32,
    waist: f32,
    chest: f32,
    /// The length of the sleeves downwards, 0 for none.
    sleeve: f32,
    front: Front,
    /// The radius of the collar as a fraction of the half depth.
    collar: f32,
}

#[derive(Clone, Copy, PartialEq)]
enum Front {
    Closed,
    Buttons,
    Zip,
    Lapels,
    Belt,
}

fn cut(b: &mut Build<'_>) -> Cut {
    let (hem, waist, chest, sleeve, front, collar) = match b.class {
        "t_shirt" => (0.66, 0.64, 0.66, 0.34, Front::Closed, 0.1),
        "shirt" => (0.62, 0.6, 0.62, b.choose(&[0.88, 0.88, 0.36]), Front::Buttons, 0.24),
        "sweater" => (0.62, 0.66, 0.64, 0.92, b.choose(&[Front::Closed, Front::Closed, Front::Buttons]), 0.22),
        "hoodie" => (0.6, 0.66, 0.64, 0.92, b.choose(&[Front::Closed, Front::Zip]), 0.3),
        "jacket" => (0.62, 0.66, 0.66, 0.94, b.choose(&[Front::Zip, Front::Buttons]), 0.3),
        "raincoat" => (0.76, 0.68, 0.64, 0.68, b.choose(&[Front::Zip, Front::Buttons]), 0.26),
        "suit" => (0.64, 0.58, 0.64, 0.75, Front::Lapels, 0.16),
        "coat" => (0.74, 0.66, 0.66, 0.66, b.choose(&[Front::Lapels, Front::Buttons, Front::Lapels]), 0.26),
        "bathrobe" => (0.7, 0.64, 0.64, 0.6, Front::Belt, 0.26),
        _ => (b.vary(0.75, 0.99), 0.46, 0.56, b.choose(&[0.0, 0.0, 0.22, 0.5]), Front::Closed, 0.08),
    };
    Cut { hem, waist, chest, sleeve, front, collar }
}

fn cloth(b: &mut Build<'_>) -> MaterialId {
    let accent = b.style.accent;
    match b.class {
        "shirt" => b.choose(&[WHITE_COTTON, SKY, BLUE_FABRIC, ROSE_FABRIC, DENIM, LINEN]),
        "suit" => b.choose(&[CHARCOAL_FABRIC, NAVY_FABRIC, BLACK_FABRIC, GREY_FABRIC]),
        "coat" => b.choose(&[CHARCOAL_FABRIC, BEIGE_FABRIC, NAVY_FABRIC, BLACK_FABRIC, BROWN_FABRIC, RED_FABRIC]),
        "jacket" => b.choose(&[DENIM, BLACK_LEATHER, BROWN_LEATHER, OLIVE_FABRIC, NAVY_FABRIC, RED_FABRIC]),
        "raincoat" => b.choose(&[YELLOW_PLASTIC, NAVY_FABRIC, GREEN_FABRIC, RED_FABRIC]),
        "bathrobe" => b.choose(&[b.style.towel, TOWEL_WHITE, TOWEL_BLUE, GREY_FABRIC]),
        _ => b.choose(&[
            accent,
            WHITE_COTTON,
            GREY_FABRIC,
            NAVY_FABRIC,
            RED_FABRIC,
            TEAL_FABRIC,
            MUSTARD_FABRIC,
            BLACK_FABRIC,
            GREEN_FABRIC,
            PURPLE_FABRIC,
            ROSE_FABRIC,
            WOOL,
        ]),
    }
}

/// Any garment worn on the upper body or hanging from the shoulders.
pub(super) fn top(b: &mut Build<'_>) {
    let (x, y, h) = half_dims(b);
    let cloth = cloth(b);
    let trim = b.choose(&[WHITE_COTTON, BLACK_FABRIC, NAVY_FABRIC, RED_FABRIC, GREY_FABRIC, MUSTARD_FABRIC]);
    if h < x.max(y) {
        return lying(b, cloth, trim);
    }
    let cut = cut(b);
    let neck = hook(b, h * 0.93);
    body(b, &cut, neck, cloth);
    if cut.sleeve > 0.0 {
        sleeves(b, &cut, neck, (cloth, trim));
    }
    closure(b, &cut, neck, (cloth, trim));
    decoration(b, &cut, neck, trim);
}

/// Half depth of the body, leaving room for parts sewn on the front.
fn depth(b: &Build<'_>) -> f32 {
    b.size.x / 2.0 * 0.88
}

fn body(b: &mut Build<'_>, cut: &Cut, neck: f32, cloth: MaterialId) {
    let (_, y, _) = half_dims(b);
    let deep = depth(b);
    let (phase, folds) = (b.vary(0.0, 6.0), b.choose(&[5.0, 7.0, 9.0]));
    let ring = |t: f32, w: f32, d: f32, wave: f32| -> Vec<P> {
        let n = 24;
        oval(Axis::Z, [0.0, 0.0, neck * t], (deep * d, y * w), 1, n)
            .into_iter()
            .enumerate()
            .map(|(i, p)| {
                let s = 1.0 - wave * 0.5 * (1.0 + (folds * std::f32::consts::TAU * i as f32 / n as f32 + phase).sine());
                [p[0] * s, p[1] * (1.0 - wave * 0.1), p[2]]
            })
            .collect()
    };
    let soft = if cut.hem > cut.waist + 0.06 { 0.4 } else { 0.12 };
    let rings = [
        ring(0.0, cut.hem, 1.0, soft),
        ring(0.28, f32::midpoint(cut.hem, cut.waist), 1.0, soft * 0.7),
        ring(0.55, cut.waist, 0.98, 0.08),
        ring(0.76, cut.chest, 1.0, 0.0),
        ring(0.88, cut.chest * 0.98, 0.9, 0.0),
        ring(0.945, cut.chest * 0.68, 0.66, 0.0),
        ring(1.0, 0.24, 0.5, 0.0),
    ];
    loft(b, "body", &rings, cloth);
    let collar = deep * cut.collar;
    let line = oval(Axis::Z, [0.0, 0.0, neck * 0.992], (deep * 0.5, y * 0.23), 0, 18);
    let line: Vec<P> = line.iter().map(|p| [p[0], p[1], p[2] - p[0].max(0.0) * 0.5]).collect();
    hoop(b, "collar", &line, collar.max(0.002), cloth);
    if b.class == "hoodie" || b.class == "raincoat" {
        let mut hood = MeshBuilder::default();
        hood.egg([-deep * 0.35, 0.0, neck * 0.9], [deep * 0.62, y * 0.3, neck * 0.085]);
        hood.put(b, "hood", cloth);
    }
}

fn sleeves(b: &mut Build<'_>, cut: &Cut, neck: f32, (cloth, trim): (MaterialId, MaterialId)) {
    let (_, y, _) = half_dims(b);
    let deep = depth(b) * 0.85;
    let long = cut.sleeve > 0.5;
    let cuff = neck * (0.93 - cut.sleeve * if long { 0.91 } else { 0.72 });
    let (mut arms, mut cuffs) = (MeshBuilder::default(), MeshBuilder::default());
    for side in [-1.0_f32, 1.0] {
        let wide = if long { 0.15 } else { 0.17 };
        let ring = |t: f32, grow: f32| {
            let z = neck * 0.91 + (cuff - neck * 0.91) * t;
            let spread = (t * 2.2).min(1.0);
            let centre = (cut.chest - 0.14) + (1.0 - wide - cut.chest + 0.14) * spread;
            let half = (y * wide * (0.85 + 0.15 * spread - 0.25 * t) * grow).min(y * (1.0 - centre));
            oval(Axis::Z, [0.0, side * y * centre, z], (deep * (0.9 - 0.3 * t) * grow, half), 0, 12)
        };
        arms.loft(&[ring(0.0, 0.55), ring(0.06, 1.0), ring(0.3, 1.0), ring(0.7, 1.0), ring(1.0, 1.0)]);
        cuffs.loft(&[ring(0.94, 1.1), ring(1.01, 1.1)]);
    }
    arms.put(b, "sleeve", cloth);
    let plain = matches!(cut.front, Front::Lapels | Front::Belt | Front::Buttons) || b.rng.chance(0.6);
    cuffs.put(b, "cuff", if plain { cloth } else { trim });
}

/// Buttons, zip, lapels or a belt.
fn closure(b: &mut Build<'_>, cut: &Cut, neck: f32, (cloth, trim): (MaterialId, MaterialId)) {
    let (x, y, _) = half_dims(b);
    let deep = depth(b);
    let step = (x - deep) * 0.3;
    let strip = |w: f32, z0: f32, z1: f32, layer: f32| {
        ([deep * 0.6, -y * w, neck * z0], [deep + step * layer, y * w, neck * z1])
    };
    let buttons = |b: &mut Build<'_>, count: usize, top: f32, layer: f32, mat: MaterialId| {
        let size = (y * 0.035).min(0.012);
        let list: Vec<(P, P)> = (0..count)
            .map(|i| neck * (top - (top - 0.12) * i as f32 / count as f32))
            .map(|z| ([deep * 0.9, -size, z - size], [deep + step * layer, size, z + size]))
            .collect();
        blocks(b, "button", &list, mat);
    };
    match cut.front {
        Front::Closed => {}
        Front::Buttons => {
            blocks(b, "placket", &[strip(0.07, 0.02, 0.84, 1.0)], cloth);
            let mat = b.choose(&[WHITE_PLASTIC, BROWN_PLASTIC, BLACK_PLASTIC]);
            buttons(b, 6, 0.82, 2.0, mat);
        }
        Front::Zip => {
            blocks(b, "zip", &[strip(0.025, 0.01, 0.86, 1.0)], STEEL);
            let pockets = [-1.0_f32, 1.0].map(|s| {
                (
                    [deep * 0.6, s * y * 0.36 - y * 0.03, neck * 0.16],
                    [deep + step * 0.5, s * y * 0.36 + y * 0.03, neck * 0.4],
                )
            });
            blocks(b, "pocket", &pockets, trim);
        }
        Front::Lapels => {
            let shirt = b.choose(&[WHITE_COTTON, SKY, LINEN, cloth]);
            let vee = [(-0.22, 0.9), (0.22, 0.9), (0.0, 0.5)].map(|(a, z)| (y * a, neck * z));
            b.prism("shirt", Axis::X, [deep * 0.5, 0.0, 0.0], &vee, deep * 0.5 + step, shirt);
            for s in [-1.0_f32, 1.0] {
                let lapel = [(0.16, 0.94), (0.32, 0.86), (0.4, 0.74), (0.02, 0.48)].map(|(a, z)| (s * y * a, neck * z));
                b.prism("lapel", Axis::X, [deep * 0.5, 0.0, 0.0], &lapel, deep * 0.5 + step * 2.0, cloth);
            }
            blocks(b, "seam", &[strip(0.008, 0.004, 0.48, 0.7)], BLACK_FABRIC);
            buttons(b, b.size.z.mul_add(1.5, 1.0) as usize, 0.46, 2.0, BLACK_PLASTIC);
        }
        Front::Belt => {
            blocks(b, "seam", &[strip(0.01, 0.004, 0.9, 0.6)], trim);
            let band = |z: f32| oval(Axis::Z, [0.0, 0.0, neck * z], (deep + step, y * (cut.waist + 0.03)), 1, 24);
            loft(b, "belt", &[band(0.53), band(0.57)], cloth);
            let ends =
                [-0.05, 0.1].map(|s| ([deep, y * s, neck * 0.28], [deep + step * 2.0, y * (s + 0.07), neck * 0.55]));
            blocks(b, "belt", &ends, cloth);
        }
    }
}

/// Stripes, a print, pockets or a pattern on the front.
fn decoration(b: &mut Build<'_>, cut: &Cut, neck: f32, trim: MaterialId) {
    let (x, y, _) = half_dims(b);
    let deep = depth(b);
    let step = (x - deep) * 0.3;
    match b.class {
        "t_shirt" | "hoodie" if cut.front == Front::Closed => {
            let kind = b.rng.below(4);
            let print: Vec<(f32, f32)> = match kind {
                0 => crate::solid::ngon((y * 0.25, y * 0.25), 20),
                1 => vec![(-y * 0.3, -y * 0.12), (y * 0.3, -y * 0.12), (y * 0.3, y * 0.12), (-y * 0.3, y * 0.12)],
                2 => (0..10)
                    .map(|i| (i as f32 * 0.6283, if i % 2 == 0 { 0.3 } else { 0.13 }))
                    .map(|(a, s)| (y * s * a.sine(), y * s * a.cosine()))
                    .collect(),
                _ => return,
            };
            b.prism("print", Axis::X, [deep * 0.6, 0.0, neck * 0.66], &print, deep * 0.4 + step, trim);
            if b.class == "hoodie" {
                let pouch = [(-0.36, 0.12), (0.36, 0.12), (0.36, 0.26), (0.22, 0.4), (-0.22, 0.4), (-0.36, 0.26)]
                    .map(|(a, z)| (y * a, neck * z));
                b.prism("pouch", Axis::X, [deep * 0.6, 0.0, 0.0], &pouch, deep * 0.4 + step * 1.5, trim);
            }
        }
        "sweater" | "dress" | "t_shirt" => {
            let count = b.rng.count(0, 4);
            let band = |z: f32| {
                let w = if z > 0.55 { cut.chest } else { cut.waist + (cut.hem - cut.waist) * (1.0 - z / 0.55) };
                oval(Axis::Z, [0.0, 0.0, neck * z], (deep * 1.05, y * w * 1.015), 1, 24)
            };
            let low = if b.class == "dress" { 0.545 } else { b.vary(0.4, 0.6) };
            let count = match (b.class, cut.front) {
                ("dress", _) => count.min(1),
                (_, Front::Closed) => count,
                _ => 0,
            };
            for i in 0..count {
                let z = low + 0.07 * i as f32;
                loft(b, "stripe", &[band(z), band(z + 0.03)], trim);
            }
        }
        "jacket" | "coat" if cut.front != Front::Zip => {
            let list = [-1.0_f32, 1.0].map(|s| {
                (
                    [deep * 0.6, s * y * 0.36 - y * 0.13, neck * 0.25],
                    [deep + step * 0.8, s * y * 0.36 + y * 0.13, neck * 0.31],
                )
            });
            blocks(b, "pocket", &list, trim);
        }
        _ => {}
    }
}

/// A folded garment: a stack of layers with collar and buttons or a stripe on top.
fn lying(b: &mut Build<'_>, cloth: MaterialId, trim: MaterialId) {
    let (x, y, h) = half_dims(b);
    let layers = ((h / 0.018) as usize).clamp(2, 5);
    let relief = (h * 0.12).min(0.008);
    let fold = Fold { low: [-x, -y, 0.0], high: [x, y, h - relief], layers, soft: 0.7 };
    folded(b, "garment", fold, cloth);
    let top = h - relief;
    let collar = relief * 0.5;
    let at = [-x * 0.72, 0.0, top - collar * 0.2];
    let neck = [
        [at[0] + x * 0.4, 0.0, at[2]],
        [at[0], -y * 0.32, at[2]],
        [at[0] - x * 0.15, 0.0, at[2]],
        [at[0], y * 0.32, at[2]],
    ];
    let mut ring = spline(&[neck[0], neck[1], neck[2], neck[3], neck[0]], 4);
    ring.pop();
    hoop(b, "collar", &ring, collar, cloth);
    match b.class {
        "shirt" | "pajamas" | "jacket" => {
            let list: Vec<(P, P)> = (0..5)
                .map(|i| x * (-0.25 + 0.24 * i as f32))
                .map(|a| ([a - x * 0.03, -x * 0.03, top - relief], [a + x * 0.03, x * 0.03, top + relief * 0.3]))
                .collect();
            blocks(b, "button", &list, WHITE_PLASTIC);
            b.block("placket", [-x * 0.3, -y * 0.06, top - relief], [x * 0.82, y * 0.06, top + relief * 0.12], cloth);
        }
        _ => {
            let list =
                [0.2, 0.4].map(|a| ([x * a, -y * 0.8, top - relief], [x * (a + 0.1), y * 0.8, top + relief * 0.15]));
            blocks(b, "stripe", &list, trim);
        }
    }
    if b.class == "bathrobe" {
        tube(b, "belt", &[[x * 0.1, -y * 0.95, top], [x * 0.1, y * 0.95, top]], relief * 0.5, cloth);
    }
}

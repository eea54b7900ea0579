//! Lamps: glowing bulbs, shades, stands.

mod hung;
mod small;
mod stood;

use super::{Generator, indoor};
use crate::material::*;
use crate::solid::{Build, P};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("ceiling_lamp", 8, hung::ceiling_lamp),
    indoor("pendant_lamp", 8, hung::pendant_lamp),
    indoor("chandelier", 5, hung::chandelier),
    indoor("table_lamp", 9, stood::table_lamp),
    indoor("desk_lamp", 7, stood::desk_lamp),
    indoor("floor_lamp", 9, stood::floor_lamp),
    indoor("light", 4, stood::table_lamp),
    indoor("wall_lamp", 7, hung::wall_lamp),
    indoor("spotlight", 6, hung::spotlight),
    indoor("mirror_light", 4, hung::mirror_light),
    indoor("under_cabinet_light", 4, hung::under_cabinet_light),
    indoor("night_light", 5, small::night_light),
    indoor("string_lights", 4, small::string_lights),
    indoor("light_bulb", 5, small::light_bulb),
    indoor("flashlight", 5, small::flashlight),
];

/// Cloth, paper or glass of a shade.
fn shade_mat(b: &mut Build<'_>) -> MaterialId {
    let accent = b.style.accent;
    b.choose(&[WHITE_COTTON, LINEN, LINEN, BEIGE_FABRIC, accent, CREAM_PAPER])
}

/// Metal of a stand.
fn stand_mat(b: &mut Build<'_>) -> MaterialId {
    let metal = b.style.metal;
    b.choose(&[metal, metal, BRASS, BLACK_METAL, WHITE_METAL])
}

/// Outlines of shades: a drum, a cone, an empire, a bell, a dome and a truncated globe.
const SHADES: [&[(f32, f32)]; 6] = [
    &[(1.0, 0.0), (1.0, 1.0)],
    &[(1.0, 0.0), (0.35, 1.0)],
    &[(1.0, 0.0), (0.66, 1.0)],
    &[(1.0, 0.0), (0.86, 0.18), (0.62, 0.5), (0.44, 1.0)],
    &[(1.0, 0.0), (0.97, 0.3), (0.84, 0.6), (0.58, 0.86), (0.25, 1.0)],
    &[(0.72, 0.0), (0.97, 0.3), (1.0, 0.5), (0.97, 0.7), (0.72, 0.94), (0.3, 1.0)],
];

/// An open shade with one of the outlines [`SHADES`], standing on `base`, with radius `r` and
/// height `h`.
fn shade(b: &mut Build<'_>, design: usize, base: P, (r, h): (f32, f32), mat: MaterialId) {
    let wall = (r * 0.04).min(0.004);
    let outer = SHADES[design % SHADES.len()].iter().map(|p| (p.0 * r, p.1 * h));
    let mut profile: Vec<(f32, f32)> = outer.collect();
    let inner: Vec<(f32, f32)> = profile.iter().rev().map(|p| ((p.0 - wall).max(wall * 0.5), p.1)).collect();
    profile.extend(inner);
    profile.push(profile[0]);
    b.lathe("shade", base, &profile, mat);
}

/// Radius to the middle of a shade's wall at a fraction of its height; `r` is the shade's radius.
fn shade_at(design: usize, share: f32, r: f32) -> f32 {
    let outline = SHADES[design % SHADES.len()];
    let between = |p: &[(f32, f32)]| {
        (p[0].1..=p[1].1).contains(&share).then(|| p[0].0 + (p[1].0 - p[0].0) * (share - p[0].1) / (p[1].1 - p[0].1))
    };
    outline.windows(2).find_map(between).unwrap_or(1.0) * r - (r * 0.02).min(0.002)
}

/// A bulb of radius `r` centred at `at` with its neck up or down.
fn bulb(b: &mut Build<'_>, at: P, r: f32, neck_up: bool) {
    let light = b.choose(&[WARM_BULB, WARM_BULB, COOL_BULB]);
    b.ball("bulb", at, r, light);
    let z = if neck_up { at[2] + r * 0.7 } else { at[2] - r * 1.7 };
    b.cylinder("socket", [at[0], at[1], z], r * 0.55, r, BLACK_PLASTIC);
}

//! Plants in pots.

mod foliage;

use super::{Generator, indoor};
use crate::material::*;
use crate::solid::{Axis, Build, half_dims, loft, oval};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("houseplant", 30, foliage::plant),
    indoor("cactus", 8, foliage::plant),
    indoor("orchid", 6, foliage::orchid),
];

/// Builds a pot within a radius (round, square, ribbed or a basket) with soil in it and returns the
/// height of the soil.
fn pot(b: &mut Build<'_>, r: f32, h: f32) -> f32 {
    let mat = b.choose(&[
        POTTERY,
        POTTERY,
        PORCELAIN,
        STONEWARE,
        BLUE_GLAZE,
        BLACK_GLAZE,
        GREEN_GLAZE,
        CONCRETE,
        WICKER,
        BRASS,
    ]);
    let (x, y, _) = half_dims(b);
    let r = r.min(x).min(y);
    let t = r * 0.08;
    let earth = h * 0.88;
    let foot = b.vary(0.62, 0.95);
    match b.rng.below(4) {
        0 => {
            let ring = |z: f32, s: f32, t: f32| oval(Axis::Z, [0.0, 0.0, z * h], (r * s - t, r * s - t), 2, 24);
            let size = foot.max(0.8);
            loft(b, "pot", &[ring(0.0, size, 0.0), ring(1.0, 1.0, 0.0), ring(1.0, 1.0, t), ring(0.12, size, t)], mat);
            loft(b, "earth", &[ring(0.11, size, t * 0.9), ring(0.88, 0.98, t * 0.9)], SOIL);
            return earth;
        }
        1 => {
            let rim =
                [(r * foot, 0.0), (r * 0.93, h * 0.72), (r, h * 0.73), (r, h), (r - t, h), (r * foot - t, h * 0.1)];
            b.lathe("pot", [0.0; 3], &rim, mat);
        }
        2 => {
            let mut profile = vec![(r * foot, 0.0)];
            for i in 0..6 {
                let z = h * (i as f32 + 0.5) / 6.0;
                let s = foot + (1.0 - foot) * z / h;
                profile.extend([(r * s, z), (r * s * 0.96, z + h / 12.0)]);
            }
            profile.extend([(r * 0.96 - t, h), (r * foot * 0.9 - t, h * 0.1)]);
            b.lathe("pot", [0.0; 3], &profile, mat);
        }
        _ => {
            let belly = [
                (r * foot * 0.8, 0.0),
                (r * 0.95, h * 0.3),
                (r, h * 0.55),
                (r * 0.9, h),
                (r * 0.9 - t, h),
                (r * foot * 0.7, h * 0.1),
            ];
            b.lathe("pot", [0.0; 3], &belly, mat);
        }
    }
    let level = r * (foot + (1.0 - foot) * 0.88).min(0.9) - t * 0.9;
    b.lathe("earth", [0.0, 0.0, h * 0.11], &[(r * foot * 0.72 - t * 0.5, 0.0), (level, earth - h * 0.11)], SOIL);
    earth
}

//! Textures as tiles of texels with coarser copies, made once per process.

use std::sync::LazyLock;

use super::Pattern;

/// A point of a texture as it is kept.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Texel {
    /// What the colour is multiplied with; 128 is one.
    tint: [u8; 3],
    /// What the roughness is multiplied with; 64 is one.
    roughness: u8,
    /// How the normal leans along u and v; 64 is one.
    lean: [i8; 2],
}

/// A texture, and its copies of half the size each.
#[derive(Debug)]
pub(crate) struct Tile {
    levels: Vec<Vec<Texel>>,
    texels: usize,
    /// Texels to a metre.
    density: f32,
}

/// A texture's say on colour, roughness and normal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch {
    pub(crate) tint: [f32; 3],
    pub(crate) roughness: f32,
    pub(crate) lean: [f32; 2],
}

static TILES: LazyLock<Vec<Tile>> = LazyLock::new(|| {
    use rayon::prelude::*;
    Pattern::ALL.par_iter().map(|pattern| Tile::new(*pattern)).collect()
});

impl Tile {
    /// The tile of a pattern.
    pub(crate) fn of(pattern: Pattern) -> &'static Self {
        &TILES[pattern as usize]
    }

    fn new(pattern: Pattern) -> Self {
        let texels = pattern.texels();
        let step = 1.0 / texels as f32;
        let samples: Vec<_> = (0..texels * texels)
            .map(|i| pattern.sample(((i % texels) as f32 + 0.5) * step, ((i / texels) as f32 + 0.5) * step))
            .collect();
        let height = |x: usize, y: usize| samples[(y % texels) * texels + x % texels].height * texels as f32;
        let lean = |a: f32, b: f32| ((a - b) * 0.5 * 64.0).clamp(-127.0, 127.0) as i8;
        let texel = |i: usize| {
            let (x, y) = (i % texels + texels, i / texels + texels);
            Texel {
                tint: samples[i].tint.map(|t| (t * 128.0 + 0.5).clamp(0.0, 255.0) as u8),
                roughness: (samples[i].roughness * 64.0).clamp(0.0, 255.0) as u8,
                lean: [lean(height(x - 1, y), height(x + 1, y)), lean(height(x, y - 1), height(x, y + 1))],
            }
        };
        let mut levels = vec![(0..texels * texels).map(texel).collect::<Vec<Texel>>()];
        while levels.last().is_some_and(|l| l.len() > 1) {
            levels.extend(levels.last().map(|l| halved(l)));
        }
        Self { levels, texels, density: texels as f32 / pattern.side() }
    }

    /// The coarser copy to use where a pixel is so many metres wide.
    #[inline(always)]
    pub(crate) fn level(&self, footprint: f32) -> usize {
        // The exponent of a float is the whole part of its logarithm.
        let texels = footprint * self.density * 1.2;
        let exponent = (texels.to_bits() >> 23) as i32 - 127;
        exponent.clamp(0, self.levels.len() as i32 - 1) as usize
    }

    /// The texture at a place, metres, between the four nearest texels.
    #[inline(always)]
    pub(crate) fn at(&self, level: usize, u: f32, v: f32) -> Touch {
        let side = self.texels >> level;
        let scale = self.density / (1_u32 << level) as f32;
        // Far from zero on the positive side, so that cutting off is rounding down.
        let (x, y) = (u * scale + 32_767.5, v * scale + 32_767.5);
        let (cx, cy) = (x as i32, y as i32);
        let (fx, fy) = (x - cx as f32, y - cy as f32);
        let mask = side - 1;
        let (x0, y0) = (cx as usize & mask, cy as usize & mask);
        let (x1, y1) = ((x0 + 1) & mask, (y0 + 1) & mask);
        let texels = &self.levels[level];
        let corners = [texels[y0 * side + x0], texels[y0 * side + x1], texels[y1 * side + x0], texels[y1 * side + x1]];
        let weights = [(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy];
        let mut sum = [0.0_f32; 6];
        for (texel, weight) in corners.iter().zip(weights) {
            let [r, g, b] = texel.tint.map(f32::from);
            let [lu, lv] = texel.lean.map(f32::from);
            for (sum, value) in sum.iter_mut().zip([r, g, b, f32::from(texel.roughness), lu, lv]) {
                *sum += weight * value;
            }
        }
        Touch {
            tint: [0, 1, 2].map(|i: usize| sum[i] * (1.0 / 128.0)),
            roughness: sum[3] * (1.0 / 64.0),
            lean: [sum[4] * (1.0 / 64.0), sum[5] * (1.0 / 64.0)],
        }
    }
}

/// Means of two by two.
fn halved(fine: &[Texel]) -> Vec<Texel> {
    let side = fine.len().isqrt();
    let half = side / 2;
    let mean = |i: usize| {
        let (x, y) = (i % half * 2, i / half * 2);
        let four = [fine[y * side + x], fine[y * side + x + 1], fine[(y + 1) * side + x], fine[(y + 1) * side + x + 1]];
        let of = |part: &dyn Fn(&Texel) -> u8| (four.iter().map(|t| u32::from(part(t))).sum::<u32>() / 4) as u8;
        let lean = |axis: usize| (four.iter().map(|t| i32::from(t.lean[axis])).sum::<i32>() / 4) as i8;
        Texel {
            tint: [0, 1, 2].map(|c: usize| of(&|t| t.tint[c])),
            roughness: of(&|t| t.roughness),
            lean: [lean(0), lean(1)],
        }
    };
    (0..half * half).map(mean).collect()
}

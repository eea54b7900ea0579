//! Textures as tiles of texels with coarser copies, made once per process.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::sync::LazyLock;

use super::Pattern;
use crate::affine::three;
use crate::simd::{Mixer, whole};

/// A point of a texture as it is kept, a byte each: what red, green and blue are multiplied
/// with (128 is one), and the roughness (64 is one); how the normal leans along u and v
/// (64 is one, 128 is none).
type Texel = [u8; 8];

/// A texture, and its copies of half the size each.
#[derive(Debug)]
pub(crate) struct Tile {
    levels: Vec<Vec<Texel>>,
    texels: usize,
    /// Texels to a metre.
    density: f32,
    /// By level, whether any texel leans the normal.
    leans: Vec<bool>,
}

/// Pixels whose texture is found at once.
pub(crate) const SPAN: usize = 16;

/// Neighbouring pixels: where in a texture they are, metres, and what it says there.
#[derive(Default)]
pub(crate) struct Span {
    pub(crate) count: usize,
    pub(crate) u: [f32; SPAN],
    pub(crate) v: [f32; SPAN],
    pub(crate) tint: [[f32; SPAN]; 3],
    pub(crate) roughness: [f32; SPAN],
    pub(crate) lean: [[f32; SPAN]; 2],
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
        let lean = |a: f32, b: f32| ((a - b) * 0.5 * 64.0 + 128.5).clamp(1.0, 255.0) as u8;
        let texel = |i: usize| {
            let (x, y) = (i % texels + texels, i / texels + texels);
            let [r, g, b] = samples[i].tint.map(|t| (t * 128.0 + 0.5).clamp(0.0, 255.0) as u8);
            let roughness = (samples[i].roughness * 64.0).clamp(0.0, 255.0) as u8;
            let (lu, lv) = (lean(height(x - 1, y), height(x + 1, y)), lean(height(x, y - 1), height(x, y + 1)));
            [r, g, b, roughness, lu, lv, 0, 0]
        };
        let mut levels = vec![(0..texels * texels).map(texel).collect::<Vec<Texel>>()];
        while levels.last().is_some_and(|l| l.len() > 1) {
            levels.extend(levels.last().map(|l| halved(l)));
        }
        // Less than a thirtieth is not seen.
        let even = |texel: &Texel| texel[4..6].iter().all(|lean| lean.abs_diff(128) < 2);
        let leans = levels.iter().map(|level| !level.iter().all(even)).collect();
        Self { levels, texels, density: texels as f32 / pattern.side(), leans }
    }

    /// The coarser copy to use where a pixel is so many metres wide.
    #[inline(always)]
    pub(crate) fn level(&self, footprint: f32) -> usize {
        // The exponent of a float is the whole part of its logarithm.
        let texels = footprint * self.density * 1.5;
        let exponent = (texels.to_bits() >> 23) as i32 - 127;
        exponent.clamp(0, self.levels.len() as i32 - 1) as usize
    }

    /// Whether its copy of a level leans normals.
    #[inline(always)]
    pub(crate) fn leans(&self, level: usize) -> bool {
        self.leans[level]
    }

    /// The texture at a place, metres, between the four nearest texels.
    #[inline(always)]
    pub(crate) fn at(&self, level: usize, u: f32, v: f32) -> Touch {
        let mut span = Span { count: 1, ..Span::default() };
        (span.u[0], span.v[0]) = (u, v);
        self.span(level, &mut span);
        Touch {
            tint: three(|c| span.tint[c][0]),
            roughness: span.roughness[0],
            lean: [span.lean[0][0], span.lean[1][0]],
        }
    }

    /// The texture at the places of a span.
    #[inline(always)]
    pub(crate) fn span(&self, level: usize, span: &mut Span) {
        // Tiles to a metre, and parts of 256 of a texel to a tile.
        let (scale, parts) = (self.density / self.texels as f32, ((self.texels >> level) * 256) as f32);
        let (texels, bits) = (self.levels[level].as_slice(), (self.texels >> level).trailing_zeros());
        let mask = (1_u32 << bits) - 1;
        // The four texels around each place, and their weights, of which the sum is 256.
        let (mut around, mut weights) = ([[0_u32; SPAN]; 4], [[0_u16; SPAN]; 4]);
        for i in 0..SPAN {
            let (u, v) = (span.u[i] * scale, span.v[i] * scale);
            // From a texel's middle to its corner.
            let x = whole((u - u.floor()) * parts).wrapping_sub(128);
            let y = whole((v - v.floor()) * parts).wrapping_sub(128);
            let (x0, y0) = (x >> 8 & mask, y >> 8 & mask);
            let (x1, y1) = ((x0 + 1) & mask, (y0 + 1) & mask);
            let (upper, lower) = (y0 << bits, y1 << bits);
            (around[0][i], around[1][i]) = (upper | x0, upper | x1);
            (around[2][i], around[3][i]) = (lower | x0, lower | x1);
            let (fx, fy) = (x & 255, y & 255);
            let both = (fx * fy) >> 8;
            (weights[0][i], weights[1][i]) = ((256 + both - fx - fy) as u16, (fx - both) as u16);
            (weights[2][i], weights[3][i]) = ((fy - both) as u16, both as u16);
        }
        // Two numbers of sixteen bits in each: red and green, blue and roughness, the leans.
        let (mixer, mut pairs) = (Mixer::new(), [[0_u32; SPAN]; 3]);
        for i in 0..span.count.min(SPAN) {
            let texel = |k: usize| texels[around[k][i] as usize];
            let weight = |k: usize| weights[k][i];
            let mixed =
                mixer.sum([texel(0), texel(1), texel(2), texel(3)], [weight(0), weight(1), weight(2), weight(3)]);
            for (k, pairs) in pairs.iter_mut().enumerate() {
                pairs[i] = u32::from(mixed[2 * k]) | u32::from(mixed[2 * k + 1]) << 16;
            }
        }
        let low = |v: u32| (v & 0xffff) as i32 as f32;
        let high = |v: u32| (v >> 16) as i32 as f32;
        let tint = 1.0 / (256.0 * 128.0);
        let half = 1.0 / (256.0 * 64.0);
        for i in 0..SPAN {
            span.tint[0][i] = low(pairs[0][i]) * tint;
            span.tint[1][i] = high(pairs[0][i]) * tint;
            span.tint[2][i] = low(pairs[1][i]) * tint;
            span.roughness[i] = high(pairs[1][i]) * half;
            span.lean[0][i] = (low(pairs[2][i]) - 32_768.0) * half;
            span.lean[1][i] = (high(pairs[2][i]) - 32_768.0) * half;
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
        let sum = |k: usize| four.iter().map(|t| u16::from(t[k])).sum::<u16>();
        std::array::from_fn(|k| ((sum(k) + 2) >> 2) as u8)
    };
    (0..half * half).map(mean).collect()
}

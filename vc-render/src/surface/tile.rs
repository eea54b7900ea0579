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
    /// Rows end with their first texel once more.
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
        let levels = levels.iter().map(|level| closed(level)).collect();
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
        let side = (self.texels >> level) as u32;
        let (scale, parts) = (self.density / self.texels as f32, (side * 256) as f32);
        let texels = self.levels[level].as_slice();
        // The left one of two texels above each place and of two below it, and their weights.
        let (mut above, mut below) = ([0_u32; SPAN], [0_u32; SPAN]);
        let (mut across, mut down) = ([0_u16; SPAN], [0_u32; SPAN]);
        for i in 0..SPAN {
            let (u, v) = (span.u[i] * scale, span.v[i] * scale);
            // From a texel's middle to its corner.
            let x = whole((u - u.floor()) * parts).wrapping_sub(128);
            let y = whole((v - v.floor()) * parts).wrapping_sub(128);
            let (column, row) = (x >> 8 & (side - 1), y >> 8 & (side - 1));
            above[i] = row * (side + 1) + column;
            below[i] = ((row + 1) & (side - 1)) * (side + 1) + column;
            let (right, lower) = (x >> 2 & 63, y >> 2 & 63);
            across[i] = ((64 - right) | (right << 8)) as u16;
            down[i] = (64 - lower) | (lower << 16);
        }
        let pair = |at: u32| texels[at as usize..].first_chunk::<2>().copied().unwrap_or_default();
        let (mixer, mut colours, mut leans) = (Mixer::new(), [[0_i32; 4]; SPAN], [[0_i32; 4]; SPAN]);
        for i in 0..span.count.min(SPAN) {
            [colours[i], leans[i]] = mixer.means([pair(above[i]), pair(below[i])], across[i], down[i]);
        }
        let (tint, half) = (1.0 / (4096.0 * 128.0), 1.0 / (4096.0 * 64.0));
        for i in 0..SPAN {
            let [red, green, blue, roughness] = colours[i];
            span.tint[0][i] = red as f32 * tint;
            span.tint[1][i] = green as f32 * tint;
            span.tint[2][i] = blue as f32 * tint;
            span.roughness[i] = roughness as f32 * half;
        }
        if self.leans[level] {
            for i in 0..SPAN {
                span.lean[0][i] = (leans[i][0] - 4096 * 128) as f32 * half;
                span.lean[1][i] = (leans[i][1] - 4096 * 128) as f32 * half;
            }
        } else {
            span.lean = [[0.0; SPAN]; 2];
        }
    }
}

/// Rows with their first texel at their end once more.
fn closed(texels: &[Texel]) -> Vec<Texel> {
    let side = texels.len().isqrt();
    texels.chunks(side).flat_map(|row| row.iter().chain(&row[..1]).copied()).collect()
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

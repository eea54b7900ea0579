//! Textures as tiles of texels with coarser copies, made once per process.

use std::sync::LazyLock;

use super::Pattern;
use crate::simd::whole;

/// A point of a texture as it is kept, a byte each: what red, green and blue are multiplied
/// with (128 is one), and the roughness (64 is one); how the normal leans along u and v
/// (64 is one, 128 is none).
type Texel = u64;

/// Every other byte.
const EVEN: u64 = 0x00ff_00ff_00ff_00ff;

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
            Texel::from_le_bytes([r, g, b, roughness, lu, lv, 0, 0])
        };
        let mut levels = vec![(0..texels * texels).map(texel).collect::<Vec<Texel>>()];
        while levels.last().is_some_and(|l| l.len() > 1) {
            levels.extend(levels.last().map(|l| halved(l)));
        }
        // Less than a thirtieth is not seen.
        let even = |texel: &Texel| texel.to_le_bytes()[4..6].iter().all(|lean| lean.abs_diff(128) < 2);
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
            tint: [0, 1, 2].map(|c: usize| span.tint[c][0]),
            roughness: span.roughness[0],
            lean: [span.lean[0][0], span.lean[1][0]],
        }
    }

    /// The texture at the places of a span.
    #[inline(always)]
    pub(crate) fn span(&self, level: usize, span: &mut Span) {
        // Tiles to a metre, and parts of 256 of a texel to a tile.
        let (scale, parts) = (self.density / self.texels as f32, ((self.texels >> level) * 256) as f32);
        let (mut xs, mut ys) = ([0_u32; SPAN], [0_u32; SPAN]);
        for i in 0..SPAN {
            let (u, v) = (span.u[i] * scale, span.v[i] * scale);
            // From a texel's middle to its corner.
            xs[i] = whole((u - u.floor()) * parts).wrapping_sub(128);
            ys[i] = whole((v - v.floor()) * parts).wrapping_sub(128);
        }
        let (mut even, mut odd) = ([[0_u32; SPAN]; 2], [[0_u32; SPAN]; 2]);
        let (texels, bits) = (self.levels[level].as_slice(), (self.texels >> level).trailing_zeros());
        for i in 0..span.count.min(SPAN) {
            let (a, b) = between(texels, bits, xs[i], ys[i]);
            (even[0][i], even[1][i]) = (a as u32, (a >> 32) as u32);
            (odd[0][i], odd[1][i]) = (b as u32, (b >> 32) as u32);
        }
        let low = |v: u32| (v & 0xffff) as i32 as f32;
        let high = |v: u32| (v >> 16) as i32 as f32;
        let tint = 1.0 / (256.0 * 128.0);
        let half = 1.0 / (256.0 * 64.0);
        for i in 0..SPAN {
            span.tint[0][i] = low(even[0][i]) * tint;
            span.tint[1][i] = low(odd[0][i]) * tint;
            span.tint[2][i] = high(even[0][i]) * tint;
            span.roughness[i] = high(odd[0][i]) * half;
            span.lean[0][i] = (low(even[1][i]) - 32_768.0) * half;
            span.lean[1][i] = (low(odd[1][i]) - 32_768.0) * half;
        }
    }
}

/// Even and odd bytes between four texels, each in sixteen bits, for a place in parts of 256.
#[inline(always)]
fn between(texels: &[Texel], bits: u32, x: u32, y: u32) -> (u64, u64) {
    let mask = (1 << bits) - 1;
    let (x0, y0) = (x >> 8 & mask, y >> 8 & mask);
    let (x1, y1) = ((x0 + 1) & mask, (y0 + 1) & mask);
    // Weights sum to 256, so that sums stay within the sixteen bits each byte has.
    let (fx, fy) = (u64::from(x & 255), u64::from(y & 255));
    let both = (fx * fy) >> 8;
    let texel = |x: u32, y: u32| texels[(y << bits | x) as usize];
    let (a, b, c, d) = (texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1));
    let (wa, wb, wc) = (256 + both - fx - fy, fx - both, fy - both);
    let even = (a & EVEN) * wa + (b & EVEN) * wb + (c & EVEN) * wc + (d & EVEN) * both;
    let odd = (a >> 8 & EVEN) * wa + (b >> 8 & EVEN) * wb + (c >> 8 & EVEN) * wc + (d >> 8 & EVEN) * both;
    (even, odd)
}

/// Means of two by two.
fn halved(fine: &[Texel]) -> Vec<Texel> {
    let side = fine.len().isqrt();
    let half = side / 2;
    let mean = |i: usize| {
        let (x, y) = (i % half * 2, i / half * 2);
        let four = [fine[y * side + x], fine[y * side + x + 1], fine[(y + 1) * side + x], fine[(y + 1) * side + x + 1]];
        let sum = |bytes: u64| four.iter().map(|t| t >> bytes & EVEN).sum::<u64>();
        let mean = |sum: u64| (sum + 2 * 0x0001_0001_0001_0001) >> 2 & EVEN;
        mean(sum(0)) | mean(sum(8)) << 8
    };
    (0..half * half).map(mean).collect()
}

//! Tiles of procedural textures with coarser copies (mipmaps), made once in a process.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::sync::LazyLock;

use super::Pattern;
use super::mean::{Mixer, Pair, Shares, mean};
use crate::math::simd::whole;
use crate::math::three;

/// A stored texel of four bytes: either the factors for red, green and blue (128 is one) and roughness (64 is
/// one), or the tilt of the normal along u and v (128 is none, 64 more is one). Few lookups need both, so they
/// are stored apart.
type Texel = [u8; 4];

/// One mipmap level.
#[derive(Debug)]
struct Level {
    colours: Vec<Texel>,
    /// None if no texel tilts the normal visibly.
    leans: Option<Vec<Texel>>,
    /// The mean, if all texels look about the same.
    even: Option<Touch>,
}

/// A procedural texture and its coarser copies, each half the size of the one before.
#[derive(Debug)]
pub(crate) struct Tile {
    /// Each row ends with a repetition of its first texel, and each level with a repetition of its first row.
    levels: Vec<Level>,
    texels: usize,
    /// Texels for each metre.
    density: f32,
}

/// Number of pixels whose texture is looked up together.
pub(crate) const SPAN: usize = 8;

/// The texture at neighbouring pixels.
pub(crate) struct Span {
    pub(crate) tint: [[f32; SPAN]; 3],
    pub(crate) roughness: [f32; SPAN],
    /// None if normals are not tilted.
    pub(crate) lean: Option<[[f32; SPAN]; 2]>,
}

/// Scale from the computed means, which are 64 times too large.
const MEAN: f32 = 1.0 / 64.0;
/// The byte that stands for one, in tints, and in roughness and tilt.
const TINT: f32 = 128.0;
const SHARE: f32 = 64.0;

/// Effect of a texture on colour, roughness and normal.
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
    pub(crate) fn for_pattern(pattern: Pattern) -> &'static Self {
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
            ([r, g, b, roughness], [lu, lv, 0, 0])
        };
        let (colours, leans) = (0..texels * texels).map(texel).unzip();
        let levels = coarser(colours).into_iter().zip(coarser(leans)).map(|(colours, leans)| {
            let leans = seen(&leans).then(|| closed(&leans));
            Level { even: even(&colours), colours: closed(&colours), leans }
        });
        Self { levels: levels.collect(), texels, density: texels as f32 / pattern.side() }
    }

    /// The mipmap level for a pixel that is `footprint` metres wide.
    #[inline(always)]
    pub(crate) fn level(&self, footprint: f32) -> usize {
        // The exponent of a float is the integer part of its base-2 logarithm.
        let texels = footprint * self.density * 1.5;
        let exponent = (texels.to_bits() >> 23) as i32 - 127;
        exponent.clamp(0, self.levels.len() as i32 - 1) as usize
    }

    /// The mean of a level, if all its texels look about the same.
    #[inline(always)]
    pub(crate) fn even(&self, level: usize) -> Option<&Touch> {
        let level = &self.levels[level];
        level.even.as_ref().filter(|_| level.leans.is_none())
    }

    /// The texture at a place in metres, interpolated between the four nearest texels.
    #[inline(always)]
    pub(crate) fn at(&self, level: usize, u: f32, v: f32) -> Touch {
        let ([first], Shares { right, lower }) = self.places(level, [&[u], &[v]]);
        let (row, Level { colours, leans, .. }) = (self.row(level), &self.levels[level]);
        let mean = |texels: &[Texel]| mean(four(texels, row, first), [right[0], lower[0]]).map(f32::from);
        let (colour, lean) = (mean(colours), leans.as_ref().map(|leans| mean(leans)));
        Touch {
            tint: three(|c| colour[c] * (MEAN / TINT)),
            roughness: colour[3] * (MEAN / SHARE),
            lean: lean.map_or([0.0; 2], |lean| [lean[0], lean[1]].map(|v| (v * MEAN - 128.0) / SHARE)),
        }
    }

    /// The texture at several places, metres.
    #[inline(always)]
    pub(crate) fn span(&self, level: usize, at: [&[f32; SPAN]; 2]) -> Span {
        let (first, shares) = self.places(level, at);
        let (row, Level { colours, leans, even }) = (self.row(level), &self.levels[level]);
        let means = |texels: &[Texel]| means((texels, row), (&first, &shares));
        let (tint, roughness) = match even {
            Some(even) => (even.tint.map(|tint| [tint; SPAN]), [even.roughness; SPAN]),
            None => {
                let (means, mut tint, mut roughness) = (means(colours), [[0.0; SPAN]; 3], [0.0; SPAN]);
                for i in 0..SPAN {
                    tint[0][i] = f32::from(means[0][i]) * (MEAN / TINT);
                    tint[1][i] = f32::from(means[1][i]) * (MEAN / TINT);
                    tint[2][i] = f32::from(means[2][i]) * (MEAN / TINT);
                    roughness[i] = f32::from(means[3][i]) * (MEAN / SHARE);
                }
                (tint, roughness)
            }
        };
        let lean = leans.as_ref().map(
            #[inline(always)]
            |leans| {
                let (means, mut lean) = (means(leans), [[0.0; SPAN]; 2]);
                for i in 0..SPAN {
                    lean[0][i] = (f32::from(means[0][i]) * MEAN - 128.0) / SHARE;
                    lean[1][i] = (f32::from(means[1][i]) * MEAN - 128.0) / SHARE;
                }
                lean
            },
        );
        Span { tint, roughness, lean }
    }

    /// Number of texels in a row of a level.
    #[inline(always)]
    fn row(&self, level: usize) -> usize {
        (self.texels >> level) + 1
    }

    /// The upper left of the four texels around each place, and the interpolation weights.
    #[inline(always)]
    fn places<const N: usize>(&self, level: usize, [us, vs]: [&[f32; N]; 2]) -> ([u32; N], Shares<N>) {
        let (mut first, mut shares) = ([0; N], Shares { right: [0; N], lower: [0; N] });
        // Scale from metres to tiles, and from a tile to 256ths of a texel.
        let side = (self.texels >> level) as u32;
        let (last, power) = (side - 1, side.trailing_zeros());
        let (scale, parts) = (self.density / self.texels as u32 as f32, (side * 256) as f32);
        for i in 0..N {
            let (u, v) = (us[i] * scale, vs[i] * scale);
            // Measured from the centre of a texel.
            let x = whole((u - u.floor()) * parts).wrapping_sub(128);
            let y = whole((v - v.floor()) * parts).wrapping_sub(128);
            let (column, row) = (x >> 8 & last, y >> 8 & last);
            first[i] = (row << power) + row + column;
            (shares.right[i], shares.lower[i]) = ((x >> 2 & 63) as u16, (y >> 2 & 63) as u16);
        }
        (first, shares)
    }
}

/// Whether the tilt of normals is visible: at least a fortieth on average. The effect on light is half of that.
fn seen(leans: &[Texel]) -> bool {
    let square = |texel: &Texel| texel[..2].iter().map(|lean| u64::from(lean.abs_diff(128)).pow(2)).sum::<u64>();
    let all: u64 = leans.iter().map(square).sum();
    all * 40 * 40 >= leans.len() as u64 * 64 * 64
}

/// The mean of the colours, if they differ too little from it to be visible: by three quarters of a hundredth
/// on average, about half a step of an 8-bit colour.
fn even(texels: &[Texel]) -> Option<Touch> {
    let (count, mean) = (texels.len() as f32, average(texels));
    let square = |v: f32| v * v;
    let spread = |k: usize| texels.iter().map(|t| square(f32::from(t[k]) - mean[k])).sum::<f32>() / count;
    let alike = (0..4).all(|k| spread(k) <= square(0.0075 * mean[k]));
    alike.then(|| touch(&mean))
}

/// The mean of texels.
fn average(texels: &[Texel]) -> [f32; 4] {
    let count = texels.len() as f32;
    std::array::from_fn(|k| texels.iter().map(|t| f32::from(t[k])).sum::<f32>() / count)
}

/// Decodes a mean of texels.
fn touch(mean: &[f32; 4]) -> Touch {
    Touch { tint: three(|c| mean[c] / TINT), roughness: mean[3] / SHARE, lean: [0.0; 2] }
}

/// Four texels: one and the next to its right, and the two below, `row` texels further on.
#[inline(always)]
fn four(texels: &[Texel], row: usize, at: u32) -> [&Pair; 2] {
    let at = at as usize;
    let texels = &texels[at..at + row + 2];
    [&texels[..2], &texels[row..]].map(|pair| pair.first_chunk().expect("two are left"))
}

/// Bilinear means at several places.
#[inline(always)]
fn means((texels, row): (&[Texel], usize), (first, shares): (&[u32; SPAN], &Shares<SPAN>)) -> [[i16; SPAN]; 4] {
    Mixer::new().means(
        #[inline(always)]
        |i| four(texels, row, first[i]),
        shares,
    )
}

/// The mipmap chain of texels, down to a single one.
fn coarser(texels: Vec<Texel>) -> Vec<Vec<Texel>> {
    let mut levels = vec![texels];
    while levels.last().is_some_and(|l| l.len() > 1) {
        levels.extend(levels.last().map(|l| halved(l)));
    }
    levels
}

/// Appends to each row a repetition of its first texel, and at the end a repetition of the first row.
fn closed(texels: &[Texel]) -> Vec<Texel> {
    let side = texels.len().isqrt();
    let rows = texels.chunks(side).chain([&texels[..side]]);
    rows.flat_map(|row| row.iter().chain(&row[..1]).copied()).collect()
}

/// Averages blocks of two by two.
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

#[cfg(test)]
mod tests {
    use super::super::pattern_mean::MEANS;
    use super::*;

    #[test]
    fn means_are_those_of_the_tiles() {
        for (pattern, (tint, roughness)) in Pattern::ALL.into_iter().zip(MEANS) {
            let tile = Tile::for_pattern(pattern);
            // Leaves out the repeated row and column.
            let rows = tile.levels[0].colours.chunks(tile.row(0)).take(tile.texels);
            let texels: Vec<Texel> = rows.flat_map(|row| &row[..tile.texels]).copied().collect();
            let (found, near) = (touch(&average(&texels)), |a: f32, b: f32| (a - b).abs() < 1e-3);
            assert!((0..3).all(|c| near(found.tint[c], tint[c])), "{pattern:?}: {found:?}");
            assert!(near(found.roughness, roughness), "{pattern:?}: {found:?}");
        }
    }
}

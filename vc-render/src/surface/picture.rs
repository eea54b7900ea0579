//! Image textures, with coarser copies (mipmaps).

use std::sync::Arc;

use vc_graph::asset::Texture;

use crate::colour::decoded;
use crate::math::three;

/// An image texture, interpolated between its texels.
#[derive(Debug)]
pub(crate) struct Picture {
    texture: Arc<Texture>,
    /// Coarser copies, each half the size of the one before.
    coarser: Vec<Level>,
}

#[derive(Debug)]
struct Level {
    size: [usize; 2],
    pixels: Vec<[u8; 3]>,
}

/// A picture's size, across and down, and its pixels.
type Pixels<'a> = ([usize; 2], &'a [[u8; 3]]);

impl PartialEq for Picture {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.texture, &other.texture)
    }
}

impl Picture {
    pub(crate) fn new(texture: &Arc<Texture>) -> Self {
        let mut picture = Self { texture: texture.clone(), coarser: Vec::new() };
        while let Some(level) = halved(picture.pixels(picture.coarser.len())) {
            picture.coarser.push(level);
        }
        picture
    }

    fn pixels(&self, level: usize) -> Pixels<'_> {
        match level.checked_sub(1).and_then(|l| self.coarser.get(l)) {
            Some(level) => (level.size, &level.pixels),
            None => ([self.texture.width as usize, self.texture.height as usize], &self.texture.pixels),
        }
    }

    /// Square root of the number of texels on a triangle, given its texture coordinates.
    pub(crate) fn texels(&self, [a, b, c]: [[f32; 2]; 3]) -> f32 {
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        (0.5 * twice.abs() * self.texture.width as f32 * self.texture.height as f32).sqrt()
    }

    /// The mipmap level for a pixel that is `texels` texels wide.
    #[inline(always)]
    pub(crate) fn level(&self, texels: f32) -> usize {
        // The exponent of a float is the integer part of its base-2 logarithm.
        let exponent = ((1.5 * texels).to_bits() >> 23 & 255) as i32 - 127;
        exponent.clamp(0, self.coarser.len() as i32) as usize
    }

    /// The linear colour at a place, interpolated between the four nearest texels.
    #[inline(always)]
    pub(crate) fn at(&self, level: usize, [u, v]: [f32; 2]) -> [f32; 3] {
        let ([width, height], pixels) = self.pixels(level);
        let ([x0, x1], right) = between(u, width);
        let ([y0, y1], down) = between(v, height);
        let texel = |x: usize, y: usize| pixels.get(y * width + x).map_or([0.0; 3], |p| decoded(*p));
        let (a, b, c, d) = (texel(x0, y0), texel(x1, y0), texel(x0, y1), texel(x1, y1));
        three(|i| {
            let (upper, lower) = (a[i] + (b[i] - a[i]) * right, c[i] + (d[i] - c[i]) * right);
            upper + (lower - upper) * down
        })
    }

    /// Its mean colour.
    pub(crate) fn mean(&self) -> [f32; 3] {
        self.pixels(self.coarser.len()).1.first().map_or([1.0; 3], |p| decoded(*p))
    }
}

/// The two texels around a place in a periodic row, and the weight of the second.
#[inline(always)]
fn between(share: f32, count: usize) -> ([usize; 2], f32) {
    // Measured from the centre of a texel, and one period ahead to stay positive.
    let at = (share - share.floor() + 1.0) * count as f32 - 0.5;
    let low = (at as usize).min(2 * count - 1);
    let first = if low >= count { low - count } else { low };
    let second = if first + 1 == count { 0 } else { first + 1 };
    ([first, second], at - low as f32)
}

/// The next coarser level, by averaging; none for a single pixel.
fn halved((size, fine): Pixels<'_>) -> Option<Level> {
    if size == [1, 1] {
        return None;
    }
    let half = size.map(|s| (s / 2).max(1));
    let row = |y: usize| (0..half[0]).map(move |x| [x, y]);
    let pixels = (0..half[1]).flat_map(row).map(|at| {
        let from = [0, 1].map(|i: usize| at[i] * size[i] / half[i]);
        let to = [0, 1].map(|i: usize| (at[i] + 1) * size[i] / half[i]);
        let mut sum = [0.0; 3];
        for pixel in (from[1]..to[1]).flat_map(|y| &fine[y * size[0] + from[0]..y * size[0] + to[0]]) {
            let light = decoded(*pixel);
            (0..3).for_each(|i| sum[i] += light[i]);
        }
        let over = 1.0 / ((to[0] - from[0]) * (to[1] - from[1])) as f32;
        sum.map(|light| nearest(light * over))
    });
    Some(Level { size: half, pixels: pixels.collect() })
}

/// The sRGB byte whose linear value is nearest: repeated averaging must not drift.
fn nearest(light: f32) -> u8 {
    let value = |byte: u8| decoded([byte; 3])[0];
    let (mut low, mut high) = (0_u8, 255_u8);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        (low, high) = if value(middle) <= light { (middle, high) } else { (low, middle) };
    }
    if light - value(low) <= value(high) - light { low } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(width: u32, height: u32, pixels: Vec<[u8; 3]>) -> Picture {
        Picture::new(&Arc::new(Texture { name: "test".into(), width, height, pixels }))
    }

    #[test]
    fn middles_of_texels_are_their_own_colour() {
        let pixels: Vec<[u8; 3]> = (0..15).map(|i| [17 * i, 255 - 17 * i, 40]).collect();
        let picture = picture(5, 3, pixels.clone());
        for (index, pixel) in pixels.into_iter().enumerate() {
            let (x, y) = (index % 5, index / 5);
            // The texture is periodic.
            for around in [-2.0, 0.0, 3.0] {
                let place = [(x as f32 + 0.5) / 5.0 + around, (y as f32 + 0.5) / 3.0 - around];
                let (found, wanted) = (picture.at(0, place), decoded(pixel));
                assert!((0..3).all(|i| (found[i] - wanted[i]).abs() < 1e-4), "{x} {y}: {found:?} {wanted:?}");
            }
        }
    }

    #[test]
    fn coarser_copies_keep_the_light() {
        let board: Vec<[u8; 3]> =
            (0..64 * 64).map(|i| if (i % 64 + i / 64) % 2 == 0 { [255; 3] } else { [0; 3] }).collect();
        let picture = picture(64, 64, board);
        assert!((picture.mean()[0] - 0.5).abs() < 0.01);
        let level = picture.level(8.0);
        assert_eq!(level, 3);
        assert!((picture.at(level, [0.123, 0.456])[1] - 0.5).abs() < 0.01);
        assert_eq!(picture.level(0.0), 0);
        assert_eq!(picture.level(f32::INFINITY), 6);
    }
}

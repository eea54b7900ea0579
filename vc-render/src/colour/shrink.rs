//! Downsampling of supersampled colours.

use rayon::prelude::*;

use super::srgb::{decoded, encoded};

/// Half a step of the encoding table, which rounds down.
const HALF: f32 = 0.5 / 4095.0;

/// Writes the mean light of each square of `times` by `times` pixels, in rows of a width.
pub(crate) fn shrink(fine: &[[u8; 3]], times: usize, (width, rgb): (usize, &mut Vec<[u8; 3]>)) {
    rgb.resize(fine.len() / (times * times), [0; 3]);
    let over = 1.0 / (times * times) as f32;
    rgb.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
        for (x, pixel) in row.iter_mut().enumerate() {
            let mut sum = [0.0; 3];
            for line in 0..times {
                let first = ((y * times + line) * width + x) * times;
                for colour in &fine[first..first + times] {
                    let light = decoded(*colour);
                    (0..3).for_each(|i| sum[i] += light[i]);
                }
            }
            *pixel = encoded(sum.map(|light| light * over + HALF));
        }
    });
}

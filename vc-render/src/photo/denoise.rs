//! Smoothing along surfaces: an edge-avoiding wavelet (Dammertz and others 2010), that looks at
//! how noisy each pixel is (Schied and others 2017). Light is smoothed without the colour
//! of the surfaces, so that textures stay.

use rayon::prelude::*;

use super::path::Traced;
use crate::light::{brightness, dot};

/// Passes; each reaches twice as far as the one before.
const PASSES: u32 = 5;
/// Weights of neighbours along an axis.
const KERNEL: [f32; 5] = [1.0 / 16.0, 1.0 / 4.0, 3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];

/// A pixel while it is smoothed.
#[derive(Clone, Copy)]
struct Soft {
    /// Light over reflectance.
    light: [f32; 3],
    /// Variance of its brightness.
    variance: f32,
}

/// What edges are told by.
struct Guide {
    colour: [f32; 3],
    normal: [f32; 3],
    inverse: f32,
}

pub(super) fn denoised(traced: &[Traced], width: usize) -> Vec<[f32; 3]> {
    let guides: Vec<Guide> = traced.iter().map(Guide::of).collect();
    let mut soft: Vec<Soft> = traced.iter().zip(&guides).map(|(t, g)| Soft::of(t, g)).collect();
    dim_specks(&mut soft, width);
    spread_variance(&mut soft, width);
    for pass in 0..PASSES {
        soft = smoothed(&soft, &guides, width, 1 << pass);
    }
    soft.iter().zip(&guides).map(|(s, g)| [0, 1, 2].map(|i: usize| s.light[i] * g.colour[i])).collect()
}

impl Guide {
    fn of(traced: &Traced) -> Self {
        let over = 1.0 / traced.count.max(1.0);
        Self {
            colour: traced.sum.colour.map(|v| (v * over).max(0.02)),
            normal: traced.sum.normal.map(|v| v * over),
            inverse: traced.sum.inverse * over,
        }
    }
}

impl Soft {
    fn of(traced: &Traced, guide: &Guide) -> Self {
        let light = traced.light();
        let (count, bright) = (traced.count.max(1.0), brightness(light));
        let spread = (traced.squares / count - bright * bright).max(0.0) / count;
        // With few paths the spread found is not to be trusted.
        let spread = spread + bright * bright / (count * count);
        let colour = brightness(guide.colour);
        Self { light: [0, 1, 2].map(|i: usize| light[i] / guide.colour[i]), variance: spread / (colour * colour) }
    }
}

/// A pixel brighter than all its neighbours is as bright as the brightest of them.
fn dim_specks(soft: &mut [Soft], width: usize) {
    let bright: Vec<f32> = soft.iter().map(|s| brightness(s.light)).collect();
    let (columns, rows) = (width as i32, (soft.len() / width.max(1)) as i32);
    soft.par_iter_mut().enumerate().for_each(|(index, pixel)| {
        let (x, y) = (index as i32 % columns, index as i32 / columns);
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy))).filter(|p| *p != (x, y));
        let inside = around.filter(|(x, y)| (0..columns).contains(x) && (0..rows).contains(y));
        let most = inside.map(|(x, y)| bright[(y * columns + x) as usize]).fold(0.0, f32::max);
        if bright[index] > most && most > 0.0 {
            let share = most / bright[index];
            pixel.light = pixel.light.map(|v| v * share);
            pixel.variance *= share * share;
        }
    });
}

/// Each pixel is as noisy as those around it: where paths are few, one may have found no
/// light at all and seem free of noise.
fn spread_variance(soft: &mut [Soft], width: usize) {
    let own: Vec<f32> = soft.iter().map(|s| s.variance).collect();
    let (columns, rows) = (width as i32, (soft.len() / width.max(1)) as i32);
    soft.par_iter_mut().enumerate().for_each(|(index, pixel)| {
        let (x, y) = (index as i32 % columns, index as i32 / columns);
        let around = (-3..=3).flat_map(|dy| (-3..=3).map(move |dx| (x + dx, y + dy)));
        let inside = around.filter(|(x, y)| (0..columns).contains(x) && (0..rows).contains(y));
        let (sum, count) = inside.fold((0.0, 0.0), |(s, n), (x, y)| (s + own[(y * columns + x) as usize], n + 1.0));
        pixel.variance = sum / count;
    });
}

fn smoothed(soft: &[Soft], guides: &[Guide], width: usize, step: i32) -> Vec<Soft> {
    let height = soft.len() / width.max(1);
    let pixel = |index: usize| {
        let (x, y) = ((index % width) as i32, (index / width) as i32);
        let (own, guide) = (&soft[index], &guides[index]);
        let noise = 4.0 * own.variance.sqrt() + 1e-4;
        let (mut light, mut variance, mut total) = ([0.0; 3], 0.0, 0.0);
        for (dy, wy) in (-2..=2).zip(KERNEL) {
            for (dx, wx) in (-2..=2).zip(KERNEL) {
                let (tx, ty) = (x + dx * step, y + dy * step);
                if tx < 0 || ty < 0 || tx >= width as i32 || ty >= height as i32 {
                    continue;
                }
                let there = ty as usize * width + tx as usize;
                let (other, edge) = (&soft[there], &guides[there]);
                let turned = dot(guide.normal, edge.normal).max(0.0);
                let turned = if guide.inverse == 0.0 && edge.inverse == 0.0 { 1.0 } else { turned };
                let turned = turned * turned * turned * turned;
                let turned = turned * turned * turned * turned;
                let apart = (guide.inverse - edge.inverse).abs() / guide.inverse.max(1e-4);
                let unlike = (brightness(own.light) - brightness(other.light)).abs() / noise;
                let weight = wx * wy * turned
                    / (1.0 + (apart * 12.0 / step as f32 * 4.0) * (apart * 12.0))
                    / (1.0 + unlike * unlike);
                light.iter_mut().zip(other.light).for_each(|(sum, value)| *sum += weight * value);
                variance += weight * weight * other.variance;
                total += weight;
            }
        }
        if total <= 0.0 {
            return *own;
        }
        Soft { light: light.map(|v| v / total), variance: variance / (total * total) }
    };
    (0..soft.len()).into_par_iter().map(pixel).collect()
}

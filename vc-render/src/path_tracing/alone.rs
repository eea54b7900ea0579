//! Isolated pieces of pixels, which resemble no neighbour: in round glass, or where things are smaller than
//! pixels. Smoothing along surfaces would leave them noisy. They are blended with the light around them, the
//! more the noisier they are, and then scaled so that together they stay as bright as the paths found them.

use rayon::prelude::*;

use super::denoise::Plane;
use super::walk::SCATTERED;
use crate::colour::luminance;
use crate::math::three;

/// A piece is isolated if the pieces like it around it fill less than this many whole pixels: a piece along a
/// line has two.
const FEW: f32 = 1.0;
/// Distance up to which light is averaged, and up to which isolated pieces share their brightness, pixels.
const REACH: i32 = 2;
const SHARING: i32 = 3;
/// Relative noise at which the light around counts half.
const NOISY: f32 = 0.15;
/// Number of paths needed for their light to count as much as the smoothed light, which is less noisy.
const TRUSTED: f32 = 200.0;

impl Plane<'_> {
    /// For each piece, whether few pieces around are like it.
    pub(super) fn alone(&self) -> Vec<bool> {
        let kin = |index: usize| {
            let others = self.around(index, 1, 1).filter(|(dx, dy, _)| (*dx, *dy) != (0, 0));
            others.map(|(.., there)| self.like(index, there) * self.guides[there].share).sum::<f32>()
        };
        (0..self.guides.len()).into_par_iter().map(|index| kin(index) < FEW).collect()
    }

    /// Blends isolated pieces with the light around them.
    pub(super) fn mend(&self, alone: &[bool], light: &mut [[f32; 3]]) {
        let lonely: Vec<usize> = (0..alone.len()).filter(|i| alone[*i]).collect();
        let smooth = &*light;
        let piece = |index: &usize| {
            let (found, noise) = self.found(*index);
            let share = noise / (noise + NOISY * NOISY);
            let mean = self.mean_around(smooth, *index);
            three(|i| found[i] + share * (mean[i] - found[i]))
        };
        let made: Vec<[f32; 3]> = lonely.par_iter().map(piece).collect();
        lonely.iter().zip(made).for_each(|(index, made)| light[*index] = made);
        self.even_out((alone, &lonely), light);
    }

    /// Light that paths found on a piece, and the variance of its brightness relative to the square of that.
    fn found(&self, index: usize) -> ([f32; 3], f32) {
        let kinds = SCATTERED.map(|kind| self.traced[index].light_of(kind));
        let light = three(|i| kinds.iter().map(|(light, _)| light[i]).sum());
        let variance: f32 = kinds.iter().map(|(_, variance)| variance).sum();
        (light, variance / (luminance(light) * luminance(light)).max(1e-12))
    }

    /// Scales isolated pieces so that they, together with other isolated ones around, are as bright as the
    /// paths found there: gaps are darker than the surfaces beside them.
    fn even_out(&self, (alone, lonely): (&[bool], &[usize]), light: &mut [[f32; 3]]) {
        let made = &*light;
        let share = |index: &usize| {
            let others = self.around(*index, SHARING, 1).filter(|(.., there)| alone[*there]);
            let trusted = TRUSTED / self.traced[*index].count().max(1.0) * luminance(made[*index]) + 1e-9;
            let sums = others.fold([trusted; 2], |[found, mended], (.., there)| {
                let weight = self.guides[there].share;
                [found + weight * luminance(self.found(there).0), mended + weight * luminance(made[there])]
            });
            sums[0] / sums[1]
        };
        let shares: Vec<f32> = lonely.par_iter().map(share).collect();
        lonely.iter().zip(shares).for_each(|(index, share)| light[*index] = light[*index].map(|v| v * share));
    }

    /// The mean light around a piece, recoloured with its own reflectance.
    fn mean_around(&self, light: &[[f32; 3]], index: usize) -> [f32; 3] {
        let (mut sum, mut total) = ([0.0; 3], 1e-9);
        for (.., there) in self.around(index, REACH, 1) {
            let (light, guide) = (light[there], &self.guides[there]);
            sum = three(|i| sum[i] + guide.share * light[i] / guide.colour[i]);
            total += guide.share;
        }
        three(|i| sum[i] / total * self.guides[index].colour[i])
    }
}

//! Pieces of pixels that no neighbour is like, in round glass or where things are finer than pixels: smoothing along
//! surfaces leaves them as noisy as they are. They get the light around them, the more the noisier they are, and
//! all together as much as was found.

use rayon::prelude::*;

use super::denoise::Plane;
use super::path::SCATTERED;
use crate::affine::three;
use crate::light::brightness;

/// Pieces that are like fewer whole pixels of the eight around them are alone: along a line two are.
const FEW: f32 = 1.0;
/// How far away, pixels, light is taken from, and others with which it shares what light was found.
const REACH: i32 = 2;
const SHARING: i32 = 3;
/// Noise, in shares of the light, at which half is of around.
const NOISY: f32 = 0.15;
/// How many paths have to find light for it to count as much as what lies around: there is less noise in that.
const TRUSTED: f32 = 200.0;

impl Plane<'_> {
    /// Which pieces are like few of those around them.
    pub(super) fn alone(&self) -> Vec<bool> {
        let kin = |index: usize| {
            let others = self.around(index, 1, 1).filter(|(dx, dy, _)| (*dx, *dy) != (0, 0));
            others.map(|(.., there)| self.like(index, there) * self.guides[there].share).sum::<f32>()
        };
        (0..self.guides.len()).into_par_iter().map(|index| kin(index) < FEW).collect()
    }

    /// Gives pieces that are alone light from around them.
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

    /// Light that paths found on a piece, and the variance of its brightness in shares of that.
    fn found(&self, index: usize) -> ([f32; 3], f32) {
        let kinds = SCATTERED.map(|kind| self.traced[index].light_of(kind));
        let light = three(|i| kinds.iter().map(|(light, _)| light[i]).sum());
        let variance: f32 = kinds.iter().map(|(_, variance)| variance).sum();
        (light, variance / (brightness(light) * brightness(light)).max(1e-12))
    }

    /// Makes pieces that are alone as bright, together with others around that are, as what was found there: it is
    /// darker in gaps than beside them.
    fn even_out(&self, (alone, lonely): (&[bool], &[usize]), light: &mut [[f32; 3]]) {
        let made = &*light;
        let share = |index: &usize| {
            let others = self.around(*index, SHARING, 1).filter(|(.., there)| alone[*there]);
            let trusted = TRUSTED / self.traced[*index].count().max(1.0) * brightness(made[*index]) + 1e-9;
            let sums = others.fold([trusted; 2], |[found, mended], (.., there)| {
                let weight = self.guides[there].share;
                [found + weight * brightness(self.found(there).0), mended + weight * brightness(made[there])]
            });
            sums[0] / sums[1]
        };
        let shares: Vec<f32> = lonely.par_iter().map(share).collect();
        lonely.iter().zip(shares).for_each(|(index, share)| light[*index] = light[*index].map(|v| v * share));
    }

    /// The mean light around a piece, on its own colour.
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

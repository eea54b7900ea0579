//! What all paths of a picture have found so far.

use super::path::{KINDS, Kind, SCATTERED, Sample};
use crate::affine::three;
use crate::light::brightness;

/// What all paths of a pixel found.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Traced {
    sum: Sample,
    /// Sums of squares of brightness, of all kinds of light.
    squares: [f32; KINDS],
    count: f32,
}

impl Traced {
    pub(super) fn add(&mut self, one: &Sample) {
        let add = |sum: &mut [f32; 3], more: [f32; 3]| (0..3).for_each(|i| sum[i] += more[i]);
        for (kind, light) in one.light.into_iter().enumerate() {
            add(&mut self.sum.light[kind], light);
            self.squares[kind] += brightness(light) * brightness(light);
        }
        add(&mut self.sum.colour, one.colour);
        add(&mut self.sum.normal, one.normal);
        add(&mut self.sum.at, one.at);
        self.sum.glass += one.glass;
        self.count += 1.0;
    }

    /// How many paths there were.
    pub(super) fn paths(&self) -> f32 {
        self.count.max(1.0)
    }

    fn mean(&self, sum: [f32; 3]) -> [f32; 3] {
        sum.map(|v| v / self.paths())
    }

    /// Mean light.
    pub(super) fn light(&self) -> [f32; 3] {
        self.mean(three(|i| self.sum.light.iter().map(|light| light[i]).sum()))
    }

    /// Mean light of one kind, and the variance of the mean's brightness.
    pub(super) fn light_of(&self, kind: Kind) -> ([f32; 3], f32) {
        let kind = kind as usize;
        let light = self.mean(self.sum.light[kind]);
        let (count, bright) = (self.paths(), brightness(light));
        let spread = (self.squares[kind] / count - bright * bright).max(0.0) / count;
        // With few paths the spread found is not to be trusted.
        (light, spread + bright * bright / (count * count))
    }

    /// Mean light that surfaces throw back, noise and all.
    pub(super) fn scattered(&self) -> [f32; 3] {
        let kinds = SCATTERED.map(|kind| self.light_of(kind).0);
        three(|i| kinds.iter().map(|light| light[i]).sum())
    }

    /// Mean share of light that glass before the first surface reflects.
    pub(super) fn glass(&self) -> f32 {
        self.sum.glass / self.paths()
    }

    /// Mean reflectance, normal and place of the first surface.
    pub(super) fn guides(&self) -> [[f32; 3]; 3] {
        [self.sum.colour, self.sum.normal, self.sum.at].map(|sum| self.mean(sum))
    }
}

//! Pixels with pieces of several surfaces: no neighbour is like them, so that smoothing leaves them
//! as noisy as they are, and dark where few paths found light.
//!
//! What guides smoothing is a mean over the pixel, so that of such a pixel it lies between those of the surfaces. Two
//! pixels nearby between which it fits are what the pixel shows, and where between them it lies is how much of each.

use rayon::prelude::*;

use super::denoise::{Guide, Plane};
use super::film::Traced;
use crate::affine::three;
use crate::light::brightness;

/// Pixels that are like fewer of the eight around them are on no surface of their own: along an edge of two, two are.
const KIN: f32 = 2.5;
/// How far away, pixels, its surfaces are looked for, and others with which it shares what light was found.
const REACH: i32 = 2;
const SHARING: i32 = 3;
/// How much places count against colours and normals, which are about one: pixels are beside each other, and the
/// line between two of them cuts a corner.
const PLACES: f32 = 0.25;
/// How many paths have to find light for it to count as much as what lies on both sides: there is less noise in that.
const TRUSTED: f32 = 200.0;

/// What the guides of a pixel are compared by: all of it is a mean over the pixel.
type Features = [f32; 9];

impl Guide {
    fn features(&self, over: f32) -> Features {
        let ([r, g, b], [nx, ny, nz], [x, y, z]) = (self.colour, self.mean, self.at.map(|v| v * over * PLACES));
        [r, g, b, nx, ny, nz, x, y, z]
    }
}

/// A pixel between two others, and its light.
struct Between {
    /// How badly it fits there.
    off: f32,
    light: [f32; 3],
}

impl Plane<'_> {
    /// Which pixels are like few of those around them.
    pub(super) fn alone(&self) -> Vec<bool> {
        let kin = |index: usize| {
            let like = |(.., there): (i32, i32, usize)| self.guides[index].like(&self.guides[there]);
            // Itself left out.
            self.around(index, 1, 1).map(like).sum::<f32>() - 1.0
        };
        (0..self.guides.len()).into_par_iter().map(|index| kin(index) < KIN).collect()
    }

    /// Gives pixels that are alone the light of the two nearby that they are between, as far as they fit, and
    /// else the mean around them.
    pub(super) fn bridge(&self, traced: &[Traced], alone: &[bool], light: &mut [[f32; 3]]) {
        let lonely: Vec<usize> = (0..alone.len()).filter(|i| alone[*i]).collect();
        let smooth = &*light;
        let pixel = |index: &usize| {
            let mean = self.mean_around(smooth, *index);
            let Some(between) = self.between(alone, smooth, *index) else { return mean };
            let share = 1.0 / (1.0 + between.off);
            three(|i| mean[i] + share * (between.light[i] - mean[i]))
        };
        let made: Vec<[f32; 3]> = lonely.par_iter().map(pixel).collect();
        lonely.iter().zip(made).for_each(|(index, made)| light[*index] = made);
        self.even_out(traced, (alone, &lonely), light);
    }

    /// Makes pixels that are alone as bright, together with others around that are, as what was found there: it is
    /// darker in gaps than beside them.
    fn even_out(&self, traced: &[Traced], (alone, lonely): (&[bool], &[usize]), light: &mut [[f32; 3]]) {
        let made = &*light;
        let share = |index: &usize| {
            let others = self.around(*index, SHARING, 1).filter(|(.., there)| alone[*there]);
            let trusted = TRUSTED / traced[*index].paths() * brightness(made[*index]) + 1e-9;
            let sums = others.fold([trusted; 2], |[found, bridged], (.., there)| {
                [found + brightness(traced[there].scattered()), bridged + brightness(made[there])]
            });
            sums[0] / sums[1]
        };
        let shares: Vec<f32> = lonely.par_iter().map(share).collect();
        lonely.iter().zip(shares).for_each(|(index, share)| light[*index] = light[*index].map(|v| v * share));
    }

    /// The mean light around a pixel, on its own colour.
    fn mean_around(&self, light: &[[f32; 3]], index: usize) -> [f32; 3] {
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for (.., there) in self.around(index, REACH, 1) {
            let (light, colour) = (light[there], self.guides[there].colour);
            sum = three(|i| sum[i] + light[i] / colour[i]);
            count += 1.0;
        }
        three(|i| sum[i] / count * self.guides[index].colour[i])
    }

    /// The pixel between the two of a surface nearby between which it fits best; none if there is none nearby.
    fn between(&self, alone: &[bool], light: &[[f32; 3]], index: usize) -> Option<Between> {
        let own = &self.guides[index];
        let features = own.features(own.over);
        let others = self.around(index, REACH, 1).filter(|(.., there)| !alone[*there]);
        let others: Vec<(usize, Features)> =
            others.map(|(.., there)| (there, self.guides[there].features(own.over))).collect();
        let pairs = others.iter().enumerate().flat_map(|(i, a)| others[i..].iter().map(move |b| (a, b)));
        let fitted = pairs.map(|(a, b)| (fit(&features, &a.1, &b.1), a.0, b.0));
        let ((off, share), a, b) = fitted.min_by(|x, y| x.0.0.total_cmp(&y.0.0))?;
        let mix = |a: [f32; 3], b: [f32; 3]| three(|i| a[i] + share * (b[i] - a[i]));
        let (light, colour) = (mix(light[a], light[b]), mix(self.guides[a].colour, self.guides[b].colour));
        // What is finer than the pixel is in its colour.
        Some(Between { off, light: three(|i| light[i] * own.colour[i] / colour[i]) })
    }
}

/// How far features are off the line between two others, squared, and where along it they are, 0 to 1.
fn fit(own: &Features, a: &Features, b: &Features) -> (f32, f32) {
    let (mut along, mut length) = (0.0, 0.0);
    for i in 0..own.len() {
        along += (own[i] - a[i]) * (b[i] - a[i]);
        length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    let share = if length > 1e-12 { (along / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = |i: usize| own[i] - a[i] - share * (b[i] - a[i]);
    let off: f32 = (0..own.len()).map(|i| off(i) * off(i)).sum();
    if off.is_finite() { (off, share) } else { (f32::MAX, 0.0) }
}

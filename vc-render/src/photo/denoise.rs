//! Smoothing along surfaces: an edge-avoiding wavelet (Dammertz and others 2010), that looks at
//! how noisy each pixel is (Schied and others 2017). Light is smoothed without the colour
//! of the surfaces, so that textures stay, and light with sharp shadows apart from all other. Pixels
//! with pieces of several surfaces are like none of their neighbours; [`bridge`](super::bridge) mends them.
//!
//! Bright pixels are rarer than dark ones where light is found by chance, and neighbours that trust what is
//! likely would lose their light. So what smoothing has taken away is given back, spread
//! over the surface without regard to light.

use rayon::prelude::*;

use super::film::Traced;
use super::path::{Kind, SCATTERED};
use crate::affine::three;
use crate::light::{brightness, dot};

/// Passes; each reaches twice as far as the one before.
const PASSES: u32 = 6;
/// Weights of neighbours along an axis.
const KERNEL: [f32; 5] = [1.0 / 16.0, 1.0 / 4.0, 3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];
/// Standard deviations by which light may differ in the first pass, of sharp light, of soft and of what panes reflect.
/// It may differ more in later ones: what has been smoothed together errs together.
const UNLIKE: [f32; 3] = [2.0, 4.0, 2.0];
/// How far a point may be off a surface, in shares of its distance from the eye.
const OFF: f32 = 0.004;

/// A pixel while it is smoothed.
#[derive(Clone, Copy)]
struct Soft {
    /// Light over reflectance.
    light: [f32; 3],
    /// Variance of its brightness.
    variance: f32,
    /// How much it counts among its neighbours.
    weight: f32,
}

/// What edges are told by.
pub(super) struct Guide {
    pub(super) colour: [f32; 3],
    /// The mean of the normals in the pixel, and the same of unit length.
    pub(super) mean: [f32; 3],
    normal: [f32; 3],
    pub(super) at: [f32; 3],
    /// Share of light that glass before it reflects.
    glass: f32,
    /// One over how far others may be off this surface.
    pub(super) over: f32,
}

/// A picture's pixels and how they lie.
pub(super) struct Plane<'a> {
    pub(super) guides: &'a [Guide],
    width: usize,
}

pub(super) fn denoised(traced: &[Traced], width: usize, eye: [f32; 3]) -> Vec<[f32; 3]> {
    let guides: Vec<Guide> = traced.iter().map(|t| Guide::of(t, eye)).collect();
    let plane = Plane { guides: &guides, width };
    let mut light = vec![[0.0; 3]; traced.len()];
    for kind in SCATTERED {
        let smooth = plane.smooth(traced, kind);
        let under = guides.iter().map(|guide| guide.under(kind));
        light.iter_mut().zip(smooth).zip(under).for_each(|((sum, soft), under)| {
            *sum = three(|i| sum[i] + soft.light[i] * under[i]);
        });
    }
    let alone = plane.alone();
    plane.give_back(traced, &alone, &mut light);
    plane.bridge(traced, &alone, &mut light);
    let own = traced.iter().map(|t| t.light_of(Kind::Own).0);
    light.iter().zip(own).map(|(light, own)| three(|i| light[i] + own[i])).collect()
}

impl Guide {
    fn of(traced: &Traced, eye: [f32; 3]) -> Self {
        let [colour, normal, at] = traced.guides();
        let to = three(|i| at[i] - eye[i]);
        let over = 1.0 / (OFF * dot(to, to).sqrt()).max(1e-4);
        let length = dot(normal, normal).sqrt();
        let unit = if length > 1e-3 { normal.map(|v| v / length) } else { [0.0; 3] };
        Self { colour: colour.map(|v| v.max(0.02)), mean: normal, normal: unit, at, glass: traced.glass(), over }
    }

    /// What light of a kind is coloured by.
    fn under(&self, kind: Kind) -> [f32; 3] {
        if kind == Kind::Reflected { [self.glass; 3] } else { self.colour }
    }

    /// How much a neighbour is of the same surface, 0 to 1.
    #[inline(always)]
    pub(super) fn like(&self, other: &Self) -> f32 {
        let turned = dot(self.normal, other.normal);
        if turned == 0.0 && self.normal == other.normal {
            // Both are sky.
            return 1.0;
        }
        let to = three(|i| other.at[i] - self.at[i]);
        let off = dot(self.normal, to) * self.over;
        let turned = turned.max(0.0);
        let turned = turned * turned * turned * turned;
        let turned = turned * turned * turned * turned;
        let like = turned / (1.0 + off * off);
        if like.is_finite() { like } else { 0.0 }
    }
}

impl Soft {
    fn of(traced: &Traced, guide: &Guide, kind: Kind) -> Self {
        let ((light, variance), under) = (traced.light_of(kind), guide.under(kind).map(|v| v.max(1e-6)));
        let colour = brightness(under);
        // Where there is no glass nothing is reflected, whatever it is beside it.
        let weight = if kind == Kind::Reflected { guide.glass } else { 1.0 };
        Self { light: three(|i| light[i] / under[i]), variance: variance / (colour * colour), weight }
    }
}

impl Plane<'_> {
    /// Neighbours of a pixel up to so many steps away that are in the picture, and their offsets.
    #[inline(always)]
    pub(super) fn around(
        &self,
        index: usize,
        reach: i32,
        step: i32,
    ) -> impl Iterator<Item = (i32, i32, usize)> + use<> {
        let (width, height) = (self.width as i32, (self.guides.len() / self.width.max(1)) as i32);
        let (x, y) = (index as i32 % width, index as i32 / width);
        let offsets = (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (dx, dy)));
        offsets.filter_map(move |(dx, dy)| {
            let (tx, ty) = (x + dx * step, y + dy * step);
            let inside = tx >= 0 && ty >= 0 && tx < width && ty < height;
            inside.then_some((dx, dy, (ty * width + tx) as usize))
        })
    }

    /// One kind of light, smoothed.
    fn smooth(&self, traced: &[Traced], kind: Kind) -> Vec<Soft> {
        let mut soft: Vec<Soft> = traced.iter().zip(self.guides).map(|(t, g)| Soft::of(t, g, kind)).collect();
        // Few pictures show panes.
        if soft.iter().all(|soft| soft.light == [0.0; 3]) {
            return soft;
        }
        self.dim_specks(&mut soft);
        self.spread_variance(&mut soft);
        let unlike = UNLIKE[kind as usize];
        (0..PASSES).fold(soft, |soft, pass| self.smoothed(&soft, 1 << pass, unlike * (1 + pass) as f32))
    }

    /// A pixel more than twice as bright as all its neighbours is as bright as the brightest of them.
    fn dim_specks(&self, soft: &mut [Soft]) {
        let bright: Vec<f32> = soft.iter().map(|s| brightness(s.light)).collect();
        soft.par_iter_mut().enumerate().for_each(|(index, pixel)| {
            let others = self.around(index, 1, 1).filter(|(dx, dy, _)| (*dx, *dy) != (0, 0));
            let most = others.map(|(.., there)| bright[there]).fold(0.0, f32::max);
            if bright[index] > 2.0 * most && most > 0.0 {
                let share = most / bright[index];
                pixel.light = pixel.light.map(|v| v * share);
                pixel.variance *= share * share;
            }
        });
    }

    /// Each pixel is as noisy as those around it: where paths are few, one may have found no
    /// light at all and seem free of noise.
    fn spread_variance(&self, soft: &mut [Soft]) {
        let own: Vec<f32> = soft.iter().map(|s| s.variance).collect();
        soft.par_iter_mut().enumerate().for_each(|(index, pixel)| {
            let (mut sum, mut total) = (0.0, 1e-9);
            for (.., there) in self.around(index, 3, 1) {
                let weight = self.guides[index].like(&self.guides[there]) + 1e-4;
                sum += weight * own[there];
                total += weight;
            }
            pixel.variance = sum / total;
        });
    }

    fn smoothed(&self, soft: &[Soft], step: i32, unlike: f32) -> Vec<Soft> {
        // Light is compared where it is a little smoothed already.
        let blurred: Vec<[f32; 2]> = (0..soft.len()).into_par_iter().map(|i| self.blurred(soft, i)).collect();
        let pixel = |index: usize| {
            let (own, guide) = (&soft[index], &self.guides[index]);
            let [bright, variance] = blurred[index];
            let over = 1.0 / (unlike * variance.sqrt() + 1e-5);
            let (mut light, mut spread, mut total) = ([0.0; 3], 0.0, 0.0);
            for (dx, dy, there) in self.around(index, 2, step) {
                let other = &soft[there];
                let apart = (bright - blurred[there][0]).abs() * over;
                let kernel = KERNEL[(dx + 2) as usize] * KERNEL[(dy + 2) as usize];
                let like = guide.like(&self.guides[there]) * other.weight;
                let weight = kernel * like / (1.0 + apart + 0.5 * apart * apart);
                light.iter_mut().zip(other.light).for_each(|(sum, value)| *sum += weight * value);
                spread += weight * weight * other.variance;
                total += weight;
            }
            if total < 1e-9 {
                return *own;
            }
            Soft { light: light.map(|v| v / total), variance: spread / (total * total), weight: own.weight }
        };
        (0..soft.len()).into_par_iter().map(pixel).collect()
    }

    /// Adds to smooth light what there was more or less of in the noisy one, spread over the surface. Pixels
    /// that are on none have no part in it.
    fn give_back(&self, traced: &[Traced], alone: &[bool], light: &mut [[f32; 3]]) {
        let lost = traced.iter().zip(&*light).zip(alone).map(|((t, smooth), alone)| {
            let noisy = t.scattered();
            if *alone { [0.0; 3] } else { three(|i| noisy[i] - smooth[i]) }
        });
        let spread = (0..PASSES).fold(lost.collect(), |lost: Vec<[f32; 3]>, pass| self.spread(&lost, 1 << pass));
        light.iter_mut().zip(spread).for_each(|(light, more)| *light = three(|i| (light[i] + more[i]).max(0.0)));
    }

    /// Every pixel's share goes to those around that are like it, all of it.
    fn spread(&self, lost: &[[f32; 3]], step: i32) -> Vec<[f32; 3]> {
        let kernel = |dx: i32, dy: i32| KERNEL[(dx + 2) as usize] * KERNEL[(dy + 2) as usize];
        let part = |index: usize| {
            let like =
                |(dx, dy, there): (i32, i32, usize)| kernel(dx, dy) * self.guides[index].like(&self.guides[there]);
            let total: f32 = self.around(index, 2, step).map(like).sum();
            // Like nothing, not even itself.
            if total > 1e-9 { lost[index].map(|v| v / total) } else { [0.0; 3] }
        };
        let parts: Vec<[f32; 3]> = (0..lost.len()).into_par_iter().map(part).collect();
        let pixel = |index: usize| {
            self.around(index, 2, step).fold([0.0; 3], |sum, (dx, dy, there)| {
                let weight = kernel(dx, dy) * self.guides[there].like(&self.guides[index]);
                three(|i| sum[i] + weight * parts[there][i])
            })
        };
        (0..lost.len()).into_par_iter().map(pixel).collect()
    }

    /// Brightness and variance, over the pixel and its eight neighbours.
    #[inline(always)]
    fn blurred(&self, soft: &[Soft], index: usize) -> [f32; 2] {
        let (mut sum, mut total) = ([0.0; 2], 0.0);
        for (dx, dy, there) in self.around(index, 1, 1) {
            let like = self.guides[index].like(&self.guides[there]) * soft[there].weight;
            let weight = (2 - dx.abs()) as f32 * (2 - dy.abs()) as f32 * like + 1e-6;
            sum[0] += weight * brightness(soft[there].light);
            sum[1] += weight * soft[there].variance;
            total += weight;
        }
        sum.map(|v| v / total)
    }
}

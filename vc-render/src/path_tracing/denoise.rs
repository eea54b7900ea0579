//! Denoising along surfaces: an edge-avoiding wavelet filter (Dammertz and others 2010) guided by the noise of
//! each pixel (Schied and others 2017). Light is divided by surface colours before filtering, so that textures
//! stay sharp, and light with sharp shadows is filtered apart from all other. If several surfaces meet in a
//! pixel, each piece is filtered along its own surface, and the pixel is put together from them again; isolated
//! pieces are left to [`alone`](super::alone).
//!
//! Light found by chance makes few pixels bright and many dark, and a filter that trusts typical values would
//! lose the light of the bright ones. The energy that filtering removed is therefore given back, spread over
//! the surface with little regard to brightness.

use rayon::prelude::*;

use super::film::{Lie, Pixel, Traced};
use super::walk::{Kind, SCATTERED};
use crate::colour::luminance;
use crate::math::three;

/// Number of passes; each reaches twice as far as the one before.
const PASSES: u32 = 6;
/// Filter weights along an axis.
const KERNEL: [f32; 5] = [1.0 / 16.0, 1.0 / 4.0, 3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0];
/// Standard deviations by which light may differ in the first pass: for sharp light, soft light, and
/// reflections of panes. The tolerance grows in later passes, as the errors of smoothed pixels are correlated.
const UNLIKE: [f32; 3] = [2.0, 4.0, 2.0];
/// Share of a piece's neighbourhood on its own surface at which energy spreads on freely.
const ENOUGH: f32 = 0.2;
/// Least similarity of pieces of one surface.
const KIN: f32 = 0.1;

/// A piece of a pixel during filtering.
#[derive(Clone, Copy)]
struct Soft {
    /// Light divided by reflectance.
    light: [f32; 3],
    /// Variance of its brightness.
    variance: f32,
    /// Weight among its neighbours.
    weight: f32,
}

/// Features that tell edges.
pub(super) struct Guide {
    pub(super) colour: [f32; 3],
    lie: Lie,
    /// Share of light reflected by the glass in front of it.
    glass: f32,
    /// Its share of its pixel.
    pub(super) share: f32,
}

/// A picture's pieces, pixel by pixel, and their features.
pub(super) struct Plane<'a> {
    pub(super) traced: Vec<&'a Traced>,
    pub(super) guides: Vec<Guide>,
    /// Pixel of each piece.
    pixels: Vec<u32>,
    /// First piece of each pixel, and at the end the number of pieces.
    first: Vec<u32>,
    width: usize,
}

pub(super) fn denoised(pixels: &[Pixel], width: usize, eye: [f32; 3]) -> Vec<[f32; 3]> {
    let plane = Plane::new(pixels, width, eye);
    let alone = plane.alone();
    let (mut light, mut lost) = (vec![[0.0; 3]; plane.traced.len()], vec![[0.0; 3]; plane.traced.len()]);
    for kind in SCATTERED {
        for (piece, soft) in plane.smooth(kind).into_iter().enumerate() {
            let under = plane.guides[piece].under(kind);
            let smooth = three(|i| soft.light[i] * under[i]);
            light[piece] = three(|i| light[piece][i] + smooth[i]);
            if !alone[piece] {
                let noisy = plane.traced[piece].light_of(kind).0;
                lost[piece] = three(|i| lost[piece][i] + noisy[i] - smooth[i]);
            }
        }
    }
    plane.give_back(lost, &mut light);
    plane.mend(&alone, &mut light);
    let mut picture = vec![[0.0; 3]; pixels.len()];
    for (piece, pixel) in plane.pixels.iter().enumerate() {
        let (own, share) = (plane.traced[piece].light_of(Kind::Own).0, plane.guides[piece].share);
        let sum = &mut picture[*pixel as usize];
        *sum = three(|i| sum[i] + share * (light[piece][i] + own[i]));
    }
    picture
}

impl Guide {
    /// The reflectance that colours light of a kind.
    fn under(&self, kind: Kind) -> [f32; 3] {
        if kind == Kind::Reflected { [self.glass; 3] } else { self.colour }
    }
}

impl Soft {
    fn new(traced: &Traced, guide: &Guide, kind: Kind) -> Self {
        let ((light, variance), under) = (traced.light_of(kind), guide.under(kind).map(|v| v.max(1e-6)));
        let colour = luminance(under);
        // Pieces without glass in front reflect nothing, whatever is reflected beside them.
        let weight = guide.share * if kind == Kind::Reflected { guide.glass } else { 1.0 };
        Self { light: three(|i| light[i] / under[i]), variance: variance / (colour * colour), weight }
    }
}

impl<'a> Plane<'a> {
    fn new(pixels: &'a [Pixel], width: usize, eye: [f32; 3]) -> Self {
        let mut plane = Self { traced: vec![], guides: vec![], pixels: vec![], first: vec![0], width };
        for (pixel, number) in pixels.iter().zip(0..) {
            let paths = pixel.paths();
            for piece in pixel.pieces() {
                let colour = piece.colour().map(|v| v.max(0.02));
                let share = piece.count() / paths;
                plane.guides.push(Guide { colour, lie: piece.lie(eye), glass: piece.glass(), share });
                plane.traced.push(piece);
                plane.pixels.push(number);
            }
            plane.first.push(plane.traced.len() as u32);
        }
        plane
    }

    /// Pieces of the pixels up to `reach` steps away within the picture, with their offsets along both axes in
    /// steps.
    #[inline(always)]
    pub(super) fn around(&self, piece: usize, reach: i32, step: i32) -> impl Iterator<Item = (i32, i32, usize)> {
        let (width, height) = (self.width as i32, (self.first.len() - 1) as i32 / self.width.max(1) as i32);
        let index = self.pixels[piece] as i32;
        let (x, y) = (index % width, index / width);
        let offsets = (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (dx, dy)));
        let pixels = offsets.filter_map(move |(dx, dy)| {
            let (tx, ty) = (x + dx * step, y + dy * step);
            let inside = tx >= 0 && ty >= 0 && tx < width && ty < height;
            inside.then_some((dx, dy, (ty * width + tx) as usize))
        });
        pixels.flat_map(|(dx, dy, pixel)| {
            (self.first[pixel] as usize..self.first[pixel + 1] as usize).map(move |piece| (dx, dy, piece))
        })
    }

    /// How likely two pieces are on the same surface, 0 to 1.
    #[inline(always)]
    pub(super) fn like(&self, one: usize, other: usize) -> f32 {
        self.guides[one].lie.like(&self.guides[other].lie)
    }

    /// One kind of light, smoothed.
    fn smooth(&self, kind: Kind) -> Vec<Soft> {
        let mut soft: Vec<Soft> = self.traced.iter().zip(&self.guides).map(|(t, g)| Soft::new(t, g, kind)).collect();
        // Few pictures show reflections in panes.
        if soft.iter().all(|soft| soft.light == [0.0; 3]) {
            return soft;
        }
        self.dim_specks(&mut soft);
        self.spread_variance(&mut soft);
        let unlike = UNLIKE[kind as usize];
        (0..PASSES).fold(soft, |soft, pass| self.smoothed(&soft, 1 << pass, unlike * (1 + pass) as f32))
    }

    /// Clamps fireflies: a piece more than twice as bright as all of its surface in the pixels around it
    /// becomes as bright as the brightest of these.
    fn dim_specks(&self, soft: &mut [Soft]) {
        let bright: Vec<f32> = soft.iter().map(|s| luminance(s.light)).collect();
        soft.par_iter_mut().enumerate().for_each(|(index, piece)| {
            let others = self.around(index, 1, 1).filter(|(dx, dy, _)| (*dx, *dy) != (0, 0));
            let kin = others.filter(|(.., there)| self.like(index, *there) > KIN);
            let most = kin.map(|(.., there)| bright[there]).fold(0.0, f32::max);
            if bright[index] > 2.0 * most && most > 0.0 {
                let share = most / bright[index];
                piece.light = piece.light.map(|v| v * share);
                piece.variance *= share * share;
            }
        });
    }

    /// Averages the variance over the neighbourhood: with few paths, a pixel may have found no light at all and
    /// seem free of noise.
    fn spread_variance(&self, soft: &mut [Soft]) {
        let own: Vec<f32> = soft.iter().map(|s| s.variance).collect();
        soft.par_iter_mut().enumerate().for_each(|(index, pixel)| {
            let (mut sum, mut total) = (0.0, 1e-9);
            for (.., there) in self.around(index, 3, 1) {
                let weight = self.guides[there].share * (self.like(index, there) + 1e-4);
                sum += weight * own[there];
                total += weight;
            }
            pixel.variance = sum / total;
        });
    }

    fn smoothed(&self, soft: &[Soft], step: i32, unlike: f32) -> Vec<Soft> {
        // Brightness is compared after slight smoothing.
        let blurred: Vec<[f32; 2]> = (0..soft.len()).into_par_iter().map(|i| self.blurred(soft, i)).collect();
        let pixel = |index: usize| {
            let own = &soft[index];
            if own.weight == 0.0 {
                return *own;
            }
            let [bright, variance] = blurred[index];
            let over = 1.0 / (unlike * variance.sqrt() + 1e-5);
            let (mut light, mut spread, mut total) = ([0.0; 3], 0.0, 0.0);
            for (dx, dy, there) in self.around(index, 2, step) {
                let other = &soft[there];
                let apart = (bright - blurred[there][0]).abs() * over;
                let kernel = KERNEL[(dx + 2) as usize] * KERNEL[(dy + 2) as usize];
                let like = self.like(index, there) * other.weight;
                // An approximation of the exponential with a longer tail: sunlight outside is a thousand times
                // that of a room.
                let near = 1.0 / (1.0 + 0.125 * apart);
                let near = near * near * near * near;
                let weight = kernel * like * near * near;
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

    /// Adds to the smoothed light the energy that smoothing removed or added, spread over the surface.
    fn give_back(&self, mut lost: Vec<[f32; 3]>, light: &mut [[f32; 3]]) {
        let fallen = light.iter().zip(&self.guides).map(|(l, g)| luminance(*l) / luminance(g.colour) + 1e-9);
        let fallen: Vec<f32> = fallen.collect();
        let mut reach = vec![1.0; lost.len()];
        for pass in 0..PASSES {
            lost = self.spread(&lost, &fallen, &mut reach, 1 << pass);
        }
        light.iter_mut().zip(lost).for_each(|(light, more)| *light = three(|i| (light[i] + more[i]).max(0.0)));
    }

    /// Spreads every piece's remainder over the pieces around that are like it and in light of similar
    /// strength, conserving the sum: a small remainder in the sun would be a large one in the shade beside it.
    /// A remainder with no similar piece nearby does not go on to pieces farther away: otherwise the ground
    /// behind a door would show up on the floor before it.
    fn spread(&self, lost: &[[f32; 3]], fallen: &[f32], reach: &mut [f32], step: i32) -> Vec<[f32; 3]> {
        let reached = &*reach;
        let taken = |from: usize, (dx, dy, to): (i32, i32, usize)| {
            let ratio = fallen[from].min(fallen[to]) / fallen[from].max(fallen[to]);
            let kernel = KERNEL[(dx + 2) as usize] * KERNEL[(dy + 2) as usize];
            let reach = if from == to { 1.0 } else { reached[from] };
            reach * kernel * self.like(from, to) * ratio * ratio
        };
        // The energy that a piece gives for each unit of weight, and the part of it that goes to others.
        let part = |index: usize| {
            let share = self.guides[index].share;
            let own = taken(index, (0, 0, index)) * share;
            let around = self.around(index, 2, step);
            let total: f32 = around.map(|to| taken(index, to) * self.guides[to.2].share).sum();
            // Pieces that are like nothing, not even themselves, give nothing.
            let part = if total > 1e-9 { lost[index].map(|v| share * v / total) } else { [0.0; 3] };
            (part, total - own)
        };
        let (parts, others): (Vec<[f32; 3]>, Vec<f32>) = (0..lost.len()).into_par_iter().map(part).unzip();
        let piece = |index: usize| {
            self.around(index, 2, step).fold([0.0; 3], |sum, (dx, dy, from)| {
                let weight = taken(from, (dx, dy, index));
                three(|i| sum[i] + weight * parts[from][i])
            })
        };
        let spread = (0..lost.len()).into_par_iter().map(piece).collect();
        reach.iter_mut().zip(others).for_each(|(reach, others)| *reach = reach.min(others / ENOUGH));
        spread
    }

    /// Mean brightness and variance on the surface, over the pixel and its eight neighbours.
    #[inline(always)]
    fn blurred(&self, soft: &[Soft], index: usize) -> [f32; 2] {
        let (mut sum, mut total) = ([0.0; 2], 0.0);
        for (dx, dy, there) in self.around(index, 1, 1) {
            let like = self.like(index, there) * soft[there].weight;
            let weight = (2 - dx.abs()) as f32 * (2 - dy.abs()) as f32 * like + 1e-6;
            sum[0] += weight * luminance(soft[there].light);
            sum[1] += weight * soft[there].variance;
            total += weight;
        }
        sum.map(|v| v / total)
    }
}

//! What all paths of a picture have found so far.

use super::path::{KINDS, Kind, Sample};
use crate::affine::three;
use crate::light::{brightness, dot};

/// Surfaces of one pixel that are told apart.
const PIECES: usize = 4;
/// How alike places on one surface are at least.
const ALIKE: f32 = 0.3;
/// How far a point may be off a surface, in shares of its distance from the eye.
const OFF: f32 = 0.004;

/// What all paths of a pixel found, by the surface met first: what is smoothed together is of one.
#[derive(Debug, Clone, Default)]
pub(super) struct Pixel {
    first: Traced,
    // Few pixels are of several.
    others: Vec<Traced>,
}

impl Pixel {
    pub(super) fn add(&mut self, one: &Sample, eye: [f32; 3]) {
        let place = Lie::of(one.normal, one.at, eye);
        let alike = |piece: &Traced| piece.lie(eye).like(&place);
        if self.first.count == 0.0 || alike(&self.first) > ALIKE {
            return self.first.add(one);
        }
        if let Some(piece) = self.others.iter_mut().find(|piece| alike(piece) > ALIKE) {
            return piece.add(one);
        }
        if self.others.len() + 1 < PIECES {
            self.others.reserve_exact(1);
            self.others.push(Traced::default());
        }
        // Of more surfaces the last piece is a mixture.
        self.others.last_mut().unwrap_or(&mut self.first).add(one);
    }

    /// What paths found on each of its surfaces.
    pub(super) fn pieces(&self) -> impl Iterator<Item = &Traced> {
        std::iter::once(&self.first).chain(&self.others)
    }

    /// Mean light.
    pub(super) fn light(&self) -> [f32; 3] {
        let paths = self.paths();
        self.pieces().fold([0.0; 3], |sum, piece| {
            let light = piece.light();
            three(|i| sum[i] + piece.count / paths * light[i])
        })
    }

    /// How many paths there were.
    pub(super) fn paths(&self) -> f32 {
        self.pieces().map(|piece| piece.count).sum::<f32>().max(1.0)
    }
}

/// How a piece of a surface lies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lie {
    /// Of unit length, or zero where there is none.
    normal: [f32; 3],
    at: [f32; 3],
    /// One over how far others may be off this surface.
    over: f32,
}

impl Lie {
    fn of(normal: [f32; 3], at: [f32; 3], eye: [f32; 3]) -> Self {
        let to = three(|i| at[i] - eye[i]);
        let over = 1.0 / (OFF * dot(to, to).sqrt()).max(1e-4);
        let length = dot(normal, normal).sqrt();
        Self { normal: if length > 1e-3 { normal.map(|v| v / length) } else { [0.0; 3] }, at, over }
    }

    /// How much another is of the same surface, 0 to 1.
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

/// What paths found that met one surface first.
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

    /// How many paths met it.
    pub(super) fn count(&self) -> f32 {
        self.count
    }

    fn mean(&self, sum: [f32; 3]) -> [f32; 3] {
        sum.map(|v| v / self.count.max(1.0))
    }

    /// Mean light.
    pub(super) fn light(&self) -> [f32; 3] {
        self.mean(three(|i| self.sum.light.iter().map(|light| light[i]).sum()))
    }

    /// Mean light of one kind, and the variance of the mean's brightness.
    pub(super) fn light_of(&self, kind: Kind) -> ([f32; 3], f32) {
        let kind = kind as usize;
        let light = self.mean(self.sum.light[kind]);
        let (count, bright) = (self.count.max(1.0), brightness(light));
        let spread = (self.squares[kind] / count - bright * bright).max(0.0) / count;
        // With few paths the spread found is not to be trusted.
        (light, spread + bright * bright / (count * count))
    }

    /// Mean share of light that glass before the first surface reflects.
    pub(super) fn glass(&self) -> f32 {
        self.sum.glass / self.count.max(1.0)
    }

    /// Mean reflectance of the first surface.
    pub(super) fn colour(&self) -> [f32; 3] {
        self.mean(self.sum.colour)
    }

    /// How the first surface lies on average.
    pub(super) fn lie(&self, eye: [f32; 3]) -> Lie {
        Lie::of(self.mean(self.sum.normal), self.mean(self.sum.at), eye)
    }
}

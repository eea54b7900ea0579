//! The film: the accumulated results of all paths of a picture.

use super::walk::{KINDS, Kind, Sample};
use crate::colour::luminance;
use crate::math::{dot, three};

/// Greatest number of surfaces told apart within a pixel.
const PIECES: usize = 4;
/// Least similarity of points on one surface.
const ALIKE: f32 = 0.3;
/// Greatest distance of a point from a surface, relative to its distance from the eye.
const OFF: f32 = 0.004;

/// The results of all paths of a pixel, separately for each surface hit first, as smoothing works along single
/// surfaces.
#[derive(Debug, Clone, Default)]
pub(super) struct Pixel {
    first: Traced,
    // Few pixels show several surfaces.
    others: Vec<Traced>,
}

impl Pixel {
    pub(super) fn add(&mut self, one: &Sample, eye: [f32; 3]) {
        let place = Lie::new(one.normal, one.at, eye);
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
        // Further surfaces are mixed into the last piece.
        self.others.last_mut().unwrap_or(&mut self.first).add(one);
    }

    /// The path results on each of its surfaces.
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

    /// Number of paths.
    pub(super) fn paths(&self) -> f32 {
        self.pieces().map(|piece| piece.count).sum::<f32>().max(1.0)
    }
}

/// Position and orientation of a piece of surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lie {
    /// Unit length, or zero for the sky.
    normal: [f32; 3],
    at: [f32; 3],
    /// The inverse of the greatest distance at which points count as on this surface.
    over: f32,
}

impl Lie {
    fn new(normal: [f32; 3], at: [f32; 3], eye: [f32; 3]) -> Self {
        let to = three(|i| at[i] - eye[i]);
        let over = 1.0 / (OFF * dot(to, to).sqrt()).max(1e-4);
        let length = dot(normal, normal).sqrt();
        Self { normal: if length > 1e-3 { normal.map(|v| v / length) } else { [0.0; 3] }, at, over }
    }

    /// How likely another is on the same surface, 0 to 1.
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

/// The results of paths whose first hit was on one surface.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Traced {
    sum: Sample,
    /// Sums of squared brightness, for each kind of light.
    squares: [f32; KINDS],
    count: f32,
}

impl Traced {
    pub(super) fn add(&mut self, one: &Sample) {
        let add = |sum: &mut [f32; 3], more: [f32; 3]| (0..3).for_each(|i| sum[i] += more[i]);
        for (kind, light) in one.light.into_iter().enumerate() {
            add(&mut self.sum.light[kind], light);
            self.squares[kind] += luminance(light) * luminance(light);
        }
        add(&mut self.sum.colour, one.colour);
        add(&mut self.sum.normal, one.normal);
        add(&mut self.sum.at, one.at);
        self.sum.glass += one.glass;
        self.count += 1.0;
    }

    /// Number of paths that hit it.
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
        let (count, bright) = (self.count.max(1.0), luminance(light));
        let spread = (self.squares[kind] / count - bright * bright).max(0.0) / count;
        // With few paths the measured variance is not reliable.
        (light, spread + bright * bright / (count * count))
    }

    /// Mean share of light reflected by the glass in front of the first surface.
    pub(super) fn glass(&self) -> f32 {
        self.sum.glass / self.count.max(1.0)
    }

    /// Mean reflectance of the first surface.
    pub(super) fn colour(&self) -> [f32; 3] {
        self.mean(self.sum.colour)
    }

    /// Mean position and orientation of the first surface.
    pub(super) fn lie(&self, eye: [f32; 3]) -> Lie {
        Lie::new(self.mean(self.sum.normal), self.mean(self.sum.at), eye)
    }
}

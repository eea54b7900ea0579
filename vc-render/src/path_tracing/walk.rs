//! The state of a path, and the light that it found.

use super::glass::Reflections;
use super::source::Place;
use crate::bvh::Ray;
use crate::colour::luminance;
use crate::math::three;

/// Kinds of light that are smoothed separately.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Light whose shadows may be sharp.
    Sharp,
    /// All other reflected light.
    Soft,
    /// Reflections of glass in front of the first surface, which do not have that surface's colour.
    Reflected,
    /// Directly visible emission, and the sky: free of noise.
    Own,
}

/// Number of kinds.
pub(super) const KINDS: usize = 4;
/// Kinds that are noisy.
pub(super) const SCATTERED: [Kind; 3] = [Kind::Sharp, Kind::Soft, Kind::Reflected];

/// The result of one path.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sample {
    /// Light of each [`Kind`].
    pub(super) light: [[f32; 3]; KINDS],
    /// Reflectance, normal and position of the first surface, which guide denoising.
    pub(super) colour: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) at: [f32; 3],
    /// Share of uniform light that glass in front of it reflects.
    pub(super) glass: f32,
}

impl Sample {
    /// Adds the light of another sample.
    pub(super) fn brighten(&mut self, other: &Self) {
        let pairs = self.light.as_flattened_mut().iter_mut().zip(other.light.as_flattened());
        pairs.for_each(|(sum, light)| *sum += light);
    }
}

/// The state of a path.
pub(super) struct Walk {
    pub(super) ray: Ray,
    /// Throughput: the share of light found that reaches the camera.
    pub(super) share: [f32; 3],
    /// Greatest component of the throughput when the path last passed a drawn cover, beyond which it is bright.
    pub(super) dimmed: f32,
    /// Probability density of the direction taken; infinite if there was no choice.
    pub(super) chance: f32,
    /// Density with which the way through the panes passed since then would have been sampled.
    pub(super) through: f32,
    /// Distance since the last surface.
    pub(super) gone: f32,
    /// The last surface.
    pub(super) last: Place,
    /// Number of surfaces hit, without panes and mirrors.
    pub(super) surfaces: u32,
    /// Reflections of glass in front of the first surface.
    pub(super) reflections: Reflections,
    most: f32,
    pub(super) found: Sample,
    /// Whether the features that guide denoising are known.
    pub(super) guided: bool,
    /// Whether it began as a reflection off glass.
    reflected: bool,
}

impl Walk {
    pub(super) fn new(ray: Ray, most: f32) -> Self {
        let last = Place { at: ray.from, normal: [0.0; 3], room: u16::MAX, lamps: 0.0, panes: 0.0, covers: 0.0 };
        Self {
            ray,
            share: [1.0; 3],
            dimmed: 1.0,
            chance: f32::INFINITY,
            through: 0.0,
            gone: 0.0,
            last,
            surfaces: 0,
            reflections: Reflections::default(),
            most,
            found: Sample::default(),
            guided: false,
            reflected: false,
        }
    }

    /// The path reflected by glass in view, which stands for all such reflections.
    pub(super) fn reflected(&self) -> Option<Self> {
        let (ray, share) = self.reflections.one()?;
        // Denoising is guided by the surface behind the glass.
        Some(Self { share, guided: true, reflected: true, ..Self::new(ray, self.most) })
    }

    /// The balance-heuristic weight of a chance hit, given the density of direct sampling.
    pub(super) fn weight(&self, other: f32) -> f32 {
        if self.chance.is_finite() { self.chance / (self.chance + other) } else { 1.0 }
    }

    /// The greatest component of the throughput.
    pub(super) fn greatest(&self) -> f32 {
        self.share.iter().fold(0.0, |m, v| m.max(*v))
    }

    /// Adds light; contributions by way of a second surface are limited in brightness.
    pub(super) fn gain(&mut self, light: [f32; 3], kind: Kind) {
        let mut brought = three(|i| self.share[i] * light[i]);
        let bright = luminance(brought);
        if self.surfaces > 0 && bright > self.most {
            brought = brought.map(|v| v * self.most / bright);
        }
        if bright.is_finite() && brought.iter().all(|v| v.is_finite()) {
            let kind = if self.reflected && kind != Kind::Own { Kind::Reflected } else { kind };
            let sum = &mut self.found.light[kind as usize];
            *sum = three(|i| sum[i] + brought[i]);
        }
    }

    /// Records the features of the first surface.
    pub(super) fn guide(&mut self, colour: [f32; 3], normal: [f32; 3], at: [f32; 3]) {
        if !self.guided {
            self.guided = true;
            (self.found.colour, self.found.normal, self.found.at) = (colour, normal, at);
        }
    }
}

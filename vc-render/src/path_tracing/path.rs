//! Tracing of a single path.

use super::PathTracing;
use super::cover::Covers;
use super::direct::Point;
use super::glass::{Reflections, mirrored};
use super::lights::Lights;
use super::sampler::Sampler;
use super::source::Place;
use super::spots::{self, Spots};
use crate::bvh::Ray;
use crate::camera::Camera;
use crate::colour::luminance;
use crate::light::{Lighting, through};
use crate::math::{self, Affine, dot, three, unit};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;
use crate::surface::{Finish, Scatter, Surface};

/// Greatest number of steps of a path, including those through glass.
const STEPS: u32 = 128;

/// The scene and settings that paths are traced in.
pub(super) struct Paths<'a> {
    pub(super) store: &'a Store,
    pub(super) lighting: &'a Lighting,
    pub(super) camera: &'a Camera,
    pub(super) lights: &'a Lights,
    pub(super) spots: &'a Spots,
    pub(super) covers: &'a Covers,
    pub(super) how: &'a PathTracing,
    /// Greatest brightness that a path may contribute by way of a second surface.
    pub(super) most: f32,
}

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
    fn brighten(&mut self, other: &Self) {
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
    found: Sample,
    /// Whether the features that guide denoising are known.
    pub(super) guided: bool,
    /// Whether it began as a reflection off glass.
    reflected: bool,
}

impl Paths<'_> {
    /// Traces one path through a pixel.
    pub(super) fn path(&self, (x, y): (usize, usize), round: u32) -> Sample {
        let mut sampler = Sampler::new((x, y), round, self.how.seed);
        let [dx, dy] = sampler.pair();
        let pose = Affine::from_pose(&self.camera.pose).narrow();
        let along = unit(math::vector(&pose, self.camera.ray(x as f32 + dx, y as f32 + dy).into()));
        let ray = Ray { from: self.camera.eye().into(), along, end: 1e4 };
        let mut walk = Walk::new(ray, self.most);
        self.follow(&mut walk, &mut sampler);
        walk.found.glass = walk.reflections.all();
        if let Some(mut reflected) = walk.reflected() {
            // With numbers independent of those of the transmitted path.
            self.follow(&mut reflected, &mut Sampler::new((x, y), round, !self.how.seed));
            walk.found.brighten(&reflected.found);
        }
        walk.found
    }

    /// Follows a path to its end.
    fn follow(&self, walk: &mut Walk, sampler: &mut Sampler) {
        for _ in 0..STEPS {
            let Some(met) = self.lighting.tracer.first_of_all(&walk.ray) else { return self.sky(walk) };
            let surface = &self.store.surfaces[usize::from(met.face.surface)];
            if surface.is_clear() {
                self.glass(walk, &met, sampler.one());
            } else if !self.surface(walk, &met, surface, sampler) {
                return;
            }
        }
    }

    pub(super) fn room(&self, met: &SurfaceHit<'_>) -> u16 {
        spots::room(self.lighting, met)
    }

    /// Diameter over which a surface's texture is averaged, metres; textures seen directly are sharp.
    fn footprint(&self, walk: &Walk, met: &SurfaceHit<'_>) -> f32 {
        let pixel = (met.t + walk.gone) / self.camera.focal.1;
        if walk.surfaces == 0 { pixel.min(0.002) } else { 0.002 }
    }

    fn sky(&self, walk: &mut Walk) {
        let weight = walk.weight(walk.through);
        let light = self.lighting.daylight.radiance(walk.ray.along).map(|v| v * weight);
        walk.guide([1.0; 3], [0.0; 3], walk.ray.along.map(|v| v * 1e3));
        walk.gain(light, if walk.surfaces == 0 { Kind::Own } else { Kind::Soft });
    }

    /// Handles a surface hit: gathers light and chooses the next direction; false where the path ends.
    fn surface(&self, walk: &mut Walk, met: &SurfaceHit<'_>, surface: &Surface, sampler: &mut Sampler) -> bool {
        let mut back = walk.ray.along.map(|v| -v);
        // Sheets have two sides in one place, either of which may be hit first. The inside of things is dark
        // anyway.
        let mut met = &met.facing(back);
        let look = met.appearance(surface, self.footprint(walk, met));
        self.glow(walk, met, surface);
        if surface.is_mirror() {
            walk.share = three(|i| walk.share[i] * look.colour[i]);
            walk.ray.along = mirrored(walk.ray.along, met.normal);
            (walk.chance, walk.through, walk.gone) = (f32::INFINITY, 0.0, 0.0);
            walk.ray.from = off(met, walk.ray.along);
            return true;
        }
        walk.guide(look.colour, met.normal, met.at);
        let (share, beyond) = (through(met, surface), met.facing(walk.ray.along));
        let passes = share > 0.0 && walk.passes(share, sampler.one());
        if passes {
            // The path continues on the other side, as if it had arrived there.
            (met, back) = (&beyond, mirrored(back, met.flat));
        }
        if walk.surfaces >= self.how.bounces {
            return false;
        }
        let normal = if !passes && dot(look.normal, back) > 0.01 { look.normal } else { met.flat };
        let finish = Finish { colour: look.colour, metallic: surface.metallic, roughness: look.roughness };
        let scatter = Scatter::new(&finish, normal, back);
        let mut place = self.lights.place(met.at, met.flat, self.room(met));
        // Points in a cover's own folds are not sent towards covers.
        place.covers = if met.instance.covers() { 0.0 } else { self.covers.weight(&place) };
        let point = Point { met, place, scatter: &scatter };
        self.direct(walk, &point, sampler);
        walk.last = place;
        self.go_on(walk, &point, sampler)
    }

    /// Adds the emission of a surface.
    fn glow(&self, walk: &mut Walk, met: &SurfaceHit<'_>, surface: &Surface) {
        let glow = self.lighting.glow(surface, met.instance.body);
        if glow != [0.0; 3] {
            let facing = -dot(met.flat, walk.ray.along).min(-1e-4);
            let distance = met.t + walk.gone;
            let other = self.lights.density(&walk.last, met.instance.body, glow) * distance * distance / facing;
            let shine = met.shine(surface, self.footprint(walk, met));
            let weight = walk.weight(other);
            let kind = match walk.surfaces {
                0 => Kind::Own,
                1 => Kind::Sharp,
                _ => Kind::Soft,
            };
            walk.gain(three(|i| glow[i] * shine[i] * weight), kind);
        }
    }

    /// Reflectance times the cosine towards a direction, and the density with which a path continues there.
    pub(super) fn reflected(&self, point: &Point<'_>, towards: [f32; 3]) -> ([f32; 3], f32) {
        let (value, chance) = point.scatter.evaluate(towards);
        (value, self.covers.mixed(chance, &point.place, towards))
    }

    fn go_on(&self, walk: &mut Walk, point: &Point<'_>, sampler: &mut Sampler) -> bool {
        let met = point.met;
        let sent = match point.place.covers > 0.0 {
            true => self.covers.towards(&point.place, sampler.one(), sampler.pair()),
            false => None,
        };
        let towards = sent.unwrap_or_else(|| point.scatter.sample(sampler.one(), sampler.pair()));
        let (value, chance) = self.reflected(point, towards);
        if chance <= 1e-7 || dot(met.flat, towards) <= 0.0 {
            return false;
        }
        walk.share = three(|i| walk.share[i] * value[i] / chance);
        (walk.chance, walk.through, walk.gone) = (chance, 0.0, 0.0);
        walk.ray.along = towards;
        walk.ray.from = off(met, towards);
        walk.surfaces += 1;
        // Light through a cover is bright, however small the path's throughput is by then.
        if walk.surfaces < 2 || sent.is_some() || met.instance.covers() {
            return true;
        }
        // Russian roulette: paths with little throughput end by chance, and the others are weighted up.
        let keep = (walk.greatest() / walk.dimmed).min(0.95);
        walk.share = walk.share.map(|v| v / keep.max(1e-6));
        sampler.one() < keep
    }
}

/// A point slightly off a surface towards a direction, so that the ray does not hit it again.
pub(super) fn off(met: &SurfaceHit<'_>, towards: [f32; 3]) -> [f32; 3] {
    let by = 2e-4_f32.copysign(dot(met.flat, towards)) * (1.0 + 0.2 * met.t.min(20.0));
    three(|i| met.at[i] + by * met.flat[i])
}

impl Walk {
    fn new(ray: Ray, most: f32) -> Self {
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
    fn reflected(&self) -> Option<Self> {
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
    fn guide(&mut self, colour: [f32; 3], normal: [f32; 3], at: [f32; 3]) {
        if !self.guided {
            self.guided = true;
            (self.found.colour, self.found.normal, self.found.at) = (colour, normal, at);
        }
    }
}

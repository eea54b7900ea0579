//! One path of light.

use super::Exposure;
use super::cover::Covers;
use super::direct::Point;
use super::glass::{Reflections, mirrored};
use super::lights::Lights;
use super::sampler::Sampler;
use super::scatter::{Finish, Scatter};
use super::source::Place;
use super::spots::{self, Spots};
use crate::affine::{self, Affine, three};
use crate::camera::Camera;
use crate::label::unit;
use crate::light::{Lighting, brightness, dot, through};
use crate::renderer::Renderer;
use crate::surface::Surface;
use crate::trace::{Met, Ray};

/// Steps of a path, those through glass included.
const STEPS: u32 = 128;

/// What paths go through.
pub(super) struct Paths<'a> {
    pub(super) renderer: &'a Renderer,
    pub(super) lighting: &'a Lighting,
    pub(super) camera: &'a Camera,
    pub(super) lights: &'a Lights,
    pub(super) spots: &'a Spots,
    pub(super) covers: &'a Covers,
    pub(super) how: &'a Exposure,
    /// Brightest light that a path may bring from afar.
    pub(super) most: f32,
}

/// Kinds of light that are smoothed each in its own way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// With shadows that may be sharp.
    Sharp,
    /// All other.
    Soft,
    /// What glass before the first surface reflects: it has nothing of that surface's colour.
    Reflected,
    /// Of what glows where the eye sees it, and of the sky: there is no noise in it.
    Own,
}

/// How many there are.
pub(super) const KINDS: usize = 4;
/// Those in which there is noise.
pub(super) const SCATTERED: [Kind; 3] = [Kind::Sharp, Kind::Soft, Kind::Reflected];

/// What one path found.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sample {
    /// Light by [`Kind`].
    pub(super) light: [[f32; 3]; KINDS],
    /// Reflectance, normal and place of the first surface, which guide smoothing.
    pub(super) colour: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) at: [f32; 3],
    /// How much of light from all around glass before it reflects.
    pub(super) glass: f32,
}

impl Sample {
    /// Adds the light that another found.
    fn brighten(&mut self, other: &Self) {
        let pairs = self.light.as_flattened_mut().iter_mut().zip(other.light.as_flattened());
        pairs.for_each(|(sum, light)| *sum += light);
    }
}

/// A path on its way.
pub(super) struct Walk {
    pub(super) ray: Ray,
    /// What share of light that is found reaches the eye.
    pub(super) share: [f32; 3],
    /// Greatest of that where a drawn cover was last gone through: it is bright beyond.
    pub(super) dimmed: f32,
    /// Chance of the direction taken; infinite where there was no choice.
    pub(super) chance: f32,
    /// Chance that the way through the panes met since would have been picked.
    pub(super) through: f32,
    /// Distance since the last surface.
    pub(super) gone: f32,
    /// The last surface.
    pub(super) last: Place,
    /// Surfaces met, panes and mirrors left out.
    pub(super) surfaces: u32,
    /// What glass before the first surface reflects.
    pub(super) reflections: Reflections,
    most: f32,
    found: Sample,
    /// Whether what smoothing goes by is known.
    pub(super) guided: bool,
    /// Whether it began off glass.
    reflected: bool,
}

impl Paths<'_> {
    /// One path through a pixel.
    pub(super) fn path(&self, (x, y): (usize, usize), round: u32) -> Sample {
        let mut sampler = Sampler::new((x, y), round, self.how.seed);
        let [dx, dy] = sampler.pair();
        let pose = Affine::of(&self.camera.pose).narrow();
        let along = unit(affine::vector(&pose, self.camera.ray(x as f32 + dx, y as f32 + dy).into()));
        let ray = Ray { from: self.camera.eye().into(), along, end: 1e4 };
        let mut walk = Walk::new(ray, self.most);
        self.follow(&mut walk, &mut sampler);
        walk.found.glass = walk.reflections.all();
        if let Some(mut reflected) = walk.reflected() {
            // By numbers that have nothing to do with those of the way through.
            self.follow(&mut reflected, &mut Sampler::new((x, y), round, !self.how.seed));
            walk.found.brighten(&reflected.found);
        }
        walk.found
    }

    /// Goes on to where a path ends.
    fn follow(&self, walk: &mut Walk, sampler: &mut Sampler) {
        for _ in 0..STEPS {
            let Some(met) = self.lighting.tracer.first_of_all(&walk.ray) else { return self.sky(walk) };
            let surface = &self.renderer.store.surfaces[usize::from(met.face.surface)];
            if surface.is_clear() {
                self.glass(walk, &met, sampler.one());
            } else if !self.surface(walk, &met, surface, sampler) {
                return;
            }
        }
    }

    pub(super) fn room(&self, met: &Met<'_>) -> u16 {
        spots::room(self.lighting, met)
    }

    /// Width at a surface that is one point of it, metres: what the eye sees is sharp.
    fn footprint(&self, walk: &Walk, met: &Met<'_>) -> f32 {
        let pixel = (met.t + walk.gone) / self.camera.focal.1;
        if walk.surfaces == 0 { pixel.min(0.002) } else { 0.002 }
    }

    fn sky(&self, walk: &mut Walk) {
        let weight = walk.weight(walk.through);
        let light = self.lighting.daylight.radiance(walk.ray.along).map(|v| v * weight);
        walk.guide([1.0; 3], [0.0; 3], walk.ray.along.map(|v| v * 1e3));
        walk.gain(light, if walk.surfaces == 0 { Kind::Own } else { Kind::Soft });
    }

    /// Light at a surface, and where to go on; false where the path ends.
    fn surface(&self, walk: &mut Walk, met: &Met<'_>, surface: &Surface, sampler: &mut Sampler) -> bool {
        let mut back = walk.ray.along.map(|v| -v);
        // Sheets have two sides in one place, either of which may be met first. Within things it is dark anyway.
        let mut met = &met.facing(back);
        let look = met.look(surface, self.footprint(walk, met));
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
            // It goes on from the other side, as if it had come from there.
            (met, back) = (&beyond, mirrored(back, met.flat));
        }
        if walk.surfaces >= self.how.bounces {
            return false;
        }
        let normal = if !passes && dot(look.normal, back) > 0.01 { look.normal } else { met.flat };
        let finish = Finish { colour: look.colour, metallic: surface.metallic, roughness: look.roughness };
        let scatter = Scatter::new(&finish, normal, back);
        let mut place = self.lights.place(met.at, met.flat, self.room(met));
        // What is in its folds is at no cover.
        place.covers = if met.instance.covers() { 0.0 } else { self.covers.weight(&place) };
        let point = Point { met, place, scatter: &scatter };
        self.direct(walk, &point, sampler);
        walk.last = place;
        self.go_on(walk, &point, sampler)
    }

    /// Light that a surface gives of itself.
    fn glow(&self, walk: &mut Walk, met: &Met<'_>, surface: &Surface) {
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

    /// What a surface throws on from a direction, and the chance that a path goes on there.
    pub(super) fn thrown(&self, point: &Point<'_>, towards: [f32; 3]) -> ([f32; 3], f32) {
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
        let (value, chance) = self.thrown(point, towards);
        if chance <= 1e-7 || dot(met.flat, towards) <= 0.0 {
            return false;
        }
        walk.share = three(|i| walk.share[i] * value[i] / chance);
        (walk.chance, walk.through, walk.gone) = (chance, 0.0, 0.0);
        walk.ray.along = towards;
        walk.ray.from = off(met, towards);
        walk.surfaces += 1;
        // What comes through a cover is bright for the little of it that reaches the eye.
        if walk.surfaces < 2 || sent.is_some() || met.instance.covers() {
            return true;
        }
        // Paths that bring little end by chance, and others count for them.
        let keep = (walk.greatest() / walk.dimmed).min(0.95);
        walk.share = walk.share.map(|v| v / keep.max(1e-6));
        sampler.one() < keep
    }
}

/// A little off a surface towards a direction, so that the ray does not meet it again.
pub(super) fn off(met: &Met<'_>, towards: [f32; 3]) -> [f32; 3] {
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

    /// The way off some glass that the eye looks through, which stands for all of it.
    fn reflected(&self) -> Option<Self> {
        let (ray, share) = self.reflections.one()?;
        // Smoothing goes by what is behind.
        Some(Self { share, guided: true, reflected: true, ..Self::new(ray, self.most) })
    }

    /// How much what was met by chance counts, given the chance to find it on purpose.
    pub(super) fn weight(&self, other: f32) -> f32 {
        if self.chance.is_finite() { self.chance / (self.chance + other) } else { 1.0 }
    }

    /// The greatest of the shares of colours.
    pub(super) fn greatest(&self) -> f32 {
        self.share.iter().fold(0.0, |m, v| m.max(*v))
    }

    /// Takes light up, specks from afar cut off.
    pub(super) fn gain(&mut self, light: [f32; 3], kind: Kind) {
        let mut brought = three(|i| self.share[i] * light[i]);
        let bright = brightness(brought);
        if self.surfaces > 0 && bright > self.most {
            brought = brought.map(|v| v * self.most / bright);
        }
        if bright.is_finite() && brought.iter().all(|v| v.is_finite()) {
            let kind = if self.reflected && kind != Kind::Own { Kind::Reflected } else { kind };
            let sum = &mut self.found.light[kind as usize];
            *sum = three(|i| sum[i] + brought[i]);
        }
    }

    /// Notes the first surface.
    fn guide(&mut self, colour: [f32; 3], normal: [f32; 3], at: [f32; 3]) {
        if !self.guided {
            self.guided = true;
            (self.found.colour, self.found.normal, self.found.at) = (colour, normal, at);
        }
    }
}

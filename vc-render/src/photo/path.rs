//! One path of light.

use super::Exposure;
use super::lights::Lights;
use super::sampler::Sampler;
use super::scatter::{Scatter, frame};
use crate::affine::{self, Affine};
use crate::camera::Camera;
use crate::label::unit;
use crate::light::{Lighting, brightness, dot};
use crate::renderer::Renderer;
use crate::surface::Surface;
use crate::trace::{Met, Ray};

/// Brightest light a path may bring after its first surface: brighter is rare and would
/// only be specks.
const MOST: f32 = 12.0;
/// Sine of half the sun's width, a little wider than it is.
const SUN: f32 = 0.008;

/// What paths go through.
pub(super) struct Paths<'a> {
    pub(super) renderer: &'a Renderer,
    pub(super) lighting: &'a Lighting,
    pub(super) camera: &'a Camera,
    pub(super) lights: &'a Lights,
    pub(super) how: &'a Exposure,
}

/// What one path found.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sample {
    pub(super) light: [f32; 3],
    /// Reflectance, normal and inverse distance of the first surface, which guide smoothing.
    pub(super) colour: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) inverse: f32,
}

/// What all paths of a pixel found.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Traced {
    pub(super) sum: Sample,
    /// Sum of squares of brightness.
    pub(super) squares: f32,
    pub(super) count: f32,
}

impl Traced {
    pub(super) fn add(&mut self, one: &Sample) {
        for i in 0..3 {
            self.sum.light[i] += one.light[i];
            self.sum.colour[i] += one.colour[i];
            self.sum.normal[i] += one.normal[i];
        }
        self.sum.inverse += one.inverse;
        self.squares += brightness(one.light) * brightness(one.light);
        self.count += 1.0;
    }

    pub(super) fn light(&self) -> [f32; 3] {
        self.sum.light.map(|v| v / self.count.max(1.0))
    }
}

/// A path on its way.
struct Walk {
    ray: Ray,
    /// What share of light that is found reaches the eye.
    share: [f32; 3],
    /// Chance of the direction taken; infinite where there was no choice.
    chance: f32,
    /// Chance that the way through the panes met since would have been picked.
    through: f32,
    /// Distance since the last surface, and the room of that.
    gone: f32,
    room: u16,
    found: Sample,
    guided: bool,
}

impl Paths<'_> {
    /// One path through a pixel.
    pub(super) fn path(&self, (x, y): (usize, usize), round: u32) -> Sample {
        let mut sampler = Sampler::new((x, y), round, self.how.seed);
        let [dx, dy] = sampler.pair();
        let pose = Affine::of(&self.camera.pose).narrow();
        let along = unit(affine::vector(&pose, self.camera.ray(x as f32 + dx, y as f32 + dy).into()));
        let ray = Ray { from: self.camera.eye().into(), along, end: 1e4 };
        let mut walk = Walk {
            ray,
            share: [1.0; 3],
            chance: f32::INFINITY,
            through: 0.0,
            gone: 0.0,
            room: u16::MAX,
            found: Sample::default(),
            guided: false,
        };
        // Panes do not count as surfaces, but neither may a path go through them for ever.
        let (mut surfaces, mut steps) = (0, 0);
        while surfaces < self.how.bounces.max(1) && steps < 64 {
            steps += 1;
            let Some(met) = self.lighting.tracer.first_of_all(&walk.ray) else {
                let weight = if walk.chance.is_finite() { walk.chance / (walk.chance + walk.through) } else { 1.0 };
                walk.gain(self.lighting.daylight.radiance(walk.ray.along).map(|v| v * weight), surfaces);
                walk.guide([1.0; 3], [0.0; 3], 0.0);
                break;
            };
            let surface = &self.renderer.store.surfaces[usize::from(met.face.surface)];
            if surface.is_clear() {
                self.pane(&mut walk, &met, surface, sampler.one());
                continue;
            }
            if !self.surface(&mut walk, &met, surface, &mut sampler, surfaces) {
                break;
            }
            surfaces += 1;
        }
        walk.found
    }

    fn room(&self, met: &Met<'_>) -> u16 {
        self.lighting.tracer.snapshot.bodies[met.instance.body as usize].room
    }

    /// Through a pane or off it.
    fn pane(&self, walk: &mut Walk, met: &Met<'_>, surface: &Surface, choice: f32) {
        let facing = dot(walk.ray.along, met.normal).abs().min(1.0);
        let edge = (1.0 - facing) * (1.0 - facing);
        let fresnel = 0.04 + 0.96 * edge * edge * (1.0 - facing);
        if choice < fresnel {
            walk.ray.along = mirrored(walk.ray.along, met.normal);
            walk.chance = f32::INFINITY;
        } else {
            walk.gone += met.t;
            walk.through += self.lights.through(
                [walk.room, self.room(met)],
                met.area,
                walk.gone,
                dot(walk.ray.along, met.flat).abs(),
            );
            // A pane has two sides.
            walk.share = [0, 1, 2].map(|i: usize| walk.share[i] * (surface.colour[i] * surface.transmission).sqrt());
        }
        walk.leave(met);
    }

    /// Light at a surface, and where to go on; false where the path ends.
    fn surface(&self, walk: &mut Walk, met: &Met<'_>, surface: &Surface, sampler: &mut Sampler, surfaces: u32) -> bool {
        let look = met.look(surface, 0.002);
        let back = walk.ray.along.map(|v| -v);
        if dot(met.flat, back) < 0.0 {
            // From within a thing: nothing is seen.
            return false;
        }
        let glow = self.lighting.glow(surface, met.instance.body);
        if glow != [0.0; 3] {
            let facing = dot(met.flat, back).max(1e-4);
            let other = self.lights.density(glow) * met.t * met.t / facing;
            let weight = if walk.chance.is_finite() { walk.chance / (walk.chance + other) } else { 1.0 };
            walk.gain(glow.map(|g| g * weight), surfaces);
        }
        walk.guide(look.colour, look.normal, 1.0 / met.t.max(1e-3));
        if surface.is_mirror() {
            walk.share = [0, 1, 2].map(|i: usize| walk.share[i] * look.colour[i]);
            walk.ray.along = mirrored(walk.ray.along, met.normal);
            (walk.chance, walk.through, walk.gone) = (f32::INFINITY, 0.0, 0.0);
            walk.leave(met);
            return true;
        }
        let normal = if dot(look.normal, back) > 0.01 { look.normal } else { met.flat };
        let scatter = Scatter::new(look.colour, surface.metallic, look.roughness, normal, back);
        self.sunlight(walk, met, &scatter, sampler.pair(), surfaces);
        self.lamplight(walk, met, &scatter, (sampler.one(), sampler.pair()), surfaces);
        self.skylight(walk, met, &scatter, (sampler.one(), sampler.pair()), surfaces);
        self.go_on(walk, met, &scatter, sampler, surfaces)
    }

    fn sunlight(&self, walk: &mut Walk, met: &Met<'_>, scatter: &Scatter, [a, b]: [f32; 2], surfaces: u32) {
        let daylight = &self.lighting.daylight;
        if daylight.sun.norm_squared() == 0.0 {
            return;
        }
        let [u, v, towards] = frame(daylight.towards_sun.into());
        let (x, y) = ((2.0 * a - 1.0) * SUN, (2.0 * b - 1.0) * SUN);
        let towards = unit([0, 1, 2].map(|i: usize| towards[i] + x * u[i] + y * v[i]));
        let (value, _) = scatter.evaluate(towards);
        if value != [0.0; 3] && dot(met.flat, towards) > 0.0 {
            let ray = Ray { from: off(met, towards), along: towards, end: 1e4 };
            if !self.lighting.tracer.blocked(&ray) {
                walk.gain([0, 1, 2].map(|i: usize| value[i] * daylight.sun[i]), surfaces + 1);
            }
        }
    }

    fn lamplight(
        &self,
        walk: &mut Walk,
        met: &Met<'_>,
        scatter: &Scatter,
        (which, point): (f32, [f32; 2]),
        surfaces: u32,
    ) {
        let Some(lit) = self.lights.pick(which, point) else { return };
        let to = [0, 1, 2].map(|i: usize| lit.at[i] - met.at[i]);
        let square = dot(to, to).max(1e-6);
        let towards = unit(to);
        let facing = -dot(lit.normal, towards);
        let (value, chance) = scatter.evaluate(towards);
        if facing <= 1e-4 || value == [0.0; 3] || dot(met.flat, towards) <= 0.0 {
            return;
        }
        let ray = Ray { from: off(met, towards), along: towards, end: square.sqrt() * 0.999 - 2e-3 };
        if !self.lighting.tracer.blocked(&ray) {
            let own = lit.density * square / facing;
            let weight = 1.0 / (own + chance);
            walk.gain([0, 1, 2].map(|i: usize| value[i] * lit.light[i] * weight), surfaces + 1);
        }
    }

    /// Light of the sky through a pane.
    fn skylight(
        &self,
        walk: &mut Walk,
        met: &Met<'_>,
        scatter: &Scatter,
        (which, point): (f32, [f32; 2]),
        surfaces: u32,
    ) {
        let room = self.room(met);
        let Some(pane) = self.lights.pane(room, which, point) else { return };
        let towards = unit([0, 1, 2].map(|i: usize| pane[i] - met.at[i]));
        let (value, chance) = scatter.evaluate(towards);
        let mut ray = Ray { from: off(met, towards), along: towards, end: 1e4 };
        if value == [0.0; 3] || dot(met.flat, towards) <= 0.0 || self.lighting.tracer.blocked(&ray) {
            return;
        }
        let (mut share, mut own, mut gone) = ([1.0_f32; 3], 0.0, 0.0);
        for _ in 0..16 {
            let Some(glass) = self.lighting.tracer.first_clear(&ray) else { break };
            let surface = &self.renderer.store.surfaces[usize::from(glass.face.surface)];
            gone += glass.t;
            let cosine = dot(towards, glass.flat).abs();
            own += self.lights.through([room, self.room(&glass)], glass.area, gone, cosine);
            let edge = (1.0 - cosine.min(1.0)) * (1.0 - cosine.min(1.0));
            let passes = 0.96 * (1.0 - edge * edge * (1.0 - cosine.min(1.0)));
            share = [0, 1, 2].map(|i: usize| share[i] * passes * (surface.colour[i] * surface.transmission).sqrt());
            ray.from = off(&glass, towards);
        }
        let sky = self.lighting.daylight.radiance(towards);
        if own > 0.0 {
            let weight = 1.0 / (own + chance);
            walk.gain([0, 1, 2].map(|i: usize| value[i] * sky[i] * share[i] * weight), surfaces + 1);
        }
    }

    fn go_on(&self, walk: &mut Walk, met: &Met<'_>, scatter: &Scatter, sampler: &mut Sampler, surfaces: u32) -> bool {
        let towards = scatter.sample(sampler.one(), sampler.pair());
        let (value, chance) = scatter.evaluate(towards);
        if chance <= 1e-7 || dot(met.flat, towards) <= 0.0 {
            return false;
        }
        walk.share = [0, 1, 2].map(|i: usize| walk.share[i] * value[i] / chance);
        (walk.chance, walk.through, walk.gone, walk.room) = (chance, 0.0, 0.0, self.room(met));
        walk.ray.along = towards;
        walk.leave(met);
        if surfaces < 2 {
            return true;
        }
        // Paths that bring little end by chance, and others count for them.
        let keep = walk.share.iter().fold(0.0_f32, |m, v| m.max(*v)).min(0.95);
        walk.share = walk.share.map(|v| v / keep.max(1e-6));
        sampler.one() < keep
    }
}

/// A little off a surface towards a direction, so that the ray does not meet it again.
fn off(met: &Met<'_>, towards: [f32; 3]) -> [f32; 3] {
    let by = 2e-4_f32.copysign(dot(met.flat, towards)) * (1.0 + 0.2 * met.t.min(20.0));
    [0, 1, 2].map(|i: usize| met.at[i] + by * met.flat[i])
}

fn mirrored(along: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
    let twice = 2.0 * dot(along, normal);
    unit([0, 1, 2].map(|i: usize| along[i] - twice * normal[i]))
}

impl Walk {
    fn leave(&mut self, met: &Met<'_>) {
        self.ray.from = off(met, self.ray.along);
    }

    /// Takes light up, specks of later surfaces cut off.
    fn gain(&mut self, light: [f32; 3], surfaces: u32) {
        let mut brought = [0, 1, 2].map(|i: usize| self.share[i] * light[i]);
        let bright = brightness(brought);
        if surfaces > 1 && bright > MOST {
            brought = brought.map(|v| v * MOST / bright);
        }
        if bright.is_finite() {
            self.found.light = [0, 1, 2].map(|i: usize| self.found.light[i] + brought[i]);
        }
    }

    /// Notes the first surface.
    fn guide(&mut self, colour: [f32; 3], normal: [f32; 3], inverse: f32) {
        if !self.guided {
            self.guided = true;
            (self.found.colour, self.found.normal, self.found.inverse) = (colour, normal, inverse);
        }
    }
}

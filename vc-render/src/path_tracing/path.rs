//! Tracing of a single path.

use super::PathTracing;
use super::cover::Covers;
use super::direct::Point;
use super::glass::mirrored;
use super::lights::Lights;
use super::sampler::Sampler;
use super::spots::{self, Spots};
use super::walk::{Kind, Sample, Walk};
use crate::bvh::Ray;
use crate::camera::Camera;
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
            let Some(hit) = self.lighting.tracer.first_of_all(&walk.ray) else { return self.sky(walk) };
            let surface = &self.store.surfaces[usize::from(hit.face.surface)];
            if surface.is_clear() {
                self.glass(walk, &hit, sampler.one());
            } else if !self.surface(walk, &hit, surface, sampler) {
                return;
            }
        }
    }

    pub(super) fn room(&self, hit: &SurfaceHit<'_>) -> u16 {
        spots::room(self.lighting, hit)
    }

    /// Diameter over which a surface's texture is averaged, metres; textures seen directly are sharp.
    fn footprint(&self, walk: &Walk, hit: &SurfaceHit<'_>) -> f32 {
        let pixel = (hit.t + walk.gone) / self.camera.focal.1;
        if walk.surfaces == 0 { pixel.min(0.002) } else { 0.002 }
    }

    fn sky(&self, walk: &mut Walk) {
        let weight = walk.weight(walk.through);
        let light = self.lighting.daylight.radiance(walk.ray.along).map(|v| v * weight);
        walk.guide([1.0; 3], [0.0; 3], walk.ray.along.map(|v| v * 1e3));
        walk.gain(light, if walk.surfaces == 0 { Kind::Own } else { Kind::Soft });
    }

    /// Handles a surface hit: gathers light and chooses the next direction; false where the path ends.
    fn surface(&self, walk: &mut Walk, hit: &SurfaceHit<'_>, surface: &Surface, sampler: &mut Sampler) -> bool {
        let mut back = walk.ray.along.map(|v| -v);
        // Sheets have two sides in one place, either of which may be hit first. The inside of things is dark
        // anyway.
        let mut hit = &hit.facing(back);
        let look = hit.appearance(surface, self.footprint(walk, hit));
        self.glow(walk, hit, surface);
        if surface.is_mirror() {
            walk.share = three(|i| walk.share[i] * look.colour[i]);
            walk.ray.along = mirrored(walk.ray.along, hit.normal);
            (walk.chance, walk.through, walk.gone) = (f32::INFINITY, 0.0, 0.0);
            walk.ray.from = off(hit, walk.ray.along);
            return true;
        }
        walk.guide(look.colour, hit.normal, hit.at);
        let (share, beyond) = (through(hit, surface), hit.facing(walk.ray.along));
        let passes = share > 0.0 && walk.passes(share, sampler.one());
        if passes {
            // The path continues on the other side, as if it had arrived there.
            (hit, back) = (&beyond, mirrored(back, hit.flat));
        }
        if walk.surfaces >= self.how.bounces {
            return false;
        }
        let normal = if !passes && dot(look.normal, back) > 0.01 { look.normal } else { hit.flat };
        let finish = Finish { colour: look.colour, metallic: surface.metallic, roughness: look.roughness };
        let scatter = Scatter::new(&finish, normal, back);
        let mut place = self.lights.place(hit.at, hit.flat, self.room(hit));
        // Points in a cover's own folds are not sent towards covers.
        place.covers = if hit.instance.covers() { 0.0 } else { self.covers.weight(&place) };
        let point = Point { hit, place, scatter: &scatter };
        self.direct(walk, &point, sampler);
        walk.last = place;
        self.go_on(walk, &point, sampler)
    }

    /// Adds the emission of a surface.
    fn glow(&self, walk: &mut Walk, hit: &SurfaceHit<'_>, surface: &Surface) {
        let glow = self.lighting.glow(surface, hit.instance.body);
        if glow != [0.0; 3] {
            let facing = -dot(hit.flat, walk.ray.along).min(-1e-4);
            let distance = hit.t + walk.gone;
            let other = self.lights.density(&walk.last, hit.instance.body, glow) * distance * distance / facing;
            let shine = hit.shine(surface, self.footprint(walk, hit));
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
        let hit = point.hit;
        let sent = match point.place.covers > 0.0 {
            true => self.covers.towards(&point.place, sampler.one(), sampler.pair()),
            false => None,
        };
        let towards = sent.unwrap_or_else(|| point.scatter.sample(sampler.one(), sampler.pair()));
        let (value, chance) = self.reflected(point, towards);
        if chance <= 1e-7 || dot(hit.flat, towards) <= 0.0 {
            return false;
        }
        walk.share = three(|i| walk.share[i] * value[i] / chance);
        (walk.chance, walk.through, walk.gone) = (chance, 0.0, 0.0);
        walk.ray.along = towards;
        walk.ray.from = off(hit, towards);
        walk.surfaces += 1;
        // Light through a cover is bright, however small the path's throughput is by then.
        if walk.surfaces < 2 || sent.is_some() || hit.instance.covers() {
            return true;
        }
        // Russian roulette: paths with little throughput end by chance, and the others are weighted up.
        let keep = (walk.greatest() / walk.dimmed).min(0.95);
        walk.share = walk.share.map(|v| v / keep.max(1e-6));
        sampler.one() < keep
    }
}

/// A point slightly off a surface towards a direction, so that the ray does not hit it again.
pub(super) fn off(hit: &SurfaceHit<'_>, towards: [f32; 3]) -> [f32; 3] {
    let by = 2e-4_f32.copysign(dot(hit.flat, towards)) * (1.0 + 0.2 * hit.t.min(20.0));
    three(|i| hit.at[i] + by * hit.flat[i])
}

//! Direct light by next-event estimation: from the sun, from lamps, from the sky through panes, and from places
//! lit by the sun.

use super::path::{Paths, off};
use super::sampler::Sampler;
use super::source::Place;
use super::spots::Way;
use super::walk::{Kind, Walk};
use crate::bvh::Ray;
use crate::colour::luminance;
use crate::math::{basis, dot, three, unit};
use crate::ray_casting::SurfaceHit;
use crate::surface::Scatter;

/// Angular radius of the sun, radians: a little larger than the real one, as haze makes it.
const SUN: f32 = 0.008;

/// A surface point at which a path gathers direct light.
pub(super) struct Point<'a> {
    pub(super) hit: &'a SurfaceHit<'a>,
    pub(super) place: Place,
    pub(super) scatter: &'a Scatter,
}

impl Paths<'_> {
    /// Adds direct light at a point: of all kinds at the first surface and at covers, of one randomly chosen
    /// kind elsewhere.
    pub(super) fn direct(&self, walk: &mut Walk, point: &Point<'_>, sampler: &mut Sampler) {
        let kinds = self.kinds(point);
        let all: f32 = kinds.iter().sum();
        if walk.surfaces == 0 || point.hit.instance.covers() {
            return (0..4).filter(|k| kinds[*k] > 0.0).for_each(|k| self.of_kind(walk, point, (k, 1.0), sampler));
        }
        let mut left = sampler.one() * all;
        for (kind, weight) in kinds.into_iter().enumerate().filter(|(_, weight)| *weight > 0.0) {
            if left < weight {
                return self.of_kind(walk, point, (kind, all / weight), sampler);
            }
            left -= weight;
        }
    }

    /// Rough estimates of the light of each kind at a point: from the sun, lamps, the sky, and places lit by
    /// the sun; zero for kinds that are absent.
    fn kinds(&self, point: &Point<'_>) -> [f32; 4] {
        let daylight = &self.lighting.daylight;
        let sun = luminance(daylight.sun.into());
        let sky = luminance((daylight.horizon + daylight.zenith).into()) * 0.5 * point.place.panes;
        let kinds = [0.02 * sun, point.place.lamps, sky, self.spots.power() * 0.02];
        let least = 0.1 * kinds.iter().sum::<f32>();
        kinds.map(|k| if k > 0.0 { k.max(least) } else { 0.0 })
    }

    fn of_kind(&self, walk: &mut Walk, point: &Point<'_>, (kind, counts): (usize, f32), sampler: &mut Sampler) {
        let (which, square) = (sampler.one(), sampler.pair());
        let light = match kind {
            0 => self.sunlight(walk, point, square),
            1 => self.lamplight(point, which, square),
            2 => self.skylight(point, which, square),
            _ => self.spotlight(point, which),
        };
        // Only the sun and lamps can cast sharp shadows.
        let sharp = walk.surfaces == 0 && kind < 2;
        walk.gain(light.map(|v| v * counts), if sharp { Kind::Sharp } else { Kind::Soft });
    }

    fn sunlight(&self, walk: &Walk, point: &Point<'_>, [a, b]: [f32; 2]) -> [f32; 3] {
        use vc_graph::portable::Portable;
        let daylight = &self.lighting.daylight;
        let [u, v, middle] = basis(daylight.towards_sun.into());
        let (s, c) = (std::f32::consts::TAU * a).sine_cosine();
        let (x, y) = (SUN * b.sqrt() * c, SUN * b.sqrt() * s);
        let towards = unit(three(|i| middle[i] + x * u[i] + y * v[i]));
        let way = self.reaches(point, towards, 1e4);
        let (value, _) = point.scatter.evaluate(towards);
        // The path may also have hit this surface by sampling it as a sunlit place.
        let hit = point.hit;
        let facing = -dot(hit.flat, walk.ray.along).min(-1e-4);
        let crossed = if hit.instance.covers() { 0 } else { way.crossed };
        let density = self.spots.density(&walk.last, point.place.room, crossed, dot(hit.flat, towards));
        let weight = walk.weight(density * (hit.t + walk.gone) * (hit.t + walk.gone) / facing);
        three(|i| value[i] * daylight.sun[i] * way.share[i] * weight)
    }

    fn lamplight(&self, point: &Point<'_>, which: f32, square: [f32; 2]) -> [f32; 3] {
        let Some(lit) = self.lights.lit(&point.place, which, square) else { return [0.0; 3] };
        let to = three(|i| lit.at[i] - point.hit.at[i]);
        let square = dot(to, to).max(1e-6);
        let towards = unit(to);
        let facing = -dot(lit.normal, towards);
        if facing <= 1e-4 {
            return [0.0; 3];
        }
        let share = self.reaches(point, towards, square.sqrt() * 0.999 - 2e-3).share;
        let (value, chance) = self.reflected(point, towards);
        let weight = 1.0 / (lit.density * square / facing + chance);
        three(|i| value[i] * lit.light[i] * share[i] * weight)
    }

    /// Sunlight reflected by another place towards the point.
    fn spotlight(&self, point: &Point<'_>, which: f32) -> [f32; 3] {
        let Some(spot) = self.spots.pick(point.place.room, which) else { return [0.0; 3] };
        let to = three(|i| spot.at[i] - point.hit.at[i]);
        let square = dot(to, to).max(1e-6);
        let towards = unit(to);
        let facing = -dot(spot.flat, towards);
        if facing <= 1e-3 {
            return [0.0; 3];
        }
        let (value, chance) = self.reflected(point, towards);
        let share = self.reaches(point, towards, square.sqrt() * 0.999 - 2e-3).share;
        let sun: [f32; 3] = self.lighting.daylight.towards_sun.into();
        let thrown = Scatter::new(&spot.finish, spot.normal, towards.map(|v| -v)).evaluate(sun).0;
        let own = spot.density(self.spots, &point.place, sun) * square / facing;
        let weight = 1.0 / (own + chance);
        three(|i| value[i] * thrown[i] * spot.light[i] * share[i] * weight)
    }

    /// Light of the sky through a pane.
    fn skylight(&self, point: &Point<'_>, which: f32, square: [f32; 2]) -> [f32; 3] {
        let Some(pane) = self.lights.window(&point.place, which, square) else { return [0.0; 3] };
        let towards = unit(three(|i| pane[i] - point.hit.at[i]));
        let (value, chance) = self.reflected(point, towards);
        let way = self.reaches(point, towards, 1e4);
        if way.chance <= 0.0 {
            return [0.0; 3];
        }
        let sky = self.lighting.daylight.radiance(towards);
        let weight = 1.0 / (way.chance + chance);
        three(|i| value[i] * sky[i] * way.share[i] * weight)
    }

    /// Traces light from a direction to a point; solid things block it.
    fn reaches(&self, point: &Point<'_>, towards: [f32; 3], end: f32) -> Way {
        let ray = Ray { from: off(point.hit, towards), along: towards, end };
        if dot(point.hit.flat, towards) <= 0.0 || self.lighting.tracer.blocked(&ray) {
            return Way { share: [0.0; 3], chance: 0.0, crossed: 0 };
        }
        Way::through(self.store, self.lighting, self.lights, ray, Some(&point.place))
    }
}

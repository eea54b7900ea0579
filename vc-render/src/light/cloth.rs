//! Light through drawn blinds and curtains, which leaves them scattered in all directions.

use super::Lighting;
use super::room::Seen;
use crate::bvh::Ray;
use crate::math::{self, Affine, dot, scaled, three};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;
use crate::scene::{Body, Instance};
use crate::surface::{Pattern, Surface};

/// Shares of light that pass a single face: of cloth, and of slats with gaps between them.
const CLOTH: f32 = 0.4;
const SLATS: f32 = 0.15;
/// Diameter over which the pattern of a cover is averaged, metres: the same as in reference pictures, because threads
/// seen close up are darker than the cloth seen from afar.
const NEAR: f32 = 0.002;
/// Greatest number of a cover's faces that a ray passes to find the light behind it.
const FOLDS: usize = 16;
/// Sample points along and up a cover for the light through it.
const PLACES: usize = 8;

/// The share of light that passes the face of a ray hit; zero except on covers that are drawn over an opening.
pub(crate) fn through(hit: &SurfaceHit<'_>, surface: &Surface) -> f32 {
    match surface.pattern {
        _ if !hit.instance.covers() => 0.0,
        Pattern::Weave => CLOTH,
        _ => SLATS,
    }
}

/// The shares of light from one side that a cover reflects and that it transmits, by colour: through its two
/// faces, interreflection between them included.
pub(crate) fn parted(hit: &SurfaceHit<'_>, surface: &Surface) -> [[f32; 3]; 2] {
    let (share, colour) = (through(hit, surface), hit.appearance(surface, NEAR).colour);
    let (goes, back) = (colour.map(|c| share * c), colour.map(|c| (1.0 - share) * c));
    let out = three(|i| goes[i] * goes[i] / (1.0 - back[i] * back[i]).max(1e-3));
    [three(|i| back[i] + out[i] * back[i]), out]
}

/// Radiance that enters the room through each drawn cover, about the same all over it.
pub(super) fn lit(store: &Store, lighting: &Lighting) -> Vec<(u32, [f32; 3])> {
    let snapshot = &lighting.tracer.snapshot;
    let bodies = snapshot.bodies.iter().zip(0..).filter(|(body, _)| body.covers(&snapshot.instances));
    bodies.map(|(body, number)| (number, lighting.comes(store, body, number))).collect()
}

impl Lighting {
    /// Light through a drawn cover, expressed as light that falls on its surface from the front, so that its
    /// pattern shows. None for anything else.
    pub(crate) fn through(&self, surface: &Surface, instance: &Instance) -> Option<[f32; 3]> {
        let index = self.cloth.binary_search_by_key(&instance.body, |(body, _)| *body).ok()?;
        instance.covers().then(|| surface.as_fallen(self.cloth[index].1))
    }

    /// Mean radiance through a cover, seen straight on from its room.
    fn comes(&self, store: &Store, body: &Body, number: u32) -> [f32; 3] {
        let pose = Affine::from_pose(&body.pose).narrow();
        let (along, ways) = (math::vector(&pose, [-1.0, 0.0, 0.0]), super::room::directions());
        let (centre, half) = (body.bounds.centre, body.bounds.half);
        let (mut sum, mut count) = ([0.0; 3], 0.0);
        for index in 0..PLACES * PLACES {
            let [y, z] = [index % PLACES, index / PLACES].map(|i| (2 * i + 1) as f32 / PLACES as f32 - 1.0);
            let from = [centre[0] + half[0] + 0.01, centre[1] + y * half[1], centre[2] + z * half[2]];
            let ray = Ray { from: math::point(&pose, from), along, end: 1e4 };
            let hit = self.tracer.first(&ray).filter(|hit| hit.instance.body == number && hit.instance.covers());
            let Some(hit) = hit.map(|hit| hit.facing(along.map(|v| -v))) else { continue };
            let share = parted(&hit, &store.surfaces[usize::from(hit.face.surface)])[1];
            let about = ways[index * super::room::STRIDE % ways.len()];
            let room = usize::from(body.room).min(self.rooms.len() - 1);
            let behind = self.outside(store, (&hit, self.far_side(&hit, &ray)), about, room);
            sum = three(|i| sum[i] + share[i] * behind[i]);
            count += 1.0;
        }
        scaled(sum, 1.0 / f32::max(count, 1.0))
    }

    /// The light seen on a cover that is drawn over an opening: the light it reflects, and the transmitted
    /// light from behind it, for which a single direction stands for all.
    pub(super) fn past(
        &self,
        store: &Store,
        (cover, ray): (&SurfaceHit<'_>, &Ray),
        about: [f32; 3],
        room: usize,
    ) -> Seen {
        let surface = &store.surfaces[usize::from(cover.face.surface)];
        let ([thrown, share], mean) = (parted(cover, surface), surface.reflected(&cover.instance.coat));
        let own = self.seen(store, cover, room).behind(three(|i| thrown[i] / mean[i].max(1e-3)));
        let behind = self.outside(store, (cover, self.far_side(cover, ray)), about, room);
        Seen { direct: three(|i| own.direct[i] + share[i] * behind[i]), ..own }
    }

    /// A point just behind a cover that a ray passes.
    fn far_side(&self, cover: &SurfaceHit<'_>, ray: &Ray) -> [f32; 3] {
        let step = |at: [f32; 3]| three(|i| at[i] + 1e-3 * ray.along[i]);
        let mut at = step(cover.at);
        for _ in 0..FOLDS {
            let hit = self.tracer.first(&Ray { from: at, ..*ray });
            let Some(hit) = hit.filter(|hit| hit.instance.body == cover.instance.body) else { break };
            at = step(hit.at);
        }
        at
    }

    /// Irradiance on the far side of a cover, over pi: the radiance along one direction or its opposite, taken
    /// as that of all directions; and the sun.
    fn outside(
        &self,
        store: &Store,
        (cover, from): (&SurfaceHit<'_>, [f32; 3]),
        about: [f32; 3],
        room: usize,
    ) -> [f32; 3] {
        let away = dot(cover.flat, about);
        let along = if away < 0.0 { about } else { about.map(|v| -v) };
        let beyond = self.tracer.first(&Ray { from, along, end: 1e4 });
        let end = beyond.map_or(1e4, |hit| hit.t);
        let panes = super::pane::passes(store, &self.tracer, Ray { from, along, end });
        let light = match beyond {
            Some(hit) if dot(hit.flat, along) < 0.0 => self.seen(store, &hit, room).direct,
            Some(_) => [0.0; 3],
            None => self.daylight.radiance(along),
        };
        let towards: [f32; 3] = self.daylight.towards_sun.into();
        let facing = -dot(cover.flat, towards);
        let sunny = facing > 0.0 && !self.tracer.blocked(&Ray { from, along: towards, end: 1e4 });
        let sun = if sunny { self.panes_from(store, from) * facing / std::f32::consts::PI } else { 0.0 };
        three(|i| 2.0 * away.abs() * light[i] * panes[i] + self.daylight.sun[i] * sun)
    }
}

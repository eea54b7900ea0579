//! Places that the sun lights through panes: small and bright, and the source of most light in a room by day.
//! Few paths hit one by chance, so they are sampled deliberately.

use rayon::prelude::*;

use super::lights::Lights;
use super::source::Place;
use crate::bvh::Ray;
use crate::colour::luminance;
use crate::light::{Lighting, straight, tint};
use crate::math::{dot, three};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;
use crate::surface::Finish;

/// Number of rays sent from panes.
const RAYS: u32 = 1 << 16;
/// Share of samples in the room of the lit point, if it has any sunlit places.
const OWN: f32 = 0.8;

/// The sunlit places of a scene.
#[derive(Default)]
pub(super) struct Spots {
    all: Vec<Spot>,
    /// For each room the range of its places.
    rooms: Vec<std::ops::Range<usize>>,
    /// Sunlight through panes, times their area.
    power: f32,
    /// Probability density, for each square metre across the sunlight, with which a place behind one pane is
    /// sampled.
    scale: f32,
}

/// A sunlit place.
pub(super) struct Spot {
    pub(super) at: [f32; 3],
    pub(super) flat: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) finish: Finish,
    /// Sunlight that reaches it, on a surface facing the sun.
    pub(super) light: [f32; 3],
    room: u16,
    /// Number of pane triangles on the way to the sun.
    crossed: u32,
}

impl Spots {
    pub(super) fn new(store: &Store, lighting: &Lighting, lights: &Lights) -> Self {
        let towards: [f32; 3] = lighting.daylight.towards_sun.into();
        if lighting.daylight.sun.norm_squared() == 0.0 {
            return Self::default();
        }
        let (panes, across) = lights.across(towards);
        let spot = |index: u32| {
            let from = lights.pane_point(&panes, (index as f32 + 0.5) / RAYS as f32 * across, index)?;
            Spot::found(store, lighting, lights, from)
        };
        let found = if across > 0.0 { RAYS } else { 0 };
        let mut all: Vec<Spot> = (0..found).into_par_iter().filter_map(spot).collect();
        // The sort is stable: within a room, places stay in the order in which rays were sent.
        all.sort_by_key(|s| s.room);
        let start = |room: u16| all.partition_point(|s| s.room < room);
        let count = lighting.tracer.snapshot.rooms.len() as u16;
        let rooms = (0..count).map(|room| start(room)..start(room + 1)).collect();
        // There are no samples if there is no pane to send rays from.
        let scale = if all.is_empty() { 0.0 } else { RAYS as f32 / (across * all.len() as f32) };
        let power = all.iter().map(|s| luminance(s.light)).sum::<f32>() * across / RAYS as f32;
        Self { all, rooms, power, scale }
    }

    /// Sunlight through panes, times their area; zero if there is none.
    pub(super) fn power(&self) -> f32 {
        self.power
    }

    fn of_room(&self, room: u16) -> &[Spot] {
        self.rooms.get(usize::from(room)).and_then(|r| self.all.get(r.clone())).unwrap_or_default()
    }

    /// Samples a sunlit place for a point in a room.
    pub(super) fn pick(&self, room: u16, which: f32) -> Option<&Spot> {
        let own = self.of_room(room);
        let (from, share) = match () {
            () if own.is_empty() => (self.all.as_slice(), which),
            () if which < OWN => (own, which / OWN),
            () => (self.all.as_slice(), (which - OWN) / (1.0 - OWN)),
        };
        from.get(((share * from.len() as f32) as usize).min(from.len().checked_sub(1)?))
    }

    /// The probability density for each square metre with which a sunlit place is sampled from a point, given
    /// the place's room, the panes crossed on its way to the sun and the cosine there.
    pub(super) fn density(&self, from: &Place, room: u16, crossed: u32, cosine: f32) -> f32 {
        let own = self.of_room(from.room).len();
        let share = match () {
            () if own == 0 => 1.0,
            () if room == from.room => OWN * self.all.len() as f32 / own as f32 + 1.0 - OWN,
            () => 1.0 - OWN,
        };
        self.scale * share * crossed as f32 * cosine.max(0.0)
    }
}

impl Spot {
    pub(super) fn density(&self, spots: &Spots, from: &Place, towards: [f32; 3]) -> f32 {
        spots.density(from, self.room, self.crossed, dot(self.flat, towards))
    }

    /// The place that the sun lights through a point of a pane; none if it is not in the sun.
    fn found(store: &Store, lighting: &Lighting, lights: &Lights, from: [f32; 3]) -> Option<Self> {
        let towards: [f32; 3] = lighting.daylight.towards_sun.into();
        let hit = lighting.tracer.first(&Ray { from, along: towards.map(|v| -v), end: 1e4 })?;
        let surface = &store.surfaces[usize::from(hit.face.surface)];
        let ray = Ray { from: super::path::off(&hit, towards), along: towards, end: 1e4 };
        // A drawn cover transmits as much light as it reflects, so it is left to chance hits.
        let other = surface.is_mirror() || hit.instance.covers();
        if dot(hit.flat, towards) <= 1e-3 || other || lighting.tracer.blocked(&ray) {
            return None;
        }
        let way = Way::through(store, lighting, lights, ray, None);
        let look = hit.appearance(surface, 0.002);
        Some(Self {
            at: hit.at,
            flat: hit.flat,
            normal: look.normal,
            finish: Finish { colour: look.colour, metallic: surface.metallic, roughness: look.roughness },
            light: three(|i| way.share[i] * lighting.daylight.sun[i]),
            room: room(lighting, &hit),
            crossed: way.crossed,
        })
        .filter(|s| s.crossed > 0)
    }
}

/// A straight path through panes.
pub(super) struct Way {
    /// The share of light that passes, by colour.
    pub(super) share: [f32; 3],
    /// The probability density over solid angle with which it would be sampled as a path through a pane.
    pub(super) chance: f32,
    /// Number of large pane triangles crossed.
    pub(super) crossed: u32,
}

impl Way {
    /// Follows a ray through panes; `from` is the point from which it may have been sampled.
    pub(super) fn through(
        store: &Store,
        lighting: &Lighting,
        lights: &Lights,
        mut ray: Ray,
        from: Option<&Place>,
    ) -> Self {
        let (mut way, mut gone) = (Self { share: [1.0; 3], chance: 0.0, crossed: 0 }, 0.0);
        for _ in 0..16 {
            let Some(glass) = lighting.tracer.first_clear(&ray) else { break };
            gone += glass.t;
            let cosine = dot(ray.along, glass.flat).abs().min(1.0);
            if let Some(pane) = lights.window_of(&glass, room(lighting, &glass)) {
                way.crossed += 1;
                way.chance += from.map_or(0.0, |from| lights.through(from, &pane, gone, cosine));
            }
            let (tint, passes) = (tint(store, &glass), straight(&glass, ray.along));
            way.share = three(|i| way.share[i] * passes * tint[i]);
            ray.from = super::path::off(&glass, ray.along);
            ray.end -= glass.t;
        }
        way
    }
}

pub(super) fn room(lighting: &Lighting, hit: &SurfaceHit<'_>) -> u16 {
    lighting.tracer.snapshot.bodies[hit.instance.body as usize].room
}

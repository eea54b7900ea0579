//! Indirect light in rooms: ambient light on a grid in every room.
//!
//! Each point of the grid keeps the light on surfaces that face along the axes. Every room has its own grid, so
//! that no light leaks through walls. Light straight from the sun and from the room's own lamps is left out, as
//! it is shaded with its shadows.

use rayon::prelude::*;

use super::extent::rooms;
use super::grid::Grid;
use super::{Ambient, Daylight, Lighting};
use crate::bvh::Ray;
use crate::colour::luminance;
use crate::math::{dot, three};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;
use crate::scene::{Body, NO_ROOM, Stands};

/// Number of rays from each point.
const RAYS: usize = 256;
/// Diameter over which surface patterns are averaged for indirect light, metres.
const FAR: f32 = 0.05;
/// Step between the indices of a direction seen on a cover and of the one sampled behind it, so that the two
/// are unrelated.
pub(super) const STRIDE: usize = 97;
/// Greatest ratio between the light of successive bounces.
const MOST: f32 = 0.95;
/// The share of the light on a closed door that comes through the gaps around its leaf: some millimetres at the
/// sides, a centimetre below.
const GAPS: f32 = 0.01;
/// Thickness of a door leaf, metres.
const LEAF: f32 = 0.05;
/// The share of the light under the open sky that there is in rooms of which only the outside is drawn.
const WITHIN: f32 = 0.04;
/// Number of bounces before the rest is extrapolated.
const BOUNCES: usize = 7;

/// A reflecting point: position, normal, reflectance and room.
pub(super) type Thrown = ([f32; 3], [f32; 3], [f32; 3], u16);

/// The hit of a ray from a grid point.
pub(super) struct Seen {
    /// Emission, and reflected direct light.
    pub(super) direct: [f32; 3],
    /// The reflecting point; none where the ray hits nothing.
    pub(super) place: Option<Thrown>,
    /// The point on the far side of a closed door, and the share of its light that comes through the gaps.
    pub(super) gaps: Option<Thrown>,
    /// The share of sunlight that panes let through to the hit; zero where the sun does not shine.
    pub(super) sun: f32,
}

/// Directions spread evenly over the sphere (Fibonacci lattice).
pub(super) fn directions() -> Vec<[f32; 3]> {
    use vc_graph::portable::Portable;
    let direction = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f32 / RAYS as f32;
        let (s, c) = (2.399_963_2 * i as f32).sine_cosine();
        let level = (1.0 - z * z).sqrt();
        [level * c, level * s, z]
    };
    (0..RAYS).map(direction).collect()
}

/// The grids of all rooms, and last the one for things in no room.
///
/// Also, for each of them, the share of sunlight that panes let through where the sun shines in.
pub(super) fn grids(store: &Store, lighting: &Lighting) -> (Vec<Grid>, Vec<f32>) {
    let bounds = rooms(&lighting.tracer.snapshot);
    let is_closed = |room: usize| lighting.tracer.snapshot.is_closed(room);
    let mut grids = Grid::over_all(&bounds, is_closed);
    let directions = directions();
    let each = |(g, grid): (usize, &Grid)| (0..grid.points.len()).map(move |i| (g, i)).collect::<Vec<_>>();
    let lit = grids.iter().enumerate().filter(|(room, _)| !is_closed(*room));
    let places: Vec<(usize, usize)> = lit.flat_map(each).collect();
    let within = within(lighting, &grids, &places);
    let cast = |(g, i): &(usize, usize)| cast_rays(store, lighting, *g, grids[*g].place(*i), &directions);
    let cast = |(place, within): (&_, &bool)| within.then(|| cast(place)).flatten();
    let seen: Vec<Option<Vec<Seen>>> = places.par_iter().zip(&within).map(cast).collect();
    let sunlight = sunlight(seen.iter().flatten().flatten(), grids.len());
    let mut sums = vec![[0.0; 2]; grids.len()];
    let mut before: Vec<Vec<Ambient>> = Vec::new();
    for _ in 0..BOUNCES {
        before = grids.iter().map(|grid| grid.points.clone()).collect();
        let gather = |seen: &Option<Vec<Seen>>| seen.as_ref().map(|seen| gathered(&grids, &directions, seen));
        let next: Vec<Option<Ambient>> = seen.par_iter().map(gather).collect();
        for ((g, i), light) in places.iter().zip(next) {
            grids[*g].points[*i] = light.unwrap_or(Ambient::UNKNOWN);
        }
        grids.iter_mut().for_each(Grid::mend);
        for ((grid, before), [last, added]) in grids.iter().zip(&before).zip(&mut sums) {
            (*last, *added) = (*added, grid.more(before));
        }
    }
    // Adds the remaining bounces, which bring much light in white rooms.
    for ((grid, before), [last, added]) in grids.iter_mut().zip(&before).zip(sums) {
        grid.go_on(before, if last > 0.0 { (added / last).clamp(0.0, MOST) } else { 0.0 });
    }
    for (_, closed) in grids.iter_mut().enumerate().filter(|(room, _)| is_closed(*room)) {
        closed.fill(&open(&lighting.daylight, &directions).times(WITHIN));
    }
    // If every body is in a room, the outside is under the open sky.
    if let Some(outside) =
        grids.last_mut().filter(|_| lighting.tracer.snapshot.bodies.iter().all(|b| b.room != NO_ROOM))
    {
        outside.fill(&open(&lighting.daylight, &directions));
    }
    grids.iter_mut().for_each(Grid::settle);
    (grids, sunlight)
}

/// Ambient light under the open sky.
fn open(daylight: &Daylight, directions: &[[f32; 3]]) -> Ambient {
    let mut light = Ambient::default();
    let each = 4.0 * std::f32::consts::PI / directions.len() as f32;
    directions.iter().for_each(|towards| light.add(*towards, daylight.radiance(*towards).map(|v| v * each)));
    light
}

/// The mean share of sunlight that panes let into each room: zero in rooms where the sun does not shine, so
/// that no light leaks in through the edges of shadows. For the outside it is one if it was not measured.
fn sunlight<'a>(seen: impl Iterator<Item = &'a Seen>, rooms: usize) -> Vec<f32> {
    let mut sums = vec![(0.0_f64, 0_u32); rooms];
    for seen in seen.filter(|seen| seen.sun > 0.0) {
        if let Some((.., room)) = seen.place {
            let (sum, count) = &mut sums[usize::from(room).min(rooms - 1)];
            *sum += f64::from(seen.sun);
            *count += 1;
        }
    }
    let share = |(room, (sum, count)): (usize, (f64, u32))| match count {
        0 if room + 1 == rooms => 1.0,
        0 => 0.0,
        count => (sum / f64::from(count)) as f32,
    };
    sums.into_iter().enumerate().map(share).collect()
}

/// For each point, whether it is above a body of its room: boxes of rooms that are not convex reach through
/// their walls. In a room that has nothing below any of its points, all points count.
fn within(lighting: &Lighting, grids: &[Grid], places: &[(usize, usize)]) -> Vec<bool> {
    let tracer = &lighting.tracer;
    let over = |(g, i): &(usize, usize)| {
        let down = Ray { from: grids[*g].place(*i), along: [0.0, 0.0, -1.0], end: 1e4 };
        let below = tracer.first(&down).map(|hit| tracer.snapshot.bodies[hit.instance.body as usize].room);
        below.is_some_and(|room| usize::from(room) == *g)
    };
    let over: Vec<bool> = places.par_iter().map(over).collect();
    let mut any = vec![false; grids.len()];
    places.iter().zip(&over).for_each(|((g, _), over)| any[*g] |= over);
    places.iter().zip(over).map(|((g, _), over)| over || !any[*g]).collect()
}

/// Casts rays from a point; none if the point is inside of things.
fn cast_rays(
    store: &Store,
    lighting: &Lighting,
    room: usize,
    from: [f32; 3],
    directions: &[[f32; 3]],
) -> Option<Vec<Seen>> {
    let tracer = &lighting.tracer;
    let rays: Vec<Ray> = directions.iter().map(|along| Ray { from, along: *along, end: 1e4 }).collect();
    let mut behind = 0;
    let mut seen = Vec::with_capacity(rays.len());
    for (index, ray) in rays.iter().enumerate() {
        let hit = tracer.first(ray);
        if let Some(cover) = hit.as_ref().filter(|hit| hit.instance.covers()) {
            let (cover, other) = (cover.facing(ray.along.map(|v| -v)), directions[index * STRIDE % directions.len()]);
            seen.push(lighting.past(store, (&cover, ray), other, room));
            continue;
        }
        let inside = hit.as_ref().is_some_and(|m| dot(m.flat, ray.along) > 0.0);
        behind += usize::from(inside);
        let share = || {
            let end = hit.as_ref().map_or(ray.end, |hit| hit.t);
            super::pane::passes(store, tracer, Ray { end, ..*ray })
        };
        seen.push(match hit {
            Some(hit) if !inside => lighting.seen(store, &hit, room).behind(share()),
            Some(_) => Seen::only([0.0; 3]),
            None => Seen::only(lighting.daylight.radiance(ray.along)).behind(share()),
        });
    }
    (behind * 5 < directions.len()).then_some(seen)
}

impl Seen {
    /// A ray that hits no reflecting surface.
    fn only(direct: [f32; 3]) -> Self {
        Self { direct, place: None, gaps: None, sun: 0.0 }
    }

    /// The same, seen through panes that let a share of light through.
    pub(super) fn behind(self, share: [f32; 3]) -> Self {
        let less = |(at, normal, colour, room): Thrown| (at, normal, three(|i| colour[i] * share[i]), room);
        let (place, gaps) = (self.place.map(less), self.gaps.map(less));
        Self { direct: three(|i| self.direct[i] * share[i]), place, gaps, ..self }
    }
}

impl Lighting {
    pub(super) fn seen(&self, store: &Store, hit: &SurfaceHit<'_>, room: usize) -> Seen {
        let surface = &store.surfaces[usize::from(hit.face.surface)];
        let body = &self.tracer.snapshot.bodies[hit.instance.body as usize];
        let colour = surface.reflected(&hit.instance.coat);
        let lamp = self.lamps.iter().any(|l| l.body == hit.instance.body && usize::from(l.room) == room);
        let glow = || {
            let (glow, shine) = (self.glow(surface, hit.instance.body), hit.shine(surface, FAR));
            three(|i| glow[i] * shine[i])
        };
        let own = if lamp { [0.0; 3] } else { glow() };
        // Shadow maps let a little light through at edges.
        let towards = || Ray {
            from: three(|i| hit.at[i] + 1e-3 * hit.flat[i]),
            along: self.daylight.towards_sun.into(),
            end: 1e4,
        };
        let lit = self.sunshine(hit.at, hit.normal).is_some_and(|lit| lit > 0.0);
        let sunny = lit && !self.tracer.blocked(&towards());
        let sun = if sunny { self.panes(store, hit) } else { 0.0 };
        let into = self.room_of(body, hit.instance, hit.at, hit.flat);
        let direct = self.direct(hit.at, hit.normal, into, sun);
        let gaps = self.gaps(body, hit, into);
        let past = gaps.map_or([0.0; 3], |(at, normal, share, room)| {
            let falls = self.direct(at, normal, room, 0.0);
            three(|i| share[i] * falls[i])
        });
        let over = 1.0 / std::f32::consts::PI;
        Seen {
            direct: three(|i| own[i] + (colour[i] * direct[i] + past[i]) * over),
            place: Some((hit.at, hit.normal, colour, into)),
            gaps,
            sun,
        }
    }

    /// The light that comes around a closed door leaf from the room behind it.
    fn gaps(&self, body: &Body, hit: &SurfaceHit<'_>, into: u16) -> Option<Thrown> {
        let back = hit.flat.map(|v| -v);
        let from = (body.stands == Stands::Between).then(|| self.room_of(body, hit.instance, hit.at, back))?;
        (from != into).then(|| (three(|i| hit.at[i] + LEAF * back[i]), back, [GAPS; 3], from))
    }

    /// The share of sunlight that panes let through to a surface.
    fn panes(&self, store: &Store, hit: &SurfaceHit<'_>) -> f32 {
        self.panes_from(store, three(|i| hit.at[i] + 1e-3 * hit.flat[i]))
    }

    /// The share of sunlight that panes let through to a point.
    pub(super) fn panes_from(&self, store: &Store, from: [f32; 3]) -> f32 {
        let ray = Ray { from, along: self.daylight.towards_sun.into(), end: 1e4 };
        luminance(super::pane::passes(store, &self.tracer, ray))
    }
}

/// Gathers the light from the hits of rays in all directions, given the light in rooms so far.
fn gathered(grids: &[Grid], directions: &[[f32; 3]], seen: &[Seen]) -> Ambient {
    let mut light = Ambient::default();
    let each = 4.0 * std::f32::consts::PI / RAYS as f32;
    for (towards, one) in directions.iter().zip(seen) {
        let mut radiance = one.direct;
        for (at, normal, colour, room) in one.place.iter().chain(&one.gaps) {
            let falling = grids[usize::from(*room).min(grids.len() - 1)].at(*at).falls(*normal);
            radiance = three(|i| radiance[i] + colour[i] * falling[i] / std::f32::consts::PI);
        }
        light.add(*towards, radiance.map(|v| v * each));
    }
    light
}

//! Light sources for direct sampling: lamps, and panes through which the sky shines; which of them is sampled,
//! and with what probability.

use std::sync::Arc;

use super::source::{Glowing, Lamp, Pane, Place, SMALL, Shown, Triangle, is_window};
use crate::colour::luminance;
use crate::light::Lighting;
use crate::math::{self, dot, low_discrepancy};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;

/// Lamps and panes of a scene.
pub(super) struct Lights {
    lamps: Vec<Lamp>,
    /// Sorted by room.
    panes: Vec<Pane>,
    /// For each room the range of its panes.
    by_room: Vec<std::ops::Range<usize>>,
    glowing: Vec<Glowing>,
    /// For each body the index of its lamp; if out of range, it has none.
    by_body: Vec<u32>,
    /// For each instance whether its clear parts are all small, so that they refract rays.
    bends: Vec<bool>,
    /// For each instance whether the sky shines through its panes, unlike those of cupboards.
    opens: Vec<bool>,
}

/// A sampled point of a lamp.
pub(super) struct Lit {
    pub(super) at: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) light: [f32; 3],
    /// Probability density for each square metre.
    pub(super) density: f32,
}

impl Lights {
    pub(super) fn new(store: &Store, lighting: &Lighting) -> Self {
        let snapshot = &lighting.tracer.snapshot;
        let by_body = vec![u32::MAX; snapshot.bodies.len()];
        let (bends, opens) = (vec![true; snapshot.instances.len()], vec![false; snapshot.instances.len()]);
        let (lamps, panes, by_room, glowing) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut lights = Self { lamps, panes, by_room, glowing, by_body, bends, opens };
        for (index, body) in snapshot.bodies.iter().enumerate() {
            let first = lights.glowing.len();
            for number in body.instances.start as usize..body.instances.end as usize {
                let instance = &snapshot.instances[number];
                let mesh = &*instance.link.levels[0];
                let world = instance.world.narrow();
                let kept = lights.panes.len();
                for (place, cluster) in mesh.clusters.iter().enumerate() {
                    for triangle in cluster.triangles.clone() {
                        let corners = mesh.triangle(cluster, triangle as usize).map(|p| math::point(&world, p));
                        let surface = &store.surfaces[usize::from(mesh.faces[triangle as usize].surface)];
                        if place >= mesh.opaque {
                            lights.bends[number] &= !lights.pane(body.room, Triangle::new(corners));
                        } else if body.lit {
                            let uvs = mesh.uvs.get(triangle as usize).copied().unwrap_or_default();
                            let picture = surface.picture.as_ref().filter(|_| surface.glows());
                            let picture = picture.map(|p| (Arc::clone(p), uvs));
                            let light = lighting.glow(surface, index as u32);
                            lights.glow(first, (Triangle::new(corners), picture), light);
                        }
                    }
                }
                lights.opens[number] = lights.panes[kept..].iter().any(|pane| pane.triangle.opens(lighting));
                lights.panes.truncate(if lights.opens[number] { lights.panes.len() } else { kept });
            }
            lights.lamp(index, body.room, first);
        }
        lights.panes.sort_by_key(|p| p.room);
        let start = |room: u16| lights.panes.partition_point(|p| p.room < room);
        lights.by_room = (0..snapshot.rooms.len() as u16).map(|room| start(room)..start(room + 1)).collect();
        lights
    }

    /// The panes sampled from a room: its own, or all if it has none.
    fn panes_of(&self, room: u16) -> &[Pane] {
        let own = self.by_room.get(usize::from(room)).filter(|r| !r.is_empty());
        own.and_then(|r| self.panes.get(r.clone())).unwrap_or(&self.panes)
    }

    /// Adds a triangle of a pane unless it is small; small ones are left to chance hits.
    fn pane(&mut self, room: u16, triangle: Triangle) -> bool {
        if is_window(triangle.area, triangle.normal) {
            self.panes.push(Pane { room, triangle });
        }
        triangle.area >= SMALL
    }

    /// Whether clear parts of an instance refract rays.
    pub(super) fn bend(&self, instance: u32) -> bool {
        self.bends.get(instance as usize).copied().unwrap_or(false)
    }

    fn glow(&mut self, first: usize, (triangle, picture): (Triangle, Option<Shown>), light: [f32; 3]) {
        let power = triangle.area * luminance(light);
        if power > 0.0 {
            let before = self.glowing.get(first..).and_then(|g| g.last()).map_or(0.0, |g| g.sum);
            self.glowing.push(Glowing { triangle, light, picture, sum: before + power });
        }
    }

    /// Makes a lamp of the triangles added last.
    fn lamp(&mut self, body: usize, room: u16, first: usize) {
        let all = &self.glowing[first..];
        let Some(power) = all.last().map(|g| g.sum) else { return };
        let corners = all.iter().map(|g| g.triangle.middle);
        let around = crate::math::Bounds::around(corners);
        self.by_body[body] = self.lamps.len() as u32;
        self.lamps.push(Lamp {
            room,
            middle: around.centre,
            square: dot(around.half, around.half).max(1e-4),
            power,
            triangles: first..self.glowing.len(),
        });
    }

    /// A lit point, with the estimated weights of its light sources.
    pub(super) fn place(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> Place {
        let mut place = Place { at, normal, room, lamps: 0.0, panes: 0.0, covers: 0.0 };
        place.lamps = self.lamps.iter().map(|l| l.weight(&place)).sum();
        place.panes = self.panes_of(room).iter().map(|p| p.weight(&place)).sum();
        place
    }

    /// Samples a point of a lamp, by its estimated contribution to a point.
    pub(super) fn lit(&self, from: &Place, which: f32, square: [f32; 2]) -> Option<Lit> {
        let mut left = which * from.lamps;
        let mut best = None;
        for lamp in &self.lamps {
            let weight = lamp.weight(from);
            if weight > 0.0 {
                best = Some((lamp, weight, (left / weight).clamp(0.0, 1.0)));
                if left < weight {
                    break;
                }
            }
            left -= weight;
        }
        let (lamp, weight, rest) = best?;
        let all = &self.glowing[lamp.triangles.clone()];
        let index = all.partition_point(|g| g.sum <= rest * lamp.power).min(all.len() - 1);
        let glowing = &all[index];
        // The density uses the brightness without the texture, as a path that hits the lamp by chance can
        // compute that, too.
        let density = weight / from.lamps * luminance(glowing.light) / lamp.power;
        let triangle = &glowing.triangle;
        Some(Lit { at: triangle.point(square), normal: triangle.normal, light: glowing.at(square), density })
    }

    /// The probability density for each square metre with which a point of a body with this emission is
    /// sampled.
    pub(super) fn density(&self, from: &Place, body: u32, light: [f32; 3]) -> f32 {
        match self.lamps.get(self.by_body[body as usize] as usize) {
            Some(lamp) if from.lamps > 0.0 => lamp.weight(from) / from.lamps * luminance(light) / lamp.power,
            _ => 0.0,
        }
    }

    /// Samples a point of a pane, by its estimated solid angle from a point.
    pub(super) fn window(&self, from: &Place, which: f32, square: [f32; 2]) -> Option<[f32; 3]> {
        let mut left = which * from.panes;
        let mut best = None;
        for pane in self.panes_of(from.room) {
            let weight = pane.weight(from);
            if weight > 0.0 {
                best = Some(pane);
                if left < weight {
                    break;
                }
            }
            left -= weight;
        }
        best.map(|pane| pane.triangle.point(square))
    }

    /// The pane triangle of a hit, if it belongs to those sampled deliberately. A sheet has one sampled side,
    /// but rays may hit either.
    pub(super) fn window_of(&self, hit: &SurfaceHit<'_>, room: u16) -> Option<Pane> {
        let picked = if hit.face.sheet { hit.area >= SMALL } else { is_window(hit.area, hit.flat) };
        let picked = picked && self.opens.get(hit.index as usize).is_some_and(|opens| *opens);
        picked.then(|| Pane { room, triangle: Triangle::new(hit.corners()) })
    }

    /// The probability density over solid angle with which a path from a point through a pane is sampled, given
    /// the distance and the cosine at the pane.
    pub(super) fn through(&self, from: &Place, pane: &Pane, distance: f32, cosine: f32) -> f32 {
        // From a room with panes of its own, no others are sampled.
        let others = pane.room != from.room && self.panes_of(from.room).len() != self.panes.len();
        if from.panes <= 0.0 || others {
            return 0.0;
        }
        pane.weight(from) / from.panes * distance * distance / (cosine.max(1e-4) * pane.triangle.area)
    }

    /// Cumulative areas of panes projected along a direction, and their sum.
    pub(super) fn across(&self, towards: [f32; 3]) -> (Vec<f32>, f32) {
        let mut sum = 0.0;
        let area = |p: &Pane| {
            sum += p.triangle.area * dot(p.triangle.normal, towards).abs();
            sum
        };
        let sums: Vec<f32> = self.panes.iter().map(area).collect();
        (sums, sum)
    }

    /// The `index`-th point on the pane at which the cumulative area reaches a number.
    pub(super) fn pane_point(&self, sums: &[f32], at: f32, index: u32) -> Option<[f32; 3]> {
        let pane = self.panes.get(sums.partition_point(|s| *s <= at).min(sums.len().checked_sub(1)?))?;
        Some(pane.triangle.point(low_discrepancy(index)))
    }
}

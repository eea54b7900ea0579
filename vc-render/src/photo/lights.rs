//! What gives light, to be looked for on purpose: lamps, and panes through which the sky shines.

use std::sync::Arc;

use super::sampler::lattice;
use crate::affine::{self, three};
use crate::light::{Lighting, brightness, dot};
use crate::renderer::Renderer;
use crate::surface::Picture;
use crate::trace::Met;

/// How much a lamp in another room than the point that is lit counts.
const ELSEWHERE: f32 = 0.05;
/// Of the two sides of a pane the one that looks about this way is the one that is picked.
const SIDE: [f32; 3] = [0.53, 0.81, 0.25];
/// Area of triangles of panes that are looked through on purpose, square metres.
const SMALL: f32 = 0.05;

/// Lamps and panes of a scene.
pub(super) struct Lights {
    lamps: Vec<Lamp>,
    /// In the order of rooms.
    panes: Vec<Pane>,
    /// Those of each room, in the list of all.
    by_room: Vec<std::ops::Range<usize>>,
    glowing: Vec<Glowing>,
    /// By body, its lamp; beyond the list, none.
    by_body: Vec<u32>,
    /// By instance, whether its clear parts are all small, so that they bend light.
    bends: Vec<bool>,
}

/// Everything that glows of a body.
struct Lamp {
    room: u16,
    middle: [f32; 3],
    /// Square of about half its size.
    square: f32,
    power: f32,
    /// Its triangles, in the list of all.
    triangles: std::ops::Range<usize>,
}

/// A picture, and where a triangle's corners are in it.
type Shown = (Arc<Picture>, [[f32; 2]; 3]);

/// A triangle that glows.
struct Glowing {
    triangle: Triangle,
    light: [f32; 3],
    /// What the light is multiplied with.
    picture: Option<Shown>,
    /// Power of it and of those of its lamp before it.
    sum: f32,
}

/// A triangle of a pane.
pub(super) struct Pane {
    room: u16,
    triangle: Triangle,
}

#[derive(Clone, Copy)]
struct Triangle {
    corner: [f32; 3],
    edges: [[f32; 3]; 2],
    middle: [f32; 3],
    normal: [f32; 3],
    area: f32,
}

/// A point that is lit: where it is, which way it faces, and its room. The camera's has no normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) at: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) room: u16,
    /// Sums of weights of all lamps and panes from here.
    pub(super) lamps: f32,
    pub(super) panes: f32,
}

/// A point of a lamp.
pub(super) struct Lit {
    pub(super) at: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) light: [f32; 3],
    /// Chance for each square metre.
    pub(super) density: f32,
}

impl Triangle {
    fn new([a, b, c]: [[f32; 3]; 3]) -> Self {
        let edge = |p: [f32; 3]| three(|i| p[i] - a[i]);
        let (u, v) = (edge(b), edge(c));
        let cross = affine::cross(u, v);
        let middle = three(|i| (a[i] + b[i] + c[i]) / 3.0);
        Self {
            corner: a,
            edges: [u, v],
            middle,
            normal: crate::label::unit(cross),
            area: 0.5 * dot(cross, cross).sqrt(),
        }
    }

    /// A point of it, evenly.
    fn point(&self, square: [f32; 2]) -> [f32; 3] {
        let [u, v] = weights(square);
        three(|i| self.corner[i] + u * self.edges[0][i] + v * self.edges[1][i])
    }
}

/// Weights of the second and third corner of a triangle at a point of it, evenly.
fn weights([a, b]: [f32; 2]) -> [f32; 2] {
    let root = a.sqrt();
    [1.0 - root, b * root]
}

impl Glowing {
    /// Light from a point of the triangle.
    fn at(&self, square: [f32; 2]) -> [f32; 3] {
        let Some((picture, [a, b, c])) = &self.picture else { return self.light };
        let [u, v] = weights(square);
        let shown = picture.at(0, [0, 1].map(|i: usize| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i])));
        three(|i| self.light[i] * shown[i])
    }
}

impl Lights {
    pub(super) fn of(renderer: &Renderer, lighting: &Lighting) -> Self {
        let snapshot = &lighting.tracer.snapshot;
        let by_body = vec![u32::MAX; snapshot.bodies.len()];
        let bends = vec![true; snapshot.instances.len()];
        let mut lights =
            Self { lamps: Vec::new(), panes: Vec::new(), by_room: Vec::new(), glowing: Vec::new(), by_body, bends };
        for (index, body) in snapshot.bodies.iter().enumerate() {
            let first = lights.glowing.len();
            for number in body.instances.start as usize..body.instances.end as usize {
                let instance = &snapshot.instances[number];
                let mesh = &*instance.link.levels[0];
                let world = instance.world.narrow();
                for (place, cluster) in mesh.clusters.iter().enumerate() {
                    for triangle in cluster.triangles.clone() {
                        let corners = mesh.triangle(cluster, triangle as usize).map(|p| affine::point(&world, p));
                        let surface = &renderer.store.surfaces[usize::from(mesh.faces[triangle as usize].surface)];
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
            }
            lights.lamp(index, body.room, first);
        }
        lights.panes.sort_by_key(|p| p.room);
        let start = |room: u16| lights.panes.partition_point(|p| p.room < room);
        lights.by_room = (0..snapshot.rooms.len() as u16).map(|room| start(room)..start(room + 1)).collect();
        lights
    }

    /// Panes that are looked through from a room: its own, or all if it has none.
    fn panes_of(&self, room: u16) -> &[Pane] {
        let own = self.by_room.get(usize::from(room)).filter(|r| !r.is_empty());
        own.and_then(|r| self.panes.get(r.clone())).unwrap_or(&self.panes)
    }

    /// Adds a triangle of a pane unless it is small; small ones are left to chance.
    fn pane(&mut self, room: u16, triangle: Triangle) -> bool {
        if is_window(triangle.area, triangle.normal) {
            self.panes.push(Pane { room, triangle });
        }
        triangle.area >= SMALL
    }

    /// Whether clear parts of an instance bend light.
    pub(super) fn bend(&self, instance: u32) -> bool {
        self.bends.get(instance as usize).copied().unwrap_or(false)
    }

    fn glow(&mut self, first: usize, (triangle, picture): (Triangle, Option<Shown>), light: [f32; 3]) {
        let power = triangle.area * brightness(light);
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
        let around = crate::mesh::Bounds::around(corners);
        self.by_body[body] = self.lamps.len() as u32;
        self.lamps.push(Lamp {
            room,
            middle: around.centre,
            square: dot(around.half, around.half).max(1e-4),
            power,
            triangles: first..self.glowing.len(),
        });
    }

    /// A place that is lit.
    pub(super) fn place(&self, at: [f32; 3], normal: [f32; 3], room: u16) -> Place {
        let mut place = Place { at, normal, room, lamps: 0.0, panes: 0.0 };
        place.lamps = self.lamps.iter().map(|l| l.weight(&place)).sum();
        place.panes = self.panes_of(room).iter().map(|p| p.weight(&place)).sum();
        place
    }

    /// A point of a lamp, chosen by about how much light it brings to a place.
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
        // By how bright it would be without its picture, so that a way that meets it by chance knows.
        let density = weight / from.lamps * brightness(glowing.light) / lamp.power;
        let triangle = &glowing.triangle;
        Some(Lit { at: triangle.point(square), normal: triangle.normal, light: glowing.at(square), density })
    }

    /// The chance for each square metre that from a place a point of a body with this light is picked.
    pub(super) fn density(&self, from: &Place, body: u32, light: [f32; 3]) -> f32 {
        match self.lamps.get(self.by_body[body as usize] as usize) {
            Some(lamp) if from.lamps > 0.0 => lamp.weight(from) / from.lamps * brightness(light) / lamp.power,
            _ => 0.0,
        }
    }

    /// A point of a pane, chosen by about how large it is seen from a place.
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

    /// The triangle of a pane that was met, if it is looked through on purpose. Of a sheet one side is, but either
    /// may be met.
    pub(super) fn window_of(&self, met: &Met<'_>, room: u16) -> Option<Pane> {
        let picked = if met.face.sheet { met.area >= SMALL } else { is_window(met.area, met.flat) };
        picked.then(|| Pane { room, triangle: Triangle::new(met.corners()) })
    }

    /// The chance for each unit of solid angle that from a place a way through a pane is picked,
    /// given its distance and the cosine to it.
    pub(super) fn through(&self, from: &Place, pane: &Pane, distance: f32, cosine: f32) -> f32 {
        // From a room with panes of its own no others are picked.
        let others = pane.room != from.room && self.panes_of(from.room).len() != self.panes.len();
        if from.panes <= 0.0 || others {
            return 0.0;
        }
        pane.weight(from) / from.panes * distance * distance / (cosine.max(1e-4) * pane.triangle.area)
    }

    /// Sums of the areas of panes as seen from far away, and the last of them.
    pub(super) fn across(&self, towards: [f32; 3]) -> (Vec<f32>, f32) {
        let mut sum = 0.0;
        let area = |p: &Pane| {
            sum += p.triangle.area * dot(p.triangle.normal, towards).abs();
            sum
        };
        let sums: Vec<f32> = self.panes.iter().map(area).collect();
        (sums, sum)
    }

    /// A point of the pane at which those sums reach a number, the index-th of its points.
    pub(super) fn pane_point(&self, sums: &[f32], at: f32, index: u32) -> Option<[f32; 3]> {
        let pane = self.panes.get(sums.partition_point(|s| *s <= at).min(sums.len().checked_sub(1)?))?;
        Some(pane.triangle.point(lattice(index)))
    }
}

impl Lamp {
    fn weight(&self, from: &Place) -> f32 {
        let to = three(|i| self.middle[i] - from.at[i]);
        let near = if self.room == from.room { 1.0 } else { ELSEWHERE };
        self.power / (dot(to, to) + self.square) * near
    }
}

impl Pane {
    fn weight(&self, from: &Place) -> f32 {
        let to = three(|i| self.triangle.middle[i] - from.at[i]);
        let square = dot(to, to);
        let over = 1.0 / square.sqrt().max(1e-6);
        // The pane may reach higher over the surface than its middle.
        let rise = (dot(to, from.normal) * over + 0.3).max(0.0);
        let turned = dot(to, self.triangle.normal).abs() * over + 0.05;
        self.triangle.area * rise * turned / (square + self.triangle.area)
    }
}

fn is_window(area: f32, normal: [f32; 3]) -> bool {
    area >= SMALL && dot(normal, SIDE) > 0.0
}

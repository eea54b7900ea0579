//! Everything that glows, to be looked for directly.

use crate::affine;
use crate::light::{Lighting, brightness};
use crate::renderer::Renderer;

/// Glowing triangles, by how much light they give.
pub(super) struct Lights {
    triangles: Vec<Glowing>,
    /// Sums of light up to and with each triangle.
    sums: Vec<f32>,
    /// Panes, through which the sky shines, by room.
    panes: Vec<Panes>,
}

/// The panes of a room.
#[derive(Default, Clone)]
struct Panes {
    triangles: Vec<[[f32; 3]; 3]>,
    areas: Vec<f32>,
}

struct Glowing {
    corner: [f32; 3],
    edges: [[f32; 3]; 2],
    normal: [f32; 3],
    light: [f32; 3],
}

/// Area of triangles of panes that are looked through on purpose, square metres.
const SMALL: f32 = 0.05;

/// A point of a light.
pub(super) struct Lit {
    pub(super) at: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) light: [f32; 3],
    /// Chance for each square metre.
    pub(super) density: f32,
}

impl Lights {
    pub(super) fn of(renderer: &Renderer, lighting: &Lighting) -> Self {
        let mut lights = Self { triangles: Vec::new(), sums: Vec::new(), panes: Vec::new() };
        let snapshot = &lighting.tracer.snapshot;
        lights.panes.resize(snapshot.rooms.len() + 1, Panes::default());
        for instance in &snapshot.instances {
            let mesh = &*instance.link.levels[0];
            let world = instance.world.narrow();
            for cluster in &mesh.clusters[mesh.opaque..] {
                for triangle in cluster.triangles.clone() {
                    let room = snapshot.bodies[instance.body as usize].room;
                    lights.push_pane(room, mesh.triangle(cluster, triangle as usize).map(|p| affine::point(&world, p)));
                }
            }
            if !snapshot.bodies[instance.body as usize].lit {
                continue;
            }
            for cluster in &mesh.clusters {
                for triangle in cluster.triangles.clone() {
                    let face = &mesh.faces[triangle as usize];
                    let surface = &renderer.store.surfaces[usize::from(face.surface)];
                    let light = lighting.glow(surface, instance.body);
                    lights.push(mesh.triangle(cluster, triangle as usize).map(|p| affine::point(&world, p)), light);
                }
            }
        }
        lights
    }

    fn push(&mut self, [a, b, c]: [[f32; 3]; 3], light: [f32; 3]) {
        let edge = |p: [f32; 3]| [0, 1, 2].map(|i: usize| p[i] - a[i]);
        let (u, v) = (edge(b), edge(c));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let area = 0.5 * (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
        let power = area * brightness(light);
        if power > 0.0 {
            self.sums.push(self.total() + power);
            self.triangles.push(Glowing { corner: a, edges: [u, v], normal: crate::label::unit(cross), light });
        }
    }

    /// Small panes are left to chance.
    fn push_pane(&mut self, room: u16, [a, b, c]: [[f32; 3]; 3]) {
        let edge = |p: [f32; 3]| [0, 1, 2].map(|i: usize| p[i] - a[i]);
        let (u, v) = (edge(b), edge(c));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let area = 0.5 * (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
        if area >= SMALL {
            let last = self.panes.len() - 1;
            let panes = &mut self.panes[usize::from(room).min(last)];
            panes.areas.push(panes.areas.last().copied().unwrap_or(0.0) + area);
            panes.triangles.push([a, u, v]);
        }
    }

    fn panes_of(&self, room: u16) -> &Panes {
        &self.panes[usize::from(room).min(self.panes.len() - 1)]
    }

    /// A point of a pane of a room.
    pub(super) fn pane(&self, room: u16, which: f32, [a, b]: [f32; 2]) -> Option<[f32; 3]> {
        let Panes { triangles, areas } = self.panes_of(room);
        let index = areas.partition_point(|s| *s <= which * areas.last().copied().unwrap_or(0.0));
        let [corner, u, v] = triangles.get(index.min(triangles.len().checked_sub(1)?))?;
        let root = a.sqrt();
        Some([0, 1, 2].map(|i: usize| corner[i] + (1.0 - root) * u[i] + b * root * v[i]))
    }

    /// The chance for each unit of solid angle that from a room a way through a triangle of a
    /// pane is picked, given the pane's room, the triangle's area, its distance and the cosine to it.
    pub(super) fn through(&self, [from, pane]: [u16; 2], area: f32, distance: f32, cosine: f32) -> f32 {
        match self.panes_of(from).areas.last() {
            Some(all) if area >= SMALL && from == pane => distance * distance / (cosine.max(1e-4) * all),
            _ => 0.0,
        }
    }

    fn total(&self) -> f32 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The chance for each square metre that a point of this light is picked.
    pub(super) fn density(&self, light: [f32; 3]) -> f32 {
        if self.triangles.is_empty() { 0.0 } else { brightness(light) / self.total() }
    }

    /// A point, by how much light it gives.
    pub(super) fn pick(&self, which: f32, [a, b]: [f32; 2]) -> Option<Lit> {
        let index = self.sums.partition_point(|s| *s <= which * self.total());
        let one = self.triangles.get(index.min(self.triangles.len().checked_sub(1)?))?;
        let root = a.sqrt();
        let (u, v) = (1.0 - root, b * root);
        let at = [0, 1, 2].map(|i: usize| one.corner[i] + u * one.edges[0][i] + v * one.edges[1][i]);
        Some(Lit { at, normal: one.normal, light: one.light, density: self.density(one.light) })
    }
}

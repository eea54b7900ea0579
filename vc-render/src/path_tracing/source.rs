//! Lamps and panes: their geometry, and estimates of how much light each brings to a point.

use std::sync::Arc;

use crate::bvh::Ray;
use crate::light::Lighting;
use crate::math::{self, basis, cosine_weighted, dot, low_discrepancy, three};
use crate::surface::Picture;

/// Factor for lamps in another room than the lit point.
const ELSEWHERE: f32 = 0.05;
/// The side of a pane that faces this direction is the one that is sampled.
const SIDE: [f32; 3] = [0.53, 0.81, 0.25];
/// Number of rays to each side of a pane that test whether the sky shines through it, and how many must be
/// unblocked.
const OUT: u32 = 64;
const OPEN: usize = 12;
/// Least area of pane triangles that are sampled deliberately, square metres.
pub(super) const SMALL: f32 = 0.05;

/// All luminous triangles of a body.
pub(super) struct Lamp {
    pub(super) room: u16,
    pub(super) middle: [f32; 3],
    /// Square of the half diagonal of its box.
    pub(super) square: f32,
    pub(super) power: f32,
    /// The range of its triangles.
    pub(super) triangles: std::ops::Range<usize>,
}

/// A texture, and the texture coordinates of a triangle's corners.
pub(super) type Shown = (Arc<Picture>, [[f32; 2]; 3]);

/// A luminous triangle.
pub(super) struct Glowing {
    pub(super) triangle: Triangle,
    pub(super) light: [f32; 3],
    /// The texture that its light is multiplied with.
    pub(super) picture: Option<Shown>,
    /// Cumulative power of this triangle and those of its lamp before it.
    pub(super) sum: f32,
}

/// A triangle of a pane.
pub(super) struct Pane {
    pub(super) room: u16,
    pub(super) triangle: Triangle,
}

#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub(super) corner: [f32; 3],
    pub(super) edges: [[f32; 3]; 2],
    pub(super) middle: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) area: f32,
}

/// A lit point: position, normal and room. The camera's has no normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) at: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) room: u16,
    /// Sums of the weights of all lamps, panes and covers as seen from here.
    pub(super) lamps: f32,
    pub(super) panes: f32,
    pub(super) covers: f32,
}

impl Triangle {
    pub(super) fn new([a, b, c]: [[f32; 3]; 3]) -> Self {
        let edge = |p: [f32; 3]| three(|i| p[i] - a[i]);
        let (u, v) = (edge(b), edge(c));
        let cross = math::cross(u, v);
        let middle = three(|i| (a[i] + b[i] + c[i]) / 3.0);
        Self {
            corner: a,
            edges: [u, v],
            middle,
            normal: crate::math::unit(cross),
            area: 0.5 * dot(cross, cross).sqrt(),
        }
    }

    /// A point of the triangle, uniformly distributed.
    pub(super) fn point(&self, square: [f32; 2]) -> [f32; 3] {
        let [u, v] = weights(square);
        three(|i| self.corner[i] + u * self.edges[0][i] + v * self.edges[1][i])
    }

    /// Whether much of the sky is visible from one of its sides.
    pub(super) fn opens(&self, lighting: &Lighting) -> bool {
        [1.0, -1.0].into_iter().any(|side| {
            let axes = basis(self.normal.map(|v| v * side));
            let blocked = |index: &u32| {
                let own = cosine_weighted(low_discrepancy(*index));
                let along = three(|i| own[0] * axes[0][i] + own[1] * axes[1][i] + own[2] * axes[2][i]);
                let from = self.point(low_discrepancy(OUT + index));
                lighting.tracer.blocked(&Ray { from, along, end: 1e4 })
            };
            (0..OUT).filter(|index| !blocked(index)).count() >= OPEN
        })
    }

    /// The probability density over solid angle of a direction from a point, if the triangle's points are
    /// sampled uniformly.
    pub(super) fn density(&self, from: [f32; 3], along: [f32; 3]) -> f32 {
        let facing = dot(self.normal, along);
        let to = three(|i| self.corner[i] - from[i]);
        let distance = dot(self.normal, to) / facing;
        // The intersection with its plane, relative to its corner.
        let at = three(|i| distance * along[i] - to[i]);
        let across = |a: [f32; 3], b: [f32; 3]| dot(self.normal, math::cross(a, b));
        let [u, v] = [across(at, self.edges[1]), across(self.edges[0], at)];
        let within = distance > 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 2.0 * self.area;
        if within { distance * distance / (facing.abs().max(1e-4) * self.area) } else { 0.0 }
    }
}

/// Barycentric weights of the second and third corner for a uniformly distributed point.
fn weights([a, b]: [f32; 2]) -> [f32; 2] {
    let root = a.sqrt();
    [1.0 - root, b * root]
}

impl Glowing {
    /// Emission at a point of the triangle.
    pub(super) fn at(&self, square: [f32; 2]) -> [f32; 3] {
        let Some((picture, [a, b, c])) = &self.picture else { return self.light };
        let [u, v] = weights(square);
        let shown = picture.at(0, [0, 1].map(|i: usize| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i])));
        three(|i| self.light[i] * shown[i])
    }
}

impl Lamp {
    pub(super) fn weight(&self, from: &Place) -> f32 {
        let to = three(|i| self.middle[i] - from.at[i]);
        let near = if self.room == from.room { 1.0 } else { ELSEWHERE };
        self.power / (dot(to, to) + self.square) * near
    }
}

impl Pane {
    pub(super) fn weight(&self, from: &Place) -> f32 {
        let to = three(|i| self.triangle.middle[i] - from.at[i]);
        let square = dot(to, to);
        let over = 1.0 / square.sqrt().max(1e-6);
        // The pane may reach higher above the surface than its centre does.
        let rise = (dot(to, from.normal) * over + 0.3).max(0.0);
        let turned = dot(to, self.triangle.normal).abs() * over + 0.05;
        self.triangle.area * rise * turned / (square + self.triangle.area)
    }
}

pub(super) fn is_window(area: f32, normal: [f32; 3]) -> bool {
    area >= SMALL && dot(normal, SIDE) > 0.0
}

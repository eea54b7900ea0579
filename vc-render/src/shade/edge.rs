//! Where the edges of things cross pixels, so that colours may be smoothed there.
//!
//! The nearer triangle of two neighbouring pixels tells how far it reaches between their
//! centres (after Persson's geometry buffer anti-aliasing, 2011).

use super::planes::Planes;
use super::surfel::{Known, Writer};
use super::tone::{decoded, encoded};
use crate::affine;
use crate::raster::{NONE, Target, Visible};

/// An edge between two pixels of a picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Edge {
    /// The pixel into which it reaches, and the one from which.
    into: u32,
    from: u32,
    /// How much of the pixel is the other's.
    share: f32,
}

/// Finds edges in rows of an image.
pub(super) struct Find<'a> {
    pub(super) writer: &'a Writer<'a>,
    pub(super) solid: &'a Target,
}

impl Find<'_> {
    /// Finds edges between pixels of a row and with the next, if that is in the planes.
    #[inline(always)]
    pub(super) fn row(
        &self,
        (planes, first): (&Planes, usize),
        (y, below): (i32, bool),
        known: &mut Known,
        edges: &mut Vec<Edge>,
    ) {
        let width = planes.width;
        let (here, inverse) = (self.solid.triangle_row(y), self.solid.inverse_row(y));
        let start = y as u32 * width as u32;
        for x in 0..width - 1 {
            if here[x] != here[x + 1]
                && !(planes.look[first + x] == planes.look[first + x + 1] && self.writer.smooth([here[x], here[x + 1]]))
            {
                let share = self.between((here[x], inverse[x]), (here[x + 1], inverse[x + 1]), (x, y, 0), known);
                push(edges, start + x as u32, 1, share);
            }
        }
        if below {
            let (next, deeper) = (self.solid.triangle_row(y + 1), self.solid.inverse_row(y + 1));
            for x in 0..width {
                if here[x] != next[x]
                    && !(planes.look[first + x] == planes.look[first + width + x]
                        && self.writer.smooth([here[x], next[x]]))
                {
                    let share = self.between((here[x], inverse[x]), (next[x], deeper[x]), (x, y, 1), known);
                    push(edges, start + x as u32, width as u32, share);
                }
            }
        }
    }

    /// How the edge between two pixels, the second after the first along an axis, cuts them:
    /// positive is how much of the first is the second's.
    fn between(
        &self,
        first: (u32, f32),
        second: (u32, f32),
        (x, y, axis): (usize, i32, usize),
        known: &mut Known,
    ) -> f32 {
        let forward = first.1 >= second.1;
        let nearer = if forward { first.0 } else { second.0 };
        if nearer == NONE {
            return 0.0;
        }
        let mut from = [x as f32 + 0.5, y as f32 + 0.5];
        from[axis] += if forward { 0.0 } else { 1.0 };
        let step = if forward { 1.0 } else { -1.0 };
        let reach = self.reach(self.writer.visible[nearer as usize], from, (axis, step), known);
        // The owner of the nearer triangle ends within its own pixel.
        reach.map_or(0.0, |r| 0.5 - r) * step
    }

    /// How far a triangle reaches from a point in it along an axis, up to one pixel.
    fn reach(&self, visible: Visible, from: [f32; 2], (axis, step): (usize, f32), known: &mut Known) -> Option<f32> {
        let instances = &self.writer.view.snapshot.instances;
        let mesh = visible.mesh(instances);
        let map = known.maps(visible.instance, instances, &self.writer.frustum)[0];
        let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index()).map(|p| affine::point(&map, p));
        let mut best: Option<f32> = None;
        let area = homogeneous(corners[0], corners[1], corners[2]);
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            // The edge's line over the image, positive inside.
            let line = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            let line = line.map(|v| v * area.signum());
            let here = (line[0] * from[0] + line[1] * from[1] + line[2]).max(0.0);
            let change = line[axis] * step;
            if here + change < 0.0 {
                let at = here / -change;
                best = Some(best.map_or(at, |b: f32| b.min(at)));
            }
        }
        best
    }
}

fn homogeneous(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> f32 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// An edge between a pixel and the one so many after it.
#[inline(always)]
fn push(edges: &mut Vec<Edge>, pixel: u32, step: u32, share: f32) {
    let (into, from) = if share > 0.0 { (pixel, pixel + step) } else { (pixel + step, pixel) };
    if share.abs() > 0.01 {
        edges.push(Edge { into, from, share: share.abs() });
    }
}

/// Mixes into pixels what is their neighbours'. `changes` is memory to work in.
pub(super) fn smooth<'a>(
    edges: impl Iterator<Item = &'a [Edge]>,
    rgb: &mut [[u8; 3]],
    changes: &mut Vec<(u32, [f32; 3])>,
) {
    changes.clear();
    for edge in edges.flatten() {
        let [own, other] = [edge.into, edge.from].map(|at| decoded(rgb[at as usize]));
        changes.push((edge.into, [0, 1, 2].map(|i: usize| edge.share * (other[i] - own[i]))));
    }
    for (at, change) in changes {
        let own = decoded(rgb[*at as usize]);
        rgb[*at as usize] = encoded([0, 1, 2].map(|i: usize| (own[i] + change[i]).max(0.0)));
    }
}

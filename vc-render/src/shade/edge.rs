//! Where the edges of things cross pixels, so that colours may be smoothed there.
//!
//! The nearer triangle of two neighbouring pixels tells how far it reaches between their
//! centres (after Persson's geometry buffer anti-aliasing, 2011).

use crate::affine;
use crate::frame::Strip;
use crate::raster::{Frustum, Layers, Visible};
use crate::scene::Instance;
use crate::shade::Scratch;
use crate::view::View;

/// Writes for each pixel how much of its right and its lower neighbour belongs into it
/// (positive), or of it into the neighbour (negative); 127 is all.
pub(super) fn edges(view: View<'_>, layers: &Layers, scratch: &mut Scratch, strip: &mut Strip<'_>) {
    let solid = if layers.clear { &layers.behind } else { &layers.front };
    let frustum = Frustum::new(view.camera, &strip.rows);
    let instances = &view.snapshot.instances;
    let mut find = Find { frustum: &frustum, instances, layers, scratch };
    let last = view.camera.height as i32 - 1;
    for y in strip.rows.clone() {
        let out = strip.row(y);
        let (here, inverse) = (solid.triangle_row(y), solid.inverse_row(y));
        let below = (y < last).then(|| (solid.triangle_row(y + 1), solid.inverse_row(y + 1)));
        for (x, edge) in strip.edges[out].iter_mut().enumerate() {
            *edge = [0; 2];
            let own = (here[x], inverse[x]);
            if x + 1 < here.len() && here[x + 1] != here[x] {
                edge[0] = find.between(own, (here[x + 1], inverse[x + 1]), ([x as f32 + 0.5, y as f32 + 0.5], 0));
            }
            if let Some((triangles, depths)) = below.filter(|(t, _)| t[x] != here[x]) {
                edge[1] = find.between(own, (triangles[x], depths[x]), ([x as f32 + 0.5, y as f32 + 0.5], 1));
            }
        }
    }
}

struct Find<'a> {
    frustum: &'a Frustum,
    instances: &'a [Instance],
    layers: &'a Layers,
    scratch: &'a mut Scratch,
}

/// A pixel's triangle and inverse depth.
type Seen = (u32, f32);

impl Find<'_> {
    /// How the edge between two pixels cuts them; the second is after the first along an axis.
    fn between(&mut self, first: Seen, second: Seen, (at, axis): ([f32; 2], usize)) -> i8 {
        let [a, b] = [first.0, second.0].map(|t| self.layers.visible.get(t as usize).copied());
        if let (Some(a), Some(b)) = (a, b)
            && self.smooth(a, b)
        {
            return 0;
        }
        let forward = first.1 >= second.1;
        let Some(nearer) = (if forward { a } else { b }) else { return 0 };
        let mut from = at;
        from[axis] += if forward { 0.0 } else { 1.0 };
        let reach = self.reach(nearer, from, axis, if forward { 1.0 } else { -1.0 });
        // Positive: the owner of the nearer triangle ends within its own pixel.
        let share = reach.map_or(0.0, |r| 0.5 - r) * if forward { 1.0 } else { -1.0 };
        (share * 127.0) as i8
    }

    /// Whether two triangles are of one surface without a crease.
    fn smooth(&self, a: Visible, b: Visible) -> bool {
        let [face, other] = [a, b].map(|v| &v.mesh(self.instances).faces[v.index()]);
        let dot = (0..3).map(|i| face.normals[0][i] * other.normals[0][i]).sum::<f32>();
        a.instance == b.instance && face.part == other.part && dot > 0.8
    }

    /// How far a triangle reaches from a point in it along an axis, up to one pixel.
    fn reach(&mut self, visible: Visible, from: [f32; 2], axis: usize, step: f32) -> Option<f32> {
        let mesh = visible.mesh(self.instances);
        let map = self.scratch.maps(visible.instance, self.instances, self.frustum)[0];
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

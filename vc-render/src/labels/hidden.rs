//! Occlusion: which visible points are hidden at another moment.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::Run;
use super::flow::{Motions, PART};
use crate::math::simd::widest;
use crate::math::{Narrow, volume};
use crate::rasterization::{Frustum, Layers, NONE, Visible, refill};
use crate::scene::Instance;
use crate::shot::View;

/// The visibility buffer of another moment, to tell what is hidden then.
#[derive(Default)]
pub(crate) struct Other {
    pub(crate) layers: Layers,
}

/// Projected triangles at the other moment, computed on first use.
#[derive(Default)]
pub(crate) struct Faces {
    /// For each triangle the index of its face.
    known: Vec<u32>,
    faces: Vec<Face>,
}

/// A triangle projected into the image.
struct Face {
    /// Corners as pixels times depth, and depth; and the volume spanned by them and the eye.
    corners: [[f64; 3]; 3],
    volume: f64,
    /// Area in the image, square pixels.
    area: f64,
}

/// Writes 1 for each pixel whose point is not visible at the other moment.
pub(crate) fn hidden(
    now: View<'_>,
    then: View<'_>,
    (layers, runs): (&Layers, &[Run]),
    (motions, faces, other): (&mut Motions, &mut Faces, &Other),
    (width, out): (usize, &mut [u8]),
) {
    let rows = layers.front.rows.clone();
    let [from, to] = [now, then].map(|m| Frustum::new(m.camera, &(0..m.camera.height as i32)));
    faces.reset(other.layers.visible.len());
    let mut there =
        There { layers: &other.layers, instances: &then.snapshot.instances, to: &to, faces, same: [NONE; 2] };
    motions.reset(now.snapshot.instances.len());
    let mut places = Places::NONE;
    out.fill(1);
    for run in runs {
        let at = run.instance as usize;
        let map = motions.map(at, (&now.snapshot.instances[at], &from.map), (&then.snapshot.instances[at], &to.map));
        let row = (run.y - rows.start) as usize * width;
        let (inverse, triangles) = (layers.front.inverse_row(run.y), layers.front.triangle_row(run.y));
        for first in (run.from as usize..run.to as usize).step_by(PART) {
            let last = (first + PART).min(run.to as usize);
            widest(
                #[inline(always)]
                || there.places(&map, (first, run.y), &inverse[first..last], &mut places),
            );
            for (i, x) in (first..last).enumerate() {
                let seen = there.shows_plainly(&places, i, triangles[x])
                    || there.shows(&places, i, (triangles[x], layers.visible[triangles[x] as usize]));
                out[row + x] = u8::from(!seen);
            }
        }
    }
}

impl Faces {
    fn reset(&mut self, count: usize) {
        self.faces.clear();
        refill(&mut self.known, NONE, count);
    }
}

impl Face {
    /// The inverse depth at a place in the image, if the triangle covers it.
    fn covers(&self, [x, y]: [f32; 2], near: f32) -> Option<f32> {
        let (towards, [a, b, c]) = ([f64::from(x), f64::from(y), 1.0], &self.corners);
        // Barycentric coordinates: volumes between the ray and two corners each, as shares of the whole volume.
        let shares = [volume(&towards, b, c), volume(a, &towards, c), volume(a, b, &towards)].map(|v| v / self.volume);
        let there = shares.iter().sum::<f64>() as f32;
        (shares.iter().all(|s| *s >= 0.0) && there * near <= 1.0).then_some(there)
    }
}

/// Where pixels are at the other moment.
struct Places {
    x: [f32; PART],
    y: [f32; PART],
    /// Inverse depth there; NaN outside the image.
    inverse: [f32; PART],
    /// Index of the upper left of the four pixels around the place, and offsets to those on its right and
    /// below.
    first: [u32; PART],
    across: [u32; PART],
    down: [u32; PART],
}

impl Places {
    const NONE: Self = {
        let (real, whole) = ([0.0; PART], [0; PART]);
        Self { x: real, y: real, inverse: real, first: whole, across: whole, down: whole }
    };
}

/// The view at the other moment.
struct There<'a> {
    layers: &'a Layers,
    instances: &'a [Instance],
    to: &'a Frustum,
    faces: &'a mut Faces,
    /// Numbers of one triangle now and at the other moment.
    same: [u32; 2],
}

/// Least ratio of inverse depths at which a triangle occludes a point: above rounding errors, and more for a
/// curve's own mesh at another level of detail, whose outline differs, and for triangles smaller than pixels.
const NEARER: f32 = 1.001;
const COARSER: f32 = 1.02;
const FINER: f32 = 1.01;
/// The same ratio for small triangles of the point's own body, which may be seen at a grazing angle.
const OWN: f32 = 1.04;

/// Area up to which triangles tell little about places beside their pixel, square pixels; and the weight of the
/// pixels around a place that nearer small triangles must have to occlude it.
const SMALL: f64 = 16.0;
const MOSTLY: f32 = 0.5;

/// Conclusion from a triangle visible near a place about a point there.
#[derive(Clone, Copy, PartialEq)]
enum Says {
    /// The triangle is in front of the point.
    Hides,
    /// The point is on the triangle or before it.
    Covers,
    /// The triangle is so small that neighbours of it, which cover no pixel's centre, may be where the point
    /// is. Nearer small triangles occlude the point; those of its own body only if no triangle covers it.
    Little {
        own: bool,
    },
    Nothing,
}

impl There<'_> {
    /// Projects some pixels of a row to the other moment.
    #[inline(always)]
    fn places(&self, map: &Narrow, (first, y): (usize, i32), inverse: &[f32], all: &mut Places) {
        let front = &self.layers.front;
        let (width, height, stride) = (front.width as i32, front.rows.len() as i32, front.all_triangles().1 as u32);
        let (count, y) = (inverse.len().min(PART), y as f32 + 0.5);
        all.inverse[..count].copy_from_slice(&inverse[..count]);
        // Whole vectors are processed; lanes past the end are not used.
        for i in 0..count.next_multiple_of(8).min(PART) {
            let (x, v) = ((first as i32 + i as i32) as f32 + 0.5, all.inverse[i]);
            let z = map[2][0] * x + map[2][1] * y + map[2][2] + map[2][3] * v;
            let over = 1.0 / z;
            let right = (map[0][0] * x + map[0][1] * y + map[0][2] + map[0][3] * v) * over;
            let down = (map[1][0] * x + map[1][1] * y + map[1][2] + map[1][3] * v) * over;
            let inverse = v * over;
            let inside = (z > 0.0) & (right >= 0.0) & (down >= 0.0) & (right < width as f32) & (down < height as f32);
            let seen = inside & (inverse * self.to.near <= 1.0);
            let (x, y) = if seen { (right, down) } else { (0.0, 0.0) };
            let [left, upper] = [x, y].map(|v| (v - 0.5).max(0.0) as i32);
            let (right, lower) = (((x + 0.5) as i32).min(width - 1), ((y + 0.5) as i32).min(height - 1));
            (all.x[i], all.y[i], all.inverse[i]) = (x, y, if seen { inverse } else { f32::NAN });
            all.first[i] = upper as u32 * stride + left as u32;
            (all.across[i], all.down[i]) = ((right - left) as u32, (lower - upper) as u32 * stride);
        }
    }

    /// Whether all four pixels around a point show its own triangle, as for most points; if not, the point may
    /// still be visible.
    #[inline(always)]
    fn shows_plainly(&self, at: &Places, i: usize, own: u32) -> bool {
        let ([now, then], triangles) = (self.same, self.layers.front.all_triangles().0);
        let (upper, lower) = (at.first[i] as usize, (at.first[i] + at.down[i]) as usize);
        let across = at.across[i] as usize;
        now == own
            && !at.inverse[i].is_nan()
            && [upper, upper + across, lower, lower + across].into_iter().all(|pixel| triangles[pixel] == then)
    }

    /// Whether a point is visible, given its triangle: no triangle seen at one of the four pixels around covers
    /// it from before, and these pixels do not mostly show small triangles that are nearer. If no triangle
    /// covers the point, they are smaller than pixels, and it is visible unless all four pixels are nearer.
    #[inline(never)]
    fn shows(&mut self, at: &Places, i: usize, (number, own): (u32, Visible)) -> bool {
        let (x, y, inverse) = (at.x[i], at.y[i], at.inverse[i]);
        if inverse.is_nan() {
            return false;
        }
        let (front, around) = (&self.layers.front, |v: f32, count: usize| {
            [(v - 0.5).max(0.0) as usize, ((v + 0.5) as usize).min(count - 1)]
        });
        let (rows, columns) = (around(y, front.rows.len()), around(x, front.width));
        let near = |v: f32, pixel: usize| 1.0 - (v - 0.5 - pixel as f32).abs();
        let (layers, mut last, mut says) = (self.layers, NONE, Says::Nothing);
        let (mut covered, mut least, mut nearer) = (false, f32::INFINITY, [0.0; 2]);
        for row in rows {
            let (triangles, inverses) = (layers.front.triangle_row(row as i32), layers.front.inverse_row(row as i32));
            for column in columns {
                let triangle = triangles[column];
                least = least.min(inverses[column]);
                if std::mem::replace(&mut last, triangle) != triangle {
                    says = match layers.visible.get(triangle as usize) {
                        None => Says::Nothing,
                        Some(visible) if *visible == own => {
                            self.same = [number, triangle];
                            Says::Covers
                        }
                        Some(visible) => self.says((triangle, *visible), ([x, y], inverse), own),
                    };
                }
                match says {
                    Says::Hides => return false,
                    Says::Covers => covered = true,
                    Says::Little { own } if inverses[column] > inverse * if own { OWN } else { FINER } => {
                        nearer[usize::from(own)] += near(x, column) * near(y, row);
                    }
                    _ => {}
                }
            }
        }
        nearer[0] < MOSTLY && (covered || nearer[1] < MOSTLY && least <= inverse * FINER)
    }

    fn says(&mut self, visible: (u32, Visible), (at, inverse): ([f32; 2], f32), own: Visible) -> Says {
        let near = self.to.near;
        let face = self.face(visible);
        let (there, small) = (face.covers(at, near), face.area < SMALL);
        let (its, coarser) = (visible.1.instance == own.instance, visible.1.level() != own.level());
        match there {
            Some(v) if v > inverse * if its && coarser { COARSER } else { NEARER } => Says::Hides,
            Some(_) => Says::Covers,
            None if small => Says::Little { own: its },
            None => Says::Nothing,
        }
    }

    fn face(&mut self, (number, visible): (u32, Visible)) -> &Face {
        let known = &mut self.faces.known[number as usize];
        if *known == NONE {
            *known = self.faces.faces.len() as u32;
            let mesh = visible.mesh(self.instances);
            let map = self.to.map.after(&self.instances[visible.instance as usize].world);
            let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index());
            let corners = corners.map(|p| map.point(p.map(f64::from)));
            let [a, b, c] = &corners;
            let volume = volume(a, b, c);
            let area = 0.5 * (volume / (a[2] * b[2] * c[2])).abs();
            self.faces.faces.push(Face { corners, volume, area });
        }
        &self.faces.faces[*known as usize]
    }
}

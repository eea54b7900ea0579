//! Culling: bounding volumes outside of the view, and clusters that face away.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use crate::camera::Camera;
use crate::math::{self, Affine, Ball, Bounds, Narrow, three};
use crate::mesh::Cluster;

/// The view volume of a camera, or of some rows of its image.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frustum {
    /// The map from the world to pixels times depth, and depth.
    pub(crate) map: Affine,
    pub(crate) near: f32,
    /// Position of the eye in the world.
    pub(crate) eye: [f32; 3],
    /// The longer focal length, pixels.
    pub(crate) focal: f32,
    /// First column and row, and the ones after the last.
    low: [i32; 2],
    high: [i32; 2],
    /// Planes around the view: in image coordinates, and in the world relative to the eye.
    sides: Sides,
    planes: Sides,
}

/// A number for each plane. There are five planes, but vectors have eight lanes.
type Lanes = [f32; LANES];
const LANES: usize = 8;

/// Planes around a view volume.
#[derive(Debug, Clone, Copy)]
struct Sides {
    /// Normals, which point into the view.
    normals: [Lanes; 3],
    least: Lanes,
}

/// The extent of a box in the image.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    /// Depth of its nearest corner.
    pub(crate) nearest: f32,
    /// First and last pixel that it can touch, within the image.
    pub(crate) low: [i32; 2],
    pub(crate) high: [i32; 2],
}

impl Frustum {
    pub(crate) fn new(camera: &Camera, rows: &std::ops::Range<i32>) -> Self {
        let Camera { focal, centre, .. } = *camera;
        let view = camera.view().0;
        let mix = |f: f32, c: f32, r: usize| {
            [0, 1, 2, 3].map(|k: usize| f64::from(f) * view[r][k] + f64::from(c) * view[2][k])
        };
        let map = Affine([mix(focal.0, centre.0, 0), mix(focal.1, centre.1, 1), view[2]]);
        let (low, high) = ([0, rows.start], [camera.width as i32, rows.end]);
        let sides = Sides::new(low, high, camera.near);
        Self {
            map,
            near: camera.near,
            eye: camera.eye().into(),
            focal: focal.0.max(focal.1),
            low,
            high,
            sides,
            planes: sides.through(&map),
        }
    }

    /// Whether a sphere is entirely outside of the view.
    #[inline(always)]
    pub(crate) fn misses(&self, ball: &Ball) -> bool {
        let to = three(|i| ball.middle[i] - self.eye[i]);
        // The radius is enlarged a little to allow for rounding.
        let far = three(|i| ball.middle[i].abs().max(self.eye[i].abs()));
        let radius = 1.0001 * ball.radius + 1e-6 * (far[0] + far[1] + far[2]);
        self.planes.any_beyond(
            #[inline(always)]
            |n| n[0] * to[0] + n[1] * to[1] + n[2] * to[2] + radius,
        )
    }

    /// The extent of a box in the image, unless it is outside of the view. `map` leads from the box to the
    /// image.
    #[inline(always)]
    pub(crate) fn extent(&self, map: &Narrow, bounds: &Bounds) -> Option<Extent> {
        let middle = math::point(map, bounds.centre);
        let side = |c: usize| [0, 1, 2].map(|r: usize| map[r][c] * bounds.half[c]);
        let sides = [side(0), side(1), side(2)];
        let reach = |n: [f32; 3]| {
            let along = |v: [f32; 3]| n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
            along(middle) + along(sides[0]).abs() + along(sides[1]).abs() + along(sides[2]).abs()
        };
        if self.sides.any_beyond(reach) {
            return None;
        }
        let nearest = middle[2] - sides.iter().map(|s| s[2].abs()).sum::<f32>();
        if nearest <= self.near {
            return Some(Extent { nearest: self.near, low: self.low, high: self.high.map(|v| v - 1) });
        }
        self.projected(middle, sides, nearest)
    }

    /// The extent of a box that is entirely in front of the near plane.
    #[inline(always)]
    fn projected(&self, middle: [f32; 3], sides: [[f32; 3]; 3], nearest: f32) -> Option<Extent> {
        let (mut low, mut high) = ([0.0; 2], [0.0; 2]);
        let mut inverse = [0.0_f32; LANES];
        let corners = |r: usize| {
            let mut at = [0.0_f32; LANES];
            for i in 0..LANES {
                at[i] = middle[r] + SIGNS[0][i] * sides[0][r] + SIGNS[1][i] * sides[1][r] + SIGNS[2][i] * sides[2][r];
            }
            at
        };
        let depth = corners(2);
        for i in 0..LANES {
            inverse[i] = 1.0 / if depth[i] > nearest { depth[i] } else { nearest };
        }
        for axis in 0..2 {
            let mut at = corners(axis);
            for i in 0..LANES {
                at[i] *= inverse[i];
            }
            (low[axis], high[axis]) = ends(at);
        }
        // Half a pixel to the pixel centres, and a hundredth to allow for rounding.
        let first = [0, 1].map(|i: usize| ((low[i] - 0.51).ceil() as i32).max(self.low[i]));
        let last = [0, 1].map(|i: usize| ((high[i] - 0.49).floor() as i32).min(self.high[i] - 1));
        (first[0] <= last[0] && first[1] <= last[1]).then_some(Extent { nearest, low: first, high: last })
    }
}

/// Signs of the corners of a box.
const SIGNS: [Lanes; 3] = [
    [-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0],
    [-1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0],
    [-1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0],
];

/// The least and the greatest of some numbers.
#[inline(always)]
fn ends(at: Lanes) -> (f32, f32) {
    let (mut low, mut high) = (at, at);
    for half in [4, 2, 1] {
        for i in 0..half {
            low[i] = if low[half + i] < low[i] { low[half + i] } else { low[i] };
            high[i] = if high[half + i] > high[i] { high[half + i] } else { high[i] };
        }
    }
    (low[0], high[0])
}

impl Sides {
    /// The near plane, then the planes through the eye: left, right, above, below. Points are given as pixels
    /// times depth, and depth.
    fn new(low: [i32; 2], high: [i32; 2], near: f32) -> Self {
        let (low, high) = (low.map(|v| v as f32), high.map(|v| v as f32));
        let x = [0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let y = [0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0];
        let z = [1.0, -low[0], high[0], -low[1], high[1], 1.0, 1.0, 1.0];
        Self { normals: [x, y, z], least: [near, 0.0, 0.0, 0.0, 0.0, near, near, near] }
    }

    /// The planes in the space that a map leads from, with normals of unit length and without the map's
    /// translation.
    fn through(&self, map: &Affine) -> Self {
        let mut normals = self.normals;
        for i in 0..LANES {
            let own = three(|r| f64::from(self.normals[r][i]));
            let normal = three(|c| own[0] * map.0[0][c] + own[1] * map.0[1][c] + own[2] * map.0[2][c]);
            let length = (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]).sqrt();
            (0..3).for_each(|c| normals[c][i] = (normal[c] / length) as f32);
        }
        Self { normals, least: self.least }
    }

    /// Whether `reach`, evaluated for each plane's normal, falls short of any plane.
    #[inline(always)]
    fn any_beyond(&self, reach: impl Fn([f32; 3]) -> f32) -> bool {
        let mut out = 0;
        for i in 0..LANES {
            out |= u32::from(reach(three(|k| self.normals[k][i])) < self.least[i]);
        }
        out != 0
    }
}

/// Whether all triangles of a cluster face away from the eye, which is given in the mesh's frame.
#[inline(always)]
pub(super) fn looks_away(cluster: &Cluster, eye: [f32; 3]) -> bool {
    let Bounds { centre, half } = cluster.bounds;
    let to = [0, 1, 2].map(|i: usize| centre[i] - eye[i]);
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    dot(to, cluster.axis) >= cluster.spread * dot(to, to).sqrt() + dot(half, half).sqrt()
}

//! What need not be drawn.

use crate::affine::{self, Affine, Narrow, three};
use crate::camera::Camera;
use crate::light::dot;
use crate::mesh::{Ball, Bounds, Cluster};

/// What a camera sees, or some rows of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frustum {
    /// From the world to pixels times depth, and depth.
    pub(crate) map: Affine,
    pub(crate) near: f32,
    /// Where the eye is in the world.
    pub(crate) eye: [f32; 3],
    /// The longer focal length, pixels.
    pub(crate) focal: f32,
    /// First column and row, and those after the last.
    low: [i32; 2],
    high: [i32; 2],
    /// Unit normals of the planes around the view, which look into it: all but the first go through the eye.
    planes: [[f32; 3]; 5],
}

/// Where a box is in the image.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    /// Depth of its nearest corner.
    pub(crate) nearest: f32,
    /// First and last pixel it can touch, within the image.
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
        Self {
            map,
            near: camera.near,
            eye: camera.eye().into(),
            focal: focal.0.max(focal.1),
            low,
            high,
            planes: inwards(low, high).map(|k| {
                let normal = three(|c| (0..3).map(|r| f64::from(k[r]) * map.0[r][c]).sum::<f64>());
                let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt();
                normal.map(|v| (v / length) as f32)
            }),
        }
    }

    /// Whether nothing within a ball can be in the image.
    #[inline(always)]
    pub(crate) fn misses(&self, ball: &Ball) -> bool {
        let to = three(|i| ball.middle[i] - self.eye[i]);
        // A little more, against rounding.
        let far = three(|i| ball.middle[i].abs().max(self.eye[i].abs()));
        let radius = 1.0001 * ball.radius + 1e-6 * (far[0] + far[1] + far[2]);
        let mut out = dot(to, self.planes[0]) + radius < self.near;
        for plane in &self.planes[1..] {
            out |= dot(to, *plane) + radius < 0.0;
        }
        out
    }

    /// Where a box is in the image, if it can be in it at all. `map` leads from the
    /// box to the image.
    #[inline(always)]
    pub(crate) fn extent(&self, map: &Narrow, bounds: &Bounds) -> Option<Extent> {
        let middle = affine::point(map, bounds.centre);
        let side = |c: usize| [0, 1, 2].map(|r: usize| map[r][c] * bounds.half[c]);
        let sides = [side(0), side(1), side(2)];
        let reach = |k: [f32; 3]| {
            let along = |v: [f32; 3]| k[0] * v[0] + k[1] * v[1] + k[2] * v[2];
            along(middle) + sides.iter().map(|s| along(*s).abs()).sum::<f32>()
        };
        let [front, others @ ..] = inwards(self.low, self.high);
        if reach(front) < self.near || others.into_iter().any(|side| reach(side) < 0.0) {
            return None;
        }
        let nearest = middle[2] - sides.iter().map(|s| s[2].abs()).sum::<f32>();
        if nearest <= self.near {
            return Some(Extent { nearest: self.near, low: self.low, high: self.high.map(|v| v - 1) });
        }
        self.projected(middle, sides, nearest)
    }

    /// The extent of a box that is all in front of the eye.
    #[inline(always)]
    fn projected(&self, middle: [f32; 3], sides: [[f32; 3]; 3], nearest: f32) -> Option<Extent> {
        let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
        for corner in 0..8 {
            let sign = |axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
            let at = |r: usize| middle[r] + sign(0) * sides[0][r] + sign(1) * sides[1][r] + sign(2) * sides[2][r];
            let inverse = 1.0 / at(2).max(nearest);
            for axis in 0..2 {
                let v = at(axis) * inverse;
                low[axis] = low[axis].min(v);
                high[axis] = high[axis].max(v);
            }
        }
        // Half a pixel to the centres, a hundredth against rounding.
        let first = [0, 1].map(|i: usize| ((low[i] - 0.51).ceil() as i32).max(self.low[i]));
        let last = [0, 1].map(|i: usize| ((high[i] - 0.49).floor() as i32).min(self.high[i] - 1));
        (first[0] <= last[0] && first[1] <= last[1]).then_some(Extent { nearest, low: first, high: last })
    }
}

/// What pixels times depth, and depth, are multiplied with to tell how far into the view something is: in front of the eye,
/// and of the left, right, upper and lower side.
#[inline(always)]
fn inwards(low: [i32; 2], high: [i32; 2]) -> [[f32; 3]; 5] {
    let (low, high) = (low.map(|v| v as f32), high.map(|v| v as f32));
    [[0.0, 0.0, 1.0], [1.0, 0.0, -low[0]], [-1.0, 0.0, high[0]], [0.0, 1.0, -low[1]], [0.0, -1.0, high[1]]]
}

/// Whether all triangles of a cluster look away from the eye, which is given in the
/// mesh's frame.
#[inline(always)]
pub(super) fn looks_away(cluster: &Cluster, eye: [f32; 3]) -> bool {
    let Bounds { centre, half } = cluster.bounds;
    let to = [0, 1, 2].map(|i: usize| centre[i] - eye[i]);
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    dot(to, cluster.axis) >= cluster.spread * dot(to, to).sqrt() + dot(half, half).sqrt()
}

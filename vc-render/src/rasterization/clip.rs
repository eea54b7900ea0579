//! Clipping of triangles that reach behind the eye or far out of the image.

use super::project::{Corner, GUARD, snapped};

/// Most corners of a triangle clipped by five planes.
const MOST: usize = 8;

/// A point in homogeneous image coordinates: pixels times depth, and depth.
type Homogeneous = [f64; 3];

/// A convex polygon in front of the eye.
pub(super) struct Polygon {
    points: [Homogeneous; MOST],
    count: usize,
}

impl Polygon {
    /// The part of a triangle beyond the near plane and within the guard band.
    pub(super) fn clipped(corners: [Homogeneous; 3], near: f32) -> Self {
        let mut polygon = Self { points: [[0.0; 3]; MOST], count: 3 };
        polygon.points[..3].copy_from_slice(&corners);
        // The planes are a little inside the guard band, as intersections are rounded.
        let guard = 0.99 * f64::from(GUARD);
        polygon.cut(|p| p[2] - f64::from(near));
        polygon.cut(|p| guard * p[2] - p[0]);
        polygon.cut(|p| guard * p[2] + p[0]);
        polygon.cut(|p| guard * p[2] - p[1]);
        polygon.cut(|p| guard * p[2] + p[1]);
        polygon
    }

    /// Clips the polygon to the half space where `inside` is not negative (Sutherland and Hodgman 1974).
    fn cut(&mut self, inside: impl Fn(&Homogeneous) -> f64) {
        let (from, count) = (self.points, self.count);
        self.count = 0;
        for i in 0..count {
            let (here, next) = (from[i], from[(i + 1) % count]);
            let (a, b) = (inside(&here), inside(&next));
            if a >= 0.0 {
                self.push(here);
            }
            if (a >= 0.0) != (b >= 0.0) {
                // Always from inside to outside, so that both triangles at an edge get the same point.
                self.push(if a >= 0.0 { between(here, next, a, b) } else { between(next, here, b, a) });
            }
        }
    }

    fn push(&mut self, point: Homogeneous) {
        if self.count < MOST {
            self.points[self.count] = point;
            self.count += 1;
        }
    }

    /// The polygon split into triangles.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [Corner; 3]> + '_ {
        (2..self.count).map(|i| [corner(self.points[0]), corner(self.points[i - 1]), corner(self.points[i])])
    }
}

fn between(inner: Homogeneous, outer: Homogeneous, a: f64, b: f64) -> Homogeneous {
    let share = a / (a - b);
    [0, 1, 2].map(|i: usize| inner[i] + share * (outer[i] - inner[i]))
}

fn corner([x, y, z]: Homogeneous) -> Corner {
    let (across, down) = ((x / z) as f32, (y / z) as f32);
    Corner { x: snapped(across), y: snapped(down), across, down, inverse: (1.0 / z) as f32 }
}

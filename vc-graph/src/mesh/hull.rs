//! Convex hulls.
//!
//! Quickhull (Barber, Dobkin, Huhdanpaa, ACM TOMS 22:4, 1996) with Shewchuk's exact predicate: a point in the
//! plane of a face does not count as in front of it, so faces with many corners, such as those of a box, need
//! no tolerance.

use std::collections::HashMap;

use nalgebra::Point3;
use robust::{Coord3D, orient3d};

struct Face {
    corners: [usize; 3],
    /// Points in front of this face that are assigned to no older face.
    outside: Vec<usize>,
    alive: bool,
}

struct Hull<'a> {
    points: &'a [Point3<f32>],
    faces: Vec<Face>,
    /// The face to the left of each directed edge.
    left: HashMap<(usize, usize), usize>,
}

/// The hull's triangles, counter-clockwise seen from outside; empty if the points are coplanar.
pub(super) fn triangles(points: &[Point3<f32>]) -> Vec<[usize; 3]> {
    let Some([a, b, c, d]) = simplex(points) else { return Vec::new() };
    let mut hull = Hull { points, faces: Vec::new(), left: HashMap::new() };
    for corners in [[a, b, c], [a, d, b], [b, d, c], [c, d, a]] {
        hull.add(corners);
    }
    hull.hand_out((0..points.len()).collect(), 0);
    let mut at = 0;
    while at < hull.faces.len() {
        if hull.faces[at].alive && !hull.faces[at].outside.is_empty() {
            hull.grow(at);
        }
        at += 1;
    }
    hull.faces.iter().filter(|f| f.alive).map(|f| f.corners).collect()
}

/// Four corners that are not coplanar, the last one below the plane of the other three.
fn simplex(points: &[Point3<f32>]) -> Option<[usize; 4]> {
    let at = |i: usize| points[i].cast::<f64>();
    let a = 0;
    let b = farthest(points.len(), |i| (at(i) - at(a)).norm_squared())?;
    let c = farthest(points.len(), |i| (at(i) - at(a)).cross(&(at(b) - at(a))).norm_squared())?;
    let d = farthest(points.len(), |i| height(points, [a, b, c], i).abs())?;
    Some(if height(points, [a, b, c], d) > 0.0 { [a, c, b, d] } else { [a, b, c, d] })
}

/// The first index with the greatest value, if that is positive.
fn farthest(count: usize, value: impl Fn(usize) -> f64) -> Option<usize> {
    let better = |(best, most): (Option<usize>, f64), i| {
        let v = value(i);
        if v > most { (Some(i), v) } else { (best, most) }
    };
    (0..count).fold((None, 0.0), better).0
}

/// Six times the signed volume between a triangle and a point. The sign, positive outside, is exact.
fn height(points: &[Point3<f32>], corners: [usize; 3], point: usize) -> f64 {
    let at = |i: usize| {
        let p = points[i].cast::<f64>();
        Coord3D { x: p.x, y: p.y, z: p.z }
    };
    -orient3d(at(corners[0]), at(corners[1]), at(corners[2]), at(point))
}

impl Hull<'_> {
    fn sees(&self, point: usize, face: usize) -> bool {
        height(self.points, self.faces[face].corners, point) > 0.0
    }

    fn add(&mut self, corners: [usize; 3]) {
        let [a, b, c] = corners;
        let face = self.faces.len();
        self.left.extend([((a, b), face), ((b, c), face), ((c, a), face)]);
        self.faces.push(Face { corners, outside: Vec::new(), alive: true });
    }

    /// Assigns each point to the first face, from `first` on, that it is in front of.
    fn hand_out(&mut self, points: Vec<usize>, first: usize) {
        for point in points {
            let seen = (first..self.faces.len()).find(|&face| self.sees(point, face));
            if let Some(face) = seen {
                self.faces[face].outside.push(point);
            }
        }
    }

    /// Adds the farthest point in front of a face to the hull.
    fn grow(&mut self, face: usize) {
        let (outside, corners) = (&self.faces[face].outside, self.faces[face].corners);
        let Some(at) = farthest(outside.len(), |i| height(self.points, corners, outside[i])) else { return };
        let apex = outside[at];
        let (visible, horizon) = self.visible(apex, face);
        let mut outside = Vec::new();
        for &face in &visible {
            self.faces[face].alive = false;
            outside.append(&mut self.faces[face].outside);
        }
        let first = self.faces.len();
        for (a, b) in horizon {
            self.add([a, b, apex]);
        }
        self.hand_out(outside, first);
    }

    /// The faces visible from a point, one of which is known, and the edges around them.
    fn visible(&self, point: usize, face: usize) -> (Vec<usize>, Vec<(usize, usize)>) {
        let mut visible = vec![face];
        let mut known = HashMap::from([(face, true)]);
        let mut horizon = Vec::new();
        let mut at = 0;
        while at < visible.len() {
            let [a, b, c] = self.faces[visible[at]].corners;
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let Some(&other) = self.left.get(&(to, from)) else { continue };
                let seen = *known.entry(other).or_insert_with(|| {
                    let seen = self.sees(point, other);
                    if seen {
                        visible.push(other);
                    }
                    seen
                });
                if !seen {
                    horizon.push((from, to));
                }
            }
            at += 1;
        }
        (visible, horizon)
    }
}

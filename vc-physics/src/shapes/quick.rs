//! The convex hull of points (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
//! convex hulls", 1996), in double precision.
//!
//! Costs about `n log n` for `n` points. What is no farther out than a millionth of the
//! coordinates' size, to which they were rounded, counts as within: points of one face stay in
//! one face.

use nalgebra::{Point3, Vector3};

type V = Vector3<f64>;

/// Parts of the largest coordinate that count as nothing.
const ROUNDING: f64 = 1e-6;
/// No point, no face.
const NONE: u32 = u32::MAX;

struct Face {
    corners: [u32; 3],
    /// Across the edge that starts at each corner.
    beyond: [u32; 3],
    normal: V,
    level: f64,
    /// The first of the points outside of it that are its own to see to, and the farthest.
    first: u32,
    farthest: (u32, f64),
    alive: bool,
}

struct Hull {
    points: Vec<V>,
    faces: Vec<Face>,
    /// The next of the points that are the same face's.
    next: Vec<u32>,
    slack: f64,
}

/// The triangles of the hull, counter-clockwise seen from outside; `None` where the points have
/// no volume, or rounding left no closed surface.
pub(super) fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    let points: Vec<V> = points.iter().map(|p| p.coords.cast()).collect();
    let largest = points.iter().fold(0.0, |most: f64, p| most.max(p.amax()));
    let next = vec![NONE; points.len()];
    let mut hull = Hull { points, faces: Vec::new(), next, slack: ROUNDING * largest };
    hull.begin()?;
    let mut open = 0;
    while open < hull.faces.len() {
        if hull.faces[open].alive && hull.faces[open].first != NONE {
            hull.grow(open as u32)?;
        }
        open += 1;
    }
    Some(hull.faces.iter().filter(|f| f.alive).map(|f| f.corners).collect())
}

impl Hull {
    /// The tetrahedron of points that lie far apart, and to whom the others belong.
    fn begin(&mut self) -> Option<()> {
        let [a, b] = self.ends()?;
        let c = self.outermost(|p, all| (p - all[a]).cross(&(all[b] - all[a])).norm_squared());
        let up = (self.points[b] - self.points[a]).cross(&(self.points[c] - self.points[a])).try_normalize(0.0)?;
        let d = self.outermost(|p, all| (p - all[a]).dot(&up).abs());
        let height = (self.points[d] - self.points[a]).dot(&up);
        if height.abs() <= 8.0 * self.slack {
            return None;
        }
        let [a, b, c, d] = [a, b, c, d].map(|i| i as u32);
        let (b, c) = if height > 0.0 { (c, b) } else { (b, c) };
        for (corners, beyond) in
            [([a, b, c], [1, 2, 3]), ([b, a, d], [0, 3, 2]), ([c, b, d], [0, 1, 3]), ([a, c, d], [0, 2, 1])]
        {
            self.push(corners, beyond)?;
        }
        for point in 0..self.points.len() as u32 {
            if ![a, b, c, d].contains(&point) {
                self.give(point, 0);
            }
        }
        Some(())
    }

    /// The two points farthest apart along the widest axis.
    fn ends(&self) -> Option<[usize; 2]> {
        let all = 0..self.points.len();
        let least = |axis: usize| all.clone().min_by(|&i, &j| self.points[i][axis].total_cmp(&self.points[j][axis]));
        let most = |axis: usize| all.clone().max_by(|&i, &j| self.points[i][axis].total_cmp(&self.points[j][axis]));
        let spans = (0..3).filter_map(|axis| Some([least(axis)?, most(axis)?]));
        let span = |ends: &[usize; 2]| (self.points[ends[1]] - self.points[ends[0]]).norm_squared();
        spans.max_by(|a, b| span(a).total_cmp(&span(b)))
    }

    fn outermost(&self, far: impl Fn(&V, &[V]) -> f64) -> usize {
        let far = |i: &usize| far(&self.points[*i], &self.points);
        (0..self.points.len()).max_by(|i, j| far(i).total_cmp(&far(j))).unwrap_or(0)
    }

    fn push(&mut self, corners: [u32; 3], beyond: [u32; 3]) -> Option<()> {
        let [a, b, c] = corners.map(|i| self.points[i as usize]);
        let normal = (b - a).cross(&(c - a)).try_normalize(0.0)?;
        let level = normal.dot(&a);
        self.faces.push(Face { corners, beyond, normal, level, first: NONE, farthest: (NONE, 0.0), alive: true });
        Some(())
    }

    fn outside(&self, face: u32, point: u32) -> f64 {
        let face = &self.faces[face as usize];
        face.normal.dot(&self.points[point as usize]) - face.level
    }

    /// Gives a point to the face, of those from a number on, that it is farthest outside of.
    fn give(&mut self, point: u32, from: usize) {
        let all = (from as u32..self.faces.len() as u32).map(|f| (f, self.outside(f, point)));
        let Some((face, far)) = all.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, far)| *far > self.slack) else {
            return;
        };
        let face = &mut self.faces[face as usize];
        self.next[point as usize] = std::mem::replace(&mut face.first, point);
        if far > face.farthest.1 {
            face.farthest = (point, far);
        }
    }

    /// Takes in the farthest point of a face: what it sees of the hull goes, and a fan from
    /// the edge of that to the point comes instead.
    fn grow(&mut self, face: u32) -> Option<()> {
        let point = self.faces[face as usize].farthest.0;
        let (seen, edge) = self.seen(face, point);
        let edge = in_order(edge)?;
        let from = self.faces.len();
        let count = edge.len() as u32;
        for (k, &(start, end, outer)) in (0..).zip(&edge) {
            let beside = |k: u32| from as u32 + k % count;
            self.push([start, end, point], [outer, beside(k + 1), beside(k + count - 1)])?;
            let outer = &mut self.faces[outer as usize];
            let side = outer.corners.iter().position(|c| *c == end)?;
            outer.beyond[side] = beside(k);
        }
        for face in seen {
            let mut open = std::mem::replace(&mut self.faces[face as usize].first, NONE);
            while open != NONE {
                let next = std::mem::replace(&mut self.next[open as usize], NONE);
                if open != point {
                    self.give(open, from);
                }
                open = next;
            }
        }
        Some(())
    }

    /// The faces that a point sees, which are gone now, and the edges around them with the
    /// faces beyond.
    fn seen(&mut self, face: u32, point: u32) -> (Vec<u32>, Vec<(u32, u32, u32)>) {
        self.faces[face as usize].alive = false;
        let (mut seen, mut edge, mut next) = (vec![face], Vec::new(), 0);
        while let Some(&face) = seen.get(next) {
            next += 1;
            let Face { corners, beyond, .. } = self.faces[face as usize];
            for side in 0..3 {
                let other = beyond[side];
                if !self.faces[other as usize].alive {
                    continue;
                }
                if self.outside(other, point) > self.slack {
                    self.faces[other as usize].alive = false;
                    seen.push(other);
                } else {
                    edge.push((corners[side], corners[(side + 1) % 3], other));
                }
            }
        }
        (seen, edge)
    }
}

/// Edges in the order in which one goes on from the other; `None` if they are not one ring.
fn in_order(mut edge: Vec<(u32, u32, u32)>) -> Option<Vec<(u32, u32, u32)>> {
    for at in 1..edge.len() {
        let follows = |e: &(u32, u32, u32)| e.0 == edge[at - 1].1;
        let found = at + edge[at..].iter().position(follows)?;
        edge.swap(at, found);
    }
    let simple = edge.iter().enumerate().all(|(i, e)| edge[..i].iter().all(|o| o.0 != e.0));
    (edge.len() >= 3 && simple && edge.last()?.1 == edge[0].0).then_some(edge)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::portable::Portable;

    use super::*;

    /// Volume enclosed, and how far the farthest point is outside.
    fn judged(points: &[Point3<f32>], triangles: &[[u32; 3]]) -> (f64, f64) {
        let corner = |i: u32| points[i as usize].coords.cast::<f64>();
        let (mut volume, mut outside) = (0.0, f64::NEG_INFINITY);
        for t in triangles {
            let [a, b, c] = t.map(corner);
            let normal = (b - a).cross(&(c - a));
            volume += a.dot(&normal) / 6.0;
            let far = |p: &Point3<f32>| (p.coords.cast::<f64>() - a).dot(&normal.normalize());
            outside = points.iter().map(far).fold(outside, f64::max);
        }
        (volume, outside)
    }

    #[test]
    fn a_box_with_points_all_over_its_faces_is_a_box() {
        let raster = || (0..5).map(|i| i as f32 * 0.1);
        let all = raster().flat_map(|x| raster().flat_map(move |y| raster().map(move |z| Point3::new(x, y, z))));
        let points: Vec<_> = all.collect();
        let triangles = triangles(&points).unwrap();
        let (volume, outside) = judged(&points, &triangles);
        assert!((volume - 0.064).abs() < 1e-6 && outside < 1e-6, "{volume} {outside}");
    }

    #[test]
    fn nothing_is_outside_of_round_things() {
        let point = |i: u32| {
            let (turn, rise) = (i as f32 * 2.4, (i as f32 + 0.5) / 150.0 - 1.0);
            let ring = (1.0 - rise * rise).max(0.0).sqrt();
            Point3::new(ring * turn.cosine(), ring * turn.sine(), rise) * 0.2 + nalgebra::Vector3::new(3.0, -2.0, 1.0)
        };
        let points: Vec<_> = (0..300).map(point).collect();
        let triangles = triangles(&points).unwrap();
        let (volume, outside) = judged(&points, &triangles);
        let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.008;
        assert!(volume > 0.95 * ball && volume < ball && outside < 1e-5, "{volume} of {ball}, {outside}");
        // Euler's formula, of a closed surface of triangles.
        let mut corners: Vec<u32> = triangles.as_flattened().to_vec();
        corners.sort_unstable();
        corners.dedup();
        assert_eq!(triangles.len(), 2 * corners.len() - 4);
    }

    #[test]
    fn what_is_flat_has_no_hull() {
        let flat: Vec<_> = (0..9).map(|i| Point3::new((i % 3) as f32, (i / 3) as f32, (i % 3) as f32)).collect();
        assert!(triangles(&flat).is_none());
        assert!(triangles(&[]).is_none());
        assert!(triangles(&[Point3::origin(); 7]).is_none());
    }
}

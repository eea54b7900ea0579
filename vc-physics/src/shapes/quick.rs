//! The convex hull of points in double precision (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
//! convex hulls", 1996).
//!
//! Costs about `n log n` for `n` points. The coordinates were rounded, so points outside by less than a
//! millionth of their size count as inside: points of one face stay in one face.
//!
//! The farthest point is always added next, so the hull after a number of corners is nearly as accurate as one
//! with so many corners can be. A rough hull is such an intermediate hull that begins with some required
//! points: points within its tolerance, or beyond its number of corners, are left out.

use nalgebra::{Point3, Vector3};

type V = Vector3<f64>;

/// Rounding tolerance, as a fraction of the largest coordinate.
const ROUNDING: f64 = 1e-6;
/// The index for no point and no face.
const NONE: u32 = u32::MAX;
/// The initial capacity of faces, including faces that are removed again.
const FACES: usize = 128;

struct Face {
    corners: [u32; 3],
    /// The neighbour across the edge that starts at each corner.
    beyond: [u32; 3],
    normal: V,
    level: f64,
    /// The first of the outside points assigned to the face, and the farthest one.
    first: u32,
    farthest: (u32, f64),
    alive: bool,
}

/// Start and end of an edge, and the face beyond it.
type Edge = (u32, u32, u32);

struct Hull {
    points: Vec<V>,
    faces: Vec<Face>,
    /// The next point that is assigned to the same face.
    next: Vec<u32>,
    /// Faces with outside points.
    open: Vec<u32>,
    slack: f64,
    /// The faces visible from an added point, and their boundary; kept to reuse the memory.
    seen: Vec<u32>,
    edge: Vec<Edge>,
    /// The distance outside all faces from which on a point is added.
    reach: f64,
}

/// The tolerance of a rough hull.
pub(super) struct Rough<'a> {
    /// The points that are added first.
    pub(super) first: &'a [u32],
    /// The largest distance of points outside the hull, metres.
    pub(super) by: f32,
    /// The number of corners from which on larger distances are allowed.
    pub(super) corners: usize,
}

/// The triangles of the hull, counter-clockwise seen from outside; `None` if the points have no volume, or
/// rounding left no closed surface.
pub(super) fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    let mut hull = Hull::new(points);
    let all: Vec<u32> = (0..points.len() as u32).collect();
    hull.begin(&all)?;
    hull.grow_to(usize::MAX)?;
    Some(hull.triangles())
}

/// As [`triangles`], for a hull that approximates that of the points.
pub(super) fn rough(points: &[Point3<f32>], rough: &Rough<'_>) -> Option<Vec<[u32; 3]>> {
    let mut hull = Hull::new(points);
    hull.begin(rough.first)?;
    let corners = hull.grow_to(usize::MAX)?;
    hull.reach = hull.reach.max(f64::from(rough.by));
    if corners < rough.corners {
        (0..points.len() as u32).for_each(|point| hull.give(point, 0));
        hull.grow_to(rough.corners - corners)?;
    }
    Some(hull.triangles())
}

impl Hull {
    fn new(points: &[Point3<f32>]) -> Self {
        let points: Vec<V> = points.iter().map(|p| p.coords.cast()).collect();
        let slack = ROUNDING * points.iter().fold(0.0, |most: f64, p| most.max(p.amax()));
        let next = vec![NONE; points.len()];
        let faces = Vec::with_capacity(FACES);
        let (open, seen, edge) = (Vec::new(), Vec::new(), Vec::new());
        Self { points, faces, next, open, slack, seen, edge, reach: slack }
    }

    fn triangles(&self) -> Vec<[u32; 3]> {
        self.faces.iter().filter(|f| f.alive).map(|f| f.corners).collect()
    }

    /// Adds the farthest outside points, at most `most` of them; returns the resulting number of corners.
    fn grow_to(&mut self, most: usize) -> Option<usize> {
        let mut left = most;
        while left > 0
            && let Some(face) = self.farthest()
        {
            self.grow(face)?;
            left -= 1;
        }
        // Euler's formula for a closed surface of triangles.
        Some(self.faces.iter().filter(|f| f.alive).count() / 2 + 2)
    }

    /// The face with the farthest outside point.
    fn farthest(&mut self) -> Option<u32> {
        self.open.retain(|&f| self.faces[f as usize].alive);
        let far = self.open.iter().map(|&f| (f, self.faces[f as usize].farthest.1));
        far.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(f, _)| f)
    }

    /// Builds a tetrahedron of points that lie far apart, and assigns the other points to its faces.
    fn begin(&mut self, among: &[u32]) -> Option<()> {
        let at = |i: u32| self.points[i as usize];
        let [a, b] = self.ends(among)?;
        let c = self.outermost(among, |p| (p - at(a)).cross(&(at(b) - at(a))).norm_squared())?;
        let up = (at(b) - at(a)).cross(&(at(c) - at(a))).try_normalize(0.0)?;
        let d = self.outermost(among, |p| (p - at(a)).dot(&up).abs())?;
        let height = (at(d) - at(a)).dot(&up);
        if height.abs() <= 8.0 * self.slack {
            return None;
        }
        let (b, c) = if height > 0.0 { (c, b) } else { (b, c) };
        for (corners, beyond) in
            [([a, b, c], [1, 2, 3]), ([b, a, d], [0, 3, 2]), ([c, b, d], [0, 1, 3]), ([a, c, d], [0, 2, 1])]
        {
            self.push(corners, beyond)?;
        }
        among.iter().for_each(|&point| self.give(point, 0));
        Some(())
    }

    /// The two points farthest apart along the widest axis.
    fn ends(&self, among: &[u32]) -> Option<[u32; 2]> {
        let ends = |axis: usize| Some([self.outermost(among, |p| -p[axis])?, self.outermost(among, |p| p[axis])?]);
        let span = |[a, b]: &[u32; 2]| (self.points[*b as usize] - self.points[*a as usize]).norm_squared();
        (0..3).filter_map(ends).max_by(|a, b| span(a).total_cmp(&span(b)))
    }

    fn outermost(&self, among: &[u32], far: impl Fn(&V) -> f64) -> Option<u32> {
        let all = among.iter().map(|&i| (i, far(&self.points[i as usize])));
        all.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(i, _)| i)
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

    /// Assigns a point to the face, among those from an index on, that it is farthest outside of.
    fn give(&mut self, point: u32, from: usize) {
        let at = self.points[point as usize];
        let mut best = (NONE, self.reach);
        for (number, face) in (from as u32..).zip(&self.faces[from..]).filter(|(_, f)| f.alive) {
            let far = face.normal.dot(&at) - face.level;
            if far > best.1 {
                best = (number, far);
            }
        }
        let (number, far) = best;
        if number == NONE {
            return;
        }
        let face = &mut self.faces[number as usize];
        if face.first == NONE {
            self.open.push(number);
        }
        self.next[point as usize] = std::mem::replace(&mut face.first, point);
        if far > face.farthest.1 {
            face.farthest = (point, far);
        }
    }

    /// Adds the farthest point of a face: the faces visible from it are removed, and a fan from their boundary
    /// to the point replaces them.
    fn grow(&mut self, face: u32) -> Option<()> {
        let point = self.faces[face as usize].farthest.0;
        self.look(face, point);
        let (seen, mut edge) = (std::mem::take(&mut self.seen), std::mem::take(&mut self.edge));
        if !is_put_in_order(&mut edge) {
            return None;
        }
        let from = self.faces.len();
        let count = edge.len() as u32;
        for (k, &(start, end, outer)) in (0..).zip(&edge) {
            let beside = |k: u32| from as u32 + k % count;
            self.push([start, end, point], [outer, beside(k + 1), beside(k + count - 1)])?;
            let outer = &mut self.faces[outer as usize];
            let side = outer.corners.iter().position(|c| *c == end)?;
            outer.beyond[side] = beside(k);
        }
        for &face in &seen {
            let mut open = std::mem::replace(&mut self.faces[face as usize].first, NONE);
            while open != NONE {
                let next = std::mem::replace(&mut self.next[open as usize], NONE);
                if open != point {
                    self.give(open, from);
                }
                open = next;
            }
        }
        (self.seen, self.edge) = (seen, edge);
        Some(())
    }

    /// Finds and removes the faces visible from a point, and collects the edges around them.
    fn look(&mut self, face: u32, point: u32) {
        self.faces[face as usize].alive = false;
        let (mut seen, mut edge, mut next) = (std::mem::take(&mut self.seen), std::mem::take(&mut self.edge), 0);
        seen.clear();
        edge.clear();
        seen.push(face);
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
        (self.seen, self.edge) = (seen, edge);
    }
}

/// Sorts edges into a ring; returns whether they form one ring.
fn is_put_in_order(edge: &mut [Edge]) -> bool {
    for at in 1..edge.len() {
        let Some(found) = edge[at..].iter().position(|e| e.0 == edge[at - 1].1) else { return false };
        edge.swap(at, at + found);
    }
    let simple = edge.iter().enumerate().all(|(i, e)| edge[..i].iter().all(|o| o.0 != e.0));
    edge.len() >= 3 && simple && edge[edge.len() - 1].1 == edge[0].0
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::portable::Portable;

    use super::*;

    /// The enclosed volume, and the distance of the farthest point outside.
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

    /// Points on a ball that is not at the origin.
    fn round() -> Vec<Point3<f32>> {
        let point = |i: u32| {
            let (turn, rise) = (i as f32 * 2.4, (i as f32 + 0.5) / 150.0 - 1.0);
            let ring = (1.0 - rise * rise).max(0.0).sqrt();
            Point3::new(ring * turn.cosine(), ring * turn.sine(), rise) * 0.2 + nalgebra::Vector3::new(3.0, -2.0, 1.0)
        };
        (0..300).map(point).collect()
    }

    #[test]
    fn a_rough_hull_is_as_true_as_asked_for() {
        let points = round();
        let corners = |triangles: &[[u32; 3]]| triangles.len() / 2 + 2;
        let first = [0, 40, 90, 140, 200, 299];
        let mut fewest = points.len();
        for by in [0.004, 0.008, 0.016] {
            let triangles = rough(&points, &Rough { first: &first, by, corners: usize::MAX }).unwrap();
            let (_, outside) = judged(&points, &triangles);
            assert!(outside <= f64::from(by) + 1e-6 && outside > 0.0, "{by}: {outside}");
            assert!(first.iter().all(|i| triangles.as_flattened().contains(i)));
            assert!(corners(&triangles) < fewest, "{by}");
            fewest = corners(&triangles);
        }
        let triangles = rough(&points, &Rough { first: &first, by: 0.0, corners: 40 }).unwrap();
        let (volume, outside) = judged(&points, &triangles);
        assert!(corners(&triangles) == 40 && volume > 0.025 && outside < 0.03, "{volume} {outside}");
    }

    #[test]
    fn nothing_is_outside_of_round_things() {
        let points = round();
        let triangles = triangles(&points).unwrap();
        let (volume, outside) = judged(&points, &triangles);
        let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.008;
        assert!(volume > 0.95 * ball && volume < ball && outside < 1e-5, "{volume} of {ball}, {outside}");
        // Euler's formula for a closed surface of triangles.
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

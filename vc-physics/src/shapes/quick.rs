//! The convex hull of points (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
//! convex hulls", 1996), in double precision.
//!
//! Costs about `n log n` for `n` points. What is no farther out than a millionth of the
//! coordinates' size, to which they were rounded, counts as within: points of one face stay in
//! one face.
//!
//! What is farthest out comes next, so the hull of the first few corners is about as near as
//! one of so many can be. A rough hull is that, from some points on that it has to have: what is
//! within its tolerance, or comes after its last corner, is left out.

use nalgebra::{Point3, Vector3};

type V = Vector3<f64>;

/// Parts of the largest coordinate that count as nothing.
const ROUNDING: f64 = 1e-6;
/// No point, no face.
const NONE: u32 = u32::MAX;
/// Faces there is room for from the start, those that are gone again among them.
const FACES: usize = 128;

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

/// Where an edge starts and ends, and the face beyond it.
type Edge = (u32, u32, u32);

struct Hull {
    points: Vec<V>,
    faces: Vec<Face>,
    /// The next of the points that are the same face's.
    next: Vec<u32>,
    /// Faces that have had points outside.
    open: Vec<u32>,
    slack: f64,
    /// What a point that is taken in sees, and the edge of that: kept for the next.
    seen: Vec<u32>,
    edge: Vec<Edge>,
    /// How far out of all faces a point has to be to be taken in.
    reach: f64,
}

/// How rough a hull may be.
pub(super) struct Rough<'a> {
    /// The points that are taken in first.
    pub(super) first: &'a [u32],
    /// How far points may be outside, metres.
    pub(super) by: f32,
    /// From how many corners on they may be farther outside.
    pub(super) corners: usize,
}

/// The triangles of the hull, counter-clockwise seen from outside; `None` where the points have
/// no volume, or rounding left no closed surface.
pub(super) fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    let mut hull = Hull::new(points);
    let all: Vec<u32> = (0..points.len() as u32).collect();
    hull.begin(&all)?;
    hull.grow_to(usize::MAX)?;
    Some(hull.triangles())
}

/// As [`triangles`], of a hull that is about that of the points.
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

    /// Takes in the points that are farthest outside, so many at most; gives how many corners
    /// there are then.
    fn grow_to(&mut self, most: usize) -> Option<usize> {
        let mut left = most;
        while left > 0
            && let Some(face) = self.farthest()
        {
            self.grow(face)?;
            left -= 1;
        }
        // Euler's formula, of a closed surface of triangles.
        Some(self.faces.iter().filter(|f| f.alive).count() / 2 + 2)
    }

    /// The face that a point is farthest outside of.
    fn farthest(&mut self) -> Option<u32> {
        self.open.retain(|&f| self.faces[f as usize].alive);
        let far = self.open.iter().map(|&f| (f, self.faces[f as usize].farthest.1));
        far.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(f, _)| f)
    }

    /// The tetrahedron of points that lie far apart, and to whom the others belong.
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

    /// Gives a point to the face, of those from a number on, that it is farthest outside of.
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

    /// Takes in the farthest point of a face: what it sees of the hull goes, and a fan from
    /// the edge of that to the point comes instead.
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

    /// Finds the faces that a point sees, which are gone now, and the edges around them.
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

/// Puts edges in the order in which one goes on from the other; whether they are one ring.
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

    /// Points all over a ball that is not at the origin.
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

//! The convex hull of points in double precision (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
//! convex hulls", 1996).
//!
//! Costs about `n log n` for `n` points. The coordinates were rounded, so points outside by less than a
//! millionth of their size count as inside: points of one face stay in one face.
//!
//! The farthest point is always added next, so the hull after a number of corners is nearly as accurate as one
//! with so many corners can be. An approximate hull is such an intermediate hull that begins with some required
//! points: points within its tolerance, or beyond its number of corners, are left out.
//!
//! `vc_graph` makes the surface of [`Shape::Hull`](vc_graph::asset::Shape) by an exact predicate instead: there
//! every point outside counts, however little, as a picture shows it; here faces have to stay flat, as bodies
//! stand on them.
//!
//! ```
//! use nalgebra::Point3;
//! let corner = |i: usize| Point3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32);
//! let mut points: Vec<_> = (0..8).map(corner).collect();
//! points.push(Point3::new(0.5, 0.5, 0.5));
//! let triangles = vc_geometry::hull::triangles(&points).ok_or("flat")?;
//! assert_eq!(triangles.len(), 12);
//! assert!(!triangles.as_flattened().contains(&8));
//! # Ok::<(), &str>(())
//! ```

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

/// The tolerance of an approximate hull.
#[derive(Debug, Clone, Copy)]
pub struct HullTolerance<'a> {
    /// The points that are added first, by index.
    pub first: &'a [u32],
    /// The largest distance of points outside the hull, metres.
    pub by: f32,
    /// The number of corners from which on larger distances are allowed.
    pub corners: usize,
}

/// The triangles of the hull by index, counter-clockwise seen from outside; `None` if the points have no volume, or
/// rounding left no closed surface.
///
/// ```
/// use nalgebra::Point3;
/// let tetrahedron = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.1; 3]].map(Point3::from);
/// assert_eq!(vc_geometry::hull::triangles(&tetrahedron).map(|all| all.len()), Some(4));
/// let flat = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
/// assert!(vc_geometry::hull::triangles(&flat).is_none());
/// ```
pub fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    let mut hull = Hull::new(points);
    let all: Vec<u32> = (0..points.len() as u32).collect();
    hull.begin(&all)?;
    hull.grow_to(usize::MAX)?;
    Some(hull.triangles())
}

/// As [`triangles`], for a hull that approximates that of the points; `None` also if the points to begin with have
/// no volume.
///
/// ```
/// use nalgebra::Point3;
/// use vc_geometry::hull::{HullTolerance, approximate, triangles};
/// // Points on a sphere.
/// let point = |i: i32| {
///     let (z, turn) = (i as f32 / 100.0 - 1.0, 2.4 * i as f32);
///     let radius = (1.0 - z * z).max(0.0).sqrt();
///     Point3::new(radius * turn.cos(), radius * turn.sin(), z)
/// };
/// let ball: Vec<_> = (0..=200).map(point).collect();
/// let tolerance = HullTolerance { first: &[0, 50, 100, 150, 200], by: 0.05, corners: 1000 };
/// let few = approximate(&ball, &tolerance).ok_or("flat")?;
/// assert!(few.len() < triangles(&ball).ok_or("flat")?.len() / 2);
/// # Ok::<(), &str>(())
/// ```
pub fn approximate(points: &[Point3<f32>], tolerance: &HullTolerance<'_>) -> Option<Vec<[u32; 3]>> {
    if tolerance.first.iter().any(|&point| point as usize >= points.len()) {
        return None;
    }
    let mut hull = Hull::new(points);
    hull.begin(tolerance.first)?;
    let corners = hull.grow_to(usize::MAX)?;
    hull.reach = hull.reach.max(f64::from(tolerance.by));
    if corners < tolerance.corners {
        (0..points.len() as u32).for_each(|point| hull.give(point, 0));
        hull.grow_to(tolerance.corners - corners)?;
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
        if height.is_nan() || height.abs() <= 8.0 * self.slack {
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

//! Cutting of surfaces by planes.
//!
//! A piece of a body is convex, so other shapes are cut: a thing that holds others along the sides of the space
//! above its surfaces, a part of the building along its own concave faces, so that a wall's mesh keeps its
//! doorway.
//!
//! ```
//! use nalgebra::Point3;
//! use vc_geometry::cut::{Plane, Surface};
//! // A corner of two walls, seen from above: six sides, and a roof and a floor of six corners each.
//! let plan = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
//! let points: Vec<_> = [0.0, 1.0].iter().flat_map(|z| plan.map(|(x, y)| Point3::new(x, y, *z))).collect();
//! let mut triangles: Vec<[u32; 3]> = vec![[0, 3, 1], [1, 3, 2], [0, 5, 3], [3, 5, 4]];
//! triangles.extend(triangles.clone().into_iter().map(|[a, b, c]| [a + 6, c + 6, b + 6]));
//! triangles.extend((0..6).flat_map(|i| [[i, (i + 1) % 6, i + 6], [(i + 1) % 6, (i + 1) % 6 + 6, i + 6]]));
//! let (mut surface, polygons) = Surface::new(points, &triangles);
//! let [low, high] = surface.divided(&polygons, Plane::across(2, 0.25));
//! assert!(surface.corners(&low).iter().all(|p| p.z <= 0.25) && surface.corners(&high).iter().all(|p| p.z >= 0.25));
//! let pieces = surface.along_faces(polygons, Some);
//! assert_eq!(pieces.len(), 2);
//! ```

use nalgebra::{Point3, Vector3};

/// The largest distance of a corner in front of a face of the same convex piece, metres.
const INWARDS: f32 = 0.002;
/// The largest number of pieces of a mesh; the rest becomes a hull.
const MOST: usize = 64;
/// Meshes with more triangles become hulls: cutting tests every face against every corner.
const TRIANGLES: usize = 4096;

/// A plane: its points satisfy `normal · point = at`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Its normal, of unit length.
    pub normal: Vector3<f32>,
    /// Its distance from the origin along the normal, metres.
    pub at: f32,
}

impl Plane {
    /// The plane across an axis (0 for X) at a coordinate.
    pub fn across(axis: usize, at: f32) -> Self {
        Self { normal: Vector3::ith(axis, 1.0), at }
    }

    /// The signed distance of a point in front of the plane.
    fn height(&self, point: &Point3<f32>) -> f32 {
        self.normal.dot(&point.coords) - self.at
    }

    /// The plane of a polygon (Newell's sum); `None` if it has no area.
    fn from_polygon(polygon: impl Iterator<Item = Point3<f32>> + Clone) -> Option<Self> {
        let first = polygon.clone().next()?;
        let ends = polygon.clone().zip(polygon.cycle().skip(1));
        let area: Vector3<f32> = ends.map(|(a, b)| (a - first).cross(&(b - first))).sum();
        let normal = area.try_normalize(1e-9)?;
        Some(Self { normal, at: normal.dot(&first.coords) })
    }
}

/// The corners of a surface's polygons, including those that cuts create.
#[derive(Debug, Clone)]
pub struct Surface {
    points: Vec<Point3<f32>>,
    /// The distance of each corner in front of the cutting plane.
    heights: Vec<f32>,
}

/// Polygons, given by the indices of their corners.
#[derive(Debug, Clone, Default)]
pub struct Polygons {
    corners: Vec<u32>,
    /// The end of each polygon among the corners.
    ends: Vec<u32>,
}

impl Polygons {
    /// The polygons, each as the indices of its corners.
    fn iter(&self) -> impl Iterator<Item = &[u32]> {
        let starts = std::iter::once(&0).chain(&self.ends);
        starts.zip(&self.ends).map(|(from, to)| &self.corners[*from as usize..*to as usize])
    }

    fn push(&mut self, polygon: &[u32]) {
        self.corners.extend_from_slice(polygon);
        self.end();
    }

    /// Ends a polygon; discards it if it has too few corners.
    fn end(&mut self) {
        let from = self.ends.last().map_or(0, |end| *end as usize);
        if self.corners.len() - from > 2 {
            self.ends.push(self.corners.len() as u32);
        } else {
            self.corners.truncate(from);
        }
    }
}

impl Surface {
    /// A surface of triangles, and these as polygons; triangles with a corner that does not exist are left out.
    pub fn new(points: Vec<Point3<f32>>, triangles: &[[u32; 3]]) -> (Self, Polygons) {
        let mut all = Polygons::default();
        let sound = |t: &&[u32; 3]| t.iter().all(|v| (*v as usize) < points.len());
        triangles.iter().filter(sound).for_each(|t| all.push(t));
        (Self { points, heights: Vec::new() }, all)
    }

    /// The parts of polygons behind and in front of a plane (Sutherland and Hodgman, 1974).
    ///
    /// ```
    /// use nalgebra::Point3;
    /// use vc_geometry::cut::{Plane, Surface};
    /// // A square of two triangles, cut at X = 0.25.
    /// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    /// let (mut surface, square) = Surface::new(corners.to_vec(), &[[0, 1, 2], [0, 2, 3]]);
    /// let [left, right] = surface.divided(&square, Plane::across(0, 0.25));
    /// assert!(surface.corners(&left).iter().all(|p| p.x <= 0.25));
    /// assert!(surface.corners(&right).iter().all(|p| p.x >= 0.25));
    /// ```
    pub fn divided(&mut self, polygons: &Polygons, plane: Plane) -> [Polygons; 2] {
        let Self { points, heights } = self;
        heights.clear();
        heights.extend(points.iter().map(|p| plane.height(p)));
        let mut sides = [Polygons::default(), Polygons::default()];
        for polygon in polygons.iter() {
            let height = |v: &u32| heights[*v as usize];
            let inside = [polygon.iter().all(|v| height(v) <= 0.0), polygon.iter().all(|v| height(v) >= 0.0)];
            if inside[0] || inside[1] {
                // Corners in the plane are on both sides.
                sides.iter_mut().zip(inside).for_each(|(side, inside)| {
                    if inside {
                        side.push(polygon)
                    }
                });
                continue;
            }
            for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let (from, to) = (heights[*a as usize], heights[*b as usize]);
                sides[0].corners.extend((from <= 0.0).then_some(*a));
                sides[1].corners.extend((from >= 0.0).then_some(*a));
                if from.min(to) < 0.0 && from.max(to) > 0.0 {
                    let (first, second) = (points[*a as usize], points[*b as usize]);
                    let new = points.len() as u32;
                    points.push(first + (second - first) * (from / (from - to)));
                    heights.push(0.0);
                    sides.iter_mut().for_each(|side| side.corners.push(new));
                }
            }
            sides.iter_mut().for_each(Polygons::end);
        }
        sides
    }

    /// The corners of polygons, each once, sorted.
    pub fn corners(&self, polygons: &Polygons) -> Vec<Point3<f32>> {
        let mut used = vec![false; self.points.len()];
        polygons.corners.iter().for_each(|v| used[*v as usize] = true);
        let mut all: Vec<Point3<f32>> =
            self.points.iter().zip(used).filter(|(_, used)| *used).map(|(p, _)| *p).collect();
        all.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
        all.dedup();
        all
    }

    fn at(&self, polygon: &[u32]) -> impl Iterator<Item = Point3<f32>> + Clone {
        polygon.iter().map(|v| self.points[*v as usize])
    }

    /// Convex pieces of a closed surface, cut along its own faces: what `piece` makes of the corners of each. At
    /// most 64; of those that would be more, and of a surface of more than 4096 polygons, the hull is one piece.
    ///
    /// Costs the number of faces times that of corners for each cut.
    pub fn along_faces<P>(
        mut self,
        polygons: Polygons,
        mut piece: impl FnMut(Vec<Point3<f32>>) -> Option<P>,
    ) -> Vec<P> {
        let mut pieces = Vec::new();
        let mut open = vec![polygons];
        while let Some(polygons) = open.pop() {
            let may_cut = pieces.len() + open.len() + 1 < MOST && polygons.ends.len() <= TRIANGLES;
            match may_cut.then(|| self.inwards(&polygons)).flatten() {
                Some(plane) => open.extend(self.divided(&polygons, plane).map(|side| self.out_of(plane, &side))),
                None => pieces.extend(piece(self.corners(&polygons))),
            }
        }
        pieces
    }

    /// The polygons that are not in a plane: faces in the plane belong to neither side, and their corners are
    /// those of their neighbours.
    fn out_of(&self, plane: Plane, side: &Polygons) -> Polygons {
        let mut out = Polygons::default();
        let leaves = |polygon: &&[u32]| self.at(polygon).any(|p| plane.height(&p).abs() > INWARDS);
        side.iter().filter(leaves).for_each(|polygon| out.push(polygon));
        out
    }

    /// The plane of a face with corners both in front of and behind it.
    fn inwards(&self, polygons: &Polygons) -> Option<Plane> {
        let corners = self.corners(polygons);
        let turns = |plane: &Plane| {
            let heights = || corners.iter().map(|p| plane.height(p));
            heights().any(|h| h > INWARDS) && heights().any(|h| h < -INWARDS)
        };
        polygons.iter().filter_map(|p| Plane::from_polygon(self.at(p))).find(turns)
    }
}

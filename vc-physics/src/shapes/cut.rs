//! Cutting of surfaces by planes.
//!
//! A piece of a body is convex, so other shapes are cut: a thing that holds others along the sides of the space
//! above its surfaces, a part of the building along its own concave faces, so that a wall's mesh keeps its
//! doorway.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Part;

use super::piece::Piece;

/// The largest distance of a corner in front of a face of the same convex piece, metres.
const INWARDS: f32 = 0.002;
/// The largest number of pieces of a mesh; the rest becomes a hull.
const MOST: usize = 64;
/// Meshes with more triangles become hulls: cutting tests every face against every corner.
const TRIANGLES: usize = 4096;

/// A plane: its points satisfy `normal · point = at`.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    pub(super) normal: Vector3<f32>,
    pub(super) at: f32,
}

impl Plane {
    pub(super) fn across(axis: usize, at: f32) -> Self {
        Self { normal: Vector3::ith(axis, 1.0), at }
    }

    /// The signed distance of a point in front of the plane.
    fn height(&self, point: &Point3<f32>) -> f32 {
        self.normal.dot(&point.coords) - self.at
    }

    /// The plane of a polygon (Newell's sum); `None` if it has no area.
    fn of(polygon: impl Iterator<Item = Point3<f32>> + Clone) -> Option<Self> {
        let first = polygon.clone().next()?;
        let ends = polygon.clone().zip(polygon.cycle().skip(1));
        let area: Vector3<f32> = ends.map(|(a, b)| (a - first).cross(&(b - first))).sum();
        let normal = area.try_normalize(1e-9)?;
        Some(Self { normal, at: normal.dot(&first.coords) })
    }
}

/// The corners of polygons, including those that cuts create.
pub(super) struct Corners {
    points: Vec<Point3<f32>>,
    /// The distance of each corner in front of the cutting plane.
    heights: Vec<f32>,
}

/// Polygons, given by the indices of their corners.
#[derive(Default)]
pub(super) struct Polygons {
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

impl Corners {
    /// A part's triangles in the frame of the scaled asset.
    pub(super) fn of(
        part: &Part,
        vertices: &[Point3<f32>],
        triangles: &[[u32; 3]],
        by: &Vector3<f32>,
    ) -> (Self, Polygons) {
        let points = vertices.iter().map(|v| Point3::from((part.pose * v).coords.component_mul(by))).collect();
        let mut all = Polygons::default();
        let sound = |t: &&[u32; 3]| t.iter().all(|v| (*v as usize) < vertices.len());
        triangles.iter().filter(sound).for_each(|t| all.push(t));
        (Self { points, heights: Vec::new() }, all)
    }

    /// The parts of polygons behind and in front of a plane (Sutherland and Hodgman, 1974).
    pub(super) fn divided(&mut self, polygons: &Polygons, plane: Plane) -> [Polygons; 2] {
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

    /// The corners of polygons, each once.
    pub(super) fn of_all(&self, polygons: &Polygons) -> Vec<Point3<f32>> {
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

    /// Convex pieces of a closed surface, cut along its own faces.
    pub(super) fn along_faces(mut self, polygons: Polygons) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut open = vec![polygons];
        while let Some(polygons) = open.pop() {
            let may_cut = pieces.len() + open.len() + 1 < MOST && polygons.ends.len() <= TRIANGLES;
            match may_cut.then(|| self.inwards(&polygons)).flatten() {
                Some(plane) => open.extend(self.divided(&polygons, plane).map(|side| self.out_of(plane, &side))),
                None => pieces.extend(Piece::hull(&self.of_all(&polygons), &Vector3::z())),
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
        let corners = self.of_all(polygons);
        let turns = |plane: &Plane| {
            let heights = || corners.iter().map(|p| plane.height(p));
            heights().any(|h| h > INWARDS) && heights().any(|h| h < -INWARDS)
        };
        polygons.iter().filter_map(|p| Plane::of(self.at(p))).find(turns)
    }
}

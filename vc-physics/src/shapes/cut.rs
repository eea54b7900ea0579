//! Surfaces cut by planes.
//!
//! A piece of a body is convex. What is not, is cut: where a thing holds others along the sides
//! of the space above its surfaces, of the building along the very faces that turn inwards, so
//! that a wall's mesh keeps its doorway.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Part;

use super::piece::Piece;

pub(super) type Polygon = Vec<Point3<f32>>;

/// How far a corner may be in front of a face of the same convex piece, metres.
const INWARDS: f32 = 0.002;
/// Into how many pieces a mesh is cut at most; what is left then is a hull.
const MOST: usize = 64;
/// Meshes of more triangles are hulls: cutting asks every face about every corner.
const TRIANGLES: usize = 4096;

/// A plane: its points have `normal` times themselves equal to `at`.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    pub(super) normal: Vector3<f32>,
    pub(super) at: f32,
}

impl Plane {
    pub(super) fn across(axis: usize, at: f32) -> Self {
        Self { normal: Vector3::ith(axis, 1.0), at }
    }

    /// How far a point is in front.
    fn height(&self, point: &Point3<f32>) -> f32 {
        self.normal.dot(&point.coords) - self.at
    }

    /// Of a polygon (Newell's sum); nothing if that has no area.
    fn of(polygon: &Polygon) -> Option<Self> {
        let ends = polygon.iter().zip(polygon.iter().cycle().skip(1));
        let area: Vector3<f32> = ends.map(|(a, b)| (a - polygon[0]).cross(&(b - polygon[0]))).sum();
        let normal = area.try_normalize(1e-9)?;
        Some(Self { normal, at: normal.dot(&polygon[0].coords) })
    }
}

/// A part's triangles in the frame of the scaled asset.
pub(super) fn polygons(
    part: &Part,
    vertices: &[Point3<f32>],
    triangles: &[[u32; 3]],
    by: &Vector3<f32>,
) -> Vec<Polygon> {
    let at = |v: &u32| Some(Point3::from((part.pose * vertices.get(*v as usize)?).coords.component_mul(by)));
    triangles.iter().filter_map(|t| t.iter().map(at).collect()).collect()
}

/// What polygons have on one side of a plane: in front, or behind (Sutherland and Hodgman, 1974).
pub(super) fn clipped(polygons: &[Polygon], plane: Plane, front: bool) -> Vec<Polygon> {
    polygons.iter().filter_map(|p| clip(p, plane, front)).collect()
}

fn clip(polygon: &Polygon, plane: Plane, front: bool) -> Option<Polygon> {
    let is_inside = |height: f32| if front { height >= 0.0 } else { height <= 0.0 };
    // Most polygons are all on one side.
    let inside = polygon.iter().filter(|p| is_inside(plane.height(p))).count();
    if inside == 0 || inside == polygon.len() {
        return (inside > 2).then(|| polygon.clone());
    }
    let mut clipped = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (plane.height(a), plane.height(b));
        clipped.extend(is_inside(from).then_some(*a));
        clipped.extend((is_inside(from) != is_inside(to)).then(|| a + (b - a) * (from / (from - to))));
    }
    (clipped.len() > 2).then_some(clipped)
}

/// The corners of polygons, each once.
pub(super) fn corners(polygons: &[Polygon]) -> Vec<Point3<f32>> {
    let mut all = polygons.concat();
    all.sort_unstable_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    all.dedup();
    all
}

/// Convex pieces of a closed surface, cut along its own faces.
pub(super) fn along_faces(polygons: Vec<Polygon>) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut open = vec![polygons];
    while let Some(polygons) = open.pop() {
        let may_cut = pieces.len() + open.len() + 1 < MOST && polygons.len() <= TRIANGLES;
        match may_cut.then(|| inwards(&polygons)).flatten() {
            Some(plane) => open.extend([false, true].map(|front| side(&polygons, plane, front))),
            None => pieces.extend(Piece::hull(&corners(&polygons), &Vector3::z())),
        }
    }
    pieces
}

/// What a closed surface has on one side of a plane; faces in it belong to neither side, their
/// corners are those of their neighbours.
fn side(polygons: &[Polygon], plane: Plane, front: bool) -> Vec<Polygon> {
    let mut side = clipped(polygons, plane, front);
    side.retain(|polygon| polygon.iter().any(|p| plane.height(p).abs() > INWARDS));
    side
}

/// The plane of a face that has corners in front of it and others behind.
fn inwards(polygons: &[Polygon]) -> Option<Plane> {
    let turns = |plane: &Plane| {
        let heights = || polygons.iter().flatten().map(|p| plane.height(p));
        heights().any(|h| h > INWARDS) && heights().any(|h| h < -INWARDS)
    };
    polygons.iter().filter_map(Plane::of).find(turns)
}

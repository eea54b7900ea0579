//! Triangle meshes of shapes: closed surfaces with normals.
//!
//! ```
//! use vc_graph::asset::Shape;
//!
//! let cup = Shape::Lathe { profile: vec![(0.04, 0.0), (0.04, 0.1), (0.036, 0.1), (0.036, 0.004)] };
//! let mesh = cup.mesh(0.0005);
//! assert!(mesh.is_closed());
//! assert!(mesh.volume() < 0.00012); // it is hollow
//! ```
//!
//! The same shape and tolerance give the same bytes on every machine: angles are computed by a series of this
//! crate, and the decisions in convex hulls and in triangulations of outlines are exact.

mod circle;
mod crease;
mod extrude;
mod hull;
mod lathe;
mod polygon;
mod solid;
mod weld;

use nalgebra::{Point3, Vector3};

use crate::asset::Shape;
use crate::{Aabb, Pose};
use weld::Welded;

/// Cosine of 40 degrees: faces that meet at a larger angle have a sharp edge between them; others are shaded
/// smoothly.
const CREASE: f64 = 0.766_044_443;

/// A surface of triangles, metres. Vertices are split at sharp edges.
///
/// ```
/// use vc_graph::asset::Shape;
/// let cube = Shape::Box { half: [0.5, 0.5, 0.5].into() }.mesh(0.01);
/// assert_eq!(cube.triangles.len(), 12);
/// assert!((cube.volume() - 1.0).abs() < 1e-5 && (cube.area() - 6.0).abs() < 1e-5);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TriangleMesh {
    /// Position of each vertex, metres.
    pub positions: Vec<Point3<f32>>,
    /// Outward unit normal of each vertex; as many as positions.
    pub normals: Vec<Vector3<f32>>,
    /// Three vertices per triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Texture coordinates of the corners of each triangle; empty if there are none.
    pub uvs: Vec<[[f32; 2]; 3]>,
}

impl Shape {
    /// The surface of the shape in its own frame.
    ///
    /// `tolerance` is the largest distance between a curve and its chords, metres: a circle gets 8 to 64
    /// corners, a multiple of four, so that the mesh is as wide as the shape's [`extent`](Shape::extent). The
    /// mesh is closed, except for a [`Shape::Mesh`], which is used as it is. A shape without volume (coplanar
    /// points, a profile that is a line) and one with a measure that is not finite or not positive has no
    /// triangles.
    ///
    /// Costs time proportional to the number of triangles; a hull of `n` points mostly takes `n log n`, an
    /// outline of `n` points `n` squared.
    ///
    /// ```
    /// use vc_graph::asset::Shape;
    /// let ball = Shape::Sphere { radius: 0.1 }.mesh(0.001);
    /// let exact = 4.0 / 3.0 * std::f32::consts::PI * 0.001;
    /// assert!(ball.is_closed() && (ball.volume() / exact - 1.0).abs() < 0.05);
    /// ```
    pub fn mesh(&self, tolerance: f32) -> TriangleMesh {
        if !self.measures_are_positive() {
            return TriangleMesh::default();
        }
        let mesh = match self {
            Self::Box { half } => solid::cuboid(*half),
            Self::RoundedBox { half, radius } => solid::rounded(*half, *radius, tolerance),
            Self::Cylinder { radius, half_height } => {
                lathe::turned(&[(*radius, -half_height), (*radius, *half_height)], tolerance)
            }
            Self::Cone { radius, half_height } => {
                lathe::turned(&[(*radius, -half_height), (0.0, *half_height)], tolerance)
            }
            Self::Capsule { radius, half_height } => lathe::capsule(*radius, *half_height, tolerance),
            Self::Sphere { radius } => lathe::capsule(*radius, 0.0, tolerance),
            Self::Hull { points } => solid::faceted(points, &hull::triangles(points)),
            Self::Lathe { profile } => lathe::turned(profile, tolerance),
            Self::Extrusion { outline, height } => extrude::drawn_up(outline, *height),
            Self::Mesh { vertices, triangles, uvs } => crease::with_normals(vertices, triangles, uvs),
        };
        mesh.cleaned()
    }
}

impl TriangleMesh {
    /// Whether the mesh encloses a volume without a gap: if vertices at the same position are merged, every
    /// triangle edge has exactly one opposite. An empty mesh is not closed.
    pub fn is_closed(&self) -> bool {
        let edges = Welded::new(&self.positions).edges(&self.triangles);
        !edges.is_empty() && edges.iter().all(|(&(a, b), &count)| count == 1 && edges.get(&(b, a)) == Some(&1))
    }

    /// Enclosed volume, cubic metres; meaningful only if the mesh is closed. Negative if the triangles are
    /// oriented inwards.
    pub fn volume(&self) -> f32 {
        let Some(origin) = self.positions.first().map(|p| p.cast::<f64>()) else { return 0.0 };
        let six = |[a, b, c]: [Point3<f64>; 3]| (a - origin).dot(&(b - origin).cross(&(c - origin)));
        (self.corners().map(six).sum::<f64>() / 6.0) as f32
    }

    /// Area of the surface, square metres.
    pub fn area(&self) -> f32 {
        (self.corners().map(|[a, b, c]| (b - a).cross(&(c - a)).norm()).sum::<f64>() / 2.0) as f32
    }

    /// The bounding box of its vertices, metres; `None` if it has no vertices.
    pub fn bounds(&self) -> Option<Aabb> {
        let start = *self.positions.first()?;
        let grow = |b: Aabb, p: &Point3<f32>| Aabb { min: b.min.inf(p), max: b.max.sup(p) };
        Some(self.positions.iter().fold(Aabb { min: start, max: start }, grow))
    }

    /// Whether it has no triangles.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The mesh transformed by a pose.
    #[must_use]
    pub fn transformed(&self, pose: &Pose) -> Self {
        Self {
            positions: self.positions.iter().map(|p| pose * p).collect(),
            normals: self.normals.iter().map(|n| pose * n).collect(),
            triangles: self.triangles.clone(),
            uvs: self.uvs.clone(),
        }
    }

    /// Adds the triangles of another mesh. If only one of them has texture coordinates,
    /// those of the other's corners are all zero.
    pub fn append(&mut self, other: &Self) {
        if !self.uvs.is_empty() || !other.uvs.is_empty() {
            self.uvs.resize(self.triangles.len(), Default::default());
            self.uvs.extend_from_slice(&other.uvs);
            self.uvs.resize(self.triangles.len() + other.triangles.len(), Default::default());
        }
        let first = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        self.normals.extend_from_slice(&other.normals);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
    }

    /// The corners of every triangle; triangles with missing vertices are skipped.
    fn corners(&self) -> impl Iterator<Item = [Point3<f64>; 3]> {
        let corner = |v: u32| self.positions.get(v as usize).map(|p| p.cast::<f64>());
        self.triangles.iter().filter_map(move |&[a, b, c]| Some([corner(a)?, corner(b)?, corner(c)?]))
    }

    fn push(&mut self, position: Point3<f32>, normal: Vector3<f64>) -> u32 {
        let normal = normal.try_normalize(0.0).unwrap_or_else(Vector3::z);
        self.positions.push(position);
        self.normals.push(normal.cast());
        self.positions.len() as u32 - 1
    }

    /// Removes triangles with two corners at the same position; the result is empty if a coordinate overflowed.
    fn cleaned(mut self) -> Self {
        if self.positions.iter().any(|p| p.iter().any(|v| !v.is_finite())) {
            return Self::default();
        }
        let at = |v: u32| self.positions[v as usize];
        let sound = |&[a, b, c]: &[u32; 3]| at(a) != at(b) && at(b) != at(c) && at(c) != at(a);
        if !self.uvs.is_empty() {
            let mut kept = self.triangles.iter().map(sound);
            self.uvs.retain(|_| kept.next().unwrap_or(false));
        }
        self.triangles.retain(sound);
        self
    }
}

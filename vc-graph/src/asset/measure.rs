//! Measures of shapes: whether they make sense, and the boxes around them.

use nalgebra::{Point3, UnitQuaternion, Vector3};

use super::Shape;

impl Shape {
    /// Whether every measure is finite and positive where it must be;
    /// [`AssetLibrary::add`](super::AssetLibrary::add) requires it of a part's shape.
    pub fn measures_are_positive(&self) -> bool {
        let positive = |v: f32| v.is_finite() && v > 0.0;
        // Checks all of them, without a branch for each.
        let finite = |points: &[Point3<f32>]| {
            points.iter().fold(true, |all, p| all & p.x.is_finite() & p.y.is_finite() & p.z.is_finite())
        };
        match self {
            Self::Box { half } => half.iter().copied().all(positive),
            Self::RoundedBox { half, radius } => half.iter().all(|&h| positive(h) && h >= *radius) && positive(*radius),
            Self::Cylinder { radius, half_height } | Self::Cone { radius, half_height } => {
                positive(*radius) && positive(*half_height)
            }
            Self::Capsule { radius, half_height } => {
                positive(*radius) && (positive(*half_height) || *half_height == 0.0)
            }
            Self::Sphere { radius } => positive(*radius),
            Self::Hull { points } => points.len() >= 4 && finite(points),
            Self::Lathe { profile } => {
                profile.len() >= 2 && profile.iter().all(|(r, z)| r.is_finite() && *r >= 0.0 && z.is_finite())
            }
            Self::Extrusion { outline, height } => {
                let plane = outline.iter().all(|(x, y)| x.is_finite() && y.is_finite());
                outline.len() >= 3 && plane && positive(*height)
            }
            Self::Mesh { vertices, .. } => finite(vertices),
        }
    }

    pub(super) fn triangles_exist(&self) -> bool {
        match self {
            Self::Mesh { vertices, triangles, .. } => {
                triangles.iter().flatten().all(|&v| (v as usize) < vertices.len())
            }
            _ => true,
        }
    }

    pub(super) fn coordinates_are_sound(&self) -> bool {
        match self {
            Self::Mesh { triangles, uvs, .. } => {
                let finite = uvs.iter().flatten().flatten().all(|v| v.is_finite());
                finite && (uvs.is_empty() || uvs.len() == triangles.len())
            }
            _ => true,
        }
    }

    /// Smallest and largest corner of the bounding box in the shape's own frame, metres.
    pub fn extent(&self) -> (Point3<f32>, Point3<f32>) {
        let around = |half: Vector3<f32>| (Point3::from(-half), Point3::from(half));
        let round = |radius: f32, half: f32| around(Vector3::new(radius, radius, half));
        match self {
            Self::Box { half } | Self::RoundedBox { half, .. } => around(*half),
            Self::Cylinder { radius, half_height } | Self::Cone { radius, half_height } => round(*radius, *half_height),
            Self::Capsule { radius, half_height } => round(*radius, half_height + radius),
            Self::Sphere { radius } => round(*radius, *radius),
            Self::Hull { points } => corners(points.iter().copied()),
            Self::Lathe { profile } => {
                corners(profile.iter().flat_map(|&(r, z)| [Point3::new(-r, -r, z), Point3::new(r, r, z)]))
            }
            Self::Extrusion { outline, height } => {
                corners(outline.iter().flat_map(|&(x, y)| [Point3::new(x, y, 0.0), Point3::new(x, y, *height)]))
            }
            Self::Mesh { vertices, .. } => corners(vertices.iter().copied()),
        }
    }
}

impl Shape {
    /// Smallest and largest corner of the bounding box of the shape rotated about its origin, metres.
    pub(super) fn extent_turned(&self, turn: &UnitQuaternion<f32>) -> (Point3<f32>, Point3<f32>) {
        let matrix = turn.to_rotation_matrix().into_inner();
        let axis = matrix.column(2).into_owned();
        // The extent of a flat ring around the axis along each world axis, per unit of its radius.
        let flat = axis.map(|a| (1.0 - a * a).max(0.0).sqrt());
        let around = |half: Vector3<f32>| (Point3::from(-half), Point3::from(half));
        let ring = |&(radius, z): &(f32, f32)| [axis * z - flat * radius, axis * z + flat * radius].map(Point3::from);
        match self {
            Self::Box { half } => around(matrix.abs() * half),
            Self::RoundedBox { half, radius } => around((matrix.abs() * half.add_scalar(-radius)).add_scalar(*radius)),
            Self::Cylinder { radius, half_height } => around(flat * *radius + axis.abs() * *half_height),
            Self::Cone { radius, half_height } => {
                corners([(*radius, -half_height), (0.0, *half_height)].iter().flat_map(ring))
            }
            Self::Capsule { radius, half_height } => around((axis.abs() * *half_height).add_scalar(*radius)),
            Self::Sphere { .. } => self.extent(),
            Self::Lathe { profile } => corners(profile.iter().flat_map(ring)),
            Self::Extrusion { outline, height } => {
                let both = |&(x, y): &(f32, f32)| [Point3::new(x, y, 0.0), Point3::new(x, y, *height)];
                corners(outline.iter().flat_map(both).map(|p| matrix * p))
            }
            Self::Hull { points } | Self::Mesh { vertices: points, .. } => corners(points.iter().map(|p| matrix * p)),
        }
    }
}

pub(super) fn corners(points: impl Iterator<Item = Point3<f32>>) -> (Point3<f32>, Point3<f32>) {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in points {
        // Plain comparisons take one operation each, whereas `min` also handles NaN.
        for k in 0..3 {
            low[k] = if p[k] < low[k] { p[k] } else { low[k] };
            high[k] = if p[k] > high[k] { p[k] } else { high[k] };
        }
    }
    (low.into(), high.into())
}

//! Scaling of assets.

use nalgebra::{Point3, Vector3};
use rapier3d::geometry::TypedShape;
use vc_graph::Pose;
use vc_graph::asset::{Joint, JointKind, Shape, Surface};

use super::piece::{Piece, cuboid};
use crate::convert;

/// The smallest cosine of the tilt of an upright box.
const UPRIGHT: f32 = 0.999_999;

/// The factor of a uniform scale; `None` if the scale is not uniform.
pub(crate) fn uniform(scale: &Vector3<f32>) -> Option<f32> {
    (scale.x == scale.y && scale.y == scale.z && scale.x > 0.0).then_some(scale.x)
}

/// A shape with all its measures multiplied by a factor.
pub(crate) fn shape(shape: &Shape, by: f32) -> Shape {
    let pairs = |list: &[(f32, f32)]| list.iter().map(|&(a, b)| (a * by, b * by)).collect();
    let points = |list: &[Point3<f32>]| list.iter().map(|p| p * by).collect();
    match shape {
        Shape::Box { half } => Shape::Box { half: half * by },
        Shape::RoundedBox { half, radius } => Shape::RoundedBox { half: half * by, radius: radius * by },
        Shape::Cylinder { radius, half_height } => {
            Shape::Cylinder { radius: radius * by, half_height: half_height * by }
        }
        Shape::Cone { radius, half_height } => Shape::Cone { radius: radius * by, half_height: half_height * by },
        Shape::Capsule { radius, half_height } => Shape::Capsule { radius: radius * by, half_height: half_height * by },
        Shape::Sphere { radius } => Shape::Sphere { radius: radius * by },
        Shape::Hull { points: list } => Shape::Hull { points: points(list) },
        Shape::Lathe { profile } => Shape::Lathe { profile: pairs(profile) },
        Shape::Extrusion { outline, height } => Shape::Extrusion { outline: pairs(outline), height: height * by },
        Shape::Mesh { vertices, triangles, .. } => {
            Shape::Mesh { vertices: points(vertices), triangles: triangles.clone(), uvs: Vec::new() }
        }
        other => other.clone(),
    }
}

/// A pose with its translation scaled.
pub(crate) fn pose(pose: &Pose, by: &Vector3<f32>) -> Pose {
    Pose::from_parts(pose.translation.vector.component_mul(by).into(), pose.rotation)
}

/// A joint of a scaled asset. A scale that differs between the axes changes the joint's axis, which is
/// normalised afterwards.
pub(crate) fn joint(joint: &Joint, by: &Vector3<f32>) -> Joint {
    let stretched = joint.axis.component_mul(by);
    let length = stretched.norm();
    let axis = stretched.try_normalize(1e-9).unwrap_or(joint.axis);
    let limits = match joint.kind {
        JointKind::Slide => (joint.limits.0 * length, joint.limits.1 * length),
        JointKind::Hinge => joint.limits,
    };
    Joint { anchor: joint.anchor.coords.component_mul(by).into(), axis, limits, ..*joint }
}

/// A surface of a scaled asset.
pub(crate) fn surface(surface: &Surface, by: &Vector3<f32>) -> Surface {
    Surface {
        centre: surface.centre.coords.component_mul(by).into(),
        half: (surface.half.0 * by.x.abs(), surface.half.1 * by.y.abs()),
        clearance: surface.clearance.map(|c| c * by.z.abs()),
        joint: surface.joint.as_ref().map(|j| joint(j, by)),
        ..surface.clone()
    }
}

/// A piece scaled along the asset's axes: the hull of its scaled corners.
pub(crate) fn stretched(piece: &Piece, by: &Vector3<f32>) -> Option<Piece> {
    let points: Vec<Point3<f32>> = corners(piece).iter().map(|p| p.coords.component_mul(by).into()).collect();
    Piece::hull(&points, &Vector3::z())
}

/// A piece extended downwards in the asset's frame; `None` if there is no such hull.
pub(crate) fn deepened(piece: &Piece, by: f32) -> Option<Piece> {
    let up = piece.at.rotation.inverse_transform_vector(&Vector3::z());
    if let TypedShape::Cuboid(s) = piece.shape.as_typed_shape()
        && up.z.abs() > UPRIGHT
    {
        let half = convert::vector3(s.half_extents) + Vector3::z() * (by / 2.0);
        return Some(Piece { shape: cuboid(half), at: Pose::translation(0.0, 0.0, -by / 2.0) * piece.at });
    }
    let mut points = corners(piece);
    let lower: Vec<Point3<f32>> = points.iter().map(|p| p - Vector3::z() * by).collect();
    points.extend(lower);
    Piece::hull(&points, &Vector3::z())
}

/// The corners of a piece in the asset's frame; for round pieces, those of an inscribed polyhedron.
pub(crate) fn corners(piece: &Piece) -> Vec<Point3<f32>> {
    match piece.shape.as_typed_shape() {
        TypedShape::ConvexPolyhedron(s) => s.points().iter().map(|p| piece.at * convert::point3(*p)).collect(),
        TypedShape::Cuboid(s) => {
            let half = convert::vector3(s.half_extents);
            let corner = |i: usize| Vector3::from_fn(|k, _| if i >> k & 1 == 0 { -half[k] } else { half[k] });
            (0..8).map(|i| piece.at * Point3::from(corner(i))).collect()
        }
        _ => mesh(piece).0,
    }
}

/// The piece as triangles in the asset's frame.
pub(crate) fn mesh(piece: &Piece) -> (Vec<Point3<f32>>, Vec<[u32; 3]>) {
    let (vertices, triangles) = match piece.shape.as_typed_shape() {
        TypedShape::Cuboid(s) => s.to_trimesh(),
        TypedShape::Ball(s) => s.to_trimesh(12, 8),
        TypedShape::Cylinder(s) => s.to_trimesh(16),
        TypedShape::Cone(s) => s.to_trimesh(16),
        TypedShape::Capsule(s) => s.to_trimesh(12, 6),
        TypedShape::ConvexPolyhedron(s) => s.to_trimesh(),
        _ => (Vec::new(), Vec::new()),
    };
    (vertices.into_iter().map(|v| piece.at * convert::point3(v)).collect(), triangles)
}

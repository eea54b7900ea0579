//! A part of an asset in the frame of the scaled asset: as convex pieces, and as triangles.

use nalgebra::{Point3, Vector3};
use vc_geometry::cut::{self, Polygons};
use vc_graph::Pose;
use vc_graph::asset::Part;

use super::piece::{self, Piece};
use super::scale;

/// A part's triangles in the frame of the scaled asset.
pub(super) fn surface(
    part: &Part,
    vertices: &[Point3<f32>],
    triangles: &[[u32; 3]],
    by: &Vector3<f32>,
) -> (cut::Surface, Polygons) {
    let placed = vertices.iter().map(|v| Point3::from((part.pose * v).coords.component_mul(by)));
    cut::Surface::new(placed.collect(), triangles)
}

/// The pieces of a part in the frame of the scaled asset.
pub(super) fn placed(part: &Part, by: &Vector3<f32>) -> Vec<Piece> {
    let at = |pose: Pose| move |p: Piece| Piece { at: pose * p.at, ..p };
    let up = part.pose.rotation.inverse_transform_vector(&Vector3::z());
    match scale::uniform(by) {
        Some(1.0) => piece::pieces(&part.shape, &up).into_iter().map(at(part.pose)).collect(),
        Some(s) => {
            let own = piece::pieces(&scale::shape(&part.shape, s), &up);
            own.into_iter().map(at(scale::pose(&part.pose, by))).collect()
        }
        None => {
            let own = piece::pieces(&part.shape, &up).into_iter().map(at(part.pose));
            own.filter_map(|p| scale::stretched(&p, by)).collect()
        }
    }
}

//! Hollow collision shapes for things that hold others.
//!
//! The collision shape of a mesh is its convex hull. If the hull would fill the space above a surface, such as
//! that of a bathtub or a seat, the mesh is cut along the sides of this space, and the remainder on each side
//! gets a hull of its own.

use nalgebra::{Point3, Vector3};
use rapier3d::geometry::SharedShape;
use vc_geometry::cut::{self, Plane, Polygons};
use vc_graph::Aabb;
use vc_graph::asset::{Hold, Part, Shape, Surface};

use super::part;
use super::piece::Piece;
use crate::convert;

/// Height of the space above a surface without a stated clearance, metres.
const CLEARANCE: f32 = 0.3;

/// The space above a surface; `None` for hooks and for spaces lower than a centimetre.
pub(super) fn space(surface: &Surface) -> Option<Aabb> {
    let height = surface.clearance.unwrap_or(CLEARANCE);
    let half = Vector3::new(surface.half.0, surface.half.1, 0.0);
    let high = surface.centre + half + Vector3::z() * height;
    (surface.hold != Hold::Hook && height >= 0.01).then_some(Aabb { min: surface.centre - half, max: high })
}

/// The pieces of a part in the frame of the scaled asset, leaving the space above the asset's surfaces free.
pub(super) fn pieces(part: &Part, by: &Vector3<f32>, surfaces: &[Surface]) -> Vec<Piece> {
    let whole = part::placed(part, by);
    let (Shape::Mesh { vertices, triangles, .. }, [hull]) = (&part.shape, &whole[..]) else { return whole };
    let spaces: Vec<Aabb> = surfaces.iter().filter_map(space).collect();
    if !spaces.iter().any(|s| fills(hull, s)) {
        return whole;
    }
    let mut cut = Vec::new();
    let (mut whole, polygons) = part::surface(part, vertices, triangles, by);
    split(&mut whole, polygons, hull.clone(), &spaces, &mut cut);
    cut
}

/// Whether a piece takes up some of the middle of a space.
fn fills(piece: &Piece, Aabb { min: low, max: high }: &Aabb) -> bool {
    let size = high - low;
    let at = |x: f32, y: f32| low + size.component_mul(&Vector3::new(x, y, 0.25));
    let middle = [(0.5, 0.5), (0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)];
    middle.iter().any(|&(x, y)| contains(&piece.shape, piece.at.inverse_transform_point(&at(x, y))))
}

fn contains(shape: &SharedShape, point: Point3<f32>) -> bool {
    shape.contains_local_point(convert::point(point))
}

/// Adds the hull of polygons; if it fills a space, the hulls of the parts below the space, on its four sides
/// and above it.
fn split(whole: &mut cut::Surface, polygons: Polygons, hull: Piece, spaces: &[Aabb], out: &mut Vec<Piece>) {
    let Some(index) = spaces.iter().position(|s| fills(&hull, s)) else {
        out.push(hull);
        return;
    };
    let (Aabb { min: low, max: high }, others) = (spaces[index], &spaces[index + 1..]);
    let mut rest = polygons;
    for (axis, at, beyond) in [
        (2, low.z, false),
        (0, low.x, false),
        (0, high.x, true),
        (1, low.y, false),
        (1, high.y, true),
        (2, high.z, true),
    ] {
        let [behind, front] = whole.divided(&rest, Plane::across(axis, at));
        let (side, left) = if beyond { (front, behind) } else { (behind, front) };
        if let Some(hull) = Piece::hull(&whole.corners(&side), &Vector3::z()) {
            split(whole, side, hull, others, out);
        }
        rest = left;
    }
}

//! Mass, centre and inertia, from the parts as they are modelled.

use rapier3d::dynamics::MassProperties;
use rapier3d::math::Vector;
use vc_graph::Pose;
use vc_graph::asset::Shape;

use super::piece::{Piece, pieces};
use crate::convert;

/// Chords of curves this far from them are good enough for a mass, metres.
const CHORD: f32 = 0.002;

/// Several bodies as one; nothing of none.
///
/// The engine takes a body for a ball whose inertia is below 1e-5, whatever the unit, and
/// that of a pen is in kilograms: they are added up in a unit that suits them.
pub(crate) fn total(list: &[MassProperties]) -> MassProperties {
    let largest = list.iter().map(|p| p.principal_inertia().max_element()).fold(0.0, f32::max);
    let unit = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    let sum = list.iter().map(|p| scaled(*p, p.mass() * unit)).reduce(|a, b| a + b).unwrap_or_default();
    scaled(sum, sum.mass() / unit)
}

/// Mass properties of a solid shape of a density, kilograms per cubic metre.
pub(crate) fn properties(shape: &Shape, density: f32) -> MassProperties {
    let exact = matches!(
        shape,
        Shape::Box { .. }
            | Shape::RoundedBox { .. }
            | Shape::Cylinder { .. }
            | Shape::Cone { .. }
            | Shape::Capsule { .. }
            | Shape::Sphere { .. }
    );
    let own = if exact { of_pieces(shape, density) } else { of_mesh(shape, density) };
    if is_sound(&own) { own } else { of_pieces(shape, density) }
}

fn of_pieces(shape: &Shape, density: f32) -> MassProperties {
    of_solids(&pieces(shape), density)
}

/// Mass properties of pieces of the same density.
pub(crate) fn of_solids(pieces: &[Piece], density: f32) -> MassProperties {
    let each: Vec<_> = pieces.iter().map(|p| moved(p.shape.mass_properties(density), &p.at)).collect();
    total(&each)
}

fn of_mesh(shape: &Shape, density: f32) -> MassProperties {
    let mesh = shape.mesh(CHORD);
    let vertices: Vec<Vector> = mesh.positions.iter().map(|p| convert::point(*p)).collect();
    // So dense that its inertia is far from too small; see `total`.
    let (low, high) = shape.extent();
    let unit = 1e4 * (high - low).norm().powi(-5);
    let own = MassProperties::from_trimesh(unit, &vertices, &mesh.triangles);
    scaled(own, own.mass() / unit * density)
}

/// Whether mass, centre and inertia are finite, and there is some mass.
pub(crate) fn is_sound(properties: &MassProperties) -> bool {
    let inertia = properties.principal_inertia();
    let positive = |v: f32| v.is_finite() && v > 0.0;
    positive(properties.mass())
        && properties.local_com.is_finite()
        && [inertia.x, inertia.y, inertia.z].into_iter().all(positive)
}

/// Moved to where the part is.
pub(crate) fn moved(properties: MassProperties, at: &Pose) -> MassProperties {
    properties.transform_by(&convert::pose(at))
}

/// The same distribution with another mass.
pub(crate) fn scaled(mut properties: MassProperties, mass: f32) -> MassProperties {
    properties.set_mass(mass, true);
    properties
}

//! Mass, centre and inertia, from the parts as they are modelled.

use rapier3d::dynamics::MassProperties;
use rapier3d::math::Vector;
use vc_graph::Pose;
use vc_graph::asset::Shape;

use super::piece::pieces;
use crate::convert;

/// Chords of curves this far from them are good enough for a mass, metres.
const CHORD: f32 = 0.002;

/// Grams in a kilogram. Masses are added up in grams: the engine takes a body for a ball
/// that has less than 1e-5 of whatever unit of inertia it is given, and a pen has less
/// than that in kilograms.
pub(crate) const GRAMS: f32 = 1e3;

/// The same in kilograms.
pub(crate) fn in_kilograms(properties: MassProperties) -> MassProperties {
    scaled(properties, properties.mass() / GRAMS)
}

/// Mass properties of a solid shape of a density; the unit of mass is the density's.
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
    let each = pieces(shape).into_iter().map(|p| p.shape.mass_properties(density).transform_by(&convert::pose(&p.at)));
    each.reduce(|a, b| a + b).unwrap_or_default()
}

fn of_mesh(shape: &Shape, density: f32) -> MassProperties {
    let mesh = shape.mesh(CHORD);
    let vertices: Vec<Vector> = mesh.positions.iter().map(|p| convert::point(*p)).collect();
    MassProperties::from_trimesh(density, &vertices, &mesh.triangles)
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

//! Translating and joining assets.

use nalgebra::{Point3, Translation3, Vector3};
use vc_graph::Asset;
use vc_graph::asset::{Joint, Part, Shape};
use vc_shapes::material::MaterialId;

/// The asset translated against its origin, metres.
pub(super) fn moved(mut asset: Asset, by: Vector3<f32>) -> Asset {
    if by == Vector3::zeros() {
        return asset;
    }
    let shift = Translation3::from(by);
    asset.parts.iter_mut().chain(&mut asset.collision).for_each(|part| {
        part.pose = shift * part.pose;
        anchored(&mut part.joint, by);
    });
    asset.surfaces.iter_mut().for_each(|surface| {
        surface.centre += by;
        anchored(&mut surface.joint, by);
    });
    asset
}

/// Moves a joint's anchor. Prismatic joints are moved as well: their anchors distinguish the drawers of
/// one unit from those of the next.
fn anchored(joint: &mut Option<Joint>, by: Vector3<f32>) {
    if let Some(joint) = joint {
        joint.anchor += by;
    }
}

/// Joins several assets: parts and surfaces keep their order, and their names get the unit's number.
pub(super) fn joined(name: &str, units: Vec<Asset>) -> Asset {
    let mut whole = Asset { name: name.into(), ..Asset::default() };
    let felt = units.iter().any(|u| !u.collision.is_empty());
    for (index, mut unit) in units.into_iter().enumerate() {
        let named = |name: &str| format!("{name}_{}", index + 1).into();
        unit.parts.iter_mut().chain(&mut unit.collision).for_each(|part| part.name = named(&part.name));
        unit.surfaces.iter_mut().for_each(|surface| surface.name = named(&surface.name));
        // If one unit has its own collision parts, the whole needs collision parts for all units.
        if felt {
            whole.collision.extend(if unit.collision.is_empty() { unit.parts.clone() } else { unit.collision });
        }
        whole.parts.extend(unit.parts);
        whole.surfaces.extend(unit.surfaces);
    }
    whole
}

/// A box between two corners.
pub(super) fn block(name: &str, low: Point3<f32>, high: Point3<f32>, mat: MaterialId) -> Part {
    let centre = nalgebra::center(&low, &high);
    Part {
        name: name.into(),
        shape: Shape::Box { half: (high - low) / 2.0 },
        material: mat.0,
        pose: Translation3::from(centre.coords).into(),
        joint: None,
    }
}

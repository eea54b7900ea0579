//! Assets moved, and put side by side.

use nalgebra::{Point3, Translation3, Vector3};
use vc_graph::Asset;
use vc_graph::asset::{Joint, Part, Shape};

use crate::material::Mat;

/// The asset moved against its origin by a vector, metres.
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

/// Moves a joint's anchor. Slides are moved as well: their anchors tell the drawers of one unit from the
/// next one's.
fn anchored(joint: &mut Option<Joint>, by: Vector3<f32>) {
    if let Some(joint) = joint {
        joint.anchor += by;
    }
}

/// One asset of several: parts and places keep their order, and are named by their unit.
pub(super) fn joined(name: &str, units: Vec<Asset>) -> Asset {
    let mut whole = Asset { name: name.into(), ..Asset::default() };
    let felt = units.iter().any(|u| !u.collision.is_empty());
    for (index, mut unit) in units.into_iter().enumerate() {
        let named = |name: &str| format!("{name}_{}", index + 1).into();
        unit.parts.iter_mut().chain(&mut unit.collision).for_each(|part| part.name = named(&part.name));
        unit.surfaces.iter_mut().for_each(|surface| surface.name = named(&surface.name));
        // If one unit has collision parts of its own, the whole needs them for all units.
        if felt {
            whole.collision.extend(if unit.collision.is_empty() { unit.parts.clone() } else { unit.collision });
        }
        whole.parts.extend(unit.parts);
        whole.surfaces.extend(unit.surfaces);
    }
    whole
}

/// A box between two corners.
pub(super) fn block(name: &str, low: Point3<f32>, high: Point3<f32>, mat: Mat) -> Part {
    let centre = nalgebra::center(&low, &high);
    Part {
        name: name.into(),
        shape: Shape::Box { half: (high - low) / 2.0 },
        material: mat.0,
        pose: Translation3::from(centre.coords).into(),
        joint: None,
    }
}

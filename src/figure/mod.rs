//! The figure of a person: an asset of fifteen bones, and its poses.

mod body;
mod bone;
#[cfg(feature = "render")]
pub(crate) mod clothes;
mod pose;
mod reach;
mod shape;

use vc_graph::asset::AssetError;
use vc_graph::{AssetId, AssetLibrary, Bounds};

pub(crate) use bone::{Bone, Side};
pub(crate) use pose::{Attitude, Doing, Skeleton};
pub(crate) use reach::Reach;
#[cfg(test)]
pub(crate) use shape::palm;

/// Height of the figure, metres: the height of the physics' default body.
pub(crate) const HEIGHT: f32 = 1.7;

/// The bounding box of a standing person.
pub(crate) fn bounds() -> Bounds {
    Bounds::standing(nalgebra::Vector3::new(0.4, 0.5, HEIGHT))
}

/// Adds a person to a library; persons with different numbers wear different clothes.
pub(crate) fn add_to(library: &mut AssetLibrary, number: usize) -> Result<AssetId, AssetError> {
    let asset = shape::person(library, number)?;
    library.add(asset)
}

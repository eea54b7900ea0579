//! The figure of a person: an asset of fifteen bones, and its poses.

mod body;
mod bone;
#[cfg(feature = "render")]
pub(crate) mod clothes;
mod pose;
mod reach;
mod shape;

use vc_graph::asset::AssetError;
use vc_graph::{Anthropometry, AssetId, AssetLibrary, Bounds};

pub(crate) use bone::{Bone, Side};
pub(crate) use pose::{Attitude, Doing, Skeleton};
pub(crate) use reach::Reach;
#[cfg(test)]
pub(crate) use shape::palm;

/// The person that the figure shows.
pub(crate) const ADULT: Anthropometry = Anthropometry::ADULT;

/// The bounding box of a standing person.
pub(crate) fn bounds() -> Bounds {
    Bounds::standing(nalgebra::Vector3::new(ADULT.depth, ADULT.breadth, ADULT.stature))
}

/// Adds a person to a library; persons with different numbers wear different clothes.
pub(crate) fn add_to(library: &mut AssetLibrary, number: usize) -> Result<AssetId, AssetError> {
    let asset = shape::person(library, number)?;
    library.add(asset)
}

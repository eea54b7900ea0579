//! A person's figure: an asset of fifteen bones, and the poses it takes.

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

/// Height of the figure, metres: that of the physics' default body.
pub(crate) const HEIGHT: f32 = 1.7;

/// The box around a person who stands.
pub(crate) fn bounds() -> Bounds {
    Bounds::standing(nalgebra::Vector3::new(0.4, 0.5, HEIGHT))
}

/// Adds a person to a library; others of another number wear other clothes.
pub(crate) fn add_to(library: &mut AssetLibrary, number: usize) -> Result<AssetId, AssetError> {
    let asset = shape::person(library, number)?;
    library.add(asset)
}

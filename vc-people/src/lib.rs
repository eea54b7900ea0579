//! The figure of a person: an asset of fifteen bones, and its poses.
//!
//! The body's frame has its origin between the feet, or on the seat; X points ahead, Y to the left, Z up; metres.
//!
//! ```
//! use vc_graph::AssetLibrary;
//! use vc_graph::nalgebra::Point3;
//! use vc_people::{BodyPosture, Bone, Activity, BodySide, Skeleton, palm};
//!
//! let mut library = AssetLibrary::default();
//! let person = vc_people::add_to(&mut library, 0)?;
//! assert!(library.get(person).is_some_and(|asset| asset.parts.iter().all(|p| p.joint.is_some())));
//!
//! // The left hand holds something before the chest.
//! let cup = Point3::new(0.35, 0.2, 1.1);
//! let skeleton = Skeleton::new(BodyPosture::Standing, &Activity::default(), [None, Some(cup)]);
//! let hand = skeleton.motion(Bone::Hand(BodySide::Left)) * palm(BodySide::Left);
//! assert!((hand - cup).norm() < 0.01);
//! # Ok::<(), vc_graph::asset::AssetError>(())
//! ```

#![warn(clippy::disallowed_methods)]

mod activity;
mod bone;
pub mod clothes;
mod pose;
mod reach;
mod shape;
mod skeleton;

use vc_graph::asset::AssetError;
use vc_graph::{Anthropometry, AssetId, AssetLibrary, Bounds};

pub use activity::{Activity, BodyPosture};
pub use bone::{BodySide, Bone};
pub use reach::Reach;
pub use shape::palm;
pub use skeleton::Skeleton;

/// The person that the figure shows.
pub(crate) const ADULT: Anthropometry = Anthropometry::ADULT;

/// The bounding box of a standing person.
///
/// ```
/// assert!((1.5..2.0).contains(&vc_people::bounds().size().z));
/// ```
pub fn bounds() -> Bounds {
    Bounds::standing(nalgebra::Vector3::new(ADULT.depth, ADULT.breadth, ADULT.stature))
}

/// Adds a person to a library; persons with different numbers wear different clothes.
///
/// # Errors
/// [`AssetError`] if the library refuses a material or the asset.
pub fn add_to(library: &mut AssetLibrary, number: usize) -> Result<AssetId, AssetError> {
    let asset = shape::person(library, number)?;
    library.add(asset)
}

//! Errors of spaces and of crossings.

use super::{PortalId, RegionId};
use crate::format::FormatError;
use crate::{ChangeMismatch, Digest, Label, NodeId};

/// An error in the plan of a [`Space`](super::Space), or in a scene that is given for a region.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpaceError {
    /// A region is part of one that does not exist yet.
    #[error("`{name}` is part of {parent}, which is not in the plan; add regions from the whole to its parts")]
    NoSuchParent {
        /// The region's name.
        name: String,
        /// The missing region.
        parent: RegionId,
    },
    /// There is no such region, or it is a group without a scene.
    #[error("{0} has no scene in this plan")]
    NoScene(RegionId),
    /// A frame or pose is not finite.
    #[error("the frame of `{0}` is not finite")]
    NotFinite(String),
    /// Node numbers are used up.
    #[error("`{name}` asks for {count} node numbers, {left} are left")]
    NumbersExhausted {
        /// The region's name.
        name: String,
        /// The numbers that it asks for.
        count: u32,
        /// The numbers that are left.
        left: u32,
    },
    /// Both sides of a portal are the same region.
    #[error("a portal joins {0} with itself")]
    JoinsItself(RegionId),
    /// The width or height of a portal is not positive.
    #[error("a portal between {0} and {1} is {2} m wide and {3} m high: both must be positive")]
    NoOpening(RegionId, RegionId, f32, f32),
    /// Neither side of a portal has the stop.
    #[error("a portal between {} and {} is at stop {stop}, and neither of them moves to one: see `Region::moving`", .regions[0], .regions[1])]
    NoStop {
        /// The regions.
        regions: [RegionId; 2],
        /// The stop, counted from 0.
        stop: u32,
    },
    /// A region that does not move was to be at a stop.
    #[error("{region} has no stop {stop}; it has {stops}, counted from 0")]
    StopUnknown {
        /// The region.
        region: RegionId,
        /// The stop.
        stop: u32,
        /// The number of its stops.
        stops: usize,
    },
    /// The two sides of a portal are not at the same place, or do not face each other.
    #[error("the sides of a portal between {0} and {1} are {2:.2} m and {3:.0} degrees apart")]
    SidesApart(RegionId, RegionId, f64, f64),
    /// The leaf of a portal is of neither of its regions.
    #[error("the leaf {leaf} of a portal between {} and {} has a number of neither of them", .regions[0], .regions[1])]
    ForeignLeaf {
        /// The leaf.
        leaf: NodeId,
        /// The regions.
        regions: [RegionId; 2],
    },
    /// A node of a scene has a number that is not of its region.
    #[error("{node} has a number outside the block of {region}: build the scene with `SceneBuilder::numbers`")]
    ForeignNumber {
        /// The region.
        region: RegionId,
        /// The node.
        node: Label,
    },
    /// The region is active already.
    #[error("{0} is active already")]
    Active(RegionId),
    /// The scene that was made for a region is not the one from which its changes were recorded.
    #[error("{region} is made otherwise than before: its scene had digest {before}, and has {now}")]
    MadeOtherwise {
        /// The region.
        region: RegionId,
        /// The digest of the scene as it was made before.
        before: Digest,
        /// The digest of the scene that was given.
        now: Digest,
    },
}

/// The reason why nobody goes through a portal; nothing has changed then.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PassError {
    /// There is no such node in an active region.
    #[error("there is no node {0} in an active region")]
    NoSuchNode(NodeId),
    /// There is no such portal.
    #[error("there is no {0}")]
    NoSuchPortal(PortalId),
    /// The node's region is on neither side of the portal.
    #[error("{node} is in {region}, which {portal} does not join")]
    Elsewhere {
        /// The node.
        node: Label,
        /// Its region.
        region: RegionId,
        /// The portal.
        portal: PortalId,
    },
    /// The portal is shut, or nobody fits through a portal of its kind.
    #[error("{0} cannot be passed: it is shut")]
    Shut(PortalId),
    /// The region beyond is not active.
    #[error("{0}, beyond the portal, is not active")]
    NotActive(RegionId),
    /// The region beyond has no room to be in, or not the one that the portal names.
    #[error("{0}, beyond the portal, has no room, or not the one that the portal names")]
    NoRoom(RegionId),
    /// The node rests on something that stays.
    #[error("{node} rests at {at}, which stays in {region}: stand up or be picked up first")]
    Resting {
        /// The node.
        node: Label,
        /// The thing that it rests on, in or with.
        at: Label,
        /// The region.
        region: RegionId,
    },
    /// The scene beyond has a node of the same number.
    #[error("the scene beyond has a node with the number of {0}: numbers are those of a region's block")]
    Taken(Label),
    /// A scene has changed since a passage that is to be undone.
    #[error(transparent)]
    Changed(Box<ChangeMismatch>),
    /// The scene beyond lacks an own word of a node.
    #[error("{node} has the own word `{word}`, which the vocabulary of {region} lacks")]
    Lacks {
        /// The node.
        node: Label,
        /// The word.
        word: &'static str,
        /// The region beyond.
        region: RegionId,
    },
    /// A room does not move.
    #[error("{0} is a room, which stays where it is")]
    IsRoom(Label),
    /// The shape of a thing cannot be taken over.
    #[error("the shape of {node} cannot be taken over: {error}")]
    Shape {
        /// The node.
        node: Label,
        /// The reason.
        error: crate::asset::AssetError,
    },
}

/// An error in the text of a saved world.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WorldFileError {
    /// It is no JSON of this format.
    #[error("this is no saved world: {0}")]
    Json(String),
    /// It was written by another version of the format.
    #[error("the world has version {0} of its format; this program reads {1}")]
    Version(u32, u32),
    /// It belongs to another plan.
    #[error("the world belongs to another plan, with digest {saved}; this one has {here}")]
    OtherPlan {
        /// The digest of the plan with which it was saved.
        saved: Digest,
        /// The digest of the plan that was given.
        here: Digest,
    },
    /// It names a region without a scene.
    #[error("the world names {0}, which has no scene in the plan")]
    NoSuchRegion(RegionId),
    /// Changes or shapes cannot be read.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// A region cannot be made active.
    #[error(transparent)]
    Space(#[from] SpaceError),
}

//! Portals: the openings through which regions are joined.

use std::fmt;
use std::sync::Arc;

use nalgebra::{Point3, distance};

use super::RegionId;
use crate::vocabulary::vocabulary;
use crate::{NodeId, Pose};

/// The number of a portal in its [`Space`](super::Space). Prints as `portal 3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct PortalId(pub u32);

impl fmt::Display for PortalId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "portal {}", self.0)
    }
}

vocabulary! {
    /// The kind of a portal.
    #[non_exhaustive]
    PortalKind, "kind of portal" {
        /// A door, with a leaf that opens and shuts.
        Door = "door",
        /// A window.
        Window = "window",
        /// An opening without a leaf: an archway, the end of a stretch of street.
        Passage = "passage",
        /// The top or foot of stairs, or the stop of a lift.
        Landing = "landing",
    }
}

/// One side of a portal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PortalSide {
    /// The region on this side.
    pub region: RegionId,
    /// The middle of its threshold in the region's frame, X pointing out of the region.
    pub pose: Pose,
    /// The room that one enters through it; the first of the scene if it is not said.
    pub room: Option<NodeId>,
}

/// Whether people and things, views and sounds go through a portal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct PortalState {
    /// Whether agents and things can go through.
    pub passable: bool,
    /// Whether one sees through.
    pub transparent: bool,
    /// Whether sounds go through without being damped.
    pub audible: bool,
}

impl PortalState {
    /// Nothing goes through.
    pub const CLOSED: Self = Self { passable: false, transparent: false, audible: false };
}

/// An opening between two regions.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Portal {
    /// Its kind.
    pub kind: PortalKind,
    /// Its two sides.
    pub sides: [PortalSide; 2],
    /// Clear width, metres.
    pub width: f32,
    /// Clear height, metres.
    pub height: f32,
    /// Whether its leaf is of glass.
    pub glazed: bool,
    /// The node whose state says whether it is open; without one it is what its kind is: a passage is open, a window shut.
    pub leaf: Option<NodeId>,
    /// The stop of its moving region at which it is there, counted from 0.
    pub stop: u32,
    /// The way over stairs to its threshold, from their foot on, in the frame of its first side; empty without stairs.
    pub stairs: Arc<[Point3<f32>]>,
    /// The nodes that call its moving region to its stop when somebody pushes them.
    pub buttons: Arc<[NodeId]>,
}

impl Portal {
    /// A portal of a kind between two sides, of a clear width and height in metres, without a leaf. Windows are of glass.
    pub fn new(kind: PortalKind, sides: [PortalSide; 2], width: f32, height: f32) -> Self {
        let glazed = kind == PortalKind::Window;
        Self { kind, sides, width, height, glazed, leaf: None, stop: 0, stairs: Arc::new([]), buttons: Arc::new([]) }
    }

    /// With a leaf: the node of a door or window.
    #[must_use]
    pub fn with_leaf(self, leaf: NodeId) -> Self {
        Self { leaf: Some(leaf), ..self }
    }

    /// As one of a region that [moves](super::Region::moving): it is there while the region is at this stop, counted from 0.
    #[must_use]
    pub fn at_stop(self, stop: u32) -> Self {
        Self { stop, ..self }
    }

    /// With nodes that call its moving region to its stop: a button before the door of a lift, one in the cabin.
    #[must_use]
    pub fn called_by(self, buttons: impl Into<Arc<[NodeId]>>) -> Self {
        Self { buttons: buttons.into(), ..self }
    }

    /// As the upper end of stairs in the region of its first side: their way, from the foot to the threshold, metres.
    #[must_use]
    pub fn over_stairs(self, way: impl Into<Arc<[Point3<f32>]>>) -> Self {
        Self { stairs: way.into(), ..self }
    }

    /// The length of its stairs, metres; 0 without stairs.
    pub fn climb(&self) -> f32 {
        self.stairs.windows(2).map(|step| distance(&step[0], &step[1])).sum()
    }

    /// The side of a region.
    pub fn side(&self, region: RegionId) -> Option<&PortalSide> {
        self.sides.iter().find(|side| side.region == region)
    }

    /// The side across from a region.
    pub fn across(&self, region: RegionId) -> Option<&PortalSide> {
        let [one, other] = &self.sides;
        [(one, other), (other, one)].into_iter().find(|(side, _)| side.region == region).map(|(_, across)| across)
    }

    /// Its state while its leaf is open, or shut.
    ///
    /// ```
    /// use vc_graph::Pose;
    /// use vc_graph::space::{Portal, PortalKind, PortalSide, RegionId};
    /// let sides = [0, 1].map(|n| PortalSide { region: RegionId(n), pose: Pose::identity(), room: None });
    /// let window = Portal::new(PortalKind::Window, sides, 1.2, 1.0);
    /// assert!(window.state(false).transparent && !window.state(true).passable);
    /// ```
    pub fn state(&self, open: bool) -> PortalState {
        let open = open || (self.leaf.is_none() && self.kind != PortalKind::Window);
        PortalState {
            passable: open && self.kind != PortalKind::Window,
            transparent: open || self.glazed,
            audible: open,
        }
    }
}

//! Errors of cities.

use std::fmt;
use std::sync::Arc;

use vc_graph::space::{RegionId, Space, SpaceError};
use vc_graph::{Label, NodeId};

use crate::environment::{MakeError, TravelError};
use crate::{ActionError, Interruption, PhysicalRefusal};

/// A region in messages: its path, `building/7/storey 0/gallery`.
///
/// ```
/// use virtualcity::graph::space::RegionId;
/// let city = virtualcity::City::make("building/7", 0)?;
/// assert_eq!(city.region_label(RegionId(1)).to_string(), "building/7/lift");
/// assert_eq!(city.region_label(RegionId(99)).to_string(), "region 99");
/// # Ok::<(), virtualcity::CityError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct RegionLabel {
    /// Its number.
    pub id: RegionId,
    /// Its name after those of the regions that it is part of; empty if there is no such region.
    pub path: Arc<str>,
}

impl RegionLabel {
    pub(super) fn new(space: &Space, id: RegionId) -> Self {
        Self { id, path: space.path(id).into() }
    }
}

impl fmt::Display for RegionLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { self.id.fmt(f) } else { f.write_str(&self.path) }
    }
}

/// Why something cannot be done in a city.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum CityError {
    /// The name is of no kind that is known.
    #[error(
        "`{0}` names no city; write `building/7`, `house/7`, or `apartment/42` for a home alone: seeds are whole numbers"
    )]
    Name(String),
    /// The plan could not be generated.
    #[error("{0}")]
    Generation(Arc<dyn std::error::Error + Send + Sync>),
    /// The node is no agent of this city.
    #[error("{0} is no agent of this city: `agents` lists them")]
    NoSuchAgent(Label),
    /// No region has a node of this number.
    #[error("there is no {0} in this city: `region_of` tells where a node is")]
    NoSuchThing(NodeId),
    /// There is no such region, or it is a group without a scene.
    #[error("{0} has no scene in this city")]
    NoScene(RegionLabel),
    /// The scene of a region cannot be made.
    #[error("{region} cannot be made: {why}")]
    Scene {
        /// The region.
        region: RegionLabel,
        /// The reason.
        #[source]
        why: Arc<dyn std::error::Error + Send + Sync>,
    },
    /// A scene has numbers of other regions.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// The environment of a region cannot be made.
    #[error("{region} cannot be made: {why}")]
    Make {
        /// The region.
        region: RegionLabel,
        /// The reason.
        #[source]
        why: Arc<MakeError>,
    },
    /// No way leads there.
    #[error("no way leads from {from} to {to}: no portal through which one gets there joins them")]
    NoWay {
        /// The region of the agent.
        from: RegionLabel,
        /// The region where it was to go.
        to: RegionLabel,
    },
    /// No way over the floor leads to the first portal of the way, though nobody is in the way.
    #[error("no way over the floor leads {agent} to a threshold of {region}: move what stands in between")]
    NoWayOut {
        /// The agent.
        agent: Label,
        /// The region in which it is.
        region: RegionLabel,
    },
    /// There is nowhere to stand beyond a threshold.
    #[error("there is no free floor within {within} m of the threshold of {region}")]
    NoFloor {
        /// The region that was to be entered.
        region: RegionLabel,
        /// How far from the threshold free floor was sought, metres.
        within: f32,
    },
    /// The doors of a lift open and shut with its cabin.
    #[error("{0} opens and shuts by itself, where the cabin stands: push a button to call it")]
    MovesByItself(Label),
    /// The agent has not ended within a day, and was interrupted.
    #[error("{0} has not ended within a day, and was interrupted: `give` and `step` wait longer")]
    TooLong(Label),
    /// A way to another region was given up for another action.
    #[error("{0} was interrupted on its way: it was given something else to do, or told to stop")]
    Interrupted(Label),
    /// A viewpoint has neither agent nor room.
    #[error("it is not said in which region the camera is: write `(region, viewpoint)`")]
    NoRegion,
    /// A picture cannot be made.
    #[cfg(feature = "render")]
    #[error("there is no picture in {region}: {why}")]
    Picture {
        /// The region of the camera.
        region: RegionLabel,
        /// The reason.
        #[source]
        why: Arc<crate::PictureError>,
    },
    /// The agent cannot leave a region or enter the next.
    #[error(transparent)]
    Travel(TravelError),
    /// The bodies do not allow it.
    #[error(transparent)]
    Bodies(#[from] PhysicalRefusal),
    /// The action was not done.
    #[error(transparent)]
    Action(#[from] ActionError),
}

impl CityError {
    /// A reason why somebody does not go from region to region, with their paths.
    pub(super) fn of_travel(space: &Space, why: TravelError) -> Self {
        match why {
            TravelError::NoFloor { region, within } => {
                Self::NoFloor { region: RegionLabel::new(space, region), within }
            }
            why => Self::Travel(why),
        }
    }

    /// There is no place beyond the threshold of a region.
    pub(super) fn of_no_floor(region: RegionLabel) -> Self {
        Self::NoFloor { region, within: crate::environment::BEYOND }
    }

    /// Whether somebody is in the doorway of a door that was to be moved, or it is stuck.
    pub(super) fn is_at_door(&self) -> bool {
        match self {
            Self::Bodies(PhysicalRefusal::Stuck { .. }) => true,
            Self::Action(ActionError::Interrupted { why, .. }) => matches!(**why, Interruption::InDoorway { .. }),
            _ => false,
        }
    }

    /// Whether it may be otherwise in a while: somebody is in the way.
    pub(super) fn may_pass(&self) -> bool {
        match self {
            Self::NoFloor { .. } | Self::Action(ActionError::Impossible { .. }) => true,
            Self::Bodies(PhysicalRefusal::Stuck { .. }) => true,
            Self::Action(ActionError::Interrupted { why, .. }) => {
                !matches!(**why, Interruption::Cancelled | Interruption::Replaced(_))
            }
            _ => false,
        }
    }
}

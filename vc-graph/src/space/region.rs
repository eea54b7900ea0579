//! Regions: the units of everything local.

use std::fmt;
use std::sync::Arc;

use super::{NumberBlock, RegionFrame};
use crate::vocabulary::vocabulary;

/// The number of a region in its [`Space`](super::Space). Prints as `region 3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
pub struct RegionId(pub u32);

impl fmt::Display for RegionId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "region {}", self.0)
    }
}

vocabulary! {
    /// The kind of a region.
    #[non_exhaustive]
    RegionKind, "kind of region" {
        /// A whole city.
        City = "city",
        /// A district of a city.
        District = "district",
        /// The ground between streets.
        Block = "block",
        /// A stretch of street between two junctions.
        Street = "street",
        /// A place where streets meet.
        Junction = "junction",
        /// A park or square.
        Park = "park",
        /// A building.
        Building = "building",
        /// A storey of a building.
        Storey = "storey",
        /// A part of a building with a use of its own: a flat, a shop, an office.
        Unit = "unit",
        /// A corridor or gallery from which units are entered.
        Corridor = "corridor",
        /// Stairs, with a lift if there is one.
        Stairwell = "stairwell",
        /// The ground that belongs to a building.
        Yard = "yard",
    }
}

/// A region of a [`Space`](super::Space). Those with node numbers have a scene; the others are groups, such as a storey.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Region {
    /// Its kind.
    pub kind: RegionKind,
    /// Its name; what it is made from, such as `apartment/42`.
    pub name: Arc<str>,
    /// The region that it is part of.
    pub parent: Option<RegionId>,
    /// Its frame: in that of its parent as it is given, in the world once the space is built.
    pub frame: RegionFrame,
    /// The numbers of nodes that are made in it; without numbers until the space is built.
    pub numbers: NumberBlock,
    /// The frames in which it stops, if it moves, as the cabin of a lift; its frame is the first.
    pub stops: Arc<[RegionFrame]>,
}

impl Region {
    /// A group of regions, at the origin of what it is part of.
    pub fn new(kind: RegionKind, name: impl Into<Arc<str>>) -> Self {
        let numbers = NumberBlock { first: 0, count: 0 };
        Self { kind, name: name.into(), parent: None, frame: RegionFrame::WORLD, numbers, stops: Arc::new([]) }
    }

    /// As part of another region.
    #[must_use]
    pub fn within(self, parent: RegionId) -> Self {
        Self { parent: Some(parent), ..self }
    }

    /// At a frame of the region that it is part of.
    #[must_use]
    pub fn at(self, frame: RegionFrame) -> Self {
        Self { frame, ..self }
    }

    /// At a point of the region that it is part of, metres, not turned.
    #[must_use]
    pub fn shifted(self, x: f64, y: f64, z: f64) -> Self {
        self.at(RegionFrame::new([x, y, z], 0.0))
    }

    /// As the cabin of a lift or whatever else moves between frames of the region that it is part of, the first of which is
    /// its own.
    #[must_use]
    pub fn moving(self, stops: impl Into<Arc<[RegionFrame]>>) -> Self {
        let stops = stops.into();
        Self { frame: stops.first().copied().unwrap_or(self.frame), stops, ..self }
    }

    /// With a scene, in which at most so many nodes can be made before it goes on with numbers of the world.
    #[must_use]
    pub fn with_numbers(self, count: u32) -> Self {
        Self { numbers: NumberBlock { first: 0, count }, ..self }
    }

    /// Its frame at a stop, counted from 0; that of a region that does not move, always.
    pub fn frame_at(&self, stop: usize) -> RegionFrame {
        self.stops.get(stop).copied().unwrap_or(self.frame)
    }

    /// Whether it has a scene.
    pub fn has_scene(&self) -> bool {
        self.numbers.count > 0
    }
}

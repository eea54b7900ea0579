//! The memory that the parts of maps hold.

use crate::parts::{Arm, Junction, Lane, Movement, Road, RoadCrossing, WalkEdge, WalkNode};
use crate::places::{Entrance, Stop};
use crate::signal::{Light, Phase, Signal};
use crate::{
    Area, Building, BuildingId, ConflictTable, CrossSection, CrossingDraft, CrossingId, EntranceDraft, EntranceId,
    JunctionDraft, JunctionId, LaneId, MapDraft, MovementId, Point, Polyline, RoadDraft, RoadId, SignDraft, StopDraft,
    Strip, TurnBan, WalkEdgeId,
};

/// Things that hold memory elsewhere.
pub(crate) trait Holds {
    /// The bytes that it holds, other than its own place.
    fn held(&self) -> usize;

    /// The bytes that it takes as an item of a list.
    fn bytes(&self) -> usize
    where
        Self: Sized,
    {
        size_of::<Self>() + self.held()
    }
}

impl<T: Holds> Holds for Vec<T> {
    fn held(&self) -> usize {
        self.capacity() * size_of::<T>() + self.iter().map(T::held).sum::<usize>()
    }
}

impl<T: Holds> Holds for Option<T> {
    fn held(&self) -> usize {
        self.as_ref().map_or(0, T::held)
    }
}

impl Holds for String {
    fn held(&self) -> usize {
        self.capacity()
    }
}

impl Holds for Polyline {
    fn held(&self) -> usize {
        Polyline::bytes(self)
    }
}

impl Holds for ConflictTable {
    fn held(&self) -> usize {
        ConflictTable::bytes(self)
    }
}

macro_rules! holds {
    ($($kind:ty { $($field:ident),* })*) => {$(
        impl Holds for $kind {
            fn held(&self) -> usize {
                0 $(+ self.$field.held())*
            }
        }
    )*};
}

holds! {
    i64 {} u32 {} [f64; 2] {} Point {} Arm {} Light {} Strip {} TurnBan {} CrossingDraft {} SignDraft {} WalkNode {}
    Entrance {}
    JunctionId {} RoadId {} LaneId {} MovementId {} CrossingId {} BuildingId {} EntranceId {} WalkEdgeId {}
    JunctionDraft { source }
    CrossSection { forward, backward }
    RoadDraft { line, section, name }
    Building { outline, courts, kind, name, address }
    EntranceDraft { kind }
    Area { outline, holes, name }
    StopDraft { name }
    MapDraft { name, junctions, roads, bans, crossings, signs, buildings, entrances, areas, stops }
    Road { draft, line, lanes }
    Lane { line, next, before }
    Junction { draft, arms, movements, conflicts, crossings, outline }
    Movement { line, yields }
    RoadCrossing { roads, line }
    WalkEdge { line }
    Phase { lights }
    Signal { phases }
    Stop { name }
}

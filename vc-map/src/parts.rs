//! The parts of a built map.

use nalgebra::Vector2;

use crate::{
    ConflictTable, CrossingId, CrossingKind, DrivingSide, JunctionDraft, JunctionId, LaneId, MovementId, Point,
    Polyline, RoadDraft, RoadId, SignKind, SignalId, StripKind, Turns, Users, WalkNodeId,
};

/// A road of a map.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Road {
    /// Its description.
    pub draft: RoadDraft,
    /// The middle of its carriageway, from junction to junction.
    pub line: Polyline,
    /// How far its lanes keep away from the start and the end of its line, metres: the junctions lie there.
    pub cuts: [f64; 2],
    /// Its lanes: those along the line from the divider outward, then those against it.
    pub lanes: Vec<LaneId>,
}

impl Road {
    /// The part of its line between its junctions.
    pub(crate) fn middle(&self) -> Polyline {
        self.line.part(self.cuts[0], self.line.length() - self.cuts[1]).unwrap_or_else(|| self.line.clone())
    }

    /// How far a point lies within the edges of the carriageway, metres, if that is more than a tenth of its width or half a metre.
    pub(crate) fn depth(&self, point: &Point) -> Option<f64> {
        let surface = self.draft.section.surface();
        let depth = surface / 2.0 - (self.line.project(point).point - point).norm();
        (self.draft.class.is_street() && depth > (surface / 10.0).min(0.5)).then_some(depth)
    }
}

/// A strip of a road that somebody uses, in the direction of travel.
///
/// ```
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
/// # for pair in ends.windows(2) {
/// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
/// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // a street of two roads along X
/// let lane = &map.lanes()[0];
/// assert!(lane.forward && lane.limit == 8.3 && lane.line.heading(0.0) == 0.0);
/// // On over the junction, into the lane of the next road.
/// let movement = map.movement(lane.next[0]).ok_or("a movement")?;
/// let next = map.lane(movement.to).ok_or("a lane")?;
/// assert!(next.road != lane.road && next.line.start().x > lane.line.end().x);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Lane {
    /// Its road.
    pub road: RoadId,
    /// Whether it runs along the road's line.
    pub forward: bool,
    /// Its position among the strips of its side, from the divider outward.
    pub index: usize,
    /// Its kind.
    pub kind: StripKind,
    /// Its width, metres.
    pub width: f64,
    /// Those who may use it.
    pub users: Users,
    /// Its speed limit, metres per second.
    pub limit: f64,
    /// The directions that are marked on it.
    pub turns: Turns,
    /// Its middle, in the direction of travel.
    pub line: Polyline,
    /// The next lane of the same side towards the divider.
    pub inner: Option<LaneId>,
    /// The next lane of the same side away from the divider.
    pub outer: Option<LaneId>,
    /// The movements by which one goes on at its end.
    pub next: Vec<MovementId>,
    /// The movements by which one comes to its start.
    pub before: Vec<MovementId>,
    /// The station at which vehicles wait, metres; `None` where they need not.
    pub stop_line: Option<f64>,
    /// The sign at its end.
    pub sign: Option<SignKind>,
}

/// An end of a road at a junction.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Arm {
    /// The road.
    pub road: RoadId,
    /// Whether it is the start of the road's line.
    pub start: bool,
    /// The direction in which the road leaves the junction, a unit vector.
    pub away: Vector2<f64>,
}

/// A junction of a map.
///
/// ```
/// use vc_map::Turn;
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("corner", 48.1, 11.6);
/// # let middle = draft.junction([0.0, 0.0], Control::Priority);
/// # for at in [[-100.0, 0.0], [100.0, 0.0], [0.0, 100.0]] {
/// #     let (end, side) = (draft.junction(at, Control::Edge), vec![Strip::driving(3.0, 8.3), Strip::pavement(2.4)]);
/// #     let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// #     draft.road(end, middle, RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // streets to the west, east and north
/// let junction = map.junction(middle).ok_or("a junction")?;
/// let turn = |turn: Turn| junction.movements.iter().filter(|id| map.movement(**id).is_some_and(|m| m.turn == turn)).count();
/// assert_eq!([Turn::Through, Turn::Left, Turn::Right].map(turn), [2, 2, 2]);
/// // Rows of the table are movements, then crossings.
/// assert_eq!(junction.conflicts.size(), junction.movements.len() + junction.crossings.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Junction {
    /// Its description.
    pub draft: JunctionDraft,
    /// Its middle.
    pub at: Point,
    /// The ends of roads, counter-clockwise.
    pub arms: Vec<Arm>,
    /// Its movements.
    pub movements: Vec<MovementId>,
    /// Which movements and crossings are in each other's way.
    pub conflicts: ConflictTable,
    /// The crossings over its arms.
    pub crossings: Vec<CrossingId>,
    /// Its signal.
    pub signal: Option<SignalId>,
    /// Its outline, counter-clockwise; empty if fewer than two roads meet.
    pub outline: Vec<Point>,
}

/// The direction of a movement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Turn {
    /// Straight on.
    Through,
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Back.
    Back,
}

impl Turn {
    /// The mark of a lane from which one goes there.
    pub(crate) fn mark(self) -> Turns {
        match self {
            Self::Through => Turns::THROUGH,
            Self::Left => Turns::LEFT,
            Self::Right => Turns::RIGHT,
            Self::Back => Turns::BACK,
        }
    }

    /// Whether it leads over the divider: to the left for those who keep to the right.
    pub(crate) fn crosses_divider(self, side: DrivingSide) -> bool {
        self == Self::Back || self == if side == DrivingSide::Right { Self::Left } else { Self::Right }
    }
}

/// A way over a junction, from the end of a lane to the start of another.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Movement {
    /// The junction.
    pub junction: JunctionId,
    /// The lane that one comes from.
    pub from: LaneId,
    /// The lane that one goes on with.
    pub to: LaneId,
    /// Its direction.
    pub turn: Turn,
    /// Its line; its length is the length of the junction's interior.
    pub line: Polyline,
    /// Those who may go.
    pub users: Users,
    /// The movements of its junction to which it gives way where no signal rules, by their positions there.
    pub yields: Vec<u32>,
}

/// A crossing over an end of a road.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RoadCrossing {
    /// The junction at which it is.
    pub junction: JunctionId,
    /// The roads that it crosses: two of a dual carriageway.
    pub roads: Vec<RoadId>,
    /// How it is marked.
    pub kind: CrossingKind,
    /// Whether there is an island in its middle.
    pub island: bool,
    /// Its middle, from kerb to kerb.
    pub line: Polyline,
    /// Its width, metres.
    pub width: f64,
    /// Its ends in the walkable network: the kerb ramps.
    pub ramps: [WalkNodeId; 2],
    /// Whether it was guessed.
    pub guessed: bool,
}

/// A place of the walkable network: a corner, a ramp, the end of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WalkNode {
    /// Its place.
    pub at: Point,
    /// The junction at which it is.
    pub junction: JunctionId,
}

/// The ground of an edge of the walkable network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum WalkKind {
    /// The pavement of a road, or a path: a lane.
    Lane(LaneId),
    /// The edge of a carriageway without pavements.
    Shared(RoadId),
    /// The corner of a junction.
    Corner(JunctionId),
    /// A crossing.
    Crossing(CrossingId),
}

impl WalkKind {
    /// Whether it is a pavement, a path or a street that is walked on, and no corner or crossing.
    pub(crate) fn is_pavement(self) -> bool {
        matches!(self, Self::Lane(_) | Self::Shared(_))
    }
}

/// An edge of the walkable network, walked both ways.
///
/// ```
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
/// # let side = vec![Strip::driving(3.0, 8.3), Strip::pavement(2.0)];
/// # for pair in ends.windows(2) {
/// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
/// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // a street of two roads along X
/// // From a node one goes on along all edges that meet there.
/// let edge = &map.walk_edges()[0];
/// for node in edge.ends {
///     assert!(map.walk_edges_at(node).iter().any(|id| map.walk_edge(*id) == Some(edge)));
/// }
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct WalkEdge {
    /// Its ends.
    pub ends: [WalkNodeId; 2],
    /// Its ground.
    pub kind: WalkKind,
    /// Its line, from the first end to the second.
    pub line: Polyline,
    /// Whether it is steps.
    pub steps: bool,
}

//! The kinds of violation, with their places.

use crate::{
    BuildingId, CrossingId, EntranceId, JunctionId, LaneId, MovementId, Point, RoadId, SignalId, StreetMap, WalkEdgeId,
    WalkNodeId,
};

/// Something that is wrong with a map.
///
/// ```
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("street", 48.1, 11.6);
/// # let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Edge));
/// # let side = vec![Strip::driving(3.0, 15.0), Strip::pavement(2.0)];
/// # let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// # draft.road(ends[0], ends[1], RoadClass::Primary, section);
/// # let map = draft.build()?; // a fast street that leaves the map at both ends: nobody crosses it
/// let wrong = map.validate();
/// assert!(wrong.iter().any(|v| v.kind() == "pavements cut off" && v.place(&map).is_some()));
/// assert!(wrong[0].to_string().ends_with("are cut off from the pavements"));
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum MapViolation {
    /// Lanes for cars that cannot be reached from the main part of the network, or from which it cannot be reached.
    CutOff {
        /// One of the lanes.
        lane: LaneId,
        /// The number of lanes in this part.
        lanes: usize,
    },
    /// A lane ends at a junction, and nothing goes on.
    DeadLane {
        /// The lane.
        lane: LaneId,
    },
    /// A lane begins or ends far from its junction, so that movements jump.
    Gap {
        /// The junction.
        junction: JunctionId,
        /// The lane at the gap.
        lane: LaneId,
        /// The distance of its end from the middle of the junction, metres.
        metres: f64,
    },
    /// A movement begins or ends against the direction of its lanes.
    Kink {
        /// The movement.
        movement: MovementId,
    },
    /// A road's line begins or ends beside its junction, which is a single point.
    Aside {
        /// The road.
        road: RoadId,
        /// The junction.
        junction: JunctionId,
        /// The distance between them, metres.
        metres: f64,
    },
    /// A road's line crosses itself.
    Tangled {
        /// The road.
        road: RoadId,
    },
    /// Lanes of two roads on one level lie on each other for most of one of them.
    Overlap {
        /// The roads.
        roads: [RoadId; 2],
        /// For so long, metres.
        metres: f64,
    },
    /// Streets on one level cross where they have no junction.
    Crosses {
        /// The roads.
        roads: [RoadId; 2],
        /// Where, metres.
        at: Point,
    },
    /// Two movements, or a movement and a crossing, meet, and the conflict table lacks them.
    MissingConflict {
        /// The junction.
        junction: JunctionId,
        /// Their positions in the table.
        pair: (usize, usize),
    },
    /// Two that conflict have green together, and neither gives way.
    UnsafePhase {
        /// The signal.
        signal: SignalId,
        /// The phase, from zero.
        phase: usize,
        /// Their positions in the table.
        pair: (usize, usize),
    },
    /// People who have begun to cross are not over when vehicles start that cross their way.
    ShortClearance {
        /// The signal.
        signal: SignalId,
        /// The phase after which people stop, from zero.
        phase: usize,
        /// The crossing.
        crossing: CrossingId,
        /// The time until vehicles start, seconds.
        seconds: f64,
    },
    /// A movement or crossing never gets green.
    NeverGreen {
        /// The signal.
        signal: SignalId,
        /// Its position in the table.
        row: usize,
    },
    /// No vehicle ever has to stop at a signal: it guards nothing.
    NeverRed {
        /// The signal.
        signal: SignalId,
    },
    /// A part of the walkable network is cut off from its main part.
    WalkCutOff {
        /// A node of the part.
        node: WalkNodeId,
        /// The number of nodes in the part.
        nodes: usize,
        /// The length of its edges, metres.
        metres: f64,
    },
    /// A pavement, path or corner leads over a lane for cars, or over the way of those who come from it, where there is no crossing.
    WalkInLane {
        /// The edge of the walkable network.
        edge: WalkEdgeId,
        /// The lane.
        lane: LaneId,
    },
    /// An edge of the walkable network does not begin and end where its nodes are.
    WalkGap {
        /// The edge.
        edge: WalkEdgeId,
        /// The distance, metres.
        metres: f64,
    },
    /// A crossing lies beside a road that it is to cross.
    CrossesNothing {
        /// The crossing.
        crossing: CrossingId,
        /// The road.
        road: RoadId,
    },
    /// The description has a crossing that joins no paths or pavements, so that the map does not have it.
    LostCrossing {
        /// The junction.
        junction: JunctionId,
        /// The road that it is to cross.
        road: RoadId,
    },
    /// A crossing begins or ends in a carriageway that it leads over, so that it is shorter than that is wide.
    CrossingInRoad {
        /// The crossing.
        crossing: CrossingId,
        /// The road.
        road: RoadId,
        /// The distance from the edge of the carriageway, metres.
        metres: f64,
    },
    /// An arm with pavements of a junction with lights has no crossing.
    NoCrossing {
        /// The junction.
        junction: JunctionId,
        /// The road.
        road: RoadId,
    },
    /// A crossing at a junction with lights has none by its kind, or it has and the junction has none.
    Unlit {
        /// The crossing.
        crossing: CrossingId,
    },
    /// The outline of a building crosses itself, or encloses nothing.
    Outline {
        /// The building.
        building: BuildingId,
    },
    /// A building has no height, or begins above its top.
    NoHeight {
        /// The building.
        building: BuildingId,
    },
    /// A building stands on lanes for cars or on a pavement.
    OnStreet {
        /// The building.
        building: BuildingId,
        /// The road.
        road: RoadId,
        /// So many metres of one of its lanes.
        metres: f64,
    },
    /// A door is far from the walls of its building.
    DoorAway {
        /// The door.
        entrance: EntranceId,
        /// The distance, metres.
        metres: f64,
    },
    /// Nobody can walk to a door.
    DoorWithoutWay {
        /// The door.
        entrance: EntranceId,
    },
    /// A door opens onto a lane for cars.
    DoorInLane {
        /// The door.
        entrance: EntranceId,
        /// The lane.
        lane: LaneId,
    },
    /// The straight way from a door to its pavement leads through a building.
    DoorWalledIn {
        /// The door.
        entrance: EntranceId,
        /// The building.
        building: BuildingId,
    },
    /// Nobody walks to a stop, and nothing stops there.
    StopAway {
        /// Its position among the stops.
        stop: usize,
    },
}

impl MapViolation {
    /// Its kind in words, for lists of how many there are of each.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::CutOff { .. } => "streets cut off",
            Self::DeadLane { .. } => "lane without a way on",
            Self::Gap { .. } => "lane far from its junction",
            Self::Kink { .. } => "movement with a kink",
            Self::Aside { .. } => "road beside its junction",
            Self::Tangled { .. } => "road crosses itself",
            Self::Overlap { .. } => "streets on each other",
            Self::Crosses { .. } => "streets cross without a junction",
            Self::MissingConflict { .. } => "conflict missing",
            Self::UnsafePhase { .. } => "unsafe phase",
            Self::ShortClearance { .. } => "clearance too short",
            Self::NeverGreen { .. } => "never green",
            Self::NeverRed { .. } => "never red",
            Self::WalkCutOff { .. } => "pavements cut off",
            Self::WalkInLane { .. } => "pavement in a lane",
            Self::WalkGap { .. } => "pavement away from its nodes",
            Self::CrossesNothing { .. } => "crossing beside its road",
            Self::LostCrossing { .. } => "crossing without a way",
            Self::CrossingInRoad { .. } => "crossing ends in its road",
            Self::NoCrossing { .. } => "no crossing at lights",
            Self::Unlit { .. } => "crossing and junction differ in lights",
            Self::Outline { .. } => "outline crosses itself",
            Self::NoHeight { .. } => "building without height",
            Self::OnStreet { .. } => "building on a street",
            Self::DoorAway { .. } => "door away from its building",
            Self::DoorWithoutWay { .. } => "door without a way",
            Self::DoorInLane { .. } => "door in a lane",
            Self::DoorWalledIn { .. } => "way to a door through a building",
            Self::StopAway { .. } => "stop away from everything",
        }
    }

    /// Its place on the map, metres; `None` if it is of another map.
    pub fn place(&self, map: &StreetMap) -> Option<Point> {
        let lane = |id: &LaneId| map.lane(*id).map(|lane| lane.line.end());
        let junction = |id: &JunctionId| map.junction(*id).map(|junction| junction.at);
        let road = |id: &RoadId| map.road(*id).map(|road| road.line.at(road.line.length() / 2.0));
        let walk = |id: &WalkEdgeId| map.walk_edge(*id).map(|edge| edge.line.start());
        let door = |id: &EntranceId| map.entrance(*id).map(|entrance| entrance.door);
        let building = |id: &BuildingId| map.building(*id).and_then(|b| b.outline.first()).map(|at| Point::from(*at));
        match self {
            Self::CutOff { lane: id, .. } | Self::DeadLane { lane: id } | Self::Gap { lane: id, .. } => lane(id),
            Self::Crosses { at, .. } => Some(*at),
            Self::StopAway { stop } => map.stops().get(*stop).map(|stop| stop.at),
            Self::Kink { movement } => map.movement(*movement).map(|movement| movement.line.start()),
            Self::Tangled { road: id } | Self::Overlap { roads: [id, _], .. } => road(id),
            Self::Aside { junction: id, .. }
            | Self::MissingConflict { junction: id, .. }
            | Self::LostCrossing { junction: id, .. }
            | Self::NoCrossing { junction: id, .. } => junction(id),
            Self::UnsafePhase { signal, .. } | Self::NeverGreen { signal, .. } | Self::NeverRed { signal } => {
                map.signal(*signal).and_then(|signal| junction(&signal.junction))
            }
            Self::WalkCutOff { node, .. } => map.walk_node(*node).map(|node| node.at),
            Self::WalkInLane { edge, .. } | Self::WalkGap { edge, .. } => walk(edge),
            Self::Outline { building: id } | Self::NoHeight { building: id } | Self::OnStreet { building: id, .. } => {
                building(id)
            }
            Self::DoorAway { entrance, .. }
            | Self::DoorWithoutWay { entrance }
            | Self::DoorInLane { entrance, .. }
            | Self::DoorWalledIn { entrance, .. } => door(entrance),
            Self::Unlit { crossing }
            | Self::ShortClearance { crossing, .. }
            | Self::CrossingInRoad { crossing, .. }
            | Self::CrossesNothing { crossing, .. } => map.crossing(*crossing).map(|crossing| crossing.line.start()),
        }
    }
}

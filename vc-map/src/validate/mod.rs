//! Checks of maps: every violation, with its place.

mod conflicts;
mod lanes;
mod walk;

use std::fmt;

use crate::{ConflictTable, CrossingId, JunctionId, LaneId, Light, Point, Signal, SignalId, StreetMap, WalkNodeId};

pub use conflicts::{missing_conflicts, short_clearances, unsafe_phases};

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
    /// A part of the walkable network is cut off from its main part.
    WalkCutOff {
        /// A node of the part.
        node: WalkNodeId,
        /// The number of nodes in the part.
        nodes: usize,
        /// The length of its edges, metres.
        metres: f64,
    },
    /// An arm with pavements of a junction with lights has no crossing.
    NoCrossing {
        /// The junction.
        junction: JunctionId,
        /// The road.
        road: crate::RoadId,
    },
    /// A crossing at a junction with lights has none by its kind, or it has and the junction has none.
    Unlit {
        /// The crossing.
        crossing: CrossingId,
    },
}

impl MapViolation {
    /// Its kind in words, for lists of how many there are of each.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::CutOff { .. } => "streets cut off",
            Self::DeadLane { .. } => "lane without a way on",
            Self::Gap { .. } => "lane far from its junction",
            Self::MissingConflict { .. } => "conflict missing",
            Self::UnsafePhase { .. } => "unsafe phase",
            Self::ShortClearance { .. } => "clearance too short",
            Self::NeverGreen { .. } => "never green",
            Self::WalkCutOff { .. } => "pavements cut off",
            Self::NoCrossing { .. } => "no crossing at lights",
            Self::Unlit { .. } => "crossing and junction differ in lights",
        }
    }

    /// Its place on the map, metres; `None` if it is of another map.
    pub fn place(&self, map: &StreetMap) -> Option<Point> {
        let lane = |id: &LaneId| map.lane(*id).map(|lane| lane.line.end());
        let junction = |id: &JunctionId| map.junction(*id).map(|junction| junction.at);
        match self {
            Self::CutOff { lane: id, .. } | Self::DeadLane { lane: id } | Self::Gap { lane: id, .. } => lane(id),
            Self::MissingConflict { junction: id, .. } | Self::NoCrossing { junction: id, .. } => junction(id),
            Self::UnsafePhase { signal, .. } | Self::NeverGreen { signal, .. } => {
                map.signal(*signal).and_then(|signal| junction(&signal.junction))
            }
            Self::WalkCutOff { node, .. } => map.walk_node(*node).map(|node| node.at),
            Self::Unlit { crossing } | Self::ShortClearance { crossing, .. } => {
                map.crossing(*crossing).map(|crossing| crossing.line.start())
            }
        }
    }
}

impl fmt::Display for MapViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CutOff { lane, lanes } => {
                write!(f, "{lane} and {} more are cut off from the main streets", lanes - 1)
            }
            Self::DeadLane { lane } => write!(f, "{lane} ends, and nothing goes on"),
            Self::Gap { junction, lane, metres } => {
                write!(f, "{lane} ends {metres:.0} m from the middle of {junction}")
            }
            Self::MissingConflict { junction, pair } => {
                write!(f, "{} and {} of {junction} meet, and its table lacks them", pair.0, pair.1)
            }
            Self::UnsafePhase { signal, phase, pair } => {
                write!(f, "phase {phase} of {signal} lets {} and {} go, which conflict", pair.0, pair.1)
            }
            Self::ShortClearance { signal, phase, crossing, seconds } => {
                write!(f, "people on {crossing} have {seconds:.1} s to end after phase {phase} of {signal}, too few")
            }
            Self::NeverGreen { signal, row } => write!(f, "{row} of {signal} never gets green"),
            Self::WalkCutOff { node, nodes, metres } => {
                write!(f, "{node} and {} more, {metres:.0} m, are cut off from the pavements", nodes - 1)
            }
            Self::NoCrossing { junction, road } => write!(f, "{junction} has lights and no crossing over {road}"),
            Self::Unlit { crossing } => {
                write!(f, "either {crossing} or its junction has no lights, and the other does")
            }
        }
    }
}

impl StreetMap {
    /// Everything that is wrong with the map, in the order of its parts. A real map has some: streets that the edge cuts off.
    /// Costs a few milliseconds for each square kilometre, most of it for the movements of each junction against each other.
    ///
    /// ```
    /// use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
    /// let mut draft = MapDraft::new("two ends", 0.0, 0.0);
    /// let ends = [[0.0, 0.0], [100.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// let side = vec![Strip::driving(3.0, 8.3)];
    /// draft.road(ends[0], ends[1], RoadClass::Residential, CrossSection { forward: side.clone(), backward: side, median: 0.0 });
    /// assert_eq!(draft.build()?.validate(), []);
    /// # Ok::<(), vc_map::MapError>(())
    /// ```
    pub fn validate(&self) -> Vec<MapViolation> {
        let mut found = lanes::violations(self);
        for (index, junction) in self.junctions().iter().enumerate() {
            let junction_id = JunctionId::of(index);
            let pairs = missing_conflicts(self, junction_id, &junction.conflicts);
            found.extend(pairs.into_iter().map(|pair| MapViolation::MissingConflict { junction: junction_id, pair }));
        }
        for (index, signal) in self.signals().iter().enumerate() {
            let id = SignalId::of(index);
            let Some(junction) = self.junction(signal.junction) else { continue };
            let pairs = unsafe_phases(signal, &junction.conflicts);
            found.extend(pairs.into_iter().map(|(phase, pair)| MapViolation::UnsafePhase { signal: id, phase, pair }));
            let short = short_clearances(self, signal);
            found.extend(short.into_iter().map(|(phase, crossing, seconds)| MapViolation::ShortClearance {
                signal: id,
                phase,
                crossing,
                seconds,
            }));
            found.extend(dark(signal, &junction.conflicts).map(|row| MapViolation::NeverGreen { signal: id, row }));
        }
        found.extend(walk::violations(self));
        found
    }
}

/// The movements and crossings that never get green.
fn dark(signal: &Signal, table: &ConflictTable) -> impl Iterator<Item = usize> {
    let green = |light: &Light| matches!(light, Light::Green | Light::GreenYield);
    (0..table.size()).filter(move |row| !signal.phases.iter().any(|phase| phase.lights.get(*row).is_some_and(green)))
}

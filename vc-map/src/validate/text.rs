//! The texts of violations.

use std::fmt;

use super::MapViolation;

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
            Self::Kink { movement } => write!(f, "{movement} begins or ends against the direction of its lanes"),
            Self::Aside { road, junction, metres } => {
                write!(f, "the line of {road} begins or ends {metres:.0} m beside {junction}")
            }
            Self::Tangled { road } => write!(f, "the line of {road} crosses itself"),
            Self::Overlap { roads: [one, other], metres } => {
                write!(f, "{one} and {other} lie on each other for {metres:.0} m, on one level")
            }
            Self::Crosses { roads: [one, other], .. } => {
                write!(f, "{one} and {other} cross on one level, and no junction is there")
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
            Self::NeverRed { signal } => write!(f, "no vehicle ever stops at {signal}: it guards nothing"),
            Self::WalkInLane { edge, lane } => write!(f, "{edge} leads over {lane} without a crossing"),
            Self::WalkGap { edge, metres } => write!(f, "{edge} begins or ends {metres:.1} m from its nodes"),
            Self::CrossesNothing { crossing, road } => write!(f, "{crossing} lies beside {road}, which it is to cross"),
            Self::WalkCutOff { node, nodes, metres } => {
                write!(f, "{node} and {} more, {metres:.0} m, are cut off from the pavements", nodes - 1)
            }
            Self::LostCrossing { junction, road } => {
                write!(f, "the crossing over {road} at {junction} joins no paths or pavements")
            }
            Self::CrossingInRoad { crossing, road, metres } => {
                write!(f, "{crossing} begins or ends in {road}, {metres:.1} m from the edge of its carriageway")
            }
            Self::NoCrossing { junction, road } => write!(f, "{junction} has lights and no crossing over {road}"),
            Self::Unlit { crossing } => {
                write!(f, "either {crossing} or its junction has no lights, and the other does")
            }
            Self::Outline { building } => write!(f, "the outline of {building} crosses itself, or encloses nothing"),
            Self::NoHeight { building } => write!(f, "{building} has no height, or begins above its top"),
            Self::OnStreet { building, road, metres } => {
                write!(f, "{building} stands on {road} for {metres:.0} m")
            }
            Self::DoorAway { entrance, metres } => {
                write!(f, "{entrance} is {metres:.0} m from the walls of its building")
            }
            Self::DoorWithoutWay { entrance } => write!(f, "no pavement or path lies within 200 m of {entrance}"),
            Self::DoorWalledIn { entrance, building } => {
                write!(f, "the way from {entrance} to its pavement leads through {building}")
            }
            Self::StopAway { stop } => write!(f, "nobody walks to stop {stop}, and nothing stops there"),
            Self::DoorInLane { entrance, lane } => write!(f, "{entrance} opens onto {lane}"),
        }
    }
}

//! The account of an import: the values that it guessed, and the elements that it dropped.

use std::fmt;

use super::Element;
use crate::DrivingSide;

/// A value that a file does not have and that a rule gave.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Guessed {
    /// The lanes of both directions together.
    Lanes(u32),
    /// The speed limit, metres per second.
    Limit(f64),
    /// Pavements along both sides.
    Pavements,
    /// The storeys of a building.
    Storeys(u32),
    /// The height of a building, metres.
    Height(f64),
    /// A door, on the side that is nearest to a way.
    Entrance,
    /// The side on which vehicles drive, by the roundabouts or by the place.
    Side(DrivingSide),
    /// The directions marked on lanes do not fit their number and were left out.
    TurnLanes,
    /// The map ends at a node: traffic comes from nowhere or has nowhere to go.
    Edge,
    /// A signal before a junction belongs to it.
    SignalAt(i64),
}

impl fmt::Display for Guessed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lanes(count) => write!(f, "{count} lanes"),
            Self::Limit(limit) => write!(f, "limit {:.0} km/h", limit * 3.6),
            Self::Pavements => f.write_str("pavements on both sides"),
            Self::Storeys(count) => write!(f, "{count} storeys"),
            Self::Height(height) => write!(f, "height {height:.1} m"),
            Self::Entrance => f.write_str("a door on the side that is nearest to a way"),
            Self::Side(DrivingSide::Left) => f.write_str("traffic drives on the left"),
            Self::Side(DrivingSide::Right) => f.write_str("traffic drives on the right"),
            Self::TurnLanes => f.write_str("no marks on lanes: those given are of another number of lanes"),
            Self::Edge => f.write_str("the map ends here"),
            Self::SignalAt(node) => write!(f, "the signal is that of the junction at node {node}"),
        }
    }
}

/// The reason for which something was dropped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Reason {
    /// It is planned, being built, or no longer there.
    NotThere,
    /// It is inside a building or goes up and down in one place.
    Indoors,
    /// Nobody whom the map knows may use it.
    NobodyMayUse,
    /// Nodes or members of it are not in the file.
    CutOff,
    /// It has no length or no area, or lies across itself.
    NoShape,
    /// It lies within a junction that was made of several nodes.
    WithinJunction,
    /// A restriction of turns that no pair of roads fits.
    NoSuchTurn,
    /// The map has no use for it.
    NoUse,
    /// More ways meet at its end than a junction takes.
    TooManyMeet,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotThere => "planned, being built, or no longer there",
            Self::Indoors => "indoors",
            Self::NobodyMayUse => "nobody may use it",
            Self::CutOff => "nodes or members are not in the file",
            Self::NoShape => "without length or area",
            Self::WithinJunction => "within a junction of several nodes",
            Self::NoSuchTurn => "no turn fits",
            Self::NoUse => "no use for it",
            Self::TooManyMeet => "too many ways meet",
        })
    }
}

/// The account of an import: everything guessed and everything dropped, in the order of the elements.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct ImportReport {
    /// Values that a rule gave.
    pub guessed: Vec<(Element, Guessed)>,
    /// Elements that the map lacks.
    pub dropped: Vec<(Element, Reason)>,
}

impl ImportReport {
    pub(super) fn guess(&mut self, element: Element, guessed: Guessed) {
        self.guessed.push((element, guessed));
    }

    pub(super) fn drop(&mut self, element: Element, reason: Reason) {
        self.dropped.push((element, reason));
    }

    pub(super) fn close(&mut self) {
        self.guessed.sort_by_key(|(element, _)| *element);
        self.dropped.sort();
        self.dropped.dedup();
    }
}

/// A line for each guess and each element that was dropped.
impl fmt::Display for ImportReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.guessed.iter().try_for_each(|(element, guessed)| writeln!(f, "guessed  {element}: {guessed}"))?;
        self.dropped.iter().try_for_each(|(element, reason)| writeln!(f, "dropped  {element}: {reason}"))
    }
}

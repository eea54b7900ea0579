//! The account of an import: the values that it guessed, and whatever of the file the map does not have.

use std::collections::BTreeMap;
use std::fmt;

use super::Element;
use super::tags::{Source, Tags, Use};
use super::words::{Full, Room};
use crate::DrivingSide;

/// A value that a file does not have and that a rule gave.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Guessed {
    /// The lanes of both directions together.
    Lanes(u32),
    /// The width of a lane or path, metres.
    Width(f64),
    /// The speed limit, metres per second.
    Limit(f64),
    /// Pavements: the number of sides that have one.
    Pavements(u32),
    /// The level of a bridge or tunnel.
    Layer(i8),
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
    /// One lane for both directions, as a narrow one for each.
    SharedLane,
    /// Bicycles may go against a one-way street, on a strip that is not marked.
    ContraFlow,
    /// The lane in the middle, for those of both directions who turn, is a divider.
    MiddleLane,
    /// The map ends at a node: traffic comes from nowhere or has nowhere to go.
    Edge,
    /// A signal before a junction belongs to it.
    SignalAt(i64),
    /// The lights of a crossing are those of a junction further on; the crossing has marks.
    CrossingOf(i64),
    /// A crossing between pavements that are mapped apart: so many paths lead from it to them.
    Links(u32),
    /// A crossing with lights belongs to a junction without; the crossing has marks.
    NoLights,
}

impl fmt::Display for Guessed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lanes(count) => write!(f, "{count} lanes"),
            Self::Width(width) => write!(f, "{width:.2} m wide, or each of its lanes"),
            Self::Limit(limit) => write!(f, "limit {:.0} km/h", limit * 3.6),
            Self::Pavements(1) => f.write_str("a pavement on one side"),
            Self::Pavements(_) => f.write_str("pavements on both sides"),
            Self::Layer(layer) => write!(f, "level {layer}"),
            Self::Storeys(count) => write!(f, "{count} storeys"),
            Self::Height(height) => write!(f, "height {height:.1} m"),
            Self::Entrance => f.write_str("a door on the side that is nearest to a way"),
            Self::Side(DrivingSide::Left) => f.write_str("traffic drives on the left"),
            Self::Side(DrivingSide::Right) => f.write_str("traffic drives on the right"),
            Self::TurnLanes => f.write_str("no marks on lanes: those given are of another number of lanes"),
            Self::SharedLane => f.write_str("a narrow lane for each direction: there is one for both"),
            Self::ContraFlow => f.write_str("a strip for bicycles that go against the one-way street"),
            Self::MiddleLane => f.write_str("a divider: the lane in the middle is for those who turn"),
            Self::Edge => f.write_str("the map ends here"),
            Self::SignalAt(node) => write!(f, "the signal is that of the junction at node {node}"),
            Self::Links(1) => f.write_str("a path from the crossing to the pavement that is mapped apart"),
            Self::Links(_) => f.write_str("paths from the crossing to the pavements that are mapped apart"),
            Self::NoLights => f.write_str("marks: the junction beside the crossing has no lights"),
            Self::CrossingOf(node) => {
                write!(f, "marks: the crossing's lights are those of the junction at node {node}")
            }
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
    /// It lies below the ground, and the map has the surface.
    Underground,
    /// Nobody whom the map knows may use it.
    NobodyMayUse,
    /// Nodes or members of it are not in the file.
    CutOff,
    /// The map has it in part: other nodes or members of it are not in the file.
    Shortened,
    /// It has no length or no area, or lies across itself.
    NoShape,
    /// Members of it close no ring, or are named twice.
    OpenRing,
    /// Ways are part of more areas than those of a map.
    NamedTooOften,
    /// A hole of it lies outside of its areas.
    HoleOutside,
    /// It lies within a junction that was made of several nodes.
    WithinJunction,
    /// The map has it but for what lies within a junction that was made of several nodes.
    PartlyWithinJunction,
    /// A restriction of turns that no pair of roads fits.
    NoSuchTurn,
    /// A restriction of turns that holds at some times only.
    AtTimes,
    /// A restriction of turns for users whom the map does not know.
    OtherUsers,
    /// A signal or sign with no junction ahead.
    NoJunction,
    /// A crossing with no pavement or path on one of its sides: nobody comes to it.
    NobodyCrosses,
    /// The map has it without the pavement around the island of a ring, to which nobody crosses.
    IslandPavement,
    /// A sign on a junction of equal streets, or on one that nobody comes to.
    NoArm,
    /// The map has no use for it.
    NoUse,
    /// More ways meet at its end than a junction takes.
    TooManyMeet,
    /// Another element with its number came before it in the file.
    Repeated,
    /// It is further from the middle of the map than a map reaches.
    TooFar,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotThere => "planned, being built, or no longer there",
            Self::Indoors => "indoors",
            Self::Underground => "below the ground",
            Self::NobodyMayUse => "nobody may use it",
            Self::CutOff => "nodes or members are not in the file",
            Self::Shortened => "in part: some nodes or members are not in the file",
            Self::NoShape => "without length or area",
            Self::OpenRing => "in part: members close no ring",
            Self::NamedTooOften => "its ways are part of too many areas",
            Self::HoleOutside => "in part: a hole lies outside of its areas",
            Self::WithinJunction => "within a junction of several nodes",
            Self::PartlyWithinJunction => "in part: without what lies within a junction of several nodes",
            Self::NoSuchTurn => "no turn fits",
            Self::AtTimes => "holds at some times only",
            Self::OtherUsers => "for users whom the map does not know",
            Self::NoJunction => "a signal or sign with no junction ahead",
            Self::NobodyCrosses => "a crossing without a pavement or path on each side",
            Self::IslandPavement => "in part: without the pavement around the island of a ring",
            Self::NoArm => "a sign on a junction of equal streets: nobody knows for whom",
            Self::NoUse => "no use for it",
            Self::TooManyMeet => "too many ways meet",
            Self::Repeated => "another element has its number",
            Self::TooFar => "too far from the middle of the map",
        })
    }
}

/// The account of an import, in the order of the elements. Each element with tags is in the map, or in [`Self::dropped`]. Each
/// tag of an element in the map was gone by, or is in [`Self::ignored`] or [`Self::unread`].
///
/// Crossings by rule are guessed when the map is built: [`RoadCrossing::guessed`](crate::RoadCrossing::guessed) tells which.
///
/// ```
/// use vc_map::osm::{Element, Guessed, ImportOptions, OsmData, Reason};
/// let file = br#"<osm version="0.6">
///   <node id="1" lat="48.1000" lon="11.5000"/>
///   <node id="2" lat="48.1010" lon="11.5000"/>
///   <way id="7"><nd ref="1"/><nd ref="2"/>
///     <tag k="highway" v="residential"/><tag k="lanes" v="many"/><tag k="mood" v="fair"/></way>
///   <way id="8"><nd ref="1"/><nd ref="2"/><tag k="highway" v="proposed"/></way>
/// </osm>"#;
/// let (_, report) = OsmData::from_xml(file)?.draft(&ImportOptions::default())?;
/// assert!(report.guessed.contains(&(Element::Way(7), Guessed::Lanes(2))));
/// assert_eq!(report.dropped, [(Element::Way(8), Reason::NotThere)]);
/// assert_eq!(report.ignored, [(Element::Way(7), "lanes=many".to_owned())]);
/// assert_eq!(report.unread.get("mood"), Some(&1));
/// # Ok::<(), vc_map::osm::OsmError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct ImportReport {
    /// Values of the whole map that a rule gave.
    pub general: Vec<Guessed>,
    /// Values that a rule gave.
    pub guessed: Vec<(Element, Guessed)>,
    /// Elements that the map lacks, or parts of them.
    pub dropped: Vec<(Element, Reason)>,
    /// Tags, as `key=value`, of elements in the map for whose key there are rules, and whose value none of them could use.
    pub ignored: Vec<(Element, String)>,
    /// Keys of tags of elements in the map for which there is no rule, with the number of such tags.
    pub unread: BTreeMap<String, usize>,
}

impl ImportReport {
    pub(super) fn guess(&mut self, element: Element, guessed: Guessed) {
        self.guessed.push((element, guessed));
    }

    pub(super) fn drop(&mut self, element: Element, reason: Reason) {
        self.dropped.push((element, reason));
    }

    /// Sorts the account, and lists every element and tag that nobody had a use for.
    pub(super) fn close(&mut self, source: &Source<'_>, room: &mut Room) -> Result<(), Full> {
        source.repeated.iter().for_each(|element| self.drop(*element, Reason::Repeated));
        let within = self.dropped.iter_mut().filter(|(_, reason)| *reason == Reason::WithinJunction);
        let kept = within.filter(|(element, _)| matches!(element, Element::Way(_)) && source.is_kept(*element));
        kept.for_each(|(_, reason)| *reason = Reason::PartlyWithinJunction);
        self.dropped.sort();
        self.dropped.dedup();
        self.guessed.sort_by_key(|(element, _)| *element);
        let nodes = source.nodes.iter().map(|node| (Element::Node(node.id), source.node_tags(node)));
        let ways = source.ways.iter().map(|way| (Element::Way(way.id), source.way_tags(way)));
        let relations = source.relations.iter().map(|r| (Element::Relation(r.id), source.relation_tags(r)));
        let mut lost = Vec::new();
        for (element, tags) in nodes.chain(ways).chain(relations).filter(|(_, tags)| !tags.is_empty()) {
            if source.is_kept(element) {
                self.unused(element, tags, room)?;
            } else if self.dropped.binary_search_by_key(&element, |(dropped, _)| *dropped).is_err() {
                lost.push((element, Reason::NoUse));
            }
        }
        self.dropped.extend(lost);
        self.dropped.sort();
        Ok(())
    }

    fn unused(&mut self, element: Element, tags: Tags<'_>, room: &mut Room) -> Result<(), Full> {
        for (key, value, made) in tags.uses() {
            match made {
                Use::Unread => *self.unread.entry(key.to_owned()).or_default() += 1,
                Use::Asked => {
                    let tag = format!("{key}={value}");
                    room.take(size_of::<(Element, String)>() + tag.len())?;
                    self.ignored.push((element, tag));
                }
                Use::Used => {}
            }
        }
        Ok(())
    }
}

/// A line for each guess, each element that was dropped, each tag that was ignored, and each key for which there is no rule.
impl fmt::Display for ImportReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.general.iter().try_for_each(|guessed| writeln!(f, "guessed  map: {guessed}"))?;
        self.guessed.iter().try_for_each(|(element, guessed)| writeln!(f, "guessed  {element}: {guessed}"))?;
        self.dropped.iter().try_for_each(|(element, reason)| writeln!(f, "dropped  {element}: {reason}"))?;
        self.ignored.iter().try_for_each(|(element, tag)| writeln!(f, "ignored  {element}: {tag}"))?;
        self.unread.iter().try_for_each(|(key, count)| writeln!(f, "unread   {key}: {count} tags"))
    }
}

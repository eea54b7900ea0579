//! The facts that nodes of streets tell: lights, crossings, stop signs.

use std::collections::{BTreeMap, BTreeSet};

use super::network::{Network, Part};
use super::street::access;
use super::tags::Tags;
use super::{Guessed, ImportReport};
use crate::{CrossingKind, SignKind, Users};

/// A signal at most so far from a lit crossing stands at its stop line, metres.
const STOP_LINE: f64 = 8.0;

/// The facts that a node of a street tells.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Marks {
    /// Lights for vehicles.
    pub(super) signals: bool,
    /// Whether they are for those only who come along the road, or against it.
    pub(super) forward_only: Option<bool>,
    /// Whether they stand at its stop line, before a crossing.
    pub(super) stop_line: bool,
    /// A crossing.
    pub(super) crossing: Option<CrossingKind>,
    pub(super) island: bool,
    /// A sign by which one gives way.
    pub(super) sign: Option<SignKind>,
    /// Whether it is for those only who come along the road, or against it.
    pub(super) sign_along: Option<bool>,
    /// A junction at which everybody stops.
    pub(super) all_stop: bool,
    /// A junction that is gone around.
    pub(super) round: bool,
    /// The vehicles that something stands in the way of.
    pub(super) closed: Users,
}

impl Marks {
    /// Whether a street is cut here.
    pub(super) fn cuts(&self) -> bool {
        self.crossing.is_some() || self.signals || !self.closed.is_empty()
    }
}

impl Network<'_> {
    pub(super) fn mark(&mut self, parts: &[Part]) {
        let source = self.source;
        for part in parts {
            let street = &self.streets[part.street];
            let way = part.way.and_then(|way| source.way(way)).map(|way| source.way_tags(way));
            let along = way.filter(|tags| tags.is("footway", "crossing"));
            let along_kind = along.and_then(|tags| crossing(tags, true));
            for node in &part.nodes {
                let Some(tags) = source.nodes.get(*node as usize).map(|node| source.node_tags(node)) else { continue };
                if tags.is_empty() && along.is_none() {
                    continue;
                }
                let marks = self.marks.entry(*node).or_default();
                if street.class.is_street() {
                    vehicles(marks, tags, street.reversed);
                    marks.closed = marks.closed | barrier(tags, way);
                }
                marks.crossing = [marks.crossing, crossing(tags, false), along_kind].into_iter().flatten().min();
                marks.island |= tags.is("crossing:island", "yes");
            }
        }
    }
}

impl Network<'_> {
    /// Gives the signals that stand at the stop lines of crossings to these: what lies between the two is no road.
    pub(super) fn join_stop_lines(&mut self, parts: &[Part], report: &mut ImportReport) {
        let mut walked = BTreeSet::new();
        let streets = |part: &&Part| self.streets[part.street].class.is_street();
        for part in parts.iter().filter(|part| !streets(part)) {
            walked.extend(part.nodes.iter().copied());
        }
        // Where streets meet it is theirs.
        let mut arms: BTreeMap<u32, u32> = BTreeMap::new();
        for nodes in parts.iter().filter(streets).map(|part| &part.nodes) {
            nodes.iter().for_each(|node| *arms.entry(*node).or_default() += 2);
            nodes.first().into_iter().chain(nodes.last()).for_each(|end| *arms.entry(*end).or_default() -= 1);
        }
        let meet = |node: &u32| arms.get(node).is_some_and(|count| *count > 2);
        let mut lines: BTreeMap<u32, u32> = BTreeMap::new();
        for part in parts.iter().filter(streets) {
            for (place, node) in part.nodes.iter().enumerate() {
                let marks = self.marks.get(node).copied().unwrap_or_default();
                if !marks.signals || marks.crossing.is_some() || walked.contains(node) || meet(node) {
                    continue;
                }
                let found = self.crossing_beside(&part.nodes, place, meet);
                found.into_iter().for_each(|crossing| _ = lines.insert(*node, crossing));
            }
        }
        for (line, crossing) in lines {
            let Some(id) = self.id(crossing) else { continue };
            let Some(marks) = self.marks.get_mut(&line) else { continue };
            let forward_only = marks.forward_only;
            marks.signals = false;
            let marks = self.marks.entry(crossing).or_default();
            marks.forward_only = if marks.signals && marks.forward_only != forward_only { None } else { forward_only };
            (marks.signals, marks.stop_line) = (true, true);
            let element = self.element(line);
            self.source.keep(element);
            report.guess(element, Guessed::SignalAt(id));
        }
    }

    /// The lit crossing of a street that is nearest to one of its nodes, at most some metres along it and before streets meet.
    fn crossing_beside(&self, nodes: &[u32], place: usize, meet: impl Fn(&u32) -> bool) -> Option<u32> {
        let lit = |node: &u32| self.marks.get(node).is_some_and(|marks| marks.crossing == Some(CrossingKind::Signals));
        let mut found: Option<(f64, u32)> = None;
        for onward in [true, false] {
            let (mut at, mut length) = (place, 0.0);
            while let Some(next) = if onward { at.checked_add(1) } else { at.checked_sub(1) } {
                let Some(node) = nodes.get(next) else { break };
                length += (self.point(*node) - self.point(nodes[at])).norm();
                at = next;
                if length > STOP_LINE {
                    break;
                }
                if lit(node) {
                    found = found.filter(|(nearest, _)| *nearest <= length).or(Some((length, *node)));
                }
                if lit(node) || meet(node) {
                    break;
                }
            }
        }
        found.map(|(_, node)| node)
    }
}

/// The facts for vehicles of a node.
fn vehicles(marks: &mut Marks, tags: Tags<'_>, reversed: bool) {
    if tags.is("highway", "traffic_signals") {
        let told = along(tags, "traffic_signals:direction", reversed);
        // Ways of different directions may meet at a signal.
        marks.forward_only = if marks.signals && marks.forward_only != told { None } else { told };
        marks.signals = true;
    }
    let sign = tags.read("highway", |word| match word {
        "give_way" => Some(SignKind::GiveWay),
        "stop" => Some(SignKind::Stop),
        _ => None,
    });
    if sign.is_some() {
        let told = along(tags, "direction", reversed);
        marks.sign_along = if marks.sign.is_some() && marks.sign_along != told { None } else { told };
        marks.sign = sign;
    }
    marks.all_stop |= tags.is("stop", "all");
    marks.round |= tags.is("highway", "mini_roundabout");
}

/// Whether a sign or signal is for those who come along a road, or against it; `None` for both.
fn along(tags: Tags<'_>, key: &str, reversed: bool) -> Option<bool> {
    let told = tags.read(key, |word| match word {
        "forward" => Some(Some(!reversed)),
        "backward" => Some(Some(reversed)),
        "both" => Some(None),
        _ => None,
    });
    told.flatten()
}

/// Gates and their like.
const GATES: &str = "gate|lift_gate|swing_gate|sliding_gate|wicket_gate";

/// The vehicles that a barrier stops: gates and bollards those with more than two wheels, if no key of access lets them in, be it one
/// of the way that a gate stands on; gates that nobody opens all vehicles.
fn barrier(tags: Tags<'_>, way: Option<Tags<'_>>) -> Users {
    let motor = Users::CAR | Users::BUS;
    if tags.is("barrier", "bollard|block|cycle_barrier|motorcycle_barrier|jersey_barrier|planter") {
        let opens = ["motorcar", "motor_vehicle", "vehicle", "access"].iter().any(|key| tags.yes(key));
        return if opens { Users::NONE } else { motor };
    }
    if !tags.is("barrier", GATES) {
        return Users::NONE;
    }
    if !(tags.yes("locked") || tags.is("access", "no")) {
        let keys = ["motorcar", "motor_vehicle", "vehicle", "access"];
        let said = |tags: Tags<'_>| keys.iter().find_map(|key| tags.read(key, access));
        let opens = said(tags).or_else(|| said(way?)).unwrap_or(false);
        return if opens { Users::NONE } else { motor };
    }
    let opens = |keys: &[&str]| keys.iter().any(|key| tags.is(key, "yes|designated|permissive"));
    let cars = if opens(&["motorcar", "motor_vehicle", "vehicle"]) { motor } else { Users::NONE };
    let bicycles = if opens(&["bicycle", "vehicle"]) { Users::BICYCLE } else { Users::NONE };
    Users::TRAFFIC.without(cars | bicycles)
}

/// The kind of a crossing; `None` if there is none.
pub(super) fn crossing(tags: Tags<'_>, there: bool) -> Option<CrossingKind> {
    if !(there || tags.is("highway", "crossing") || tags.has("crossing")) {
        return None;
    }
    let said = tags.read("crossing", |value| match value {
        "no" => Some(None),
        lights if lights.contains("traffic_signals") => Some(Some(CrossingKind::Signals)),
        "unmarked" | "informal" => Some(Some(CrossingKind::Unmarked)),
        _ => Some(Some(CrossingKind::Marked)),
    });
    let drawn = || if tags.yes("crossing:markings") { CrossingKind::Marked } else { CrossingKind::Unmarked };
    let kind = said.unwrap_or_else(|| Some(drawn()))?;
    Some(if tags.is("crossing:signals", "yes") { CrossingKind::Signals } else { kind })
}

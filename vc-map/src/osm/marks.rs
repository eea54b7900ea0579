//! The facts that nodes of streets tell: lights, crossings, stop signs.

use super::network::{Network, Part};
use super::tags::Tags;
use crate::{CrossingKind, Users};

/// The facts that a node of a street tells.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Marks {
    /// Lights for vehicles.
    pub(super) signals: bool,
    /// Whether they are for those only who come along the road, or against it.
    pub(super) forward_only: Option<bool>,
    /// A crossing.
    pub(super) crossing: Option<CrossingKind>,
    pub(super) island: bool,
    /// A junction at which everybody stops.
    pub(super) all_stop: bool,
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
            let tags = source.way(part.way).map(|way| source.way_tags(way));
            let along = tags.filter(|tags| tags.is("footway", "crossing"));
            let along_kind = along.and_then(|tags| crossing(tags, true));
            for node in &part.nodes {
                let tags = source.node_tags(&source.nodes[*node as usize]);
                if tags.is_empty() && along.is_none() {
                    continue;
                }
                let marks = self.marks.entry(*node).or_default();
                if street.class.is_street() {
                    vehicles(marks, tags, street.reversed);
                }
                marks.crossing = [marks.crossing, crossing(tags, false), along_kind].into_iter().flatten().min();
                marks.island |= tags.is("crossing:island", "yes");
            }
        }
    }
}

/// The facts for vehicles of a node.
fn vehicles(marks: &mut Marks, tags: Tags<'_>, reversed: bool) {
    if tags.is("highway", "traffic_signals") {
        let told = tags.read("traffic_signals:direction", |word| match word {
            "forward" => Some(Some(!reversed)),
            "backward" => Some(Some(reversed)),
            "both" => Some(None),
            _ => None,
        });
        let told = told.flatten();
        // Ways of different directions may meet at a signal.
        marks.forward_only = if marks.signals && marks.forward_only != told { None } else { told };
        marks.signals = true;
    }
    marks.all_stop |= tags.is("stop", "all");
    marks.closed = marks.closed | barrier(tags);
}

/// The vehicles that a barrier stops: bollards and their like those with more than two wheels, gates that nobody opens all of them.
/// Other gates are opened by those who have something to do behind them.
fn barrier(tags: Tags<'_>) -> Users {
    let motor = Users::CAR | Users::BUS;
    if tags.is("barrier", "bollard|block|cycle_barrier|motorcycle_barrier|jersey_barrier|planter") {
        let opens = ["motorcar", "motor_vehicle", "vehicle", "access"].iter().any(|key| tags.yes(key));
        return if opens { Users::NONE } else { motor };
    }
    let shut = tags.has("barrier") && (tags.is("locked", "yes") || tags.is("access", "no"));
    if !(shut && tags.is("barrier", "gate|lift_gate|swing_gate|sliding_gate|wicket_gate")) {
        return Users::NONE;
    }
    let opens = |keys: &[&str]| keys.iter().any(|key| tags.is(key, "yes|designated|permissive"));
    let cars = if opens(&["motorcar", "motor_vehicle", "vehicle"]) { motor } else { Users::NONE };
    let bicycles = if opens(&["bicycle", "vehicle"]) { Users::BICYCLE } else { Users::NONE };
    Users::TRAFFIC.without(cars | bicycles)
}

/// The kind of a crossing; `None` if there is none.
fn crossing(tags: Tags<'_>, there: bool) -> Option<CrossingKind> {
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

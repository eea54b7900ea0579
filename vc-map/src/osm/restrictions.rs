//! Restrictions of turns.

use std::collections::{BTreeMap, BTreeSet};

use super::data::Relation;
use super::network::Network;
use super::tags::Tags;
use super::{Element, ImportReport, Reason};
use crate::{JunctionId, MapDraft, Point, RoadDraft, RoadId, TurnBan, Users};

/// Keys of restrictions, and the users for whom they hold.
const KEYS: [(&str, Users); 6] = [
    ("restriction", Users::TRAFFIC),
    ("restriction:motor_vehicle", MOTOR),
    ("restriction:motorcar", Users::CAR),
    ("restriction:bus", Users::BUS),
    ("restriction:psv", Users::BUS),
    ("restriction:bicycle", Users::BICYCLE),
];
const MOTOR: Users = Users::TRAFFIC.without(Users::BICYCLE);

/// Turns relations of restrictions into bans; those that hold at some times only are left out. Bans that
/// are there stay.
pub(super) fn bans(network: &Network<'_>, draft: &mut MapDraft, report: &mut ImportReport) {
    let source = network.source;
    let (junctions, roads) = (by_node(draft), by_end(draft));
    let mut bans: BTreeMap<(RoadId, JunctionId, RoadId), Users> = BTreeMap::new();
    for relation in &source.relations {
        let tags = source.relation_tags(relation);
        if !tags.is("type", "restriction") {
            continue;
        }
        let element = Element::Relation(relation.id);
        match restriction(network, &junctions, relation, tags) {
            Err(reason) => report.drop(element, reason),
            Ok(found) => {
                let ends = roads.get(&found.at).map(Vec::as_slice).unwrap_or_default();
                let turns = found.turns(draft, ends);
                if turns.is_empty() {
                    report.drop(element, Reason::NoSuchTurn);
                } else {
                    source.keep(element);
                }
                for (from, to) in turns {
                    let users = bans.entry((from, found.at, to)).or_default();
                    *users = *users | found.users;
                }
            }
        }
    }
    draft.bans.extend(bans.into_iter().map(|((from, at, to), users)| TurnBan { from, at, to, users }));
}

/// A restriction whose members are known.
struct Restriction<'a> {
    kind: &'a str,
    users: Users,
    at: JunctionId,
    /// The ways that one comes from, and those that one goes on with.
    ways: [Vec<i64>; 2],
}

fn restriction<'a>(
    network: &Network<'_>,
    junctions: &BTreeMap<i64, JunctionId>,
    relation: &Relation,
    tags: Tags<'a>,
) -> Result<Restriction<'a>, Reason> {
    let source = network.source;
    let times = ["hour_on", "hour_off", "day_on", "day_off", "restriction:conditional"];
    let known = KEYS.iter().find_map(|(key, users)| Some((tags.text(key)?, *users)));
    if times.iter().any(|key| tags.has(key)) {
        return Err(Reason::AtTimes);
    }
    let (kind, users) = known.ok_or(Reason::OtherUsers)?;
    let users = users.without(tags.read("except", exempt).unwrap_or_default());
    if users.is_empty() {
        return Err(Reason::OtherUsers);
    }
    let members = |role: &str| -> Vec<Element> {
        let members = source.members(relation).iter().filter(|member| source.role(**member) == role);
        members.map(|member| member.element).collect()
    };
    let ways = ["from", "to"].map(|role| ways(&members(role)));
    let at = via(network, &members("via")).and_then(|id| junctions.get(&id).copied()).ok_or(Reason::CutOff)?;
    if ways.iter().any(Vec::is_empty) {
        return Err(Reason::CutOff);
    }
    Ok(Restriction { kind, users, at, ways })
}

/// Those for whom a restriction does not hold.
fn exempt(text: &str) -> Option<Users> {
    let users = text.split(';').map(|word| match word.trim() {
        "motorcar" => Users::CAR,
        "motor_vehicle" => MOTOR,
        "bus" | "psv" => Users::BUS,
        "bicycle" => Users::BICYCLE,
        _ => Users::NONE,
    });
    Some(users.fold(Users::NONE, |all, users| all | users)).filter(|users| !users.is_empty())
}

fn ways(members: &[Element]) -> Vec<i64> {
    let way = |member: &Element| if let Element::Way(id) = member { Some(*id) } else { None };
    members.iter().filter_map(way).collect()
}

/// The node over which a restriction leads; of a way, one within its junction.
fn via(network: &Network<'_>, members: &[Element]) -> Option<i64> {
    let source = network.source;
    match members.first()? {
        Element::Node(id) => Some(*id),
        Element::Way(id) => {
            let refs = source.refs(source.way(*id)?);
            let meets = |id: &&i64| source.near(**id).is_some_and(|node| network.at.contains_key(&node));
            refs.iter().find(meets).copied()
        }
        Element::Relation(_) => None,
    }
}

fn by_node(draft: &MapDraft) -> BTreeMap<i64, JunctionId> {
    let nodes = draft.junctions.iter().enumerate();
    nodes.flat_map(|(index, junction)| junction.source.iter().map(move |id| (*id, JunctionId::of(index)))).collect()
}

fn by_end(draft: &MapDraft) -> BTreeMap<JunctionId, Vec<RoadId>> {
    let mut roads: BTreeMap<JunctionId, Vec<RoadId>> = BTreeMap::new();
    for (index, road) in draft.roads.iter().enumerate() {
        for junction in BTreeSet::from([road.from, road.to]) {
            roads.entry(junction).or_default().push(RoadId::of(index));
        }
    }
    roads
}

impl Restriction<'_> {
    /// The turns that it takes away, among the roads at its junction: some, or all others if only some are allowed.
    fn turns(&self, draft: &MapDraft, ends: &[RoadId]) -> Vec<(RoadId, RoadId)> {
        let road = |id: &RoadId| &draft.roads[id.index()];
        let [from, to] = &self.ways;
        let is = |id: &RoadId, ways: &[i64]| road(id).source.iter().any(|way| ways.contains(way));
        let comes = |id: &&RoadId| {
            let road = road(id);
            is(id, from) && road.section.users(road.to == self.at).any(Users::TRAFFIC)
        };
        let mut turns = Vec::new();
        for one in ends.iter().filter(comes) {
            let others = || ends.iter().filter(|other| *other != one && road(other).class.is_street());
            let named = |other: &&RoadId| is(other, to);
            if self.kind.starts_with("only_") {
                if others().any(|other| named(&other)) {
                    turns.extend(others().filter(|other| !named(other)).map(|other| (*one, *other)));
                }
            } else if self.kind.starts_with("no_") {
                let bends = |other: &&RoadId| bends_as(self.kind, road(one), road(other), self.at);
                turns.extend(others().filter(named).filter(bends).map(|other| (*one, *other)));
            }
        }
        turns
    }
}

/// Whether a turn bends to the side that a restriction names, so that ways which go on over the junction lose that turn only.
fn bends_as(kind: &str, from: &RoadDraft, to: &RoadDraft, at: JunctionId) -> bool {
    let away = |road: &RoadDraft| {
        let count = road.line.len();
        let (near, far) = if road.from == at { (0, 1) } else { (count - 1, count - 2) };
        Point::from(road.line[far]) - Point::from(road.line[near])
    };
    let (come, go) = (-away(from).normalize(), away(to).normalize());
    let side = come.perp(&go);
    match kind {
        "no_left_turn" => side > -0.2,
        "no_right_turn" => side < 0.2,
        "no_straight_on" => come.dot(&go) > 0.0,
        "no_u_turn" => come.dot(&go) < 0.0,
        _ => true,
    }
}

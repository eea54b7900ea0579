//! Restrictions of turns.

use std::collections::BTreeSet;

use super::network::Network;
use super::{Element, ImportReport, OsmData, Reason};
use crate::{JunctionId, MapDraft, Point, RoadDraft, RoadId, TurnBan, Users};

/// Turns relations of restrictions into bans; those with exceptions for cars or with times are passed over.
pub(super) fn bans(data: &OsmData, network: &Network<'_>, draft: &mut MapDraft, report: &mut ImportReport) {
    let junctions = by_node(draft);
    let roads = by_end(draft);
    let mut bans = BTreeSet::new();
    for relation in &data.relations {
        let tags = data.relation_tags(relation);
        if !tags.is("type", "restriction") {
            continue;
        }
        let kind = tags.get("restriction").or_else(|| tags.get("restriction:motorcar")).unwrap_or_default();
        let members = |role: &str| -> Vec<Element> {
            data.members(relation)
                .iter()
                .filter(|member| data.role(**member) == role)
                .map(|member| member.element)
                .collect()
        };
        let exempt = tags.get("except").is_some_and(|text| text.split(';').any(|word| word.trim() == "motorcar"));
        let found = via(data, network, &members("via")).and_then(|id| junctions.get(&id).copied()).filter(|_| !exempt);
        let (from, to) = (way(&members("from")), way(&members("to")));
        let (Some(at), Some(from), Some(to)) = (found, from, to) else {
            report.drop(Element::Relation(relation.id), if exempt { Reason::NoUse } else { Reason::CutOff });
            continue;
        };
        let before = bans.len();
        let ends = roads.get(&at).map(Vec::as_slice).unwrap_or_default();
        add(draft, ends, at, (from, to), kind, &mut bans);
        if bans.len() == before {
            report.drop(Element::Relation(relation.id), Reason::NoSuchTurn);
        }
    }
    draft.bans = bans.into_iter().collect();
}

fn way(members: &[Element]) -> Option<i64> {
    members.iter().find_map(|member| match member {
        Element::Way(id) => Some(*id),
        _ => None,
    })
}

/// The node over which a restriction leads; of a way, one within its junction.
fn via(data: &OsmData, network: &Network<'_>, members: &[Element]) -> Option<i64> {
    match members.first()? {
        Element::Node(id) => Some(*id),
        Element::Way(id) => {
            let refs = data.refs(data.way(*id)?);
            let meets = |id: &&i64| data.node(**id).is_some_and(|node| network.at.contains_key(&(node as u32)));
            refs.iter().find(meets).copied()
        }
        Element::Relation(_) => None,
    }
}

fn by_node(draft: &MapDraft) -> std::collections::BTreeMap<i64, JunctionId> {
    let nodes = draft.junctions.iter().enumerate();
    nodes.flat_map(|(index, junction)| junction.source.iter().map(move |id| (*id, JunctionId::of(index)))).collect()
}

fn by_end(draft: &MapDraft) -> std::collections::BTreeMap<JunctionId, Vec<RoadId>> {
    let mut roads: std::collections::BTreeMap<JunctionId, Vec<RoadId>> = std::collections::BTreeMap::new();
    for (index, road) in draft.roads.iter().enumerate() {
        for junction in BTreeSet::from([road.from, road.to]) {
            roads.entry(junction).or_default().push(RoadId::of(index));
        }
    }
    roads
}

/// Adds the bans of a restriction: one turn, or every other if only one is allowed.
fn add(
    draft: &MapDraft,
    ends: &[RoadId],
    at: JunctionId,
    (from, to): (i64, i64),
    kind: &str,
    bans: &mut BTreeSet<TurnBan>,
) {
    let road = |id: &RoadId| &draft.roads[id.index()];
    let comes = |id: &&RoadId| {
        let road = road(id);
        road.source == from && road.section.users(road.to == at).any(Users::TRAFFIC)
    };
    let drives = |id: &&RoadId| road(id).class.is_street();
    for one in ends.iter().filter(comes) {
        let fits = |other: &&RoadId| road(other).source == to && other != &one;
        if kind.starts_with("only_") {
            let others = ends.iter().filter(drives).filter(|other| !fits(other) && other != &one);
            if ends.iter().any(|other| fits(&other)) {
                bans.extend(others.map(|other| TurnBan { from: *one, at, to: *other }));
            }
        } else if kind.starts_with("no_") {
            let named = |other: &&RoadId| bends_as(kind, road(one), road(other), at);
            bans.extend(ends.iter().filter(fits).filter(named).map(|other| TurnBan { from: *one, at, to: *other }));
        }
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
        _ => true,
    }
}

//! Give-way and stop signs: each belongs to the arm by which one comes to the junction ahead.

use std::collections::BTreeMap;

use super::clusters::degree;
use super::emit::Emitter;
use super::marks::Marks;
use super::network::{Network, Piece};
use super::signals::{AHEAD, ahead, nearest};
use super::{Element, ImportReport, Reason};
use crate::{Control, JunctionId, RoadDraft, RoadId, SignDraft, SignKind, Users};

impl Emitter<'_> {
    /// Puts signs at the ends of roads. A junction all of whose roads have a stop sign is one at which everybody stops.
    pub(super) fn signs(&mut self, report: &mut ImportReport) {
        let between = between(self.network);
        for (node, marks) in &self.network.marks {
            let Some(kind) = marks.sign else { continue };
            let source = self.network.id(*node).unwrap_or_default();
            let found = junction(self, *node, marks, between.get(node).copied());
            let found = found.and_then(|found| Some((*self.ids.get(&self.clusters.of(found.node))?, found)));
            let Some((at, found)) = found else {
                report.drop(Element::Node(source), Reason::NoJunction);
                continue;
            };
            let roads = if *node == found.node { self.lesser(at, *node) } else { self.nearest(at, &found) };
            if roads.is_empty() {
                report.drop(Element::Node(source), Reason::NoArm);
                continue;
            }
            self.network.source.keep(Element::Node(source));
            self.draft.signs.extend(roads.into_iter().map(|road| SignDraft { at, road, kind, source }));
            if marks.all_stop {
                self.stop_all(at);
            }
        }
        self.stops_everywhere();
    }

    /// The streets by which one comes to a junction.
    fn incoming(&self, at: JunctionId, junction: u32) -> Vec<RoadId> {
        let comes = |road: &RoadDraft| {
            let open = |forward: bool| road.section.users(forward).any(Users::TRAFFIC);
            road.class.is_street() && ((road.to == at && open(true)) || (road.from == at && open(false)))
        };
        let roads = self.roads.get(&self.clusters.of(junction)).into_iter().flatten().copied();
        roads.filter(|road| comes(&self.draft.roads[road.index()])).collect()
    }

    /// The streets that are less important than another, for a sign on the junction itself.
    fn lesser(&self, at: JunctionId, junction: u32) -> Vec<RoadId> {
        let rank = |road: &RoadId| self.draft.roads[road.index()].class.rank();
        let roads = self.incoming(at, junction);
        let most = roads.iter().map(rank).max();
        roads.into_iter().filter(|road| Some(rank(road)) < most).collect()
    }

    /// The street by which one comes past a sign.
    fn nearest(&self, at: JunctionId, found: &Ahead) -> Vec<RoadId> {
        let point = self.network.point(found.behind);
        let roads = self.incoming(at, found.node).into_iter().map(|road| (self.away(road, &point), road));
        roads.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, road)| road).into_iter().collect()
    }

    fn stop_all(&mut self, at: JunctionId) {
        let control = &mut self.draft.junctions[at.index()].control;
        if *control == Control::Priority {
            *control = Control::AllWayStop;
        }
    }

    fn stops_everywhere(&mut self) {
        let stops = self.draft.signs.iter().filter(|sign| sign.kind == SignKind::Stop);
        let mut roads: BTreeMap<JunctionId, Vec<RoadId>> = BTreeMap::new();
        stops.for_each(|sign| roads.entry(sign.at).or_default().push(sign.road));
        let heads: Vec<(u32, JunctionId)> = self.ids.iter().map(|(head, id)| (*head, *id)).collect();
        for (head, at) in heads.into_iter().filter(|(_, at)| roads.contains_key(at)) {
            if self.incoming(at, head).iter().all(|road| roads[&at].contains(road)) {
                self.stop_all(at);
            }
        }
    }
}

/// The pieces that have signs between their ends.
fn between<'a>(network: &'a Network<'_>) -> BTreeMap<u32, &'a Piece> {
    let marked = |node: &u32| network.marks.get(node).is_some_and(|marks| marks.sign.is_some());
    let inner = |piece: &'a Piece| piece.nodes[1..piece.nodes.len() - 1].iter().map(move |node| (*node, piece));
    let streets = network.all().filter(|(_, piece)| network.street(piece).class.is_street());
    streets.flat_map(|(_, piece)| inner(piece)).filter(|(node, _)| marked(node)).collect()
}

/// The junction to which a sign belongs.
struct Ahead {
    node: u32,
    /// The sign's node, or the one before it on a way: those within a junction are on no road.
    behind: u32,
}

/// The junction to which a sign belongs: the nearest ahead.
fn junction(emitter: &Emitter<'_>, node: u32, marks: &Marks, on: Option<&Piece>) -> Option<Ahead> {
    let (network, clusters) = (emitter.network, emitter.clusters);
    let Some(piece) = on else {
        let here = degree(network, node) > 2 || clusters.is_junction(network, node);
        let found = if here { Some(node) } else { ahead(network, clusters, node, marks.sign_along) };
        return found.map(|found| Ahead { node: found, behind: node });
    };
    let directions = [true, false]
        .into_iter()
        .filter(|forward| network.drives(piece, *forward) && marks.sign_along.is_none_or(|along| along == *forward));
    let found = directions.filter_map(|forward| {
        let position = piece.nodes.iter().position(|other| *other == node)?;
        let (before, after) = (&piece.nodes[..=position], &piece.nodes[position..]);
        let behind = if forward { before.iter().nth_back(1) } else { after.get(1) }.copied()?;
        let part = if forward { after } else { before };
        let gone = network.line(part)?.length();
        let end = if forward { piece.last() } else { piece.first() };
        if clusters.is_junction(network, end) {
            return Some((gone, Ahead { node: end, behind }));
        }
        let other = |other: &Piece, along: bool| !std::ptr::eq(other, piece) && network.drives(other, along);
        let found = nearest(network, clusters, end, AHEAD - gone, other)?;
        Some((gone + found.length, Ahead { node: found.node, behind }))
    });
    let near = found.filter(|(gone, _)| *gone <= AHEAD);
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, ahead)| ahead)
}

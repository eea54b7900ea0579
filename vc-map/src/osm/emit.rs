//! From pieces and clusters to junctions, roads and crossings.

use std::collections::{BTreeMap, BTreeSet};

use super::clusters::Clusters;
use super::network::{Network, Piece};
use super::words::{Full, Room};
use super::{Element, Guessed, ImportReport, Reason};
use crate::size::Holds;
use crate::{
    Control, CrossingDraft, JunctionDraft, JunctionId, MapDraft, Point, RoadClass, RoadDraft, RoadId, TurnBan, Users,
};

/// A crossing lies on the arm whose road leaves the junction over its node, at most this far from the node, metres.
const ON_ARM: f64 = 6.0;

pub(super) fn emit(
    network: &Network<'_>,
    clusters: &Clusters,
    lit: &BTreeSet<u32>,
    draft: &mut MapDraft,
    room: &mut Room,
    report: &mut ImportReport,
) -> Result<(), Full> {
    let mut emitter = Emitter { network, clusters, ids: BTreeMap::new(), draft, roads: BTreeMap::new() };
    for (_, piece) in network.all() {
        let before = emitter.draft.roads.len();
        emitter.road(piece, lit, report);
        room.take(emitter.draft.roads[before..].iter().map(Holds::bytes).sum())?;
    }
    emitter.crossings(report);
    emitter.barriers(report);
    emitter.signs(report);
    emitter.edges(report);
    Ok(())
}

pub(super) struct Emitter<'a> {
    pub(super) network: &'a Network<'a>,
    pub(super) clusters: &'a Clusters,
    pub(super) ids: BTreeMap<u32, JunctionId>,
    pub(super) draft: &'a mut MapDraft,
    /// The roads that begin or end at each node.
    pub(super) roads: BTreeMap<u32, Vec<RoadId>>,
}

impl Emitter<'_> {
    fn junction(&mut self, node: u32, lit: &BTreeSet<u32>) -> JunctionId {
        let head = self.clusters.of(node);
        if let Some(id) = self.ids.get(&head) {
            return *id;
        }
        let members: Vec<u32> = self.clusters.members.get(&head).cloned().unwrap_or_else(|| vec![node]);
        // The nodes at which streets meet say where the middle is; crossings lie around it.
        let meets = |node: &&u32| super::clusters::degree(self.network, **node) > 2;
        let main: Vec<u32> = members.iter().filter(meets).copied().collect();
        let of = if main.is_empty() { &members } else { &main };
        let sum: nalgebra::Vector2<f64> = of.iter().map(|node| self.network.point(*node).coords).sum();
        let at = Point::from(sum / of.len() as f64);
        let mut marks = members.iter().filter_map(|node| self.network.marks.get(node));
        let control = match () {
            () if lit.contains(&head) => Control::Signals,
            () if marks.clone().any(|marks| marks.round) => Control::MiniRoundabout,
            () if marks.any(|marks| marks.all_stop) => Control::AllWayStop,
            () => Control::Priority,
        };
        let source: Vec<i64> = members.iter().filter_map(|node| self.network.id(*node)).collect();
        source.iter().for_each(|id| self.network.source.keep(Element::Node(*id)));
        let id = JunctionId::of(self.draft.junctions.len());
        self.draft.junctions.push(JunctionDraft { at: at.into(), control, source });
        self.ids.insert(head, id);
        id
    }

    fn road(&mut self, piece: &Piece, lit: &BTreeSet<u32>, report: &mut ImportReport) {
        let [first, last] = piece.ends();
        let mut drop = |reason| piece.ways.iter().for_each(|way| report.drop(Element::Way(*way), reason));
        let closed = self.clusters.of(first) == self.clusters.of(last);
        if closed && first != last && piece.length < 100.0 {
            return drop(Reason::WithinJunction);
        }
        // A way that comes back to its junction is two roads, which meet in its middle.
        if closed && piece.nodes.len() > 2 {
            let (before, after) = piece.nodes.split_at(piece.nodes.len() / 2);
            let middle = after[0];
            let before = before.iter().copied().chain([middle]).collect();
            for nodes in [before, after.to_vec()] {
                self.road(&Piece { nodes, ..piece.clone() }, lit, report);
            }
            return;
        }
        let ends = [self.junction(first, lit), self.junction(last, lit)];
        if ends[0] == ends[1] {
            return drop(Reason::WithinJunction);
        }
        if ends.iter().any(|end| self.arms(*end) >= crate::build::MOST_ARMS - 2) {
            return drop(Reason::TooManyMeet);
        }
        let id = self.add(piece, ends);
        for node in [first, last] {
            self.roads.entry(self.clusters.of(node)).or_default().push(id);
        }
    }

    /// Adds a road between two junctions.
    fn add(&mut self, piece: &Piece, ends: [JunctionId; 2]) -> RoadId {
        piece.ways.iter().for_each(|way| self.network.source.keep(Element::Way(*way)));
        let street = self.network.street(piece);
        let line = piece.nodes.iter().map(|node| self.network.point(*node).into()).collect();
        self.draft.roads.push(RoadDraft {
            from: ends[0],
            to: ends[1],
            line,
            class: street.class,
            name: street.name.clone(),
            section: street.section.clone(),
            layer: street.layer,
            structure: street.structure,
            roundabout: street.roundabout,
            slip: street.slip,
            private: street.private,
            source: piece.ways.clone(),
        });
        RoadId::of(self.draft.roads.len() - 1)
    }

    fn arms(&self, junction: JunctionId) -> usize {
        let source = self.draft.junctions[junction.index()].source.first();
        let head = source.and_then(|id| self.network.source.node(*id)).map(|node| self.clusters.of(node as u32));
        head.and_then(|head| self.roads.get(&head)).map_or(0, Vec::len)
    }

    /// Bollards, locked gates and their like: those whom they stop turn back there. Where several streets meet nobody knows between
    /// which they stand.
    fn barriers(&mut self, report: &mut ImportReport) {
        for (node, marks) in self.network.marks.iter().filter(|(_, marks)| !marks.closed.is_empty()) {
            let head = self.clusters.of(*node);
            let street = |road: &&RoadId| self.draft.roads[road.index()].class.is_street();
            let roads: Vec<RoadId> = self.roads.get(&head).into_iter().flatten().filter(street).copied().collect();
            let Some(at) = self.ids.get(&head).copied() else { continue };
            match (&roads[..], self.clusters.nodes(*node).len()) {
                ([one, other], 1) => {
                    let turns = [(*one, *other), (*other, *one)];
                    let ban = |(from, to)| TurnBan { from, at, to, users: marks.closed };
                    self.draft.bans.extend(turns.map(ban));
                }
                ([] | [_], 1) => {}
                _ => {
                    report.drop(self.network.element(*node), Reason::WithinJunction);
                }
            }
        }
    }

    /// The crossings at nodes of clusters: each over the street that leaves nearest to it. Those that no street leaves near are within
    /// the junction.
    fn crossings(&mut self, report: &mut ImportReport) {
        for (node, marks) in &self.network.marks {
            let (Some(kind), true) = (marks.crossing, self.network.at.contains_key(node)) else { continue };
            if self.network.streets_at(*node).next().is_none() {
                continue;
            }
            let head = self.clusters.of(*node);
            let Some(at) = self.ids.get(&head).copied() else { continue };
            let point = self.network.point(*node);
            let street = |road: &&RoadId| self.draft.roads[road.index()].class.is_street();
            let away = |road: &RoadId| self.away(*road, &point);
            let roads = self.roads.get(&head).into_iter().flatten().filter(street);
            let nearest = roads.map(|road| (away(road), *road)).min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let Some((_, road)) = nearest.filter(|(away, _)| *away < ON_ARM) else {
                report.drop(self.network.element(*node), Reason::WithinJunction);
                continue;
            };
            let source = self.network.id(*node).unwrap_or_default();
            self.draft.crossings.push(CrossingDraft { at, road, kind, island: marks.island, source });
        }
    }

    /// The distance of a road from a point, metres.
    pub(super) fn away(&self, road: RoadId, point: &Point) -> f64 {
        let line = crate::Polyline::new(self.draft.roads[road.index()].line.iter().copied());
        line.map_or(f64::INFINITY, |line| (line.project(point).point - point).norm())
    }

    /// Junctions at which the map ends: a single way leaves it there, or traffic comes from nowhere or has nowhere to go.
    fn edges(&mut self, report: &mut ImportReport) {
        for (head, roads) in &self.roads {
            let Some(id) = self.ids.get(head).copied() else { continue };
            let roads = roads.iter().map(|road| &self.draft.roads[road.index()]);
            let streets: Vec<&RoadDraft> = roads.clone().filter(|road| road.class.is_street()).collect();
            let seen = self.clusters.members.get(head).into_iter().flatten().any(|node| self.network.is_edge(*node));
            let cut = is_cut(&streets, id);
            let junction = &mut self.draft.junctions[id.index()];
            if streets.len() <= 1 && roads.count() <= 2 && seen {
                junction.control = Control::Edge;
            } else if cut && junction.control != Control::Signals {
                junction.control = Control::Edge;
                let source = junction.source.first().copied().unwrap_or_default();
                report.guess(Element::Node(source), Guessed::Edge);
            }
        }
    }
}

/// Whether streets end as none does but where a map was cut: all lead to a junction or all away from it, or a main street
/// ends.
fn is_cut(streets: &[&RoadDraft], at: JunctionId) -> bool {
    let drives = |away: bool| {
        streets.iter().any(|road| {
            // Along its line one drives away from its start and towards its end.
            let sides = [(true, road.from == at), (false, road.to == at)];
            let open = |forward: bool| road.section.users(forward).any(Users::CAR | Users::BUS);
            sides.into_iter().any(|(forward, starts)| starts && open(forward == away))
        })
    };
    let main = matches!(streets, [road] if road.class <= RoadClass::Tertiary);
    !streets.is_empty() && (main || !drives(true) || !drives(false))
}

//! Ways cut into pieces at the nodes where they meet.

use std::collections::BTreeMap;

use super::street::{Street, street};
use super::{Element, ImportReport, OsmData, Reason};
use crate::{CrossingKind, DrivingSide, Point, Polyline, RoadClass, Structure, Users};

/// The most pieces that meet at a node.
const MOST: usize = 12;
/// Nodes at which ways end are at the edge if the file's bounds are this near, metres.
const EDGE: f64 = 15.0;

/// A stretch of a way between two nodes at which something happens.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) way: i64,
    pub(super) street: usize,
    /// Positions of nodes, in the direction of the road.
    pub(super) nodes: Vec<u32>,
    pub(super) length: f64,
}

impl Piece {
    pub(super) fn first(&self) -> u32 {
        self.nodes[0]
    }

    pub(super) fn last(&self) -> u32 {
        self.nodes[self.nodes.len() - 1]
    }

    pub(super) fn ends(&self) -> [u32; 2] {
        [self.first(), self.last()]
    }
}

/// The fact that a node of a street tells.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Marks {
    /// Lights for vehicles.
    pub(super) signals: bool,
    /// Whether they are for those only who come along the way, or against it.
    pub(super) forward_only: Option<bool>,
    /// A crossing.
    pub(super) crossing: Option<CrossingKind>,
    pub(super) island: bool,
    /// A junction at which everybody stops.
    pub(super) all_stop: bool,
}

/// All roads of a file as pieces.
pub(super) struct Network<'a> {
    pub(super) data: &'a OsmData,
    pub(super) points: &'a [Point],
    pub(super) side: DrivingSide,
    pub(super) streets: Vec<Street>,
    /// Pieces; those that were merged into others are `None`.
    pub(super) pieces: Vec<Option<Piece>>,
    /// The pieces at each node.
    pub(super) at: BTreeMap<u32, Vec<usize>>,
    pub(super) marks: BTreeMap<u32, Marks>,
    /// Nodes at which ways leave the map.
    edges: BTreeMap<u32, ()>,
}

impl<'a> Network<'a> {
    pub(super) fn new(data: &'a OsmData, points: &'a [Point], side: DrivingSide, report: &mut ImportReport) -> Self {
        let mut network = Self {
            data,
            points,
            side,
            streets: Vec::new(),
            pieces: Vec::new(),
            at: BTreeMap::new(),
            marks: BTreeMap::new(),
            edges: BTreeMap::new(),
        };
        let parts = network.parts(report);
        network.separate_pavements(&parts);
        network.mark(&parts);
        network.cut(parts, report);
        network
    }

    /// The stretches of ways whose nodes are all in the file, with the number of their street.
    fn parts(&mut self, report: &mut ImportReport) -> Vec<(i64, usize, Vec<u32>)> {
        let mut parts = Vec::new();
        for way in &self.data.ways {
            let street = match street(way.id, self.data.way_tags(way), self.side, report) {
                Ok(street) => street,
                Err(reason) => {
                    reason.into_iter().for_each(|reason| report.drop(Element::Way(way.id), reason));
                    continue;
                }
            };
            let found = self.whole(self.data.refs(way), street.reversed);
            if found.is_empty() {
                report.drop(Element::Way(way.id), Reason::CutOff);
                continue;
            }
            let number = self.streets.len();
            self.streets.push(street);
            parts.extend(found.into_iter().map(|nodes| (way.id, number, nodes)));
        }
        parts
    }

    /// The runs of nodes that are in the file. Where a run breaks off, the map ends.
    fn whole(&mut self, refs: &[i64], reversed: bool) -> Vec<Vec<u32>> {
        let places: Vec<Option<u32>> = refs.iter().map(|id| self.data.node(*id).map(|at| at as u32)).collect();
        let mut runs: Vec<Vec<u32>> = Vec::new();
        for (index, run) in places.split(Option::is_none).enumerate() {
            let mut run: Vec<u32> = run.iter().copied().flatten().collect();
            run.dedup();
            let broken = places.iter().any(Option::is_none);
            if broken {
                let ends = [run.first().filter(|_| index > 0), run.last()];
                ends.into_iter().flatten().for_each(|node| _ = self.edges.insert(*node, ()));
            }
            if reversed {
                run.reverse();
            }
            if run.len() > 1 {
                runs.push(run);
            }
        }
        runs
    }

    pub(super) fn line(&self, nodes: &[u32]) -> Option<Polyline> {
        Polyline::new(nodes.iter().map(|node| self.points[*node as usize]))
    }

    /// The facts that nodes of streets tell: lights, crossings, stop signs.
    fn mark(&mut self, parts: &[(i64, usize, Vec<u32>)]) {
        for (way, street, nodes) in parts {
            let class = self.streets[*street].class;
            let crossing_way =
                self.data.way(*way).map(|way| self.data.way_tags(way)).filter(|tags| tags.is("footway", "crossing"));
            for node in nodes {
                let tags = self.data.node_tags(&self.data.nodes[*node as usize]);
                if tags.is_empty() && crossing_way.is_none() {
                    continue;
                }
                let marks = self.marks.entry(*node).or_default();
                if class.is_street() {
                    let lights = tags.is("highway", "traffic_signals");
                    marks.signals |= lights;
                    if lights {
                        marks.forward_only = tags.get("traffic_signals:direction").map(|word| word == "forward");
                    }
                    marks.all_stop |= tags.is("stop", "all");
                }
                let here = kind(tags.get("crossing"), tags.is("highway", "crossing") || tags.get("crossing").is_some());
                let along = crossing_way.and_then(|tags| kind(tags.get("crossing"), true));
                marks.crossing = [marks.crossing, here, along].into_iter().flatten().min();
                marks.island |= tags.is("crossing:island", "yes");
            }
        }
    }

    /// Cuts the parts where they meet, where they pass themselves, and at crossings and lights.
    fn cut(&mut self, parts: Vec<(i64, usize, Vec<u32>)>, report: &mut ImportReport) {
        let mut passes: BTreeMap<u32, u32> = BTreeMap::new();
        for (_, _, nodes) in &parts {
            for (index, node) in nodes.iter().enumerate() {
                let end = index == 0 || index + 1 == nodes.len();
                *passes.entry(*node).or_default() += if end { 2 } else { 1 };
            }
        }
        for (way, street, nodes) in parts {
            let class = self.streets[street].class;
            let special = |node: &u32| {
                let marked = self.marks.get(node).is_some_and(|marks| marks.crossing.is_some() || marks.signals);
                passes.get(node).is_some_and(|count| *count > 1) || (class.is_street() && marked)
            };
            let mut start = 0;
            let breaks: Vec<usize> =
                (1..nodes.len()).filter(|i| *i + 1 == nodes.len() || special(&nodes[*i])).collect();
            for end in breaks {
                self.add(way, street, &nodes[start..=end], report);
                start = end;
            }
        }
    }

    fn add(&mut self, way: i64, street: usize, nodes: &[u32], report: &mut ImportReport) {
        let Some(line) = self.line(nodes) else {
            return report.drop(Element::Way(way), Reason::NoShape);
        };
        let full = |node: &u32| self.at.get(node).is_some_and(|pieces| pieces.len() >= MOST);
        let piece = Piece { way, street, nodes: nodes.to_vec(), length: line.length() };
        if piece.ends().iter().any(full) {
            return report.drop(Element::Way(way), Reason::TooManyMeet);
        }
        let number = self.pieces.len();
        piece.ends().into_iter().for_each(|node| self.at.entry(node).or_default().push(number));
        self.pieces.push(Some(piece));
    }

    pub(super) fn street(&self, piece: &Piece) -> &Street {
        &self.streets[piece.street]
    }

    pub(super) fn all(&self) -> impl Iterator<Item = (usize, &Piece)> {
        self.pieces.iter().enumerate().filter_map(|(number, piece)| Some((number, piece.as_ref()?)))
    }

    /// The pieces at a node that vehicles on tyres use.
    pub(super) fn streets_at(&self, node: u32) -> impl Iterator<Item = (usize, &Piece)> {
        let pieces = self
            .at
            .get(&node)
            .into_iter()
            .flatten()
            .filter_map(|number| Some((*number, self.pieces[*number].as_ref()?)));
        pieces.filter(|(_, piece)| self.street(piece).class.is_street())
    }

    /// Whether the map ends at a node.
    pub(super) fn is_edge(&self, node: u32) -> bool {
        let near = |[south, west, north, east]: [f64; 4]| {
            let [latitude, longitude] = self.data.nodes[node as usize].degrees();
            let margin = EDGE / 111_000.0;
            latitude < south + margin
                || latitude > north - margin
                || longitude < west + margin
                || longitude > east - margin
        };
        self.edges.contains_key(&node) || self.data.bounds.is_some_and(near)
    }

    /// Joins pieces that go on alike where nothing else meets them.
    pub(super) fn merge(&mut self) {
        let nodes: Vec<u32> = self.at.keys().copied().collect();
        for node in nodes {
            let Some([one, other]) =
                self.at.get(&node).and_then(|pieces| <[usize; 2]>::try_from(pieces.as_slice()).ok())
            else {
                continue;
            };
            if one == other || self.marks.get(&node).is_some_and(|marks| marks.crossing.is_some() || marks.signals) {
                continue;
            }
            if let Some(joined) = self.joined(one, other, node) {
                let far = joined.last();
                self.pieces[one] = Some(joined);
                self.pieces[other] = None;
                self.at.remove(&node);
                self.at
                    .get_mut(&far)
                    .into_iter()
                    .flatten()
                    .filter(|piece| **piece == other)
                    .for_each(|piece| *piece = one);
                if let Some(piece) = &self.pieces[one] {
                    let first = piece.first();
                    self.at
                        .get_mut(&first)
                        .into_iter()
                        .flatten()
                        .filter(|piece| **piece == other)
                        .for_each(|piece| *piece = one);
                }
            }
        }
    }

    /// Two pieces as one, if they are of the same kind and direction.
    fn joined(&self, one: usize, other: usize, node: u32) -> Option<Piece> {
        let (a, b) = (self.pieces[one].as_ref()?, self.pieces[other].as_ref()?);
        let (alike, same) = (self.street(a), self.street(b));
        let fits = alike.class == same.class
            && alike.section == same.section
            && alike.layer == same.layer
            && (alike.structure == same.structure || alike.class >= RoadClass::Path)
            && alike.name == same.name
            && alike.roundabout == same.roundabout
            && alike.slip == same.slip
            && alike.private == same.private;
        let (before, after) = match (a.last() == node, b.first() == node) {
            (true, true) => (a, b),
            (false, false) if a.first() == node && b.last() == node => (b, a),
            _ => return None,
        };
        let length = a.length + b.length;
        let nodes = before.nodes.iter().chain(&after.nodes[1..]).copied().collect();
        let closed = before.first() == after.last();
        (fits && !closed).then_some(Piece { way: a.way, street: a.street, nodes, length })
    }

    /// Whether both ends of a piece lie on the ground or on the same bridge.
    pub(super) fn is_ground(&self, piece: &Piece) -> bool {
        self.street(piece).structure == Structure::Ground
    }

    /// Whether cars may use a piece in a direction.
    pub(super) fn drives(&self, piece: &Piece, forward: bool) -> bool {
        self.street(piece).section.users(forward).any(Users::CAR | Users::BUS)
    }
}

/// The kind of a crossing by its tag; `None` if there is none.
fn kind(value: Option<&str>, there: bool) -> Option<CrossingKind> {
    match value {
        _ if !there => None,
        Some("no") => None,
        Some(value) if value.contains("traffic_signals") => Some(CrossingKind::Signals),
        Some("unmarked" | "informal") | None => Some(CrossingKind::Unmarked),
        Some(_) => Some(CrossingKind::Marked),
    }
}

//! Ways cut into pieces at the nodes where they meet.

use std::collections::{BTreeMap, BTreeSet};

use super::marks::Marks;
use super::street::{Street, street};
use super::tags::Source;
use super::{Element, ImportReport, Reason};
use crate::{DrivingSide, Point, Polyline, Structure, Users};

/// The most pieces that meet at a node.
const MOST: usize = 12;
/// Nodes at which ways end are at the edge if the file's bounds are this near, metres.
const EDGE: f64 = 15.0;

/// A stretch of a way between two nodes at which something happens.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// The ways that it was made of: several if it goes on over their ends.
    pub(super) ways: Vec<i64>,
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

/// A run of nodes of a way that are all in the file.
pub(super) struct Part {
    /// Its way; `None` for one that was guessed.
    pub(super) way: Option<i64>,
    pub(super) street: usize,
    pub(super) nodes: Vec<u32>,
}

/// All roads of a file as pieces.
pub(super) struct Network<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) side: DrivingSide,
    pub(super) streets: Vec<Street>,
    /// Pieces; those that were merged into others are `None`.
    pub(super) pieces: Vec<Option<Piece>>,
    /// The pieces at each node.
    pub(super) at: BTreeMap<u32, Vec<usize>>,
    pub(super) marks: BTreeMap<u32, Marks>,
    /// Nodes at which ways leave the map.
    edges: BTreeSet<u32>,
    /// The places of nodes that were added to those of the file.
    added: Vec<Point>,
}

impl<'a> Network<'a> {
    pub(super) fn new(source: &'a Source<'a>, side: DrivingSide, report: &mut ImportReport) -> Self {
        let mut network = Self {
            source,
            side,
            streets: Vec::new(),
            pieces: Vec::new(),
            at: BTreeMap::new(),
            marks: BTreeMap::new(),
            edges: BTreeSet::new(),
            added: Vec::new(),
        };
        let mut parts = network.parts(report);
        network.separate_pavements(&parts, report);
        network.link_crossings(&mut parts, report);
        network.mark(&parts);
        network.join_stop_lines(&parts, report);
        network.cut(parts, report);
        network.join_in_carriageways();
        network.merge();
        network
    }

    fn parts(&mut self, report: &mut ImportReport) -> Vec<Part> {
        let mut parts = Vec::new();
        let source = self.source;
        for way in &source.ways {
            let element = Element::Way(way.id);
            let street = match street(way.id, source.way_tags(way), self.side, report) {
                Ok(street) => street,
                Err(reason) => {
                    reason.into_iter().for_each(|reason| report.drop(element, reason));
                    continue;
                }
            };
            let refs = source.refs(way);
            let found = self.runs(refs, street.reversed);
            match (source.lacks(refs), found.is_empty()) {
                (Some(reason), true) => report.drop(element, reason),
                (None, true) => report.drop(element, Reason::NoShape),
                (Some(_), false) => report.drop(element, Reason::Shortened),
                (None, false) => {}
            }
            let number = self.streets.len();
            self.streets.push(street);
            parts.extend(found.into_iter().map(|nodes| Part { way: Some(way.id), street: number, nodes }));
        }
        parts
    }

    /// The runs of nodes that are in the file. Where one breaks off, the map ends.
    fn runs(&mut self, refs: &[i64], reversed: bool) -> Vec<Vec<u32>> {
        let places: Vec<Option<u32>> = refs.iter().map(|id| self.source.near(*id)).collect();
        let count = places.split(Option::is_none).count();
        let mut runs: Vec<Vec<u32>> = Vec::new();
        for (index, run) in places.split(Option::is_none).enumerate() {
            let mut run: Vec<u32> = run.iter().copied().flatten().collect();
            run.dedup();
            let ends = [run.first().filter(|_| index > 0), run.last().filter(|_| index + 1 < count)];
            self.edges.extend(ends.into_iter().flatten());
            if reversed {
                run.reverse();
            }
            if run.len() > 1 {
                runs.push(run);
            }
        }
        runs
    }

    pub(super) fn point(&self, node: u32) -> Point {
        let added = (node as usize).checked_sub(self.source.points.len());
        added.map_or_else(|| self.source.point(node), |index| self.added[index])
    }

    /// Adds a node that the file does not have.
    pub(super) fn add_node(&mut self, at: Point) -> u32 {
        self.added.push(at);
        (self.source.points.len() + self.added.len() - 1) as u32
    }

    /// The number that a node has in the file; `None` for one that was added.
    pub(super) fn id(&self, node: u32) -> Option<i64> {
        self.source.nodes.get(node as usize).map(|node| node.id)
    }

    /// A node as an element of the file.
    pub(super) fn element(&self, node: u32) -> Element {
        Element::Node(self.id(node).unwrap_or_default())
    }

    pub(super) fn line(&self, nodes: &[u32]) -> Option<Polyline> {
        Polyline::new(nodes.iter().map(|node| self.point(*node)))
    }

    /// Cuts the parts where they meet, where they pass themselves, and at crossings and lights.
    fn cut(&mut self, parts: Vec<Part>, report: &mut ImportReport) {
        let mut passes: BTreeMap<u32, u32> = BTreeMap::new();
        for Part { nodes, .. } in &parts {
            for (index, node) in nodes.iter().enumerate() {
                let end = index == 0 || index + 1 == nodes.len();
                *passes.entry(*node).or_default() += if end { 2 } else { 1 };
            }
        }
        for part in parts {
            let street = self.streets[part.street].class.is_street();
            let special = |node: &u32| {
                let marked = self.marks.get(node).is_some_and(|marks| marks.cuts());
                passes.get(node).is_some_and(|count| *count > 1) || (street && marked)
            };
            let nodes = &part.nodes;
            let mut start = 0;
            let breaks: Vec<usize> =
                (1..nodes.len()).filter(|i| *i + 1 == nodes.len() || special(&nodes[*i])).collect();
            for end in breaks {
                self.add(&part, &nodes[start..=end], report);
                start = end;
            }
        }
    }

    fn add(&mut self, part: &Part, nodes: &[u32], report: &mut ImportReport) {
        let mut drop = |reason| part.way.iter().for_each(|way| report.drop(Element::Way(*way), reason));
        let Some(line) = self.line(nodes) else { return drop(Reason::NoShape) };
        let full = |node: &u32| self.at.get(node).is_some_and(|pieces| pieces.len() >= MOST);
        let piece = Piece {
            ways: part.way.into_iter().collect(),
            street: part.street,
            nodes: nodes.to_vec(),
            length: line.length(),
        };
        if piece.ends().iter().any(full) {
            return drop(Reason::TooManyMeet);
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
        let numbers = self.at.get(&node).into_iter().flatten();
        let pieces = numbers.filter_map(|number| Some((*number, self.pieces[*number].as_ref()?)));
        pieces.filter(|(_, piece)| self.street(piece).class.is_street())
    }

    /// The pieces of rails at a node.
    fn rails_at(&self, node: u32) -> impl Iterator<Item = &Piece> {
        let pieces = self.at.get(&node).into_iter().flatten().filter_map(|number| self.pieces[*number].as_ref());
        pieces.filter(|piece| self.street(piece).class.is_rail())
    }

    /// Whether rails meet at a node.
    pub(super) fn has_rails(&self, node: u32) -> bool {
        self.rails_at(node).next().is_some()
    }

    /// Whether rails lead from one node to the next one.
    pub(super) fn rails_join(&self, one: u32, other: u32) -> bool {
        self.rails_at(one).any(|piece| piece.ends().contains(&other))
    }

    /// Whether the map ends at a node.
    pub(super) fn is_edge(&self, node: u32) -> bool {
        let near = |bounds: [f64; 4]| self.source.nodes.get(node as usize).is_some_and(|n| n.within(bounds) < EDGE);
        self.edges.contains(&node) || self.source.bounds.is_some_and(near)
    }

    /// Whether a piece lies on the ground.
    pub(super) fn is_ground(&self, piece: &Piece) -> bool {
        self.street(piece).structure == Structure::Ground
    }

    /// Whether cars or buses may use a piece in a direction.
    pub(super) fn drives(&self, piece: &Piece, forward: bool) -> bool {
        self.street(piece).section.users(forward).any(Users::CAR | Users::BUS)
    }
}

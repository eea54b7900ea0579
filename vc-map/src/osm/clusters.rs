//! Clusters: nodes that are one junction for those who drive.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::unionfind::UnionFind;

use super::network::{Network, Piece};
use crate::{CrossingKind, RoadClass, Users};

/// Junctions nearer than this are one, metres; SUMO joins those within 10 m.
pub(super) const NEAR: f64 = 12.0;
/// Nodes nearer than this are one, metres: no road fits between them.
const SAME: f64 = 0.1;
/// Junctions of dual carriageways with lights are one up to this distance, metres.
const DUAL: f64 = 24.0;
/// A crossing belongs to the junction that is nearer than this, metres.
pub(super) const CROSSING: f64 = 20.0;
/// Nodes that together would have more movements than this are junctions each: one has 512 at most, and bicycles have their own.
const MOST: usize = 400;
/// A street passes at most so many rails between two nodes that are one junction.
const MOST_RAILS: usize = 5;
/// No cluster is wider, metres.
const WIDEST: f64 = 48.0;

/// The cluster of each node at which pieces meet.
pub(super) struct Clusters {
    /// By node: the node of the cluster with the lowest position.
    of: BTreeMap<u32, u32>,
    /// By that node: all of its nodes.
    pub(super) members: BTreeMap<u32, Vec<u32>>,
}

impl Clusters {
    pub(super) fn of(&self, node: u32) -> u32 {
        self.of.get(&node).copied().unwrap_or(node)
    }

    /// The nodes of the cluster of a node.
    pub(super) fn nodes(&self, node: u32) -> &[u32] {
        self.members.get(&self.of(node)).map(Vec::as_slice).unwrap_or_default()
    }

    /// Whether streets meet in the cluster of a node, more than two at one of its nodes.
    pub(super) fn is_junction(&self, network: &Network<'_>, node: u32) -> bool {
        self.nodes(node).iter().any(|node| degree(network, *node) > 2)
    }
}

/// The clusters of all nodes; crossings in `apart` belong to no junction beside them.
pub(super) fn clusters(network: &Network<'_>, apart: &BTreeSet<u32>) -> Clusters {
    let nodes: Vec<u32> = network.at.keys().copied().collect();
    let position = |node: u32| nodes.binary_search(&node).unwrap_or(0);
    let mut sets = UnionFind::<usize>::new(nodes.len());
    let mut boxes: Vec<[f64; 4]> =
        nodes.iter().map(|node| network.point(*node)).map(|p| [p.x, p.y, p.x, p.y]).collect();
    let mut links: Vec<(f64, u32, u32)> = network
        .all()
        .filter(|(_, piece)| piece.first() != piece.last() && (piece.length < SAME || joins(network, piece, apart)))
        .map(|(_, piece)| (piece.length, piece.first(), piece.last()))
        .collect();
    links.extend(over_rails(network));
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    for (_, one, other) in links {
        let (one, other) = (sets.find_mut(position(one)), sets.find_mut(position(other)));
        let (a, b) = (boxes[one], boxes[other]);
        let around = [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])];
        if one != other && around[2] - around[0] <= WIDEST && around[3] - around[1] <= WIDEST {
            sets.union(one, other);
            boxes[sets.find_mut(one)] = around;
        }
    }
    let mut clusters = Clusters { of: BTreeMap::new(), members: BTreeMap::new() };
    let mut first: BTreeMap<usize, u32> = BTreeMap::new();
    for (index, node) in nodes.iter().enumerate() {
        let head = *first.entry(sets.find_mut(index)).or_insert(*node);
        clusters.of.insert(*node, head);
        clusters.members.entry(head).or_default().push(*node);
    }
    clusters.split(network);
    clusters
}

impl Clusters {
    /// Parts clusters into their nodes that would be junctions of more movements than one has.
    fn split(&mut self, network: &Network<'_>) {
        let large = |(head, nodes): (&u32, &Vec<u32>)| {
            (nodes.len() > 1 && self.movements(network, nodes) > MOST).then_some(*head)
        };
        let large: Vec<u32> = self.members.iter().filter_map(large).collect();
        for head in large {
            for node in self.members.remove(&head).into_iter().flatten() {
                self.of.insert(node, node);
                self.members.insert(node, vec![node]);
            }
        }
    }

    /// About how many movements a junction of some nodes has: those from each lane that comes to each street that leaves.
    fn movements(&self, network: &Network<'_>, nodes: &[u32]) -> usize {
        let (mut comes, mut leaves) = (0, 0);
        for node in nodes {
            let away = |(_, piece): &(usize, &Piece)| self.of(piece.first()) != self.of(piece.last());
            for (_, piece) in network.streets_at(*node).filter(away) {
                let section = &network.street(piece).section;
                // Along a piece one comes to its last node.
                let towards = piece.last() == *node;
                let lanes = section.side(towards).iter().filter(|strip| strip.users.any(Users::TRAFFIC));
                comes += lanes.count();
                leaves += usize::from(section.users(!towards).any(Users::TRAFFIC));
            }
        }
        comes * leaves
    }
}

/// The number of pieces of street, tracks aside, that meet at a node.
pub(super) fn degree(network: &Network<'_>, node: u32) -> usize {
    network.streets_at(node).filter(|(_, piece)| network.street(piece).class != RoadClass::Track).count()
}

/// The links of junctions between which a street only passes rails, as in the median of a dual carriageway: all pieces of a
/// street between two junctions that would be one without the rails.
fn over_rails(network: &Network<'_>) -> Vec<(f64, u32, u32)> {
    let real = |node: u32| degree(network, node) > 2;
    let passes = |node: u32| degree(network, node) == 2 && network.has_rails(node);
    let mut links = Vec::new();
    for first in network.at.keys().copied().filter(|node| real(*node)) {
        for (number, piece) in network.streets_at(first) {
            let (mut number, mut piece, mut node, mut length) = (number, piece, first, 0.0);
            let mut nodes = vec![first];
            while nodes.len() <= MOST_RAILS && network.is_ground(piece) && !network.street(piece).roundabout {
                length += piece.length;
                node = if piece.first() == node { piece.last() } else { piece.first() };
                nodes.push(node);
                if real(node) && nodes.len() > 2 && length < widest(network, first, node) {
                    links.extend(nodes.windows(2).map(|pair| (length, pair[0].min(pair[1]), pair[0].max(pair[1]))));
                }
                let next = network.streets_at(node).find(|(other, _)| *other != number).filter(|_| passes(node));
                let Some((onward, on)) = next else { break };
                (number, piece) = (onward, on);
            }
        }
    }
    links
}

/// Two junctions nearer than this are one, metres.
fn widest(network: &Network<'_>, one: u32, other: u32) -> f64 {
    let one_way = network.streets_at(one).chain(network.streets_at(other)).any(|(_, p)| !network.drives(p, false));
    let dual = one_way && (around_lights(network, one) || around_lights(network, other));
    if dual { DUAL } else { NEAR }
}

/// Whether a piece of street lies within a junction.
fn joins(network: &Network<'_>, piece: &Piece, apart: &BTreeSet<u32>) -> bool {
    let street = network.street(piece);
    if !street.class.is_street() || street.roundabout || !network.is_ground(piece) {
        return false;
    }
    let [one, other] = piece.ends();
    let real = |node: u32| degree(network, node) > 2;
    let marks = |node: u32| network.marks.get(&node).copied().unwrap_or_default();
    let lights = |node: u32| marks(node).signals || marks(node).crossing == Some(CrossingKind::Signals);
    let ring = |node: u32| network.streets_at(node).any(|(_, piece)| network.street(piece).roundabout);
    let rounds = |node: u32| marks(node).round || ring(node);
    if rounds(one) || rounds(other) || street.class == RoadClass::Motorway {
        return false;
    }
    let crossing = |node: u32| marks(node).cuts() && !apart.contains(&node);
    // Tracks beside each other are passed in one go.
    let tracks = || [one, other].iter().all(|node| network.has_rails(*node)) && !network.rails_join(one, other);
    match (real(one), real(other)) {
        (false, false) if tracks() => piece.length < NEAR,
        (true, true) => piece.length < widest(network, one, other),
        (true, false) => crossing(other) && piece.length < CROSSING,
        (false, true) => crossing(one) && piece.length < CROSSING,
        (false, false) => crossing(one) && crossing(other) && piece.length < NEAR / 2.0 && lights(one) == lights(other),
    }
}

/// Whether a node has lights or the next nodes along its streets have.
fn around_lights(network: &Network<'_>, node: u32) -> bool {
    let lights = |node: u32| {
        network.marks.get(&node).is_some_and(|marks| marks.signals || marks.crossing == Some(CrossingKind::Signals))
    };
    let beyond = |(_, piece): (usize, &Piece)| piece.length < DUAL && piece.ends().into_iter().any(lights);
    lights(node) || network.streets_at(node).any(beyond)
}

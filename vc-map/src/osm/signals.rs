//! Signals: those on the nodes of junctions, those on nodes before them, and those of crossings for people.

use std::collections::{BTreeMap, BTreeSet};

use super::clusters::{CROSSING, Clusters, NEAR, clusters, degree};
use super::marks::Marks;
use super::network::{Network, Piece};
use super::{Element, Guessed, ImportReport, Reason};
use crate::{CrossingKind, StripKind, Users};

/// A signal or sign rules the junction at most this far ahead, metres.
pub(super) const AHEAD: f64 = 60.0;
/// The lights of a crossing are those of a junction with lights at most this far away, metres.
const AWAY: f64 = 45.0;
/// Junctions are looked for among so many nodes, the nearest.
const NODES: usize = 64;

/// Junctions as clusters of nodes, and those of them that have lights, by their first nodes. Lights of a crossing for people
/// belong to the junction beside it if that has lights. They light a junction by themselves only if all its arms have
/// such a crossing.
pub(super) fn signals(network: &mut Network<'_>, report: &mut ImportReport) -> (Clusters, BTreeSet<u32>) {
    unwalked(network, report);
    let people = crossings(network);
    let signals = |node: &u32| network.marks.get(node).is_some_and(|marks| marks.signals);
    let mut apart: BTreeSet<u32> = people.iter().copied().filter(|node| !signals(node)).collect();
    let first = clusters(network, &apart);
    let mut lit = vehicles(network, &first, &mut ImportReport::default());
    let all_round = lit_by_crossings(network, &first, &apart);
    lit.extend(all_round.iter().copied());
    let joined = join(network, &first, &lit, &people, &mut apart, report);
    let last = clusters(network, &apart);
    // At roundabouts and bridges a crossing stays for itself, without lights against those of the junction.
    for (node, junction) in joined {
        if !last.is_junction(network, node) {
            unlit(network, node, Guessed::CrossingOf(id(network, junction)), report);
        }
    }
    let mut lit = vehicles(network, &last, report);
    lit.extend(all_round.into_iter().map(|node| last.of(node)));
    lit.extend(crossings(network).into_iter().map(|node| last.of(node)).filter(|head| {
        // Those that joined a junction have its lights.
        !last.is_junction(network, *head)
    }));
    (last, lit)
}

/// Gives crossings with lights to the junctions beside them: takes those that are to be one with a junction from `apart` and
/// gives them back with a node of it, and makes others crossings without lights.
fn join(
    network: &mut Network<'_>,
    clusters: &Clusters,
    lit: &BTreeSet<u32>,
    people: &[u32],
    apart: &mut BTreeSet<u32>,
    report: &mut ImportReport,
) -> Vec<(u32, u32)> {
    let mut joined = Vec::new();
    for node in people.iter().copied() {
        if clusters.is_junction(network, node) {
            continue;
        }
        let Some(found) = nearest(network, clusters, node, AWAY, |_, _| true) else { continue };
        let joins = found.length < CROSSING && apart.contains(&node);
        match lit.contains(&clusters.of(found.node)) {
            true if joins => {
                apart.remove(&node);
                joined.push((node, found.node));
            }
            true => unlit(network, node, Guessed::CrossingOf(id(network, found.node)), report),
            false if found.length < NEAR => {
                apart.remove(&node);
                unlit(network, node, Guessed::NoLights, report);
            }
            false => {}
        }
    }
    joined
}

/// Nodes with lights for people at which no streets meet.
fn crossings(network: &Network<'_>) -> Vec<u32> {
    let lights = network.marks.iter().filter(|(_, marks)| marks.crossing == Some(CrossingKind::Signals));
    let nodes = lights.map(|(node, _)| *node);
    nodes.filter(|node| (1..=2).contains(&degree(network, *node))).collect()
}

fn id(network: &Network<'_>, node: u32) -> i64 {
    network.id(node).unwrap_or_default()
}

/// Takes away the crossings between junctions that nobody can come to: those with lights would stop traffic for nobody.
fn unwalked(network: &mut Network<'_>, report: &mut ImportReport) {
    let between = |node: u32| (1..=2).contains(&degree(network, node));
    let lost = |(node, marks): (&u32, &Marks)| {
        (marks.crossing.is_some() && between(*node) && sides(network, *node) < 2).then_some(*node)
    };
    let lost: Vec<u32> = network.marks.iter().filter_map(lost).collect();
    for node in lost {
        report.drop(network.element(node), Reason::NobodyCrosses);
        if let Some(marks) = network.marks.get_mut(&node) {
            marks.crossing = None;
        }
    }
}

/// The number of sides from which people come to a node of a street, by paths that end there and by pavements.
fn sides(network: &Network<'_>, node: u32) -> usize {
    let numbers = network.at.get(&node).into_iter().flatten();
    let streets = numbers.filter_map(|number| network.pieces[*number].as_ref()).map(|piece| network.street(piece));
    let (mut paths, mut pavements) = (0, [false; 2]);
    for street in streets {
        if !street.class.is_street() {
            paths += usize::from((street.section.users(true) | street.section.users(false)).has(Users::FOOT));
        }
        for (has, forward) in pavements.iter_mut().zip([true, false]) {
            *has |= street.section.side(forward).iter().any(|strip| strip.kind == StripKind::Pavement);
        }
    }
    paths + pavements.iter().filter(|has| **has).count()
}

/// Makes a crossing one without lights.
fn unlit(network: &mut Network<'_>, node: u32, guessed: Guessed, report: &mut ImportReport) {
    report.guess(Element::Node(id(network, node)), guessed);
    if let Some(marks) = network.marks.get_mut(&node) {
        marks.crossing = Some(CrossingKind::Marked);
    }
}

/// Junctions whose nodes have lights for vehicles, or before which such nodes stand.
fn vehicles(network: &Network<'_>, clusters: &Clusters, report: &mut ImportReport) -> BTreeSet<u32> {
    let mut lit = BTreeSet::new();
    for (node, marks) in &network.marks {
        let crossing = marks.crossing == Some(CrossingKind::Signals);
        let here = degree(network, *node);
        // A junction may have its lights on a crossing node of its own.
        if here == 0 || !(marks.signals || (crossing && here > 2)) {
            continue;
        }
        let element = Element::Node(id(network, *node));
        if clusters.is_junction(network, *node) || (marks.signals && network.has_rails(*node)) {
            lit.insert(clusters.of(*node));
        } else if crossing && !marks.stop_line {
            // A crossing for people between junctions.
        } else if let Some(ahead) = ahead(network, clusters, *node, marks.forward_only) {
            report.guess(element, Guessed::SignalAt(id(network, ahead)));
            lit.insert(clusters.of(ahead));
        } else if !crossing {
            report.drop(element, Reason::NoJunction);
        }
    }
    lit
}

/// The nearest junction ahead of a signal or sign, along the directions in which one drives there.
pub(super) fn ahead(network: &Network<'_>, clusters: &Clusters, node: u32, forward_only: Option<bool>) -> Option<u32> {
    let drives = |piece: &Piece, forward: bool| {
        network.drives(piece, forward) && forward_only.is_none_or(|only| only == forward)
    };
    nearest(network, clusters, node, AHEAD, drives).map(|found| found.node)
}

/// Junctions all of whose arms have a crossing with lights.
fn lit_by_crossings(network: &Network<'_>, clusters: &Clusters, crossings: &BTreeSet<u32>) -> BTreeSet<u32> {
    let mut arms: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
    for node in crossings {
        if let Some(found) = nearest(network, clusters, *node, AWAY, |_, _| true) {
            arms.entry(clusters.of(found.node)).or_default().insert(found.piece);
        }
    }
    let whole = |(head, lights): &(u32, BTreeSet<usize>)| {
        let nodes = clusters.nodes(*head).iter();
        let pieces = nodes.flat_map(|node| network.streets_at(*node));
        let mut leave = pieces.filter(|(_, p)| clusters.of(p.first()) != clusters.of(p.last()));
        leave.all(|(piece, _)| lights.contains(&piece))
    };
    arms.into_iter().filter(whole).map(|(head, _)| head).collect()
}

/// A junction that was found along streets.
pub(super) struct Found {
    pub(super) node: u32,
    /// The piece by which one comes to it.
    piece: usize,
    pub(super) length: f64,
}

/// The junction nearest to a node within a distance, along pieces that may be followed in a direction.
pub(super) fn nearest(
    network: &Network<'_>,
    clusters: &Clusters,
    node: u32,
    within: f64,
    follows: impl Fn(&Piece, bool) -> bool,
) -> Option<Found> {
    // Lengths are not negative, so that their bits are in their order.
    let mut open = BTreeSet::from([(0.0_f64.to_bits(), node, usize::MAX)]);
    let mut seen = BTreeSet::new();
    while let Some((bits, at, came)) = open.pop_first() {
        let gone = f64::from_bits(bits);
        if !seen.insert(at) {
            continue;
        }
        if came != usize::MAX && clusters.is_junction(network, at) {
            return Some(Found { node: at, piece: came, length: gone });
        }
        if seen.len() > NODES {
            return None;
        }
        for (number, piece) in network.streets_at(at) {
            for (forward, from, to) in [(true, piece.first(), piece.last()), (false, piece.last(), piece.first())] {
                let length = gone + piece.length;
                if from == at && length <= within && follows(piece, forward) {
                    open.insert((length.to_bits(), to, number));
                }
            }
        }
    }
    None
}

//! Signals: those on the nodes of junctions, and those on nodes before them.

use std::collections::BTreeSet;

use super::clusters::{Clusters, degree};
use super::network::Network;
use super::{Element, Guessed, ImportReport};
use crate::CrossingKind;

/// A signal rules the junction at most this far ahead, metres.
const AHEAD: f64 = 60.0;

/// The clusters that have lights, by their first nodes.
pub(super) fn signals(network: &Network<'_>, clusters: &Clusters, report: &mut ImportReport) -> BTreeSet<u32> {
    let mut lit = BTreeSet::new();
    let streets = |head: u32| {
        let members = clusters.members.get(&head).into_iter().flatten();
        members.map(|node| degree(network, *node)).max().unwrap_or(0)
    };
    for (node, marks) in &network.marks {
        let head = clusters.of(*node);
        let people = marks.crossing == Some(CrossingKind::Signals);
        if !network.at.contains_key(node) || network.streets_at(*node).next().is_none() || !(marks.signals || people) {
            continue;
        }
        if streets(head) > 2 || people {
            lit.insert(head);
        } else if let Some(ahead) = ahead(network, clusters, *node, marks.forward_only) {
            let source = network.data.nodes[ahead as usize].id;
            report.guess(Element::Node(network.data.nodes[*node as usize].id), Guessed::SignalAt(source));
            lit.insert(clusters.of(ahead));
        }
    }
    lit
}

/// The nearest junction ahead of a signal, along the directions in which one drives there.
fn ahead(network: &Network<'_>, clusters: &Clusters, node: u32, forward_only: Option<bool>) -> Option<u32> {
    let mut best: Option<(f64, u32)> = None;
    let mut open = vec![(0.0, node, usize::MAX)];
    while let Some((gone, at, came)) = open.pop() {
        for (number, piece) in network.streets_at(at).filter(|(number, _)| *number != came) {
            let forward = piece.first() == at;
            let length = gone + piece.length;
            let told = forward_only.is_none_or(|only| only == forward);
            if !network.drives(piece, forward) || !told || length > AHEAD {
                continue;
            }
            let next = if forward { piece.last() } else { piece.first() };
            let members = clusters.members.get(&clusters.of(next)).into_iter().flatten();
            if members.clone().any(|node| degree(network, *node) > 2) {
                if best.is_none_or(|(least, known)| (length, next) < (least, known)) {
                    best = Some((length, next));
                }
            } else {
                open.push((length, next, number));
            }
        }
    }
    best.map(|(_, node)| node)
}

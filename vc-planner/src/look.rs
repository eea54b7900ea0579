//! Where to look next: chance over cost.
//!
//! For one thing in independent boxes the best order is by falling `p / c` (Stone,
//! *Theory of Optimal Search*, 1975). Entering a room shows all its surfaces at once
//! and makes its boxes cheap, so a room is worth the best of
//! `(P_surfaces + p_1 + ... + p_j) / (c_1 + ... + c_j)` over its boxes by falling `p`
//! (Sidney's index for chains, 1975). Several things looked for count by the chance
//! that at least one of those still needed is found.

use vc_graph::{NodeId, Place, Relation, SceneGraph};

use crate::Belief;
use crate::compile::{Lack, Manners};

/// Something to look at: a room to enter, or a container to open.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Look {
    Enter(NodeId),
    Open(NodeId),
}

/// A container that has not been looked into.
struct Box {
    at: NodeId,
    chance: f64,
    cost: f64,
}

/// What one room hides.
#[derive(Default)]
struct Hidden {
    room: Option<NodeId>,
    surfaces: f64,
    boxes: Vec<Box>,
}

/// The best look for what is lacking; `None` if nothing is left to look at.
pub(crate) fn best_look(
    belief: &Belief,
    me: NodeId,
    lacks: &[Lack],
    doors: &[NodeId],
    manners: Manners,
) -> Option<Look> {
    let graph = belief.graph();
    let chances = chances(belief, lacks);
    let here = graph.room_of(me);
    let mut rooms: Vec<Hidden> = Vec::new();
    for (index, place, room) in belief.sites() {
        let room = room.or_else(|| graph.room_of(place.at));
        let position = rooms.iter().position(|h| h.room == room).unwrap_or_else(|| {
            rooms.push(Hidden { room, ..Hidden::default() });
            rooms.len() - 1
        });
        let chance = chances[index];
        match box_at(graph, &place, room == here) {
            None => rooms[position].surfaces += chance,
            Some(at) => add_box(graph, me, &mut rooms[position], Box { at, chance, cost: 0.0 }, doors, manners),
        }
    }
    let looks = rooms.into_iter().filter_map(|hidden| look_in(hidden, here));
    looks
        .fold(None, |best: Option<(f64, Look)>, (value, look)| match best {
            Some((most, _)) if most >= value => best,
            _ => Some((value, look)),
        })
        .map(|(_, look)| look)
}

/// For each place the chance that something needed is found there.
fn chances(belief: &Belief, lacks: &[Lack]) -> Vec<f64> {
    let mut all = vec![0.0; belief.places_known()];
    for lack in lacks {
        let mut none = vec![1.0; all.len()];
        for (position, &id) in lack.subjects.iter().enumerate() {
            let Some(weights) = belief.weights_of(id) else { continue };
            let sum: f64 = belief.sites().map(|(i, _, _)| weights[i]).sum();
            // Instances of a class are alike: the last of many changes little.
            if position >= MANY || sum <= 0.0 {
                break;
            }
            for (i, _, _) in belief.sites() {
                none[i] *= 1.0 - weights[i] / sum;
            }
        }
        for (chance, none) in all.iter_mut().zip(none) {
            *chance += 1.0 - none;
        }
    }
    all
}

/// So many instances of what is lacking are told apart from infinitely many.
const MANY: usize = 8;

/// The container that must be opened to see a place; `None` if it is in view in its
/// room.
fn box_at(graph: &SceneGraph, place: &Place, here: bool) -> Option<NodeId> {
    let shut = |id: NodeId| graph.node(id).is_some_and(vc_graph::Node::hides_contents);
    if let Some(around) = graph.hidden_in(place.at) {
        return Some(around);
    }
    match place.relation {
        Relation::Inside if shut(place.at) || here => Some(place.at),
        _ => None,
    }
}

fn add_box(graph: &SceneGraph, me: NodeId, hidden: &mut Hidden, new: Box, doors: &[NodeId], manners: Manners) {
    if let Some(known) = hidden.boxes.iter_mut().find(|b| b.at == new.at) {
        known.chance += new.chance;
        return;
    }
    let walk = if graph.near(me, new.at) { 0.0 } else { 1.0 };
    // What has to be opened anyway is looked into for nothing more than the walk.
    let open = if doors.contains(&new.at) { 0.0 } else { 1.0 + f64::from(u8::from(manners == Manners::Tidy)) };
    hidden.boxes.push(Box { cost: (walk + open).max(0.25), ..new });
}

/// What a room is worth, and what to do first in it.
fn look_in(mut hidden: Hidden, here: Option<NodeId>) -> Option<(f64, Look)> {
    hidden.boxes.sort_by(|a, b| (b.chance * a.cost).total_cmp(&(a.chance * b.cost)));
    let mut best = match hidden.room {
        Some(room) if hidden.room != here && hidden.surfaces > 0.0 => Some((hidden.surfaces, Look::Enter(room))),
        _ => None,
    };
    let (mut chance, mut cost) = (hidden.surfaces, 0.0);
    for b in &hidden.boxes {
        (chance, cost) = (chance + b.chance, cost + b.cost);
        let value = chance / cost;
        if best.is_none_or(|(most, _)| value > most) {
            best = Some((value, Look::Open(hidden.boxes[0].at)));
        }
    }
    best
}

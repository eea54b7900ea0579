//! What is there for packed plans to work on: spots to walk to, doors, switches, hands and
//! piles of things.

use vc_graph::{Condition, Kind, NodeId, Place, Property, Relation, SceneGraph, State as Word};

use super::{Compiler, Manners, SPARE};
use crate::packed::{BITS, Door, MOST, Pile, Spot, Switch, Way, bit};

impl Compiler<'_> {
    pub(super) fn spot_number(&self, anchor: NodeId) -> Option<u8> {
        self.out.problem.spots.iter().position(|s| s.anchor == anchor).map(|i| i as u8)
    }

    pub(super) fn spot(&mut self, anchor: NodeId) -> Option<u8> {
        if let Some(number) = self.spot_number(anchor) {
            return Some(number);
        }
        let (graph, me) = (self.now.graph, self.now.agent);
        let number = self.out.problem.spots.len();
        let room = graph.room_of(anchor)?;
        if number == BITS {
            return None;
        }
        let node = graph.node(anchor)?;
        let surface =
            node.kind() == Kind::Object && node.affords(Property::Surface) && !node.affords(Property::Graspable);
        self.out.problem.spots.push(Spot { anchor, room: Some(room), reach: bit(number as u8), surface });
        if graph.near(me, anchor) {
            self.out.start.at |= bit(number as u8);
        }
        Some(number as u8)
    }

    /// The door something is behind, if any; `None` if there are several.
    pub(super) fn doors_of(&mut self, id: NodeId) -> Option<Option<u8>> {
        let graph = self.now.graph;
        let mut found = None;
        let mut at = id;
        for _ in 0..DEEPEST {
            let Some(place) = graph.place(at) else { break };
            let opens = graph.node(place.at).is_some_and(|n| n.affords(Property::Openable));
            if place.relation == Relation::Inside && opens {
                if found.is_some() {
                    return None;
                }
                found = Some(place.at);
            }
            at = place.at;
        }
        match found {
            None => Some(None),
            Some(container) => {
                let spot = self.spot(anchor(graph, container))?;
                self.door(container, spot).map(Some)
            }
        }
    }

    pub(super) fn door(&mut self, node: NodeId, spot: u8) -> Option<u8> {
        if let Some(number) = self.out.problem.doors.iter().position(|d| d.node == node) {
            return Some(number as u8);
        }
        let body = self.graph().node(node)?;
        let open = !body.hides_contents();
        let harmless = body.affords(Property::Cooler) || body.affords(Property::Heater);
        let switches = !harmless && body.affords(Property::Switchable);
        let number = self.out.problem.doors.len();
        if number == BITS {
            return None;
        }
        let want = (self.manners == Manners::Tidy && !open).then_some(false);
        self.out.problem.doors.push(Door { node, spot, unsafe_when_on: None, want });
        if open {
            self.out.start.open |= bit(number as u8);
        }
        if switches {
            let switch = self.switch(node);
            self.out.problem.doors[number].unsafe_when_on = switch;
        }
        Some(number as u8)
    }

    pub(super) fn switch(&mut self, node: NodeId) -> Option<u8> {
        if let Some(number) = self.out.problem.switches.iter().position(|s| s.node == node) {
            return Some(number as u8);
        }
        let body = self.graph().node(node)?;
        let number = self.out.problem.switches.len();
        let (on, off) = (body.is(Word::On), body.is(Word::Off));
        if number == BITS || (!on && !off) || body.is(Word::PluggedOut) {
            return None;
        }
        if on {
            self.out.start.on |= bit(number as u8);
        }
        let spot = self.spot(anchor(self.now.graph, node))?;
        let door = self.doors_of(node)?;
        self.out.problem.switches.push(Switch { node, spot, door, want: None });
        Some(number as u8)
    }

    /// What is held now.
    pub(super) fn hands(&mut self) {
        let held: Vec<NodeId> = self.graph().held(self.now.agent).take(2).collect();
        for (hand, &id) in held.iter().enumerate() {
            let serves = self.items.iter().find(|(item, _)| *item == id).map_or(0, |(_, serves)| *serves);
            self.out.problem.held[hand] = Some(id);
            let kind = self.kind(serves);
            self.out.start.hands[hand] = kind + 1;
        }
        self.items.retain(|(id, _)| !held.contains(id));
        let [a, b] = self.out.start.hands;
        if a < b {
            self.out.start.hands.swap(0, 1);
            self.out.problem.held.swap(0, 1);
        }
    }

    pub(super) fn kind(&mut self, serves: u32) -> u8 {
        let kinds = &mut self.out.problem.kinds;
        let known = kinds.iter().position(|&k| k == serves);
        known.unwrap_or_else(|| {
            kinds.push(serves);
            kinds.len() - 1
        }) as u8
    }

    /// Gathers items into piles, the most useful first.
    pub(super) fn piles(&mut self) {
        let graph = self.now.graph;
        let items = std::mem::take(&mut self.items);
        let mut piles: Vec<(NodeId, Option<NodeId>, u32, Vec<NodeId>)> = Vec::new();
        for (id, serves) in items {
            // What another holds or wears is left to it.
            if graph.holder(id).is_some() || Condition::NotElsewhereHeld(id).check(graph, self.now.agent).is_err() {
                continue;
            }
            let (at, shut) = (anchor(graph, id), container(graph, id));
            match piles.iter_mut().find(|p| p.0 == at && p.1 == shut && p.2 == serves) {
                Some(pile) => pile.3.push(id),
                None => piles.push((at, shut, serves, vec![id])),
            }
        }
        let busy = |at: NodeId| self.spot_number(at).is_some() || piles.iter().filter(|p| p.0 == at).count() > 1;
        let ranks: Vec<_> = piles
            .iter()
            .map(|p| {
                (
                    !busy(p.0),
                    std::cmp::Reverse(p.3.len().min(2)),
                    p.1.is_some(),
                    graph.room_of(p.0) != graph.room_of(self.now.agent),
                    p.0,
                )
            })
            .collect();
        let mut order: Vec<usize> = (0..piles.len()).collect();
        order.sort_by_key(|&i| ranks[i]);
        let mut kept = [0usize; MOST];
        for i in order {
            let (at, _, serves, ref items) = piles[i];
            let wanted = |n: usize| self.out.problem.needs[n].number as usize;
            let needs = || (0..MOST).filter(move |n| serves & (1 << n) != 0);
            if needs().all(|n| kept[n] >= wanted(n) + SPARE) {
                continue;
            }
            needs().for_each(|n| kept[n] += 1);
            self.pile(at, serves, items);
        }
    }

    pub(super) fn pile(&mut self, at: NodeId, serves: u32, items: &[NodeId]) {
        let number = self.out.problem.piles.len();
        if number == MOST {
            return;
        }
        let Some(spot) = self.spot(at) else { return };
        let Some(door) = self.doors_of(items[0]) else {
            self.out.rest = true;
            return;
        };
        let kind = self.kind(serves);
        self.out.start.piles[number] = items.len().min(250) as u8;
        self.out.problem.piles.push(Pile { kind, spot, door, items: items.to_vec() });
    }

    pub(super) fn finish(&mut self) {
        let problem = &mut self.out.problem;
        for n in 0..problem.needs.len() {
            let mut serving = problem.piles.iter().filter(|p| problem.kinds[p.kind as usize] & (1 << n) != 0);
            problem.needs[n].local = serving.any(|p| problem.needs[n].spots & bit(p.spot) != 0);
        }
        // In a room one is wherever in it one is.
        for i in 0..problem.spots.len() {
            let room = |(_, s): &(usize, &Spot)| Some(s.anchor) == problem.spots[i].room;
            let around = problem.spots.iter().enumerate().find(room).map_or(0, |(j, _)| bit(j as u8));
            problem.spots[i].reach |= around;
        }
        self.out.problem.shared = self.one_for_two();
        self.out.problem.index();
        let me = self.now.agent;
        self.out.start.room = self.now.graph.room_of(me).map_or(255, |r| (r.0 % 251) as u8);
        self.out.start.sort_hands();
    }

    /// Whether an item that is put somewhere can serve two needs there.
    pub(super) fn one_for_two(&self) -> bool {
        let problem = &self.out.problem;
        let target = |way: &Way| if let Way::Put { verb, at, .. } = way { Some((*verb, *at)) } else { None };
        let meet = |a: usize, b: usize| {
            let at = |n: usize| problem.needs[n].ways.iter().filter_map(target);
            at(a).any(|x| at(b).any(|y| x == y))
        };
        problem.kinds.iter().any(|k| {
            let needs: Vec<usize> = (0..problem.needs.len()).filter(|n| k & (1 << n) != 0).collect();
            needs.iter().enumerate().any(|(i, &a)| needs[i + 1..].iter().any(|&b| meet(a, b)))
        })
    }
}

/// How far down things are looked for in each other.
const DEEPEST: usize = 16;

/// What one walks up to, to have a thing at hand: the furniture it is on or in.
pub(crate) fn anchor(graph: &SceneGraph, id: NodeId) -> NodeId {
    let mut at = id;
    for _ in 0..DEEPEST {
        match graph.place(at) {
            Some(Place { relation: Relation::On | Relation::Inside, at: on }) if !is_ground(graph, on) => at = on,
            _ => break,
        }
    }
    at
}

/// The nearest container that opens around a thing.
fn container(graph: &SceneGraph, id: NodeId) -> Option<NodeId> {
    let mut at = id;
    for _ in 0..DEEPEST {
        let place = graph.place(at)?;
        if place.relation == Relation::Inside && graph.node(place.at).is_some_and(|n| n.affords(Property::Openable)) {
            return Some(place.at);
        }
        at = place.at;
    }
    None
}

/// Floors and rugs: standing on them is no reason to be near all that does.
pub(crate) fn is_ground(graph: &SceneGraph, id: NodeId) -> bool {
    graph.node(id).is_none_or(|n| {
        n.kind() != Kind::Object
            || matches!(&**n.class(), "floor" | "rug" | "carpet" | "mat" | "ceiling" | "wall" | "ground")
    })
}

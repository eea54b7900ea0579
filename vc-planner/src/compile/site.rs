//! The sites that packed plans work on: spots to walk to, doors and switches.

use vc_graph::{NodeId, NodeKind, ObjectRole, Place, Property, Relation, SceneGraph, State as Word};

use super::Compiler;
use crate::manners::Touched;
use crate::packed::{BITS, Door, Spot, Switch, Way, bit};

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
            node.kind() == NodeKind::Object && node.affords(Property::Surface) && !node.affords(Property::Graspable);
        self.out.problem.spots.push(Spot { anchor, room: Some(room), reach: bit(number as u8), surface });
        if graph.near(me, anchor) || graph.room_of(me) == Some(anchor) {
            self.out.start.at |= bit(number as u8);
        }
        Some(number as u8)
    }

    /// Where something stands: its spot, and its enclosing door, if any. `None` if there are several doors, or
    /// no room for another.
    pub(super) fn site(&mut self, id: NodeId) -> Option<(u8, Option<u8>)> {
        let standing = Standing::new(self.now.graph, id);
        let spot = self.spot(standing.anchor)?;
        Some((spot, self.door_of(&standing, spot)?))
    }

    /// The enclosing door of a thing, if any; `None` if there are several.
    pub(super) fn door_of(&mut self, standing: &Standing, spot: u8) -> Option<Option<u8>> {
        match standing.inside {
            _ if standing.nested => None,
            None => Some(None),
            Some(container) => self.door(container, spot).map(Some),
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
        self.out.problem.doors.push(Door { node, spot, unsafe_when_on: None, wanted: None });
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
        let (spot, door) = self.site(node)?;
        self.out.problem.switches.push(Switch { node, spot, door, wanted: None });
        Some(number as u8)
    }

    /// Requires doors and switches to be left as they are now, or as they were before they were touched, where
    /// the goal says nothing about them. While the goal has more parts than are packed, touched doors and
    /// switches are left: they may be needed for the rest.
    pub(super) fn tidy_up(&mut self, touched: &Touched) {
        let graph = self.now.graph;
        let more = self.out.rest;
        let awaited = self.leave.awaited;
        for (id, was) in touched.amiss(graph).filter(|(id, _)| !more && !awaited.contains(id)) {
            match was {
                Word::Open | Word::Closed => {
                    let spot = self.spot(anchor(graph, id));
                    let door = spot.and_then(|spot| self.door(id, spot));
                    if let Some(d) = door {
                        self.out.problem.doors[d as usize].wanted.get_or_insert(was == Word::Open);
                    }
                }
                _ => {
                    if let Some(w) = self.switch(id) {
                        self.out.problem.switches[w as usize].wanted.get_or_insert(was == Word::On);
                    }
                }
            }
        }
        let (open, on) = (self.out.start.open, self.out.start.on);
        for door in
            self.out.problem.doors.iter_mut().enumerate().filter(|(d, _)| open >> d & 1 == 0).map(|(_, door)| door)
        {
            door.wanted.get_or_insert(false);
        }
        for (w, switch) in self.out.problem.switches.iter_mut().enumerate() {
            switch.wanted.get_or_insert(on >> w & 1 != 0);
        }
    }

    pub(super) fn finish(&mut self) {
        let problem = &mut self.out.problem;
        // Every spot in a room also counts as being in the room.
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

/// The maximal nesting depth of things that is followed.
const DEEPEST: usize = 16;

/// Where a thing stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Standing {
    /// The furniture on or in which the thing is: walking up to it brings the thing within reach.
    pub(crate) anchor: NodeId,
    /// The nearest enclosing container that opens.
    pub(super) inside: Option<NodeId>,
    /// Whether another such container encloses that one.
    pub(super) nested: bool,
}

impl Standing {
    /// Follows the support chain from a thing down to the floor.
    pub(crate) fn new(graph: &SceneGraph, id: NodeId) -> Self {
        let mut standing = Self { anchor: id, inside: None, nested: false };
        for _ in 0..DEEPEST {
            let Some(Place { relation, at }) = graph.place(standing.anchor) else { break };
            let rests = matches!(relation, Relation::On | Relation::Inside);
            if !rests || is_ground(graph, at) {
                break;
            }
            if relation == Relation::Inside && graph.node(at).is_some_and(|n| n.affords(Property::Openable)) {
                standing.nested |= standing.inside.is_some();
                standing.inside = standing.inside.or(Some(at));
            }
            standing.anchor = at;
        }
        standing
    }
}

/// The furniture on or in which a thing is: walking up to it brings the thing within reach.
pub(crate) fn anchor(graph: &SceneGraph, id: NodeId) -> NodeId {
    Standing::new(graph, id).anchor
}

/// Whether a node is a floor or a rug: standing on it does not mean being near everything on it.
pub(crate) fn is_ground(graph: &SceneGraph, id: NodeId) -> bool {
    use ObjectRole::{Ceiling, Floor, Person, Room, Rug, Wall};
    graph.node(id).is_none_or(|n| matches!(n.role(), Room | Person | Floor | Wall | Ceiling | Rug))
}

//! The places where items of a demand can be put.

use vc_graph::{Condition, NodeId, NodeKind, Property, Verb};

use super::{Compiler, Result, anchor};
use crate::demand::Demand;
use crate::open_condition::Unreachable;
use crate::packed::Way;
use crate::small_list::SmallList;

/// How many places are tried for a need.
const PLACES: usize = 4;

impl Compiler<'_> {
    /// The ways to put items of a demand where it wants them.
    pub(super) fn puts(&mut self, demand: &Demand<'_>, verb: Verb) -> Result<Vec<Way>> {
        let mut ways = Vec::new();
        for &at in self.places(demand, verb)?.iter() {
            // Things on movable things are left to the general planner.
            if self.affords(at, Property::Graspable) {
                continue;
            }
            if self.is_room(at) {
                ways.extend(self.in_room(at));
            } else if let Some(way) = self.put(verb, at) {
                ways.push(way);
            }
        }
        Ok(ways)
    }

    /// The places that take items of a demand and have room for them: a few, those at hand and in this room first.
    fn places(&self, demand: &Demand<'_>, verb: Verb) -> Result<SmallList> {
        let (graph, me, text) = (self.now.graph, self.now.agent, || demand.part.to_string());
        let others = demand.others();
        if others.is_empty() {
            return Err(Unreachable::NoInstance(text()));
        }
        let places: SmallList = others.iter().copied().filter(|&at| self.takes(demand, verb, at)).collect();
        if places.is_empty() {
            let refused = if verb == Verb::Place { Unreachable::NotASurface } else { Unreachable::NotAContainer };
            return Err(refused(text()));
        }
        let sample = *demand.subjects().first().ok_or_else(|| Unreachable::NoInstance(text()))?;
        let holds = |at: &NodeId| self.is_room(*at) || Condition::Fits(sample, *at).holds(graph, me);
        let places = self.few(places.iter().copied().filter(holds).collect());
        if places.iter().all(|&id| graph.room_of(id).is_none()) && !places.is_empty() {
            return Err(Unreachable::NoRoute(text()));
        }
        Ok(places)
    }

    /// Whether a place is one on or in which items of a demand can be.
    fn takes(&self, demand: &Demand<'_>, verb: Verb, at: NodeId) -> bool {
        let (graph, me) = (self.now.graph, self.now.agent);
        match verb {
            // A book is a surface for a bookmark, and for little else.
            Verb::Place => {
                Condition::Carries(at).holds(graph, me)
                    && (!self.affords(at, Property::Readable)
                        || demand.subjects().iter().any(|s| Condition::Fits(*s, at).holds(graph, me)))
            }
            _ => self.is_room(at) || Condition::Encloses(at).holds(graph, me),
        }
    }

    /// The first few of some places: those at spots that are walked to anyway, and then those in this room.
    fn few(&self, mut places: SmallList) -> SmallList {
        let graph = self.now.graph;
        let (here, hand) = (graph.room_of(self.now.agent), |id: NodeId| self.spot_number(anchor(graph, id)).is_some());
        if let SmallList::Many(many) = &mut places
            && many.len() > PLACES
        {
            many.sort_by_key(|&id| (!hand(id), graph.room_of(id) != here, id));
            many.truncate(PLACES);
        }
        places
    }

    fn put(&mut self, verb: Verb, at: NodeId) -> Option<Way> {
        let (spot, inner) = self.site(at)?;
        let own = verb == Verb::PutIn && self.affords(at, Property::Openable);
        let door = match (own, inner) {
            (true, None) => Some(self.door(at, spot)?),
            (false, door) => door,
            (true, Some(_)) => return None,
        };
        Some(Way::Put { verb, at, spot, door })
    }

    /// Something in a room is put on some surface there, or let go.
    fn in_room(&mut self, room: NodeId) -> Option<Way> {
        let spot = self.spot(room)?;
        Some(Way::Put { verb: Verb::Drop, at: room, spot, door: None })
    }

    fn is_room(&self, id: NodeId) -> bool {
        self.now.graph.node(id).is_some_and(|node| node.kind() == NodeKind::Room)
    }
}

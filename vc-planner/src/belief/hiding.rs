//! The things still missing: found, lost, or guessed anew after their place was seen without them.

use rand_chacha::rand_core::Rng;
use vc_graph::{Node, NodeId, NodeKind, Observation, Place, Property, Relation};

use super::places::{in_view, left};
use super::{Belief, Learned};
use crate::prior::Supposed;

impl Belief {
    /// Supposes something about one more missing thing.
    pub(super) fn weigh(&mut self, id: NodeId) {
        let Some(class) = self.graph.node(id).map(|n| n.class().clone()) else { return };
        if let Some(known) = self.supposed.get_mut(&class) {
            known.missing += 1;
            self.spread();
            return;
        }
        let weights = self.prior.weights(&self.graph, id, &self.kinds);
        let likely = weights.as_ref().map(|w| w.likely(&self.kinds));
        let left = likely.as_deref().map_or([1.0; 2], |likely| left(likely, &self.kinds, &self.seen));
        self.supposed.insert(class, Supposed { example: id, weights, likely, stale: false, left, missing: 1 });
    }

    /// Notes what is found and which places are in view, and guesses anew what that
    /// disproves.
    pub(super) fn take_in(&mut self, seen: &Observation, learned: &mut Learned) {
        self.spread();
        let mut lost = self.lost(seen);
        if self.missing.is_empty() && lost.is_empty() && !self.in_unknown_home {
            return;
        }
        let found: Vec<NodeId> = self.missing.iter().map(|(id, _)| *id).filter(|id| seen.sees(*id)).collect();
        found.iter().for_each(|&id| self.find(seen, id));
        self.spread();
        // Both are in the order of numbers.
        self.missing.retain(|(id, _)| found.binary_search(id).is_err());
        if self.look_at_places(seen) || !found.is_empty() {
            self.tidiness.settle(self.supposed.values(), self.unseen_share());
        }
        self.resample(learned);
        lost.drain(..).for_each(|id| self.lose(id, learned));
    }

    /// Things that are not where they were: somebody else has taken them.
    fn lost(&self, seen: &Observation) -> Vec<NodeId> {
        let Some(room) = seen.room().filter(|_| !self.knows_all() && self.graph.agents().len() > 1) else {
            return Vec::new();
        };
        let gone = |id: &NodeId| {
            let movable =
                self.known.contains(*id) && self.graph.node(*id).is_some_and(|n| n.affords(Property::Graspable));
            let place = self.graph.place(*id).unwrap_or(Place { relation: Relation::InRoom, at: room });
            movable && !seen.sees(*id) && self.graph.holder(*id).is_none() && in_view(seen, &place)
        };
        self.graph.in_room(room).filter(gone).collect()
    }

    /// Takes what others went out of view with to have been put down somewhere; whether there
    /// is any.
    pub(crate) fn let_go_of_held(&mut self) -> bool {
        let away = self.graph.agents().iter().filter(|&&id| !self.knows_all() && id != self.agent && !self.sees(id));
        let held: Vec<NodeId> =
            away.flat_map(|&id| self.graph.held(id)).filter(|id| self.known.contains(*id)).collect();
        held.iter().for_each(|&id| self.lose(id, &mut Learned::default()));
        !held.is_empty()
    }

    fn lose(&mut self, id: NodeId, learned: &mut Learned) {
        self.known.remove(id);
        self.weigh(id);
        let place = self.sample(id);
        let position = self.missing.partition_point(|(other, _)| *other < id);
        self.missing.insert(position, (id, place));
        self.suppose(id, place);
        learned.disproved.push(id);
    }

    /// A missing thing is found: it tells how tidy the home is.
    fn find(&mut self, seen: &Observation, id: NodeId) {
        let even = self.even();
        let place =
            seen.places(id).next().or_else(|| Some(Place { relation: Relation::InRoom, at: seen.room_of(id)? }));
        let at = place.and_then(|place| self.places.iter().position(|p| *p == place));
        let Some(class) = self.graph.node(id).and_then(|n| self.supposed.get_mut(n.class())) else { return };
        class.missing = class.missing.saturating_sub(1);
        // Where it is found again after it was moved says nothing.
        if let (Some(likely), Some(at)) = (&class.likely, at.filter(|&at| !self.seen[at])) {
            let kind = self.kinds.of_place(at);
            self.tidiness.found(likely[kind], even);
            class.find(kind);
        }
    }

    /// Notes which places are in view now; whether there are new ones.
    fn look_at_places(&mut self, seen: &Observation) -> bool {
        let mut new = false;
        for (index, place) in self.places.iter().enumerate() {
            if self.seen[index] || !in_view(seen, place) {
                continue;
            }
            (self.seen[index], new) = (true, true);
            self.supposed.values_mut().for_each(|class| class.leave_out(self.kinds.of_place(index)));
        }
        new
    }

    /// Expects to get at a thing no more, nor at anything on or in it: what is only guessed
    /// there is guessed elsewhere, what is known there cannot be picked up. Whether there was
    /// anything to expect.
    pub(crate) fn exclude(&mut self, id: NodeId) -> bool {
        if self.graph.node(id).is_none_or(|n| n.kind() != NodeKind::Object) || self.excluded.contains(&id) {
            return false;
        }
        self.excluded.push(id);
        self.leave_out_excluded();
        self.resample(&mut Learned::default());
        let known = |n: &NodeId| self.graph.rests_at(*n, id) && !self.is_missing(*n);
        let there: Vec<NodeId> = self.graph.nodes().map(Node::id).filter(known).collect();
        for thing in there {
            self.bar(thing, Property::Graspable);
        }
        true
    }

    /// Looks for nothing where it cannot get.
    fn leave_out_excluded(&mut self) {
        for index in 0..self.places.len() {
            let at = self.places[index].at;
            let out = self.excluded.iter().any(|&id| id == at || self.graph.rests_at(at, id));
            if out && !self.seen[index] {
                self.seen[index] = true;
                self.supposed.values_mut().for_each(|class| class.leave_out(self.kinds.of_place(index)));
            }
        }
    }

    fn resample(&mut self, learned: &mut Learned) {
        for index in 0..self.missing.len() {
            let (id, place) = self.missing[index];
            // If there is no place at all, there is nothing to disprove.
            if self.seen.get(place).is_some_and(|seen| *seen) {
                let place = self.sample(id);
                self.missing[index].1 = place;
                self.suppose(id, place);
                learned.disproved.push(id);
            }
        }
    }

    /// A place that has not been looked at, by its chance; all again, when none is
    /// left.
    pub(super) fn sample(&mut self, id: NodeId) -> usize {
        if !self.has_no_place() && self.seen.iter().all(|&seen| seen) {
            self.widen();
        }
        // 53 bits make a number from 0 up to 1.
        let mut draw = (self.rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let Some(chances) = self.chances_of(id) else { return 0 };
        let mut last = 0;
        for (i, _, _) in self.sites() {
            last = i;
            draw -= chances.at(i);
            if draw < 0.0 {
                break;
            }
        }
        last
    }

    fn widen(&mut self) {
        self.seen.fill(false);
        self.widened += 1;
        self.supposed.values_mut().for_each(|class| class.left = [1.0; 2]);
        self.leave_out_excluded();
        self.tidiness.settle(self.supposed.values(), 1.0);
    }
}

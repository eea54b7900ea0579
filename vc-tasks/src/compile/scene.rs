//! Atoms read from scenes.

use vc_graph::goal::{Predicate, Situation};
use vc_graph::{Change, NodeId, Observation, Relation};

use super::{Atom, Bits, Known, Program};

impl Program {
    /// Which atoms are true in a situation. Costs a look at the scene for each.
    pub fn read(&self, now: &Situation<'_>) -> Bits {
        let mut bits = self.bits();
        for (index, atom) in self.atoms().iter().enumerate() {
            bits.set(index, now.holds(atom.predicate, atom.things));
        }
        bits
    }

    /// Which atoms are true as far as an agent sees: those of which it sees all
    /// things, and what has been done.
    pub fn read_seen(&self, now: &Situation<'_>, seen: &Observation) -> Known {
        let mut known = Known::nothing(self);
        for (index, atom) in self.atoms().iter().enumerate() {
            if atom.is_deed() || atom.things.iter().flatten().all(|&id| seen.sees(id)) {
                known.learn(index, now.holds(atom.predicate, atom.things));
            }
        }
        known
    }
}

/// What can change an atom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wake {
    /// A change of one of its things.
    Things,
    /// Any change of places or poses: it reaches through other things.
    Places,
    /// Something done.
    Events,
}

pub(super) fn wake(atom: &Atom) -> Wake {
    match atom.predicate {
        Predicate::Did(_) => Wake::Events,
        Predicate::Relation(Relation::Inside | Relation::Near) => Wake::Places,
        _ => Wake::Things,
    }
}

/// The things a change is about; none for nodes that come or go.
pub(super) fn changed(change: &Change) -> [Option<NodeId>; 2] {
    match change {
        Change::States { id, .. } | Change::Pose { id, .. } | Change::Contents { id, .. } => [Some(*id), None],
        Change::Link(edge) | Change::Unlink(edge) => [Some(edge.from), Some(edge.to)],
        _ => [None, None],
    }
}

/// Whether a change can change places or poses.
pub(super) fn moves(change: &Change) -> bool {
    matches!(change, Change::Link(_) | Change::Unlink(_) | Change::Pose { .. })
}

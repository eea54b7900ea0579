//! Reading atoms from scenes.

use vc_graph::goal::{Predicate, Situation};
use vc_graph::{Change, NodeId, Observation, Relation};

use super::{Atom, Bits, Known, Program};

impl Program {
    /// The atoms that are true in a situation. Costs one read of the scene for each.
    pub fn read(&self, now: &Situation<'_>) -> Bits {
        let mut bits = self.bits();
        for (index, atom) in self.atoms().iter().enumerate() {
            bits.set(index, now.holds(atom.predicate, atom.things));
        }
        bits
    }

    /// The atoms as far as an agent observes them: those whose objects it sees, and those about
    /// executed actions.
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

/// The changes that can affect an atom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wake {
    /// A change of one of its objects.
    Things,
    /// Any change of placements or poses, because the atom depends on other objects as well.
    Places,
    /// An executed action.
    Events,
}

pub(super) fn wake(atom: &Atom) -> Wake {
    match atom.predicate {
        Predicate::Did(_) => Wake::Events,
        Predicate::Relation(Relation::Inside | Relation::Near) => Wake::Places,
        _ => Wake::Things,
    }
}

/// The objects that a change concerns; none for added or removed nodes.
pub(super) fn changed(change: &Change) -> [Option<NodeId>; 2] {
    match change {
        Change::States { id, .. } | Change::Pose { id, .. } | Change::Contents { id, .. } => [Some(*id), None],
        Change::Link(edge) | Change::Unlink(edge) => [Some(edge.from), Some(edge.to)],
        _ => [None, None],
    }
}

/// Whether a change can alter placements or poses.
pub(super) fn moves(change: &Change) -> bool {
    matches!(change, Change::Link(_) | Change::Unlink(_) | Change::Pose { .. })
}

//! Reading atoms from scenes.

use vc_graph::goal::{Predicate, Situation};
use vc_graph::{Change, NodeId, Observation, Relation};

use super::{Bits, GoalProgram, GroundAtom, Known};

impl GoalProgram {
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
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder, Scope};
    /// use vc_tasks::compile::{GoalProgram, Verdict};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table)".parse()?, &now)?;
    /// let known = program.read_seen(&now, &graph.observe(me, Scope::Room));
    /// assert_eq!(program.verdict(&known), Verdict::True);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn read_seen(&self, now: &Situation<'_>, seen: &Observation) -> Known {
        let mut known = Known::nothing(self);
        for (index, atom) in self.atoms().iter().enumerate() {
            if atom.is_about_action() || atom.things.iter().flatten().all(|&id| seen.sees(id)) {
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

pub(super) fn wake(atom: &GroundAtom) -> Wake {
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

//! An emulation of Watch-And-Help's agent, to compare with.

use vc_graph::{Action, NodeId, Observation, Place, State, Verb};
use vc_tasks::WorldError;

use crate::policy::{Brief, Policy, Reaction};
use crate::{Belief, Decision, Learned, Newcomer, Plan};

/// The faithful planner with the habits of Watch-And-Help's hierarchical planner, as
/// published (Puig et al., ICLR 2021): it carries one thing at a time, and closes what
/// it has opened before it leaves it. An emulation from the description; none of its
/// code is here. In two points it is kinder than the original: surfaces are places of
/// its belief, and it walks to a thing in another room in one action, not by the room.
#[derive(Debug, Clone)]
pub struct Habitual {
    inner: Newcomer,
    agent: NodeId,
    /// What it has opened and not closed again.
    opened: Vec<NodeId>,
}

impl Default for Habitual {
    fn default() -> Self {
        Self { inner: Newcomer::faithful(), agent: NodeId(0), opened: Vec::new() }
    }
}

impl Habitual {
    /// The container to close before going away with an action.
    fn left_open(&self, action: &Action) -> Option<NodeId> {
        let graph = self.inner.belief()?.graph();
        // Who goes on to something in it does not leave it.
        let inside = |id: NodeId| action.object.and_then(|o| graph.place(o)).is_some_and(|p| p.at == id);
        let leaves = action.verb == Verb::Walk;
        let open = |id: &&NodeId| graph.node(**id).is_some_and(|n| n.is(State::Open)) && graph.near(self.agent, **id);
        self.opened.iter().rev().find(open).copied().filter(|id| leaves && action.object != Some(*id) && !inside(*id))
    }
}

impl Policy for Habitual {
    fn name(&self) -> &str {
        "habitual"
    }

    fn begin(&mut self, brief: &Brief<'_>) {
        (self.agent, self.opened) = (brief.agent, Vec::new());
        self.inner.begin(brief);
    }

    fn see(&mut self, seen: &Observation) -> Learned {
        self.inner.see(seen)
    }

    fn decide(&mut self) -> Decision {
        let decision = self.inner.decide();
        if let Decision::Act(action, _) = &decision
            && let Some(id) = self.left_open(action)
        {
            return Decision::Act(Action::one(Verb::Close, id), Plan::default());
        }
        decision
    }

    fn did(&mut self, action: &Action) {
        match action.verb {
            Verb::Open => self.opened.extend(action.object),
            Verb::Close => self.opened.retain(|id| Some(*id) != action.object),
            _ => {}
        }
        self.inner.did(action);
    }

    fn refused(&mut self, action: &Action, why: &WorldError) -> Reaction {
        self.inner.refused(action, why)
    }

    fn belief(&self) -> Option<&Belief> {
        self.inner.belief()
    }

    fn guesses(&self) -> Vec<(NodeId, Option<Place>)> {
        self.inner.guesses()
    }
}

//! Things that hands under control hold and let go, as the transition rule has it.

use vc_graph::{Action, NodeId, Refusal, State, Verb, rule};
use vc_physics::{BodyRole, Hand};

use crate::environment::Environment;
use crate::environment::execute::load_of;
use crate::environment::observe::moved_by_rule;

/// A node, and the number of its moving part where it is that.
type Held = (NodeId, Option<usize>);

impl Environment {
    /// The reasons of the rule against holding what is between fingers and thumb: for a moving part those against opening
    /// or closing it.
    pub(super) fn hold_refusals(&self, agent: NodeId, (id, part): Held) -> Vec<Refusal> {
        rule::refusals(&self.graph, agent, &Action::one(self.verb_of(id, part), id))
    }

    /// The verb of which holding something is the beginning.
    fn verb_of(&self, id: NodeId, part: Option<usize>) -> Verb {
        let is_open = self.graph.node(id).is_some_and(|node| node.is(State::Open));
        match part {
            None => Verb::Grab,
            Some(_) if is_open => Verb::Close,
            Some(_) => Verb::Open,
        }
    }

    /// Lets the graph follow what a hand has let go, and holds what its fingers have closed around.
    pub(super) fn follow_hold(&mut self, agent: NodeId, hand: Hand) {
        let Some(guided) = self.world.agent(agent).ok().and_then(|agent| agent.guided(hand)) else { return };
        let said = self.graph.related(agent, hand.relation()).next();
        let falls = |id: &NodeId| self.world.role(*id) == Some(BodyRole::Loose);
        if let Some(lost) = said.filter(falls) {
            self.bring_about(agent, &Action::one(Verb::Drop, lost), lost);
            self.set_adrift(&self.graph.carried_with(lost));
        }
        let loose = guided.touches.iter().copied().filter(|id| self.world.role(*id) == Some(BodyRole::Loose));
        let loose: Vec<NodeId> = loose.collect();
        self.set_adrift(&loose);
        self.excuse(&guided.touches);
        let Some(between) = guided.between else { return };
        if self.hold_refusals(agent, between).is_empty() {
            self.hold(agent, hand, between);
        }
    }

    fn hold(&mut self, agent: NodeId, hand: Hand, (id, part): Held) {
        let load = load_of(&self.graph, id);
        if self.world.grasp(agent, hand, &load).is_err() || part.is_some() {
            return;
        }
        self.bring_about(agent, &Action::grab(id), id);
        let mut edit = self.graph.edit();
        // The body holds it with this hand, so it is empty in the graph.
        let _ = edit.hold_in(agent, hand.relation(), id);
        let changes = edit.commit();
        self.clock.note(changes);
        self.tell_taken(agent, id);
    }

    /// Carries out the effects of an action that bodies have done.
    fn bring_about(&mut self, agent: NodeId, action: &Action, id: NodeId) {
        self.clock.about_to_change(&self.graph);
        for effect in rule::effects(self.graph.vocabulary(), action) {
            // The graph can say all that bodies do.
            let changes = rule::carry_out(&mut self.graph, agent, &effect).unwrap_or_default();
            self.clock.changed.extend(changes.changes().iter().filter_map(moved_by_rule));
            self.clock.note(changes);
        }
        self.clock.changed.push(id);
        self.tell_others(agent, action);
    }
}

//! Exploration: an agent that does not know what the home contains explores it before it reports a goal as
//! unreachable.

use vc_graph::goal::Comparison;
use vc_graph::{Action, Goal, NodeId, Place, Relation, Verb};

use super::{Agent, Decision};

impl Agent {
    /// Whether unknown things might change a decision.
    pub(super) fn may_be_rash(&self, decision: &Decision) -> bool {
        self.belief.is_in_unknown_home()
            && match decision {
                Decision::GiveUp(_) => true,
                Decision::Done => speaks_of_all(&self.goal),
                Decision::Act(..) => false,
            }
    }

    /// Looks at an unseen place: rooms first, then closed containers, the nearest first.
    pub(super) fn explore(&mut self) -> Option<Decision> {
        let graph = self.belief.graph();
        let here = graph.room_of(self.id);
        let room = |place: &Place| graph.room_of(place.at);
        let far = |place: &Place| {
            (place.relation == Relation::Inside, !graph.near(self.id, place.at), room(place) != here, place.at)
        };
        let place = self.belief.possible_places().filter(|place| room(place).is_some()).min_by_key(far)?;
        let walk = |at: NodeId| Action::one(Verb::Walk, at);
        Some(match (place.relation, room(&place)) {
            (Relation::Inside, _) => self.go_and(Action::one(Verb::Open, place.at)),
            (_, Some(room)) => self.act(walk(room), Vec::new()),
            _ => self.act(walk(place.at), Vec::new()),
        })
    }
}

/// Whether a goal is about absence or about all things of a kind: then it is not certain to hold while there
/// may be further things.
fn speaks_of_all(goal: &Goal) -> bool {
    match goal {
        Goal::Literal(_) => false,
        Goal::Count { comparison, .. } => *comparison != Comparison::AtLeast,
        Goal::And(_) | Goal::Or(_) | Goal::Then(_) | Goal::Exists(_) | Goal::Eventually(_) | Goal::AtEnd(_) => {
            goal.parts().into_iter().any(speaks_of_all)
        }
        _ => true,
    }
}

//! Ways to make a predicate true or false for given things.

use vc_graph::goal::Predicate;
use vc_graph::{Action, Condition, Effect, NodeId, Property, Relation, State, Verb};

use super::View;
use crate::open_condition::OpenCondition;

impl View<'_> {
    /// The conditions that would make a predicate true for given things.
    pub(super) fn conditions(&self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Vec<OpenCondition> {
        let me = self.now.agent;
        let hold = |c| vec![OpenCondition::Hold(c)];
        match (predicate, things) {
            (Predicate::State(state), [Some(id), _]) => hold(Condition::In(id, state)),
            (Predicate::Holds, [Some(agent), Some(id)]) if agent == me => hold(Condition::Holding(id)),
            (Predicate::Relation(relation), [Some(from), Some(to)]) => self.relation_conditions(from, relation, to),
            (Predicate::Did(verb), [object, target]) => {
                let things: Vec<NodeId> = object.into_iter().chain(target).collect();
                Action::with(verb, &things).map(OpenCondition::Do).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    fn relation_conditions(&self, from: NodeId, relation: Relation, to: NodeId) -> Vec<OpenCondition> {
        let me = self.now.agent;
        let room = self.graph().rooms().contains(&to);
        let related = |relation| vec![OpenCondition::Hold(Condition::Related(from, relation, to))];
        let fixed = from != me && !Condition::Graspable(from).holds(self.graph(), me);
        if from == to || (fixed && matches!(relation, Relation::On | Relation::Inside | Relation::InRoom)) {
            return Vec::new();
        }
        match relation {
            Relation::On if from == me => {
                let node = self.graph().node(to);
                let affords = |p| node.is_some_and(|n| n.affords(p));
                let lie = affords(Property::Lieable).then_some(Relation::LyingOn);
                let sit = affords(Property::Sittable).then_some(Relation::SittingOn);
                let (first, second) = if self.hints.lying { (lie, sit) } else { (sit, lie) };
                first.into_iter().chain(second).flat_map(related).collect()
            }
            Relation::On if to == me => vec![OpenCondition::Hold(Condition::Worn(from))],
            Relation::Inside | Relation::InRoom if room => related(Relation::InRoom),
            Relation::Near if from == me && room => {
                vec![OpenCondition::Hold(Condition::Related(me, Relation::InRoom, to))]
            }
            Relation::Near if from == me => vec![OpenCondition::Hold(Condition::Near(to))],
            Relation::Facing if from == me => vec![OpenCondition::Hold(Condition::Facing(to))],
            _ => related(relation),
        }
    }

    /// Whether an action ends a state without another one in its place.
    fn left(&self, state: State) -> bool {
        let leaves =
            |effect: &Effect<_>| matches!(effect, Effect::Leave(_, left) | Effect::LeaveOwn(left) if *left == state);
        self.graph().vocabulary().rules().any(|rule| rule.effects.iter().any(leaves))
    }

    /// The conditions that would make a predicate false for given things.
    pub(super) fn undo(&self, predicate: Predicate, things: [Option<NodeId>; 2]) -> Vec<OpenCondition> {
        let me = self.now.agent;
        match (predicate, things) {
            (Predicate::State(State::Sitting | State::Lying), [Some(id), _]) if id == me => {
                vec![OpenCondition::Hold(Condition::Upright)]
            }
            (Predicate::State(state), [Some(id), _]) => {
                let opposites = self.graph().vocabulary().opposites(state);
                let others = opposites.iter().map(|s| Condition::In(id, s));
                others.chain(self.left(state).then_some(Condition::NotIn(id, state))).map(OpenCondition::Hold).collect()
            }
            (Predicate::Holds, [_, Some(id)]) => vec![OpenCondition::Do(Action::one(Verb::Drop, id))],
            (Predicate::Relation(relation), [Some(from), Some(to)]) => match relation {
                Relation::HoldsRight | Relation::HoldsLeft => vec![OpenCondition::Do(Action::one(Verb::Drop, to))],
                Relation::SittingOn | Relation::LyingOn => vec![OpenCondition::Hold(Condition::Upright)],
                Relation::On | Relation::Inside if from == me => vec![OpenCondition::Hold(Condition::Upright)],
                // Picking a thing up does not take it out of the room.
                Relation::Inside | Relation::InRoom if self.graph().rooms().contains(&to) => {
                    let others = self.graph().rooms().iter().filter(|room| **room != to);
                    others.map(|&room| OpenCondition::Hold(Condition::Related(from, Relation::InRoom, room))).collect()
                }
                Relation::On | Relation::Inside | Relation::WornBy | Relation::InRoom => {
                    vec![OpenCondition::Hold(Condition::Holding(from))]
                }
                _ => Vec::new(),
            },
            _ => Vec::new(),
        }
    }
}

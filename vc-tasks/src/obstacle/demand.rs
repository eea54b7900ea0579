//! The abilities that predicates demand of the objects they are about.

use vc_graph::clock::ProcessTable;
use vc_graph::goal::Predicate;
use vc_graph::{Node, NodeKind, Property, Relation, SceneGraph, State, Vocabulary};

/// An ability that a predicate demands of an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Demand {
    /// It can be carried, or goes by itself.
    Moves,
    /// It can be picked up.
    Graspable,
    /// Things can be put on it.
    Carries,
    /// Things can be put in it, or poured.
    Encloses,
    /// It is an agent.
    Person,
    /// It can be brought into a state, by an action or by a process.
    Enters(State),
    /// It has an affordance.
    Affords(Property),
}

/// The ability that a predicate demands of the object in a position, if it demands any.
pub(super) fn demand(predicate: Predicate, position: usize) -> Option<Demand> {
    use Relation as R;
    Some(match (predicate, position) {
        (Predicate::Relation(R::On | R::Inside), 0) => Demand::Moves,
        (Predicate::Holds | Predicate::Relation(R::HoldsRight | R::HoldsLeft), 1) => Demand::Graspable,
        (Predicate::Relation(R::On), 1) => Demand::Carries,
        (Predicate::Relation(R::Inside), 1) => Demand::Encloses,
        (Predicate::Relation(R::SittingOn), 1) => Demand::Affords(Property::Sittable),
        (Predicate::Relation(R::LyingOn), 1) => Demand::Affords(Property::Lieable),
        (Predicate::Relation(R::SittingOn | R::LyingOn), 0) => Demand::Person,
        (Predicate::Relation(R::WornBy), 0) => Demand::Affords(Property::Wearable),
        (Predicate::State(state), 0) => Demand::Enters(state),
        _ => return None,
    })
}

impl Demand {
    /// Whether an object meets the demand, as the transition rules and the processes have it.
    pub(super) fn is_met(self, node: &Node, graph: &SceneGraph) -> bool {
        match self {
            Self::Moves => node.is_graspable() || node.kind() == NodeKind::Agent,
            Self::Graspable => node.is_graspable(),
            Self::Carries => node.carries(),
            Self::Encloses => {
                node.kind() == NodeKind::Room || node.encloses(graph.classes()) || node.receives_liquids()
            }
            Self::Person => node.kind() == NodeKind::Agent,
            Self::Enters(state) => {
                let by_action = by_action(state, graph.vocabulary()).is_none_or(|demand| demand.is_met(node, graph));
                by_action || ProcessTable::builtin().brings_into(graph, node.id(), state)
            }
            Self::Affords(property) => node.affords(property),
        }
    }

    /// The property that an object lacks which does not meet the demand.
    pub(super) fn as_str(self, words: &Vocabulary) -> &'static str {
        match self {
            Self::Moves | Self::Graspable => "graspable",
            Self::Carries => "a surface",
            Self::Encloses => "a container",
            Self::Person => "a person",
            Self::Affords(Property::Plug) => "with a plug",
            Self::Affords(property) => vc_graph::Word::as_str(property),
            Self::Enters(state) => by_action(state, words).map_or("", |demand| demand.as_str(words)),
        }
    }
}

/// The demand of the actions that bring a state about. Things are heated and cooled that can be carried to a machine.
fn by_action(state: State, words: &Vocabulary) -> Option<Demand> {
    match state {
        State::Hot | State::Cold => Some(Demand::Graspable),
        state => words.needs(state).map(Demand::Affords),
    }
}

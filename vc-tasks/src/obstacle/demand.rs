//! The affordances that predicates demand of the objects they are about.

use vc_graph::goal::Predicate;
use vc_graph::{Node, NodeKind, Property, Relation, State};

/// Whether a node has an affordance.
pub(super) type Fits = fn(&Node) -> bool;

/// The affordance that a predicate demands of the object in a position.
pub(super) fn demand(predicate: Predicate, position: usize) -> (Fits, &'static str) {
    let any: (Fits, &'static str) = (|_| true, "");
    match (predicate, position) {
        (Predicate::Relation(Relation::On | Relation::Inside), 0) | (Predicate::Holds, 1) => {
            (|n| n.affords(Property::Graspable), "graspable")
        }
        (Predicate::Relation(Relation::On), 1) => (
            |n| {
                [Property::Surface, Property::Sittable, Property::Lieable, Property::Container, Property::Heater]
                    .into_iter()
                    .any(|p| n.affords(p))
            },
            "a surface",
        ),
        (Predicate::Relation(Relation::Inside), 1) => (
            |n| n.kind() == NodeKind::Room || n.affords(Property::Container) || n.affords(Property::Recipient),
            "a container",
        ),
        (Predicate::Relation(Relation::SittingOn), 1) => (|n| n.affords(Property::Sittable), "sittable"),
        (Predicate::Relation(Relation::LyingOn), 1) => (|n| n.affords(Property::Lieable), "lieable"),
        (Predicate::Relation(Relation::SittingOn | Relation::LyingOn), 0) => {
            (|n| n.kind() == NodeKind::Agent, "a person")
        }
        (Predicate::Relation(Relation::WornBy), 0) => (|n| n.affords(Property::Wearable), "wearable"),
        (Predicate::State(State::Open | State::Closed), 0) => (|n| n.affords(Property::Openable), "openable"),
        (Predicate::State(State::On | State::Off), 0) => (|n| n.affords(Property::Switchable), "switchable"),
        (Predicate::State(State::PluggedIn | State::PluggedOut), 0) => (|n| n.affords(Property::Plug), "with a plug"),
        (Predicate::State(State::Hot), 0) => (|n| n.is(State::Hot) || n.affords(Property::Graspable), "graspable"),
        (Predicate::State(State::Cold), 0) => (|n| n.is(State::Cold) || n.affords(Property::Graspable), "graspable"),
        (Predicate::State(State::Cooked), 0) => (|n| n.affords(Property::Cookable), "cookable"),
        (Predicate::State(State::Sliced), 0) => (|n| n.affords(Property::Cuttable), "cuttable"),
        (Predicate::State(State::Folded), 0) => (|n| n.affords(Property::Foldable), "foldable"),
        _ => any,
    }
}

//! The reasons why a goal cannot make sense in a scene.

use std::fmt;

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Term};
use vc_graph::{Node, Property, Relation, SceneGraph, State, did_you_mean};

use crate::Task;

/// A reason why a goal cannot be reached in a scene by any agent.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Obstacle {
    /// The scene has too few objects of a class.
    TooFew {
        /// The part of the goal.
        part: String,
        /// The class.
        class: String,
        /// The number of objects needed.
        needs: usize,
        /// The number of objects in the scene.
        has: usize,
        /// Classes of the scene that may have been meant, if the class table does not know the class.
        nearest: Vec<String>,
    },
    /// The scene has objects of the class, but too few with the affordance that is asked for.
    NotAfforded {
        /// The part of the goal.
        part: String,
        /// The class.
        class: String,
        /// The affordance that they lack.
        must_be: &'static str,
    },
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { part, class, needs, has, nearest } => {
                let near = did_you_mean(class, nearest.iter().map(String::as_str));
                write!(f, "`{part}` needs {needs} of `{class}`{near}, the scene has {has}")
            }
            Self::NotAfforded { part, class, must_be } => {
                write!(f, "`{part}` needs `{class}` to be {must_be}, which it is not in this scene")
            }
        }
    }
}

impl Task {
    /// The reasons why the goal makes no sense in a scene; empty if it does make sense. Considers the
    /// parts that must hold, but not negations; one alternative of a disjunction must be possible.
    pub fn obstacles(&self, graph: &SceneGraph) -> Vec<Obstacle> {
        obstacles(&self.goal, graph)
    }
}

fn obstacles(goal: &Goal, graph: &SceneGraph) -> Vec<Obstacle> {
    let mut found = Vec::new();
    look(goal, graph, &mut found);
    found
}

fn look(goal: &Goal, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    match goal {
        Goal::Literal(literal) => look_at(goal, literal, 1, graph, found),
        Goal::Count { literal, comparison: Comparison::AtLeast | Comparison::Exactly, number } => {
            look_at(goal, literal, *number as usize, graph, found);
        }
        Goal::And(parts) | Goal::Then(parts) => parts.iter().for_each(|p| look(p, graph, found)),
        Goal::Or(parts) => {
            let each: Vec<Vec<Obstacle>> = parts.iter().map(|p| obstacles(p, graph)).collect();
            if each.iter().all(|o| !o.is_empty()) {
                found.extend(each.into_iter().flatten());
            }
        }
        Goal::Exists(q) | Goal::ForAll(q) => {
            if let Some(class) = &q.class {
                require(goal, class, 1, graph, found, |_| true, "");
            }
            look(&q.body, graph, found);
        }
        _ => {}
    }
}

fn look_at(part: &Goal, literal: &Literal, number: usize, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    let counted = literal.counted();
    for (position, term) in literal.terms.iter().enumerate() {
        let Term::Class(class) = term else { continue };
        let needs = if Some(position) == counted { number } else { 1 };
        let (fits, must_be) = demand(literal.predicate, position);
        require(part, class, needs, graph, found, fits, must_be);
    }
}

type Fits = fn(&Node) -> bool;

/// The affordance that a predicate demands of the object in a position.
fn demand(predicate: Predicate, position: usize) -> (Fits, &'static str) {
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
            |n| n.kind() == vc_graph::Kind::Room || n.affords(Property::Container) || n.affords(Property::Recipient),
            "a container",
        ),
        (Predicate::Relation(Relation::SittingOn), 1) => (|n| n.affords(Property::Sittable), "sittable"),
        (Predicate::Relation(Relation::LyingOn), 1) => (|n| n.affords(Property::Lieable), "lieable"),
        (Predicate::State(State::Open | State::Closed), 0) => (|n| n.affords(Property::Openable), "openable"),
        (Predicate::State(State::On | State::Off), 0) => (|n| n.affords(Property::Switchable), "switchable"),
        (Predicate::State(State::Cooked), 0) => (|n| n.affords(Property::Cookable), "cookable"),
        (Predicate::State(State::Sliced), 0) => (|n| n.affords(Property::Cuttable), "cuttable"),
        (Predicate::State(State::Folded), 0) => (|n| n.affords(Property::Foldable), "foldable"),
        _ => any,
    }
}

fn require(
    part: &Goal,
    class: &str,
    needs: usize,
    graph: &SceneGraph,
    found: &mut Vec<Obstacle>,
    fits: impl Fn(&Node) -> bool,
    must_be: &'static str,
) {
    let all = graph.of_class(class);
    let fit = all.iter().filter(|&&id| graph.node(id).is_some_and(&fits)).count();
    let (part, class) = (part.to_string(), class.to_owned());
    if all.len() < needs {
        let nearest = graph.nearest_classes(&class).into_iter().map(str::to_owned).collect();
        found.push(Obstacle::TooFew { part, class, needs, has: all.len(), nearest });
    } else if fit < needs {
        found.push(Obstacle::NotAfforded { part, class, must_be });
    }
}

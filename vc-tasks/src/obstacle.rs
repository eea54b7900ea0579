//! The reasons why a goal cannot make sense in a scene.

use std::fmt;

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Term};
use vc_graph::{NameMismatch, Node, NodeId, Property, Relation, SceneGraph, State, did_you_mean};

use crate::attainable::brought_about;
use crate::{Lost, Task, vacuous};

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
        /// If the scene has none, a class of which it is a kind and of which the scene has objects, and their number.
        wider: Option<Wider>,
    },
    /// Neither the class table nor the scene knows the class.
    UnknownClass {
        /// The name of none.
        class: String,
        /// Classes that may have been meant.
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
    /// Too few things are in the state that is asked for, and no action brings others into it.
    NoAction {
        /// The part of the goal.
        part: String,
        /// The class or label.
        thing: String,
        /// The state.
        state: State,
    },
    /// A label of the goal is of another class than its node.
    Misnomer(NameMismatch),
    /// The scene has no node of a number that the goal names.
    NoSuchNode(String),
    /// An agent is to hold more at once than it has hands.
    TooManyHeld {
        /// The parts of the goal that say so.
        parts: String,
        /// The number of objects to be held, at least.
        held: usize,
    },
}

/// A class that another one is a kind of, and of which a scene has objects.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wider {
    /// The class.
    pub class: String,
    /// The name in the class table of the one that is a kind of it: of `lamp` that is `table_lamp`.
    pub of: String,
    /// The number of objects in the scene.
    pub has: usize,
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { part, class, needs, has, nearest, wider } => {
                let near = did_you_mean(class, nearest.iter().map(String::as_str));
                write!(f, "`{part}` needs {needs} of `{class}`{near}, the scene has {has}")?;
                wider.as_ref().map_or(Ok(()), |Wider { class, of, has }| {
                    write!(f, "; it has {has} of `{class}`, of which `{of}` is a kind")
                })
            }
            Self::UnknownClass { class, nearest } => {
                write!(f, "there is no class `{class}`{}", did_you_mean(class, nearest.iter().map(String::as_str)))
            }
            Self::NotAfforded { part, class, must_be } => {
                write!(f, "`{part}` needs `{class}` to be {must_be}, which it is not in this scene")
            }
            Self::NoAction { part, thing, state } => {
                write!(f, "`{part}` needs `{thing}` to be {state}, which it is not here, and no action makes it so")
            }
            Self::Misnomer(misnomer) => misnomer.fmt(f),
            Self::NoSuchNode(label) => write!(f, "there is no `{label}` in this scene"),
            Self::TooManyHeld { parts, held } => {
                write!(f, "`{parts}` needs {held} things to be held at once, and an agent has {HANDS} hands")
            }
        }
    }
}

impl Task {
    /// The reasons why the goal makes no sense in a scene; empty if it does make sense. Considers the
    /// parts that must hold, but not negations; one alternative of a disjunction must be possible. Labels, nodes and
    /// classes that there are not are reported wherever they stand.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// for class in ["milk", "apple", "bread"] {
    ///     scene.add_in(kitchen, Draft::new(class))?;
    /// }
    /// let scene = scene.build();
    /// let why = |goal: &str| -> Result<String, vc_graph::goal::GoalError> {
    ///     Ok(Task::new("t", goal.parse()?).obstacles(&scene).iter().map(ToString::to_string).collect())
    /// };
    /// assert!(why("Holds(milk) & Holds(apple) & Holds(bread)")?.ends_with("an agent has 2 hands"));
    /// assert!(why("On(apple, floor.2)")?.contains("`floor.2` names a thing that is milk.2"));
    /// assert_eq!(why("Holds(milk.99)")?, "there is no `milk.99` in this scene");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn obstacles(&self, graph: &SceneGraph) -> Vec<Obstacle> {
        let parts = obstacles(&self.goal, graph);
        let lacks = |told: &str| parts.iter().any(|o| matches!(o, Obstacle::TooFew { class, .. } if class == told));
        let told = |o: &Obstacle| matches!(o, Obstacle::UnknownClass { class, .. } if lacks(class));
        let mut found: Vec<Obstacle> = self.goal.name_mismatches(graph).into_iter().map(Obstacle::Misnomer).collect();
        found.extend(unknown(self.goal.terms(), graph).into_iter().filter(|obstacle| !told(obstacle)));
        found.extend(parts);
        found
    }

    /// The reason why the goal is lost in a scene before anything is done: a label of another class than its node, or a
    /// node or class that there is not, in a part that must not hold or must hold for all. Such a part would hold at
    /// once, as nothing on the table is a `mugg`. A known class of which the scene has no object is no such name.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// scene.add(Draft::new("kitchen_table"))?;
    /// let scene = scene.build();
    /// let why = |goal: &str| -> Result<_, vc_graph::goal::GoalError> {
    ///     Ok(Task::new("t", goal.parse()?).lost(&scene).map(|lost| lost.to_string()))
    /// };
    /// let told = why("always !On(mugg, kitchen_table)")?;
    /// assert_eq!(told.as_deref(), Some("there is no class `mugg` (did you mean `mug`?)"));
    /// assert_eq!(why("!On(mug, kitchen_table)")?, None); // there is no mug, and so none on the table
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lost(&self, graph: &SceneGraph) -> Option<Lost> {
        let mut found: Vec<Obstacle> = self.goal.name_mismatches(graph).into_iter().map(Obstacle::Misnomer).collect();
        found.extend(unknown(vacuous::terms(&self.goal), graph));
        (!found.is_empty()).then_some(Lost::Misnamed(found))
    }
}

/// The number of things that an agent can hold at once.
const HANDS: usize = 2;

/// The nodes and classes that terms name and that there are not, each once.
fn unknown(terms: Vec<Term>, graph: &SceneGraph) -> Vec<Obstacle> {
    let mut found = Vec::new();
    for obstacle in terms.into_iter().filter_map(|term| unknown_term(term, graph)) {
        if !found.contains(&obstacle) {
            found.push(obstacle);
        }
    }
    found
}

fn unknown_term(term: Term, graph: &SceneGraph) -> Option<Obstacle> {
    match term {
        Term::Node(class, id) if graph.node(id).is_none() => {
            let label = class.map_or_else(|| format!("#{}", id.0), |class| format!("{class}.{}", id.0));
            Some(Obstacle::NoSuchNode(label))
        }
        Term::Class(class) if graph.classes().get(&class).is_none() && graph.of_class(&class).is_empty() => {
            let nearest = graph.classes().nearest(&class).into_iter().map(str::to_owned).collect();
            Some(Obstacle::UnknownClass { class, nearest })
        }
        _ => None,
    }
}

/// A class that a class is a kind of and of which a scene has objects: the one of which it has the fewest.
fn wider(class: &str, graph: &SceneGraph) -> Option<Wider> {
    let known = graph.classes().get(class)?;
    let has = known.parents.iter().map(|parent| (graph.of_class(parent).len(), parent)).filter(|(has, _)| *has > 0);
    has.min().map(|(has, parent)| Wider { class: parent.to_string(), of: known.name.to_string(), has })
}

/// Whether more is to be held at once than there are hands: things of parts that no thing can serve both of.
fn hands(parts: &[Goal], graph: &SceneGraph) -> Option<Obstacle> {
    let (mut serving, mut told, mut held): (Vec<NodeId>, Vec<String>, usize) = (Vec::new(), Vec::new(), 0);
    for part in parts {
        let Some((thing, number)) = held_by_me(part) else { continue };
        let things = match thing {
            Term::Class(class) => graph.of_class(class),
            Term::Node(_, id) => vec![*id],
            _ => continue,
        };
        if !things.is_empty() && !things.iter().any(|thing| serving.contains(thing)) {
            serving.extend(things);
            told.push(part.to_string());
            held += number;
        }
    }
    (held > HANDS).then(|| Obstacle::TooManyHeld { parts: told.join(" & "), held })
}

/// The things an agent is to hold by a part of a goal, and their number.
fn held_by_me(part: &Goal) -> Option<(&Term, usize)> {
    let (literal, number) = match part {
        Goal::Literal(literal) => (literal, 1),
        Goal::Count { literal, comparison: Comparison::AtLeast | Comparison::Exactly, number } => {
            (literal, *number as usize)
        }
        _ => return None,
    };
    let in_hand =
        matches!(literal.predicate, Predicate::Holds | Predicate::Relation(Relation::HoldsRight | Relation::HoldsLeft));
    match literal.terms.as_slice() {
        [Term::Me, thing] if in_hand => Some((thing, number)),
        _ => None,
    }
}

fn obstacles(goal: &Goal, graph: &SceneGraph) -> Vec<Obstacle> {
    let mut found = Vec::new();
    look(goal, graph, &mut found);
    found.extend(hands(std::slice::from_ref(goal), graph));
    found
}

fn look(goal: &Goal, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    match goal {
        Goal::Literal(literal) => look_at(goal, literal, 1, graph, found),
        Goal::Count { literal, comparison: Comparison::AtLeast | Comparison::Exactly, number } => {
            look_at(goal, literal, *number as usize, graph, found);
        }
        Goal::And(parts) | Goal::Then(parts) => {
            parts.iter().for_each(|p| look(p, graph, found));
            found.extend(hands(parts, graph).filter(|_| matches!(goal, Goal::And(_))));
        }
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
    let (counted, before) = (literal.counted(), found.len());
    for (position, term) in literal.terms.iter().enumerate() {
        let Term::Class(class) = term else { continue };
        let needs = if Some(position) == counted { number } else { 1 };
        let (fits, must_be) = demand(literal.predicate, position);
        require(part, class, needs, graph, found, fits, must_be);
    }
    if found.len() == before {
        found.extend(beyond(part, literal, number, graph));
    }
}

/// Whether fewer things than needed are in the state of a literal, and no action brings any other into it.
fn beyond(part: &Goal, literal: &Literal, needs: usize, graph: &SceneGraph) -> Option<Obstacle> {
    let (Predicate::State(state), Some(term)) = (literal.predicate, literal.terms.first()) else { return None };
    let things = match term {
        Term::Class(class) => graph.of_class(class),
        Term::Node(_, id) => vec![*id],
        Term::Me => graph.agents().to_vec(),
        Term::Variable(_) | Term::Anything => return None,
    };
    let there = things.iter().filter_map(|id| graph.node(*id)).filter(|node| node.is(state)).count();
    let never = there < needs && !brought_about(literal.predicate);
    never.then(|| Obstacle::NoAction { part: part.to_string(), thing: term.to_string(), state })
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
            |n| {
                n.kind() == vc_graph::NodeKind::Room || n.affords(Property::Container) || n.affords(Property::Recipient)
            },
            "a container",
        ),
        (Predicate::Relation(Relation::SittingOn), 1) => (|n| n.affords(Property::Sittable), "sittable"),
        (Predicate::Relation(Relation::LyingOn), 1) => (|n| n.affords(Property::Lieable), "lieable"),
        (Predicate::Relation(Relation::SittingOn | Relation::LyingOn), 0) => {
            (|n| n.kind() == vc_graph::NodeKind::Agent, "a person")
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
        let unknown = graph.classes().get(&class).is_none();
        let of_scene = graph.nearest_classes(&class);
        let nearest = if of_scene.is_empty() && unknown { graph.classes().nearest(&class) } else { of_scene };
        let nearest = nearest.into_iter().map(str::to_owned).collect();
        let wider = if all.is_empty() { wider(&class, graph) } else { None };
        found.push(Obstacle::TooFew { part, class, needs, has: all.len(), nearest, wider });
    } else if fit < needs {
        found.push(Obstacle::NotAfforded { part, class, must_be });
    }
}

//! Finds the obstacles of a goal in a scene.

use vc_graph::clock::ProcessTable;
use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Situation, Term};
use vc_graph::{Node, NodeId, Relation, SceneGraph};

use super::contradiction::contradiction;
use super::demand::demand;
use super::size::too_large;
use super::{BroaderClass, HANDS, Lost, Obstacle};
use crate::attainable::brought_about_by_action;
use crate::vacuous;

/// The obstacles of a goal; see [`Task::obstacles`](crate::Task::obstacles).
pub(crate) fn obstacles(goal: &Goal, graph: &SceneGraph) -> Vec<Obstacle> {
    let goal = &*goal.expanded(graph.vocabulary());
    let parts = of_parts(goal, graph);
    let lacks = |name: &str| parts.iter().any(|o| matches!(o, Obstacle::TooFew { class, .. } if class == name));
    let is_listed = |o: &Obstacle| matches!(o, Obstacle::UnknownClass { class, .. } if lacks(class));
    let mut found = name_mismatches(goal, graph);
    found.extend(unknown(goal.terms(), graph).into_iter().filter(|obstacle| !is_listed(obstacle)));
    found.extend(each_once(undefined(goal)));
    found.extend(too_large(goal, graph));
    found.extend(contradiction(goal, graph));
    found.extend(parts);
    found
}

/// The derived predicates that are left where definitions have taken the place of others, and without which the goal has
/// no meaning: one alternative is enough.
fn undefined(goal: &Goal) -> Vec<Obstacle> {
    match goal {
        Goal::And(parts) | Goal::Then(parts) => parts.iter().flat_map(undefined).collect(),
        Goal::Or(parts) => {
            let each: Vec<Vec<Obstacle>> = parts.iter().map(undefined).collect();
            if each.iter().any(Vec::is_empty) { Vec::new() } else { each.concat() }
        }
        _ => goal.derived_predicates().into_iter().map(Obstacle::NoDefinition).collect(),
    }
}

/// The reason why a goal is lost before anything is done; see [`Task::lost`](crate::Task::lost).
pub(crate) fn lost(goal: &Goal, graph: &SceneGraph) -> Option<Lost> {
    let goal = &*goal.expanded(graph.vocabulary());
    let mut found = name_mismatches(goal, graph);
    found.extend(each_once(undefined(goal)));
    found.extend(too_large(goal, graph));
    found.extend(unknown(vacuous::terms(goal), graph));
    found.extend(contradiction(goal, graph));
    (!found.is_empty()).then_some(Lost::Meaningless(found))
}

/// The labels of a goal that are of another class than their nodes.
fn name_mismatches(goal: &Goal, graph: &SceneGraph) -> Vec<Obstacle> {
    goal.name_mismatches(graph).into_iter().map(Obstacle::NameMismatch).collect()
}

/// Obstacles in their order, without repetitions.
fn each_once(all: Vec<Obstacle>) -> Vec<Obstacle> {
    let mut found = Vec::new();
    for obstacle in all {
        if !found.contains(&obstacle) {
            found.push(obstacle);
        }
    }
    found
}

/// The missing nodes and the unknown classes that terms name, each once.
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
fn broader(class: &str, graph: &SceneGraph) -> Option<BroaderClass> {
    let known = graph.classes().get(class)?;
    let has = known.parents.iter().map(|parent| (graph.of_class(parent).len(), parent)).filter(|(has, _)| *has > 0);
    has.min().map(|(has, parent)| BroaderClass { class: parent.to_string(), of: known.name.to_string(), has })
}

/// Whether more is to be held at once than there are hands: things of parts that no thing can serve both of.
fn hands(parts: &[Goal], graph: &SceneGraph) -> Option<Obstacle> {
    let (mut serving, mut named, mut held): (Vec<NodeId>, Vec<String>, usize) = (Vec::new(), Vec::new(), 0);
    for part in parts {
        let Some((thing, number)) = held_by_me(part) else { continue };
        let things = match thing {
            Term::Class(class) => graph.of_class(class),
            Term::Node(_, id) => vec![*id],
            _ => continue,
        };
        if !things.is_empty() && !things.iter().any(|thing| serving.contains(thing)) {
            serving.extend(things);
            named.push(part.to_string());
            held += number;
        }
    }
    (held > HANDS).then(|| Obstacle::TooManyHeld { parts: named.join(" & "), held })
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

fn of_parts(goal: &Goal, graph: &SceneGraph) -> Vec<Obstacle> {
    let mut found = Vec::new();
    check_goal(goal, graph, &mut found);
    found.extend(hands(std::slice::from_ref(goal), graph));
    found
}

fn check_goal(goal: &Goal, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    match goal {
        Goal::Literal(literal) => check_literal(goal, literal, 1, graph, found),
        Goal::Count { literal, comparison: Comparison::AtLeast | Comparison::Exactly, number } => {
            check_literal(goal, literal, *number as usize, graph, found);
        }
        Goal::And(parts) | Goal::Then(parts) => {
            parts.iter().for_each(|p| check_goal(p, graph, found));
            found.extend(hands(parts, graph).filter(|_| matches!(goal, Goal::And(_))));
        }
        Goal::Or(parts) => {
            let each: Vec<Vec<Obstacle>> = parts.iter().map(|p| of_parts(p, graph)).collect();
            if each.iter().all(|o| !o.is_empty()) {
                found.extend(each.into_iter().flatten());
            }
        }
        Goal::Exists(q) | Goal::ForAll(q) => check_range(goal, q, 1, graph, found),
        Goal::ForN { comparison: Comparison::AtLeast | Comparison::Exactly, number, of } if *number > 0 => {
            check_range(goal, of, *number as usize, graph, found);
        }
        _ => {}
    }
}

fn check_range(part: &Goal, range: &Quantified, number: usize, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    if let Some(class) = &range.class {
        require(part, class, number, graph, found, |_| true, "");
    }
    check_goal(&range.body, graph, found);
}

fn check_literal(part: &Goal, literal: &Literal, number: usize, graph: &SceneGraph, found: &mut Vec<Obstacle>) {
    let (counted, before) = (literal.counted(), found.len());
    for (position, term) in literal.terms.iter().enumerate() {
        let Term::Class(class) = term else { continue };
        let needs = if Some(position) == counted { number } else { 1 };
        let demand = demand(literal.predicate, position);
        let meets = |node: &Node| demand.is_none_or(|demand| demand.is_met(node, graph));
        let fits = |node: &Node| meets(node) || holds_of(literal, position, node.id(), graph);
        require(part, class, needs, graph, found, fits, demand.map_or("", |demand| demand.as_str(graph.vocabulary())));
    }
    if found.len() == before {
        found.extend(unattainable(part, literal, number, graph));
    }
}

/// Whether a literal holds already of an object in one of its positions.
fn holds_of(literal: &Literal, position: usize, object: NodeId, graph: &SceneGraph) -> bool {
    let now = Situation { graph, agent: object, events: &[] };
    let Some(other) = literal.terms.get(1 - position) else {
        return now.holds(literal.predicate, [Some(object), None]);
    };
    let pair = |other: NodeId| if position == 0 { [object, other] } else { [other, object] };
    things(other, graph).into_iter().any(|other| now.holds(literal.predicate, pair(other).map(Some)))
}

/// The nodes that a term stands for, whoever the agent is; none for a variable.
fn things(term: &Term, graph: &SceneGraph) -> Vec<NodeId> {
    match term {
        Term::Class(class) => graph.of_class(class),
        Term::Node(_, id) => vec![*id],
        Term::Me => graph.agents().to_vec(),
        Term::Anything => graph.nodes().map(Node::id).collect(),
        Term::Variable(_) => Vec::new(),
    }
}

/// Whether fewer things than needed are in the state of a literal, and neither an action nor a process brings others
/// into it.
fn unattainable(part: &Goal, literal: &Literal, needs: usize, graph: &SceneGraph) -> Option<Obstacle> {
    let (Predicate::State(state), Some(term)) = (literal.predicate, literal.terms.first()) else { return None };
    if matches!(term, Term::Variable(_) | Term::Anything)
        || brought_about_by_action(graph.vocabulary(), literal.predicate)
    {
        return None;
    }
    let is_so = |id: &NodeId| graph.node(*id).is_some_and(|node| node.is(state));
    let processes = ProcessTable::builtin();
    let attainable = |id: &NodeId| is_so(id) || processes.brings_into(graph, *id, state);
    let never = things(term, graph).iter().filter(|id| attainable(id)).count() < needs;
    never.then(|| Obstacle::NoAction { part: part.to_string(), thing: term.to_string(), state })
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
        let wider = if all.is_empty() { broader(&class, graph) } else { None };
        found.push(Obstacle::TooFew { part, class, needs, has: all.len(), nearest, wider });
    } else if fit < needs {
        found.push(Obstacle::NotAfforded { part, class, must_be });
    }
}

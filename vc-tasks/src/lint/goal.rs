//! Goals in our own notation.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashSet};

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Situation, Term};
use vc_graph::{ClassTable, History, NodeId, Refusal, SceneGraph, Vocabulary, did_you_mean};

use super::cycle::{first_in_cycle, rests};
use super::{Finding, FindingKind, LARGEST, satisfiability};
use crate::attainable::brought_about;
use crate::compile::{CompileError, Compiler, GoalProgram, Things};
use crate::obstacle::too_large;
use crate::{Obstacle, Task};

/// Finds the mistakes and oddities of a goal. A scene says which objects there are; without one, each class
/// is taken to have as many objects as needed, and only goals about given nodes are checked as a whole.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_tasks::lint::{self, FindingKind};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let found = lint::goal(&"On(mug, kitchen_table)".parse()?, Some(&graph));
/// assert_eq!(found[0].kind, FindingKind::Obstacle, "the scene has no mug");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn goal(goal: &Goal, scene: Option<&SceneGraph>) -> Vec<Finding> {
    let written = goal;
    let goal = &*scene.map_or(Cow::Borrowed(goal), |graph| goal.expanded(graph.vocabulary()));
    let mut found = Vec::new();
    check_part(goal, &mut Vec::new(), Some(true), &mut found);
    found.extend(cycle(goal));
    found.extend(unknown(goal, scene));
    found.extend(scene.into_iter().flat_map(|graph| lacking(goal, graph)));
    let program = compiled(goal, scene);
    found.extend(program.and_then(|p| satisfiability(&p, &written.to_string())));
    if let Some((graph, agent)) = scene.and_then(|g| Some((g, *g.agents().first()?))) {
        let history = History::default();
        let finding = Finding { kind: FindingKind::TrueAtStart, at: None, part: written.to_string() };
        let can_be_judged = too_large(goal, graph).next().is_none();
        if can_be_judged && goal.holds(&Situation::new(graph, agent, &history)) && !found.contains(&finding) {
            found.push(finding);
        }
    }
    found
}

/// Findings about classes that are in no class table and no scene; a class already named by an obstacle is
/// not repeated.
fn unknown(goal: &Goal, scene: Option<&SceneGraph>) -> Vec<Finding> {
    let builtin = ClassTable::builtin();
    let table = scene.map_or(&builtin, SceneGraph::classes);
    let obstacles = scene.map(|graph| Task::new("", goal.clone()).obstacles(graph)).unwrap_or_default();
    let reported = |class: &str| {
        obstacles.iter().any(|o| matches!(o, Obstacle::TooFew { class: reported, .. } if reported == class))
    };
    let is_there = |class: &str| scene.is_some_and(|graph| !graph.of_class(class).is_empty());
    let named = goal.terms().into_iter().filter_map(|term| match term {
        Term::Class(class) | Term::Node(Some(class), _) => Some(class),
        _ => None,
    });
    let lost = named.filter(|class| table.get(class).is_none() && !is_there(class) && !reported(class));
    let part = |class: String| format!("`{class}`{}", did_you_mean(&class, table.nearest(&class)));
    let lost: BTreeSet<String> = lost.collect();
    lost.into_iter().map(|class| Finding { kind: FindingKind::UnknownClass, at: None, part: part(class) }).collect()
}

/// Findings about labels whose class is not that of their node, and about objects that the scene lacks.
fn lacking(goal: &Goal, graph: &SceneGraph) -> Vec<Finding> {
    let finding = |kind, part| Finding { kind, at: None, part };
    let name_mismatches =
        goal.name_mismatches(graph).into_iter().map(|m| finding(FindingKind::NameMismatch, m.to_string()));
    let nobody = |id: &NodeId| graph.node(*id).is_none();
    let ids = goal.terms().into_iter().filter_map(|t| if let Term::Node(_, id) = t { Some(id) } else { None });
    let missing: BTreeSet<NodeId> = ids.filter(nobody).collect();
    let missing = missing.into_iter().map(|id| finding(FindingKind::Obstacle, Refusal::NoSuchThing(id).to_string()));
    let task = Task::new("", goal.clone());
    // Unknown classes are findings of their own, and states that nothing brings about are found without a scene, too.
    let is_found_here = |obstacle: &Obstacle| match obstacle {
        Obstacle::UnknownClass { .. } => false,
        Obstacle::NoAction { state, .. } => !is_beyond_all(Predicate::State(*state)),
        _ => true,
    };
    let obstacles = task.obstacles(graph).into_iter().filter(is_found_here);
    let obstacles = obstacles.map(|o| finding(FindingKind::Obstacle, o.to_string()));
    name_mismatches.chain(missing).chain(obstacles).collect()
}

/// A finding if the goal asks for objects that support each other in a cycle.
fn cycle(goal: &Goal) -> Option<Finding> {
    let mut literals = Vec::new();
    conjuncts(goal, &mut literals);
    let node = |term: &Term| if let Term::Node(_, id) = term { Some(*id) } else { None };
    let resting = literals.into_iter().filter_map(|literal| match literal.predicate {
        Predicate::Relation(relation) if rests(relation) => {
            Some((literal, (node(&literal.terms[0])?, node(&literal.terms[1])?)))
        }
        _ => None,
    });
    let (said, pairs): (Vec<&Literal>, Vec<(NodeId, NodeId)>) = resting.unzip();
    let part = Goal::Literal((*said.get(first_in_cycle(&pairs)?)?).clone()).to_string();
    Some(Finding { kind: FindingKind::Cycle, at: None, part })
}

/// Collects the literals that must all hold for a goal to hold.
fn conjuncts<'g>(goal: &'g Goal, found: &mut Vec<&'g Literal>) {
    match goal {
        Goal::And(parts) => parts.iter().for_each(|part| conjuncts(part, found)),
        Goal::Literal(literal) => found.push(literal),
        _ => {}
    }
}

/// Whether a relation has the same object twice.
fn with_itself(literal: &Literal) -> bool {
    let one = |term: &Term| matches!(term, Term::Node(..) | Term::Variable(_) | Term::Me);
    let same = |a: &Term, b: &Term| match (a, b) {
        (Term::Node(_, a), Term::Node(_, b)) => a == b,
        _ => a == b,
    };
    matches!(&literal.terms[..], [a, b] if one(a) && same(a, b))
}

/// The goal compiled for the objects of a scene; without a scene, only if it is about given nodes.
fn compiled(goal: &Goal, scene: Option<&SceneGraph>) -> Option<GoalProgram> {
    let mut compiler = Compiler::limited(LARGEST);
    let program: Result<GoalProgram, CompileError> = match scene {
        Some(graph) => {
            let agent = graph.agents().first().copied().unwrap_or(NOBODY);
            compiler.compile(goal, &Situation::new(graph, agent, &History::default()))
        }
        None if ranges(goal) => return None,
        None => compiler.compile(goal, &Given),
    };
    program.ok()
}

/// The node that `me` denotes where no agent is known.
const NOBODY: NodeId = NodeId(u32::MAX);

/// Whether a goal ranges over objects that only a scene determines.
fn ranges(goal: &Goal) -> bool {
    let here = match goal {
        Goal::ForAll(_) | Goal::Exists(_) | Goal::ForN { .. } | Goal::ForPairs(_) => true,
        Goal::Literal(literal) | Goal::Count { literal, .. } => literal.counted().is_some(),
        _ => false,
    };
    here || goal.parts().into_iter().any(ranges)
}

/// The objects that a goal names exist, and no others are known.
struct Given;

impl Things for Given {
    fn each(&self, _class: Option<&str>, _things: &mut Vec<NodeId>) {}

    fn agent(&self) -> NodeId {
        NOBODY
    }

    fn has(&self, _id: NodeId) -> bool {
        true
    }
}

/// Whether nothing brings a predicate about in any scene. For a scene's own states, its vocabulary tells.
fn is_beyond_all(predicate: Predicate) -> bool {
    let own = match predicate {
        Predicate::State(state) => !state.is_builtin(),
        predicate => matches!(predicate, Predicate::Derived(_)),
    };
    !own && !brought_about(&Vocabulary::builtin(), predicate)
}

/// A variable and its class.
type Bound<'g> = (&'g str, Option<&'g str>);

fn check_part<'g>(goal: &'g Goal, bound: &mut Vec<Bound<'g>>, wanted: Option<bool>, found: &mut Vec<Finding>) {
    let outer = bound.len();
    match goal {
        Goal::ForAll(q) | Goal::Exists(q) | Goal::ForN { of: q, .. } => {
            bind(goal, &[(&q.variable, q.class.as_deref())], &q.body, bound, found);
        }
        Goal::ForPairs(p) => {
            let both = [&p.first, &p.second].map(|v| (v.name.as_str(), v.class.as_deref()));
            bind(goal, &both, &p.body, bound, found);
        }
        Goal::Literal(literal) | Goal::Count { literal, .. } if with_itself(literal) => {
            found.push(Finding { kind: FindingKind::WithItself, at: None, part: goal.to_string() });
        }
        Goal::Count { comparison: Comparison::AtLeast, number: 0, .. } if wanted == Some(true) => {
            found.push(Finding { kind: FindingKind::TrueAtStart, at: None, part: goal.to_string() });
        }
        Goal::Literal(literal) | Goal::Count { literal, .. }
            if wanted == Some(true) && is_beyond_all(literal.predicate) =>
        {
            found.push(Finding { kind: FindingKind::NothingBringsAbout, at: None, part: goal.to_string() });
        }
        _ => {}
    }
    for (i, part) in goal.parts().into_iter().enumerate() {
        check_part(part, bound, within(goal, i, wanted), found);
    }
    bound.truncate(outer);
}

/// The truth value that the i-th part of a goal has to take, where that is certain.
fn within(goal: &Goal, i: usize, wanted: Option<bool>) -> Option<bool> {
    match goal {
        Goal::Not(_) => wanted.map(|w| !w),
        Goal::Imply(..) | Goal::Before(..) if (i == 0) == matches!(goal, Goal::Imply(..)) => wanted.map(|w| !w),
        Goal::ForN { .. } | Goal::ForPairs(_) | Goal::Until(..) => None,
        _ => wanted,
    }
}

fn bind<'g>(
    goal: &'g Goal,
    variables: &[Bound<'g>],
    body: &'g Goal,
    bound: &mut Vec<Bound<'g>>,
    found: &mut Vec<Finding>,
) {
    let mut report = |kind: FindingKind, part: String| found.push(Finding { kind, at: None, part });
    let mut terms = HashSet::new();
    terms_in(body, &mut terms);
    for &(name, _) in variables {
        if bound.iter().any(|(n, _)| *n == name) {
            report(FindingKind::HiddenVariable, format!("?{name}"));
        }
        if !terms.iter().any(|t| matches!(t, Term::Variable(v) if v == name)) {
            let kind = if variables.len() == 1 { FindingKind::UnusedVariable } else { FindingKind::UnusedInPair };
            report(kind, format!("?{name} in `{goal}`"));
        }
    }
    let own = |t: &&&Term| matches!(t, Term::Node(Some(c), _) if variables.iter().any(|(_, v)| *v == Some(c)));
    let mut constants: Vec<String> = terms.iter().filter(own).map(|t| t.to_string()).collect();
    constants.sort();
    if let Some(constant) = constants.into_iter().next() {
        report(FindingKind::ConstantInQuantifier, constant);
    }
    bound.extend_from_slice(variables);
}

fn terms_in<'g>(goal: &'g Goal, found: &mut HashSet<&'g Term>) {
    match goal {
        Goal::Literal(Literal { terms, .. }) | Goal::Count { literal: Literal { terms, .. }, .. } => {
            found.extend(terms)
        }
        Goal::Same(a, b) => found.extend([a, b]),
        _ => {}
    }
    goal.parts().into_iter().for_each(|part| terms_in(part, found));
}

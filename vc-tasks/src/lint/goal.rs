//! Goals in our own language.

use std::collections::HashSet;

use vc_graph::goal::{Goal, Literal, Predicate, Situation, Term};
use vc_graph::rule::table::RULES;
use vc_graph::{Effect, History, NodeId, Relation, SceneGraph, State};

use super::{Finding, Kind, satisfiability};
use crate::ground::{self, Things};

/// Everything that is wrong or odd with a goal. A scene tells which things there
/// are: without one, things of a class are taken to be as many as it takes, and
/// only goals about given nodes are looked at as a whole.
pub fn goal(goal: &Goal, scene: Option<&SceneGraph>) -> Vec<Finding> {
    let mut found = Vec::new();
    look(goal, &mut Vec::new(), Some(true), &mut found);
    let formula = match scene {
        Some(graph) => ground::formula(std::slice::from_ref(goal), &InScene(graph)),
        None => ground::formula(std::slice::from_ref(goal), &Unknown),
    };
    found.extend(formula.and_then(|f| satisfiability(&f, &goal.to_string())));
    if let Some((graph, agent)) = scene.and_then(|g| Some((g, *g.agents().first()?))) {
        let history = History::default();
        if goal.holds(&Situation::new(graph, agent, &history)) {
            found.push(Finding { kind: Kind::TrueAtStart, at: None, part: goal.to_string() });
        }
    }
    found
}

/// The things of a scene.
struct InScene<'a>(&'a SceneGraph);

impl Things for InScene<'_> {
    fn of_class(&self, class: Option<&str>) -> Option<Vec<NodeId>> {
        Some(match class {
            Some(class) => self.0.of_class(class),
            None => self.0.nodes().map(vc_graph::Node::id).collect(),
        })
    }
}

/// Nothing is known of what there is.
struct Unknown;

impl Things for Unknown {
    fn of_class(&self, _class: Option<&str>) -> Option<Vec<NodeId>> {
        None
    }
}

/// A variable and its class.
type Bound<'g> = (&'g str, Option<&'g str>);

fn look<'g>(goal: &'g Goal, bound: &mut Vec<Bound<'g>>, wanted: Option<bool>, found: &mut Vec<Finding>) {
    let outer = bound.len();
    match goal {
        Goal::ForAll(q) | Goal::Exists(q) | Goal::ForN { of: q, .. } => {
            bind(goal, &[(&q.variable, q.class.as_deref())], &q.body, bound, found);
        }
        Goal::ForPairs(p) => {
            let both = [&p.first, &p.second].map(|v| (v.name.as_str(), v.class.as_deref()));
            bind(goal, &both, &p.body, bound, found);
        }
        Goal::Literal(literal) | Goal::Count { literal, .. }
            if wanted == Some(true) && !brought_about(literal.predicate) =>
        {
            found.push(Finding { kind: Kind::NothingBringsAbout, at: None, part: goal.to_string() });
        }
        _ => {}
    }
    for (i, part) in goal.parts().into_iter().enumerate() {
        look(part, bound, within(goal, i, wanted), found);
    }
    bound.truncate(outer);
}

/// Whether the i-th part of a goal is to be true, where that is certain.
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
    let mut report = |kind: Kind, part: String| found.push(Finding { kind, at: None, part });
    let mut terms = HashSet::new();
    terms_in(body, &mut terms);
    for &(name, _) in variables {
        if bound.iter().any(|(n, _)| *n == name) {
            report(Kind::HiddenVariable, format!("?{name}"));
        }
        if !terms.iter().any(|t| matches!(t, Term::Variable(v) if v == name)) {
            let kind = if variables.len() == 1 { Kind::UnusedVariable } else { Kind::UnusedInPair };
            report(kind, format!("?{name} in `{goal}`"));
        }
    }
    let own = |t: &&&Term| matches!(t, Term::Node(Some(c), _) if variables.iter().any(|(_, v)| *v == Some(c)));
    let mut constants: Vec<String> = terms.iter().filter(own).map(|t| t.to_string()).collect();
    constants.sort();
    if let Some(constant) = constants.into_iter().next() {
        report(Kind::ConstantInQuantifier, constant);
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

/// Whether some action of the transition rule makes a predicate true.
///
/// ```
/// use vc_graph::State;
/// use vc_graph::goal::Predicate;
/// use vc_tasks::lint::brought_about;
/// assert!(brought_about(Predicate::State(State::Cooked)));
/// assert!(!brought_about(Predicate::State(State::Broken)));
/// ```
pub fn brought_about(predicate: Predicate) -> bool {
    match predicate {
        Predicate::Did(_) | Predicate::Holds => true,
        Predicate::State(state) => RULES.iter().flat_map(|r| r.does).any(|e| enters(e, state)),
        Predicate::Relation(relation) => RULES.iter().flat_map(|r| r.does).any(|e| relates(e, relation)),
        // No action brings forth what is not there.
        Predicate::Real | _ => false,
    }
}

fn enters<T>(effect: &Effect<T>, state: State) -> bool {
    match effect {
        Effect::Enter(_, entered) | Effect::EnterOwn(entered) => *entered == state,
        Effect::SitOn(_) | Effect::Board(_) => state == State::Sitting,
        Effect::LieOn(_) => state == State::Lying,
        Effect::PourInto(..) => [State::Filled, State::Empty].contains(&state),
        Effect::FillWithWater(_) => state == State::Filled,
        _ => false,
    }
}

fn relates<T>(effect: &Effect<T>, relation: Relation) -> bool {
    use Relation as R;
    let made: &[R] = match effect {
        Effect::GoTo(_) | Effect::Approach(_) => &[R::Near, R::InRoom, R::Inside],
        Effect::Face(_) => &[R::Facing],
        Effect::Hold(_) => &[R::HoldsRight, R::HoldsLeft, R::Near, R::TakenOff, R::TakenOut],
        Effect::PutOn(..) => &[R::On, R::Near],
        Effect::PutInto(..) => &[R::Inside, R::Near],
        Effect::PutWhereItWas(_) => &[R::On, R::Inside, R::Near],
        Effect::SitOn(_) => &[R::SittingOn, R::On, R::Facing],
        Effect::LieOn(_) => &[R::LyingOn, R::On],
        Effect::PourInto(..) => &[R::PouredInto, R::Inside, R::FilledWith, R::Contains],
        Effect::FillWithWater(_) => &[R::FilledWith, R::Contains],
        Effect::PutOnBody(_) => &[R::WornBy, R::On],
        Effect::Board(_) => &[R::Inside],
        Effect::DriveTo(..) => &[R::InRoom, R::Near, R::Inside],
        _ => &[],
    };
    made.contains(&relation)
}

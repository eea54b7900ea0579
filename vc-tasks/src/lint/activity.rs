//! Activities in BDDL.

use std::collections::{HashMap, HashSet};

use vc_graph::goal::{Pairing, Predicate};

use super::cycle::{first_in_cycle, rests};
use super::{Finding, FindingKind, satisfiability};
use crate::format::bddl::{
    ActivityDefinition, AppliedPredicate, ConditionNode, DOMAINS, Facts, TypedVariable, meaning,
};
use crate::format::sexpr::Expr;

/// Finds the mistakes and oddities of an activity. Whether its goal can be fulfilled is decided
/// from the text alone: without geometry or physics.
///
/// Takes some tens of microseconds for most activities.
///
/// ```
/// use vc_tasks::format::bddl::ActivityDefinition;
/// use vc_tasks::lint;
/// let text = "(define (problem p) (:domain omnigibson) (:objects a - cup)
///     (:init (dusty a) (dusty a)) (:goal (dusty b)))";
/// let found = lint::activity(&ActivityDefinition::read(text)?);
/// assert!(found.iter().any(|finding| finding.kind == lint::FindingKind::RepeatedFact));
/// assert!(found.iter().any(|finding| finding.kind == lint::FindingKind::Undeclared));
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
pub fn activity(activity: &ActivityDefinition) -> Vec<Finding> {
    let mut checker = Checker::new(activity);
    checker.domain(activity);
    checker.objects(activity);
    checker.start(activity);
    checker.condition(activity.goal(), &mut Vec::new(), Some(true));
    let (mut start, mut wanted) = (Vec::new(), Vec::new());
    start.extend(activity.initial().filter(|f| f.holds).map(|f| (f.atom, f.at)));
    conjuncts(activity.goal(), &mut wanted);
    checker.cycles(&start);
    checker.cycles(&wanted);
    checker.strays(activity);
    checker.found.extend(judged(activity));
    checker.found
}

/// The findings about the goal as a whole: that it cannot be fulfilled, that it holds at the start.
fn judged(activity: &ActivityDefinition) -> Vec<Finding> {
    // Undeclared names have been reported already.
    let Ok(facts) = Facts::from_activity(activity, Pairing::Matching) else { return Vec::new() };
    let unmet = satisfiability(facts.program(), activity.name());
    let done = facts.start(activity).is_ok_and(|start| facts.program().holds(&start));
    let done = done.then(|| Finding { kind: FindingKind::TrueAtStart, at: None, part: activity.name().to_owned() });
    unmet.into_iter().chain(done).collect()
}

/// The declared names, and the findings so far.
struct Checker<'t> {
    classes: HashMap<&'t str, &'t str>,
    known_classes: HashSet<&'t str>,
    start: HashSet<AppliedPredicate<'t>>,
    found: Vec<Finding>,
}

impl<'t> Checker<'t> {
    fn new(activity: &'t ActivityDefinition) -> Self {
        let classes: HashMap<&str, &str> = activity.objects().map(|o| (o.name, o.class)).collect();
        let known_classes = classes.values().copied().collect();
        let start = activity.initial().filter(|f| f.holds).map(|f| f.atom).collect();
        Self { classes, known_classes, start, found: Vec::new() }
    }

    fn add(&mut self, kind: FindingKind, at: Expr<'_>, part: impl Into<String>) {
        self.found.push(Finding { kind, at: Some(at.position()), part: part.into() });
    }

    fn domain(&mut self, activity: &'t ActivityDefinition) {
        let domain = activity.domain();
        if !DOMAINS.contains(&domain) {
            let name = if domain.is_empty() { "no `(:domain ...)` is given" } else { domain };
            let part = format!("{name}; known are {}", DOMAINS.join(" and "));
            self.found.push(Finding { kind: FindingKind::UnknownDomain, at: None, part });
        }
    }

    /// Reports one finding if objects are said to rest on each other in a cycle.
    fn cycles(&mut self, said: &[(AppliedPredicate<'t>, Expr<'t>)]) {
        let resting = |(atom, at): &(AppliedPredicate<'t>, Expr<'t>)| match meaning(atom.predicate) {
            Some(Predicate::Relation(relation)) if rests(relation) => Some((*at, (atom.first, atom.second?))),
            _ => None,
        };
        let (places, pairs): (Vec<Expr<'t>>, Vec<(&str, &str)>) = said.iter().filter_map(resting).unzip();
        if let Some(index) = first_in_cycle(&pairs) {
            self.add(FindingKind::Cycle, places[index], places[index].to_string());
        }
    }

    /// Finds predicates with a wrong number of arguments, and with one object twice.
    fn things(&mut self, atom: AppliedPredicate<'t>, at: Expr<'t>) {
        let (Some(predicate), given) = (meaning(atom.predicate), atom.things().count()) else { return };
        if predicate.arity() != given {
            let (name, takes) = (atom.predicate, predicate.arity());
            self.add(FindingKind::WrongArity, at, format!("{at}: `{name}` takes {takes}, {given} given"));
        } else if atom.second == Some(atom.first) {
            self.add(FindingKind::WithItself, at, at.to_string());
        }
    }

    fn objects(&mut self, activity: &'t ActivityDefinition) {
        let mut seen = HashSet::new();
        for object in activity.objects() {
            if !seen.insert(object.name) {
                self.add(FindingKind::DuplicateObject, object.at, object.name);
            }
        }
    }

    fn start(&mut self, activity: &'t ActivityDefinition) {
        let mut seen: HashMap<AppliedPredicate<'t>, bool> = HashMap::new();
        for fact in activity.initial() {
            match seen.insert(fact.atom, fact.holds) {
                Some(before) if before == fact.holds => {
                    self.add(FindingKind::RepeatedFact, fact.at, fact.at.to_string())
                }
                Some(_) => self.add(FindingKind::ContradictoryFacts, fact.at, fact.at.to_string()),
                None => {}
            }
            self.names(fact.atom, fact.at, &[]);
        }
    }

    /// Finds undeclared objects and predicates.
    fn names(&mut self, atom: AppliedPredicate<'t>, at: Expr<'t>, bound: &[TypedVariable<'t>]) {
        self.things(atom, at);
        if meaning(atom.predicate).is_none() {
            self.add(FindingKind::Undeclared, at, format!("predicate `{}`", atom.predicate));
        }
        let things = atom.things().take(if atom.predicate == "inroom" { 1 } else { 2 });
        for thing in things {
            if !self.classes.contains_key(thing) && bound.iter().all(|v| v.name != thing) {
                self.add(FindingKind::Undeclared, at, format!("object `{thing}`"));
            }
        }
    }

    /// Checks a condition and its parts. `wanted` is the truth value that it has to take, where
    /// that is certain.
    fn condition(&mut self, at: Expr<'t>, bound: &mut Vec<TypedVariable<'t>>, wanted: Option<bool>) {
        let Ok(part) = ConditionNode::new(at) else { return };
        self.variables(&part, at, bound);
        let outer = bound.len();
        bound.extend_from_slice(part.variables());
        for (i, condition) in part.conditions().into_iter().enumerate() {
            self.condition(condition, bound, within(&part, i, wanted));
        }
        bound.truncate(outer);
        if let ConditionNode::Atom(atom) = part {
            self.names(atom, at, bound);
            let never = ["inroom", "insource", "future"].contains(&atom.predicate);
            if never && wanted == Some(true) && !self.start.contains(&atom) {
                self.add(FindingKind::NothingBringsAbout, at, at.to_string());
            }
        }
    }

    fn variables(&mut self, part: &ConditionNode<'t>, at: Expr<'t>, bound: &[TypedVariable<'t>]) {
        let variables = part.variables();
        let Some(body) = part.conditions().first().copied().filter(|_| !variables.is_empty()) else { return };
        let mut words = Vec::new();
        things_in(body, &mut words);
        for variable in variables {
            if !self.known_classes.contains(variable.class) {
                self.add(FindingKind::Undeclared, at, format!("class `{}`", variable.class));
            }
            if bound.iter().any(|v| v.name == variable.name) {
                self.add(FindingKind::HiddenVariable, at, variable.name);
            }
            if !words.contains(&variable.name) {
                let kind = if variables.len() == 1 { FindingKind::UnusedVariable } else { FindingKind::UnusedInPair };
                self.add(kind, at, variable.name);
            }
        }
        let own = |word: &&str| self.classes.get(word).is_some_and(|class| variables.iter().any(|v| v.class == *class));
        if let Some(constant) = words.iter().copied().find(own) {
            self.add(FindingKind::ConstantInQuantifier, at, constant);
        }
    }

    fn strays(&mut self, activity: &'t ActivityDefinition) {
        for stray in activity.strays() {
            let condition = stray.is_list() && ConditionNode::new(stray).is_ok();
            let kind = if condition { FindingKind::SecondCondition } else { FindingKind::Stray };
            self.add(kind, stray, stray.to_string());
        }
    }
}

/// Collects the predicates that must all be true for a condition to hold.
fn conjuncts<'t>(at: Expr<'t>, found: &mut Vec<(AppliedPredicate<'t>, Expr<'t>)>) {
    match ConditionNode::new(at) {
        Ok(ConditionNode::And(parts)) => parts.for_each(|part| conjuncts(part, found)),
        Ok(ConditionNode::Atom(atom)) => found.push((atom, at)),
        _ => {}
    }
}

/// The truth value that the i-th condition of a part has to take, given that of the part.
fn within(part: &ConditionNode<'_>, i: usize, wanted: Option<bool>) -> Option<bool> {
    match part {
        ConditionNode::Not(_) => wanted.map(|w| !w),
        ConditionNode::Imply(..) if i == 0 => wanted.map(|w| !w),
        ConditionNode::ForN(..) => None,
        _ => wanted,
    }
}

/// The objects and variables in a condition, once per occurrence, and the variables it binds
/// itself.
fn things_in<'t>(at: Expr<'t>, found: &mut Vec<&'t str>) {
    match ConditionNode::new(at) {
        Ok(ConditionNode::Atom(atom)) => found.extend(atom.things()),
        Ok(part) => {
            found.extend(part.variables().iter().map(|v| v.name));
            part.conditions().into_iter().for_each(|c| things_in(c, found));
        }
        Err(_) => {}
    }
}

//! Activities in BDDL.

use std::collections::{HashMap, HashSet};

use vc_graph::goal::{Pairing, Predicate};

use super::circle::{first_in_circle, rests};
use super::{Finding, Kind, satisfiability};
use crate::format::bddl::{Activity, Atom, DOMAINS, Facts, Part, Variable, meaning};
use crate::format::sexpr::Expr;

/// Finds the mistakes and oddities of an activity. Whether its goal can be fulfilled is decided
/// from the text alone: without geometry or physics.
///
/// Takes some tens of microseconds for most activities.
pub fn activity(activity: &Activity) -> Vec<Finding> {
    let mut look = Look::of(activity);
    look.domain(activity);
    look.objects(activity);
    look.start(activity);
    look.condition(activity.goal(), &mut Vec::new(), Some(true));
    let (mut start, mut wanted) = (Vec::new(), Vec::new());
    start.extend(activity.initial().filter(|f| f.holds).map(|f| (f.atom, f.at)));
    conjuncts(activity.goal(), &mut wanted);
    look.circles(&start);
    look.circles(&wanted);
    look.strays(activity);
    look.found.extend(judged(activity));
    look.found
}

/// The findings about the goal as a whole: that it cannot be fulfilled, that it holds at the start.
fn judged(activity: &Activity) -> Vec<Finding> {
    // Undeclared names have been reported already.
    let Ok(facts) = Facts::of(activity, Pairing::Matching) else { return Vec::new() };
    let unmet = satisfiability(facts.program(), activity.name());
    let done = facts.start(activity).is_ok_and(|start| facts.program().holds(&start));
    let done = done.then(|| Finding { kind: Kind::TrueAtStart, at: None, part: activity.name().to_owned() });
    unmet.into_iter().chain(done).collect()
}

/// The declared names, and the findings so far.
struct Look<'t> {
    classes: HashMap<&'t str, &'t str>,
    known_classes: HashSet<&'t str>,
    start: HashSet<Atom<'t>>,
    found: Vec<Finding>,
}

impl<'t> Look<'t> {
    fn of(activity: &'t Activity) -> Self {
        let classes: HashMap<&str, &str> = activity.objects().map(|o| (o.name, o.class)).collect();
        let known_classes = classes.values().copied().collect();
        let start = activity.initial().filter(|f| f.holds).map(|f| f.atom).collect();
        Self { classes, known_classes, start, found: Vec::new() }
    }

    fn add(&mut self, kind: Kind, at: Expr<'_>, part: impl Into<String>) {
        self.found.push(Finding { kind, at: Some(at.position()), part: part.into() });
    }

    fn domain(&mut self, activity: &'t Activity) {
        let domain = activity.domain();
        if !DOMAINS.contains(&domain) {
            let name = if domain.is_empty() { "no `(:domain ...)` is given" } else { domain };
            let part = format!("{name}; known are {}", DOMAINS.join(" and "));
            self.found.push(Finding { kind: Kind::UnknownDomain, at: None, part });
        }
    }

    /// Reports one finding if objects are said to rest on each other in a cycle.
    fn circles(&mut self, said: &[(Atom<'t>, Expr<'t>)]) {
        let resting = |(atom, at): &(Atom<'t>, Expr<'t>)| match meaning(atom.predicate) {
            Some(Predicate::Relation(relation)) if rests(relation) => Some((*at, (atom.first, atom.second?))),
            _ => None,
        };
        let (places, pairs): (Vec<Expr<'t>>, Vec<(&str, &str)>) = said.iter().filter_map(resting).unzip();
        if let Some(index) = first_in_circle(&pairs) {
            self.add(Kind::Circle, places[index], places[index].to_string());
        }
    }

    /// Finds predicates with a wrong number of arguments, and with one object twice.
    fn things(&mut self, atom: Atom<'t>, at: Expr<'t>) {
        let (Some(predicate), given) = (meaning(atom.predicate), atom.things().count()) else { return };
        if predicate.arity() != given {
            let (name, takes) = (atom.predicate, predicate.arity());
            self.add(Kind::WrongArity, at, format!("{at}: `{name}` takes {takes}, {given} given"));
        } else if atom.second == Some(atom.first) {
            self.add(Kind::WithItself, at, at.to_string());
        }
    }

    fn objects(&mut self, activity: &'t Activity) {
        let mut seen = HashSet::new();
        for object in activity.objects() {
            if !seen.insert(object.name) {
                self.add(Kind::DuplicateObject, object.at, object.name);
            }
        }
    }

    fn start(&mut self, activity: &'t Activity) {
        let mut seen: HashMap<Atom<'t>, bool> = HashMap::new();
        for fact in activity.initial() {
            match seen.insert(fact.atom, fact.holds) {
                Some(before) if before == fact.holds => self.add(Kind::RepeatedFact, fact.at, fact.at.to_string()),
                Some(_) => self.add(Kind::ContradictoryFacts, fact.at, fact.at.to_string()),
                None => {}
            }
            self.names(fact.atom, fact.at, &[]);
        }
    }

    /// Finds undeclared objects and predicates.
    fn names(&mut self, atom: Atom<'t>, at: Expr<'t>, bound: &[Variable<'t>]) {
        self.things(atom, at);
        if meaning(atom.predicate).is_none() {
            self.add(Kind::Undeclared, at, format!("predicate `{}`", atom.predicate));
        }
        let things = atom.things().take(if atom.predicate == "inroom" { 1 } else { 2 });
        for thing in things {
            if !self.classes.contains_key(thing) && bound.iter().all(|v| v.name != thing) {
                self.add(Kind::Undeclared, at, format!("object `{thing}`"));
            }
        }
    }

    /// Checks a condition and its parts. `wanted` is the truth value that it has to take, where
    /// that is certain.
    fn condition(&mut self, at: Expr<'t>, bound: &mut Vec<Variable<'t>>, wanted: Option<bool>) {
        let Ok(part) = Part::of(at) else { return };
        self.variables(&part, at, bound);
        let outer = bound.len();
        bound.extend_from_slice(part.variables());
        for (i, condition) in part.conditions().into_iter().enumerate() {
            self.condition(condition, bound, within(&part, i, wanted));
        }
        bound.truncate(outer);
        if let Part::Atom(atom) = part {
            self.names(atom, at, bound);
            let never = ["inroom", "insource", "future"].contains(&atom.predicate);
            if never && wanted == Some(true) && !self.start.contains(&atom) {
                self.add(Kind::NothingBringsAbout, at, at.to_string());
            }
        }
    }

    fn variables(&mut self, part: &Part<'t>, at: Expr<'t>, bound: &[Variable<'t>]) {
        let variables = part.variables();
        let Some(body) = part.conditions().first().copied().filter(|_| !variables.is_empty()) else { return };
        let mut words = Vec::new();
        things_in(body, &mut words);
        for variable in variables {
            if !self.known_classes.contains(variable.class) {
                self.add(Kind::Undeclared, at, format!("class `{}`", variable.class));
            }
            if bound.iter().any(|v| v.name == variable.name) {
                self.add(Kind::HiddenVariable, at, variable.name);
            }
            if !words.contains(&variable.name) {
                let kind = if variables.len() == 1 { Kind::UnusedVariable } else { Kind::UnusedInPair };
                self.add(kind, at, variable.name);
            }
        }
        let own = |word: &&str| self.classes.get(word).is_some_and(|class| variables.iter().any(|v| v.class == *class));
        if let Some(constant) = words.iter().copied().find(own) {
            self.add(Kind::ConstantInQuantifier, at, constant);
        }
    }

    fn strays(&mut self, activity: &'t Activity) {
        for stray in activity.strays() {
            let condition = stray.is_list() && Part::of(stray).is_ok();
            let kind = if condition { Kind::SecondCondition } else { Kind::Stray };
            self.add(kind, stray, stray.to_string());
        }
    }
}

/// Collects the predicates that must all be true for a condition to hold.
fn conjuncts<'t>(at: Expr<'t>, found: &mut Vec<(Atom<'t>, Expr<'t>)>) {
    match Part::of(at) {
        Ok(Part::And(parts)) => parts.for_each(|part| conjuncts(part, found)),
        Ok(Part::Atom(atom)) => found.push((atom, at)),
        _ => {}
    }
}

/// The truth value that the i-th condition of a part has to take, given that of the part.
fn within(part: &Part<'_>, i: usize, wanted: Option<bool>) -> Option<bool> {
    match part {
        Part::Not(_) => wanted.map(|w| !w),
        Part::Imply(..) if i == 0 => wanted.map(|w| !w),
        Part::ForN(..) => None,
        _ => wanted,
    }
}

/// The objects and variables in a condition, once per occurrence, and the variables it binds
/// itself.
fn things_in<'t>(at: Expr<'t>, found: &mut Vec<&'t str>) {
    match Part::of(at) {
        Ok(Part::Atom(atom)) => found.extend(atom.things()),
        Ok(part) => {
            found.extend(part.variables().iter().map(|v| v.name));
            part.conditions().into_iter().for_each(|c| things_in(c, found));
        }
        Err(_) => {}
    }
}

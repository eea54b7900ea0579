//! Goals in PDDL: facts, or an action that states that they hold.

use vc_graph::goal::{Comparison, Goal, Literal, Predicate, Quantified, Term};
use vc_graph::{NodeId, NodeKind, Relation, SceneGraph};

use super::rules::{is, is_not, kind};
use super::scene::name;
use super::{AtomicFormula, FORMAT, Formula, Operator, OperatorEffect, TypedName};
use crate::format::Unwritable;

/// One way in which a goal is fulfilled: facts about objects and variables.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Way {
    pub(super) facts: Vec<AtomicFormula>,
}

impl Way {
    /// The objects that it names.
    pub(super) fn named(&self) -> impl Iterator<Item = &str> {
        let arguments = self.facts.iter().flat_map(|fact| &fact.arguments);
        arguments.map(String::as_str).filter(|argument| !argument.starts_with('?'))
    }
}

/// The limit of the ways of a goal.
const MOST: usize = 1000;

/// All ways in which a goal is fulfilled in a scene.
pub(super) fn ways(goal: &Goal, graph: &SceneGraph, agent: NodeId) -> Result<Vec<Way>, Unwritable> {
    let mut translator = Translator { graph, agent, bound: Vec::new(), fresh: 0 };
    translator.goal(goal)
}

struct Translator<'g, 'a> {
    graph: &'a SceneGraph,
    agent: NodeId,
    /// The bindings of variables: a node, or a parameter.
    bound: Vec<(&'g str, String)>,
    fresh: usize,
}

fn no<T>(part: impl std::fmt::Display, why: &str) -> Result<T, Unwritable> {
    Err(Unwritable::new(FORMAT, part, why))
}

/// The fact that an object is of a class.
pub(super) fn class_fact(class: &str, thing: &str) -> AtomicFormula {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    AtomicFormula::new(format!("kind_{}", class.chars().map(plain).collect::<String>()), &[thing])
}

impl<'g> Translator<'g, '_> {
    fn goal(&mut self, goal: &'g Goal) -> Result<Vec<Way>, Unwritable> {
        match goal {
            Goal::Literal(literal) => self.literal(literal).map(|way| vec![way]),
            Goal::Count { literal, comparison: Comparison::AtLeast, number } => {
                let copies = self.copies(*number, |this| this.counted(literal))?;
                Ok(vec![copies])
            }
            Goal::And(parts) => self.all(parts.iter()),
            Goal::Or(parts) => {
                let ways = parts.iter().map(|p| self.goal(p)).collect::<Result<Vec<_>, _>>()?.concat();
                limited(goal, ways)
            }
            Goal::Not(part) => match &**part {
                Goal::Literal(Literal { predicate: Predicate::State(state), terms }) => {
                    let things = self.all_of(&terms[0])?;
                    let facts = things.iter().map(|thing| AtomicFormula::new(is_not(*state), &[thing])).collect();
                    Ok(vec![Way { facts }])
                }
                _ => no(goal, "only states are asked not to be"),
            },
            Goal::Exists(q) => self.some(q),
            Goal::ForAll(q) => {
                let mut ways = vec![Way::default()];
                for id in self.range(q.class.as_deref()) {
                    self.bound.push((&q.variable, name(self.graph, id)));
                    let more = self.goal(&q.body);
                    self.bound.pop();
                    ways = limited(goal, product(&ways, &more?))?;
                }
                Ok(ways)
            }
            _ => no(goal, "it has no counts other than `at least`, no pairs and no time"),
        }
    }

    /// All objects that a term can denote.
    fn all_of(&mut self, term: &'g Term) -> Result<Vec<String>, Unwritable> {
        let range = match term {
            Term::Class(class) => self.range(Some(class)),
            Term::Anything => self.range(None),
            _ => return self.term(term, &mut Way::default()).map(|thing| vec![thing]),
        };
        Ok(range.into_iter().map(|id| name(self.graph, id)).collect())
    }

    fn all(&mut self, parts: impl Iterator<Item = &'g Goal>) -> Result<Vec<Way>, Unwritable> {
        let mut ways = vec![Way::default()];
        for part in parts {
            let more = self.goal(part)?;
            ways = limited(part, product(&ways, &more))?;
        }
        Ok(ways)
    }

    fn range(&self, class: Option<&str>) -> Vec<NodeId> {
        match class {
            Some(class) => self.graph.of_class(class),
            None => self.graph.nodes().map(vc_graph::Node::id).collect(),
        }
    }

    fn some(&mut self, q: &'g Quantified) -> Result<Vec<Way>, Unwritable> {
        let variable = self.parameter("v");
        self.bound.push((&q.variable, variable.clone()));
        let ways = self.goal(&q.body);
        self.bound.pop();
        let class = q.class.as_deref().map(|class| class_fact(class, &variable));
        let with = |mut way: Way| {
            way.facts.extend(class.clone());
            way
        };
        Ok(ways?.into_iter().map(with).collect())
    }

    fn parameter(&mut self, letter: &str) -> String {
        self.fresh += 1;
        format!("?{letter}{}", self.fresh)
    }

    /// A number of different objects, in the order of their names.
    fn copies(
        &mut self,
        number: u32,
        mut one: impl FnMut(&mut Self) -> Result<(Way, String), Unwritable>,
    ) -> Result<Way, Unwritable> {
        let (mut whole, mut last) = (Way::default(), None::<String>);
        for _ in 0..number.min(MOST as u32) {
            let (way, thing) = one(self)?;
            whole.facts.extend(way.facts);
            whole.facts.extend(last.map(|last| AtomicFormula::new("before", &[&last, &thing])));
            last = Some(thing);
        }
        Ok(whole)
    }

    /// A literal, and the object in its counted position.
    fn counted(&mut self, literal: &'g Literal) -> Result<(Way, String), Unwritable> {
        let place = literal.counted().unwrap_or(0);
        let way = self.literal(literal)?;
        let things = &way.facts.last().map(|fact| fact.arguments.clone()).unwrap_or_default();
        // The agent is not an argument of facts.
        let at = if literal.terms.first() == Some(&Term::Me) { 0 } else { place };
        match things.get(at) {
            Some(thing) => Ok((way.clone(), thing.clone())),
            None => no(literal, "nothing in it can be counted"),
        }
    }

    fn term(&mut self, term: &'g Term, way: &mut Way) -> Result<String, Unwritable> {
        match term {
            Term::Node(_, id) => Ok(name(self.graph, *id)),
            Term::Variable(variable) => {
                let found = self.bound.iter().rev().find(|(name, _)| name == variable);
                found.map_or_else(|| no(term, "no quantifier binds it"), |(_, thing)| Ok(thing.clone()))
            }
            Term::Class(class) => {
                let variable = self.parameter("v");
                way.facts.push(class_fact(class, &variable));
                Ok(variable)
            }
            Term::Anything => Ok(self.parameter("v")),
            Term::Me => no(term, "the agent is no object of the problem"),
        }
    }

    /// The facts of a literal; that of its own predicate comes last.
    fn literal(&mut self, literal: &'g Literal) -> Result<Way, Unwritable> {
        let mut way = Way::default();
        let me = |t: &Term| *t == Term::Me || matches!(t, Term::Node(_, id) if *id == self.agent);
        let (first, second) = (literal.terms.first(), literal.terms.get(1));
        let by_me = first.is_some_and(me);
        let of_me = second.is_some_and(me);
        let fact = match (literal.predicate, second) {
            (Predicate::State(state), _) => {
                let thing =
                    if by_me { super::rules::HANDS.to_owned() } else { self.term(&literal.terms[0], &mut way)? };
                AtomicFormula::new(is(state), &[&thing])
            }
            (Predicate::Holds, Some(held)) if by_me => {
                let (thing, hand) = (self.term(held, &mut way)?, self.parameter("h"));
                AtomicFormula::new("held", &[&thing, &hand])
            }
            (Predicate::Relation(Relation::WornBy), _) if of_me => {
                AtomicFormula::new("worn", &[&self.term(&literal.terms[0], &mut way)?])
            }
            (Predicate::Relation(Relation::Near), Some(thing)) if by_me => {
                let (thing, spot) = (self.term(thing, &mut way)?, self.parameter("v"));
                way.facts.push(AtomicFormula::new("at", &[&spot]));
                AtomicFormula::new("by", &[&thing, &spot])
            }
            (Predicate::Relation(relation), Some(second)) => {
                self.relation(literal, relation, by_me, second, &mut way)?
            }
            (Predicate::Did(verb), _) => {
                let things = literal.terms.iter().map(|t| self.term(t, &mut way)).collect::<Result<Vec<_>, _>>()?;
                AtomicFormula { predicate: format!("did_{verb}"), arguments: things }
            }
            _ => return no(literal, "it has no such predicate"),
        };
        way.facts.push(fact);
        Ok(way)
    }

    fn relation(
        &mut self,
        literal: &'g Literal,
        relation: Relation,
        by_me: bool,
        second: &'g Term,
        way: &mut Way,
    ) -> Result<AtomicFormula, Unwritable> {
        let predicate = match (relation, by_me) {
            (Relation::On, false) => "on",
            (Relation::Inside, false) => "in",
            (Relation::SittingOn | Relation::On, true) => "sitting_on",
            (Relation::LyingOn, true) => "lying_on",
            _ => return no(literal, "it has no such relation"),
        };
        let room = |id: NodeId| self.graph.node(id).is_some_and(|n| n.kind() == NodeKind::Room);
        let into_room = match second {
            Term::Node(_, id) => room(*id),
            Term::Class(class) => self.graph.of_class(class).into_iter().any(room),
            _ => false,
        };
        if into_room {
            return no(literal, "it does not know which room things are in");
        }
        if by_me {
            let second = self.term(second, way)?;
            return Ok(AtomicFormula::new(predicate, &[&second]));
        }
        let first = self.term(&literal.terms[0], way)?;
        let second = self.term(second, way)?;
        Ok(AtomicFormula::new(predicate, &[&first, &second]))
    }
}

fn limited(goal: &Goal, ways: Vec<Way>) -> Result<Vec<Way>, Unwritable> {
    if ways.len() > MOST { no(goal, "it can be met in more than 1000 ways") } else { Ok(ways) }
}

fn product(all: &[Way], more: &[Way]) -> Vec<Way> {
    let both = |a: &Way, b: &Way| Way { facts: a.facts.iter().chain(&b.facts).cloned().collect() };
    all.iter().flat_map(|a| more.iter().map(move |b| both(a, b))).collect()
}

/// The action that states that a goal is fulfilled in one of its ways.
pub(super) fn met(way: &Way, number: usize) -> Operator {
    let mut names: Vec<&str> = Vec::new();
    for argument in way.facts.iter().flat_map(|f| &f.arguments) {
        if argument.starts_with('?') && !names.contains(&argument.as_str()) {
            names.push(argument);
        }
    }
    Operator {
        name: if number == 0 { "met".to_owned() } else { format!("met-{}", number + 1) },
        parameters: names.into_iter().map(|n| TypedName::new(n, kind(n))).collect(),
        precondition: Formula::And(way.facts.iter().cloned().map(Formula::Atom).collect()),
        effect: vec![OperatorEffect::Add(AtomicFormula::new("met", &[]))],
    }
}

//! Random goals, and scenes in which many atoms are true and many are not.
#![allow(dead_code, clippy::unwrap_used, reason = "each test file uses a part, and tests may unwrap")]

use proptest::prelude::*;
use vc_graph::goal::{Literal, Pairs, Predicate, Quantified, Situation, Term};
use vc_graph::{ChangeSet, Draft, Edge, Goal, History, NodeId, Relation, SceneBuilder, SceneGraph, State, Verb, Word};

const STATES: [State; 2] = [State::Dusty, State::Stained];
const RELATIONS: [Relation; 2] = [Relation::Covered, Relation::Draped];
const CLASSES: [&str; 3] = ["cup", "plate", "spoon"];

/// Nodes 2 to 8: three cups, three plates, a spoon; 9 is the agent.
const THINGS: [&str; 7] = ["cup", "cup", "cup", "plate", "plate", "plate", "spoon"];

/// A scene of a few objects.
pub(crate) struct Room {
    pub(crate) graph: SceneGraph,
    pub(crate) me: NodeId,
    pub(crate) history: History,
}

impl Room {
    /// A room in which the objects have the states and relations given by the flips.
    pub(crate) fn new(flips: &[Flip]) -> Self {
        let mut scene = SceneBuilder::new("room");
        let kitchen = scene.add(Draft::new("kitchen")).unwrap();
        THINGS.iter().for_each(|class| {
            scene.add_in(kitchen, Draft::new(*class)).unwrap();
        });
        let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
        let mut room = Self { graph: scene.build(), me, history: History::default() };
        flips.iter().for_each(|&flip| {
            room.flip(flip);
        });
        room
    }

    pub(crate) fn now(&self) -> Situation<'_> {
        Situation::new(&self.graph, self.me, &self.history)
    }

    /// Inverts a state or relation.
    pub(crate) fn flip(&mut self, (which, from, to): Flip) -> ChangeSet {
        let [from, to] = [from, to].map(|n| NodeId(2 + n % 7));
        let has = |graph: &SceneGraph, state| graph.node(from).unwrap().is(state);
        let (state, relation) = (STATES[usize::from(which % 2)], RELATIONS[usize::from(which % 2)]);
        let (is, edge) = (has(&self.graph, state), Edge::new(from, relation, to));
        let linked = self.graph.has(edge);
        let mut edit = self.graph.edit();
        match (which / 2 % 3, is, linked) {
            (0, true, _) => edit.leave_state(from, state).unwrap(),
            (0, false, _) => edit.enter_state(from, state).unwrap(),
            (_, _, true) => edit.unrelate(from, &[relation]).unwrap(),
            (_, _, false) => edit.relate(edge).unwrap(),
        }
        edit.commit()
    }
}

/// The actions of the temporal tests, with one and with two objects.
const VERBS: [Verb; 3] = [Verb::Grab, Verb::Eat, Verb::Place];

/// The kind of the flip, and the objects concerned.
pub(crate) type Flip = (u8, u32, u32);

pub(crate) fn flip() -> impl Strategy<Value = Flip> {
    (0_u8..6, 0_u32..7, 0_u32..7)
}

pub(crate) fn flips(most: usize) -> impl Strategy<Value = Vec<Flip>> {
    prop::collection::vec(flip(), 0..most)
}

/// Random goals from the strategy of the crate below, restricted to such a scene and without
/// temporal operators.
pub(crate) fn timeless(depth: u32) -> impl Strategy<Value = Goal> {
    vc_testkit::goals::goal(0, depth).prop_map(|goal| tamed(&goal))
}

/// Random goals from the strategy of the crate below, restricted to such a scene and a few actions.
pub(crate) fn temporal(depth: u32) -> impl Strategy<Value = Goal> {
    vc_testkit::goals::goal(0, depth).prop_map(|goal| in_time(&goal))
}

/// The same goal with objects and actions that exist.
fn in_time(goal: &Goal) -> Goal {
    let boxed = |g: &Goal| Box::new(in_time(g));
    let all = |parts: &[Goal]| parts.iter().map(in_time).collect();
    let quantified = |q: &Quantified| Quantified { body: boxed(&q.body), ..quantified(q) };
    match goal {
        Goal::Literal(Literal { predicate: Predicate::Did(verb), terms }) => {
            let verb = match verb.arity() {
                1 => VERBS[verb.index() % 2],
                2 => VERBS[2],
                _ => *verb,
            };
            Goal::Literal(Literal { predicate: Predicate::Did(verb), terms: terms.iter().map(term).collect() })
        }
        Goal::And(parts) => Goal::And(all(parts)),
        Goal::Or(parts) => Goal::Or(all(parts)),
        Goal::Then(parts) => Goal::Then(all(parts)),
        Goal::Not(part) => Goal::Not(boxed(part)),
        Goal::Imply(a, b) => Goal::Imply(boxed(a), boxed(b)),
        Goal::ForAll(q) => Goal::ForAll(quantified(q)),
        Goal::Exists(q) => Goal::Exists(quantified(q)),
        Goal::ForN { comparison, number, of } => {
            Goal::ForN { comparison: *comparison, number: *number, of: quantified(of) }
        }
        Goal::ForPairs(pairs) => match tamed(goal) {
            Goal::ForPairs(tamed) => Goal::ForPairs(Pairs { body: boxed(&pairs.body), ..tamed }),
            other => other,
        },
        Goal::Eventually(part) => Goal::Eventually(boxed(part)),
        Goal::Always(part) => Goal::Always(boxed(part)),
        Goal::Within(steps, part) => Goal::Within(steps % 8, boxed(part)),
        Goal::AtEnd(part) => Goal::AtEnd(boxed(part)),
        Goal::Until(a, b) => Goal::Until(boxed(a), boxed(b)),
        Goal::Before(a, b) => Goal::Before(boxed(a), boxed(b)),
        other => tamed(other),
    }
}

fn tamed(goal: &Goal) -> Goal {
    let boxed = |g: &Goal| Box::new(tamed(g));
    let all = |parts: &[Goal]| parts.iter().map(tamed).collect();
    match goal {
        Goal::Literal(l) => Goal::Literal(literal(l)),
        Goal::Count { literal: l, comparison, number } => {
            Goal::Count { literal: literal(l), comparison: *comparison, number: *number }
        }
        Goal::Same(a, b) => Goal::Same(term(a), term(b)),
        Goal::And(parts) | Goal::Then(parts) => Goal::And(all(parts)),
        Goal::Or(parts) => Goal::Or(all(parts)),
        Goal::Not(part) => Goal::Not(boxed(part)),
        Goal::Imply(a, b) => Goal::Imply(boxed(a), boxed(b)),
        Goal::Until(a, b) | Goal::Before(a, b) => Goal::And(vec![tamed(a), tamed(b)]),
        Goal::ForAll(q) => Goal::ForAll(quantified(q)),
        Goal::Exists(q) => Goal::Exists(quantified(q)),
        Goal::ForN { comparison, number, of } => {
            Goal::ForN { comparison: *comparison, number: *number, of: quantified(of) }
        }
        Goal::ForPairs(pairs) => {
            let mut pairs = Pairs { body: boxed(&pairs.body), ..pairs.clone() };
            pairs.first.class = Some(class(pairs.first.class.as_deref()));
            pairs.second.class = Some(class(pairs.second.class.as_deref()));
            Goal::ForPairs(pairs)
        }
        Goal::Eventually(part) | Goal::Always(part) | Goal::Within(_, part) | Goal::AtEnd(part) => tamed(part),
        other => other.clone(),
    }
}

fn quantified(q: &Quantified) -> Quantified {
    Quantified { class: Some(class(q.class.as_deref())), body: Box::new(tamed(&q.body)), variable: q.variable.clone() }
}

fn class(class: Option<&str>) -> String {
    CLASSES[class.map_or(0, str::len) % 3].to_owned()
}

fn term(term: &Term) -> Term {
    match term {
        Term::Class(name) => Term::Class(class(Some(name))),
        Term::Node(name, id) => Term::Node(name.clone(), NodeId(2 + id.0 % 7)),
        other => other.clone(),
    }
}

fn literal(literal: &Literal) -> Literal {
    let predicate = match literal.predicate {
        Predicate::State(state) => Predicate::State(STATES[state.index() % 2]),
        Predicate::Relation(relation) => Predicate::Relation(RELATIONS[relation.index() % 2]),
        Predicate::Did(verb) if verb.arity() == 1 => Predicate::State(STATES[verb.index() % 2]),
        Predicate::Did(verb) if verb.arity() == 2 => Predicate::Relation(RELATIONS[verb.index() % 2]),
        other => other,
    };
    Literal { predicate, terms: literal.terms.iter().map(term).collect() }
}

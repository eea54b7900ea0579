//! Random goals in normal form.

use proptest::prelude::*;
use vc_graph::goal::{Comparison, Literal, Pairing, Pairs, Predicate, Quantified, Term, Variable};
use vc_graph::{Goal, NodeId, Relation, State, Verb, Word};

/// Any word of a vocabulary.
pub fn words<W: Word>() -> impl Strategy<Value = W> + Clone {
    prop::sample::select(W::ALL)
}

fn predicate() -> impl Strategy<Value = Predicate> + Clone {
    prop_oneof![
        words::<State>().prop_map(Predicate::State),
        words::<Relation>().prop_map(Predicate::Relation),
        Just(Predicate::Holds),
        Just(Predicate::Real),
        words::<Verb>().prop_map(Predicate::Did),
    ]
}

/// Names of classes, plain ones and ones that need quotes; `v0` is also the name of a variable.
fn class() -> impl Strategy<Value = String> + Clone {
    let classes = [
        "apple",
        "kitchen_table",
        "SM_Cup_03",
        "coffee-table",
        "x1",
        "then",
        "not",
        "apple.n.01",
        "a \"big\" one",
        "me",
        "character",
        "_",
        "",
        "v0",
        "cup.3",
        "\\",
    ];
    prop_oneof![
        3 => prop::sample::select(classes[..5].to_vec()),
        1 => prop::sample::select(classes.to_vec()),
    ]
    .prop_map(str::to_owned)
}

/// The name of the variable at a depth; one needs quotes.
fn variable(depth: usize) -> String {
    if depth == 2 { "v.2 ?".to_owned() } else { format!("v{depth}") }
}

/// A term that refers to a single object.
fn thing(bound: usize) -> BoxedStrategy<Term> {
    let node = (prop::option::of(class()), any::<u32>()).prop_map(|(c, id)| Term::Node(c, NodeId(id)));
    let free = prop_oneof![node, Just(Term::Me)];
    if bound == 0 {
        return free.boxed();
    }
    prop_oneof![free, (0..bound).prop_map(|i| Term::Variable(variable(i)))].boxed()
}

/// A term; a variable only if one is bound.
fn term(bound: usize) -> BoxedStrategy<Term> {
    prop_oneof![2 => class().prop_map(Term::Class), 3 => thing(bound), 1 => Just(Term::Anything)].boxed()
}

fn literal(bound: usize) -> impl Strategy<Value = Literal> {
    predicate().prop_flat_map(move |predicate| {
        let terms = prop::collection::vec(term(bound), predicate.arity());
        terms.prop_map(move |terms| Literal { predicate, terms })
    })
}

fn comparison() -> impl Strategy<Value = Comparison> {
    prop::sample::select(vec![Comparison::AtLeast, Comparison::Exactly, Comparison::AtMost])
}

/// A goal in normal form: lists with no or several parts, `then` with several, counts other than the plain "at
/// least one".
pub fn goal(bound: usize, depth: u32) -> BoxedStrategy<Goal> {
    let count = (literal(bound), comparison(), 0_u32..5)
        .prop_map(|(literal, comparison, number)| Goal::Count { literal, comparison, number })
        .prop_filter("is the plain literal", |g| {
            !matches!(g, Goal::Count { comparison: Comparison::AtLeast, number: 1, .. })
        });
    let same = (thing(bound), thing(bound)).prop_map(|(a, b)| Goal::Same(a, b));
    let leaf = prop_oneof![6 => literal(bound).prop_map(Goal::Literal), 4 => count, 1 => same];
    if depth == 0 {
        return leaf.boxed();
    }
    let part = || goal(bound, depth - 1);
    let boxed = || part().prop_map(Box::new);
    let several = || prop::collection::vec(part(), 2..4);
    let list = prop_oneof![1 => Just(Vec::new()), 4 => several()].boxed();
    prop_oneof![
        2 => leaf,
        1 => list.clone().prop_map(Goal::And),
        1 => list.prop_map(Goal::Or),
        1 => boxed().prop_map(Goal::Not),
        1 => (boxed(), boxed()).prop_map(|(a, b)| Goal::Imply(a, b)),
        1 => quantified(bound, depth).prop_map(Goal::ForAll),
        1 => quantified(bound, depth).prop_map(Goal::Exists),
        1 => (comparison(), 0_u32..4, quantified(bound, depth))
            .prop_map(|(comparison, number, of)| Goal::ForN { comparison, number, of }),
        1 => pairs(bound, depth).prop_map(Goal::ForPairs),
        1 => several().prop_map(Goal::Then),
        1 => temporal(bound, depth),
    ]
    .boxed()
}

fn ranged() -> impl Strategy<Value = Option<String>> {
    prop::option::of(
        prop_oneof![4 => prop::sample::select(vec!["plate", "kitchen_table", "SM_Cup_03"]).prop_map(str::to_owned), 1 => class()],
    )
}

fn quantified(bound: usize, depth: u32) -> impl Strategy<Value = Quantified> {
    (ranged(), goal(bound + 1, depth - 1)).prop_map(move |(class, body)| Quantified {
        variable: variable(bound),
        class,
        body: Box::new(body),
    })
}

fn pairs(bound: usize, depth: u32) -> impl Strategy<Value = Pairs> {
    let pairing = prop::sample::select(vec![Pairing::Matching, Pairing::Marginal]);
    let number = prop::option::of((comparison(), 0_u32..4));
    (ranged(), ranged(), number, pairing, goal(bound + 2, depth - 1)).prop_map(move |(a, b, number, pairing, body)| {
        Pairs {
            first: Variable { name: variable(bound), class: a },
            second: Variable { name: variable(bound + 1), class: b },
            number,
            pairing,
            body: Box::new(body),
        }
    })
}

fn temporal(bound: usize, depth: u32) -> impl Strategy<Value = Goal> {
    let part = || goal(bound, depth - 1).prop_map(Box::new);
    prop_oneof![
        part().prop_map(Goal::Eventually),
        part().prop_map(Goal::Always),
        (0_u32..9, part()).prop_map(|(steps, p)| Goal::Within(steps, p)),
        part().prop_map(Goal::AtEnd),
        (part(), part()).prop_map(|(a, b)| Goal::Until(a, b)),
        (part(), part()).prop_map(|(a, b)| Goal::Before(a, b)),
    ]
}

//! Random goals in normal form.

use proptest::prelude::*;
use vc_graph::goal::{Comparison, Literal, Predicate, Quantified, Term};
use vc_graph::{Goal, NodeId, Relation, State, Verb, Word};

pub(crate) fn words<W: Word>() -> impl Strategy<Value = W> + Clone {
    prop::sample::select(W::ALL)
}

fn predicate() -> impl Strategy<Value = Predicate> + Clone {
    prop_oneof![
        words::<State>().prop_map(Predicate::State),
        words::<Relation>().prop_map(Predicate::Relation),
        Just(Predicate::Holds),
        words::<Verb>().prop_map(Predicate::Did),
    ]
}

/// A term; a variable only if one is bound, `?v0` being the outermost.
fn term(bound: usize) -> BoxedStrategy<Term> {
    let classes =
        prop::sample::select(vec!["apple", "kitchen_table", "SM_Cup_03", "coffee-table", "x1", "then", "not"]);
    let free = prop_oneof![
        classes.clone().prop_map(|c| Term::Class(c.to_owned())),
        (prop::option::of(classes), any::<u32>()).prop_map(|(c, id)| Term::Node(c.map(str::to_owned), NodeId(id))),
        Just(Term::Me),
        Just(Term::Anything),
    ];
    if bound == 0 {
        return free.boxed();
    }
    prop_oneof![free, (0..bound).prop_map(|i| Term::Variable(format!("v{i}")))].boxed()
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

/// A goal in normal form: lists of none or of several, `then` of several, counts
/// other than the plain "at least one".
pub(crate) fn goal(bound: usize, depth: u32) -> BoxedStrategy<Goal> {
    let count = (literal(bound), comparison(), 0_u32..5)
        .prop_map(|(literal, comparison, number)| Goal::Count { literal, comparison, number })
        .prop_filter("is the plain literal", |g| {
            !matches!(g, Goal::Count { comparison: Comparison::AtLeast, number: 1, .. })
        });
    let leaf = prop_oneof![3 => literal(bound).prop_map(Goal::Literal), 2 => count];
    if depth == 0 {
        return leaf.boxed();
    }
    let part = || goal(bound, depth - 1);
    let several = || prop::collection::vec(part(), 2..4);
    let list = prop_oneof![1 => Just(Vec::new()), 4 => several()].boxed();
    let class = prop::option::of(prop::sample::select(vec!["plate", "kitchen_table", "SM_Cup_03"]));
    let quantified = (class, goal(bound + 1, depth - 1)).prop_map(move |(class, body)| Quantified {
        variable: format!("v{bound}"),
        class: class.map(str::to_owned),
        body: Box::new(body),
    });
    prop_oneof![
        2 => leaf,
        1 => list.clone().prop_map(Goal::And),
        1 => list.prop_map(Goal::Or),
        1 => part().prop_map(|g| Goal::Not(Box::new(g))),
        1 => quantified.clone().prop_map(Goal::ForAll),
        1 => quantified.prop_map(Goal::Exists),
        1 => several().prop_map(Goal::Then),
    ]
    .boxed()
}

//! Goals, actions and labels print as what reads back.
#![allow(clippy::unwrap_used)]

mod shared;

use proptest::prelude::*;
use shared::cases;
use shared::scenes::{scene, steps};
use vc_graph::format::program::{self, Program};
use vc_graph::goal::{Comparison, Literal, Predicate, Quantified, Term};
use vc_graph::{Action, Goal, Label, NodeId, Relation, State, Verb, Word};

fn words<W: Word>() -> impl Strategy<Value = W> + Clone {
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

fn action() -> impl Strategy<Value = Action> {
    (words::<Verb>(), any::<u32>(), any::<u32>()).prop_map(|(verb, x, y)| {
        let things = [NodeId(x), NodeId(y)];
        Action::with(verb, &things[..verb.arity()]).unwrap()
    })
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn goals_read_back(goal in goal(0, 3)) {
        let text = goal.to_string();
        prop_assert_eq!(text.parse::<Goal>(), Ok(goal), "{}", text);
    }

    #[test]
    fn actions_read_back(action in action()) {
        prop_assert_eq!(action.to_string().parse::<Action>(), Ok(action));
    }

    #[test]
    fn labels_read_back(class in "[\\p{Alphabetic}0-9_-]{1,20}", id: u32) {
        let label = Label { class: class.into(), id: NodeId(id) };
        prop_assert_eq!(label.to_string().parse::<Label>(), Ok(label));
    }

    #[test]
    fn described_actions_and_virtualhome_notation_read_back(steps in steps(6), verb in words::<Verb>(), x: usize, y: usize) {
        let graph = scene(&steps, false);
        let ids: Vec<NodeId> = graph.nodes().map(|n| n.id()).collect();
        let things = [ids[x % ids.len()], ids[y % ids.len()]];
        let action = Action::with(verb, &things[..verb.arity()]).unwrap();
        prop_assert_eq!(action.describe(&graph).to_string().parse::<Action>(), Ok(action));
        match action.to_virtualhome(&graph) {
            Ok(text) => prop_assert_eq!(text.parse::<Action>(), Ok(action), "{}", text),
            Err(error) => prop_assert!(verb.virtualhome().is_none(), "{}", error),
        }
    }

    #[test]
    fn programs_read_back(actions in prop::collection::vec(action(), 0..8), titled: bool) {
        let actions: Vec<Action> = actions.into_iter().filter(|a| a.verb.virtualhome().is_some()).collect();
        let heading = if titled { vec!["Make coffee".to_owned(), "In the morning.".to_owned()] } else { Vec::new() };
        let program = Program { heading, actions };
        let text = program::write(&program, &scene(&[], false)).unwrap();
        prop_assert_eq!(program::read(&text).unwrap(), program, "{}", text);
    }
}

#[test]
fn words_read_back_in_any_spelling() {
    fn check<W: Word + std::fmt::Display>() {
        for word in W::ALL {
            let spelled = [word.to_string(), word.as_str().to_uppercase(), word.as_str().replace('_', " ")];
            spelled.iter().for_each(|text| assert_eq!(W::parse(text).as_ref(), Ok(word)));
        }
    }
    check::<State>();
    check::<Relation>();
    check::<Verb>();
    check::<vc_graph::Property>();
    check::<vc_graph::class::Category>();
    check::<vc_graph::class::SlotKind>();
}

#[test]
fn virtualhome_names_are_its_own() {
    for verb in Verb::ALL {
        let Some(name) = verb.virtualhome() else { continue };
        assert_eq!(Verb::from_virtualhome(name), Some(*verb));
        assert_eq!(Verb::from_virtualhome(&name.to_lowercase()), Some(*verb));
    }
    assert_eq!(Verb::from_virtualhome("PUTBACK"), Some(Verb::Place));
    assert_eq!(Verb::from_virtualhome("RELEASE"), Some(Verb::Drop));
}

#[test]
fn older_virtualhome_numbers_name_the_instance_after_the_dot() {
    let action: Action = "<char0> [putin] <milk> (1.12) <fridge> (3)".parse().unwrap();
    assert_eq!(action, Action::two(Verb::PutIn, NodeId(12), NodeId(3)));
}

#[test]
fn deep_goals_read_back() {
    let text = "Open(door) & forall ?x. ".repeat(40) + "Open(?x)";
    let goal: Goal = text.parse().unwrap();
    assert_eq!(goal.to_string().parse(), Ok(goal));
}

#[test]
fn odd_variables_read_back() {
    for text in ["forall #12. Open(#12)", "forall *. Open(*)", "exists x.1. Open(x.1)", "exists ?. Open(?)"] {
        if let Ok(goal) = text.parse::<Goal>() {
            assert_eq!(goal.to_string().parse(), Ok(goal), "{text}");
        }
    }
}

//! Derived predicates: their texts, and goals with them against a slow evaluation by substitution.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use proptest::prelude::*;
use vc_graph::format::native;
use vc_graph::goal::{EpisodeTrace, Goal, Situation, Term};
use vc_graph::{ClassTable, History, NameProblem, NodeId, SceneGraph, Vocabulary, VocabularyProblem};
use vc_testkit::cases;
use vc_testkit::flat::Flat;

const WORDS: &str = "
    predicate stocked ?x | is: Open(?x) | exists ?y: food. Inside(?y, ?x)
    predicate sharing ?a ?b | is: ?a != ?b & exists ?t. (On(?a, ?t) & On(?b, ?t))
    predicate laid ?x | is: On(?x, kitchen_table) & !Dirty(?x)
    predicate mine ?x | is: Holds(me, ?x) | Near(me, ?x) & did walk(_)
    predicate calm | is: !exists ?d: television. SwitchedOn(?d)
    predicate festive ?table | is: calm() & at least 2 ?x. (laid(?x) & On(?x, ?table))
";

/// The definitions once more, as texts in which `$0` and `$1` are nodes.
const SLOW: [(&str, &str); 5] = [
    ("Stocked", "Open($0) | exists ?y: food. Inside(?y, $0)"),
    ("Sharing", "$0 != $1 & exists ?t. (On($0, ?t) & On($1, ?t))"),
    ("Laid", "On($0, kitchen_table) & !Dirty($0)"),
    ("Mine", "Holds(me, $0) | Near(me, $0) & did walk(_)"),
    (
        "Festive",
        "(!exists ?d: television. SwitchedOn(?d)) & at least 2 ?x. (On(?x, kitchen_table) & !Dirty(?x) & On(?x, $0))",
    ),
];

fn words(text: &str) -> Vocabulary {
    Vocabulary::parse("words.txt", text).unwrap()
}

fn problem(text: &str) -> VocabularyProblem {
    Vocabulary::parse("words.txt", text).unwrap_err().problem
}

fn goal(text: &str) -> Goal {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The flat after some actions, with the words above.
fn flat() -> (NodeId, SceneGraph, History) {
    let flat = Flat::after(&["walk fridge", "open fridge", "grab apple", "walk kitchen_table"]);
    let mut graph = flat.graph().clone();
    graph.set_vocabulary(words(WORDS));
    let history = flat.sim.history().clone();
    (flat.me, graph, history)
}

#[test]
fn a_name_stands_for_a_goal_in_texts_of_vocabularies_and_scenes() {
    let known = words(WORDS);
    assert_eq!(words(&known.to_string()), known);
    assert_eq!(known.own_predicates().len(), 6);
    assert_eq!(goal("festive( kitchen_table )").to_string(), "Festive(kitchen_table)");
    let (_, graph, _) = flat();
    let again = native::read(&native::write(&graph), &ClassTable::builtin()).unwrap();
    assert!(again.vocabulary() == graph.vocabulary());
    // A class with the name of a variable is written so that it stays a class.
    let quoted = words("predicate odd ?cup | is: On(\"cup\", ?cup)");
    assert_eq!(words(&quoted.to_string()), quoted);
}

#[test]
fn mistakes_are_told() {
    use VocabularyProblem as P;
    assert!(matches!(problem("predicate p1 ?x"), P::Undefined("p1")));
    assert!(matches!(problem("predicate p1 x | is: Open(fridge)"), P::Variables(_)));
    assert!(matches!(problem("predicate p1 ?me | is: Holds(?me)"), P::Variables(_)));
    assert!("exists ?me. Holds(character, ?me)".parse::<Goal>().is_err());
    assert!(matches!(problem("predicate p1 ?x ?x | is: Open(?x)"), P::Variables(_)));
    assert!(matches!(problem("predicate p3 ?x ?y ?z | is: Open(?x)"), P::Variables(_)));
    assert!(matches!(problem("predicate p1 ?x | is: Opne(?x)"), P::Goal(_)));
    assert!(matches!(problem("predicate p1 ?x | is: Open(?y)"), P::Goal(_)));
    assert!(matches!(problem("predicate p1 ?x | is: always Open(?x)"), P::Temporal("p1")));
    assert!(matches!(problem("predicate open ?x | is: Closed(?x)"), P::Name(NameProblem::BuiltIn(_))));
    assert!(matches!(problem("state p2\npredicate p2 ?x | is: Open(?x)"), P::Name(NameProblem::BuiltIn(_))));
    assert!(matches!(problem("predicate p4 ?x | is: Open(?x)\nstate p4"), P::Name(NameProblem::BuiltIn(_))));
    assert!(matches!(problem("predicate p1 ?x | says: Nice. | is: Open(?x)"), P::Field { .. }));
    assert!(matches!(problem("predicate p1 ?x | is: On(?x, table.4)"), P::NamesNode { .. }));
    let round = "predicate p5 ?x | is: p6(?x)\npredicate p6 ?x | is: !p5(?x)";
    assert!(matches!(problem(round), P::Circular("p5")));
    words("predicate elsewhere ?x | is: Open(?x)");
    assert!(matches!(problem("predicate p1 ?x | is: elsewhere(?x)"), P::Undeclared("elsewhere")));
    // Each refers to the one before twice.
    let doubled = (1..20).map(|n| format!("predicate d{n} ?x | is: d{m}(?x) & d{m}(?x)\n", m = n - 1));
    let doubled = format!("predicate d0 ?x | is: Open(?x)\n{}", doubled.collect::<String>());
    assert!(matches!(problem(&doubled), P::Large { .. }));
}

#[test]
fn variables_of_a_definition_are_not_confused_with_those_of_the_goal() {
    let words =
        words("predicate loaded ?x | is: exists ?y. On(?y, ?x)\npredicate shelved ?y | is: loaded(?y) & Clean(?y)");
    let expanded = |text: &str| goal(text).expanded(&words).to_string();
    assert_eq!(expanded("exists ?y: table. Loaded(?y)"), "exists ?y: table. exists ?y1. On(?y1, ?y)");
    assert_eq!(expanded("Shelved(table)"), "exists ?y: table. (exists ?y1. On(?y1, ?y)) & Clean(?y)");
    assert_eq!(expanded("Loaded(table.4), = 1"), "exists ?y. On(?y, table.4)");
    assert_eq!(expanded("Loaded(table.4), <= 0"), "!(exists ?y. On(?y, table.4))");
    assert_eq!(expanded("Loaded(table.4), 2"), "false");
    assert_eq!(expanded("exactly 1 ?x: cup. Loaded(?x)"), "exactly 1 ?x: cup. exists ?y. On(?y, ?x)");
    assert_eq!(expanded("!Loaded(table.4)"), "!(exists ?y. On(?y, table.4))");
    let words = Vocabulary::parse(
        "words.txt",
        "predicate heaped ?x | is: forall ?y: cup. (On(?y, ?x) | exists ?x: plate. On(?x, ?y))
         predicate stacked ?x ?y | is: at least 2 ?z. (On(?z, ?x) & On(?x, ?y))
         predicate paired ?x | is: pairs ?y: cup, ?z: plate. (On(?y, ?z) & On(?z, ?x))",
    )
    .unwrap();
    let within = |text: &str| goal(text).expanded(&words).to_string();
    let heaped = "forall ?y: table. forall ?y1: cup. On(?y1, ?y) | (exists ?x: plate. On(?x, ?y1))";
    assert_eq!(within("forall ?y: table. Heaped(?y)"), heaped);
    let swapped = "exists ?y. exists ?x. at least 2 ?z. On(?z, ?y) & On(?y, ?x)";
    assert_eq!(within("exists ?y. exists ?x. Stacked(?y, ?x)"), swapped);
    let counted = "exists ?z. at least 2 ?z1. On(?z1, ?z) & On(?z, table.3)";
    assert_eq!(within("exists ?z. Stacked(?z, table.3)"), counted);
    let pairs = "forall ?z: table. pairs ?y: cup, ?z1: plate. On(?y, ?z1) & On(?z1, ?z)";
    assert_eq!(within("forall ?z: table. Paired(?z)"), pairs);
    assert_eq!(expanded("always Loaded(_)"), "always (exists ?x. exists ?y. On(?y, ?x))");
}

#[test]
fn a_predicate_that_the_scene_does_not_define_does_not_hold() {
    let (me, graph, history) = flat();
    words("predicate strange ?x | is: Open(?x) | Closed(?x)");
    let now = Situation::new(&graph, me, &history);
    assert!(!goal("Strange(fridge)").holds(&now));
    assert!(goal("Stocked(fridge)").holds(&now));
    assert_eq!(goal("Laid(cup) & Strange(cup)").score(&now), 0.5);
}

/// The number of objects for the first class or `_` for which a definition holds, by substitution of nodes.
fn found(body: &str, terms: &[Term], now: &Situation<'_>) -> usize {
    let choices: Vec<Vec<NodeId>> = terms.iter().map(|term| now.candidates(term)).collect();
    let counted = terms.iter().position(|term| matches!(term, Term::Class(_) | Term::Anything)).unwrap_or(0);
    let with = |nodes: &[NodeId]| {
        let put = |text: String, (place, node): (usize, &NodeId)| text.replace(&format!("${place}"), &node.to_string());
        goal(&nodes.iter().enumerate().fold(body.to_owned(), put)).holds(now)
    };
    let holds = |node: &NodeId| match (&choices[..], counted) {
        ([_], _) => with(&[*node]),
        ([_, others], 0) => others.iter().any(|other| with(&[*node, *other])),
        ([others, ..], _) => others.iter().any(|other| with(&[*other, *node])),
        _ => false,
    };
    choices[counted].iter().filter(|node| holds(node)).count()
}

fn term() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["cup", "food", "fridge", "plate", "kitchen_table", "apple", "me", "table", "_"])
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn goals_with_derived_predicates_mean_what_their_definitions_say(
        (name, body) in prop::sample::select(SLOW.to_vec()),
        terms in [term(), term()],
        (sign, number) in (prop::sample::select(vec!["", "= ", "<= "]), 0_usize..4),
    ) {
        let (me, graph, history) = flat();
        let now = Situation::new(&graph, me, &history);
        let arity = if body.contains("$1") { 2 } else { 1 };
        let text = format!("{name}({})", terms[..arity].join(", "));
        let Goal::Literal(literal) = goal(&text) else { panic!("{text}") };
        let number_found = found(body, &literal.terms, &now);
        prop_assert_eq!(goal(&text).holds(&now), number_found > 0, "{}", text);
        let counted = format!("{text}, {sign}{number}");
        let admitted = match sign {
            "" => number_found >= number,
            "= " => number_found == number,
            _ => number_found <= number,
        };
        prop_assert_eq!(goal(&format!("!{text}")).holds(&now), number_found == 0, "{}", text);
        prop_assert_eq!(goal(&counted).holds(&now), admitted, "{}: {}", counted, number_found);
        // A trace with a single state says the same, but for what has been done.
        let trace = EpisodeTrace::new(graph.clone(), me);
        let start = trace.situation(0).unwrap();
        prop_assert_eq!(goal(&text).holds_on(&trace), found(body, &literal.terms, &start) > 0, "{}", text);
    }
}

//! No text makes a reader panic, hang or overflow the stack.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use proptest::prelude::*;
use vc_graph::goal::Pairing;
use vc_tasks::format::alfred::Template;
use vc_tasks::format::bddl::{self, ActivityDefinition, Facts};
use vc_tasks::format::{eai, json, pddl, sexpr, thesis, watch_and_help};
use vc_tasks::lint;
use vc_testkit::cases;

/// Passes a text to every reader, and uses the results.
fn read_all(text: &str) {
    if let Ok(tree) = sexpr::SexprTree::read("text", text) {
        assert!(sexpr::SexprTree::read("text", &tree.root().to_string()).unwrap().root().same(tree.root()));
    }
    if let Ok(activity) = ActivityDefinition::read(text) {
        assert_eq!(ActivityDefinition::read(&activity.to_string()).as_ref(), Ok(&activity));
        let _ = lint::activity(&activity);
        if let Ok(goal) = activity.to_goal() {
            let names: Vec<&str> = activity.objects().map(|o| o.name).collect();
            let _ = (
                bddl::condition(&goal, &names),
                Facts::from_activity(&activity, Pairing::Marginal).map(|f| f.heads(|_| true)),
            );
        }
    }
    if let Ok(domain) = text.parse::<pddl::Domain>() {
        assert_eq!(domain.to_string().parse().as_ref(), Ok(&domain));
    }
    if let Ok(problem) = text.parse::<pddl::PlanningProblem>() {
        assert_eq!(problem.to_string().parse().as_ref(), Ok(&problem));
    }
    let _ = pddl::read_plan(text);
    if let Ok(tasks) = json::read(text) {
        assert_eq!(json::read(&json::write(&tasks)).as_ref(), Ok(&tasks));
    }
    if let Ok(task) = Template::read(text) {
        assert_eq!(Template::from_goal(&task.to_goal()).map(|t| t.task_type), Ok(task.task_type));
    }
    let goals = [thesis::read(text), watch_and_help::read(text), eai::read_formula(text)];
    for goal in goals.into_iter().flatten() {
        let _ = (thesis::write(&goal), watch_and_help::write(&goal), eai::formula(&goal), eai::goal(&goal));
        let _ = (bddl::condition(&goal, &[]), lint::goal(&goal, None));
    }
}

const DOCUMENTS: &[&str] = &[
    "(define (problem tea-0) (:domain omnigibson)\n (:objects cup.n.01_1 cup.n.01_2 - cup.n.01 t_1 - t)\n \
     (:init (inside cup.n.01_1 t_1) (not (hot t_1)) (inroom t_1 kitchen)) ; there\n (:goal (and (forpairs \
     (?c - cup.n.01) (?t - t) (ontop ?c ?t)) (forn (2) (?c - cup.n.01) (or (hot ?c) (real ?t_1))) \
     (imply (open ?t_1) (exists (?c - cup.n.01) (not (touching ?c ?t_1)))))))",
    "(define (domain d) (:requirements :strips) (:types a - object b) (:predicates (p ?x - a) (q))\n (:action go \
     :parameters (?x ?y - a) :precondition (and (p ?x) (not (= ?x ?y)) (forall (?z - a) (imply (p ?z) (q)))) \
     :effect (and (not (p ?x)) (p ?y) (forall (?z - a) (when (p ?z) (not (q)))))))",
    "(define (problem p) (:domain d) (:objects a b - a c) (:init (p a) (q)) (:goal (exists (?x - a) (or (p ?x) (q)))))",
    "0: (walk table_3 here)\n(grab cup_12 table_3 air air right)\n; cost = 2\n(met)",
    "{\"virtualcity_tasks\": 1, \"tasks\": [{\"title\": \"a\", \"goal\": \"On(apple, table), 2\", \"step_limit\": 9}]}",
    "{\"task_type\": \"pick_two_obj_and_place\", \"pddl_params\": {\"object_target\": \"Mug\", \"parent_target\": \
     \"Desk\", \"object_sliced\": false}}",
    "{\"on_plate_kitchentable\": 2, \"turnOn_12_1\": [1, true], \"sit_character_chair\": 1, \"offInside_a_4\": 0}",
    "On(apple, kitchentable), 3\nSit(kitchen chair), 1",
    "(exists x0. (TOUCH(x0) or PUSH(x0)) then (NEXT_TO(character.65, cat.1) and forn 2. y. (not OPEN(y))))",
];

const TOKENS: &[&str] = &[
    "",
    "(",
    ")",
    "()",
    "((",
    "))",
    "?",
    "-",
    " - ",
    ";",
    "\n",
    "\"",
    "{",
    "}",
    "[",
    ":",
    ",",
    ".",
    "é",
    "\u{0}",
    "and",
    "not",
    "forall",
    "forpairs",
    "(0)",
    "(4294967296)",
    ":goal",
    ":init",
    "define",
    "4294967296",
    "-1",
    "1e9",
    "null",
    "#",
    "#12",
    "then",
    "then then",
    "|",
    "&",
    "!",
    "A",
    "met",
    "grab",
    "_",
    "_1",
    "x_99999999999",
];

/// A mutation of a document: position, length of the removed part, and index of the inserted token.
type Cut = (prop::sample::Index, usize, usize);

fn mutated(document: &str, cuts: &[Cut]) -> String {
    let mut text: Vec<char> = document.chars().collect();
    for (at, length, token) in cuts {
        if text.is_empty() {
            break;
        }
        let start = at.index(text.len());
        let end = (start + length).min(text.len());
        text.splice(start..end, TOKENS[token % TOKENS.len()].chars());
    }
    text.into_iter().collect()
}

proptest! {
    #![proptest_config(cases(2000))]

    #[test]
    fn changed_documents_are_read_or_refused(
        document in prop::sample::select(DOCUMENTS),
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..12, any::<usize>()), 0..6),
    ) {
        read_all(&mutated(document, &cuts));
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,200}") {
        read_all(&text);
    }

    #[test]
    fn words_of_the_languages_in_any_order_are_read_or_refused(
        words in prop::collection::vec(prop::sample::select(TOKENS), 0..60),
    ) {
        read_all(&words.join(" "));
        read_all(&words.concat());
    }
}

#[test]
fn changed_activities_are_read_or_refused() {
    for (i, (_, text)) in crate::behavior::activities().into_iter().enumerate() {
        // Every activity loses a stretch somewhere, and gains a bracket elsewhere.
        let chars: Vec<char> = text.chars().collect();
        let (a, b) = (chars.len() * (i % 97) / 97, chars.len() * (i % 89) / 89);
        let short: String = chars[..a].iter().chain(&chars[(a + i % 40).min(chars.len())..]).collect();
        let more: String = chars[..b].iter().chain(['(', ')'][i % 2..=i % 2].iter()).chain(&chars[b..]).collect();
        read_all(&short);
        read_all(&more);
    }
}

#[test]
fn deep_texts_are_refused_and_long_ones_are_not() {
    for open in ["(", "(and ", "(not ", "{\"a\":", "[", "!", "not ", "forall ?x. ", "eventually (", "exists x. ("] {
        let deep = open.repeat(100_000);
        let goal = format!("(define (problem p) (:goal {deep}");
        for text in [deep, goal] {
            read_all(&text);
            assert!(ActivityDefinition::read(&text).is_err());
            assert!(text.parse::<pddl::Domain>().is_err());
        }
    }
    let error = ActivityDefinition::read(&format!("(define (:goal {}", "(and ".repeat(200))).unwrap_err();
    assert!(error.to_string().ends_with("at most 128 brackets within each other, found another one"), "{error}");
    let nots = 120;
    let deep = format!("(define (problem p) (:objects a) (:goal {}(hot a){}))", "(not ".repeat(nots), ")".repeat(nots));
    read_all(&deep);
    assert!(ActivityDefinition::read(&deep).is_ok());
    let long = format!("(define (problem p) (:objects a) (:goal (and {})))", "(hot a) ".repeat(50_000));
    assert_eq!(ActivityDefinition::read(&long).unwrap().heads().len(), 50_000);
}

#[test]
fn many_things_do_not_make_a_goal_blow_up() {
    let objects: Vec<String> = (0..400).map(|i| format!("o{i}")).collect();
    let body = "(forall (?a - o) (forall (?b - o) (forall (?c - o) (forall (?d - o) (touching ?a ?d)))))";
    let text = format!("(define (problem p) (:objects {} - o) (:goal {body}))", objects.join(" "));
    let activity = ActivityDefinition::read(&text).unwrap();
    assert!(Facts::from_activity(&activity, Pairing::Matching).is_err());
    let _ = lint::activity(&activity);
}

#[test]
fn errors_say_what_was_expected_where_and_what_was_found() {
    let errors = [
        ("", "line 1, column 1: BDDL: expected an expression, found the end"),
        ("(define (problem p)", "line 1, column 1: BDDL: expected a `)` for this `(`, found the end"),
        ("(define) x", "line 1, column 10: BDDL: expected the end, found more text"),
        ("(problem p)", "line 1, column 2: BDDL: expected `(define ...`, found `problem`"),
        ("(define\n (problem p))", "line 2, column 13: BDDL: expected a `(:goal ...)`, found `)`"),
        ("(define (:goal (not)))", "line 1, column 20: BDDL: expected a condition, found `)`"),
        ("(define (:goal (not (hot a) b)))", "line 1, column 29: BDDL: expected `)`, found `b`"),
        ("(define (:goal x))", "line 1, column 16: BDDL: expected a condition, found `x`"),
        (
            "(define (:goal (forall (?x cup) (hot ?x))))",
            "line 1, column 24: BDDL: expected a variable and its class, `(?x - class)`, found `(?x ...)`",
        ),
        (
            "(define (:goal (forn 2 (?x - cup) (hot ?x))))",
            "line 1, column 22: BDDL: expected a number in brackets, `(2)`, found `2`",
        ),
        (
            "(define (:init (and (hot a))) (:goal (and)))",
            "line 1, column 16: BDDL: expected a predicate of things, found `(and ...)`",
        ),
    ];
    for (text, message) in errors {
        assert_eq!(ActivityDefinition::read(text).unwrap_err().to_string(), message);
    }
    let text = "(define (problem p)\n (:objects a)\n (:goal (flies a)))";
    let error = ActivityDefinition::read(text).unwrap().to_goal().unwrap_err().in_file("p.bddl");
    let message = "p.bddl, line 3, column 9: BDDL: expected a predicate of BEHAVIOR, found `(flies ...)`";
    assert_eq!(error.to_string(), message);
    let plan = pddl::read_plan("(walk table_3)\n (fly cup_1)").unwrap_err();
    assert_eq!(
        plan.to_string(),
        "line 2, column 2: PDDL: expected a step such as `(grab cup_12 ...)`, found `fly cup_1`"
    );
}

#[test]
fn a_byte_order_mark_is_no_part_of_a_text() {
    for text in DOCUMENTS {
        let marked = format!("\u{feff}{text}");
        assert_eq!(ActivityDefinition::read(&marked).ok(), ActivityDefinition::read(text).ok());
        assert_eq!(marked.parse::<pddl::Domain>().ok(), text.parse().ok());
        assert_eq!(marked.parse::<pddl::PlanningProblem>().ok(), text.parse().ok());
        assert_eq!(pddl::read_plan(&marked).ok(), pddl::read_plan(text).ok());
        assert_eq!(json::read(&marked).ok(), json::read(text).ok());
        assert_eq!(Template::read(&marked).ok(), Template::read(text).ok());
        assert_eq!(watch_and_help::read(&marked).ok(), watch_and_help::read(text).ok());
        assert_eq!(thesis::read(&marked).ok(), thesis::read(text).ok());
    }
    let tasks = vc_tasks::Task::read_list("\u{feff}# mornings\nbreakfast: On(apple, table)\n").unwrap();
    assert_eq!(tasks.len(), 1);
}

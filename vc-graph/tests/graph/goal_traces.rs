//! Goals about events and states along a trace.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::goal::{EpisodeTrace, Situation};
use vc_graph::{Draft, Event, Goal, SceneBuilder, Simulator};
use vc_testkit::cases;
use vc_testkit::flat::Flat;
use vc_testkit::goals::goal;

/// The trace of actions that `me` performs one by one.
fn trace(actions: &[&str]) -> EpisodeTrace {
    let mut flat = Flat::new();
    let mut trace = EpisodeTrace::new(flat.graph().clone(), flat.me);
    for text in actions {
        let action = flat.action(text);
        flat.step(text).unwrap_or_else(|refusals| panic!("{text}: {}", vc_testkit::flat::plain(&refusals)));
        trace.push(flat.graph().clone(), [Event { agent: flat.me, action }]);
    }
    trace
}

fn check(trace: &EpisodeTrace, yes: &[&str], no: &[&str]) {
    let holds = |text: &str| {
        let goal: Goal = text.parse().unwrap_or_else(|e| panic!("{text}: {e}"));
        let score = goal.score_on(trace);
        assert!((0.0..=1.0).contains(&score) && goal.holds_on(trace) == (score == 1.0), "{text}: {score}");
        goal.holds_on(trace)
    };
    yes.iter().for_each(|text| assert!(holds(text), "{text} does not hold"));
    no.iter().for_each(|text| assert!(!holds(text), "{text} holds"));
}

/// Milk is taken out of the fridge and put on the table, and the fridge is closed again.
fn milk() -> EpisodeTrace {
    trace(&[
        "walk fridge",
        "open fridge",
        "grab milk",
        "walk kitchen_table",
        "place milk kitchen_table",
        "walk fridge",
        "close fridge",
    ])
}

#[test]
fn a_goal_without_temporal_words_is_about_the_end() {
    check(
        &milk(),
        &["On(milk, kitchen_table) & Closed(fridge)", "did open(fridge)", "did open(fridge) & did close(fridge)"],
        &["Open(fridge)", "Holds(milk)", "Inside(milk, fridge)"],
    );
}

#[test]
fn some_step_and_all_steps() {
    let yes = [
        "eventually Open(fridge)",
        "eventually (Holds(milk) & Open(fridge))",
        "always Clean(cup)",
        "always (did grab(milk) => Open(fridge))",
        "eventually did grab(milk)",
        "always (Open(fridge) => eventually Closed(fridge))",
        "eventually (Inside(milk, fridge) & eventually On(milk, kitchen_table))",
        "eventually always On(milk, kitchen_table)",
        "always !did eat(_)",
    ];
    let no = [
        "always Closed(fridge)",
        "eventually (On(milk, kitchen_table) & eventually Inside(milk, fridge))",
        "eventually (did grab(milk) & did open(fridge))",
        "always eventually Holds(milk)",
        "eventually Broken(cup)",
    ];
    check(&milk(), &yes, &no);
}

#[test]
fn so_many_steps() {
    let yes = ["within 2 steps Open(fridge)", "within 0 steps Closed(fridge)", "within 99 steps On(milk, table)"];
    let no = ["within 1 steps Open(fridge)", "within 4 steps On(milk, table)"];
    check(&milk(), &yes, &no);
    check(
        &milk(),
        &["always (did open(fridge) => within 5 steps Closed(fridge))"],
        &["always (did open(fridge) => within 4 steps Closed(fridge))"],
    );
}

#[test]
fn until_and_before() {
    let yes = [
        "Inside(milk, fridge) until Holds(milk)",
        "Closed(fridge) until did open(fridge) | Open(fridge)",
        "Open(wardrobe) until Closed(fridge)",
        "did open(fridge) before did grab(milk)",
        "Holds(milk) before On(milk, kitchen_table)",
        "did open(fridge) before Broken(cup)",
    ];
    let no = [
        "Inside(milk, fridge) until On(milk, kitchen_table)",
        "Clean(cup) until Dirty(cup)",
        "did grab(milk) before did open(fridge)",
        "Open(fridge) before Open(fridge)",
        "Broken(cup) before did grab(milk)",
    ];
    check(&milk(), &yes, &no);
}

#[test]
fn the_end_from_within() {
    check(
        &milk(),
        &["eventually (Open(fridge) & at end Closed(fridge))", "at end (did open(fridge) & did grab(milk))"],
        &["eventually at end Open(fridge)"],
    );
}

#[test]
fn stretches_one_after_the_other() {
    let yes = [
        "did open(fridge) then did grab(milk) then did close(fridge)",
        "Open(fridge) then Closed(fridge)",
        "Holds(milk) then On(milk, kitchen_table) then Closed(fridge)",
        "eventually (Holds(milk) then Closed(fridge))",
        "did grab(milk) then always Holds(milk) | On(milk, table)",
    ];
    let no = [
        "did grab(milk) then did open(fridge)",
        "Holds(milk) then Inside(milk, fridge)",
        "Closed(fridge) then Open(fridge)",
        "did open(fridge) then did open(fridge)",
    ];
    check(&milk(), &yes, &no);
}

#[test]
fn order_matters() {
    let forth = milk();
    let mut back = EpisodeTrace::new(forth.graph(forth.steps()).unwrap().clone(), forth.agent());
    for step in (0..forth.steps()).rev() {
        back.push(forth.graph(step).unwrap().clone(), forth.events(step + 1).to_vec());
    }
    let goal: Goal = "eventually Open(fridge) then eventually did grab(milk) then On(milk, table)".parse().unwrap();
    assert!(goal.holds_on(&forth) && !goal.holds_on(&back));
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn a_trace_is_judged_as_its_last_situation_where_time_does_not_matter(goal in goal(0, 2)) {
        let trace = milk();
        let last = trace.situation(trace.steps()).unwrap();
        prop_assert_eq!(goal.score_on(&trace) == 1.0, goal.holds_on(&trace), "{}", goal);
        if !goal.is_temporal() {
            prop_assert_eq!(goal.holds(&last), goal.holds_on(&trace), "{}", goal);
        }
        let end = Goal::AtEnd(Box::new(goal.clone()));
        prop_assert_eq!(end.holds_on(&trace), goal.holds_on(&trace), "{}", goal);
    }

    #[test]
    fn what_is_always_so_is_not_at_some_step_not_so(goal in goal(0, 2)) {
        let trace = milk();
        let not = |g: Goal| Goal::Not(Box::new(g));
        let always = Goal::Always(Box::new(goal.clone()));
        let dual = not(Goal::Eventually(Box::new(not(goal.clone()))));
        prop_assert_eq!(always.holds_on(&trace), dual.holds_on(&trace), "{}", goal);
        let within = Goal::Within(trace.steps() as u32, Box::new(goal.clone()));
        let eventually = Goal::Eventually(Box::new(goal.clone()));
        prop_assert_eq!(within.holds_on(&trace), eventually.holds_on(&trace), "{}", goal);
        let until = Goal::Until(Box::new(Goal::And(vec![])), Box::new(goal));
        prop_assert_eq!(until.holds_on(&trace), eventually.holds_on(&trace), "{}", until);
    }

    #[test]
    fn a_situation_is_a_trace_of_its_present_state(goal in goal(0, 2)) {
        let flat = Flat::after(&["walk bread", "eat bread", "walk cup", "grab cup"]);
        let mut trace = EpisodeTrace::new(flat.graph().clone(), flat.me);
        flat.sim.history().events().iter().for_each(|&e| trace.push(flat.graph().clone(), [e]));
        let now = Situation::new(flat.graph(), flat.me, flat.sim.history());
        prop_assert_eq!(goal.holds(&now), goal.holds_on(&trace), "{}", goal);
        prop_assert_eq!(goal.score(&now), goal.score_on(&trace), "{}", goal);
    }
}

/// The verdicts of the Embodied Agent Interface's evaluator and of VirtualCity, on a fridge that is opened and
/// closed.
#[test]
fn formulas_are_judged_as_published_beside_our_way() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    let mut trace = EpisodeTrace::new(world.graph().clone(), me);
    for line in ["walk fridge.2", "open fridge.2", "close fridge.2"] {
        let action = line.parse().unwrap();
        world.step(me, &action).unwrap();
        trace.push(world.graph().clone(), [Event { agent: me, action }]);
    }
    let cases = [
        // For EAI a condition is met if it held at any step.
        ("OPEN(fridge.2)", false, Some(true)),
        ("exists x0. (OPEN(x0))", false, Some(true)),
        ("forn 1. x0. (OPEN(x0))", false, Some(true)),
        ("CLOSED(fridge.2) then OPEN(fridge.2)", false, Some(true)),
        ("OPEN(fridge.2) then CLOSED(fridge.2)", true, Some(true)),
        ("OPEN(fridge.2) then OPEN(fridge.2)", false, Some(false)),
        // For EAI an action belongs to the state in which it begins.
        ("CLOSED(fridge.2) and CLOSE(fridge.2)", true, Some(false)),
        ("OPEN(fridge.2) and CLOSE(fridge.2)", false, Some(true)),
        ("CLOSE(fridge.2) then CLOSED(fridge.2)", true, Some(true)),
        // Brackets around a sequence use up all remaining steps.
        ("OPEN(fridge.2) then CLOSED(fridge.2) then CLOSED(fridge.2)", true, Some(false)),
        ("(WALK(fridge.2) then OPEN(fridge.2)) then CLOSED(fridge.2)", true, Some(false)),
        ("not (OPEN(fridge.2) then CLOSED(fridge.2))", false, Some(false)),
        ("not (OPEN(fridge.2) then OPEN(fridge.2))", true, Some(true)),
        // EAI uses only the edges that are written in a graph.
        ("NEXT_TO(character.3, kitchen.1)", true, Some(false)),
        ("OPEN(cup.2)", false, Some(false)),
        ("OPEN(fridge.2) and (OPEN(fridge.2) then CLOSED(fridge.2))", false, None),
    ];
    for (text, ours, theirs) in cases {
        let formula = Goal::from_eai(text).unwrap();
        assert_eq!(formula.holds_on(&trace), ours, "ours: {text}");
        assert_eq!(formula.eai_verdict(&trace).ok(), theirs, "theirs: {text}");
    }
    let native: Goal = "always Closed(fridge)".parse().unwrap();
    assert!(native.eai_verdict(&trace).unwrap_err().to_string().contains("its formulas have and, or, not"));
}

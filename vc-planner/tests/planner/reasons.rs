//! Unreachable goals, and the exact reason for each.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Draft, History, NodeId, SceneBuilder, SceneGraph};
use vc_planner::{Unreachable, plan};

/// One apple and one book on a table, a sofa, a fridge with a chicken in it.
fn flat() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(kitchen, Draft::new("sofa")).unwrap();
    for class in ["apple", "book"] {
        scene.add_on(table, Draft::new(class)).unwrap();
    }
    scene.add_in(fridge, Draft::new("chicken")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), me)
}

fn why(goal: &str) -> Unreachable {
    let (mut scene, me) = flat();
    plan(&mut scene, me, &goal.parse().unwrap(), &History::default()).unwrap_err()
}

/// One thing cannot be at two places: the error names the parts that ask for both.
#[test]
fn what_conflicts_is_named() {
    let part = |goal| match why(goal) {
        Unreachable::Conflicting(part) => part,
        other => panic!("{goal}: {other:?}"),
    };
    let both = "Inside(chicken, fridge) & On(chicken, kitchen_table)";
    assert_eq!(part(both), both);
    assert_eq!(part("On(apple, sofa) & Inside(apple, fridge)"), "On(apple, sofa) & Inside(apple, fridge)");
    assert_eq!(part("Open(fridge) & Closed(fridge)"), "Closed(fridge)");
}

/// The apple is a fruit and serves two parts at one place, so that counting things does not show the conflict:
/// every state is examined.
#[test]
fn what_only_a_search_can_tell_says_how_much_was_checked() {
    let goal = "On(apple, sofa) & On(fruit, sofa) & Inside(apple, fridge)";
    let exhausted = why(goal);
    let Unreachable::SearchExhausted { goal: told, checked } = &exhausted else { panic!("{exhausted:?}") };
    assert_eq!(told, goal);
    assert!(*checked > 1, "{checked}");
    let text = exhausted.to_string();
    assert!(text.starts_with(&format!("all {checked} states that matter were looked at")), "{text}");
    // With a second fruit there is no conflict.
    let (scene, me) = flat();
    let table = scene.of_class("kitchen_table")[0];
    let mut scene = SceneBuilder::from_graph(scene);
    scene.add_on(table, Draft::new("apple")).unwrap();
    assert!(plan(&mut scene.build(), me, &goal.parse().unwrap(), &History::default()).is_ok());
}

/// A label has a class and a number, which must belong to the same thing: planners and episodes report
/// violations.
#[test]
fn a_thing_that_is_called_what_it_is_not_is_refused() {
    let (scene, me) = flat();
    let [apple, book, table] = ["apple", "book", "kitchen_table"].map(|class| scene.of_class(class)[0].0);
    for (goal, told) in [
        (format!("Holds(fridge.{apple})"), format!("`fridge.{apple}` names a thing that is apple.{apple}")),
        (format!("exists ?t: table. On(apple.{book}, ?t)"), format!("apple.{book}` names a thing that is book")),
        (format!("!Holds(fridge.{apple})"), format!("is apple.{apple}")),
    ] {
        let parsed: vc_graph::Goal = goal.parse().unwrap();
        let why = plan(&mut scene.clone(), me, &parsed, &History::default()).unwrap_err().to_string();
        assert!(why.contains(&told), "{goal}: {why}");
        let task = vc_tasks::Task::new("t", parsed);
        let mut world = vc_graph::Simulator::new(scene.clone());
        let episode = vc_planner::run_episode(&mut vc_planner::PlannerPolicy::best(), &task, &mut world);
        assert_eq!((episode.outcome, episode.steps), (vc_tasks::Outcome::Lost, 0));
        assert_eq!(episode.reason.unwrap(), why);
    }
    // Superclasses and other spellings are correct.
    for goal in
        [format!("Holds(fruit.{apple})"), format!("On(Apple.{apple}, table.{table})"), format!("Holds(#{book})")]
    {
        assert!(plan(&mut scene.clone(), me, &goal.parse().unwrap(), &History::default()).is_ok(), "{goal}");
    }
}

/// If an episode is lost because the scene has too few things, the reason says which ones, and how many there
/// are.
#[test]
fn what_the_scene_lacks_is_named() {
    let (scene, _) = flat();
    let task = vc_tasks::Task::new("tea", "On(mug, kitchen_table), 2 & Holds(apple)".parse().unwrap());
    let mut world = vc_graph::Simulator::new(scene);
    for policy in [
        &mut vc_planner::PlannerPolicy::best() as &mut dyn vc_planner::Policy,
        &mut vc_planner::PlannerPolicy::oracle(),
    ] {
        let reason = vc_planner::run_episode(policy, &task, &mut world).reason.unwrap();
        assert!(reason.contains("needs 2 of `mug`, the scene has 0"), "{reason}");
    }
}

/// Three things are not held by turns in two hands: that is told at once, or when all are found.
#[test]
fn two_hands_hold_two_things() {
    let (scene, _) = flat();
    let task = vc_tasks::Task::new("armful", "Holds(apple) & Holds(book) & Holds(chicken)".parse().unwrap());
    for policy in [
        &mut vc_planner::PlannerPolicy::best() as &mut dyn vc_planner::Policy,
        &mut vc_planner::PlannerPolicy::oracle(),
    ] {
        let mut world = vc_graph::Simulator::new(scene.clone());
        let episode = vc_planner::run_episode(policy, &task, &mut world);
        let reason = episode.reason.unwrap();
        assert!(reason.contains("needs 3 things to be held at once, and an agent has 2 hands"), "{reason}");
        assert!(episode.steps < 20, "{} {}", policy.name(), episode.steps);
    }
}

/// Nobody waits for all choices of sixteen things.
#[test]
fn a_goal_that_ranges_over_too_much_is_refused_at_once() {
    let (scene, _) = flat();
    let variables: String = (0..16).map(|number| format!("forall ?v{number}. ")).collect();
    let task = vc_tasks::Task::new("vast", format!("{variables}On(?v0, ?v15)").parse().unwrap());
    let mut world = vc_graph::Simulator::new(scene.clone());
    let episode = vc_planner::run_episode(&mut vc_planner::PlannerPolicy::best(), &task, &mut world);
    assert!(episode.reason.is_some_and(|reason| reason.contains("choices of objects")));
    let found = vc_tasks::lint::goal(&task.goal, Some(&scene));
    assert!(found.iter().any(|finding| finding.part.contains("choices of objects")), "{found:?}");
}

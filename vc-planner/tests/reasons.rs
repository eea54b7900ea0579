//! Goals that cannot be reached, and the reason for each; what is asked for in vain is not
//! to be had by a few actions either.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use vc_graph::{Action, Draft, Goal, History, NodeId, Place, Relation, SceneBuilder, SceneGraph, Simulator, Verb};
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

/// One thing cannot be at two places: the part is named that asks for the second.
#[test]
fn what_conflicts_is_named() {
    let part = |goal| match why(goal) {
        Unreachable::Conflicting(part) => part,
        other => panic!("{goal}: {other:?}"),
    };
    assert_eq!(part("Inside(chicken, fridge) & On(chicken, kitchen_table)"), "On(chicken, kitchen_table)");
    assert_eq!(part("On(apple, sofa) & Inside(apple, fridge)"), "On(apple, sofa) & Inside(apple, fridge)");
    assert_eq!(part("Open(fridge) & Closed(fridge)"), "Closed(fridge)");
}

/// The apple is a fruit and serves two parts at one place, so that counting things does not
/// show the conflict: every state is looked at.
#[test]
fn what_only_a_search_can_tell_says_how_much_was_checked() {
    let goal = "On(apple, sofa) & On(fruit, sofa) & Inside(apple, fridge)";
    let exhausted = why(goal);
    let Unreachable::SearchExhausted { goal: told, checked } = &exhausted else { panic!("{exhausted:?}") };
    assert_eq!(told, goal);
    assert!(*checked > 1, "{checked}");
    let text = exhausted.to_string();
    assert!(text.starts_with(&format!("all {checked} states that matter were looked at")), "{text}");
    // The same with a second fruit is no conflict.
    let (scene, me) = flat();
    let table = scene.of_class("kitchen_table")[0];
    let mut scene = SceneBuilder::of(scene);
    scene.add_on(table, Draft::new("apple")).unwrap();
    assert!(plan(&mut scene.build(), me, &goal.parse().unwrap(), &History::default()).is_ok());
}

/// What is in the hands and in the way is put down near by, on furniture; nothing else is
/// touched.
#[test]
fn full_hands_are_emptied_where_it_does_no_harm() {
    let (scene, me) = flat();
    let [book, apple, chicken, sofa] = ["book", "apple", "chicken", "sofa"].map(|c| scene.of_class(c)[0]);
    let table = scene.of_class("kitchen_table")[0];
    let mut world = Simulator::new(scene);
    for (verb, id) in [(Verb::Walk, table), (Verb::Grab, apple), (Verb::Grab, book)] {
        world.step(me, &Action::one(verb, id)).unwrap();
    }
    let history = world.history().clone();
    let mut scene = world.into_graph();
    let goal: Goal = "On(chicken, sofa)".parse().unwrap();
    let found = plan(&mut scene, me, &goal, &history).unwrap();
    let mut world = Simulator::new(scene.clone());
    found.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
    let graph = world.graph();
    assert_eq!(graph.place(chicken).map(|p| p.at), Some(sofa));
    // One hand is enough: the other keeps what it holds.
    let held: Vec<NodeId> = graph.held(me).collect();
    assert_eq!(held.len(), 1, "{:?}", found.actions);
    let put: NodeId = if held[0] == book { apple } else { book };
    assert_eq!(graph.place(put), Some(Place { relation: Relation::On, at: table }), "{:?}", found.actions);
    let moved = |a: &Action| matches!(a.verb, Verb::Grab | Verb::Place | Verb::PutIn | Verb::Drop).then_some(a.object);
    let touched: Vec<Option<NodeId>> = found.actions.iter().filter_map(moved).collect();
    assert!(touched.iter().flatten().all(|id| [put, chicken].contains(id)), "{:?}", found.actions);
}

//! Plans: they can be carried out, reach the goal, and leave the scene alone; goals
//! that cannot be reached are refused with a reason.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::goal::Situation;
use vc_graph::{Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, Simulator, State};
use vc_planner::{Unreachable, plan};

/// A kitchen and a living room with what the goals below are about.
fn home() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("home");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let living = scene.add(Draft::new("living_room")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let counter = scene.add_in(kitchen, Draft::new("kitchen_counter")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let dishwasher = scene.add_in(kitchen, Draft::new("dishwasher")).unwrap();
    scene.add_in(kitchen, Draft::new("stove")).unwrap();
    scene.add_on(counter, Draft::new("faucet")).unwrap();
    scene.add_on(counter, Draft::new("pot")).unwrap();
    let coffee_table = scene.add_in(living, Draft::new("coffee_table")).unwrap();
    scene.add_in(living, Draft::new("sofa")).unwrap();
    scene.add_in(living, Draft::new("television")).unwrap();
    for place in [counter, coffee_table, table] {
        scene.add_on(place, Draft::new("plate").state(State::Dirty)).unwrap();
        scene.add_on(place, Draft::new("apple")).unwrap();
    }
    scene.add_on(counter, Draft::new("knife")).unwrap();
    scene.add_on(counter, Draft::new("water_glass")).unwrap();
    scene.add_on(coffee_table, Draft::new("book")).unwrap();
    scene.add_in(living, Draft::new("jacket")).unwrap();
    scene.add_in(fridge, Draft::new("milk")).unwrap();
    scene.add_in(fridge, Draft::new("chicken")).unwrap();
    scene.add_in(dishwasher, Draft::new("mug")).unwrap();
    let me = scene.add_in(living, Draft::new("character")).unwrap();
    (scene.build(), me)
}

/// Goals of every kind the language has, and how many actions they take at most.
const GOALS: &[(&str, usize)] = &[
    ("On(apple, kitchen_table), 3 & Closed(fridge)", 12),
    ("Inside(plate, dishwasher), 3 & Closed(dishwasher) & SwitchedOn(dishwasher)", 18),
    ("forall ?p: plate. Clean(?p)", 12),
    ("forall ?p: plate. (Clean(?p) & On(?p, kitchen_counter))", 20),
    ("exists ?t: table. On(milk, ?t)", 8),
    ("On(milk, coffee_table) | On(unicorn, coffee_table)", 8),
    ("!On(apple, coffee_table) & !On(plate, coffee_table)", 10),
    ("On(apple, kitchen_table), = 2", 8),
    ("On(apple, kitchen_counter), <= 0", 6),
    ("Holds(milk) & Holds(book)", 8),
    ("Sit(sofa) & Watch(television) & SwitchedOn(television)", 8),
    ("Sit(sofa) & Read(book)", 8),
    ("Sit(sofa) & On(book, kitchen_table)", 6),
    ("Lie(sofa) & On(book, kitchen_table) & Inside(jacket, dishwasher) & Closed(dishwasher)", 12),
    ("Wear(jacket)", 4),
    ("Sliced(apple)", 6),
    ("Cooked(chicken)", 14),
    ("Filled(water_glass)", 8),
    ("Wash(apple) then Eat(apple)", 6),
    ("Drink(milk) & Closed(fridge)", 8),
    ("Inside(book, kitchen)", 6),
    ("Near(fridge) & Holds(knife)", 6),
    ("Open(fridge) & Holds(apple) & Holds(book)", 10),
    ("Dance() & Wave()", 2),
    ("Lie(sofa) & Sleep()", 4),
];

#[test]
fn plans_can_be_carried_out_and_reach_the_goal() {
    for (text, most) in GOALS {
        let (mut scene, me) = home();
        let before = scene.clone();
        let goal: Goal = text.parse().unwrap();
        let plan = plan(&mut scene, me, &goal, &History::default()).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(scene, before, "{text}: planning changed the scene");
        let mut world = Simulator::new(scene);
        for action in &plan.actions {
            let told = action.describe(&before).to_string();
            world.step(me, action).unwrap_or_else(|r| panic!("{text}: {told}: {}", r[0]));
        }
        assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{text}: {:?}", plan.actions);
        assert!(plan.actions.len() <= *most, "{text}: {} actions: {:?}", plan.actions.len(), plan.actions);
        assert_eq!(world.graph().validate(), [], "{text}");
    }
}

#[test]
fn a_goal_that_holds_needs_no_plan() {
    let (mut scene, me) = home();
    let goal = "Closed(fridge) & On(apple, kitchen_table)".parse().unwrap();
    assert_eq!(plan(&mut scene, me, &goal, &History::default()).unwrap().actions, []);
}

#[test]
fn what_cannot_be_reached_is_told_with_its_reason() {
    let (mut scene, me) = home();
    let mut why = |text: &str| plan(&mut scene, me, &text.parse().unwrap(), &History::default()).unwrap_err();
    assert!(matches!(why("On(unicorn, kitchen_table)"), Unreachable::NoInstance(_)));
    assert!(matches!(why("On(apple, kitchen_table), 4"), Unreachable::NoInstance(_)));
    assert!(matches!(why("On(fridge, kitchen_table)"), Unreachable::NotGraspable(_)));
    assert!(matches!(why("Open(sofa)"), Unreachable::NotOpenable(_)));
    assert!(matches!(why("SwitchedOn(sofa)"), Unreachable::NotSwitchable(_)));
    assert!(matches!(why("On(apple, book)"), Unreachable::NotASurface(_)));
    assert!(matches!(why("Inside(apple, sofa)"), Unreachable::NotAContainer(_)));
    assert!(matches!(why("Eat(sofa)"), Unreachable::NotAfforded(_)));
    assert!(matches!(
        why("Inside(chicken, fridge) & On(chicken, kitchen_table)"),
        Unreachable::Conflicting(_) | Unreachable::SearchExhausted { .. } | Unreachable::NoPlan(_)
    ));
    assert!(matches!(why("Broken(plate)"), Unreachable::NoPlan(_)));
    assert!(matches!(why("Near(fridge) & Touching(apple, fridge)"), Unreachable::NoPlan(_)));
}

#[test]
fn full_hands_are_emptied_where_it_does_no_harm() {
    let (scene, me) = home();
    let mut world = Simulator::new(scene);
    for class in ["book", "jacket"] {
        let id = world.graph().of_class(class)[0];
        for verb in ["walk", "grab"] {
            world.step(me, &format!("{verb} #{}", id.0).parse().unwrap()).unwrap();
        }
    }
    let goal: Goal = "Inside(apple, fridge)".parse().unwrap();
    let history = world.history().clone();
    let mut scene = world.into_graph();
    let plan = plan(&mut scene, me, &goal, &history).unwrap();
    let mut world = Simulator::new(scene);
    plan.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
    assert!(goal.holds(&Situation::new(world.graph(), me, world.history())));
    let dropped = plan.actions.iter().any(|a| a.verb == vc_graph::Verb::Drop);
    assert!(!dropped, "{:?}", plan.actions);
}

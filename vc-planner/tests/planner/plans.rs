//! Plans can be executed, reach the goal, and leave the scene unchanged; unreachable goals are refused with a
//! reason.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::goal::Situation;
use vc_graph::{Draft, Goal, History, Node, NodeId, Property, Relation, SceneBuilder, SceneGraph, Simulator, State};
use vc_planner::{Unreachable, plan};

/// A kitchen and a living room with the things of the goals below.
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

/// Goals of every kind in the language, with the largest number of actions for each.
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
    ("InRoom(book, kitchen) & InRoom(milk, living_room)", 8),
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
    // Equality and inequality.
    ("exists ?a: apple. (?a != apple.18 & On(?a, kitchen_table))", 4),
    ("forall ?a: apple. (On(?a, kitchen_table) | ?a = apple.14)", 4),
    ("exists ?a: apple. (?a = apple.16 & Holds(?a))", 2),
    ("!(exists ?a: apple. (?a != apple.14 & On(?a, coffee_table)))", 2),
    // Numbers of things.
    ("exactly 1 ?a: apple. On(?a, kitchen_counter)", 0),
    ("exactly 2 ?a: apple. On(?a, kitchen_table)", 4),
    ("exactly 1 ?p: plate. (Clean(?p) & On(?p, kitchen_counter))", 4),
    ("at most 1 ?a: apple. (On(?a, coffee_table) | On(?a, kitchen_table))", 2),
    ("at most 0 ?p: plate. On(?p, coffee_table)", 2),
    // Pairs.
    ("pairs ?p: plate, ?t: table. On(?p, ?t)", 0),
    ("pairs ?a: apple, ?p: plate. (On(?a, kitchen_table) & On(?p, kitchen_table))", 12),
    ("at least 2 pairs ?p: plate, ?a: apple. (On(?p, kitchen_table) & On(?a, kitchen_table))", 6),
    ("at least 2 marginal pairs ?p: plate, ?t: table. On(?p, ?t)", 0),
    ("exactly 1 pairs ?p: plate, ?t: table. On(?p, ?t)", 4),
    ("at most 2 pairs ?p: plate, ?t: table. On(?p, ?t)", 2),
    ("!(pairs ?p: plate, ?t: table. On(?p, ?t))", 2),
    // Conditions, and negations.
    ("SwitchedOn(television) => Sit(sofa)", 0),
    ("Closed(fridge) => Open(dishwasher)", 2),
    ("!(Closed(fridge) => On(apple, coffee_table))", 2),
    ("!(at least 2 ?p: plate. Dirty(?p))", 8),
    ("!(at most 1 ?a: apple. On(?a, kitchen_table))", 4),
    ("!(exactly 3 ?a: apple. On(?a, kitchen_counter))", 0),
    ("!(exactly 1 ?a: apple. On(?a, coffee_table))", 2),
    ("!(On(apple, coffee_table) & On(plate, coffee_table))", 2),
    // Orders.
    ("eventually did open(fridge) & Closed(fridge)", 3),
    ("did grab(apple) before did open(fridge)", 2),
    ("(did grab(apple) before did open(fridge)) & Inside(apple, fridge)", 5),
    ("Closed(fridge) until did open(dishwasher)", 2),
    ("within 3 steps did wave() & On(book, kitchen_table)", 5),
    ("always !did eat(apple) & On(apple, coffee_table), <= 0", 2),
    ("at end Closed(fridge) & Holds(milk)", 4),
    ("(Grab(apple) then did open(fridge)) & Closed(fridge)", 5),
];

/// The fault of the plan for a goal, if there is one.
fn fault(text: &str, most: usize) -> Option<String> {
    let (mut scene, me) = home();
    let before = scene.clone();
    let goal: Goal = text.parse().unwrap();
    let plan = match plan(&mut scene, me, &goal, &History::default()) {
        Ok(plan) => plan,
        Err(why) => return Some(why.to_string()),
    };
    if scene != before {
        return Some("planning changed the scene".into());
    }
    let mut world = Simulator::new(scene);
    let told: Vec<String> = plan.actions.iter().map(|a| a.describe(&before).to_string()).collect();
    for (action, told) in plan.actions.iter().zip(&told) {
        if let Err(refusals) = world.step(me, action) {
            return Some(format!("{told}: {}", refusals[0]));
        }
    }
    if !goal.holds(&Situation::new(world.graph(), me, world.history())) {
        return Some(format!("not reached by {told:?}"));
    }
    if told.len() > most {
        return Some(format!("{} actions: {told:?}", told.len()));
    }
    (!world.graph().validate().is_empty()).then(|| format!("{:?}", world.graph().validate()))
}

#[test]
fn plans_can_be_carried_out_and_reach_the_goal() {
    let faults: Vec<String> =
        GOALS.iter().filter_map(|(text, most)| fault(text, *most).map(|why| format!("{text}: {why}"))).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A plan with one action left out is refused, or misses the goal.
#[test]
fn no_action_can_be_left_out() {
    let mut left_out = 0;
    for (text, _) in GOALS {
        let (mut scene, me) = home();
        let goal: Goal = text.parse().unwrap();
        let actions = plan(&mut scene, me, &goal, &History::default()).unwrap().actions;
        for gap in 0..actions.len() {
            let mut world = Simulator::new(scene.clone());
            let mut rest = actions[..gap].iter().chain(&actions[gap + 1..]);
            let accepted = rest.all(|action| world.step(me, action).is_ok());
            let reached = accepted && goal.holds(&Situation::new(world.graph(), me, world.history()));
            let told = || actions.iter().map(|a| a.describe(&scene).to_string()).collect::<Vec<_>>();
            assert!(!reached, "{text}: {} of {:?}", actions[gap].describe(&scene), told());
            left_out += 1;
        }
    }
    assert!(left_out > 200, "{left_out}");
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
    let conflict = why("Inside(chicken, fridge) & On(chicken, kitchen_table)");
    assert_eq!(conflict, Unreachable::Conflicting("Inside(chicken, fridge) & On(chicken, kitchen_table)".into()));
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
    let before = scene.clone();
    let plan = plan(&mut scene, me, &goal, &history).unwrap();
    let mut world = Simulator::new(scene);
    plan.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
    assert!(goal.holds(&Situation::new(world.graph(), me, world.history())));
    // The formerly held things are on furniture or still held; of the other things only an apple moves.
    let (after, told) = (world.graph(), || format!("{:?}", plan.actions));
    let [book, jacket] = ["book", "jacket"].map(|c| after.of_class(c)[0]);
    let is_fixed = |id: NodeId| !after.node(id).unwrap().affords(Property::Graspable);
    for id in [book, jacket] {
        let on_furniture = after.place(id).is_some_and(|p| p.relation == Relation::On && is_fixed(p.at));
        assert!(on_furniture || after.held(me).any(|held| held == id), "{}", told());
    }
    assert!(after.held(me).count() < 2, "{}", told());
    let moved = after.nodes().map(Node::id).filter(|&id| id != me && after.place(id) != before.place(id));
    let moved: Vec<NodeId> = moved.filter(|id| ![book, jacket].contains(id)).collect();
    assert!(matches!(moved[..], [one] if after.of_class("apple").contains(&one)), "{}", told());
}

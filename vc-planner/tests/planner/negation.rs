//! If a thing must not be at a place, only that place is searched for it.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{Action, Draft, NodeId, SceneBuilder, SceneGraph, Seed, Simulator, Verb};
use vc_planner::{EpisodeOptions, PlannerPolicy};
use vc_tasks::{Outcome, Task};

const BOXES: [&str; 5] = ["fridge", "kitchen_cabinet", "closet", "bathroom_cabinet", "microwave"];

/// Three rooms, two tables, ten boxes; two mugs, on the coffee table or in boxes.
fn home(seed: u64, on_table: usize) -> SceneGraph {
    let mut stream = Seed(seed).child("negation").stream();
    let mut scene = SceneBuilder::new("home");
    let rooms = ["kitchen", "living_room", "bedroom"].map(|room| scene.add(Draft::new(room)).unwrap());
    let table = scene.add_in(rooms[1], Draft::new("coffee_table")).unwrap();
    scene.add_in(rooms[0], Draft::new("kitchen_table")).unwrap();
    let mut furniture = |class: &&str| scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(*class)).unwrap();
    let boxes: Vec<NodeId> = BOXES.iter().chain(&BOXES).map(&mut furniture).collect();
    for number in 0..2 {
        if number < on_table {
            scene.add_on(table, Draft::new("mug")).unwrap();
        } else {
            scene.add_in(*stream.pick(&boxes).unwrap(), Draft::new("mug")).unwrap();
        }
    }
    scene.add_in(rooms[0], Draft::new("character")).unwrap();
    scene.build()
}

/// The actions of each of two newcomers for a goal.
fn actions_for(scene: &SceneGraph, goal: &str, seed: u64) -> [Vec<Action>; 2] {
    let task = Task::new("not there", goal.parse().unwrap());
    [PlannerPolicy::best(), PlannerPolicy::faithful()].map(|mut policy| {
        let mut world = Simulator::new(scene.clone());
        let episode = EpisodeOptions::seeded(seed).episode(&mut policy, &task, &mut world, &mut |_| {});
        assert_eq!(episode.outcome, Outcome::Won, "{seed} {goal}: {episode:?}");
        world.history().events().iter().map(|event| event.action).collect()
    })
}

/// The opened things.
fn opened(actions: &[Action]) -> impl Iterator<Item = NodeId> {
    actions.iter().filter(|a| a.verb == Verb::Open).filter_map(|a| a.object)
}

/// One look at a table suffices for it; other things need not be found.
#[test]
fn what_is_not_to_be_on_a_table_is_looked_for_there() {
    let goals = [
        "!On(mug, coffee_table)",
        "On(mug, coffee_table), <= 0",
        "forall ?m: mug. !On(?m, coffee_table)",
        "!(exists ?m: mug. On(?m, coffee_table))",
    ];
    for (seed, goal) in (0..10).flat_map(|seed| goals.map(|goal| (seed, goal))) {
        for on_table in 0..3 {
            for actions in actions_for(&home(seed, on_table), goal, seed) {
                // One walk to the table, and for each mug one walk to it and a grab.
                assert!(actions.len() <= 1 + 2 * on_table, "{seed} {goal}: {actions:?}");
                assert_eq!(opened(&actions).count(), 0, "{seed} {goal}");
            }
        }
    }
}

#[test]
fn only_what_may_hold_it_is_opened() {
    for seed in 0..10 {
        let scene = home(seed, 0);
        let living = scene.of_class("living_room")[0];
        for actions in actions_for(&scene, "!Inside(mug, fridge)", seed) {
            assert_eq!(opened(&actions).count(), 2, "{seed}: {actions:?}");
            assert!(opened(&actions).all(|id| scene.of_class("fridge").contains(&id)), "{seed}: {actions:?}");
        }
        for actions in actions_for(&scene, "!InRoom(mug, living_room)", seed) {
            assert!(opened(&actions).all(|id| scene.room_of(id) == Some(living)), "{seed}: {actions:?}");
        }
    }
}

/// Things that have been seen elsewhere need no look.
#[test]
fn what_is_known_to_be_elsewhere_is_not_looked_for() {
    let mut scene = SceneBuilder::new("home");
    let [kitchen, bedroom] = ["kitchen", "bedroom"].map(|room| scene.add(Draft::new(room)).unwrap());
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    scene.add_in(bedroom, Draft::new("desk")).unwrap();
    scene.add_on(table, Draft::new("mug")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    for actions in actions_for(&scene.build(), "!On(mug, desk)", 0) {
        assert_eq!(actions, []);
    }
}

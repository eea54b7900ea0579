//! Manners: a tidy agent leaves doors and switches in their original state as far as the goal allows; others
//! leave them as they happen to be.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use vc_graph::goal::Situation;
use vc_graph::{Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, Seed, Simulator, State};
use vc_planner::{EpisodeOptions, Manners, Planner, PlannerPolicy, Policy, Unreachable};
use vc_tasks::{Outcome, Task};

/// A home in which some doors are open and some machines run at first, and most things are in closed
/// containers.
fn home(seed: u64) -> SceneGraph {
    let mut stream = Seed(seed).child("manners").stream();
    let mut scene = SceneBuilder::new("home");
    let rooms = ["kitchen", "living_room", "bedroom"].map(|r| scene.add(Draft::new(r)).unwrap());
    scene.add_in(rooms[0], Draft::new("kitchen_table")).unwrap();
    scene.add_in(rooms[0], Draft::new("stove")).unwrap();
    scene.add_in(rooms[1], Draft::new("sofa")).unwrap();
    scene.add_in(rooms[1], Draft::new("television").state(State::On)).unwrap();
    scene.add_in(rooms[2], Draft::new("desk")).unwrap();
    let mut boxes = Vec::new();
    for class in ["fridge", "kitchen_cabinet", "dishwasher", "microwave", "closet", "bathroom_cabinet"] {
        let draft = if stream.below(4) == 0 { Draft::new(class).state(State::Open) } else { Draft::new(class) };
        boxes.push(scene.add_in(*stream.pick(&rooms).unwrap(), draft).unwrap());
    }
    for class in ["apple", "milk", "plate", "mug", "book", "towel", "chicken", "plate", "book"] {
        scene.add_in(*stream.pick(&boxes).unwrap(), Draft::new(class)).unwrap();
    }
    // One running machine blocks access to its contents.
    let mut scene = {
        scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new("character")).unwrap();
        scene.build()
    };
    let microwave = scene.of_class("microwave")[0];
    if !scene.node(microwave).unwrap().is(State::Open) {
        let mut edit = scene.edit();
        edit.set_states(microwave, edit.graph().node(microwave).unwrap().states().entering(State::On)).unwrap();
        edit.commit();
    }
    scene
}

const GOALS: [&str; 10] = [
    "On(apple, kitchen_table)",
    "On(plate, kitchen_table), 2 & On(mug, kitchen_table)",
    "Holds(book) & Holds(towel)",
    "On(milk, desk) & Open(fridge)",
    "Inside(mug, dishwasher) & Closed(dishwasher) & SwitchedOn(dishwasher)",
    "Sit(sofa) & Holds(book)",
    "Sit(sofa) & SwitchedOff(television) & On(towel, desk)",
    "Drink(milk) & On(book, kitchen_table)",
    "exactly 1 ?p: plate. On(?p, kitchen_table)",
    "!(Closed(closet) => Inside(apple, closet))",
];

const WORDS: [State; 4] = [State::Open, State::Closed, State::On, State::Off];

/// Doors and switches that are not in their original state although the goal would hold with it.
fn amiss(before: &SceneGraph, world: &Simulator, me: NodeId, goal: &Goal) -> Vec<String> {
    let after = world.graph();
    let word = |scene: &SceneGraph, id, word: &State| scene.node(id).unwrap().is(*word);
    let mut found = Vec::new();
    for id in before.nodes().map(vc_graph::Node::id) {
        for was in WORDS.iter().filter(|w| word(before, id, w) && !word(after, id, w)) {
            let mut put_back = after.clone();
            let states = put_back.node(id).unwrap().states().entering(*was);
            let mut edit = put_back.edit();
            edit.set_states(id, states).unwrap();
            edit.commit();
            if goal.holds(&Situation::new(&put_back, me, world.history())) {
                found.push(format!("{} was {was:?}", before.label(id)));
            }
        }
    }
    found
}

/// Lets a policy do a task; returns the doors and switches that it leaves in another state.
fn left(policy: &mut dyn Policy, seed: u64, text: &str) -> Vec<String> {
    let scene = home(seed);
    let me = scene.agents()[0];
    let task = Task::new("manners", text.parse().unwrap());
    let mut world = Simulator::new(scene.clone());
    let mut done = Vec::new();
    let episode =
        EpisodeOptions::seeded(seed).episode(policy, &task, &mut world, &mut |step| done.push(step.described.clone()));
    assert_eq!(episode.outcome, Outcome::Won, "{seed} {text} {}: {episode:?} {done:?}", policy.name());
    let amiss = amiss(&scene, &world, me, &task.goal);
    amiss.into_iter().map(|what| format!("{seed} {text} {}: {what}: {done:?}", policy.name())).collect()
}

#[test]
fn who_is_tidy_leaves_doors_and_switches_as_they_were() {
    let mut rude = 0;
    for (seed, text) in (0..12).flat_map(|seed| GOALS.map(|text| (seed, text))) {
        for policy in [
            &mut PlannerPolicy::oracle().with_manners(Manners::Tidy) as &mut dyn Policy,
            &mut PlannerPolicy::best().with_manners(Manners::Tidy),
            &mut PlannerPolicy::faithful().with_manners(Manners::Tidy),
        ] {
            assert_eq!(left(policy, seed, text), [""; 0]);
        }
        rude += left(&mut PlannerPolicy::best(), seed, text).len();
    }
    println!("{rude} doors and switches left amiss by who is not");
    assert!(rude >= 100, "{rude}");
}

fn tidy_planner() -> Planner {
    let mut planner = Planner::default();
    planner.manners = Manners::Tidy;
    planner
}

#[test]
fn whole_plans_are_tidy() {
    let further = ["Cooked(chicken)", "Near(fridge) & Read(book)", "Lie(sofa) & Read(book)"];
    let mut planner = tidy_planner();
    for (seed, text) in (0..12).flat_map(|seed| GOALS.into_iter().chain(further).map(move |text| (seed, text))) {
        let scene = home(seed);
        let (me, goal) = (scene.agents()[0], text.parse::<Goal>().unwrap());
        let plan = planner.plan(&mut scene.clone(), me, &goal, History::default().events());
        let plan = plan.unwrap_or_else(|why| panic!("{seed} {text}: {why}"));
        let mut world = Simulator::new(scene.clone());
        plan.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
        assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{seed} {text}");
        assert_eq!(amiss(&scene, &world, me, &goal), [""; 0], "{seed} {text}: {:?}", plan.actions);
    }
}

#[test]
fn manners_hide_no_conflict() {
    let scene = home(0);
    let me = scene.agents()[0];
    let mut planner = tidy_planner();
    for text in ["Open(fridge) & Closed(fridge)", "SwitchedOn(television) & SwitchedOff(television)"] {
        let found = planner.plan(&mut scene.clone(), me, &text.parse().unwrap(), &[]);
        assert!(matches!(found, Err(Unreachable::Conflicting(_))), "{text}: {found:?}");
    }
}

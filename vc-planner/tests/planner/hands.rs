//! Both hands full before a closed door: something useful is put down and taken up again.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::brute;

use vc_graph::{Action, Draft, Goal, History, NodeId, Place, Relation, SceneBuilder, SceneGraph, Simulator, Verb};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, plan};
use vc_tasks::{Outcome, Task};

/// A desk in one room, a closed cabinet and a fridge in another, a book, a mug and an apple.
struct Home {
    scene: SceneGraph,
    me: NodeId,
    things: Vec<NodeId>,
    places: Vec<NodeId>,
}

/// The classes of `held` are in the hands, the other things on the desk; one stands at the
/// cabinet or has just come in where the desk is.
fn home(held: &[&str], at_cabinet: bool) -> Home {
    let mut scene = SceneBuilder::new("hands");
    let study = scene.add(Draft::new("office")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    let desk = scene.add_in(study, Draft::new("desk")).unwrap();
    let cabinet = scene.add_in(bedroom, Draft::new("bathroom_cabinet")).unwrap();
    let fridge = scene.add_in(bedroom, Draft::new("fridge")).unwrap();
    let classes = ["book", "mug", "apple"];
    let things: Vec<NodeId> = classes.iter().map(|c| scene.add_on(desk, Draft::new(*c)).unwrap()).collect();
    let me = scene.add_in(study, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    let mut act = |action: Action| world.step(me, &action).unwrap();
    act(Action::one(Verb::Walk, desk));
    for (class, &id) in classes.iter().zip(&things).filter(|(class, _)| held.contains(class)) {
        assert!(act(Action::one(Verb::Grab, id)).changes().len() > 1, "{class}");
    }
    act(Action::one(Verb::Walk, if at_cabinet { cabinet } else { study }));
    Home { scene: world.into_graph(), me, things, places: vec![desk, cabinet, fridge] }
}

fn actions(home: &Home) -> Vec<Action> {
    let mut all = Vec::new();
    for &place in &home.places {
        all.extend([Verb::Walk, Verb::Open, Verb::Close].map(|verb| Action::one(verb, place)));
        let puts = |&item: &NodeId| [Verb::Place, Verb::PutIn].map(|verb| Action::two(verb, item, place));
        all.extend(home.things.iter().flat_map(puts));
    }
    let singles = |&item: &NodeId| [Verb::Walk, Verb::Grab, Verb::Drop].map(|verb| Action::one(verb, item));
    all.extend(home.things.iter().flat_map(singles));
    all
}

#[test]
fn what_is_useful_is_put_down_and_taken_up_again() {
    let both = "Inside(book, bathroom_cabinet) & Inside(mug, bathroom_cabinet)";
    let cases: [(&[&str], bool, &str, bool); 6] = [
        (&["book", "mug"], true, both, true),
        (&["book", "mug"], false, both, true),
        (&["book", "mug"], true, "Inside(book, bathroom_cabinet) & Inside(mug, fridge)", true),
        (&["book", "mug"], true, "Inside(book, bathroom_cabinet) & Holds(mug) & Closed(bathroom_cabinet)", true),
        // With a hand free nothing needs to be put down.
        (&["book"], true, both, false),
        (&[], false, both, false),
    ];
    for (held, at_cabinet, text, again) in cases {
        let home = home(held, at_cabinet);
        let goal: Goal = text.parse().unwrap();
        let found = plan(&mut home.scene.clone(), home.me, &goal, &History::default()).unwrap();
        let told = format!("{held:?} {at_cabinet} {text}: {:?}", found.actions);
        let within =
            brute::World { scene: &home.scene, me: home.me, actions: &actions(&home), remembered: &|_| Vec::new() };
        let best = brute::shortest(&within, &goal, found.actions.len() + 1, 200_000).unwrap();
        assert_eq!(best, Some(found.actions.len()), "{told}");
        let held_first = |id: &NodeId| home.scene.holder(*id).is_some();
        let retaken =
            found.actions.iter().filter(|a| a.verb == Verb::Grab && a.object.is_some_and(|id| held_first(&id)));
        assert_eq!(retaken.count() > 0, again, "{told}");
        let mut world = Simulator::new(home.scene.clone());
        found.actions.iter().for_each(|a| drop(world.step(home.me, a).unwrap()));
        let cabinet = home.places[1];
        assert!(
            world.graph().places(home.things[0]).any(|p| p.relation == Relation::Inside && p.at == cabinet),
            "{told}"
        );
    }
}

/// A held thing that is of no use and in the way is put on the table at hand; nothing else is touched.
#[test]
fn a_full_hand_is_emptied_on_the_table_at_hand() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let [table, fridge, sofa] =
        ["kitchen_table", "fridge", "sofa"].map(|class| scene.add_in(kitchen, Draft::new(class)).unwrap());
    let [apple, book] = ["apple", "book"].map(|class| scene.add_on(table, Draft::new(class)).unwrap());
    let chicken = scene.add_in(fridge, Draft::new("chicken")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    for (verb, id) in [(Verb::Walk, table), (Verb::Grab, apple), (Verb::Grab, book)] {
        world.step(me, &Action::one(verb, id)).unwrap();
    }
    let goal: Goal = "On(chicken, sofa)".parse().unwrap();
    let found = plan(&mut world.graph().clone(), me, &goal, &History::default()).unwrap();
    found.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
    let graph = world.graph();
    let on = |at| Some(Place { relation: Relation::On, at });
    assert_eq!(graph.place(chicken), on(sofa));
    // One hand is enough: the other keeps what it holds.
    let held: Vec<NodeId> = graph.held(me).collect();
    let put = if held == [book] { apple } else { book };
    assert!(held == [apple] || held == [book], "{:?}", found.actions);
    assert_eq!(graph.place(put), on(table), "{:?}", found.actions);
    assert_eq!(found.actions.len(), 6, "{:?}", found.actions);
}

/// Which hand is to hold what, whatever is in the hands before: each goal that the rule can bring about is
/// reached, by who knows everything and by who is new, in at most one action more than the fewest.
#[test]
fn each_hand_holds_what_the_goal_says() {
    let goals = [
        "HoldsLeft(me, toothbrush)",
        "HoldsRight(me, toothbrush)",
        "HoldsLeft(me, toothbrush) & HoldsRight(me, apple)",
        "HoldsLeft(me, apple) & HoldsRight(me, toothbrush)",
        "HoldsLeft(me, mug) & On(apple, table)",
        "HoldsRight(me, mug) & Holds(apple)",
        "HoldsLeft(me, mug) & Holds(apple) & On(toothbrush, table)",
        "HoldsLeft(me, apple) & !HoldsRight(me, toothbrush)",
    ];
    let held: [&[&str]; 6] =
        [&[], &["apple"], &["toothbrush"], &["apple", "toothbrush"], &["toothbrush", "apple"], &["mug", "apple"]];
    for hands in held {
        let (scene, me, actions) = washroom(hands);
        for text in goals {
            let goal: Goal = text.parse().unwrap();
            let within = brute::World { scene: &scene, me, actions: &actions, remembered: &|_| Vec::new() };
            let best = brute::shortest(&within, &goal, 9, 200_000).unwrap().unwrap();
            let task = Task::new("hands", goal);
            let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
            for mut policy in policies {
                let mut world = Simulator::new(scene.clone());
                let episode = EpisodeOptions::seeded(2).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
                assert_eq!(episode.outcome, Outcome::Won, "{hands:?} {text} {}: {episode:?}", policy.name());
                assert!(episode.steps <= best + 1, "{hands:?} {text} {}: {episode:?} for {best}", policy.name());
            }
        }
    }
}

/// A table with things on it, some of them already taken; and all that can be done with them.
fn washroom(hands: &[&str]) -> (SceneGraph, NodeId, Vec<Action>) {
    let mut scene = SceneBuilder::new("washroom");
    let bathroom = scene.add(Draft::new("bathroom")).unwrap();
    let table = scene.add_in(bathroom, Draft::new("table")).unwrap();
    let classes = ["toothbrush", "apple", "mug"];
    let things = classes.map(|class| scene.add_on(table, Draft::new(class)).unwrap());
    let me = scene.add_in(bathroom, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    world.step(me, &Action::one(Verb::Walk, table)).unwrap();
    for class in hands {
        let id = things[classes.iter().position(|c| c == class).unwrap()];
        world.step(me, &Action::one(Verb::Grab, id)).unwrap();
    }
    let singles = |id: &NodeId| {
        [Action::one(Verb::Grab, *id), Action::one(Verb::Drop, *id), Action::two(Verb::Place, *id, table)]
    };
    (world.into_graph(), me, things.iter().flat_map(singles).collect())
}

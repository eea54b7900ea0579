//! The likeliest places by the belief, and carriable containers as further places to look into.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::homes;

use homes::{ITEMS, home};
use vc_graph::{
    Action, Draft, NodeId, Place, Property, Relation, SceneBuilder, SceneGraph, Scope, Simulator, State, Verb,
};
use vc_planner::{Belief, EpisodeOptions, PlannerPolicy, Policy, Prior};
use vc_tasks::{Outcome, Task};

/// The place of a thing, also on a bare floor.
fn place(scene: &SceneGraph, id: NodeId) -> Option<Place> {
    let floor = || Some(Place { relation: Relation::InRoom, at: scene.room_of(id)? });
    scene.place(id).or_else(floor)
}

#[test]
fn the_likeliest_state_has_each_thing_where_it_is_likeliest() {
    for seed in 0..6 {
        for prior in [Prior::Uniform, Prior::Kept] {
            let scene = home(seed);
            let me = scene.agents()[0];
            let mut belief = Belief::with_prior(&scene, me, seed, prior.clone());
            check_likeliest(&belief, &scene);
            // Once more after an observation.
            belief.observe(&scene.observe(me, Scope::Room));
            check_likeliest(&belief, &scene);
        }
    }
}

fn check_likeliest(belief: &Belief, scene: &SceneGraph) {
    let state = belief.most_likely_state();
    assert_eq!(state.validate(), []);
    let text = belief.to_string();
    let mut missing = 0;
    for id in ITEMS.iter().flat_map(|class| scene.of_class(class)) {
        let chances = belief.distribution(id);
        let (likeliest, chance) = chances[0];
        assert_eq!(belief.most_likely(id), Some(likeliest));
        assert!(chances.iter().all(|(_, c)| *c <= chance));
        assert!((chances.iter().map(|(_, c)| c).sum::<f64>() - 1.0).abs() < 1e-9);
        assert_eq!(place(&state, id), Some(likeliest), "{}", scene.label(id));
        let line = text.lines().find(|l| l.starts_with(&format!("{}:", scene.label(id))));
        assert_eq!(line.is_some(), belief.is_missing(id), "{text}");
        if let Some(line) = line {
            missing += 1;
            let first = format!(": {:.0}% {} {}", 100.0 * chance, likeliest.relation, scene.label(likeliest.at));
            assert!(line.contains(&first), "{line}: {first}");
        } else {
            assert_eq!(place(&state, id), place(scene, id));
        }
    }
    let head = format!("{missing} things not found, {} places not searched", belief.open_places());
    assert_eq!(text.lines().next(), Some(head.as_str()));
}

/// An apple in a closed container that can be carried, on a table in the other room.
struct Shut {
    scene: SceneGraph,
    me: NodeId,
    apple: NodeId,
    inside: Place,
}

fn shut_in(class: &str) -> Shut {
    let mut scene = SceneBuilder::new("flat");
    let [bedroom, kitchen] = ["bedroom", "kitchen"].map(|r| scene.add(Draft::new(r)).unwrap());
    scene.add_in(bedroom, Draft::new("desk")).unwrap();
    scene.add_in(bedroom, Draft::new("closet")).unwrap();
    scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let portable = scene.add_on(table, Draft::new(class)).unwrap();
    let apple = scene.add_in(portable, Draft::new("apple")).unwrap();
    let me = scene.add_in(bedroom, Draft::new("character")).unwrap();
    let scene = scene.build();
    let node = scene.node(portable).unwrap();
    assert!(node.affords(Property::Graspable) && node.is(State::Closed), "{class}");
    Shut { scene, me, apple, inside: Place { relation: Relation::Inside, at: portable } }
}

const PORTABLE: [&str; 4] = ["suitcase", "backpack", "food_container", "toolbox"];

#[test]
fn what_can_be_carried_becomes_a_place_when_it_is_seen() {
    for class in PORTABLE {
        for prior in [Prior::Uniform, Prior::Kept] {
            let Shut { scene, me, apple, inside } = shut_in(class);
            let mut belief = Belief::with_prior(&scene, me, 5, prior.clone());
            let mut world = Simulator::new(scene);
            let places = |belief: &Belief| belief.distribution(apple).len();
            let whole = |belief: &Belief| belief.distribution(apple).iter().map(|(_, c)| c).sum::<f64>();
            belief.observe(&world.graph().observe(me, Scope::Room));
            assert!(belief.probability(apple, inside) == 0.0 && (whole(&belief) - 1.0).abs() < 1e-9);
            let before = places(&belief);
            let kitchen = world.graph().of_class("kitchen")[0];
            world.step(me, &Action::one(Verb::Walk, kitchen)).unwrap();
            belief.observe(&world.graph().observe(me, Scope::Room));
            let chance = belief.probability(apple, inside);
            assert!(chance > 0.0 && (whole(&belief) - 1.0).abs() < 1e-9, "{class} {prior:?}: {chance}");
            // The table and the floor have been seen without the apple.
            assert_eq!(places(&belief), before - 2 + 1, "{class} {prior:?}: {belief}");
            // The opened container holds the apple.
            for verb in [Verb::Walk, Verb::Open] {
                world.step(me, &Action::one(verb, inside.at)).unwrap();
            }
            belief.observe(&world.graph().observe(me, Scope::Room));
            assert_eq!(belief.probability(apple, inside), 1.0);
        }
    }
}

#[test]
fn what_is_shut_in_something_portable_is_found() {
    for class in PORTABLE {
        for seed in 0..4 {
            for policy in [&mut PlannerPolicy::best() as &mut dyn Policy, &mut PlannerPolicy::faithful()] {
                let Shut { scene, .. } = shut_in(class);
                let task = Task::new("lunch", "On(apple, desk)".parse().unwrap());
                let mut world = Simulator::new(scene);
                let episode = EpisodeOptions::seeded(seed).episode(policy, &task, &mut world, &mut |_| {});
                assert_eq!(episode.outcome, Outcome::Won, "{class} {seed} {}: {episode:?}", policy.name());
            }
        }
    }
}

/// Two things of a class are equally likely at every place, and whichever is found first will do.
#[test]
fn instances_of_a_class_are_interchangeable() {
    let mut taken = Vec::new();
    for seed in 0..12 {
        let scene = home(seed);
        let me = scene.agents()[0];
        let belief = Belief::with_prior(&scene, me, seed, Prior::Kept);
        let mugs = scene.of_class("mug");
        assert_eq!(belief.distribution(mugs[0]), belief.distribution(mugs[1]), "{seed}");

        let task = Task::new("a mug", "Holds(mug)".parse().unwrap());
        let mut world = Simulator::new(scene.clone());
        let episode = EpisodeOptions::seeded(seed).episode(&mut PlannerPolicy::best(), &task, &mut world, &mut |_| {});
        assert_eq!(episode.outcome, Outcome::Won, "{seed}");
        let held = world.graph().held(me).find(|id| mugs.contains(id)).unwrap();
        taken.push(held == mugs[0]);
    }
    assert!(taken.contains(&true) && taken.contains(&false), "{taken:?}");
}

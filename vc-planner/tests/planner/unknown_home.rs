//! An agent that knows only the rooms learns their contents by entering them.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use crate::homes;

use homes::{GOALS, home};
use vc_graph::{Draft, Node, NodeId, Place, Property, Relation, SceneBuilder, Scope, Simulator};
use vc_planner::{Belief, EpisodeOptions, PlannerPolicy, Policy, Prior};
use vc_tasks::{Outcome, Task};

#[test]
fn places_are_added_when_they_are_seen() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let apple = scene.add_in(fridge, Draft::new("apple")).unwrap();
    let desk = scene.add_in(bedroom, Draft::new("desk")).unwrap();
    let book = scene.add_on(desk, Draft::new("book")).unwrap();
    let me = scene.add_in(bedroom, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    let mut belief = Belief::in_unknown_home(world.graph(), me, 0, Prior::Kept);
    let knows = |belief: &Belief, ids: &[NodeId]| -> Vec<bool> {
        ids.iter().map(|&id| belief.graph().node(id).is_some()).collect()
    };
    assert_eq!(
        knows(&belief, &[kitchen, bedroom, fridge, apple, desk, book, me]),
        [true, true, false, false, false, false, true]
    );
    let open = |belief: &Belief| belief.possible_places().collect::<Vec<Place>>();
    let room = |at| Place { relation: Relation::InRoom, at };
    assert_eq!(open(&belief), [room(kitchen), room(bedroom)]);

    belief.observe(&world.graph().observe(me, Scope::Room));
    assert_eq!(knows(&belief, &[fridge, apple, desk, book]), [false, false, true, true]);
    assert_eq!(belief.graph().place(book), Some(Place { relation: Relation::On, at: desk }));
    assert!(!open(&belief).contains(&room(bedroom)));

    for action in ["walk fridge", "open fridge"] {
        let action = action.replace("fridge", &world.graph().label(fridge).to_string()).parse().unwrap();
        world.step(me, &action).unwrap();
        belief.expect(&action);
        belief.observe(&world.graph().observe(me, Scope::Room));
        let inside = Place { relation: Relation::Inside, at: fridge };
        let is_open = world.graph().node(fridge).is_some_and(|n| !n.hides_contents());
        assert_eq!(open(&belief).contains(&inside), !is_open);
        assert_eq!(knows(&belief, &[fridge, apple]), [true, is_open]);
    }
    let same = |node: &Node| belief.graph().node(node.id()).is_some_and(|n| n.states() == node.states());
    assert!(world.graph().nodes().all(same));
}

/// In an unknown home an agent reaches every goal that it reaches in a known one, in more steps.
#[test]
fn goals_are_reached_without_knowing_the_furniture() {
    let (mut known, mut unknown) = (0, 0);
    for seed in 0..10 {
        let scene = home(seed);
        for goal in GOALS {
            let task = Task::new("unknown home", goal.parse().unwrap());
            let steps = |mut policy: PlannerPolicy| {
                let mut world = Simulator::new(scene.clone());
                let episode = EpisodeOptions::seeded(seed).episode(&mut policy, &task, &mut world, &mut |_| {});
                assert_eq!(episode.outcome, Outcome::Won, "{} {seed} {goal}: {episode:?}", policy.name());
                episode.steps
            };
            known += steps(PlannerPolicy::best());
            unknown += steps(PlannerPolicy::in_unknown_home());
        }
    }
    println!("{known} steps, {unknown} without knowing the furniture");
    assert!(unknown <= 2 * known, "{unknown} against {known}");
}

/// The agent gives up when it has looked everywhere, and not before.
#[test]
fn what_is_nowhere_is_given_up_when_all_has_been_seen() {
    let scene = home(3);
    let task = Task::new("nowhere", "Holds(unicorn)".parse().unwrap());
    let mut world = Simulator::new(scene.clone());
    let episode =
        EpisodeOptions::seeded(3).episode(&mut PlannerPolicy::in_unknown_home(), &task, &mut world, &mut |_| {});
    assert_eq!(episode.outcome, Outcome::Lost);
    assert!(episode.reason.unwrap().contains("unicorn"));
    let shut =
        |n: &&Node| n.hides_contents() && n.affords(Property::Container) && world.graph().hidden_in(n.id()).is_none();
    let left: Vec<String> = world.graph().nodes().filter(shut).map(|n| n.label().to_string()).collect();
    assert!(left.is_empty(), "{left:?}");
}

/// In a scene with neither rooms nor furniture an unseen thing cannot be anywhere.
#[test]
fn what_can_be_nowhere_is_given_up_at_once() {
    let mut scene = SceneBuilder::new("nothing");
    let me = scene.add(Draft::new("character")).unwrap();
    let apples = ["apple", "apple"].map(|class| scene.add(Draft::new(class)).unwrap());
    let scene = scene.build();
    for mut policy in [PlannerPolicy::best(), PlannerPolicy::in_unknown_home(), PlannerPolicy::faithful()] {
        for goal in ["Holds(apple)", "Near(me, apple)", "On(apple, apple)", "Sliced(apple), 2"] {
            let task = Task::new("nowhere", goal.parse().unwrap());
            let mut world = Simulator::new(scene.clone());
            let episode = EpisodeOptions::seeded(0).episode(&mut policy, &task, &mut world, &mut |_| {});
            assert_eq!((episode.outcome, episode.steps), (Outcome::Lost, 0), "{} {goal}", policy.name());
            assert!(episode.reason.unwrap().contains("apple"), "{} {goal}", policy.name());
        }
    }
    let belief = Belief::in_known_home(&scene, me, 0);
    assert_eq!(apples.map(|id| belief.distribution(id).len()), [0, 0]);
}

/// Things that the goal names by number are found like those that it names by class.
#[test]
fn numbered_things_in_rooms_not_seen_are_found() {
    let mut scene = SceneBuilder::new("flat");
    let [living, hall, kitchen] = ["living_room", "hallway", "kitchen"].map(|r| scene.add(Draft::new(r)).unwrap());
    let chair = scene.add_in(living, Draft::new("chair")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let pudding = scene.add_in(fridge, Draft::new("pudding")).unwrap();
    scene.add_in(hall, Draft::new("plant")).unwrap();
    scene.add_in(living, Draft::new("character")).unwrap();
    let scene = scene.build();
    let (chair, table, fridge, pudding) = (chair.0, table.0, fridge.0, pudding.0);
    let pairs = [
        (
            format!("On(pudding, #{table}) & SittingOn(me, #{chair})"),
            "On(pudding, kitchen_table) & SittingOn(me, chair)",
        ),
        (
            format!("SittingOn(me, #{chair}) & On(#{pudding}, #{table})"),
            "SittingOn(me, chair) & On(pudding, kitchen_table)",
        ),
        (format!("Holds(#{pudding}) & Closed(#{fridge})"), "Holds(pudding) & Closed(fridge)"),
        (format!("Open(#{fridge})"), "Open(fridge)"),
        (format!("Near(me, #{table}) & !Sitting(me)"), "Near(me, kitchen_table) & !Sitting(me)"),
        (format!("did eat(#{pudding}) & SittingOn(me, #{chair})"), "did eat(pudding) & SittingOn(me, chair)"),
        (
            format!("HoldsLeft(me, #{pudding}) | On(#{pudding}, #{table})"),
            "HoldsLeft(me, pudding) | On(pudding, kitchen_table)",
        ),
    ];
    for (numbered, named) in &pairs {
        let steps = |goal: &str| {
            let task = Task::new("numbers", goal.parse().unwrap());
            let mut world = Simulator::new(scene.clone());
            let episode = EpisodeOptions::seeded(1).episode(
                &mut PlannerPolicy::in_unknown_home(),
                &task,
                &mut world,
                &mut |_| {},
            );
            assert_eq!(episode.outcome, Outcome::Won, "{goal}: {episode:?}");
            episode.steps
        };
        let (by_number, by_name) = (steps(numbered), steps(named));
        assert!(by_number <= by_name + 2, "{numbered}: {by_number} steps, by name {by_name}");
    }
    // A goal about a thing that the scene lacks is lost once everything has been seen.
    let task = Task::new("numbers", "On(pudding, #999) & SittingOn(me, chair)".parse().unwrap());
    let mut world = Simulator::new(scene.clone());
    let episode =
        EpisodeOptions::seeded(1).episode(&mut PlannerPolicy::in_unknown_home(), &task, &mut world, &mut |_| {});
    assert!(episode.outcome == Outcome::Lost && episode.steps < 20, "{episode:?}");
}

/// A scene with one character and one apple, and no place where the apple could be.
#[test]
fn a_scene_without_any_place_is_lost_with_a_reason() {
    let text = r#"{"nodes": [{"id": 1, "class_name": "character", "category": "Characters"},
        {"id": 2, "class_name": "apple", "category": "Food"}], "edges": []}"#;
    let scene = vc_graph::format::virtualhome::read(text, &vc_graph::ClassTable::builtin()).unwrap();
    for mut policy in [PlannerPolicy::best(), PlannerPolicy::in_unknown_home(), PlannerPolicy::faithful()] {
        let task = Task::new("nowhere", "Holds(apple)".parse().unwrap());
        let episode =
            EpisodeOptions::seeded(0).episode(&mut policy, &task, &mut Simulator::new(scene.clone()), &mut |_| {});
        assert_eq!((episode.outcome, episode.steps), (Outcome::Lost, 0), "{}", policy.name());
        assert!(episode.reason.unwrap().contains("apple"), "{}", policy.name());
    }
}

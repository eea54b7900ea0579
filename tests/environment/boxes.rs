//! Homes of which only bounding boxes are known.

use std::sync::OnceLock;

use virtualcity::Environment;
use virtualcity::graph::format::{read_scene, thesis};
use virtualcity::graph::{
    Action, Bounds, ClassTable, Draft, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneBuilder,
    SceneGraph, Seed, Verb,
};
use virtualcity::physics::BodyRole;
use virtualcity::planner::{EpisodeOptions, PlannerPolicy};
use virtualcity::procgen::Apartment;
use virtualcity::tasks::{Outcome, Task};

use super::act;
use super::alter::is_as_read;

/// The thesis's JSON has no shapes: a home written in it comes back with the same boxes at the same positions,
/// and stands.
#[test]
fn a_home_comes_back_from_the_thesis_form() {
    for seed in [42, 3] {
        let made = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let read = thesis::read(&thesis::write(&made), made.classes()).unwrap();
        for (old, new) in made.nodes().zip(read.nodes()) {
            assert_eq!((old.id(), old.class(), old.states()), (new.id(), new.class(), new.states()));
            let (Some(was), Some(is)) = (old.aabb(), new.aabb()) else { continue };
            let off = (was.min - is.min).norm().max((was.max - is.max).norm());
            assert!(off < 2e-3, "{}: {was:?} {is:?}", old.label());
        }
        let home = Environment::from_scene(read, 1).unwrap();
        assert_eq!(home.left_out(), []);
        let stays = |n: &&Node| {
            let now = home.graph().node(n.id()).and_then(|n| n.position());
            n.position().zip(now).is_none_or(|(was, is)| (was - is).norm() < 0.25)
        };
        let strayed: Vec<_> =
            made.nodes().filter(|n| n.kind() == NodeKind::Object && !stays(n)).map(Node::label).collect();
        assert!(strayed.is_empty(), "{strayed:?}");
        let at = |graph: &SceneGraph, id| graph.place(id).filter(|p| p.relation == Relation::Inside);
        let carried = || made.nodes().filter(|n| n.affords(Property::Graspable) && at(&made, n.id()).is_some());
        let same = carried().filter(|n| at(&made, n.id()) == at(home.graph(), n.id())).count();
        assert_eq!(same, carried().count());
        assert!(!home.opened_passages().is_empty(), "living rooms have passages without doors");
        for &room in home.graph().rooms() {
            home.clone().set_action(home.agents()[0], Action::one(Verb::Walk, room)).unwrap();
        }
    }
}

/// A scene of which only bounding boxes are known.
fn boxes(text: &str) -> Environment {
    Environment::from_scene(read_scene(text, &ClassTable::builtin()).unwrap(), 1).unwrap()
}

pub(super) fn one(home: &Environment, class: &str) -> NodeId {
    home.graph().of_class(class)[0]
}

/// Tables of boxes support objects, fridges of boxes contain them.
#[test]
fn things_are_put_on_and_into_boxes() {
    let mut home = boxes(include_str!("../data/boxes_table.json"));
    let [me, table, apple, fridge, milk] =
        [home.agents()[0], one(&home, "kitchen_table"), one(&home, "apple"), one(&home, "fridge"), one(&home, "milk")];
    assert!(home.elsewhere().is_empty(), "{:?}", home.elsewhere());
    assert_eq!(home.graph().hidden_in(milk), Some(fridge));
    assert!(home.graph().places(milk).eq([Place { relation: Relation::Inside, at: fridge }]));
    act(&mut home, me, Verb::Walk, &[apple]);
    act(&mut home, me, Verb::Grab, &[apple]);
    act(&mut home, me, Verb::Place, &[apple, table]);
    assert!(home.world().supports(apple).contains(&table));
    act(&mut home, me, Verb::Grab, &[apple]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    act(&mut home, me, Verb::Open, &[fridge]);
    act(&mut home, me, Verb::PutIn, &[apple, fridge]);
    act(&mut home, me, Verb::Close, &[fridge]);
    assert_eq!(home.graph().hidden_in(apple), Some(fridge));
}

/// A mug in a closed box is inside the box only, and moves along when the box is carried.
#[test]
fn contents_of_boxes_go_along() {
    let mut home = boxes(include_str!("../data/boxes_mug.json"));
    let [me, carton, mug, fridge] =
        [home.agents()[0], one(&home, "cardboard_box"), one(&home, "mug"), one(&home, "fridge")];
    assert!(home.graph().places(mug).eq([Place { relation: Relation::Inside, at: carton }]));
    let within = |home: &Environment| {
        let at = |id| home.world().pose(id).unwrap().translation.vector;
        (at(mug) - at(carton)).norm()
    };
    let was = within(&home);
    act(&mut home, me, Verb::Walk, &[carton]);
    act(&mut home, me, Verb::Grab, &[carton]);
    act(&mut home, me, Verb::Walk, &[fridge]);
    assert!((within(&home) - was).abs() < 1e-3);
    assert_eq!(home.graph().hidden_in(mug), Some(carton));
    act(&mut home, me, Verb::Drop, &[carton]);
    assert!((within(&home) - was).abs() < 0.02);
    assert!(home.graph().places(mug).eq([Place { relation: Relation::Inside, at: carton }]));
    let start = home.start().clone();
    let report = home.reset(&start).unwrap();
    assert!(report.elsewhere.is_empty(), "{:?}", report.elsewhere);
    assert_eq!(home.graph().digest(), start.digest());
}

/// An object that is kept in place because it intersects the walls of its box can be placed elsewhere
/// nevertheless; it moves along when its box is placed elsewhere.
#[test]
fn what_is_held_in_boxes_is_put_elsewhere() {
    let mut home = boxes(include_str!("../data/boxes_mug.json"));
    let [me, carton, mug, table, kitchen] = [
        home.agents()[0],
        one(&home, "cardboard_box"),
        one(&home, "mug"),
        one(&home, "kitchen_table"),
        one(&home, "kitchen"),
    ];
    assert_eq!(home.world().role(mug), Some(BodyRole::Hung));
    home.put(carton, Place { relation: Relation::On, at: kitchen }).unwrap();
    assert!(home.graph().places(mug).eq([Place { relation: Relation::Inside, at: carton }]));
    act(&mut home, me, Verb::Walk, &[carton]);
    act(&mut home, me, Verb::Grab, &[carton]);
    assert_eq!(home.graph().hidden_in(mug), Some(carton));
    act(&mut home, me, Verb::Drop, &[carton]);
    home.put(mug, Place { relation: Relation::On, at: table }).unwrap();
    assert_eq!(home.world().role(mug), Some(BodyRole::Loose));
    assert!(home.world().supports(mug).contains(&table));
    is_as_read(&home);
}

/// A thing that lies on two others stays on one if the other is taken, and is where it was.
#[test]
fn who_lies_on_two_stays_on_one() {
    let mut scene = SceneBuilder::new("studio");
    let size = |x: f32, y: f32, z: f32| Bounds::standing([x, y, z].into());
    let at = Pose::translation;
    let room = scene.add(Draft::new("kitchen").bounds(size(5.0, 5.0, 2.5)).at(Pose::identity())).unwrap();
    scene.add_in(room, Draft::new("floor").bounds(size(5.0, 5.0, 0.1)).at(at(0.0, 0.0, -0.1))).unwrap();
    let table = scene.add_in(room, Draft::new("table").bounds(size(0.8, 0.8, 0.7)).at(at(1.0, 0.0, 0.0))).unwrap();
    let mut book = |on: NodeId, y: f32, z: f32| {
        scene.add_on(on, Draft::new("book").bounds(size(0.2, 0.15, 0.05)).at(at(1.0, y, z))).unwrap()
    };
    let [left, right] = [book(table, 0.08, 0.7), book(table, -0.08, 0.7)];
    let above = book(left, 0.04, 0.75);
    let mut home = Environment::from_scene(scene.build(), 1).unwrap();
    let on = |home: &Environment| home.graph().places(above).map(|place| place.at).collect::<Vec<NodeId>>();
    assert!(on(&home).contains(&left) && on(&home).contains(&right), "{:?}", on(&home));
    let (me, before) = (home.agents()[0], home.world().pose(above).unwrap());
    act(&mut home, me, Verb::Walk, &[right]);
    act(&mut home, me, Verb::Grab, &[right]);
    assert_eq!(on(&home), [left]);
    let (seen, is) = (home.graph().node(above).and_then(Node::position).unwrap(), home.world().pose(above).unwrap());
    assert!((is.translation.vector - before.translation.vector).norm() < 0.02);
    assert_eq!(seen.coords, is.translation.vector);
    is_as_read(&home);
}

/// A home made from a file of VirtualHome, if the shared data exists.
fn scene(number: u32) -> Option<Environment> {
    static MADE: [OnceLock<Option<Environment>>; 7] = [const { OnceLock::new() }; 7];
    let make = || {
        let file = vc_testkit::data::folder()?.join(format!("virtualhome/scene{number}.json.gz"));
        Some(Environment::make(&format!("scene:{}", file.display()), 1).unwrap())
    };
    MADE[number as usize].get_or_init(make).clone()
}

/// VirtualHome's scenes: nothing is moved, agents walk to every room, and doors connect the rooms as in the
/// scenes.
#[test]
fn scenes_of_boxes_are_lived_in() {
    for number in vc_testkit::data::SCENES {
        let Some(home) = scene(number) else { return };
        let scene = vc_testkit::data::scene(number).unwrap();
        assert_eq!(home.left_out(), []);
        let off = |n: &&Node| {
            let now = home.graph().node(n.id()).and_then(Node::position);
            n.kind() == NodeKind::Object && n.position().zip(now).is_none_or(|(was, is)| (was - is).norm() > 0.05)
        };
        let moved: Vec<_> = scene.nodes().filter(off).map(Node::label).collect();
        assert!(moved.is_empty(), "{number}: {moved:?}");
        let me = home.agents()[0];
        for &room in home.graph().rooms() {
            act(&mut home.clone(), me, Verb::Walk, &[room]);
        }
        let doors = scene.edges().filter(|e| e.relation == Relation::Between);
        doors.for_each(|edge| assert!(home.graph().has(edge), "{number}: {edge}"));
    }
}

/// The planner, which does not know the home, performs everyday tasks in a scene of boxes.
#[test]
fn the_planner_lives_in_boxes() {
    let Some(home) = scene(1) else { return };
    let goals = Task::read_list(include_str!("../../examples/data/box_goals.txt")).unwrap();
    assert_eq!(goals.len(), 40);
    let wins = |home: &Environment, title: &str| {
        let task = goals.iter().find(|t| t.title == title).unwrap();
        let episode =
            EpisodeOptions::seeded(1).episode(&mut PlannerPolicy::best(), task, &mut home.clone(), &mut |_| {});
        assert_eq!(episode.outcome, Outcome::Won, "{title}: {:?}", episode.reason);
    };
    ["bread in the fridge", "a book on the bed", "listen to the radio"].iter().for_each(|title| wins(&home, title));
    // A slice is wider than a turntable; only the foot of a bed in a corner is free.
    let hard = [(5, "warm a slice of bread"), (5, "lie down"), (3, "fry something")];
    for (number, title) in hard {
        wins(&scene(number).unwrap(), title);
    }
}

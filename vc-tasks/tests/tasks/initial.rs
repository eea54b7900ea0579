//! Initial environments in scenes of boxes: properties of all of them, and every error.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use nalgebra::{Isometry3, Vector3};
use vc_graph::goal::Situation;
use vc_graph::{
    Action, Bounds, ChangeSet, Draft, Edge, History, NodeId, NodeKind, Place, Relation, SceneBuilder, SceneGraph, Seed,
    Simulator,
};
use vc_tasks::initial::{Initial, InitialError, InitialGenerator, PlacementReason, PlainStock, Purpose};
use vc_tasks::library::{Activity, Benchmark, List, thesis_tasks};
use vc_tasks::{World, WorldError};

/// An activity from its goal, its needs, and further JSON fields.
fn activity(goal: &str, needs: &[&str], more: &str) -> Activity {
    let needs: Vec<String> = needs.iter().map(|n| format!("\"{n}\"")).collect();
    let text =
        format!(r#"[{{"number": 1, "title": "own", "goal": "{goal}", "needs": [{}] {more}}}]"#, needs.join(", "));
    Activity::read_list("own", &text).unwrap().remove(0)
}

/// A kitchen of five by four metres with a table, a shelf of the given height and a fridge, and an
/// adjacent bedroom.
fn flat(shelf: f32) -> SceneGraph {
    let mut scene = SceneBuilder::new("flat");
    let at = |x: f32, y: f32| Isometry3::translation(x, y, 0.0);
    let room =
        |class: &str, x: f32| Draft::new(class).at(at(x, 0.0)).bounds(Bounds::standing(Vector3::new(5.0, 4.0, 2.5)));
    let boxed = |class: &str, x: f32, y: f32, size: [f32; 3]| {
        Draft::new(class).at(at(x, y)).bounds(Bounds::standing(size.into()))
    };
    let kitchen = scene.add(room("kitchen", 0.0)).unwrap();
    let bedroom = scene.add(room("bedroom", 5.0)).unwrap();
    scene.add_in(kitchen, boxed("dining_table", 0.0, 0.0, [0.9, 1.4, 0.75])).unwrap();
    scene.add_in(kitchen, boxed("fridge", -2.1, 1.5, [0.6, 0.6, 1.8])).unwrap();
    scene.add_in(kitchen, boxed("bookshelf", -2.2, -1.0, [0.35, 0.8, shelf])).unwrap();
    scene.add_in(bedroom, boxed("double_bed", 6.0, 0.5, [2.0, 1.6, 0.5])).unwrap();
    scene.build()
}

fn make(activity: &Activity, scene: &SceneGraph, seed: u64) -> Result<Initial, InitialError> {
    let mut world = Simulator::new(scene.clone());
    InitialGenerator::new(&PlainStock).distractors(3).make(activity, scene, Seed(seed), &mut world)
}

fn table_and_fridge() -> Activity {
    activity(
        "Inside(milk, fridge) & On(plate, dining_table), 2 & !On(mug, dining_table)",
        &["milk on dining_table | on double_bed", "2 plate [dirty] on double_bed", "mug on bookshelf | on double_bed"],
        r#", "start": "Closed(fridge) & !Open(bookshelf)", "places": ["kitchen", "bedroom"]"#,
    )
}

#[test]
fn environments_are_as_they_were_asked_for() {
    for seed in 0..64 {
        let (task, scene) = (table_and_fridge(), flat(Seed(seed).stream().between(0.8, 1.4)));
        let made = make(&task, &scene, seed).unwrap();
        assert_eq!(&made, &make(&task, &scene, seed).unwrap(), "the same seed gives the same scene");

        let history = History::default();
        let now = Situation::new(&made.scene, made.agent, &history);
        assert!(!task.goal.holds(&now) && made.credit < 1.0);
        assert!(task.start.holds(&now));
        assert!(made.scene.validate().is_empty());
        let dirty = made
            .scene
            .of_class("plate")
            .into_iter()
            .filter(|&p| made.scene.node(p).unwrap().is(vc_graph::State::Dirty));
        assert!(dirty.count() >= 2);

        for node in scene.nodes() {
            let after = made.scene.node(node.id()).unwrap();
            assert_eq!(after.pose(), node.pose());
            assert_eq!(after.spec(), node.spec());
        }
        assert!(scene.edges().all(|edge| made.scene.has(edge)), "nothing was moved");
        assert_eq!(made.scene.len(), scene.len() + made.added.len());
        assert_eq!(made.added.iter().filter(|a| a.purpose == Purpose::Need).count(), 4);
        assert_eq!(overlapping(&made.scene, &made), None);
    }
}

/// An added object and another whose boxes overlap although neither holds the other.
fn overlapping(scene: &SceneGraph, made: &Initial) -> Option<(NodeId, NodeId)> {
    let things: Vec<NodeId> = scene.nodes().filter(|n| n.kind() != NodeKind::Room).map(vc_graph::Node::id).collect();
    let boxed = |id: NodeId| scene.node(id).unwrap().aabb().unwrap();
    let meet = |a: NodeId, b: NodeId| {
        let (a, b) = (boxed(a), boxed(b));
        (0..3).all(|i| a.min[i] + 0.003 < b.max[i] && b.min[i] + 0.003 < a.max[i])
    };
    // Bodies are rounder than their boxes.
    let added = made.added.iter().filter(|a| a.purpose != Purpose::Agent);
    let pairs = added.flat_map(|a| things.iter().map(move |&b| (a.id, b)));
    pairs.into_iter().find(|&(a, b)| {
        let holds = scene.support_chain(a).contains(&b) || scene.support_chain(b).contains(&a);
        a != b && !holds && meet(a, b)
    })
}

#[test]
fn chance_decides_where_things_are() {
    let (task, scene) = (table_and_fridge(), flat(1.0));
    let places = |seed| {
        let made = make(&task, &scene, seed).unwrap();
        made.added.iter().map(|a| (a.place, made.scene.node(a.id).unwrap().pose().copied())).collect::<Vec<_>>()
    };
    assert!((1..9).all(|seed| places(seed) != places(0)));
}

#[test]
fn scenes_without_poses_work_as_well() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    for class in ["fridge", "dining_table", "dishwasher", "stove", "kitchen_cabinet"] {
        scene.add_in(kitchen, Draft::new(class)).unwrap();
    }
    let scene = scene.build();
    for id in ["put_fridge-01", "setup_table-01", "put_dishwasher-03", "prepare_food-04"] {
        let benchmark = Benchmark::v1();
        let task = benchmark.get(id).unwrap();
        let made = make(task, &scene, 1).unwrap_or_else(|e| panic!("{id}: {e}"));
        assert_eq!(made.credit, 0.0, "{id}");
    }
}

#[test]
fn what_is_there_is_not_added() {
    let mut scene = SceneBuilder::from_graph(flat(1.0));
    let table = scene.graph().of_class("dining_table")[0];
    let pose = Isometry3::translation(0.0, 0.0, 0.76);
    let milk = Draft::new("milk").at(pose).bounds(Bounds::standing(Vector3::new(0.1, 0.1, 0.2)));
    let milk = scene.add_on(table, milk).unwrap();
    let scene = scene.build();
    let made = make(&activity("Inside(milk, fridge)", &["milk on dining_table"], ""), &scene, 1).unwrap();
    assert_eq!(made.scene.of_class("milk"), [milk]);
    let elsewhere = make(&activity("Inside(milk, fridge)", &["milk on double_bed"], ""), &scene, 1).unwrap();
    assert_eq!(elsewhere.scene.of_class("milk").len(), 2);
}

#[test]
fn an_agent_that_is_to_sit_sits() {
    let task = thesis_tasks(List::Outdoor).into_iter().find(|t| t.id == "outdoor-6").unwrap();
    let mut scene = SceneBuilder::from_graph(flat(1.0));
    let kitchen = scene.graph().rooms()[0];
    let chair =
        Draft::new("chair").at(Isometry3::translation(1.5, 1.0, 0.0)).bounds(Bounds::standing(Vector3::repeat(0.5)));
    let chair = scene.add_in(kitchen, chair).unwrap();
    let made = make(&task, &scene.build(), 5).unwrap();
    assert!(made.scene.has(Edge::new(made.agent, Relation::SittingOn, chair)));
    let place = Place { relation: Relation::SittingOn, at: chair };
    assert_eq!(made.added.iter().find(|a| a.purpose == Purpose::Agent).unwrap().place, Some(place));
}

/// The error message when there is no environment.
fn complaint(activity: &Activity, scene: &SceneGraph) -> String {
    make(activity, scene, 1).unwrap_err().to_string()
}

#[test]
fn errors_name_the_thing_the_place_and_why() {
    let scene = flat(1.0);
    let says = |goal: &str, needs: &[&str], more: &str| complaint(&activity(goal, needs, more), &scene);
    assert_eq!(says("Holds(apple)", &[], r#", "places": ["beach"]"#), "the scene has no beach");
    assert_eq!(says("Holds(unobtainium)", &[], ""), "the scene has no unobtainium, and the stock has none either");
    assert_eq!(
        says("Open(window)", &[], ""),
        "the scene has no window that can be reached, and one does not add what is built in"
    );
    assert_eq!(says("Holds(apple)", &["apple on desk"], ""), "no place for apple: on desk: there is no such place");
    assert_eq!(
        says("On(apple, dining_table)", &["apple on dining_table"], ""),
        "no place for apple: on dining_table.3: the goal would be met"
    );
    assert_eq!(
        says("Holds(apple)", &["mattress on dining_table"], ""),
        "no place for mattress: on dining_table.3: it is too small"
    );
    assert_eq!(
        says("Holds(apple)", &["apple on wardrobe"], r#", "start": "Holds(pear)""#),
        "no place for apple: on wardrobe: there is no such place"
    );
    assert_eq!(says("Closed(fridge)", &[], ""), "the goal holds already: `Closed(fridge)`");
    let nowhere = says("Holds(apple)", &[], r#", "start": "Near(double_bed) & Near(fridge)""#);
    assert!(
        nowhere.starts_with("`Near(me, ") && nowhere.ends_with("` is to hold at the start and does not"),
        "{nowhere}"
    );
}

#[test]
fn there_must_be_height_and_room() {
    // A shelf compartment four centimetres high cannot hold milk.
    let low = make(&activity("Holds(milk)", &["milk in bookshelf"], ""), &flat(0.04), 1).unwrap_err();
    let InitialError::NoSpot { thing, why, .. } = &low else { panic!("{low}") };
    assert_eq!((thing.as_str(), *why), ("milk", PlacementReason::TooLow));
    // A table has no space for a hundred plates side by side.
    let full = make(&activity("Holds(plate)", &["100 plate on dining_table"], ""), &flat(1.0), 1).unwrap_err();
    let InitialError::NoSpot { why, .. } = &full else { panic!("{full}") };
    assert_eq!(*why, PlacementReason::Taken);
}

/// Furniture that opens does not block the way when it is open: in front of it is a metre of free
/// floor, in a kitchen and in a passage along a counter, which it would otherwise face.
#[test]
fn what_opens_has_room_before_it() {
    let needs = ["dishwasher of kitchen", "plate on dining_table | on kitchen_counter"];
    let task = activity("Inside(plate, dishwasher)", &needs, "");
    let mut passage = SceneBuilder::new("passage");
    let boxed = |class: &str, y: f32, size: [f32; 3]| {
        Draft::new(class).at(Isometry3::translation(0.0, y, 0.0)).bounds(Bounds::standing(size.into()))
    };
    let kitchen = passage.add(boxed("kitchen", 0.0, [4.0, 1.9, 2.5])).unwrap();
    passage.add_in(kitchen, boxed("kitchen_counter", 0.65, [4.0, 0.6, 0.9])).unwrap();
    let scenes = [passage.build(), flat(1.0)];
    for seed in 0..64 {
        let made = make(&task, &scenes[seed as usize % 2], seed).unwrap();
        let machine = made.scene.node(made.scene.of_class("dishwasher")[0]).unwrap();
        let own = machine.spec().bounds.unwrap();
        let offset = own.offset + Vector3::new(own.half.x + 0.5, 0.0, 0.0);
        let before = Bounds { offset, half: Vector3::new(0.5, own.half.y, own.half.z), ..own };
        let free = before.aabb(machine.pose().unwrap());
        let meets =
            |b: &vc_graph::Aabb| (0..3).all(|i| b.min[i] + 0.005 < free.max[i] && free.min[i] + 0.005 < b.max[i]);
        let stands = |n: &&vc_graph::Node| n.kind() == NodeKind::Object && n.id() != machine.id();
        let met = made.scene.nodes().filter(stands).find(|n| n.aabb().as_ref().is_some_and(meets));
        assert_eq!(met.map(|n| n.label()), None, "seed {seed}");
    }
}

/// A world in which objects roll off the table at the first resets.
struct Sloping {
    inner: Simulator,
    resets: usize,
    until: usize,
}

impl World for Sloping {
    fn graph(&self) -> &SceneGraph {
        self.inner.graph()
    }

    fn history(&self) -> &History {
        self.inner.history()
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        World::step(&mut self.inner, agent, action)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        self.resets += 1;
        let mut graph = graph.clone();
        if self.resets <= self.until {
            let table = graph.of_class("dining_table")[0];
            let on_it: Vec<NodeId> = graph.relating(Relation::On, table).collect();
            let mut edit = graph.edit();
            on_it.into_iter().for_each(|id| edit.detach(id).unwrap());
            edit.commit();
        }
        World::reset(&mut self.inner, &graph)
    }
}

#[test]
fn what_the_world_makes_of_it_is_compared_and_tried_again() {
    let scene = flat(1.0);
    let task = activity("Holds(apple)", &["apple on dining_table"], "");
    let world = |until| Sloping { inner: Simulator::new(scene.clone()), resets: 0, until };
    let generator = InitialGenerator::new(&PlainStock).tries(4);

    let mut third = world(2);
    let made = generator.make(&task, &scene, Seed(1), &mut third).unwrap();
    assert_eq!((made.tries, third.resets), (3, 3));
    assert_eq!(third.graph(), &made.scene);

    let error = generator.make(&task, &scene, Seed(1), &mut world(9)).unwrap_err();
    assert_eq!(error.to_string(), "after 4 tries: apple.8 is not on dining_table.3");
}

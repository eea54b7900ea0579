//! Doors and drawers: opened, shut, locked, among neighbours.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod common;

use common::{Scene, at, block, plain};
use nalgebra::{Point3, Vector3};
use vc_graph::State;
use vc_physics::{PhysicsError, Shapes, World};

#[test]
fn doors_and_drawers_follow_the_graph_and_back() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let door = scene.door_asset();
    let (shut, ajar) = (scene.add("door", door, at(0.0, 0.0, 0.0)), scene.add("door", door, at(2.0, 0.0, 0.0)));
    let mut graph = scene.graph();
    common::open(&mut graph, ajar);
    let mut world = World::build(&graph, &Shapes::new(), plain()).unwrap();
    assert_eq!((world.openness(shut), world.openness(ajar)), (Some(0.0), Some(1.0)));
    assert_eq!(world.open_state(shut), Some(State::Closed));
    assert_eq!(world.open_state(ajar), Some(State::Open));
    world.drive(shut, 0, 1.0).unwrap();
    world.drive(ajar, 0, 0.0).unwrap();
    world.run(30);
    let part_way = world.openness(shut).unwrap();
    assert!(part_way > 0.1 && part_way < 0.999, "it swings: {part_way}");
    assert!(world.settle(400).at_rest);
    assert_eq!((world.open_state(shut), world.open_state(ajar)), (Some(State::Open), Some(State::Closed)));
    assert!(world.openness(ajar).unwrap() < 0.006);
    // Shut and latched, it does not give way; locked, it cannot be opened.
    world.push(ajar, Vector3::x(), Point3::origin()).unwrap_err();
    world.lock(ajar, 0, true).unwrap();
    assert_eq!(world.drive(ajar, 0, 1.0), Err(PhysicsError::Locked(ajar)));
    world.lock(ajar, 0, false).unwrap();
    world.put_open(ajar, 0, 0.5).unwrap();
    assert!((world.openness(ajar).unwrap() - 0.5).abs() < 1e-3);
    assert_eq!(world.drive(ajar, 7, 1.0), Err(PhysicsError::NoSuchPart { id: ajar, part: 7, count: 1 }));
}

/// A door stops at a person, and goes on when the person has left.
#[test]
fn a_door_does_not_go_through_a_person() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let door = scene.door_asset();
    let door = scene.add("door", door, at(0.0, 0.0, 0.0));
    let me = scene.agent(at(0.45, 0.0, 0.0));
    let mut world = scene.world();
    world.drive(door, 0, 1.0).unwrap();
    world.run(300);
    let open = world.openness(door).unwrap();
    assert!(open > 0.02 && open < 0.8, "{open}");
    world.teleport(me, at(3.0, 3.0, 0.0)).unwrap();
    world.drive(door, 0, 1.0).unwrap();
    world.settle(400);
    assert!(world.openness(door).unwrap() > 0.99);
}

/// What lies in a drawer comes along, pulled or put.
#[test]
fn a_drawer_takes_its_content_along() {
    for at_once in [false, true] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let chest = scene.chest_asset();
        let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
        let spoon = scene.cube(0.03, at(0.0, 0.05, 0.245));
        let mut world = scene.world();
        world.settle(200);
        let before = world.pose(spoon).unwrap().translation;
        if at_once {
            world.put_open(chest, 0, 1.0).unwrap();
        } else {
            world.drive(chest, 0, 1.0).unwrap();
        }
        assert!(world.settle(400).at_rest);
        let moved = world.pose(spoon).unwrap().translation.vector - before.vector;
        assert!((moved.x - 0.3).abs() < 0.03 && moved.z.abs() < 0.005, "{at_once}: {moved:?}");
        let shelf = &world.shelves(chest)[1];
        assert!((shelf.pose.translation.x - 0.31).abs() < 0.003, "{shelf:?}");
    }
}

/// A drawer between two cupboards that leave it no gap opens all the same, and they
/// stay where they are.
#[test]
fn a_drawer_does_not_rub_against_its_neighbours() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = scene.chest_asset();
    let chests = [-0.6, 0.0, 0.6].map(|y| scene.add("kitchen_cabinet", chest, at(0.0, y, 0.0)));
    let snug = scene.solid("snug", block([0.3, 0.02, 0.2]), scene.wood);
    let snug = scene.add("wall", snug, at(0.1, 0.265, 0.3));
    let mut world = scene.world();
    world.drive(chests[1], 0, 1.0).unwrap();
    assert!(world.settle(400).at_rest);
    assert!(world.openness(chests[1]).unwrap() > 0.99);
    assert_eq!([world.openness(chests[0]), world.openness(chests[2])], [Some(0.0), Some(0.0)]);
    assert_eq!(world.pose(snug), Some(at(0.1, 0.265, 0.3)));
}

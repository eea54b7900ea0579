//! Doors and drawers: opened, closed, locked, next to neighbours.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind};
use vc_graph::{Asset, NodeId, Pose, State};
use vc_physics::{PhysicsError, PhysicsWorld, Settings, ShapeCache};

#[test]
fn doors_and_drawers_follow_the_graph_and_back() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let door = scene.door_asset();
    let (shut, ajar) = (scene.add("door", door, at(0.0, 0.0, 0.0)), scene.add("door", door, at(2.0, 0.0, 0.0)));
    let mut graph = scene.graph();
    common::open(&mut graph, ajar);
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap();
    assert_eq!((world.parts(shut).openness(), world.parts(ajar).openness()), (Some(0.0), Some(1.0)));
    assert_eq!(world.parts(shut).state(), Some(State::Closed));
    assert_eq!(world.parts(ajar).state(), Some(State::Open));
    world.drive(shut, 0, 1.0).unwrap();
    world.drive(ajar, 0, 0.0).unwrap();
    world.run(30);
    let part_way = world.parts(shut).openness().unwrap();
    assert!(part_way > 0.1 && part_way < 0.999, "it swings: {part_way}");
    assert!(world.settle(400).at_rest);
    assert_eq!((world.parts(shut).state(), world.parts(ajar).state()), (Some(State::Open), Some(State::Closed)));
    assert!(world.parts(ajar).openness().unwrap() < 0.006);
    // A closed, latched door does not give way; a locked one cannot be opened.
    world.push(ajar, Vector3::x(), Point3::origin()).unwrap_err();
    world.lock(ajar, 0, true).unwrap();
    assert_eq!(world.drive(ajar, 0, 1.0), Err(PhysicsError::Locked(ajar)));
    world.lock(ajar, 0, false).unwrap();
    world.put_open(ajar, Some(0), 0.5).unwrap();
    assert!((world.parts(ajar).openness().unwrap() - 0.5).abs() < 1e-3);
    assert_eq!(world.drive(ajar, 7, 1.0), Err(PhysicsError::NoSuchPart { id: ajar, part: 7, count: 1 }));
}

/// A door stops at a person, and continues when the person has left.
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
    let open = world.parts(door).openness().unwrap();
    assert!(open > 0.02 && open < 0.8, "{open}");
    world.teleport(me, at(3.0, 3.0, 0.0)).unwrap();
    world.drive(door, 0, 1.0).unwrap();
    world.settle(400);
    assert!(world.parts(door).openness().unwrap() > 0.99);
}

/// The contents of a drawer come along, whether it is driven or set.
#[test]
fn a_drawer_takes_its_content_along() {
    for (at_once, pinned) in [(false, false), (true, false), (false, true), (true, true)] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let chest = scene.chest_asset();
        let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
        let spoon = scene.cube(0.03, at(0.0, 0.05, 0.245));
        let mut world = scene.world();
        world.settle(200);
        if pinned {
            world.pin(spoon, None).unwrap();
        }
        let before = world.pose(spoon).unwrap().translation;
        if at_once {
            world.put_open(chest, Some(0), 1.0).unwrap();
        } else {
            world.drive(chest, 0, 1.0).unwrap();
        }
        assert!(world.settle(400).at_rest);
        let moved = world.pose(spoon).unwrap().translation.vector - before.vector;
        assert!((moved.x - 0.3).abs() < 0.03 && moved.z.abs() < 0.005, "{at_once} {pinned}: {moved:?}");
        let shelf = &world.body(chest).unwrap().support_surfaces()[1];
        assert!((shelf.pose.translation.x - 0.31).abs() < 0.003, "{shelf:?}");
    }
}

/// A thing that has just been put into an open drawer goes along when it shuts: pinned at once, before anything has touched
/// it; while it falls the last millimetres, against another thing; and jammed between the drawer's sides.
#[test]
fn what_has_just_been_put_into_a_drawer_goes_along() {
    for how in ["pinned", "falls", "jams"] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let chest = scene.chest_asset();
        let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
        let beside = scene.cube(0.03, at(0.0, 0.05, 0.245));
        let rod = scene.solid("rod", block([0.01, 0.2402, 0.01]), scene.wood);
        let rod = scene.add("rolling_pin", rod, at(2.0, 0.0, 0.01));
        let spoon = scene.cube(0.03, at(2.0, 1.0, 0.03));
        let mut world = scene.world();
        world.settle(200);
        world.put_open(chest, Some(0), 1.0).unwrap();
        world.settle(200);
        let edge = world.pose(beside).unwrap().translation.vector;
        let (thing, spot) = match how {
            "pinned" => (spoon, at(0.3, -0.1, 0.24)),
            "falls" => (spoon, at(edge.x, edge.y - 0.0601, 0.246)),
            _ => (rod, at(0.4, 0.0, 0.27)),
        };
        world.place(thing, spot).unwrap();
        if how == "falls" {
            world.run(1);
        } else {
            world.pin(thing, None).unwrap();
        }
        let before = world.pose(thing).unwrap().translation.vector;
        world.put_open(chest, Some(0), 0.0).unwrap();
        world.settle(200);
        let moved = world.pose(thing).unwrap().translation.vector - before;
        assert!((moved.x + 0.3).abs() < 0.02 && moved.z.abs() < 0.01, "{how}: {moved:?}");
    }
}

/// A thing that lies on a rack and on the open flap before it goes in with the rack, and not up with the flap after that.
#[test]
fn what_a_rack_has_taken_along_lies_on_no_flap() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.4) };
    let hinge =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.31, 0.0, 0.2), axis: Vector3::y(), limits: (0.0, 1.57) };
    let moving = |name: &str, half: [f32; 3], x: f32, z: f32, joint: Joint| {
        let mut board = part(name, block(half), at(x, 0.0, z), scene.wood);
        board.joint = Some(joint);
        board
    };
    let parts = vec![
        part("bottom", block([0.3, 0.3, 0.01]), at(0.0, 0.0, 0.01), scene.wood),
        moving("rack", [0.2, 0.2, 0.01], 0.0, 0.2, slide),
        moving("flap", [0.01, 0.2, 0.15], 0.31, 0.36, hinge),
    ];
    let machine = scene.asset(Asset { name: "machine".into(), parts, ..Asset::default() });
    let machine = scene.add("dishwasher", machine, at(0.0, 0.0, 0.0));
    let fork = scene.cube(0.03, at(2.0, 0.0, 0.03));
    let mut world = scene.world();
    world.put_open(machine, Some(1), 1.0).unwrap();
    world.put_open(machine, Some(0), 1.0).unwrap();
    world.place(fork, at(0.45, 0.0, 0.242)).unwrap();
    assert!(world.settle(300).at_rest);
    let before = world.pose(fork).unwrap().translation.vector;
    world.put_open(machine, Some(0), 0.0).unwrap();
    world.put_open(machine, Some(1), 0.0).unwrap();
    let moved = world.pose(fork).unwrap().translation.vector - before;
    assert!((moved + Vector3::x() * 0.4).norm() < 0.02, "{moved:?}");
}

/// A chest of a few kilograms: its drawer moves with it and has no motor.
fn light_chest(scene: &mut Scene) -> NodeId {
    scene.wood = scene.library.add_material(common::material("balsa", 150.0, 0.5, 0.0)).unwrap();
    let chest = scene.chest_asset();
    scene.add("nightstand", chest, at(0.0, 0.0, 0.0))
}

/// The drawer of a chest that one could push away takes along what is in it, too, and shuts with it.
#[test]
fn a_drawer_of_a_light_chest_takes_its_content_along() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = light_chest(&mut scene);
    let spoon = scene.cube(0.03, at(0.0, 0.05, 0.245));
    let mut world = scene.world();
    assert!(!world.parts(chest).all()[0].has_motor);
    world.settle(200);
    let shut = world.pose(spoon).unwrap().translation.vector;
    for (open, along) in [(1.0, 0.3), (0.0, 0.0), (1.0, 0.3)] {
        assert!(world.set_openness(chest, open, &[]).unwrap(), "{:?}", world.parts(chest).blockers(open));
        world.settle(100);
        let moved = world.pose(spoon).unwrap().translation.vector - shut;
        assert!((moved - Vector3::x() * along).norm() < 0.01, "{open}: {moved:?}");
    }
}

/// A rod that lies across a drawer, as far as over its sides and against a wall beside it, keeps it open; one within
/// does not.
#[test]
fn what_sticks_out_of_a_drawer_keeps_it_open() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
    let beside = scene.solid("wall", block([0.24, 0.1, 0.5]), scene.wood);
    let beside = scene.add("wall", beside, at(0.0, 0.45, 0.5));
    let rod = scene.solid("rod", block([0.01, 0.3, 0.01]), scene.wood);
    let rod = scene.add("rolling_pin", rod, at(2.0, 0.0, 0.01));
    let short = scene.cube(0.03, at(2.0, 1.0, 0.03));
    let mut world = scene.world();
    // Nothing keeps open a drawer that is shut.
    assert!(!world.parts(chest).are_kept_open_by(rod, &at(0.3, 0.15, 0.4)).unwrap());
    world.put_open(chest, Some(0), 1.0).unwrap();
    assert!(world.parts(chest).are_kept_open_by(rod, &at(0.35, 0.15, 0.4)).unwrap());
    assert!(!world.parts(chest).are_kept_open_by(short, &at(0.35, 0.15, 0.25)).unwrap());
    world.place(rod, at(0.35, 0.15, 0.4)).unwrap();
    world.settle(60);
    assert!(!world.set_openness(chest, 0.0, &[]).unwrap());
    assert_eq!(world.parts(chest).blockers(0.0).unwrap(), [beside]);
}

/// A light box with a heavy lid, whose centre of mass moves by centimetres with the lid, stands still meanwhile.
#[test]
fn a_light_box_stands_still_when_its_lid_turns() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let joint =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(-0.1, 0.0, 0.3), axis: -Vector3::y(), limits: (0.0, 1.5) };
    let base = part("base", block([0.1, 0.1, 0.15]), at(0.0, 0.0, 0.15), scene.wood);
    let mut lid = part("lid", block([0.1, 0.1, 0.02]), at(0.0, 0.0, 0.32), scene.wood);
    lid.joint = Some(joint);
    let hamper = scene.asset(Asset { name: "hamper".into(), parts: vec![base, lid], ..Asset::default() });
    let hamper = scene.add("laundry_hamper", hamper, at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    assert!(world.settle(200).at_rest);
    let before = world.pose(hamper).unwrap().translation.vector;
    for open in [1.0, 0.0, 1.0, 0.0] {
        world.put_open(hamper, Some(0), open).unwrap();
        for step in 0..30 {
            world.step();
            let moved = (world.pose(hamper).unwrap().translation.vector - before).norm();
            assert!(moved < 0.001, "{open}: {moved} m after {step} steps");
        }
    }
}

/// A drawer between two cupboards without any gap still opens, and the cupboards stay in place.
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
    assert!(world.parts(chests[1]).openness().unwrap() > 0.99);
    assert_eq!([world.parts(chests[0]).openness(), world.parts(chests[2]).openness()], [Some(0.0), Some(0.0)]);
    assert_eq!(world.pose(snug), Some(at(0.1, 0.265, 0.3)));
}

/// A chest of one board with a lid of another, hinged at the back: its axis is horizontal, and it opens towards
/// negative angles.
fn lidded(scene: &mut Scene) -> vc_graph::NodeId {
    let joint =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(-0.3, 0.0, 0.4), axis: Vector3::y(), limits: (-1.4, 0.0) };
    let base = part("base", block([0.3, 0.4, 0.2]), at(0.0, 0.0, 0.2), scene.wood);
    let mut lid = part("lid", block([0.3, 0.4, 0.01]), at(0.0, 0.0, 0.41), scene.wood);
    lid.joint = Some(joint);
    let chest = scene.asset(Asset { name: "chest".into(), parts: vec![base, lid], ..Asset::default() });
    scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0))
}

/// A balanced lid stays where it is left; an unbalanced one falls shut.
#[test]
fn lids_stay_or_fall() {
    for balanced in [true, false] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let chest = lidded(&mut scene);
        let mut world = scene.world_with(Settings { balanced, ..plain() });
        world.put_open(chest, Some(0), 0.6).unwrap();
        assert!(world.parts(chest).pose(0).unwrap().rotation.angle() > 0.5);
        world.settle(600);
        let open = world.parts(chest).openness().unwrap();
        assert!(if balanced { (open - 0.6).abs() < 0.01 } else { open < 0.01 }, "{balanced}: {open}");
    }
}

/// Things in the door of a fridge come along and stay there.
#[test]
fn milk_rides_in_the_fridge_door() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.6);
    let w = scene.wood;
    let hinge =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.3, 0.3, 0.0), axis: Vector3::z(), limits: (0.0, 1.6) };
    let moving = |name: &str, half: [f32; 3], x: f32, z: f32| {
        let mut board = part(name, block(half), at(x, 0.0, z), w);
        board.joint = Some(hinge);
        board
    };
    let parts = vec![
        part("body", block([0.25, 0.3, 0.8]), at(-0.05, 0.0, 0.8), w),
        moving("leaf", [0.02, 0.3, 0.8], 0.36, 0.8),
        moving("shelf", [0.06, 0.26, 0.01], 0.28, 1.0),
        moving("rail", [0.005, 0.26, 0.04], 0.215, 1.05),
    ];
    let fridge = scene.asset(Asset { name: "fridge".into(), parts, ..Asset::default() });
    let fridge = scene.add("fridge", fridge, at(0.0, 0.0, 0.0));
    let milk = scene.cube(0.04, at(0.28, -0.1, 1.051));
    let mut world = scene.world();
    world.settle(300);
    let (before, closed) = (world.pose(milk).unwrap(), world.parts(fridge).pose(0).unwrap());
    world.drive(fridge, 0, 1.0).unwrap();
    assert!(world.settle(900).at_rest);
    assert!(world.parts(fridge).openness().unwrap() > 0.98);
    let carried = world.parts(fridge).pose(0).unwrap() * closed.inverse() * before;
    let now = world.pose(milk).unwrap();
    assert!((now.translation.vector - carried.translation.vector).norm() < 0.05, "{now}, carried {carried}");
    assert!((now.translation.z - before.translation.z).abs() < 0.006);
}

/// The two leaves of a window open and close one by one.
#[test]
fn a_window_of_two_leaves() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let w = scene.wood;
    let leaf = |side: f32| {
        let limits = if side > 0.0 { (0.0, 1.5) } else { (-1.5, 0.0) };
        let anchor = Point3::new(0.0, 0.5 * side, 0.0);
        let mut leaf = part("leaf", block([0.02, 0.25, 0.6]), at(0.0, 0.25 * side, 1.5), w);
        leaf.joint = Some(Joint { kind: JointKind::Hinge, anchor, axis: Vector3::z(), limits });
        leaf
    };
    let sill = part("sill", block([0.1, 0.5, 0.05]), at(0.0, 0.0, 0.8), w);
    let window =
        scene.asset(Asset { name: "window".into(), parts: vec![sill, leaf(1.0), leaf(-1.0)], ..Asset::default() });
    let window = scene.add("window", window, at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    let open = |world: &PhysicsWorld| world.parts(window).all().iter().map(|p| p.open).collect::<Vec<f32>>();
    world.drive(window, 1, 1.0).unwrap();
    assert!(world.settle(600).at_rest);
    let now = open(&world);
    assert!(now[0] < 0.01 && now[1] > 0.98, "{now:?}");
    world.put_open(window, None, 0.5).unwrap();
    assert!(open(&world).iter().all(|o| (o - 0.5).abs() < 1e-3), "{:?}", open(&world));
    let before = world.digest();
    assert!(world.put_open(window, None, f32::NAN).is_err() && world.put_open(NodeId(77), None, 0.5).is_err());
    assert_eq!(world.digest(), before);
    world.drive(window, 0, 0.0).unwrap();
    world.drive(window, 1, 0.0).unwrap();
    world.settle(600);
    assert_eq!(world.parts(window).state(), Some(State::Closed));
}

/// A door that is opened at once ends where it ends when opened over time; if a person is in the way it stays
/// as it was.
#[test]
fn doors_that_leap() {
    let scene = |person: bool| {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let door = scene.door_asset();
        let door = scene.add("door", door, at(0.0, 0.0, 0.0));
        if person {
            scene.agent(at(0.45, 0.0, 0.0));
        }
        (scene.world(), door)
    };
    let ((mut driven, door), (mut at_once, _)) = (scene(false), scene(false));
    driven.drive(door, 0, 1.0).unwrap();
    driven.settle(600);
    assert!(at_once.set_openness(door, 1.0, &[]).unwrap());
    at_once.settle(100);
    let angle = |world: &PhysicsWorld| world.parts(door).all()[0].position;
    assert!((angle(&driven) - angle(&at_once)).abs() < 0.01, "{} {}", angle(&driven), angle(&at_once));
    let (mut blocked, door) = scene(true);
    let before = blocked.digest();
    assert!(!blocked.set_openness(door, 1.0, &[]).unwrap());
    assert_eq!(blocked.digest(), before);
}

/// A cupboard with a sliding board, and in front of it a door with a rack; a jar stands on the rack, in front
/// of the board. There may be a wall that the jar hits while the door opens.
fn racked(wall: bool) -> (PhysicsWorld, vc_graph::NodeId, vc_graph::NodeId) {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    let hinge =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.4, -0.3, 0.0), axis: Vector3::z(), limits: (-1.5, 0.0) };
    let on = |joint: Option<Joint>, half: [f32; 3], pose: Pose| {
        let mut part = part("board", block(half), pose, scene.wood);
        part.joint = joint;
        part
    };
    let parts = vec![
        on(None, [0.3, 0.3, 0.02], at(0.0, 0.0, 0.02)),
        on(Some(slide), [0.25, 0.25, 0.01], at(0.0, 0.0, 0.18)),
        on(Some(hinge), [0.01, 0.3, 0.3], at(0.4, 0.0, 0.4)),
        on(Some(hinge), [0.05, 0.3, 0.01], at(0.34, 0.0, 0.15)),
    ];
    let asset = scene.asset(Asset { name: "cupboard".into(), parts, ..Asset::default() });
    let cupboard = scene.add("kitchen_cabinet", asset, at(0.0, 0.0, 0.0));
    let jar = scene.cube(0.03, at(0.34, 0.25, 0.195));
    if wall {
        let wall = scene.solid("wall", block([0.05, 0.5, 0.5]), scene.wood);
        scene.add("wall", wall, at(0.95, -0.1, 0.5));
    }
    let mut world = scene.world();
    world.settle(200);
    (world, cupboard, jar)
}

/// A door is opened before the part behind it, and closed after it, with all its contents.
#[test]
fn what_is_in_the_way_moves_first() {
    let (mut world, cupboard, jar) = racked(false);
    let open = |world: &PhysicsWorld| world.parts(cupboard).all().iter().map(|p| p.open).collect::<Vec<f32>>();
    for wanted in [1.0, 0.0] {
        assert!(world.set_openness(cupboard, wanted, &[]).unwrap());
        world.settle(200);
        assert!(open(&world).iter().all(|o| (o - wanted).abs() < 0.01), "{:?}", open(&world));
        assert_eq!(world.supports(jar), [cupboard]);
    }
}

/// A door opens only as far as its contents can move.
#[test]
fn a_door_opens_as_far_as_its_load_goes() {
    let (mut world, cupboard, jar) = racked(true);
    assert!(world.set_openness(cupboard, 1.0, &[]).unwrap());
    let parts = world.parts(cupboard).all();
    assert!(parts[0].open > 0.99 && (0.5..0.9).contains(&parts[1].open), "{parts:?}");
    let before = world.pose(jar).unwrap().translation.vector;
    world.settle(200);
    assert!((world.pose(jar).unwrap().translation.vector - before).norm() < 0.01);
    assert_eq!(world.supports(jar), [cupboard]);
}

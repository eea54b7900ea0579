//! From scene graphs to worlds: what is fixed, what falls, what opens.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod common;

use common::{Scene, at, block, part, plain, surface, turned};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Shape};
use vc_graph::{Asset, Bounds, Draft, Edge, NodeId, Place, Relation, SceneBuilder, State};
use vc_physics::{Fixing, Order, PhysicsError, Role, Settings, Shapes, Unplaced, World};

#[test]
fn roles_by_class() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let heavy = scene.solid("heavy", block([0.3, 0.3, 0.3]), scene.wood);
    let sofa = scene.add("sofa", heavy, at(2.0, 0.0, 0.3));
    let fridge = scene.add("fridge", heavy, at(-2.0, 0.0, 0.3));
    let cup = scene.cube(0.05, at(0.0, 0.0, 0.8));
    let strange = scene.add("gizmo_of_no_class", heavy, at(0.0, 2.0, 0.3));
    let (graph, shapes) = (scene.graph(), Shapes::new());
    let roles = |fixing| {
        let world = World::build(&graph, &shapes, Settings { fixing, ..plain() }).unwrap();
        [floor, table, sofa, fridge, cup, strange].map(|id| world.role(id).unwrap())
    };
    use Role::{Fixed, Loose};
    // The table has 33 kg, the blocks 130.
    assert_eq!(roles(Fixing::Heavy), [Fixed, Fixed, Fixed, Fixed, Loose, Fixed]);
    assert_eq!(roles(Fixing::Immovable), [Fixed, Loose, Loose, Fixed, Loose, Loose]);
    assert_eq!(roles(Fixing::Structure), [Fixed, Loose, Loose, Loose, Loose, Loose]);
}

#[test]
fn class_masses() {
    let mut scene = Scene::default();
    let cup = scene.solid("cup", block([0.04, 0.04, 0.04]), scene.wood);
    let heavy = scene.add("cup", cup, at(0.0, 0.0, 1.0));
    let graph = scene.graph();
    let modelled = World::build(&graph, &Shapes::new(), plain()).unwrap();
    assert!((modelled.mass(heavy).unwrap() - 0.3072).abs() < 1e-3);
    // No cup has more than 0.3 kg.
    let real = World::build(&graph, &Shapes::new(), Settings::default()).unwrap();
    assert!((real.mass(heavy).unwrap() - 0.3).abs() < 1e-4);
    assert_eq!(real.modelled_mass(heavy), modelled.mass(heavy));
}

/// A cup of twice the size may weigh eight times as much.
#[test]
fn class_masses_grow_with_the_scale() {
    let mut scene = Scene::default();
    let cup = scene.solid("cup", block([0.03, 0.03, 0.03]), scene.wood);
    let draft =
        Draft { asset: Some(cup), scale: Some(Vector3::repeat(2.0)), ..Draft::new("cup").at(at(0.0, 0.0, 1.0)) };
    let large = scene.builder.add(draft).unwrap();
    let world = scene.world_with(Settings::default());
    assert!((world.mass(large).unwrap() - 600.0 * 0.12_f32.powi(3)).abs() < 1e-3, "{:?}", world.mass(large));
}

/// A picture that rests on nothing hangs, if the graph says what other things rest on.
#[test]
fn what_hangs_stays_until_it_is_touched() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let picture = scene.cube(0.1, at(0.0, 0.0, 1.5));
    let toy = scene.cube(0.1, at(1.0, 0.0, 0.1));
    scene.builder.edit().place(toy, Place { relation: Relation::On, at: floor }).unwrap();
    let mut edit = scene.builder.edit();
    edit.place(toy, Place { relation: Relation::On, at: floor }).unwrap();
    edit.commit();
    let graph = scene.graph();
    let mut world = World::build(&graph, &Shapes::new(), plain()).unwrap();
    assert_eq!((world.role(picture), world.role(toy)), (Some(Role::Hung), Some(Role::Loose)));
    assert!(world.settle(200).is_sound());
    assert!(world.pose(picture).unwrap().translation.z == 1.5);
    world.push(picture, Vector3::new(0.1, 0.0, 0.0), Point3::new(0.0, 0.0, 1.5)).unwrap();
    assert_eq!(world.settle(300).fell, [picture]);
    let falls = Settings { unplaced: Unplaced::Falls, ..plain() };
    let mut world = World::build(&graph, &Shapes::new(), falls).unwrap();
    assert_eq!(world.settle(300).fell, [picture]);
}

/// A coat on a hook hangs there, though the graph says what it is on; one that lies
/// beside does not.
#[test]
fn what_is_on_a_hook_hangs() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let board = part("board", block([0.01, 0.4, 0.05]), at(0.0, 0.0, 1.6), scene.wood);
    let hook = surface("hook", Hold::Hook, [0.05, 0.2, 1.6], (0.0, 0.0), Some(1.2));
    let rack = scene.asset(Asset { name: "rack".into(), parts: vec![board], surfaces: vec![hook], ..Asset::default() });
    let rack = scene.add("wall_hook_rack", rack, turned(1.0, 1.0, 0.0, Vector3::z(), 0.5));
    let coat = scene.solid("coat", block([0.05, 0.2, 0.5]), scene.wood);
    let spot = turned(1.0, 1.0, 0.0, Vector3::z(), 0.5);
    let hangs = scene.add("coat", coat, spot * at(0.08, 0.2, 1.1));
    let falls = scene.add("coat", coat, spot * at(0.08, -0.3, 1.1));
    let mut edit = scene.builder.edit();
    for id in [hangs, falls] {
        edit.place(id, Place { relation: Relation::On, at: rack }).unwrap();
    }
    edit.commit();
    let mut world = scene.world();
    assert_eq!((world.role(hangs), world.role(falls)), (Some(Role::Hung), Some(Role::Loose)));
    assert_eq!(world.settle(400).fell, [falls]);
}

/// Light things on small feet come to rest and stay where they are.
#[test]
fn small_things_do_not_tremble() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let bottle = vec![(0.0, 0.0), (0.03, 0.0), (0.035, 0.02), (0.035, 0.14), (0.012, 0.2), (0.012, 0.24), (0.0, 0.24)];
    let cup = vec![(0.03, 0.0), (0.04, 0.09), (0.036, 0.09), (0.027, 0.005)];
    let plate = vec![(0.06, 0.0), (0.06, 0.004), (0.13, 0.02), (0.13, 0.024), (0.05, 0.006)];
    let mut things = Vec::new();
    for (i, profile) in [bottle, cup, plate].into_iter().enumerate() {
        let asset = scene.solid("turned", Shape::Lathe { profile }, scene.wood);
        for j in 0..6 {
            let spot = turned(0.4 * i as f32, 0.4 * j as f32, 0.002, Vector3::z(), 0.3 * j as f32);
            things.push((scene.add("toy", asset, spot), spot));
        }
    }
    let mut world = scene.world();
    let report = world.settle(120);
    assert!(report.at_rest && report.fell.is_empty(), "{report:?}");
    for (id, spot) in things {
        let moved = world.pose(id).unwrap().translation.vector - spot.translation.vector;
        assert!(moved.norm() < 0.01, "{moved:?}");
    }
}

#[test]
fn settle_tells_what_happened() {
    let mut scene = Scene::default();
    let floor = scene.floor(2.0, 0.5);
    scene.room([-2.0, -2.0], [2.0, 2.0]);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let still = scene.cube(0.05, at(0.0, 0.2, 0.791));
    let falls = scene.cube(0.05, at(0.0, 1.0, 0.9));
    let lost = scene.cube(0.05, at(5.0, 0.0, 0.5));
    let mut edit = scene.builder.edit();
    for id in [still, falls] {
        edit.place(id, Place { relation: Relation::On, at: table }).unwrap();
    }
    edit.place(lost, Place { relation: Relation::On, at: floor }).unwrap();
    edit.place(table, Place { relation: Relation::On, at: floor }).unwrap();
    edit.commit();
    let mut world = scene.world();
    let report = world.settle(150);
    assert!(!report.is_sound());
    assert_eq!(report.fell, [falls, lost]);
    let on = |at: NodeId| Place { relation: Relation::On, at };
    assert_eq!(report.left, [(falls, on(table)), (lost, on(floor))]);
    assert_eq!(report.outside, [lost]);
    assert!(report.moved.iter().all(|m| m.id != still));
    assert_eq!(world.supports(still), [table]);
    let contact = world.contacts_of(still)[0];
    assert_eq!((contact.a, contact.b), (table, still));
    assert!(contact.normal.z > 0.99 && contact.point.z > 0.73 && contact.depth < 0.006, "{contact:?}");
}

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

#[test]
fn free_spots() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(1.0, 1.0, 0.0));
    let cubes: Vec<_> = (0..60).map(|i| scene.cube(0.05, at(-3.0 + 0.2 * i as f32, -3.0, 0.05))).collect();
    let large = scene.cube(0.5, at(4.0, 4.0, 0.5));
    let mut world = scene.world();
    let mut placed = 0;
    for (i, &cube) in cubes.iter().enumerate() {
        let order = [Order::Middle, Order::Near(Point3::new(0.6, 0.3, 0.8)), Order::Random(vc_graph::Seed(7))][i % 3];
        let Some(spot) = world.free_spot(cube, table, 0, 0.3, order).unwrap() else { break };
        assert!(world.overlaps(cube, &spot).unwrap().is_empty());
        world.place(cube, spot).unwrap();
        placed += 1;
    }
    // The table has room for 0.8 * 1.4 / 0.1^2 cubes at the very most.
    assert!(placed > 30, "{placed}");
    assert_eq!(world.free_spot(large, table, 0, 0.0, Order::Middle).unwrap(), None);
    let report = world.settle(200);
    assert!(report.at_rest && report.fell.is_empty() && report.overlapping.is_empty(), "{report:?}");
    for cube in &cubes[..placed] {
        assert_eq!(world.supports(*cube)[0], table);
    }
    assert!(world.free_spot(cubes[0], table, 3, 0.0, Order::Middle).is_err());
    assert!(world.is_free(Vector3::repeat(0.2), &at(0.0, -1.0, 1.0)));
    assert!(!world.is_free(Vector3::repeat(0.2), &at(1.0, 1.0, 0.7)));
}

#[test]
fn free_spots_in_containers_keep_below_their_roof() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let w = scene.wood;
    let board = |x: f32, z: f32, half: [f32; 3]| part("board", block(half), at(x, 0.0, z), w);
    let parts = vec![
        board(0.0, 0.01, [0.2, 0.3, 0.01]),
        board(0.0, 0.39, [0.2, 0.3, 0.01]),
        board(-0.19, 0.2, [0.01, 0.3, 0.18]),
    ];
    let surfaces = vec![
        surface("shelf", Hold::Inside, [0.0, 0.0, 0.02], (0.17, 0.29), Some(0.36)),
        surface("top", Hold::On, [0.0, 0.0, 0.4], (0.2, 0.3), None),
    ];
    let shelf = scene.asset(Asset { name: "shelf".into(), parts, surfaces, ..Asset::default() });
    let shelf = scene.add("shelf", shelf, turned(1.0, 1.0, 0.0, Vector3::z(), 0.7));
    let low = scene.cube(0.1, at(3.0, 0.0, 0.1));
    let tall = scene.solid("tall", block([0.05, 0.05, 0.2]), w);
    let tall = scene.add("toy", tall, at(3.0, 1.0, 0.2));
    let mut world = scene.world();
    let spot = world.free_spot_at(low, shelf, true, Order::Middle).unwrap().unwrap();
    world.place(low, spot).unwrap();
    assert_eq!(world.free_spot_at(tall, shelf, true, Order::Middle).unwrap(), None, "it is too tall");
    let on_top = world.free_spot_at(tall, shelf, false, Order::Middle).unwrap().unwrap();
    world.place(tall, on_top).unwrap();
    assert!(world.settle(200).fell.is_empty());
    assert!((world.pose(low).unwrap().translation.z - 0.12).abs() < 0.005);
    assert_eq!(world.supports(tall), [shelf]);
}

/// A bowl holds an apple, a solid of its hull would not.
#[test]
fn bowls_are_hollow() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let profile = vec![(0.06, 0.0), (0.12, 0.08), (0.115, 0.08), (0.055, 0.008)];
    let bowl = scene.solid("bowl", Shape::Lathe { profile }, scene.wood);
    let bowl = scene.add("bowl", bowl, at(0.0, 0.0, 0.001));
    let apple = scene.ball(0.035, at(0.0, 0.0, 0.06));
    let mut world = scene.world();
    let report = world.settle(900);
    assert!(report.at_rest && report.overlapping.is_empty(), "{report:?}");
    let z = world.pose(apple).unwrap().translation.z;
    assert!(z > 0.035 && z < 0.055, "{z}");
    assert_eq!(world.supports(apple), [bowl]);
}

/// However many parts an asset has, it has few pieces, and its shelves stay open.
#[test]
fn many_parts_become_few_pieces() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let w = scene.wood;
    let mut parts = Vec::new();
    for i in 0..4 {
        parts.push(part("board", block([0.15, 0.4, 0.01]), at(0.0, 0.0, 0.01 + 0.3 * i as f32), w));
    }
    for side in [-1.0, 1.0] {
        for i in 0..60 {
            let z = 0.01 + 0.015 * i as f32;
            parts.push(part("slat", block([0.15, 0.01, 0.007]), at(0.0, 0.41 * side, z), w));
        }
    }
    let surfaces: Vec<_> = (0..3)
        .map(|i| surface("shelf", Hold::Inside, [0.0, 0.0, 0.02 + 0.3 * i as f32], (0.15, 0.38), Some(0.28)))
        .collect();
    let shelf = scene.asset(Asset { name: "shelf".into(), parts, surfaces, ..Asset::default() });
    let shelf = scene.add("bookshelf", shelf, at(0.0, 0.0, 0.0));
    let books: Vec<_> = (0..3).map(|i| scene.cube(0.1, at(0.0, 0.0, 0.13 + 0.3 * i as f32))).collect();
    let mut world = scene.world();
    let (_, pieces) = world.size();
    assert!(pieces <= 24 + 4, "{pieces}");
    let report = world.settle(200);
    assert!(report.at_rest && report.fell.is_empty() && report.overlapping.is_empty(), "{report:?}");
    for book in books {
        assert_eq!(world.supports(book), [shelf], "{:?} {:?}", world.pose(book), world.contacts());
    }
}

/// Scaled assets are as large and as heavy as they should be.
#[test]
fn scales() {
    for (scale, factor) in [([2.0, 2.0, 2.0], 8.0), ([1.0, 2.0, 3.0], 6.0)] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let asset = scene.solid("cube", block([0.1, 0.1, 0.1]), scene.wood);
        let draft = Draft { asset: Some(asset), scale: Some(scale.into()), ..Draft::new("toy").at(at(0.0, 0.0, 1.0)) };
        let id = scene.builder.add(draft).unwrap();
        let world = scene.world();
        assert!((world.mass(id).unwrap() / (4.8 * factor) - 1.0).abs() < 1e-3);
        let aabb = world.aabb(id).unwrap();
        assert!((aabb.max - aabb.min - Vector3::from(scale) * 0.2).norm() < 1e-4, "{aabb:?}");
    }
}

/// Graphs with boxes only: VirtualHome's, and those without poses.
#[test]
fn boxes_only() {
    let mut builder = SceneBuilder::new("boxes");
    let size = |x: f32, y: f32, z: f32| Bounds::standing([x, y, z].into());
    let floor = Draft::new("floor").at(at(0.0, 0.0, -0.1)).bounds(size(6.0, 6.0, 0.1));
    builder.add(floor).unwrap();
    let cabinet = builder.add(Draft::new("kitchen_cabinet").at(at(0.0, 0.0, 0.0)).bounds(size(0.6, 1.0, 0.8))).unwrap();
    let plate =
        builder.add_in(cabinet, Draft::new("plate").at(at(0.0, 0.0, 0.02)).bounds(size(0.25, 0.25, 0.03))).unwrap();
    let apple =
        builder.add_on(cabinet, Draft::new("apple").at(at(0.0, 0.0, 0.801)).bounds(size(0.08, 0.08, 0.08))).unwrap();
    let nowhere = builder.add(Draft::new("fork")).unwrap();
    let graph = builder.build();
    let mut world = World::build(&graph, &Shapes::new(), Settings::default()).unwrap();
    assert_eq!(world.skipped(), [nowhere]);
    let report = world.settle(300);
    assert!(report.is_sound(), "{report:?}");
    assert!((world.pose(plate).unwrap().translation.z - 0.01).abs() < 0.015, "in the hollow box");
    assert_eq!(world.supports(apple), [cabinet]);
    assert!(graph.has(Edge::new(plate, Relation::Inside, cabinet)));
}

#[test]
fn shapes_are_kept_between_worlds_and_dropped_with_their_library() {
    let shapes = Shapes::new();
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    scene.table(at(0.0, 0.0, 0.0));
    let graph = scene.graph();
    World::build(&graph, &shapes, plain()).unwrap();
    assert_eq!(shapes.len(), 2);
    World::build(&graph, &shapes, plain()).unwrap();
    assert_eq!(shapes.len(), 2);
    drop(graph);
    let other = Scene::default().graph();
    World::build(&other, &shapes, plain()).unwrap();
    assert!(shapes.is_empty());
}

#[test]
fn fill_levels() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let w = scene.wood;
    let side = |x: f32, y: f32, half: [f32; 3]| part("side", block(half), at(x, y, 0.3), w);
    let parts = vec![
        part("bottom", block([0.4, 0.8, 0.02]), at(0.0, 0.0, 0.02), w),
        side(0.39, 0.0, [0.01, 0.8, 0.26]),
        side(-0.39, 0.0, [0.01, 0.8, 0.26]),
        side(0.0, 0.79, [0.38, 0.01, 0.26]),
        side(0.0, -0.79, [0.38, 0.01, 0.26]),
    ];
    let surfaces = vec![surface("basin", Hold::Inside, [0.0, 0.0, 0.04], (0.37, 0.77), Some(0.5))];
    let bath = scene.asset(Asset { name: "bath".into(), parts, surfaces, ..Asset::default() });
    let bath = scene.add("bathtub", bath, at(0.0, 0.0, 0.0));
    let duck = scene.ball(0.06, at(0.0, 0.0, 0.11));
    let mut world = scene.world();
    assert!((world.capacity(bath).unwrap() - 4.0 * 0.37 * 0.77 * 0.5).abs() < 1e-4);
    world.settle(200);
    assert_eq!(world.level(bath), 0.0);
    world.fill(bath, 0.6).unwrap();
    assert_eq!((world.level(bath), world.waters().len()), (0.6, 1));
    world.settle(1200);
    let z = world.pose(duck).unwrap().translation.z;
    assert!(z > 0.32 && z < 0.36, "the duck floats: {z}");
    world.fill(bath, 0.0).unwrap();
    world.wake(duck).unwrap();
    world.settle(400);
    assert!(world.pose(duck).unwrap().translation.z < 0.11 && world.waters().is_empty());
    assert!(world.fill(duck, f32::NAN).is_err());
}

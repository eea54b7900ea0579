//! Worlds built from scene graphs: roles, masses, and free spots.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain, surface, turned};
use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Shape};
use vc_graph::{Asset, Bounds, Draft, Edge, Relation, SceneBuilder};
use vc_physics::{
    BodyRole, FixedThings, PhysicsWorld, Settings, ShapeCache, SpotFault, SpotOrder, SpotSearch, SpotWish,
};

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
    let (graph, shapes) = (scene.graph(), ShapeCache::new());
    let roles = |fixing| {
        let world = PhysicsWorld::build(&graph, &shapes, Settings { fixing, ..plain() }).unwrap();
        [floor, table, sofa, fridge, cup, strange].map(|id| world.role(id).unwrap())
    };
    use BodyRole::{Fixed, Loose};
    // The mass of the table is 33 kg, that of the blocks 130 kg.
    assert_eq!(roles(FixedThings::Heavy), [Fixed, Fixed, Fixed, Fixed, Loose, Fixed]);
    assert_eq!(roles(FixedThings::Immovable), [Fixed, Loose, Loose, Fixed, Loose, Loose]);
    assert_eq!(roles(FixedThings::Structure), [Fixed, Loose, Loose, Loose, Loose, Loose]);
}

#[test]
fn class_masses() {
    let mut scene = Scene::default();
    let cup = scene.solid("cup", block([0.04, 0.04, 0.04]), scene.wood);
    let heavy = scene.add("cup", cup, at(0.0, 0.0, 1.0));
    let graph = scene.graph();
    let modelled = PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap();
    assert!((modelled.body(heavy).unwrap().mass() - 0.3072).abs() < 1e-3);
    // No cup weighs more than 0.3 kg.
    let real = PhysicsWorld::build(&graph, &ShapeCache::new(), Settings::default()).unwrap();
    assert!((real.body(heavy).unwrap().mass() - 0.3).abs() < 1e-4);
    assert_eq!(real.body(heavy).unwrap().modelled_mass(), modelled.body(heavy).unwrap().mass());
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
    assert!(
        (world.body(large).unwrap().mass() - 600.0 * 0.12_f32.powi(3)).abs() < 1e-3,
        "{}",
        world.body(large).unwrap().mass()
    );
}

#[test]
fn free_spots() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(1.0, 1.0, 0.0));
    let cubes: Vec<_> = (0..60).map(|i| scene.cube(0.05, at(-3.0 + 0.2 * i as f32, -3.0, 0.05))).collect();
    let large = scene.cube(0.5, at(4.0, 4.0, 0.5));
    let mut world = scene.world();
    let rotation = Some(UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.3));
    let turned = SpotWish { rotation, surface: Some(0), ..SpotWish::default() };
    let mut placed = 0;
    for (i, &cube) in cubes.iter().enumerate() {
        let order =
            [SpotOrder::Middle, SpotOrder::Near(Point3::new(0.6, 0.3, 0.8)), SpotOrder::Random(vc_graph::Seed(7))]
                [i % 3];
        let search = SpotSearch::new(cube, table, false).order(order);
        let Ok(spot) = search.wished(&world, &turned, |_| true).unwrap() else { break };
        assert!(world.overlaps(cube, &spot).unwrap().is_empty());
        world.place(cube, spot).unwrap();
        placed += 1;
    }
    // The table has room for at most 0.8 * 1.4 / 0.1^2 cubes.
    assert!(placed > 30, "{placed}");
    assert_eq!(SpotSearch::new(large, table, false).find(&world).unwrap(), None);
    let report = world.settle(200);
    assert!(report.at_rest && report.fell.is_empty() && report.overlapping.is_empty(), "{report:?}");
    for cube in &cubes[..placed] {
        assert_eq!(world.supports(*cube)[0], table);
    }
    let no_such = SpotWish { surface: Some(3), ..SpotWish::default() };
    let none = SpotSearch::new(cubes[0], table, false).wished(&world, &no_such, |_| true);
    assert_eq!(none.unwrap(), Err(SpotFault::OffSurface));
}

/// A wall keeps its window open, however many parts it has.
#[test]
fn a_wall_of_many_parts_keeps_its_window() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    // A grid of bricks half a metre wide, except at the window.
    let bricks =
        (0..8).flat_map(|i| (0..5).map(move |k| (i, k))).filter(|(i, k)| !(3..5).contains(i) || !(2..4).contains(k));
    let brick = |(i, k): (i32, i32)| {
        let pose = at(0.0, -1.75 + 0.5 * i as f32, 0.25 + 0.5 * k as f32);
        part("brick", block([0.05, 0.25, 0.25]), pose, scene.wood)
    };
    let parts: Vec<_> = bricks.map(brick).collect();
    assert_eq!(parts.len(), 36);
    let wall = scene.asset(Asset { name: "wall".into(), parts, ..Asset::default() });
    scene.add("wall", wall, at(2.0, 0.0, 0.0));
    let (through, against) = (scene.ball(0.05, at(0.0, 0.0, 1.5)), scene.ball(0.05, at(0.0, 1.2, 1.5)));
    let mut world = scene.world();
    for ball in [through, against] {
        world.set_velocity(ball, Vector3::new(8.0, 0.0, 1.0), Vector3::zeros()).unwrap();
    }
    world.run(60);
    let x = |id| world.pose(id).unwrap().translation.x;
    assert!(x(through) > 2.5 && x(against) < 2.0, "{} {}", x(through), x(against));
}

/// A wall that is a single mesh, as in model files, keeps its doorway.
#[test]
fn a_wall_of_one_mesh_keeps_its_doorway() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    // The outline of the wall around the doorway, extruded along x.
    let outline = [(-2.0, 0.0), (-0.5, 0.0), (-0.5, 2.0), (0.5, 2.0), (0.5, 0.0), (2.0, 0.0), (2.0, 2.6), (-2.0, 2.6)];
    let vertices: Vec<Point3<f32>> =
        [-0.05, 0.05].iter().flat_map(|&x| outline.map(|(y, z)| Point3::new(x, y, z))).collect();
    let front = [[0, 1, 2], [0, 2, 7], [2, 3, 7], [7, 3, 6], [3, 5, 6], [3, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = front.map(|[a, b, c]| [a + 8, b + 8, c + 8]).to_vec();
    triangles.extend(front.map(|[a, b, c]| [a, c, b]));
    for i in 0..8 {
        let j = (i + 1) % 8;
        triangles.extend([[i, j, j + 8], [i, j + 8, i + 8]]);
    }
    let mesh = Shape::Mesh { vertices, triangles, uvs: Vec::new() };
    let wall = scene.solid("wall", mesh, scene.wood);
    scene.add("wall", wall, at(2.0, 0.0, 0.0));
    let low = [(-1.0, 0.5), (0.0, 0.5), (0.0, 1.7), (0.0, 2.3), (1.0, 1.5)];
    let balls = low.map(|(y, z)| scene.ball(0.05, at(0.0, y, z)));
    let mut world = scene.world();
    for ball in balls {
        world.set_velocity(ball, Vector3::new(8.0, 0.0, 0.5), Vector3::zeros()).unwrap();
    }
    world.run(30);
    let through = balls.map(|ball| world.pose(ball).unwrap().translation.x > 2.2);
    assert_eq!(through, [false, true, true, false, false]);
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
    let spot = SpotSearch::new(low, shelf, true).find(&world).unwrap().unwrap();
    world.place(low, spot).unwrap();
    assert_eq!(SpotSearch::new(tall, shelf, true).find(&world).unwrap(), None, "it is too tall");
    let on_top = SpotSearch::new(tall, shelf, false).find(&world).unwrap().unwrap();
    world.place(tall, on_top).unwrap();
    assert!(world.settle(200).fell.is_empty());
    assert!((world.pose(low).unwrap().translation.z - 0.12).abs() < 0.005);
    assert_eq!(world.supports(tall), [shelf]);
}

/// An asset with many parts has few pieces, and its shelves stay open.
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

/// Scaled assets have the correct sizes and masses.
#[test]
fn scales() {
    for (scale, factor) in [([2.0, 2.0, 2.0], 8.0), ([1.0, 2.0, 3.0], 6.0)] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let asset = scene.solid("cube", block([0.1, 0.1, 0.1]), scene.wood);
        let draft = Draft { asset: Some(asset), scale: Some(scale.into()), ..Draft::new("toy").at(at(0.0, 0.0, 1.0)) };
        let id = scene.builder.add(draft).unwrap();
        let world = scene.world();
        assert!((world.body(id).unwrap().mass() / (4.8 * factor) - 1.0).abs() < 1e-3);
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
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), Settings::default()).unwrap();
    assert_eq!(world.skipped(), [nowhere]);
    let report = world.settle(300);
    assert!(report.is_sound(), "{report:?}");
    assert!((world.pose(plate).unwrap().translation.z - 0.01).abs() < 0.015, "in the hollow box");
    assert_eq!(world.supports(apple), [cabinet]);
    assert!(graph.has(Edge::new(plate, Relation::Inside, cabinet)));
}

#[test]
fn shapes_are_kept_between_worlds_and_dropped_with_their_library() {
    let shapes = ShapeCache::new();
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    scene.table(at(0.0, 0.0, 0.0));
    let graph = scene.graph();
    PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    assert_eq!(shapes.len(), 2);
    PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    assert_eq!(shapes.len(), 2);
    drop(graph);
    let other = Scene::default().graph();
    PhysicsWorld::build(&other, &shapes, plain()).unwrap();
    assert!(shapes.is_empty());
}

//! Pitfalls of the physics engine, each with this crate's remedy.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use std::collections::BTreeMap;
use std::f32::consts::FRAC_PI_2;

use common::{Scene, at, part, plain, surface};
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use vc_graph::asset::{Hold, Shape};
use vc_graph::{Asset, Draft};
use vc_physics::{PhysicsWorld, Settings, ShapeCache, SpotOrder, SpotSearch};

/// Bodies that are inserted asleep sink into their supports: `rest` finds contacts first.
#[test]
fn a_scene_put_to_rest_stays_where_it_is() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let cubes: Vec<_> = (0..20).map(|i| scene.cube(0.05, at(0.2 * i as f32 - 2.0, 0.0, 0.05))).collect();
    let mut world = scene.world();
    world.rest();
    assert_eq!(world.awake(), 0);
    let before: Vec<_> = cubes.iter().map(|c| world.pose(*c).unwrap()).collect();
    world.run(120);
    assert_eq!(before, cubes.iter().map(|c| world.pose(*c).unwrap()).collect::<Vec<_>>());
    // When pushed, the cubes move and come to rest again.
    world.push(cubes[3], Vector3::new(0.0, 0.6, 0.0), Point3::new(-1.4, 0.0, 0.05)).unwrap();
    let report = world.settle(200);
    assert!(report.at_rest && report.moved.iter().any(|m| m.id == cubes[3]), "{report:?}");
    for cube in &cubes {
        let z = world.pose(*cube).unwrap().translation.z;
        assert!((z - 0.05).abs() < 0.006, "{z}");
    }
}

/// Bodies are registered before the first step, so none of them hangs in the air.
#[test]
fn bodies_fall_after_queries() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let ball = scene.ball(0.1, at(0.0, 0.0, 3.0));
    let mut world = scene.world();
    assert!(world.contacts().is_empty() && world.overlaps(ball, &at(0.0, 0.0, 0.05)).unwrap().len() == 1);
    world.settle(300);
    assert!((world.pose(ball).unwrap().translation.z - 0.1).abs() < 0.006);
}

/// An overlap is reported before anything is placed.
#[test]
fn overlap_is_told_beforehand() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let cube = scene.cube(0.1, at(2.0, 0.0, 0.1));
    let world = scene.world();
    assert_eq!(world.overlaps(cube, &at(0.0, 0.0, 0.72)).unwrap(), [table]);
    assert_eq!(world.overlaps(cube, &at(0.37, 0.67, 0.05)).unwrap(), [floor, table]);
    // Touching is not overlapping.
    assert!(world.overlaps(cube, &at(0.0, 0.0, 0.84)).unwrap().is_empty());
    assert!(world.overlaps(cube, &at(0.0, 0.0, 0.3)).unwrap().is_empty(), "under the table");
}

/// A body that becomes non-finite is stopped, named and reported; the others continue.
#[test]
fn a_body_that_becomes_non_finite_is_named() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let (wild, calm) = (scene.cube(0.1, at(0.0, 0.0, 2.0)), scene.cube(0.1, at(1.0, 0.0, 2.0)));
    let mut world = scene.world();
    world.step();
    for _ in 0..3 {
        let far = Point3::new(1e30, 0.0, 0.0);
        let _ = world.push(wild, Vector3::new(0.0, 3e38, 3e38), far);
    }
    let report = world.settle(300);
    assert_eq!((report.stopped.as_slice(), world.stopped()), (&[wild][..], &[wild][..]), "{report:?}");
    assert!(world.pose(wild).unwrap().translation.vector.iter().all(|v| v.is_finite()));
    assert!((world.pose(calm).unwrap().translation.z - 0.1).abs() < 0.006);
    assert!(world.push(wild, Vector3::x(), Point3::origin()).is_err());
}

/// A mesh is not solid where it holds things: a ball stays in a tub.
#[test]
fn a_tub_of_one_mesh_is_hollow() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    // Rings of four corners: the outside from below, then the inside from above.
    let rings = [(0.8, 0.0), (0.8, 0.5), (0.7, 0.5), (0.7, 0.12)];
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let ring = |&(r, z): &(f32, f32)| corners.map(|(x, y)| Point3::new(r * x, r * y, z));
    let vertices = rings.iter().flat_map(ring).collect();
    let side = |row: u32| {
        (0..4).map(move |k| [row * 4 + k, row * 4 + (k + 1) % 4, row * 4 + 4 + k, row * 4 + 4 + (k + 1) % 4])
    };
    let sides = (0..3).flat_map(side).flat_map(|[a, b, c, d]| [[a, b, d], [a, d, c]]);
    let triangles = sides.chain([[0, 2, 1], [0, 3, 2], [12, 13, 14], [12, 14, 15]]).collect();
    let tub = Asset {
        name: "tub".into(),
        parts: vec![part("tub", Shape::Mesh { vertices, triangles, uvs: Vec::new() }, at(0.0, 0.0, 0.0), scene.wood)],
        surfaces: vec![surface("basin", Hold::Inside, [0.0, 0.0, 0.12], (0.65, 0.65), Some(0.38))],
        ..Asset::default()
    };
    let tub = scene.asset(tub);
    scene.add("bathtub", tub, at(0.0, 0.0, 0.0));
    let balls = [(0.0, 0.0), (0.5, 0.5), (-0.55, 0.1)].map(|(x, y)| scene.ball(0.05, at(x, y, 0.25)));
    let mut world = scene.world();
    assert!(world.settle(300).outside.is_empty());
    for ball in balls {
        let z = world.pose(ball).unwrap().translation.z;
        assert!((z - 0.17).abs() < 0.006, "{z}");
    }
}

/// The inertia of a straw is below the resolution of the engine's eigenvectors: with wrong axes it digs into
/// its support.
#[test]
fn thin_things_lie_still() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let profile = vec![(0.0026, 0.0), (0.0026, 0.21), (0.0018, 0.21), (0.0018, 0.0), (0.0026, 0.0)];
    let straw = scene.solid("straw", Shape::Lathe { profile }, scene.wood);
    let lying =
        |i: usize| common::turned(0.3 * i as f32, 0.0, 0.0026, Vector3::new(1.0, 0.3 * i as f32, 0.0), FRAC_PI_2);
    let straws: Vec<_> = (0..4).map(|i| scene.add("drinking_straw", straw, lying(i))).collect();
    let mut world = scene.world();
    let report = world.settle(300);
    assert!(report.at_rest && report.fell.is_empty(), "{report:?}");
    for straw in straws {
        let z = world.pose(straw).unwrap().translation.z;
        assert!((z - 0.0026).abs() < 0.001, "{z}");
    }
}

/// The engine uses only four adjacent corners of a face with many: a round top would carry on one side only,
/// and a pot of one hull would stand on an edge.
#[test]
fn faces_with_many_corners_carry_everywhere() {
    let around = |radius: f32, i: u32| {
        let angle = i as f32 * std::f32::consts::TAU / 24.0;
        (radius * angle.cos(), radius * angle.sin())
    };
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let outline: Vec<_> = (0..24).map(|i| around(0.6, i)).collect();
    let top = scene.solid("top", Shape::Extrusion { outline, height: 0.7 }, scene.wood);
    scene.add("dining_table", top, at(0.0, 0.0, 0.0));
    let both = |i: u32, z: f32| Point3::new(around(0.06, i).0, around(0.06, i).1, z);
    let points = (0..24).flat_map(|i| [both(i, 0.0), both(i, 0.1)]).collect();
    let pot = scene.solid("pot", Shape::Hull { points }, scene.wood);
    let spots = [(0.0, 0.0), (0.45, 0.0), (-0.45, 0.0), (0.0, 0.45), (0.0, -0.45), (-0.3, 0.3)];
    let pots = spots.map(|(x, y)| scene.add("cooking_pot", pot, at(x, y, 0.7)));
    let mut world = scene.world();
    let report = world.settle(300);
    assert!(report.moved.is_empty(), "{report:?}");
    for pot in pots {
        let z = world.pose(pot).unwrap().translation.z;
        assert!((z - 0.7).abs() < 0.006, "{z}");
    }
}

fn hostile(sound: std::ops::Range<f32>) -> impl Strategy<Value = f32> {
    let odd = prop::sample::select(vec![0.0, -0.1, 1e-30, 1e30, -1e30, f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
    prop_oneof![6 => sound, 1 => odd]
}

/// Poses, positions of parts and roles, as bits and text: some are no numbers.
fn readings(world: &PhysicsWorld) -> BTreeMap<vc_graph::NodeId, String> {
    let parts = |id| world.parts(id).all().into_iter().map(|p| p.position.to_bits()).collect::<Vec<u32>>();
    let bits = |pose: vc_graph::Pose| {
        let numbers = pose.translation.vector.iter().chain(pose.rotation.coords.iter()).map(|v| v.to_bits());
        numbers.collect::<Vec<u32>>()
    };
    let reading = |id| format!("{:?} {:?} {:?}", world.pose(id).map(bits), parts(id), world.role(id));
    world.nodes().into_iter().map(|id| (id, reading(id))).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the measures, poses and calls, they are done or refused without a panic, and the resulting
    /// world is finite.
    #[test]
    fn hostile_worlds(
        boxes in prop::collection::vec(prop::array::uniform7(hostile(0.01..2.0)), 1..6),
        orders in prop::collection::vec((0..12_u8, 1..9_u32, prop::array::uniform3(hostile(-3.0..3.0))), 0..16),
    ) {
        let mut scene = Scene::default();
        scene.floor(4.0, 0.5);
        let door = scene.door_asset();
        scene.add("door", door, at(0.0, 3.0, 0.0));
        scene.agent(at(3.0, 3.0, 0.0));
        for [x, y, z, sx, sy, sz, turn] in boxes {
            let pose = common::turned(x, y, z, Vector3::new(0.2, 1.0, 0.4), turn);
            let bounds = vc_graph::Bounds::standing(Vector3::new(sx, sy, sz));
            // The graph itself refuses some of these.
            drop(scene.builder.add(vc_graph::Draft::new("toy").at(pose).bounds(bounds)));
        }
        let mut world = scene.world();
        let agent = world.agents().next().unwrap();
        let mut read = readings(&world);
        world.forget_moved();
        for (order, id, [a, b, c]) in orders {
            let (id, v) = (vc_graph::NodeId(id), Vector3::new(a, b, c));
            match order {
                0 => drop(world.push(id, v, v.into())),
                1 => drop(world.set_velocity(id, v, v)),
                2 => drop(world.place(id, at(a, b, c))),
                3 => drop(world.go(agent, v.xy())),
                4 => drop(world.follow(agent, &[v.xy().into()], true)),
                5 => drop(world.grab(agent, vc_physics::Hand::Right, id)),
                6 => drop(world.put_open(id, Some(0), a)),
                7 => drop(world.fill(id, a)),
                8 => drop(world.add_water(&vc_graph::Aabb { min: v.into(), max: (v * 2.0).into() })),
                9 => drop(world.sit(agent, id, None)),
                10 => drop(world.remove(id)),
                _ => drop(SpotSearch::new(id, vc_graph::NodeId(0), a > 0.0).order(SpotOrder::Near(v.into())).find(&world)),
            }
            world.run(2);
            // Whoever reads only what has moved misses nothing.
            let (now, moved) = (readings(&world), world.moved());
            for (id, reading) in &now {
                prop_assert!(moved.contains(id) || read.get(id) == Some(reading), "{id} after order {order}");
            }
            read = now;
            world.forget_moved();
        }
        let finite = |v: &Vector3<f32>| v.iter().all(|c| c.is_finite());
        for (id, pose) in world.poses() {
            prop_assert!(finite(&pose.translation.vector) || world.stopped().contains(&id), "{id}: {pose}");
        }
    }
}

/// Ten thousand things are thrown at random into a room in which others fly and fall: none passes through its
/// floor or its walls.
#[test]
fn no_tunnelling() {
    let mut out = 0;
    for batch in 0..20_u64 {
        let mut rng = vc_graph::Seed(batch).stream();
        let mut scene = Scene::default();
        scene.floor(4.2, 0.5);
        scene.room([-4.0, -4.0], [4.0, 4.0]);
        for (low, high) in [
            ([-4.1, -4.1, 0.0], [-4.0, 4.1, 30.0]),
            ([4.0, -4.1, 0.0], [4.1, 4.1, 30.0]),
            ([-4.0, -4.1, 0.0], [4.0, -4.0, 30.0]),
            ([-4.0, 4.0, 0.0], [4.0, 4.1, 30.0]),
        ] {
            scene.wall(low, high);
        }
        let cube = scene.solid("cube", common::block([0.06, 0.04, 0.05]), scene.wood);
        let ball = scene.solid("ball", vc_graph::asset::Shape::Sphere { radius: 0.04 }, scene.wood);
        let can = vc_graph::asset::Shape::Cylinder { radius: 0.035, half_height: 0.06 };
        let can = scene.solid("can", can, scene.wood);
        let mut graph = scene.graph();
        let shapes = ShapeCache::new();
        let mut world = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
        let things: Vec<_> = (0..500)
            .map(|i| {
                let mut pose = || {
                    let (x, y, z) = (rng.between(-3.8, 3.8), rng.between(-3.8, 3.8), rng.between(0.2, 6.0));
                    common::turned(x, y, z, Vector3::new(1.0, 0.3, 0.2), rng.between(-3.0, 3.0))
                };
                let mut edit = graph.edit();
                let toy = Draft { asset: Some([cube, ball, can][i % 3]), ..Draft::new("toy").at(pose()) };
                let thing = edit.add(toy).unwrap();
                edit.commit();
                world.insert(&graph, thing, &shapes).unwrap();
                // Other things may be at its spot.
                let mut spot = world.pose(thing).unwrap();
                while !world.overlaps(thing, &spot).unwrap().is_empty() {
                    spot = pose();
                }
                world.place(thing, spot).unwrap();
                let v = Vector3::new(rng.between(-8.0, 8.0), rng.between(-8.0, 8.0), rng.between(-15.0, 0.0));
                world.set_velocity(thing, v, Vector3::new(rng.between(-9.0, 9.0), 0.0, 3.0)).unwrap();
                if i % 50 == 0 {
                    world.step();
                }
                thing
            })
            .collect();
        let report = world.settle(2000);
        assert!(report.at_rest && report.stopped.is_empty() && report.outside.is_empty(), "{report:?}");
        for thing in &things {
            let p = world.body(*thing).unwrap().centre_of_mass();
            out += usize::from(p.x.abs() > 4.0 || p.y.abs() > 4.0 || p.z < 0.0);
        }
    }
    assert_eq!(out, 0, "of 10,000 things went through the floor or a wall");
}

/// Falls are as far with substeps and other step lengths.
#[test]
fn steps_of_other_lengths() {
    for (dt, substeps) in [(1.0 / 60.0, 4), (1.0 / 240.0, 1), (1.0 / 30.0, 2)] {
        let mut scene = Scene::default();
        scene.floor(5.0, 0.5);
        let ball = scene.ball(0.1, at(0.0, 0.0, 6.0));
        let mut world = scene.world_with(Settings { dt, substeps, ..plain() });
        world.run((1.0 / dt).round() as u32);
        let fallen = 6.0 - world.pose(ball).unwrap().translation.z;
        assert!((fallen - 4.905).abs() < 0.1, "{fallen} m with {dt} / {substeps}");
        assert!((world.time() - 1.0).abs() < 1e-3);
    }
    let graph = Scene::default().graph();
    for bad in
        [Settings { dt: 0.0, ..plain() }, Settings { substeps: 0, ..plain() }, Settings { dt: f32::NAN, ..plain() }]
    {
        assert!(PhysicsWorld::build(&graph, &ShapeCache::new(), bad).is_err());
    }
}

/// Everything below a floor is solid, however thin the floor is: fast or thin falling things do not pass
/// through. The floor's bounding box is not made thicker.
#[test]
fn floors_have_ground_below_them() {
    for thick in [1e-5_f32, 0.01, 0.1] {
        let mut scene = Scene::default();
        let slab = vc_graph::Bounds::standing([6.0, 6.0, thick].into());
        let floor = scene.builder.add(Draft::new("floor").at(at(0.0, 0.0, -thick)).bounds(slab)).unwrap();
        let sheet = scene.solid("sheet", common::block([0.05, 0.07, 0.0005]), scene.wood);
        let sheets: Vec<_> = (0..10_u8)
            .map(|i| {
                let (i, axis) = (f32::from(i), Vector3::new(1.0, f32::from(i), 0.3));
                scene.add("paper", sheet, common::turned(0.4 * i - 2.0, 0.0, 5.0, axis, 0.7 * i))
            })
            .collect();
        let mut world = scene.world();
        assert!(world.aabb(floor).unwrap().min.z > -thick - 0.003);
        let report = world.settle(900);
        assert!(report.outside.is_empty() && report.stopped.is_empty(), "{thick} m: {report:?}");
        for sheet in sheets {
            let z = world.body(sheet).unwrap().centre_of_mass().z;
            assert!(z > -0.005, "{thick} m: {z}");
        }
    }
}

/// A thing that gets past the edge of all floors is soon stopped and named, and takes part again where it is
/// placed.
#[test]
fn what_falls_out_of_the_world_is_stopped() {
    let mut scene = Scene::default();
    scene.floor(2.0, 0.5);
    let cube = scene.cube(0.05, at(3.0, 0.0, 0.5));
    let agent = scene.agent(at(0.0, 1.9, 0.0));
    let mut world = scene.world();
    let report = world.settle(600);
    assert_eq!((report.stopped.as_slice(), report.outside.as_slice()), (&[cube][..], &[cube][..]), "{report:?}");
    assert!(world.pose(cube).unwrap().translation.z > -4.0 && world.outside().contains(&cube));
    world.place(cube, at(1.0, 0.0, 0.3)).unwrap();
    assert_eq!(world.role(cube), Some(vc_physics::BodyRole::Loose));
    world.settle(300);
    assert!(world.stopped().is_empty() && !world.outside().contains(&cube));
    assert!((world.pose(cube).unwrap().translation.z - 0.05).abs() < 0.006);
    // Nobody walks over the edge.
    world.go(agent, nalgebra::Vector2::new(0.0, 1.0)).unwrap();
    world.run(240);
    let feet = world.pose(agent).unwrap().translation.vector;
    assert!(feet.z > -0.2 && feet.y < 2.4, "{feet}");
}

/// An agent without ground below falls as things do, is stopped and named, and stands again where it is placed.
#[test]
fn an_agent_over_nothing_falls() {
    for floor in [true, false] {
        let mut scene = Scene::default();
        if floor {
            scene.floor(2.0, 0.5);
        }
        let agent = scene.agent(at(5.0, 0.0, 0.0));
        let mut world = scene.world();
        world.run(20);
        assert!(world.stopped().is_empty());
        world.run(200);
        let feet = |world: &PhysicsWorld| world.pose(agent).unwrap().translation.vector;
        let end = feet(&world);
        assert!((-4.0..-1.9).contains(&end.z) && world.stopped() == [agent], "{end}");
        world.follow(agent, &[nalgebra::Point2::new(0.0, 0.0)], false).unwrap();
        world.run(240);
        assert_eq!((feet(&world), world.agent(agent).unwrap().walk()), (end, vc_physics::WalkState::Stuck));
        if floor {
            world.teleport(agent, at(1.0, 0.0, 0.05)).unwrap();
            world.run(60);
            assert!(world.stopped().is_empty() && feet(&world).z.abs() < 0.02, "{}", feet(&world));
        }
    }
}

/// Coinciding things are reported, however many there are.
#[test]
fn what_is_in_one_place_is_told() {
    let mut scene = Scene::default();
    scene.floor(2.0, 0.5);
    let heap: Vec<_> = (0..40_u8).map(|i| scene.cube(0.05, at(0.0001 * f32::from(i), 0.0, 0.06))).collect();
    let beside = scene.cube(0.05, at(0.2, 0.0, 0.06));
    let within = scene.cube(0.01, at(0.03, 0.0, 0.06));
    let world = scene.world();
    assert_eq!(world.coinciding(), heap[1..]);
    assert!(!world.coinciding().contains(&beside) && !world.coinciding().contains(&within));
}

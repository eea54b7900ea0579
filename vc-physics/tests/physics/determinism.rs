//! A clone, a restored snapshot and a rebuilt world evolve identically, bit for bit.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, plain, turned};
use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Aabb, Bounds, Draft, NodeId, SceneGraph, Seed};
use vc_physics::{
    BodyRole, Hand, PhysicsWorld, Posture, Settings, ShapeCache, SnapshotError, VehicleControls, VehiclePlan,
};

/// The agents and things that are moved in the scene.
#[derive(Clone, Copy)]
struct Others {
    chest: NodeId,
    door: NodeId,
    car: NodeId,
    stool: NodeId,
    me: NodeId,
    sitter: NodeId,
}

/// A room with a table, a chest, a door, a car, two agents and things that fall about.
fn graph() -> (SceneGraph, Vec<NodeId>, Others) {
    let mut scene = Scene::default();
    scene.floor(4.0, 0.5);
    scene.room([-4.0, -4.0], [4.0, 4.0]);
    scene.table(at(0.0, 0.0, 0.0));
    let (chest, door) = (scene.chest_asset(), scene.door_asset());
    let chest = scene.add("kitchen_cabinet", chest, at(2.0, 0.0, 0.0));
    let door = scene.add("door", door, at(-2.0, 0.0, 0.0));
    let mut rng = Seed(5).stream();
    let things = (0..40)
        .map(|_| {
            let spot = (rng.between(-1.5, 1.5), rng.between(-1.5, 1.5), rng.between(0.9, 2.5));
            scene.cube(0.05, turned(spot.0, spot.1, spot.2, Vector3::x(), rng.between(-2.0, 2.0)))
        })
        .collect();
    let car = scene.solid("car", common::block([0.4, 0.2, 0.1]), scene.wood);
    let car = scene.add("toy", car, at(-3.0, 3.0, 0.2));
    let stool = scene.solid("stool", common::block([0.2, 0.2, 0.22]), scene.wood);
    let stool = scene.add("stool", stool, at(3.0, -3.0, 0.22));
    let (me, sitter) = (scene.agent(at(-1.0, -3.0, 0.0)), scene.agent(at(2.3, -3.0, 0.0)));
    (scene.graph(), things, Others { chest, door, car, stool, me, sitter })
}

/// The events in the world at a step, always the same.
fn act(world: &mut PhysicsWorld, step: u32, things: &[NodeId], others: Others) {
    let Others { chest, door, car, stool, me, sitter } = others;
    match step {
        2 => world.add_vehicle(car, &VehiclePlan::car(80.0, 0.6, 0.3, 0.08, 0.0)).unwrap(),
        5 => world.add_water(&Aabb { min: [-4.0, 1.0, 0.0].into(), max: [4.0, 4.0, 0.15].into() }).unwrap(),
        15 => world.steer(car, VehicleControls { throttle: 0.4, steering: 0.3, ..VehicleControls::default() }).unwrap(),
        40 => world.sit(sitter, stool, None).unwrap(),
        120 => world.stand_up(sitter).unwrap(),
        10 => world.drive(chest, 0, 1.0).unwrap(),
        20 => world.drive(door, 0, 0.6).unwrap(),
        30 => world.follow(me, &[Point2::new(1.5, -3.0), Point2::new(1.5, 2.0)], false).unwrap(),
        60 => world.take_any(me, things),
        _ if step.is_multiple_of(25) => {
            let id = things[step as usize % things.len()];
            let _ = world.push(id, Vector3::new(0.1, 0.05, 0.3), Point3::new(0.0, 0.0, 0.5));
        }
        _ => {}
    }
    world.step();
}

trait Takes {
    fn take_any(&mut self, agent: NodeId, things: &[NodeId]);
}

impl Takes for PhysicsWorld {
    fn take_any(&mut self, agent: NodeId, things: &[NodeId]) {
        let near = self.agent(agent).unwrap().in_reach().first().map(|(id, _)| *id);
        if let Some(id) = near.filter(|id| things.contains(id)) {
            self.grab(agent, Hand::Right, id).unwrap();
        }
    }
}

#[test]
fn clone_restore_and_rebuild_are_the_same_world() {
    let (graph, things, others) = graph();
    let shapes = ShapeCache::new();
    let build = || PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    let (mut original, mut rebuilt) = (build(), build());
    let mut copies: Vec<(&str, PhysicsWorld)> = Vec::new();
    for step in 0..240 {
        // Copies are made while things move.
        if step == 0 || step == 70 {
            copies.push(("clone", original.clone()));
            let bytes = original.save().unwrap();
            let restored = PhysicsWorld::restore(&bytes, &graph, &ShapeCache::new()).unwrap();
            assert_eq!(restored.save().unwrap(), bytes, "a snapshot of the snapshot is the same");
            copies.push(("restored", restored));
        }
        act(&mut original, step, &things, others);
        act(&mut rebuilt, step, &things, others);
        assert_eq!(original.digest(), rebuilt.digest(), "rebuilt, step {step}");
        for (what, copy) in &mut copies {
            act(copy, step, &things, others);
            assert_eq!(original.digest(), copy.digest(), "{what}, step {step}");
        }
    }
    // The whole state, not only the part covered by the digest.
    let bytes = original.save().unwrap();
    assert_eq!(rebuilt.save().unwrap(), bytes);
    for (what, copy) in &copies {
        assert_eq!(copy.save().unwrap(), bytes, "{what}");
    }
}

/// Whatever was removed, moved and put back before, a restored world evolves as the saved one does; falls end
/// at the same places, too.
#[test]
fn a_restored_world_is_the_saved_one_after_any_edits() {
    for seed in 0..12 {
        let mut rng = Seed(seed).stream();
        let mut scene = Scene::default();
        let mut nodes: Vec<NodeId> = (0_u8..4)
            .map(|i| {
                let slab = Draft::new("floor").bounds(Bounds::standing([2.0, 2.0, 0.1].into()));
                scene.builder.add(slab.at(at(3.0 * f32::from(i), 0.0, -3.0 * f32::from(i)))).unwrap()
            })
            .collect();
        nodes.extend((0..12).map(|_| scene.cube(0.05, at(rng.between(-2.0, 11.0), 0.0, rng.between(0.5, 2.0)))));
        let graph = scene.graph();
        let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap();
        for _ in 0..10 {
            world.run(rng.count(1, 30) as u32);
            let id = nodes[rng.below(nodes.len())];
            if world.pose(id).is_none() {
                world.insert(&graph, id, &ShapeCache::new()).unwrap();
            } else if rng.chance(0.5) {
                world.remove(id).unwrap();
            } else {
                world.place(id, at(rng.between(-2.0, 11.0), 0.0, rng.between(-12.0, 2.0))).unwrap();
            }
        }
        let mut restored = PhysicsWorld::restore(&world.save().unwrap(), &graph, &ShapeCache::new()).unwrap();
        for _ in 0..40 {
            world.run(6);
            restored.run(6);
            assert_eq!((restored.digest(), restored.stopped()), (world.digest(), world.stopped()), "seed {seed}");
        }
        assert_eq!(restored.save().unwrap(), world.save().unwrap(), "seed {seed}");
    }
}

/// The same world ends in the same state on one thread, and among others on several threads.
#[test]
fn any_number_of_threads() {
    let (graph, things, others) = graph();
    let shapes = ShapeCache::new();
    let run = || {
        let mut world = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
        (0..150).for_each(|step| act(&mut world, step, &things, others));
        world.digest()
    };
    let alone = run();
    std::thread::scope(|scope| {
        let all: Vec<_> = (0..4).map(|_| scope.spawn(run)).collect();
        all.into_iter().for_each(|t| assert_eq!(t.join().unwrap(), alone));
    });
}

#[test]
fn worlds_can_be_sent_and_shared() {
    fn check<T: Send + Sync>() {}
    check::<PhysicsWorld>();
    check::<ShapeCache>();
    check::<vc_physics::Floor>();
}

#[test]
fn damaged_snapshots_are_refused() {
    let (graph, ..) = graph();
    let shapes = ShapeCache::new();
    let world = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    let bytes = world.save().unwrap();
    let restore = |bytes: &[u8]| PhysicsWorld::restore(bytes, &graph, &shapes).err();
    assert_eq!(restore(b"nonsense"), Some(SnapshotError::NotASnapshot));
    assert_eq!(restore(&[]), Some(SnapshotError::NotASnapshot));
    assert_eq!(restore(&bytes[..bytes.len() - 1]), Some(SnapshotError::Damaged));
    for at in (20..bytes.len()).step_by(997) {
        let mut bad = bytes.clone();
        bad[at] ^= 16;
        assert_eq!(restore(&bad), Some(SnapshotError::Damaged), "byte {at}");
    }
    let mut newer = bytes.clone();
    newer[8] = 99;
    assert_eq!(restore(&newer), Some(SnapshotError::Version { found: 99, expected: 8 }));
    let other = Scene::default().graph();
    assert!(matches!(PhysicsWorld::restore(&bytes, &other, &shapes), Err(SnapshotError::OtherScene(_))));
}

/// A reset moves the differing things and leaves the rest asleep; with too many differences the world is built
/// anew.
#[test]
fn reset_moves_what_differs() {
    let mut scene = Scene::default();
    scene.floor(4.0, 0.5);
    scene.table(at(0.0, 0.0, 0.0));
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(2.0, 0.0, 0.0));
    let cubes: Vec<_> = (0..40).map(|i| scene.cube(0.05, at(-2.0 + 0.12 * i as f32, -2.0, 0.052))).collect();
    let graph = scene.graph();
    let shapes = ShapeCache::new();
    let mut template = PhysicsWorld::build(&graph, &shapes, Settings::default()).unwrap();
    template.settle(200);
    let (same, plan) = template.reset(&graph, &shapes).unwrap();
    assert_eq!((same.digest(), plan), (template.digest(), Default::default()));

    let mut other = graph.clone();
    let mut edit = other.edit();
    edit.set_pose(cubes[3], Some(at(0.0, 0.0, 0.8))).unwrap();
    edit.remove(cubes[7]).unwrap();
    edit.enter_state(chest, vc_graph::State::Open).unwrap();
    let new = edit
        .add(vc_graph::Draft {
            asset: graph.node(cubes[0]).unwrap().spec().asset,
            ..vc_graph::Draft::new("toy").at(at(0.2, 0.3, 0.9))
        })
        .unwrap();
    edit.commit();
    let (mut world, plan) = template.reset(&other, &shapes).unwrap();
    assert_eq!((plan.moved.as_slice(), plan.removed.as_slice()), (&[cubes[3]][..], &[cubes[7]][..]));
    assert_eq!((plan.inserted.as_slice(), plan.turned.as_slice()), (&[new][..], &[chest][..]));
    assert!(world.settle(200).at_rest);
    assert!((world.pose(cubes[3]).unwrap().translation.z - 0.79).abs() < 0.006);
    assert!(world.parts(chest).openness().unwrap() > 0.999);
    assert_eq!(world.pose(cubes[7]), None);
    assert_eq!(world.pose(cubes[20]), template.pose(cubes[20]));
    // The template is unchanged and can be used again.
    assert_eq!(template.reset(&graph, &shapes).unwrap().0.digest(), template.digest());

    let mut edit = other.edit();
    for cube in &cubes[10..] {
        edit.set_pose(*cube, Some(at(0.0, 0.0, 3.0 + 0.2 * cube.0 as f32))).unwrap();
    }
    edit.commit();
    let (built, plan) = template.reset(&other, &shapes).unwrap();
    assert!(plan.built && built.ticks() == 0);
}

/// An agent that has walked away, or sits, stands again where the graph has it.
#[test]
fn a_reset_brings_agents_back() {
    let mut scene = Scene::default();
    scene.floor(4.0, 0.5);
    let stool = scene.solid("stool", common::block([0.2, 0.2, 0.22]), scene.wood);
    let stool = scene.add("stool", stool, at(1.0, 0.0, 0.22));
    let (walker, sitter) = (scene.agent(at(-2.0, 0.0, 0.01)), scene.agent(at(0.3, 0.0, 0.01)));
    let (graph, shapes) = (scene.graph(), ShapeCache::new());
    let mut template = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    template.settle(100);
    let fresh = template.poses();
    let (same, _) = template.reset(&graph, &shapes).unwrap();
    assert_eq!(same.digest(), template.digest(), "who has only landed is left alone");
    template.follow(walker, &[Point2::new(-2.0, 2.0)], false).unwrap();
    template.sit(sitter, stool, None).unwrap();
    template.run(200);
    let (mut world, plan) = template.reset(&graph, &shapes).unwrap();
    assert!(!plan.built);
    assert_eq!([walker, sitter].map(|a| world.posture(a)), [Some(Posture::Standing); 2]);
    world.run(20);
    for (id, before) in fresh {
        let way = world.pose(id).unwrap().translation.vector - before.translation.vector;
        assert!(way.norm() < 0.02, "{id}: {way:?}");
    }
}

/// A coat that hung on a hook and now lies on the bed is free to move, as in a world built from that scene.
#[test]
fn a_reset_takes_things_off_hooks() {
    let mut scene = Scene::default();
    scene.floor(4.0, 0.5);
    let w = scene.wood;
    let parts = vec![common::part("board", common::block([0.02, 0.3, 0.05]), at(0.0, 0.0, 1.6), w)];
    let surfaces = vec![common::surface("hook", vc_graph::asset::Hold::Hook, [0.05, 0.0, 1.6], (0.01, 0.01), None)];
    let rack = scene.asset(vc_graph::Asset { name: "rack".into(), parts, surfaces, ..Default::default() });
    let rack = scene.add("coat_rack", rack, at(0.0, 0.0, 0.0));
    let table = scene.table(at(2.0, 0.0, 0.0));
    let coat = scene.cube(0.05, at(0.08, 0.0, 1.55));
    let mut edit = scene.builder.edit();
    edit.place(coat, vc_graph::Place { relation: vc_graph::Relation::On, at: rack }).unwrap();
    edit.commit();
    let (graph, shapes) = (scene.graph(), ShapeCache::new());
    let mut template = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    template.settle(100);
    assert_eq!(template.role(coat), Some(BodyRole::Hung));
    let mut other = graph.clone();
    let mut edit = other.edit();
    edit.place(coat, vc_graph::Place { relation: vc_graph::Relation::On, at: table }).unwrap();
    edit.set_pose(coat, Some(at(2.0, 0.0, 0.9))).unwrap();
    edit.commit();
    let (mut world, plan) = template.reset(&other, &shapes).unwrap();
    let built = PhysicsWorld::build(&other, &shapes, plain()).unwrap();
    assert_eq!((world.role(coat), plan.built), (built.role(coat), false));
    world.settle(200);
    assert!((world.pose(coat).unwrap().translation.z - 0.79).abs() < 0.006, "{:?}", world.pose(coat));
    // The coat is back on the hook.
    let (hung, _) = world.reset(&graph, &shapes).unwrap();
    assert_eq!(hung.role(coat), Some(BodyRole::Hung));
}

/// Two resets to the same scene give the same world.
#[test]
fn resets_are_deterministic() {
    let (graph, things, _) = graph();
    let shapes = ShapeCache::new();
    let mut template = PhysicsWorld::build(&graph, &shapes, plain()).unwrap();
    template.settle(400);
    let mut other = graph.clone();
    let mut edit = other.edit();
    for (i, id) in things.iter().take(10).enumerate() {
        edit.set_pose(*id, Some(at(0.3 * i as f32 - 1.5, 2.0, 1.0))).unwrap();
    }
    edit.commit();
    let run = || {
        let (mut world, plan) = template.reset(&other, &shapes).unwrap();
        assert!(!plan.built);
        world.settle(300);
        world.digest()
    };
    assert_eq!(run(), run());
}

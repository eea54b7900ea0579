//! Clone, restored snapshot and rebuilt world go on alike, bit for bit.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod common;

use common::{Scene, at, plain, turned};
use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{NodeId, SceneGraph, Seed};
use vc_physics::{Hand, Settings, Shapes, SnapshotError, World};

/// A room with a table, a chest, a door, an agent and things that fall about.
fn graph() -> (SceneGraph, Vec<NodeId>, [NodeId; 3]) {
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
    let me = scene.agent(at(-1.0, -3.0, 0.0));
    (scene.graph(), things, [chest, door, me])
}

/// What happens in the world at a step, always the same.
fn act(world: &mut World, step: u32, things: &[NodeId], [chest, door, me]: [NodeId; 3]) {
    match step {
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

impl Takes for World {
    fn take_any(&mut self, agent: NodeId, things: &[NodeId]) {
        let near = self.in_reach(agent).unwrap().first().map(|(id, _)| *id);
        if let Some(id) = near.filter(|id| things.contains(id)) {
            self.grab(agent, Hand::Right, id).unwrap();
        }
    }
}

#[test]
fn clone_restore_and_rebuild_are_the_same_world() {
    let (graph, things, others) = graph();
    let shapes = Shapes::new();
    let build = || World::build(&graph, &shapes, plain()).unwrap();
    let (mut original, mut rebuilt) = (build(), build());
    let mut copies: Vec<(&str, World)> = Vec::new();
    for step in 0..240 {
        // Copies are made in the middle of things.
        if step == 0 || step == 70 {
            copies.push(("clone", original.clone()));
            let bytes = original.save().unwrap();
            let restored = World::restore(&bytes, &graph, &Shapes::new()).unwrap();
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
    assert_eq!(original.poses(), copies[1].1.poses());
    assert_eq!(original.contacts(), copies[3].1.contacts());
    // The whole state, not only what the digest looks at.
    let bytes = original.save().unwrap();
    assert_eq!(rebuilt.save().unwrap(), bytes);
}

/// The same world on one thread, and among others on several, ends the same.
#[test]
fn any_number_of_threads() {
    let (graph, things, others) = graph();
    let shapes = Shapes::new();
    let run = || {
        let mut world = World::build(&graph, &shapes, plain()).unwrap();
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
    check::<World>();
    check::<Shapes>();
    check::<vc_physics::Floor>();
}

#[test]
fn damaged_snapshots_are_refused() {
    let (graph, ..) = graph();
    let shapes = Shapes::new();
    let world = World::build(&graph, &shapes, plain()).unwrap();
    let bytes = world.save().unwrap();
    let restore = |bytes: &[u8]| World::restore(bytes, &graph, &shapes).err();
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
    assert_eq!(restore(&newer), Some(SnapshotError::Version { found: 99, expected: 3 }));
    let other = Scene::default().graph();
    assert!(matches!(World::restore(&bytes, &other, &shapes), Err(SnapshotError::OtherScene(_))));
}

/// A reset moves what differs and leaves the rest asleep; too much is built anew.
#[test]
fn reset_moves_what_differs() {
    let mut scene = Scene::default();
    scene.floor(4.0, 0.5);
    scene.table(at(0.0, 0.0, 0.0));
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(2.0, 0.0, 0.0));
    let cubes: Vec<_> = (0..40).map(|i| scene.cube(0.05, at(-2.0 + 0.12 * i as f32, -2.0, 0.052))).collect();
    let graph = scene.graph();
    let shapes = Shapes::new();
    let mut template = World::build(&graph, &shapes, Settings::default()).unwrap();
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
    assert!(world.openness(chest).unwrap() > 0.999);
    assert_eq!(world.pose(cubes[7]), None);
    assert_eq!(world.pose(cubes[20]), template.pose(cubes[20]));
    // The template is untouched and can be used again.
    assert_eq!(template.reset(&graph, &shapes).unwrap().0.digest(), template.digest());

    let mut edit = other.edit();
    for cube in &cubes[10..] {
        edit.set_pose(*cube, Some(at(0.0, 0.0, 3.0 + 0.2 * cube.0 as f32))).unwrap();
    }
    edit.commit();
    let (built, plan) = template.reset(&other, &shapes).unwrap();
    assert!(plan.built && built.ticks() == 0);
}

/// Two resets to the same scene are the same world.
#[test]
fn resets_are_deterministic() {
    let (graph, things, _) = graph();
    let shapes = Shapes::new();
    let mut template = World::build(&graph, &shapes, plain()).unwrap();
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

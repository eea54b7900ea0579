//! Worlds at rest that are built anew from what differs from their start.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, turned};
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use vc_graph::asset::{Joint, JointKind};
use vc_graph::{Asset, NodeId, Pose, Seed, Stream};
use vc_physics::{BodyRole, Hand, PhysicsWorld, RestError, ShapeCache};

/// A room with cubes in stacks, a cupboard with a drawer and a door, a light box with a lid, and two people.
struct Room {
    world: PhysicsWorld,
    graph: vc_graph::SceneGraph,
    cubes: Vec<NodeId>,
    cupboard: NodeId,
    chest: NodeId,
    people: Vec<NodeId>,
}

fn room() -> Room {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    let hinge =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.4, -0.3, 0.0), axis: Vector3::z(), limits: (-1.5, 0.0) };
    let lid =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(-0.1, 0.0, 0.12), axis: Vector3::y(), limits: (-1.5, 0.0) };
    let on = |joint: Option<Joint>, half: [f32; 3], pose: Pose| {
        let mut part = part("board", block(half), pose, scene.wood);
        part.joint = joint;
        part
    };
    let parts = vec![
        on(None, [0.3, 0.3, 0.02], at(0.0, 0.0, 0.02)),
        on(Some(slide), [0.25, 0.25, 0.01], at(0.0, 0.0, 0.2)),
        on(Some(hinge), [0.01, 0.3, 0.3], at(0.4, 0.0, 0.4)),
    ];
    let light =
        vec![on(None, [0.1, 0.1, 0.05], at(0.0, 0.0, 0.05)), on(Some(lid), [0.1, 0.1, 0.01], at(0.0, 0.0, 0.12))];
    let cupboard = scene.asset(Asset { name: "cupboard".into(), parts, ..Asset::default() });
    let chest = scene.asset(Asset { name: "chest".into(), parts: light, ..Asset::default() });
    let cupboard = scene.add("kitchen_cabinet", cupboard, at(0.0, 0.0, 0.0));
    let chest = scene.add("toy", chest, turned(-1.0, 1.0, 0.0, Vector3::z(), 0.4));
    let mut cubes = vec![scene.cube(0.04, at(0.1, 0.1, 0.25)), scene.cube(0.03, at(0.1, 0.1, 0.32))];
    for (x, y) in [(1.5, 1.5), (-2.0, -1.0)] {
        cubes
            .extend((0..5_u8).map(|i| scene.cube(0.05, at(x + 0.01 * f32::from(i % 2), y, 0.05 + 0.1 * f32::from(i)))));
    }
    let people = vec![scene.agent(at(1.0, -1.0, 0.0)), scene.agent(at(-1.0, -2.0, 0.0))];
    let graph = scene.graph();
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), common::plain()).unwrap();
    assert!(world.settle(400).at_rest);
    Room { world, graph, cubes, cupboard, chest, people }
}

impl Room {
    /// Does something at random to a world, and lets all come to rest.
    fn disturb(&self, world: &mut PhysicsWorld, rng: &mut Stream) {
        let (cube, person) = (self.cubes[rng.below(self.cubes.len())], self.people[rng.below(2)]);
        let shove = Vector3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(0.0, 0.5));
        let spot = at(rng.between(-2.5, 2.5), rng.between(-2.5, 2.5), rng.between(0.05, 0.6));
        match rng.below(9) {
            0 => drop(world.pose(cube).map(|pose| world.push(cube, shove, pose.translation.vector.into()))),
            1 => drop(world.place(cube, spot)),
            2 => drop(world.put_open(self.cupboard, Some(rng.below(2)), rng.between(0.0, 1.0))),
            3 => drop(world.drive(self.cupboard, rng.below(2), rng.between(-0.2, 1.2))),
            4 => drop(world.put_open(self.chest, None, rng.between(0.0, 1.0))),
            5 => {
                let near = world.pose(cube).map(|pose| pose.translation.vector);
                let beside = near
                    .map(|p| at(p.x + 0.4, p.y, 0.0))
                    .filter(|feet| world.standing(person, feet).unwrap().is_free());
                if let Some(feet) = beside {
                    world.teleport(person, feet).unwrap();
                }
                drop(world.grab(person, Hand::Right, cube));
            }
            6 => drop(world.drop(person, Hand::Right)),
            7 => {
                let feet = turned(spot.translation.x, spot.translation.y, 0.0, Vector3::z(), 1.0);
                if world.standing(person, &feet).unwrap().is_free() {
                    world.teleport(person, feet).unwrap();
                }
            }
            _ => {
                if world.pose(cube).is_some() {
                    drop(world.remove(cube));
                } else {
                    drop(world.insert(&self.graph, cube, &ShapeCache::new()));
                }
            }
        }
        world.settle(600);
        if world.awake() > 0 {
            world.rest();
        }
        world.run(2);
    }
}

fn bits(world: &PhysicsWorld) -> Vec<(NodeId, [u32; 7])> {
    let all = |pose: &Pose| {
        let (t, r) = (pose.translation.vector, pose.rotation.coords);
        [t.x, t.y, t.z, r.x, r.y, r.z, r.w].map(f32::to_bits)
    };
    world.poses().iter().map(|(id, pose)| (*id, all(pose))).collect()
}

/// The largest difference of two poses' numbers.
fn apart(one: &PhysicsWorld, other: &PhysicsWorld) -> f32 {
    let far = |((id, a), (also, b)): (&(NodeId, Pose), &(NodeId, Pose))| {
        assert_eq!(id, also);
        let turned = (a.rotation.coords - b.rotation.coords).abs().max();
        (a.translation.vector - b.translation.vector).abs().max().max(turned)
    };
    one.poses().iter().zip(&other.poses()).map(far).fold(0.0, f32::max)
}

fn same_future(one: &PhysicsWorld, other: &PhysicsWorld, room: &Room, rng: &Stream) {
    let (mut one, mut other) = (one.clone(), other.clone());
    for _ in 0..3 {
        room.disturb(&mut one, &mut rng.clone());
        room.disturb(&mut other, &mut rng.clone());
        assert_eq!(one.digest(), other.digest());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever has happened, the world that was recorded and every world that is built from the record are the same
    /// and go on alike, however often that is done; and recording moves nothing.
    #[test]
    fn a_record_is_the_world(seed in any::<u64>()) {
        let (room, mut rng) = (room(), Seed(seed).stream());
        let start = room.world.clone();
        let mut world = start.clone();
        for _ in 0..4 {
            room.disturb(&mut world, &mut rng);
            let before = world.clone();
            let record = match world.record(&start) {
                Ok(record) => record,
                Err(RestError::Moves(_) | RestError::Stopped(_)) => continue,
                Err(other) => panic!("{other}"),
            };
            prop_assert!(apart(&before, &world) < 1e-6, "{}", apart(&before, &world));
            let is = |world: &PhysicsWorld, id| world.role(id).map(|role| if role == BodyRole::Hung { BodyRole::Loose } else { role });
            for id in before.nodes() {
                prop_assert_eq!((is(&before, id), before.holder(id)), (is(&world, id), world.holder(id)));
                let open = |w: &PhysicsWorld| w.parts(id).all().iter().map(|p| (p.locked, (p.open * 1e4).round())).collect::<Vec<_>>();
                prop_assert_eq!(open(&before), open(&world));
            }
            let other = start.recorded(&record).unwrap();
            prop_assert_eq!(world.digest(), other.digest());
            let again = world.clone().record(&start).unwrap();
            prop_assert!(again.things().eq(record.things()));
            same_future(&world, &other, &room, &rng);
            same_future(&world, &start.recorded(&again).unwrap(), &room, &rng);
        }
    }
}

#[test]
fn a_hundred_records_move_no_bit() {
    let (room, mut rng) = (room(), Seed(3).stream());
    let mut world = room.world.clone();
    (0..6).for_each(|_| room.disturb(&mut world, &mut rng));
    world.record(&room.world).unwrap();
    let (poses, digest) = (bits(&world), world.digest());
    for _ in 0..100 {
        world.record(&room.world).unwrap();
        assert_eq!(bits(&world), poses);
    }
    assert_eq!(world.digest(), digest);
}

#[test]
fn what_moves_is_not_recorded() {
    let room = room();
    let mut world = room.world.clone();
    world.push(room.cubes[3], Vector3::new(0.3, 0.0, 0.0), Point3::origin()).unwrap();
    let before = world.digest();
    assert!(matches!(world.record(&room.world), Err(RestError::Moves(all)) if all.contains(&room.cubes[3])));
    assert_eq!(world.digest(), before);
}

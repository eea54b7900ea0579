//! Plans and questions leave a world as it is; time passes only where something is awake.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain, turned};
use nalgebra::{Point2, Point3, Vector2, Vector3};
use vc_graph::asset::{Joint, JointKind};
use vc_graph::{Asset, NodeId, Pose, Seed};
use vc_physics::{BodyRole, PhysicsError, PhysicsWorld, RestProgress, ShapeCache};

/// A cupboard with two sliding boards behind a door with a rack, things at random on all of them and in front, perhaps
/// a wall beside it, and a person about.
fn cupboard(seed: u64) -> (PhysicsWorld, NodeId, NodeId) {
    let mut rng = Seed(seed).stream();
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let slide = Joint { kind: JointKind::Slide, anchor: Point3::origin(), axis: Vector3::x(), limits: (0.0, 0.3) };
    let higher = Joint { limits: (0.0, 0.2), ..slide };
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
        on(Some(higher), [0.25, 0.25, 0.01], at(0.0, 0.0, 0.4)),
        on(Some(hinge), [0.01, 0.3, 0.3], at(0.4, 0.0, 0.4)),
        on(Some(hinge), [0.05, 0.3, 0.01], at(0.34, 0.0, 0.15)),
    ];
    let asset = scene.asset(Asset { name: "cupboard".into(), parts, ..Asset::default() });
    let cupboard = scene.add("kitchen_cabinet", asset, at(0.0, 0.0, 0.0));
    for (x, z, half) in [(0.34, 0.195, 0.03), (0.1, 0.23, 0.035), (0.1, 0.45, 0.035), (0.6, 0.05, 0.045)] {
        if rng.between(0.0, 1.0) < 0.7 {
            scene.cube(half, at(x + rng.between(-0.02, 0.02), rng.between(-0.2, 0.25), z));
        }
    }
    if rng.between(0.0, 1.0) < 0.5 {
        let wall = scene.solid("wall", block([0.05, 0.5, 0.5]), scene.wood);
        scene.add("wall", wall, at(rng.between(0.7, 1.2), -0.1, 0.5));
    }
    let person = scene.agent(at(rng.between(0.7, 1.6), rng.between(-1.0, 0.5), 0.0));
    let mut world = scene.world();
    world.settle(200);
    (world, cupboard, person)
}

fn openness(world: &PhysicsWorld, id: NodeId) -> Vec<f32> {
    world.parts(id).all().iter().map(|part| part.open).collect()
}

/// A copy in which the parts that come first, doors before drawers and drawers before doors that shut, are where a plan
/// has them, if they go all the way: a plan made then is the same.
fn midway(world: &PhysicsWorld, id: NodeId, open: f32, plan: Option<&[f32]>) -> Option<PhysicsWorld> {
    let first = if open > 0.0 { JointKind::Hinge } else { JointKind::Slide };
    let (mut copy, parts) = (world.clone(), world.parts(id).all());
    for (part, to) in plan?.iter().enumerate().filter(|(part, _)| parts[*part].kind == first) {
        (*to == open).then_some(())?;
        copy.put_open(id, Some(part), *to).unwrap();
    }
    Some(copy)
}

/// A plan says how far opening at once then moves each part, and refuses where that returns false; the world stays as
/// it is.
#[test]
fn plans_of_openness_come_true() {
    let (mut whole, mut part_way, mut none, mut halves) = (0, 0, 0, 0);
    for seed in 0..60 {
        let (mut world, cupboard, person) = cupboard(seed);
        for (open, passes) in [(1.0, false), (1.0, true), (0.6, true), (0.0, true)] {
            let past = if passes { std::slice::from_ref(&person) } else { &[] };
            let before = world.digest();
            let plan = world.parts(cupboard).plan(open, past).unwrap();
            assert_eq!(world.digest(), before);
            let midway = midway(&world, cupboard, open, plan.as_deref());
            let did = world.set_openness(cupboard, open, past).unwrap();
            assert_eq!(did, plan.is_some(), "seed {seed}, {open}");
            let Some(plan) = plan else {
                none += 1;
                continue;
            };
            if let Some(midway) = midway {
                assert_eq!(
                    midway.parts(cupboard).plan(open, past).unwrap().as_ref(),
                    Some(&plan),
                    "seed {seed}, {open}"
                );
                halves += 1;
            }
            let now = openness(&world, cupboard);
            let equal = plan.iter().zip(&now).all(|(plan, now)| (plan - now).abs() < 1e-4);
            assert!(equal && plan.len() == now.len(), "seed {seed}, {open}: {plan:?}, {now:?}");
            let complete = plan.iter().all(|o| *o == open);
            (whole, part_way) = (whole + i32::from(complete), part_way + i32::from(!complete));
            world.run(3);
        }
    }
    assert!(whole > 100 && part_way > 20 && none > 10 && halves > 50, "{whole} {part_way} {none} {halves}");
}

#[test]
fn plans_refuse_as_motions_do() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    assert_eq!(world.parts(floor).plan(1.0, &[]), Ok(Some(vec![])));
    assert_eq!(world.parts(NodeId(77)).plan(1.0, &[]), Err(PhysicsError::NoBody(NodeId(77))));
    assert!(matches!(world.parts(chest).plan(f32::NAN, &[]), Err(PhysicsError::NotFinite(..))));
    world.lock(chest, 0, true).unwrap();
    assert_eq!(world.parts(chest).plan(1.0, &[]), Err(PhysicsError::Locked(chest)));
}

/// A table with stacks on it, things that fall beside and among them, and a ball that rolls by.
fn falling(seed: u64) -> (PhysicsWorld, Vec<NodeId>) {
    let mut rng = Seed(seed).stream();
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let mut things = vec![table];
    for stack in 0..3 {
        things.extend((0..3).map(|i| scene.cube(0.05, at(0.0, 0.4 * stack as f32 - 0.4, 0.791 + 0.1 * i as f32))));
    }
    for _ in 0..12 {
        let spot = (rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(1.2, 3.0));
        things.push(scene.cube(0.04, turned(spot.0, spot.1, spot.2, Vector3::x(), rng.between(-2.0, 2.0))));
    }
    let ball = scene.ball(0.1, at(-4.0, -2.0, 0.1));
    things.push(ball);
    let mut world = scene.world();
    world.set_velocity(ball, Vector3::new(2.0, 0.3, 0.0), Vector3::zeros()).unwrap();
    (world, things)
}

/// A thing that rests stays where it is to the bit, until something comes and touches it; all rest when nothing is
/// awake, and only then.
#[test]
fn what_rests_stays() {
    let (mut rested, mut moved) = (0, 0);
    for seed in 0..4 {
        let (mut world, things) = falling(seed);
        world.step();
        for _ in 0..600 {
            let rests: Vec<bool> = things.iter().map(|id| world.rests(&[*id])).collect();
            assert_eq!(world.rests(&things), rests.iter().all(|r| *r));
            assert_eq!(world.rests(&things), world.awake() == 0);
            let before: Vec<Option<Pose>> = things.iter().map(|id| world.pose(*id)).collect();
            world.step();
            for ((id, before), rested_before) in things.iter().zip(before).zip(rests) {
                let stays = world.pose(*id) == before;
                assert!(stays || !rested_before || !world.rests(&[*id]), "{id} moved at rest");
                rested += i32::from(rested_before && world.awake() > 0);
                moved += i32::from(!stays);
            }
        }
        assert!(world.settle(900).at_rest && world.rests(&things));
    }
    assert!(rested > 1000 && moved > 1000, "{rested} {moved}");
}

/// Rest is asked of an island: through loose things that touch, not through the table on which they stand.
#[test]
fn rest_is_of_what_touches() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let [low, middle, top] = [0.791, 0.891, 0.991].map(|z| scene.cube(0.05, at(0.0, 0.3, z)));
    let apart = scene.cube(0.05, at(0.0, -0.3, 0.791));
    let person = scene.agent(at(2.0, 2.0, 0.0));
    let mut world = scene.world();
    world.step();
    let all = [table, low, middle, top, apart, person, NodeId(77)];
    assert!(all[..5].iter().all(|id| !world.rests(&[*id])), "it is about to settle");
    assert!(world.settle(300).at_rest);
    assert!(world.rests(&all) && world.rests(&[]));
    world.wake(top).unwrap();
    assert_eq!(all.map(|id| world.rests(&[id])), [false, false, false, false, true, true, true]);
    world.settle(300);
    world.go(person, Vector2::new(1.0, 0.0)).unwrap();
    assert!(world.rests(&[low, apart]) && !world.rests(&[low, person]));
}

/// A floor with a wall's edge of nothing behind, two people and a door.
fn two_people() -> (PhysicsWorld, vc_graph::SceneGraph, [NodeId; 3]) {
    let mut scene = Scene::default();
    scene.floor(3.0, 0.5);
    let door = scene.door_asset();
    let door = scene.add("door", door, at(0.0, 0.0, 0.0));
    let (one, other) = (scene.agent(at(0.45, 0.0, 0.0)), scene.agent(at(2.0, 0.0, 0.0)));
    let graph = scene.graph();
    (PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap(), graph, [one, other, door])
}

/// Where nothing is awake, time that passes and steps that are run end in the same state, and go on alike.
#[test]
fn time_passes_as_it_runs() {
    let (mut world, _, [one, other, door]) = two_people();
    assert!(!world.pass(1), "they have yet to stand");
    world.run(60);
    for ticks in [1, 7, 8, 100] {
        let (mut passed, mut run) = (world.clone(), world.clone());
        assert!(passed.pass(ticks));
        run.run(ticks as u32);
        assert_eq!((passed.digest(), passed.ticks()), (run.digest(), run.ticks()));
        for world in [&mut passed, &mut run] {
            world.teleport(one, at(-2.0, 2.0, 0.0)).unwrap();
            world.drive(door, 0, 1.0).unwrap();
            world.run(90);
        }
        assert_eq!(passed.digest(), run.digest());
    }
    let before = world.ticks();
    world.follow(other, &[Point2::new(2.0, 2.0)], false).unwrap();
    assert!(!world.pass(60), "somebody walks");
    world.go(other, Vector2::zeros()).unwrap();
    assert!(world.pass(60), "they have stopped");
    world.drive(door, 0, 1.0).unwrap();
    assert!(!world.pass(60), "a motor drives");
    assert_eq!(world.ticks(), before + 60);
}

/// Coming to rest ends, at the latest with all held where they are; a copy in the midst of it goes on alike.
#[test]
fn coming_to_rest_ends() {
    let (mut world, things) = falling(9);
    let (mut progress, mut copy) = (RestProgress::default(), None);
    let mut steps = 0;
    while world.step_awake(&mut progress) {
        steps += 1;
        assert_eq!(progress.steps(), steps);
        if steps == 50 {
            copy = Some((world.clone(), progress));
        }
    }
    assert!((50..=480).contains(&steps) && progress == RestProgress::default(), "{steps}");
    assert!(world.awake() == 0 && world.rests(&things));
    let (mut copy, mut progress) = copy.unwrap();
    while copy.step_awake(&mut progress) {}
    assert_eq!(copy.digest(), world.digest());
    // The ball would roll for another while.
    let ball = things[things.len() - 1];
    world.set_velocity(ball, Vector3::new(0.0, 0.0, 40.0), Vector3::zeros()).unwrap();
    let ticks = world.ticks();
    while world.step_awake(&mut progress) {}
    assert_eq!((world.role(ball), world.awake()), (Some(BodyRole::Hung), 0));
    assert!(world.ticks() - ticks >= 480);
}

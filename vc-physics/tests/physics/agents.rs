//! Bodies of agents: legs, hands, seats.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain, turned};
use nalgebra::{Point2, Point3, Vector2, Vector3};
use vc_graph::{Asset, Bounds, Draft, NodeId, Pose, Relation};
use vc_physics::{
    AgentError, BodyPlan, BodyRole, Floor, FloorOptions, Hand, PhysicsError, PhysicsWorld, Posture, ShapeCache,
    ShutDoors, SpotOrder, SpotSearch, WalkState,
};

fn position(world: &PhysicsWorld, id: NodeId) -> Vector3<f32> {
    world.pose(id).unwrap().translation.vector
}

#[test]
fn walking_at_speed_and_stopping() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.follow(me, &[Point2::new(3.0, 0.0), Point2::new(3.0, 2.0)], false).unwrap();
    world.run(60);
    assert!((position(&world, me).x - 1.2).abs() < 0.05, "{:?}", position(&world, me));
    world.run(60 * 4);
    let end = position(&world, me);
    assert!((end - Vector3::new(3.0, 2.0, 0.0)).norm() < 0.06, "{end:?}");
    assert_eq!(world.agent(me).unwrap().walk(), WalkState::Still);
    // It faces the direction in which it walked.
    assert!((world.pose(me).unwrap().rotation * Vector3::x()).y > 0.99);
    world.go(me, Vector2::new(-100.0, 0.0)).unwrap();
    world.run(60);
    assert!((position(&world, me).x - 0.0).abs() < 0.15, "no faster than it runs");
    world.go(me, Vector2::zeros()).unwrap();
    let still = world.pose(me);
    world.run(60);
    assert!((world.pose(me).unwrap().translation.vector - still.unwrap().translation.vector).norm() < 0.02);
}

#[test]
fn who_is_put_on_a_rug_stands_on_it() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let mut lying = |class: &str, half: [f32; 3], pose: Pose| {
        let asset = scene.solid(class, block(half), scene.wood);
        scene.add(class, asset, pose)
    };
    let rug = lying("rug", [1.0, 0.7, 0.007], at(0.0, 0.0, 0.007));
    let table = lying("table", [0.3, 0.3, 0.2], at(0.6, 0.3, 0.214));
    let bar = lying("chocolate", [0.08, 0.04, 0.005], at(0.6, 0.3, 0.419));
    let me = scene.agent(at(3.0, 0.0, 0.0));
    let mut world = scene.world();
    world.run(120);
    let before = [rug, table, bar].map(|id| position(&world, id));
    world.teleport(me, at(0.0, -0.3, 0.0)).unwrap();
    assert!((position(&world, me).z - 0.014).abs() < 0.002, "{:?}", position(&world, me));
    world.run(120);
    for (id, was) in [rug, table, bar].into_iter().zip(before) {
        assert!((position(&world, id) - was).norm() < 0.002, "{id} was at {was:?}, is at {:?}", position(&world, id));
    }
}

#[test]
fn walls_stairs_and_slopes() {
    let mut scene = Scene::default();
    scene.floor(20.0, 0.5);
    scene.wall([2.0, -2.0, 0.0], [2.2, 2.0, 2.6]);
    for i in 0..5 {
        let (near, up) = (-1.0 - 0.3 * i as f32, 0.17 * (i + 1) as f32);
        scene.wall([-4.0, 3.0, 0.0], [near, 5.0, up]);
    }
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let climber = scene.agent(at(0.0, 4.0, 0.0));
    let mut world = scene.world();
    world.go(me, Vector2::new(1.2, 0.0)).unwrap();
    world.go(climber, Vector2::new(-1.0, 0.0)).unwrap();
    world.run(200);
    let p = position(&world, me);
    assert!(p.x < 1.81 && p.x > 1.7, "it stops at the wall: {p:?}");
    let p = position(&world, climber);
    assert!((p.z - 0.85).abs() < 0.05 && p.x < -2.2, "it climbs the stairs: {p:?}");
    world.run(200);
    assert!(position(&world, climber).z.abs() < 0.05, "and comes down behind");
}

/// A slope of less than forty degrees is climbed; a steeper one, or a step of thirty centimetres, is not.
#[test]
fn what_is_too_steep_or_too_high() {
    let ends = [0.5, 0.9].map(|slope: f32| {
        let mut scene = Scene::default();
        scene.floor(20.0, 0.9);
        let ramp = scene.solid("ramp", block([4.0, 1.0, 0.1]), scene.wood);
        let (sin, cos) = slope.sin_cos();
        // The ramp's upper side begins at the floor, a metre ahead.
        let middle = Vector3::new(1.0 + 4.0 * cos + 0.1 * sin, 0.0, 4.0 * sin - 0.1 * cos);
        scene.add("floor", ramp, turned(middle.x, 0.0, middle.z, Vector3::y(), -slope));
        let me = scene.agent(at(0.0, 0.0, 0.0));
        let mut world = scene.world();
        world.go(me, Vector2::new(1.2, 0.0)).unwrap();
        world.run(180);
        position(&world, me)
    });
    assert!(ends[0].z > 0.5, "it climbs: {:?}", ends[0]);
    assert!(ends[1].z < 0.25, "it does not: {:?}", ends[1]);

    let mut scene = Scene::default();
    scene.floor(20.0, 0.5);
    scene.wall([1.0, -2.0, 0.0], [5.0, 2.0, 0.3]);
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.go(me, Vector2::new(1.2, 0.0)).unwrap();
    world.run(180);
    let p = position(&world, me);
    assert!(p.x < 0.85 && p.z < 0.05, "{p:?}");
}

#[test]
fn jumping_and_landing() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.run(10);
    let ground = position(&world, me).z;
    // Walking does not hold the agent down.
    world.go(me, Vector2::new(1.0, 0.0)).unwrap();
    world.jump(me).unwrap();
    let mut highest: f32 = 0.0;
    for _ in 0..60 {
        world.step();
        highest = highest.max(position(&world, me).z - ground);
        // In the air there is nothing to jump from.
        world.jump(me).unwrap();
        if highest > 0.1 && (position(&world, me).z - ground).abs() < 0.02 {
            break;
        }
    }
    assert!((highest - 0.4).abs() < 0.05, "{highest}");
    world.run(60);
    assert!((position(&world, me).z - ground).abs() < 0.45, "it came down");
    assert!(matches!(world.jump(NodeId(999)), Err(AgentError::NoSuchAgent(_))));
}

#[test]
fn pushing_has_limits() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let light = scene.cube(0.15, at(1.0, 0.0, 0.15));
    let stone = scene.library.add_material(common::material("stone", 2500.0, 0.5, 0.0)).unwrap();
    let rock = scene.solid("rock", block([0.2, 1.0, 0.2]), stone);
    let rock = scene.add("toy", rock, at(1.0, 3.0, 0.2));
    let (a, b) = (scene.agent(at(0.0, 0.0, 0.0)), scene.agent(at(0.0, 3.0, 0.0)));
    let mut world = scene.world();
    world.run(30);
    world.go(a, Vector2::new(1.0, 0.0)).unwrap();
    world.go(b, Vector2::new(1.0, 0.0)).unwrap();
    world.run(150);
    assert!(position(&world, light).x > 1.3, "16 kg are pushed: {:?}", position(&world, light));
    assert!((position(&world, rock).x - 1.0).abs() < 0.02, "160 kg are not");
    assert!(position(&world, b).x < 0.7);
}

#[test]
fn taking_carrying_and_putting_down() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let table = scene.table(at(0.7, 0.0, 0.0));
    let tray = scene.solid("tray", block([0.15, 0.2, 0.01]), scene.wood);
    let tray = scene.add("tray", tray, at(0.5, 0.0, 0.751));
    let cup = scene.cube(0.04, at(0.5, 0.1, 0.802));
    let far = scene.cube(0.05, at(5.0, 0.0, 0.05));
    let heavy = scene.solid("heavy", block([0.25, 0.2, 0.2]), scene.wood);
    let heavy = scene.add("toy", heavy, at(0.0, 0.7, 0.2));
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.settle(200);
    let reach: Vec<NodeId> = world.agent(me).unwrap().in_reach().into_iter().map(|(id, _)| id).collect();
    assert!(reach.contains(&tray) && reach.contains(&cup) && !reach.contains(&far), "{reach:?}");
    assert!(matches!(world.grab(me, Hand::Right, far), Err(AgentError::OutOfReach { .. })));
    assert!(matches!(world.grab(me, Hand::Right, heavy), Err(AgentError::TooHeavy { .. })));
    assert!(matches!(world.grab(me, Hand::Right, NodeId(999)), Err(AgentError::World(PhysicsError::NoBody(_)))));
    world.grab(me, Hand::Right, tray).unwrap();
    assert_eq!((world.held(me, Hand::Right), world.role(cup)), (Some(tray), Some(BodyRole::Carried)));
    assert!(matches!(world.grab(me, Hand::Right, heavy), Err(AgentError::HandFull { .. })));
    assert_eq!(world.grab(me, Hand::Left, tray), Err(AgentError::Held(tray)));
    let between = position(&world, cup) - position(&world, tray);
    world.follow(me, &[Point2::new(-2.0, 0.0), Point2::new(-2.0, 2.0)], false).unwrap();
    world.run(300);
    assert!((position(&world, me) - Vector3::new(-2.0, 2.0, 0.0)).norm() < 0.1, "carrying does not hinder");
    // The cup on the tray came along and turned with it.
    let now = position(&world, cup) - position(&world, tray);
    assert!((now.norm() - between.norm()).abs() < 1e-3 && (now.z - between.z).abs() < 1e-3);
    assert!(position(&world, tray).z > 0.8);
    // Back to the table, and down.
    world.follow(me, &[Point2::new(-2.0, 0.0), Point2::new(0.05, 0.0)], false).unwrap();
    world.run(300);
    let near = SpotOrder::Near(Point3::new(0.4, 0.0, 0.75));
    let spot = SpotSearch::new(tray, table, false).order(near).find(&world).unwrap().unwrap();
    assert!(matches!(
        world.put(me, Hand::Right, at(0.7, 0.0, 0.72)),
        Err(AgentError::World(PhysicsError::Overlap { .. }))
    ));
    assert!(matches!(world.put(me, Hand::Right, at(5.0, 5.0, 1.0)), Err(AgentError::OutOfReach { .. })));
    assert_eq!(world.put(me, Hand::Right, spot).unwrap(), tray);
    assert_eq!(world.held(me, Hand::Right), None);
    let report = world.settle(200);
    assert!(report.at_rest && report.fell.is_empty(), "{report:?}");
    assert_eq!((world.supports(tray), world.supports(cup)), (vec![table], vec![tray]));
    assert_eq!(world.put(me, Hand::Right, spot), Err(AgentError::HandEmpty(me)));
}

/// Carried things touch nothing: cubes that one is swept through stay in place.
#[test]
fn what_is_held_pushes_nothing() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    scene.table(at(0.9, 0.0, 0.3));
    let cubes: Vec<_> = (0..5).map(|i| scene.cube(0.05, at(0.6, 0.2 * i as f32 - 0.4, 1.09))).collect();
    let toy = scene.cube(0.08, at(0.4, -1.5, 0.08));
    let me = scene.agent(at(0.2, -1.5, 0.0));
    let mut world = scene.world();
    world.settle(100);
    world.grab(me, Hand::Right, toy).unwrap();
    world.follow(me, &[Point2::new(0.2, 1.5)], false).unwrap();
    let before: Vec<_> = cubes.iter().map(|c| world.pose(*c)).collect();
    world.run(300);
    assert_eq!(world.agent(me).unwrap().walk(), WalkState::Still);
    assert_eq!(cubes.iter().map(|c| world.pose(*c)).collect::<Vec<_>>(), before);
}

#[test]
fn dropping() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let toy = scene.cube(0.05, at(0.4, 0.0, 0.05));
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    world.settle(100);
    world.grab(me, Hand::Left, toy).unwrap();
    world.run(10);
    assert!(position(&world, toy).z > 0.9);
    world.drop(me, Hand::Left).unwrap();
    assert_eq!(world.body(toy).unwrap().velocity(), Vector3::zeros());
    assert!(world.settle(200).at_rest);
    assert!((position(&world, toy).z - 0.05).abs() < 0.01);
    // If a thing is removed from the world while it is held, the hand is empty.
    world.grab(me, Hand::Left, toy).unwrap();
    world.remove(toy).unwrap();
    assert_eq!(world.held(me, Hand::Left), None);
}

/// Things that are held by the graph are in the hand.
#[test]
fn held_in_the_graph() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let toy = scene.cube(0.05, at(4.0, 0.0, 0.05));
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut edit = scene.builder.edit();
    edit.hold(me, toy).unwrap();
    edit.commit();
    let graph = scene.graph();
    assert!(graph.related(me, Relation::HoldsRight).any(|id| id == toy));
    let world = PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap();
    assert_eq!(world.holder(toy), Some((me, Hand::Right)));
    assert!(position(&world, toy).x < 1.0);
}

/// A sofa with three seats 2 m ahead, its front towards the origin.
fn sofa(scene: &mut Scene) -> NodeId {
    let w = scene.wood;
    let parts = vec![
        part("seat", block([0.3, 0.8, 0.2]), at(0.0, 0.0, 0.2), w),
        part("back", block([0.1, 0.8, 0.4]), at(-0.4, 0.0, 0.4), w),
    ];
    let surfaces = vec![common::surface("seat", vc_graph::asset::Hold::On, [0.0, 0.0, 0.4], (0.3, 0.75), None)];
    let sofa = scene.asset(Asset { name: "sofa".into(), parts, surfaces, ..Asset::default() });
    scene.add("sofa", sofa, turned(2.0, 0.0, 0.0, Vector3::z(), std::f32::consts::PI))
}

#[test]
fn sitting_lying_and_getting_up() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let sofa = sofa(&mut scene);
    let people: Vec<_> = (0..4).map(|i| scene.agent(at(1.0, 0.7 * i as f32 - 1.0, 0.0))).collect();
    let mut world = scene.world();
    world.run(5);
    assert_eq!(world.body(sofa).unwrap().seats().len(), 3);
    for &person in &people[..3] {
        world.sit(person, sofa, None).unwrap();
    }
    assert_eq!(world.sit(people[3], sofa, None), Err(AgentError::SeatTaken(sofa)));
    let places: Vec<_> = people[..3].iter().map(|p| position(&world, *p)).collect();
    assert!(places.iter().all(|p| (p.z - 0.4).abs() < 1e-4 && (p.x - 2.0).abs() < 1e-4), "{places:?}");
    assert!(matches!(world.posture(people[0]), Some(Posture::Sitting(on, _)) if on == sofa));
    assert!(world.go(people[0], Vector2::x()).is_err(), "who sits does not walk");
    // The sofa's front faces -X, so they get up on that side.
    world.run(20);
    world.stand_up(people[0]).unwrap();
    let p = position(&world, people[0]);
    assert!(p.x < 1.7 && p.z.abs() < 0.01, "{p:?}");
    assert_eq!(world.stand_up(people[0]).unwrap_err(), AgentError::Posture { agent: people[0], posture: "standing" });
    for &person in &people[1..3] {
        world.stand_up(person).unwrap();
    }
    world.teleport(people[3], at(0.2, 0.0, 0.0)).unwrap();
    assert!(matches!(world.lie(people[3], sofa), Err(AgentError::OutOfReach { .. })));
    world.teleport(people[3], at(1.2, 0.0, 0.0)).unwrap();
    world.lie(people[3], sofa).unwrap();
    assert!(matches!(world.posture(people[3]), Some(Posture::Lying(on, 0)) if on == sofa));
    let p = position(&world, people[3]);
    assert!((p - Vector3::new(2.0, 0.0, 0.4)).norm() < 1e-4, "{p:?}");
    world.stand_up(people[3]).unwrap();
    assert!(position(&world, people[3]).z.abs() < 0.01);
}

/// An agent sits beside a box and upon a cushion; if only places with boxes are free, an error says so.
#[test]
fn seats_that_are_covered() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let sofa = sofa(&mut scene);
    let cushion = scene.library.add_material(common::material("down", 20.0, 0.5, 0.0)).unwrap();
    let cushion = scene.solid("cushion", block([0.15, 0.15, 0.15]), cushion);
    scene.add("cushion", cushion, at(2.0, 0.5, 0.551));
    let boxes = [0.0, -0.5].map(|y| scene.cube(0.15, at(2.0, y, 0.551)));
    let people: Vec<_> = (0..2).map(|i| scene.agent(at(1.2, -0.5 + 0.6 * i as f32, 0.0))).collect();
    let mut world = scene.world();
    world.settle(200);
    world.sit(people[0], sofa, None).unwrap();
    assert!((position(&world, people[0]).y - 0.5).abs() < 0.05, "on the cushion: {:?}", world.pose(people[0]));
    let refused = AgentError::SeatCovered { seat: sofa, by: boxes[0] };
    assert_eq!(world.sit(people[1], sofa, None), Err(refused));
    world.place(boxes[0], at(0.0, 3.0, 0.151)).unwrap();
    world.settle(200);
    world.sit(people[1], sofa, None).unwrap();
    assert!(position(&world, people[1]).y.abs() < 0.05);
}

/// Nobody sits where somebody lies, nor lies where somebody sits.
#[test]
fn a_body_that_lies_takes_the_seats() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let sofa = sofa(&mut scene);
    let people: Vec<_> = (0..2).map(|i| scene.agent(at(1.2, -0.5 + 0.6 * i as f32, 0.0))).collect();
    let mut world = scene.world();
    world.settle(200);
    let feet = world.pose(people[0]).unwrap();
    world.lie(people[0], sofa).unwrap();
    assert_eq!(world.sit(people[1], sofa, None), Err(AgentError::SeatTaken(sofa)));
    world.teleport(people[0], feet).unwrap();
    world.sit(people[1], sofa, None).unwrap();
    assert_eq!(world.lie(people[0], sofa), Err(AgentError::SeatTaken(sofa)));
}

/// Nobody walks through a sitting agent.
#[test]
fn who_sits_is_in_the_way() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let stool = scene.solid("stool", block([0.15, 0.15, 0.05]), scene.wood);
    let stool = scene.add("stool", stool, at(0.0, 0.0, 0.05));
    let (sitter, walker) = (scene.agent(at(0.5, 0.5, 0.0)), scene.agent(at(-2.0, 0.0, 0.0)));
    let mut world = scene.world();
    world.sit(sitter, stool, None).unwrap();
    world.go(walker, Vector2::new(1.0, 0.0)).unwrap();
    let mut least = f32::MAX;
    for _ in 0..240 {
        world.step();
        least = least.min((position(&world, walker) - position(&world, sitter)).xy().norm());
    }
    assert!(least > 0.38, "as near as {least} m");
}

/// An agent that is walled in on all sides cannot get up.
#[test]
fn no_exit() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let stool = scene.solid("stool", block([0.2, 0.2, 0.22]), scene.wood);
    let stool = scene.add("stool", stool, at(0.0, 0.0, 0.22));
    for (low, high) in [
        ([-0.5, -0.5, 0.0], [-0.4, 0.5, 2.0]),
        ([0.4, -0.5, 0.0], [0.5, 0.5, 2.0]),
        ([-0.4, -0.5, 0.0], [0.4, -0.4, 2.0]),
        ([-0.4, 0.4, 0.0], [0.4, 0.5, 2.0]),
    ] {
        scene.wall(low, high);
    }
    let me = scene.agent(at(1.0, 0.0, 0.0));
    let mut world = scene.world();
    world.sit(me, stool, None).unwrap();
    assert_eq!(world.stand_up(me), Err(AgentError::NoExit(stool)));
}

/// Two agents that meet in a doorway, or in a narrow corridor, both get through.
#[test]
fn people_meet_where_it_is_narrow() {
    for (half_width, length) in [(0.42, 0.1), (0.6, 3.0)] {
        let mut scene = Scene::default();
        scene.floor(10.0, 0.5);
        scene.wall([-length / 2.0, half_width, 0.0], [length / 2.0, 6.0, 2.5]);
        scene.wall([-length / 2.0, -6.0, 0.0], [length / 2.0, -half_width, 2.5]);
        let people = [scene.agent(at(-3.0, 0.0, 0.0)), scene.agent(at(3.0, 0.0, 0.0))];
        let mut world = scene.world();
        for (person, x) in people.iter().zip([3.0, -3.0]) {
            world.follow(*person, &[Point2::new(x, 0.0)], false).unwrap();
        }
        world.run(1500);
        for (person, x) in people.iter().zip([3.0, -3.0]) {
            let p = position(&world, *person);
            assert!((p.x - x).abs() < 0.1, "{half_width}: {p:?}, {:?}", world.agent(*person).unwrap().walk());
        }
    }
}

/// Six agents change places across a room without touching.
#[test]
fn people_walk_past_each_other() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let corners = [(3.0, 0.0), (-3.0, 0.1), (0.1, 3.0), (0.0, -3.0), (2.1, 2.1), (-2.1, -2.2)];
    let people: Vec<_> = corners.iter().map(|&(x, y)| scene.agent(at(x, y, 0.0))).collect();
    let mut world = scene.world();
    for (person, (x, y)) in people.iter().zip(corners) {
        world.follow(*person, &[Point2::new(-x, -y)], false).unwrap();
    }
    let mut least = f32::MAX;
    for _ in 0..900 {
        world.step();
        for (i, a) in people.iter().enumerate() {
            for b in &people[..i] {
                least = least.min((position(&world, *a) - position(&world, *b)).norm());
            }
        }
    }
    assert!(least > 0.39, "they came as near as {least} m");
    for (person, (x, y)) in people.iter().zip(corners) {
        assert_eq!(world.agent(*person).unwrap().walk(), WalkState::Still);
        let p = position(&world, *person);
        assert!((p.xy() - Vector2::new(-x, -y)).norm() < 0.1, "{p:?}");
    }
}

/// Walking over time and moving at once have the same result.
#[test]
fn walking_and_being_there_end_the_same() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    scene.table(at(0.0, 0.0, 0.0));
    let me = scene.agent(at(-2.0, 0.0, 0.0));
    let toy = scene.cube(0.05, at(2.0, 0.5, 0.05));
    let mut walking = scene.world();
    walking.settle(100);
    let mut jumping = walking.clone();
    let floor = Floor::new(&walking, FloorOptions::default());
    let stand = floor.standing_pose(&walking, &BodyPlan::default(), Point2::new(-2.0, 0.0), toy).unwrap().unwrap();
    assert!(stand.route.length > 2.9);
    walking.follow(me, &stand.route.points, true).unwrap();
    while walking.agent(me).unwrap().walk() == WalkState::Walking {
        walking.step();
    }
    jumping.teleport(me, stand.feet).unwrap();
    jumping.step();
    let (a, b): (Pose, Pose) = (walking.pose(me).unwrap(), jumping.pose(me).unwrap());
    assert!((a.translation.vector - b.translation.vector).norm() < 0.05, "{a} {b}");
    for world in [&mut walking, &mut jumping] {
        assert!(floor.sees(world, &BodyPlan::default(), &world.pose(me).unwrap(), toy));
        world.grab(me, Hand::Right, toy).unwrap();
    }
}

/// An agent, a closed door, and a cube beside it.
fn beside_a_door() -> (PhysicsWorld, NodeId, NodeId) {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let me = scene.agent(at(3.0, 3.0, 0.0));
    let door = scene.door_asset();
    let door = scene.add("door", door, at(0.0, 0.0, 0.0));
    scene.cube(0.2, at(-0.5, 0.0, 0.2));
    (scene.world(), me, door)
}

/// The positions that a door does not sweep, however far it is open.
#[test]
fn clear_of_a_door_that_swings() {
    let (mut world, me, door) = beside_a_door();
    let clear = |world: &PhysicsWorld, x: f32, y: f32, open: &[f32]| {
        world.standing(me, &at(x, y, 0.0)).unwrap().is_free_with_open(door, open)
    };
    // In the door's way, but at neither its start nor its end.
    assert_eq!(clear(&world, 0.5, 0.0, &[0.0]), Ok(true));
    assert_eq!(clear(&world, 0.5, 0.0, &[0.5]), Ok(false));
    assert_eq!(clear(&world, 0.5, -0.2, &[1.0]), Ok(true));
    assert_eq!(clear(&world, 0.5, 0.0, &[0.0, 0.5, 1.0]), Ok(false));
    assert_eq!(clear(&world, 0.4, -1.0, &[0.0, 0.5, 1.0]), Ok(true));
    // Other things count at any position of the door.
    assert_eq!(clear(&world, -0.5, 0.0, &[0.0]), Ok(false));
    // The door counts at the queried position, not at its present one.
    world.put_open(door, None, 1.0).unwrap();
    assert!(!world.standing(me, &at(0.5, 0.4, 0.0)).unwrap().is_free());
    assert_eq!(clear(&world, 0.5, 0.4, &[0.0]), Ok(true));
    assert_eq!(clear(&world, 0.5, 0.4, &[1.0]), Ok(false));
    let nobody = NodeId(77);
    let there = at(0.5, 0.0, 0.0);
    assert_eq!(world.standing(nobody, &there).map(drop), Err(AgentError::NoSuchAgent(nobody)));
    assert!(world.standing(me, &there).unwrap().is_free_with_open(nobody, &[0.0]).is_err());
}

#[test]
fn agents_refuse_nonsense() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let me = scene.agent(at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    let nobody = NodeId(77);
    assert_eq!(world.go(nobody, Vector2::x()), Err(AgentError::NoSuchAgent(nobody)));
    assert!(world.go(me, Vector2::new(f32::NAN, 0.0)).is_err());
    assert!(world.follow(me, &[Point2::new(f32::INFINITY, 0.0)], false).is_err());
    let odd = BodyPlan { height: -1.0, ..BodyPlan::default() };
    assert!(world.add_agent(NodeId(5), odd, at(0.0, 0.0, 0.0)).is_err());
    assert!(world.add_agent(me, BodyPlan::default(), at(0.0, 0.0, 0.0)).is_err());
    let boxed = Draft::new("cup").bounds(Bounds::standing(Vector3::repeat(0.1)));
    assert_eq!(boxed.pose, None);
}

/// An open door gives way to an approaching agent; a wall does not.
#[test]
fn open_doors_give_way() {
    let (mut world, me, door) = beside_a_door();
    let aside = |world: &PhysicsWorld, x: f32, y: f32, shut: ShutDoors| {
        world.standing(me, &at(x, y, 0.0)).unwrap().parts_to_move_aside(shut)
    };
    let is_free = |world: &PhysicsWorld| world.standing(me, &at(0.5, 0.4, 0.0)).unwrap().is_free();
    assert_eq!(aside(&world, 0.5, 0.4, ShutDoors::Stay), Some(Vec::new()));
    world.put_open(door, None, 1.0).unwrap();
    assert!(!is_free(&world));
    let parts = aside(&world, 0.5, 0.4, ShutDoors::Stay).unwrap();
    assert!(matches!(parts[..], [(id, 0, open)] if id == door && open > 0.05 && open < 1.0), "{parts:?}");
    parts.iter().try_for_each(|(id, part, open)| world.put_open(*id, Some(*part), *open)).unwrap();
    assert!(is_free(&world));
    assert_eq!(aside(&world, -0.5, 0.0, ShutDoors::Stay), None);
    // A closed door opens to let somebody in only if it may.
    world.put_open(door, None, 0.0).unwrap();
    assert_eq!(aside(&world, 0.0, 0.0, ShutDoors::Stay), None);
    assert!(world.standing(NodeId(77), &at(0.0, 0.0, 0.0)).is_err());
}

/// Whoever sits on a thing that is removed stands beside it, and what was pinned to it falls.
#[test]
fn what_is_on_a_removed_thing_comes_off_it() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let stool = scene.solid("stool", block([0.2, 0.2, 0.22]), scene.wood);
    let stool = scene.add("stool", stool, at(0.0, 0.0, 0.22));
    let (me, toy) = (scene.agent(at(0.6, 0.0, 0.0)), scene.cube(0.05, at(0.0, 1.0, 1.5)));
    let mut world = scene.world();
    world.sit(me, stool, None).unwrap();
    world.pin(toy, Some(stool)).unwrap();
    world.run(30);
    assert!((position(&world, toy).z - 1.5).abs() < 1e-3);
    world.remove(stool).unwrap();
    assert_eq!(world.posture(me), Some(Posture::Standing));
    assert!(position(&world, me).xy().norm() > 0.4, "beside the seat");
    world.settle(300);
    assert!(position(&world, toy).z < 0.1 && position(&world, me).z < 0.02);
}

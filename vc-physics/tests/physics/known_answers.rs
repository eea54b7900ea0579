//! Physics problems with known answers.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, material, part, plain, turned};
use nalgebra::{Point3, Vector3};
use vc_graph::Asset;
use vc_graph::asset::{Joint, JointKind, Shape};
use vc_physics::{FixedThings, PhysicsWorld, Settings, VehicleControls, VehiclePlan};

#[test]
fn free_fall() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let ball = scene.ball(0.1, at(0.0, 0.0, 10.0));
    let mut world = scene.world();
    world.run(60);
    // Symplectic Euler falls g/2 dt t farther than the parabola.
    let fallen = 10.0 - world.pose(ball).unwrap().translation.z;
    assert!((fallen - 4.905).abs() < 0.1, "{fallen}");
    let speed = -world.body(ball).unwrap().velocity().z;
    assert!((speed - 9.81).abs() < 0.01, "{speed}");
}

/// A box on a slope moves if and only if the slope is steeper than friction allows.
#[test]
fn slope_at_the_friction_angle() {
    let moved = |friction: f32, angle: f32| {
        let mut scene = Scene::default();
        let stuff = scene.library.add_material(material("stuff", 500.0, friction, 0.0)).unwrap();
        let slab = scene.solid("slab", block([5.0, 2.0, 0.1]), stuff);
        let slab = scene.add("floor", slab, turned(0.0, 0.0, 0.0, Vector3::y(), angle));
        let cube = scene.solid("cube", block([0.1, 0.1, 0.1]), stuff);
        let lifted = turned(0.0, 0.0, 0.0, Vector3::y(), angle) * at(0.0, 0.0, 0.2005);
        let cube = scene.add("toy", cube, lifted);
        let mut world = scene.world();
        world.run(120);
        let _ = slab;
        (world.pose(cube).unwrap().translation.vector - lifted.translation.vector).norm()
    };
    for friction in [0.3_f32, 0.5, 0.8] {
        let steepest = friction.atan();
        assert!(moved(friction, steepest - 0.04) < 0.03, "slides too early at {friction}");
        assert!(moved(friction, steepest + 0.04) > 0.1, "sticks too long at {friction}");
    }
}

/// A tall stool tips over once its centre of mass is beyond the outer edge of its feet, with four legs or six.
#[test]
fn what_stands_on_legs_tips_over_their_edge() {
    let lean = |feet: &[(f32, f32)], angle: f32| {
        let mut scene = Scene::default();
        let rough = scene.library.add_material(material("rough", 500.0, 0.9, 0.0)).unwrap();
        let slab = scene.solid("slab", block([5.0, 2.0, 0.1]), rough);
        scene.add("floor", slab, turned(0.0, 0.0, 0.0, Vector3::y(), angle));
        let leg = |&(x, y): &(f32, f32)| part("leg", block([0.02, 0.02, 0.2]), at(x, y, 0.2), rough);
        let mut parts: Vec<_> = feet.iter().map(leg).collect();
        parts.push(part("seat", block([0.16, 0.16, 0.1]), at(0.0, 0.0, 0.5), rough));
        let stool = scene.asset(Asset { name: "stool".into(), parts, ..Asset::default() });
        let tilt = turned(0.0, 0.0, 0.0, Vector3::y(), angle);
        let stool = scene.add("stool", stool, tilt * at(0.0, 0.0, 0.1002));
        let mut world = scene.world();
        world.run(240);
        (world.pose(stool).unwrap().rotation.inverse() * tilt.rotation).angle()
    };
    let square = [(0.14, 0.14), (0.14, -0.14), (-0.14, 0.14), (-0.14, -0.14)];
    let six = [(0.14, 0.08), (0.0, 0.16), (-0.14, 0.08), (-0.14, -0.08), (0.0, -0.16), (0.14, -0.08)];
    for (feet, legs) in [(&square[..], 4.0_f32), (&six[..], 6.0)] {
        // Volumes: a leg of 0.00064 m3 at 0.2 m, the seat of 0.02048 at 0.5.
        let (leg, seat) = (0.00064 * legs, 0.02048);
        let height = (leg * 0.2 + seat * 0.5) / (leg + seat);
        let steepest = (0.16 / height).atan();
        assert!(lean(feet, steepest - 0.03) < 0.02, "{legs} legs tip too early");
        assert!(lean(feet, steepest + 0.03) > 0.2, "{legs} legs stand too long");
    }
}

/// A ball rolls until rolling resistance, 0.02 of its weight, has stopped it: for a solid sphere the
/// deceleration is 5/7 of that.
#[test]
fn a_ball_rolls_to_a_stop() {
    let mut scene = Scene::default();
    scene.floor(10.0, 0.5);
    let ball = scene.ball(0.1, at(0.0, 0.0, 0.1));
    let mut world = scene.world();
    world.set_velocity(ball, Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 10.0, 0.0)).unwrap();
    assert!(world.settle(600).at_rest);
    let distance = world.pose(ball).unwrap().translation.x;
    let expected = 1.0 / (2.0 * 0.02 * 9.81 * 5.0 / 7.0);
    assert!((distance / expected - 1.0).abs() < 0.1, "{distance} m, should be {expected} m");
}

#[test]
fn a_stack_of_ten_rests() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let cubes: Vec<_> = (0..10).map(|i| scene.cube(0.1, at(0.0, 0.0, 0.101 + 0.201 * i as f32))).collect();
    let mut world = scene.world();
    let report = world.settle(300);
    assert!(report.at_rest && report.fell.is_empty() && report.overlapping.is_empty(), "{report:?}");
    // The engine lets bodies overlap by up to 5 mm.
    let mut below = -0.1;
    for (i, cube) in cubes.iter().enumerate() {
        let p = world.pose(*cube).unwrap().translation;
        assert!((p.z - below - 0.2).abs() < 0.006 && p.x.hypot(p.y) < 0.01, "{i}: {p}");
        below = p.z;
    }
    assert_eq!(world.supports(cubes[5]), [cubes[4]]);
}

/// A leaf one metre high that hangs from a horizontal hinge.
fn flap(scene: &mut Scene) -> vc_graph::NodeId {
    let joint =
        Joint { kind: JointKind::Hinge, anchor: Point3::new(0.0, 0.0, 2.0), axis: Vector3::y(), limits: (-1.5, 1.5) };
    let mut leaf = part("leaf", block([0.02, 0.4, 0.5]), at(0.0, 0.0, 1.5), scene.wood);
    leaf.joint = Some(joint);
    let beam = part("beam", block([0.1, 0.5, 0.05]), at(0.0, 0.0, 2.05), scene.wood);
    let flap = scene.asset(Asset { name: "flap".into(), parts: vec![beam, leaf], ..Asset::default() });
    scene.add("door", flap, at(0.0, 0.0, 0.0))
}

/// The leaf swings with the period of its pendulum.
#[test]
fn period_of_a_pendulum_door() {
    let mut scene = Scene::default();
    let flap = flap(&mut scene);
    let settings = Settings { balanced: false, latches: false, hinge_friction: 0.0, substeps: 4, ..plain() };
    let mut world = scene.world_with(settings);
    world.put_open(flap, Some(0), 0.1).unwrap();
    let start = world.parts(flap).all()[0].position;
    // Small swings: 2 pi sqrt(I / (m g d)), with the inertia around the hinge.
    let (height, thick, arm) = (1.0_f32, 0.04_f32, 0.5_f32);
    let inertia = (height * height + thick * thick) / 12.0 + arm * arm;
    let period = std::f32::consts::TAU * (inertia / (9.81 * arm)).sqrt();
    let (mut crossings, mut before) = (Vec::new(), start);
    for step in 0..600 {
        world.step();
        let now = world.parts(flap).all()[0].position;
        if before > 0.0 && now <= 0.0 {
            crossings.push(step as f32 + before / (before - now));
        }
        before = now;
    }
    let measured = (crossings[4] - crossings[0]) / 4.0 / 60.0;
    assert!((measured / period - 1.0).abs() < 0.02, "{measured} s, should be {period} s");
}

/// Under a friction torque M each swing to the other side ends 2 M / (m g d) short of the last one.
#[test]
fn friction_of_a_pendulum_door() {
    let mut scene = Scene::default();
    let flap = flap(&mut scene);
    let friction = 0.05;
    let settings = Settings { balanced: false, latches: false, hinge_friction: friction, substeps: 4, ..plain() };
    let mut world = scene.world_with(settings);
    world.put_open(flap, Some(0), 0.6).unwrap();
    let position = |world: &PhysicsWorld| world.parts(flap).all()[0].position;
    let (mut ends, mut before) = (vec![position(&world)], [position(&world); 2]);
    for _ in 0..600 {
        world.step();
        let now = position(&world);
        if (before[1] - before[0]) * (now - before[1]) < 0.0 && ends.len() < 6 {
            ends.push(before[1]);
        }
        before = [before[1], now];
    }
    // For larger swings the weight's torque goes with the sine: energies are compared.
    let (arm, gravity) = (0.5_f32, 9.81_f32);
    for pair in ends.windows(2) {
        let energy = |angle: f32| gravity * arm * (1.0 - angle.cos());
        let (lost, way) = (energy(pair[0]) - energy(pair[1]), (pair[0] - pair[1]).abs());
        assert!((lost / (friction * way) - 1.0).abs() < 0.15, "{ends:?}: {lost} J/kg over {way} rad");
    }
    assert!(ends.len() > 4, "{ends:?}");
}

/// A drawer pulled hard stops at its limits, both ways.
#[test]
fn a_drawer_at_its_limits() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let chest = scene.chest_asset();
    let chest = scene.add("kitchen_cabinet", chest, at(0.0, 0.0, 0.0));
    let mut world = scene.world();
    for (open, expected) in [(1.0, 0.3), (0.0, 0.0), (0.5, 0.15)] {
        world.drive(chest, 0, open).unwrap();
        for _ in 0..240 {
            world.step();
            let position = world.parts(chest).all()[0].position;
            assert!((-0.005..=0.305).contains(&position), "{position}");
        }
        let position = world.parts(chest).all()[0].position;
        assert!((position - expected).abs() < 0.005, "{position}, should be {expected}");
    }
    assert_eq!(world.awake(), 0);
}

/// A block of 600 kg/m3 floats with six tenths of its height below the water.
#[test]
fn depth_of_a_floating_block() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let stone = scene.library.add_material(material("stone", 2500.0, 0.5, 0.0)).unwrap();
    let block_asset = scene.solid("block", block([0.2, 0.2, 0.1]), scene.wood);
    let wood = scene.add("toy", block_asset, at(0.0, 0.0, 1.2));
    let rock_asset = scene.solid("rock", Shape::Sphere { radius: 0.1 }, stone);
    let rock = scene.add("toy", rock_asset, at(1.0, 0.0, 1.5));
    let light = scene.library.add_material(material("rubber", 100.0, 0.5, 0.0)).unwrap();
    let ball_asset = scene.solid("ball", Shape::Sphere { radius: 0.12 }, light);
    let ball = scene.add("ball", ball_asset, at(-1.0, 0.0, 0.3));
    let mut world = scene.world();
    let pool = vc_graph::Aabb { min: Point3::new(-3.0, -3.0, 0.0), max: Point3::new(3.0, 3.0, 1.0) };
    world.add_water(&pool).unwrap();
    let mut highest = f32::MIN;
    for _ in 0..1200 {
        world.step();
        highest = highest.max(world.pose(ball).unwrap().translation.z);
    }
    assert!(world.body(rock).unwrap().is_asleep(), "what has sunk comes to rest");
    assert!(
        world.body(wood).unwrap().is_asleep() && world.body(ball).unwrap().is_asleep(),
        "so does what floats, within twenty seconds"
    );
    // 0.6 of 0.2 m is below: the middle is 0.02 m below the surface.
    let middle = world.pose(wood).unwrap().translation.z;
    assert!((middle - 0.98).abs() < 0.003, "{middle}");
    assert!(world.pose(rock).unwrap().translation.z < 0.11, "a stone sinks");
    // The ball came up, bobbed, and floats with a tenth of its volume below the surface.
    let depth = |share: f32| {
        // Height h of a cap with a share of the volume: h^2 (3 r - h) / (4 r^3) = share.
        let (mut low, mut high) = (0.0_f32, 0.24_f32);
        for _ in 0..40 {
            let h = f32::midpoint(low, high);
            if h * h * (0.36 - h) / (4.0 * 0.12_f32.powi(3)) < share { low = h } else { high = h }
        }
        low
    };
    let expected = 1.0 - depth(0.1) + 0.12;
    let ball = world.pose(ball).unwrap().translation.z;
    assert!((ball - expected).abs() < 0.01, "{ball}, should be {expected}");
    assert!(highest > expected + 0.005 && highest < 1.6, "it bobs: {highest}");
}

/// Momentum is conserved when two balls collide on a level floor.
#[test]
fn momentum_of_a_collision() {
    let mut scene = Scene::default();
    let bouncy = scene.library.add_material(material("bouncy", 800.0, 0.0, 1.0)).unwrap();
    let small = scene.solid("small", Shape::Sphere { radius: 0.1 }, bouncy);
    let large = scene.solid("large", Shape::Sphere { radius: 0.15 }, bouncy);
    let (a, b) = (scene.add("ball", small, at(0.0, 0.0, 5.0)), scene.add("ball", large, at(1.0, 0.0, 5.0)));
    let mut world = scene.world_with(Settings { gravity: 0.0, ..plain() });
    world.set_velocity(a, Vector3::new(3.0, 0.0, 0.0), Vector3::zeros()).unwrap();
    let (ma, mb) = (world.body(a).unwrap().mass(), world.body(b).unwrap().mass());
    assert!((mb / ma - 3.375).abs() < 1e-3);
    world.run(60);
    let (va, vb) = (world.body(a).unwrap().velocity().x, world.body(b).unwrap().velocity().x);
    assert!((ma * va + mb * vb - ma * 3.0).abs() < ma * 3.0 * 0.01, "{va} {vb}");
    // Elastic: v_b = 2 m_a / (m_a + m_b) v.
    assert!((vb - 2.0 / 4.375 * 3.0).abs() < 0.15, "{vb}");
}

/// A stone sinks at its terminal speed: `2 (m - rho V) g = rho A c v^2`.
#[test]
fn speed_of_a_sinking_stone() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let stone = scene.library.add_material(material("granite", 2600.0, 0.5, 0.0)).unwrap();
    let stone = scene.solid("stone", block([0.05; 3]), stone);
    let stone = scene.add("toy", stone, at(0.0, 0.0, 40.0));
    let mut world = scene.world();
    world.add_water(&vc_graph::Aabb { min: [-5.0, -5.0, 0.0].into(), max: [5.0, 5.0, 45.0].into() }).unwrap();
    world.run(240);
    let speed = -world.body(stone).unwrap().velocity().z;
    let expected = (2.0_f32 * 0.001 * 1600.0 * 9.81 / (1000.0 * 0.01)).sqrt();
    assert!((speed / expected - 1.0).abs() < 0.1, "{speed} m/s, should be {expected} m/s");
}

fn car(scene: &mut Scene, mass: f32) -> vc_graph::NodeId {
    let density = mass / (4.2 * 1.7 * 0.6);
    let steel = scene.library.add_material(material("car", density, 0.5, 0.0)).unwrap();
    let body = part("body", block([2.1, 0.85, 0.3]), at(0.0, 0.0, 0.5), steel);
    let asset = scene.asset(Asset { name: "car".into(), parts: vec![body], ..Asset::default() });
    scene.add("car", asset, at(0.0, 0.0, 0.0))
}

/// With tyres whose grip is 0.8 of its weight, a car stops from v within v^2 / (2 mu g).
#[test]
fn stopping_distance_of_a_car() {
    let mut scene = Scene::default();
    scene.floor(200.0, 0.9);
    let car = car(&mut scene, 1300.0);
    let mut world = scene.world();
    let plan = VehiclePlan { grip: 0.8, ..VehiclePlan::car(1300.0, 2.6, 1.5, 0.32, 0.32) };
    world.add_vehicle(car, &plan).unwrap();
    world.run(120);
    let height = world.pose(car).unwrap().translation.z;
    assert!(height.abs() < 0.05, "it stands on its springs: {height}");
    world.steer(car, VehicleControls { throttle: 1.0, ..VehicleControls::default() }).unwrap();
    while world.vehicle(car).unwrap().speed() < 15.0 {
        world.step();
        assert!(world.time() < 20.0, "{}", world.vehicle(car).unwrap().speed());
    }
    world.steer(car, VehicleControls { brake: 1.0, ..VehicleControls::default() }).unwrap();
    let (v, from) = (world.vehicle(car).unwrap().speed(), world.pose(car).unwrap().translation.x);
    while world.vehicle(car).unwrap().speed() > 0.05 && world.time() < 40.0 {
        world.step();
    }
    let distance = world.pose(car).unwrap().translation.x - from;
    let expected = v * v / (2.0 * 0.8 * 9.81);
    assert!((distance / expected - 1.0).abs() < 0.1, "{distance} m, should be {expected} m");
    world.run(120);
    assert!((world.pose(car).unwrap().translation.x - from - distance).abs() < 0.1, "it stands");
}

/// Released from its stand, a car bounces at the frequency of its springs, and each bounce is lower than the
/// last in accordance with its dampers.
#[test]
fn springs_and_dampers_of_a_car() {
    let mut scene = Scene::default();
    scene.floor(50.0, 0.9);
    let car = car(&mut scene, 1300.0);
    let mut world = scene.world_with(Settings { substeps: 4, ..plain() });
    world.add_vehicle(car, &VehiclePlan::car(1300.0, 2.6, 1.5, 0.32, 0.32)).unwrap();
    world.run(240);
    let height = |world: &PhysicsWorld| world.pose(car).unwrap().translation.z;
    let rest = height(&world);
    world.place(car, at(0.0, 0.0, rest - 0.06)).unwrap();
    let (mut crossings, mut peaks, mut before) = (Vec::new(), Vec::new(), [-0.06_f32; 2]);
    for step in 0..240 {
        world.step();
        let now = height(&world) - rest;
        if before[1] < 0.0 && now >= 0.0 {
            crossings.push(step as f32 - now / (now - before[1]));
        }
        if before[1] > before[0] && now < before[1] {
            peaks.push(before[1]);
        }
        before = [before[1], now];
    }
    // 1.5 Hz and 0.3 of the critical damping.
    let damped = 1.5 * (1.0_f32 - 0.09).sqrt();
    let measured = 60.0 / (crossings[1] - crossings[0]);
    assert!((measured / damped - 1.0).abs() < 0.1, "{measured} Hz, should be {damped} Hz");
    let decay = (-std::f32::consts::PI * 0.3 / (1.0_f32 - 0.09).sqrt()).exp();
    assert!((peaks[0] / (0.06 * decay) - 1.0).abs() < 0.25, "{peaks:?}, the first should be {}", 0.06 * decay);
}

#[test]
fn a_car_turns_and_climbs_a_ramp() {
    let mut scene = Scene::default();
    scene.floor(200.0, 0.9);
    let car = car(&mut scene, 1300.0);
    let ramp = scene.solid("ramp", block([10.0, 4.0, 0.1]), scene.wood);
    scene.add("floor", ramp, turned(16.0, 0.0, 0.9, Vector3::y(), -0.1));
    let mut world = scene.world();
    world.add_vehicle(car, &VehiclePlan::car(1300.0, 2.6, 1.5, 0.32, 0.32)).unwrap();
    world.run(60);
    let before = world.clone();
    world.steer(car, VehicleControls { throttle: 0.6, ..VehicleControls::default() }).unwrap();
    world.run(240);
    let p = world.pose(car).unwrap().translation;
    assert!(p.x > 8.0 && p.z > 0.3 && p.y.abs() < 0.3, "{p}");
    // With X forward, left is positive Y.
    let mut left = before;
    left.steer(car, VehicleControls { throttle: 0.3, steering: 0.5, ..VehicleControls::default() }).unwrap();
    left.run(120);
    assert!(left.pose(car).unwrap().translation.y > 0.3, "{:?}", left.pose(car));
    assert_eq!(left.vehicle(car).unwrap().wheels().len(), 4);
}

/// One drop test for each shape whose axis differs in the engine.
#[test]
fn shapes_stand_upright() {
    let shapes = [
        (Shape::Cylinder { radius: 0.1, half_height: 0.3 }, 0.3),
        (Shape::Cone { radius: 0.2, half_height: 0.2 }, 0.2),
        (Shape::Capsule { radius: 0.1, half_height: 0.2 }, 0.3),
        (Shape::Extrusion { outline: vec![(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)], height: 0.5 }, 0.0),
        (Shape::Lathe { profile: vec![(0.2, 0.0), (0.2, 0.4), (0.18, 0.4), (0.18, 0.02)] }, 0.0),
    ];
    for (shape, height) in shapes {
        let mut scene = Scene::default();
        scene.floor(3.0, 0.6);
        let name = format!("{shape:?}");
        let asset = scene.solid("thing", shape.clone(), scene.wood);
        let id = scene.add("toy", asset, at(0.0, 0.0, height + 0.05));
        let mut world = scene.world_with(Settings { fixing: FixedThings::Structure, ..plain() });
        world.run(20);
        let (low, high) = shape.extent();
        let aabb = world.aabb(id).unwrap();
        assert!(((aabb.max.z - aabb.min.z) - (high.z - low.z)).abs() < 0.01, "{name}: {aabb:?}");
        assert!(aabb.min.z.abs() < 0.006, "{name}: {aabb:?}");
    }
}

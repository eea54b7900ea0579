//! Water in containers that are filled, emptied, moved, rotated and removed.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, surface, turned};
use nalgebra::Vector3;
use vc_graph::asset::Hold;
use vc_graph::{Asset, NodeId, Pose};
use vc_physics::PhysicsWorld;

/// A bath of five boards, 0.8 by 1.6 m, half a metre deep.
fn bath(scene: &mut Scene, pose: Pose) -> NodeId {
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
    scene.add("bathtub", bath, pose)
}

fn height(world: &PhysicsWorld, id: NodeId) -> f32 {
    world.pose(id).unwrap().translation.z
}

#[test]
fn fill_levels() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let bath = bath(&mut scene, at(0.0, 0.0, 0.0));
    let duck = scene.ball(0.06, at(0.0, 0.0, 0.11));
    let mut world = scene.world();
    world.settle(200);
    assert_eq!(world.body(bath).unwrap().level(), 0.0);
    world.fill(bath, 0.6).unwrap();
    assert_eq!((world.body(bath).unwrap().level(), world.waters().len()), (0.6, 1));
    world.settle(1200);
    let z = height(&world, duck);
    assert!(z > 0.32 && z < 0.36, "the duck floats: {z}");
    world.fill(bath, 0.0).unwrap();
    world.wake(duck).unwrap();
    world.settle(400);
    assert!(height(&world, duck) < 0.11 && world.waters().is_empty());
    assert!(world.fill(duck, f32::NAN).is_err());
}

/// Things below a filled basin, or beside a rotated one, stay dry.
#[test]
fn water_is_only_in_its_basin() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let high = bath(&mut scene, at(0.0, 0.0, 0.7));
    let aslant = bath(&mut scene, turned(3.0, 0.0, 0.0, Vector3::z(), std::f32::consts::FRAC_PI_4));
    let under = scene.ball(0.06, at(0.0, 0.0, 0.06));
    // Within the bounding box of the rotated bath, but outside of the bath.
    let beside = scene.ball(0.06, at(3.6, 0.6, 0.06));
    let within = scene.ball(0.06, at(3.0 - 0.35, 0.35, 0.2));
    let mut world = scene.world();
    world.settle(200);
    for bath in [high, aslant] {
        world.fill(bath, 0.8).unwrap();
    }
    let dry = [under, beside];
    dry.iter().for_each(|id| world.wake(*id).unwrap());
    world.settle(1200);
    for id in dry {
        assert!(height(&world, id) < 0.07, "{:?}", world.pose(id));
    }
    assert!((height(&world, within) - 0.44).abs() < 0.03, "it floats: {:?}", world.pose(within));
}

/// Water moves with its basin, and is removed with it.
#[test]
fn water_stays_with_its_basin() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let bath = bath(&mut scene, at(0.0, 0.0, 0.0));
    let ball = scene.ball(0.06, at(0.0, 0.0, 0.2));
    let mut world = scene.world();
    world.fill(bath, 0.8).unwrap();
    world.settle(1200);
    assert!(height(&world, ball) > 0.4);
    world.place(bath, at(3.0, 0.0, 0.0)).unwrap();
    let water = world.waters()[0];
    assert!((water.centre().x - 3.0).abs() < 1e-4 && world.waters().len() == 1, "{water:?}");
    world.remove(bath).unwrap();
    assert!(world.waters().is_empty());
    world.wake(ball).unwrap();
    world.settle(400);
    assert!(height(&world, ball) < 0.07);
}

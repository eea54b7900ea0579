//! Every graspable object, dropped: it comes to rest, and falls through no floor. A small sample here; all of
//! them in `proofs/dropped`.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use virtualcity::graph::{Bounds, ClassTable, Draft, NodeId, Pose, Property, SceneBuilder, Seed};
use virtualcity::physics::{PhysicsWorld, Settings, ShapeCache};
use virtualcity::shapes::material;
use virtualcity::shapes::object::{Generator, generator, generators};

/// Steps per second.
const SECOND: u32 = 60;

/// The conditions of a drop.
struct Fall {
    /// Least height of its lowest point above the floor, and thickness of the floor, metres.
    height: f32,
    thick: f32,
    /// Seconds within which it must come to rest.
    patience: u32,
}

/// Graspable objects are at rest five seconds after a release just above a floor, in any orientation.
const LET_GO: Fall = Fall { height: 0.01, thick: 0.1, patience: 5 };
/// From two storeys up onto a floor as thin as a board.
const THROWN_DOWN: Fall = Fall { height: 5.0, thick: 0.01, patience: 10 };

fn carried() -> Vec<&'static Generator> {
    let table = ClassTable::builtin();
    let carried = |g: &&Generator| table.get(g.class).is_some_and(|c| c.affordances.contains(Property::Graspable));
    generators().filter(carried).collect()
}

/// A world with randomly oriented instances of a class above a floor.
fn dropped(of: &'static Generator, seeds: u64, fall: &Fall) -> (PhysicsWorld, Vec<NodeId>) {
    let (mut library, mut scene) = (material::library(), SceneBuilder::new("drop"));
    let slab = Bounds::standing([30.0, 30.0, fall.thick].into());
    scene.add(Draft::new("floor").at(Pose::translation(0.0, 0.0, -fall.thick)).bounds(slab)).unwrap();
    let mut things = Vec::new();
    for seed in 0..seeds {
        let made = of.instance(Seed(7), seed as usize).object;
        let mut rng = Seed(seed).child(of.class).stream();
        let axis = Vector3::from_fn(|_, _| rng.between(-1.0, 1.0));
        let turn = UnitQuaternion::from_axis_angle(
            &nalgebra::Unit::new_normalize(axis),
            rng.between(0.0, std::f32::consts::TAU),
        );
        let at = Vector3::new(2.5 * seed as f32 - 11.25, 0.0, fall.height + made.size().norm());
        let asset = Some(library.add(made.asset).unwrap());
        let draft = Draft { asset, ..Draft::new(of.class).at(Pose::from_parts(at.into(), turn)).bounds(made.bounds) };
        things.push(scene.add(draft).unwrap());
    }
    scene.assets(Arc::new(library));
    (PhysicsWorld::build(&scene.build(), &ShapeCache::new(), Settings::default()).unwrap(), things)
}

/// The numbers of instances that are still awake, and of those below the floor.
fn faults(of: &'static Generator, seeds: u64, fall: &Fall) -> (usize, usize) {
    let (mut world, things) = dropped(of, seeds, fall);
    world.settle(fall.patience * SECOND);
    let below = |id: &&NodeId| world.body(**id).is_ok_and(|body| body.centre_of_mass().z < -fall.thick);
    (things.iter().filter(|id| !world.body(**id).unwrap().is_asleep()).count(), things.iter().filter(below).count())
}

/// Every thirtieth class, and some whose objects once rocked forever.
#[test]
fn what_is_carried_comes_to_rest() {
    let rocked = ["pizza", "sponge", "shrimp", "remote_control", "tortilla", "hamburger", "steak", "cake"];
    let rolled = ["billiard_cue", "barbell", "nail", "crayon", "soap_dish", "drinking_straw", "leaf_blower"];
    let sank_or_rocked = ["sausage", "rice_cooker", "laundry_basket"];
    let some = carried()
        .into_iter()
        .step_by(30)
        .chain(rocked.into_iter().chain(rolled).chain(sank_or_rocked).filter_map(generator));
    let all: Vec<_> = some.map(|g| (g.class, faults(g, 4, &LET_GO))).collect();
    let faults: Vec<_> = all.iter().filter(|(_, f)| *f != (0, 0)).collect();
    assert!(faults.is_empty(), "class, awake, below: {faults:?}");
}

#[test]
fn what_is_carried_goes_through_no_floor() {
    let some = carried().into_iter().step_by(30);
    let faults: Vec<_> = some.map(|g| (g.class, faults(g, 2, &THROWN_DOWN).1)).filter(|(_, f)| *f > 0).collect();
    assert!(faults.is_empty(), "class, below: {faults:?}");
}

/// Classes `FROM` to `FROM + COUNT`, ten instances each.
#[test]
#[ignore = "takes a minute: proofs/dropped"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn all_that_is_carried() {
    let number = |name: &str, other: usize| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(other);
    let (from, count) = (number("FROM", 0), number("COUNT", usize::MAX));
    let (mut things, mut awake, mut below) = (0, 0, 0);
    for g in carried().into_iter().skip(from).take(count) {
        let ((rest, _), (_, through)) = (faults(g, 10, &LET_GO), faults(g, 10, &THROWN_DOWN));
        if (rest, through) != (0, 0) {
            println!("  {}: {rest} of 10 awake, {through} of 10 below", g.class);
        }
        (things, awake, below) = (things + 10, awake + rest, below + through);
    }
    let to = from.saturating_add(things / 10);
    println!("classes {from} to {to} : {things} things, {awake} awake, {below} below");
    assert_eq!((awake, below), (0, 0));
}

/// Balls roll for metres, as real ones do, and come to rest.
#[test]
fn balls_roll() {
    for class in ["football", "basketball", "volleyball", "tennis_ball", "golf_ball", "bowling_ball", "ball"] {
        let (mut world, balls) = dropped(generator(class).unwrap(), 3, &LET_GO);
        world.settle(10 * SECOND);
        for id in balls {
            let (from, radius) = (world.body(id).unwrap().centre_of_mass(), world.body(id).unwrap().centre_of_mass().z);
            world.set_velocity(id, Vector3::y() * 1.5, Vector3::x() * (-1.5 / radius)).unwrap();
            world.settle(40 * SECOND);
            let way = (world.body(id).unwrap().centre_of_mass() - from).norm();
            assert!((1.5..25.0).contains(&way) && world.body(id).unwrap().is_asleep(), "{class}: {way:.2} m");
        }
    }
}

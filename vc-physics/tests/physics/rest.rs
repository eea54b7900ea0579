//! Coming to rest: hanging things, trembling things, and the report of settling.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use crate::common;

use common::{Scene, at, block, part, plain, surface, turned};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Hold, Shape};
use vc_graph::{Asset, NodeId, Place, Relation};
use vc_physics::{BodyRole, PhysicsWorld, Settings, ShapeCache, SpotSearch, UnsupportedThings};

/// A picture without a support hangs, if the graph states the supports of other things.
#[test]
fn what_hangs_stays_until_it_is_touched() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let picture = scene.cube(0.1, at(0.0, 0.0, 1.5));
    let toy = scene.cube(0.1, at(1.0, 0.0, 0.1));
    scene.builder.edit().place(toy, Place { relation: Relation::On, at: floor }).unwrap();
    let mut edit = scene.builder.edit();
    edit.place(toy, Place { relation: Relation::On, at: floor }).unwrap();
    edit.commit();
    let graph = scene.graph();
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), plain()).unwrap();
    assert_eq!((world.role(picture), world.role(toy)), (Some(BodyRole::Hung), Some(BodyRole::Loose)));
    assert!(world.settle(200).is_sound());
    assert!(world.pose(picture).unwrap().translation.z == 1.5);
    world.push(picture, Vector3::new(0.1, 0.0, 0.0), Point3::new(0.0, 0.0, 1.5)).unwrap();
    assert_eq!(world.settle(300).fell, [picture]);
    let falls = Settings { unplaced: UnsupportedThings::Falls, ..plain() };
    let mut world = PhysicsWorld::build(&graph, &ShapeCache::new(), falls).unwrap();
    assert_eq!(world.settle(300).fell, [picture]);
}

/// A coat on a hook hangs there, although the graph states its support; a coat that lies beside the hook does
/// not hang.
#[test]
fn what_is_on_a_hook_hangs() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let board = part("board", block([0.01, 0.4, 0.05]), at(0.0, 0.0, 1.6), scene.wood);
    let hook = surface("hook", Hold::Hook, [0.05, 0.2, 1.6], (0.0, 0.0), Some(1.2));
    let rack = scene.asset(Asset { name: "rack".into(), parts: vec![board], surfaces: vec![hook], ..Asset::default() });
    let rack = scene.add("wall_hook_rack", rack, turned(1.0, 1.0, 0.0, Vector3::z(), 0.5));
    let coat = scene.solid("coat", block([0.05, 0.2, 0.5]), scene.wood);
    let spot = turned(1.0, 1.0, 0.0, Vector3::z(), 0.5);
    let hangs = scene.add("coat", coat, spot * at(0.08, 0.2, 1.1));
    let falls = scene.add("coat", coat, spot * at(0.08, -0.3, 1.1));
    let mut edit = scene.builder.edit();
    for id in [hangs, falls] {
        edit.place(id, Place { relation: Relation::On, at: rack }).unwrap();
    }
    edit.commit();
    let mut world = scene.world();
    assert_eq!((world.role(hangs), world.role(falls)), (Some(BodyRole::Hung), Some(BodyRole::Loose)));
    assert_eq!(world.settle(400).fell, [falls]);
}

/// Things that are certainly at rest may sleep at once; a thing that is about to tip, or stands on such a
/// thing, may not.
#[test]
fn who_dozes_off() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let safe = scene.cube(0.05, at(0.0, 0.0, 0.79));
    let stacked = scene.cube(0.05, at(0.0, 0.0, 0.89));
    let edge = scene.cube(0.05, at(0.402, 0.3, 0.79));
    let burden = scene.cube(0.03, at(0.402, 0.3, 0.87));
    let mut world = scene.world();
    world.run(3);
    world.put_to_sleep();
    world.step();
    let asleep = [safe, stacked, edge, burden].map(|id| world.body(id).unwrap().is_asleep());
    assert_eq!(asleep, [true, true, false, false]);
    // Nothing has been stopped: the thing falls in time.
    assert_eq!(world.settle(400).fell, [edge, burden]);
    assert_eq!(world.supports(safe), [table]);
}

/// A pinned thing stays where it is, at no cost, until it is pushed.
#[test]
fn what_is_pinned_stays() {
    let mut scene = Scene::default();
    let floor = scene.floor(5.0, 0.5);
    let cube = scene.cube(0.05, at(0.0, 0.0, 1.0));
    let mut world = scene.world();
    world.pin(cube, None).unwrap();
    world.settle(100);
    assert_eq!((world.role(cube), world.pose(cube).unwrap().translation.z), (Some(BodyRole::Hung), 1.0));
    world.push(cube, Vector3::new(0.01, 0.0, 0.0), Point3::new(0.0, 0.0, 1.0)).unwrap();
    assert_eq!((world.settle(300).fell, world.role(cube)), (vec![cube], Some(BodyRole::Loose)));
    assert!(world.pin(floor, None).is_err());
}

/// Light things on small feet come to rest and stay where they are.
#[test]
fn small_things_do_not_tremble() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let bottle = vec![(0.0, 0.0), (0.03, 0.0), (0.035, 0.02), (0.035, 0.14), (0.012, 0.2), (0.012, 0.24), (0.0, 0.24)];
    let cup = vec![(0.03, 0.0), (0.04, 0.09), (0.036, 0.09), (0.027, 0.005)];
    let plate = vec![(0.06, 0.0), (0.06, 0.004), (0.13, 0.02), (0.13, 0.024), (0.05, 0.006)];
    let mut things = Vec::new();
    for (i, profile) in [bottle, cup, plate].into_iter().enumerate() {
        let asset = scene.solid("turned", Shape::Lathe { profile }, scene.wood);
        for j in 0..6 {
            let spot = turned(0.4 * i as f32, 0.4 * j as f32, 0.002, Vector3::z(), 0.3 * j as f32);
            things.push((scene.add("toy", asset, spot), spot));
        }
    }
    let mut world = scene.world();
    let report = world.settle(120);
    assert!(report.at_rest && report.fell.is_empty(), "{report:?}");
    for (id, spot) in things {
        let moved = world.pose(id).unwrap().translation.vector - spot.translation.vector;
        assert!(moved.norm() < 0.01, "{moved:?}");
    }
}

#[test]
fn settle_tells_what_happened() {
    let mut scene = Scene::default();
    let floor = scene.floor(2.0, 0.5);
    scene.room([-2.0, -2.0], [2.0, 2.0]);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let still = scene.cube(0.05, at(0.0, 0.2, 0.791));
    let falls = scene.cube(0.05, at(0.0, 1.0, 0.9));
    let lost = scene.cube(0.05, at(5.0, 0.0, 0.5));
    let mut edit = scene.builder.edit();
    for id in [still, falls] {
        edit.place(id, Place { relation: Relation::On, at: table }).unwrap();
    }
    edit.place(lost, Place { relation: Relation::On, at: floor }).unwrap();
    edit.place(table, Place { relation: Relation::On, at: floor }).unwrap();
    edit.commit();
    let mut world = scene.world();
    let report = world.settle(150);
    assert!(!report.is_sound());
    assert_eq!(report.fell, [falls, lost]);
    let on = |at: NodeId| Place { relation: Relation::On, at };
    assert_eq!(report.left, [(falls, on(table)), (lost, on(floor))]);
    assert_eq!(report.outside, [lost]);
    assert!(report.moved.iter().all(|m| m.id != still));
    assert_eq!(world.supports(still), [table]);
    let contact = world.body(still).unwrap().contacts()[0];
    assert_eq!((contact.a, contact.b), (table, still));
    assert!(contact.normal.z > 0.99 && contact.point.z > 0.73 && contact.depth < 0.006, "{contact:?}");
}

/// A bowl holds an apple; a solid hull of it would not.
#[test]
fn bowls_are_hollow() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let profile = vec![(0.06, 0.0), (0.12, 0.08), (0.115, 0.08), (0.055, 0.008)];
    let bowl = scene.solid("bowl", Shape::Lathe { profile }, scene.wood);
    let bowl = scene.add("bowl", bowl, at(0.0, 0.0, 0.001));
    let apple = scene.ball(0.035, at(0.0, 0.0, 0.06));
    let mut world = scene.world();
    let report = world.settle(900);
    assert!(report.at_rest && report.overlapping.is_empty(), "{report:?}");
    let z = world.pose(apple).unwrap().translation.z;
    assert!(z > 0.035 && z < 0.055, "{z}");
    assert_eq!(world.supports(apple), [bowl]);
}

/// Two overlapping things are reported with their penetration depth.
#[test]
fn settle_tells_what_is_inside_what() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let cube = scene.cube(0.1, at(0.0, 0.0, 0.8));
    let mut world = scene.world();
    let report = world.settle(1);
    assert!(!report.is_sound());
    let (a, b, depth) = report.overlapping[0];
    assert_eq!((a, b), (table, cube));
    assert!(depth > 0.01 && depth < 0.05, "{depth}");
}

/// A thing that hovers a little is lowered and rests at once; a thing high up is not lowered.
#[test]
fn let_down_it_rests() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let table = scene.table(at(0.0, 0.0, 0.0));
    let low = scene.cube(0.05, at(0.1, 0.0, 1.0));
    let high = scene.cube(0.05, at(2.0, 0.0, 1.0));
    let mut world = scene.world();
    world.settle(300);
    let spot = SpotSearch::new(low, table, false).find(&world).unwrap().unwrap();
    world.place(low, at(0.0, 0.0, 0.01) * spot).unwrap();
    world.place(high, at(2.0, 0.0, 1.0)).unwrap();
    let by = world.lower(low, 0.02).unwrap();
    assert!((by - 0.0105).abs() < 0.0005, "{by}");
    assert_eq!(world.lower(high, 0.02).unwrap(), 0.0);
    assert!(world.lower(NodeId(77), 0.02).is_err());
    let is_at = |id, inside| world.body(id).unwrap().is_at(table, inside);
    assert!(is_at(low, false) && !is_at(low, true) && !is_at(high, false));
    world.step();
    world.put_to_sleep();
    world.step();
    assert!(world.body(low).unwrap().is_asleep() && !world.body(high).unwrap().is_asleep());
}

/// A board that leans on a wall sleeps again where it slept before, without another test.
#[test]
fn what_leans_sleeps_where_it_slept() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.8);
    scene.wall([0.5, -1.0, 0.0], [0.6, 1.0, 2.0]);
    let board = scene.solid("board", block([0.02, 0.2, 0.4]), scene.wood);
    let leaning = scene.add("painting", board, turned(0.3, 0.0, 0.4, Vector3::y(), 0.4));
    let mut world = scene.world();
    assert!(world.settle(600).at_rest);
    let rested = world.pose(leaning).unwrap();
    world.wake(leaning).unwrap();
    world.step();
    world.put_to_sleep();
    world.step();
    assert!(world.body(leaning).unwrap().is_asleep());
    // After it has been moved it does not.
    world.place(leaning, at(-0.01, 0.0, 0.0) * rested).unwrap();
    world.step();
    world.put_to_sleep();
    world.step();
    assert!(!world.body(leaning).unwrap().is_asleep());
}

/// A thing falls if the rack on which it hung is removed.
#[test]
fn what_hung_from_it_falls() {
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let hook = surface("hook", Hold::Hook, [0.05, 0.2, 1.6], (0.0, 0.0), Some(1.2));
    let board = part("board", block([0.01, 0.4, 0.05]), at(0.0, 0.0, 1.6), scene.wood);
    let rack = scene.asset(Asset { name: "rack".into(), parts: vec![board], surfaces: vec![hook], ..Asset::default() });
    let rack = scene.add("wall_hook_rack", rack, at(1.0, 1.0, 0.0));
    let coat = scene.solid("coat", block([0.05, 0.2, 0.5]), scene.wood);
    let coat = scene.add("coat", coat, at(1.08, 1.2, 1.1));
    let mut edit = scene.builder.edit();
    edit.place(coat, Place { relation: Relation::On, at: rack }).unwrap();
    edit.commit();
    let mut world = scene.world();
    world.settle(100);
    assert_eq!(world.role(coat), Some(BodyRole::Hung));
    world.remove(rack).unwrap();
    assert_eq!((world.settle(400).fell, world.role(coat)), (vec![coat], Some(BodyRole::Loose)));
}

/// A block whose bottom has eight corners comes to rest from any small tilt: it does not rock from side to side
/// for ever.
#[test]
fn flat_blocks_do_not_rock() {
    let corners = [(0.06, 0.03), (0.05, 0.04), (-0.05, 0.04), (-0.06, 0.03)];
    let points = corners.iter().flat_map(|&(x, y)| [(x, y), (-x, -y)]);
    let points = points.flat_map(|(x, y)| [0.0, 0.02].map(|z| Point3::new(x, y, z))).collect();
    let mut scene = Scene::default();
    scene.floor(5.0, 0.5);
    let sponge = scene.solid("sponge", Shape::Hull { points }, scene.wood);
    let tilts = (0..24).map(|i| {
        turned(
            0.2 * i as f32 - 2.4,
            0.0,
            0.01 + 0.002 * i as f32,
            Vector3::new(1.0, 0.3 * i as f32, 0.2),
            0.05 * i as f32,
        )
    });
    let things: Vec<NodeId> =
        tilts.collect::<Vec<_>>().into_iter().map(|pose| scene.add("sponge", sponge, pose)).collect();
    let mut world = scene.world();
    let report = world.settle(300);
    let awake: Vec<_> = things.into_iter().filter(|id| !world.body(*id).unwrap().is_asleep()).collect();
    assert!(report.at_rest, "{awake:?} of 24 are awake");
}

/// Things that are pinned while they are awake stay to the bit, step after step, and let what lies on them sleep.
#[test]
fn what_is_pinned_does_not_creep() {
    let mut scene = Scene::default();
    scene.floor(9.0, 0.5);
    let pair = |i: u8| {
        let (x, y, axis) = (f32::from(i / 16), f32::from(i % 16), Vector3::new(0.3, 0.5, f32::from(i)));
        let below = scene.cube(0.1, turned(x - 8.0, y - 8.0, 0.11, axis, 0.1 + 0.07 * f32::from(i)));
        scene.cube(0.05, at(x - 8.0, y - 8.0, 0.27));
        below
    };
    let below: Vec<NodeId> = (0..=255).map(pair).collect();
    let mut world = PhysicsWorld::build(&scene.graph(), &ShapeCache::new(), plain()).unwrap();
    world.run(5);
    below.iter().for_each(|id| world.pin(*id, None).unwrap());
    let poses = |world: &PhysicsWorld| below.iter().map(|id| world.pose(*id)).collect::<Vec<_>>();
    let pinned = poses(&world);
    for _ in 0..200 {
        world.step();
        assert_eq!(poses(&world), pinned);
    }
    assert_eq!(world.awake(), 0);
}

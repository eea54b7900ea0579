//! A door stands between two rooms, and each of its sides is lit by one of them.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material, part};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape};
use vc_graph::{Draft, NodeId, Pose, SceneGraph};
use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};

/// The lamps' light on the two sides of the wall: reddish and bluish.
const GLOW: [[f32; 3]; 2] = [[30.0, 10.0, 4.0], [4.0, 10.0, 30.0]];

/// Two rooms with a lamp each, a wall between them, and a closed door in it that belongs to the second room.
fn home() -> (SceneGraph, Vec<NodeId>) {
    home_with(|stage| {
        stage.one("door", block([0.02, 0.5, 1.0]), Pose::translation(0.0, 0.0, 1.0), 1);
    })
}

/// The same home with another door.
fn home_with(door: impl Fn(&mut Stage)) -> (SceneGraph, Vec<NodeId>) {
    let mut stage = Stage::new();
    let mut lamps = Vec::new();
    for (glow, side) in GLOW.into_iter().zip([-1.0, 1.0]) {
        if side > 0.0 {
            stage.room = stage.builder.add(Draft::new("kitchen")).unwrap();
        }
        let bulb = Material { emission: glow, ..material("bulb", [0.9; 3]) };
        let bulb = stage.library.add_material(bulb).unwrap();
        let mut slab = |class: &str, half: [f32; 3], at: [f32; 3]| {
            let asset = stage.asset(vec![part(class, block(half), [side * at[0], at[1], at[2]], 1)]);
            stage.put(class, asset, Pose::identity())
        };
        slab("floor", [1.5, 1.5, 0.05], [1.5, 0.0, -0.05]);
        slab("ceiling", [1.5, 1.5, 0.05], [1.5, 0.0, 2.55]);
        slab("wall", [0.05, 1.5, 1.25], [3.05, 0.0, 1.25]);
        slab("wall", [1.5, 0.05, 1.25], [1.5, 1.55, 1.25]);
        slab("wall", [1.5, 0.05, 1.25], [1.5, -1.55, 1.25]);
        // The wall around the door.
        slab("wall", [0.04, 0.5, 1.25], [0.04, 1.0, 1.25]);
        slab("wall", [0.04, 0.5, 1.25], [0.04, -1.0, 1.25]);
        slab("wall", [0.04, 0.5, 0.25], [0.04, 0.0, 2.25]);
        let at = Pose::translation(side * 1.5, 0.0, 2.2);
        lamps.push(stage.one("ceiling_lamp", Shape::Sphere { radius: 0.1 }, at, bulb));
    }
    door(&mut stage);
    (stage.build(), lamps)
}

#[test]
fn each_side_of_a_door_is_in_the_light_of_its_room() {
    let (graph, lamps) = home();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&graph).unwrap();
    lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
    let dark = Vector3::zeros();
    let night = Daylight { sun: dark, zenith: dark, horizon: dark, ground: dark, ..Daylight::noon() };
    let lighting = renderer.light(&snapshot, &night);
    let mut frame = Frame::new();
    for side in [-1.0, 1.0] {
        let camera =
            Camera::with_fov(16, 16, 0.3).looking(Point3::new(side * 2.0, 0.0, 1.2), Point3::new(0.0, 0.0, 1.0));
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        for [red, _, blue] in &frame.rgb {
            let (more, less) = if side < 0.0 { (red, blue) } else { (blue, red) };
            assert!(i32::from(*more) > i32::from(*less) + 20, "from side {side}: {red} red, {blue} blue");
        }
    }
}

/// A panelled door whose leaf is flush with one side of the wall: everything seen of it from either room is lit
/// by that room. Also, a room without any light of its own behind a closed door is dim, not black.
#[test]
fn a_panelled_door_is_in_the_light_of_the_room_it_is_seen_from() {
    let leaf = |stage: &mut Stage| {
        let frame = |half: [f32; 3], at: [f32; 3]| part("leaf", block(half), at, 1);
        let parts = vec![
            frame([0.02, 0.1, 1.0], [0.02, 0.4, 0.0]),
            frame([0.02, 0.1, 1.0], [0.02, -0.4, 0.0]),
            frame([0.02, 0.3, 0.1], [0.02, 0.0, 0.9]),
            frame([0.02, 0.3, 0.1], [0.02, 0.0, -0.9]),
            part("infill", block([0.005, 0.3, 0.8]), [0.02, 0.0, 0.0], 1),
        ];
        let asset = stage.asset(parts);
        stage.put("door", asset, Pose::translation(0.0, 0.0, 1.0));
    };
    let (graph, lamps) = home_with(leaf);
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&graph).unwrap();
    let dark = Vector3::zeros();
    let night = Daylight { sun: dark, zenith: dark, horizon: dark, ground: dark, ..Daylight::noon() };
    let mut frame = Frame::new();
    lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
    let lighting = renderer.light(&snapshot, &night);
    for side in [-1.0, 1.0] {
        let eye = Point3::new(side * 1.2, 0.8, 1.6);
        let camera = Camera::with_fov(64, 64, 0.7).looking(eye, Point3::new(0.0, 0.0, 1.0));
        let shot = Shot::new(&snapshot, &camera, Modality::Rgb | Modality::Class).lit(&lighting);
        renderer.render(&shot, &mut frame).unwrap();
        let door = |(_, class): &(&[u8; 3], &u16)| snapshot.class(**class).is_some_and(|class| &**class == "door");
        for ([red, _, blue], _) in frame.rgb.iter().zip(&frame.class).filter(door) {
            let (more, less) = if side < 0.0 { (red, blue) } else { (blue, red) };
            assert!(more > less, "from side {side}: {red} red, {blue} blue");
        }
    }
    snapshot.switch(lamps[0], false).unwrap();
    let lighting = renderer.light(&snapshot, &night);
    let camera = Camera::with_fov(32, 32, 1.2).looking(Point3::new(-0.5, 0.0, 1.5), Point3::new(-3.0, 0.3, 0.5));
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
    let mean = frame.rgb.iter().map(|c| u32::from(c[2])).sum::<u32>() / 1024;
    assert!((15..150).contains(&mean), "{mean} in the room whose lamp is off");
}

//! Cameras around objects, along paths and in rooms show what they should.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Shape;
use vc_render::{Camera, Frame, Modality, RenderError, Renderer, Shot};

#[test]
fn views_around_an_object_have_it_in_the_middle() {
    let mut stage = Stage::new();
    let node = stage.one("ball", Shape::Sphere { radius: 0.2 }, Pose::translation(1.0, -2.0, 0.7), 0);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let target = Point3::new(1.0, -2.0, 0.7);
    for elevation in [-0.4, 0.0, 0.5, 1.2] {
        let views = Camera::with_fov(65, 49, 0.6).around(target, 1.5, elevation, 7);
        let shots: Vec<_> =
            views.iter().map(|v| Shot::new(&snapshot, v, Modality::Instance | Modality::Distance)).collect();
        let mut frames: Vec<Frame> = shots.iter().map(|_| Frame::new()).collect();
        renderer.render_all(&shots, &mut frames).unwrap();
        for (i, (view, frame)) in views.iter().zip(&frames).enumerate() {
            let to = view.eye() - target;
            assert!((to.norm() - 1.5).abs() < 1e-5 && (to.z - 1.5 * f32::sin(elevation)).abs() < 1e-5);
            let turn = std::f32::consts::TAU * i as f32 / 7.0;
            assert!((to.x - 1.5 * elevation.cos() * turn.cos()).abs() < 1e-5);
            let middle = 24 * 65 + 32;
            assert_eq!(frame.instance[middle], node);
            assert!((frame.distance[middle] - 1.3).abs() < 5e-3, "{}", frame.distance[middle]);
        }
    }
    assert!(Camera::with_fov(8, 8, 1.0).around(target, 1.0, 0.0, 0).is_empty());
}

#[test]
fn views_along_a_way_are_even_and_turn_smoothly() {
    let camera = Camera::with_fov(8, 8, 1.0);
    let way = [[0.0, 0.0, 1.5], [3.0, 0.0, 1.5], [3.0, 4.0, 1.5], [1.0, 4.0, 2.5]].map(Point3::from);
    let views = camera.along(&way, 200);
    assert_eq!(views.len(), 200);
    let steps: Vec<f32> = views.windows(2).map(|v| (v[1].eye() - v[0].eye()).norm()).collect();
    let longest = steps.iter().copied().fold(0.0, f32::max);
    // A step across a cut corner is a little shorter.
    assert!(steps.iter().all(|s| *s > 0.9 * longest), "{steps:?}");
    let looks = |v: &Camera| v.unproject(4.0, 4.0, 1.0) - v.eye();
    let turns = views.windows(2).map(|v| looks(&v[0]).normalize().dot(&looks(&v[1]).normalize()).min(1.0).acos());
    let most = turns.fold(0.0, f32::max);
    assert!(most < 0.08, "the eye turns by {most} at once, of a quarter turn in all");
    // The views stay near the path: a corner is cut by no more than a quarter of its sides.
    assert!((views[0].eye() - way[0]).norm() < 1e-5);
    assert!((looks(&views[0]).normalize() - Vector3::x()).norm() < 1e-3);
    assert!(camera.along(&[], 5).is_empty() && camera.along(&way, 0).is_empty());
    assert_eq!(camera.along(&way, 1).len(), 1);
    let stood = camera.along(&way[..1], 3);
    assert!(stood.iter().all(|v| v.eye() == way[0] && (looks(v) - Vector3::x()).norm() < 1e-5));
    let waited = [way[0], way[1], way[1], way[2]];
    assert_eq!(camera.along(&waited, 9).len(), 9);
    camera.along(&[Point3::new(f32::NAN, 0.0, 0.0), Point3::origin()], 3);
}

#[test]
fn a_viewpoint_sees_more_of_its_room_than_others() {
    let mut stage = Stage::new();
    let size = vc_graph::Bounds::standing(Vector3::new(4.0, 4.0, 2.5));
    let den = stage.builder.add(vc_graph::Draft::new("bedroom").at(Pose::identity()).bounds(size)).unwrap();
    let tall = stage.asset(vec![common::part("board", block([0.8, 0.02, 1.2]), [0.0; 3], 0)]);
    let low = stage.asset(vec![common::part("box", block([0.1; 3]), [0.0; 3], 1)]);
    let mut put = |asset, at: [f32; 3]| {
        let draft = vc_graph::Draft { asset: Some(asset), ..vc_graph::Draft::new("thing") };
        stage.builder.add_in(den, draft.at(pose(at, 0.0, 0.0))).unwrap();
    };
    // A screen across the room: the things behind it are only visible from the far side.
    put(tall, [-0.9, 0.5, 1.2]);
    put(tall, [0.7, 0.5, 1.2]);
    for i in 0..10 {
        put(low, [0.3 * i as f32 - 1.4, 0.9, 0.2]);
    }
    let kitchen = stage.room;
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let wanted = Camera::with_fov(160, 120, 1.15);
    let view = renderer.viewpoint(&snapshot, den, &wanted).unwrap();
    assert!(view.eye().y > 0.5 && view.eye().coords.amax() < 2.0, "{}", view.eye());
    assert_eq!(Camera { pose: wanted.pose, centre: wanted.centre, ..view }, wanted);
    // Level, so that uprights are upright, with more of the floor than of the ceiling.
    assert!((view.pose.rotation * Vector3::z()).z.abs() < 1e-6);
    assert!(view.centre.0 == wanted.centre.0 && view.centre.1 < wanted.centre.1);
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &view, Modality::Boxes), &mut frame).unwrap();
    assert!(frame.boxes.len() >= 8, "{} things are seen", frame.boxes.len());
    for room in [kitchen, vc_graph::NodeId(77)] {
        assert_eq!(renderer.viewpoint(&snapshot, room, &wanted), Err(RenderError::NoRoom(room)));
    }
    let bad = Camera { width: 0, ..wanted };
    assert!(matches!(renderer.viewpoint(&snapshot, den, &bad), Err(RenderError::BadSize { .. })));
}

#[test]
fn a_viewpoint_sees_a_window() {
    for side in [-1.0, 1.0] {
        let mut stage = Stage::new();
        let size = vc_graph::Bounds::standing(Vector3::new(5.0, 4.0, 2.5));
        let den = stage.builder.add(vc_graph::Draft::new("bedroom").at(Pose::identity()).bounds(size)).unwrap();
        let wide = stage.asset(vec![common::part("board", block([0.02, 0.6, 0.6]), [0.0; 3], 0)]);
        let low = stage.asset(vec![common::part("box", block([0.1; 3]), [0.0; 3], 1)]);
        let mut put = |asset, class, at: [f32; 3]| {
            let draft = vc_graph::Draft { asset: Some(asset), ..vc_graph::Draft::new(class) };
            stage.builder.add_in(den, draft.at(pose(at, 0.0, 0.0))).unwrap()
        };
        // Everything looks the same from both sides, with a board as wide as the window at the other wall.
        let window = put(wide, "window", [side * 2.45, 0.0, 1.4]);
        put(wide, "painting", [side * -2.45, 0.0, 1.4]);
        for i in 0..8 {
            put(low, "thing", [0.4 * (i % 2) as f32 - 0.2, 0.4 * (i / 2) as f32 - 0.6, 0.1]);
        }
        let mut renderer = Renderer::new();
        let snapshot = renderer.snapshot(&stage.build()).unwrap();
        let view = renderer.viewpoint(&snapshot, den, &Camera::with_fov(160, 120, 1.15)).unwrap();
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &view, Modality::Instance), &mut frame).unwrap();
        let seen = frame.instance.iter().filter(|n| **n == window).count();
        assert!(seen > frame.instance.len() / 50, "{seen} pixels of the window from {}", view.eye());
    }
}

#[test]
fn a_viewpoint_is_in_no_cupboard() {
    let mut stage = Stage::new();
    let size = vc_graph::Bounds::standing(Vector3::new(2.4, 4.0, 2.5));
    let kitchen = stage.builder.add(vc_graph::Draft::new("kitchen").at(Pose::identity()).bounds(size)).unwrap();
    // Their fronts are a millimetre before the candidate eyes along the wall, too near to be seen.
    let cupboard = stage.asset(vec![common::part("board", block([0.15, 0.3, 0.4]), [0.0; 3], 0)]);
    let cup = stage.asset(vec![common::part("box", block([0.05; 3]), [0.0; 3], 1)]);
    let mut put = |asset, at: [f32; 3]| {
        let draft = vc_graph::Draft { asset: Some(asset), ..vc_graph::Draft::new("thing") };
        stage.builder.add_in(kitchen, draft.at(pose(at, 0.0, 0.0))).unwrap();
    };
    let hung: Vec<[f32; 3]> = (0..5).map(|i| [-1.049, 0.8 * i as f32 - 1.6, 1.5]).collect();
    hung.iter().for_each(|at| put(cupboard, *at));
    (0..60).for_each(|i| put(cup, [1.1, 0.2 * (i % 15) as f32 - 1.4, 0.7 + 0.2 * (i / 15) as f32]));
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let eye = renderer.viewpoint(&snapshot, kitchen, &Camera::with_fov(160, 120, 1.15)).unwrap().eye();
    let inside = |at: &&[f32; 3]| (eye.x - at[0]).abs() < 0.2 && (eye.y - at[1]).abs() < 0.35;
    assert!(!hung.iter().any(|at| inside(&at)), "the eye is at {eye}, in a cupboard");
}

#[test]
fn a_viewpoint_looks_along_a_narrow_hall() {
    let mut stage = Stage::new();
    let size = vc_graph::Bounds::standing(Vector3::new(6.0, 1.1, 2.5));
    let hall = stage.builder.add(vc_graph::Draft::new("hallway").at(Pose::identity()).bounds(size)).unwrap();
    let side = stage.asset(vec![common::part("wall", block([3.0, 0.05, 1.25]), [0.0; 3], 1)]);
    let end = stage.asset(vec![common::part("wall", block([0.05, 0.6, 1.25]), [0.0; 3], 1)]);
    let floor = stage.asset(vec![common::part("floor", block([3.0, 0.6, 0.05]), [0.0; 3], 0)]);
    let chest = stage.asset(vec![common::part("chest", block([0.2, 0.1, 0.4]), [0.0; 3], 0)]);
    let walls =
        [(side, [0.0, 0.6, 1.25]), (side, [0.0, -0.6, 1.25]), (end, [3.05, 0.0, 1.25]), (end, [-3.05, 0.0, 1.25])];
    for (asset, at) in walls.into_iter().chain([(floor, [0.0, 0.0, -0.05]), (chest, [0.5, 0.4, 0.4])]) {
        let draft = vc_graph::Draft { asset: Some(asset), ..vc_graph::Draft::new("thing") };
        stage.builder.add_in(hall, draft.at(pose(at, 0.0, 0.0))).unwrap();
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let view = renderer.viewpoint(&snapshot, hall, &Camera::with_fov(160, 120, 1.15)).unwrap();
    let looks = view.pose.rotation * Vector3::z();
    assert!(looks.x.abs() > 0.8 && looks.x * view.eye().x < -1.0, "from {} to {looks}", view.eye());
}

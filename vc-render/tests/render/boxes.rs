//! Oriented boxes, classes, points and cameras agree with the scene.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, cameras, furnished, pose};
use nalgebra::{Point3, Vector3, Vector4};
use vc_graph::asset::Shape;
use vc_graph::{Bounds, Draft, Pose, SceneBuilder, State};
use vc_render::{Camera, Daylight, Frame, Modalities, Modality, NO_LABEL, NOTHING, RenderError, Renderer, Shot};

#[test]
fn boxes_in_space_turn_with_things_and_grow_with_drawers() {
    let mut stage = Stage::new();
    let half = [0.3, 0.1, 0.2];
    let crate_pose = pose([2.0, 0.3, 0.4], 0.6, 0.3);
    let node = stage.one("crate", block(half), crate_pose, 0);
    stage.one("ball", Shape::Sphere { radius: 0.1 }, pose([1.0, -0.4, 0.4], 0.0, 0.0), 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let camera = Camera::with_fov(320, 240, 1.0).looking(Point3::new(0.0, 0.0, 0.6), Point3::new(2.0, 0.0, 0.4));
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes), &mut frame).unwrap();
    let label = frame.boxes.iter().find(|b| b.node == node).unwrap();
    assert!((label.oriented.half - Vector3::from(half)).norm() < 1e-5);
    let (mut low, mut high) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
    for corner in 0..8 {
        let sign = |axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
        let wanted = crate_pose * Point3::new(sign(0) * half[0], sign(1) * half[1], sign(2) * half[2]);
        assert!((label.oriented.corner(corner) - wanted).norm() < 1e-5, "corner {corner}");
        let (seen, wanted) = (label.oriented.corners[corner].unwrap(), camera.project(&wanted).unwrap());
        assert!((seen - wanted.xy()).norm() < 1e-2, "corner {corner} in the image");
        for axis in 0..2 {
            (low[axis], high[axis]) = (low[axis].min(seen[axis]), high[axis].max(seen[axis]));
        }
    }
    // A box is its own bounding box: its visible pixels are within its corners, up to the pixel these lie in.
    let amodal = label.amodal;
    assert!((amodal.x as f32 - low[0]).abs() < 1.0 && (amodal.y as f32 - low[1]).abs() < 1.0, "{amodal:?}");
    assert!(((amodal.x + amodal.width) as f32 - high[0]).abs() < 1.0);
    // The box of a ball has corners outside of the ball.
    assert!(frame.boxes.iter().any(|b| b.node != node && (b.oriented.half - Vector3::repeat(0.1)).norm() < 1e-3));
}

#[test]
fn corners_behind_the_camera_are_left_out_and_open_drawers_count() {
    let graph = furnished();
    let dresser = graph.nodes().find(|n| n.is(State::Open)).unwrap().id();
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&graph).unwrap();
    let camera = cameras(160, 120)[0];
    let mut frame = Frame::new();
    let mut length = |shut: bool| {
        snapshot.articulate(dresser, |j| Some(if shut { 0.0 } else { j.limits.1 })).unwrap();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes), &mut frame).unwrap();
        frame.boxes.iter().find(|b| b.node == dresser).unwrap().oriented.half.x
    };
    // It reaches from 0.25 behind to 0.02 + 0.2 + 0.3 in front; shut, the top is longest.
    let (open, shut) = (length(false), length(true));
    assert!((shut - 0.25).abs() < 1e-3 && (open - 0.385).abs() < 1e-3, "{shut} and {open}");
    let walls = frame.boxes.iter().filter(|b| b.oriented.corners.iter().any(Option::is_none)).count();
    assert!(walls >= 2, "{walls} boxes reach behind the camera");
}

#[test]
fn classes_are_those_of_nodes() {
    let graph = furnished();
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&graph).unwrap();
    let mut frame = Frame::new();
    let mut classes = std::collections::BTreeSet::new();
    for camera in cameras(96, 72) {
        let wanted = Modality::Instance | Modality::Class | Modality::Boxes;
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        for (node, class) in frame.instance.iter().zip(&frame.class) {
            match *node {
                NOTHING => assert_eq!(*class, NO_LABEL),
                node => assert_eq!(snapshot.class(*class), Some(graph.node(node).unwrap().class())),
            }
        }
        for label in &frame.boxes {
            assert_eq!(snapshot.class(label.class), Some(graph.node(label.node).unwrap().class()));
            classes.insert(label.class);
        }
    }
    assert!(classes.len() >= 8, "{classes:?}");
    assert_eq!(snapshot.class(NO_LABEL), None);
}

#[test]
fn points_are_what_the_camera_saw_and_matrices_take_them_back() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let skew = Camera::with_intrinsics(120, 90, (90.0, 110.0), (50.0, 48.5));
    let camera = skew.looking(Point3::new(-2.6, -2.2, 1.6), Point3::new(2.0, 1.0, 0.8));
    let wanted = Modality::Position | Modality::Depth | Modality::Distance | Modality::Instance;
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
    let (projection, extrinsics) = (camera.projection(), camera.extrinsics());
    let mut count = 0;
    for (i, point) in frame.points() {
        count += 1;
        let (x, y, depth) = ((i % 120) as f32 + 0.5, (i / 120) as f32 + 0.5, frame.depth[i]);
        let whole = Vector4::new(point.x, point.y, point.z, 1.0);
        let seen = projection * whole;
        assert!((seen.z - depth).abs() < 1e-4 * depth, "{} is not {depth}", seen.z);
        assert!((seen.x / seen.z - x).abs() < 0.01 && (seen.y / seen.z - y).abs() < 0.01);
        let own = extrinsics * whole;
        assert!((own.xyz().norm() - frame.distance[i]).abs() < 1e-4 * depth);
        assert!((camera.unproject(x, y, depth) - point).norm() < 1e-4 * depth);
        let again = camera.project(&point).unwrap();
        assert!((again - Point3::new(x, y, depth)).norm() < 0.02);
    }
    assert_eq!(count, frame.instance.iter().filter(|n| **n != NOTHING).count());
    assert!(count > 5000);
    // The extrinsics are the pose's inverse; a projection is the intrinsics after the extrinsics.
    assert!((camera.pose.to_homogeneous() * extrinsics - nalgebra::Matrix4::identity()).norm() < 1e-5);
    assert!((camera.intrinsics() * extrinsics.fixed_rows::<3>(0) - projection).norm() < 1e-3);
}

#[test]
fn several_cameras_in_one_call_are_as_one_after_the_other() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let mut cameras = cameras(96, 72);
    cameras.push(Camera::with_fov(50, 80, 1.4).overhead(Point3::new(0.0, 0.0, 0.0), 2.0));
    let shot = |camera| Shot::new(&snapshot, camera, Modalities::SIX).lit(&lighting).after(&snapshot, camera);
    let shots: Vec<Shot<'_>> = cameras.iter().map(shot).collect();
    let mut frames: Vec<Frame> = shots.iter().map(|_| Frame::new()).collect();
    renderer.render_all(&shots, &mut frames).unwrap();
    for (shot, frame) in shots.iter().zip(&frames) {
        let mut alone = Frame::new();
        renderer.render(shot, &mut alone).unwrap();
        assert!(alone.rgb == frame.rgb && alone.depth == frame.depth && alone.instance == frame.instance);
        assert!(alone.boxes == frame.boxes && alone.class == frame.class);
        let bitmaps = |f: &Frame| f.masks().map(|m| m.bitmap()).collect::<Vec<_>>();
        assert!(bitmaps(&alone) == bitmaps(frame));
    }
    let refused = renderer.render_all(&shots, &mut frames[1..]);
    assert_eq!(refused, Err(RenderError::FrameCount { shots: 5, frames: 4 }));
}

#[test]
fn lamps_are_told_by_their_class() {
    let mut stage = Stage::new();
    let made = ["floor_lamp", "candle", "lightbulb", "sofa", "tv"]
        .map(|class| stage.one(class, block([0.1; 3]), Pose::identity(), 3));
    let snapshot = Renderer::new().snapshot(&stage.build()).unwrap();
    assert_eq!(snapshot.lamps().collect::<Vec<_>>(), [made[0], made[2]]);
}

/// Class numbers of the things in front of the camera, by class.
fn numbers(classes: &[&str]) -> Vec<(String, u16)> {
    let mut scene = SceneBuilder::new("shelf");
    for (class, y) in classes.iter().zip([-0.6_f32, 0.0, 0.6]) {
        let bounds = Bounds::standing([0.3; 3].into());
        scene.add(Draft::new(*class).at(Pose::translation(2.0, y, -0.1)).bounds(bounds)).unwrap();
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene.build()).unwrap();
    let mut frame = Frame::new();
    let camera = Camera::with_fov(64, 48, 1.0);
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes), &mut frame).unwrap();
    let named = |label: &vc_render::BoxLabel| (snapshot.class(label.class).unwrap().to_string(), label.class);
    frame.boxes.iter().map(named).collect()
}

#[test]
fn a_class_has_one_number_whatever_the_scene() {
    let first = numbers(&["gizmo", "cup", "widget"]);
    let second = numbers(&["aardvark", "widget", "cup"]);
    assert_eq!((first.len(), second.len()), (3, 3));
    for (class, number) in &first {
        let others = second.iter().filter(|(name, other)| (name == class) != (other == number));
        assert_eq!(others.count(), 0, "{class} is {number}: {second:?}");
    }
    assert!(first.iter().all(|(class, number)| (class == "cup") == (*number < 1 << 15)));
}

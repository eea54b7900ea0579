//! Orientation of cameras: what lies at the borders of their pictures, and which way is up and left.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, pose};
use nalgebra::Point3;
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose, SceneBuilder};
use vc_render::{Camera, Frame, Modality, RenderError, Renderer, Shot};

/// The image position of a point.
fn seen(camera: &Camera, point: Point3<f32>) -> [f32; 2] {
    camera.project(&point).map_or([f32::NAN; 2], |p| [p.x, p.y])
}

fn assert_near(own: [f32; 2], wanted: [f32; 2], what: &str) {
    assert!((0..2).all(|i| (own[i] - wanted[i]).abs() < 0.01), "{what}: {own:?}, not {wanted:?}");
}

#[test]
fn a_field_of_view_reaches_from_the_top_row_to_the_bottom_row() {
    for (width, height, fov) in [(64, 48, 1.0), (48, 64, 0.3), (33, 17, 2.4)] {
        let camera = Camera::with_fov(width, height, fov);
        let (rise, (across, down)) = ((0.5 * fov).tangent(), (width as f32, height as f32));
        for far in [0.5, 3.0] {
            let at = |left: f32, up: f32| seen(&camera, Point3::new(far, far * left, far * up));
            assert_near(at(0.0, rise), [0.5 * across, 0.0], "half the angle up");
            assert_near(at(0.0, -rise), [0.5 * across, down], "half the angle down");
            // Pixels are square.
            let side = rise * across / down;
            assert_near(at(side, 0.0), [0.0, 0.5 * down], "left");
            assert_near(at(-side, 0.0), [across, 0.5 * down], "right");
        }
    }
}

#[test]
fn a_mounted_camera_looks_along_x_with_y_to_its_left_and_z_up() {
    let base = Camera::with_fov(64, 48, 1.0);
    for on in [Pose::identity(), pose([1.0, -2.0, 0.7], 2.3, 0.4), pose([-3.0, 0.2, 1.1], -1.0, -0.9)] {
        let camera = base.mounted(&on);
        let at = |x: f32, y: f32, z: f32| seen(&camera, on * Point3::new(x, y, z));
        assert_near(at(2.0, 0.0, 0.0), [32.0, 24.0], "ahead");
        let step = 0.3 * camera.focal.0 / 2.0;
        assert_near(at(2.0, 0.3, 0.0), [32.0 - step, 24.0], "to the left");
        assert_near(at(2.0, 0.0, 0.3), [32.0, 24.0 - step], "above");
        assert!(camera.project(&(on * Point3::new(-1.0, 0.0, 0.0))).is_none(), "behind");
        assert!((camera.eye() - on * Point3::origin()).norm() < 1e-5);
    }
    // An earlier mounting does not matter.
    assert_eq!(base.mounted(&pose([1.0, 2.0, 3.0], 0.5, 0.1)).mounted(&Pose::identity()), base);
}

/// A plan shows a wall that it cuts open as far as its outer side; a camera within a thing does not see the thing.
#[test]
fn plans_cut_things_open() {
    let mut stage = Stage::new();
    let wall = stage.one("wall", block([0.2, 1.0, 1.25]), pose([2.0, 0.0, 1.25], 0.0, 0.0), 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let mut frame = Frame::new();
    let mut seen = |camera: &Camera, at: Point3<f32>| {
        renderer.render(&Shot::new(&snapshot, camera, Modality::Instance), &mut frame).unwrap();
        let [x, y] = seen(camera, at);
        frame.instance[y as usize * 80 + x as usize]
    };
    let camera = Camera::with_fov(80, 80, 1.2);
    // Cut at a height of 2.1 metres, where the wall reaches from 1.8 to 2.2.
    let plan = Camera { near: 4.0, ..camera.looking(Point3::new(0.0, 0.0, 6.1), Point3::origin()) };
    for x in [1.82, 1.9, 2.0, 2.1, 2.17] {
        assert_eq!(seen(&plan, Point3::new(x, 0.3, 2.09)), wall, "{x}");
    }
    assert_ne!(seen(&plan, Point3::new(2.27, 0.3, 2.09)), wall);
    let within = camera.looking(Point3::new(2.0, 0.0, 1.2), Point3::new(2.0, 5.0, 1.2));
    assert_ne!(seen(&within, Point3::new(2.0, 5.0, 1.2)), wall);
}

#[test]
fn from_overhead_a_span_of_ground_fills_the_height_and_x_is_up() {
    let at = Point3::new(1.5, -2.0, 0.25);
    for (width, height, fov, span) in [(64, 48, 1.0, 4.0), (30, 90, 0.4, 0.5)] {
        let camera = Camera::with_fov(width, height, fov).overhead(at, span);
        let (across, down) = (width as f32, height as f32);
        let ground = |x: f32, y: f32| seen(&camera, at + nalgebra::Vector3::new(x, y, 0.0));
        assert_near(ground(0.0, 0.0), [0.5 * across, 0.5 * down], "the middle");
        assert_near(ground(0.5 * span, 0.0), [0.5 * across, 0.0], "the top");
        assert_near(ground(-0.5 * span, 0.0), [0.5 * across, down], "the bottom");
        let side = 0.5 * span * across / down;
        assert_near(ground(0.0, side), [0.0, 0.5 * down], "the left");
        assert_near(ground(0.0, -side), [across, 0.5 * down], "the right");
        assert!(camera.eye().z > at.z && (camera.eye() - at).xy().norm() < 1e-5);
    }
}

#[test]
fn looking_has_its_target_in_the_middle_and_the_worlds_z_up() {
    let (eye, target) = (Point3::new(-1.0, 2.0, 0.5), Point3::new(2.0, 1.0, 1.5));
    let camera = Camera::with_fov(64, 48, 1.0).looking(eye, target);
    assert_near(seen(&camera, target), [32.0, 24.0], "the target");
    let [x, y] = seen(&camera, target + nalgebra::Vector3::z() * 0.2);
    assert!((x - 32.0).abs() < 0.01 && y < 23.0, "{x}, {y} above the target");
    // When looking straight up, the world's X is up as well.
    let up = Camera::with_fov(64, 48, 1.0).looking(eye, eye + nalgebra::Vector3::z());
    let [x, y] = seen(&up, eye + nalgebra::Vector3::new(0.2, 0.0, 1.0));
    assert!((x - 32.0).abs() < 0.01 && y < 20.0, "{x}, {y} towards X");
}

#[test]
fn what_was_at_the_border_is_there_in_another_size() {
    let camera = Camera::with_intrinsics(64, 48, (50.0, 60.0), (30.0, 25.0)).mounted(&pose([0.3, 0.2, 0.1], 1.0, 0.2));
    let other = camera.resized(200, 30);
    assert_eq!((other.width, other.height), (200, 30));
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.3, 1.0), (1.0, 1.0)] {
        let point = camera.unproject(64.0 * x, 48.0 * y, 2.0);
        assert_near(seen(&other, point), [200.0 * x, 30.0 * y], "a place at the border");
    }
}

/// Mean image position of a node's pixels, relative to the centre of the picture.
fn middle(frame: &Frame, node: NodeId) -> [f32; 2] {
    let own = || (0..frame.instance.len()).filter(|i| frame.instance[*i] == node);
    let count = own().count() as f32;
    let mean = |of: &dyn Fn(usize) -> usize| own().map(|i| of(i) as f32 + 0.5).sum::<f32>() / count;
    let (width, height) = (frame.width, frame.height);
    [mean(&|i| i % width) - 0.5 * width as f32, mean(&|i| i / width) - 0.5 * height as f32]
}

#[test]
fn pictures_show_things_on_that_side() -> Result<(), RenderError> {
    // One box is ahead of a robot and to its left, the other ahead and above.
    let on = pose([0.5, 1.0, 0.8], 0.7, 0.0);
    let mut stage = Stage::new();
    let mut put = |x: f32, y: f32, z: f32| stage.one("box", block([0.1; 3]), on * Pose::translation(x, y, z), 0);
    let [left, above] = [put(2.0, 0.5, 0.0), put(2.0, 0.0, 0.5)];
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build())?;
    let mut frame = Frame::new();
    let camera = Camera::with_fov(64, 48, 1.0).mounted(&on);
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance), &mut frame)?;
    let ([x, y], [u, v]) = (middle(&frame, left), middle(&frame, above));
    assert!(x < -8.0 && y.abs() < 1.0, "{x}, {y}: to the left");
    assert!(u.abs() < 1.0 && v < -8.0, "{u}, {v}: above");
    // Seen from overhead, the robot's X, which is turned to the left by 0.7, points up and to the left.
    let camera = Camera::with_fov(64, 48, 1.0).overhead(on * Point3::origin(), 6.0);
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance), &mut frame)?;
    let [u, v] = middle(&frame, above);
    assert!(u < -5.0 && v < -5.0, "{u}, {v}: ahead, from overhead");
    Ok(())
}

/// No picture is made with a field of view of zero, of half a turn or more, or that is not finite.
#[test]
fn fields_of_view_are_angles() -> Result<(), RenderError> {
    let scene = SceneBuilder::new("empty").build();
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene)?;
    for angle in [0.0, -1.0, std::f32::consts::PI, 6.3, 1e9, f32::NAN, f32::INFINITY] {
        let camera = Camera::with_fov(32, 24, angle);
        let made = renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut Frame::new());
        assert!(matches!(made, Err(RenderError::BadCamera(_))), "{angle}");
    }
    Ok(())
}

#[test]
fn a_camera_is_written_and_read() {
    let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(1.0, 2.0, 1.5), Point3::new(4.0, 2.5, 0.5));
    let text = serde_json::to_string(&camera).unwrap();
    assert_eq!(serde_json::from_str::<Camera>(&text).unwrap(), camera);
    assert!(serde_json::from_str::<Camera>(&text.replace("\"rotation\":[", "\"rotation\":[9.0,")).is_err());
}

/// The body of a camera looks where the camera does, upright.
#[test]
fn a_camera_knows_what_it_is_mounted_on() {
    let (eye, target) = (Point3::new(1.0, 2.0, 1.5), Point3::new(4.0, 2.5, 0.5));
    let body = Camera::with_fov(64, 48, 1.0).looking(eye, target).body();
    assert!((body * Point3::new((target - eye).norm(), 0.0, 0.0) - target).norm() < 1e-5);
    assert!((body.rotation * nalgebra::Vector3::y()).z.abs() < 1e-6);
}

//! Unusual input gives an error or a correct picture, never a panic.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::Caster;
use common::{Stage, block, furnished, lamplit, material, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Material, Shape};
use vc_graph::{Draft, Pose, SceneBuilder};
use vc_render::{
    Camera, Daylight, Frame, Modalities, Modality, NOTHING, PathTracing, RayCaster, RenderError, Renderer, Shot,
    Snapshot,
};

fn everything() -> Modalities {
    Modality::ALL.iter().fold(Modalities::SIX, |all, one| all | *one)
}

/// Renders all modalities, and a reference picture.
fn rendered(renderer: &Renderer, snapshot: &Snapshot, camera: &Camera) -> Frame {
    let lighting = renderer.light(snapshot, &Daylight::noon());
    let mut frame = Frame::new();
    let shot = Shot::new(snapshot, camera, everything()).lit(&lighting);
    renderer.render(&shot.after(snapshot, camera).before(snapshot, camera), &mut frame).unwrap();
    let how = PathTracing { samples: 1, ..PathTracing::default() };
    let small = Camera { width: camera.width.min(16), height: camera.height.min(12), ..*camera };
    let reference_picture = renderer.reference_picture(&lighting, &small, &how, |_| true).unwrap();
    assert!(reference_picture.light.iter().flatten().all(|v| v.is_finite() && *v >= 0.0));
    frame
}

#[test]
fn cameras_that_cannot_be_are_refused_by_the_reference_as_well() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let good = Camera::with_fov(16, 12, 1.0);
    let of = |camera: &Camera| renderer.reference_picture(&lighting, camera, &PathTracing::default(), |_| false);
    assert!(of(&good).is_ok());
    assert!(matches!(of(&Camera { width: 0, ..good }), Err(RenderError::BadSize { .. })));
    assert!(matches!(of(&Camera { height: 1 << 20, ..good }), Err(RenderError::BadSize { .. })));
    for value in [f32::NAN, f32::INFINITY, 1e30] {
        let pose = Pose::translation(value, 0.0, 0.0);
        assert!(matches!(of(&Camera { pose, ..good }), Err(RenderError::BadCamera(_))), "{value}");
        assert!(matches!(of(&Camera { focal: (value, 10.0), ..good }), Err(RenderError::BadCamera(_))), "{value}");
    }
}

#[test]
fn cameras_inside_things_and_upon_them_see_something_right() {
    let mut stage = Stage::new();
    stage.one("wall", block([2.0, 2.0, 2.0]), Pose::identity(), 1);
    stage.one("ball", Shape::Sphere { radius: 0.5 }, pose([0.2, 0.0, 0.0], 0.4, 0.2), 0);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let places = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.9999, 1.9999, 0.0], [0.7, 0.0, 0.0], [2.0, 2.0, 2.0]];
    for (at, near) in places.into_iter().flat_map(|p| [(p, 1e-5), (p, 0.5), (p, 5e5)]) {
        let eye = Point3::from(at);
        let camera = Camera { near, ..Camera::with_fov(40, 30, 1.4) }.looking(eye, eye + Vector3::new(1.0, 0.3, 0.1));
        let frame = rendered(&renderer, &snapshot, &camera);
        assert!(frame.depth.iter().all(|d| *d >= near * 0.999), "nothing is nearer than the near plane");
    }
}

#[test]
fn from_inside_of_things_is_seen_what_a_ray_caster_sees() {
    let graph = furnished();
    let caster = Caster::new(&graph, 0.0005);
    let mut renderer = Renderer::new().with_detail(0.0);
    let snapshot = renderer.snapshot(&graph).unwrap();
    let ball: [f32; 3] = graph.node(graph.of_class("ball")[0]).unwrap().pose().unwrap().translation.vector.into();
    // The eyes are in a wall, in the floor, in the cabinet, in its drawer, and in a ball.
    let eyes = [[3.05, 0.2, 1.0], [0.3, 0.1, -0.1], [2.0, 1.0, 0.25], [1.8, 1.0, 0.6], ball];
    let (mut pixels, mut foreign, mut deep) = (0, 0, 0);
    for (eye, near) in eyes.into_iter().flat_map(|eye| [(eye, 0.01), (eye, 0.4)]) {
        let camera =
            Camera { near, ..Camera::with_fov(64, 48, 1.2) }.looking(Point3::from(eye), Point3::new(0.1, -0.2, 1.3));
        let mut frame = Frame::new();
        let wanted = Modality::Instance | Modality::Depth;
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        for (i, node) in frame.instance.iter().enumerate() {
            let hit = caster.cast(&camera, (i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
            pixels += 1;
            if hit.map_or(NOTHING, |h| h.node) != *node {
                foreign += 1;
            } else if let Some(hit) = hit {
                deep += usize::from((f64::from(frame.depth[i]) / hit.depth - 1.0).abs() > 1e-4);
            }
        }
        let seen = frame.instance.iter().filter(|n| **n != NOTHING).count();
        assert!(seen > 2000, "{seen} pixels show something from {eye:?}");
    }
    eprintln!("{pixels} pixels: {foreign} other ids, {deep} other depths");
    // They differ at edges, as vertices snap to fractions of a pixel.
    assert!(foreign * 1000 < pixels && deep * 1000 < pixels, "{foreign} ids and {deep} depths of {pixels} differ");
}

#[test]
fn triangles_across_the_eye_are_cut_at_the_near_plane() {
    // A floor that continues behind the camera fills the lower half of the picture.
    let mut stage = Stage::new();
    stage.one("floor", block([500.0, 500.0, 0.1]), Pose::translation(0.0, 0.0, -0.1), 0);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let camera = Camera::with_fov(40, 30, 1.0).looking(Point3::new(0.0, 0.0, 1.5), Point3::new(1.0, 0.0, 1.5));
    let frame = rendered(&renderer, &snapshot, &camera);
    for (index, node) in frame.instance.iter().enumerate() {
        let below = index / 40 >= 15;
        assert_eq!(*node != NOTHING, below && frame.depth[index].is_finite(), "pixel {index}");
        if index / 40 >= 16 {
            assert!(*node != NOTHING);
        }
    }
}

#[test]
fn meshes_without_triangles_or_area_are_not_seen() {
    let mut stage = Stage::new();
    stage.one(
        "ball",
        Shape::Mesh { vertices: Vec::new(), triangles: Vec::new(), uvs: Vec::new() },
        Pose::identity(),
        0,
    );
    let point = Point3::new(0.1, 0.2, 0.3);
    let flat = Shape::Mesh { vertices: vec![point; 3], triangles: vec![[0, 1, 2], [0, 0, 0]], uvs: Vec::new() };
    stage.one("ball", flat, Pose::identity(), 0);
    let needle = vec![Point3::origin(), Point3::new(1.0, 0.0, 0.0), Point3::new(2.0, 0.0, 0.0)];
    stage.one(
        "ball",
        Shape::Mesh { vertices: needle, triangles: vec![[0, 1, 2]], uvs: Vec::new() },
        Pose::identity(),
        2,
    );
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let camera = Camera::with_fov(32, 24, 1.0).looking(Point3::new(-2.0, 0.1, 0.2), Point3::origin());
    let frame = rendered(&renderer, &snapshot, &camera);
    assert!(frame.instance.iter().all(|n| *n == NOTHING) && frame.boxes.is_empty());
    let caster = RayCaster::new(&snapshot);
    assert!(caster.first(&Point3::new(-2.0, 0.0, 0.0), &Vector3::x(), 10.0).is_none());
}

#[test]
fn rays_that_cannot_be_meet_nothing() {
    let mut renderer = Renderer::new();
    let caster = RayCaster::new(&renderer.snapshot(&furnished()).unwrap());
    let (eye, along) = (Point3::new(0.0, 0.0, 1.0), Vector3::x());
    assert!(caster.first(&eye, &along, 100.0).is_some());
    for value in [f32::NAN, f32::INFINITY] {
        assert!(caster.first(&Point3::new(value, 0.0, 0.0), &along, 100.0).is_none());
        assert!(caster.first(&eye, &Vector3::new(value, 0.0, 0.0), 100.0).is_none());
    }
    assert!(caster.first(&eye, &Vector3::zeros(), 100.0).is_none());
    assert!(caster.first(&eye, &along, f32::NAN).is_none() && caster.first(&eye, &along, -1.0).is_none());
    assert!(caster.sees(&eye, &eye));
}

#[test]
fn triangles_each_a_tenth_smaller_than_the_one_before_are_all_met() {
    // Wherever such a set is split, most triangles are on one side.
    let sizes: Vec<f32> = (0..800).map(|k| 4.0 * 0.9_f32.powi(k)).collect();
    let axes = [Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0), Point3::new(0.0, 0.0, 1.0)];
    let vertices = sizes.iter().flat_map(|size| axes.map(|axis| axis * *size)).collect();
    let triangles = (0..800).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let mut stage = Stage::new();
    stage.one("ball", Shape::Mesh { vertices, triangles, uvs: Vec::new() }, Pose::identity(), 0);
    let caster = RayCaster::new(&Renderer::new().snapshot(&stage.build()).unwrap());
    let out = Vector3::new(1.0, 1.0, 1.0).normalize();
    let depth = |size: f32| size / 3.0_f32.sqrt();
    for pair in sizes.windows(2).take_while(|pair| pair[0] > 1e-3) {
        let start = Point3::origin() + out * (0.5 * (depth(pair[0]) + depth(pair[1])));
        for (along, size) in [(out, pair[0]), (-out, pair[1])] {
            let met = caster.first(&start, &along, 10.0).unwrap();
            assert!(((met.point - Point3::origin()).norm() - depth(size)).abs() < 1e-5, "{size} m: {met:?}");
        }
        assert!(!caster.sees(&start, &Point3::new(5.0, 5.0, 5.0)));
    }
}

#[test]
fn glass_with_glass_in_it_ends() {
    // Nested balls of glass with mirrors around: paths go on and on.
    let mut stage = Stage::new();
    let hall = Material { metallic: 1.0, roughness: 0.01, ..material("mirror", [1.0; 3]) };
    let mirror = stage.library.add_material(hall).unwrap();
    for i in 1..8 {
        stage.one("ball", Shape::Sphere { radius: 0.1 * i as f32 }, Pose::identity(), 2);
    }
    for (x, y) in [(3.0, 0.0), (-3.0, 0.0), (0.0, 3.0), (0.0, -3.0)] {
        let half = if x == 0.0 { [3.0, 0.1, 3.0] } else { [0.1, 3.0, 3.0] };
        stage.one("mirror", block(half), pose([x, y, 0.0], 0.0, 0.0), mirror);
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let camera = Camera::with_fov(16, 12, 1.0).looking(Point3::new(-2.0, 0.3, 0.2), Point3::origin());
    rendered(&renderer, &snapshot, &camera);
}

#[test]
fn cameras_that_are_nowhere_are_refused_when_they_look() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let (good, at) = (Camera::with_fov(16, 12, 1.0), Point3::new(0.0, 0.0, 1.0));
    let mut cameras = vec![Camera::with_fov(16, 12, 0.0), Camera::with_fov(16, 12, -1.0)];
    for value in [f32::NAN, f32::INFINITY] {
        let off = Point3::new(0.0, value, 1.0);
        cameras.extend(good.around(off, 1.0, 0.3, 2));
        cameras.extend(good.around(at, value, 0.3, 2));
        cameras.extend(good.around(at, 1.0, value, 2));
        cameras.extend([good.overhead(off, 2.0), good.overhead(at, value)]);
        cameras.extend([good.looking(off, at), good.mounted(&Pose::translation(value, 0.0, 0.0))]);
        cameras.push(Camera::with_fov(16, 12, value));
    }
    // The direction of this camera is undefined.
    cameras.push(good.looking(at, Point3::new(f32::NAN, 0.0, 0.0)));
    let mut frame = Frame::new();
    for (number, camera) in cameras.iter().enumerate() {
        let refused = renderer.render(&Shot::new(&snapshot, camera, Modality::Depth), &mut frame);
        assert!(matches!(refused, Err(RenderError::BadCamera(_))), "camera {number}: {refused:?}");
    }
    assert!(frame.depth.is_empty());
    renderer.render(&Shot::new(&snapshot, &good.overhead(at, 2.0), Modality::Depth), &mut frame).unwrap();
}

#[test]
fn exposures_that_cannot_be_give_some_picture() {
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&lamplit()).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let camera = common::cameras(16, 12)[0];
    let numbers =
        [(0, 0, f32::NAN), (0, 12, 0.0), (1, 0, 20.0), (1, 12, f32::NAN), (1, u32::MAX, f32::INFINITY), (2, 3, -1.0)];
    for ((samples, bounces, brightest), denoise) in numbers.into_iter().flat_map(|n| [(n, false), (n, true)]) {
        let how = PathTracing { samples, bounces, brightest, seed: u32::MAX, denoise };
        let mut rounds = 0;
        let reference_picture = renderer.reference_picture(&lighting, &camera, &how, |made| {
            rounds = made.rounds;
            true
        });
        let light = reference_picture.unwrap().light;
        // At least one path is traced, as there would be no picture otherwise.
        assert_eq!(rounds, samples.max(1), "{how:?}");
        assert_eq!(light.len(), 16 * 12);
        assert!(light.iter().flatten().all(|v| v.is_finite()), "{how:?}");
        assert!(light.iter().flatten().all(|v| *v >= 0.0), "{how:?}");
    }
}

#[test]
fn more_classes_than_there_are_numbers_are_refused() {
    let mut stage = Stage::new();
    for i in 0..70_000 {
        stage.builder.add(Draft::new(format!("qx{i}"))).unwrap();
    }
    let refused = Renderer::new().snapshot(&stage.build()).map(|_| ());
    assert!(matches!(refused, Err(RenderError::TooManyClasses { classes }) if classes >= 70_000), "{refused:?}");
}

#[test]
fn sheets_of_pictures_of_any_size_have_their_corners_where_they_belong() {
    use vc_render::picture::Picture;
    let sizes = [(4, 3), (9, 1), (1, 7), (0, 0), (2, 2), (4, 3)];
    let pictures: Vec<Picture> =
        sizes.iter().zip(1..).map(|((width, height), i)| Picture::new(*width, *height, [10 * i; 3])).collect();
    for (columns, margin) in [0, 1, 2, 7].into_iter().flat_map(|columns| [(columns, 0), (columns, 3)]) {
        let sheet = Picture::sheet(&pictures, columns, margin);
        assert_eq!(sheet.pixels.len(), sheet.width * sheet.height);
        let columns = columns.max(1);
        for (i, picture) in pictures.iter().enumerate().filter(|(_, p)| !p.pixels.is_empty()) {
            let (x, y) = (margin + i % columns * (4 + margin), margin + i / columns * (3 + margin));
            assert_eq!(sheet.pixels[y * sheet.width + x], picture.pixels[0], "picture {i}, {columns} columns");
        }
    }
    assert!(Picture::sheet(&[], 3, 0).pixels.is_empty());
    let lone = Picture::sheet(&pictures[..1], 1, 0);
    assert!(lone == pictures[0]);
}

#[test]
fn what_is_pasted_outside_is_left_out() {
    use vc_render::picture::Picture;
    let (white, mut black) = (Picture::new(3, 2, [255; 3]), Picture::new(4, 4, [0; 3]));
    for (x, y) in [(4, 3), (5, 0), (9, 3), (0, 4), (usize::MAX, usize::MAX)] {
        black.paste(&white, x, y);
    }
    assert!(black.pixels.iter().all(|p| *p == [0; 3]));
    black.paste(&white, 2, 3);
    assert_eq!(black.pixels.iter().filter(|p| **p == [255; 3]).count(), 2);
}

/// The list of pixels is public, and may not be as long as the size says.
#[test]
fn pictures_without_all_their_pixels_are_drawn_in_part_and_not_encoded() {
    use vc_render::picture::{self, Picture};
    for (width, height, pixels) in [(4, 3, 11), (4, 3, 0), (4, 3, 40), (0, 3, 5), (usize::MAX, usize::MAX, 7)] {
        let odd = Picture { width, height, pixels: vec![[9; 3]; pixels] };
        let mut sheet = Picture::new(6, 6, [0; 3]);
        sheet.paste(&odd, 1, 1);
        let filled = sheet.pixels.iter().filter(|p| **p == [9; 3]).count();
        let (across, down) = (width.min(5), height.min(5).min(pixels / width.max(1)));
        assert_eq!(filled, across * down, "{width} by {height}, {pixels} pixels");
        odd.clone().paste(&sheet, 0, 0);
        let small = odd.shrunk(2);
        assert_eq!(small.pixels.len(), small.width * small.height);
        let mut frame = Frame::new();
        frame.boxes = boxes_in_view();
        picture::with_boxes(odd.clone(), &frame, 0);
        let both = [odd.clone(), odd.clone()];
        let refused = [picture::png(&odd), picture::jpeg(&odd, 90), picture::gif(&both, 9), picture::apng(&both, 9)];
        assert!(refused.iter().all(|file| matches!(file, Err(RenderError::Encoding(_)))), "{width} by {height}");
    }
}

/// The boxes of some things that a camera sees.
fn boxes_in_view() -> Vec<vc_render::BoxLabel> {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let mut frame = Frame::new();
    let camera = common::cameras(16, 12)[0];
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Boxes), &mut frame).unwrap();
    assert!(!frame.boxes.is_empty());
    frame.boxes
}

/// Renders `layers` layers of a hundred by a hundred boxes from close by, and checks that the picture agrees
/// with ray hits wherever no edge is near.
fn boxes_are_seen(layers: u32) {
    let mut stage = Stage::new();
    let asset = stage.asset(vec![common::part("box", block([0.02; 3]), [0.0; 3], 0)]);
    let mut scene = SceneBuilder::new("many");
    let room = scene.add(Draft::new("living_room")).unwrap();
    for i in 0..10_000 * layers {
        let at = |k: u32| (i / 100_u32.pow(k) % 100) as f32 * 0.1;
        let draft = Draft { asset: Some(asset), ..Draft::new("box").at(Pose::translation(at(2), at(0), at(1))) };
        scene.add_in(room, draft).unwrap();
    }
    scene.assets(std::sync::Arc::new(stage.library));
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&scene.build()).unwrap();
    let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(-0.6, 4.9, 5.1), Point3::new(5.0, 5.2, 4.8));
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance | Modality::Depth), &mut frame).unwrap();
    let caster = RayCaster::new(&snapshot);
    let met = |x: f32, y: f32| {
        let ray = camera.unproject(x, y, 1.0) - camera.eye();
        caster.first(&camera.eye(), &ray, 100.0).map(|hit| hit.node)
    };
    let mut certain = 0;
    for (i, node) in frame.instance.iter().enumerate() {
        let (x, y) = ((i % 64) as f32 + 0.5, (i / 64) as f32 + 0.5);
        let around = [(0.0, 0.0), (0.05, 0.05), (-0.05, 0.05), (0.05, -0.05), (-0.05, -0.05)];
        let around = around.map(|(dx, dy)| met(x + dx, y + dy));
        if around.iter().all(|node| *node == around[0]) {
            certain += 1;
            assert_eq!(around[0].unwrap_or(vc_render::NOTHING), *node, "pixel {x} {y}");
            assert_eq!(around[0].is_some(), frame.depth[i].is_finite());
        }
    }
    assert!(certain > 64 * 48 / 2, "only {certain} pixels are far from edges");
}

#[test]
fn sixty_thousand_objects_are_seen() {
    boxes_are_seen(6);
}

#[test]
#[ignore = "takes some gigabytes and a minute: cargo test -p vc-render --test render odd -- --ignored"]
fn a_million_objects_are_seen() {
    boxes_are_seen(100);
}

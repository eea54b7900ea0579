//! Labels agree with each other, do not depend on the number of threads, and survive bad input.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, cameras, furnished, lamplit, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::Shape;
use vc_render::{Camera, Daylight, Frame, Modalities, Modality, NOTHING, PathTracing, RenderError, Renderer, Shot};

#[test]
fn masks_boxes_and_ids_agree_exactly() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let mut frame = Frame::new();
    for camera in cameras(200, 150) {
        let wanted = Modality::Instance | Modality::Boxes | Modality::Masks | Modality::Amodal;
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        let seen = frame.instance.iter().filter(|n| **n != NOTHING).count();
        assert_eq!(frame.boxes.iter().map(|b| b.area as usize).sum::<usize>(), seen);
        for ((label, mask), whole) in frame.boxes.iter().zip(frame.masks()).zip(frame.amodal_masks()) {
            assert_eq!((label.node, label.visible, label.area), (mask.node(), mask.within(), mask.area()));
            let bits = mask.bitmap();
            assert!(frame.instance.iter().zip(&bits).all(|(n, b)| (*n == label.node) == (*b == 1)));
            assert!(label.amodal.contains(&label.visible));
            let all = whole.bitmap();
            assert!(bits.iter().zip(&all).all(|(seen, whole)| seen <= whole), "{}: seen where it is not", label.node);
            let share = label.visible_fraction.unwrap();
            assert_eq!(share, label.area as f32 / whole.area() as f32);
            let rle = mask.rle();
            assert_eq!((rle.area(), rle.counts.iter().sum::<u32>()), (label.area, 200 * 150));
        }
    }
}

#[test]
fn triangles_that_share_an_edge_leave_no_gap_and_do_not_overlap() {
    // Seen past a ball, the wall behind it fills every other pixel: nothing is missing.
    let mut stage = Stage::new();
    stage.one("ball", Shape::Sphere { radius: 0.5 }, Pose::identity(), 0);
    stage.one("wall", block([0.1, 30.0, 30.0]), pose([5.0, 0.0, 0.0], 0.0, 0.0), 1);
    let mut renderer = Renderer::new().with_detail(0.0);
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let mut frame = Frame::new();
    for turn in 0..24 {
        let eye = Point3::new(-1.3, 0.013 * turn as f32, 0.007 * turn as f32);
        let camera = Camera::with_fov(301, 211, 0.9).looking(eye, Point3::origin());
        let wanted = Modality::Instance | Modality::Boxes;
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        assert!(frame.instance.iter().all(|n| *n != NOTHING));
        // The ball has no hole: every row of it is one run.
        let ball = frame.boxes[0].node;
        for row in frame.instance.chunks(301) {
            let runs = row.chunk_by(|a, b| (*a == ball) == (*b == ball)).filter(|run| run[0] == ball).count();
            assert!(runs <= 1, "a hole in the ball");
        }
    }
}

#[test]
fn flow_moves_points_onto_themselves() {
    let mut renderer = Renderer::new();
    let graph = furnished();
    let now = renderer.snapshot(&graph).unwrap();
    let mut then = now.clone();
    let moved = graph.of_class("ball")[0];
    then.place(moved, &(Pose::translation(0.05, 0.02, 0.03) * graph.node(moved).unwrap().pose().unwrap())).unwrap();
    let camera = cameras(160, 120)[0];
    let later = Camera { pose: camera.pose * Pose::translation(0.04, 0.01, 0.05), ..camera };
    let wanted = Modality::FlowForward | Modality::Occlusion | Modality::Position | Modality::Instance;
    let (mut frame, mut next) = (Frame::new(), Frame::new());
    renderer.render(&Shot::new(&now, &camera, wanted).after(&then, &later), &mut frame).unwrap();
    renderer.render(&Shot::new(&then, &later, Modality::Instance | Modality::Position), &mut next).unwrap();
    let (mut kept, mut same) = (0, 0);
    for (i, flow) in frame.flow_forward.iter().enumerate() {
        if frame.instance[i] == NOTHING {
            continue;
        }
        let mut point = Point3::from(frame.position[i]);
        if frame.instance[i] == moved {
            point += Vector3::new(0.05, 0.02, 0.03);
        }
        let Some(there) = later.project(&point) else { continue };
        let wanted = [there.x - (i % 160) as f32 - 0.5, there.y - (i / 160) as f32 - 0.5];
        assert!((flow[0] - wanted[0]).hypot(flow[1] - wanted[1]) < 0.02, "{flow:?} is not {wanted:?}");
        if frame.occluded_forward[i] == 0 {
            kept += 1;
            same += usize::from(next.instance[there.y as usize * 160 + there.x as usize] == frame.instance[i]);
        }
    }
    assert!(kept > 10_000 && same as f32 > 0.97 * kept as f32, "{same} of {kept} are found again");
}

#[test]
fn threads_do_not_change_a_byte() {
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&lamplit()).unwrap();
    // The room has no window.
    let all: Vec<_> = snapshot.nodes().collect();
    all.into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let camera = cameras(160, 120)[1];
    let make = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let lighting = renderer.light(&snapshot, &Daylight::noon());
            let mut frame = Frame::new();
            let shot = Shot::new(&snapshot, &camera, Modalities::SIX).lit(&lighting).after(&snapshot, &camera);
            renderer.render(&shot, &mut frame).unwrap();
            let how = PathTracing { samples: 1, bounces: 3, ..PathTracing::default() };
            let small = Camera { width: 40, height: 30, ..camera };
            let reference_picture = renderer.reference_picture(&lighting, &small, &how, |_| true).unwrap();
            let flow: Vec<[u32; 2]> = frame.flow_forward.iter().map(|f| f.map(f32::to_bits)).collect();
            (frame.rgb, frame.depth, frame.instance, flow, reference_picture.light)
        })
    };
    let one = make(1);
    assert!([2, 3, 8].into_iter().all(|threads| one == make(threads)));
    assert!(one.0.iter().any(|c| c.iter().any(|v| *v > 30)), "the picture is dark");
}

#[test]
fn a_grey_ball_in_even_light_is_grey() {
    let mut stage = Stage::new();
    stage.one("ball", Shape::Sphere { radius: 0.5 }, Pose::identity(), 1);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let one = Vector3::repeat(1.0);
    let even = Daylight { sun: Vector3::zeros(), zenith: one, horizon: one, ground: one, ..Daylight::noon() };
    let lighting = renderer.light(&snapshot, &even);
    let camera = Camera::with_fov(24, 24, 0.5).looking(Point3::new(-3.0, 0.0, 0.0), Point3::origin());
    let how = PathTracing { samples: 128, denoise: false, ..PathTracing::default() };
    let reference_picture = renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap();
    let middle = reference_picture.light[12 * 24 + 12];
    // The reflectance is 0.8, with a little gloss; the light is never more than that of the surroundings.
    assert!(middle.iter().all(|v| (0.7..=1.0).contains(v)), "{middle:?}");
    assert!((reference_picture.light[0][0] - 1.0).abs() < 0.15);
}

#[test]
fn bad_input_is_an_error_or_a_right_picture() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let mut frame = Frame::new();
    let camera = cameras(64, 48)[0];
    let bad = [
        Camera { width: 0, ..camera },
        Camera { height: 100_000, ..camera },
        Camera { near: 0.0, ..camera },
        Camera { focal: (f32::NAN, 1.0), ..camera },
        Camera { centre: (f32::INFINITY, 0.0), ..camera },
        Camera { pose: Pose::translation(f32::NAN, 0.0, 0.0), ..camera },
    ];
    for camera in bad {
        assert!(renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut frame).is_err());
    }
    let missing = renderer.render(&Shot::new(&snapshot, &camera, Modality::FlowForward), &mut frame);
    assert!(matches!(missing, Err(RenderError::Missing { .. })));
    // Cameras inside of things, far away, with unusual lenses, and with a single pixel.
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    for eye in [[3.05, 0.0, 1.0], [2.0, 1.0, 0.5], [1e6, 0.0, 0.0], [0.0, 0.0, 0.0]] {
        for (width, height, fov) in [(1, 1, 1.0), (33, 7, 3.1), (7, 65, 0.01)] {
            let camera = Camera::with_fov(width, height, fov).looking(Point3::from(eye), Point3::new(0.0, 0.1, 1.0));
            let shot = Shot::new(&snapshot, &camera, Modalities::SIX | Modality::Amodal | Modality::Normal);
            renderer.render(&shot.lit(&lighting).after(&snapshot, &camera), &mut frame).unwrap();
        }
    }
    let empty = renderer.snapshot(&Stage::new().build()).unwrap();
    let lighting = renderer.light(&empty, &Daylight::noon());
    renderer.render(&Shot::new(&empty, &camera, Modality::Rgb | Modality::Depth).lit(&lighting), &mut frame).unwrap();
    assert!(frame.depth.iter().all(|d| d.is_infinite()));
}

//! Triangles that share an edge cover every pixel of both exactly once.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::Stage;
use common::caster::Caster;
use nalgebra::{Point3, Vector3};
use vc_graph::asset::Shape;
use vc_graph::{Pose, Seed};
use vc_render::{Camera, Frame, Modality, Renderer, Shot};

/// Triangles around a common point, each a separate node, on a plane in front of the camera.
fn fan(corners: &[Point3<f32>], middle: Point3<f32>) -> Stage {
    let mut stage = Stage::new();
    for (i, a) in corners.iter().enumerate() {
        let vertices = vec![middle, *a, corners[(i + 1) % corners.len()]];
        let shape = Shape::Mesh { vertices, triangles: vec![[0, 1, 2]], uvs: Vec::new() };
        stage.one("leaf", shape, Pose::identity(), 0);
    }
    stage
}

#[test]
fn neighbours_leave_no_gap_and_do_not_overlap() {
    let mut chance = Seed(17).stream();
    let mut covered = 0;
    for round in 0..60 {
        let mut near = |v: f32| chance.between(-v, v);
        // In some rounds, points lie on the grid that vertices snap to and on pixel centres, which gives ties.
        let snap = |v: f32| if round % 3 == 0 { (v * 32.0).round() / 32.0 } else { v };
        let tilt = [near(0.5), near(0.5)];
        let mut place = |x: f32, y: f32| {
            let (x, y) = (snap(x + near(0.2)), snap(y + near(0.2)));
            Point3::new(4.0 + if round % 3 == 0 { 0.0 } else { tilt[0] * x + tilt[1] * y }, -x, y)
        };
        let corners: Vec<_> = [(1.0, 0.0), (0.6, 0.9), (-0.5, 1.0), (-1.0, -0.1), (-0.4, -1.0), (0.7, -0.8)]
            .map(|(x, y)| place(x, y))
            .to_vec();
        let graph = fan(&corners, place(0.0, 0.0)).build();
        let mut renderer = Renderer::new().with_detail(0.0);
        let snapshot = renderer.snapshot(&graph).unwrap();
        let camera = Camera::with_intrinsics(64, 64, (64.0, 64.0), (32.0, 32.0))
            .looking(Point3::origin(), Point3::from(Vector3::x()));
        let wanted = Modality::Instance | Modality::Boxes | Modality::Amodal;
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        assert_eq!(frame.boxes.len(), 6, "round {round}");
        let caster = Caster::new(&graph, 0.0005);
        for y in 0..64 {
            for x in 0..64 {
                let owners: Vec<_> = frame.amodal_masks().filter(|m| m.has(x, y)).map(|m| m.node()).collect();
                assert!(owners.len() <= 1, "round {round}: pixel {x}, {y} is in {owners:?}");
                // If everything around the pixel's centre belongs to some triangle, so does the centre.
                let at = |dx: f64, dy: f64| caster.cast(&camera, f64::from(x) + 0.5 + dx, f64::from(y) + 0.5 + dy);
                let inside = [(0.02, 0.01), (-0.02, 0.01), (0.01, -0.02), (-0.01, 0.02)];
                if inside.iter().all(|(dx, dy)| at(*dx, *dy).is_some()) {
                    assert_eq!(owners.len(), 1, "round {round}: nothing at pixel {x}, {y}");
                    covered += 1;
                }
            }
        }
    }
    assert!(covered > 10_000, "{covered}");
}

/// A solid whose front is a strip of `count` triangles on a plane in front of the camera, and which ends in a
/// point far behind.
fn strip(count: u32) -> Shape {
    let corner = |i: u32| {
        Point3::new(4.0, 1.9 - 3.8 * i as f32 / (count + 1) as f32, if i.is_multiple_of(2) { -0.4 } else { 0.4 })
    };
    let turned = |i: u32| if i.is_multiple_of(2) { [i, i + 2, i + 1] } else { [i, i + 1, i + 2] };
    let front: Vec<[u32; 3]> = (0..count).map(turned).collect();
    let edges = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: Vec<[u32; 2]> = front.iter().flat_map(edges).collect();
    let open = all.iter().rev().filter(|[a, b]| !all.contains(&[*b, *a]));
    let back = open.map(|[a, b]| [*b, *a, count + 2]);
    Shape::Mesh {
        vertices: (0..count + 2).map(corner).chain([Point3::new(30.0, 0.0, 0.0)]).collect(),
        triangles: front.iter().copied().chain(back).collect(),
        uvs: Vec::new(),
    }
}

#[test]
fn all_triangles_of_a_mesh_that_faces_the_eye_are_drawn() {
    let camera = Camera::with_intrinsics(512, 64, (512.0, 256.0), (256.0, 32.0))
        .looking(Point3::origin(), Point3::from(Vector3::x()));
    for count in 1..=200 {
        let shape = strip(count);
        let Shape::Mesh { vertices, triangles, .. } = shape.clone() else { unreachable!() };
        let mut stage = Stage::new();
        let node = stage.one("strip", shape, Pose::identity(), 0);
        let mut renderer = Renderer::new().with_detail(0.0);
        let snapshot = renderer.snapshot(&stage.build()).unwrap();
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance), &mut frame).unwrap();
        for (i, corners) in triangles.iter().take(count as usize).enumerate() {
            let sum: Vector3<f32> = corners.iter().map(|c| vertices[*c as usize].coords).sum();
            let at = camera.project(&Point3::from(sum / 3.0)).unwrap();
            let pixel = at.y as usize * 512 + at.x as usize;
            assert_eq!(frame.instance[pixel], node, "triangle {i} of {count} is missing");
        }
    }
}

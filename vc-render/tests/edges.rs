//! Triangles that share an edge cover every pixel of both once.

#![allow(clippy::unwrap_used)]

mod common;

use common::Stage;
use common::caster::Caster;
use nalgebra::{Point3, Vector3};
use vc_graph::asset::Shape;
use vc_graph::{Pose, Seed};
use vc_render::{Camera, Frame, Modality, Renderer, Shot};

/// Triangles around a middle, each a node of its own, on a plane before the camera.
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
        // Steps of the grid that vertices snap to, and of pixels, among the places: ties.
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
                // All around it belongs to some triangle: so does it.
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

//! Ids, depth and normals against a ray caster at every pixel's centre.

#![allow(clippy::unwrap_used)]

mod common;

use common::caster::Caster;
use common::{cameras, furnished};
use nalgebra::Vector3;
use vc_render::{Frame, Modality, NOTHING, Renderer, Shot};

/// Whether a part of what is seen at a place lies in the plane that is seen there.
fn shared(caster: &Caster, camera: &vc_render::Camera, (x, y): (f64, f64), depth: f64, part: u16) -> bool {
    caster.pierce(camera, x, y).iter().any(|h| h.part == part && (h.depth / depth - 1.0).abs() < 1e-6)
}

#[test]
fn ids_depths_and_normals_are_those_of_a_ray_caster() {
    let graph = furnished();
    let caster = Caster::new(&graph, 0.0005);
    let mut renderer = Renderer::new().with_detail(0.0);
    let snapshot = renderer.snapshot(&graph).unwrap();
    let wanted = Modality::Instance | Modality::Part | Modality::Depth | Modality::Distance | Modality::Normal;
    let (mut pixels, mut foreign, mut deep, mut turned, mut other_parts) = (0, 0, 0, 0, 0);
    for camera in cameras(160, 120) {
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, wanted), &mut frame).unwrap();
        for (i, &node) in frame.instance.iter().enumerate() {
            let (x, y) = ((i % 160) as f64 + 0.5, (i / 160) as f64 + 0.5);
            pixels += 1;
            let hit = caster.cast(&camera, x, y);
            if hit.map_or(NOTHING, |h| h.node) != node {
                foreign += 1;
                continue;
            }
            let Some(hit) = hit else { continue };
            let error = (f64::from(frame.depth[i]) / hit.depth - 1.0).abs();
            deep += u32::from(error > 1e-4);
            let along = frame.depth[i] * nalgebra::distance(&camera.unproject(x as f32, y as f32, 1.0), &camera.eye());
            assert!((frame.distance[i] / along - 1.0).abs() < 1e-5);
            // Another part at the same depth lies in the other's plane.
            other_parts +=
                u32::from(hit.part != frame.part[i] && !shared(&caster, &camera, (x, y), hit.depth, frame.part[i]));
            turned += u32::from(hit.normal.cast::<f32>().dot(&Vector3::from(frame.normal[i])) < 0.75);
        }
    }
    eprintln!(
        "{pixels} pixels: {foreign} other ids, {deep} other depths, {turned} other normals, {other_parts} other parts"
    );
    assert!(f64::from(other_parts) < 0.0005 * f64::from(pixels), "{other_parts} of {pixels} parts differ");
    assert!(f64::from(foreign) < 0.0005 * f64::from(pixels), "{foreign} of {pixels} ids differ");
    assert!(f64::from(deep) < 0.0005 * f64::from(pixels), "{deep} of {pixels} depths differ");
    assert!(f64::from(turned) < 0.001 * f64::from(pixels), "{turned} of {pixels} normals differ");
}

//! Ids, depth and normals compared with a ray caster at every pixel's centre.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::{Caster, Hit};
use common::{Stage, block, cameras, furnished, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::asset::Shape;
use vc_graph::{Pose, SceneGraph};
use vc_render::{Camera, Frame, Modalities, Modality, NO_LABEL, NOTHING, Renderer, Shot};

/// Whether the given part also lies in the plane that is visible at a place.
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
            // Another part at the same depth lies in the same plane.
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

/// The hit at a place, if everything around it, within a 64th of a pixel, is in the same plane of the same
/// part: vertices snap by less than that.
fn inside(caster: &Caster, camera: &Camera, (x, y): (f64, f64)) -> Option<Hit> {
    const STEP: f64 = 1.0 / 64.0;
    let own = caster.cast(camera, x, y)?;
    let same = |(dx, dy): (f64, f64)| {
        caster
            .cast(camera, x + dx, y + dy)
            .is_some_and(|hit| (hit.node, hit.part) == (own.node, own.part) && hit.normal.dot(&own.normal) > 1.0 - 1e-9)
    };
    [(STEP, 0.0), (-STEP, 0.0), (0.0, STEP), (0.0, -STEP)].into_iter().all(same).then_some(own)
}

/// Whether the hit surface is flat, and so the same at all levels of detail.
fn is_flat(graph: &SceneGraph, hit: &Hit) -> bool {
    match &**graph.node(hit.node).unwrap().class() {
        "wall" | "book" => true,
        // Its top has rounded edges.
        "dresser" => hit.part < 2,
        _ => false,
    }
}

#[test]
fn away_from_edges_depths_and_the_normals_of_what_is_flat_are_all_right() {
    let graph = furnished();
    let caster = Caster::new(&graph, 0.0005);
    let mut renderers = [Renderer::new().with_detail(0.0), Renderer::new()];
    let [fine, usual] = renderers.each_mut().map(|renderer| renderer.snapshot(&graph).unwrap());
    let wanted = Modality::Instance | Modality::Part | Modality::Depth | Modality::Normal;
    let (mut pixels, mut flats, mut foreign) = ([0; 2], [0; 2], 0);
    for camera in cameras(96, 72) {
        let mut frames = [Frame::new(), Frame::new()];
        renderers[0].render(&Shot::new(&fine, &camera, wanted), &mut frames[0]).unwrap();
        renderers[1].render(&Shot::new(&usual, &camera, wanted), &mut frames[1]).unwrap();
        for i in 0..96 * 72 {
            let Some(hit) = inside(&caster, &camera, ((i % 96) as f64 + 0.5, (i / 96) as f64 + 0.5)) else { continue };
            let flat = is_flat(&graph, &hit);
            for (which, frame) in frames.iter().enumerate() {
                // Coarser meshes of curves are displaced by up to a quarter of a pixel, and so occlude slightly
                // different pixels.
                if (frame.instance[i], frame.part[i]) != (hit.node, hit.part) {
                    foreign += usize::from(which == 0);
                    continue;
                }
                if which == 0 || flat {
                    pixels[which] += 1;
                    let error = (f64::from(frame.depth[i]) / hit.depth - 1.0).abs();
                    assert!(error < 1e-4, "pixel {i} of frame {which}, {}: depth is off by {error}", hit.node);
                }
                if flat {
                    flats[which] += 1;
                    let off = (hit.normal.cast::<f32>() - Vector3::from(frame.normal[i])).norm();
                    assert!(off < 1e-3, "pixel {i} of frame {which}, {}: the normal is off by {off}", hit.node);
                }
            }
        }
    }
    eprintln!("{pixels:?} pixels, {flats:?} of what is flat, {foreign} other ids");
    assert!(pixels[0] > 15_000 && flats[1] > 5_000, "{pixels:?} pixels, {flats:?} of what is flat");
    assert!(foreign * 5000 < pixels[0], "{foreign} of {} ids differ", pixels[0]);
}

#[test]
fn where_nothing_is_seen_all_buffers_say_so() {
    let mut stage = Stage::new();
    stage.one("ball", Shape::Sphere { radius: 0.4 }, Pose::translation(2.0, 0.4, 0.2), 0);
    stage.one("book", block([0.1, 0.3, 0.2]), pose([2.0, -0.5, -0.2], 0.5, 0.2), 1);
    let graph = stage.build();
    let caster = Caster::new(&graph, 0.0005);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&graph).unwrap();
    let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::origin(), Point3::new(1.0, 0.0, 0.0));
    let later = Camera { pose: camera.pose * Pose::translation(0.02, 0.0, 0.0), ..camera };
    let wanted = Modalities::new(Modality::ALL).without(Modality::Rgb);
    let shot = Shot::new(&snapshot, &camera, wanted).after(&snapshot, &later).before(&snapshot, &later);
    let mut frame = Frame::new();
    renderer.render(&shot, &mut frame).unwrap();
    let (mut seen, mut wrong) = (0, 0);
    for (i, node) in frame.instance.iter().enumerate() {
        let nothing = *node == NOTHING;
        seen += usize::from(!nothing);
        let hit = caster.cast(&camera, (i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
        wrong += usize::from(hit.map_or(NOTHING, |h| h.node) != *node);
        for far in [frame.depth[i], frame.distance[i]] {
            assert!(if nothing { far == f32::INFINITY } else { far > 1.0 && far < 3.0 }, "pixel {i}: {far}");
        }
        for label in [frame.part[i], frame.class[i]] {
            assert_eq!(label == NO_LABEL, nothing, "pixel {i}");
        }
        let length = Vector3::from(frame.normal[i]).norm();
        assert!((length - if nothing { 0.0 } else { 1.0 }).abs() < 1e-5, "pixel {i}: a normal of length {length}");
        assert!(frame.position[i].iter().all(|v| if nothing { *v == f32::INFINITY } else { v.is_finite() }));
        for flow in [frame.flow_forward[i], frame.flow_backward[i]] {
            assert!(flow.iter().all(|v| v.is_nan() == nothing), "pixel {i}: {flow:?}");
        }
        assert!(!nothing || (frame.occluded_forward[i], frame.occluded_backward[i]) == (1, 1), "pixel {i}");
    }
    // Outlines are those of coarser meshes.
    assert!(seen > 300 && seen < 2000 && wrong < 20, "{seen} pixels, {wrong} of them wrong");
    assert_eq!(frame.points().count(), seen);
    assert_eq!(frame.boxes.iter().map(|b| b.area as usize).sum::<usize>(), seen);
}

//! A home of three rooms at the default level of detail, compared with a ray caster.

#![allow(clippy::unwrap_used)]

use crate::common;
#[path = "../../benches/support/home.rs"]
#[allow(dead_code, reason = "only what stands in it is of use here")]
mod rooms;

use common::caster::Caster;
use vc_render::{Daylight, Frame, Modality, NOTHING, Renderer, Shot};

#[test]
fn ids_and_depths_at_the_usual_detail_are_those_of_a_ray_caster() {
    let graph = rooms::home(4, 300).graph;
    let caster = Caster::new(&graph, 0.0005);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&graph).unwrap();
    let (width, height) = (80, 60);
    let (mut pixels, mut foreign, mut deep, mut far) = (0_u32, 0_u32, 0_u32, 0_u32);
    for camera in rooms::cameras(width as u32, height as u32).iter().step_by(5) {
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, camera, Modality::Instance | Modality::Depth), &mut frame).unwrap();
        let seen = |x: f64, y: f64| caster.cast(camera, x, y);
        for (i, &node) in frame.instance.iter().enumerate() {
            let (x, y) = ((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
            let hit = seen(x, y);
            let own = hit.map_or(NOTHING, |h| h.node);
            // Skips edges, where outlines differ by a quarter of a pixel and thin things may be missed.
            let around = [(0.3, 0.0), (-0.3, 0.0), (0.0, 0.3), (0.0, -0.3)];
            if around.iter().any(|(dx, dy)| seen(x + dx, y + dy).map_or(NOTHING, |h| h.node) != own) {
                continue;
            }
            pixels += 1;
            foreign += u32::from(own != node);
            let off = hit.filter(|_| own == node).map_or(0.0, |h| (f64::from(frame.depth[i]) / h.depth - 1.0).abs());
            deep += u32::from(off > 1e-4);
            far += u32::from(off > 3e-3);
        }
    }
    eprintln!("{pixels} pixels: {foreign} other ids, {deep} other depths, {far} far off");
    assert!(pixels > 15_000);
    assert!(foreign * 2000 < pixels, "{foreign} of {pixels} ids differ");
    // Curves are as coarse as an image of this size permits: with finer meshes there is no difference.
    assert!(deep * 100 < pixels, "{deep} of {pixels} depths differ");
    assert!(far * 2000 < pixels, "{far} of {pixels} depths are far off");
}

#[test]
fn colours_of_a_home_are_the_same_for_any_number_of_threads() {
    let graph = rooms::home(4, 300).graph;
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&graph).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    for (number, camera) in rooms::cameras(96, 160).iter().enumerate() {
        let of = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut frame = Frame::new();
            let shot = Shot { lighting: Some(&lighting), ..Shot::new(&snapshot, camera, Modality::Rgb) };
            pool.install(|| renderer.render(&shot, &mut frame)).unwrap();
            frame.rgb
        };
        assert!(of(1) == of(3), "camera {number}: walls and doors have faces to several rooms");
    }
}

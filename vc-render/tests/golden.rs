//! Small pictures of all modalities, compared byte by byte with those in `tests/golden`.
//!
//! A change in them is either intended or a bug. If it is intended,
//! `VC_GOLDEN=write cargo test -p vc-render --test golden` rewrites them: look at them before they are
//! committed.

#![allow(clippy::unwrap_used)]

mod common;

use std::path::PathBuf;

use common::{cameras, lamplit};
use nalgebra::Vector3;
use vc_graph::State;
use vc_render::picture::{self, Picture};
use vc_render::{Camera, Daylight, Frame, Modalities, Modality, PathTracing, Renderer, Shot};
use vc_testkit::golden;

/// Decodes a PNG file.
fn read(bytes: &[u8]) -> Picture {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let pixels = pixels.as_chunks::<3>().0.to_vec();
    Picture { width: info.width as usize, height: info.height as usize, pixels }
}

fn compare(name: &str, made: &Picture) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(format!("{name}.png"));
    let Some(kept) = golden::kept(&path, &picture::png(made).unwrap()) else { return };
    let kept = read(&kept);
    assert_eq!((made.width, made.height), (kept.width, kept.height), "{name}: another size");
    let other = made.pixels.iter().zip(&kept.pixels).filter(|(a, b)| a != b).count();
    assert!(other == 0, "{name}: {other} of {} pixels differ; see the head of this file", made.pixels.len());
}

/// Cameras of the room, with the daylight of each.
fn views() -> Vec<(&'static str, Camera, Daylight)> {
    let cameras = cameras(64, 48);
    let above = Camera::with_fov(64, 48, 1.5).looking([-1.5, 1.0, 2.5].into(), [-0.4, 0.0, 0.0].into());
    vec![
        ("corner", cameras[0], Daylight::noon()),
        ("close", cameras[2], Daylight::overcast()),
        ("above", above, Daylight::night()),
    ]
}

#[test]
fn modalities_are_as_they_were() {
    let mut renderer = Renderer::new();
    let scene = lamplit();
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    scene.nodes().filter(|n| &**n.class() == "ceiling_lamp").for_each(|n| snapshot.switch(n.id(), true).unwrap());
    // The next moment: the camera has moved, and the drawer is shut.
    let mut next = snapshot.clone();
    let dresser = scene.nodes().find(|n| n.is(State::Open)).unwrap().id();
    next.articulate(dresser, |_| Some(0.0)).unwrap();
    for (name, camera, daylight) in views() {
        let lighting = renderer.light(&snapshot, &daylight);
        let step = nalgebra::Translation3::from(Vector3::new(0.03, 0.0, 0.06));
        let then = Camera { pose: camera.pose * step, ..camera };
        let wanted = Modalities::SIX | Modality::Normal | Modality::Part | Modality::Amodal;
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, wanted).lit(&lighting).after(&next, &then), &mut frame).unwrap();
        let rgb = picture::rgb(&frame);
        let labels = [
            picture::instances(&frame),
            picture::classes(&frame),
            picture::depth(&frame, 6.0),
            picture::normals(&frame),
            picture::flow(&frame, 8.0),
            picture::with_boxes(Picture::new(64, 48, [40; 3]), &frame, 10),
        ];
        compare(&format!("{name}_labels"), &Picture::sheet(&labels, 3, 1));
        compare(&format!("{name}_colours"), &rgb);
    }
}

#[test]
fn the_reference_picture_is_as_it_was() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&lamplit()).unwrap();
    let mut lamps = snapshot.clone();
    snapshot.nodes().for_each(|n| lamps.switch(n, true).unwrap());
    let how = PathTracing { samples: 8, ..PathTracing::default() };
    for (name, camera, daylight) in views().into_iter().skip(1) {
        let reference_picture =
            renderer.reference_picture(&renderer.light(&lamps, &daylight), &camera, &how, |_| true).unwrap();
        compare(&format!("{name}_reference"), &reference_picture.picture());
    }
}

//! Supersampled colours: thin things are whole, and labels are unchanged.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, cameras, furnished, material, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_render::{Camera, Daylight, Frame, Modalities, Modality, RenderError, Renderer, Shot};

#[test]
fn bars_thinner_than_a_pixel_do_not_break_up() {
    let mut stage = Stage::new();
    let white = stage.library.add_material(material("plain", [0.9; 3])).unwrap();
    let black = stage.library.add_material(material("plain", [0.01; 3])).unwrap();
    // A pixel is 2 cm wide there, the bar 8 mm and slightly tilted.
    stage.one("wall", block([0.1, 4.0, 4.0]), Pose::translation(2.2, 0.0, 0.0), black);
    stage.one("floor", block([4.0, 4.0, 0.1]), Pose::translation(0.0, 0.0, -2.0), white);
    let turn = nalgebra::UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.06);
    let bar = Pose::from_parts(Vector3::new(2.0, 0.0, 0.0).into(), turn);
    stage.one("bar", block([0.004, 3.0, 0.004]), bar, white);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::overcast());
    let camera =
        Camera::with_intrinsics(96, 72, (100.0, 100.0), (48.0, 36.0)).looking(Point3::origin(), [1.0, 0.0, 0.0].into());
    let missing = |times: u32| {
        let mut frame = Frame::new();
        let shot = Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting).supersampled(times);
        renderer.render(&shot, &mut frame).unwrap();
        let wall = frame.rgb[5 * 96 + 48][1];
        let brightest = |x: usize| (0..72).map(|y| frame.rgb[y * 96 + x][1]).max().unwrap();
        (0..96).filter(|x| brightest(*x) < wall.saturating_add(30)).count()
    };
    assert!(missing(1) > 10, "the bar is too thick for this test");
    assert_eq!(missing(4), 0);
}

#[test]
fn labels_are_what_they_were_and_colours_nearly() {
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&furnished()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let camera = cameras(96, 72)[0];
    let wanted = Modalities::SIX | Modality::Normal;
    let shot = Shot::new(&snapshot, &camera, wanted).lit(&lighting).after(&snapshot, &camera);
    let (mut plain, mut fine) = (Frame::new(), Frame::new());
    renderer.render(&shot, &mut plain).unwrap();
    // A frame that was used for other pictures before works as well.
    renderer.render(&shot.supersampled(3), &mut fine).unwrap();
    renderer.render(&shot, &mut fine).unwrap();
    assert!(fine.rgb == plain.rgb);
    renderer.render(&shot.supersampled(2), &mut fine).unwrap();
    assert!(fine.modalities == wanted && fine.rgb.len() == 96 * 72);
    assert!(fine.instance == plain.instance && fine.depth == plain.depth && fine.normal == plain.normal);
    assert!(fine.boxes == plain.boxes);
    let off = |(a, b): (&[u8; 3], &[u8; 3])| a[1].abs_diff(b[1]) > 12;
    let far = fine.rgb.iter().zip(&plain.rgb).filter(|pair| off(*pair)).count();
    // Only pixels at edges differ.
    assert!(far * 5 < plain.rgb.len(), "{far} pixels differ");
}

#[test]
fn too_many_pixels_are_refused() {
    let mut stage = Stage::new();
    stage.one("ball", block([0.1; 3]), pose([2.0, 0.0, 0.0], 0.0, 0.0), 0);
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let camera = Camera::with_fov(64, 48, 1.0);
    let mut frame = Frame::new();
    for times in [129, u32::MAX] {
        let shot = Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting).supersampled(times);
        assert!(matches!(renderer.render(&shot, &mut frame), Err(RenderError::BadSize { .. })));
    }
    let unlit = Shot::new(&snapshot, &camera, Modality::Rgb).supersampled(2);
    assert!(matches!(renderer.render(&unlit, &mut frame), Err(RenderError::Missing { .. })));
}

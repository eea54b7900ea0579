//! In fast pictures, penumbrae widen with the distance of the blocker.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::{Material, Shape};
use vc_render::{Camera, Daylight, Frame, Modality, Renderer, Shot};

const WIDTH: usize = 96;
const HEIGHT: usize = 48;

/// Brightness along the middle row, for a floor with or without a board above it.
fn row(lamp: Option<f32>, board: Option<[f32; 2]>, day: &Daylight, camera: &Camera) -> Vec<f64> {
    let mut stage = Stage::new();
    let matt = Material { roughness: 1.0, ..material("plain", [0.6; 3]) };
    let matt = stage.library.add_material(matt).unwrap();
    stage.one("floor", block([1.5, 2.5, 0.05]), Pose::translation(0.0, 0.0, -0.05), matt);
    if let Some(height) = lamp {
        stage.one("ceiling_lamp", Shape::Sphere { radius: 0.1 }, Pose::translation(0.0, 0.0, height), 3);
    }
    if let Some([y, z]) = board {
        stage.one("board", block([1.2, 0.3, 0.002]), Pose::translation(0.0, y, z), matt);
    }
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let lighting = renderer.light(&snapshot, day);
    let mut frame = Frame::new();
    renderer.render(&Shot::new(&snapshot, camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
    let own = &frame.rgb[HEIGHT / 2 * WIDTH..(HEIGHT / 2 + 1) * WIDTH];
    own.iter().map(|rgb| rgb.iter().map(|v| f64::from(*v)).sum()).collect()
}

/// Number of pixels in a row that lack between a tenth and nine tenths of the light missing in the shadow.
fn width(shaded: &[f64], bare: &[f64]) -> usize {
    // Relative to the floor without a board, so that light may fall off along it.
    let shares: Vec<f64> = shaded.iter().zip(bare).map(|(own, all)| own / all).collect();
    let low = shares.iter().copied().fold(f64::INFINITY, f64::min);
    let high = shares.iter().copied().fold(0.0, f64::max);
    assert!(high - low > 0.15, "there is no shadow: {low} to {high}");
    shares.iter().filter(|v| (0.1..0.9).contains(&((**v - low) / (high - low)))).count()
}

/// An overhead view of a strip of floor of a given width in metres around a point on the y axis.
fn above(y: f32, wide: f32) -> Camera {
    let span = wide * HEIGHT as f32 / WIDTH as f32;
    Camera::with_fov(WIDTH as u32, HEIGHT as u32, 0.5).overhead(Point3::new(0.0, y, 0.0), span)
}

#[test]
fn the_suns_shadows_widen_with_distance() {
    // The sun is halfway up in the direction of y: a board's shadow is displaced by its height.
    let day = Daylight { towards_sun: Vector3::new(0.0, 1.0, 1.0).normalize(), ..Daylight::noon() };
    let [near, far] = [0.1, 1.6].map(|height: f32| {
        let camera = above(-0.3 - height, 0.16);
        width(&row(None, Some([0.0, height]), &day, &camera), &row(None, None, &day, &camera))
    });
    eprintln!("{near} and {far} pixels");
    // The penumbrae are 32 mm across the light, and less than a texel of the shadow map.
    assert!(near >= 1 && far > 2 * near, "an edge of {near} pixels from near, of {far} from afar");
}

#[test]
fn a_lamps_shadows_widen_with_distance() {
    const UP: f32 = 2.2;
    let day = Daylight::night();
    let edge = 1.35;
    let camera = above(edge, 0.48);
    let [near, far] = [0.3, 1.2].map(|height: f32| {
        // The board ends where its shadow's edge falls on the same place each time.
        let end = edge * (UP - height) / UP;
        let board = Some([end - 0.3, height]);
        width(&row(Some(UP), board, &day, &camera), &row(Some(UP), None, &day, &camera))
    });
    eprintln!("{near} and {far} pixels");
    assert!(near >= 1 && far > 2 * near, "an edge of {near} pixels from near, of {far} from afar");
}

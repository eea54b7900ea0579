//! In reference pictures, a mirror shows the things in front of it.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, material, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::Pose;
use vc_graph::asset::{Material, Shape};
use vc_render::{Camera, Daylight, PathTracing, Renderer};

const SIZE: (usize, usize) = (64, 48);

/// Light at pixels, seen from one point towards another. The scene consists of three luminous things around x =
/// -1 and, if wanted, a mirror at x = 2; direct emission has no noise.
fn seen(mirror: bool, eye: [f32; 3], target: [f32; 3]) -> Vec<[f32; 3]> {
    let mut stage = Stage::new();
    let mut glow = |emission: [f32; 3]| {
        let made = Material { emission, roughness: 1.0, ..material("plain", [0.0; 3]) };
        stage.library.add_material(made).unwrap()
    };
    let [red, green, blue] = [glow([90.0, 5.0, 5.0]), glow([5.0, 60.0, 5.0]), glow([10.0, 5.0, 120.0])];
    stage.one("tv", block([0.05, 0.4, 0.3]), pose([-1.0, 0.9, 0.5], 0.4, 0.1), red);
    stage.one("tv", Shape::Sphere { radius: 0.4 }, Pose::translation(-1.3, -0.6, 0.4), green);
    stage.one("tv", block([0.1, 0.5, 0.2]), pose([-0.9, 0.1, -0.7], -0.3, 0.0), blue);
    if mirror {
        stage.one("mirror", block([0.1, 3.0, 3.0]), Pose::translation(2.1, 0.0, 0.0), 4);
    }
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let none = Vector3::zeros();
    let dark = Daylight { zenith: none, horizon: none, ground: none, ..Daylight::night() };
    let lighting = renderer.light(&snapshot, &dark);
    let camera = Camera::with_fov(SIZE.0 as u32, SIZE.1 as u32, 0.5).looking(Point3::from(eye), Point3::from(target));
    let how = PathTracing { samples: 4, denoise: false, brightest: f32::INFINITY, ..PathTracing::default() };
    renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap().light
}

/// The light of a pixel, if its eight neighbours have the same light, so that it is not at an edge.
fn even(light: &[[f32; 3]], x: usize, y: usize) -> Option<[f32; 3]> {
    let own = light[y * SIZE.0 + x];
    let alike = |at: [f32; 3]| (0..3).all(|c| (at[c] - own[c]).abs() <= 1e-3 * own[c]);
    (y - 1..y + 2)
        .flat_map(|y| (x - 1..x + 2).map(move |x| (x, y)))
        .all(|(x, y)| alike(light[y * SIZE.0 + x]))
        .then_some(own)
}

#[test]
fn a_mirror_shows_what_an_eye_behind_it_would_see_the_other_way_round() {
    let eye = [0.3, 0.1, -0.1];
    let shown = seen(true, eye, [2.0, 0.1, -0.1]);
    let wanted = seen(false, [4.0 - eye[0], eye[1], eye[2]], [2.0, 0.1, -0.1]);
    // Counts by colour, the last one for dark pixels.
    let mut counts = [0; 4];
    for (x, y) in (1..SIZE.1 - 1).flat_map(|y| (1..SIZE.0 - 1).map(move |x| (x, y))) {
        let Some(light) = even(&wanted, SIZE.0 - 1 - x, y) else { continue };
        let own = shown[y * SIZE.0 + x];
        // The mirror reflects nine tenths.
        for c in 0..3 {
            let share = 0.9 * light[c];
            assert!((own[c] - share).abs() <= 0.01 * share, "pixel {x}, {y}: {own:?}, not 0.9 of {light:?}");
        }
        let brightest = (0..3).max_by(|a, b| light[*a].total_cmp(&light[*b])).unwrap();
        counts[if light[brightest] > 0.0 { brightest } else { 3 }] += 1;
    }
    assert!(counts.iter().all(|n| *n > 40), "{counts:?} pixels of each thing");
}

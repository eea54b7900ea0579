//! Scenes that are drawn beside each other, as regions of a city are.

#![allow(clippy::unwrap_used)]

use nalgebra::{Point3, Vector3};
use vc_graph::{Pose, SceneGraph};
use vc_render::{Camera, Daylight, Frame, Modality, PathTracing, Renderer, Shot, Snapshot};

use crate::common::{Stage, block, pose};

/// A floor of boards with nothing on it.
fn floor() -> SceneGraph {
    let mut stage = Stage::new();
    stage.one("floor", block([2.0, 2.0, 0.05]), Pose::identity(), 0);
    stage.build()
}

/// The correlation of the light of two pictures, which does not depend on how bright each is.
fn alike(one: &[f32], other: &[f32]) -> f32 {
    let off = |all: &[f32]| {
        let mean = all.iter().sum::<f32>() / all.len() as f32;
        all.iter().map(|light| light - mean).collect::<Vec<f32>>()
    };
    let (one, other) = (off(one), off(other));
    let product = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
    product(&one, &other) / (product(&one, &one) * product(&other, &other)).sqrt()
}

/// Boards of a floor lie as in pictures of its scene alone, from whichever of two scenes they are seen.
#[test]
fn boards_lie_where_they_lie_in_their_own_scene() {
    let mut renderer = Renderer::new();
    let [here, there] = [floor(), floor()].map(|scene| renderer.snapshot(&scene).unwrap());
    // The same from all sides, however a scene is turned.
    let sky = Vector3::repeat(0.5);
    let day = Daylight { zenith: sky, horizon: sky, ground: sky, ..Daylight::night() };
    let (eye, at) = (Point3::new(-0.5, 0.2, 1.6), Point3::new(0.2, -0.1, 0.0));
    let drawn = |snapshot: &Snapshot, shift: &Pose| {
        let camera = Camera::with_fov(96, 72, 0.8).looking(shift * eye, shift * at);
        let (light, mut frame) = (renderer.light(snapshot, &day), Frame::new());
        renderer.render(&Shot::new(snapshot, &camera, Modality::Rgb).lit(&light), &mut frame).unwrap();
        let how = PathTracing { samples: 4, denoise: false, ..PathTracing::default() };
        let traced = renderer.reference_picture(&light, &camera, &how, |_| true).unwrap();
        let fast: Vec<f32> = frame.rgb.iter().map(|pixel| f32::from(pixel[0])).collect();
        [fast, traced.light.iter().map(|pixel| pixel[0]).collect()]
    };
    let alone = drawn(&there, &Pose::identity());
    let elsewhere = drawn(&there, &Pose::translation(0.37, 0.23, 0.0));
    let shifts = [
        pose([5.37, 1.13, 0.2], 0.0, 0.0),
        pose([6.1, -2.7, 0.0], 0.65, 0.0),
        pose([0.0, 7.0, 0.0], std::f32::consts::FRAC_PI_2, 0.0),
    ];
    for shift in shifts {
        let both = here.clone().joined(&[(there.clone(), shift)]).unwrap();
        let beside = drawn(&both, &shift);
        for how in 0..2 {
            let (same, other) = (alike(&alone[how], &beside[how]), alike(&alone[how], &elsewhere[how]));
            assert!(same > 0.9 && other < 0.7, "{same} where the boards are the same, {other} where they are others");
        }
    }
}

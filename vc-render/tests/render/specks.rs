//! Outlines in reference pictures have no fireflies.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{cameras, lamplit};
use vc_graph::NodeId;
use vc_render::{Camera, Daylight, Lighting, PathTracing, Renderer};

const SIZE: (usize, usize) = (72, 54);

fn lit() -> (Renderer, Lighting) {
    let mut renderer = Renderer::new();
    let mut snapshot = renderer.snapshot(&lamplit()).unwrap();
    let lamps: Vec<NodeId> = snapshot.lamps().collect();
    lamps.iter().for_each(|lamp| snapshot.switch(*lamp, true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::night());
    (renderer, lighting)
}

fn brightness((renderer, lighting): &(Renderer, Lighting), camera: &Camera, samples: u32, denoise: bool) -> Vec<f32> {
    let how = PathTracing { samples, denoise, ..PathTracing::default() };
    let light = renderer.reference_picture(lighting, camera, &how, |_| true).unwrap().light;
    light.iter().map(|c| 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]).collect()
}

/// The least and the greatest of a pixel and its eight neighbours.
fn range(light: &[f32], index: usize) -> [f32; 2] {
    let (x, y) = (index % SIZE.0, index / SIZE.0);
    let around = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    let near = around(y, SIZE.1).flat_map(|y| around(x, SIZE.0).map(move |x| light[y * SIZE.0 + x]));
    near.fold([f32::INFINITY, 0.0], |[least, most], v| [v.min(least), v.max(most)])
}

#[test]
fn outlines_are_free_of_specks() {
    let made = lit();
    let (mut dark, mut bright) = (0, 0);
    for camera in &cameras(SIZE.0 as u32, SIZE.1 as u32)[..2] {
        let truth = brightness(&made, camera, 256, false);
        let smooth = brightness(&made, camera, 16, true);
        let mean = truth.iter().sum::<f32>() / truth.len() as f32;
        for (index, light) in smooth.iter().enumerate() {
            let [least, most] = range(&truth, index);
            dark += usize::from(*light < 0.5 * least - 0.02 * mean);
            bright += usize::from(*light > 2.0 * most + 0.02 * mean);
        }
    }
    eprintln!("{dark} dark and {bright} bright specks in {} pixels", 2 * SIZE.0 * SIZE.1);
    // Smoothing that ignores outlines leaves six and fifteen.
    assert!(dark == 0 && bright < 12, "{dark} dark and {bright} bright specks");
}

/// Pillars in front of each other under a grey sky.
fn pillars() -> (Renderer, Lighting) {
    let mut stage = common::Stage::new();
    stage.one("floor", common::block([4.0, 4.0, 0.05]), common::pose([0.0, 0.0, -0.05], 0.0, 0.0), 1);
    for i in 0..9 {
        let at = [0.6 * (i % 3) as f32 - 0.5, 0.7 * (i / 3) as f32 - 0.8, 0.8];
        let turn = 0.35 * i as f32;
        stage.one("pillar", common::block([0.1, 0.1, 0.8]), common::pose(at, turn, 0.0), i % 2);
    }
    let mut renderer = Renderer::new();
    let snapshot = renderer.snapshot(&stage.build()).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::overcast());
    (renderer, lighting)
}

#[test]
fn outlines_are_as_in_the_light_of_many_paths() {
    let made = pillars();
    let camera = Camera::with_fov(SIZE.0 as u32, SIZE.1 as u32, 0.9);
    let camera = camera.looking([2.2, -2.4, 1.9].into(), [0.0, 0.0, 0.6].into());
    let truth = brightness(&made, &camera, 256, false);
    let smooth = brightness(&made, &camera, 8, true);
    let ([mut off, mut count], sky) = ([0.0; 2], truth[0]);
    for (index, light) in smooth.iter().enumerate() {
        let [least, most] = range(&truth, index);
        if most > 1.3 * least && most < 0.9 * sky {
            off += (light - truth[index]).abs() / truth[index];
            count += 1.0;
        }
    }
    let off = off / count;
    eprintln!("{off:.3} of the light off, at {count} pixels");
    assert!(count > 200.0 && off < 0.1, "{off} off at {count} pixels");
}

//! Outlines in reference pictures.

#![allow(clippy::unwrap_used)]

mod common;

use common::{cameras, lamplit};
use vc_graph::NodeId;
use vc_render::{Camera, Daylight, Exposure, Lighting, Renderer};

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
    let how = Exposure { samples, denoise, ..Exposure::default() };
    let light = renderer.photograph(lighting, camera, &how, |_| true).unwrap().light;
    light.iter().map(|c| 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]).collect()
}

/// Least and greatest of a pixel and the eight around it.
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
    // Smoothed without regard to them it is six and fifteen.
    assert!(dark == 0 && bright < 12, "{dark} dark and {bright} bright specks");
}

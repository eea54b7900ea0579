//! The home from above, and the ways the agents went.

use nalgebra::{Point2, Point3};
use vc_render::picture::{self, Picture};
use vc_render::{Camera, Modality};

use crate::{Environment, PictureError, Viewpoint};

/// Size of the map, pixels.
const SIZE: (u32, u32) = (960, 720);
/// Colours of a way from its beginning to its end: the first agent's, the second's, the third's, and then the
/// first agent's again.
const WAYS: [[[f32; 3]; 2]; 3] = [
    [[40.0, 110.0, 255.0], [255.0, 60.0, 30.0]],
    [[30.0, 170.0, 90.0], [250.0, 210.0, 40.0]],
    [[120.0, 60.0, 200.0], [255.0, 130.0, 220.0]],
];
/// Half of the width of the way, pixels.
const WIDE: f32 = 2.4;
/// Distance of the points of which the way is drawn, metres.
const FINE: f32 = 0.005;

pub(super) fn of(home: &Environment, ways: &[Vec<Point2<f32>>]) -> Result<Picture, PictureError> {
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, SIZE.0, SIZE.1)?;
    let camera = home.camera(Viewpoint::Overhead, SIZE.0, SIZE.1)?;
    let mut picture = picture::rgb(&frame);
    let level = home.floor().options().level;
    for (way, colours) in ways.iter().zip(WAYS.iter().cycle()) {
        let count = way.len().max(1) as f32;
        for (i, pair) in way.windows(2).enumerate() {
            line(&mut picture, &camera, (pair[0], pair[1]), level, between(colours, i as f32 / count));
        }
    }
    Ok(picture)
}

fn between(colours: &[[f32; 3]; 2], share: f32) -> [u8; 3] {
    [0, 1, 2].map(|c: usize| (colours[0][c] * (1.0 - share) + colours[1][c] * share) as u8)
}

fn line(picture: &mut Picture, camera: &Camera, (a, b): (Point2<f32>, Point2<f32>), level: f32, colour: [u8; 3]) {
    let steps = ((b - a).norm() / FINE).ceil().max(1.0) as usize;
    let reach = WIDE as i32;
    let disc = (-reach..=reach).flat_map(|dx| (-reach..=reach).map(move |dy| (dx, dy)));
    let disc: Vec<(i32, i32)> = disc.filter(|(x, y)| ((x * x + y * y) as f32) < WIDE * WIDE).collect();
    for step in 0..=steps {
        let p = a + (b - a) * (step as f32 / steps as f32);
        let Some(seen) = camera.project(&Point3::new(p.x, p.y, level)) else { continue };
        for (dx, dy) in &disc {
            let (x, y) = (seen.x as i32 + dx, seen.y as i32 + dy);
            if (0..picture.width as i32).contains(&x) && (0..picture.height as i32).contains(&y) {
                picture.pixels[y as usize * picture.width + x as usize] = colour;
            }
        }
    }
}

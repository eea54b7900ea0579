//! Depth, distance and points of pixels.

use crate::camera::Camera;
use crate::frame::Strip;
use crate::math;
use crate::rasterization::Layers;

/// Writes depth, distance and points, as far as they are requested.
#[inline(always)]
pub(crate) fn depths(camera: &Camera, layers: &Layers, strip: &mut Strip<'_>) {
    for y in strip.rows.clone() {
        let row = strip.row(y);
        let inverse = layers.front.inverse_row(y);
        if let Some(depth) = strip.depth.get_mut(row.clone()) {
            depth.iter_mut().zip(inverse).for_each(|(d, v)| *d = 1.0 / v);
        }
        if let Some(distance) = strip.distance.get_mut(row.clone()) {
            distances(camera, y, inverse, distance);
        }
        if let Some(position) = strip.position.get_mut(row) {
            positions(camera, y, inverse, position);
        }
    }
}

#[inline(always)]
fn distances(camera: &Camera, y: i32, inverse: &[f32], distance: &mut [f32]) {
    let down = (y as f32 + 0.5 - camera.centre.1) / camera.focal.1;
    let (scale, centre) = (1.0 / camera.focal.0, camera.centre.0);
    for ((x, out), v) in (0_u32..).zip(distance).zip(inverse) {
        let across = (x as f32 + 0.5 - centre) * scale;
        *out = (across * across + down * down + 1.0).sqrt() / v;
    }
}

#[inline(always)]
fn positions(camera: &Camera, y: i32, inverse: &[f32], position: &mut [[f32; 3]]) {
    let map = math::Affine::from_pose(&camera.pose).narrow();
    let down = (y as f32 + 0.5 - camera.centre.1) / camera.focal.1;
    for ((x, out), v) in (0_u32..).zip(position).zip(inverse) {
        let across = (x as f32 + 0.5 - camera.centre.0) / camera.focal.0;
        let depth = 1.0 / v;
        let seen = math::point(&map, [across * depth, down * depth, depth]);
        *out = if *v > 0.0 { seen } else { [f32::INFINITY; 3] };
    }
}

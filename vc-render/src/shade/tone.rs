//! From light to colours on a screen.

use std::sync::LazyLock;

use rayon::prelude::*;

use crate::frame::Frame;

/// Steps of the table from linear to sRGB.
const STEPS: usize = 4096;

static TABLE: LazyLock<Vec<u8>> = LazyLock::new(|| {
    use vc_graph::portable::Portable;
    let encode = |i: usize| {
        let v = i as f32 / (STEPS - 1) as f32;
        // sRGB's transfer function (IEC 61966-2-1).
        let v = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.power(1.0 / 2.4) - 0.055 };
        (v * 255.0 + 0.5) as u8
    };
    (0..STEPS).map(encode).collect()
});

/// A film's response, after Narkowicz's fit of ACES (2015), linear on a screen.
#[inline(always)]
pub(crate) fn film(x: f32) -> f32 {
    let x = x.max(0.0) * 0.72;
    (x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)).min(1.0)
}

/// A linear colour in sRGB.
#[inline(always)]
pub(crate) fn encoded(colour: [f32; 3]) -> [u8; 3] {
    let table = &TABLE;
    colour.map(|v| table[((v * (STEPS - 1) as f32) as usize).min(STEPS - 1)])
}

/// Light to colours, edges smoothed.
pub(super) fn colours(frame: &mut Frame, exposure: f32) {
    let Frame { light, edges, rgb, width, height, .. } = frame;
    light.par_iter_mut().with_min_len(1 << 14).for_each(|c| *c = c.map(|v| film(v * exposure)));
    let (light, edges, width, height) = (&*light, &*edges, *width, *height);
    rgb.par_chunks_mut(width).with_min_len(16).enumerate().for_each(|(y, row)| {
        for (x, out) in row.iter_mut().enumerate() {
            *out = encoded(smoothed(light, edges, (x, y), (width, height)));
        }
    });
}

/// A pixel's colour with what belongs to its neighbours' surfaces.
#[inline(always)]
fn smoothed(
    light: &[[f32; 3]],
    edges: &[[i8; 2]],
    (x, y): (usize, usize),
    (width, height): (usize, usize),
) -> [f32; 3] {
    let at = y * width + x;
    let own = light[at];
    let share = |e: i8| f32::from(e.max(0)) * (1.0 / 127.0);
    let mut mixed = own;
    let mut add = |there: usize, weight: f32| {
        if weight > 0.0 {
            for i in 0..3 {
                mixed[i] += weight * (light[there][i] - own[i]);
            }
        }
    };
    if x + 1 < width {
        add(at + 1, share(edges[at][0]));
    }
    if y + 1 < height {
        add(at + width, share(edges[at][1]));
    }
    if x > 0 {
        add(at - 1, share(-edges[at - 1][0]));
    }
    if y > 0 {
        add(at - width, share(-edges[at - width][1]));
    }
    mixed.map(|v| v.clamp(0.0, 1.0))
}

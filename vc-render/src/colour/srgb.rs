//! Encoding of linear colours in sRGB, and back.

use std::sync::LazyLock;

use vc_graph::srgb;

use crate::math::three;

/// Steps of the table from linear to sRGB.
pub(super) const STEPS: usize = 4096;

pub(super) static TABLE: LazyLock<Box<[u8; STEPS]>> = LazyLock::new(|| {
    let encode = |i: usize| (srgb::from_linear(i as f32 / (STEPS - 1) as f32) * 255.0 + 0.5) as u8;
    Box::new(std::array::from_fn(encode))
});

/// The table from sRGB back to linear.
static LINEAR: LazyLock<Vec<f32>> = LazyLock::new(|| (0..256).map(|i| srgb::to_linear(i as f32 / 255.0)).collect());

/// Luminance of a linear colour (Rec. 709).
#[inline(always)]
pub(crate) fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Encodes a linear colour in sRGB.
#[inline(always)]
pub(crate) fn encoded(colour: [f32; 3]) -> [u8; 3] {
    let table: &[u8; STEPS] = &TABLE;
    three(|c| table[((colour[c] * (STEPS - 1) as f32) as usize).min(STEPS - 1)])
}

/// Decodes an sRGB colour to linear.
#[inline(always)]
pub(crate) fn decoded(colour: [u8; 3]) -> [f32; 3] {
    let table = &*LINEAR;
    three(|c| table[usize::from(colour[c])])
}

//! Tone mapping: from light to display colours.

use std::sync::LazyLock;

use crate::affine::three;

/// Steps of the table from linear to sRGB.
const STEPS: usize = 4096;

static TABLE: LazyLock<Box<[u8; STEPS]>> = LazyLock::new(|| {
    use vc_graph::portable::Portable;
    let encode = |i: usize| {
        let v = i as f32 / (STEPS - 1) as f32;
        // sRGB's transfer function (IEC 61966-2-1).
        let v = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.power(1.0 / 2.4) - 0.055 };
        (v * 255.0 + 0.5) as u8
    };
    Box::new(std::array::from_fn(encode))
});

/// The table from sRGB back to linear.
static LINEAR: LazyLock<Vec<f32>> = LazyLock::new(|| {
    use vc_graph::portable::Portable;
    let decode = |i: usize| {
        let v = i as f32 / 255.0;
        if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).power(2.4) }
    };
    (0..256).map(decode).collect()
});

/// The tone curve, in linear display light: the response of the eye's photoreceptors (Naka and Rushton 1966),
/// which never saturates, with a shoulder that keeps the sky and the surroundings of lamps distinct from white.
/// A white wall in the light of its room is displayed at a half, ten times that light at six sevenths, and a
/// hundred times at nineteen twentieths.
pub(crate) fn film(x: f32) -> f32 {
    use vc_graph::portable::Portable;
    let light = 1.9 * x.max(0.0);
    let beyond = (light / SHOULDER).raised(4);
    let strength = light.power(CONTRAST) / (1.0 + beyond).power(FLATTER / 4.0);
    if light < 1e9 { strength / (1.0 + strength) } else { 1.0 }
}

/// Slope of the tone curve in the middle, the light from which on it is flatter, and by how much.
const CONTRAST: f32 = 1.2;
const SHOULDER: f32 = 2.0;
const FLATTER: f32 = 0.6;

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

/// Bits of a float between neighbouring entries of the table from light to colours, and the light of its first
/// entry and the brightest it is used for.
const PART: u32 = 15;
const DARK: f32 = 1.0 / 4096.0;
const BRIGHT: f32 = 65536.0;

/// Number of entries of the table, a power of two; the last ones are unused.
const ENTRIES: usize = 8192;

/// The table from light, in 256 steps for each doubling, to sRGB.
static FILM: LazyLock<Box<[u8; ENTRIES]>> = LazyLock::new(|| {
    let first = (DARK.to_bits() >> PART) as usize;
    let colour = |step: u32| encoded([film(f32::from_bits(step << PART | 1 << (PART - 1))); 3])[0];
    Box::new(std::array::from_fn(|entry| colour((first + entry) as u32)))
});

/// Display colours for the light of a row's pixels.
#[allow(clippy::manual_clamp, reason = "what is no number is dark")]
#[inline(always)]
pub(super) fn colours(light: [&[f32]; 3], exposure: [f32; 3], out: &mut [[u8; 3]]) {
    let table: &[u8; ENTRIES] = &FILM;
    let mut steps = [[0_u32; 64]; 3];
    for (part, out) in out.chunks_mut(64).enumerate() {
        for ((steps, light), exposure) in steps.iter_mut().zip(light).zip(exposure) {
            for (step, light) in steps.iter_mut().zip(&light[part * 64..]) {
                let light = (light * exposure).max(DARK).min(BRIGHT);
                *step = (light.to_bits() - DARK.to_bits()) >> PART;
            }
        }
        let colour = |step: u32| table[step as usize % ENTRIES];
        for (i, out) in out.iter_mut().enumerate() {
            *out = [colour(steps[0][i]), colour(steps[1][i]), colour(steps[2][i])];
        }
    }
}

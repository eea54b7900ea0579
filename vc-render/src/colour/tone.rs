//! Tone mapping: from light to display colours.

use std::sync::LazyLock;

use super::srgb::{STEPS, TABLE, luminance};
use crate::math::simd::whole;
use crate::math::three;

/// The strength of the eye's response to light: the tone curve before it saturates. It grows with the light's power of
/// [`CONTRAST`] up to [`SHOULDER`], and from there on more slowly, by [`FLATTER`].
fn strength(x: f32) -> f32 {
    use vc_graph::portable::Portable;
    let light = GAIN * x;
    light.power(CONTRAST) / (1.0 + (light / SHOULDER).raised(4)).power(FLATTER / 4.0)
}

const GAIN: f32 = 1.7;
const CONTRAST: f32 = 1.2;
const SHOULDER: f32 = 1.3;
const FLATTER: f32 = 0.7;

/// How far all colours of a light saturate together, by the greatest of them, and not each by itself: bright things
/// keep their colour. The strength from which on this is lost: the brightest lights are white.
const TOGETHER: f32 = 0.6;
const WHITE: f32 = 40.0;

/// The exposure from which on pictures are displayed darker, and the exponent: in darkness eyes see what there is, but
/// the night stays dark, its sky too.
const NIGHT: f32 = 2500.0;
const NIGHTFALL: f32 = 0.35;

/// How bright a picture of an exposure is displayed, 0 to 1: less than 1 at night.
pub(crate) fn night(exposure: f32) -> f32 {
    use vc_graph::portable::Portable;
    if exposure > NIGHT { (NIGHT / exposure).power(NIGHTFALL) } else { 1.0 }
}

/// A colour in linear display light, given the strength of the greatest of its parts.
#[inline(always)]
fn saturated(light: [f32; 3], greatest: f32, strength: f32) -> [f32; 3] {
    let (over, together) = (strength / greatest, TOGETHER / (1.0 + strength / WHITE));
    let bottom = 1.0 + together * strength;
    three(|c| light[c] * over / (bottom + (1.0 - together) * light[c] * over))
}

/// Light at an exposure, within what the tone curve is made for; what is no number is dark.
#[allow(clippy::manual_clamp, reason = "what is no number is dark")]
#[inline(always)]
fn within(light: f32, exposure: f32) -> f32 {
    (light * exposure).max(DARK).min(BRIGHT)
}

/// The display colour of light at an exposure, linear: the response of the eye's photoreceptors (Naka and Rushton
/// 1966), which never saturates, with a shoulder that keeps the shading of sunlit things, the sky and the surroundings
/// of lamps distinct from white, and keeps their hue. A white wall in the light of its room is displayed at two fifths,
/// ten times that light at three quarters, and a hundred times at nine tenths.
pub(crate) fn displayed(light: [f32; 3], exposure: [f32; 3]) -> [f32; 3] {
    let light = three(|c| within(light[c], exposure[c]));
    let greatest = light[0].max(light[1]).max(light[2]);
    let (shown, dim) = (saturated(light, greatest, strength(greatest)), night(luminance(exposure)));
    three(|c| dim * shown[c])
}

/// Bits of a float between neighbouring entries of the table of strengths, and the light of its first entry and the
/// brightest it is used for.
const PART: u32 = 15;
const DARK: f32 = 1.0 / 4096.0;
const BRIGHT: f32 = 65536.0;

/// Number of entries of the table, a power of two; the last ones are unused.
const ENTRIES: usize = 8192;

/// The table of [`strength`], in 256 steps for each doubling of the light.
static STRENGTHS: LazyLock<Box<[f32; ENTRIES]>> = LazyLock::new(|| {
    let first = (DARK.to_bits() >> PART) as usize;
    let of = |step: u32| strength(f32::from_bits(step << PART | 1 << (PART - 1)));
    Box::new(std::array::from_fn(|entry| of((first + entry) as u32)))
});

/// Number of pixels converted together.
const MANY: usize = 64;

/// Display colours for the light of a row's pixels, as [`displayed`] gives them.
#[inline(always)]
pub(crate) fn colours(light: [&[f32]; 3], exposure: [f32; 3], out: &mut [[u8; 3]]) {
    let (strengths, codes): (&[f32; ENTRIES], &[u8; STEPS]) = (&STRENGTHS, &TABLE);
    let top = (STEPS - 1) as f32 * night(luminance(exposure));
    for (part, out) in out.chunks_mut(MANY).enumerate() {
        let (mut exposed, mut greatest, mut strong) = ([[DARK; MANY]; 3], [DARK; MANY], [0.0; MANY]);
        for ((exposed, light), exposure) in exposed.iter_mut().zip(light).zip(exposure) {
            for ((exposed, greatest), light) in exposed.iter_mut().zip(&mut greatest).zip(&light[part * MANY..]) {
                *exposed = within(*light, exposure);
                *greatest = greatest.max(*exposed);
            }
        }
        for (strong, greatest) in strong.iter_mut().zip(&greatest) {
            *strong = strengths[(greatest.to_bits() - DARK.to_bits()) as usize >> PART & (ENTRIES - 1)];
        }
        let mut steps = [[0_u32; MANY]; 3];
        for i in 0..MANY {
            let shown = saturated(exposed.each_ref().map(|list| list[i]), greatest[i], strong[i]);
            (0..3).for_each(|c| steps[c][i] = whole(shown[c] * top));
        }
        for (i, out) in out.iter_mut().enumerate() {
            *out = three(|c| codes[steps[c][i] as usize % STEPS]);
        }
    }
}

#[cfg(test)]
mod tests {
    use vc_graph::portable::Portable;

    use super::super::encoded;
    use super::{colours, displayed};

    /// Fast pictures and reference pictures display the same light in the same colours, by day and at night.
    #[test]
    fn fast_colours_are_those_of_references() {
        let light = |i: usize, k: usize| 1.05_f32.power(i as f32) * [1e-4, 3e-5, 2e-3][k];
        let lists = [0, 1, 2].map(|k| (0..256).map(|i| light(i, k)).collect::<Vec<f32>>());
        for exposure in [[8.0, 9.0, 10.0], [4e4; 3]] {
            let mut fast = [[0; 3]; 256];
            colours([&lists[0], &lists[1], &lists[2]], exposure, &mut fast);
            for (i, fast) in fast.iter().enumerate() {
                let reference = encoded(displayed([light(i, 0), light(i, 1), light(i, 2)], exposure));
                assert!((0..3).all(|c| fast[c].abs_diff(reference[c]) <= 2), "{i}: {fast:?}, {reference:?}");
            }
        }
    }
}

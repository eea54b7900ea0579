//! A surface point's appearance: its material modified by its texture.

use super::{Pattern, Surface, Tile};
use crate::math::{self, Narrow, three, unit};

/// The surface at a point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Appearance {
    pub(crate) colour: [f32; 3],
    pub(crate) roughness: f32,
    pub(crate) normal: [f32; 3],
}

/// The appearance at a point. `local` is its position and `facing` the axis along which the triangle faces, both in
/// the frame that `axes` leads from; `footprint` is the diameter to average over, metres.
#[inline(always)]
pub(crate) fn textured(
    surface: &Surface,
    (local, facing, grain): ([f32; 3], u8, u8),
    axes: &Narrow,
    normal: [f32; 3],
    footprint: f32,
) -> Appearance {
    let tile = Tile::for_pattern(surface.pattern);
    let (u, v) = texture_axes(surface.pattern, (facing, grain));
    let touch = tile.at(tile.level(footprint), local[u], local[v]);
    let colour = three(|i| surface.colour[i] * touch.tint[i]);
    let roughness = (surface.roughness * touch.roughness).clamp(0.02, 1.0);
    if touch.lean == [0.0; 2] {
        return Appearance { colour, roughness, normal };
    }
    let axis = |a: usize, by: f32| {
        let mut own = [0.0; 3];
        own[a] = by;
        math::vector(axes, own)
    };
    let (a, b) = (axis(u, touch.lean[0]), axis(v, touch.lean[1]));
    Appearance { colour, roughness, normal: unit(three(|i| normal[i] + a[i] + b[i])) }
}

/// The axes along which a texture is laid, across and with the grain, on a surface that faces along an axis.
/// Courses of bricks are level on all vertical surfaces, whatever their lengths.
#[inline(always)]
pub(crate) fn texture_axes(pattern: Pattern, (facing, grain): (u8, u8)) -> (usize, usize) {
    let (a, b) = [(1, 2), (0, 2), (0, 1)][usize::from(facing)];
    let level = pattern == Pattern::Bricks && b == 2;
    if usize::from(grain) == a && !level { (b, a) } else { (a, b) }
}

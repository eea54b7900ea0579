//! Textures mapped onto visible surfaces.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::sync::Arc;

use super::planes::packed;
use crate::math::{self, Narrow, three};
use crate::surface::{Picture, SPAN, Span, Tile, Touch};

/// A texture mapped onto a surface.
#[derive(Debug, Clone)]
pub(super) struct Texture {
    cloth: Cloth,
    /// Map from (x, y, 1) times depth to texture coordinates.
    places: [[f32; 4]; 2],
}

/// The texture itself.
#[derive(Debug, Clone)]
enum Cloth {
    /// A pattern, and the world directions along which it tilts normals.
    Tile(&'static Tile, [[f32; 3]; 2]),
    /// An image texture, and its texels for each metre.
    Picture(Arc<Picture>, f32),
}

impl Texture {
    /// A pattern along two axes of a frame, given the map from (x, y, 1) times depth into that frame and the
    /// one from there to the world.
    pub(super) fn tile(tile: &'static Tile, (u, v): (usize, usize), (back, axes): (&Narrow, &Narrow)) -> Self {
        let column = |c: usize| [axes[0][c], axes[1][c], axes[2][c]];
        Self { cloth: Cloth::Tile(tile, [column(u), column(v)]), places: [back[u], back[v]] }
    }

    /// An image texture on a triangle, given its corners, their texture coordinates, and the same maps.
    pub(super) fn picture(
        picture: &Arc<Picture>,
        (corners, uvs): ([[f32; 3]; 3], [[f32; 2]; 3]),
        (back, world): (&Narrow, &Narrow),
    ) -> Self {
        let edge = |i: usize| three(|k| corners[i][k] - corners[0][k]);
        let (b, c) = (edge(1), edge(2));
        let across = cross(math::vector(world, b), math::vector(world, c));
        let area = 0.5 * length(across);
        let density = picture.texels(uvs) / area.sqrt().max(1e-12);
        let normal = cross(b, c);
        let square = (normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]).max(1e-30);
        // Vectors along which only the weight of the second or the third corner grows.
        let (second, third) = (cross(c, normal), cross(normal, b));
        let place = |axis: usize| {
            let [at, to_b, to_c] = three(|i| uvs[i][axis]);
            let slope = three(|k| ((to_b - at) * second[k] + (to_c - at) * third[k]) / square);
            let start = at - (0..3).map(|k| slope[k] * corners[0][k]).sum::<f32>();
            let cell = |j: usize| (0..3).map(|k| slope[k] * back[k][j]).sum::<f32>();
            [cell(0), cell(1), cell(2), cell(3) + start]
        };
        Self { cloth: Cloth::Picture(picture.clone(), density), places: [place(0), place(1)] }
    }

    /// The texture's value, if it is constant for pixels that are `footprint` metres wide.
    #[inline(always)]
    pub(super) fn even(&self, footprint: f32) -> Option<&'static Touch> {
        match &self.cloth {
            Cloth::Tile(tile, _) => tile.even(tile.level(footprint)),
            Cloth::Picture(..) => None,
        }
    }

    /// The texture at the first `count` of some pixels of a row, each `footprint` metres wide, and the packed
    /// tilt of normals there.
    #[inline(always)]
    pub(super) fn touch(
        &self,
        (inverse, count): (&[f32; SPAN], usize),
        at: (f32, f32),
        footprint: f32,
    ) -> (Span, [u32; SPAN]) {
        let [us, vs] = self.places(inverse, at);
        match &self.cloth {
            Cloth::Tile(tile, along) => {
                let level = tile.level(footprint);
                let span = tile.span(level, [&us, &vs]);
                let lean = span.lean.as_ref().map_or([0; SPAN], |lean| leant(lean, along));
                (span, lean)
            }
            Cloth::Picture(picture, density) => {
                let level = picture.level(footprint * density);
                let mut tint = [[0.0; SPAN]; 3];
                for i in 0..count.min(SPAN) {
                    let colour = picture.at(level, [us[i], vs[i]]);
                    (0..3).for_each(|c| tint[c][i] = colour[c]);
                }
                (Span { tint, roughness: [1.0; SPAN], lean: None }, [0; SPAN])
            }
        }
    }

    /// Texture coordinates of some pixels of a row.
    #[inline(always)]
    fn places(&self, inverse: &[f32; SPAN], (x, y): (f32, f32)) -> [[f32; SPAN]; 2] {
        const LANE: [f32; SPAN] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
        let [us, vs] = &self.places;
        let (u0, v0) = (us[1] * y + us[2], vs[1] * y + vs[2]);
        let mut all = [[0.0; SPAN]; 2];
        for i in 0..SPAN {
            let depth = 1.0 / inverse[i];
            let x = x + LANE[i];
            all[0][i] = (us[0] * x + u0) * depth + us[3];
            all[1][i] = (vs[0] * x + v0) * depth + vs[3];
        }
        all
    }
}

/// The packed tilt of normals in the world.
#[inline(always)]
fn leant([us, vs]: &[[f32; SPAN]; 2], [across, along]: &[[f32; 3]; 2]) -> [u32; SPAN] {
    let mut lean = [0; SPAN];
    for i in 0..SPAN {
        let (u, v) = (us[i], vs[i]);
        lean[i] = packed([across[0] * u + along[0] * v, across[1] * u + along[1] * v, across[2] * u + along[2] * v]);
    }
    lean
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(v: [f32; 3]) -> f32 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

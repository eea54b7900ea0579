//! Transmission of panes along straight rays. A pane transmits the same share whether it is modelled as a thin
//! box or as a sheet.

use crate::bvh::Ray;
use crate::math::{dot, three};
use crate::ray_casting::{SurfaceHit, Tracer};
use crate::scene::Store;

/// Greatest number of pane sides that a ray passes.
const SIDES: usize = 16;

/// Refractive index of glass.
pub(crate) const INDEX: f32 = 1.5;

/// The share of light that passes the panes along a ray, by colour.
pub(crate) fn passes(store: &Store, tracer: &Tracer, mut ray: Ray) -> [f32; 3] {
    let mut share = [1.0; 3];
    for _ in 0..SIDES {
        let Some(glass) = tracer.first_clear(&ray) else { break };
        let (tint, straight) = (tint(store, &glass), straight(&glass, ray.along));
        share = three(|i| share[i] * straight * tint[i]);
        let on = glass.t + 1e-3;
        ray.from = three(|i| ray.from[i] + on * ray.along[i]);
        ray.end -= on;
        if ray.end <= 0.0 {
            break;
        }
    }
    share
}

/// Colour transmission at a hit on a clear surface: of one side of a solid pane, or of a sheet, which stands
/// for both sides at once.
pub(crate) fn tint(store: &Store, hit: &SurfaceHit<'_>) -> [f32; 3] {
    let surface = &store.surfaces[usize::from(hit.face.surface)];
    let both = surface.colour.map(|c| c * surface.transmission);
    if hit.face.sheet { both } else { both.map(f32::sqrt) }
}

/// The share of light that a pane does not reflect at a hit: by one of its sides, or by both sides of a sheet.
pub(crate) fn straight(hit: &SurfaceHit<'_>, along: [f32; 3]) -> f32 {
    let one = 1.0 - fresnel(dot(along, hit.flat).abs().min(1.0), INDEX).0;
    if hit.face.sheet { one * one } else { one }
}

/// Fresnel reflectance and the cosine beyond the interface, where light enters a medium with `denser` times the
/// refractive index; the mean over both polarisations.
pub(crate) fn fresnel(cosine: f32, denser: f32) -> (f32, f32) {
    let square = 1.0 - (1.0 - cosine * cosine) / (denser * denser);
    if square <= 0.0 {
        return (1.0, 0.0);
    }
    let beyond = square.sqrt();
    let across = (cosine - denser * beyond) / (cosine + denser * beyond);
    let along = (denser * cosine - beyond) / (denser * cosine + beyond);
    (0.5 * (across * across + along * along), beyond)
}

//! What panes leave of the light that goes straight through them.

use crate::affine::three;
use crate::light::dot;
use crate::renderer::Renderer;
use crate::trace::{Met, Ray, Tracer};

/// Sides of panes that are looked through at most.
const SIDES: usize = 16;

/// Refractive index of glass.
pub(crate) const INDEX: f32 = 1.5;

/// The share of light that passes panes along a ray, by colour.
pub(super) fn passes(renderer: &Renderer, tracer: &Tracer, mut ray: Ray) -> [f32; 3] {
    let mut share = [1.0; 3];
    for _ in 0..SIDES {
        let Some(glass) = tracer.first_clear(&ray) else { break };
        let cosine = dot(ray.along, glass.flat).abs().min(1.0);
        let (tint, straight) = (tint(renderer, &glass), 1.0 - fresnel(cosine, INDEX).0);
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

/// What one side of a clear thing leaves of light, by colour.
pub(crate) fn tint(renderer: &Renderer, met: &Met<'_>) -> [f32; 3] {
    let surface = &renderer.store.surfaces[usize::from(met.face.surface)];
    surface.colour.map(|c| (c * surface.transmission).sqrt())
}

/// The share reflected and the cosine beyond, where light meets what is so many times denser (Fresnel), both
/// polarisations alike.
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

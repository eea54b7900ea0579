//! Glass: view rays through it are refracted; light goes straight through it, so glass casts shadows but no
//! caustics. Panes are too thin to bend rays.

use super::path::{Paths, off};
use super::walk::Walk;
use crate::bvh::Ray;
use crate::colour::luminance;
use crate::light::{INDEX, fresnel, straight, tint};
use crate::math::{dot, three, unit};
use crate::ray_casting::SurfaceHit;

/// Reflections of glass along a path: one of them, sampled by brightness, stands for all.
#[derive(Clone, Copy, Default)]
pub(super) struct Reflections {
    all: f32,
    /// The reflected ray, and the share of its light that would reach the eye if it were the only reflection.
    one: Option<(Ray, [f32; 3])>,
}

impl Reflections {
    fn add(&mut self, ray: Ray, share: [f32; 3], choice: f32) {
        let bright = luminance(share);
        self.all += bright;
        if choice * self.all < bright {
            self.one = Some((ray, share.map(|v| v / bright)));
        }
    }

    /// Total brightness of the reflections under uniform white light.
    pub(super) fn all(&self) -> f32 {
        self.all
    }

    pub(super) fn one(&self) -> Option<(Ray, [f32; 3])> {
        self.one.map(|(ray, share)| (ray, share.map(|v| v * self.all)))
    }
}

pub(super) fn mirrored(along: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
    let twice = 2.0 * dot(along, normal);
    unit(three(|i| along[i] - twice * normal[i]))
}

impl Paths<'_> {
    /// Continues through glass or reflects off it.
    pub(super) fn glass(&self, walk: &mut Walk, hit: &SurfaceHit<'_>, choice: f32) {
        // A sheet is entered and left in one hit.
        let bends = walk.surfaces == 0 && self.lights.bend(hit.index) && !hit.face.sheet;
        let normal = if bends { hit.normal } else { hit.flat };
        let entering = dot(walk.ray.along, normal) < 0.0;
        let normal = if entering { normal } else { normal.map(|v| -v) };
        let cosine = -dot(walk.ray.along, normal);
        let (share, beyond) = fresnel(cosine, if bends && !entering { 1.0 / INDEX } else { INDEX });
        let share = if bends { share } else { 1.0 - straight(hit, walk.ray.along) };
        let reflected = mirrored(walk.ray.along, normal);
        // Glass in front of the first surface is passed, and its reflection is a separate path. If chance
        // decided between the two, neighbouring pixels would seem to show different things and not be smoothed
        // together. This does not apply to round glass, which shows too many directions in one pixel.
        let parts = !walk.guided && share < 1.0 && hit.face.is_flat();
        if parts {
            let ray = Ray { from: off(hit, reflected), along: reflected, ..walk.ray };
            walk.reflections.add(ray, walk.share.map(|v| v * share), choice);
            walk.share = walk.share.map(|v| v * (1.0 - share));
        }
        if !parts && choice < share {
            walk.ray.along = reflected;
            walk.chance = f32::INFINITY;
        } else {
            let tint = tint(self.store, hit);
            walk.share = three(|i| walk.share[i] * tint[i]);
            if bends {
                let over = if entering { 1.0 / INDEX } else { INDEX };
                let slide = over * cosine - beyond;
                walk.ray.along = unit(three(|i| over * walk.ray.along[i] + slide * normal[i]));
            } else {
                walk.gone += hit.t;
                let cosine = dot(walk.ray.along, hit.flat).abs();
                if let Some(pane) = self.lights.window_of(hit, self.room(hit)) {
                    walk.through += self.lights.through(&walk.last, &pane, walk.gone, cosine);
                }
            }
        }
        walk.ray.from = off(hit, walk.ray.along);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fresnel_is_as_books_have_it() {
        let reflected = |cosine: f32| fresnel(cosine, INDEX).0;
        assert!((reflected(1.0) - 0.04).abs() < 1e-6);
        // At Brewster's angle the reflected light is fully polarised, in a single polarisation.
        let brewster = 1.0 / (1.0 + INDEX * INDEX).sqrt();
        let across = (INDEX * INDEX - 1.0) / (INDEX * INDEX + 1.0);
        assert!((reflected(brewster) - 0.5 * across * across).abs() < 1e-6);
        assert!(reflected(0.0) > 0.999);
        // From inside, beyond the critical angle, reflection is total.
        assert_eq!(fresnel(0.7, 1.0 / INDEX).0, 1.0);
    }
}

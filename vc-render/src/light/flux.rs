//! Light that leaves a lamp: much of the light of its bulb and its shade hits the lamp itself.

use crate::bvh::Ray;
use crate::colour::luminance;
use crate::math::{self, basis, cosine_weighted, dot, low_discrepancy, scaled, three, unit};
use crate::ray_casting::Tracer;
use crate::scene::Store;
use crate::surface::Role;

/// Number of light paths that are traced.
const WAYS: u32 = 512;
/// Greatest number of bounces within a lamp.
const WITHIN: u32 = 8;

/// A luminous triangle, and the cumulative brightness up to it.
struct Giver {
    corners: [[f32; 3]; 3],
    normal: [f32; 3],
    flux: [f32; 3],
    sum: f32,
}

/// The light that leaves a lamp.
pub(super) struct Leaving {
    pub(super) flux: [f32; 3],
    /// Preferred direction, times the strength of the preference: zero for uniform light, one for a cosine
    /// distribution.
    pub(super) axis: [f32; 3],
    /// Mean point from which it leaves.
    pub(super) at: [f32; 3],
}

impl Leaving {
    /// No light.
    pub(super) fn none(at: [f32; 3]) -> Self {
        Self { flux: [0.0; 3], axis: [0.0; 3], at }
    }
}

/// The light that leaves a lamp; none if all of it is absorbed within.
pub(super) fn leaving(store: &Store, tracer: &Tracer, body: u32, gains: &[f32; 4]) -> Option<Leaving> {
    let givers = givers(store, tracer, body, gains);
    let all = givers.last().map_or(0.0, |giver| giver.sum);
    let (mut flux, mut axis, mut middle) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    for way in 0..WAYS {
        let from = (way as f32 + 0.5) / WAYS as f32 * all;
        let Some(giver) = givers.get(givers.partition_point(|giver| giver.sum <= from)) else { continue };
        let share = all / WAYS as f32 / luminance(giver.flux);
        let [a, b] = low_discrepancy(2 * way);
        let root = a.sqrt();
        let [p, q, r] = giver.corners;
        let at = three(|i| (1.0 - root) * p[i] + root * ((1.0 - b) * q[i] + b * r[i]));
        if let Some((light, along, at)) = out(store, tracer, (body, way), (at, giver.normal), scaled(giver.flux, share))
        {
            let bright = luminance(light);
            flux = three(|i| flux[i] + light[i]);
            axis = three(|i| axis[i] + bright * along[i]);
            middle = three(|i| middle[i] + bright * at[i]);
        }
    }
    // The mean direction of cosine-distributed light has length two thirds.
    let bright = luminance(flux);
    let axis = scaled(axis, 1.5 / bright);
    let length = dot(axis, axis).sqrt();
    (bright > 0.0).then(|| Leaving {
        flux,
        axis: scaled(axis, 1.0 / length.max(1.0)),
        at: scaled(middle, 1.0 / bright),
    })
}

/// Traces a light path until it leaves the lamp; returns its light, direction and point of exit.
fn out(
    store: &Store,
    tracer: &Tracer,
    (body, way): (u32, u32),
    (mut at, mut normal): ([f32; 3], [f32; 3]),
    mut light: [f32; 3],
) -> Option<([f32; 3], [f32; 3], [f32; 3])> {
    for bounce in 0..WITHIN {
        let own = cosine_weighted(low_discrepancy(2 * way + 1 + bounce * 2 * WAYS));
        let [u, v, n] = basis(normal);
        let along = unit(three(|i| own[0] * u[i] + own[1] * v[i] + own[2] * n[i]));
        let ray = Ray { from: three(|i| at[i] + 1e-4 * normal[i]), along, end: 1e4 };
        let hit = tracer.first(&ray).filter(|hit| hit.instance.body == body);
        let Some(hit) = hit else { return Some((light, along, at)) };
        let hit = hit.facing(along.map(|v| -v));
        let surface = &store.surfaces[usize::from(hit.face.surface)];
        let thrown = surface.reflected(&hit.instance.coat);
        (at, normal, light) = (hit.at, hit.flat, three(|i| light[i] * thrown[i]));
    }
    None
}

/// All luminous triangles of a lamp.
fn givers(store: &Store, tracer: &Tracer, body: u32, [gain, shade @ ..]: &[f32; 4]) -> Vec<Giver> {
    let (body, mut sum) = (&tracer.snapshot.bodies[body as usize], 0.0);
    let mut givers = Vec::new();
    for instance in &tracer.snapshot.instances[body.instances.start as usize..body.instances.end as usize] {
        let (mesh, world) = (&*instance.link.levels[0], instance.world.narrow());
        for cluster in &mesh.clusters {
            for triangle in cluster.triangles.clone() {
                let surface = &store.surfaces[usize::from(mesh.faces[triangle as usize].surface)];
                let light = match surface.role {
                    Role::Shade => three(|i| surface.colour[i] * shade[i]),
                    _ => scaled(surface.mean_emission(), *gain),
                };
                let corners = mesh.triangle(cluster, triangle as usize).map(|p| math::point(&world, p));
                let (normal, area) = super::lamp::area(corners);
                let flux = scaled(light, std::f32::consts::PI * area);
                if luminance(flux) > 0.0 {
                    sum += luminance(flux);
                    givers.push(Giver { corners, normal, flux, sum });
                }
            }
        }
    }
    givers
}

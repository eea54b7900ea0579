//! Mirrors and panes, which few pixels show.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::light::Lamps;
use super::planes;
use super::surfel::Known;
use crate::bvh::Ray;
use crate::labels::bent;
use crate::light::{Lighting, passes};
use crate::math::simd::stretches;
use crate::math::{dot, three, unit};
use crate::rasterization::{Frustum, Layers, NONE};
use crate::ray_casting::SurfaceHit;
use crate::scene::Store;
use crate::shot::View;

/// Number of pixels of a pane that share ambient light.
const SHARED: usize = 8;

pub(super) struct Extra<'a> {
    pub(super) store: &'a Store,
    pub(super) view: View<'a>,
    pub(super) lamps: &'a Lamps<'a>,
}

/// Linear colours of a row, by channel.
pub(super) type Row<'a> = [&'a mut [f32]; 3];

impl Extra<'_> {
    fn place(&self, (x, y): (usize, i32), inverse: f32) -> ([f32; 3], [f32; 3]) {
        let eye: [f32; 3] = self.view.camera.eye().into();
        let towards = self.lamps.ray(x as f32, y as f32);
        (three(|i| eye[i] + towards[i] / inverse), unit(towards))
    }

    /// Shades mirrors in a row of the image.
    pub(super) fn mirrors(&self, known: &mut Known, seen: &planes::Row, y: i32, row: &mut Row<'_>) {
        let inverse = self.lamps.solid.inverse_row(y);
        for (x, group) in seen.groups().iter().enumerate() {
            if known.group(*group).mirror {
                let (at, towards) = self.place((x, y), inverse[x]);
                let triangle = self.lamps.solid.triangle_row(y)[x];
                let normal = unit(self.lamps.writer.normal(triangle, (x as f32 + 0.5, y as f32 + 0.5), known));
                let light = self.reflected(at, towards, normal);
                (0..3).for_each(|i| row[i][x] = light[i] * seen.colour[i][x]);
            }
        }
    }

    fn reflected(&self, at: [f32; 3], towards: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
        let twice = 2.0 * dot(towards, normal);
        let along = three(|i| towards[i] - twice * normal[i]);
        let from = three(|i| at[i] + 1e-3 * normal[i]);
        let lighting = self.lamps.lighting;
        let ray = Ray { from, along, end: 1e4 };
        let (light, end) = match lighting.tracer.first(&ray) {
            Some(hit) => (lighting.reflected(self.store, &hit, 0.004), hit.t),
            None => (lighting.daylight.radiance(along), ray.end),
        };
        let share = passes(self.store, &lighting.tracer, Ray { end, ..ray });
        three(|i| share[i] * light[i])
    }

    /// Adds the transmission and reflections of panes in a row of the image.
    pub(super) fn panes(&self, layers: &Layers, frustum: &Frustum, y: i32, row: &mut Row<'_>) {
        if !layers.behind.rows.contains(&y) {
            return;
        }
        let (front, behind) = (layers.front.triangle_row(y), layers.behind.triangle_row(y));
        let inverse = layers.front.inverse_row(y);
        if front == behind {
            return;
        }
        stretches(front, |triangle, from, to| {
            if triangle != NONE && behind[from..to].iter().any(|b| *b != triangle) {
                self.pane(layers, frustum, (triangle, y), (from..to, &inverse[from..to], &behind[from..to]), row);
            }
        });
    }

    /// Shades the pixels of a row that show a triangle of a pane, over the surface behind it.
    fn pane(
        &self,
        layers: &Layers,
        frustum: &Frustum,
        (triangle, y): (u32, i32),
        (columns, inverse, behind): (std::ops::Range<usize>, &[f32], &[u32]),
        row: &mut Row<'_>,
    ) {
        let visible = layers.visible[triangle as usize];
        let instances = &self.view.snapshot.instances;
        let instance = &instances[visible.instance as usize];
        let surface = &self.store.surfaces[usize::from(visible.mesh(instances).faces[visible.index()].surface)];
        let room = self.view.snapshot.bodies[instance.body as usize].room;
        let map = || frustum.map.after(&instance.world).narrow();
        let bend = bent(map, frustum.near, instances, visible);
        // Position, direction from the eye, normal and reflectance.
        let seen = |i: usize| {
            let x = columns.start + i;
            let normal = bend.unwrap_or_else(|bend| unit(bend.at(x as f32 + 0.5, y as f32 + 0.5)));
            let (at, towards) = self.place((x, y), inverse[i]);
            let edge = 1.0 - dot(towards, normal).abs().clamp(0.0, 1.0);
            (at, towards, normal, 0.06 + 0.94 * edge * edge * edge * edge * edge)
        };
        for first in (0..columns.len()).step_by(SHARED) {
            let last = (first + SHARED).min(columns.len()) - 1;
            let (at, towards, normal, start) = seen(first);
            let twice = 2.0 * dot(towards, normal);
            let along = unit(three(|i| towards[i] - twice * normal[i]));
            let sides = self.lamps.lighting.sides(at, normal, room);
            let (around, own) = (sides.sheen(along), sides.falls(normal));
            let slope = (seen(last).3 - start) / (last - first).max(1) as f32;
            for i in (first..=last).filter(|i| behind[*i] != triangle) {
                // Across a flat pane reflectance changes slowly and almost linearly.
                let fresnel = if bend.is_ok() { start + slope * (i - first) as f32 } else { seen(i).3 };
                let through = surface.transmission * (1.0 - fresnel);
                let x = columns.start + i;
                for c in 0..3 {
                    let body = (1.0 - surface.transmission) * surface.colour[c] * own[c] / std::f32::consts::PI;
                    row[c][x] = row[c][x] * surface.colour[c] * through + around[c] * fresnel + body * (1.0 - fresnel);
                }
            }
        }
    }
}

impl Lighting {
    /// Emitted and diffusely reflected light of a hit surface, without gloss.
    pub(crate) fn reflected(&self, store: &Store, hit: &SurfaceHit<'_>, footprint: f32) -> [f32; 3] {
        let surface = &store.surfaces[usize::from(hit.face.surface)];
        let room =
            self.room_of(&self.tracer.snapshot.bodies[hit.instance.body as usize], hit.instance, hit.at, hit.flat);
        let point = hit.appearance(surface, footprint);
        let falling = self.around(hit.at, point.normal, room);
        let direct = self.direct(hit.at, point.normal, room, self.sunlight(room));
        let shine = hit.shine(surface, footprint);
        let glow = self.glow(surface, hit.instance.body);
        let behind = self.through(surface, hit.instance).unwrap_or_default();
        let over = 1.0 / std::f32::consts::PI;
        three(|i| glow[i] * shine[i] + point.colour[i] * over * (falling[i] + direct[i] + behind[i]))
    }
}

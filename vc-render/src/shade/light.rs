//! Light on surfaces.

use rayon::prelude::*;

use super::surfel::Pane;
use super::{Around, Surfel};
use crate::affine::{self, Affine, Narrow};
use crate::frame::Frame;
use crate::label::unit;
use crate::light::{Lighting, dot};
use crate::renderer::Renderer;
use crate::trace::{Met, Ray};
use crate::view::View;

/// Rows given to a thread at a time.
const ROWS: usize = 16;

/// Writes the light that comes to the eye from solid surfaces and the sky.
pub(super) fn light(renderer: &Renderer, lighting: &Lighting, view: View<'_>, frame: &mut Frame) {
    let (width, height) = (frame.width, frame.height);
    let half = (width.div_ceil(2), height.div_ceil(2));
    let (surfels, around) = (&frame.surfels, &frame.memory.around);
    let pose = Affine::of(&view.camera.pose).narrow();
    let eye: [f32; 3] = view.camera.eye().into();
    frame.light.par_chunks_mut(width * ROWS).enumerate().for_each(|(chunk, rows)| {
        crate::simd::widest(
            #[inline(always)]
            || {
                for (i, out) in rows.iter_mut().enumerate() {
                    let (x, y) = (i % width, chunk * ROWS + i / width);
                    let surfel = &surfels[y * width + x];
                    let towards = affine::vector(&pose, view.camera.ray(x as f32 + 0.5, y as f32 + 0.5).into());
                    *out = if surfel.inverse > 0.0 {
                        let pixel = Pixel::new(surfel, eye, towards);
                        pixel.light(renderer, lighting, view, Around::at(around, half, (x, y), surfel))
                    } else {
                        lighting.daylight.radiance(unit(towards))
                    };
                }
            },
        );
    });
}

/// A pixel's surface as light meets it.
struct Pixel<'a> {
    surfel: &'a Surfel,
    at: [f32; 3],
    normal: [f32; 3],
    /// To the eye, unit length.
    back: [f32; 3],
    colour: [f32; 3],
    metallic: f32,
    roughness: f32,
}

impl<'a> Pixel<'a> {
    #[inline(always)]
    fn new(surfel: &'a Surfel, eye: [f32; 3], towards: [f32; 3]) -> Self {
        let depth = 1.0 / surfel.inverse;
        Self {
            surfel,
            at: [0, 1, 2].map(|i: usize| eye[i] + towards[i] * depth),
            normal: surfel.normal(),
            back: unit(towards.map(|v| -v)),
            colour: surfel.colour(),
            metallic: surfel.metallic(),
            roughness: surfel.roughness().max(0.05),
        }
    }

    #[inline(always)]
    fn light(
        &self,
        renderer: &Renderer,
        lighting: &Lighting,
        view: View<'_>,
        (falls, sheen): ([f32; 3], [f32; 3]),
    ) -> [f32; 3] {
        let body = &view.snapshot.bodies[self.surfel.body as usize];
        let surface = &renderer.store.surfaces[usize::from(self.surfel.surface)];
        let facing = dot(self.normal, self.back).clamp(0.02, 1.0);
        let over = 1.0 / std::f32::consts::PI;
        let dull = 1.0 - self.metallic;
        let shine = self.shine(facing);
        let mut sum = [0, 1, 2].map(|i: usize| self.colour[i] * dull * falls[i] * over + sheen[i] * shine[i]);
        if body.lit {
            let glow = lighting.glow(surface, self.surfel.body);
            sum = [0, 1, 2].map(|i: usize| sum[i] + glow[i]);
        }
        if lighting.sun.is_some() {
            self.sun(lighting, facing, &mut sum);
        }
        for lamp in lighting.lamps.iter().filter(|l| l.room == body.room) {
            let (to, strength) = lamp.falls(self.at);
            let cosine = dot(to, self.normal);
            if cosine > 0.0 {
                let off = [0, 1, 2].map(|i: usize| self.at[i] + 0.02 * self.normal[i]);
                let share = cosine * strength * lamp.seen(off);
                self.add(to, facing, lamp.flux.map(|f| f * share), &mut sum);
            }
        }
        sum
    }

    #[inline(always)]
    fn sun(&self, lighting: &Lighting, facing: f32, sum: &mut [f32; 3]) {
        let towards: [f32; 3] = lighting.daylight.towards_sun.into();
        let cosine = dot(towards, self.normal);
        let Some(map) = lighting.sun.as_ref().filter(|_| cosine > 0.0) else { return };
        let share = cosine * map.lit([0, 1, 2].map(|i: usize| self.at[i] + 0.02 * self.normal[i]));
        if share > 0.0 {
            let sun: [f32; 3] = lighting.daylight.sun.into();
            self.add(towards, facing, sun.map(|s| s * share), sum);
        }
    }

    /// Adds what a surface throws to the eye of light from a direction: Lambert's law, and
    /// microfacets by Trowbridge and Reitz with Schlick's approximations.
    #[inline(always)]
    fn add(&self, to: [f32; 3], facing: f32, falling: [f32; 3], sum: &mut [f32; 3]) {
        let over = 1.0 / std::f32::consts::PI;
        let half = unit([0, 1, 2].map(|i: usize| to[i] + self.back[i]));
        let (nh, nl) = (dot(half, self.normal).clamp(0.0, 1.0), dot(to, self.normal).max(0.0));
        let vh = dot(half, self.back).clamp(0.0, 1.0);
        let alpha = self.roughness * self.roughness;
        let square = alpha * alpha;
        let bottom = nh * nh * (square - 1.0) + 1.0;
        let spread = square * over / (bottom * bottom);
        let k = 0.5 * alpha;
        let shadowing = 0.25 / ((nl * (1.0 - k) + k) * (facing * (1.0 - k) + k));
        let lobe = (spread * shadowing).min(40.0);
        let edge = 1.0 - vh;
        let edge = edge * edge * edge * edge * edge;
        for i in 0..3 {
            let head_on = 0.04 + (self.colour[i] - 0.04) * self.metallic;
            let fresnel = head_on + (1.0 - head_on) * edge;
            sum[i] += falling[i] * (self.colour[i] * (1.0 - self.metallic) * over * (1.0 - fresnel) + lobe * fresnel);
        }
    }

    /// How much of light from all sides is reflected (Karis's fit for mobile, 2014).
    #[inline(always)]
    fn shine(&self, facing: f32) -> [f32; 3] {
        let r = [
            1.0 - self.roughness,
            0.0425 - 0.0275 * self.roughness,
            1.04 - 0.572 * self.roughness,
            0.022 * self.roughness - 0.04,
        ];
        // 2^(-9.28 facing), by a power of what is nearly that.
        let low = 1.0 - facing;
        let fall = low * low * low * low * low * low;
        let a = (r[0] * r[0]).min(fall) * r[0] + r[1];
        let (scale, shift) = (-1.04 * a + r[2], 1.04 * a + r[3]);
        self.colour.map(|c| ((0.04 + (c - 0.04) * self.metallic) * scale + shift).max(0.0))
    }
}

/// What few pixels need: mirrors and panes.
pub(super) struct Extra<'a> {
    pub(super) renderer: &'a Renderer,
    pub(super) lighting: &'a Lighting,
    pub(super) view: View<'a>,
    pub(super) surfels: &'a [Surfel],
}

impl Extra<'_> {
    /// Where a pixel's ray goes in the world; depth times it leads to what is seen.
    fn towards(&self, pixel: u32) -> [f32; 3] {
        let width = self.view.camera.width;
        let (x, y) = (pixel % width, pixel / width);
        let pose: Narrow = Affine::of(&self.view.camera.pose).narrow();
        affine::vector(&pose, self.view.camera.ray(x as f32 + 0.5, y as f32 + 0.5).into())
    }

    fn place(&self, pixel: u32, inverse: f32) -> ([f32; 3], [f32; 3]) {
        let (eye, towards): ([f32; 3], _) = (self.view.camera.eye().into(), self.towards(pixel));
        ([0, 1, 2].map(|i: usize| eye[i] + towards[i] / inverse), unit(towards))
    }

    /// What is seen in a mirror.
    pub(super) fn mirror(&self, pixel: u32, light: &mut [[f32; 3]]) {
        let surfel = &self.surfels[pixel as usize];
        if surfel.inverse <= 0.0 {
            return;
        }
        let (at, towards) = self.place(pixel, surfel.inverse);
        let seen = self.reflected(at, towards, surfel.normal());
        let colour = surfel.colour();
        light[pixel as usize] = [0, 1, 2].map(|i: usize| seen[i] * colour[i]);
    }

    fn reflected(&self, at: [f32; 3], towards: [f32; 3], normal: [f32; 3]) -> [f32; 3] {
        let twice = 2.0 * dot(towards, normal);
        let along = [0, 1, 2].map(|i: usize| towards[i] - twice * normal[i]);
        let from = [0, 1, 2].map(|i: usize| at[i] + 1e-3 * normal[i]);
        let ray = Ray { from, along, end: 1e4 };
        match self.lighting.tracer.first(&ray) {
            Some(met) => self.lighting.thrown(self.renderer, &met, 0.004),
            None => self.lighting.daylight.radiance(along),
        }
    }

    /// What a pane lets through, and what it reflects.
    pub(super) fn pane(&self, pane: &Pane, light: &mut [[f32; 3]]) {
        let surface = &self.renderer.store.surfaces[usize::from(pane.surface)];
        let (at, towards) = self.place(pane.pixel, pane.inverse);
        let facing = dot(towards, pane.normal).abs().clamp(0.0, 1.0);
        let edge = 1.0 - facing;
        let edge = edge * edge * edge * edge * edge;
        let fresnel = 0.06 + 0.94 * edge;
        let twice = 2.0 * dot(towards, pane.normal);
        let along = unit([0, 1, 2].map(|i: usize| towards[i] - twice * pane.normal[i]));
        let room = self.view.snapshot.bodies[pane.body as usize].room;
        let around = crate::light::sheen(&self.lighting.harmonics(at, pane.normal, room), along);
        let own = self.lighting.around(at, pane.normal, room);
        let through = surface.transmission * (1.0 - fresnel);
        let behind = &mut light[pane.pixel as usize];
        *behind = [0, 1, 2].map(|i: usize| {
            let body = (1.0 - surface.transmission) * surface.colour[i] * own[i] / std::f32::consts::PI;
            behind[i] * surface.colour[i] * through + around[i] * fresnel + body * (1.0 - fresnel)
        });
    }
}

impl Lighting {
    /// Light that a surface throws back towards any side, its sheen left out.
    pub(crate) fn thrown(&self, renderer: &Renderer, met: &Met<'_>, footprint: f32) -> [f32; 3] {
        let surface = &renderer.store.surfaces[usize::from(met.face.surface)];
        let room = self.tracer.snapshot.bodies[met.instance.body as usize].room;
        let look = met.look(surface, footprint);
        let falling = self.around(met.at, look.normal, room);
        let direct = self.direct(met.at, look.normal, room);
        let glow = self.glow(surface, met.instance.body);
        let over = 1.0 / std::f32::consts::PI;
        [0, 1, 2].map(|i: usize| glow[i] + look.colour[i] * over * (falling[i] + direct[i]))
    }
}

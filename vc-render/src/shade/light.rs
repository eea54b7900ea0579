//! Light at pixels, many at a time.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use super::Openness;
use super::planes::{LIGHT, Planes, gloss, packed};
use super::surfel::{Known, Look, NOTHING, Writer};
use crate::affine::{self, Affine, Narrow, three};
use crate::label::unit;
use crate::light::{Lamp, Lighting, brightness, dot};
use crate::raster::Solid;

/// Pixels that are lit at once.
const BATCH: usize = 64;
/// Light that leans is kept up to so many times the light there is.
pub(super) const DRIFT: f32 = 4.0;

type Lanes = [f32; BATCH];

/// Where light comes from and who sees it.
pub(super) struct Lamps<'a> {
    pub(super) lighting: &'a Lighting,
    pub(super) open: &'a Openness,
    pub(super) solid: Solid<'a>,
    pub(super) writer: &'a Writer<'a>,
    eye: [f32; 3],
    /// From pixels to directions in the world, of depth one.
    rays: [[f32; 3]; 3],
}

/// Pixels as light meets them.
pub(crate) struct Batch {
    count: usize,
    places: [u32; BATCH],
    rooms: [u16; BATCH],
    at: [Lanes; 3],
    normal: [Lanes; 3],
    /// To the eye, unit length.
    back: [Lanes; 3],
    facing: Lanes,
    roughness: Lanes,
    /// Reflectance head on: a metal's colour comes later.
    head_on: Lanes,
    open: Lanes,
    light: [Lanes; LIGHT],
    /// How light changes where the normal leans.
    drift: [Lanes; 3],
    to: [Lanes; 3],
    cosine: Lanes,
    power: Lanes,
}

impl Default for Batch {
    fn default() -> Self {
        let zero = [0.0; BATCH];
        let three = [zero; 3];
        Self {
            count: 0,
            places: [0; BATCH],
            rooms: [0; BATCH],
            at: three,
            normal: three,
            back: three,
            facing: zero,
            roughness: zero,
            head_on: zero,
            open: zero,
            light: [zero; LIGHT],
            drift: three,
            to: three,
            cosine: zero,
            power: zero,
        }
    }
}

impl<'a> Lamps<'a> {
    pub(super) fn new(writer: &'a Writer<'a>, open: &'a Openness, solid: Solid<'a>) -> Self {
        let camera = writer.view.camera;
        let pose: Narrow = Affine::of(&camera.pose).narrow();
        let turned = |v: [f32; 3]| affine::vector(&pose, v);
        let (fx, fy) = (1.0 / camera.focal.0, 1.0 / camera.focal.1);
        let corner = [(0.5 - camera.centre.0) * fx, (0.5 - camera.centre.1) * fy, 1.0];
        let rays = [turned([fx, 0.0, 0.0]), turned([0.0, fy, 0.0]), turned(corner)];
        Self { lighting: writer.lighting, open, solid, writer, eye: camera.eye().into(), rays }
    }

    /// Direction through a pixel in the world; depth times it leads to what is seen.
    #[inline(always)]
    pub(super) fn ray(&self, x: f32, y: f32) -> [f32; 3] {
        three(|i| self.rays[0][i] * x + self.rays[1][i] * y + self.rays[2][i])
    }

    /// Finds the light at pixels of a strip that begins at a row of the image.
    #[inline(always)]
    pub(super) fn light(&self, planes: &mut Planes, known: &mut Known, start: i32, spots: &[u32], batch: &mut Batch) {
        for spots in spots.chunks(BATCH) {
            batch.load(self, planes, known, (start, spots));
            batch.around(self);
            batch.sun(self.lighting);
            for lamp in &self.lighting.lamps {
                if batch.rooms[..batch.count].contains(&lamp.room) {
                    batch.lamp(lamp);
                }
            }
            batch.store(planes, &known.looks);
        }
    }
}

impl Batch {
    /// Pixels of whole vectors, of which those past the end are not looked at.
    #[inline(always)]
    fn lanes(&self) -> usize {
        self.count.next_multiple_of(8).min(BATCH)
    }

    #[inline(always)]
    fn load(&mut self, lamps: &Lamps<'_>, planes: &Planes, known: &mut Known, (start, spots): (i32, &[u32])) {
        self.count = spots.len().min(BATCH);
        let (mut xs, mut ys, mut depth) = ([0.0; BATCH], [0.0; BATCH], [1.0; BATCH]);
        for (i, spot) in spots.iter().enumerate().take(BATCH) {
            let (row, x) = ((spot >> 16) as usize, (spot & 0xffff) as usize);
            let at = row * planes.width + x;
            self.places[i] = at as u32;
            self.rooms[i] = known.looks[planes.look[at] as usize].room;
            (xs[i], ys[i]) = (x as f32, (start + row as i32) as f32);
            let inverse = planes.inverse[at];
            depth[i] = if inverse > 0.0 { 1.0 / inverse } else { 1.0 };
            let y = start + row as i32;
            let triangle = lamps.solid.triangle_row(y)[x];
            let normal = lamps.writer.normal(triangle, (x as f32 + 0.5, y as f32 + 0.5), known);
            (self.normal[0][i], self.normal[1][i], self.normal[2][i]) = (normal[0], normal[1], normal[2]);
            let (roughness, metallic) = gloss(planes.gloss[at]);
            self.roughness[i] = roughness.max(0.05);
            self.head_on[i] = 0.04 + 0.96 * metallic;
            self.open[i] = lamps.open.at(x, y as usize, inverse);
        }
        for i in 0..self.lanes() {
            let ray = lamps.ray(xs[i], ys[i]);
            let over = -1.0 / (ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]).sqrt();
            for k in 0..3 {
                self.at[k][i] = lamps.eye[k] + ray[k] * depth[i];
                self.back[k][i] = ray[k] * over;
                self.drift[k][i] = 0.0;
            }
            let facing = self.back[0][i] * self.normal[0][i]
                + self.back[1][i] * self.normal[1][i]
                + self.back[2][i] * self.normal[2][i];
            self.facing[i] = facing.clamp(0.02, 1.0);
        }
    }

    /// Light from all sides, less what nearby things keep away.
    #[inline(always)]
    fn around(&mut self, lamps: &Lamps<'_>) {
        for i in 0..self.count {
            let part = |of: &[Lanes; 3]| [of[0][i], of[1][i], of[2][i]];
            let (at, normal, back) = (part(&self.at), part(&self.normal), part(&self.back));
            let along = 2.0 * dot(back, normal);
            let mirrored = three(|k| along * normal[k] - back[k]);
            let sides = lamps.lighting.sides(at, normal, self.rooms[i]);
            let (falls, sheen, lean) = (sides.falls(normal), sides.sheen(mirrored), sides.lean());
            for k in 0..3 {
                self.light[k][i] = falls[k] * self.open[i];
                self.light[k + 3][i] = sheen[k] * (0.3 + 0.7 * self.open[i]);
                self.drift[k][i] = lean[k] * self.open[i];
            }
        }
        for i in 0..self.lanes() {
            let shine = shine(self.roughness[i], self.facing[i], self.head_on[i]);
            for k in 3..6 {
                self.light[k][i] *= shine;
            }
        }
    }

    #[inline(always)]
    fn sun(&mut self, lighting: &Lighting) {
        let Some(map) = &lighting.sun else { return };
        let towards: [f32; 3] = lighting.daylight.towards_sun.into();
        for i in 0..self.lanes() {
            for k in 0..3 {
                self.to[k][i] = towards[k];
            }
            self.cosine[i] =
                self.normal[0][i] * towards[0] + self.normal[1][i] * towards[1] + self.normal[2][i] * towards[2];
            self.power[i] = 1.0;
        }
        let sun = lighting.daylight.sun.into();
        self.shadow(
            sun,
            #[inline(always)]
            |at, normal| map.lit(at, normal),
        );
    }

    #[inline(always)]
    fn lamp(&mut self, lamp: &Lamp) {
        let [x, y, z] = lamp.axis;
        let narrow = (x * x + y * y + z * z).sqrt().min(1.0);
        // From all around, to a half space with the cosine's law.
        let even = (1.0 - narrow) / (4.0 * std::f32::consts::PI);
        for i in 0..self.lanes() {
            let to = [lamp.at[0] - self.at[0][i], lamp.at[1] - self.at[1][i], lamp.at[2] - self.at[2][i]];
            let square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
            let over = 1.0 / square.sqrt().max(1e-6);
            let to = [to[0] * over, to[1] * over, to[2] * over];
            let beam = (-(to[0] * x + to[1] * y + to[2] * z)).max(0.0) * (1.0 / std::f32::consts::PI);
            let own = if self.rooms[i] == lamp.room { 1.0 } else { 0.0 };
            self.power[i] = own * (even + beam) / (square + lamp.radius * lamp.radius);
            self.cosine[i] = to[0] * self.normal[0][i] + to[1] * self.normal[1][i] + to[2] * self.normal[2][i];
            for k in 0..3 {
                self.to[k][i] = to[k];
            }
        }
        self.shadow(
            lamp.flux,
            #[inline(always)]
            |at, normal| lamp.seen(at, normal),
        );
    }

    /// Takes away what is in the shadow, and adds the rest.
    #[inline(always)]
    fn shadow(&mut self, flux: [f32; 3], lit: impl Fn([f32; 3], [f32; 3]) -> f32) {
        let mut any = 0.0;
        for i in 0..self.count {
            if self.cosine[i] <= 0.0 || self.power[i] <= 0.0 {
                self.power[i] = 0.0;
                continue;
            }
            let part = |of: &[Lanes; 3]| [of[0][i], of[1][i], of[2][i]];
            self.power[i] *= lit(part(&self.at), part(&self.normal));
            any += self.power[i];
        }
        if any > 0.0 {
            self.add(flux);
        }
    }

    /// Adds light from a direction: Lambert's law, and microfacets by Trowbridge and Reitz
    /// with Schlick's approximations.
    #[inline(always)]
    fn add(&mut self, flux: [f32; 3]) {
        let over = 1.0 / std::f32::consts::PI;
        let bright = brightness(flux);
        for i in 0..self.lanes() {
            let (x, y, z) =
                (self.to[0][i] + self.back[0][i], self.to[1][i] + self.back[1][i], self.to[2][i] + self.back[2][i]);
            let scale = 1.0 / (x * x + y * y + z * z + 1e-12).sqrt();
            let nh = (x * self.normal[0][i] + y * self.normal[1][i] + z * self.normal[2][i]) * scale;
            let vh = (x * self.back[0][i] + y * self.back[1][i] + z * self.back[2][i]) * scale;
            let (nh, vh) = (nh.clamp(0.0, 1.0), vh.clamp(0.0, 1.0));
            let nl = self.cosine[i].max(0.0);
            let alpha = self.roughness[i] * self.roughness[i];
            let square = alpha * alpha;
            let bottom = nh * nh * (square - 1.0) + 1.0;
            let k = 0.5 * alpha;
            let shadowing = 0.25 / ((nl * (1.0 - k) + k) * (self.facing[i] * (1.0 - k) + k));
            let lobe = (square * over / (bottom * bottom) * shadowing).min(40.0);
            let edge = 1.0 - vh;
            let edge = edge * edge * edge * edge * edge;
            let fresnel = self.head_on[i] + (1.0 - self.head_on[i]) * edge;
            let share = self.power[i] * nl;
            for c in 0..3 {
                self.light[c][i] += flux[c] * share * (1.0 - 0.96 * edge);
                self.light[c + 3][i] += flux[c] * share * lobe * fresnel;
                self.drift[c][i] += bright * self.power[i] * self.to[c][i];
            }
        }
    }

    #[inline(always)]
    fn store(&self, planes: &mut Planes, looks: &[Look]) {
        for i in 0..self.count {
            let at = self.places[i] as usize;
            let number = planes.look[at];
            let look = &looks[number as usize];
            for k in 0..3 {
                planes.light[k][at] = self.light[k][i];
                planes.light[k + 3][at] = self.light[k + 3][i] + look.glow[k];
            }
            let over = 1.0 / (DRIFT * brightness([self.light[0][i], self.light[1][i], self.light[2][i]])).max(1e-6);
            planes.drift[at] = packed(three(|k| self.drift[k][i] * over));
        }
    }

    /// The sky at pixels where nothing is seen.
    #[inline(always)]
    pub(super) fn sky(&self, lamps: &Lamps<'_>, planes: &mut Planes, start: i32, spots: &[u32]) {
        for spot in spots {
            let (row, x) = ((spot >> 16) as usize, (spot & 0xffff) as usize);
            let at = row * planes.width + x;
            if planes.look[at] == NOTHING {
                let towards = unit(lamps.ray(x as f32, (start + row as i32) as f32));
                let sky = lamps.lighting.daylight.radiance(towards);
                for k in 0..3 {
                    planes.light[k][at] = 0.0;
                    planes.light[k + 3][at] = sky[k];
                }
                planes.drift[at] = 0;
            }
        }
    }
}

/// How much of light from all sides is reflected (Karis's fit for mobile, 2014).
#[inline(always)]
fn shine(roughness: f32, facing: f32, head_on: f32) -> f32 {
    let r = [1.0 - roughness, 0.0425 - 0.0275 * roughness, 1.04 - 0.572 * roughness, 0.022 * roughness - 0.04];
    // 2^(-9.28 facing), by a power of what is nearly that.
    let low = 1.0 - facing;
    let fall = low * low * low * low * low * low;
    let a = (r[0] * r[0]).min(fall) * r[0] + r[1];
    let (scale, shift) = (-1.04 * a + r[2], 1.04 * a + r[3]);
    (head_on * scale + shift).max(0.0)
}

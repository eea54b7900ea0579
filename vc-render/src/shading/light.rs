//! Shading of pixels, many at a time.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

mod beam;

use super::Openness;
use super::interpolate::{LIGHT, SampleGrid};
use super::planes::{Planes, gloss, packed};
use super::surfel::{Known, NOTHING, SurfaceGroup, Writer};
use crate::colour::luminance;
use crate::light::{Ambient, Lighting};
use crate::math::simd::widest;
use crate::math::{self, Affine, Narrow, dot, three, unit};
use crate::rasterization::Solid;

/// Number of pixels shaded together.
const BATCH: usize = 64;
/// Limit of the stored change of light with the normal, relative to the light itself.
pub(super) const DRIFT: f32 = 4.0;

/// Reflectance of dielectrics at normal incidence.
const HEAD_ON: f32 = 0.04;
/// Light scattered again between the facets of rough metals, as a factor for the square of roughness and for
/// the colour: a fit to the compensation in reference pictures (Turquin 2019).
const AGAIN: f32 = 0.75;

type Lanes = [f32; BATCH];

/// The light sources and the camera.
pub(super) struct Lamps<'a> {
    pub(super) lighting: &'a Lighting,
    /// None for light without shadows.
    pub(super) open: Option<&'a Openness>,
    pub(super) solid: Solid<'a>,
    pub(super) writer: &'a Writer<'a>,
    eye: [f32; 3],
    /// Map from pixels to world directions with depth one.
    rays: [[f32; 3]; 3],
}

/// A batch of pixels to shade.
pub(crate) struct Batch {
    count: usize,
    groups: [u32; BATCH],
    rooms: [u16; BATCH],
    at: [Lanes; 3],
    normal: [Lanes; 3],
    /// Direction to the eye, unit length.
    back: [Lanes; 3],
    facing: Lanes,
    roughness: Lanes,
    /// Reflectance at normal incidence; a metal's colour is applied later.
    head_on: Lanes,
    /// Share of the light that reaches the base under the gloss.
    base: Lanes,
    open: Lanes,
    sides: [Ambient; BATCH],
    light: [Lanes; LIGHT],
    /// Change of light with the tilt of the normal.
    drift: [Lanes; 3],
    to: [Lanes; 3],
    cosine: Lanes,
    power: Lanes,
    /// Visible share of the current light source.
    share: Lanes,
}

impl Default for Batch {
    fn default() -> Self {
        let zero = [0.0; BATCH];
        let three = [zero; 3];
        Self {
            count: 0,
            groups: [0; BATCH],
            rooms: [0; BATCH],
            at: three,
            normal: three,
            back: three,
            facing: zero,
            roughness: zero,
            head_on: zero,
            base: zero,
            open: zero,
            sides: [Ambient::default(); BATCH],
            light: [zero; LIGHT],
            drift: three,
            to: three,
            cosine: zero,
            power: zero,
            share: zero,
        }
    }
}

impl<'a> Lamps<'a> {
    pub(super) fn new(writer: &'a Writer<'a>, open: Option<&'a Openness>, solid: Solid<'a>) -> Self {
        let camera = writer.view.camera;
        let pose: Narrow = Affine::from_pose(&camera.pose).narrow();
        let turned = |v: [f32; 3]| math::vector(&pose, v);
        let (fx, fy) = (1.0 / camera.focal.0, 1.0 / camera.focal.1);
        let corner = [(0.5 - camera.centre.0) * fx, (0.5 - camera.centre.1) * fy, 1.0];
        let rays = [turned([fx, 0.0, 0.0]), turned([0.0, fy, 0.0]), turned(corner)];
        Self { lighting: writer.lighting, open, solid, writer, eye: camera.eye().into(), rays }
    }

    /// World direction through a pixel; multiplied by depth it leads to the visible point.
    #[inline(always)]
    pub(super) fn ray(&self, x: f32, y: f32) -> [f32; 3] {
        three(|i| self.rays[0][i] * x + self.rays[1][i] * y + self.rays[2][i])
    }

    /// Computes the light at pixels of a strip, whose first row is `start` in the image.
    pub(super) fn light(
        &self,
        (samples, planes): (&mut SampleGrid, &mut Planes),
        known: &mut Known,
        (start, spots): (i32, &[u32]),
        batch: &mut Batch,
    ) {
        for spots in spots.chunks(BATCH) {
            widest(
                #[inline(always)]
                || self.some((samples, planes), known, (start, spots), batch),
            );
        }
    }

    /// Computes the light of one batch.
    #[inline(always)]
    fn some(
        &self,
        (samples, planes): (&mut SampleGrid, &mut Planes),
        known: &mut Known,
        (start, spots): (i32, &[u32]),
        batch: &mut Batch,
    ) {
        batch.load(self, planes, known, (start, spots));
        batch.around(self);
        batch.sun(self.lighting, self.open.is_none());
        for lamp in &*self.lighting.lamps {
            if batch.rooms[..batch.count].contains(&lamp.room) {
                batch.lamp(lamp, self.open.is_none());
            }
        }
        batch.store((samples, planes), known, spots);
        batch.sky(self, (samples, planes), (start, spots));
    }
}

/// Row and column of a pixel in a list of pixels of a strip.
#[inline(always)]
fn place(spot: u32) -> (usize, usize) {
    ((spot >> 16) as usize, (spot & 0xffff) as usize)
}

impl Batch {
    /// Number of lanes in whole vectors; lanes past the count are not used.
    #[inline(always)]
    fn lanes(&self) -> usize {
        self.count.next_multiple_of(8).min(BATCH)
    }

    #[inline(always)]
    fn load(&mut self, lamps: &Lamps<'_>, planes: &Planes, known: &mut Known, (start, spots): (i32, &[u32])) {
        self.count = spots.len().min(BATCH);
        let (mut xs, mut ys, mut inverse) = ([0.0; BATCH], [0.0; BATCH], [1.0; BATCH]);
        let mut shiny = [0_u32; BATCH];
        for (i, spot) in spots.iter().enumerate().take(BATCH) {
            let (row, x) = place(*spot);
            let y = start + row as i32;
            let seen = &planes.0[row];
            self.groups[i] = seen.cells.group[x];
            self.rooms[i] = known.group(self.groups[i]).room;
            (xs[i], ys[i], inverse[i]) = (x as f32, y as f32, seen.cells.inverse[x]);
            shiny[i] = seen.gloss[x];
            let triangle = lamps.solid.triangle_row(y)[x];
            let normal = lamps.writer.normal(triangle, (xs[i] + 0.5, ys[i] + 0.5), known);
            (self.normal[0][i], self.normal[1][i], self.normal[2][i]) = (normal[0], normal[1], normal[2]);
            self.open[i] = lamps.open.map_or(1.0, |open| open.at(x, y as usize, inverse[i]));
        }
        for i in 0..self.lanes() {
            let (roughness, metallic) = gloss(shiny[i]);
            self.roughness[i] = roughness.max(0.05);
            self.head_on[i] = HEAD_ON + (1.0 - HEAD_ON) * metallic;
            let normal = unit([self.normal[0][i], self.normal[1][i], self.normal[2][i]]);
            let ray = lamps.ray(xs[i], ys[i]);
            let over = -1.0 / (ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]).sqrt();
            let depth = if inverse[i] > 0.0 { 1.0 / inverse[i] } else { 1.0 };
            for k in 0..3 {
                self.normal[k][i] = normal[k];
                self.at[k][i] = lamps.eye[k] + ray[k] * depth;
                self.back[k][i] = ray[k] * over;
                self.drift[k][i] = 0.0;
            }
            let facing = over * dot(ray, normal);
            self.facing[i] = facing.clamp(0.02, 1.0);
        }
    }

    /// Ambient light, reduced by ambient occlusion.
    #[inline(always)]
    fn around(&mut self, lamps: &Lamps<'_>) {
        let part = |of: &[Lanes; 3], i: usize| [of[0][i], of[1][i], of[2][i]];
        let mut mirrored = [[0.0; BATCH]; 3];
        for i in 0..self.lanes() {
            let along = 2.0 * dot(part(&self.back, i), part(&self.normal, i));
            (0..3).for_each(|k| mirrored[k][i] = along * self.normal[k][i] - self.back[k][i]);
        }
        // In separate loops, so that no step waits for the one before it.
        for i in 0..self.count {
            self.sides[i] = lamps.lighting.sides(part(&self.at, i), part(&self.normal, i), self.rooms[i]);
        }
        for i in 0..self.count {
            let (falls, lean) = (self.sides[i].falls(part(&self.normal, i)), self.sides[i].lean());
            (0..3).for_each(|k| (self.light[k][i], self.drift[k][i]) = (falls[k], lean[k]));
        }
        for i in 0..self.count {
            let sheen = self.sides[i].sheen(part(&mirrored, i));
            (0..3).for_each(|k| self.light[k + 3][i] = sheen[k]);
        }
        for i in 0..self.lanes() {
            // The roughest surfaces have no gloss, except metals.
            let coat = ((1.0 - self.roughness[i]) * 10.0).clamp(0.0, 1.0).max(self.metal(i));
            let thrown = coat * shine(self.roughness[i], self.facing[i], self.head_on[i]);
            self.base[i] = 1.0 - thrown;
            let shine = thrown * (0.3 + 0.7 * self.open[i]);
            for k in 0..3 {
                self.light[k][i] *= self.open[i];
                self.drift[k][i] *= self.open[i];
                self.light[k + 3][i] *= shine;
            }
        }
    }

    /// Metallic share of the surface.
    #[inline(always)]
    fn metal(&self, i: usize) -> f32 {
        (self.head_on[i] - HEAD_ON) * (1.0 / (1.0 - HEAD_ON))
    }

    #[inline(always)]
    fn store(&mut self, (samples, planes): (&mut SampleGrid, &mut Planes), known: &Known, spots: &[u32]) {
        let (mut drift, mut again, mut metals) = ([0_u32; BATCH], [0.0; BATCH], false);
        for i in 0..self.lanes() {
            again[i] = AGAIN * self.roughness[i] * self.roughness[i] * self.metal(i);
            metals |= again[i] > 0.0;
            let over = 1.0 / (DRIFT * luminance([self.light[0][i], self.light[1][i], self.light[2][i]])).max(1e-6);
            drift[i] = packed([self.drift[0][i] * over, self.drift[1][i] * over, self.drift[2][i] * over]);
            (0..3).for_each(|k| self.light[k][i] *= self.base[i]);
        }
        for (i, spot) in spots.iter().enumerate().take(self.count) {
            let (row, x) = place(*spot);
            if metals && again[i] > 0.0 {
                let colour = planes.0[row].colour.each_ref().map(|list| list[x]);
                (0..3).for_each(|c| self.light[c + 3][i] *= 1.0 + again[i] * colour[c]);
            }
            let (cells, k) = samples.cell(planes, row, x);
            let SurfaceGroup { glow, shine, .. } = known.group(self.groups[i]);
            for c in 0..3 {
                cells.light[c][k] = self.light[c][i] + shine[c];
                cells.light[c + 3][k] = self.light[c + 3][i] + glow[c];
            }
            cells.drift[k] = drift[i];
        }
    }

    /// Writes the sky into pixels where nothing is visible.
    #[inline(always)]
    fn sky(&self, lamps: &Lamps<'_>, (samples, planes): (&mut SampleGrid, &mut Planes), (start, spots): (i32, &[u32])) {
        if !self.groups[..self.count].contains(&NOTHING) {
            return;
        }
        for (_, spot) in self.groups.iter().zip(spots).filter(|(group, _)| **group == NOTHING) {
            let (row, x) = place(*spot);
            let towards = unit(lamps.ray(x as f32, (start + row as i32) as f32));
            let sky = lamps.lighting.daylight.radiance(towards);
            let (cells, k) = samples.cell(planes, row, x);
            for c in 0..3 {
                cells.light[c][k] = 0.0;
                cells.light[c + 3][k] = sky[c];
            }
            cells.drift[k] = 0;
        }
    }
}

/// Reflectance for ambient light (Karis's fit for mobile, 2014).
#[inline(always)]
fn shine(roughness: f32, facing: f32, head_on: f32) -> f32 {
    let r = [1.0 - roughness, 0.0425 - 0.0275 * roughness, 1.04 - 0.572 * roughness, 0.022 * roughness - 0.04];
    // 2^(-9.28 facing), approximated by a power.
    let low = 1.0 - facing;
    let fall = low * low * low * low * low * low;
    let a = (r[0] * r[0]).min(fall) * r[0] + r[1];
    let (scale, shift) = (-1.04 * a + r[2], 1.04 * a + r[3]);
    (head_on * scale + shift).max(0.0)
}

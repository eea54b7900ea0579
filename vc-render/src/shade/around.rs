//! Light from all sides, at half the resolution, and how much nearby things keep away.

use rayon::prelude::*;

use super::Surfel;
use crate::affine::{self, Affine};
use crate::frame::Frame;
use crate::light::{Lighting, falls, sheen};
use crate::raster::refill;
use crate::view::View;

/// How far things keep light away, metres.
const REACH: f32 = 0.45;
/// Comparisons for each point; nine neighbours look in different directions.
const TAPS: usize = 7;
/// Rows given to a thread at a time.
const ROWS: usize = 8;

/// Light from all sides at a pixel of half the resolution.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Around {
    /// One over depth.
    pub(crate) inverse: f32,
    pub(crate) normal: [f32; 3],
    /// What falls on the surface.
    pub(crate) falls: [f32; 3],
    /// What comes from where the surface reflects to.
    pub(crate) sheen: [f32; 3],
}

/// Directions of the comparisons: nine turns of a spiral.
fn spirals() -> [[[f32; 2]; TAPS]; 9] {
    use vc_graph::portable::Portable;
    let tap = |turn: usize, k: usize| {
        let (s, c) = (2.399_963_2 * k as f32 + 0.698_131_7 * turn as f32).sine_cosine();
        let far = ((k as f32 + 0.35 + turn as f32 / 18.0) / TAPS as f32).sqrt().min(1.0);
        [far * c, far * s]
    };
    std::array::from_fn(|turn| std::array::from_fn(|k| tap(turn, k)))
}

/// How open every point is, 0 to 1 (Bavoil and Sainz 2009, by comparisons of points).
pub(super) fn occlusion(view: View<'_>, frame: &mut Frame) {
    let (width, height) = (frame.width, frame.height);
    let across = width.div_ceil(2);
    let (surfels, open) = (&frame.surfels, &mut frame.memory.open);
    refill(open, 1.0, across * height.div_ceil(2));
    let spirals = spirals();
    let turn = Affine::of(&view.camera.pose).inverse().unwrap_or(Affine::IDENTITY).narrow();
    let focal = view.camera.focal;
    let look = Look { surfels, width, height, over: [1.0 / focal.0, 1.0 / focal.1], centre: view.camera.centre };
    open.par_chunks_mut(across * ROWS).enumerate().for_each(|(chunk, rows)| {
        crate::simd::widest(
            #[inline(always)]
            || {
                for (i, out) in rows.iter_mut().enumerate() {
                    let (x, y) = (i % across * 2, (chunk * ROWS + i / across) * 2);
                    let surfel = &surfels[y * width + x];
                    if surfel.inverse > 0.0 {
                        let normal = affine::vector(&turn, surfel.normal());
                        let pattern = &spirals[(x / 2) % 3 + 3 * ((y / 2) % 3)];
                        *out = look.open((x, y), normal, focal.0 * surfel.inverse * REACH, pattern);
                    }
                }
            },
        );
    });
}

struct Look<'a> {
    surfels: &'a [Surfel],
    width: usize,
    height: usize,
    over: [f32; 2],
    centre: (f32, f32),
}

impl Look<'_> {
    #[inline(always)]
    fn point(&self, x: usize, y: usize) -> [f32; 3] {
        let depth = 1.0 / self.surfels[y * self.width + x].inverse.max(1e-9);
        let across = (x as f32 + 0.5 - self.centre.0) * self.over[0];
        let down = (y as f32 + 0.5 - self.centre.1) * self.over[1];
        [across * depth, down * depth, depth]
    }

    #[inline(always)]
    fn open(&self, (x, y): (usize, usize), normal: [f32; 3], radius: f32, taps: &[[f32; 2]; TAPS]) -> f32 {
        let radius = radius.min(0.2 * self.height as f32).max(3.0);
        let here = self.point(x, y);
        let mut kept = 0.0;
        for tap in taps {
            let tx = ((x as f32 + tap[0] * radius) as i32).clamp(0, self.width as i32 - 1);
            let ty = ((y as f32 + tap[1] * radius) as i32).clamp(0, self.height as i32 - 1);
            let there = self.point(tx as usize, ty as usize);
            let to = [0, 1, 2].map(|i: usize| there[i] - here[i]);
            let square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2] + 1e-8;
            let rise = (to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2]) / square.sqrt();
            let near = (1.0 - square * (1.0 / (REACH * REACH))).max(0.0);
            kept += (rise - 0.06).max(0.0) * near;
        }
        (1.0 - 1.7 * kept / TAPS as f32).max(0.08)
    }
}

/// Light from the grids, less what nearby things keep away.
pub(super) fn around(lighting: &Lighting, view: View<'_>, frame: &mut Frame) {
    let (width, height) = (frame.width, frame.height);
    let (across, down) = (width.div_ceil(2), height.div_ceil(2));
    let (surfels, memory) = (&frame.surfels, &mut frame.memory);
    memory.around.resize(across * down, Around::default());
    let open = &memory.open;
    let pose = Affine::of(&view.camera.pose).narrow();
    let eye: [f32; 3] = view.camera.eye().into();
    memory.around.par_chunks_mut(across * ROWS).enumerate().for_each(|(chunk, rows)| {
        crate::simd::widest(
            #[inline(always)]
            || {
                for (i, out) in rows.iter_mut().enumerate() {
                    let (hx, hy) = (i % across, chunk * ROWS + i / across);
                    let surfel = &surfels[hy * 2 * width + hx * 2];
                    *out = Around::default();
                    if surfel.inverse <= 0.0 {
                        continue;
                    }
                    let ray = view.camera.ray(hx as f32 * 2.0 + 0.5, hy as f32 * 2.0 + 0.5);
                    let towards = affine::vector(&pose, ray.into());
                    let depth = 1.0 / surfel.inverse;
                    let at = [0, 1, 2].map(|k: usize| eye[k] + towards[k] * depth);
                    let normal = surfel.normal();
                    let room = view.snapshot.bodies[surfel.body as usize].room;
                    let light = lighting.harmonics(at, normal, room);
                    let share = blurred(open, (across, down), (hx, hy));
                    let along = 2.0 * (towards[0] * normal[0] + towards[1] * normal[1] + towards[2] * normal[2]);
                    let mirrored = crate::label::unit([0, 1, 2].map(|k: usize| towards[k] - along * normal[k]));
                    out.inverse = surfel.inverse;
                    out.normal = normal;
                    out.falls = falls(&light, normal).map(|v| v * share);
                    out.sheen = sheen(&light, mirrored).map(|v| v * (0.3 + 0.7 * share));
                }
            },
        );
    });
}

/// The mean over nine neighbours, whose comparisons differ.
#[inline(always)]
fn blurred(open: &[f32], (across, down): (usize, usize), (x, y): (usize, usize)) -> f32 {
    let rows = y.saturating_sub(1)..(y + 2).min(down);
    let columns = x.saturating_sub(1)..(x + 2).min(across);
    let count = rows.len() * columns.len();
    let sum: f32 =
        rows.map(|row| open[row * across + columns.start..row * across + columns.end].iter().sum::<f32>()).sum();
    sum / count as f32
}

impl Around {
    /// Light at a pixel: of the four around it those that are of its surface.
    #[inline(always)]
    pub(crate) fn at(
        all: &[Self],
        (across, down): (usize, usize),
        (x, y): (usize, usize),
        own: &Surfel,
    ) -> ([f32; 3], [f32; 3]) {
        let normal = own.normal();
        let (x0, y0) = (x / 2, y / 2);
        let (x1, y1) = (x.div_ceil(2).min(across - 1), y.div_ceil(2).min(down - 1));
        let (mut falls, mut sheen, mut total) = ([0.0; 3], [0.0; 3], 1e-12);
        for index in [y0 * across + x0, y0 * across + x1, y1 * across + x0, y1 * across + x1] {
            let one = &all[index];
            let facing = (one.normal[0] * normal[0] + one.normal[1] * normal[1] + one.normal[2] * normal[2]).max(0.0);
            let apart = (one.inverse - own.inverse).abs() / own.inverse;
            let weight = facing * facing * facing / (1e-3 + apart * 20.0) + 1e-6;
            total += weight;
            for i in 0..3 {
                falls[i] += weight * one.falls[i];
                sheen[i] += weight * one.sheen[i];
            }
        }
        let over = 1.0 / total;
        (falls.map(|v| v * over), sheen.map(|v| v * over))
    }
}

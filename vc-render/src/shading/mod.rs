//! Fast colours: deferred shading of the visibility buffer.
//!
//! Ambient occlusion is computed at half the resolution or a quarter ([`occlusion`]). Then the image is
//! processed in strips of a few rows, which stay in the processor's cache: surface attributes are written for
//! every pixel ([`surfel`]); light is computed ([`light`]) where it cannot be interpolated ([`interpolate`]);
//! mirrors and panes are added ([`extra`]); and light is converted to colours ([`colour`]). Finally edges are
//! found ([`edge`]) and smoothed ([`smooth`]).

mod edge;
mod extra;
mod interpolate;
mod light;
mod occlusion;
mod planes;
mod smooth;
mod surfel;
mod texture;

pub(crate) use occlusion::Openness;
pub(crate) use smooth::Smoother;

use std::ops::Range;

use self::edge::Find;
use self::extra::Extra;
use self::interpolate::{Between, STEP, SampleGrid, Spots};
use self::light::{Batch, DRIFT, Lamps};
use self::planes::{Planes, Row, gloss, unpacked};
use self::smooth::Edge;
use self::surfel::{Known, Writer};
use crate::camera::Camera;
use crate::colour;
use crate::frame::Strip;
use crate::light::Lighting;
use crate::math::simd::widest;
use crate::rasterization::Layers;
use crate::scene::Store;
use crate::shot::View;

/// Bands begin at multiples of this number of rows, so that light is computed at the same pixels however many
/// bands there are.
pub(crate) const ALIGNED: usize = 8;

/// Approximate number of pixels in a strip: it should stay in the processor's cache and have enough pixels to shade
/// many at a time.
const STRIP: usize = 2560;

/// Number of pixels of a row processed together.
const PART: usize = 64;

/// Working memory of shading a band, and the edges found in it.
#[derive(Default)]
pub(crate) struct Scratch {
    known: Known,
    planes: Planes,
    samples: SampleGrid,
    batch: Box<Batch>,
    spots: Spots,
    linear: [Vec<f32>; 3],
    /// Colours of the row after the band's last.
    next: Vec<[u8; 3]>,
    edges: Vec<Edge>,
}

/// Inputs shared by all bands.
pub(crate) struct Shading<'a> {
    pub(crate) store: &'a Store,
    pub(crate) lighting: &'a Lighting,
    pub(crate) view: View<'a>,
    /// None for light without shadows.
    pub(crate) open: Option<&'a Openness>,
    pub(crate) exposure: [f32; 3],
}

/// Computes ambient occlusion from the visibility buffers of bands of rows.
pub(crate) fn occlusion<'a, 'b>(
    camera: &Camera,
    bands: impl Iterator<Item = (&'b Layers, Range<i32>)>,
    open: &'a mut Openness,
) -> &'a Openness {
    open.find(camera, bands);
    open
}

impl Scratch {
    /// The edges found in the band.
    pub(crate) fn edges(&self) -> &[Edge] {
        &self.edges
    }
}

impl Shading<'_> {
    /// Writes the colours of a band.
    pub(crate) fn band(&self, layers: &Layers, scratch: &mut Scratch, strip: &mut Strip<'_>) {
        let View { snapshot, camera } = self.view;
        scratch.known.reset(snapshot.instances.len(), layers.visible.len());
        let count = (STRIP / camera.width as usize).next_multiple_of(STEP).max(STEP);
        scratch.planes.prepare(camera.width as usize, count);
        scratch.samples.prepare(camera.width as usize, count);
        scratch.linear.iter_mut().for_each(|l| l.resize(camera.width as usize, 0.0));
        scratch.edges.clear();
        let writer = Writer::new(self.store, (self.lighting, self.exposure), self.view, layers, &strip.rows);
        let lamps = Lamps::new(&writer, self.open, layers.solid());
        let mut rows = Rows { shading: self, layers, writer: &writer, lamps, scratch, start: strip.rows.start, count };
        rows.band(strip);
    }
}

/// A band being shaded, strip by strip.
struct Rows<'a> {
    shading: &'a Shading<'a>,
    layers: &'a Layers,
    writer: &'a Writer<'a>,
    lamps: Lamps<'a>,
    scratch: &'a mut Scratch,
    /// First row of the strip, and rows of one.
    start: i32,
    count: usize,
}

impl Rows<'_> {
    fn band(&mut self, strip: &mut Strip<'_>) {
        self.write(0);
        self.lines(0, 0);
        self.gather(0, 0);
        let end = self.layers.front.rows.end;
        while self.start < strip.rows.end {
            let last = (end - 1 - self.start).min(self.count as i32) as usize;
            for row in 1..=last {
                self.write(row);
            }
            self.rest(last);
            self.finish(last, strip);
            self.scratch.planes.turn();
            self.scratch.samples.turn();
            self.start += self.count as i32;
        }
    }

    /// Writes the surface attributes of a row of the strip.
    fn write(&mut self, row: usize) {
        let Scratch { known, planes, samples, .. } = &mut *self.scratch;
        let (solid, y) = (self.layers.solid(), self.start + row as i32);
        widest(
            #[inline(always)]
            || {
                self.writer.row(solid, y, known, &mut planes.0[row]);
                samples.write(row, &planes.0[row].cells);
            },
        );
    }

    /// Light in every fourth row, from `first` to `last`, by sideways interpolation only.
    fn lines(&mut self, first: usize, last: usize) {
        for row in (first..=last).step_by(STEP) {
            self.scratch.samples.first(row, &mut self.scratch.spots);
        }
        self.light();
        self.fill((first..=last).step_by(STEP).map(SampleGrid::half));
        self.quarters(first, last);
    }

    /// The rest of the light in rows where every second pixel has it.
    fn quarters(&mut self, first: usize, last: usize) {
        self.fill((first..=last).step_by(STEP).flat_map(SampleGrid::quarters));
    }

    /// Light in the rows after the first, up to `last`.
    fn rest(&mut self, last: usize) {
        self.lines(STEP, last);
        self.fill((2..=last).step_by(STEP).flat_map(|row| SampleGrid::between(row, last)));
        self.quarters(2, last);
        self.gather(2, last);
        let Scratch { samples, planes, spots, .. } = &mut *self.scratch;
        (1..=last).step_by(2).for_each(|row| samples.fill_row(planes, (row, last), spots));
        self.light();
    }

    /// Merges the combs of every second row.
    fn gather(&mut self, first: usize, last: usize) {
        let Scratch { samples, planes, .. } = &mut *self.scratch;
        (first..=last).step_by(2).for_each(|row| samples.gather(row, &mut planes.0[row].cells));
    }

    /// Interpolates pixels, and computes the light of those where that is not possible.
    fn fill(&mut self, which: impl Iterator<Item = Between>) {
        let Scratch { samples, spots, .. } = &mut *self.scratch;
        which.for_each(|which| samples.fill(which, spots));
        self.light();
    }

    /// Computes the light of the collected pixels.
    fn light(&mut self) {
        let Scratch { samples, planes, spots, batch, known, .. } = &mut *self.scratch;
        self.lamps.light((samples, planes), known, (self.start, spots), batch);
        spots.clear();
    }

    /// Converts light to colours and finds edges, as far as the row after the strip, which is known too.
    fn finish(&mut self, last: usize, strip: &mut Strip<'_>) {
        let mut next = std::mem::take(&mut self.scratch.next);
        next.resize(strip.width, [0; 3]);
        // Except in the band's first strip, the first row's colours are known from the strip before.
        let known = usize::from(self.start > strip.rows.start);
        for (row, y) in (0..=last).zip(self.start..).skip(known) {
            let inside = y < strip.rows.end;
            let at = if inside { strip.row(y) } else { 0..0 };
            self.colour(row, if inside { &mut strip.rgb[at] } else { &mut next[..] });
        }
        let find = Find { writer: self.writer, solid: self.layers.solid() };
        let Scratch { planes, known, edges, .. } = &mut *self.scratch;
        for (row, y) in (self.start..strip.rows.end).take(self.count).enumerate() {
            let own = &strip.rgb[strip.row(y)];
            widest(
                #[inline(always)]
                || find.across(planes.0[row].groups(), y, own, known, edges),
            );
            if row < last {
                let below = if y + 1 < strip.rows.end { &strip.rgb[strip.row(y + 1)] } else { &next[..] };
                let groups = [&planes.0[row], &planes.0[row + 1]].map(Row::groups);
                widest(
                    #[inline(always)]
                    || find.down(groups, y, [own, below], known, edges),
                );
            }
        }
        self.scratch.next = next;
    }

    /// Converts light to colours in a row of the strip.
    fn colour(&mut self, row: usize, out: &mut [[u8; 3]]) {
        let (shading, y) = (self.shading, self.start + row as i32);
        let Scratch { planes, linear, known, .. } = &mut *self.scratch;
        let seen = &planes.0[row];
        widest(
            #[inline(always)]
            || seen.reflected(linear),
        );
        let [r, g, b] = linear;
        let mut line = [r.as_mut_slice(), g.as_mut_slice(), b.as_mut_slice()];
        let extra = Extra { store: shading.store, view: shading.view, lamps: &self.lamps };
        if known.mirrors() {
            extra.mirrors(known, seen, y, &mut line);
        }
        if self.layers.clear {
            extra.panes(self.layers, &self.writer.frustum, y, &mut line);
        }
        let line = line.map(|l| &*l);
        widest(
            #[inline(always)]
            || colour::colours(line, shading.exposure, out),
        );
    }
}

impl Row {
    /// Light that surfaces reflect to the eye.
    #[inline(always)]
    fn reflected(&self, out: &mut [Vec<f32>; 3]) {
        for from in (0..self.width).step_by(PART) {
            let to = (from + PART).min(self.width);
            self.part(from..to, &self.leant(from..to), out.each_mut().map(|out| &mut out[from..to]));
        }
    }

    /// Factors for the light on pixels whose texture tilts the normal.
    #[inline(always)]
    fn leant(&self, at: std::ops::Range<usize>) -> [f32; PART] {
        let (mut more, count) = ([1.0; PART], at.len().min(PART));
        let (lean, drift) = (&self.lean[at.clone()][..count], &self.cells.drift[at][..count]);
        if lean.iter().fold(0, |all, lean| all | lean) != 0 {
            for x in 0..count {
                let ([a, b, c], [u, v, w]) = (unpacked(lean[x]), unpacked(drift[x]));
                // Half of the computed change, as textures are flat and only simulate relief.
                more[x] = (1.0 + 0.5 * DRIFT * (a * u + b * v + c * w)).clamp(0.4, 1.8);
            }
        }
        more
    }

    #[inline(always)]
    fn part(&self, at: std::ops::Range<usize>, leant: &[f32; PART], out: [&mut [f32]; 3]) {
        let count = at.len().min(PART);
        let shiny = &self.gloss[at.clone()][..count];
        let (mut more, mut metal) = ([0.0_f32; PART], [0.0_f32; PART]);
        for x in 0..count {
            metal[x] = gloss(shiny[x]).1;
            more[x] = (1.0 - metal[x]) * std::f32::consts::FRAC_1_PI * leant[x];
        }
        for (c, out) in out.into_iter().enumerate() {
            let (colour, out) = (&self.colour[c][at.clone()][..count], &mut out[..count]);
            let [falls, sheen] = [c, c + 3].map(|c| &self.cells.light[c][at.clone()][..count]);
            for x in 0..count {
                let tint = 1.0 + metal[x] * (colour[x] - 1.0);
                out[x] = colour[x] * falls[x] * more[x] + tint * sheen[x];
            }
        }
    }
}

//! Optical flow, from the true motion of camera and bodies.

use super::Run;
use crate::math::{Affine, Narrow};
use crate::rasterization::{Frustum, Layers, NONE, refill};
use crate::scene::Instance;
use crate::shot::View;

/// Motion of pixels for every instance, computed on first use.
#[derive(Default)]
pub(crate) struct Motions {
    /// For each instance the index of its map.
    known: Vec<u32>,
    maps: Vec<Narrow>,
}

impl Motions {
    pub(super) fn reset(&mut self, instances: usize) {
        self.maps.clear();
        refill(&mut self.known, NONE, instances);
    }

    /// The map from (x, y, 1, inverse depth) now to homogeneous pixel coordinates at the other moment.
    pub(super) fn map(&mut self, index: usize, now: (&Instance, &Affine), then: (&Instance, &Affine)) -> Narrow {
        if self.known[index] == NONE {
            let own = then.0.world.after(&now.0.world.inverse().unwrap_or(Affine::IDENTITY));
            let back = now.1.inverse().unwrap_or(Affine::IDENTITY);
            self.known[index] = self.maps.len() as u32;
            self.maps.push(then.1.after(&own).after(&back).narrow());
        }
        self.maps[self.known[index] as usize]
    }
}

/// Writes flow from `now` to `then` for the band's pixels.
#[inline(always)]
pub(crate) fn flows(
    now: View<'_>,
    then: View<'_>,
    (layers, runs): (&Layers, &[Run]),
    motions: &mut Motions,
    (width, out): (usize, &mut [[f32; 2]]),
) {
    let rows = layers.front.rows.clone();
    let [from, to] = [now, then].map(|m| Frustum::new(m.camera, &(0..m.camera.height as i32)));
    motions.reset(now.snapshot.instances.len());
    // Pixels where nothing is visible have no flow.
    let mut past = 0;
    for run in runs {
        let at = run.instance as usize;
        let map = motions.map(at, (&now.snapshot.instances[at], &from.map), (&then.snapshot.instances[at], &to.map));
        let inverse = &layers.front.inverse_row(run.y)[run.from as usize..run.to as usize];
        let row = (run.y - rows.start) as usize * width;
        let pixels = row + run.from as usize..row + run.to as usize;
        out[past..pixels.start].fill([f32::NAN; 2]);
        past = pixels.end;
        follow(&map, (run.from as f32 + 0.5, run.y as f32 + 0.5), inverse, &mut out[pixels]);
    }
    out[past..].fill([f32::NAN; 2]);
}

/// Number of pixels processed together.
pub(super) const PART: usize = 64;

#[inline(always)]
fn follow(map: &Narrow, (x, y): (f32, f32), inverse: &[f32], out: &mut [[f32; 2]]) {
    let [right, down, over] = map;
    let start = [right, down, over].map(|row| row[1] * y + row[2]);
    let (mut vs, mut xs, mut ys) = ([0.0_f32; PART], [0.0_f32; PART], [0.0_f32; PART]);
    for (part, (out, inverse)) in (0_u32..).zip(out.chunks_mut(PART).zip(inverse.chunks(PART))) {
        let count = out.len().min(PART);
        vs[..count].copy_from_slice(&inverse[..count]);
        let x = x + (part * PART as u32) as f32;
        // Whole vectors are processed; lanes past the end are not used.
        for i in 0..count.next_multiple_of(8).min(PART) {
            // Signed integers convert to floats in a single vector instruction, unsigned ones do not.
            let x = x + i as i32 as f32;
            let over = 1.0 / (over[0] * x + start[2] + over[3] * vs[i]);
            let (a, b) = (right[0] * x + start[0] + right[3] * vs[i], down[0] * x + start[1] + down[3] * vs[i]);
            xs[i] = if over > 0.0 { a * over - x } else { f32::NAN };
            ys[i] = if over > 0.0 { b * over - y } else { f32::NAN };
        }
        for (i, out) in out.iter_mut().enumerate() {
            *out = [xs[i], ys[i]];
        }
    }
}

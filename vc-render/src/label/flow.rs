//! Optical flow, from the true motion of camera and bodies.

use crate::affine::{Affine, Narrow, volume};
use crate::label::Run;
use crate::raster::{Frustum, Layers, NONE, Visible, refill};
use crate::scene::Instance;
use crate::view::View;

/// Depth at another moment, to tell what is hidden then.
#[derive(Default)]
pub(crate) struct Other {
    pub(crate) layers: Layers,
}

/// For every instance how pixels move, found when it is asked for.
#[derive(Default)]
pub(crate) struct Motions {
    /// Position in the list below.
    known: Vec<u32>,
    maps: Vec<Narrow>,
}

impl Motions {
    fn reset(&mut self, instances: usize) {
        self.maps.clear();
        refill(&mut self.known, NONE, instances);
    }

    /// From (x, y, 1, inverse depth) now to pixels times something, and that, then.
    fn map(&mut self, index: usize, now: (&Instance, &Affine), then: (&Instance, &Affine)) -> Narrow {
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
    // Where nothing is seen, nothing moves.
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

/// Pixels that are followed at once.
const PART: usize = 64;

#[inline(always)]
fn follow(map: &Narrow, (x, y): (f32, f32), inverse: &[f32], out: &mut [[f32; 2]]) {
    let [right, down, over] = map;
    let start = [right, down, over].map(|row| row[1] * y + row[2]);
    let (mut vs, mut xs, mut ys) = ([0.0_f32; PART], [0.0_f32; PART], [0.0_f32; PART]);
    for (part, (out, inverse)) in (0_u32..).zip(out.chunks_mut(PART).zip(inverse.chunks(PART))) {
        let count = out.len().min(PART);
        vs[..count].copy_from_slice(&inverse[..count]);
        let x = x + (part * PART as u32) as f32;
        // Whole blocks: what is past the end is not looked at.
        for i in 0..count.next_multiple_of(8).min(PART) {
            // Vectors of whole numbers become such of floats in one step if they are signed.
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

/// Writes 1 where what is seen now cannot be seen at the other moment.
pub(crate) fn hidden(
    now: View<'_>,
    then: View<'_>,
    (layers, runs): (&Layers, &[Run]),
    (motions, other): (&mut Motions, &Other),
    (width, out): (usize, &mut [u8]),
) {
    let rows = layers.front.rows.clone();
    let [from, to] = [now, then].map(|m| Frustum::new(m.camera, &(0..m.camera.height as i32)));
    let there = There { layers: &other.layers, instances: &then.snapshot.instances, to: &to };
    motions.reset(now.snapshot.instances.len());
    out.fill(1);
    for run in runs {
        let at = run.instance as usize;
        let map = motions.map(at, (&now.snapshot.instances[at], &from.map), (&then.snapshot.instances[at], &to.map));
        let row = (run.y - rows.start) as usize * width;
        let (inverse, triangles) = (layers.front.inverse_row(run.y), layers.front.triangle_row(run.y));
        for x in run.from as usize..run.to as usize {
            let (across, v) = ([x as f32 + 0.5, run.y as f32 + 0.5], inverse[x]);
            let part = |r: usize| map[r][0] * across[0] + map[r][1] * across[1] + map[r][2] + map[r][3] * v;
            let own = layers.visible[triangles[x] as usize];
            out[row + x] = u8::from(!there.shows([part(0), part(1), part(2)], v, own));
        }
    }
}

/// What is seen at the other moment.
struct There<'a> {
    layers: &'a Layers,
    instances: &'a [Instance],
    to: &'a Frustum,
}

/// How much nearer what hides a point is at least, of its depth: rounding is less. Of a curve's own mesh at
/// another level of detail, whose outlines differ; and where triangles are finer than pixels.
const NEARER: f32 = 1.001;
const COARSER: f32 = 1.02;
const FINER: f32 = 1.01;
/// The same of small triangles of its own body, which may be seen at a grazing angle.
const OWN: f32 = 1.04;

/// Area of triangles that tell little about a place beside their pixel, square pixels; the share of what is around a place
/// that has to be of nearer ones to hide it.
const SMALL: f64 = 16.0;
const MOSTLY: f32 = 0.5;

/// What a triangle that is seen near a place says about a point there.
#[derive(Clone, Copy, PartialEq)]
enum Says {
    /// It is in front of the point.
    Hides,
    /// The point is on it or before it.
    Covers,
    /// It is so small that others beside it, which are not seen at a pixel's middle, may be where the point is. They hide
    /// it if they are nearer; those of its own body only where no triangle covers it.
    Little {
        own: bool,
    },
    Nothing,
}

impl There<'_> {
    /// Whether a point is seen, given as pixels times something and that, its inverse depth before, and its triangle:
    /// no triangle that is seen at one of the four pixels around covers it from before, and they are not mostly of
    /// small ones that are nearer. If none covers it, they are finer than pixels, and it is seen unless all
    /// four are nearer.
    fn shows(&self, [x, y, z]: [f32; 3], inverse: f32, own: Visible) -> bool {
        let (front, inverse) = (&self.layers.front, inverse / z);
        let (x, y, width, height) = (x / z, y / z, front.width, front.rows.len());
        let inside = z > 0.0 && x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32;
        if !inside || inverse * self.to.near > 1.0 {
            return false;
        }
        let around = |v: f32, count: usize| [(v - 0.5).max(0.0) as usize, ((v + 0.5) as usize).min(count - 1)];
        let near = |v: f32, pixel: usize| 1.0 - (v - 0.5 - pixel as f32).abs();
        let (columns, mut last, mut says) = (around(x, width), NONE, Says::Nothing);
        let (mut covered, mut least, mut nearer) = (false, f32::INFINITY, [0.0; 2]);
        for row in around(y, height) {
            let (triangles, inverses) = (front.triangle_row(row as i32), front.inverse_row(row as i32));
            for column in columns {
                least = least.min(inverses[column]);
                if std::mem::replace(&mut last, triangles[column]) != last {
                    let visible = self.layers.visible.get(last as usize);
                    says = visible.map_or(Says::Nothing, |v| self.says(*v, ([x, y], inverse), own));
                }
                match says {
                    Says::Hides => return false,
                    Says::Covers => covered = true,
                    Says::Little { own } if inverses[column] > inverse * if own { OWN } else { FINER } => {
                        nearer[usize::from(own)] += near(x, column) * near(y, row);
                    }
                    _ => {}
                }
            }
        }
        nearer[0] < MOSTLY && (covered || nearer[1] < MOSTLY && least <= inverse * FINER)
    }

    fn says(&self, visible: Visible, (at, inverse): ([f32; 2], f32), own: Visible) -> Says {
        if visible == own {
            return Says::Covers;
        }
        let (there, area) = self.covers(visible, at);
        let coarser = visible.instance == own.instance && visible.level() != own.level();
        match there {
            Some(v) if v > inverse * if coarser { COARSER } else { NEARER } => Says::Hides,
            Some(_) => Says::Covers,
            None if area < SMALL => Says::Little { own: visible.instance == own.instance },
            None => Says::Nothing,
        }
    }

    /// The inverse depth of a triangle at a place in the image, if it covers that; and its area there.
    #[inline(never)]
    fn covers(&self, visible: Visible, [x, y]: [f32; 2]) -> (Option<f32>, f64) {
        let mesh = visible.mesh(self.instances);
        let map = self.to.map.after(&self.instances[visible.instance as usize].world);
        let corners = mesh.triangle(mesh.cluster_of(visible.index()), visible.index());
        let corners = corners.map(|p| map.point(p.map(f64::from)));
        let towards = [f64::from(x), f64::from(y), 1.0];
        // Volumes between the ray and two corners each, over that between all three.
        let [a, b, c] = &corners;
        let all = volume(a, b, c);
        let shares = [volume(&towards, b, c), volume(a, &towards, c), volume(a, b, &towards)].map(|v| v / all);
        let there = shares.iter().sum::<f64>() as f32;
        let area = 0.5 * (all / (a[2] * b[2] * c[2])).abs();
        ((shares.iter().all(|s| *s >= 0.0) && there * self.to.near <= 1.0).then_some(there), area)
    }
}

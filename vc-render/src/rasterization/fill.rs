//! Rasterization of triangles.

use pulp::Simd;

use super::project::Corner;
use super::setup::Setup;
use super::target::{LANES, Target};

/// Longest side of the bounding box of a small triangle, in 256ths of a pixel: its edge functions fit in 32
/// bits.
pub(super) const SMALL: i32 = 64 * 256;
/// Subpixel units in a pixel.
pub(super) const PIXEL: i32 = 256;
/// The index of each lane, as a float.
const LANE: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// First and last pixel of a triangle's bounding box, both included.
type Span = ([i32; 2], [i32; 2]);

/// Draws a triangle that is wound from the x axis towards the y axis (as seen from the front); false if its
/// bounding box contains no pixel centre, or it is seen from behind.
#[inline(always)]
pub(super) fn triangle<S: Simd>(simd: S, target: &mut Target, corners: &[Corner; 3], number: u32) -> bool {
    let [a, b, c] = corners;
    let wide = |p: i32, q: i32| i64::from(p - q);
    if wide(b.x, a.x) * wide(c.y, a.y) <= wide(b.y, a.y) * wide(c.x, a.x) {
        return false;
    }
    let (low_x, high_x) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
    let (low_y, high_y) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
    let low = [((low_x + 127) >> 8).max(0), ((low_y + 127) >> 8).max(target.rows.start)];
    let high = [((high_x - 128) >> 8).min(target.width as i32 - 1), ((high_y - 128) >> 8).min(target.rows.end - 1)];
    if low[0] > high[0] || low[1] > high[1] {
        return false;
    }
    large(simd, target, corners, (low, high), number);
    target.mark(low, high);
    true
}

/// Tie-break for points on an edge: one if they count as outside. Exactly one of two triangles that share an
/// edge owns its points.
#[inline(always)]
pub(super) fn tie(dx: i32, dy: i32) -> i32 {
    i32::from(!(dy < 0 || (dy == 0 && dx > 0)))
}

#[inline(always)]
fn range([a, b, c]: &[Corner; 3]) -> (f32, f32) {
    (a.inverse.min(b.inverse).min(c.inverse), a.inverse.max(b.inverse).max(c.inverse))
}

/// Draws a small triangle in blocks of a row, from about where the first edge is crossed to about where the
/// last one is.
#[inline(always)]
pub(super) fn small<S: Simd>(simd: S, target: &mut Target, setup: &Setup, lane: usize, number: u32) {
    let (low, high) = setup.span(lane);
    let first = low[0] as usize / LANES;
    let last = (high[0] as usize / LANES - first) as i32;
    let [p, q, r] = [0, 1, 2].map(|k: usize| setup.across[k][lane]);
    let [mut e, mut f, mut g] = [0, 1, 2].map(|k: usize| setup.value[k][lane]);
    let [e_down, f_down, g_down] = [0, 1, 2].map(|k: usize| setup.down[k][lane]);
    let over = [0, 1, 2].map(|k: usize| setup.over[k][lane]);
    let (across, down) = (setup.slope[0][lane], setup.slope[1][lane]);
    let (start, top) = (setup.start[lane], setup.top[lane]);
    let paint = Paint::new(simd, across, (setup.least[lane], setup.most[lane]), [p, q, r], number);
    for y in low[1]..=high[1] {
        let (from, to) = if last == 0 { (0, 0) } else { blocks([e, f, g], over, last) };
        let at = (y - target.rows.start) as usize * target.stride + first;
        let line = start + down * (y as f32 + 0.5 - top);
        for block in from..=to {
            let columns = block * LANES as i32;
            let values = [e + p * columns, f + q * columns, g + r * columns];
            let at = at + block as usize;
            paint.block(
                simd,
                line + across * columns as f32,
                values,
                (&mut target.inverse[at], &mut target.triangles[at]),
            );
        }
        (e, f, g) = (e + e_down, f + f_down, g + g_down);
    }
    target.mark(low, high);
}

/// Values shared by all pixel blocks of a triangle.
struct Paint<S: Simd> {
    least: S::f32s,
    most: S::f32s,
    number: S::u32s,
    /// Changes of inverse depth and of the edge functions relative to a block's first pixel.
    depths: [f32; LANES],
    edges: [[u32; LANES]; 3],
}

impl<S: Simd> Paint<S> {
    #[inline(always)]
    fn new(simd: S, across: f32, (least, most): (f32, f32), edges: [i32; 3], number: u32) -> Self {
        let (least, most, number) = (simd.splat_f32s(least), simd.splat_f32s(most), simd.splat_u32s(number));
        let (mut depths, mut changes) = ([0.0; LANES], [[0; LANES]; 3]);
        for lane in 0..LANES {
            depths[lane] = across * LANE[lane];
            for (changes, edge) in changes.iter_mut().zip(edges) {
                changes[lane] = (edge * lane as i32) as u32;
            }
        }
        Self { least, most, number, depths, edges: changes }
    }

    /// Draws the pixels of a block that are inside all edges and nearer than the present ones.
    #[inline(always)]
    fn block(&self, simd: S, line: f32, values: [i32; 3], (inverse, triangle): (&mut [f32; LANES], &mut [u32; LANES])) {
        let line = simd.splat_f32s(line);
        let [e, f, g] = values.map(|v| simd.splat_u32s(v as u32));
        let [es, fs, gs] = &self.edges;
        let edges = S::as_simd_u32s(es).0.iter().zip(S::as_simd_u32s(fs).0).zip(S::as_simd_u32s(gs).0);
        let depths = S::as_simd_f32s(&self.depths).0;
        let out = S::as_mut_simd_f32s(inverse).0.iter_mut().zip(S::as_mut_simd_u32s(triangle).0);
        for (((inverse, triangle), ((es, fs), gs)), depth) in out.zip(edges).zip(depths) {
            // The limits come second, so that NaN turns into one of them.
            let v = simd.max_f32s(simd.add_f32s(line, *depth), self.least);
            let v = simd.min_f32s(v, self.most);
            let any = simd.or_u32s(simd.add_u32s(e, *es), simd.add_u32s(f, *fs));
            let any = simd.transmute_i32s_u32s(simd.or_u32s(any, simd.add_u32s(g, *gs)));
            let inside = simd.greater_than_i32s(any, simd.splat_i32s(-1));
            // Outside of the triangle, inverse depth is zero, as in the background. Both old values are read
            // before one is written, as otherwise the selects become masked stores, which are slow on some
            // processors.
            let v = simd.select_f32s(inside, v, simd.splat_f32s(0.0));
            let (far, old) = (*inverse, *triangle);
            *inverse = simd.max_f32s(far, v);
            *triangle = simd.select_u32s(simd.less_than_f32s(far, v), self.number, old);
        }
    }
}

/// First and last block of a row that may be inside all edges, given the edge functions at the first pixel and
/// the reciprocals of their change from pixel to pixel.
#[inline(always)]
fn blocks(values: [i32; 3], over: [f32; 3], last: i32) -> (i32, i32) {
    let (mut from, mut to) = (0.0_f32, (last * LANES as i32) as f32);
    for k in 0..3 {
        // The crossing of the edge; the hundredth of a pixel allows for rounding.
        let at = -(values[k] as f32) * over[k];
        from = if over[k] > 0.0 && at - 0.01 > from { at - 0.01 } else { from };
        to = if over[k] < 0.0 && at + 0.01 < to { at + 0.01 } else { to };
    }
    ((from as i32) / LANES as i32, if to < 0.0 { -1 } else { (to as i32) / LANES as i32 })
}

/// Floor of the quotient of two integers of at most 50 bits, the second one positive.
#[inline(always)]
fn over(above: i64, below: i64) -> i64 {
    let part = (above as f64 / below as f64).floor() as i64;
    // Rounding may have carried the quotient across an integer.
    let left = above - part * below;
    part + i64::from(left >= below) - i64::from(left < 0)
}

/// Draws a large triangle row by row, from where the first edge is crossed to where the last one is.
#[inline(always)]
fn large<S: Simd>(simd: S, target: &mut Target, corners: &[Corner; 3], (low, high): Span, number: u32) {
    let edge = |from: &Corner, to: &Corner| {
        let (dx, dy) = (i64::from(to.x - from.x), i64::from(to.y - from.y));
        let half = i64::from(PIXEL / 2);
        let y = i64::from(low[1] * PIXEL) + half - i64::from(from.y);
        let start = dx * y - dy * (half - i64::from(from.x)) - i64::from(tie(to.x - from.x, to.y - from.y));
        (start, -dy * i64::from(PIXEL), dx * i64::from(PIXEL))
    };
    let [a, b, c] = corners;
    let mut edges = [edge(a, b), edge(b, c), edge(c, a)];
    let (across, down) = wide_slope(corners);
    let paint = Paint::new(simd, across as f32, range(corners), [1, -1, 0], number);
    for y in low[1]..=high[1] {
        let (mut from, mut to) = (i64::from(low[0]), i64::from(high[0]));
        for (value, step, next) in &mut edges {
            match *step {
                0 if *value < 0 => to = -1,
                0 => {}
                s if s > 0 => from = from.max(over(s - 1 - *value, s)),
                s => to = to.min(over(*value, -s)),
            }
            *value += *next;
        }
        if from <= to {
            let line = f64::from(a.inverse) + down * (f64::from(y) + 0.5 - f64::from(a.down));
            let at = (y - target.rows.start) as usize * target.stride;
            for block in from / LANES as i64..=to / LANES as i64 {
                let first = block * LANES as i64;
                let start = line + across * (first as f64 + 0.5 - f64::from(a.across));
                // The ends of the row take the place of edges.
                let values = [(first - from) as i32, (to - first) as i32, 0];
                let at = at + block as usize;
                paint.block(simd, start as f32, values, (&mut target.inverse[at], &mut target.triangles[at]));
            }
        }
    }
}

/// Gradient of inverse depth across and down, in double precision, as triangles may be long or near.
#[inline(always)]
fn wide_slope(corners: &[Corner; 3]) -> (f64, f64) {
    let [a, b, c] = corners.map(|p| [p.across, p.down, p.inverse].map(f64::from));
    let (bx, by, bz) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    let (cx, cy, cz) = (c[0] - a[0], c[1] - a[1], c[2] - a[2]);
    let over = 1.0 / (bx * cy - by * cx);
    ((bz * cy - cz * by) * over, (cz * bx - bz * cx) * over)
}

//! Triangles to pixels.

use pulp::Simd;

use super::project::Corner;
use super::target::{LANES, Target};

/// Longest side of the box around a small triangle, parts of a pixel: sums of
/// products fit in 32 bits.
const SMALL: i32 = 64 * 256;
/// Parts of a pixel.
const PIXEL: i32 = 256;
/// Whole numbers below the number of lanes.
const LANE: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// First and last pixel of a triangle, both included.
type Span = ([i32; 2], [i32; 2]);

/// Draws a triangle whose corners go around it as the y axis goes to the x axis
/// (seen from the front); false if it covers no pixel's centre's column or row, or is seen from behind.
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
    if high_x - low_x <= SMALL && high_y - low_y <= SMALL {
        small(simd, target, corners, (low, high), number);
    } else {
        large(simd, target, corners, (low, high), number);
    }
    target.mark(low, high);
    true
}

/// One where points on the edge are outside: of the two triangles at an edge exactly one owns it.
#[inline(always)]
fn tie(dx: i32, dy: i32) -> i32 {
    i32::from(!(dy < 0 || (dy == 0 && dx > 0)))
}

/// How inverse depth changes across and down, from the corners.
#[inline(always)]
fn slope([a, b, c]: &[Corner; 3]) -> (f32, f32) {
    let (bx, by) = (b.across - a.across, b.down - a.down);
    let (cx, cy) = (c.across - a.across, c.down - a.down);
    let (bz, cz) = (b.inverse - a.inverse, c.inverse - a.inverse);
    let over = 1.0 / (bx * cy - by * cx);
    ((bz * cy - cz * by) * over, (cz * bx - bz * cx) * over)
}

#[inline(always)]
fn range([a, b, c]: &[Corner; 3]) -> (f32, f32) {
    (a.inverse.min(b.inverse).min(c.inverse), a.inverse.max(b.inverse).max(c.inverse))
}

/// Block by block of the rows, from about where the first edge is crossed to about where
/// the last one is.
#[inline(always)]
fn small<S: Simd>(simd: S, target: &mut Target, corners: &[Corner; 3], (low, high): Span, number: u32) {
    let first = low[0] as usize / LANES;
    let last = (high[0] as usize / LANES - first) as i32;
    let origin = [(first * LANES) as i32, low[1]];
    let [a, b, c] = corners;
    let mut edges = [Edge::new(a, b, origin), Edge::new(b, c, origin), Edge::new(c, a, origin)];
    let [p, q, r] = [edges[0].across, edges[1].across, edges[2].across];
    let (across, down) = slope(corners);
    let start = a.inverse + across * (origin[0] as f32 + 0.5 - a.across);
    let paint = Paint::new(simd, across, range(corners), [p, q, r], number);
    for y in low[1]..=high[1] {
        let (from, to) = if last == 0 { (0, 0) } else { blocks(&edges, last) };
        let at = (y - target.rows.start) as usize * target.stride + first;
        let line = start + down * (y as f32 + 0.5 - a.down);
        let [e, f, g] = [edges[0].value, edges[1].value, edges[2].value];
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
        edges.iter_mut().for_each(|edge| edge.value += edge.down);
    }
}

/// What a triangle's blocks of pixels are drawn with.
struct Paint<S: Simd> {
    least: S::f32s,
    most: S::f32s,
    number: S::u32s,
    /// Changes of inverse depth and of the edge functions from a block's first pixel on.
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

    /// Draws a block's pixels that are inside all edges and nearer than what is there.
    #[inline(always)]
    fn block(&self, simd: S, line: f32, values: [i32; 3], (inverse, triangle): (&mut [f32; LANES], &mut [u32; LANES])) {
        let line = simd.splat_f32s(line);
        let [e, f, g] = values.map(|v| simd.splat_u32s(v as u32));
        let [es, fs, gs] = &self.edges;
        let edges = S::as_simd_u32s(es).0.iter().zip(S::as_simd_u32s(fs).0).zip(S::as_simd_u32s(gs).0);
        let depths = S::as_simd_f32s(&self.depths).0;
        let out = S::as_mut_simd_f32s(inverse).0.iter_mut().zip(S::as_mut_simd_u32s(triangle).0);
        for (((inverse, triangle), ((es, fs), gs)), depth) in out.zip(edges).zip(depths) {
            // Limits come second: what is no number becomes one of them.
            let v = simd.max_f32s(simd.add_f32s(line, *depth), self.least);
            let v = simd.min_f32s(v, self.most);
            let any = simd.or_u32s(simd.add_u32s(e, *es), simd.add_u32s(f, *fs));
            let any = simd.transmute_i32s_u32s(simd.or_u32s(any, simd.add_u32s(g, *gs)));
            let inside = simd.greater_than_i32s(any, simd.splat_i32s(-1));
            let drawn = simd.and_m32s(inside, simd.less_than_f32s(*inverse, v));
            *inverse = simd.select_f32s(drawn, v, *inverse);
            *triangle = simd.select_u32s(drawn, self.number, *triangle);
        }
    }
}

/// An edge function at the first pixel of a row, and how it changes from pixel to pixel.
struct Edge {
    value: i32,
    across: i32,
    down: i32,
    /// One over the change across; zero without any.
    over: f32,
}

impl Edge {
    #[inline(always)]
    fn new(from: &Corner, to: &Corner, origin: [i32; 2]) -> Self {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let x = origin[0] * PIXEL + PIXEL / 2 - from.x;
        let y = origin[1] * PIXEL + PIXEL / 2 - from.y;
        let across = -dy * PIXEL;
        let over = if across == 0 { 0.0 } else { 1.0 / across as f32 };
        Self { value: dx * y - dy * x - tie(dx, dy), across, down: dx * PIXEL, over }
    }
}

/// First and last block of a row that may be inside all edges.
#[inline(always)]
fn blocks(edges: &[Edge; 3], last: i32) -> (i32, i32) {
    let (mut from, mut to) = (0.0_f32, (last * LANES as i32) as f32);
    for edge in edges {
        // Where it is crossed; the hundredth of a pixel is for rounding.
        let at = -(edge.value as f32) * edge.over;
        from = if edge.across > 0 && at - 0.01 > from { at - 0.01 } else { from };
        to = if edge.across < 0 && at + 0.01 < to { at + 0.01 } else { to };
    }
    ((from as i32) / LANES as i32, if to < 0.0 { -1 } else { (to as i32) / LANES as i32 })
}

/// Row by row, from where the first edge is crossed to where the last one is.
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
                s if s > 0 => from = from.max((s - 1 - *value).div_euclid(s)),
                s => to = to.min(value.div_euclid(-s)),
            }
            *value += *next;
        }
        if from <= to {
            let line = f64::from(a.inverse) + down * (f64::from(y) + 0.5 - f64::from(a.down));
            let at = (y - target.rows.start) as usize * target.stride;
            for block in from / LANES as i64..=to / LANES as i64 {
                let first = block * LANES as i64;
                let start = line + across * (first as f64 + 0.5 - f64::from(a.across));
                // The ends of the row are its edges.
                let values = [(first - from) as i32, (to - first) as i32, 0];
                let at = at + block as usize;
                paint.block(simd, start as f32, values, (&mut target.inverse[at], &mut target.triangles[at]));
            }
        }
    }
}

/// As [`slope`], in double precision for triangles that are long or near.
#[inline(always)]
fn wide_slope(corners: &[Corner; 3]) -> (f64, f64) {
    let [a, b, c] = corners.map(|p| [p.across, p.down, p.inverse].map(f64::from));
    let (bx, by, bz) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    let (cx, cy, cz) = (c[0] - a[0], c[1] - a[1], c[2] - a[2]);
    let over = 1.0 / (bx * cy - by * cx);
    ((bz * cy - cz * by) * over, (cz * bx - bz * cx) * over)
}

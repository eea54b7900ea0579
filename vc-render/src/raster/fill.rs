//! Triangles to pixels.

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
pub(super) fn triangle(target: &mut Target, corners: &[Corner; 3], number: u32) -> bool {
    let [a, b, c] = corners;
    let (low_x, high_x) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
    let (low_y, high_y) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
    let low = [((low_x + 127) >> 8).max(0), ((low_y + 127) >> 8).max(target.rows.start)];
    let high = [((high_x - 128) >> 8).min(target.width as i32 - 1), ((high_y - 128) >> 8).min(target.rows.end - 1)];
    if low[0] > high[0] || low[1] > high[1] {
        return false;
    }
    if high_x - low_x <= SMALL && high_y - low_y <= SMALL {
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if area <= 0 {
            return false;
        }
        small(target, corners, (low, high), number);
    } else {
        let [a, b, c] = corners.map(|p| [i64::from(p.x), i64::from(p.y)]);
        if (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0 {
            return false;
        }
        large(target, corners, (low, high), number);
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

#[inline(always)]
fn small(target: &mut Target, corners: &[Corner; 3], (low, high): Span, number: u32) {
    let first = low[0] as usize / LANES;
    let blocks = high[0] as usize / LANES - first + 1;
    let origin = [(first * LANES) as i32, low[1]];
    let edge = |from: &Corner, to: &Corner| {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let x = origin[0] * PIXEL + PIXEL / 2 - from.x;
        let y = origin[1] * PIXEL + PIXEL / 2 - from.y;
        (dx * y - dy * x - tie(dx, dy), -dy * PIXEL, dx * PIXEL)
    };
    let [a, b, c] = corners;
    let edges = [edge(a, b), edge(b, c), edge(c, a)];
    let mut rows = edges.map(|(start, across, _)| [0, 1, 2, 3, 4, 5, 6, 7].map(|lane: i32| start + across * lane));
    let (across, down) = slope(corners);
    let (least, most) = range(corners);
    let start = a.inverse + across * (origin[0] as f32 + 0.5 - a.across);
    for y in low[1]..=high[1] {
        let at = (y - target.rows.start) as usize * target.stride + first;
        let line = start + down * (y as f32 + 0.5 - a.down);
        let inverses = &mut target.inverse[at..at + blocks];
        let triangles = &mut target.triangles[at..at + blocks];
        let mut inside = rows;
        let mut column = 0.0;
        for (inverse, triangle) in inverses.iter_mut().zip(triangles) {
            for lane in 0..LANES {
                let v = line + across * (column + LANE[lane]);
                let v = if v > least { v } else { least };
                let v = if v < most { v } else { most };
                let drawn = ((inside[0][lane] | inside[1][lane] | inside[2][lane]) >= 0) & (v > inverse[lane]);
                inverse[lane] = if drawn { v } else { inverse[lane] };
                triangle[lane] = if drawn { number } else { triangle[lane] };
            }
            for edge in 0..3 {
                let step = edges[edge].1 * LANES as i32;
                inside[edge].iter_mut().for_each(|value| *value = value.wrapping_add(step));
            }
            column += LANES as f32;
        }
        for edge in 0..3 {
            rows[edge].iter_mut().for_each(|value| *value += edges[edge].2);
        }
    }
}

/// Row by row, from where the first edge is crossed to where the last one is.
#[inline(always)]
fn large(target: &mut Target, corners: &[Corner; 3], (low, high): Span, number: u32) {
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
    let (least, most) = range(corners);
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
            let start = line + across * (from as f64 + 0.5 - f64::from(a.across));
            let at = (y - target.rows.start) as usize * target.stride * LANES;
            let columns = at + from as usize..at + to as usize + 1;
            let inverse = &mut target.inverse.as_flattened_mut()[columns.clone()];
            let triangles = &mut target.triangles.as_flattened_mut()[columns];
            run(inverse, triangles, (start as f32, across as f32), (least, most), number);
        }
    }
}

#[inline(always)]
fn run(inverse: &mut [f32], triangles: &mut [u32], (start, step): (f32, f32), (least, most): (f32, f32), number: u32) {
    for ((column, inverse), triangle) in (0_u32..).zip(inverse).zip(triangles) {
        let v = start + step * column as f32;
        let v = if v > least { v } else { least };
        let v = if v < most { v } else { most };
        let drawn = v > *inverse;
        *inverse = if drawn { v } else { *inverse };
        *triangle = if drawn { number } else { *triangle };
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

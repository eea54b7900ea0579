//! Outlines in a plane, counter-clockwise, for prisms and rings.

use std::f32::consts::{FRAC_PI_2, TAU};
use std::sync::LazyLock;

use vc_graph::portable::Portable;

use super::build::Axis;
use super::curve::oval;

/// The four corners of a rectangle around the origin, as signs of X and Y.
pub(crate) const CORNERS: [(f32, f32); 4] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];

/// The point at an angle and a distance from the origin of a plane.
pub(crate) fn polar(angle: f32, radius: f32) -> (f32, f32) {
    let (sin, cos) = angle.sine_cosine();
    (cos * radius, sin * radius)
}

/// Corners of a regular polygon, the first one at `start` radians.
///
/// ```
/// use vc_shapes::solid::polygon;
/// let hexagon = polygon(6, 1.0, 0.0);
/// assert!(hexagon.len() == 6 && hexagon.iter().all(|(x, y)| (x.hypot(*y) - 1.0).abs() < 1e-5));
/// ```
pub fn polygon(corners: usize, radius: f32, start: f32) -> Vec<(f32, f32)> {
    (0..corners).map(|i| polar(start + TAU * i as f32 / corners as f32, radius)).collect()
}

/// A regular polygon as an outline.
///
/// ```
/// use vc_shapes::solid::ngon;
/// assert!(ngon((0.3, 0.1), 8).iter().all(|(x, y)| x.abs() <= 0.3001 && y.abs() <= 0.1001));
/// ```
pub fn ngon(half: (f32, f32), n: usize) -> Vec<(f32, f32)> {
    oval(Axis::Z, [0.0; 3], half, 0, n).into_iter().map(|p| (p[0], p[1])).collect()
}

/// A star whose corners alternate between two radii.
///
/// ```
/// use vc_shapes::solid::star;
/// assert_eq!(star(5, 1.0, 0.4).len(), 10);
/// ```
pub fn star(points: usize, outer: f32, inner: f32) -> Vec<(f32, f32)> {
    let step = TAU / (2 * points) as f32;
    (0..2 * points).map(|i| polar(step * i as f32, if i % 2 == 0 { outer } else { inner })).collect()
}

/// The outline of an ellipse.
///
/// ```
/// use vc_shapes::solid::ellipse;
/// let plate = ellipse((0.2, 0.1));
/// assert!(plate.iter().all(|(x, y)| ((x / 0.2).powi(2) + (y / 0.1).powi(2) - 1.0).abs() < 1e-3));
/// ```
pub fn ellipse(half: (f32, f32)) -> Vec<(f32, f32)> {
    let mut points: Vec<_> = turned(8, half).into_iter().map(|(_, p)| p).collect();
    points.dedup_by(|a, b| (a.0 - b.0).abs() + (a.1 - b.1).abs() < 1e-5);
    points.pop();
    points
}

/// Points around an ellipse, spaced as evenly as a whole number of steps of about `step` allows, 24 at most.
pub(crate) fn evenly_spaced_ellipse(half: (f32, f32), step: f32) -> Vec<(f32, f32)> {
    const FINE: usize = 96;
    let at = |i: usize| {
        let (x, y) = polar(TAU * i as f32 / FINE as f32, 1.0);
        (x * half.0, y * half.1)
    };
    let mut walked = vec![0.0_f32];
    for i in 0..FINE {
        let ((x0, y0), (x1, y1)) = (at(i), at(i + 1));
        walked.push(walked[i] + (x1 - x0).hypotenuse(y1 - y0));
    }
    let count = (walked[FINE] / step).ceil().clamp(3.0, 24.0) as usize;
    let place = |k: usize| walked.partition_point(|w| *w < walked[FINE] * k as f32 / count as f32);
    (0..count).map(|k| at(place(k))).collect()
}

/// An ellipse with `count` corners around a centre.
pub(crate) fn oval_outline(centre: (f32, f32), half: (f32, f32), count: usize) -> Vec<(f32, f32)> {
    arc_outline(centre, half, (0.0, TAU * (1.0 - 1.0 / count as f32)), count)
}

/// Part of an ellipse, from one angle to another.
pub(crate) fn arc_outline(centre: (f32, f32), half: (f32, f32), angles: (f32, f32), count: usize) -> Vec<(f32, f32)> {
    let turn = |i: usize| angles.0 + (angles.1 - angles.0) * i as f32 / (count.max(2) - 1) as f32;
    (0..count).map(|i| turn(i).sine_cosine()).map(|(s, c)| (centre.0 + half.0 * c, centre.1 + half.1 * s)).collect()
}

/// A band along a curve: the curve followed by the same curve, reversed and shifted by `by`.
///
/// ```
/// use vc_shapes::solid::band;
/// let strip = band(&[(0.0, 0.0), (1.0, 0.0)], (0.0, 0.1));
/// assert_eq!(strip, [(0.0, 0.0), (1.0, 0.0), (1.0, 0.1), (0.0, 0.1)]);
/// ```
pub fn band(curve: &[(f32, f32)], by: (f32, f32)) -> Vec<(f32, f32)> {
    let back = curve.iter().rev().map(|&(x, y)| (x + by.0, y + by.1));
    curve.iter().copied().chain(back).collect()
}

/// A rectangle with rounded corners; `round` is 0 for sharp corners and 1 for half circles.
pub(crate) fn rounded_by_share(half: (f32, f32), round: f32) -> Vec<(f32, f32)> {
    let r = half.0.min(half.1) * round.clamp(0.02, 0.999);
    let point = |i: usize| {
        let (sx, sy) = CORNERS[i / CORNER];
        let (s, c) = TURNS[i];
        (sx * (half.0 - r) + r * c, sy * (half.1 - r) + r * s)
    };
    (0..TURNS.len()).map(point).collect()
}

/// Number of points of a rounded corner.
const CORNER: usize = 6;

/// Sine and cosine of the points of four rounded corners.
static TURNS: LazyLock<[(f32, f32); 4 * CORNER]> = LazyLock::new(|| {
    let part = |i: usize| (i / CORNER) as f32 + (i % CORNER) as f32 / (CORNER - 1) as f32;
    std::array::from_fn(|i| (FRAC_PI_2 * part(i)).sine_cosine())
});

/// An outline with rounded corners around the origin, for prisms along Z. Large radii give a
/// stadium or a circle.
///
/// ```
/// use vc_shapes::solid::rounded_by_radius;
/// let outline = rounded_by_radius((0.3, 0.2), 0.05);
/// assert!(outline.iter().all(|(x, y)| x.abs() < 0.3001 && y.abs() < 0.2001));
/// ```
pub fn rounded_by_radius(half: (f32, f32), radius: f32) -> Vec<(f32, f32)> {
    let r = radius.min(half.0 * 0.999).min(half.1 * 0.999);
    turned(6, (r, r)).into_iter().map(|(c, p)| (p.0 + c.0 * (half.0 - r), p.1 + c.1 * (half.1 - r))).collect()
}

/// Four quarters of an ellipse, each including both ends, as pairs of the quarter's corner and a
/// point.
fn turned(steps: usize, half: (f32, f32)) -> Vec<((f32, f32), (f32, f32))> {
    let arc = (0..=steps).map(move |i| {
        // Tangents of half angles give points of a circle without a sine; the correction by the
        // tangent of an eighth turn spaces them evenly.
        let k = i as f32 / steps as f32;
        let t = k * (1.0 + k * 0.2) / 1.2;
        ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t))
    });
    let arc: Vec<(f32, f32)> = arc.collect();
    let quarter = |q: usize| {
        let corner = CORNERS[q];
        arc.clone().into_iter().map(move |(c, s)| {
            let (x, y) = [(c, s), (-s, c), (-c, -s), (s, -c)][q];
            (corner, (x * half.0, y * half.1))
        })
    };
    (0..4).flat_map(quarter).collect()
}

/// A rectangle from `low` to `high` with its corners rounded by `by`.
pub(crate) fn rounded_between(low: (f32, f32), high: (f32, f32), by: (f32, f32)) -> Vec<(f32, f32)> {
    let quarter = TAU / 4.0;
    let (x0, x1, y0, y1) = (low.0 + by.0, high.0 - by.0, low.1 + by.1, high.1 - by.1);
    let centres = [(x1, y1), (x0, y1), (x0, y0), (x1, y0)];
    let turns = centres.iter().enumerate();
    turns.flat_map(|(i, &c)| arc_outline(c, by, (i as f32 * quarter, (i + 1) as f32 * quarter), 4)).collect()
}

/// A rectangle of half lengths `half` whose corners are rounded by `r`.
///
/// ```
/// use vc_shapes::solid::oblong;
/// assert_eq!(oblong((0.3, 0.2), 0.05).len(), 20);
/// ```
pub fn oblong(half: (f32, f32), r: f32) -> Vec<(f32, f32)> {
    let steps = [(1.0, 0.0), (0.924, 0.383), (0.707, 0.707), (0.383, 0.924), (0.0, 1.0)];
    let r = r.min(half.0 * 0.98).min(half.1 * 0.98);
    let (x, y) = (half.0 - r, half.1 - r);
    // Each quarter rotates the steps by a right angle.
    let turned = |q: usize, (c, s): (f32, f32)| match q {
        0 => (x + r * c, y + r * s),
        1 => (-x - r * s, y + r * c),
        2 => (-x - r * c, -y - r * s),
        _ => (x + r * s, -y - r * c),
    };
    (0..4).flat_map(|q| steps.map(|p| turned(q, p))).collect()
}

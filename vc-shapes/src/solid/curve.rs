//! Curves in space, as points from which surfaces are made.

use std::f32::consts::PI;

use vc_graph::portable::Portable;

use super::build::{Axis, P};
use super::circle;
use super::outline::rounded_by_share;

/// Steps in the half turn along which handles and loops are bent.
const BENDS: usize = 7;

/// Interpolates between two points by `t`.
///
/// ```
/// use vc_shapes::solid::mix;
/// assert_eq!(mix([0.0, 0.0, 0.0], [1.0, 2.0, 4.0], 0.5), [0.5, 1.0, 2.0]);
/// ```
pub fn mix(a: P, b: P, t: f32) -> P {
    [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)
}

/// `count` numbers evenly spaced from `low` to `high`, both included; the midpoint if `count` is
/// one.
///
/// ```
/// use vc_shapes::solid::spaced;
/// assert_eq!(spaced(3, -1.0, 1.0).collect::<Vec<_>>(), [-1.0, 0.0, 1.0]);
/// ```
pub fn spaced(count: usize, low: f32, high: f32) -> impl Iterator<Item = f32> {
    let last = count.saturating_sub(1) as f32;
    (0..count).map(move |i| if last > 0.0 { low + (high - low) * i as f32 / last } else { f32::midpoint(low, high) })
}

/// Points around an ellipse perpendicular to an axis; `square` of 1 or 2 fills its bounding box
/// more.
///
/// ```
/// use vc_shapes::solid::{Axis, oval};
/// let ring = oval(Axis::Z, [0.0, 0.0, 0.5], (0.2, 0.1), 0, 12);
/// assert!(ring.len() == 12 && ring.iter().all(|p| p[2] == 0.5));
/// ```
pub fn oval(axis: Axis, at: P, half: (f32, f32), square: usize, n: usize) -> Vec<P> {
    let full = |v: f32| (0..square).fold(v.abs(), |v, _| v.sqrt()).copysign(v);
    (0..n)
        .map(|i| {
            let (s, c) = circle::part(i, n);
            across(axis, at, half.0 * full(c), half.1 * full(s))
        })
        .collect()
}

/// A level ellipse of 16 points.
pub fn level_oval(centre: P, half: (f32, f32)) -> Vec<P> {
    oval(Axis::Z, centre, half, 0, 16)
}

/// A horizontal rectangle with rounded corners at a height.
pub(crate) fn rounded_ring(z: f32, half: (f32, f32), round: f32) -> Vec<P> {
    rounded_by_share(half, round).into_iter().map(|(x, y)| [x, y, z]).collect()
}

/// A point of the plane perpendicular to an axis through `at`.
fn across(axis: Axis, at: P, a: f32, b: f32) -> P {
    match axis {
        Axis::X => [at[0], at[1] + a, at[2] + b],
        Axis::Y => [at[0] + a, at[1], at[2] + b],
        Axis::Z => [at[0] + a, at[1] + b, at[2]],
    }
}

/// An arc perpendicular to an axis, from one angle to another.
///
/// ```
/// use std::f32::consts::PI;
/// use vc_shapes::solid::{Axis, arc};
/// let half = arc(Axis::X, [0.0; 3], (0.1, 0.1), (0.0, PI), 8);
/// assert!(half.len() == 9 && half.iter().all(|p| p[0] == 0.0 && p[2] > -1e-6));
/// ```
pub fn arc(axis: Axis, at: P, half: (f32, f32), angles: (f32, f32), n: usize) -> Vec<P> {
    (0..=n)
        .map(|i| {
            let (s, c) = (angles.0 + (angles.1 - angles.0) * i as f32 / n as f32).sine_cosine();
            across(axis, at, half.0 * c, half.1 * s)
        })
        .collect()
}

/// Points of half an ellipse: from `centre + across` via `centre + out` to `centre - across`.
///
/// ```
/// use vc_shapes::solid::arch;
/// let handle = arch([0.0; 3], [0.0, 0.1, 0.0], [0.0, 0.0, 0.05]);
/// assert_eq!(handle[0], [0.0, 0.1, 0.0]);
/// assert!(handle.iter().all(|p| p[2] <= 0.05));
/// ```
pub fn arch(centre: P, across: P, out: P) -> Vec<P> {
    let point = |k: usize| {
        let (s, c) = (PI * k as f32 / BENDS as f32).sine_cosine();
        [0, 1, 2].map(|i| centre[i] + across[i] * c + out[i] * s)
    };
    (0..=BENDS).map(point).collect()
}

/// A smooth Catmull-Rom curve through points with `steps` segments between two.
///
/// ```
/// use vc_shapes::solid::spline;
/// let curve = spline(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]], 4);
/// assert!(curve.len() == 9 && curve[4] == [1.0, 0.0, 0.0]);
/// ```
pub fn spline(points: &[P], steps: usize) -> Vec<P> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let at = |i: isize| points[i.max(0).min(last as isize) as usize];
    let mut curve = Vec::with_capacity(last * steps + 1);
    for i in 0..last as isize {
        let [a, b, c, d] = [-1, 0, 1, 2].map(|k| at(i + k));
        for k in 0..steps {
            let t = k as f32 / steps as f32;
            curve.push([0, 1, 2].map(|j| {
                let (p, q) = (c[j] - a[j], 2.0 * a[j] - 5.0 * b[j] + 4.0 * c[j] - d[j]);
                b[j] + t / 2.0 * (p + t * (q + t * (3.0 * (b[j] - c[j]) + d[j] - a[j])))
            }));
        }
    }
    curve.push(points[last]);
    curve
}

//! Distance between two boxes that may lean.

use nalgebra::Vector3;

use crate::solid::Solid;

/// How far two boxes are apart, metres; zero where they overlap. Exact. Costs about a
/// microsecond.
pub(crate) fn distance(a: &Solid, b: &Solid) -> f32 {
    if crate::solid::gap(a, b, 0.0) <= 0.0 { 0.0 } else { features(a, b) }
}

/// The least distance of corners from boxes and edges from edges, of boxes that do not
/// overlap.
fn features(a: &Solid, b: &Solid) -> f32 {
    let corner = |of: &Solid, to: &Solid| {
        of.corners(1.0).iter().map(|c| (to.nearest(c) - c).norm()).fold(f32::INFINITY, f32::min)
    };
    let (edges_a, edges_b) = (edges(a), edges(b));
    let (balls_a, balls_b) = (edges_a.map(ball), edges_b.map(ball));
    let mut least = corner(a, b).min(corner(b, a));
    for (e, (at, reach)) in edges_a.iter().zip(&balls_a) {
        for (f, (other, other_reach)) in edges_b.iter().zip(&balls_b) {
            // No point of one is nearer than the balls around the two.
            if (at - other).norm() <= least + reach + other_reach + ROUNDING {
                least = least.min(between(e, f));
            }
        }
    }
    least
}

/// What rounding may take off a distance, metres.
const ROUNDING: f32 = 1e-4;

/// The ball around a segment.
fn ball((from, to): Segment) -> (Vector3<f32>, f32) {
    ((from + to) / 2.0, (to - from).norm() / 2.0)
}

type Segment = (Vector3<f32>, Vector3<f32>);

fn edges(s: &Solid) -> [Segment; 12] {
    let corners = s.corners(1.0);
    std::array::from_fn(|i| {
        let (bit, rest) = (i / 4, i % 4);
        // The two other bits of a corner's number, around the one that changes.
        let low = rest & ((1 << bit) - 1);
        let start = (rest - low) << 1 | low;
        (corners[start], corners[start | 1 << bit])
    })
}

/// Distance of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
fn between(e: &Segment, f: &Segment) -> f32 {
    let (d1, d2, r) = (e.1 - e.0, f.1 - f.0, e.0 - f.0);
    let (a, c, b) = (d1.norm_squared(), d2.norm_squared(), d1.dot(&d2));
    let (dr, fr) = (d1.dot(&r), d2.dot(&r));
    let ratio = |up: f32, down: f32| if down > 1e-12 { (up / down).clamp(0.0, 1.0) } else { 0.0 };
    let s = ratio(b * fr - c * dr, a * c - b * b);
    let t = ratio(b * s + fr, c);
    let s = ratio(b * t - dr, a);
    ((e.0 + d1 * s) - (f.0 + d2 * t)).norm()
}

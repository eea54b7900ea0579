//! Distance between two boxes.

use nalgebra::{Vector2, Vector3};

use crate::solid::Solid;

/// How far two boxes are apart, metres; zero where they overlap. Exact. Costs some tens of
/// nanoseconds for upright boxes, a microsecond for others.
pub(crate) fn distance(a: &Solid, b: &Solid) -> f32 {
    if a.upright && b.upright {
        let rise = (a.low.z - b.high.z).max(b.low.z - a.high.z).max(0.0);
        return (rise * rise + plan_distance_squared(a, b)).sqrt();
    }
    if crate::solid::gap(a, b, 0.0) <= 0.0 { 0.0 } else { features(a, b) }
}

/// Square of the distance of the footprints of two upright boxes.
fn plan_distance_squared(a: &Solid, b: &Solid) -> f32 {
    let way = (b.centre - a.centre).xy();
    let axis = |s: &Solid, i: usize| Vector2::new(s.axes[(0, i)], s.axes[(1, i)]);
    let (ax, bx) = (axis(a, 0), axis(b, 0));
    let cosine = ax.dot(&bx).abs();
    if !(1e-4..=0.999_999).contains(&cosine) {
        // Parallel rectangles: the gaps along both axes.
        let (bh, ay) = (if cosine > 0.5 { b.half.xy() } else { b.half.yx() }, axis(a, 1));
        let x = (way.dot(&ax).abs() - a.half.x - bh.x).max(0.0);
        let y = (way.dot(&ay).abs() - a.half.y - bh.y).max(0.0);
        return x * x + y * y;
    }
    if overlap(a, b, way) {
        return 0.0;
    }
    // Turned rectangles are apart where a corner of one is nearest to the other.
    corner_distance(a, b).min(corner_distance(b, a))
}

fn overlap(a: &Solid, b: &Solid, way: Vector2<f32>) -> bool {
    [a, b].iter().all(|s| {
        (0..2).all(|i| {
            let axis: Vector3<f32> = s.axes.column(i).into();
            way.dot(&axis.xy()).abs() <= a.level_reach(&axis) + b.level_reach(&axis)
        })
    })
}

/// Square of the least distance of a footprint's corners from another footprint.
fn corner_distance(corners_of: &Solid, from: &Solid) -> f32 {
    let (u, v) = (from.axes.column(0).xy(), from.axes.column(1).xy());
    let own = |w: Vector2<f32>| Vector2::new(w.dot(&u), w.dot(&v));
    let centre = own((corners_of.centre - from.centre).xy());
    let x = own(corners_of.axes.column(0).xy()) * corners_of.half.x;
    let y = own(corners_of.axes.column(1).xy()) * corners_of.half.y;
    let outside = |p: Vector2<f32>| (p.abs() - from.half.xy()).sup(&Vector2::zeros()).norm_squared();
    let squared = [x + y, x - y, -x + y, -x - y].map(|c| outside(centre + c));
    squared.into_iter().fold(f32::INFINITY, f32::min)
}

/// The least distance of corners from boxes and edges from edges, of boxes that do not
/// overlap.
fn features(a: &Solid, b: &Solid) -> f32 {
    let corner = |of: &Solid, to: &Solid| {
        of.corners(1.0).iter().map(|c| (to.nearest(c) - c).norm()).fold(f32::INFINITY, f32::min)
    };
    let (edges_a, edges_b) = (edges(a), edges(b));
    let pairs = edges_a.iter().flat_map(|e| edges_b.iter().map(move |f| between(e, f)));
    pairs.fold(corner(a, b).min(corner(b, a)), f32::min)
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

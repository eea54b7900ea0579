//! Distance between two oriented boxes.

use nalgebra::Vector3;
use vc_geometry::order::lesser;

use crate::solid::Solid;

/// Distance between two boxes, metres; zero if they overlap. Exact. Costs about a microsecond.
pub(crate) fn distance(a: &Solid, b: &Solid) -> f32 {
    let apart = crate::solid::gap(a, b, f32::INFINITY);
    if apart <= 0.0 { 0.0 } else { features(a, b, apart) }
}

/// The least distance of corners from boxes and of edges from edges, for boxes that do not overlap.
///
/// If two edges are nearest between their ends, the segment that connects the nearest points is perpendicular
/// to both, and no other edge of either box lies farther along it. So for each pair of axes only the edges that
/// lie outermost along their cross product are measured. No edges are measured if a corner is as near as the
/// boxes are apart along some axis.
fn features(a: &Solid, b: &Solid, apart: f32) -> f32 {
    let corner = |of: &Solid, to: &Solid| {
        of.corners(1.0).iter().map(|c| (to.nearest(c) - c).norm_squared()).fold(f32::INFINITY, lesser)
    };
    let mut least = lesser(corner(a, b), corner(b, a));
    if least.sqrt() <= apart + ROUNDING {
        return least.sqrt();
    }
    let way = b.centre - a.centre;
    for (i, j) in (0..9).map(|pair| (pair / 3, pair % 3)) {
        let across = a.axes.column(i).cross(&b.axes.column(j));
        let across = if across.dot(&way) < 0.0 { -across } else { across };
        if across.norm_squared() > PARALLEL {
            each_outermost(a, i, &across, |e| {
                each_outermost(b, j, &-across, |f| least = lesser(least, between_squared(e, f)));
            });
        }
    }
    least.sqrt()
}

/// Rounding error by which a corner may be farther away than that, metres.
const ROUNDING: f32 = 1e-6;
/// Square of the sine up to which axes count as parallel: corners are then as near as edges.
const PARALLEL: f32 = 1e-10;
/// Sine of the angle up to which edges count as equally far out.
const LEVEL: f32 = 1e-3;

/// Calls `visit` with the edges parallel to an axis that lie farthest in a direction: with one, or with all
/// that are about equally far.
fn each_outermost(s: &Solid, along: usize, towards: &Vector3<f32>, mut visit: impl FnMut(&Segment)) {
    let axis = |i: usize| s.axes.column(i % 3) * s.half[i % 3];
    let (long, slack) = (axis(along), LEVEL * towards.norm());
    let ends = |i: usize| {
        let far = s.axes.column(i % 3).dot(towards);
        (far >= -slack, far <= slack)
    };
    let signs = |(up, down): (bool, bool)| [(up, 1.0), (down, -1.0)].into_iter().filter(|s| s.0).map(|s| s.1);
    for u in signs(ends(along + 1)) {
        for v in signs(ends(along + 2)) {
            let middle = s.centre + axis(along + 1) * u + axis(along + 2) * v;
            visit(&(middle - long, middle + long));
        }
    }
}

type Segment = (Vector3<f32>, Vector3<f32>);

/// Squared distance between two segments (Ericson, Real-Time Collision Detection, 5.1.9).
fn between_squared(e: &Segment, f: &Segment) -> f32 {
    let (d1, d2, r) = (e.1 - e.0, f.1 - f.0, e.0 - f.0);
    let (a, c, b) = (d1.norm_squared(), d2.norm_squared(), d1.dot(&d2));
    let (dr, fr) = (d1.dot(&r), d2.dot(&r));
    let ratio = |up: f32, down: f32| if down > 1e-12 { (up / down).clamp(0.0, 1.0) } else { 0.0 };
    let s = ratio(b * fr - c * dr, a * c - b * b);
    let t = ratio(b * s + fr, c);
    let s = ratio(b * t - dr, a);
    ((e.0 + d1 * s) - (f.0 + d2 * t)).norm_squared()
}

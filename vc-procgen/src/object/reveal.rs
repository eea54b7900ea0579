//! Reveals: as a joiner sets a panel a hair behind its frame, a part that would share
//! a plane with an earlier one is made a hair smaller on that side, so that it is
//! never chance which of the two is seen.

use nalgebra::{Matrix3, Point3, Vector3};
use vc_graph::asset::{Part, Shape};
use vc_graph::{Asset, Pose};

/// How far a part is set back, metres; a quarter of the asset's thickness where that
/// is less.
const HAIR: f32 = 4e-4;

/// Sides set back at most for one part.
const TURNS: usize = 8;

/// Sets back what would share a plane. O(n²) in the parts, almost all of it one test
/// of two boxes.
pub(super) fn reveal(asset: &mut Asset) {
    let Some((low, high)) = asset.extent() else { return };
    let hair = HAIR.min((high - low).min() * 0.25);
    let mut boxes: Vec<Around> = asset.parts.iter().map(Around::new).collect();
    for j in 1..asset.parts.len() {
        for _ in 0..TURNS {
            let flush = (0..j).find_map(|i| boxes[j].flush(&boxes[i], hair * 0.75));
            let Some((axis, high)) = flush else { break };
            if !set_back(&mut asset.parts[j], axis, high, hair) {
                break;
            }
            boxes[j] = Around::new(&asset.parts[j]);
        }
    }
}

/// What surrounds a part: corners in the asset's frame and in its own.
struct Around {
    low: Point3<f32>,
    high: Point3<f32>,
    centre: Point3<f32>,
    half: Vector3<f32>,
    axes: Matrix3<f32>,
    pose: Pose,
    /// Balls and pills have no flat side.
    flat: bool,
}

impl Around {
    fn new(part: &Part) -> Self {
        let (least, most) = part.shape.extent();
        let (centre, half) = (nalgebra::center(&least, &most), (most - least) / 2.0);
        let axes = part.pose.rotation.to_rotation_matrix().into_inner();
        let (middle, reach) = (part.pose * centre, axes.abs() * half);
        let flat = !matches!(part.shape, Shape::Sphere { .. } | Shape::Capsule { .. });
        Self { low: middle - reach, high: middle + reach, centre, half, axes, pose: part.pose, flat }
    }

    /// A side of this box, as axis and whether it is the higher one, that lies in a
    /// plane with the same side of another box and overlaps it.
    fn flush(&self, other: &Self, same: f32) -> Option<(usize, bool)> {
        let apart = |k: usize| self.low[k] > other.high[k] + same || other.low[k] > self.high[k] + same;
        if !self.flat || !other.flat || apart(0) || apart(1) || apart(2) {
            return None;
        }
        let turn = self.axes.tr_mul(&other.axes);
        let middle = self.pose.inverse_transform_point(&(other.pose * other.centre)) - self.centre;
        let reach = turn.abs() * other.half;
        (0..3).find_map(|k| {
            let upright = turn.row(k).iter().any(|v| v.abs() > 0.9999);
            let beside = |m: usize| m != k && middle[m].abs() > self.half[m] + reach[m] - same;
            if !upright || (0..3).any(beside) {
                return None;
            }
            let side = |sign: f32| (middle[k] * sign + reach[k] - self.half[k]).abs() <= same;
            if side(1.0) { Some((k, true)) } else { side(-1.0).then_some((k, false)) }
        })
    }
}

/// Moves one side of a part inwards by `by`, unless the part is too thin for that.
fn set_back(part: &mut Part, axis: usize, high: bool, by: f32) -> bool {
    let (least, most) = part.shape.extent();
    let length = most[axis] - least[axis];
    if length < 4.0 * by {
        return false;
    }
    let (fixed, scale) = (if high { least[axis] } else { most[axis] }, 1.0 - by / length);
    let shift = if high { -by / 2.0 } else { by / 2.0 };
    let scaled = |v: &mut f32| *v = fixed + (*v - fixed) * scale;
    let mut moved = Vector3::zeros();
    match &mut part.shape {
        Shape::Box { half } => {
            half[axis] -= by / 2.0;
            moved[axis] = shift;
        }
        Shape::RoundedBox { half, radius } => {
            half[axis] -= by / 2.0;
            *radius = radius.min(half[axis]);
            moved[axis] = shift;
        }
        Shape::Cylinder { radius, half_height } | Shape::Cone { radius, half_height } => {
            if axis == 2 {
                *half_height -= by / 2.0;
                moved.z = shift;
            } else {
                *radius -= by;
            }
        }
        Shape::Lathe { profile } if axis == 2 => profile.iter_mut().for_each(|p| scaled(&mut p.1)),
        Shape::Lathe { profile } => profile.iter_mut().for_each(|p| p.0 *= 1.0 - 2.0 * by / length),
        Shape::Extrusion { height, .. } if axis == 2 => {
            *height -= by;
            moved.z = if high { 0.0 } else { by };
        }
        Shape::Extrusion { outline, .. } => {
            outline.iter_mut().for_each(|p| scaled(if axis == 0 { &mut p.0 } else { &mut p.1 }));
        }
        Shape::Hull { points } | Shape::Mesh { vertices: points, .. } => {
            points.iter_mut().for_each(|p| scaled(&mut p[axis]));
        }
        _ => return false,
    }
    part.pose.translation.vector += part.pose.rotation * moved;
    true
}

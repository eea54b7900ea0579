//! Ways through portals as lines: from where somebody stands to a threshold, and on to a place behind it.

use nalgebra::{Point2, Point3, UnitQuaternion, Vector2, Vector3};
use vc_graph::Pose;
use vc_graph::clock::TICKS_PER_SECOND;
use vc_graph::portable::Portable;
use vc_graph::space::{Portal, RegionId};

use super::measures::{BESIDE, DEEP, INWARD, LEVEL, MOUTH, STAIRS, TURNING};

/// Whether the stairs of a portal lead up to it from a region.
fn leads_up(plan: &Portal, from: RegionId) -> bool {
    !plan.stairs.is_empty() && plan.sides[0].region == from
}

/// A point of a region some way behind the threshold of a portal and to its left, metres.
fn behind(plan: &Portal, region: RegionId, (back, left): (f32, f32)) -> Point2<f32> {
    let at = plan.side(region).map(|side| side.pose * Point3::new(-back, left, 0.0));
    at.map_or_else(Point2::origin, |point| point.xy())
}

/// The point of a region from which one goes through a portal, or to which one comes: the foot of its stairs, or a step
/// behind its threshold.
pub(super) fn beside(plan: &Portal, region: RegionId) -> Point2<f32> {
    let foot = plan.stairs.first().filter(|_| leads_up(plan, region));
    foot.map_or_else(|| behind(plan, region, (INWARD, 0.0)), |point| point.xy())
}

/// Where one goes in a cabin: to its back.
pub(super) fn back_of(plan: &Portal, cabin: RegionId) -> Point2<f32> {
    behind(plan, cabin, (DEEP, 0.0))
}

/// The points beside the opening of a lift, at which one waits.
pub(super) fn waiting(plan: &Portal, region: RegionId) -> [Point2<f32>; 2] {
    let aside = plan.width / 2.0 + BESIDE;
    [aside, -aside].map(|left| behind(plan, region, (INWARD, left)))
}

/// The line before a portal that those who go through need.
pub(super) fn mouth(plan: &Portal, region: RegionId) -> [Point2<f32>; 2] {
    let foot = plan.stairs.first().filter(|_| leads_up(plan, region)).map(|foot| foot.xy());
    let near = foot.unwrap_or_else(|| behind(plan, region, (0.0, 0.0)));
    [near, foot.unwrap_or_else(|| behind(plan, region, (MOUTH, 0.0)))]
}

/// The way from where somebody stands to the threshold of a portal: who stands beside the opening steps before it first.
pub(super) fn way_out(plan: &Portal, from: RegionId, feet: &Pose) -> Vec<Point3<f32>> {
    let side = plan.side(from).map(|side| side.pose);
    let here = Point3::from(feet.translation.vector);
    let is_beside = side.is_some_and(|side| side.inverse_transform_point(&here).y.abs() > plan.width / 2.0);
    let before = side.map(|side| side * Point3::new(-INWARD / 2.0, 0.0, 0.0));
    let before = before.filter(|_| is_beside && !leads_up(plan, from));
    let stairs = plan.stairs.iter().copied().filter(|_| leads_up(plan, from));
    let threshold = side.map(|side| Point3::from(side.translation.vector));
    std::iter::once(here).chain(before).chain(stairs).chain(threshold).collect()
}

/// The way from the threshold of a portal to a free place behind it.
pub(super) fn way_in(plan: &Portal, into: RegionId, spot: Point2<f32>) -> Vec<Point3<f32>> {
    let threshold = plan.side(into).map(|side| Point3::from(side.pose.translation.vector));
    let stairs: Vec<Point3<f32>> = plan.stairs.iter().rev().copied().filter(|_| leads_up(plan, into)).collect();
    let level = stairs.last().or(threshold.as_ref()).map_or(0.0, |point| point.z);
    threshold.into_iter().chain(stairs).chain([Point3::new(spot.x, spot.y, level)]).collect()
}

/// The last stretch of the way from a threshold to a spot: what has to be free of those who stand.
pub(super) fn last_stretch(plan: &Portal, into: RegionId, spot: Point2<f32>) -> [Point2<f32>; 2] {
    let way = way_in(plan, into, spot);
    [way[way.len().saturating_sub(2)].xy(), spot]
}

/// The distance of a point from a line, metres.
pub(super) fn off(point: &Point2<f32>, [from, to]: &[Point2<f32>; 2]) -> f32 {
    let (way, out) = (to - from, point - from);
    let share = if way.norm_squared() > 0.0 { (out.dot(&way) / way.norm_squared()).clamp(0.0, 1.0) } else { 0.0 };
    (out - way * share).norm()
}

/// The rotation of somebody who looks in a direction.
pub(super) fn facing(direction: Vector2<f32>) -> UnitQuaternion<f32> {
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), direction.y.angle_to(direction.x))
}

/// The pose of feet after some ticks on a way; none once it is at its end.
pub(super) fn along(way: &[Point3<f32>], ticks: u64) -> Option<Pose> {
    let mut left = ticks as f32 / TICKS_PER_SECOND as f32;
    for step in way.windows(2) {
        let between = step[1] - step[0];
        let takes = seconds(&between);
        if left < takes {
            let at = step[0] + between * (left / takes);
            return Some(Pose::from_parts(at.coords.into(), facing(between.xy())));
        }
        left -= takes;
    }
    None
}

/// How long one takes for a way, seconds.
pub(super) fn duration(way: &[Point3<f32>]) -> f32 {
    way.windows(2).map(|step| seconds(&(step[1] - step[0]))).sum()
}

/// How long one takes for a straight part of a way, seconds.
fn seconds(between: &Vector3<f32>) -> f32 {
    let is_slope = between.z.abs() > 0.1 * between.xy().norm();
    between.norm() / if is_slope { STAIRS } else { LEVEL }
}

/// Feet that turn on the spot, a tick later; none if they have turned.
pub(super) fn turned(feet: &Pose, to: &UnitQuaternion<f32>) -> Option<Pose> {
    let (left, step) = (feet.rotation.angle_to(to), TURNING / TICKS_PER_SECOND as f32);
    if left < 1e-3 {
        return None;
    }
    let between = feet.rotation.try_slerp(to, step / left, 1e-6).filter(|_| step < left);
    Some(Pose::from_parts(feet.translation, between.unwrap_or(*to)))
}

//! Doors of furniture that open only as far as the walls around them allow.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::{Joint, JointKind, Part};
use vc_graph::{Aabb, Asset, Pose};

/// The positions of a door that are checked, evenly spaced along its way.
const LOOKS: u8 = 24;
/// The share of its way that a door keeps, as the contents must stay within reach.
const LEAST: f32 = 0.5;
/// The depth by which a door may overlap a wall, metres.
const TOUCH: f32 = 0.005;
/// The points of each box that are checked along each axis.
const POINTS: u8 = 3;

/// The asset with the limits of its doors reduced so that they stop before walls; `None` if all of them open
/// without meeting one. Walls that a closed door already meets do not count.
pub(super) fn within_walls(asset: &Asset, pose: &Pose, scale: &Vector3<f32>, walls: &[Aabb]) -> Option<Asset> {
    let upright = |j: &Joint| j.kind == JointKind::Hinge && (pose.rotation * j.axis).z.abs() > 0.9;
    let mut joints: Vec<Joint> = Vec::new();
    for joint in asset.parts.iter().filter_map(|p| p.joint).filter(upright) {
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }
    let mut reduced = asset.clone();
    for joint in joints {
        let leaf = Leaf { asset, joint, pose, scale };
        let Some(share) = leaf.stops_at(walls) else { continue };
        let limits = leaf.limits(share.max(LEAST));
        let own = reduced.parts.iter_mut().chain(&mut reduced.collision).filter_map(|part| part.joint.as_mut());
        own.filter(|j| **j == joint).for_each(|j| j.limits = limits);
    }
    (reduced != *asset).then_some(reduced)
}

/// The parts that swing about one joint of an object.
struct Leaf<'a> {
    asset: &'a Asset,
    joint: Joint,
    pose: &'a Pose,
    scale: &'a Vector3<f32>,
}

impl Leaf<'_> {
    /// The share of its way after which it meets a wall; `None` if it meets none.
    fn stops_at(&self, walls: &[Aabb]) -> Option<f32> {
        let closed = self.points(0);
        let apart: Vec<&Aabb> = walls.iter().filter(|wall| !closed.iter().any(|p| is_in(wall, p))).collect();
        let meets = |look: &u8| self.points(*look).iter().any(|p| apart.iter().any(|wall| is_in(wall, p)));
        (1..=LOOKS).find(meets).map(|look| f32::from(look - 1) / f32::from(LOOKS))
    }

    /// The limits of its joint with its way reduced to a share.
    fn limits(&self, share: f32) -> (f32, f32) {
        let (low, high) = self.joint.limits;
        if high >= -low { (low, high * share) } else { (low * share, high) }
    }

    /// Points of the boxes around its parts at a position, in the world.
    fn points(&self, look: u8) -> Vec<Point3<f32>> {
        let (low, high) = self.joint.limits;
        let widest = if high >= -low { high } else { low };
        let motion = self.joint.motion(widest * f32::from(look) / f32::from(LOOKS));
        let own = self.asset.parts.iter().filter(|part| part.joint == Some(self.joint));
        let placed = |p: Point3<f32>| self.pose * Point3::from((motion * p).coords.component_mul(self.scale));
        own.flat_map(raster).map(placed).collect()
    }
}

/// Points of the box around a part.
fn raster(part: &Part) -> impl Iterator<Item = Point3<f32>> {
    let (low, high) = part.extent();
    let share = |i: u8| f32::from(i) / f32::from(POINTS - 1);
    (0..POINTS * POINTS * POINTS).map(move |i| {
        let shares = Vector3::new(i % POINTS, i / POINTS % POINTS, i / (POINTS * POINTS)).map(share);
        low + (high - low).component_mul(&shares)
    })
}

fn is_in(wall: &Aabb, point: &Point3<f32>) -> bool {
    (0..3).all(|i| point[i] > wall.min[i] + TOUCH && point[i] < wall.max[i] - TOUCH)
}

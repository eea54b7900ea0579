//! How an agent's figure is posed, by what its body does.

use nalgebra::{Point3, Vector3};
use vc_graph::{NodeId, Pose};
use vc_physics::{Hand, Posture, World};

use super::{Attitude, Skeleton};
use crate::Environment;

impl Environment {
    /// How an agent's figure is posed.
    pub(crate) fn skeleton(&self, agent: NodeId) -> Option<Skeleton> {
        let world = self.world();
        let pose = world.pose(agent)?;
        let attitude = match world.posture(agent)? {
            Posture::Standing => Attitude::Standing,
            Posture::Sitting(..) => Attitude::Sitting(pose.translation.z - self.floor().plan().level),
            Posture::Lying(..) => Attitude::Lying,
        };
        let mut doing = self.doing(agent);
        if let Some(reach) = &mut doing.reach {
            reach.point = pose.inverse_transform_point(&reach.point);
        }
        let hands = Hand::BOTH.map(|hand| grip(world, &pose, hand, world.held(agent, hand)?));
        Some(Skeleton::new(attitude, &doing, hands))
    }
}

/// Where the palm is on what a hand holds, in the body's frame: at its outer side.
fn grip(world: &World, feet: &Pose, hand: Hand, held: NodeId) -> Option<Point3<f32>> {
    let aabb = world.aabb(held)?;
    let side = if hand == Hand::Right { -1.0 } else { 1.0 };
    let centre = feet.inverse_transform_point(&aabb.centre());
    // Half its width across, as it is turned.
    let across = feet.rotation * Vector3::y();
    let half = (aabb.max - aabb.min) / 2.0;
    let reach = across.x.abs() * half.x + across.y.abs() * half.y;
    Some(centre + Vector3::new(-0.01, side * (reach.min(0.3) + 0.02), 0.0))
}

//! The surroundings of an environment: walls and floors of the regions beyond its doors.

use nalgebra::{Point3, Translation3, Vector3};
use vc_graph::{Node, NodeId, ObjectRole, Pose, SceneGraph};
use vc_physics::{PhysicsError, PhysicsWorld};

/// How far from a threshold what stands beyond it is in the way here, too, metres: a table whose middle is on the threshold
/// is no longer.
const NEAR: f32 = 2.0;

/// How much lower floors are than there, and how far they reach under the own one, metres. Where two floors meet flush the engine
/// brakes what rolls over the seam by a third and throws it up by 15 mm, as it foresees that it meets the edge of the second.
const LOWER: f32 = 1e-3;
const UNDER: f32 = 0.1;

/// Fixed bodies of other scenes that are in the way here, too.
#[derive(Debug, Clone, Default)]
pub(crate) struct Around {
    pub(crate) walls: Vec<Walls>,
    pub(crate) bars: Vec<Bar>,
}

/// The scene beyond a threshold.
#[derive(Debug, Clone)]
pub(crate) struct Walls {
    pub(crate) scene: SceneGraph,
    /// The threshold, in the frame of that scene.
    pub(crate) threshold: Point3<f32>,
    /// The pose of its frame here.
    pub(crate) pose: Pose,
    /// The direction here in which it is, of unit length.
    pub(crate) out: Vector3<f32>,
    /// The leaf of the threshold: it moves.
    pub(crate) but: Option<NodeId>,
}

/// A box that is in the way on a threshold while that lets nothing through.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bar {
    pub(crate) id: NodeId,
    pub(crate) pose: Pose,
    pub(crate) size: Vector3<f32>,
    pub(crate) shut: bool,
}

impl Around {
    pub(super) fn put_into(&self, world: &mut PhysicsWorld) -> Result<(), PhysicsError> {
        for Walls { scene, threshold, pose, out, but } in &self.walls {
            let is_near = |node: &Node| node.aabb().is_some_and(|own| own.distance(threshold) < NEAR);
            let is_floor = |node: &Node| node.role() == ObjectRole::Floor;
            let under = Translation3::from(out * -UNDER - Vector3::z() * LOWER) * pose;
            world.surround(scene, |node| is_near(node) && is_floor(node), &under);
            let stands = |node: &Node| is_near(node) && !is_floor(node) && Some(node.id()) != *but;
            world.surround(scene, stands, pose);
        }
        for Bar { id, pose, size, shut } in &self.bars {
            world.bar(*id, *pose, *size)?;
            world.set_barred(*id, *shut);
        }
        Ok(())
    }
}

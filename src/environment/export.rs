//! Export of the home in its present state to other programs.

use vc_gltf::{GltfError, Stage, posed_scene};
use vc_graph::asset::Joint;
use vc_graph::{NodeId, Pose, Relation, SceneGraph};
use vc_people::Bone;
use vc_physics::PhysicsWorld;

use super::Environment;

impl Environment {
    /// The home in its present state as binary glTF (`.glb`): every thing at its pose, doors and drawers at
    /// their present opening, people standing or sitting as they are. Metres, Y up, as glTF requires. Takes
    /// some hundredths of a second: `vc_gltf::posed_scene`.
    ///
    /// ```no_run
    /// let home = virtualcity::Environment::make("apartment/42", 1)?;
    /// std::fs::write("home.glb", home.gltf()?)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`GltfError`] if a node's shape is not in the library, or the home is too large for one file.
    pub fn gltf(&self) -> Result<Vec<u8>, GltfError> {
        posed_scene(&self.unworn(), &Stage::default(), |id, joint| self.moved(id, joint))
    }

    /// The scene without worn clothes, which have no shape of their own while worn.
    fn unworn(&self) -> SceneGraph {
        let mut graph = self.graph.clone();
        let worn: Vec<NodeId> = self.agents().iter().flat_map(|a| self.graph.relating(Relation::WornBy, *a)).collect();
        let mut edit = graph.edit();
        // The nodes exist, so the edit cannot fail.
        worn.into_iter().for_each(|id| drop(edit.set_pose(id, None)));
        edit.commit();
        graph
    }

    /// The motion of a part on a joint: a limb, a door, a drawer.
    fn moved(&self, id: NodeId, joint: &Joint) -> Option<Pose> {
        match self.skeleton(id) {
            Some(skeleton) => Some(skeleton.motion(Bone::from_joint(joint)?)),
            None => Some(joint.motion(position(&self.graph, &self.world, id, joint)?)),
        }
    }
}

/// The position of a node's joint, read from the bodies.
pub(crate) fn position(graph: &SceneGraph, world: &PhysicsWorld, id: NodeId, joint: &Joint) -> Option<f32> {
    let asset = graph.assets().get(graph.node(id)?.spec().asset?)?;
    let mut joints: Vec<&Joint> = Vec::new();
    for own in asset.parts.iter().filter_map(|p| p.joint.as_ref()) {
        if !joints.contains(&own) {
            joints.push(own);
        }
    }
    let index = joints.iter().position(|own| *own == joint)?;
    world.parts(id).all().get(index).map(|part| part.position)
}

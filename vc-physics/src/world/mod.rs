//! The world: the bodies of a scene's nodes, in a physics engine.

mod read;

use std::collections::BTreeMap;
use std::sync::Arc;

use rapier3d::dynamics::RigidBodyHandle;
use vc_graph::{Aabb, NodeId, ObjectRole, SceneGraph};

use crate::engine::Engine;
use crate::state::{Agent, Effector, Hand, Thing, Vehicle, Waters};
use crate::{AgentError, PhysicsError, Settings};

/// Things above the ground are no higher, metres: a storey.
pub(crate) const HEADROOM: f32 = 2.5;
/// How far the floor of a room may reach beyond the room's box, metres: into walls and doorways.
const EDGE: f32 = 0.6;

/// The bodies of a scene's nodes, and their time.
///
/// A world is built from a [`SceneGraph`](vc_graph::SceneGraph) and its assets; poses, contacts and joint
/// positions are available as plain data by node number. `Clone` copies the dynamic state and shares the
/// shapes; a clone evolves as the original does, bit for bit.
#[derive(Clone)]
pub struct PhysicsWorld {
    pub(crate) settings: Settings,
    pub(crate) engine: Engine,
    /// Sorted by node.
    pub(crate) things: Vec<Thing>,
    pub(crate) agents: BTreeMap<NodeId, Agent>,
    /// The hands that are guided.
    pub(crate) effectors: BTreeMap<(NodeId, Hand), Effector>,
    pub(crate) vehicles: BTreeMap<NodeId, Vehicle>,
    pub(crate) waters: Waters,
    /// Moving parts with an active motor, in the order in which they were started.
    pub(crate) driven: Vec<(NodeId, usize)>,
    /// Rooms and grounds, and their boxes in the scene.
    pub(crate) rooms: Arc<[(NodeId, Aabb)]>,
    /// Height of the lowest fixed thing's bottom, metres.
    pub(crate) bottom: f32,
    pub(crate) ticks: u64,
    pub(crate) stopped: Vec<NodeId>,
    pub(crate) skipped: Vec<NodeId>,
    /// Boxes around the world that are in the way at times.
    pub(crate) bars: Vec<(NodeId, RigidBodyHandle)>,
}

impl PhysicsWorld {
    pub(crate) fn index(&self, id: NodeId) -> Result<usize, PhysicsError> {
        self.things.binary_search_by_key(&id, |t| t.id).map_err(|_| PhysicsError::NoBody(id))
    }

    pub(crate) fn thing(&self, id: NodeId) -> Result<&Thing, PhysicsError> {
        self.index(id).map(|i| &self.things[i])
    }

    pub(crate) fn thing_mut(&mut self, id: NodeId) -> Result<&mut Thing, PhysicsError> {
        self.index(id).map(|i| &mut self.things[i])
    }

    pub(crate) fn agent_state(&self, id: NodeId) -> Result<&Agent, AgentError> {
        self.agents.get(&id).ok_or(AgentError::NoSuchAgent(id))
    }

    pub(crate) fn agent_mut(&mut self, id: NodeId) -> Result<&mut Agent, AgentError> {
        self.agents.get_mut(&id).ok_or(AgentError::NoSuchAgent(id))
    }
}

/// Rooms and their bounding boxes, and those of floors that are larger: the ground around a building.
pub(crate) fn rooms(graph: &SceneGraph) -> Arc<[(NodeId, Aabb)]> {
    let aabb = |id: NodeId| Some((id, graph.node(id)?.aabb()?));
    let rooms: Vec<(NodeId, Aabb)> = graph.rooms().iter().filter_map(|id| aabb(*id)).collect();
    let floors = graph.of_role(ObjectRole::Floor).filter_map(|floor| aabb(floor.id()));
    let is_larger = |(_, own): &(NodeId, Aabb)| {
        let holds = |room: &Aabb| (0..2).all(|k| room.min[k] - EDGE <= own.min[k] && own.max[k] <= room.max[k] + EDGE);
        !rooms.iter().any(|(_, room)| holds(room))
    };
    let grounds: Vec<(NodeId, Aabb)> = floors.filter(is_larger).collect();
    rooms.into_iter().chain(grounds).collect()
}

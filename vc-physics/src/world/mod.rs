//! The world: the bodies of a scene's nodes, in a physics engine.

mod build;
mod drive;
mod fold;
mod look;
mod rest;
mod sleep;

pub(crate) use build::{collider, rooms};

use std::collections::BTreeMap;
use std::sync::Arc;

use rapier3d::dynamics::{ImpulseJointHandle, RigidBodyHandle};
use serde::{Deserialize, Serialize};
use vc_graph::class::SlotKind;
use vc_graph::{Aabb, AssetId, Node, NodeId, Place, Pose};

use crate::agent::Agent;
use crate::engine::Engine;
use crate::settings::Settings;
use crate::shapes::Form;
use crate::vehicle::Vehicle;
use crate::water::Water;
use crate::{BodyRole, PhysicsError};

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
    pub(crate) vehicles: BTreeMap<NodeId, Vehicle>,
    pub(crate) waters: Vec<Water>,
    /// The fill levels of containers, 0 to 1.
    pub(crate) fills: BTreeMap<NodeId, f32>,
    /// Moving parts with an active motor, in the order in which they were started.
    pub(crate) driven: Vec<(NodeId, usize)>,
    /// Rooms and their bounding boxes.
    pub(crate) rooms: Arc<[(NodeId, Aabb)]>,
    /// Height of the lowest fixed thing's bottom, metres.
    pub(crate) bottom: f32,
    pub(crate) ticks: u64,
    pub(crate) stopped: Vec<NodeId>,
    pub(crate) skipped: Vec<NodeId>,
}

/// The body or bodies of a node.
#[derive(Clone)]
pub(crate) struct Thing {
    pub(crate) id: NodeId,
    pub(crate) form: Arc<Form>,
    pub(crate) places: Places,
    pub(crate) state: State,
}

/// The number of places for people on a node, by its slots.
#[derive(Clone, Copy)]
pub(crate) struct Places {
    pub(crate) seats: u32,
    pub(crate) beds: u32,
}

impl Places {
    pub(crate) fn of(node: &Node) -> Self {
        Self { seats: node.slots(SlotKind::Seat).max(1), beds: node.slots(SlotKind::Lie).max(1) }
    }
}

/// The part of a thing that a snapshot keeps; form and places are reconstructed from the graph.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct State {
    pub(crate) role: BodyRole,
    pub(crate) base: RigidBodyHandle,
    pub(crate) moving: Vec<Moving>,
    /// The factor on its parts' masses.
    pub(crate) mass_factor: f32,
    /// The asset and scale from which it was built, and its pose in the graph.
    pub(crate) asset: Option<AssetId>,
    pub(crate) scale: [u32; 3],
    #[serde(with = "crate::serial::pose")]
    pub(crate) written: Pose,
    /// How long it has been at about the same pose.
    pub(crate) watch: rest::Watch,
    /// The pose at which it last fell asleep.
    pub(crate) slept: Option<rest::Spot>,
    /// The node and link to which it is pinned, and with which it moves.
    pub(crate) rides: Option<(NodeId, usize)>,
    /// Its support by the graph.
    #[serde(with = "crate::serial::place")]
    pub(crate) rests: Option<Place>,
    /// Whether the graph counts it as a part of the building.
    pub(crate) structure: bool,
    /// Whether it is a door between rooms.
    pub(crate) door: bool,
    /// Whether people carry it.
    pub(crate) graspable: bool,
    /// Its rolling resistance as a fraction of its weight.
    pub(crate) rolling: f32,
    /// The depth of the ground below the floor's own shape, metres.
    pub(crate) ground: f32,
}

/// A part that moves relative to its base.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Moving {
    /// Its body; without one it is fixed to the base's body, at `position`.
    pub(crate) body: Option<RigidBodyHandle>,
    pub(crate) joint: Option<ImpulseJointHandle>,
    pub(crate) limits: (f32, f32),
    /// Its position when last set, or one step ago while a motor drives it.
    pub(crate) position: f32,
    /// The target of its motor.
    pub(crate) target: Option<f32>,
    /// Remaining steps before its motor gives up.
    pub(crate) patience: u32,
    pub(crate) locked: bool,
    pub(crate) latched: bool,
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
}

impl Thing {
    /// The bodies of the thing, its base first.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        std::iter::once(self.state.base).chain(self.state.moving.iter().filter_map(|m| m.body))
    }
}

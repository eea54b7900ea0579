//! The world: bodies of a scene's nodes, in a physics engine.

mod build;
mod doze;
mod drive;
mod fold;
mod look;
mod rest;

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
use crate::{PhysicsError, Role};

/// Bodies of a scene's nodes, and the time that passes for them.
///
/// Built from a [`SceneGraph`](vc_graph::SceneGraph) and its assets; poses, contacts
/// and joint positions come back as plain data under the nodes' own numbers.
/// `Clone` copies what moves and shares the shapes; a clone goes on as the original
/// does, bit for bit.
#[derive(Clone)]
pub struct World {
    pub(crate) settings: Settings,
    pub(crate) engine: Engine,
    /// Sorted by node.
    pub(crate) things: Vec<Thing>,
    pub(crate) agents: BTreeMap<NodeId, Agent>,
    pub(crate) vehicles: BTreeMap<NodeId, Vehicle>,
    pub(crate) waters: Vec<Water>,
    /// How full containers are, 0 to 1.
    pub(crate) fills: BTreeMap<NodeId, f32>,
    /// Moving parts that a motor drives, in the order in which they were told to.
    pub(crate) driven: Vec<(NodeId, usize)>,
    /// Rooms and their boxes.
    pub(crate) rooms: Arc<[(NodeId, Aabb)]>,
    /// Height of the lowest fixed thing's bottom, metres.
    pub(crate) bottom: f32,
    pub(crate) ticks: u64,
    pub(crate) stopped: Vec<NodeId>,
    pub(crate) skipped: Vec<NodeId>,
}

/// A node's body, or bodies.
#[derive(Clone)]
pub(crate) struct Thing {
    pub(crate) id: NodeId,
    pub(crate) form: Arc<Form>,
    pub(crate) places: Places,
    pub(crate) state: State,
}

/// How many people have place on a node, by its slots.
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

/// The part of a thing that a snapshot keeps; form and places are found again by the graph.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct State {
    pub(crate) role: Role,
    pub(crate) base: RigidBodyHandle,
    pub(crate) moving: Vec<Moving>,
    /// What its parts' masses were multiplied by.
    pub(crate) mass_factor: f32,
    /// The shape it was built from, and where the graph had it.
    pub(crate) asset: Option<AssetId>,
    pub(crate) scale: [u32; 3],
    #[serde(with = "crate::serial::pose")]
    pub(crate) written: Pose,
    /// Since when it has been about where it is.
    pub(crate) watch: rest::Watch,
    /// Where it last fell asleep.
    pub(crate) slept: Option<rest::Spot>,
    /// The node and its link on which it was pinned: it comes along with that.
    pub(crate) rides: Option<(NodeId, usize)>,
    /// What the graph says it rests on.
    #[serde(with = "crate::serial::place")]
    pub(crate) rests: Option<Place>,
    /// Whether the graph counts it to the building.
    pub(crate) structure: bool,
    /// Whether it is a door between rooms.
    pub(crate) door: bool,
    /// Whether people carry it.
    pub(crate) graspable: bool,
    /// The force against its rolling as a part of its weight.
    pub(crate) rolling: f32,
    /// How far the ground reaches below the floor's own shape, metres.
    pub(crate) ground: f32,
}

/// A part that moves against its base.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Moving {
    /// Its body; without one it is fixed to the base's, at `position`.
    pub(crate) body: Option<RigidBodyHandle>,
    pub(crate) joint: Option<ImpulseJointHandle>,
    pub(crate) limits: (f32, f32),
    /// Where it was last put, or a step ago while a motor drives it.
    pub(crate) position: f32,
    /// Where its motor takes it.
    pub(crate) target: Option<f32>,
    /// Steps its motor may still try.
    pub(crate) patience: u32,
    pub(crate) locked: bool,
    pub(crate) latched: bool,
}

impl World {
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

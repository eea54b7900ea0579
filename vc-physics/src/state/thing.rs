//! The state of a thing: its bodies, its moving parts, and its place in the scene.

use std::sync::Arc;

use rapier3d::dynamics::{ImpulseJointHandle, RigidBodyHandle};
use serde::{Deserialize, Serialize};
use vc_graph::class::SlotKind;
use vc_graph::{AssetId, Node, NodeId, Place, Pose};

use super::watch::{Spot, Watch};
use crate::BodyRole;
use crate::shapes::Form;

/// The body or bodies of a node.
#[derive(Clone)]
pub(crate) struct Thing {
    pub(crate) id: NodeId,
    pub(crate) form: Arc<Form>,
    pub(crate) places: Places,
    pub(crate) state: ThingState,
}

/// The number of places for people on a node, by its slots.
#[derive(Clone, Copy)]
pub(crate) struct Places {
    pub(crate) seats: u32,
    pub(crate) beds: u32,
}

impl Places {
    pub(crate) fn new(node: &Node) -> Self {
        Self { seats: node.capacity(SlotKind::Seat), beds: node.capacity(SlotKind::Lie) }
    }
}

/// The part of a thing that a snapshot keeps; form and places are reconstructed from the graph.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct ThingState {
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
    pub(crate) watch: Watch,
    /// The pose at which it last fell asleep.
    pub(crate) slept: Option<Spot>,
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

impl Thing {
    /// Its mass, its moving parts with it, kilograms.
    pub(crate) fn mass(&self) -> f32 {
        self.form.mass() * self.state.mass_factor
    }

    /// The bodies of the thing, its base first.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        std::iter::once(self.state.base).chain(self.state.moving.iter().filter_map(|m| m.body))
    }
}

//! Where furniture is, and how open: what is about to be put into it is put elsewhere once somebody else has moved it.

use serde::{Deserialize, Serialize};
use vc_graph::{NodeId, Pose};
use vc_physics::PhysicsWorld;

/// How far furniture moves that is only pushed by what is put into it: metres, and the share of a part's way.
const MOVED: f32 = 0.05;

/// Where a thing was in a tick, and how open its parts were.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Whereabouts {
    id: NodeId,
    pose: Option<Pose>,
    open: Vec<f32>,
}

impl Whereabouts {
    pub(super) fn of(world: &PhysicsWorld, id: NodeId) -> Self {
        Self { id, pose: world.pose(id), open: world.parts(id).all().iter().map(|part| part.open).collect() }
    }

    /// Whether the thing is elsewhere now, or more open or shut.
    pub(super) fn differ(&self, world: &PhysicsWorld) -> bool {
        let now = Self::of(world, self.id);
        let way = |(then, now): (&Pose, &Pose)| (now.translation.vector - then.translation.vector).norm();
        self.pose.iter().zip(&now.pose).any(|poses| way(poses) > MOVED)
            || self.open.iter().zip(&now.open).any(|(then, now)| (now - then).abs() > MOVED)
    }
}

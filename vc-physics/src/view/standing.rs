//! Room for an agent at a place.

use nalgebra::Point3;
use vc_graph::{NodeId, Pose};

use crate::agent::{PartsToMoveAside, ShutDoors, point_distance};
use crate::state::Agent;
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError};

/// An agent as if it stood with its feet at a pose, as [`PhysicsWorld::standing`] gives it.
#[derive(Clone, Copy)]
pub struct StandingView<'w> {
    world: &'w PhysicsWorld,
    body: &'w Agent,
    feet: Pose,
}

/// # Room for a body
impl PhysicsWorld {
    /// An agent as if it stood with its feet at a pose: the room for its body there, and the reach of its hands. The
    /// world stays as it is.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// assert!(world.standing(home.person, &Pose::translation(0.0, -1.0, 0.0))?.is_free());
    /// let in_table = world.standing(home.person, &Pose::translation(1.0, 0.0, 0.0))?;
    /// assert!(!in_table.is_free() && in_table.obstacles().contains(&home.table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn standing(&self, agent: NodeId, feet: &Pose) -> Result<StandingView<'_>, AgentError> {
        Ok(StandingView { world: self, body: self.agent_state(agent)?, feet: *feet })
    }
}

impl StandingView<'_> {
    /// Whether its body overlaps nothing a little above the floor.
    pub fn is_free(&self) -> bool {
        self.world.fits(self.body, &self.feet)
    }

    /// Whether its body overlaps nothing while the moving parts of a node are open by each of some fractions of their
    /// range (0 closed, 1 open).
    ///
    /// # Errors
    /// As [`PhysicsWorld::drive`].
    pub fn is_free_with_open(&self, id: NodeId, open: &[f32]) -> Result<bool, PhysicsError> {
        self.world.fits_with_open(self.body, &self.feet, id, open)
    }

    /// The things and agents that its body overlaps; none if it [is free](Self::is_free).
    pub fn obstacles(&self) -> Vec<NodeId> {
        self.world.obstacles_at(self.body, &self.feet)
    }

    /// Whether a thing at a pose would be clear of its body.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn is_clear_of(&self, id: NodeId, pose: &Pose) -> Result<bool, PhysicsError> {
        Ok(self.world.is_clear_of_body(self.body, &self.feet, self.world.thing(id)?, pose))
    }

    /// The open moving parts that would have to give way so that it is free, by node and part, with the opening that
    /// each would have then, at least a tenth of its range; and the doors between rooms that would have to open, if
    /// they may. Empty if it is free already; `None` if anything else is in the way, or a part has no such position.
    ///
    /// [`put_open`](PhysicsWorld::put_open) moves them. Costs some microseconds, and as much for each tested position.
    pub fn parts_to_move_aside(&self, shut: ShutDoors) -> Option<PartsToMoveAside> {
        self.world.parts_to_move_aside(self.body, &self.feet, shut)
    }

    /// The distance from its shoulder to a thing that it would put down at a pose: to the middle of the thing, less
    /// half the thing's size, metres.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    pub fn put_distance(&self, id: NodeId, pose: &Pose) -> Result<f32, PhysicsError> {
        Ok(self.world.put_distance(self.body, &self.feet, self.world.thing(id)?, pose))
    }

    /// The distance from its shoulder to a point, metres, bent down or leant towards it as for
    /// [`reach_distance`](crate::AgentView::reach_distance).
    pub fn point_distance(&self, point: Point3<f32>) -> f32 {
        point_distance(self.body, &self.feet, point)
    }
}

//! Agents whose feet are set from outside.

use vc_graph::NodeId;

use crate::AgentError;
use crate::state::Motion;
use crate::world::PhysicsWorld;

/// # Leading
impl PhysicsWorld {
    /// Leads an agent, or lets go of it. The feet of an agent that is led are where [`teleport`](Self::teleport) has
    /// set them: no [`step`](Self::step) moves them, nobody pushes them, they do not fall, and nobody checks the ground
    /// below them. Others walk around the agent, and loose things meet its body. An order to walk
    /// ([`go`](Self::go), [`follow`](Self::follow)) ends the leading; sitting, lying and getting up do not.
    ///
    /// An agent that is let go stands still, and falls to the floor if its feet are above it.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// world.lead(home.person, true)?;
    /// for tick in 0..60 {
    ///     world.teleport(home.person, Pose::translation(0.0, -1.0 - 0.01 * tick as f32, 0.0))?;
    ///     world.step();
    /// }
    /// assert!(world.pose(home.person).is_some_and(|feet| (feet.translation.y - -1.59).abs() < 1e-5));
    /// assert_eq!(world.walk(home.person)?, vc_physics::WalkState::Led);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lead(&mut self, agent: NodeId, on: bool) -> Result<(), AgentError> {
        let body = self.agent_mut(agent)?;
        match (on, &body.walk) {
            (true, _) => (body.walk, body.velocity, body.fall) = (Motion::Led, [0.0; 2], 0.0),
            (false, Motion::Led) => body.walk = Motion::Still,
            (false, _) => {}
        }
        Ok(())
    }
}

//! Reading one agent.

use nalgebra::Point3;
use vc_graph::{NodeId, Pose};

use crate::state::{Agent, BodyPlan, Hand, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, WalkState};

/// The body of an agent in its present state, as [`PhysicsWorld::agent`] gives it. Its pose, its posture and the
/// things in its hands are with the world: [`pose`](PhysicsWorld::pose), [`posture`](PhysicsWorld::posture),
/// [`held`](PhysicsWorld::held).
#[derive(Clone, Copy)]
pub struct AgentView<'w> {
    pub(super) world: &'w PhysicsWorld,
    pub(super) id: NodeId,
    body: &'w Agent,
}

/// # Reading one agent
impl PhysicsWorld {
    /// The body of an agent, to read it.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::WalkState;
    /// world.go(home.person, nalgebra::Vector2::new(0.0, -1.0))?;
    /// assert_eq!(world.agent(home.person)?.walk(), WalkState::Walking);
    /// assert!(world.agent(home.cup).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn agent(&self, id: NodeId) -> Result<AgentView<'_>, AgentError> {
        Ok(AgentView { world: self, id, body: self.agent_state(id)? })
    }
}

impl<'w> AgentView<'w> {
    /// The build of its body.
    pub fn plan(&self) -> &'w BodyPlan {
        &self.body.plan
    }

    /// The state of its walk.
    pub fn walk(&self) -> WalkState {
        WalkState::new(&self.body.walk)
    }

    /// The pose of the thing in a hand, relative to its feet or its seat.
    pub fn grip(&self, hand: Hand) -> Option<Pose> {
        self.body.hands[hand as usize].as_ref().map(|held| self.body.lap() * held.grip)
    }

    /// Whether it stands in a thing: the thing meets its middle, and not only its sides.
    pub fn is_stuck(&self) -> bool {
        self.world.is_stuck(self.body)
    }

    /// Whether it stands beside all floors, where there is no ground below.
    pub fn is_off_floor(&self) -> bool {
        self.world.is_off_floor(self.body)
    }

    /// The pose of its feet where it stands, turned to a point, metres; the rotation is one for
    /// [`turn`](PhysicsWorld::turn).
    ///
    /// # Errors
    /// [`AgentError::Posture`] if it does not stand, [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let turned = world.agent(home.person)?.turned_to(nalgebra::Point3::new(0.0, 1.5, 0.0))?;
    /// world.turn(home.person, turned.rotation)?;
    /// let front = world.pose(home.person).ok_or("no body")?.rotation * nalgebra::Vector3::x();
    /// assert!(front.y > 0.999);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn turned_to(&self, point: Point3<f32>) -> Result<Pose, AgentError> {
        self.world.turned_to(self.id, point)
    }
}

/// # Reach
impl AgentView<'_> {
    /// The distance from its shoulder to the nearest point of a thing, metres. A standing agent bends down for low
    /// things, leans towards far ones, and stands on its toes for high ones.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let far = world.agent(home.person)?.reach_distance(home.cabinet)?;
    /// world.teleport(home.person, vc_graph::Pose::translation(-0.8, 0.0, 0.0))?;
    /// assert!(world.agent(home.person)?.reach_distance(home.cabinet)? < far);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reach_distance(&self, id: NodeId) -> Result<f32, PhysicsError> {
        self.world.reach_distance(self.body, id)
    }

    /// The things within reach of its hands from its present pose, with their distances from the shoulder, nearest
    /// first; only things that people carry. A closed door in between is not considered; see
    /// [`Floor::sees`](crate::Floor::sees).
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// assert_eq!(world.agent(home.person)?.in_reach()[0].0, home.cup);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn in_reach(&self) -> Vec<(NodeId, f32)> {
        self.world.in_reach(self.body)
    }
}

/// # Seats
impl AgentView<'_> {
    /// The pose at which its feet stood before it sat or lay down; `None` while it stands.
    pub fn stood_before(&self) -> Option<Pose> {
        (self.body.posture != Posture::Standing).then_some(self.body.stood)
    }

    /// The nearest free place beside its seat that a condition admits, to which it can get up: that from there a way
    /// leads on, as [`Floor::route`](crate::Floor::route) says.
    ///
    /// # Errors
    /// [`AgentError::Posture`] if it stands, [`AgentError::NoExit`].
    pub fn exit_where(&self, admits: impl Fn(&Pose) -> bool) -> Result<Pose, AgentError> {
        self.world.exit_where(self.id, admits)
    }
}

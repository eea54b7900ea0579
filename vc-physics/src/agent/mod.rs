//! Bodies of agents: a capsule that walks, two hands, a seat.

mod aside;
mod avoid;
mod exit;
mod hands;
mod put_down;
mod reach;
mod room;
mod seat;
mod side;
mod stride;
mod travel;
mod walk;

use rapier3d::dynamics::RigidBodyBuilder;
use rapier3d::geometry::ColliderBuilder;
use vc_graph::{NodeId, Pose, Relation, SceneGraph};

use crate::state::{Agent, BodyPlan, Hand, Motion, Posture, upright};
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, convert, group};

pub use aside::{PartsToMoveAside, ShutDoors};
pub(crate) use reach::point_distance;
pub use travel::Traveller;
pub use walk::WalkState;

/// # Agents
impl PhysicsWorld {
    /// Agents of the graph that have poses, and what they hold.
    pub(crate) fn add_agents(&mut self, graph: &SceneGraph) {
        for &id in graph.agents() {
            let Some(pose) = graph.node(id).and_then(|n| n.pose()) else {
                self.skipped.push(id);
                continue;
            };
            if self.add_agent(id, BodyPlan::default(), *pose).is_err() {
                self.skipped.push(id);
                continue;
            }
            for (hand, relation) in [(Hand::Right, Relation::HoldsRight), (Hand::Left, Relation::HoldsLeft)] {
                for held in graph.related(id, relation).collect::<Vec<_>>() {
                    // A thing that cannot be held (it has no body, or the hand is full) stays.
                    let load = self.load_on(held);
                    let _ = self.take(id, hand, held, &load, None);
                }
            }
        }
        self.skipped.sort_unstable();
    }

    /// Adds an agent's body, its feet at a pose. [`PhysicsWorld::build`] does so for the
    /// agents of the graph, with [`BodyPlan::default`].
    ///
    /// # Errors
    /// [`PhysicsError::Duplicate`], [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::{NodeId, Pose};
    /// use vc_physics::BodyPlan;
    /// let child = BodyPlan { height: 1.2, radius: 0.15, ..BodyPlan::default() };
    /// world.add_agent(NodeId(1000), child, Pose::translation(0.0, -1.0, 0.0))?;
    /// assert_eq!(world.agents().count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_agent(&mut self, id: NodeId, plan: BodyPlan, feet: Pose) -> Result<(), PhysicsError> {
        if self.agents.contains_key(&id) || self.index(id).is_ok() {
            return Err(PhysicsError::Duplicate(id));
        }
        if !convert::is_sound(&feet) || !plan.is_sound() {
            return Err(PhysicsError::NotFinite("the pose or the plan", id));
        }
        let (written, feet) = (feet, upright(&feet));
        let builder = RigidBodyBuilder::kinematic_position_based().pose(convert::pose(&feet));
        let body = self.engine.bodies.insert(builder.user_data(group::mark(id, 0)));
        let (shape, at, groups) = plan.body(Posture::Standing);
        let capsule = ColliderBuilder::new(shape).position(at).friction(0.3);
        let capsule = capsule.collision_groups(groups).user_data(group::mark(id, 0));
        self.engine.add_collider(capsule.build(), body);
        self.engine.refresh(body);
        let agent = Agent {
            plan,
            body,
            feet,
            written,
            posture: Posture::Standing,
            stood: feet,
            hands: [None, None],
            walk: Motion::Still,
            velocity: [0.0; 2],
            fall: 0.0,
            grounded: false,
            floor: feet.translation.z,
        };
        self.agents.insert(id, agent);
        self.step_up(id);
        self.embody(id, true);
        Ok(())
    }

    /// The agents that have bodies.
    pub fn agents(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.agents.keys().copied()
    }

    /// The posture of an agent's body.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert_eq!(world.posture(home.person), Some(vc_physics::Posture::Standing));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn posture(&self, id: NodeId) -> Option<Posture> {
        self.agents.get(&id).map(|a| a.posture)
    }

    /// Moves an agent at once; it then stands with its feet at a pose, of which only the rotation around the vertical
    /// counts. If something as low as a rug lies there, the agent stands on it. The things in its hands come along. An
    /// agent with nothing below its feet falls, and is among the [stopped](Self::stopped) in the end.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.0, -1.0, 0.0))?;
    /// assert!(world.pose(home.person).is_some_and(|feet| feet.translation.y == -1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn teleport(&mut self, id: NodeId, feet: Pose) -> Result<(), AgentError> {
        self.agent_state(id)?;
        if !convert::is_sound(&feet) {
            return Err(PhysicsError::NotFinite("the pose", id).into());
        }
        self.stopped.retain(|other| *other != id);
        let agent = self.agent_mut(id)?;
        agent.feet = upright(&feet);
        agent.posture = Posture::Standing;
        agent.walk = Motion::Still;
        (agent.velocity, agent.fall, agent.grounded) = ([0.0; 2], 0.0, false);
        self.step_up(id);
        self.embody(id, true);
        Ok(())
    }

    /// Moves an agent's body and the things in its hands to the agent's pose: at once, or in the course of the next
    /// step.
    pub(crate) fn embody(&mut self, id: NodeId, at_once: bool) {
        let Some(agent) = self.agents.get(&id) else { return };
        let (body, feet) = (agent.body, convert::pose(&agent.feet));
        let (shape, at, groups) = agent.plan.body(agent.posture);
        let stands = agent.feet;
        // A thing that is fastened to a guided hand moves by itself.
        let moved = |held: &(NodeId, Pose)| at_once || !self.is_fastened(held.0);
        let held: Vec<(NodeId, Pose)> = agent.holdings().into_iter().filter(moved).collect();
        if at_once {
            self.take_hands_along(id, &stands);
            let colliders = self.engine.bodies.get(body).map_or_else(Vec::new, |b| b.colliders().to_vec());
            for collider in colliders {
                if let Some(collider) =
                    self.engine.colliders.get_mut(collider).filter(|c| c.collision_groups() != groups)
                {
                    collider.set_collision_groups(groups);
                    collider.set_shape(shape.clone());
                    collider.set_position_wrt_parent(at);
                }
            }
        }
        let bases = held.into_iter().filter_map(|(id, pose)| Some((self.thing(id).ok()?.state.base, pose)));
        let all: Vec<_> = bases.map(|(base, pose)| (base, convert::pose(&pose))).chain([(body, feet)]).collect();
        for (body, pose) in all {
            if at_once { self.engine.place(body, pose) } else { self.engine.carry(body, pose) }
        }
    }
}

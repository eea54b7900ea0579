//! Walking: velocities, paths, and avoidance of other walkers.

use nalgebra::{Point2, Point3, Quaternion, UnitQuaternion, Vector2, Vector3};
use vc_graph::portable::Portable;
use vc_graph::{NodeId, Pose};

use super::avoid::{self, Walker};
use crate::convert::facing;
use crate::state::{Agent, Motion, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, convert};

/// Number of steps between ground checks of an agent that stands still.
const GLANCE: u64 = 8;

/// The fastest turn, radians per second.
const FASTEST_TURN: f32 = 5.0;

/// Height of a standing jump, metres (the mean of adults in vertical jump tests).
const JUMP: f32 = 0.4;

/// The state of a walk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum WalkState {
    /// The agent stands still, or has arrived.
    Still,
    /// The agent is on its way.
    Walking,
    /// The agent gave up: something is in the way.
    Stuck,
}

impl WalkState {
    pub(crate) fn new(motion: &Motion) -> Self {
        match motion {
            Motion::Still => Self::Still,
            Motion::Stuck => Self::Stuck,
            Motion::Going(_) | Motion::Along { .. } | Motion::Drifting { .. } => Self::Walking,
        }
    }
}

/// # Walking
impl PhysicsWorld {
    /// Lets an agent move at a velocity over the floor, metres per second, until told otherwise, no faster than
    /// its running speed. Zero stops it.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`AgentError::Posture`],
    /// [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.go(home.person, nalgebra::Vector2::new(0.0, -1.0))?;
    /// world.run(60);
    /// assert!(world.pose(home.person).is_some_and(|feet| feet.translation.y < -0.9));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn go(&mut self, id: NodeId, velocity: Vector2<f32>) -> Result<(), AgentError> {
        if !velocity.iter().all(|v| v.is_finite()) {
            return Err(PhysicsError::NotFinite("the velocity", id).into());
        }
        let agent = self.standing_mut(id)?;
        let v = velocity * (agent.plan.run / velocity.norm().max(agent.plan.run));
        agent.walk = if v == Vector2::zeros() { Motion::Still } else { Motion::Going([v.x, v.y]) };
        Ok(())
    }

    /// Lets an agent move at a velocity ahead and to the left, metres per second, no faster than its running speed, and
    /// turn at a rate, radians per second to the left and at most five, until told otherwise. Zero stops it.
    ///
    /// # Errors
    /// As [`Self::go`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.0, -1.0, 0.0))?;
    /// world.drift(home.person, nalgebra::Vector2::new(-0.5, 0.0), 0.0)?; // Backwards.
    /// world.run(60);
    /// assert!(world.pose(home.person).is_some_and(|feet| feet.translation.x < -0.4 && feet.rotation.w == 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn drift(&mut self, id: NodeId, velocity: Vector2<f32>, spin: f32) -> Result<(), AgentError> {
        if !spin.is_finite() {
            return Err(PhysicsError::NotFinite("the turn", id).into());
        }
        self.go(id, velocity)?;
        let spin = spin.clamp(-FASTEST_TURN, FASTEST_TURN);
        let walk = &mut self.standing_mut(id)?.walk;
        *walk = match (&walk, spin) {
            (Motion::Going(velocity), _) => Motion::Drifting { velocity: *velocity, spin },
            (_, 0.0) => Motion::Still,
            _ => Motion::Drifting { velocity: [0.0; 2], spin },
        };
        Ok(())
    }

    /// Lets an agent jump as high as a person does from standing, if it stands on something.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`AgentError::Posture`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.run(30);
    /// world.jump(home.person)?;
    /// world.run(17);
    /// assert!(world.pose(home.person).is_some_and(|feet| feet.translation.z > 0.3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn jump(&mut self, id: NodeId) -> Result<(), AgentError> {
        let speed = (2.0 * self.settings.gravity.max(0.0) * JUMP).sqrt();
        let agent = self.standing_mut(id)?;
        if agent.grounded {
            (agent.grounded, agent.fall) = (false, -speed);
        }
        Ok(())
    }

    /// Lets an agent walk or run along points, metres.
    ///
    /// # Errors
    /// As [`Self::go`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Point2;
    /// use vc_physics::WalkState;
    /// world.follow(home.person, &[Point2::new(0.0, -1.0), Point2::new(-0.5, -1.0)], false)?;
    /// while world.agent(home.person)?.walk() == WalkState::Walking {
    ///     world.step();
    /// }
    /// assert!(world.pose(home.person).is_some_and(|feet| (feet.translation.x - -0.5).abs() < 0.05));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow(&mut self, id: NodeId, path: &[Point2<f32>], run: bool) -> Result<(), AgentError> {
        if path.iter().any(|p| !p.x.is_finite() || !p.y.is_finite()) {
            return Err(PhysicsError::NotFinite("the path", id).into());
        }
        let agent = self.standing_mut(id)?;
        let speed = if run { agent.plan.run } else { agent.plan.walk };
        let points: Vec<[f32; 2]> = path.iter().map(|p| [p.x, p.y]).collect();
        agent.walk = if points.is_empty() { Motion::Still } else { Motion::Along { points, next: 0, speed, idle: 0 } };
        Ok(())
    }

    /// The pose of a standing agent's feet once it is turned to a point.
    pub(crate) fn turned_to(&self, id: NodeId, point: Point3<f32>) -> Result<Pose, AgentError> {
        if !convert::is_finite(&point.coords) {
            return Err(PhysicsError::NotFinite("the point", id).into());
        }
        let feet = self.standing_agent(id)?.feet;
        let way = point.coords - feet.translation.vector;
        Ok(Pose::from_parts(feet.translation, facing(way.x, way.y)))
    }

    /// Turns a standing agent at once to an orientation, of which only the rotation around the vertical counts.
    /// [`AgentView::turned_to`](crate::AgentView::turned_to) gives the one that faces a point.
    ///
    /// # Errors
    /// As [`Self::go`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let north = nalgebra::UnitQuaternion::from_axis_angle(&nalgebra::Vector3::z_axis(), 1.5708);
    /// world.turn(home.person, north)?;
    /// assert!(world.pose(home.person).is_some_and(|feet| (feet * nalgebra::Point3::new(1.0, 0.0, 0.0)).y > 0.999));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn turn(&mut self, id: NodeId, rotation: UnitQuaternion<f32>) -> Result<(), AgentError> {
        if !rotation.coords.iter().all(|c| c.is_finite()) {
            return Err(PhysicsError::NotFinite("the orientation", id).into());
        }
        self.standing_agent(id)?;
        let front = rotation * Vector3::x();
        // To the bit as it is, if it is about the vertical already.
        let upright = if rotation.i == 0.0 && rotation.j == 0.0 { rotation } else { facing(front.x, front.y) };
        self.agent_mut(id)?.feet.rotation = upright;
        self.embody(id, true);
        Ok(())
    }

    pub(crate) fn standing_agent(&self, id: NodeId) -> Result<&Agent, AgentError> {
        let agent = self.agent_state(id)?;
        match agent.posture {
            Posture::Standing => Ok(agent),
            other => Err(AgentError::Posture { agent: id, posture: other.as_str() }),
        }
    }

    pub(crate) fn standing_mut(&mut self, id: NodeId) -> Result<&mut Agent, AgentError> {
        self.standing_agent(id)?;
        self.agent_mut(id)
    }

    /// One step of all agents, which avoid each other.
    pub(crate) fn move_agents(&mut self) {
        if self.agents.is_empty() {
            return;
        }
        self.turn_drifting();
        let wishes = self.wishes();
        for (id, wish) in wishes {
            let Some(agent) = self.agents.get(&id) else { continue };
            let still = wish == Vector2::zeros() && agent.grounded;
            if agent.posture == Posture::Standing && (!still || self.ticks.is_multiple_of(GLANCE)) {
                self.stride(id, wish);
            } else if let Some(agent) = self.agents.get_mut(&id) {
                agent.velocity = [0.0; 2];
            }
            self.embody(id, false);
        }
    }

    /// Turns agents that drift.
    fn turn_drifting(&mut self) {
        let dt = self.settings.dt;
        for agent in self.agents.values_mut() {
            if let Some((_, turn)) = agent.walk.drift(dt).filter(|(_, turn)| *turn != 0.0) {
                let (sin, cos) = (turn / 2.0).sine_cosine();
                let turn = UnitQuaternion::new_normalize(Quaternion::new(cos, 0.0, 0.0, sin));
                agent.feet.rotation = UnitQuaternion::new_normalize((agent.feet.rotation * turn).into_inner());
            }
        }
    }

    /// The velocities of the agents: their wishes, corrected so that they do not run into each other.
    fn wishes(&self) -> Vec<(NodeId, Vector2<f32>)> {
        let dt = self.settings.dt;
        let standing: Vec<_> = self.agents.iter().filter(|(_, a)| a.posture == Posture::Standing).collect();
        let walker = |a: &Agent| Walker {
            at: a.feet.translation.vector.xy().into(),
            velocity: a.velocity.into(),
            wish: match a.walk.drift(dt) {
                Some((own, _)) => (a.feet.rotation * own.push(0.0)).xy(),
                None => a.walk.wish(a.feet.translation.vector.xy().into(), dt),
            },
            radius: a.plan.radius + 0.03,
            fastest: a.plan.run,
        };
        let walkers: Vec<Walker> = standing.iter().map(|(_, a)| walker(a)).collect();
        let all = standing.iter().zip(avoid::velocities(&walkers, dt));
        all.map(|((id, _), v)| (**id, v)).collect()
    }
}

//! Walking: the engine's character controller, paths, and avoidance of other walkers.

use nalgebra::{Point2, Point3, Vector2, Vector3};
use rapier3d::control::{CharacterAutostep, CharacterCollision, CharacterLength, KinematicCharacterController};
use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::math::Vector;
use rapier3d::parry::query::ShapeCastOptions;
use rapier3d::parry::shape::Capsule;
use rapier3d::pipeline::QueryFilter;
use vc_graph::NodeId;

use super::avoid::{self, Walker};
use crate::convert::facing;
use crate::state::{Agent, BodyPlan, Motion, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, convert, group};

/// The largest force with which a walker pushes things aside, newtons.
const PUSH: f32 = 150.0;
/// Number of steps between ground checks of an agent that stands still.
const GLANCE: u64 = 8;

/// The largest depth by which the feet of a placed agent are lifted onto a thing on the floor, metres.
/// Otherwise the agent would throw up a rug with everything on it.
const SUNK: f32 = 0.05;
/// Penetration depth that does not count as being in the ground, metres.
const TOUCH: f32 = 1e-3;

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
        let agent = self.standing(id)?;
        let v = velocity * (agent.plan.run / velocity.norm().max(agent.plan.run));
        agent.walk = if v == Vector2::zeros() { Motion::Still } else { Motion::Going([v.x, v.y]) };
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
        let agent = self.standing(id)?;
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
    /// while world.walk(home.person)? == WalkState::Walking {
    ///     world.step();
    /// }
    /// assert!(world.pose(home.person).is_some_and(|feet| (feet.translation.x - -0.5).abs() < 0.05));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow(&mut self, id: NodeId, path: &[Point2<f32>], run: bool) -> Result<(), AgentError> {
        if path.iter().any(|p| !p.x.is_finite() || !p.y.is_finite()) {
            return Err(PhysicsError::NotFinite("the path", id).into());
        }
        let agent = self.standing(id)?;
        let speed = if run { agent.plan.run } else { agent.plan.walk };
        let points: Vec<[f32; 2]> = path.iter().map(|p| [p.x, p.y]).collect();
        agent.walk = if points.is_empty() { Motion::Still } else { Motion::Along { points, next: 0, speed, idle: 0 } };
        Ok(())
    }

    /// Turns a standing agent at once to face a point.
    ///
    /// # Errors
    /// As [`Self::go`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.face(home.person, nalgebra::Point3::new(0.0, 1.5, 0.0))?;
    /// let front = world.pose(home.person).ok_or("no body")?.rotation * nalgebra::Vector3::x();
    /// assert!(front.y > 0.999);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn face(&mut self, id: NodeId, point: nalgebra::Point3<f32>) -> Result<(), AgentError> {
        if !convert::is_finite(&point.coords) {
            return Err(PhysicsError::NotFinite("the point", id).into());
        }
        let agent = self.standing(id)?;
        let way = point.coords - agent.feet.translation.vector;
        agent.feet.rotation = facing(way.x, way.y);
        self.embody(id, true);
        Ok(())
    }

    /// The state of an agent's walk.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    pub fn walk(&self, id: NodeId) -> Result<WalkState, AgentError> {
        Ok(match self.agent(id)?.walk {
            Motion::Still => WalkState::Still,
            Motion::Stuck => WalkState::Stuck,
            Motion::Going(_) | Motion::Along { .. } => WalkState::Walking,
        })
    }

    pub(crate) fn standing(&mut self, id: NodeId) -> Result<&mut Agent, AgentError> {
        let agent = self.agent_mut(id)?;
        match agent.posture {
            Posture::Standing => Ok(agent),
            other => Err(AgentError::Posture { agent: id, posture: other.as_str() }),
        }
    }

    /// One step of all agents, which avoid each other.
    pub(crate) fn move_agents(&mut self) {
        if self.agents.is_empty() {
            return;
        }
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

    /// The velocities of the agents: their wishes, corrected so that they do not run into each other.
    fn wishes(&self) -> Vec<(NodeId, Vector2<f32>)> {
        let dt = self.settings.dt;
        let standing: Vec<_> = self.agents.iter().filter(|(_, a)| a.posture == Posture::Standing).collect();
        let walker = |a: &Agent| Walker {
            at: a.feet.translation.vector.xy().into(),
            velocity: a.velocity.into(),
            wish: a.walk.wish(a.feet.translation.vector.xy().into(), dt),
            radius: a.plan.radius + 0.03,
            fastest: a.plan.run,
        };
        let walkers: Vec<Walker> = standing.iter().map(|(_, a)| walker(a)).collect();
        let all = standing.iter().zip(avoid::velocities(&walkers, dt));
        all.map(|((id, _), v)| (**id, v)).collect()
    }

    /// Moves one agent for one step, as far as it gets.
    fn stride(&mut self, id: NodeId, wish: Vector2<f32>) {
        let dt = self.settings.dt;
        let Some(agent) = self.agents.get(&id) else { return };
        let fall = if agent.grounded { 0.0 } else { agent.fall + self.settings.gravity * dt };
        let desired = Vector::new(wish.x * dt, wish.y * dt, -fall * dt);
        let (mut moved, mut grounded, hits) = self.slide(agent, desired);
        // A standing agent never steps, and a jumping agent never falls, to where there is no ground. An agent
        // that is placed there does fall, until the fall ends.
        let over_nothing = |way: Vector3<f32>| self.is_over_nothing(&(agent.feet * Point3::from(way)), agent.body);
        let ends = self.is_in_abyss(agent);
        let stays = || ends || agent.grounded || !over_nothing(Vector3::zeros());
        if !grounded && fall >= 0.0 && over_nothing(moved) && stays() {
            (moved, grounded) = (Vector3::zeros(), true);
        }
        if ends && !self.stopped.contains(&id) {
            self.stopped.push(id);
        }
        hits.iter().for_each(|hit| self.push_aside(id, hit, wish));
        // An agent that moves up has left the ground, however near it is.
        let grounded = grounded && fall >= 0.0;
        let Some(agent) = self.agents.get_mut(&id) else { return };
        agent.feet.translation.vector += moved;
        (agent.grounded, agent.fall) = (grounded, if grounded { 0.0 } else { fall });
        agent.velocity = [moved.x / dt, moved.y / dt];
        if grounded && !ends {
            agent.floor = agent.feet.translation.z;
        }
        if wish.norm() > 0.05 {
            agent.feet.rotation = facing(wish.x, wish.y);
        }
        let at = agent.feet.translation.vector.xy().into();
        agent.walk.advance(at, moved.xy().norm());
    }

    /// How far an agent gets, whether it then stands on something, and what it hit.
    fn slide(&self, agent: &Agent, desired: Vector) -> (Vector3<f32>, bool, Vec<CharacterCollision>) {
        // Agents in one place, such as scripted walkers, separate as they move and do not climb each other.
        let own = |c: &Collider| self.agents.get(&group::marked(c.user_data).0).is_some_and(|a| a.is_with(agent));
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && !own(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let plan = &agent.plan;
        let middle = agent.feet * vc_graph::Pose::translation(0.0, 0.0, plan.height / 2.0);
        let mut hits = Vec::new();
        let legs = legs(plan, desired.z > 0.0);
        let moved =
            legs.move_shape(self.settings.dt, &queries, &upright(plan), &convert::pose(&middle), desired, |hit| {
                hits.push(hit)
            });
        (convert::vector3(moved.translation), moved.grounded, hits)
    }

    /// Lifts an agent that was placed inside something low onto it, but not onto people.
    pub(super) fn step_up(&mut self, id: NodeId) {
        let Some(agent) = self.agents.get(&id) else { return };
        let is_person = |c: &Collider| self.agents.contains_key(&group::marked(c.user_data).0);
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && !is_person(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let above = agent.feet * vc_graph::Pose::translation(0.0, 0.0, agent.plan.height / 2.0 + SUNK);
        let options = ShapeCastOptions { max_time_of_impact: SUNK, ..ShapeCastOptions::default() };
        let ground = queries.cast_shape(&convert::pose(&above), -Vector::Z, &upright(&agent.plan), options);
        // Anything that overlaps the raised body at once is not ground.
        let depth = ground.map(|(_, hit)| hit.time_of_impact).filter(|gap| *gap > 0.0).map(|gap| SUNK - gap);
        let Some(agent) = self.agents.get_mut(&id) else { return };
        agent.feet.translation.z += depth.filter(|depth| *depth > TOUCH).unwrap_or(0.0);
        agent.floor = agent.feet.translation.z;
    }

    /// Pushes a loose thing that a walker has run into.
    fn push_aside(&mut self, id: NodeId, hit: &CharacterCollision, wish: Vector2<f32>) {
        let Some(limit) = self.agents.get(&id).map(|a| a.plan.pushes) else { return };
        let Some(body) = self.engine.colliders.get(hit.handle).and_then(|c| c.parent()) else { return };
        let dt = self.settings.dt;
        let Some(rigid) = self.engine.bodies.get_mut(body).filter(|b| b.is_dynamic() && b.mass() <= limit) else {
            return;
        };
        let Some(way) = wish.try_normalize(1e-3) else { return };
        let way = Vector::new(way.x, way.y, 0.0);
        let missing = wish.norm() - rigid.linvel().dot(way);
        let impulse = (rigid.mass() * missing).clamp(0.0, PUSH * dt);
        rigid.apply_impulse(way * impulse, true);
    }
}

/// The shape of a standing body.
fn upright(plan: &BodyPlan) -> Capsule {
    Capsule::new_z(plan.height / 2.0 - plan.radius, plan.radius)
}

/// The controller for an agent's legs, which keep to the ground unless they jump.
fn legs(plan: &BodyPlan, jumping: bool) -> KinematicCharacterController {
    KinematicCharacterController {
        up: Vector::Z,
        offset: CharacterLength::Absolute(0.01),
        slide: true,
        autostep: (!jumping).then_some(CharacterAutostep {
            max_height: CharacterLength::Absolute(plan.step),
            min_width: CharacterLength::Absolute(0.1),
            include_dynamic_bodies: false,
        }),
        max_slope_climb_angle: plan.slope,
        min_slope_slide_angle: plan.slope,
        snap_to_ground: (!jumping).then_some(CharacterLength::Absolute(plan.step)),
        ..KinematicCharacterController::default()
    }
}

//! Bodies of agents: a capsule that walks, two hands, a seat.

mod aside;
mod hands;
mod seat;
mod walk;

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::dynamics::{RigidBodyBuilder, RigidBodyHandle};
use rapier3d::geometry::{ColliderBuilder, InteractionGroups, SharedShape};
use rapier3d::math::{Pose as EnginePose, Vector};
use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{Anthropometry, NodeId, Pose, Relation, SceneGraph};

use crate::world::PhysicsWorld;
use crate::{AgentError, PhysicsError, convert, group};

pub use aside::PartsToMoveAside;
pub use hands::Hand;
pub use walk::Walk;

/// The person as which agents are built.
pub(crate) const ADULT: Anthropometry = Anthropometry::ADULT;

/// How an agent is built and what it can do.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BodyPlan {
    /// Height, metres.
    pub height: f32,
    /// Radius of the capsule, metres.
    pub radius: f32,
    /// From the shoulder to the middle of the hand, arm stretched, metres.
    pub reach: f32,
    /// Highest step it climbs, metres.
    pub step: f32,
    /// Steepest slope it climbs, radians.
    pub slope: f32,
    /// Heaviest thing it carries in one hand, kilograms.
    pub carries: f32,
    /// Heaviest thing it pushes aside when it walks, kilograms.
    pub pushes: f32,
    /// Walking speed, metres a second.
    pub walk: f32,
    /// Running speed, metres a second.
    pub run: f32,
}

impl Default for BodyPlan {
    /// A grown-up person.
    fn default() -> Self {
        Self {
            height: ADULT.stature,
            radius: ADULT.radius,
            reach: ADULT.reach,
            step: ADULT.climbs,
            slope: 0.7,
            carries: 15.0,
            pushes: 25.0,
            walk: 1.2,
            run: 3.0,
        }
    }
}

impl BodyPlan {
    /// How far from the middle of its feet a standing body reaches, along the floor, metres.
    pub fn stretch(&self) -> f32 {
        self.reach + ADULT.lean
    }

    /// Height of the shoulders above the feet, metres.
    pub fn shoulder(&self) -> f32 {
        ADULT.shoulder * self.height
    }

    /// Height of the eyes above the feet, metres.
    pub fn eye(&self) -> f32 {
        ADULT.eye * self.height
    }

    /// The capsule of a body in a posture, where it is from the feet or the seat, and what it
    /// collides with.
    fn body(&self, posture: Posture) -> (SharedShape, EnginePose, InteractionGroups) {
        let (half, middle) = (self.height / 2.0 - self.radius, self.height / 2.0);
        let above = |z: f32| EnginePose::from_translation(Vector::new(0.0, 0.0, z));
        match posture {
            Posture::Standing => (SharedShape::capsule_z(half, self.radius), above(middle), group::agent()),
            Posture::Sitting(..) => {
                let middle = ADULT.sitting * self.height / 2.0;
                let half = (middle - self.radius).max(0.01);
                (SharedShape::capsule_z(half, self.radius), above(middle), group::seated())
            }
            Posture::Lying(..) => (SharedShape::capsule_x(half, self.radius), above(self.radius), group::seated()),
        }
    }

    fn is_sound(&self) -> bool {
        let all = [self.height, self.radius, self.reach, self.step, self.slope, self.carries, self.pushes];
        let speeds = [self.walk, self.run];
        all.into_iter().chain(speeds).all(|v| v.is_finite() && v > 0.0) && self.height > 2.0 * self.radius
    }
}

/// What an agent's body does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Posture {
    /// It stands or walks.
    Standing,
    /// It sits on a place of a node.
    Sitting(NodeId, u32),
    /// It lies on a place of a node.
    Lying(NodeId, u32),
}

impl Posture {
    /// The word for it.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Standing => "standing",
            Self::Sitting(..) => "sitting",
            Self::Lying(..) => "lying",
        }
    }

    fn seat(self) -> Option<(NodeId, u32)> {
        match self {
            Self::Standing => None,
            Self::Sitting(id, place) | Self::Lying(id, place) => Some((id, place)),
        }
    }
}

/// An agent's body.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Agent {
    pub(crate) plan: BodyPlan,
    pub(crate) body: RigidBodyHandle,
    /// Where its feet are, and which way it looks; a seated one's seat.
    #[serde(with = "crate::serial::pose")]
    pub(crate) feet: Pose,
    /// Where it was when it was added.
    #[serde(with = "crate::serial::pose")]
    pub(crate) written: Pose,
    pub(crate) posture: Posture,
    /// Where one who sits or lies stood before.
    #[serde(with = "crate::serial::pose")]
    pub(crate) stood: Pose,
    pub(crate) hands: [Option<hands::Held>; 2],
    pub(crate) walk: walk::Motion,
    /// Velocity over the floor in the last step, metres a second.
    pub(crate) velocity: [f32; 2],
    /// Falling speed, metres a second, and whether it stands on something.
    pub(crate) fall: f32,
    pub(crate) grounded: bool,
    /// Height of the floor it last stood on, metres.
    pub(crate) floor: f32,
}

impl Agent {
    pub(crate) fn pose(&self) -> Pose {
        self.feet
    }

    /// Whether it stands where it was added, but for the way down to the floor.
    pub(crate) fn has_only_landed(&self) -> bool {
        let way = self.feet.translation.vector - self.written.translation.vector;
        let turn = self.feet.rotation.angle_to(&upright(&self.written).rotation);
        self.posture == Posture::Standing && way.xy().norm() < 1e-3 && way.z.abs() < self.plan.step && turn < 1e-2
    }

    pub(crate) fn shoulder(&self) -> Point3<f32> {
        let height = match self.posture {
            Posture::Standing => self.plan.shoulder(),
            // From the seat up.
            Posture::Sitting(..) => 0.55 * self.plan.shoulder(),
            Posture::Lying(..) => 0.15,
        };
        self.feet * Point3::new(0.0, 0.0, height)
    }

    pub(crate) fn feed(&self, id: NodeId, hash: &mut Digester) {
        hash.word(u64::from(id.0));
        hash.reals(self.feet.translation.vector.iter().copied());
        hash.reals(self.feet.rotation.coords.iter().copied());
        hash.reals([self.velocity[0], self.velocity[1], self.fall]);
        for held in &self.hands {
            hash.word(held.as_ref().map_or(0, |h| u64::from(h.id.0) + 1));
        }
        hash.word(self.posture.seat().map_or(0, |(id, place)| (u64::from(id.0) << 32) | (u64::from(place) + 1)));
    }
}

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
                    // What cannot be held (it has no body, or the hand is full) stays.
                    let load = self.load_on(held);
                    let _ = self.take(id, hand, held, &load);
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
            walk: walk::Motion::Still,
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

    /// How an agent is built.
    pub fn body_plan(&self, id: NodeId) -> Option<&BodyPlan> {
        self.agents.get(&id).map(|a| &a.plan)
    }

    /// What an agent's body does.
    pub fn posture(&self, id: NodeId) -> Option<Posture> {
        self.agents.get(&id).map(|a| a.posture)
    }

    pub(crate) fn agent(&self, id: NodeId) -> Result<&Agent, AgentError> {
        self.agents.get(&id).ok_or(AgentError::NoSuchAgent(id))
    }

    pub(crate) fn agent_mut(&mut self, id: NodeId) -> Result<&mut Agent, AgentError> {
        self.agents.get_mut(&id).ok_or(AgentError::NoSuchAgent(id))
    }

    /// Puts an agent somewhere at once, standing, its feet at a pose of which only
    /// the turn around the vertical counts; where something as low as a rug lies, it stands on
    /// that. The things in its hands come along. An agent with nothing below its feet falls, and is among the
    /// [stopped](Self::stopped) in the end.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NotFinite`].
    pub fn teleport(&mut self, id: NodeId, feet: Pose) -> Result<(), AgentError> {
        self.agent(id)?;
        if !convert::is_sound(&feet) {
            return Err(PhysicsError::NotFinite("the pose", id).into());
        }
        self.stopped.retain(|other| *other != id);
        let agent = self.agent_mut(id)?;
        agent.feet = upright(&feet);
        agent.posture = Posture::Standing;
        (agent.walk, agent.velocity, agent.fall, agent.grounded) = (walk::Motion::Still, [0.0; 2], 0.0, false);
        self.step_up(id);
        self.embody(id, true);
        Ok(())
    }

    /// Brings an agent's body, and what it holds, to where the agent is: at once, or
    /// in the course of the next step.
    fn embody(&mut self, id: NodeId, at_once: bool) {
        let Some(agent) = self.agents.get(&id) else { return };
        let (body, feet) = (agent.body, convert::pose(&agent.feet));
        let (shape, at, groups) = agent.plan.body(agent.posture);
        let held = agent.holdings();
        if at_once {
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

impl Agent {
    /// Whether two bodies are in one place: an agent is so with itself.
    fn is_with(&self, other: &Self) -> bool {
        let between = self.feet.translation.vector - other.feet.translation.vector;
        let high = if between.z > 0.0 { other.plan.height } else { self.plan.height };
        between.xy().norm() < self.plan.radius + other.plan.radius && between.z.abs() < high
    }
}

/// A pose without pitch and roll.
fn upright(pose: &Pose) -> Pose {
    let front = pose.rotation * Vector3::x();
    Pose::from_parts(pose.translation, facing(front.x, front.y))
}

/// The turn around the vertical whose X points in a direction.
pub(crate) fn facing(x: f32, y: f32) -> UnitQuaternion<f32> {
    let length = (x * x + y * y).sqrt();
    if length.is_nan() || length <= 1e-9 {
        return UnitQuaternion::identity();
    }
    // Half-angle formulas; no angle is needed.
    let cos = x / length;
    let (w, z) = (((1.0 + cos) / 2.0).max(0.0).sqrt(), ((1.0 - cos) / 2.0).max(0.0).sqrt());
    UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, 0.0, 0.0, if y < 0.0 { -z } else { z }))
}

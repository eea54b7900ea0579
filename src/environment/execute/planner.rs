//! The planner of an agent's next motions, which only reads the world.

use nalgebra::{Point2, Vector3};
use vc_graph::{Action, NodeId, Pose, SceneGraph};
use vc_physics::{BodyPlan, Floor, PhysicsWorld, Posture};

use super::step::Step;
use super::task::Task;
use crate::environment::motion::BodyMotion;
use crate::environment::{PhysicalRefusal, Start};

/// The planner of an agent's motions. It reads the world, which stays as it is.
pub(in crate::environment) struct Planner<'a> {
    pub(super) world: &'a PhysicsWorld,
    /// The floor follows the bodies whenever it is asked.
    pub(super) floor: &'a mut Floor,
    pub(super) start: &'a Start,
    /// The scene before the action, and the scene that the rule predicts after it.
    pub(super) before: &'a SceneGraph,
    pub(super) after: &'a SceneGraph,
    pub(super) agent: NodeId,
    pub(super) action: &'a Action,
    /// Whether doors and drawers are pushed all the way.
    pub(super) pushes: bool,
    /// The spots where others are going to stand.
    pub(super) claims: &'a [Point2<f32>],
    /// Whether open doors and drawers count as out of the way.
    pub(super) nudges: bool,
}

/// The next motions of a body, one after the other, and the tasks that are planned when they are done.
#[derive(Debug, Default)]
pub(in crate::environment) struct Plan {
    pub(in crate::environment) motions: Vec<BodyMotion>,
    pub(in crate::environment) tasks: Vec<Task>,
}

pub(super) type Planning = Result<Plan, PhysicalRefusal>;

impl Plan {
    pub(super) fn of(motions: impl IntoIterator<Item = BodyMotion>) -> Self {
        Self { motions: motions.into_iter().collect(), tasks: Vec::new() }
    }

    pub(super) fn then(mut self, task: Task) -> Self {
        self.tasks.push(task);
        self
    }
}

impl From<BodyMotion> for Plan {
    fn from(motion: BodyMotion) -> Self {
        Self::of([motion])
    }
}

impl From<Task> for Plan {
    fn from(task: Task) -> Self {
        Self::default().then(task)
    }
}

impl<'a> Planner<'a> {
    /// The planner of a step in a world.
    pub(in crate::environment) fn new(
        world: &'a PhysicsWorld,
        floor: &'a mut Floor,
        start: &'a Start,
        step: &'a Step,
    ) -> Self {
        let Step { before, after, agent, action, pushes, claims } = step;
        Self { world, floor, start, before, after, agent: *agent, action, pushes: *pushes, claims, nudges: false }
    }

    /// The same planner in another world: with some things elsewhere, say.
    pub(super) fn in_world<'b>(&'b mut self, world: &'b PhysicsWorld) -> Planner<'b> {
        let Planner { start, before, after, agent, action, pushes, claims, nudges, .. } = *self;
        Planner { world, floor: self.floor, start, before, after, agent, action, pushes, claims, nudges }
    }

    /// Whether the agent holds or wears a thing, or a thing on which it rests.
    pub(super) fn is_mine(&self, id: NodeId) -> bool {
        self.before.rests_at(id, self.agent)
    }

    pub(super) fn body(&self) -> BodyPlan {
        self.world.agent(self.agent).map(|agent| *agent.plan()).unwrap_or_default()
    }

    pub(super) fn feet(&self) -> Pose {
        self.world.pose(self.agent).unwrap_or_else(Pose::identity)
    }

    pub(super) fn stands(&self) -> bool {
        self.world.posture(self.agent) == Some(Posture::Standing)
    }

    /// The thing itself, or the nearest thing with a body in its support chain.
    pub(super) fn body_of(&self, id: NodeId) -> Result<NodeId, PhysicalRefusal> {
        let chain = std::iter::once(id).chain(self.before.support_chain(id));
        let body = chain.into_iter().find(|id| self.world.aabb(*id).is_some());
        body.ok_or_else(|| PhysicalRefusal::NoBody(self.before.label(id)))
    }

    /// Whether a thing is upright as it was at another pose, about.
    pub(super) fn is_upright(now: &Pose, was: &Pose) -> bool {
        let up = |pose: &Pose| pose.rotation * Vector3::z();
        up(now).dot(&up(was)) >= UPRIGHT
    }
}

/// The cosine of the largest tilt of a thing that stands as it stood.
const UPRIGHT: f32 = 0.9;

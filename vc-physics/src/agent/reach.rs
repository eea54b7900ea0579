//! Reach and sight of an agent.

use nalgebra::{Point3, Vector2, Vector3};
use vc_graph::{NodeId, Pose};

use crate::state::{ADULT, BodyPlan, Posture};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError};

/// Height of the shoulders of a body that bends down, as a share of its height.
const BENT: f32 = 0.3;

/// Shares of the largest lean that are tried.
const LEANS: [f32; 4] = [1.0, 0.7, 0.35, 0.0];

/// # Reach and sight
impl PhysicsWorld {
    /// The distance from an agent's shoulder to the nearest point of a thing, metres. A standing agent bends down for
    /// low things, leans towards far ones, and stands on its toes for high ones.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let far = world.reach_distance(home.person, home.cabinet)?;
    /// world.teleport(home.person, vc_graph::Pose::translation(-0.8, 0.0, 0.0))?;
    /// assert!(world.reach_distance(home.person, home.cabinet)? < far);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reach_distance(&self, agent: NodeId, id: NodeId) -> Result<f32, AgentError> {
        let body = self.agent(agent)?;
        let arm = match body.posture {
            Posture::Standing => self.arm(&body.plan, body.feet.translation.vector.into(), id)?,
            _ => body.shoulder(),
        };
        Ok(self.distance_to(id, arm)?)
    }

    /// The distance from an agent's shoulder to a thing that it would put down at a pose with its own feet at another
    /// pose: to the middle of the thing, less half the thing's size, metres.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    pub fn put_distance(&self, agent: NodeId, feet: &Pose, id: NodeId, pose: &Pose) -> Result<f32, AgentError> {
        let body = self.agent(agent)?;
        let (low, high) = self.thing(id)?.form.extent;
        let middle = pose * nalgebra::center(&low, &high);
        let arm = match body.posture {
            Posture::Standing => leaning(&body.plan, feet.translation.vector.into(), middle),
            _ => body.shoulder(),
        };
        Ok((middle - arm).norm() - (high - low).norm() / 2.0)
    }

    /// The shoulder of a body that reaches for a thing.
    pub(crate) fn arm(&self, plan: &BodyPlan, feet: Point3<f32>, id: NodeId) -> Result<Point3<f32>, PhysicsError> {
        let middle = self.aabb(id).ok_or(PhysicsError::NoBody(id))?.centre();
        Ok(leaning(plan, feet, middle))
    }

    /// The things within reach of an agent's hands from its present pose, with their distances from the shoulder,
    /// nearest first; only things that people carry. A closed door in between is not considered; see
    /// [`can_see`](Self::can_see).
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(0.3, 0.0, 0.0))?;
    /// assert_eq!(world.in_reach(home.person)?[0].0, home.cup);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn in_reach(&self, agent: NodeId) -> Result<Vec<(NodeId, f32)>, AgentError> {
        let body = self.agent(agent)?;
        let feet = Point3::from(body.feet.translation.vector);
        // Everything that it bends for is within this distance of its middle.
        let middle = feet + Vector3::z() * (0.5 * body.plan.height);
        let near = self.within(middle, body.plan.stretch() + 0.5 * body.plan.height);
        let carried =
            |id: &NodeId| self.thing(*id).is_ok_and(|t| t.state.graspable && t.state.role != BodyRole::Carried);
        let mut found = Vec::new();
        for (id, _) in near.into_iter().filter(|(id, _)| carried(id)) {
            let distance = self.reach_distance(agent, id)?;
            if distance <= body.plan.reach {
                found.push((id, distance));
            }
        }
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        Ok(found)
    }

    /// Whether a thing is visible from an agent's eyes: a ray to its middle, or to a corner of a slightly smaller box,
    /// hits nothing else first. The direction of the gaze is not considered.
    ///
    /// # Errors
    /// [`AgentError::NoSuchAgent`], [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(world.can_see(home.person, home.cup)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn can_see(&self, agent: NodeId, id: NodeId) -> Result<bool, AgentError> {
        let body = self.agent(agent)?;
        let rise = body.plan.eye() - body.plan.shoulder();
        let eye = body.shoulder() + Vector3::z() * rise;
        let mut ignored = vec![agent];
        ignored.extend(body.holdings().into_iter().map(|(id, _)| id));
        Ok(self.sees(eye, id, &ignored)?)
    }

    pub(super) fn check_reach(&self, agent: NodeId, id: NodeId) -> Result<(), AgentError> {
        let distance = self.reach_distance(agent, id)?;
        let reach = self.agent(agent)?.plan.reach;
        if distance > reach { Err(AgentError::OutOfReach { agent, id, distance, reach }) } else { Ok(()) }
    }
}

/// The shoulder of a standing body that reaches for a point: leant towards the point and bent down as far as that
/// brings it nearer.
pub(super) fn leaning(plan: &BodyPlan, feet: Point3<f32>, to: Point3<f32>) -> Point3<f32> {
    let shoulders = LEANS.map(|share| leant(plan, feet, to, share * ADULT.lean));
    let nearer = |a: Point3<f32>, b: Point3<f32>| if (b - to).norm() < (a - to).norm() { b } else { a };
    shoulders.into_iter().fold(shoulders[0], nearer)
}

/// The shoulder of a body that leans forward by a distance, metres: at the height of the target, but no lower than a
/// body bends and no higher than a leaning body comes.
fn leant(plan: &BodyPlan, feet: Point3<f32>, to: Point3<f32>, most: f32) -> Point3<f32> {
    let way = (to - feet).xy();
    let forward = way.norm().min(most);
    let torso = ADULT.torso * plan.height;
    let sunk = torso - (torso * torso - forward * forward).max(0.0).sqrt();
    let rise =
        (to.z - feet.z).clamp(BENT * plan.height, (plan.shoulder() + ADULT.tiptoe - sunk).max(BENT * plan.height));
    let ahead = way.try_normalize(1e-6).map_or_else(Vector2::zeros, |w| w * forward);
    feet + Vector3::new(ahead.x, ahead.y, rise)
}

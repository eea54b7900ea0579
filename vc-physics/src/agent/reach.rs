//! Reach of an agent.

use nalgebra::{Point3, Vector2, Vector3};
use vc_graph::{NodeId, Pose};

use crate::state::{ADULT, Agent, BodyPlan, Posture, Thing};
use crate::world::PhysicsWorld;
use crate::{AgentError, BodyRole, PhysicsError};

/// Height of the shoulders of a body that bends down, as a share of its height.
const BENT: f32 = 0.3;

/// Shares of the largest lean that are tried.
const LEANS: [f32; 4] = [1.0, 0.7, 0.35, 0.0];

/// # Reach
impl PhysicsWorld {
    /// The distance from an agent's shoulder to the nearest point of a thing, metres.
    pub(crate) fn reach_distance(&self, body: &Agent, id: NodeId) -> Result<f32, PhysicsError> {
        let arm = match body.posture {
            Posture::Standing => self.arm(&body.plan, body.feet.translation.vector.into(), id)?,
            _ => body.shoulder(),
        };
        self.distance_to(id, arm)
    }

    /// The distance from an agent's shoulder to a thing that it would put down at a pose, with its own feet at another pose:
    /// to the middle of the thing, less half the thing's size, metres.
    pub(crate) fn put_distance(&self, body: &Agent, feet: &Pose, thing: &Thing, pose: &Pose) -> f32 {
        let (low, high) = thing.form.extent;
        point_distance(body, feet, pose * nalgebra::center(&low, &high)) - (high - low).norm() / 2.0
    }

    /// The shoulder of a body that reaches for a thing.
    pub(crate) fn arm(&self, plan: &BodyPlan, feet: Point3<f32>, id: NodeId) -> Result<Point3<f32>, PhysicsError> {
        let middle = self.aabb(id).ok_or(PhysicsError::NoBody(id))?.centre();
        Ok(leaning(plan, feet, middle))
    }

    /// The things within reach of an agent's hands, with their distances from the shoulder, nearest first.
    pub(crate) fn in_reach(&self, body: &Agent) -> Vec<(NodeId, f32)> {
        let feet = Point3::from(body.feet.translation.vector);
        // Everything that it bends for is within this distance of its middle.
        let middle = feet + Vector3::z() * (0.5 * body.plan.height);
        let near = self.within(middle, body.plan.stretch() + 0.5 * body.plan.height);
        let carried =
            |id: &NodeId| self.thing(*id).is_ok_and(|t| t.state.graspable && t.state.role != BodyRole::Carried);
        let far = |(id, _)| Some((id, self.reach_distance(body, id).ok()?));
        let carried = near.into_iter().filter(|(id, _)| carried(id)).filter_map(far);
        let mut found: Vec<(NodeId, f32)> = carried.filter(|(_, far)| *far <= body.plan.reach).collect();
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        found
    }

    pub(super) fn check_reach(&self, agent: NodeId, id: NodeId) -> Result<(), AgentError> {
        let body = self.agent_state(agent)?;
        let (distance, reach) = (self.reach_distance(body, id)?, body.plan.reach);
        if distance > reach { Err(AgentError::OutOfReach { agent, id, distance, reach }) } else { Ok(()) }
    }
}

/// The distance from an agent's shoulder to a point, with its feet at a pose, metres.
pub(crate) fn point_distance(body: &Agent, feet: &Pose, point: Point3<f32>) -> f32 {
    let arm = match body.posture {
        Posture::Standing => leaning(&body.plan, feet.translation.vector.into(), point),
        _ => body.shoulder(),
    };
    (point - arm).norm()
}

/// The shoulder of a standing body that reaches for a point: leant towards the point and bent down as far as that
/// brings it nearer.
fn leaning(plan: &BodyPlan, feet: Point3<f32>, to: Point3<f32>) -> Point3<f32> {
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

//! Hands as end effectors: bodies with a palm, fingers and a thumb.

use rapier3d::dynamics::{ImpulseJointHandle, RigidBodyHandle};
use rapier3d::geometry::ColliderHandle;
use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{NodeId, Pose};

use crate::AgentError;
use crate::convert::is_sound;

/// The largest force of a grip, newtons: twice that of a strong hand.
const STRONGEST: f32 = 1000.0;

/// The goal of a guided hand, until it gets another.
///
/// ```
/// use vc_graph::Pose;
/// use vc_physics::HandGoal;
/// // Open, half a metre ahead of the chest, palm down.
/// let open = HandGoal { pose: Pose::translation(0.5, -0.2, 1.2), grip: 0.0, ..HandGoal::default() };
/// assert_eq!(open.force, 40.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HandGoal {
    /// The pose in the body's frame, whose origin is between the feet or on the seat, metres: the point between the
    /// fingers and the thumb, X along the fingers, Z from the thumb to the fingers, out of the back of the hand.
    #[serde(with = "crate::serial::pose")]
    pub pose: Pose,
    /// How far the fingers and the thumb close, 0 to 1, unless something is between them: 0 is open, with 0.1 m between
    /// them, 1 is closed, and between these the opening is `0.1 * (1 - grip)` metres. They open and close at 0.15 m/s each.
    /// A thing that is wider than that everywhere does not fit between them; what is held falls when the opening is 5 mm wider than
    /// it.
    pub grip: f32,
    /// The force of the grip, newtons, 0 to 1,000: what is held slips out of the hand where more than that pulls at it.
    pub force: f32,
}

impl Default for HandGoal {
    /// Open before the chest of a grown-up, with a grip of 40 N.
    fn default() -> Self {
        Self { pose: Pose::translation(0.4, 0.0, 1.2), grip: 0.0, force: 40.0 }
    }
}

impl HandGoal {
    /// Whether it is a goal for a hand of an agent.
    ///
    /// # Errors
    /// [`AgentError::BadGoal`].
    pub fn check(&self, agent: NodeId) -> Result<(), AgentError> {
        let bad = |why| Err(AgentError::BadGoal { agent, why });
        match self {
            goal if !is_sound(&goal.pose) => {
                bad("its pose must be finite, within 1,000 km, its rotation of unit length")
            }
            goal if !(0.0..=1.0).contains(&goal.grip) => bad("its grip must be 0 (open) to 1 (closed)"),
            goal if !(0.0..=STRONGEST).contains(&goal.force) => bad("the force of its grip must be 0 to 1,000 N"),
            _ => Ok(()),
        }
    }
}

/// A guided hand.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Effector {
    pub(crate) goal: HandGoal,
    pub(crate) body: RigidBodyHandle,
    /// The fixed body from which the arm pulls the hand to its set point, and the joint. (The agent's own body moves by
    /// rounding wherever it stands, and would never let a hand sleep.)
    pub(crate) anchor: RigidBodyHandle,
    pub(crate) arm: ImpulseJointHandle,
    /// Where the arm pulls it now, relative to the feet: a point on the way to the goal.
    #[serde(with = "crate::serial::pose")]
    pub(crate) set_point: Pose,
    /// Its pose after the last step, relative to the feet.
    #[serde(with = "crate::serial::pose")]
    pub(crate) at: Pose,
    /// The fingers and the thumb, and their distances from the point between them, metres.
    pub(crate) jaws: [ColliderHandle; 2],
    pub(crate) open: [f32; 2],
    /// Whether neither closes any further.
    pub(crate) closed: bool,
    pub(crate) grasp: Option<Grasp>,
}

/// A thing, or a moving part of one, that is fastened to a guided hand.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Grasp {
    pub(crate) id: NodeId,
    /// The link of a moving part, 0 for a whole thing.
    pub(crate) link: usize,
    pub(crate) joint: ImpulseJointHandle,
}

impl Effector {
    /// Distance of the fingers from the thumb, metres.
    pub(crate) fn opening(&self) -> f32 {
        self.open[0] + self.open[1]
    }

    pub(crate) fn feed(&self, hash: &mut Digester) {
        for pose in [self.goal.pose, self.set_point] {
            hash.reals(pose.translation.vector.iter().copied());
            hash.reals(pose.rotation.coords.iter().copied());
        }
        hash.reals([self.goal.grip, self.goal.force, self.open[0], self.open[1]]);
        hash.word(self.grasp.map_or(0, |grasp| (u64::from(grasp.id.0) + 1) << 32 | grasp.link as u64));
    }
}

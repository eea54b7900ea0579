//! Fingers and thumb: they close until they meet something.

use nalgebra::Vector3;
use rapier3d::geometry::{Collider, ColliderHandle, SharedShape};
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use crate::state::{Effector, Hand};
use crate::world::PhysicsWorld;
use crate::{BodyRole, convert, group};

/// The widest opening, metres.
pub(super) const SPAN: f32 = 0.1;
/// Distance of fingers and thumb from the point between them while a hand begins, metres.
pub(super) const NEAR: f32 = 0.01;
/// The speed at which fingers and thumb open and close, each, metres per second.
const RATE: f32 = 0.15;
/// Half the length, width and thickness of fingers and thumb, metres.
const HALF: [Vector3<f32>; 2] = [Vector3::new(0.04, 0.03, 0.006), Vector3::new(0.035, 0.012, 0.006)];
/// How far fingertips reach beyond the point between fingers and thumb, metres.
const TIP: f32 = 0.015;
/// Half the size of the palm, and its middle, metres.
const PALM: Vector3<f32> = Vector3::new(0.025, 0.035, 0.012);
const BEHIND: f32 = -0.09;
/// Finger pads yield by so much: what is no farther from them counts as touched, metres.
const PAD: f32 = 0.008;
/// Depth up to which fingers go on when they touch something with tips and edges only, metres.
const EDGE: f32 = 0.003;

/// A shape and its pose in the hand.
pub(super) type Piece = (SharedShape, Pose);

/// The palm, behind what is held.
pub(super) fn palm() -> Piece {
    (SharedShape::cuboid(PALM.x, PALM.y, PALM.z), Pose::translation(BEHIND, 0.0, 0.0))
}

/// The two sides of a grip.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Jaw {
    Fingers,
    Thumb,
}

impl Jaw {
    pub(super) const BOTH: [Self; 2] = [Self::Fingers, Self::Thumb];

    /// The side along Z, fingers positive.
    fn sign(self) -> f32 {
        if self == Self::Fingers { 1.0 } else { -1.0 }
    }

    /// The shape at a distance from the point between fingers and thumb.
    pub(super) fn piece(self, open: f32) -> Piece {
        self.slab(open, HALF[self as usize].z, 0.0)
    }

    /// The space from the middle between fingers and thumb to the outside of this jaw.
    pub(super) fn reach(self, open: f32) -> Piece {
        self.slab(0.0, open / 2.0 + HALF[self as usize].z, 0.0)
    }

    /// A slab from a distance outwards, of half a thickness, smaller all around.
    fn slab(self, from: f32, thickness: f32, smaller: f32) -> Piece {
        let half = HALF[self as usize];
        let shape = SharedShape::cuboid(half.x - smaller, half.y - smaller, thickness);
        (shape, Pose::translation(TIP - half.x, 0.0, self.sign() * (from + thickness)))
    }
}

impl PhysicsWorld {
    /// Opens or closes a hand a little further.
    pub(super) fn work_fingers(&mut self, agent: NodeId, hand: Hand) {
        let Some(effector) = self.effectors.get(&(agent, hand)).filter(|hand| hand.grasp.is_none()) else { return };
        let (wanted, step) = ((1.0 - effector.goal.grip) * SPAN / 2.0, RATE * self.settings.dt);
        let (mut open, before) = (effector.open, effector.open);
        for jaw in Jaw::BOTH {
            let (own, other) = (open[jaw as usize], open[1 - jaw as usize]);
            // Fingers and thumb meet wherever the thing between them is.
            let target = if effector.goal.grip >= 1.0 { -other } else { wanted };
            let next = own + (target - own).clamp(-step, step);
            let stops =
                next < own && self.in_way(effector, jaw.slab(next, HALF[jaw as usize].z, EDGE)).next().is_some();
            open[jaw as usize] = if stops { own } else { next };
        }
        let (body, jaws) = (effector.body, effector.jaws);
        if let Some(effector) = self.effectors.get_mut(&(agent, hand)) {
            (effector.open, effector.closed) = (open, effector.goal.grip > 0.0 && open == before);
        }
        for (jaw, handle) in Jaw::BOTH.into_iter().zip(jaws).filter(|_| open != before) {
            if let Some(collider) = self.engine.colliders.get_mut(handle) {
                collider.set_position_wrt_parent(convert::pose(&jaw.piece(open[jaw as usize]).1));
            }
        }
        if open != before {
            self.engine.refresh(body);
            if let Some(hand) = self.engine.body_mut(body) {
                hand.wake_up(true);
            }
        }
    }

    /// The node and link that fingers and thumb touch from both sides and close around no further: a loose thing before a
    /// moving part, and what is nearest.
    pub(crate) fn between(&self, agent: NodeId, hand: Hand) -> Option<(NodeId, usize)> {
        let effector = self.effectors.get(&(agent, hand)).filter(|hand| hand.closed && hand.grasp.is_none())?;
        let [fingers, thumb] = Jaw::BOTH.map(|jaw| {
            let pad = jaw.slab(effector.open[jaw as usize] - PAD, PAD / 2.0, EDGE);
            self.in_way(effector, pad).collect::<Vec<(NodeId, usize)>>()
        });
        let at = self.engine.pose(effector.body)?.translation.vector;
        let far = |id: NodeId| self.distance_to(id, at.into()).unwrap_or(f32::INFINITY);
        let fixed =
            |(id, link): (NodeId, usize)| self.role(id) == Some(BodyRole::Fixed) && self.part_body(id, link).is_none();
        let both = fingers.into_iter().filter(|touched| thumb.contains(touched) && !fixed(*touched));
        let key = |(id, link): (NodeId, usize)| (self.part_body(id, link).is_some(), far(id));
        both.min_by(|a, b| {
            let ((part, near), (other_part, other_near)) = (key(*a), key(*b));
            part.cmp(&other_part).then(near.total_cmp(&other_near)).then(a.cmp(b))
        })
    }

    /// The nodes and links that a piece of a hand meets; people are soft.
    pub(super) fn in_way(
        &self,
        effector: &Effector,
        (shape, pose): Piece,
    ) -> impl Iterator<Item = (NodeId, usize)> + use<> {
        let at = self.engine.pose(effector.body).unwrap_or_else(Pose::identity) * pose;
        let is_thing = |c: &Collider| !self.agents.contains_key(&group::marked(c.user_data).0);
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && is_thing(c);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let met = queries.intersect_shape(convert::pose(&at), &*shape.0);
        let mut all: Vec<(NodeId, usize)> = met.map(|(_, c)| group::marked(c.user_data)).collect();
        all.sort_unstable();
        all.dedup();
        all.into_iter()
    }
}

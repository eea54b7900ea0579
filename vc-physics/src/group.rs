//! Collision groups.
//!
//! Parts on joints collide with loose things and with agents, but neither with fixed things nor with other such
//! parts: a drawer does not rub against the cupboard beside it. Carried things collide with nothing. Guided hands and
//! what they hold collide as loose things do, but not with people, and nobody has to find a way around them.

use rapier3d::geometry::{Collider, Group, InteractionGroups, InteractionTestMode};
use vc_graph::NodeId;

use crate::BodyRole;

const FIXED: Group = Group::GROUP_1;
const LEAF: Group = Group::GROUP_2;
const LOOSE: Group = Group::GROUP_3;
const AGENT: Group = Group::GROUP_4;
const CARRIED: Group = Group::GROUP_5;
const HAND: Group = Group::GROUP_6;

fn groups(member: Group, of: Group) -> InteractionGroups {
    InteractionGroups::new(member, of, InteractionTestMode::And)
}

/// Groups of a thing's base.
pub(crate) fn base(role: BodyRole) -> InteractionGroups {
    match role {
        BodyRole::Fixed | BodyRole::Hung => groups(FIXED, LOOSE.union(AGENT)),
        BodyRole::Loose => groups(LOOSE, FIXED.union(LEAF).union(LOOSE).union(AGENT)),
        BodyRole::Carried | BodyRole::Stopped => nothing(),
    }
}

/// Groups of a part that moves on a joint.
pub(crate) fn leaf() -> InteractionGroups {
    groups(LEAF, LOOSE.union(AGENT))
}

/// Groups of an agent's capsule.
pub(crate) fn agent() -> InteractionGroups {
    groups(AGENT, LOOSE.union(LEAF).union(AGENT))
}

/// Groups of the body of an agent that sits or lies: others walk around it, but it does not push cushions away.
pub(crate) fn seated() -> InteractionGroups {
    groups(AGENT, AGENT)
}

/// Groups of a guided hand, and of what it holds.
pub(crate) fn hand() -> InteractionGroups {
    groups(LOOSE.union(HAND), FIXED.union(LEAF).union(LOOSE))
}

/// Groups of a guided hand that has just opened: what it held falls past its fingers.
pub(crate) fn opened_hand() -> InteractionGroups {
    groups(LOOSE.union(HAND), FIXED.union(LEAF))
}

/// Groups of colliders that collide with nothing.
pub(crate) fn nothing() -> InteractionGroups {
    groups(CARRIED, Group::NONE)
}

/// Whether a collider is in the way of anything that is planned: not what hands are and carry, nor what stands around the
/// world, which is in the way of what moves by itself.
pub(crate) fn is_solid(collider: &Collider) -> bool {
    !is_around(collider.user_data) && !collider.collision_groups().memberships.intersects(CARRIED.union(HAND))
}

/// The links in the marks of bodies that are no things of their world: they stand around it, some of them at times only.
pub(crate) const AROUND: usize = u32::MAX as usize;
pub(crate) const BAR: usize = AROUND - 1;

/// The mark of a node's part on its body and collider.
pub(crate) fn mark(id: NodeId, link: usize) -> u128 {
    u128::from(id.0) | (link as u128) << 32
}

/// Whether a mark is that of a body which is no thing of its world.
pub(crate) fn is_around(mark: u128) -> bool {
    marked(mark).1 >= BAR
}

/// The node and the part that a mark denotes.
pub(crate) fn marked(mark: u128) -> (NodeId, usize) {
    (NodeId(mark as u32), (mark >> 32) as u32 as usize)
}

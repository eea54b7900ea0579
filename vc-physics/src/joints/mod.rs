//! Doors, lids and drawers: parts that turn or slide against their base.
//!
//! On a base that is fixed, or heavier than ten kilograms, a part has a body and a joint of its own, with
//! limits, friction and a motor. On a light thing, such as a book, it moves with the base and is opened at
//! once.

mod clearance;
mod drive;
mod make;
mod motion;
mod openness;
mod sweep;
mod travel;

use vc_graph::asset::{Joint, JointKind};
use vc_graph::{NodeId, Pose};

use crate::convert;
use crate::state::Thing;
use crate::world::PhysicsWorld;

pub(crate) use make::{add, add_again};

/// The largest opening of a part that counts as closed, as a fraction.
pub(crate) const SHUT: f32 = 0.02;

/// A moving part, as data.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MovingPart {
    /// Its name: that of the asset's first part on this joint.
    pub name: std::sync::Arc<str>,
    /// Hinge or slide.
    pub kind: JointKind,
    /// The smallest and largest position, radians or metres.
    pub limits: (f32, f32),
    /// The present position, radians or metres.
    pub position: f32,
    /// The opening, 0 to 1.
    pub open: f32,
    /// Whether it is locked.
    pub locked: bool,
    /// Whether it has a body of its own, which a motor drives; otherwise it is opened at once.
    pub has_motor: bool,
}

impl PhysicsWorld {
    /// The moving parts of a node, in the asset's order; none without a body.
    pub(crate) fn moving_parts(&self, id: NodeId) -> Vec<MovingPart> {
        let Ok(thing) = self.thing(id) else { return Vec::new() };
        (0..thing.state.moving.len()).filter_map(|part| self.moving_part(thing, part)).collect()
    }

    fn moving_part(&self, thing: &Thing, part: usize) -> Option<MovingPart> {
        let (moving, link) = (thing.state.moving[part], &thing.form.links[part + 1]);
        let (joint, position) = (link.joint?, self.part_position(thing, part)?);
        let open = motion::fraction(joint.limits, position);
        let name = link.name.clone();
        Some(MovingPart {
            name,
            kind: joint.kind,
            limits: joint.limits,
            position,
            open,
            locked: moving.locked,
            has_motor: moving.body.is_some(),
        })
    }

    pub(crate) fn part_position(&self, thing: &Thing, part: usize) -> Option<f32> {
        let moving = thing.state.moving.get(part)?;
        let Some(body) = moving.body else { return Some(moving.position) };
        let joint = thing.form.links[part + 1].joint?;
        Some(motion::position(&joint, &self.engine.pose(thing.state.base)?, &self.engine.pose(body)?))
    }

    /// The position of a part after it is put to a fraction of its range.
    fn position_when_put(&self, thing: &Thing, part: usize, open: f32) -> Option<f32> {
        let target = self.target(thing.id, part, open).ok()?;
        if thing.state.moving.get(part)?.body.is_none() {
            return Some(target);
        }
        let (joint, base) = (thing.form.links[part + 1].joint?, self.engine.pose(thing.state.base)?);
        let (_, leaf) = self.poses_when_put(thing, part, target)?;
        // As the engine keeps it.
        let leaf = convert::isometry(&convert::pose(&leaf));
        Some(motion::position(&joint, &base, &leaf))
    }

    /// The motion of a part relative to its pose in the asset, in the asset's frame.
    pub(crate) fn part_motion(&self, thing: &Thing, joint: &Joint) -> Pose {
        let part = thing.form.links.iter().skip(1).position(|l| l.joint.as_ref() == Some(joint));
        let position = part.and_then(|p| self.part_position(thing, p));
        position.map_or_else(Pose::identity, |p| joint.motion(p))
    }

    /// The opening of a node's most open part, 0 to 1; `None` if it has no moving parts.
    pub(crate) fn openness(&self, id: NodeId) -> Option<f32> {
        self.moving_parts(id).iter().map(|p| p.open).reduce(f32::max)
    }

    /// Whether a motor drives a part of a node.
    pub(crate) fn is_driven(&self, id: NodeId) -> bool {
        self.driven.iter().any(|(d, _)| *d == id)
    }

    /// The state of a node's moving parts in the graph's terms; `None` if it has none.
    pub(crate) fn open_state(&self, id: NodeId) -> Option<vc_graph::State> {
        let open = self.openness(id)? > SHUT;
        Some(if open { vc_graph::State::Open } else { vc_graph::State::Closed })
    }
}

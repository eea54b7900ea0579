//! The way of a part on its joint, as the positions that are tested.

use vc_graph::Pose;
use vc_graph::asset::Joint;

/// Number of positions that are tested on the way, including the end.
pub(super) const POSITIONS: usize = 8;

/// The motion of a part from one position to another, on a base at a pose.
pub(super) struct Travel {
    pub(super) joint: Joint,
    pub(super) base: Pose,
    pub(super) way: (f32, f32),
}

impl Travel {
    /// The pose of the part at a tested position; zero is the start.
    pub(super) fn at(&self, step: usize) -> Pose {
        let (from, to) = self.way;
        self.base * self.joint.motion(from + (to - from) * share(step))
    }

    /// The motion of the part, and of what it carries, up to a tested position, in the world's frame.
    pub(super) fn since_start(&self, step: usize) -> Pose {
        self.at(step) * self.at(0).inverse()
    }

    /// The poses of the part at the tested positions.
    pub(super) fn poses(&self) -> impl Iterator<Item = Pose> + '_ {
        (1..=POSITIONS).map(|step| self.at(step))
    }
}

/// The share of the way at a tested position.
pub(super) fn share(step: usize) -> f32 {
    step as f32 / POSITIONS as f32
}

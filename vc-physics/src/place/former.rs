//! The spot at which a thing was in another moment of a world.

use vc_graph::{NodeId, Pose};

use crate::PhysicsError;
use crate::world::PhysicsWorld;

impl PhysicsWorld {
    /// The pose that a thing had in another moment of this world, moved along with its support or container since.
    pub(crate) fn former_spot(&self, then: &Self, id: NodeId, at: NodeId) -> Result<Option<Pose>, PhysicsError> {
        let link = then.link_below(id, at);
        let frame = |world: &Self| link.checked_sub(1).map_or_else(|| world.pose(at), |part| world.part_pose(at, part));
        let (Some(was), Some(before), Some(now)) = (then.pose(id), frame(then), frame(self)) else { return Ok(None) };
        let (spot, known) = (now * before.inverse() * was, then.overlaps(id, &was)?);
        let more = self.overlaps(id, &spot)?.iter().any(|other| !known.contains(other));
        Ok((!more).then_some(spot))
    }

    /// The link of a thing on which another one rests; zero is the base.
    pub(crate) fn link_below(&self, id: NodeId, at: NodeId) -> usize {
        let pinned = self.thing(id).ok().and_then(|thing| thing.state.rides);
        let part = pinned.or_else(|| self.rides(id)).filter(|(below, _)| *below == at);
        part.map_or(0, |(_, link)| link)
    }
}

//! Opening and closing at once, where nothing is in the way.

use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::math::Pose as EnginePose;
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use crate::world::World;
use crate::{PhysicsError, convert, group};

/// Positions looked at on the way, its end with them.
const LOOKS: usize = 8;
/// What overlaps less is only touched, metres.
const SKIN: f32 = 0.001;

impl World {
    /// Opens or closes every part of a node at once, what lies in a drawer with it, if
    /// nothing loose and nobody is in the way; gives whether it did. Where it does, the parts
    /// end where [`drive`](Self::drive) takes them.
    ///
    /// Costs some ten microseconds for each part.
    ///
    /// # Errors
    /// As [`Self::drive`].
    pub fn leap_open(&mut self, id: NodeId, open: f32) -> Result<bool, PhysicsError> {
        let parts = self.thing(id)?.state.moving.len();
        for part in 0..parts {
            let target = self.target(id, part, open)?;
            if !self.is_way_free(id, part, target) {
                return Ok(false);
            }
        }
        self.put_all_open(id, open)?;
        Ok(true)
    }

    /// Whether a part may go to a position without meeting anything that it collides with,
    /// and what it carries has room there.
    fn is_way_free(&self, id: NodeId, part: usize, target: f32) -> bool {
        let Ok(thing) = self.thing(id) else { return false };
        let (moving, link) = (&thing.state.moving[part], &thing.form.links[part + 1]);
        let (Some(body), Some(joint)) = (moving.body, link.joint) else { return true };
        let (Some(base), Some(from)) = (self.engine.pose(thing.state.base), self.part_position(thing, part)) else {
            return false;
        };
        let load = self.load_of(body);
        let at = |share: f32| base * joint.motion(from + (target - from) * share);
        let free = |look: usize| self.is_part_free(id, part, &at(look as f32 / LOOKS as f32), &load);
        let motion = at(1.0) * at(0.0).inverse();
        (1..=LOOKS).all(free) && load.iter().all(|l| self.has_room(*l, &motion, id, &load))
    }

    fn is_part_free(&self, id: NodeId, part: usize, at: &Pose, load: &[NodeId]) -> bool {
        let solid = self.thing(id).ok().and_then(|t| t.form.links[part + 1].solid.as_ref());
        let Some((shape, local)) = solid else { return true };
        let at = convert::pose(at) * *local;
        let other = |_: ColliderHandle, c: &Collider| {
            let node = group::marked(c.user_data).0;
            group::is_solid(c) && node != id && !load.contains(&node)
        };
        let filter = QueryFilter::default().exclude_sensors().groups(group::leaf()).predicate(&other);
        let queries = self.engine.queries(filter);
        let mut met = queries.intersect_shape(at, &**shape);
        met.all(|(_, collider)| {
            let between = at.inv_mul(collider.position());
            let depth =
                rapier3d::parry::query::contact(&EnginePose::IDENTITY, &**shape, &between, collider.shape(), 0.0);
            depth.is_ok_and(|c| c.is_none_or(|c| c.dist > -SKIN))
        })
    }

    /// Whether what a part carries has room where it comes to.
    fn has_room(&self, id: NodeId, motion: &Pose, part_of: NodeId, load: &[NodeId]) -> bool {
        let Some(pose) = self.pose(id) else { return false };
        let met = self.overlaps(id, &(motion * pose));
        met.is_ok_and(|met| met.iter().all(|m| *m == part_of || load.contains(m)))
    }
}

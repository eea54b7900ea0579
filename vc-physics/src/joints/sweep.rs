//! The way of a part with its load, and the obstacles on it.

use rapier3d::geometry::Collider;
use vc_graph::NodeId;

use super::travel::{POSITIONS, Travel, share};
use crate::displaced::Displaced;
use crate::place::{SKIN, distance};
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{convert, group};

impl PhysicsWorld {
    /// The share of its way up to which a part meets no obstacle, and its load has room.
    pub(super) fn free_share(&self, sweep: Option<Sweep<'_>>) -> f32 {
        let Some(sweep) = sweep else { return 1.0 };
        let free = (1..=POSITIONS).take_while(|&step| self.obstacles_of_part(&sweep, step).is_empty()).count();
        let has_room = |step: &usize| self.obstacles_of_load(&sweep, *step).is_empty();
        (1..=free).rev().find(has_room).map_or(0.0, share)
    }

    /// The motion of a part from one position to another, with some nodes ignored and some bodies displaced; `None` if
    /// it is there already, or has no joint.
    pub(super) fn sweep<'w>(
        &'w self,
        (id, part): (NodeId, usize),
        way: (f32, f32),
        ignored: &'w [NodeId],
        displaced: &'w Displaced,
    ) -> Option<Sweep<'w>> {
        let thing = self.thing(id).ok()?;
        let link = &thing.form.links[part + 1];
        let (joint, base) = (link.joint.filter(|_| way.0 != way.1)?, self.engine.pose(thing.state.base)?);
        let (travel, load) = (Travel { joint, base, way }, self.load_of_part_with(id, part, displaced));
        Some(Sweep { thing, part, travel, load, ignored, displaced })
    }

    /// The obstacles of a part and its load at a tested position.
    pub(super) fn obstacles(&self, sweep: &Sweep<'_>, step: usize) -> Vec<NodeId> {
        let mut all = self.obstacles_of_part(sweep, step);
        all.extend(self.obstacles_of_load(sweep, step));
        all
    }

    /// The obstacles of a part at a tested position.
    fn obstacles_of_part(&self, sweep: &Sweep<'_>, step: usize) -> Vec<NodeId> {
        let thing = sweep.thing;
        let Some((shape, local)) = thing.form.links[sweep.part + 1].solid.as_ref() else { return Vec::new() };
        // A lid that moves with its box has the collision groups of the box.
        let moving = thing.state.moving[sweep.part];
        let own = moving.body.map_or_else(|| group::base(thing.state.role), |_| group::leaf());
        let other = |c: &Collider| {
            let node = group::marked(c.user_data).0;
            group::is_solid(c) && sweep.meets(node) && c.collision_groups().test(own)
        };
        let (at, mut hits) = (convert::pose(&sweep.travel.at(step)) * *local, Vec::new());
        self.each_met((shape, &at), &other, sweep.displaced, &mut |collider, between| {
            let distance = distance(shape, &between, collider);
            if !distance.is_some_and(|distance| distance.is_none_or(|distance| distance > -SKIN)) {
                hits.push(group::marked(collider.user_data).0);
            }
            true
        });
        hits
    }

    /// The obstacles of a part's load at a tested position.
    fn obstacles_of_load(&self, sweep: &Sweep<'_>, step: usize) -> Vec<NodeId> {
        let motion = sweep.travel.since_start(step);
        let hits = |id: &NodeId| {
            let thing = self.thing(*id).ok();
            let now = thing.and_then(|thing| Some((thing, self.body_pose(thing.state.base, sweep.displaced)?)));
            let there = now.map(|(thing, now)| (thing, motion * convert::isometry(&now)));
            match there.filter(|(_, pose)| convert::is_sound(pose)) {
                Some((thing, pose)) => self.overlapped(thing, &pose, sweep.displaced),
                // A thing that cannot be there has no room: it counts as its own obstacle.
                None => return vec![*id],
            }
            .into_iter()
            .filter(|other| sweep.meets(*other))
            .collect()
        };
        sweep.load.iter().flat_map(hits).collect()
    }
}

/// The motion of a part.
pub(super) struct Sweep<'w> {
    thing: &'w Thing,
    part: usize,
    travel: Travel,
    /// The things that the part carries.
    load: Vec<NodeId>,
    /// Nodes that are ignored.
    ignored: &'w [NodeId],
    /// The bodies that are displaced meanwhile.
    displaced: &'w Displaced,
}

impl Sweep<'_> {
    /// Whether a node counts as an obstacle.
    fn meets(&self, id: NodeId) -> bool {
        id != self.thing.id && !self.load.contains(&id) && !self.ignored.contains(&id)
    }
}

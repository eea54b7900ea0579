//! Opening and closing at once, where nothing is in the way.

use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::math::Pose as EnginePose;
use rapier3d::pipeline::QueryFilter;
use vc_graph::NodeId;
use vc_graph::asset::JointKind;

use super::motion::fraction;
use super::travel::{POSITIONS, Travel, share};
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{PhysicsError, convert, group};

/// Smallest share of its range that a part opens if it cannot open completely.
const HALF: f32 = 0.5;
/// Smaller overlaps count as touching only, metres.
const SKIN: f32 = 0.001;

/// # Opening at once
impl PhysicsWorld {
    /// Opens or closes every part of a node at once, with the contents of drawers, where neither loose things
    /// nor agents are in the way; returns whether it did. The parts then end where [`drive`](Self::drive) takes
    /// them, except in two cases in which `drive` would press a part against things: a part that cannot open
    /// completely, because its contents would hit a wall, opens as far as possible if that is at least half of
    /// the range; a drawer that cannot open stays closed if others open.
    ///
    /// Doors and lids open before drawers, whose contents would be in their way, and close after them.
    ///
    /// Costs some ten microseconds for each part.
    ///
    /// # Errors
    /// As [`Self::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(world.set_openness(home.cabinet, 1.0)?);
    /// assert!(world.openness(home.cabinet).is_some_and(|open| open > 0.99));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_openness(&mut self, id: NodeId, open: f32) -> Result<bool, PhysicsError> {
        self.set_openness_ignoring(id, open, &[])
    }

    /// As [`Self::set_openness`], ignoring some nodes as obstacles: an agent that opens a door gives way to it.
    ///
    /// # Errors
    /// As [`Self::drive`].
    pub fn set_openness_ignoring(&mut self, id: NodeId, open: f32, past: &[NodeId]) -> Result<bool, PhysicsError> {
        let form = self.thing(id)?.form.clone();
        let slides = |part: &usize| form.links[part + 1].joint.is_some_and(|j| j.kind == JointKind::Slide);
        let parts = 0..self.thing(id)?.state.moving.len();
        parts.clone().try_for_each(|part| self.target(id, part, open).map(drop))?;
        let (drawers, doors): (Vec<usize>, Vec<usize>) = parts.partition(slides);
        if open == 0.0 {
            return Ok(self.open_each(id, drawers, open, past)? && self.open_each(id, doors, open, past)?);
        }
        if !self.open_each(id, doors, open, past)? {
            return Ok(false);
        }
        // A drawer that stays closed does not matter if another part is open.
        Ok(self.open_each(id, drawers, open, past)? || self.openness(id).is_some_and(|o| o >= HALF))
    }

    /// Opens or closes some parts as far as they go, the freest first; returns whether all of them moved.
    fn open_each(
        &mut self,
        id: NodeId,
        mut parts: Vec<usize>,
        open: f32,
        past: &[NodeId],
    ) -> Result<bool, PhysicsError> {
        let least = if open > 0.0 { HALF } else { 1.0 };
        while let Some((at, share)) = self.freest(id, &parts, open, past)?.filter(|(_, share)| *share >= least) {
            let part = parts.remove(at);
            let (from, target) = self.way(id, part, open)?;
            let limits = self.thing(id)?.state.moving[part].limits;
            let reached = if share < 1.0 { fraction(limits, from + (target - from) * share) } else { open };
            self.put_open(id, part, reached)?;
        }
        Ok(parts.is_empty())
    }

    /// The first of some parts that can move completely, otherwise the one that gets farthest: its index among
    /// them, and the share of its way.
    fn freest(
        &self,
        id: NodeId,
        parts: &[usize],
        open: f32,
        past: &[NodeId],
    ) -> Result<Option<(usize, f32)>, PhysicsError> {
        let mut best: Option<(usize, f32)> = None;
        for (at, &part) in parts.iter().enumerate() {
            let (from, target) = self.way(id, part, open)?;
            let share = self.free_share(self.sweep(id, part, from, target, past));
            if best.is_none_or(|(_, most)| share > most) {
                best = Some((at, share));
            }
            if share == 1.0 {
                break;
            }
        }
        Ok(best)
    }

    /// Whether a part meets no obstacle on its way to a fraction of its range.
    pub(crate) fn is_free_way(&self, id: NodeId, part: usize, open: f32) -> bool {
        self.way(id, part, open)
            .is_ok_and(|(from, target)| self.free_share(self.sweep(id, part, from, target, &[])) == 1.0)
    }

    /// The present position of a part, and its position at a fraction of its range.
    fn way(&self, id: NodeId, part: usize, open: f32) -> Result<(f32, f32), PhysicsError> {
        let target = self.target(id, part, open)?;
        Ok((self.part_position(self.thing(id)?, part).unwrap_or(target), target))
    }

    /// The nodes that block the parts of a node on the way to a fraction of their range, 0 to 1, sorted by
    /// number: the first obstacles of the parts and of the things they carry. Empty if the way is free.
    ///
    /// # Errors
    /// As [`Self::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.teleport(home.person, vc_graph::Pose::translation(-1.0, 0.0, 0.0))?;
    /// assert_eq!(world.blockers(home.cabinet, 1.0)?, [home.person]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn blockers(&self, id: NodeId, open: f32) -> Result<Vec<NodeId>, PhysicsError> {
        let mut hits = Vec::new();
        for part in 0..self.thing(id)?.state.moving.len() {
            let (from, target) = self.way(id, part, open)?;
            let Some(sweep) = self.sweep(id, part, from, target, &[]) else { continue };
            let first = (1..=POSITIONS).map(|step| self.obstacles(&sweep, step)).find(|hits| !hits.is_empty());
            hits.extend(first.unwrap_or_default());
        }
        hits.sort_unstable();
        hits.dedup();
        Ok(hits)
    }

    /// The share of its way up to which a part meets no obstacle, and its load has room.
    fn free_share(&self, sweep: Option<Sweep<'_>>) -> f32 {
        let Some(sweep) = sweep else { return 1.0 };
        let free = (1..=POSITIONS).take_while(|&step| self.obstacles_of_part(&sweep, step).next().is_none()).count();
        let has_room = |step: &usize| self.obstacles_of_load(&sweep, *step).next().is_none();
        (1..=free).rev().find(has_room).map_or(0.0, share)
    }

    /// The motion of a part from one position to another; `None` if it is there already, or has no joint.
    fn sweep(&self, id: NodeId, part: usize, from: f32, target: f32, past: &[NodeId]) -> Option<Sweep<'_>> {
        let thing = self.thing(id).ok()?;
        let link = &thing.form.links[part + 1];
        let (joint, base) = (link.joint.filter(|_| from != target)?, self.engine.pose(thing.state.base)?);
        let travel = Travel { joint, base, way: (from, target) };
        Some(Sweep { thing, part, travel, load: self.load_of_part(id, part), past: past.to_vec() })
    }

    /// The obstacles of a part and its load at a tested position.
    fn obstacles(&self, sweep: &Sweep<'_>, step: usize) -> Vec<NodeId> {
        self.obstacles_of_part(sweep, step).chain(self.obstacles_of_load(sweep, step)).collect()
    }

    /// The obstacles of a part at a tested position.
    fn obstacles_of_part(&self, sweep: &Sweep<'_>, step: usize) -> impl Iterator<Item = NodeId> {
        let thing = sweep.thing;
        let solid = thing.form.links[sweep.part + 1].solid.as_ref();
        // A lid that moves with its box has the collision groups of the box.
        let moving = thing.state.moving[sweep.part];
        let own = moving.body.map_or_else(|| group::base(thing.state.role), |_| group::leaf());
        let other = |_: ColliderHandle, c: &Collider| {
            let node = group::marked(c.user_data).0;
            group::is_solid(c) && sweep.meets(node)
        };
        let hits = solid.map(|(shape, local)| {
            let at = convert::pose(&sweep.travel.at(step)) * *local;
            let filter = QueryFilter::default().exclude_sensors().groups(own).predicate(&other);
            let queries = self.engine.queries(filter);
            let deep = |collider: &Collider| {
                let between = at.inv_mul(collider.position());
                let depth =
                    rapier3d::parry::query::contact(&EnginePose::IDENTITY, &**shape, &between, collider.shape(), 0.0);
                !depth.is_ok_and(|c| c.is_none_or(|c| c.dist > -SKIN))
            };
            let hits = queries.intersect_shape(at, &**shape).filter(|(_, c)| deep(c));
            hits.map(|(_, c)| group::marked(c.user_data).0).collect::<Vec<NodeId>>()
        });
        hits.into_iter().flatten()
    }

    /// The obstacles of a part's load at a tested position.
    fn obstacles_of_load(&self, sweep: &Sweep<'_>, step: usize) -> impl Iterator<Item = NodeId> {
        let motion = sweep.travel.since_start(step);
        let hits = |id: &NodeId| {
            let all = self.pose(*id).and_then(|pose| self.overlaps(*id, &(motion * pose)).ok());
            // A thing for which the query fails has no room: it counts as its own obstacle.
            all.map_or_else(|| vec![*id], |all| all.into_iter().filter(|m| sweep.meets(*m)).collect())
        };
        sweep.load.iter().flat_map(hits).collect::<Vec<NodeId>>().into_iter()
    }
}

/// The motion of a part.
struct Sweep<'w> {
    thing: &'w Thing,
    part: usize,
    travel: Travel,
    /// The things that the part carries.
    load: Vec<NodeId>,
    /// Nodes that are ignored.
    past: Vec<NodeId>,
}

impl Sweep<'_> {
    /// Whether a node counts as an obstacle.
    fn meets(&self, id: NodeId) -> bool {
        id != self.thing.id && !self.load.contains(&id) && !self.past.contains(&id)
    }
}

//! Doors and drawers that give way to an agent that steps up.

use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use super::room::standing_capsule;
use crate::group;
use crate::state::{Agent, Thing};
use crate::world::PhysicsWorld;

/// The opening at which a part that gives way stays at least, as a fraction of its range.
const AJAR: f32 = 0.1;
/// Number of positions that are tested, from there to wide open.
const POSITIONS: u8 = 18;

/// Moving parts by node and number, and the opening that each would have, 0 to 1.
pub type PartsToMoveAside = Vec<(NodeId, usize, f32)>;

/// Whether doors between rooms that are shut give way to an agent too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShutDoors {
    /// They stay shut.
    Stay,
    /// Those that are not locked open.
    Open,
}

impl PhysicsWorld {
    /// The moving parts that would have to give way so that a body could stand at a pose.
    pub(crate) fn parts_to_move_aside(&self, body: &Agent, feet: &Pose, shut: ShutDoors) -> Option<PartsToMoveAside> {
        let aside = |(id, link): (NodeId, usize)| {
            let part = link.checked_sub(1)?;
            let opens = shut == ShutDoors::Open && self.is_unlocked_door(id, part);
            Some((id, part, self.part_aside(body, feet, id, part, if opens { 0.0 } else { AJAR })?))
        };
        let overlapped = self.overlapped_at(body, feet);
        // The contents of a drawer move with it.
        let parts = overlapped.iter().filter_map(|(id, link)| Some((id, link.checked_sub(1)?)));
        let load: Vec<NodeId> = parts.flat_map(|(id, part)| self.load_of_part(*id, part)).collect();
        overlapped.into_iter().filter(|(id, _)| !load.contains(id)).map(aside).collect()
    }

    /// Whether a part is the leaf of a door between rooms and not locked.
    fn is_unlocked_door(&self, id: NodeId, part: usize) -> bool {
        let free = |thing: &Thing| thing.state.moving.get(part).is_some_and(|m| !m.locked);
        self.thing(id).is_ok_and(|thing| thing.state.door && free(thing))
    }

    /// Nodes and links that a body would overlap with its feet at a pose.
    pub(super) fn overlapped_at(&self, body: &Agent, feet: &Pose) -> Vec<(NodeId, usize)> {
        let (shape, at) = standing_capsule(&body.plan, feet);
        let solid = |_: ColliderHandle, c: &Collider| group::is_solid(c) && c.parent() != Some(body.body);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let mut overlapped: Vec<(NodeId, usize)> =
            queries.intersect_shape(at, &shape).map(|(_, c)| group::marked(c.user_data)).collect();
        overlapped.sort_unstable();
        overlapped.dedup();
        overlapped
    }

    /// The opening nearest to the present one at which a part is out of a body's way; `None` if the part is less
    /// open than `least`.
    fn part_aside(&self, body: &Agent, feet: &Pose, id: NodeId, part: usize, least: f32) -> Option<f32> {
        let now = self.moving_parts(id).get(part).map(|p| p.open).filter(|open| *open >= least)?;
        let position = |i: u8| AJAR + (1.0 - AJAR) * f32::from(i) / f32::from(POSITIONS);
        let mut positions: Vec<f32> = (0..=POSITIONS).map(position).collect();
        positions.sort_by(|a, b| (a - now).abs().total_cmp(&(b - now).abs()));
        let clear = |open: &f32| {
            self.meets_part(body, feet, id, part, *open).is_ok_and(|overlapped| !overlapped)
                && self.is_free_way(id, part, *open)
        };
        positions.into_iter().find(clear)
    }
}

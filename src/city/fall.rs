//! Things that fall out of their region: over the parapet of a gallery or a balcony, into what is below.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};
use vc_graph::NodeId;
use vc_graph::space::{RegionId, RegionKind};

use super::City;
use super::measures::{DEEPEST, FALLS, STEP};
use super::things::{Gate, loose};
use crate::Environment;

impl City {
    /// Lets what falls beside a region go over to the region of the same building on which it will land.
    pub(super) fn fall_out(&mut self, region: RegionId) {
        let Some(there) = self.active.get(&region) else { return };
        let falls = |id: &NodeId| there.world().body(*id).is_ok_and(|body| body.velocity().z < -FALLS);
        let falling: Vec<NodeId> = loose(there).filter(falls).collect();
        if falling.is_empty() {
            return;
        }
        let gates = self.gates_of(region);
        let is_beside = |there: &Environment, id: &NodeId| {
            let at = there.world().body(*id).ok()?.centre_of_mass();
            let is_at_portal = gates.iter().any(|gate: &Gate| gate.is_at(&at));
            (!is_at_portal && ground(there, &at, &there.graph().carried_with(*id)).is_none()).then_some(at)
        };
        if !falling.iter().any(|id| is_beside(there, id).is_some()) {
            return;
        }
        // It takes along what is on or in it now.
        let Some(there) = self.active.get_mut(&region) else { return };
        there.catch_up();
        let there = &*there;
        let alone = falling.into_iter().filter(|id| there.carrier(*id) == *id);
        let out: Vec<(NodeId, Point3<f32>)> = alone.filter_map(|id| Some((id, is_beside(there, &id)?))).collect();
        for (thing, at) in out {
            let Some(into) = self.region_below(region, &at) else { continue };
            let Some(shift) = self.pose_in(into, region) else { continue };
            let room = self.seen(into).ok().and_then(|there| room_at(&there, &(shift * at)));
            // Where nothing can take it, it falls to the end of its own region, which tells of it.
            let _ = self.carry_over(thing, (region, into), &shift, room);
        }
    }

    /// The region of the same building that has the highest thing below a point of a region.
    fn region_below(&self, from: RegionId, at: &Point3<f32>) -> Option<RegionId> {
        let mut found: Option<(f32, RegionId)> = None;
        for region in self.of_building(from).into_iter().filter(|region| *region != from) {
            // A storey above is not made to be looked at.
            let back = self.pose_in(from, region).filter(|back| back.translation.z < at.z + STEP);
            let (Some(back), Some(there)) = (back, back.and_then(|_| self.seen(region).ok())) else { continue };
            let below = ground(&there, &(back.inverse() * at), &[]).map(|(_, hit)| (back * hit).z);
            let Some(below) = below else { continue };
            if found.is_none_or(|(height, _)| below > height) {
                found = Some((below, region));
            }
        }
        found.map(|(_, region)| region)
    }

    /// The regions with scenes of the building that a region is part of, in order; none outside of buildings.
    fn of_building(&self, region: RegionId) -> BTreeSet<RegionId> {
        let plan = |id: RegionId| self.space().region(id);
        let above = std::iter::successors(Some(region), |id| plan(*id)?.parent);
        let is_building = |id: &RegionId| plan(*id).is_some_and(|plan| plan.kind == RegionKind::Building);
        let mut left: Vec<RegionId> = above.filter(is_building).take(1).collect();
        let mut all = BTreeSet::new();
        while let Some(id) = left.pop() {
            left.extend(self.space().parts(id));
            all.extend(plan(id).filter(|plan| plan.has_scene()).map(|_| id));
        }
        all
    }
}

/// The one of a region's own things that is below a point, and where.
pub(super) fn ground(there: &Environment, at: &Point3<f32>, but: &[NodeId]) -> Option<(NodeId, Point3<f32>)> {
    let hit = there.world().ray(*at, at - DEEPEST * Vector3::z(), but)?;
    there.graph().node(hit.0).map(|_| hit)
}

/// The room over which a point is, or the first.
fn room_at(there: &Environment, at: &Point3<f32>) -> Option<NodeId> {
    let graph = there.graph();
    let around = |id: &&NodeId| {
        let room = graph.node(**id).and_then(vc_graph::Node::aabb);
        room.is_some_and(|room| (0..2).all(|axis| (room.min[axis]..room.max[axis]).contains(&at[axis])))
    };
    graph.rooms().iter().find(around).or_else(|| graph.rooms().first()).copied()
}

//! Things in doorways between regions: between the doors of a lift, and in a shut front door.

use nalgebra::Vector3;
use vc_graph::space::{Portal, RegionId};
use vc_graph::{NodeId, Pose, State};
use vc_physics::BodyRole;

use super::City;
use super::lift::Lift;
use super::measures::BAR;
use crate::Environment;

/// How far things are in a leaf, or over its line, that are not only pressed against it, metres.
const DEEP: f32 = 0.01;

impl City {
    /// Whether a thing is between the doors of a lift at a stop, so that they do not shut.
    pub(super) fn is_obstructed(&self, cabin: RegionId, stop: u32) -> bool {
        let mut plans = self.space().portals_of(cabin).filter_map(|portal| self.space().portal(portal));
        let plan = plans.find(|plan| plan.stop == stop);
        plan.is_some_and(|plan| plan.sides.iter().any(|side| !self.between_doors(side.region, plan).is_empty()))
    }

    /// The loose things of a region, if somebody has been there, that are between both doors of a lift.
    fn between_doors(&self, region: RegionId, plan: &Portal) -> Vec<NodeId> {
        let known = self.active.contains_key(&region) || self.asleep.contains_key(&region);
        let there = known.then(|| self.seen(region).ok()).flatten();
        there.map_or_else(Vec::new, |there| self.on_sill(&there, (region, plan)))
    }

    /// The loose things of a region into which the doors of a lift reach when they are shut, or which are over the shaft.
    fn on_sill(&self, there: &Environment, (region, plan): (RegionId, &Portal)) -> Vec<NodeId> {
        let doors = self.doors_of_lift((region, there.graph()), plan).into_iter();
        let in_doors = doors.flat_map(|door| there.world().parts(door).reach_into_when_shut(DEEP));
        let over = self.over_shaft(there, (region, plan)).unwrap_or_default();
        in_doors.chain(over).filter(|id| is_loose(there, *id)).collect()
    }

    /// Whatever of a region reaches farther than the middle between its line at a portal and that of the region beyond.
    fn over_shaft(&self, there: &Environment, (region, plan): (RegionId, &Portal)) -> Option<Vec<NodeId>> {
        let (own, across) = (plan.side(region)?, plan.across(region)?);
        let back = self.frame_at(across.region, plan)?.to(&self.frame_at(region, plan)?);
        let gap = (own.pose.inverse() * back * across.pose).translation.x.max(0.0);
        let (first, last) = ((gap / 2.0).max(DEEP), gap + BAR);
        let middle = Pose::translation(f32::midpoint(first, last), 0.0, plan.height / 2.0);
        let size = Vector3::new(last - first, plan.width, plan.height);
        Some(there.world().in_box(size, &(own.pose * middle)))
    }

    /// The loose things of a region that are in shut doors between regions, where they were to be held up.
    pub(super) fn in_shut_doors(&self, region: RegionId, there: &Environment) -> Vec<NodeId> {
        let things = |(_, plan, ..): (_, &Portal, _, _)| match (self.lifts.at(plan), plan.leaf) {
            (Some((cabin, lift)), _) if is_shut_at(lift, plan, cabin == region) => self.on_sill(there, (region, plan)),
            (None, Some(leaf)) => in_shut_leaf(there, leaf),
            _ => Vec::new(),
        };
        let mut all: Vec<NodeId> = self.gates(region).flat_map(things).collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}

fn is_loose(there: &Environment, id: NodeId) -> bool {
    there.world().role(id) == Some(BodyRole::Loose)
}

/// Whether the doors of a lift are shut at a stop: at that landing, or in its cabin, which has one door for all stops.
fn is_shut_at(lift: &Lift, plan: &Portal, in_cabin: bool) -> bool {
    if in_cabin { lift.is_all_shut() } else { !lift.is_standing_open(plan.stop) }
}

/// The loose things that are in a leaf of this region, if it is shut.
fn in_shut_leaf(there: &Environment, leaf: NodeId) -> Vec<NodeId> {
    let is_shut = there.graph().node(leaf).is_some_and(|node| node.is(State::Closed));
    let all = if is_shut { there.world().parts(leaf).reach_into_when_shut(DEEP) } else { Vec::new() };
    all.into_iter().filter(|id| is_loose(there, *id)).collect()
}

//! Obstacles at the borders of a region: walls and floors beyond its portals, and portals that are shut.

use nalgebra::{Point3, Vector3};
use vc_graph::space::{Portal, PortalId, PortalKind, PortalSide, RegionFrame, RegionId};
use vc_graph::{NodeId, Pose, State};

use super::City;
use super::measures::{AJAR, BAR};
use crate::environment::{Around, Bar, Walls};

/// A threshold of a region that is shut at times by no leaf of its own: a front door as seen from the gallery, the doors of
/// a lift. In a cabin the portals of all stops have the same.
struct Threshold<'a> {
    /// The number by which the region's bodies know what is in the way there.
    bar: NodeId,
    side: &'a PortalSide,
    portals: Vec<(PortalId, &'a Portal)>,
}

impl City {
    /// The portals of a region through which things go, with its own side and the one across.
    pub(super) fn gates(
        &self,
        region: RegionId,
    ) -> impl Iterator<Item = (PortalId, &Portal, &PortalSide, &PortalSide)> {
        let plans = self.space().portals_of(region).filter_map(|id| Some((id, self.space().portal(id)?)));
        let plans = plans.filter(|(_, plan)| plan.kind != PortalKind::Window);
        plans.filter_map(move |(id, plan)| Some((id, plan, plan.side(region)?, plan.across(region)?)))
    }

    /// The surroundings of a region, as the regions beyond are made: what is fixed there never moves.
    pub(super) fn around(&self, region: RegionId) -> Around {
        let walls = self.gates(region).filter_map(|(_, plan, side, across)| {
            Some(Walls {
                // A region that cannot be made has nothing.
                scene: self.source.scene(across.region).ok()?,
                threshold: Point3::from(across.pose.translation.vector),
                pose: self.frame_at(across.region, plan)?.to(&self.frame_at(region, plan)?),
                out: side.pose.rotation * Vector3::x(),
                but: plan.leaf,
            })
        });
        let walls: Vec<Walls> = walls.collect();
        let bars = self.thresholds(region).into_iter().map(|Threshold { bar, side, portals }| {
            let (width, height) = portals.first().map_or((0.0, 0.0), |(_, plan)| (plan.width, plan.height));
            let open =
                |leaf| walls.iter().any(|beyond| beyond.scene.node(leaf).is_some_and(|leaf| leaf.is(State::Open)));
            Bar {
                id: bar,
                pose: side.pose * Pose::translation(BAR / 2.0, 0.0, height / 2.0),
                size: Vector3::new(BAR, width, height),
                shut: !portals.iter().filter_map(|(_, plan)| plan.leaf).any(open),
            }
        });
        Around { bars: bars.collect(), walls }
    }

    /// The frame of a region where one of its portals is there.
    pub(super) fn frame_at(&self, region: RegionId, portal: &Portal) -> Option<RegionFrame> {
        Some(self.space().region(region)?.frame_at(portal.stop as usize))
    }

    fn thresholds(&self, region: RegionId) -> Vec<Threshold<'_>> {
        let mut all: Vec<Threshold<'_>> = Vec::new();
        let is_own = |leaf: NodeId| self.space().made_in(leaf) == Some(region);
        for (id, plan, side, _) in self.gates(region) {
            if plan.leaf.map_or(self.lifts.at(plan).is_none(), is_own) {
                continue;
            }
            match all.iter_mut().find(|known| known.side.pose == side.pose) {
                Some(known) => known.portals.push((id, plan)),
                None => {
                    let bar = plan.leaf.unwrap_or(NodeId(u32::MAX - id.0));
                    all.push(Threshold { bar, side, portals: vec![(id, plan)] });
                }
            }
        }
        all
    }

    /// Bars the thresholds of a region that let nothing through now, and no others.
    pub(super) fn set_bars(&mut self, region: RegionId) {
        self.set_bars_to(region, |_| true);
    }

    /// Bars the thresholds to those regions beyond of which something holds, as they are now.
    pub(super) fn set_bars_to(&mut self, region: RegionId, is_meant: impl Fn(RegionId) -> bool) {
        let leads = |plan: &Portal| plan.across(region).is_some_and(|side| is_meant(side.region));
        let now = |threshold: &Threshold<'_>| {
            let shut = threshold.portals.iter().all(|(id, plan)| self.is_shut(*id, plan, (region, threshold.bar)));
            (threshold.bar, shut)
        };
        let meant = |threshold: &&Threshold<'_>| threshold.portals.iter().any(|(_, plan)| leads(plan));
        let bars: Vec<(NodeId, bool)> = self.thresholds(region).iter().filter(meant).map(now).collect();
        let Some(there) = self.active.get_mut(&region) else { return };
        bars.into_iter().for_each(|(bar, shut)| there.set_barred(bar, shut));
    }

    /// Whether a portal lets nothing through now. Behind it nothing differs from how it was made if nobody has been there.
    fn is_shut(&self, portal: PortalId, plan: &Portal, (region, bar): (RegionId, NodeId)) -> bool {
        let beyond = plan.leaf.filter(|_| self.lifts.at(plan).is_none()).and_then(|leaf| self.region_of(leaf));
        match beyond.filter(|at| !self.active.contains_key(at) && !self.asleep.contains_key(at)) {
            Some(_) => self.first(region).is_ok_and(|made| made.world().is_barred(bar)),
            None => self.portal(portal).is_none_or(|state| !state.passable),
        }
    }

    /// Whether things go through a portal of a region that is there: past a leaf that stands ajar, too.
    pub(super) fn lets_things_through(&self, region: RegionId, plan: &Portal) -> bool {
        let Some(there) = self.active.get(&region) else { return false };
        let shut = plan.leaf.and_then(|leaf| there.world().parts(leaf).openness()).is_some_and(|open| open < AJAR);
        let is_of = |threshold: &Threshold<'_>| threshold.portals.iter().any(|(_, other)| *other == plan);
        let barred = || self.thresholds(region).iter().any(|line| is_of(line) && there.world().is_barred(line.bar));
        let at_its_stop = self.lifts.at(plan).is_none_or(|(_, lift)| lift.is_open_at(plan.stop));
        at_its_stop && !shut && !barred()
    }
}

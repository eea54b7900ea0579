//! Regions that are seen from another one, through open and glazed portals.

use std::collections::{BTreeMap, VecDeque};

use nalgebra::{Point3, distance};
use vc_graph::Pose;
use vc_graph::space::{PortalId, PortalSide, RegionId};

use super::City;
use super::measures::{FAR, PORTALS};

/// A region that is seen from another one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct InSight {
    pub(super) region: RegionId,
    /// The pose of its frame in that of the region from which it is seen.
    pub(super) pose: Pose,
    /// Whether one sees into it, and not only its shut door from outside.
    pub(super) is_open: bool,
}

impl City {
    /// The regions that are seen from a point of one, itself first, then in the order of their numbers: those behind up to
    /// three doors or windows that one can see through, and from outside those whose shut doors are on such a way. Behind a
    /// shut door of its own stand the same regions, from outside: they shade its windows.
    pub(super) fn in_sight(&self, from: RegionId, eye: &Point3<f32>) -> Vec<InSight> {
        let mut found = BTreeMap::from([(from, true)]);
        let mut ahead = VecDeque::from([(from, 0, true)]);
        while let Some((region, portals, is_seen)) = ahead.pop_front() {
            for portal in self.space().portals_of(region) {
                let Some((side, is_open)) = self.beyond(portal, region) else { continue };
                // A stair or a gallery in the open hides nothing: what is behind no more doors comes first.
                let is_door = self.space().portal(portal).is_some_and(|plan| plan.leaf.is_some());
                if is_open && is_door && portals == PORTALS {
                    continue;
                }
                let (goes_on, is_open) = (is_open || region == from, is_seen && is_open);
                let is_known = found.get(&side.region).is_some_and(|known| *known || !is_open);
                let at = self.pose_in(from, side.region).map(|pose| pose * Point3::from(side.pose.translation.vector));
                if is_known || at.is_none_or(|at| distance(&at, eye) > FAR) {
                    continue;
                }
                found.insert(side.region, is_open);
                match (goes_on, is_door) {
                    (true, true) => ahead.push_back((side.region, portals + 1, is_open)),
                    (true, false) => ahead.push_front((side.region, portals, is_open)),
                    (false, _) => {}
                }
            }
        }
        let own = found.remove(&from).map(|is_open| (from, is_open));
        let all = own.into_iter().chain(found);
        all.filter_map(|(region, is_open)| Some(InSight { region, pose: self.pose_in(from, region)?, is_open }))
            .collect()
    }

    /// The other side of a portal if anything is seen of the region there, and whether one sees into it.
    fn beyond(&self, portal: PortalId, region: RegionId) -> Option<(&PortalSide, bool)> {
        let plan = self.space().portal(portal)?;
        let across = plan.across(region)?;
        let is_open = self.portal(portal)?.transparent;
        // A lift elsewhere is not seen.
        let is_shut_door = || self.lifts.at(plan).is_none() && plan.leaf.is_some();
        (is_open || is_shut_door()).then_some((across, is_open))
    }
}

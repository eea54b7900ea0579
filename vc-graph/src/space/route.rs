//! Ways from region to region.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use nalgebra::{Point3, distance};

use super::{PortalId, RegionId, Space};

impl Space {
    /// The portals on the shortest way from a point of one region to a point of another, by straight lines from portal to
    /// portal; empty within one region, `None` if there is no way, or a point is not finite. Points are in the frames of their regions, metres;
    /// `passable` says which portals can be gone through.
    ///
    /// An A* search (Hart, Nilsson and Raphael, 1968). Costs what is near the way, however large the world is.
    ///
    /// ```
    /// use vc_graph::Pose;
    /// use vc_graph::nalgebra::{Point3, Vector3};
    /// use vc_graph::space::{Portal, PortalKind, PortalSide, Region, RegionKind, SpaceBuilder};
    /// let mut plan = SpaceBuilder::new();
    /// let flat = plan.add(Region::new(RegionKind::Unit, "flat").with_numbers(100))?;
    /// let yard = plan.add(Region::new(RegionKind::Yard, "yard").with_numbers(100).shifted(5.0, 0.0, 0.0))?;
    /// let inside = PortalSide { region: flat, pose: Pose::translation(5.0, 0.0, 0.0), room: None };
    /// let back = Pose::rotation(Vector3::new(0.0, 0.0, std::f32::consts::PI));
    /// let door = plan.join(Portal::new(PortalKind::Passage, [inside, PortalSide { region: yard, pose: back, room: None }], 0.9, 2.0))?;
    /// let space = plan.build();
    /// let (here, there) = (Point3::new(1.0, 1.0, 0.0), Point3::new(8.0, 2.0, 0.0));
    /// assert_eq!(space.route((flat, here), (yard, there), |_| true), Some(vec![door]));
    /// assert_eq!(space.route((flat, here), (yard, there), |_| false), None);
    /// # Ok::<(), vc_graph::space::SpaceError>(())
    /// ```
    pub fn route(
        &self,
        (from, start): (RegionId, Point3<f32>),
        (to, end): (RegionId, Point3<f32>),
        passable: impl Fn(PortalId) -> bool,
    ) -> Option<Vec<PortalId>> {
        let (start, end) = (self.in_world(from, &start)?, self.in_world(to, &end)?);
        let mut search = Search { end, open: BinaryHeap::new(), known: BTreeMap::new() };
        search.reach(Step { entered: (from, None), at: start, walked: 0.0, before: (from, None) });
        while let Some(step) = search.next() {
            let region = step.entered.0;
            if region == to {
                return Some(search.way(step.entered));
            }
            for portal in self.portals_of(region).filter(|portal| passable(*portal)) {
                let Some((into, at, length)) = self.through(portal, region, &step.at) else { continue };
                let walked = step.walked + length;
                search.reach(Step { entered: (into, Some(portal)), at, walked, before: step.entered });
            }
        }
        None
    }

    /// The region beyond a portal, where in the world one is then, and the length of the way there from a point of the
    /// world: up its stairs, or through it and down them.
    fn through(&self, portal: PortalId, from: RegionId, at: &Point3<f64>) -> Option<(RegionId, Point3<f64>, f64)> {
        let plan = self.portal(portal)?;
        let (side, stop) = (plan.across(from)?, plan.stop as usize);
        let place = |region, point: &Point3<f32>| self.in_world_at(region, stop, point);
        let threshold = place(side.region, &Point3::from(side.pose.translation.vector))?;
        let foot = plan.stairs.first().and_then(|foot| place(plan.sides[0].region, foot));
        let climb = f64::from(plan.climb());
        Some(match foot {
            None => (side.region, threshold, distance(at, &threshold)),
            Some(foot) if from == plan.sides[0].region => (side.region, threshold, distance(at, &foot) + climb),
            Some(foot) => (side.region, foot, distance(at, &threshold) + climb),
        })
    }

    /// A point of a region in the world.
    fn in_world(&self, region: RegionId, point: &Point3<f32>) -> Option<Point3<f64>> {
        self.in_world_at(region, 0, point)
    }

    fn in_world_at(&self, region: RegionId, stop: usize, point: &Point3<f32>) -> Option<Point3<f64>> {
        let point = self.region(region)?.frame_at(stop).point(&point.cast());
        Some(point).filter(|point| point.iter().all(|value| value.is_finite()))
    }
}

/// A region, and the portal through which it was entered.
type Entered = (RegionId, Option<PortalId>);

/// A place on a way.
#[derive(Clone, Copy)]
struct Step {
    entered: Entered,
    at: Point3<f64>,
    walked: f64,
    before: Entered,
}

struct Search {
    end: Point3<f64>,
    /// Places to go on from, by the length of the way over them at least.
    open: BinaryHeap<Reverse<(u64, Entered)>>,
    known: BTreeMap<Entered, Step>,
}

impl Search {
    /// Notes a place, unless a way there is known that is as short.
    fn reach(&mut self, step: Step) {
        if self.known.get(&step.entered).is_some_and(|known| known.walked <= step.walked) {
            return;
        }
        let length = step.walked + distance(&step.at, &self.end);
        // Lengths are not negative, so that their bits are in order.
        self.open.push(Reverse((length.to_bits(), step.entered)));
        self.known.insert(step.entered, step);
    }

    fn next(&mut self) -> Option<Step> {
        let Reverse((_, entered)) = self.open.pop()?;
        self.known.get(&entered).copied()
    }

    /// The portals on the way to a place.
    fn way(&self, end: Entered) -> Vec<PortalId> {
        let mut portals = Vec::new();
        let mut next = end;
        while let (_, Some(portal)) = next {
            portals.push(portal);
            next = self.known.get(&next).map_or((next.0, None), |step| step.before);
        }
        portals.reverse();
        portals
    }
}

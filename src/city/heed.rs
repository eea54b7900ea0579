//! Heeding others at portals: nobody sets out through one without a free place beyond, two never meet in one, and those who
//! stand in the way with nothing to do make way.

use nalgebra::{Point2, Point3, distance};
use vc_graph::clock::{Span, TICKS_PER_SECOND};
use vc_graph::space::{Portal, PortalId, RegionId};
use vc_graph::{NodeId, Pose};

use super::journey::{Journey, Leg, Stage};
use super::measures::{BETWEEN, HELD, LEVEL, PATIENCE, RETREATS, STAYS};
use super::passage::Crossing;
use super::{City, CityError, way};
use crate::environment::{APART, apart_after};

/// How far the other may come in the same tick, metres.
const STEP: f32 = LEVEL / TICKS_PER_SECOND as f32;
/// A distance that has not changed, metres.
const SAME: f32 = 1e-4;

impl City {
    /// Whether somebody has a portal for itself: coming the other way, going back, or wanting out of a cabin first.
    pub(super) fn is_taken(&self, portal: PortalId, (from, into): (RegionId, RegionId)) -> bool {
        let comes = |crossing: &Crossing| crossing.portal == portal && (crossing.from != from || crossing.goes_back);
        let is_in_cabin = |id: &NodeId| self.lifts.get(into).is_some() && self.region_of(*id) == Some(into);
        let goes_first = |(id, journey): (&NodeId, &Journey)| {
            journey.crossing().is_some_and(comes) || (journey.next_portal() == Some(portal) && is_in_cabin(id))
        };
        self.journeys.iter().any(goes_first)
    }

    /// Whether somebody in a region is too near to a point for who has waited for some time.
    pub(super) fn is_crowded(&self, agent: NodeId, region: RegionId, at: &Point2<f32>, waited: Span) -> bool {
        let mut others = self.environment(region).into_iter().flat_map(|there| there.people_but(agent));
        others.any(|(_, other)| distance(&other, at) < apart_after(waited))
    }

    /// Whether somebody is in the way of a step; who stands there with nothing to do is asked to make way.
    pub(super) fn is_held(&mut self, agent: NodeId, crossing: &mut Crossing, step: &Pose) -> bool {
        let here = self.feet(agent).map(|feet| Point2::from(feet.translation.vector.xy()));
        let (Some(here), Some(region)) = (here, self.region_of(agent)) else { return false };
        let to = Point2::from(step.translation.vector.xy());
        let Some((near, follows)) = self.nearest_ahead(agent, crossing, [&here, &to]).filter(|(near, _)| *near < APART)
        else {
            crossing.held = Span(0);
            return false;
        };
        if crossing.held.0.is_multiple_of(PATIENCE.0) {
            let goal = crossing.spot_in(region).unwrap_or(to);
            self.make_way(agent, region, &[here, goal]);
        }
        // One does not get past somebody who goes the same way.
        let waited = if follows { crossing.held.min(PATIENCE) } else { crossing.held };
        waited < HELD && near < apart_after(waited) + STEP
    }

    /// The distance of the nearest other to which a step leads nearer, but for those who come after, and whether it goes the
    /// same way.
    fn nearest_ahead(&self, agent: NodeId, crossing: &Crossing, [here, to]: [&Point2<f32>; 2]) -> Option<(f32, bool)> {
        let there = self.environment_of(agent)?;
        let left = crossing.left(self.tick);
        let comes_after =
            |id: NodeId, other: &Crossing| other.left(self.tick).total_cmp(&left).then(id.cmp(&agent)).is_gt();
        let ahead = |(id, at): (NodeId, Point2<f32>)| {
            let is_nearer = distance(to, &at) < distance(here, &at) - SAME;
            let same_way = self.journeys.get(&id).and_then(Journey::crossing).filter(|other| crossing.follows(other));
            let is_ahead = is_nearer && same_way.is_none_or(|other| !comes_after(id, other));
            is_ahead.then_some((distance(to, &at), same_way.is_some()))
        };
        there.people_but(agent).filter_map(ahead).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Asks those on a line who stand and have nothing to do, or wait for a portal, to step off it.
    pub(super) fn make_way(&mut self, agent: NodeId, region: RegionId, line: &[Point2<f32>; 2]) {
        let Some(there) = self.environment(region) else { return };
        let in_the_way = there.people_but(agent).filter(|(_, at)| way::off(at, line) <= APART);
        let asked: Vec<(NodeId, Point2<f32>)> = in_the_way.filter(|(id, _)| self.can_make_way(*id)).collect();
        for (id, at) in asked {
            let Some(spot) = self.spot_aside((id, at), region, line) else { continue };
            let now = self.tick;
            match self.journeys.get_mut(&id) {
                Some(journey) => journey.step_aside(spot, now),
                None => _ = self.journeys.insert(id, Journey::unordered(Leg::Aside(spot), now)),
            }
        }
    }

    /// Those who stand in a cabin with nothing to do but to wait turn to its door.
    pub(super) fn riders_turn(&mut self) {
        let facing = |cabin: RegionId, at: &Pose| {
            let (_, _, side, _) = self.gates(cabin).next()?;
            way::turned(at, &way::facing(side.pose.translation.vector.xy() - at.translation.vector.xy()))
        };
        let cabins = self.lifts.busy().filter_map(|cabin| Some((cabin, self.environment(cabin)?)));
        let riders = cabins.flat_map(|(cabin, there)| there.agents().iter().map(move |agent| (cabin, *agent)));
        let waiting = riders.filter(|(_, agent)| self.can_make_way(*agent));
        let turned = waiting.filter_map(|(cabin, agent)| Some((agent, facing(cabin, &self.feet(agent)?)?)));
        for (agent, feet) in turned.collect::<Vec<(NodeId, Pose)>>() {
            if let Some(there) = self.environment_mut(agent) {
                there.place_feet(agent, feet);
            }
        }
    }

    /// Whether somebody stands and has nothing to do but to wait.
    fn can_make_way(&self, agent: NodeId) -> bool {
        let waits = |journey: &Journey| {
            let is_before = matches!(journey.legs.front(), Some(Leg::Cross(_) | Leg::Approach(_)));
            is_before && matches!(journey.stage, Stage::Waiting(_))
        };
        self.journeys.get(&agent).is_none_or(waits)
            && self.environment_of(agent).is_some_and(|there| there.is_free_to_move(agent))
    }

    /// Whether the doors of a lift have to stay open at a stop: somebody is between them, or wants out. One who stands between
    /// them with nothing to do is asked to leave.
    pub(super) fn keeps_open(&mut self, cabin: RegionId, stop: u32) -> bool {
        let space = self.space().clone();
        let mut portals = space.portals_of(cabin).filter_map(|id| Some((id, space.portal(id)?)));
        let Some((portal, plan)) = portals.find(|(_, plan)| plan.stop == stop) else { return false };
        let crosses = |journey: &Journey| journey.crossing().is_some_and(|crossing| crossing.portal == portal);
        let wants_out = |id: &NodeId, journey: &Journey| {
            journey.next_portal() == Some(portal) && self.region_of(*id) == Some(cabin)
        };
        if self.journeys.iter().any(|(id, journey)| crosses(journey) || wants_out(id, journey)) {
            return true;
        }
        let mut stands = false;
        for side in &plan.sides {
            let threshold = Point2::from(side.pose.translation.vector.xy());
            let there = self.environment(side.region).into_iter().flat_map(|there| there.people_but(NodeId(0)));
            if there.filter(|(_, at)| distance(at, &threshold) < BETWEEN).count() > 0 {
                stands = true;
                self.make_way(NodeId(0), side.region, &way::mouth(plan, side.region));
            }
        }
        stands
    }

    /// Whoever has waited long enough on a threshold goes back, so that others get through and doors can shut, and those
    /// behind with it. Out of a lift and on stairs one waits longer.
    pub(super) fn go_back_in_time(
        &mut self,
        agent: NodeId,
        plan: &Portal,
        crossing: &mut Crossing,
    ) -> Result<(), CityError> {
        let is_alone = plan.stairs.is_empty() && self.lifts.get(crossing.from).is_none();
        if crossing.held < if is_alone { RETREATS } else { STAYS } {
            return Ok(());
        }
        let no_room = CityError::of_no_floor(self.region_label(crossing.into));
        if !is_alone {
            return Err(no_room);
        }
        let behind = self
            .journeys
            .iter()
            .filter(|(id, journey)| **id != agent && journey.crossing().is_some_and(|other| other.follows(crossing)));
        for id in behind.map(|(id, _)| *id).collect::<Vec<NodeId>>() {
            let Some(Stage::Crossing(mut other)) = self.journeys.get(&id).map(|journey| journey.stage.clone()) else {
                continue;
            };
            if self.go_back(id, plan, &mut other).is_some()
                && let Some(journey) = self.journeys.get_mut(&id)
            {
                journey.stage = Stage::Crossing(other);
            }
        }
        self.go_back(agent, plan, crossing).ok_or(no_room)
    }

    /// Turns back to a free place before a portal, if there is one.
    fn go_back(&self, agent: NodeId, plan: &Portal, crossing: &mut Crossing) -> Option<()> {
        let (spot, feet) = (self.spot_before(agent, plan, crossing.from)?, self.feet(agent)?.translation.vector);
        (crossing.goes_back, crossing.spot) = (true, spot);
        crossing.sets_out(vec![feet.into(), Point3::new(spot.x, spot.y, feet.z)], self.tick);
        Some(())
    }
}

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

/// How much farther from a way than need be one stands who has made way, metres.
const ROOM: f32 = 0.05;
/// How far the other may come in the same tick, metres.
const STEP: f32 = LEVEL / TICKS_PER_SECOND as f32;
/// How near a spot is to one that was kept, metres: it is the same cell of the floor.
const KEPT: f32 = 0.1;
/// A distance that has not changed, metres.
const SAME: f32 = 1e-4;

impl City {
    /// The places in a region where somebody stands who is on no way through a portal.
    pub(super) fn standing(&self, agent: NodeId, region: RegionId) -> Vec<Point2<f32>> {
        let crosses = |id: &NodeId| self.journeys.get(id).is_some_and(|journey| journey.crossing().is_some());
        let there = self.environment(region).into_iter().flat_map(|there| there.people_but(agent));
        there.filter(|(id, _)| !crosses(id)).map(|(_, at)| at).collect()
    }

    /// The places in a region that are kept for others.
    fn kept_places(&self, agent: NodeId, region: RegionId) -> Vec<Point2<f32>> {
        let others = self.journeys.iter().filter(|(id, _)| **id != agent);
        let kept = others.filter_map(|(id, journey)| match (journey.crossing(), journey.legs.front()) {
            (Some(crossing), _) => crossing.spot_in(region),
            (None, Some(Leg::Aside(spot))) if self.region_of(*id) == Some(region) => Some(*spot),
            _ => None,
        });
        kept.collect()
    }

    /// The point of a region to which those go who come through a portal: to the back of a cabin, else a step.
    pub(super) fn towards(&self, plan: &Portal, into: RegionId) -> Point2<f32> {
        match self.lifts.get(into) {
            Some(_) => way::back_of(plan, into),
            None => way::beside(plan, into),
        }
    }

    /// A free place behind a portal, with a free way to it from the threshold, and off the ways of others; for who comes to
    /// the threshold the one that was kept, if nobody has come to stand there. If there is none, whoever stands there with
    /// nothing to do is asked to make way.
    pub(super) fn room_beyond(
        &mut self,
        agent: NodeId,
        plan: &Portal,
        into: RegionId,
        kept: Option<Point2<f32>>,
    ) -> Result<Point2<f32>, CityError> {
        let spot = self.environment(into).and_then(|there| {
            there.spot_near(agent, self.towards(plan, into), self.free_beyond(agent, (plan, into), kept))
        });
        spot.ok_or_else(|| {
            self.make_way(agent, into, &way::mouth(plan, into));
            CityError::of_no_floor(self.region_label(into))
        })
    }

    /// Whether a spot behind a portal is free for somebody, off its threshold, and one gets there past others. One that was
    /// kept has only to be free of those who stand.
    pub(super) fn free_beyond<'a>(
        &'a self,
        agent: NodeId,
        (plan, into): (&'a Portal, RegionId),
        kept: Option<Point2<f32>>,
    ) -> impl Fn(&Point2<f32>) -> bool + 'a {
        let (standing, taken) = (self.standing(agent, into), self.kept_places(agent, into));
        let to = move |spot: &Point2<f32>| way::last_stretch(plan, into, *spot);
        move |spot| {
            let line = to(spot);
            let is_kept = kept.is_some_and(|kept| distance(&kept, spot) < KEPT);
            let is_off = |other: &Point2<f32>| way::off(other, &line) > APART;
            let lets_by = |other: &Point2<f32>| is_kept || (is_off(other) && way::off(spot, &to(other)) > APART);
            distance(&line[0], spot) > BETWEEN && standing.iter().all(is_off) && taken.iter().all(lets_by)
        }
    }

    /// A free place before a portal, to wait for others or for a lift.
    pub(super) fn spot_before(&self, agent: NodeId, plan: &Portal, region: RegionId) -> Option<Point2<f32>> {
        let here = Point2::from(self.feet(agent)?.translation.vector.xy());
        let there = self.environment(region)?;
        let kept = self.kept_places(agent, region);
        let is_apart = |spot: &Point2<f32>| kept.iter().all(|other| distance(other, spot) > APART);
        let is_off = |spot: &Point2<f32>| is_apart(spot) && way::off(spot, &way::mouth(plan, region)) > APART;
        let straight = || there.spot_near(agent, way::beside(plan, region), is_apart);
        if self.lifts.at(plan).is_none() {
            return straight();
        }
        let mut sides = way::waiting(plan, region);
        sides.sort_by(|a, b| distance(a, &here).total_cmp(&distance(b, &here)));
        sides.iter().find_map(|side| there.spot_near(agent, *side, is_off)).or_else(straight)
    }

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
            let obstacles = [self.standing(id, region), self.kept_places(id, region)].concat();
            let is_aside = |spot: &Point2<f32>| {
                way::off(spot, line) > APART + ROOM && obstacles.iter().all(|other| distance(other, spot) > APART)
            };
            let Some(spot) = self.environment(region).and_then(|there| there.spot_near(id, at, is_aside)) else {
                continue;
            };
            let now = self.tick;
            match self.journeys.get_mut(&id) {
                Some(journey) => journey.step_aside(spot, now),
                None => _ = self.journeys.insert(id, Journey::unordered(Leg::Aside(spot), now)),
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

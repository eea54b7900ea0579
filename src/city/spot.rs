//! Places to stand at portals: before them, behind them, and out of the way.

use nalgebra::{Point2, distance};
use vc_graph::NodeId;
use vc_graph::space::{Portal, PortalId, PortalKind, RegionId};
use vc_physics::Posture;

use super::journey::Leg;
use super::measures::OFF;
use super::{City, CityError, way};
use crate::environment::APART;

/// How much farther from a way than need be one stands who has made way, metres.
const ROOM: f32 = 0.05;
/// How near a spot is to one that was kept, metres: it is the same cell of the floor.
const KEPT: f32 = 0.1;

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

    /// Whether a spot behind a portal is free for somebody, off all thresholds, and one gets there straight over the floor and
    /// past others. One that was kept has only to be free of those who stand.
    fn free_beyond<'a>(
        &'a self,
        agent: NodeId,
        (plan, into): (&'a Portal, RegionId),
        kept: Option<Point2<f32>>,
    ) -> impl Fn(&Point2<f32>) -> bool + 'a {
        let (standing, taken) = (self.standing(agent, into), self.kept_places(agent, into));
        let (there, mouths) = (self.environment(into), self.mouths(into));
        let to = move |spot: &Point2<f32>| way::last_stretch(plan, into, *spot);
        move |spot| {
            let line = to(spot);
            let is_kept = kept.is_some_and(|kept| distance(&kept, spot) < KEPT);
            let is_off = |other: &Point2<f32>| way::off(other, &line) > APART;
            let lets_by = |other: &Point2<f32>| is_kept || (is_off(other) && way::off(spot, &to(other)) > APART);
            let is_free = standing.iter().all(is_off) && taken.iter().all(lets_by);
            is_free && off_thresholds(spot, &mouths) && there.is_some_and(|there| there.leads_straight(&line[0], spot))
        }
    }

    /// A free place before a portal, off all thresholds, to wait for others or for a lift.
    pub(super) fn spot_before(&self, agent: NodeId, plan: &Portal, region: RegionId) -> Option<Point2<f32>> {
        let here = Point2::from(self.feet(agent)?.translation.vector.xy());
        let there = self.environment(region)?;
        let (kept, mouth, beside) =
            (self.kept_places(agent, region), way::mouth(plan, region), way::beside(plan, region));
        // Stairs begin where one waits for them.
        let mouths: Vec<_> = self.mouths(region).into_iter().filter(|other| other[0] != beside).collect();
        let fits = |spot: &Point2<f32>| {
            kept.iter().all(|other| distance(other, spot) > APART)
                && off_thresholds(spot, &mouths)
                && there.leads_straight(&mouth[0], spot)
        };
        let is_off = |spot: &Point2<f32>| way::off(spot, &mouth) > APART && fits(spot);
        let straight = || there.spot_near(agent, beside, fits);
        if self.lifts.at(plan).is_none() {
            return straight();
        }
        let mut sides = way::waiting(plan, region);
        sides.sort_by(|a, b| distance(a, &here).total_cmp(&distance(b, &here)));
        sides.iter().find_map(|side| there.spot_near(agent, *side, is_off)).or_else(straight)
    }

    /// A free place off a line, to which somebody goes who makes way: off all ways through portals, a straight step away or
    /// round a corner, or at least off all thresholds.
    pub(super) fn spot_aside(
        &self,
        (agent, at): (NodeId, Point2<f32>),
        region: RegionId,
        line: &[Point2<f32>; 2],
    ) -> Option<Point2<f32>> {
        let (there, mouths) = (self.environment(region)?, self.mouths(region));
        let others = [self.standing(agent, region), self.kept_places(agent, region)].concat();
        let is_aside = |spot: &Point2<f32>| {
            way::off(spot, line) > APART + ROOM
                && others.iter().all(|other| distance(other, spot) > APART)
                && off_thresholds(spot, &mouths)
        };
        let is_off = |spot: &Point2<f32>| is_aside(spot) && mouths.iter().all(|mouth| way::off(spot, mouth) > APART);
        let straight = |spot: &Point2<f32>| there.leads_straight(&at, spot);
        let step = there.spot_near(agent, at, |spot| is_off(spot) && straight(spot));
        let step = step.or_else(|| there.spot_on_foot(agent, at, is_off));
        step.or_else(|| there.spot_near(agent, at, |spot| is_aside(spot) && straight(spot)))
    }

    /// The free places nearest to the portals of a region, if nobody is there.
    pub(super) fn spots_at_portals(&self, region: RegionId) -> Vec<Point2<f32>> {
        let plans = self.space().portals_of(region).filter_map(|portal| self.space().portal(portal));
        let plans = plans.filter(|plan| plan.kind != PortalKind::Window);
        plans.filter_map(|plan| self.empty_spot(plan, region)).collect()
    }

    /// The free place nearest to a portal, if nobody is there.
    fn empty_spot(&self, plan: &Portal, region: RegionId) -> Option<Point2<f32>> {
        let (there, [threshold, _]) = (self.environment(region)?, way::mouth(plan, region));
        there.free_floor_near(way::beside(plan, region), |spot| there.leads_straight(&threshold, spot))
    }

    /// Whether somebody who stands gets over the floor to a portal, if nobody is in the way.
    pub(super) fn reaches(&self, agent: NodeId, portal: PortalId) -> bool {
        let Some((region, plan)) = self.region_of(agent).zip(self.space().portal(portal)) else { return true };
        let Some((there, feet)) = self.environment(region).zip(self.feet(agent)) else { return true };
        let spot = || self.empty_spot(plan, region);
        let stays = self.lifts.get(region).is_some() || there.posture(agent) != Some(Posture::Standing);
        stays || spot().is_none_or(|spot| there.has_way(feet.translation.vector.xy().into(), spot))
    }

    /// The lines that are needed before the portals of a region.
    pub(super) fn mouths(&self, region: RegionId) -> Vec<[Point2<f32>; 2]> {
        let plans = self.space().portals_of(region).filter_map(|portal| self.space().portal(portal));
        let plans = plans.filter(|plan| plan.kind != PortalKind::Window);
        plans.map(|plan| way::mouth(plan, region)).collect()
    }
}

/// Whether nobody who stands at a spot is on a threshold.
fn off_thresholds(spot: &Point2<f32>, mouths: &[[Point2<f32>; 2]]) -> bool {
    mouths.iter().all(|mouth| distance(&mouth[0], spot) > OFF)
}

//! Passages through portals: to the threshold, into the region beyond, to a free place there; or back, if there is none.

use nalgebra::{Point2, Point3};
use serde::{Deserialize, Serialize};
use vc_graph::clock::{Span, TICKS_PER_SECOND, Tick};
use vc_graph::hash::Digester;
use vc_graph::space::{Portal, PortalId, RegionId, Space};
use vc_graph::{Action, ChangeSet, NodeId, Pose, Verb, rule};

use super::journey::{Journey, Stage};
use super::measures::FARTHEST;
use super::{City, CityError, RegionLabel, way};
use crate::Environment;

/// Somebody on the way through a portal.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Crossing {
    pub(super) portal: PortalId,
    pub(super) from: RegionId,
    pub(super) into: RegionId,
    /// Whether it is in the region beyond by now.
    pub(super) is_beyond: bool,
    /// Whether it goes back, as there was no room beyond.
    pub(super) goes_back: bool,
    /// The way in the region in which it is, metres.
    way: Vec<Point3<f32>>,
    /// The place beyond that is kept for it.
    pub(super) spot: Point2<f32>,
    /// When it has begun this way, without the time for which it has waited.
    begun: Tick,
    /// How long somebody has been in its way.
    pub(super) held: Span,
    /// Whether the leaf was shut, so that it is shut again.
    shuts: bool,
}

impl Crossing {
    /// Whether it leads from or to a region.
    pub(super) fn joins(&self, region: RegionId) -> bool {
        [self.from, self.into].contains(&region)
    }

    /// Whether it is going to be in the region beyond.
    pub(super) fn is_on_its_way(&self) -> bool {
        !self.is_beyond && !self.goes_back
    }

    /// The place to which it goes in a region.
    pub(super) fn spot_in(&self, region: RegionId) -> Option<Point2<f32>> {
        let at = if self.goes_back { self.from } else { self.into };
        (at == region).then_some(self.spot)
    }

    /// Whether two go the same way, so that one follows the other.
    pub(super) fn follows(&self, other: &Self) -> bool {
        let course = |crossing: &Self| (crossing.portal, crossing.from, crossing.is_beyond, crossing.goes_back);
        course(self) == course(other)
    }

    /// Whether a saved passage can go on at a tick.
    pub(super) fn is_sound(&self, space: &Space, now: Tick) -> bool {
        let joins = |region| space.portal(self.portal).is_some_and(|plan| plan.side(region).is_some());
        let is_near = |point: &Point3<f32>| point.coords.iter().all(|value| value.abs() <= FARTHEST);
        let spot = Point3::new(self.spot.x, self.spot.y, 0.0);
        self.begun <= now && joins(self.from) && joins(self.into) && self.way.iter().chain([&spot]).all(is_near)
    }

    pub(super) fn feed(&self, hash: &mut Digester) {
        let flags = [self.is_beyond, self.shuts, self.goes_back].map(u64::from);
        hash.words([2, u64::from(self.portal.0), self.begun.0, self.held.0]).words(flags);
        hash.reals(self.way.iter().flat_map(|point| [point.x, point.y, point.z]).chain([self.spot.x, self.spot.y]));
    }

    /// How long it still takes, seconds.
    pub(super) fn left(&self, now: Tick) -> f32 {
        way::duration(&self.way) - now.0.saturating_sub(self.begun.0) as f32 / TICKS_PER_SECOND as f32
    }

    /// A tick passes in which it stands.
    fn waits(&mut self) {
        (self.begun, self.held) = (self.begun + Span(1), self.held + Span(1));
    }

    /// Goes another way, from now on.
    pub(super) fn sets_out(&mut self, way: Vec<Point3<f32>>, now: Tick) {
        (self.way, self.begun, self.held) = (way, now, Span(0));
    }
}

/// How far somebody has come in a tick.
enum Progress {
    OnTheWay,
    Through,
    BackAgain,
}

impl City {
    /// Begins to go through a portal, if it lets through and there is room beyond; calls the lift if it is one of a lift.
    pub(super) fn begin_crossing(&mut self, agent: NodeId, portal: PortalId) -> Result<Option<Crossing>, CityError> {
        let space = self.space().clone();
        let Some((from, plan)) = self.region_of(agent).zip(space.portal(portal)) else { return Ok(None) };
        let Some(into) = plan.across(from).map(|side| side.region) else { return Ok(None) };
        let is_of_lift = self.lifts.at(plan).is_some();
        if is_of_lift && !self.lift_lets_in(agent, plan) || self.is_taken(portal, (from, into)) {
            return Ok(None);
        }
        self.wake(into)?;
        let spot = self.room_beyond(agent, plan, into, None)?;
        let shuts = plan.leaf.is_some_and(|leaf| !is_of_lift && !self.is_open(leaf));
        if shuts {
            self.swing_leaf(agent, (portal, plan), true)?;
        }
        let Some(feet) = self.feet(agent) else { return Ok(None) };
        let (way, begun, held) = (way::way_out(plan, from, &feet), self.tick, Span(0));
        Ok(Some(Crossing { portal, from, into, is_beyond: false, goes_back: false, way, spot, begun, held, shuts }))
    }

    /// Whether the lift of a portal stands open there; else it is called. Whoever it had no room for calls it again when it has left.
    fn lift_lets_in(&mut self, agent: NodeId, plan: &Portal) -> bool {
        let Some((_, lift)) = self.lifts.at(plan) else { return false };
        let was_full = self.journeys.get(&agent).is_some_and(Journey::has_tried);
        let (is_open, waits) = (lift.is_open_at(plan.stop), was_full && lift.is_leaving(plan.stop));
        if !is_open && !waits && !lift.is_called_to(plan.stop) {
            self.call_lift(agent, plan);
        }
        is_open
    }

    /// Pushes the button of a lift, if there is one within reach and a hand is free; else it is called all the same.
    fn call_lift(&mut self, agent: NodeId, plan: &Portal) {
        let now = self.tick;
        let pushes = self.environment_of(agent).and_then(|there| {
            let button = plan.buttons.iter().find(|button| there.graph().node(**button).is_some())?;
            let push = Action::one(Verb::Push, *button);
            rule::refusals(there.graph(), agent, &push).is_empty().then_some(push)
        });
        match pushes.zip(self.journeys.get_mut(&agent)) {
            Some((push, journey)) => journey.presses(push, now),
            None => self.lifts.call(plan),
        }
    }

    /// Opens or shuts the leaf of a portal, if nothing is in its way; things that are begin to be pushed, and people are asked to
    /// make way. Those who pass give way, and so does everybody who has been in the way for long.
    fn swing_leaf(&mut self, agent: NodeId, (portal, plan): (PortalId, &Portal), open: bool) -> Result<(), CityError> {
        let Some(leaf) = plan.leaf else { return Ok(()) };
        let region = self.region_of(leaf).unwrap_or(plan.sides[0].region);
        self.wake(region)?;
        self.draw_to_leaf(region, leaf);
        let waits_long = self.journeys.get(&agent).is_some_and(Journey::has_waited_long);
        let passes = |id: NodeId| {
            self.journeys.get(&id).and_then(Journey::crossing).is_some_and(|crossing| crossing.portal == portal)
        };
        let give_way: Vec<NodeId> = self.agents().filter(|id| *id == agent || waits_long || passes(*id)).collect();
        let swung = self.wake(region)?.swing_leaf(leaf, open, &give_way);
        if swung.is_err() {
            self.make_way(agent, region, &way::mouth(plan, region));
        }
        Ok(swung.map(drop)?)
    }

    /// Moves those who are between two regions.
    pub(super) fn journeys_pass(&mut self) {
        let crossing = |city: &Self, agent| city.journeys.get(&agent).and_then(Journey::crossing).cloned();
        let agents: Vec<NodeId> = self.journeys.keys().copied().collect();
        for agent in agents {
            let Some(mut crossing) = crossing(self, agent) else { continue };
            match self.go_through(agent, &mut crossing) {
                Ok(Progress::OnTheWay) => {
                    if let Some(journey) = self.journeys.get_mut(&agent) {
                        journey.stage = Stage::Crossing(crossing);
                    }
                    continue;
                }
                Ok(Progress::Through) => self.leg_done(agent),
                Ok(Progress::BackAgain) => {
                    self.leg_failed(agent, CityError::of_no_floor(self.region_label(crossing.into)));
                }
                Err(why) => self.leg_failed(agent, why),
            }
            self.shut_behind(agent, &crossing);
        }
    }

    /// Shuts the leaf that somebody has opened, or leaves that to another one who is passing.
    fn shut_behind(&mut self, agent: NodeId, passed: &Crossing) {
        if !passed.shuts {
            return;
        }
        let mut others = self.journeys.values_mut().filter_map(|journey| match &mut journey.stage {
            Stage::Crossing(crossing) => Some(crossing).filter(|crossing| crossing.portal == passed.portal),
            _ => None,
        });
        if let Some(other) = others.next() {
            other.shuts = true;
        } else if let Some(plan) = self.space().clone().portal(passed.portal) {
            // A leaf with somebody in its way stays open; against things it is pushed.
            let _ = self.swing_leaf(agent, (passed.portal, plan), false);
        }
    }

    /// Goes on through a portal, unless somebody is in the way.
    fn go_through(&mut self, agent: NodeId, crossing: &mut Crossing) -> Result<Progress, CityError> {
        let gone = self.tick.0.saturating_sub(crossing.begun.0);
        let Some(feet) = way::along(&crossing.way, gone) else { return self.at_its_end(agent, crossing) };
        if self.is_held(agent, crossing, &feet) {
            crossing.waits();
        } else if let Some(environment) = self.environment_mut(agent) {
            environment.place_feet(agent, feet);
        }
        Ok(Progress::OnTheWay)
    }

    /// Somebody is at the end of a way: at the threshold, at its place beyond, or back.
    fn at_its_end(&mut self, agent: NodeId, crossing: &mut Crossing) -> Result<Progress, CityError> {
        if crossing.is_on_its_way() {
            return self.hand_over(agent, crossing).map(|()| Progress::OnTheWay);
        }
        let (feet, last) = (self.feet(agent).unwrap_or_else(Pose::identity), crossing.way.last());
        let at = Pose::from_parts(last.copied().unwrap_or_else(Point3::origin).coords.into(), feet.rotation);
        // In a lift one turns to its door.
        let door = crossing.way.first().filter(|_| crossing.is_beyond && self.lifts.get(crossing.into).is_some());
        let turned =
            door.and_then(|door| way::turned(&at, &way::facing(door.coords.xy() - at.translation.vector.xy())));
        let environment = self.environment_mut(agent);
        Ok(match (turned, crossing.goes_back) {
            (Some(turned), _) => {
                environment.into_iter().for_each(|there| there.place_feet(agent, turned));
                Progress::OnTheWay
            }
            (None, goes_back) => {
                environment.into_iter().for_each(|there| there.stand_at(agent, at));
                if goes_back { Progress::BackAgain } else { Progress::Through }
            }
        })
    }

    /// Takes an agent from the region that it leaves into the one that it enters, if there is room for it; it goes back if
    /// there is none for a while.
    fn hand_over(&mut self, agent: NodeId, crossing: &mut Crossing) -> Result<(), CityError> {
        let space = self.space().clone();
        let Crossing { portal, from, into, .. } = *crossing;
        let Some((plan, side)) = space.portal(portal).and_then(|plan| Some((plan, plan.side(into)?))) else {
            return Ok(());
        };
        self.wake(into)?;
        let threshold: Point2<f32> = side.pose.translation.vector.xy().into();
        let room = self.room_beyond(agent, plan, into, Some(crossing.spot));
        let Some(spot) = room.ok().filter(|_| !self.is_crowded(agent, into, &threshold, crossing.held)) else {
            crossing.waits();
            return self.go_back_in_time(agent, plan, crossing);
        };
        let frames = self.frame(from).zip(self.frame(into));
        let shift = frames.map_or_else(Pose::identity, |(from, to)| from.to(&to));
        let feet = self.feet(agent).unwrap_or_else(Pose::identity);
        let entered = shift * feet;
        let both = [from, into].into_iter().filter_map(|region| Some((region, self.active.get(&region)?.clone())));
        let before: Vec<(RegionId, Environment)> = both.collect();
        let passed = self.pass(agent, (plan, from, into), spot, (&shift, entered));
        match passed {
            Ok((spot, changes)) => {
                (crossing.is_beyond, crossing.spot) = (true, spot);
                let way = way::way_in(plan, into, spot);
                // The lines of both sides are some steps apart where walls are thick, and the doors of a lift.
                crossing.sets_out(std::iter::once(entered.translation.vector.into()).chain(way).collect(), self.tick);
                self.changed(agent, changes);
                Ok(())
            }
            Err(why) => {
                // Nobody is lost between two regions.
                self.active.extend(before);
                Err(why)
            }
        }
    }

    /// Takes an agent out of one environment and into the next; returns the place to which it goes on.
    fn pass(
        &mut self,
        agent: NodeId,
        (plan, from, into): (&Portal, RegionId, RegionId),
        spot: Point2<f32>,
        (shift, feet): (&Pose, Pose),
    ) -> Result<(Point2<f32>, ChangeSet), CityError> {
        let space = self.space().clone();
        let travel = |why| CityError::of_travel(&space, why);
        let missing = |region| CityError::NoScene(RegionLabel::new(&space, region));
        let home = self.active.get_mut(&from).ok_or_else(|| missing(from))?;
        let (departure, left) = home.depart(agent, from).map_err(travel)?;
        let next = self.active.get_mut(&into).ok_or_else(|| missing(into))?;
        let room = plan.side(into).and_then(|side| side.room).or_else(|| next.room_to_enter(&[]).map(|(room, _)| room));
        let room = room.unwrap_or(NodeId(0));
        let [from, _] = way::last_stretch(plan, into, spot);
        let fits = |there: &Environment, spot: &Point2<f32>| there.leads_straight(&from, spot);
        let arrived = next.arrive(&departure, (into, room), shift, feet, (spot, fits));
        let (spot, entered) = arrived.map_err(travel)?;
        self.are_now_in(departure.nodes(), into);
        Ok((spot, left.then(entered)))
    }

    /// Takes note of nodes that are in another region now.
    pub(super) fn are_now_in(&mut self, nodes: impl Iterator<Item = NodeId>, region: RegionId) {
        for node in nodes {
            if self.space().made_in(node) == Some(region) {
                self.whereabouts.remove(&node);
            } else {
                self.whereabouts.insert(node, region);
            }
        }
    }
}

//! The legs of ways from region to region: how each begins, ends, and is tried again.

use nalgebra::{Point2, distance};
use vc_graph::space::PortalId;
use vc_graph::{Action, ChangeSet, NodeId, Verb};
use vc_physics::Posture;

use super::journey::{Leg, Stage};
use super::measures::{PATIENCE, THERE};
use super::time::CityEnding;
use super::{City, CityError};

impl City {
    /// Begins the legs that can begin.
    pub(super) fn journeys_begin(&mut self) {
        let now = self.tick;
        let is_due = |stage: &Stage| matches!(stage, Stage::Waiting(until) if *until <= now);
        let waiting = self.journeys.iter().filter(|(_, journey)| is_due(&journey.stage));
        for agent in waiting.map(|(agent, _)| *agent).collect::<Vec<NodeId>>() {
            if let Err(why) = self.begin_leg(agent) {
                self.leg_failed(agent, why);
            }
        }
    }

    fn begin_leg(&mut self, agent: NodeId) -> Result<(), CityError> {
        loop {
            let Some(leg) = self.journeys.get(&agent).map(|journey| journey.legs.front().copied()) else {
                return Ok(());
            };
            let begun = match leg {
                None => {
                    self.end_journey(agent, Ok(()));
                    return Ok(());
                }
                Some(Leg::Act(action)) => {
                    self.clear_doorway(agent, &action, self.behind_door(agent, &action))?;
                    self.act(agent, action)
                }
                Some(Leg::Press(push)) => self.act(agent, push),
                Some(Leg::Approach(portal)) => match self.approach(agent, portal)? {
                    None => {
                        self.leg_done(agent);
                        continue;
                    }
                    Some(walk) => self.act(agent, walk),
                },
                Some(Leg::Before(portal)) => self.walk_before(agent, portal)?.and_then(|walk| self.act(agent, walk)),
                Some(Leg::Aside(spot)) => walk_to(&spot).and_then(|walk| self.act(agent, walk)),
                Some(Leg::Leaf(_, action)) => Some(self.reach_for(agent, &action)?),
                Some(Leg::Cross(portal)) => self.begin_crossing(agent, portal)?.map(Stage::Crossing),
            };
            if let (Some(stage), Some(journey)) = (begun, self.journeys.get_mut(&agent)) {
                journey.stage = stage;
            }
            return Ok(());
        }
    }

    fn act(&mut self, agent: NodeId, action: Action) -> Option<Stage> {
        self.environment_mut(agent)?.give(agent, action);
        Some(Stage::Acting)
    }

    pub(super) fn leg_done(&mut self, agent: NodeId) {
        if let Some(journey) = self.journeys.get_mut(&agent) {
            journey.goes_on(self.tick);
        }
    }

    /// The action of a leg has ended.
    pub(super) fn leg_ended(&mut self, agent: NodeId, outcome: Result<ChangeSet, CityError>) {
        match outcome {
            Ok(changes) => {
                self.changed(agent, changes);
                self.leg_done(agent);
            }
            Err(why) => self.leg_failed(agent, why),
        }
    }

    pub(super) fn changed(&mut self, agent: NodeId, changes: ChangeSet) {
        if let Some(journey) = self.journeys.get_mut(&agent) {
            journey.changes = std::mem::take(&mut journey.changes).then(changes);
        }
    }

    /// A leg cannot be done: if somebody is in the way, it is tried again later.
    pub(super) fn leg_failed(&mut self, agent: NodeId, why: CityError) {
        let later = self.tick + PATIENCE;
        let Some(journey) = self.journeys.get_mut(&agent) else { return };
        match journey.legs.front().copied() {
            // Others wait, or come past.
            Some(Leg::Aside(_)) => self.leg_done(agent),
            // Somebody's elbow does it.
            Some(Leg::Press(push)) => {
                self.push_button(agent, push.object);
                self.leg_done(agent);
            }
            Some(Leg::Act(_) | Leg::Leaf(..)) if why.is_at_door() && journey.handles_again(later) => {}
            Some(Leg::Act(_) | Leg::Leaf(..)) => self.end_journey(agent, Err(why)),
            _ if why.may_pass() && journey.tries_again(later) => {}
            _ => self.end_journey(agent, Err(why)),
        }
    }

    pub(super) fn end_journey(&mut self, agent: NodeId, outcome: Result<(), CityError>) {
        let Some(journey) = self.journeys.remove(&agent) else { return };
        if !journey.is_ordered {
            return;
        }
        let outcome = outcome.map(|()| journey.changes);
        self.endings.push(CityEnding { tick: self.tick, agent, action: journey.action, outcome });
    }

    /// The walk that brings somebody before a portal; none if it is there, or in a cabin. Before a lift one waits beside the
    /// opening.
    fn approach(&self, agent: NodeId, portal: PortalId) -> Result<Option<Action>, CityError> {
        let Some((region, plan)) = self.region_of(agent).zip(self.space().portal(portal)) else { return Ok(None) };
        let (Some(feet), Some(environment)) = (self.feet(agent), self.environment(region)) else { return Ok(None) };
        if self.lifts.get(region).is_some() {
            return Ok(None);
        }
        let here = Point2::from(feet.translation.vector.xy());
        let no_floor = || CityError::of_no_floor(self.region_label(region));
        let spot = self.spot_before(agent, plan, region).ok_or_else(no_floor)?;
        let stands = environment.posture(agent) == Some(Posture::Standing);
        Ok(if stands && distance(&spot, &here) < THERE { None } else { walk_to(&spot) })
    }
}

/// A walk to a point.
pub(super) fn walk_to(spot: &Point2<f32>) -> Option<Action> {
    Action::zero(Verb::Walk).at(f64::from(spot.x), f64::from(spot.y)).ok()
}

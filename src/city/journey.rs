//! Ways from region to region, as they are ordered: walks to portals, passages through them, and what is done at the end.

use std::collections::VecDeque;

use nalgebra::{Point2, Point3};
use serde::{Deserialize, Serialize};
use vc_graph::clock::{Span, Tick};
use vc_graph::hash::Digester;
use vc_graph::space::{Portal, PortalId, PortalKind, RegionId, Space};
use vc_graph::{Action, ChangeSet, NodeId, ObjectNames, Pose, Verb};

use super::measures::{FARTHEST, HANDLES, HELD, PATIENCE, TRIES};
use super::passage::Crossing;
use super::time::{CityEnding, is_done_at_a_door};
use super::{City, CityError};
use crate::Ending;

/// An agent's way to another region, and what it does there.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Journey {
    /// The action that it was given; none if it was sent to a region.
    pub(super) action: Option<Action>,
    /// Whether it was ordered: of somebody who is interrupted between two regions and gets through, or makes way, nothing
    /// more is told.
    pub(super) is_ordered: bool,
    /// The legs that are left; the first goes on, unless it waits.
    pub(super) legs: VecDeque<Leg>,
    pub(super) stage: Stage,
    /// How often somebody was in the way of the leg.
    tries: u32,
    #[serde(skip)]
    pub(super) changes: ChangeSet,
}

/// A part of a way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) enum Leg {
    /// To a portal, within a region.
    Approach(PortalId),
    /// To a portal, to look at its door from outside.
    Before(PortalId),
    /// Through it.
    Cross(PortalId),
    /// Its door is opened or shut from outside.
    Leaf(PortalId, Action),
    /// Out of the way of others.
    Aside(Point2<f32>),
    /// A button is pushed that calls a lift, while one waits for it.
    Press(Action),
    /// The action itself.
    Act(Action),
}

#[derive(Clone, Serialize, Deserialize)]
pub(super) enum Stage {
    /// The next leg has not begun; it is tried from a tick on.
    Waiting(Tick),
    /// An action in the region goes on.
    Acting,
    /// A hand is at the door of a portal until a tick.
    Handling(Tick),
    Crossing(Crossing),
}

impl Leg {
    fn portal(&self) -> Option<PortalId> {
        match self {
            Self::Approach(portal) | Self::Before(portal) | Self::Cross(portal) | Self::Leaf(portal, _) => {
                Some(*portal)
            }
            Self::Act(_) | Self::Press(_) | Self::Aside(_) => None,
        }
    }

    fn action_mut(&mut self) -> Option<&mut Action> {
        match self {
            Self::Act(action) | Self::Press(action) | Self::Leaf(_, action) => Some(action),
            _ => None,
        }
    }
}

impl Journey {
    /// A way that nobody was told to go.
    pub(super) fn unordered(leg: Leg, now: Tick) -> Self {
        let (legs, stage) = (VecDeque::from([leg]), Stage::Waiting(now));
        Self { action: None, is_ordered: false, legs, stage, tries: 0, changes: ChangeSet::default() }
    }

    /// The passage in which it is.
    pub(super) fn crossing(&self) -> Option<&Crossing> {
        match &self.stage {
            Stage::Crossing(crossing) => Some(crossing),
            _ => None,
        }
    }

    /// Whether a region has to be there for it.
    pub(super) fn needs(&self, region: RegionId) -> bool {
        self.crossing().is_some_and(|crossing| crossing.joins(region))
    }

    /// The portal that it goes through next.
    pub(super) fn next_portal(&self) -> Option<PortalId> {
        match (self.crossing(), self.legs.front()) {
            (None, Some(Leg::Cross(portal))) => Some(*portal),
            _ => None,
        }
    }

    /// Whether a saved journey can go on at a tick: its portals join regions of a plan, and its way is one.
    pub(super) fn is_sound(&self, space: &Space, now: Tick) -> bool {
        let is_near = |at: &Point2<f32>| at.coords.iter().all(|value| value.abs() <= FARTHEST);
        let is_leg = |leg: &Leg| match leg {
            Leg::Aside(spot) => is_near(spot),
            leg => leg.portal().is_none_or(|portal| space.portal(portal).is_some()),
        };
        self.legs.iter().all(is_leg) && self.crossing().is_none_or(|crossing| crossing.is_sound(space, now))
    }

    /// Takes up what a saved journey does not have itself: the names by which its action calls things, and its changes.
    pub(super) fn take_up(&mut self, called: Option<ObjectNames>, changes: ChangeSet) {
        self.changes = changes;
        for action in self.action.iter_mut().chain(self.legs.iter_mut().filter_map(Leg::action_mut)) {
            action.called = called.unwrap_or(action.called);
        }
    }

    pub(super) fn feed(&self, agent: NodeId, hash: &mut Digester) {
        hash.words([u64::from(agent.0), u64::from(self.tries), u64::from(self.is_ordered)]);
        self.legs.iter().for_each(|leg| _ = hash.text(&format!("{leg:?}")));
        match &self.stage {
            Stage::Waiting(until) => _ = hash.words([0, until.0]),
            Stage::Acting => _ = hash.word(1),
            Stage::Handling(until) => _ = hash.words([3, until.0]),
            Stage::Crossing(crossing) => crossing.feed(hash),
        }
    }

    /// Steps aside before it goes on; a portal is approached anew.
    pub(super) fn step_aside(&mut self, to: Point2<f32>, now: Tick) {
        if let Some(portal) = self.next_portal() {
            self.legs.push_front(Leg::Approach(portal));
        }
        self.legs.push_front(Leg::Aside(to));
        self.stage = Stage::Waiting(now);
    }

    /// Pushes a button before it goes on.
    pub(super) fn presses(&mut self, push: Action, now: Tick) {
        self.legs.push_front(Leg::Press(push));
        self.stage = Stage::Waiting(now);
    }

    /// A leg is done, and the next one can begin.
    pub(super) fn goes_on(&mut self, now: Tick) {
        self.legs.pop_front();
        (self.stage, self.tries) = (Stage::Waiting(now), 0);
    }

    /// Whether somebody was in the way of its leg before.
    pub(super) fn has_tried(&self) -> bool {
        self.tries > 0
    }

    /// Whether somebody has been in the way of its leg for ten seconds.
    pub(super) fn has_waited_long(&self) -> bool {
        u64::from(self.tries) * PATIENCE.0 >= HELD.0
    }

    /// Somebody was in the way: it is tried again from a tick on, if it has not been tried too often.
    pub(super) fn tries_again(&mut self, from: Tick) -> bool {
        (self.tries, self.stage) = (self.tries + 1, Stage::Waiting(from));
        self.tries <= TRIES
    }

    /// Somebody was in the doorway of a door: it is tried again from a tick on, a few times.
    pub(super) fn handles_again(&mut self, from: Tick) -> bool {
        self.tries_again(from) && self.tries <= HANDLES
    }
}

impl City {
    /// The region in which the object of a walk is, if it is another one than the agent's.
    pub(super) fn elsewhere(&self, agent: NodeId, action: &Action) -> Option<RegionId> {
        let goes = matches!(action.verb, Verb::Walk | Verb::Run | Verb::Find);
        let region = self.region_of(action.object.filter(|_| goes)?)?;
        (Some(region) != self.begins_at(agent).map(|(here, _)| here)).then_some(region)
    }

    /// Plans a way to another region, and an action there; whoever is between two regions gets through first.
    pub(super) fn set_out(
        &mut self,
        agent: NodeId,
        to: Option<RegionId>,
        action: Option<Action>,
    ) -> Result<(), CityError> {
        let (here, feet) = self.begins_at(agent).ok_or_else(|| CityError::NoSuchAgent(self.label(agent)))?;
        let way = to.filter(|to| *to != here).map_or_else(|| Ok(Vec::new()), |to| self.way(agent, (here, feet), to))?;
        let stands = !self.is_crossing(agent);
        if let Some(there) = self.active.get_mut(&here) {
            there.see_floor();
        }
        if way.first().is_some_and(|first| stands && !self.reaches(agent, *first)) {
            return Err(CityError::NoWayOut { agent: self.label(agent), region: self.region_label(here) });
        }
        let legs = self.legs_of(agent, way, action);
        let before = self.break_off(agent);
        // Whoever goes back from a portal has left it behind.
        let goes_on = before.as_ref().filter(|before| !before.crossing().is_some_and(|crossing| crossing.goes_back));
        let goes_on = goes_on.and_then(|before| before.legs.front().copied());
        let legs = goes_on.into_iter().chain(legs).collect();
        let stage = before.map_or(Stage::Waiting(self.tick), |before| before.stage);
        let (is_ordered, changes) = (to.is_some() || action.is_some(), ChangeSet::default());
        self.journeys.insert(agent, Journey { action, is_ordered, legs, stage, tries: 0, changes });
        Ok(())
    }

    /// The legs of a way and of an action at its end. A walk to a door of the region beyond ends before it.
    fn legs_of(&self, agent: NodeId, mut way: Vec<PortalId>, action: Option<Action>) -> Vec<Leg> {
        let handles = |action: Action| {
            let door = self.door_of(agent, &action).filter(|_| is_done_at_a_door(action.verb))?;
            Some(Leg::Leaf(door, action))
        };
        let last = match action {
            Some(action) if self.ends_before(&way, &action).is_some() => way.pop().map(Leg::Before),
            action => action.map(|action| handles(action).unwrap_or(Leg::Act(action))),
        };
        let legs = way.into_iter().flat_map(|portal| [Leg::Approach(portal), Leg::Cross(portal)]);
        legs.chain(last).collect()
    }

    /// Where an agent is, or will be once it is through the portal in which it is.
    pub(super) fn begins_at(&self, agent: NodeId) -> Option<(RegionId, Point3<f32>)> {
        match self.journeys.get(&agent).and_then(Journey::crossing) {
            Some(crossing) if crossing.is_on_its_way() => Some((crossing.into, Point3::origin())),
            _ => Some((self.region_of(agent)?, Point3::from(self.feet(agent)?.translation.vector))),
        }
    }

    fn way(&self, agent: NodeId, from: (RegionId, Point3<f32>), to: RegionId) -> Result<Vec<PortalId>, CityError> {
        let own = self.ways.get(&agent);
        let takes = |plan: &Portal| plan.kind != PortalKind::Window && own.is_none_or(|takes| takes(plan));
        let takes = |portal: PortalId| self.space().portal(portal).is_some_and(takes);
        let way = self.space().route(from, (to, Point3::origin()), takes);
        let way = way.ok_or_else(|| CityError::NoWay { from: self.region_label(from.0), to: self.region_label(to) })?;
        // A region that cannot be made is told now, not on the way.
        let beyond = way.iter().filter_map(|portal| self.space().portal(*portal)).flat_map(|plan| &plan.sides);
        let unknown = |region: &RegionId| !self.active.contains_key(region) && !self.asleep.contains_key(region);
        for region in beyond.map(|side| side.region).filter(unknown) {
            self.first(region)?;
        }
        Ok(way)
    }

    /// Whether an agent is between two regions.
    pub(super) fn is_crossing(&self, agent: NodeId) -> bool {
        self.journeys.get(&agent).is_some_and(|journey| journey.crossing().is_some())
    }

    /// Ends an action of an agent's region before time goes on. All that are to end in a tick do so in the order of the
    /// agents, in whatever order they were told to: each sees where those before have stopped.
    fn stop_acting(&mut self, agent: NodeId, is_told: bool) {
        self.stops.entry(agent).or_insert(is_told);
    }

    /// Ends the actions that are to end, and takes note of them; that of a leg is not told, as its journey tells more.
    pub(super) fn stop_those_told(&mut self) {
        let stops = std::mem::take(&mut self.stops);
        for agent in stops.keys() {
            let Some(environment) = self.environment_mut(*agent) else { continue };
            environment.interrupt(*agent);
            for ended in environment.step(Span(0)) {
                let Ending { tick, agent, action, outcome } = ended;
                let outcome = outcome.map_err(CityError::from);
                match stops.get(&agent) {
                    None => self.note(tick, agent, action, outcome),
                    Some(true) => self.endings.push(CityEnding { tick, agent, action: Some(action), outcome }),
                    Some(false) => {}
                }
            }
        }
    }

    /// Ends a journey where it is; returns it if the agent is between two regions.
    pub(super) fn break_off(&mut self, agent: NodeId) -> Option<Journey> {
        let Some(journey) = self.journeys.remove(&agent) else {
            self.stop_acting(agent, true);
            return None;
        };
        if let Stage::Acting = journey.stage {
            self.stop_acting(agent, false);
        }
        if journey.is_ordered {
            let why = CityError::Interrupted(self.label(agent));
            self.endings.push(CityEnding { tick: self.tick, agent, action: journey.action, outcome: Err(why) });
        }
        journey.crossing().is_some().then_some(journey)
    }

    pub(super) fn feet(&self, agent: NodeId) -> Option<Pose> {
        self.environment_of(agent)?.world().pose(agent)
    }
}

//! Time: all regions that are there go on together.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Point3, distance};
use vc_graph::clock::{Span, Tick};
use vc_graph::space::{Portal, RegionId};
use vc_graph::{Action, ChangeSet, Node, NodeId, ObjectRole, SceneGraph, State, Verb, rule};

use super::measures::{AT_THRESHOLD, LONGEST};
use super::record::Order;
use super::{City, CityError};
use crate::{ActionError, Ending, Environment, Interruption};

/// An action in a city that has ended, as [`City::step`] reports it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct CityEnding {
    /// The tick in which it ended.
    pub tick: Tick,
    /// The agent that did it.
    pub agent: NodeId,
    /// The action; none for a walk to a region.
    pub action: Option<Action>,
    /// The changes of the graphs of the regions that the agent was in, or the reason for which it was not done.
    pub outcome: Result<ChangeSet, CityError>,
}

impl CityEnding {
    /// Whether it is that of an agent's action, and not of one for which it was given another at once.
    fn is_last_of(&self, agent: NodeId) -> bool {
        let replaced = match &self.outcome {
            Err(CityError::Action(ActionError::Interrupted { why, .. })) => matches!(**why, Interruption::Replaced(_)),
            Err(CityError::Interrupted(_)) => true,
            _ => false,
        };
        self.agent == agent && !replaced
    }
}

pub(super) fn opens_or_shuts(verb: Verb) -> bool {
    matches!(verb, Verb::Open | Verb::Close)
}

/// Whether an action is done at a front door from either side.
pub(super) fn is_done_at_a_door(verb: Verb) -> bool {
    opens_or_shuts(verb) || matches!(verb, Verb::Touch | Verb::Push)
}

impl City {
    /// Gives an agent an action, which begins in the next tick of [`step`](Self::step), as [`Environment::give`](crate::Environment::give)
    /// does. A walk to something in another region leads there, one to the door of another region before it; from there it is
    /// opened and shut. An action that the rule refuses ends at once. Pushing a [button](vc_graph::space::Portal::buttons) calls
    /// the lift; its doors open and shut by themselves only.
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`], [`CityError::NoWay`], [`CityError::NoWayOut`], [`CityError::MovesByItself`].
    pub fn give(&mut self, agent: NodeId, action: Action) -> Result<(), CityError> {
        self.write_down(agent, Order::act(action));
        self.environment_with(agent)?;
        if let Some(door) = action.object.filter(|door| self.is_of_lift(*door) && opens_or_shuts(action.verb)) {
            return Err(CityError::MovesByItself(self.label(door)));
        }
        let region = self.elsewhere(agent, &action);
        let is_beyond = region.is_some() || (is_done_at_a_door(action.verb) && self.door_of(agent, &action).is_some());
        let refusals = match is_beyond {
            true => self.refusals_beyond(agent, &action)?,
            // Its environment says itself what it refuses, but a refused action breaks no journey off.
            false if self.journeys.contains_key(&agent) && !self.is_crossing(agent) => {
                rule::refusals(self.environment_with(agent)?.graph(), agent, &action)
            }
            false => Vec::new(),
        };
        if !refusals.is_empty() {
            let outcome = Err(ActionError::Refused(refusals).into());
            self.endings.push(CityEnding { tick: self.tick, agent, action: Some(action), outcome });
            return Ok(());
        }
        // One that is shut on nobody beyond has to wait for that one.
        let is_beyond = is_beyond || self.behind_door(agent, &action).is_some();
        if is_beyond || self.journeys.contains_key(&agent) || self.stops.contains_key(&agent) {
            return self.set_out(agent, region, Some(action));
        }
        if let Some(environment) = self.environment_mut(agent) {
            environment.give(agent, action);
        }
        Ok(())
    }

    /// Ends what an agent is doing, where it is; whoever is between two regions gets through first. Nothing happens for a node
    /// that is no [agent](Self::agents).
    pub fn interrupt(&mut self, agent: NodeId) {
        if !self.agents.contains(&agent) {
            return;
        }
        self.write_down(agent, Order::Stop);
        match self.is_crossing(agent) {
            true => drop(self.set_out(agent, None, None)),
            false => drop(self.break_off(agent)),
        }
    }

    /// Sends an agent to another region. It begins in the next tick of [`step`](Self::step).
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`], [`CityError::NoWay`], [`CityError::NoWayOut`].
    pub fn send(&mut self, agent: NodeId, region: RegionId) -> Result<(), CityError> {
        self.write_down(agent, Order::Go(region));
        self.environment_with(agent)?;
        self.set_out(agent, Some(region), None)
    }

    /// Lets an agent go to another region, to the end of its way. Others go on with what they were given.
    ///
    /// # Errors
    /// [`CityError`].
    pub fn go(&mut self, agent: NodeId, region: RegionId) -> Result<ChangeSet, CityError> {
        self.send(agent, region)?;
        self.finish(agent)
    }

    /// Lets an agent act, from the beginning of an action to its end; others go on with what they were given.
    ///
    /// # Errors
    /// [`CityError`], as [`Environment::set_action`](crate::Environment::set_action).
    pub fn set_action(&mut self, agent: NodeId, action: Action) -> Result<ChangeSet, CityError> {
        let known = self.endings.len();
        self.give(agent, action)?;
        let is_refused = |ending: &CityEnding| {
            ending.agent == agent && matches!(ending.outcome, Err(CityError::Action(ActionError::Refused(_))))
        };
        match (known..self.endings.len()).find(|at| is_refused(&self.endings[*at])) {
            // Its journey goes on.
            Some(at) => self.endings.remove(at).outcome,
            None => self.finish(agent),
        }
    }

    /// Lets time pass until an agent has ended what it was just given. Endings of before are left for [`step`](Self::step).
    fn finish(&mut self, agent: NodeId) -> Result<ChangeSet, CityError> {
        self.stop_those_told();
        let (end, known) = (self.tick + LONGEST, self.endings.len());
        let own = |city: &Self| (known..city.endings.len()).find(|at| city.endings[*at].is_last_of(agent));
        while self.tick < end && own(self).is_none() {
            self.advance(end, Some((agent, known)));
        }
        match own(self) {
            Some(at) => self.endings.remove(at).outcome,
            None => {
                self.interrupt(agent);
                Err(CityError::TooLong(self.label(agent)))
            }
        }
    }

    /// Lets a span of time pass in all regions. Returns the actions that have ended, in the order of their ticks.
    ///
    /// Costs what the regions cost that are there, however many there are in the plan.
    pub fn step(&mut self, span: Span) -> Vec<CityEnding> {
        let end = self.tick + span;
        self.stop_those_told();
        while self.tick < end {
            self.advance(end, None);
        }
        // An order that was replaced at once has ended without a tick.
        let untold: Vec<Ending> = self.active.values_mut().flat_map(|environment| environment.step(Span(0))).collect();
        for ending in untold {
            self.note(ending.tick, ending.agent, ending.action, ending.outcome.map_err(CityError::from));
        }
        std::mem::take(&mut self.endings)
    }

    /// Lets time pass until no agent has anything to do any more, at most a span; returns the actions that have ended.
    ///
    /// ```
    /// use virtualcity::City;
    /// use virtualcity::graph::clock::Span;
    /// let mut city = City::make("building/7", 1)?;
    /// let me = city.agents().next().ok_or("nobody")?;
    /// let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?.0;
    /// city.send(me, yard)?;
    /// assert!(city.is_busy(me));
    /// assert_eq!(city.step_until_idle(Span::from_seconds(300.0)).len(), 1);
    /// assert_eq!((city.region_of(me), city.is_busy(me)), (Some(yard), false));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn step_until_idle(&mut self, most: Span) -> Vec<CityEnding> {
        let end = self.tick + most;
        self.stop_those_told();
        while let Some(agent) = self.agents.iter().copied().find(|agent| self.is_busy(*agent))
            && self.tick < end
        {
            self.advance(end, Some((agent, self.endings.len())));
        }
        self.step(Span(0))
    }

    /// Lets time pass until a tick at most, or until something has to be looked at: a step of a journey, or the end of what
    /// an agent does, if its ending is the first after some that are known.
    fn advance(&mut self, end: Tick, whom: Option<(NodeId, usize)>) {
        self.stop_those_told();
        self.see_floors();
        self.journeys_begin();
        self.make_way_for_leaves();
        let has_ended = |(agent, known): (NodeId, usize)| self.endings[known..].iter().any(|e| e.is_last_of(agent));
        if whom.is_some_and(has_ended) {
            return;
        }
        let to = self.next_stop(end);
        let mut moving = self.moving();
        let mut ended = Vec::new();
        for environment in self.active.values_mut() {
            ended.extend(environment.step(Span(to.0.saturating_sub(environment.tick().0))));
        }
        self.tick = to;
        self.see_floors();
        ended.sort_by_key(|ending| (ending.tick, ending.agent));
        for ending in ended {
            self.note(ending.tick, ending.agent, ending.action, ending.outcome.map_err(CityError::from));
        }
        self.lifts_pass();
        self.journeys_pass();
        self.doors_pass();
        moving.extend(self.moving());
        let reached = self.things_pass(&moving);
        // At the end of a tick all has begun that can: it does not matter whether somebody asks for the next.
        self.journeys_begin();
        self.let_rest(&reached);
    }

    /// Sees where the floors are free while somebody looks for places on them: a city that is restored sees them anew, too.
    pub(super) fn see_floors(&mut self) {
        if !self.journeys.is_empty() {
            self.active.values_mut().for_each(Environment::see_floor);
        }
    }

    /// The end of the next tick in which something is touched, at most a tick: nothing comes to a portal before.
    fn next_stop(&mut self, end: Tick) -> Tick {
        if !self.journeys.is_empty() || !self.lifts.are_idle() {
            return self.tick + Span(1);
        }
        let live = self.active.values_mut().filter_map(Environment::next_live).min();
        live.map_or(end, |live| (live.max(self.tick) + Span(1)).min(end))
    }

    /// The regions in which something moves, or is about to.
    fn moving(&self) -> BTreeSet<RegionId> {
        let moves = |environment: &Environment| !environment.is_still();
        self.active.iter().filter(|(_, environment)| moves(environment)).map(|(region, _)| *region).collect()
    }

    /// An action in a region has ended: that of a journey, or one that was given.
    pub(super) fn note(&mut self, tick: Tick, agent: NodeId, action: Action, outcome: Result<ChangeSet, CityError>) {
        if outcome.is_ok() && action.verb == Verb::Push {
            self.push_button(agent, action.object);
        }
        if self.journeys.contains_key(&agent) {
            self.leg_ended(agent, outcome);
        } else {
            self.endings.push(CityEnding { tick, agent, action: Some(action), outcome });
        }
    }

    /// Calls the lift of a button.
    pub(super) fn push_button(&mut self, agent: NodeId, button: Option<NodeId>) {
        let space = self.space().clone();
        let portal = self.region_of(agent).zip(button).and_then(|(region, button)| space.called_with(region, button));
        portal.into_iter().for_each(|portal| self.lifts.call(portal));
    }

    /// Whether a node is a door that a lift moves.
    fn is_of_lift(&self, door: NodeId) -> bool {
        let there = self.region_of(door).and_then(|region| Some((region, self.active.get(&region)?)));
        there.is_some_and(|(region, environment)| self.lift_doors(region, environment.graph()).contains_key(&door))
    }

    fn lifts_pass(&mut self) {
        let open = self.lifts.standing_open().into_iter();
        let mut kept_open: BTreeSet<RegionId> =
            open.filter(|(cabin, stop)| self.keeps_open(*cabin, *stop)).map(|(cabin, _)| cabin).collect();
        let shut = self.lifts.about_to_shut(self.tick).into_iter();
        kept_open.extend(shut.filter(|(cabin, stop)| self.is_obstructed(*cabin, *stop)).map(|(cabin, _)| cabin));
        let changed = self.lifts.pass(self.tick, &kept_open);
        changed.into_iter().for_each(|cabin| self.move_lift_doors(cabin));
        self.riders_turn();
    }

    /// Opens and shuts the doors of a lift, or of all lifts at a region, where they are there to be seen.
    pub(super) fn move_lift_doors(&mut self, region: RegionId) {
        let portals = self.space().portals_of(region).filter_map(|portal| self.space().portal(portal));
        let beyond = portals.filter_map(|plan| Some(plan.across(region)?.region));
        let regions: BTreeSet<RegionId> = beyond.chain([region]).collect();
        for at in regions {
            self.set_bars(at);
            let Some(environment) = self.active.get(&at) else { continue };
            let doors = self.lift_doors(at, environment.graph());
            if let Some(environment) = self.active.get_mut(&at) {
                set_lift_doors(environment, &doors);
            }
        }
    }

    /// The doors of lifts in a region, and whether they are to be open: those of portals, and those of a cabin at its
    /// thresholds.
    pub(super) fn lift_doors(&self, region: RegionId, graph: &SceneGraph) -> BTreeMap<NodeId, bool> {
        let mut doors = BTreeMap::new();
        for plan in self.space().portals_of(region).filter_map(|portal| self.space().portal(portal)) {
            let Some((_, lift)) = self.lifts.at(plan) else { continue };
            for door in self.doors_of_lift((region, graph), plan) {
                *doors.entry(door).or_default() |= lift.is_open_at(plan.stop);
            }
        }
        doors
    }

    /// The doors in a region of the lift of a portal.
    pub(super) fn doors_of_lift(&self, (region, graph): (RegionId, &SceneGraph), plan: &Portal) -> Vec<NodeId> {
        let is_cabin = self.lifts.at(plan).is_some_and(|(cabin, _)| cabin == region);
        let own = plan.side(region).filter(|_| is_cabin);
        let own = own.into_iter().flat_map(|side| doors_at(graph, side.pose.translation.vector.into()));
        own.chain(plan.leaf.filter(|leaf| graph.node(*leaf).is_some())).collect()
    }
}

/// The doors of a scene that stand at a threshold.
fn doors_at(graph: &SceneGraph, threshold: Point3<f32>) -> Vec<NodeId> {
    let stands = |node: &&Node| node.position().is_some_and(|at| distance(&at, &threshold) < AT_THRESHOLD);
    graph.of_role(ObjectRole::Door).filter(stands).map(Node::id).collect()
}

/// Opens and shuts doors that are not as they are to be. One that jams stays as it is, and people pass it all the same.
pub(super) fn set_lift_doors(environment: &mut Environment, doors: &BTreeMap<NodeId, bool>) {
    let is_open = |environment: &Environment, door| environment.graph().node(door).is_some_and(|n| n.is(State::Open));
    for (door, open) in doors {
        if is_open(environment, *door) != *open {
            drop(environment.set_leaf(*door, *open));
        }
    }
}

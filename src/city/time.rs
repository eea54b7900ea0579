//! Time: all regions that are there go on together.

use vc_graph::clock::{Span, Tick};
use vc_graph::space::RegionId;
use vc_graph::{Action, ChangeSet, NodeId};

use super::{City, CityError};

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

/// An action that takes longer is left alone: an hour.
const LONGEST: Span = Span(3600 * 60);

impl City {
    /// Gives an agent an action, which begins in the next tick of [`step`](Self::step), as [`Environment::give`](crate::Environment::give)
    /// does. A walk to something in another region leads there.
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`], [`CityError::NoWay`].
    pub fn give(&mut self, agent: NodeId, action: Action) -> Result<(), CityError> {
        self.environment_with(agent)?;
        let region = self.elsewhere(agent, &action);
        if region.is_some() || self.is_crossing(agent) {
            return self.set_out(agent, region, Some(action));
        }
        self.break_off(agent);
        if let Some(environment) = self.environment_mut(agent) {
            environment.give(agent, action);
        }
        Ok(())
    }

    /// Ends what an agent is doing, where it is; whoever is between two regions gets through first.
    pub fn interrupt(&mut self, agent: NodeId) {
        match self.is_crossing(agent) {
            true => drop(self.set_out(agent, None, None)),
            false => {
                self.break_off(agent);
                if let Some(environment) = self.environment_mut(agent) {
                    environment.interrupt(agent);
                }
            }
        }
    }

    /// Sends an agent to another region. It begins in the next tick of [`step`](Self::step).
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`], [`CityError::NoWay`].
    pub fn send(&mut self, agent: NodeId, region: RegionId) -> Result<(), CityError> {
        self.environment_with(agent)?;
        self.set_out(agent, Some(region), None)
    }

    /// Lets an agent go to another region, to the end of its way. Others go on with what they were given.
    ///
    /// # Errors
    /// [`CityError`].
    pub fn go(&mut self, agent: NodeId, region: RegionId) -> Result<ChangeSet, CityError> {
        self.send(agent, region)?;
        self.forget_interrupted(agent);
        self.finish(agent)
    }

    /// Lets an agent act, from the beginning of an action to its end; others go on with what they were given.
    ///
    /// # Errors
    /// [`CityError`], as [`Environment::set_action`](crate::Environment::set_action).
    pub fn set_action(&mut self, agent: NodeId, action: Action) -> Result<ChangeSet, CityError> {
        self.give(agent, action)?;
        self.forget_interrupted(agent);
        self.finish(agent)
    }

    /// Whoever asks for an agent's next ending does not ask for that of the action before.
    fn forget_interrupted(&mut self, agent: NodeId) {
        self.endings.retain(|ending| ending.agent != agent);
    }

    fn finish(&mut self, agent: NodeId) -> Result<ChangeSet, CityError> {
        let end = self.tick + LONGEST;
        let is_open = |city: &Self| city.endings.iter().all(|ending| ending.agent != agent);
        while self.tick < end && is_open(self) {
            self.advance(end, true);
        }
        let at = self.endings.iter().position(|ending| ending.agent == agent);
        at.map_or_else(|| Ok(ChangeSet::default()), |at| self.endings.remove(at).outcome)
    }

    /// Lets a span of time pass in all regions. Returns the actions that have ended, in the order of their ticks.
    ///
    /// Costs what the regions cost that are there, however many there are in the plan.
    pub fn step(&mut self, span: Span) -> Vec<CityEnding> {
        let end = self.tick + span;
        while self.tick < end {
            self.advance(end, false);
        }
        std::mem::take(&mut self.endings)
    }

    /// Lets time pass until a tick at most, or until something has to be looked at: an ending if `each` is asked for, a
    /// step of a journey.
    fn advance(&mut self, end: Tick, each: bool) {
        let now = self.tick;
        self.journeys_begin();
        let in_transit = !self.journeys.is_empty() || self.lifts.values().any(|lift| !lift.is_idle());
        let to = if in_transit || (each && self.busy().count() > 1) { Tick(now.0 + 1) } else { end };
        let mut ended = Vec::new();
        let alone = self.busy().next().filter(|_| each && to == end);
        if let Some(environment) = alone.and_then(|region| self.active.get_mut(&region)) {
            ended.extend(environment.step_until_idle(Span(to.0 - now.0)));
        }
        let to = alone.and_then(|region| self.active.get(&region)).map_or(to, |environment| environment.tick());
        for environment in self.active.values_mut() {
            ended.extend(environment.step(Span(to.0 - environment.tick().0)));
        }
        self.tick = to;
        ended.sort_by_key(|ending| (ending.tick, ending.agent));
        for ending in ended {
            self.note(ending.tick, ending.agent, ending.action, ending.outcome.map_err(CityError::from));
        }
        self.lifts_pass();
        self.journeys_pass();
        self.let_rest();
    }

    /// The regions in which somebody acts or something moves.
    fn busy(&self) -> impl Iterator<Item = RegionId> + '_ {
        self.active.iter().filter(|(_, environment)| !environment.is_still()).map(|(region, _)| *region)
    }

    /// An action in a region has ended: that of a journey, or one that was given.
    fn note(&mut self, tick: Tick, agent: NodeId, action: Action, outcome: Result<ChangeSet, CityError>) {
        if self.journeys.contains_key(&agent) {
            self.leg_ended(agent, outcome);
        } else {
            self.endings.push(CityEnding { tick, agent, action: Some(action), outcome });
        }
    }

    fn lifts_pass(&mut self) {
        let now = self.tick;
        let mut changed = Vec::new();
        for (cabin, lift) in &mut self.lifts {
            let is_crossed = self.journeys.values().any(|journey| journey.crosses(self.source.space(), *cabin));
            let before = lift.state();
            lift.pass(now, is_crossed);
            if lift.state() != before {
                changed.push(*cabin);
            }
        }
        changed.into_iter().for_each(|cabin| self.move_lift_doors(cabin));
    }

    /// Opens and shuts the doors of a lift, or of all lifts at a region, where they are there to be seen.
    pub(super) fn move_lift_doors(&mut self, region: RegionId) {
        let space = self.space().clone();
        for plan in space.portals_of(region).filter_map(|portal| space.portal(portal)) {
            let lift = plan.sides.iter().find_map(|side| self.lifts.get(&side.region));
            let Some((leaf, lift)) = plan.leaf.zip(lift) else { continue };
            let open = lift.is_open_at(plan.stop);
            let there = self.region_of(leaf).filter(|region| self.active.contains_key(region));
            if let Some(environment) =
                there.filter(|_| self.is_open(leaf) != open).and_then(|at| self.active.get_mut(&at))
            {
                // A door that jams stays as it is, and people pass it all the same.
                drop(environment.set_leaf(leaf, open));
            }
        }
    }
}

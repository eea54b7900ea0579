//! Actions from their beginning to their end, one agent's or several agents' side by side.

use vc_graph::clock::{Span, Tick};
use vc_graph::{Action, ChangeSet, NodeId, rule};

use crate::environment::{ActionError, Environment};

/// An action that takes longer is interrupted: a day.
const LONGEST: Span = Span(24 * 3600 * 60);

impl Environment {
    /// Lets an agent act, from the beginning of an action to its end. The time that it takes passes for all: others go
    /// on with what they were [given](Self::give), machines run, food cools.
    ///
    /// 1. `rule::refusals`: whether the transition rule allows it.
    /// 2. The rule's effects become tasks, and these become motions by the world as it is: `Floor::standing_pose` and a
    ///    walk, `SpotSearch` and a hand that puts down, parts that open.
    /// 3. At the end of each motion bodies do it: `PhysicsWorld::teleport`, `PhysicsWorld::grab_with_load`, `PhysicsWorld::put`,
    ///    `PhysicsWorld::sit` ... Between these events the clock jumps, unless something is awake.
    /// 4. When all that was moved rests, `Relations::update_nodes` and `Relations::write_except` observe it.
    /// 5. The observed outcome is held against the rule's.
    ///
    /// The outcome is that of [`give`](Self::give) and [`step`](Self::step) until the action has ended. Takes some tenths
    /// of a millisecond in the middle; where bodies have to be pushed aside, some tens of milliseconds.
    ///
    /// ```no_run
    /// use virtualcity::{ActionError, Environment};
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    /// match home.set_action(me, format!("open fridge.{}", fridge.0).parse()?) {
    ///     Ok(changes) => println!("{} changes", changes.changes().len()),
    ///     Err(ActionError::Refused(reasons)) => println!("it may not: {}", reasons[0]),
    ///     Err(other) => println!("it cannot: {other}"),
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// The coordinate and the rotation of an action are its [`Aim`](vc_graph::Aim): a point of the world, metres, and a
    /// heading, degrees counter-clockwise from X; see the [guide](crate::guide::acting#actions-at-points).
    ///
    /// The changes are all those of the graph since the last action that was done.
    ///
    /// # Errors
    /// [`ActionError`]. After [`ActionError::Refused`], [`ActionError::Busy`] and [`ActionError::Twice`] nothing has
    /// changed; after another error the world is as it was when the action could not go on: the agent may have walked.
    /// One that takes longer than a day is interrupted after that day, unlike by [`give`](Self::give).
    /// [`can_do`](Self::can_do) tries an action on a copy.
    pub fn set_action(&mut self, agent: NodeId, action: Action) -> Result<ChangeSet, ActionError> {
        self.set_actions(&[(agent, action)]).pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }

    /// Lets several agents act side by side, until the last of them has ended; that takes as long as the longest of their
    /// actions. All begin in the same tick, in the order of the agents' numbers, whatever the order of the list; the
    /// outcomes come in the order of the list. Whoever is to do two things does neither.
    ///
    /// ```no_run
    /// use virtualcity::Environment;
    /// let mut home = Environment::make("apartment/42", 2)?;
    /// let agents = home.agents().to_vec();
    /// let fridge = home.graph().of_class("fridge")[0];
    /// let outcomes = home.set_actions(&[
    ///     (agents[1], "dance".parse()?),
    ///     (agents[0], format!("walk fridge.{}", fridge.0).parse()?),
    /// ]);
    /// for outcome in outcomes {
    ///     println!("{} changes", outcome?.changes().len());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_actions(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, ActionError>> {
        let (begun, agents) = self.begin_all(actions);
        self.finish(&agents, self.tick() + LONGEST);
        self.outcomes(actions, begun)
    }

    /// As [`set_actions`](Self::set_actions), with the same end bit for bit: `watch` is shown the environment
    /// [as it is seen](Self::moment) after each span of time, with poses, doors, limbs, relations and states as they are
    /// then, so that it can be observed and rendered, and at last as it is in the end.
    ///
    /// Walkers go at 1.2 m/s (3 m/s when they run), along a way that keeps clear of everything that stands on the floor;
    /// doors swing open before them and shut behind them. Hands go to what they take, put down, wipe or eat, and what
    /// they hold goes with them. Each time costs a copy of the environment, half a millisecond.
    ///
    /// ```no_run
    /// use virtualcity::Environment;
    /// use virtualcity::graph::clock::Span;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let fridge = home.graph().of_class("fridge")[0];
    /// let mut way = Vec::new();
    /// home.set_action_in_time(me, format!("walk fridge.{}", fridge.0).parse()?, Span(6), |now| {
    ///     way.extend(now.world().pose(me).map(|feet| feet.translation.vector));
    /// })?;
    /// println!("{} points, a tenth of a second apart", way.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_actions_in_time(
        &mut self,
        actions: &[(NodeId, Action)],
        every: Span,
        mut watch: impl FnMut(&Self),
    ) -> Vec<Result<ChangeSet, ActionError>> {
        let (begun, agents) = self.begin_all(actions);
        let end = self.tick() + LONGEST;
        while self.is_acting(&agents) {
            let next = (self.tick() + every.max(Span(1))).min(end);
            self.advance_while(next, |home| home.is_acting(&agents));
            if next == end {
                self.finish(&agents, end);
            }
            watch(&self.moment());
        }
        self.outcomes(actions, begun)
    }

    /// One agent's action in time; see [`set_actions_in_time`](Self::set_actions_in_time).
    ///
    /// # Errors
    /// As [`set_action`](Self::set_action).
    pub fn set_action_in_time(
        &mut self,
        agent: NodeId,
        action: Action,
        every: Span,
        watch: impl FnMut(&Self),
    ) -> Result<ChangeSet, ActionError> {
        let mut outcomes = self.set_actions_in_time(&[(agent, action)], every, watch);
        outcomes.pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }

    /// Gives agents what the rule allows them; returns which actions begin and which do not, and the agents that act.
    fn begin_all(&mut self, actions: &[(NodeId, Action)]) -> (Vec<Result<(), ActionError>>, Vec<NodeId>) {
        self.read_if_still();
        let twice = |agent| actions.iter().filter(|(a, _)| *a == agent).count() > 1;
        let begin = |(agent, action): &(NodeId, Action)| {
            if twice(*agent) {
                return Err(ActionError::Twice(self.graph.label(*agent)));
            }
            if self.controlled(*agent).is_some() {
                return Err(ActionError::Busy(self.graph.label(*agent)));
            }
            let refusals = rule::refusals(&self.graph, *agent, action);
            if refusals.is_empty() { Ok(()) } else { Err(ActionError::Refused(refusals)) }
        };
        let begun: Vec<Result<(), ActionError>> = actions.iter().map(begin).collect();
        let allowed: Vec<&(NodeId, Action)> =
            actions.iter().zip(&begun).filter(|(_, begun)| begun.is_ok()).map(|(act, _)| act).collect();
        allowed.iter().for_each(|(agent, action)| self.give(*agent, *action));
        (begun, allowed.into_iter().map(|(agent, _)| *agent).collect())
    }

    fn is_acting(&self, agents: &[NodeId]) -> bool {
        agents.iter().any(|agent| self.current_action(*agent).is_some())
    }

    /// Lets time pass until agents have ended what they do; what lasts until a tick is interrupted.
    fn finish(&mut self, agents: &[NodeId], end: Tick) {
        self.advance_while(end, |home| home.is_acting(agents));
        agents.iter().for_each(|agent| self.cancel(*agent));
    }

    /// The outcomes of actions that have begun and ended.
    fn outcomes(
        &mut self,
        actions: &[(NodeId, Action)],
        begun: Vec<Result<(), ActionError>>,
    ) -> Vec<Result<ChangeSet, ActionError>> {
        let mut ended = |agent: NodeId| {
            let at = self.clock.endings.iter().rposition(|ending| ending.agent == agent);
            at.map_or_else(|| Ok(ChangeSet::default()), |at| self.clock.endings.remove(at).outcome)
        };
        let all = actions.iter().zip(begun);
        all.map(|((agent, _), begun)| begun.and_then(|()| ended(*agent))).collect()
    }
}

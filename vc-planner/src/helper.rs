//! A policy that helps another agent whose goal it has to infer: Watch-And-Help's challenge.

use vc_graph::{Action, Event, Goal, NodeId, Observation, SceneGraph, Scope, Verb, rule};
use vc_tasks::WorldError;

use crate::policy::{EpisodeStart, Policy, RefusalResponse};
use crate::shared::shared;
use crate::trip::{Promise, Trip};
use crate::{Agent, Belief, Decision, GoalRecognizer, Learned, Planner, Prior, SearchLimits};

/// It helps with a goal when it is likelier than this: than all others together.
const SURE: f64 = 0.5;

/// A policy that watches another agent, infers which of some goals it pursues, and does
/// what that one is not about to do itself.
///
/// It makes no use of the task of its episode. Until one goal is likely enough it watches, going
/// after the other where it sees only its room; where nothing is left for it, it decides
/// [`Decision::Done`]: it waits.
///
/// The other's actions come through [`Policy::saw`]; [`run_together`](crate::run_together)
/// reports those that happen in view.
#[derive(Debug, Clone)]
pub struct Helper {
    goals: Vec<Goal>,
    scope: Scope,
    recognizer: GoalRecognizer,
    planner: Planner,
    me: NodeId,
    agent: Option<Agent>,
    other: Option<NodeId>,
    /// Where the other was last seen to go.
    trail: Option<NodeId>,
    /// The goal it helps with.
    helping: Option<usize>,
}

impl Helper {
    /// A helper that knows the home and sees all of it.
    pub fn oracle(goals: Vec<Goal>) -> Self {
        Self::with(goals, Scope::Whole)
    }

    /// A helper that knows the plan of the home and sees the room it is in.
    pub fn in_known_home(goals: Vec<Goal>) -> Self {
        Self::with(goals, Scope::Room)
    }

    fn with(goals: Vec<Goal>, scope: Scope) -> Self {
        let recognizer = GoalRecognizer::new(goals.clone());
        let planner = Planner::with_limits(SearchLimits::FIRST_ANSWER);
        Self { goals, scope, recognizer, planner, me: NodeId(0), agent: None, other: None, trail: None, helping: None }
    }

    /// The goals with how likely they are; likeliest first.
    pub fn likely(&self) -> Vec<(&Goal, f64)> {
        self.recognizer.likely()
    }

    /// The believed scene, with the things that it carries itself where it brings them, or else within
    /// reach: they are not in the other's way.
    fn promised(&self) -> Option<SceneGraph> {
        let agent = self.agent.as_ref()?;
        let mut graph = agent.belief().graph().clone();
        let mut edit = graph.edit();
        let held: Vec<NodeId> = edit.graph().held(self.me).collect();
        for id in held {
            let promise = agent.promises().iter().find(|(item, _)| *item == id);
            // A promise that the edit refuses is not counted on.
            let _ = match promise {
                Some((_, place)) => edit.place(id, *place),
                None => edit.detach(id),
            };
        }
        edit.commit();
        Some(graph)
    }

    /// Puts down what it took by mistake, as the other may want it; else goes to where it can
    /// see what the other does.
    fn watch_on(&self) -> Decision {
        let Some(belief) = self.agent.as_ref().map(Agent::belief) else { return Decision::Done };
        let drop = belief.graph().held(self.me).next().map(|id| Action::one(Verb::Drop, id));
        let action = drop.or_else(|| self.room_to_watch(belief).map(|room| Action::one(Verb::Walk, room)));
        action.map_or(Decision::Done, |action| Decision::Act(action, crate::Plan::default()))
    }

    /// With nobody in view, where the other has gone, or else a room not looked at.
    fn room_to_watch(&self, belief: &Belief) -> Option<NodeId> {
        let graph = belief.graph();
        if self.scope == Scope::Whole || graph.agents().iter().any(|&id| id != self.me && belief.sees(id)) {
            return None;
        }
        let elsewhere = |room: &NodeId| Some(*room) != graph.room_of(self.me);
        let unseen = || belief.possible_places().filter_map(|place| graph.room_of(place.at)).find(elsewhere);
        self.trail.filter(elsewhere).or_else(unseen)
    }

    /// The deliveries of the other's next trip, if it pursues a goal, as far as they are about things that it
    /// has in its hands or before its eyes. A thing that it would have to look for first is
    /// sooner brought by an agent that knows where it is.
    fn foresee(&mut self, goal: &Goal) -> Vec<Promise> {
        let (Some(graph), Some(other)) = (self.promised(), self.other) else { return Vec::new() };
        let plan = self.planner.outline(&graph, other, goal, &[]).unwrap_or_default();
        let held: Vec<NodeId> = graph.held(other).collect();
        let here = graph.room_of(other);
        let sees = |id: NodeId| graph.room_of(id) == here && graph.hidden_in(id).is_none();
        let mut trip = Trip::new(&graph, other, &plan).promises;
        let mine = self.agent.as_ref().map_or_else(Vec::new, |a| a.belief().graph().held(self.me).collect());
        trip.retain(|(item, _)| !mine.contains(item) && (held.contains(item) || sees(*item)));
        trip
    }
}

impl Policy for Helper {
    fn name(&self) -> &str {
        "helper"
    }

    fn scope(&self) -> Scope {
        self.scope
    }

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        let EpisodeStart { scene, agent, seed, .. } = *start;
        let idle = Goal::And(Vec::new());
        self.agent = Some(match self.scope {
            Scope::Whole => Agent::oracle(scene, agent, idle),
            _ => Agent::with_prior(scene, agent, idle, seed.0, Prior::Kept),
        });
        self.recognizer = GoalRecognizer::new(self.goals.clone());
        (self.me, self.other, self.trail, self.helping) = (agent, None, None, None);
    }

    fn see(&mut self, seen: &Observation) -> Learned {
        self.agent.as_mut().map_or_else(Learned::default, |agent| agent.see(seen))
    }

    fn saw(&mut self, event: &Event) {
        let Some(before) = self.promised() else { return };
        self.other = Some(event.agent);
        let mut after = before.clone();
        if rule::step(&mut after, event.agent, &event.action).is_ok() {
            self.recognizer.watch(&before, &after, event);
            self.trail = after.room_of(event.agent);
        }
    }

    fn decide(&mut self) -> Decision {
        let likely = self.recognizer.likely();
        let Some(goal) = likely.first().filter(|(_, chance)| *chance > SURE).map(|(goal, _)| (*goal).clone()) else {
            return self.watch_on();
        };
        let number = self.goals.iter().position(|g| *g == goal);
        let promised = self.foresee(&goal);
        let Some(agent) = &mut self.agent else { return Decision::Done };
        if self.helping != number {
            self.helping = number;
            let goal = goal.expanded(agent.belief().graph().vocabulary());
            agent.pursue(shared(&goal));
        }
        agent.count_on(promised);
        match agent.decide() {
            act @ Decision::Act(..) => act,
            _ => Decision::Done,
        }
    }

    fn did(&mut self, action: &Action) {
        if let Some(agent) = &mut self.agent {
            agent.did(action);
        }
    }

    fn refused(&mut self, action: &Action, _: &WorldError) -> RefusalResponse {
        if let Some(agent) = &mut self.agent {
            agent.refused(action);
        }
        RefusalResponse::GoOn
    }

    fn belief(&self) -> Option<&Belief> {
        self.agent.as_ref().map(Agent::belief)
    }
}

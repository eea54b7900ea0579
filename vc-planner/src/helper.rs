//! Somebody who helps another whose goal it has to infer: Watch-And-Help's challenge.

use vc_graph::{Action, Event, Goal, NodeId, Observation, SceneGraph, Scope, Verb, rule};
use vc_tasks::{Outcome, Task, World, WorldError};

use crate::episode::{explained, refusal};
use crate::policy::{EpisodeStart, Policy, RefusalResponse};
use crate::shared::shared;
use crate::trip::{Promise, Trip};
use crate::{Agent, Belief, Decision, GoalRecognizer, Learned, Planner, Prior, SearchLimits, TeamEpisode, Unreachable};

/// It helps with a goal when it is likelier than this: than all others together.
const SURE: f64 = 0.5;

/// A policy that watches another agent, infers which of some goals it pursues, and does
/// what that one is not about to do itself.
///
/// It makes no use of the task it is told. Until one goal is likely enough it watches, going
/// after the other where it sees only its room; where nothing is left for it, it decides
/// [`Decision::Done`]: it waits.
///
/// What it sees of the other's deeds comes through [`Policy::saw`]; [`run_together`]
/// tells those that happen in view.
#[derive(Debug, Clone)]
pub struct Helper {
    goals: Vec<Goal>,
    scope: Scope,
    watcher: GoalRecognizer,
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

    /// A helper that has just moved in and sees the room it is in.
    pub fn in_known_home(goals: Vec<Goal>) -> Self {
        Self::with(goals, Scope::Room)
    }

    fn with(goals: Vec<Goal>, scope: Scope) -> Self {
        let watcher = GoalRecognizer::new(goals.clone());
        let planner = Planner::with_limits(SearchLimits::FIRST_ANSWER);
        Self { goals, scope, watcher, planner, me: NodeId(0), agent: None, other: None, trail: None, helping: None }
    }

    /// The goals with how likely they are; likeliest first.
    pub fn likely(&self) -> Vec<(&Goal, f64)> {
        self.watcher.likely()
    }

    /// What it believes, with what it carries itself where it brings it, or else within
    /// reach: it is not in the other's way.
    fn promised(&self) -> Option<SceneGraph> {
        let agent = self.agent.as_ref()?;
        let mut graph = agent.belief().graph().clone();
        let mut edit = graph.edit();
        let held: Vec<NodeId> = edit.graph().held(self.me).collect();
        for id in held {
            let promise = agent.promises().iter().find(|(item, _)| *item == id);
            // What cannot be imagined is not counted on.
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

    /// What the other will bring where on its next trip, if it pursues a goal: of what it
    /// has in its hands or before its eyes. What it would have to look for first is
    /// sooner brought by who knows where it is.
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

    fn begin(&mut self, brief: &EpisodeStart<'_>) {
        let EpisodeStart { scene, agent, seed, .. } = *brief;
        let idle = Goal::And(Vec::new());
        self.agent = Some(match self.scope {
            Scope::Whole => Agent::oracle(scene, agent, idle),
            _ => Agent::with_prior(scene, agent, idle, seed.0, Prior::Kept),
        });
        self.watcher = GoalRecognizer::new(self.goals.clone());
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
            self.watcher.watch(&before, &after, event);
            self.trail = after.room_of(event.agent);
        }
    }

    fn decide(&mut self) -> Decision {
        let likely = self.watcher.likely();
        let Some(goal) = likely.first().filter(|(_, chance)| *chance > SURE).map(|(goal, _)| (*goal).clone()) else {
            return self.watch_on();
        };
        let number = self.goals.iter().position(|g| *g == goal);
        let promised = self.foresee(&goal);
        let Some(agent) = &mut self.agent else { return Decision::Done };
        if self.helping != number {
            self.helping = number;
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

/// After so many rounds in which nobody does anything it is over.
const IDLE: usize = 4;

/// Lets several policies act in one world, in rounds, each for an agent of its own, until
/// the task's goal holds for the first of them, nobody does anything any more, or the
/// step limit is reached. Each agent sees what the agents in its view do. Without a policy, or if the goal has a name that
/// stands for nothing or somebody is no agent of the scene, the task is lost at once.
pub fn run_together(
    policies: &mut [(NodeId, &mut dyn Policy)],
    task: &Task,
    world: &mut dyn World,
    seed: vc_graph::Seed,
) -> TeamEpisode {
    let ids: Vec<NodeId> = policies.iter().map(|(id, _)| *id).collect();
    if let Some(lost) = TeamEpisode::hopeless(&ids, task, world.graph()) {
        return lost;
    }
    for (agent, policy) in policies.iter_mut() {
        policy.begin(&EpisodeStart { scene: world.graph(), agent: *agent, task, seed });
    }
    let mut progress = task.begin(world, policies[0].0);
    let (mut rounds, mut actions, mut idle, mut reasons) = (0, 0, 0, Vec::new());
    while rounds < task.step_limit && idle < IDLE && !progress.holds(world) {
        reasons.clear();
        let mut done = 0;
        for index in 0..policies.len() {
            match turn(policies, index, world) {
                Turn::Done => done += 1,
                Turn::Waited => {}
                Turn::GaveUp(why) => reasons.push(explained(&why, task, world.graph())),
                Turn::Refused(why) => reasons.push(why),
            }
            progress.note(world);
        }
        (rounds, actions) = (rounds + 1, actions + done);
        idle = if done == 0 { idle + 1 } else { 0 };
    }
    let lost = if rounds < task.step_limit { Outcome::Lost } else { Outcome::TimedOut };
    let outcome = if progress.holds(world) { Outcome::Won } else { lost };
    TeamEpisode::ended(outcome, (rounds, actions), progress.score(world), reasons)
}

/// The result of a policy's turn.
enum Turn {
    Done,
    Waited,
    GaveUp(Unreachable),
    Refused(String),
}

/// One policy looks, decides and acts; the others see it, if they can.
fn turn(policies: &mut [(NodeId, &mut dyn Policy)], index: usize, world: &mut dyn World) -> Turn {
    let (agent, policy) = &mut policies[index];
    let agent = *agent;
    policy.see(&world.graph().observe(agent, policy.scope()));
    let action = match policy.decide() {
        Decision::Act(action, _) => action,
        Decision::Done => return Turn::Waited,
        Decision::GiveUp(why) => return Turn::GaveUp(why),
    };
    let words = action.describe(world.graph()).to_string();
    // Who goes out of view has been seen going.
    let witnesses = |world: &dyn World, policies: &[(NodeId, &mut dyn Policy)]| -> Vec<bool> {
        policies.iter().map(|(id, p)| *id != agent && world.graph().observe(*id, p.scope()).sees(agent)).collect()
    };
    let before = witnesses(world, policies);
    match world.step(agent, &action) {
        Ok(_) => {
            policies[index].1.did(&action);
            let after = witnesses(world, policies);
            for (i, (_, other)) in policies.iter_mut().enumerate().filter(|(i, _)| before[*i] || after[*i]) {
                debug_assert_ne!(i, index);
                other.saw(&Event { agent, action });
            }
            Turn::Done
        }
        Err(why) => {
            policies[index].1.refused(&action, &why);
            Turn::Refused(refusal(&words, &why))
        }
    }
}

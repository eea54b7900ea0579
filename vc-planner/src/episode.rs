//! Episodes: an agent in a simulated scene, from the first look to the verdict.

use serde::{Deserialize, Serialize};
use vc_graph::goal::Situation;
use vc_graph::{Action, Digest, Label, NodeId, Place, Refusal, Scope, Simulator};
use vc_tasks::{Outcome, Task};

use crate::{Agent, Decision};

/// One step of an episode, as it is recorded.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Step {
    /// Number of the step, from one.
    pub step: usize,
    /// The room the agent was in.
    pub room: Option<Label>,
    /// What it saw for the first time.
    pub found: Vec<Label>,
    /// Things it no longer believes where it guessed them.
    pub disproved: Vec<Label>,
    /// Where it guessed the missing things that the goal is about.
    pub believed: Vec<String>,
    /// Among how many places it guessed.
    pub places: usize,
    /// What it meant to do, the first of which it did.
    pub plan: Vec<String>,
    /// What it did.
    pub action: Action,
    /// The same, with the classes of the things.
    pub described: String,
    /// Digest of the scene after it.
    pub digest: String,
}

/// How an episode went.
#[derive(Debug, Clone, PartialEq)]
pub struct Episode {
    /// How it ended.
    pub outcome: Outcome,
    /// How much of the goal holds at the end, 0 to 1.
    pub score: f64,
    /// How many actions were done.
    pub steps: usize,
    /// Why the agent gave up or was stopped, if so.
    pub reason: Option<String>,
    /// Digest of the scene at the end.
    pub digest: Digest,
}

/// The last line of a recorded episode.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// How it ended.
    pub outcome: Outcome,
    /// How much of the goal holds, 0 to 1.
    pub score: f64,
    /// How many actions were done.
    pub steps: usize,
    /// Why the agent gave up or was stopped.
    pub reason: Option<String>,
}

impl Episode {
    /// What a record ends with.
    pub fn summary(&self) -> Summary {
        let Self { outcome, score, steps, reason, .. } = self;
        Summary { outcome: *outcome, score: *score, steps: *steps, reason: reason.clone() }
    }
}

/// Lets an agent pursue a task until it is done, gives up or runs out of steps,
/// telling `watch` each step. The verdict is by the true scene, not by what the
/// agent believes.
///
/// A resident sees everything each step, a newcomer its room: pass the [`Scope`].
pub fn run_episode(
    world: &mut Simulator,
    id: NodeId,
    agent: &mut Agent,
    task: &Task,
    scope: Scope,
    mut watch: impl FnMut(&Step),
) -> Episode {
    let mut done = 0;
    let (outcome, reason) = loop {
        let seen = world.graph().observe(id, scope);
        let learned = agent.see(&seen);
        let (action, plan) = match agent.decide() {
            Decision::Act(..) if done == task.step_limit => {
                break (Outcome::TimedOut, Some("step limit reached".into()));
            }
            Decision::Act(action, plan) => (action, plan),
            Decision::Done => break (Outcome::Lost, None),
            Decision::GiveUp(why) => break (Outcome::Lost, Some(why.to_string())),
        };
        let label = |&id: &NodeId| world.graph().label(id);
        let mut step = Step {
            step: done + 1,
            room: seen.room().as_ref().map(label),
            found: learned.found.iter().map(label).collect(),
            disproved: learned.disproved.iter().map(label).collect(),
            believed: agent.guesses().iter().map(|&(id, place)| guess(world, id, place)).collect(),
            places: agent.belief().possible_places().count(),
            plan: plan.actions.iter().map(|a| a.describe(world.graph()).to_string()).collect(),
            action,
            described: action.describe(world.graph()).to_string(),
            digest: String::new(),
        };
        if let Err(refusals) = world.step(id, &action) {
            break (Outcome::Aborted, Some(refused(&step.described, &refusals)));
        }
        agent.did(&action);
        step.digest = world.graph().digest().to_string();
        watch(&step);
        done += 1;
    };
    end(world, id, task, outcome, done, reason)
}

fn guess(world: &Simulator, id: NodeId, place: Option<Place>) -> String {
    let label = |id| world.graph().label(id);
    match place {
        Some(place) => format!("{} {} {}", label(id), place.relation, label(place.at)),
        None => format!("{} in some room", label(id)),
    }
}

fn refused(action: &str, refusals: &[Refusal]) -> String {
    let reasons: Vec<String> = refusals.iter().map(Refusal::to_string).collect();
    format!("`{action}` was refused: {}", reasons.join("; "))
}

/// The verdict: an agent that stopped has won if the goal holds.
fn end(world: &Simulator, id: NodeId, task: &Task, outcome: Outcome, steps: usize, reason: Option<String>) -> Episode {
    let now = Situation::new(world.graph(), id, world.history());
    let holds = task.goal.holds(&now);
    let outcome = if holds { Outcome::Won } else { outcome };
    let reason = if holds { None } else { reason };
    Episode { outcome, score: task.goal.score(&now), steps, reason, digest: world.graph().digest() }
}

//! Episodes: a policy in a world, from the first look to the verdict.

use serde::{Deserialize, Serialize};
use vc_graph::{Action, Digest, NodeId, Observation, Place, SceneGraph, Seed};
use vc_tasks::{GoalProgress, Outcome, Task, World};

use crate::observation::as_json;
use crate::policy::{EpisodeStart, Policy, RefusalResponse};
use crate::reason::{explained, hopeless, loss, refusal};
use crate::{Decision, Learned, Plan};

/// One step of an episode, as it is recorded.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Step {
    /// Number of the step, from one.
    pub step: usize,
    /// The room the agent was in.
    pub room: Option<String>,
    /// The number of things that the agent saw.
    pub seen: usize,
    /// Digest of the observation.
    pub sight: String,
    /// The observation before the step, if the [`EpisodeOptions`] keep it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub observation: Option<serde_json::Value>,
    /// Things that the agent saw for the first time.
    pub found: Vec<String>,
    /// Things that the agent no longer believes where it guessed them.
    pub disproved: Vec<String>,
    /// The guessed places of the missing things that the goal is about.
    pub believed: Vec<String>,
    /// The number of places among which the agent guessed.
    pub places: usize,
    /// Digest of the belief, if the policy has one.
    pub belief: Option<String>,
    /// The planned actions, the first of which is that of the step.
    pub plan: Vec<String>,
    /// The action.
    pub action: Action,
    /// The same, with the classes of the things.
    pub described: String,
    /// The reason for which the action was refused, if it was; then nothing has changed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refused: Option<String>,
    /// Digest of the scene after the action.
    pub digest: String,
}

/// How an episode went.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{PlannerPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut world = Simulator::new(scene.build());
/// let task = Task::new("fetch", "Holds(apple)".parse()?);
/// let episode = run_episode(&mut PlannerPolicy::oracle(), &task, &mut world);
/// assert_eq!((episode.outcome, episode.steps), (Outcome::Won, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Episode {
    /// How it ended.
    pub outcome: Outcome,
    /// How much of the goal holds at the end, 0 to 1.
    pub score: f64,
    /// How many actions were done or tried.
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
    /// How many actions were done or tried.
    pub steps: usize,
    /// Why the agent gave up or was stopped.
    pub reason: Option<String>,
}

impl Episode {
    /// The last line of a record.
    pub fn summary(&self) -> Summary {
        self.into()
    }
}

impl From<&Episode> for Summary {
    fn from(episode: &Episode) -> Self {
        let Episode { outcome, score, steps, reason, .. } = episode;
        Self { outcome: *outcome, score: *score, steps: *steps, reason: reason.clone() }
    }
}

/// Lets a policy do a task in a world as its first agent, with seed 0. See [`EpisodeOptions`] for
/// more.
///
/// The verdict and the score are those of [`GoalProgress`]: of the true scene at the end, and for a goal with words of
/// time of all that happened in the episode.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{PlannerPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("egg"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let scene = scene.build();
/// let run = |goal: &str| -> Result<_, vc_graph::goal::GoalError> {
///     let task = Task::new("in time", goal.parse()?);
///     Ok(run_episode(&mut PlannerPolicy::oracle(), &task, &mut Simulator::new(scene.clone())))
/// };
/// let aired = run("eventually Open(fridge) & Closed(fridge)")?;
/// assert_eq!((aired.outcome, aired.steps), (Outcome::Won, 3)); // walk, open, close
/// let shut = run("always Closed(fridge) & Holds(egg)")?;
/// assert_eq!(shut.outcome, Outcome::Lost);
/// println!("{}", shut.reason.unwrap_or_default()); // opening the fridge breaks `always Closed(fridge)`
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run_episode(policy: &mut dyn Policy, task: &Task, world: &mut dyn World) -> Episode {
    EpisodeOptions::default().episode(policy, task, world, &mut |_| {})
}

/// How an episode is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EpisodeOptions {
    /// The agent that acts; the first agent of the scene, if none is named.
    pub agent: Option<NodeId>,
    /// Where the policy's randomness comes from.
    pub seed: Seed,
    /// Whether each step keeps all that was seen, not only its digest: many times as much,
    /// in the form of [`Transition::observation`](crate::Transition::observation).
    pub keeps_observations: bool,
}

impl EpisodeOptions {
    /// A run with a seed.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator};
    /// use vc_planner::{EpisodeOptions, RandomPolicy};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let mut task = Task::new("fetch", "Holds(apple)".parse()?);
    /// task.step_limit = 3;
    /// let mut policy = RandomPolicy::default();
    /// let episode = EpisodeOptions::seeded(7).episode(&mut policy, &task, &mut world, &mut |_step| {});
    /// assert!(episode.steps <= 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn seeded(seed: u64) -> Self {
        Self { seed: Seed(seed), ..Self::default() }
    }

    /// Lets a policy pursue a task until it is done, gives up or runs out of steps,
    /// telling `watch` each step. The verdict is by the true scene, not by what the
    /// policy believes, and for a goal with words of time by the trace of true scenes: [`GoalProgress`]. An episode is
    /// lost at once in a scene without an agent, if [`agent`](Self::agent) is none, and for a task whose goal has a
    /// name that stands for nothing ([`Task::lost`]).
    pub fn episode(
        &self,
        policy: &mut dyn Policy,
        task: &Task,
        world: &mut dyn World,
        watch: &mut dyn FnMut(&Step),
    ) -> Episode {
        let lost = |reason: String| {
            let (reason, digest) = (Some(reason), world.graph().digest());
            Episode { outcome: Outcome::Lost, score: 0.0, steps: 0, reason, digest }
        };
        let Some(agent) = self.agent.or_else(|| world.graph().agents().first().copied()) else {
            return lost("the scene has no agent".into());
        };
        if let Some(why) = hopeless(&[agent], task, world.graph()) {
            return lost(why);
        }
        policy.begin(&EpisodeStart { scene: world.graph(), agent, task, seed: self.seed });
        let (progress, keeps_observations) = (task.begin(world, agent), self.keeps_observations);
        let mut running = Running { agent, task, world, progress, done: 0, refused: None, keeps_observations };
        let (outcome, reason) = loop {
            if let Some(end) = running.step(policy, watch) {
                break end;
            }
        };
        running.end(outcome, reason)
    }
}

/// How an episode ended, and why.
type End = (Outcome, Option<String>);

struct Running<'a> {
    agent: NodeId,
    task: &'a Task,
    world: &'a mut dyn World,
    progress: GoalProgress,
    done: usize,
    /// The last action that was refused and has not been done since, and why.
    refused: Option<(Action, String)>,
    keeps_observations: bool,
}

impl Running<'_> {
    fn step(&mut self, policy: &mut dyn Policy, watch: &mut dyn FnMut(&Step)) -> Option<End> {
        if !policy.knows_when_to_stop() && self.holds() {
            return Some((Outcome::Won, None));
        }
        let seen = self.world.graph().observe(self.agent, policy.scope());
        let learned = policy.see(&seen);
        let (action, plan) = match policy.decide() {
            Decision::Act(..) if self.done >= self.task.step_limit => {
                return Some((Outcome::TimedOut, None));
            }
            Decision::Act(action, plan) => (action, plan),
            Decision::Done => return Some((Outcome::Lost, None)),
            Decision::GiveUp(why) => {
                return Some((Outcome::Lost, Some(explained(&why, self.task, self.world.graph()))));
            }
        };
        let mut step = describe(self.world.graph(), policy, &seen, &learned, action, &plan);
        step.observation = self.keeps_observations.then(|| as_json(&seen));
        // The scene's nodes are shared with what is seen: letting go saves a copy.
        drop(seen);
        self.done += 1;
        step.step = self.done;
        let end = match self.world.step(self.agent, &action) {
            Ok(_) => {
                self.refused.take_if(|(refused, _)| *refused == action);
                self.progress.note(self.world);
                policy.did(&action);
                None
            }
            Err(why) => {
                step.refused = Some(why.to_string());
                self.refused = Some((action, refusal(&step.described, &why)));
                let stop = policy.refused(&action, &why) == RefusalResponse::Stop;
                stop.then_some((Outcome::Aborted, None))
            }
        };
        step.digest = self.world.graph().digest().to_string();
        watch(&step);
        end
    }

    fn holds(&mut self) -> bool {
        self.progress.holds(self.world)
    }

    /// The verdict: an agent that stopped has won if the goal holds. A refusal is a reason, too.
    fn end(mut self, outcome: Outcome, reason: Option<String>) -> Episode {
        let outcome = if self.holds() { Outcome::Won } else { outcome };
        let stopped = reason.into_iter().chain(self.refused.take().map(|(_, why)| why)).collect();
        let reason = loss(outcome, stopped, &mut self.progress, self.world);
        let (score, digest) = (self.progress.score(self.world), self.world.graph().digest());
        Episode { outcome, score, steps: self.done, reason, digest }
    }
}

fn describe(
    graph: &SceneGraph,
    policy: &dyn Policy,
    seen: &Observation,
    learned: &Learned,
    action: Action,
    plan: &Plan,
) -> Step {
    let label = |&id: &NodeId| graph.label(id).to_string();
    Step {
        step: 0,
        room: seen.room().as_ref().map(label),
        seen: seen.len(),
        sight: seen.digest().to_string(),
        observation: None,
        found: learned.found.iter().map(label).collect(),
        disproved: learned.disproved.iter().map(label).collect(),
        believed: policy.guesses().iter().map(|&(id, place)| guess(graph, id, place)).collect(),
        places: policy.belief().map_or(0, |b| b.open_places()),
        belief: policy.belief().map(|b| format!("{:016x}", b.digest())),
        plan: plan.actions.iter().map(|a| a.describe(graph).to_string()).collect(),
        action,
        described: action.describe(graph).to_string(),
        refused: None,
        digest: String::new(),
    }
}

fn guess(graph: &SceneGraph, id: NodeId, place: Option<Place>) -> String {
    let label = |id| graph.label(id);
    match place {
        Some(place) => format!("{} {} {}", label(id), place.relation, label(place.at)),
        None => format!("{} in some room", label(id)),
    }
}

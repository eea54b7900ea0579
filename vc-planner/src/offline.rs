//! Trajectories as transitions, for offline reinforcement learning.
//!
//! A record need not contain all observations. Since actions on a scene are deterministic, the observations are
//! reconstructed by a replay from the initial scene.

#[cfg(feature = "parquet")]
mod table;

use vc_graph::{SceneGraph, Scope, Simulator};
use vc_tasks::{GoalProgress, Outcome};

use crate::observation::as_json;
use crate::{Fault, Trajectory};

#[cfg(feature = "parquet")]
pub use table::{TableError, write_parquet};

/// One step of an episode in the form of offline reinforcement learning: observation, action and result.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Number of the step, from one.
    pub step: usize,
    /// The agent's observation as JSON: its room, the things with their states, and the relations between them.
    pub observation: String,
    /// The action, such as `place apple.5 kitchen_table.3`.
    pub action: String,
    /// The increase of the share of the goal that holds, -1 to 1. Over an episode that won, the rewards sum to
    /// the share that did not hold at first.
    pub reward: f64,
    /// The next observation.
    pub next_observation: String,
    /// Whether the step reached the goal.
    pub terminated: bool,
    /// Whether the episode ended with this step for another reason: the step limit, or the agent gave up or was
    /// stopped.
    pub truncated: bool,
}

impl Trajectory {
    /// The steps as transitions with observations of a scope, reconstructed by a replay from the scene in which
    /// the episode began.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope, Simulator};
    /// use vc_planner::{EpisodeOptions, PlannerPolicy, Trajectory};
    /// use vc_tasks::Task;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let mut world = Simulator::new(scene.build());
    /// let start = world.graph().clone();
    /// let task = Task::new("fetch", "Holds(apple)".parse()?);
    /// let episode = Trajectory::record(&EpisodeOptions::seeded(1), &mut PlannerPolicy::oracle(), &task, &mut world);
    /// let steps = episode.transitions(&start, Scope::Room)?;
    /// assert!(steps.last().is_some_and(|step| step.terminated && step.reward == 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::OtherScene`] if the episode began in another scene, [`Fault::Refused`] if a step that was done
    /// cannot be done there.
    pub fn transitions(&self, initial: &SceneGraph, scope: Scope) -> Result<Vec<Transition>, Fault> {
        self.is_of(initial)?;
        let me = self.header.agent;
        let mut world = Simulator::new(initial.clone());
        let mut progress = GoalProgress::new(&self.header.goal, &world, me);
        let look = |world: &Simulator| as_json(&world.graph().observe(me, scope)).to_string();
        let (mut before, mut seen) = (progress.score(&world), look(&world));
        let mut all = Vec::new();
        for (i, step) in self.steps.iter().enumerate() {
            self.redo(&mut world, step)?;
            let (after, now) = (progress.score(&world), look(&world));
            let (last, won) = (i + 1 == self.steps.len(), self.summary.outcome == Outcome::Won);
            all.push(Transition {
                step: step.step,
                observation: std::mem::replace(&mut seen, now.clone()),
                action: step.action.describe(initial).to_string(),
                reward: after - before,
                next_observation: now,
                terminated: last && won,
                truncated: last && !won,
            });
            before = after;
        }
        Ok(all)
    }
}

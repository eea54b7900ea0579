//! Policies decide: one trait for planners, baselines, scripts and language models.

mod planning;
mod random;
mod scripted;

use vc_graph::{Action, Event, NodeId, Observation, SceneGraph, Scope, Seed};
use vc_tasks::{Task, WorldError};

use crate::{Belief, Decision, Learned};

pub use planning::PlannerPolicy;
pub use random::{RandomPolicy, objects_of_interest};
pub use scripted::ScriptedPolicy;

/// The information that a policy gets when an episode begins.
#[derive(Debug, Clone, Copy)]
pub struct EpisodeStart<'a> {
    /// The true scene. A policy decides itself how much of it it uses: a planner in a known home takes the rooms, the
    /// fixed things, and which movable things there are.
    pub scene: &'a SceneGraph,
    /// The agent that the policy controls.
    pub agent: NodeId,
    /// The task.
    pub task: &'a Task,
    /// Where its randomness comes from.
    pub seed: Seed,
}

/// The response to a refused action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum RefusalResponse {
    /// It counts as a step, and the episode goes on.
    GoOn,
    /// The episode ends.
    Stop,
}

/// Decides what an agent does.
///
/// It is object-safe: runners take `&mut dyn Policy`.
///
/// An action that is refused ends the episode unless the policy says otherwise: [`Policy::refused`] answers
/// [`RefusalResponse::Stop`] by default. A policy that tries what may not work overrides it and goes on.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{Policy, RandomPolicy, PlannerPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let task = Task::new("milk", "Holds(milk)".parse()?);
/// let graph = scene.build();
/// let policies: [&mut dyn Policy; 3] = [&mut PlannerPolicy::best(), &mut PlannerPolicy::oracle(), &mut RandomPolicy::default()];
/// for policy in policies {
///     let episode = run_episode(policy, &task, &mut Simulator::new(graph.clone()));
///     assert_eq!(episode.outcome, Outcome::Won, "{}", policy.name());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Policy {
    /// The name in tables.
    fn name(&self) -> &str;

    /// How far it sees.
    fn scope(&self) -> Scope {
        Scope::Room
    }

    /// Whether it knows itself when to stop. If not, an episode ends as soon as the
    /// goal holds.
    fn knows_when_to_stop(&self) -> bool {
        true
    }

    /// A new episode begins.
    fn begin(&mut self, start: &EpisodeStart<'_>);

    /// Takes in what is seen.
    fn see(&mut self, seen: &Observation) -> Learned;

    /// The decision on the next action.
    fn decide(&mut self) -> Decision;

    /// The action was done.
    fn did(&mut self, action: &Action);

    /// The action was refused, for this reason, and nothing has changed. By default the episode ends here as
    /// [`Aborted`](vc_tasks::Outcome::Aborted); with [`RefusalResponse::GoOn`] it goes on, and the refusal counts as a
    /// step.
    fn refused(&mut self, _action: &Action, _why: &WorldError) -> RefusalResponse {
        RefusalResponse::Stop
    }

    /// Another agent in view has done something, before the next observation.
    fn saw(&mut self, _event: &Event) {}

    /// The belief about where things are, if the policy has one.
    fn belief(&self) -> Option<&Belief> {
        None
    }

    /// The things the task is about that it has not found, with its guesses.
    fn guesses(&self) -> Vec<(NodeId, Option<vc_graph::Place>)> {
        Vec::new()
    }
}

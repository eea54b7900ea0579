//! Planners as policies: with a belief, or as an oracle.

use vc_graph::{Action, NodeId, Observation, Scope, Verb};
use vc_tasks::WorldError;

use super::{EpisodeStart, Policy, RefusalResponse};
use crate::{Agent, Belief, Decision, Horizon, Learned, Manners, Prior, SearchLimits};

/// After so many refusals in a row a planner stops.
const REFUSALS: usize = 8;

/// The knowledge of the home that a planner has from the beginning.
#[derive(Debug, Clone)]
enum Knowledge {
    /// The rooms.
    Rooms,
    /// The furniture and which things there are, too; it supposes where they are.
    Things(Prior),
    /// The same, as the thesis's agent, which pursues one subgoal after the other.
    Thesis,
    /// Everything.
    All,
}

/// A planner as a policy: an [`Agent`] made anew for each episode. It searches the home for the things that its goal
/// is about, or knows where they are: the [oracle](Self::oracle).
#[derive(Debug, Clone)]
pub struct PlannerPolicy {
    name: &'static str,
    knowledge: Knowledge,
    manners: Manners,
    agent: Option<Agent>,
    refusals: usize,
    /// The action that was refused last.
    failed: Option<Action>,
}

impl PlannerPolicy {
    fn new(name: &'static str, knowledge: Knowledge) -> Self {
        Self { name, knowledge, manners: Manners::GoalOnly, agent: None, refusals: 0, failed: None }
    }

    /// The best planner: things are where people keep them, the search step that is most
    /// worth it first, two hands.
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
    /// assert_eq!(run_episode(&mut PlannerPolicy::best(), &task, &mut world).outcome, Outcome::Won);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn best() -> Self {
        Self::new("planner", Knowledge::Things(Prior::Kept))
    }

    /// The best planner, in a home of which it knows the rooms and no more: the furniture, and
    /// which things there are, it learns by walking in.
    ///
    /// ```
    /// use vc_planner::{Policy, PlannerPolicy};
    /// assert_eq!(PlannerPolicy::in_unknown_home().name(), "unknown home");
    /// ```
    pub fn in_unknown_home() -> Self {
        Self::new("unknown home", Knowledge::Rooms)
    }

    /// The thesis's planner: a uniform sample, one subgoal after the other.
    pub fn faithful() -> Self {
        Self::new("faithful", Knowledge::Thesis)
    }

    /// The oracle: it knows everything and sees everything. Others are measured by its plans.
    ///
    /// ```
    /// use vc_planner::{PlannerPolicy, Policy};
    /// assert_eq!(PlannerPolicy::oracle().name(), "oracle");
    /// ```
    pub fn oracle() -> Self {
        Self::new("oracle", Knowledge::All)
    }

    /// A planner in a known home, with another supposition about where things are.
    #[must_use]
    pub fn with_prior(self, prior: Prior) -> Self {
        Self { knowledge: Knowledge::Things(prior), ..self }
    }

    /// The name in tables.
    #[must_use]
    pub fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// How it leaves the home.
    #[must_use]
    pub fn with_manners(self, manners: Manners) -> Self {
        Self { manners, ..self }
    }
}

impl Policy for PlannerPolicy {
    fn name(&self) -> &str {
        self.name
    }

    fn scope(&self) -> Scope {
        if matches!(self.knowledge, Knowledge::All) { Scope::Whole } else { Scope::Room }
    }

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        let (scene, id, goal, seed) = (start.scene, start.agent, start.task.goal.clone(), start.seed.0);
        let agent = match &self.knowledge {
            Knowledge::Rooms => Agent::in_unknown_home(scene, id, goal, seed),
            Knowledge::Things(prior) => Agent::with_prior(scene, id, goal, seed, prior.clone()),
            Knowledge::Thesis => Agent::faithful(scene, id, goal, seed),
            Knowledge::All => {
                Agent::oracle(scene, id, goal).planning(Horizon::Goal).with_limits(SearchLimits::THOROUGH)
            }
        };
        (self.agent, self.refusals, self.failed) = (Some(agent.with_manners(self.manners)), 0, None);
    }

    fn see(&mut self, seen: &Observation) -> Learned {
        self.agent.as_mut().map_or_else(Learned::default, |a| a.see(seen))
    }

    fn decide(&mut self) -> Decision {
        self.agent.as_mut().map_or(Decision::Done, Agent::decide)
    }

    fn did(&mut self, action: &Action) {
        // One walks up to what has failed before one tries again.
        if action.verb != Verb::Walk {
            (self.refusals, self.failed) = (0, None);
        }
        if let Some(agent) = &mut self.agent {
            agent.did(action);
        }
    }

    /// The agent walks up to a thing with which the world could not do an action; after the second refusal it
    /// opens elsewhere what can be taken out, and else expects the action no more.
    fn refused(&mut self, action: &Action, why: &WorldError) -> RefusalResponse {
        self.refusals += 1;
        if let Some(agent) = &mut self.agent {
            agent.refused(action);
            match why {
                WorldError::Failed(_) if self.failed != Some(*action) => agent.go_back_to(action),
                WorldError::Failed(_) if agent.open_elsewhere(action) || agent.bar(action) => self.refusals = 0,
                _ => {}
            }
        }
        self.failed = Some(*action);
        if self.refusals < REFUSALS { RefusalResponse::GoOn } else { RefusalResponse::Stop }
    }

    fn belief(&self) -> Option<&Belief> {
        self.agent.as_ref().map(Agent::belief)
    }

    fn guesses(&self) -> Vec<(NodeId, Option<vc_graph::Place>)> {
        self.agent.as_ref().map_or_else(Vec::new, Agent::guesses)
    }
}

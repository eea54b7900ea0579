//! Planners as policies: with a belief, and the oracle.

use vc_graph::{Action, NodeId, Observation, Scope, Verb};
use vc_tasks::WorldError;

use super::{EpisodeStart, Policy, RefusalResponse};
use crate::{Agent, Belief, Decision, Horizon, Learned, Manners, Prior, SearchLimits};

/// After so many refusals in a row a planner stops.
const REFUSALS: usize = 8;

/// A planner as a policy: an [`Agent`] made anew for each episode.
#[derive(Debug, Clone)]
struct Planning {
    agent: Option<Agent>,
    refusals: usize,
    /// The action that was refused last.
    failed: Option<Action>,
}

impl Planning {
    const NEW: Self = Self { agent: None, refusals: 0, failed: None };

    fn begin(&mut self, agent: Agent) {
        *self = Self { agent: Some(agent), refusals: 0, failed: None };
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
}

macro_rules! plans {
    () => {
        fn see(&mut self, seen: &Observation) -> Learned {
            self.planning.see(seen)
        }

        fn decide(&mut self) -> Decision {
            self.planning.decide()
        }

        fn did(&mut self, action: &Action) {
            self.planning.did(action);
        }

        fn refused(&mut self, action: &Action, why: &WorldError) -> RefusalResponse {
            self.planning.refused(action, why)
        }

        fn belief(&self) -> Option<&Belief> {
            self.planning.agent.as_ref().map(Agent::belief)
        }

        fn guesses(&self) -> Vec<(NodeId, Option<vc_graph::Place>)> {
            self.planning.agent.as_ref().map_or_else(Vec::new, Agent::guesses)
        }
    };
}

/// A planner with a belief: it searches the home for the things that its goal is about.
#[derive(Debug, Clone)]
pub struct PlannerPolicy {
    name: &'static str,
    planning: Planning,
    /// The prior about where things are; `None` for the thesis's agent.
    prior: Option<Prior>,
    /// It knows from the beginning what furniture and which things there are.
    knows_home: bool,
    manners: Manners,
}

impl PlannerPolicy {
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
        let prior = Some(Prior::Kept);
        Self { name: "planner", planning: Planning::NEW, prior, knows_home: true, manners: Manners::GoalOnly }
    }

    /// The best planner, in a home of which it knows the rooms and no more: the furniture, and
    /// which things there are, it learns by walking in.
    ///
    /// ```
    /// use vc_planner::{Policy, PlannerPolicy};
    /// assert_eq!(PlannerPolicy::in_unknown_home().name(), "unknown home");
    /// ```
    pub fn in_unknown_home() -> Self {
        Self { name: "unknown home", knows_home: false, ..Self::best() }
    }

    /// The thesis's planner: a uniform sample, one subgoal after the other.
    pub fn faithful() -> Self {
        Self { name: "faithful", prior: None, ..Self::best() }
    }

    /// The best planner, with another supposition about where things are.
    #[must_use]
    pub fn with_prior(self, prior: Prior) -> Self {
        Self { prior: Some(prior), ..self }
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

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        let EpisodeStart { scene, agent, task, seed } = *start;
        let agent = match &self.prior {
            _ if !self.knows_home => Agent::in_unknown_home(scene, agent, task.goal.clone(), seed.0),
            None => Agent::faithful(scene, agent, task.goal.clone(), seed.0),
            Some(prior) => Agent::with_prior(scene, agent, task.goal.clone(), seed.0, prior.clone()),
        };
        self.planning.begin(agent.with_manners(self.manners));
    }

    plans!();
}

/// The oracle: it knows everything and sees everything.
#[derive(Debug, Clone)]
pub struct OraclePolicy {
    planning: Planning,
    manners: Manners,
}

impl Default for OraclePolicy {
    fn default() -> Self {
        Self { planning: Planning::NEW, manners: Manners::GoalOnly }
    }
}

impl OraclePolicy {
    /// How it leaves the home.
    #[must_use]
    pub fn with_manners(self, manners: Manners) -> Self {
        Self { manners, ..self }
    }
}

impl Policy for OraclePolicy {
    fn name(&self) -> &str {
        "oracle"
    }

    fn scope(&self) -> Scope {
        Scope::Whole
    }

    fn begin(&mut self, start: &EpisodeStart<'_>) {
        let agent = Agent::oracle(start.scene, start.agent, start.task.goal.clone());
        // Others are measured by its plans.
        self.planning
            .begin(agent.planning(Horizon::Goal).with_limits(SearchLimits::THOROUGH).with_manners(self.manners));
    }

    plans!();
}

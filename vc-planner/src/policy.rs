//! What decides: one trait for planners, baselines, scripts and language models.

use vc_graph::{Action, Event, Goal, NodeId, Observation, SceneGraph, Scope, Seed, Stream, Verb};
use vc_tasks::library::THESIS_VERBS;
use vc_tasks::{Task, WorldError};

use crate::{Agent, Belief, Decision, Horizon, Learned, Manners, Plan, Prior, SearchLimits};

/// What a policy is told when an episode begins.
#[derive(Debug, Clone, Copy)]
pub struct EpisodeStart<'a> {
    /// The true scene. What a policy may take from it is its own honesty: newcomers
    /// take the rooms, the fixed things, and what movable things there are.
    pub scene: &'a SceneGraph,
    /// Who it acts as.
    pub agent: NodeId,
    /// What is to be done.
    pub task: &'a Task,
    /// Where its randomness comes from.
    pub seed: Seed,
}

/// What to do about a refused action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RefusalResponse {
    /// It counts as a step, and the episode goes on.
    GoOn,
    /// The episode ends.
    Stop,
}

/// Somebody who decides what an agent does.
///
/// It is object-safe: runners take `&mut dyn Policy`.
///
/// An action that is refused ends the episode unless the policy says otherwise: [`Policy::refused`] answers
/// [`RefusalResponse::Stop`] by default. A policy that tries what may not work overrides it and goes on.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
/// use vc_planner::{Policy, RandomPolicy, OraclePolicy, PlannerPolicy, run_episode};
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let task = Task::new("milk", "Holds(milk)".parse()?);
/// let graph = scene.build();
/// let policies: [&mut dyn Policy; 3] = [&mut PlannerPolicy::best(), &mut OraclePolicy::default(), &mut RandomPolicy::default()];
/// for policy in policies {
///     let episode = run_episode(policy, &task, &mut Simulator::new(graph.clone()));
///     assert_eq!(episode.outcome, Outcome::Won, "{}", policy.name());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Policy {
    /// What it is called in tables.
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
    fn begin(&mut self, brief: &EpisodeStart<'_>);

    /// Takes in what is seen.
    fn see(&mut self, seen: &Observation) -> Learned;

    /// What to do now.
    fn decide(&mut self) -> Decision;

    /// The action was done.
    fn did(&mut self, action: &Action);

    /// The action was refused, for this reason, and nothing has changed. By default the episode ends here as
    /// [`Aborted`](vc_tasks::Outcome::Aborted); with [`RefusalResponse::GoOn`] it goes on, and the refusal counts as a step.
    fn refused(&mut self, _action: &Action, _why: &WorldError) -> RefusalResponse {
        RefusalResponse::Stop
    }

    /// Another agent in view has done something, before the next look.
    fn saw(&mut self, _event: &Event) {}

    /// What it believes, if it does.
    fn belief(&self) -> Option<&Belief> {
        None
    }

    /// The things the task is about that it has not found, with its guesses.
    fn guesses(&self) -> Vec<(NodeId, Option<vc_graph::Place>)> {
        Vec::new()
    }
}

/// After so many refusals in a row a planner stops.
const REFUSALS: usize = 8;

/// A planner as a policy: an [`Agent`] made anew for each episode.
#[derive(Debug, Clone)]
struct Planning {
    agent: Option<Agent>,
    refusals: usize,
    /// What was refused last.
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

    /// What the world cannot do, the agent walks up to; what it cannot do a second time, the
    /// agent does not expect of it any more.
    fn refused(&mut self, action: &Action, why: &WorldError) -> RefusalResponse {
        self.refusals += 1;
        if let Some(agent) = &mut self.agent {
            agent.refused(action);
            match why {
                WorldError::Failed(_) if self.failed != Some(*action) => agent.go_back_to(action),
                WorldError::Failed(_) if agent.bar(action) => self.refusals = 0,
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

/// Somebody who knows the plan of the home and searches it.
#[derive(Debug, Clone)]
pub struct PlannerPolicy {
    name: &'static str,
    planning: Planning,
    /// What it supposes about where things are; `None` for the thesis's agent.
    prior: Option<Prior>,
    /// It has been told what furniture and which things there are.
    told: bool,
    manners: Manners,
}

impl PlannerPolicy {
    /// The best planner: things are where people keep them, the look that is most
    /// worth it first, two hands.
    pub fn best() -> Self {
        let prior = Some(Prior::Kept);
        Self { name: "planner", planning: Planning::NEW, prior, told: true, manners: Manners::GoalOnly }
    }

    /// The best planner, in a home of which it knows the rooms and no more: the furniture, and
    /// which things there are, it learns by walking in.
    pub fn in_unknown_home() -> Self {
        Self { name: "stranger", told: false, ..Self::best() }
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

    /// What it is called in tables.
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

    fn begin(&mut self, brief: &EpisodeStart<'_>) {
        let EpisodeStart { scene, agent, task, seed } = *brief;
        let agent = match &self.prior {
            _ if !self.told => Agent::in_unknown_home(scene, agent, task.goal.clone(), seed.0),
            None => Agent::faithful(scene, agent, task.goal.clone(), seed.0),
            Some(prior) => Agent::with_prior(scene, agent, task.goal.clone(), seed.0, prior.clone()),
        };
        self.planning.begin(agent.with_manners(self.manners));
    }

    plans!();
}

/// The oracle: somebody who knows everything and sees everything.
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

    fn begin(&mut self, brief: &EpisodeStart<'_>) {
        let agent = Agent::oracle(brief.scene, brief.agent, brief.task.goal.clone());
        // Others are measured by its plans.
        self.planning
            .begin(agent.planning(Horizon::Goal).with_limits(SearchLimits::THOROUGH).with_manners(self.manners));
    }

    plans!();
}

/// The thesis's random model: a verb and objects of interest, each drawn uniformly;
/// what cannot be done is ignored, and counts as a step.
#[derive(Debug, Clone, Default)]
pub struct RandomPolicy {
    things: Vec<NodeId>,
    stream: Option<Stream>,
}

impl RandomPolicy {
    fn draw(&mut self) -> Option<Action> {
        let stream = self.stream.as_mut()?;
        // A verb of VirtualCity that takes more things than there are is drawn again.
        for _ in 0..64 {
            let verb = *stream.pick(&THESIS_VERBS)?;
            let things: Vec<NodeId> = (0..verb.arity()).filter_map(|_| stream.pick(&self.things).copied()).collect();
            if let Ok(action) = Action::with(verb, &things) {
                return Some(action);
            }
        }
        None
    }
}

/// The objects of interest of a goal in a scene: what it names, of each class all that
/// there are, and what these are in or on.
pub fn objects_of_interest(scene: &SceneGraph, goal: &Goal) -> Vec<NodeId> {
    let mut found = Vec::new();
    for term in goal.terms() {
        match term {
            vc_graph::goal::Term::Class(class) => found.extend(scene.of_class(&class)),
            vc_graph::goal::Term::Node(_, id) => found.push(id),
            _ => {}
        }
    }
    let around: Vec<NodeId> = found.iter().filter_map(|&id| scene.place(id)).map(|p| p.at).collect();
    found.extend(around);
    found.sort_unstable();
    found.dedup();
    found
}

impl Policy for RandomPolicy {
    fn name(&self) -> &str {
        "random"
    }

    fn knows_when_to_stop(&self) -> bool {
        false
    }

    fn begin(&mut self, brief: &EpisodeStart<'_>) {
        self.things = objects_of_interest(brief.scene, &brief.task.goal);
        self.stream = Some(brief.seed.child("random policy").stream());
    }

    fn see(&mut self, _: &Observation) -> Learned {
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        self.draw().map_or(Decision::Done, |action| Decision::Act(action, Plan::default()))
    }

    fn did(&mut self, _: &Action) {}

    fn refused(&mut self, _: &Action, _: &WorldError) -> RefusalResponse {
        RefusalResponse::GoOn
    }
}

/// Does what is written, whatever it sees.
#[derive(Debug, Clone, Default)]
pub struct ScriptedPolicy {
    script: Vec<Action>,
    next: usize,
}

impl ScriptedPolicy {
    /// A policy that does these actions in turn.
    pub fn new(script: Vec<Action>) -> Self {
        Self { script, next: 0 }
    }
}

impl Policy for ScriptedPolicy {
    fn name(&self) -> &str {
        "script"
    }

    fn begin(&mut self, _: &EpisodeStart<'_>) {
        self.next = 0;
    }

    fn see(&mut self, _: &Observation) -> Learned {
        Learned::default()
    }

    fn decide(&mut self) -> Decision {
        match self.script.get(self.next) {
            Some(&action) => {
                Decision::Act(action, Plan { actions: self.script[self.next..].to_vec(), ..Plan::default() })
            }
            None => Decision::Done,
        }
    }

    fn did(&mut self, _: &Action) {
        self.next += 1;
    }
}

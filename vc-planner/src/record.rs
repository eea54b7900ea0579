//! Trajectories as JSON Lines: writing, reading, replaying and checking.

use std::fmt::Write as _;

use serde::{Deserialize, Serialize};
use vc_graph::format::unmarked;
use vc_graph::{Action, Edge, Goal, NodeId, Observation, Refusal, Relation, SceneGraph, Scope, Seed, Simulator, Verb};
use vc_tasks::{GoalProgress, Outcome, Task, World};

use crate::observation::as_json;
use crate::{EpisodeOptions, Policy, Step, Summary};

/// The first line of a record: the subject of the episode.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// The scene's name.
    pub scene: String,
    /// Digest of the initial scene.
    pub digest: String,
    /// The task's title.
    pub task: String,
    /// The goal.
    pub goal: Goal,
    /// The acting agent.
    pub agent: NodeId,
    /// The policy's name.
    pub policy: String,
    /// The scope of its observations.
    pub scope: Scope,
    /// The policy's seed.
    pub seed: Seed,
}

/// A whole episode.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Simulator};
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
/// let again = Trajectory::read_json_lines(&episode.to_json_lines()?)?;
/// assert_eq!(again, episode);
/// assert!(again.check(&start).is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// The subject of the episode.
    pub header: Header,
    /// The steps.
    pub steps: Vec<Step>,
    /// The outcome of the episode.
    pub summary: Summary,
}

/// An error in a record.
///
/// ```
/// use vc_planner::{Trajectory, TrajectoryError};
/// assert!(matches!(Trajectory::read_json_lines(""), Err(TrajectoryError::TooShort)));
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TrajectoryError {
    /// A line cannot be read.
    #[error("line {line}: {error}")]
    Line {
        /// Line, counted from one.
        line: usize,
        /// The error in the line.
        #[source]
        error: serde_json::Error,
    },
    /// The first line is that of a `Recorder`, which records the motions of bodies, with times and positions.
    #[error(
        "line 1 is of a record with bodies, which the `Recorder` of the crate `virtualcity` writes: its lines are read \
         as JSON; a `Trajectory` is what `to_json_lines` writes"
    )]
    WithBodies,
    /// The header or the summary is missing.
    #[error("a record needs a first line about the episode and a last line about its outcome")]
    TooShort,
}

/// A fault of a trajectory.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The trajectory began in another scene.
    #[error("the trajectory began in another scene")]
    OtherScene,
    /// The same action was done twice in a row.
    #[error("step {0}: the same action as before")]
    Duplicate(usize),
    /// An action cannot be done although the record says that it was done.
    #[error("step {0}: {1}")]
    Refused(usize, String),
    /// An action was refused although it can be done.
    #[error("step {0}: recorded as refused, but it can be done")]
    NotRefused(usize),
    /// The recorded observation before a step differs: the room, the number of things, or the digest.
    #[error("step {0}: the recorded observation before it differs")]
    OtherSight(usize),
    /// The scene after a step differs.
    #[error("step {0}: the recorded scene after it differs")]
    OtherState(usize),
    /// A relation that an action establishes does not hold after it.
    #[error("step {0}: `{1}` does not hold after it")]
    Relation(usize, String),
    /// The goal does not hold at the end although the record says so.
    #[error("the goal does not hold at the end")]
    NotMet,
    /// The goal holds at the end although the record says otherwise.
    #[error("the goal holds at the end")]
    Met,
}

impl Header {
    /// The header of an episode that is about to begin in a scene.
    pub fn new(run: &EpisodeOptions, policy: &dyn Policy, task: &Task, graph: &SceneGraph) -> Self {
        Self {
            scene: graph.name().to_owned(),
            digest: graph.digest().to_string(),
            task: task.title.clone(),
            goal: task.goal.clone(),
            agent: run.agent.or_else(|| graph.agents().first().copied()).unwrap_or(NodeId(0)),
            policy: policy.name().to_owned(),
            scope: policy.scope(),
            seed: run.seed,
        }
    }
}

impl Trajectory {
    /// Runs an episode and records it.
    pub fn record(run: &EpisodeOptions, policy: &mut dyn Policy, task: &Task, world: &mut dyn World) -> Self {
        let header = Header::new(run, policy, task, world.graph());
        let mut steps = Vec::new();
        let episode = run.episode(policy, task, world, &mut |step| steps.push(step.clone()));
        Self { header, steps, summary: episode.summary() }
    }

    /// The trajectory as JSON Lines: a header, a line for each step, a summary.
    ///
    /// # Errors
    /// The error of serde_json.
    pub fn to_json_lines(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string(&self.header)? + "\n";
        for step in &self.steps {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{}", serde_json::to_string(step)?);
        }
        Ok(text + &serde_json::to_string(&self.summary)? + "\n")
    }

    /// Reads what [`Trajectory::to_json_lines`] wrote.
    ///
    /// # Errors
    /// [`TrajectoryError`] with the line.
    pub fn read_json_lines(text: &str) -> Result<Self, TrajectoryError> {
        let lines: Vec<(usize, &str)> =
            unmarked(text).lines().enumerate().map(|(i, l)| (i + 1, l)).filter(|(_, l)| !l.trim().is_empty()).collect();
        let [first, middle @ .., last] = lines.as_slice() else { return Err(TrajectoryError::TooShort) };
        if is_with_bodies(first.1) {
            return Err(TrajectoryError::WithBodies);
        }
        let steps: Result<Vec<Step>, TrajectoryError> = middle.iter().map(read).collect();
        Ok(Self { header: read(first)?, steps: steps?, summary: read(last)? })
    }

    /// The scenes of an episode, replayed symbolically: the initial one, then the one after each step. They
    /// share their unchanged parts.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Simulator};
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
    /// assert_eq!(episode.replay(&start)?.last(), Some(world.graph()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::OtherScene`] if the episode began in another scene, [`Fault::Refused`] if a step that was done
    /// cannot be done there.
    pub fn replay(&self, initial: &SceneGraph) -> Result<Vec<SceneGraph>, Fault> {
        self.is_of(initial)?;
        let mut world = Simulator::new(initial.clone());
        let mut scenes = vec![initial.clone()];
        for step in &self.steps {
            self.redo(&mut world, step)?;
            scenes.push(world.graph().clone());
        }
        Ok(scenes)
    }

    pub(crate) fn is_of(&self, initial: &SceneGraph) -> Result<(), Fault> {
        if initial.digest().to_string() == self.header.digest { Ok(()) } else { Err(Fault::OtherScene) }
    }

    /// Repeats a step. A refused action changes nothing.
    pub(crate) fn redo(&self, world: &mut Simulator, step: &Step) -> Result<(), Fault> {
        if step.refused.is_some() {
            return Ok(());
        }
        world.step(self.header.agent, &step.action).map(drop).map_err(|why| refused(step, &why))
    }

    /// The faults of the trajectory when it is replayed symbolically from a scene: the thesis's post-processing
    /// check. Empty if there are none.
    pub fn check(&self, initial: &SceneGraph) -> Vec<Fault> {
        if let Err(fault) = self.is_of(initial) {
            return vec![fault];
        }
        let mut faults = Vec::new();
        let mut world = Simulator::new(initial.clone());
        let mut progress = GoalProgress::new(&self.header.goal, &world, self.header.agent);
        let mut last: Option<Action> = None;
        for step in &self.steps {
            self.check_step(&mut world, step, last, &mut faults);
            progress.note(&world);
            last = step.refused.is_none().then_some(step.action);
        }
        match (progress.holds(&world), self.summary.outcome == Outcome::Won) {
            (false, true) => faults.push(Fault::NotMet),
            (true, false) => faults.push(Fault::Met),
            _ => {}
        }
        faults
    }

    fn check_step(&self, world: &mut Simulator, step: &Step, last: Option<Action>, faults: &mut Vec<Fault>) {
        let (number, me) = (step.step, self.header.agent);
        if last == Some(step.action) {
            faults.push(Fault::Duplicate(number));
        }
        if !saw(step, &world.graph().observe(me, self.header.scope), world.graph()) {
            faults.push(Fault::OtherSight(number));
        }
        match (world.step(me, &step.action), &step.refused) {
            (Ok(_), Some(_)) => faults.push(Fault::NotRefused(number)),
            (Err(why), None) => faults.push(refused(step, &why)),
            (Ok(_), None) => {
                if let Some(edge) = expected(world.graph(), me, &step.action).filter(|e| !world.graph().has(*e)) {
                    faults.push(Fault::Relation(number, edge.to_string()));
                }
            }
            (Err(_), Some(_)) => {}
        }
        if world.graph().digest().to_string() != step.digest {
            faults.push(Fault::OtherState(number));
        }
    }
}

fn refused(step: &Step, why: &[Refusal]) -> Fault {
    Fault::Refused(step.step, why.first().map_or_else(String::new, ToString::to_string))
}

/// Whether a step's record of the observation is correct.
fn saw(step: &Step, seen: &Observation, graph: &SceneGraph) -> bool {
    let room = seen.room().map(|id| graph.label(id).to_string());
    let whole = step.observation.as_ref().is_none_or(|recorded| *recorded == as_json(seen));
    whole && room == step.room && seen.len() == step.seen && seen.digest().to_string() == step.sight
}

/// Whether a first line names its agent as records with bodies do; a `Trajectory` gives the agent's number.
fn is_with_bodies(line: &str) -> bool {
    let header = serde_json::from_str::<serde_json::Value>(line);
    header.is_ok_and(|header| header.get("agent").is_some_and(serde_json::Value::is_string))
}

fn read<T: serde::de::DeserializeOwned>(&(line, text): &(usize, &str)) -> Result<T, TrajectoryError> {
    serde_json::from_str(text).map_err(|error| TrajectoryError::Line { line, error })
}

/// The relation that an action is meant to establish.
fn expected(graph: &SceneGraph, me: NodeId, action: &Action) -> Option<Edge> {
    let (object, target) = (action.object?, action.target);
    match action.verb {
        Verb::Grab => {
            graph.holder(object).filter(|p| p.at == me).is_none().then(|| Edge::new(me, Relation::HoldsRight, object))
        }
        Verb::Place => Some(Edge::new(object, Relation::On, target?)),
        Verb::PutIn => Some(Edge::new(object, Relation::Inside, target?)),
        Verb::Sit => Some(Edge::new(me, Relation::SittingOn, object)),
        Verb::Lie => Some(Edge::new(me, Relation::LyingOn, object)),
        _ => None,
    }
}

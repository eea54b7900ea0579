//! All policies in one environment.

use serde::{Deserialize, Serialize};
use vc_graph::{Action, ChangeSet, History, NodeId, SceneGraph, Seed, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Prior, RandomPolicy};
use vc_tasks::initial::Initial;
use vc_tasks::library::Activity;
use vc_tasks::report::{Run, predicates};
use vc_tasks::{Outcome, World, WorldError};
use virtualcity::ActionError;
use virtualcity::Environment;
use virtualcity::initial::{AtHome, at_home, at_home_that, feasible, generator};

/// All policies in the order of the tables; the oracle is the last.
pub(crate) fn policies(symbolic: bool) -> Vec<Box<dyn Policy>> {
    let mut all: Vec<Box<dyn Policy>> = vec![Box::new(RandomPolicy::default())];
    if symbolic {
        all.push(Box::new(PlannerPolicy::faithful()));
        all.push(Box::new(PlannerPolicy::best().with_prior(Prior::Uniform).named("planner, uniform")));
    }
    all.push(Box::new(PlannerPolicy::best()));
    all.push(Box::new(PlannerPolicy::oracle()));
    all
}

/// The results of an attempt.
#[derive(Clone, Default, Serialize, Deserialize)]
pub(crate) struct Attempt {
    pub(crate) runs: Vec<Run>,
    /// The reasons of failures, and the refused actions.
    pub(crate) failures: Vec<String>,
    /// Number of actions performed with bodies.
    pub(crate) done: usize,
    /// Actions after which the bodies contradicted the rule, one line each.
    pub(crate) disagreements: Vec<String>,
    /// The reasons why homes were skipped, one line each.
    pub(crate) passed_over: Vec<String>,
}

impl Attempt {
    pub(crate) fn append(&mut self, other: Self) {
        self.runs.extend(other.runs);
        self.failures.extend(other.failures);
        self.done += other.done;
        self.disagreements.extend(other.disagreements);
        self.passed_over.extend(other.passed_over);
    }
}

/// Lets all policies attempt a task in the home of a seed.
pub(crate) fn attempt(activity: &Activity, seed: u64, steps: usize, symbolic: bool) -> Result<Attempt, String> {
    let unmade = |e: virtualcity::initial::NoHome| format!("{} in home {seed}: {e}", activity.id);
    if symbolic {
        let made = at_home(activity, Seed(seed), &generator(), |home| Ok(Simulator::new(home))).map_err(unmade)?;
        return tried(activity, seed, steps, made, policies(true)).map(|(attempt, _)| attempt);
    }
    let suits = |world: &Bodies, initial: &Initial| feasible(activity, &world.home, initial);
    let made = at_home_that(activity, Seed(seed), &generator(), Bodies::of, suits).map_err(unmade)?;
    let (mut attempt, bodies) = tried(activity, seed, steps, made, policies(false))?;
    let named = |line: String| format!("{} in home {seed}: {line}", activity.id);
    (attempt.done, attempt.disagreements) = (bodies.done, bodies.disagreements.into_iter().map(named).collect());
    Ok(attempt)
}

fn tried<W: World>(
    activity: &Activity,
    seed: u64,
    steps: usize,
    made: AtHome<W>,
    policies: Vec<Box<dyn Policy>>,
) -> Result<(Attempt, W), String> {
    let AtHome { mut world, initial, passed_over, .. } = made;
    let (scene, mut task) = (initial.scene, initial.task);
    task.goal = activity.goal.clone();
    task.step_limit = steps;
    let passed_over = passed_over.iter().map(|why| format!("{} in home {seed}: {why}", activity.id)).collect();
    let mut attempt = Attempt { passed_over, ..Attempt::default() };
    for mut policy in policies {
        world.reset(&scene).map_err(|e| e.to_string())?;
        let how = EpisodeOptions { agent: Some(initial.agent), ..EpisodeOptions::seeded(seed) };
        let mut refused: Vec<String> = Vec::new();
        // Most random actions are refused, so those refusals are not reported.
        let tells = policy.name() != "random";
        let episode = how.episode(policy.as_mut(), &task, &mut world, &mut |step| {
            let why = step.refused.as_ref().filter(|_| tells);
            refused.extend(why.map(|why| format!("{}. {}: {why}", step.step, step.described)));
        });
        if episode.outcome != Outcome::Won {
            let why = episode.reason.unwrap_or_else(|| format!("not done after {} steps", episode.steps));
            let all = refused.iter().map(|r| format!("\n    {r}")).collect::<String>();
            attempt.failures.push(format!("{}, {} in home {seed}: {why}{all}", policy.name(), activity.id));
        }
        attempt.runs.push(Run {
            agent: policy.name().to_owned(),
            task: activity.id.clone(),
            seed,
            predicates: predicates(&task.goal),
            outcome: episode.outcome,
            credit: episode.score,
            steps: episode.steps,
            ..Run::default()
        });
    }
    // The oracle's number of steps is the best known.
    let best = attempt.runs.last().filter(|r| r.outcome == Outcome::Won).map(|r| r.steps);
    attempt.runs.iter_mut().for_each(|r| r.best_steps = best);
    Ok((attempt, world))
}

/// A home with bodies, with counts of the actions performed in it.
struct Bodies {
    home: Environment,
    done: usize,
    disagreements: Vec<String>,
}

impl Bodies {
    fn of(home: SceneGraph) -> Result<Self, WorldError> {
        let home = Environment::from_scene(home, 1).map_err(WorldError::failed)?;
        Ok(Self { home, done: 0, disagreements: Vec::new() })
    }
}

impl World for Bodies {
    fn graph(&self) -> &SceneGraph {
        self.home.graph()
    }

    fn history(&self) -> &History {
        self.home.history()
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        let outcome = self.home.set_action(agent, *action);
        match &outcome {
            Ok(_) => self.done += 1,
            Err(ActionError::Disagreement(both)) => {
                self.done += 1;
                self.disagreements.push(both.to_string());
            }
            Err(_) => {}
        }
        outcome.map_err(WorldError::from)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.home, graph)
    }
}

//! Several agents with one goal.

use vc_graph::{Action, Goal, NodeId, SceneGraph, Scope};
use vc_tasks::{GoalProgress, Outcome, Task, World};

use crate::reason::{explained, hopeless, loss, refusal};
use crate::shared::shared;
use crate::{Agent, Decision, Summary};

/// Agents that share a goal and tell each other what they see and what they will do.
///
/// A delivery that one has promised (to bring this there) counts as done for the others: no thing
/// is fetched twice, and the others see to the rest of the goal. Nobody closes or starts a
/// container to which another is bringing something. A promise is for one trip, two things at most.
/// Parts of the goal about the agent itself (what it holds, where it sits) are about the
/// first of them.
///
/// ```
/// use vc_graph::Simulator;
/// use vc_graph::{Draft, SceneBuilder};
/// use vc_planner::Team;
/// use vc_tasks::{Outcome, Task};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let graph = scene.build();
/// let mut scene = SceneBuilder::from_graph(graph);
/// let agents = [scene.add_in(kitchen, Draft::new("character"))?, scene.add_in(kitchen, Draft::new("character"))?];
/// let mut world = Simulator::new(scene.build());
/// let task = Task::new("fetch", "exists ?a: character. Holds(?a, apple)".parse()?);
/// let episode = Team::oracles(&world.graph().clone(), &agents, &task.goal).run(&task, &mut world);
/// assert_eq!(episode.outcome, Outcome::Won);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Team {
    agents: Vec<Agent>,
    ids: Vec<NodeId>,
}

/// How a team did.
#[derive(Debug, Clone, PartialEq)]
pub struct TeamEpisode {
    /// How it ended.
    pub outcome: Outcome,
    /// How many rounds it took: in each every agent acts at most once.
    pub rounds: usize,
    /// How many actions were done by all.
    pub actions: usize,
    /// How much of the goal holds at the end, 0 to 1.
    pub score: f64,
    /// Why it was not won; `None` if it was.
    pub reason: Option<String>,
}

impl From<&TeamEpisode> for Summary {
    fn from(episode: &TeamEpisode) -> Self {
        let (outcome, score, steps) = (episode.outcome, episode.score, episode.actions);
        Self { outcome, score, steps, reason: episode.reason.clone() }
    }
}

impl TeamEpisode {
    /// An episode that is lost before it begins, if there is a reason for that.
    pub(crate) fn hopeless(ids: &[NodeId], task: &Task, graph: &SceneGraph) -> Option<Self> {
        let reason = Some(hopeless(ids, task, graph)?);
        Some(Self { outcome: Outcome::Lost, rounds: 0, actions: 0, score: 0.0, reason })
    }

    /// An episode that has ended after so many rounds and actions; if agents stopped, for these reasons.
    pub(crate) fn ended(
        outcome: Outcome,
        (rounds, actions): (usize, usize),
        stopped: Vec<String>,
        progress: &mut GoalProgress,
        world: &dyn World,
    ) -> Self {
        let idle = || (outcome != Outcome::Won).then(|| "none of the agents knows what else to do".to_owned());
        let reason = loss(outcome, stopped, progress, world).or_else(idle);
        Self { outcome, rounds, actions, score: progress.score(world), reason }
    }
}

/// After so many rounds in which nobody does anything a team stops.
const IDLE: usize = 2;

impl Team {
    /// Agents that know the plan of the home and no more.
    pub fn in_known_home(graph: &SceneGraph, ids: &[NodeId], goal: &Goal, seed: u64) -> Self {
        let goal = &goal.expanded(graph.vocabulary());
        Self::with_agents(ids, goal, |id, goal| Agent::in_known_home(graph, id, goal, seed))
    }

    /// Agents that know everything there is.
    pub fn oracles(graph: &SceneGraph, ids: &[NodeId], goal: &Goal) -> Self {
        let goal = &goal.expanded(graph.vocabulary());
        Self::with_agents(ids, goal, |id, goal| Agent::oracle(graph, id, goal))
    }

    /// The first has the whole goal, which speaks of it; the others what anybody can do.
    fn with_agents(ids: &[NodeId], goal: &Goal, agent: impl Fn(NodeId, Goal) -> Agent) -> Self {
        let part = |index| if index == 0 { goal.clone() } else { shared(goal) };
        let agents = ids.iter().enumerate().map(|(index, &id)| agent(id, part(index))).collect();
        Self { agents, ids: ids.to_vec() }
    }

    /// Lets the team pursue its goal until it holds, nobody knows what to do, or the
    /// task's limit of steps is reached, in rounds. The verdict is that on the first agent, as in
    /// [`run_episode`](crate::run_episode). A team of nobody has lost at once, and so has one whose task's goal has a
    /// name that stands for nothing, or with a member that is no agent; [`TeamEpisode::reason`] says so.
    pub fn run(&mut self, task: &Task, world: &mut dyn World) -> TeamEpisode {
        if let Some(lost) = TeamEpisode::hopeless(&self.ids, task, world.graph()) {
            return lost;
        }
        // The goal speaks of the first agent.
        let mut progress = task.begin(world, self.ids[0]);
        let (mut rounds, mut actions, mut idle, mut reasons) = (0, 0, 0, Vec::new());
        while rounds < task.step_limit && idle < IDLE && !progress.holds(world) {
            reasons.clear();
            let done = self.round(task, world, &mut progress, &mut reasons);
            actions += done;
            rounds += 1;
            idle = if done == 0 { idle + 1 } else { 0 };
        }
        let lost = if rounds < task.step_limit { Outcome::Lost } else { Outcome::TimedOut };
        let outcome = if progress.holds(world) { Outcome::Won } else { lost };
        TeamEpisode::ended(outcome, (rounds, actions), reasons, &mut progress, world)
    }

    /// Everybody looks, tells, and acts once; returns how many did something. `reasons` is told why the others did not.
    /// Where actions take time, all decide before they act side by side; else everybody sees what came of the last action.
    fn round(
        &mut self,
        task: &Task,
        world: &mut dyn World,
        progress: &mut GoalProgress,
        reasons: &mut Vec<String>,
    ) -> usize {
        let (mut done, mut decided) = (0, Vec::new());
        for index in 0..self.agents.len() {
            match self.decide(index, world) {
                Decision::Act(action, _) => decided.push((index, action)),
                Decision::GiveUp(why) => reasons.push(explained(&why, task, world.graph())),
                Decision::Done => {}
            }
            if !world.has_clock() {
                done += self.act(&std::mem::take(&mut decided), world, progress, reasons);
            }
        }
        done + self.act(&decided, world, progress, reasons)
    }

    /// An agent looks, hears of what the others see and promise, and decides.
    fn decide(&mut self, index: usize, world: &dyn World) -> Decision {
        self.observe(world);
        if self.agents.len() > 1 {
            let others = (0..self.agents.len()).filter(|&other| other != index);
            let promised = others.flat_map(|other| self.agents[other].promises().to_vec()).collect();
            self.agents[index].count_on(promised);
        }
        self.agents[index].decide()
    }

    /// Lets agents do what they have decided; returns how many did it.
    fn act(
        &mut self,
        decided: &[(usize, Action)],
        world: &mut dyn World,
        progress: &mut GoalProgress,
        reasons: &mut Vec<String>,
    ) -> usize {
        if decided.is_empty() {
            return 0;
        }
        let words: Vec<String> = decided.iter().map(|(_, action)| action.describe(world.graph()).to_string()).collect();
        let actions: Vec<(NodeId, Action)> =
            decided.iter().map(|(index, action)| (self.ids[*index], *action)).collect();
        let outcomes = world.step_together(&actions);
        if outcomes.iter().any(Result::is_ok) {
            progress.note(world);
        }
        let mut done = 0;
        for (((index, action), words), outcome) in decided.iter().zip(&words).zip(outcomes) {
            match outcome {
                Ok(_) => {
                    self.agents[*index].did(action);
                    done += 1;
                }
                Err(why) => {
                    reasons.push(refusal(words, &why));
                    self.agents[*index].refused(action);
                }
            }
        }
        done
    }

    fn observe(&mut self, world: &dyn World) {
        let scope = |agent: &Agent| if agent.belief().knows_all() { Scope::Whole } else { Scope::Room };
        let seen: Vec<_> =
            self.agents.iter().zip(&self.ids).map(|(a, &id)| world.graph().observe(id, scope(a))).collect();
        for (index, agent) in self.agents.iter_mut().enumerate() {
            for (other, seen) in seen.iter().enumerate() {
                if other != index {
                    agent.hear(seen);
                }
            }
            agent.see(&seen[index]);
        }
    }
}

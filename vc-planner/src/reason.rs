//! Reasons: why a task is lost before anybody acts, why an action was refused, why an agent gave up, and why an episode
//! was not won.

use std::collections::BTreeSet;

use vc_graph::{NodeId, Refusal, SceneGraph};
use vc_tasks::{GoalProgress, Outcome, Task, World, WorldError};

use crate::Unreachable;

/// The reason why a task is lost before anybody acts: there is no agent, the goal has a name that stands for nothing,
/// or somebody who is to act is no agent of the scene.
pub(crate) fn hopeless(agents: &[NodeId], task: &Task, graph: &SceneGraph) -> Option<String> {
    let nobody = || agents.is_empty().then(|| "there is no agent to act: the team is empty".to_owned());
    let misnamed = || task.lost(graph).map(|lost| lost.to_string());
    let unfit = |id| graph.node(id).map_or(Refusal::NoSuchThing(id), |node| Refusal::NoAgent(node.label()));
    let outsider = || agents.iter().copied().find(|id| !graph.agents().contains(id));
    nobody().or_else(misnamed).or_else(|| outsider().map(|id| unfit(id).to_string()))
}

/// The reason why an episode was not won: the step limit, or else whatever stopped its agents, each reason once, or
/// else the part of the goal that is broken for good. `None` if it was won, or if agents stopped without a reason.
pub(crate) fn loss(
    outcome: Outcome,
    mut stopped: Vec<String>,
    progress: &mut GoalProgress,
    world: &dyn World,
) -> Option<String> {
    match outcome {
        Outcome::Won => return None,
        Outcome::TimedOut => return Some("step limit reached".to_owned()),
        _ => {}
    }
    let mut told = BTreeSet::new();
    stopped.retain(|reason| told.insert(reason.clone()));
    if stopped.is_empty() {
        stopped.extend(progress.lost(world).map(|lost| lost.to_string()));
    }
    (!stopped.is_empty()).then(|| stopped.join("; "))
}

/// The reason why an action was not done.
pub(crate) fn refusal(action: &str, why: &WorldError) -> String {
    let why = why.to_string();
    let why = why.strip_prefix("refused: ").unwrap_or(&why);
    // Bodies name the action themselves.
    let why = why.strip_prefix(action).and_then(|rest| rest.strip_prefix(": ")).unwrap_or(why);
    format!("`{action}` was refused: {why}")
}

/// The reason why a policy gives up, with the things that the scene, which it need not know, has too few of.
pub(crate) fn explained(reason: &Unreachable, task: &Task, graph: &SceneGraph) -> String {
    let obstacles = match reason {
        Unreachable::NoInstance(_) | Unreachable::Conflicting(_) | Unreachable::NoPlan(_) => task.obstacles(graph),
        _ => Vec::new(),
    };
    let obstacles: Vec<String> = obstacles.iter().map(ToString::to_string).collect();
    if obstacles.is_empty() { reason.to_string() } else { format!("{reason}: {}", obstacles.join("; ")) }
}

//! Objects for the roles of an action that a condition says nothing about: the tap for a glass, the rag for a table.

use crate::rule::condition::Condition;
use crate::rule::effect::Argument;
use crate::rule::table::ActionRule;
use crate::{Action, NodeId, SceneGraph};

/// The number of tools among which a planner can choose: one may be out of reach.
const TOOLS: usize = 3;

/// The action with an object in a role, if its verb has that and it is free: the likeliest object, or the few likeliest
/// tools.
pub(super) fn filled(
    graph: &SceneGraph,
    agent: NodeId,
    rule: &ActionRule,
    action: Action,
    role: Argument,
) -> Vec<Action> {
    let (given, number) = match role {
        Argument::X => (action.object, 1),
        Argument::Y => (action.target, 2),
    };
    if given.is_some() || rule.arity < number {
        return vec![action];
    }
    let with = |id| match role {
        Argument::X => Action { object: Some(id), ..action },
        Argument::Y => Action { target: Some(id), ..action },
    };
    let held = rule.preconditions.contains(&Condition::Holding(role));
    let ids = graph.nodes().map(crate::Node::id).filter(|id| action.things().all(|other| other != *id));
    let ranked = ids.filter_map(|id| Some((cost(graph, agent, rule, &action, &with(id), held.then_some(id))?, id)));
    let mut ranked: Vec<_> = ranked.collect();
    ranked.sort_unstable();
    ranked.into_iter().take(if held { TOOLS } else { 1 }).map(|(_, id)| with(id)).collect()
}

/// How much is missing for an action with an object more: unmet preconditions besides nearness, and the way to a tool.
/// `None` if the object never fits.
fn cost(
    graph: &SceneGraph,
    agent: NodeId,
    rule: &ActionRule,
    before: &Action,
    action: &Action,
    tool: Option<NodeId>,
) -> Option<(usize, (bool, bool, bool))> {
    let new = rule.preconditions.iter().filter(|need| need.ground(before).is_none());
    let unmet: Vec<Condition> =
        new.filter_map(|need| need.ground(action)).filter(|need| !need.holds(graph, agent)).collect();
    let taken = tool.is_none_or(|id| Condition::Graspable(id).holds(graph, agent));
    if !taken || unmet.iter().any(Condition::is_lasting) {
        return None;
    }
    let far =
        |id: NodeId| (!graph.near(agent, id), graph.room_of(id) != graph.room_of(agent), graph.hidden_in(id).is_some());
    let missing = unmet.iter().filter(|need| !matches!(need, Condition::Near(_))).count();
    Some((missing, tool.map(far).unwrap_or_default()))
}

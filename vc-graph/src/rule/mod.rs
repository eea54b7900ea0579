//! The transition rule: what every action needs and does, once.
//!
//! [`table`] lists the verbs; [`condition`] says what they need and [`refusal`] why
//! not, [`effect`] carries out what they do, [`regress`] reads the table backwards. Everybody goes
//! by it: the planner regresses through it, tasks validate with it, and an
//! environment with bodies checks with it before they move.
//!
//! Where a program written for VirtualHome's symbolic simulator is valid there, it
//! is valid here and does the same, except where that simulator is broken:
//!
//! - `find` walks when it must, also for an agent with its hands full;
//! - what an agent carries goes with it, with all that lies on it, and is in the
//!   room where the agent is, not in the one it came from;
//! - `take_off` works and puts the clothes into a hand;
//! - `put_back` refuses when it cannot; a thing taken from nowhere in particular
//!   is put down in the room;
//! - `stand` takes the agent off its seat; sitting is a relation of its own;
//! - pulling the plug of a running machine and watching a hidden screen are
//!   refused;
//! - grabbing what one holds already does nothing, instead of putting it into both
//!   hands;
//! - a surface must be a surface, a container a container, and things must fit
//!   where sizes are known;
//! - fridges and ovens open while they are on;
//! - seats are taken by people, not by the cushions on them.
//!
//! Some programs of others leave it to common sense whether they can be done. Here
//!
//! - a book, a magazine or a sheet carries what is of paper and no larger: a bookmark lies on a novel;
//! - what a scene says is open or closed opens, though its properties do not say so: a desk has drawers;
//! - what a scene says is inside itself is not shut in by itself: a closed basket that is can be opened;
//! - water can be poured over hands, which then hold it;
//! - clothes that are taken off are in hand: whose hands are full of them grabs nothing before one is put down.
//!
//! Their verdicts instead of these are those of [`virtual_home`].

mod check;
pub mod condition;
pub mod effect;
mod fit;
mod judge;
mod legal;
pub mod refusal;
pub mod regress;
pub mod table;
pub mod virtual_home;

pub use condition::Condition;
pub use effect::{Effect, Role};
pub use legal::{legal_actions, legal_actions_with};
pub use refusal::Refusal;
pub use table::Rule;
pub(crate) use virtual_home::Memory;
pub use virtual_home::Semantics;

use crate::{Action, ChangeSet, EditError, NodeId, SceneGraph};

/// What an agent's action needs, as conditions on the graph.
///
/// ```
/// use vc_graph::{Action, Condition, NodeId, Verb, rule};
/// let needs = rule::preconditions(&Action::one(Verb::Grab, NodeId(12)));
/// assert!(needs.contains(&Condition::FreeHandOrHolding(NodeId(12))));
/// assert!(needs.contains(&Condition::Near(NodeId(12))));
/// ```
pub fn preconditions(action: &Action) -> Vec<Condition> {
    action.verb.rule().needs.iter().filter_map(|c| c.ground(action)).collect()
}

/// What an agent's action does, without doing it.
pub fn effects(action: &Action) -> Vec<Effect<NodeId>> {
    action.verb.rule().does.iter().filter_map(|e| e.ground(action)).collect()
}

/// Every reason why an agent cannot do an action now; empty if it can.
pub fn refusals(graph: &SceneGraph, agent: NodeId, action: &Action) -> Vec<Refusal> {
    if let Some(refusal) = check::check_things(graph, agent, action) {
        return vec![refusal];
    }
    let needs = action.verb.rule().needs.iter().filter_map(|c| c.ground(action));
    needs.filter_map(|c| c.check(graph, agent).err()).collect()
}

/// Whether an agent can do an action now: whether it has no [`refusals`]. Stops at the first
/// need that is not met and words no reason, so that it costs a fraction of them.
///
/// ```
/// use vc_graph::{Action, Draft, SceneBuilder, Verb, rule};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// assert!(rule::allows(&graph, me, &Action::one(Verb::Walk, fridge)));
/// assert!(!rule::allows(&graph, me, &Action::one(Verb::Eat, fridge)));
/// # Ok::<(), vc_graph::EditError>(())
/// ```
pub fn allows(graph: &SceneGraph, agent: NodeId, action: &Action) -> bool {
    let mut needs = action.verb.rule().needs.iter().filter_map(|c| c.ground(action));
    check::check_things(graph, agent, action).is_none() && needs.all(|need| need.holds(graph, agent))
}

/// Lets an agent do an action and returns what changed.
///
/// Costs a few microseconds: it touches only the nodes concerned.
///
/// # Errors
/// Every [`Refusal`]; then nothing has changed.
pub fn step(graph: &mut SceneGraph, agent: NodeId, action: &Action) -> Result<ChangeSet, Vec<Refusal>> {
    let refusals = refusals(graph, agent, action);
    if !refusals.is_empty() {
        return Err(refusals);
    }
    let mut edit = graph.edit();
    for effect in action.verb.rule().does.iter().filter_map(|e| e.ground(action)) {
        effect::carry_out(&mut edit, agent, effect).map_err(|e| vec![Refusal::Edit(e)])?;
    }
    Ok(edit.commit())
}

/// Carries out one effect of an action, whether or not the agent could do the action: for what
/// shows an action part by part. Costs as [`step`].
///
/// ```
/// use vc_graph::{Draft, Effect, SceneBuilder, State, rule};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut graph = scene.build();
/// rule::carry_out(&mut graph, me, &Effect::Enter(fridge, State::Open))?;
/// assert!(graph.node(fridge).is_some_and(|n| n.is(State::Open)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`EditError`] if a node is not there, or would be in itself; then nothing has changed.
pub fn carry_out(graph: &mut SceneGraph, agent: NodeId, effect: &Effect<NodeId>) -> Result<ChangeSet, EditError> {
    let mut edit = graph.edit();
    effect::carry_out(&mut edit, agent, *effect)?;
    Ok(edit.commit())
}

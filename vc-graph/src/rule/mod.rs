//! The transition rule: the preconditions and effects of every action, defined once.
//!
//! [`table`] lists the verbs; [`condition`] defines their preconditions and [`refusal`] the reasons for
//! refusals; [`effect`] defines the effects, and [`regress`] reads the table backwards. All parts of
//! VirtualCity use this rule: the planner regresses through it, tasks are validated with it, and an environment
//! with bodies checks it before they move.
//!
//! A program for VirtualHome's symbolic simulator that is valid there is also valid here and has the same
//! effects, except where that simulator has a fault:
//!
//! - `find` walks if necessary, also for an agent with full hands;
//! - objects that an agent carries move with it, with everything on them, and are in the room where the agent
//!   is, not in the one it came from;
//! - `take_off` works and puts the clothes into a hand;
//! - `put_back` is refused if it is impossible; an object that was taken from no particular place is put down
//!   in the room;
//! - `stand` takes the agent off its seat; sitting is a relation of its own;
//! - unplugging a running machine and watching a hidden screen are refused;
//! - grabbing an object that the agent already holds does nothing, instead of putting it into both hands;
//! - only surfaces and containers can be put on and in, and objects must fit if sizes are known;
//! - fridges and ovens can be opened while they are on;
//! - seats are occupied by people, not by the cushions on them.
//!
//! Some programs of other sources rely on common sense for whether they are possible. In VirtualCity
//!
//! - a book, a magazine or a sheet supports paper objects of no larger size: a bookmark lies on a novel;
//! - an object with the state open or closed can be opened, even if its properties do not say so: a desk has
//!   drawers;
//! - an object that by the relations is inside itself is not hidden by itself: such a closed basket can be
//!   opened;
//! - water can be poured over hands, which then hold it;
//! - clothes that are taken off are in the hand: an agent whose hands are full of them cannot grab anything
//!   before it puts one down.
//!
//! An action may have an [`Aim`](crate::Aim): a point, a heading, a seat, a slot or a side. The table says which verbs
//! take which; an aim is then a parameter that the rule judges by poses and boxes, as far as the scene has them. In a
//! scene without poses a point for a thing changes nothing.
//!
//! A scene may have verbs of its own: rows like those of the table, from its [`Vocabulary`].
//!
//! The verdicts of VirtualHome's simulator instead of these are in [`virtual_home`].

mod aim;
mod aim_sets;
mod check;
pub mod condition;
pub mod effect;
mod fit;
mod free_role;
mod implied;
mod judge;
mod legal;
mod motion;
mod perform;
pub mod refusal;
pub mod regress;
pub mod table;
pub mod virtual_home;

pub use aim::{AimForm, AimRule, Aimed};
pub use condition::Condition;
pub use effect::{Argument, Effect};
pub(crate) use implied::{bodiless, is_of_bodies, with_implied};
pub(crate) use legal::Needs;
pub use legal::{legal_actions, legal_actions_with};
pub use motion::Motion;
pub use refusal::Refusal;
pub use table::ActionRule;
pub(crate) use virtual_home::Memory;
pub use virtual_home::Semantics;

use crate::{Action, ChangeSet, EditError, NodeId, SceneGraph, Vocabulary};

/// The preconditions of an agent's action by a vocabulary, as conditions on the graph; none for a verb that it lacks.
///
/// ```
/// use vc_graph::{Action, Condition, NodeId, Verb, Vocabulary, rule};
/// let needs = rule::preconditions(&Vocabulary::builtin(), &Action::one(Verb::Grab, NodeId(12)));
/// assert!(needs.contains(&Condition::FreeHandOrHolding(NodeId(12))));
/// assert!(needs.contains(&Condition::Near(NodeId(12))));
/// ```
pub fn preconditions(words: &Vocabulary, action: &Action) -> Vec<Condition> {
    grounded_needs(words, action).collect()
}

fn grounded_needs(words: &Vocabulary, action: &Action) -> impl Iterator<Item = Condition> {
    let rule = words.rule(action.verb);
    rule.into_iter().flat_map(|rule| rule.preconditions.iter()).filter_map(|need| need.ground(action))
}

/// The effects of an agent's action by a vocabulary, without carrying them out; none for a verb that it lacks.
///
/// ```
/// use vc_graph::{Effect, Vocabulary, rule};
/// let effects = rule::effects(&Vocabulary::builtin(), &"open fridge.2".parse()?);
/// assert!(!effects.is_empty());
/// # Ok::<(), vc_graph::ActionTextError>(())
/// ```
pub fn effects(words: &Vocabulary, action: &Action) -> Vec<Effect<NodeId>> {
    let rule = words.rule(action.verb);
    let own = |rule: &ActionRule| -> Vec<Effect<NodeId>> {
        rule.effects.iter().filter_map(|e| e.ground(action)).chain(rule.aims.effects(action)).collect()
    };
    rule.map(own).unwrap_or_default()
}

/// Every reason why an agent cannot perform an action now; empty if it can.
///
/// ```
/// use vc_graph::rule;
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let why = rule::refusals(&graph, me, &"grab milk.3".parse()?);
/// assert_eq!(why[0].to_string(), "milk.3 is inside fridge.2, which is closed");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refusals(graph: &SceneGraph, agent: NodeId, action: &Action) -> Vec<Refusal> {
    if let Some(refusal) = check::check_things(graph, agent, action) {
        return vec![refusal];
    }
    let unmet = grounded_needs(graph.vocabulary(), action).filter_map(|c| c.check(graph, agent).err());
    unmet.chain(aim::refusals(graph, agent, action)).collect()
}

/// Whether an agent can perform an action now, that is, whether it has no [`refusals`]. Stops at the first
/// unmet precondition and formulates no reason, so it costs a fraction of [`refusals`].
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
    let mut needs = grounded_needs(graph.vocabulary(), action);
    check::check_things(graph, agent, action).is_none()
        && needs.all(|need| need.holds(graph, agent))
        && aim::refusals(graph, agent, action).is_empty()
}

/// Performs an agent's action and returns the changes.
///
/// Costs a few microseconds: it touches only the nodes concerned.
///
/// ```
/// use vc_graph::rule;
/// use vc_graph::{Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let mut graph = scene.build();
/// for line in ["walk apple.3", "grab apple.3"] {
///     rule::step(&mut graph, me, &line.parse()?).map_err(|why| why[0].clone())?;
/// }
/// assert_eq!(graph.held(me).collect::<Vec<_>>(), [apple]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Every [`Refusal`]; then nothing has changed.
pub fn step(graph: &mut SceneGraph, agent: NodeId, action: &Action) -> Result<ChangeSet, Vec<Refusal>> {
    let refusals = refusals(graph, agent, action);
    if !refusals.is_empty() {
        return Err(refusals);
    }
    let effects = effects(graph.vocabulary(), action);
    let mut edit = graph.edit();
    for effect in effects {
        perform::carry_out(&mut edit, agent, effect).map_err(|e| vec![Refusal::Edit(e)])?;
    }
    Ok(edit.commit())
}

/// Carries out one effect of an action, whether or not the agent could perform the action: for displays that
/// show an action in parts. Costs as [`step`].
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
/// [`EditError`] if a node does not exist, or would be inside itself; then nothing has changed.
pub fn carry_out(graph: &mut SceneGraph, agent: NodeId, effect: &Effect<NodeId>) -> Result<ChangeSet, EditError> {
    let mut edit = graph.edit();
    perform::carry_out(&mut edit, agent, *effect)?;
    Ok(edit.commit())
}

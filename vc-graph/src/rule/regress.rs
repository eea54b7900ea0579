//! The rule table read backwards: the actions that would bring about a condition.

use crate::rule::check::origin;
use crate::rule::condition::Condition;
use crate::rule::effect::{Argument, Effect};
use crate::rule::free_role::filled;
use crate::rule::preconditions;
use crate::rule::table::ActionRule;
use crate::{Action, NodeId, Place, Property, Relation, SceneGraph, State, Verb};

/// Actions whose effects make a condition true for an agent, those with the fewest unmet preconditions first.
/// The preconditions are not pursued further: regress through the action's [`preconditions`].
///
/// Empty if no action helps: an apple does not become a surface.
///
/// ```
/// use vc_graph::{rule, Condition, Draft, SceneBuilder};
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// let milk = scene.add_in(fridge, Draft::new("milk"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let graph = scene.build();
/// let how = rule::regress::achievers(&graph, me, &Condition::Accessible(milk));
/// assert_eq!(how[0].describe(&graph).to_string(), "open fridge.2");
/// # Ok::<(), vc_graph::EditError>(())
/// ```
pub fn achievers(graph: &SceneGraph, agent: NodeId, condition: &Condition) -> Vec<Action> {
    let mut found = candidates(graph, agent, condition);
    let unmet = |a: &Action| preconditions(graph.vocabulary(), a).iter().filter(|c| !c.holds(graph, agent)).count();
    // Dropping has the fewest preconditions, but putting down is preferred.
    let with_manners = matches!(condition, Condition::FreeHand | Condition::FreeHandOrHolding(_));
    if found.len() > 1 && found.len() < MANY && !with_manners {
        found.sort_by_cached_key(unmet);
    }
    found
}

/// The number of candidates from which on sorting them costs more than trying them.
const MANY: usize = 16;

fn candidates(graph: &SceneGraph, agent: NodeId, condition: &Condition) -> Vec<Action> {
    match *condition {
        Condition::Accessible(id) => match graph.hidden_in(id) {
            Some(container) => achievers(graph, agent, &Condition::In(container, State::Open)),
            None => Vec::new(),
        },
        Condition::SafeToOpen(id) => achievers(graph, agent, &Condition::In(id, State::Off)),
        Condition::Accepts(id) => achievers(graph, agent, &Condition::In(id, State::Open)),
        Condition::FreeHand => put_downs(graph, agent),
        Condition::FreeHandOrHolding(_) => put_downs(graph, agent),
        Condition::HoldingSomething => grabs(graph, agent, |_| true),
        Condition::HoldingKind(p) => grabs(graph, agent, |id| graph.node(id).is_some_and(|n| n.affords(p))),
        Condition::OriginNear(id) => match origin(graph, id) {
            Some(Place { relation: Relation::Inside, at }) if graph.near(agent, at) => {
                achievers(graph, agent, &Condition::In(at, State::Open))
            }
            Some(place) => achievers(graph, agent, &Condition::Near(place.at)),
            None => Vec::new(),
        },
        Condition::OnHeat(id) => heat(graph, agent, id),
        Condition::InCold(id) => chill(graph, agent, id),
        Condition::Steady(id) => put_downs(graph, agent).into_iter().filter(|a| a.object == Some(id)).collect(),
        Condition::Related(who, hand @ (Relation::HoldsRight | Relation::HoldsLeft), id) if who == agent => {
            into_hand(graph, agent, hand, id)
        }
        Condition::AtRest => rests(graph, agent, None),
        Condition::Aboard => vehicles(graph, agent),
        Condition::In(id, posture @ (State::Sitting | State::Lying)) if id == agent => {
            rests(graph, agent, Some(posture))
        }
        Condition::Related(id, Relation::Inside | Relation::InRoom, room) if graph.rooms().contains(&room) => {
            into_room(graph, agent, id, room)
        }
        _ => graph.vocabulary().rules().flat_map(|rule| by_effect(graph, agent, rule, condition)).collect(),
    }
}

/// The actions of a verb that has an effect which makes the condition true.
fn by_effect(graph: &SceneGraph, agent: NodeId, rule: &ActionRule, condition: &Condition) -> Vec<Action> {
    let Some(bound) = rule.effects.iter().find_map(|e| binding(graph, *e, condition, agent)) else { return Vec::new() };
    let action = match bound {
        Bound::Nothing => Action::zero(rule.verb),
        Bound::One(Argument::X, id) => Action::one(rule.verb, id),
        Bound::One(Argument::Y, id) => Action { target: Some(id), ..Action::zero(rule.verb) },
        Bound::Two(id, at) => Action::two(rule.verb, id, at),
    };
    let with_first = filled(graph, agent, rule, action, Argument::X);
    with_first.into_iter().flat_map(|action| filled(graph, agent, rule, action, Argument::Y)).collect()
}

enum Bound {
    Nothing,
    One(Argument, NodeId),
    Two(NodeId, NodeId),
}

/// The assignment of an effect's roles with which it makes a condition true.
fn binding(graph: &SceneGraph, effect: Effect<Argument>, condition: &Condition, agent: NodeId) -> Option<Bound> {
    use Bound::{Nothing, One, Two};
    use Condition as C;
    match (effect, *condition) {
        (Effect::Enter(role, s) | Effect::EnterWith(role, s), C::In(id, wanted)) if s == wanted => Some(One(role, id)),
        (Effect::Enter(role, s) | Effect::EnterWith(role, s), C::NotIn(id, unwanted))
            if graph.vocabulary().opposites(s).contains(unwanted) =>
        {
            Some(One(role, id))
        }
        (Effect::Leave(role, s), C::NotIn(id, unwanted)) if s == unwanted => Some(One(role, id)),
        (Effect::LeaveOwn(s), C::NotIn(id, unwanted)) if id == agent && s == unwanted => Some(Nothing),
        (Effect::FillWithWater(role), C::In(id, State::Filled)) => Some(One(role, id)),
        (Effect::EnterOwn(s), C::In(id, wanted)) if id == agent && s == wanted => Some(Nothing),
        (Effect::GoTo(role), C::Near(id) | C::SameRoom(id)) => Some(One(role, id)),
        (Effect::GoTo(role), C::Related(who, Relation::Near, id)) if who == agent => Some(One(role, id)),
        (Effect::Hold(role), C::Holding(id)) => Some(One(role, id)),
        (Effect::PutOn(..), C::Related(id, Relation::On, at)) if at != agent && id != agent => Some(Two(id, at)),
        (Effect::PutInto(..), C::Related(id, Relation::Inside, at)) if id != agent => Some(Two(id, at)),
        (Effect::PourInto(..), C::Related(id, Relation::PouredInto, into)) => Some(Two(id, into)),
        (Effect::PutOnBody(role), C::Worn(id)) => Some(One(role, id)),
        (Effect::PutOnBody(role), C::Related(id, Relation::WornBy, who)) if who == agent => Some(One(role, id)),
        (Effect::Face(role), C::Facing(id)) => Some(One(role, id)),
        (Effect::Face(role), C::Related(who, Relation::Facing, id)) if who == agent => Some(One(role, id)),
        (Effect::SitOn(role), C::Related(who, Relation::SittingOn, id)) if who == agent => Some(One(role, id)),
        (Effect::LieOn(role), C::Related(who, Relation::LyingOn, id)) if who == agent => Some(One(role, id)),
        (Effect::StandUp, C::Upright | C::NotSitting | C::NotLying | C::UprightOrNear(_)) => Some(Nothing),
        (Effect::Board(role), C::AboardOf(id)) => Some(One(role, id)),
        (Effect::Board(role), C::Related(who, Relation::Inside, id)) if who == agent => Some(One(role, id)),
        _ => None,
    }
}

/// Ways to free a hand: put a held object on a near surface, else on one in the room, else drop it.
fn put_downs(graph: &SceneGraph, agent: NodeId) -> Vec<Action> {
    let surface = |id: &NodeId| graph.node(*id).is_some_and(|n| n.affords(Property::Surface));
    let usable = |id: &NodeId| surface(id) && !graph.rests_at(*id, agent) && graph.hidden_in(*id).is_none();
    let near = graph.related(agent, Relation::Near).filter(usable);
    let there = graph.room_of(agent).into_iter().flat_map(|room| graph.in_room(room)).filter(usable);
    let at: Vec<NodeId> = near.chain(there).take(3).collect();
    let held: Vec<NodeId> = graph.held(agent).collect();
    let place = |at: &NodeId| held.iter().map(|&id| Action::two(Verb::Place, id, *at)).collect::<Vec<_>>();
    at.iter().flat_map(place).chain(held.iter().map(|&id| Action::one(Verb::Drop, id))).collect()
}

/// Ways to have an object in a particular hand: that hand must be free, and an object in the wrong hand is put
/// down. Since the right hand is filled first, it takes another object first if the left hand is to be filled.
fn into_hand(graph: &SceneGraph, agent: NodeId, hand: Relation, id: NodeId) -> Vec<Action> {
    let occupied = graph.related(agent, hand).next();
    let wrong = graph.held(agent).find(|&held| held == id || Some(held) == occupied);
    match wrong {
        Some(held) => put_downs(graph, agent).into_iter().filter(|a| a.object == Some(held)).collect(),
        None if graph.free_hand(agent) == Some(hand) => vec![Action::one(Verb::Grab, id)],
        None => grabs(graph, agent, |other| other != id && !graph.rests_at(id, other)),
    }
}

/// Ways to hold an object of a kind: near objects first.
fn grabs(graph: &SceneGraph, agent: NodeId, kind: impl Fn(NodeId) -> bool) -> Vec<Action> {
    let graspable = |n: &&crate::Node| n.affords(Property::Graspable) && kind(n.id());
    let mut found: Vec<NodeId> = graph.nodes().filter(graspable).map(crate::Node::id).collect();
    let room = graph.room_of(agent);
    found.sort_by_key(|&id| (!graph.near(agent, id), graph.room_of(id) != room, graph.hidden_in(id).is_some()));
    found.into_iter().map(|id| Action::one(Verb::Grab, id)).collect()
}

/// Ways to sit or lie: the present seat or bed first.
fn rests(graph: &SceneGraph, agent: NodeId, posture: Option<State>) -> Vec<Action> {
    let postures = [(State::Sitting, Property::Sittable, Verb::Sit), (State::Lying, Property::Lieable, Verb::Lie)];
    let room = graph.room_of(agent);
    let mut found = Vec::new();
    for (state, property, verb) in postures {
        if posture.is_none_or(|p| p == state) {
            let fit = graph.nodes().filter(|n| n.affords(property));
            found.extend(fit.map(|n| (n.id(), Action::one(verb, n.id()))));
        }
    }
    found
        .sort_by_cached_key(|&(id, _)| (!graph.rests_at(agent, id), !graph.near(agent, id), graph.room_of(id) != room));
    found.into_iter().map(|(_, action)| action).collect()
}

/// Ways to be in a vehicle: near ones first, then those in the agent's room.
fn vehicles(graph: &SceneGraph, agent: NodeId) -> Vec<Action> {
    let drivable = graph.nodes().filter(|n| n.affords(Property::Drivable));
    let mut found: Vec<NodeId> = drivable.map(crate::Node::id).collect();
    let room = graph.room_of(agent);
    found.sort_by_key(|&id| (!graph.near(agent, id), graph.room_of(id) != room));
    found.into_iter().map(|id| Action::one(Verb::Enter, id)).collect()
}

/// Ways to heat an object: switch on the heater it is on, or put it on one.
fn heat(graph: &SceneGraph, agent: NodeId, id: NodeId) -> Vec<Action> {
    let heats = |n: &NodeId| graph.node(*n).is_some_and(|n| n.affords(Property::Heater));
    if let Some(heater) = graph.support_chain(id).into_iter().find(|n| heats(n)) {
        return achievers(graph, agent, &Condition::In(heater, State::On));
    }
    let heaters = graph.nodes().map(crate::Node::id).filter(heats);
    heaters.flat_map(|at| [Action::two(Verb::Place, id, at), Action::two(Verb::PutIn, id, at)]).collect()
}

/// Ways to cool an object: switch on the cooler it is in, or put it into one.
fn chill(graph: &SceneGraph, agent: NodeId, id: NodeId) -> Vec<Action> {
    let cools = |n: &NodeId| graph.node(*n).is_some_and(|n| n.affords(Property::Cooler));
    let inside = |p: Place| p.relation == Relation::Inside && cools(&p.at);
    if let Some(cooler) = graph.climb(id, &mut { inside }) {
        return achievers(graph, agent, &Condition::In(cooler, State::On));
    }
    let coolers = graph.nodes().map(crate::Node::id).filter(cools);
    coolers.map(|at| Action::two(Verb::PutIn, id, at)).collect()
}

/// Ways to be in a room: walk there; for an object, carry it there and put it down.
fn into_room(graph: &SceneGraph, agent: NodeId, id: NodeId, room: NodeId) -> Vec<Action> {
    if id == agent {
        return vec![Action::one(Verb::Walk, room)];
    }
    let carried = graph.holder(id).is_some_and(|p| p.at == agent);
    match (carried, graph.room_of(agent) == Some(room)) {
        (false, _) => vec![Action::one(Verb::Grab, id)],
        (true, false) => vec![Action::one(Verb::Walk, room)],
        (true, true) => vec![Action::one(Verb::Drop, id)],
    }
}

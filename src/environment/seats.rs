//! Agents that a scene has sitting or lying.

use nalgebra::Point2;
use vc_graph::class::SlotKind;
use vc_graph::{EditError, Effect, Node, NodeId, Place, Pose, Relation, SceneGraph, State, rule};
use vc_physics::{AgentError, Floor, PhysicsWorld, Posture};

use super::{Displaced, astray, make};

/// How far from a seat that no relation names somebody may be said to sit, metres.
const BESIDE: f32 = 0.5;

/// Lets sit or lie who does so by the graph, and stand up who does not. The graph then says the same; those are told
/// who stand, as there is no seat, or the place is taken.
pub(super) fn take(world: &mut PhysicsWorld, graph: &mut SceneGraph) -> Result<Vec<Displaced>, EditError> {
    let mut told = Vec::new();
    for agent in graph.agents().to_vec() {
        let Some(now) = world.posture(agent) else { continue };
        let seat = named(graph, agent).or_else(|| nearest(graph, agent));
        match seat {
            Some(seat) if is_at(now, seat) || settle(world, agent, seat).is_ok() => write(graph, agent, seat)?,
            seat if seat.is_some() || rests(graph, agent).is_some() => {
                told.extend(seat.map(|wanted| Displaced::new(graph, agent, wanted, None)));
                told.extend(astray::told(graph, if seat.is_none() { std::slice::from_ref(&agent) } else { &[] }));
                rule::carry_out(graph, agent, &Effect::StandUp)?;
            }
            _ => {}
        }
        let seated = seat.is_some() && world.posture(agent) != Some(Posture::Standing);
        if let Some(stood) = world.agent(agent).ok().and_then(|agent| agent.stood_before()).filter(|_| !seated) {
            // It is there, and its pose is sound.
            let _ = world.teleport(agent, stood);
        }
    }
    Ok(told)
}

/// Notes for those who sit or lie from where a way leads on. Those for whom there is no such spot stand; they are
/// returned.
pub(super) fn leave_ways(world: &mut PhysicsWorld, graph: &SceneGraph, floor: &Floor) -> Vec<NodeId> {
    let seated: Vec<NodeId> =
        world.agents().filter(|a| world.agent(*a).ok().and_then(|agent| agent.stood_before()).is_some()).collect();
    let base = if seated.is_empty() { None } else { make::base(graph, floor) };
    let leads_on = |feet: &Pose| {
        let at = Point2::from(feet.translation.vector.xy());
        floor.is_free(at) && base.is_none_or(|base| floor.route(base, at).is_some())
    };
    let mut without = Vec::new();
    // They are there, and all poses are sound.
    for agent in seated {
        let mut below = world.pose(agent).unwrap_or_else(Pose::identity);
        below.translation.z = floor.options().level;
        drop(world.set_stood_before(agent, below));
        match world.agent(agent).and_then(|agent| agent.exit_where(leads_on)) {
            Ok(exit) => drop(world.set_stood_before(agent, exit)),
            Err(_) => without.push(agent),
        }
    }
    for &agent in &without {
        let feet = world.pose(agent).unwrap_or_else(Pose::identity);
        drop(world.teleport(agent, feet));
    }
    without
}

/// Lets agents stand by the graph, and tells that they do not sit or lie.
pub(super) fn stand(graph: &mut SceneGraph, agents: &[NodeId]) -> Result<Vec<Displaced>, EditError> {
    let mut told = Vec::new();
    for &agent in agents {
        let wanted = named(graph, agent);
        told.extend(wanted.map(|wanted| Displaced::new(graph, agent, wanted, None)));
        rule::carry_out(graph, agent, &Effect::StandUp)?;
    }
    Ok(told)
}

/// The seat or bed that a relation names.
fn named(graph: &SceneGraph, agent: NodeId) -> Option<Place> {
    let on = |relation| graph.related(agent, relation).next().map(|at| Place { relation, at });
    on(Relation::SittingOn).or_else(|| on(Relation::LyingOn))
}

/// The relation in which somebody is to a seat, by a state.
fn rests(graph: &SceneGraph, agent: NodeId) -> Option<Relation> {
    let node = graph.node(agent)?;
    let lies = node.is(State::Lying).then_some(Relation::LyingOn);
    lies.or_else(|| node.is(State::Sitting).then_some(Relation::SittingOn))
}

/// The nearest seat or bed of one of whom only a state says that it sits or lies.
fn nearest(graph: &SceneGraph, agent: NodeId) -> Option<Place> {
    let relation = rests(graph, agent)?;
    let kind = if relation == Relation::LyingOn { SlotKind::Lie } else { SlotKind::Seat };
    let own = graph.node(agent)?.aabb()?;
    let gap = |n: &Node| n.aabb().map_or(f32::INFINITY, |b| own.gap(&b));
    let seats = graph.nodes().filter(|n| n.slots(kind) > 0 && gap(n) < BESIDE);
    let seat = seats.min_by(|a, b| gap(a).total_cmp(&gap(b)).then(a.id().cmp(&b.id())))?;
    Some(Place { relation, at: seat.id() })
}

fn is_at(posture: Posture, seat: Place) -> bool {
    match posture {
        Posture::Standing => false,
        Posture::Sitting(at, _) => seat == Place { relation: Relation::SittingOn, at },
        Posture::Lying(at, _) => seat == Place { relation: Relation::LyingOn, at },
    }
}

fn settle(world: &mut PhysicsWorld, agent: NodeId, seat: Place) -> Result<(), AgentError> {
    if let Some(feet) =
        world.pose(agent).filter(|_| world.agent(agent).ok().and_then(|agent| agent.stood_before()).is_some())
    {
        world.teleport(agent, feet)?;
    }
    if seat.relation == Relation::SittingOn { world.sit(agent, seat.at, None) } else { world.lie(agent, seat.at) }
}

/// Writes a seat and the posture into the graph, if it does not say both.
fn write(graph: &mut SceneGraph, agent: NodeId, seat: Place) -> Result<(), EditError> {
    let (state, effect) = match seat.relation {
        Relation::SittingOn => (State::Sitting, Effect::SitOn(seat.at)),
        _ => (State::Lying, Effect::LieOn(seat.at)),
    };
    let said = named(graph, agent) == Some(seat) && graph.node(agent).is_some_and(|n| n.is(state));
    if said { Ok(()) } else { rule::carry_out(graph, agent, &effect).map(drop) }
}

//! Observation of bodies into the graph: poses and relations, only of things that have moved.

use vc_graph::{Change, ChangeSet, Edge, EditError, NodeId, Place, Pose, Property, Relation, SceneGraph, State};
use vc_physics::{BodyRole, Hand, PhysicsWorld, Posture};
use vc_relations::threshold::FACING_COSINE;
use vc_relations::{Evidence, NodeEvidence, Relations};

use super::{PhysicalRefusal, Start, boxes};

/// Height of worn things above the wearer's feet, metres.
const WORN: f32 = 0.9;
/// The distance over the floor within which a thing counts as straight above or below: one looks up, metres.
const ABOVE: f32 = 0.1;

/// Writes the poses of all bodies and of worn things into the graph, and returns the nodes whose pose changed.
pub(super) fn write_poses(graph: &mut SceneGraph, world: &PhysicsWorld) -> Result<(Vec<NodeId>, ChangeSet), EditError> {
    write_poses_of(graph, world, &world.nodes(), &[])
}

/// Writes the poses of some bodies and of things that are worn by some agents or are themselves named, and returns the
/// nodes whose pose changed.
pub(super) fn write_poses_of(
    graph: &mut SceneGraph,
    world: &PhysicsWorld,
    bodies: &[NodeId],
    changed: &[NodeId],
) -> Result<(Vec<NodeId>, ChangeSet), EditError> {
    let elsewhere = |(id, pose): &(NodeId, Pose)| graph.node(*id).is_some_and(|n| n.pose() != Some(pose));
    let poses = bodies.iter().filter_map(|id| Some((*id, world.pose(*id)?)));
    let meant = |id: &NodeId, wearer: &NodeId| bodies.binary_search(wearer).is_ok() || changed.contains(id);
    let worn = worn(graph, world).into_iter().filter(|(id, wearer, _)| meant(id, wearer));
    let poses = poses.chain(worn.map(|(id, _, pose)| (id, pose)));
    let moved: Vec<(NodeId, Pose)> = poses.filter(elsewhere).collect();
    let mut edit = graph.edit();
    moved.iter().try_for_each(|(id, pose)| edit.set_pose(*id, Some(*pose)))?;
    Ok((moved.into_iter().map(|(id, _)| id).collect(), edit.commit()))
}

/// Worn things, their wearers and their poses: they have no body and move with their wearer.
fn worn(graph: &SceneGraph, world: &PhysicsWorld) -> Vec<(NodeId, NodeId, Pose)> {
    let at = |agent: NodeId| Some(world.pose(agent)? * Pose::translation(0.0, 0.0, WORN));
    let wearers = world.agents().filter_map(|agent| Some((agent, at(agent)?)));
    let by = |(agent, at)| graph.relating(Relation::WornBy, agent).map(move |id| (id, agent, at));
    wearers.flat_map(by).collect()
}

/// The facts that relations cannot observe: the positions of doors and drawers, and the things that hands
/// carry.
pub(super) fn evidence(world: &PhysicsWorld) -> Evidence {
    let carried = world.nodes().into_iter().filter(|id| is_carried(world, *id));
    let mut evidence = Evidence::default().carrying(carried);
    for id in world.nodes() {
        let parts = (0..).zip(world.parts(id).all()).filter(|(_, part)| part.position != 0.0);
        evidence.positions.extend(parts.map(|(joint, part)| ((id, joint), part.position)));
    }
    evidence
}

/// These facts about one node.
fn evidence_of(world: &PhysicsWorld, node: NodeId) -> NodeEvidence {
    let positions = world.parts(node).all().into_iter().map(|part| part.position).collect();
    NodeEvidence { node, positions, is_carried: is_carried(world, node) }
}

fn is_carried(world: &PhysicsWorld, id: NodeId) -> bool {
    world.role(id) == Some(BodyRole::Carried)
}

/// Observes again the things that have moved or changed, and writes poses and relations into the graph. Returns
/// all nodes whose relations may differ, and the changes.
///
/// `changed` lists the nodes that the rule puts elsewhere. The resulting graph equals that of a scene read
/// anew, whatever the graph said before; a thing that has not moved keeps the places that the scene gave it,
/// and one that only opens keeps all its places. The costs are those of what has been disturbed since the last time.
pub(super) fn look_again(
    graph: &mut SceneGraph,
    start: &Start,
    world: &mut PhysicsWorld,
    relations: &mut Relations,
    changed: &[NodeId],
) -> Result<(Vec<NodeId>, ChangeSet), PhysicalRefusal> {
    let mut disturbed = world.moved();
    // The rule has moved these in the graph, whether or not their bodies have moved.
    disturbed.extend(changed);
    disturbed.sort_unstable();
    disturbed.dedup();
    let (moved, poses) = write_poses_of(graph, world, &disturbed, changed)?;
    let stay = graph.agents().iter().filter(|agent| !moved.contains(agent));
    let faced: Vec<Edge> = stay.flat_map(|agent| faced_by(graph, *agent)).collect();
    let all = [moved.as_slice(), changed].concat();
    // A thing that is put on or used up has lost its body: only the rule names it.
    let evidence: Vec<NodeEvidence> = disturbed.iter().map(|id| evidence_of(world, *id)).collect();
    let read = relations.update_nodes(graph, &all, &evidence).map_err(PhysicalRefusal::from);
    let kept = |graph: &SceneGraph, id: NodeId| {
        boxes::still_at(start, graph, world, id)
            .or_else(|| boxes::unmoved_at(graph, world, id, &moved))
            .or_else(|| boxes::carried_at(graph, world, id))
    };
    let written = read.and_then(|met| Ok((relations.write_except(graph, &met, kept)?, met)));
    if written.is_err() {
        // They have just been written, so they can be taken back; all is read again the next time.
        let _ = poses.undo(graph);
    }
    let (edges, met) = written?;
    let facing = keep_facing(graph, faced);
    world.forget_moved();
    Ok((met, poses.then(edges).then(facing)))
}

/// Adds the places that the rule expects below a cover: a plate on a tablecloth is on the table too, as
/// the rule knows no cloth.
pub(super) fn lay_through(observed: &mut SceneGraph, ruled: &SceneGraph, changed: &[NodeId]) -> ChangeSet {
    let is_cover = |id: NodeId| observed.node(id).is_some_and(|n| n.affords(Property::Cover));
    let on = |id: NodeId, graph: &SceneGraph| graph.related(id, Relation::On).collect::<Vec<NodeId>>();
    let through = |&id: &NodeId| {
        let (wanted, found) = (on(id, ruled), on(id, observed));
        let covered =
            |at: &NodeId| found.iter().any(|c| is_cover(*c) && observed.has(Edge::new(*c, Relation::On, *at)));
        let more: Vec<NodeId> = wanted.into_iter().filter(|at| !found.contains(at) && covered(at)).collect();
        let places = found.into_iter().chain(more.iter().copied()).map(|at| Place { relation: Relation::On, at });
        (!more.is_empty()).then(|| (id, places.collect::<Vec<Place>>()))
    };
    let laid: Vec<(NodeId, Vec<Place>)> = changed.iter().filter_map(through).collect();
    let mut edit = observed.edit();
    // The nodes are there and carry one another already, so this cannot fail.
    laid.into_iter().for_each(|(id, places)| drop(edit.place_as_seen(id, &places, None)));
    edit.commit()
}

/// Writes what an agent's hands hold, and whether it sits or lies, as bodies have it: an own verb may have said
/// otherwise. Returns the changes.
pub(super) fn write_holding_and_posture(graph: &mut SceneGraph, world: &PhysicsWorld, agent: NodeId) -> ChangeSet {
    let hands = [(Hand::Right, Relation::HoldsRight), (Hand::Left, Relation::HoldsLeft)];
    let mut edit = graph.edit();
    for (hand, relation) in hands {
        let held = world.held(agent, hand);
        let said: Vec<NodeId> = edit.graph().related(agent, relation).collect();
        // A thing without a body is held by the rule alone.
        let lost = said.into_iter().filter(|id| Some(*id) != held && world.role(*id).is_some());
        // All of them are there, and hands hold what can be held.
        lost.collect::<Vec<NodeId>>().into_iter().for_each(|id| drop(edit.detach(id)));
        let new = held.filter(|id| !edit.graph().has(Edge::new(agent, relation, *id)));
        new.into_iter().for_each(|id| drop(edit.hold_in(agent, relation, id)));
    }
    let (place, state) = match world.posture(agent) {
        Some(Posture::Sitting(at, _)) => (Some(Place { relation: Relation::SittingOn, at }), State::Sitting),
        Some(Posture::Lying(at, _)) => (Some(Place { relation: Relation::LyingOn, at }), State::Lying),
        _ => (None, State::Sitting),
    };
    let said_to_rest = edit.graph().node(agent).is_some_and(|n| n.is(State::Sitting) || n.is(State::Lying));
    let rests: Vec<Place> = edit.graph().places(agent).filter(|place| place.relation != Relation::On).collect();
    match place {
        Some(place) if !rests.contains(&place) => {
            drop(edit.place(agent, place));
            drop(edit.enter_state(agent, state));
        }
        None if said_to_rest && rests.iter().all(|place| place.relation != Relation::Inside) => {
            drop(edit.detach(agent));
            [State::Sitting, State::Lying, State::Asleep].into_iter().for_each(|s| drop(edit.leave_state(agent, s)));
        }
        _ => {}
    }
    edit.commit()
}

/// The node that a change puts somewhere else.
pub(super) fn holder(change: &Change) -> Option<NodeId> {
    use Change::{Link, Unlink};
    match change {
        Link(e) | Unlink(e) if matches!(e.relation, Relation::HoldsRight | Relation::HoldsLeft) => Some(e.to),
        Link(e) | Unlink(e) if Relation::places().contains(&e.relation) => Some(e.from),
        _ => None,
    }
}

/// The node that the rule has moved by a change: what lies on a thing that is taken goes with it in the graph, and stays
/// behind if something else carries it as well.
pub(super) fn moved_by_rule(change: &Change) -> Option<NodeId> {
    match change {
        Change::Pose { id, .. } => Some(*id),
        change => holder(change),
    }
}

/// The things that an agent faces.
pub(super) fn faced_by(graph: &SceneGraph, agent: NodeId) -> impl Iterator<Item = Edge> {
    graph.related(agent, Relation::Facing).map(move |id| Edge::new(agent, Relation::Facing, id))
}

/// Keeps what agents have turned to, as long as it is before them. Relations know of screens and
/// pictures only that they are faced: one turns to anything.
pub(super) fn keep_facing(observed: &mut SceneGraph, faced: impl IntoIterator<Item = Edge>) -> ChangeSet {
    let lost = |edge: &Edge| !observed.has(*edge) && is_before(observed, edge.from, edge.to);
    let kept: Vec<Edge> = faced.into_iter().filter(lost).collect();
    let mut edit = observed.edit();
    // Both are there.
    kept.into_iter().for_each(|edge| drop(edit.relate(edge)));
    edit.commit()
}

/// Whether a thing is on the side of an agent to which its body is turned; who sits or lies turns
/// the head.
fn is_before(graph: &SceneGraph, agent: NodeId, id: NodeId) -> bool {
    let (Some(body), Some(node)) = (graph.node(agent), graph.node(id)) else { return false };
    let Some(feet) = body.pose() else { return true };
    let Some(at) = node.aabb().map(|b| b.centre()).or_else(|| node.position()) else { return true };
    let way = feet.inverse_transform_point(&at).xy().coords;
    let seated = body.is(State::Sitting) || body.is(State::Lying);
    seated || way.norm() < ABOVE || way.x >= FACING_COSINE * way.norm()
}

//! Poses that an edited graph has kept although it says that things and agents are elsewhere.

use nalgebra::Point2;
use vc_graph::{Aabb, EditError, Node, NodeId, NodeKind, ObjectRole, Place, Pose, Relation, SceneGraph};
use vc_physics::{BodyRole, Floor, PhysicsError, PhysicsWorld};

use super::execute::load_of;
use super::{Displaced, Start, UnplacedReason, alter, outlook};

/// Things whose boxes are farther apart than this are not on or in each other, metres.
const TOUCHING: f32 = 0.02;

/// Where a graph has something: on or in a thing, or in a room.
pub(super) fn said(graph: &SceneGraph, id: NodeId) -> Option<Place> {
    let in_room = || Some(Place { relation: Relation::InRoom, at: graph.room_of(id)? });
    graph.place(id).or_else(in_room)
}

/// The place of a thing in terms of bodies: a room stands for its floor.
pub(super) fn on_floor(graph: &SceneGraph, place: Place) -> Place {
    let of_room = |id: &NodeId| graph.room_of(*id) == Some(place.at);
    let floor = || graph.of_role(ObjectRole::Floor).map(Node::id).find(of_room);
    let floor = graph.rooms().contains(&place.at).then(floor).flatten();
    floor.map_or(place, |at| Place { relation: Relation::On, at })
}

/// Why a thing cannot be put elsewhere, as it is part of the building or the like.
pub(super) fn is_fixed(graph: &SceneGraph, id: NodeId) -> Option<&'static str> {
    let node = graph.node(id).filter(|n| n.kind() == NodeKind::Object)?;
    alter::no_thing(graph.classes().get(node.class())?)
}

/// The place that a graph gives to something whose pose is that of graphs known to be right, and belongs to another
/// place in all of these.
pub(super) fn place(known: &[&SceneGraph], graph: &SceneGraph, id: NodeId) -> Option<Place> {
    let place = said(graph, id)?;
    let pose = graph.node(id)?.pose()?;
    let same = |before: &&&SceneGraph| before.node(id).is_some_and(|n| n.pose() == Some(pose));
    let mut alike = known.iter().filter(same).peekable();
    let is_stale = alike.peek().is_some() && alike.all(|before| is_new(before, graph, id, place));
    is_stale.then_some(place)
}

/// Whether a thing with the same pose in two graphs is at a place in the second, and was not there in the first.
fn is_new(before: &SceneGraph, graph: &SceneGraph, id: NodeId, place: Place) -> bool {
    match place.relation {
        Relation::InRoom => before.room_of(id).is_some_and(|room| room != place.at),
        Relation::On | Relation::Inside => {
            let pose = |graph: &SceneGraph| graph.node(place.at).and_then(|n| n.pose().copied());
            let bounds = |id: NodeId| graph.node(id).and_then(Node::aabb);
            let apart = |(a, b): (Aabb, Aabb)| a.gap(&b) > TOUCHING;
            let elsewhere = pose(before) == pose(graph) || bounds(id).zip(bounds(place.at)).is_none_or(apart);
            before.places(id).all(|p| p != place) && elsewhere
        }
        _ => false,
    }
}

/// Takes along what a thing carries that was moved from a pose to where its body is now. Returns what came along.
pub(super) fn bring_load(
    world: &mut PhysicsWorld,
    graph: &mut SceneGraph,
    (id, before): (NodeId, Pose),
    stays: impl Fn(NodeId) -> bool,
) -> Result<Vec<NodeId>, super::ResetError> {
    let Some(now) = world.pose(id) else { return Ok(Vec::new()) };
    let motion = now * before.inverse();
    let moves = |load: &NodeId| !stays(*load) && world.role(*load).is_some_and(|role| role != BodyRole::Carried);
    let load: Vec<NodeId> = load_of(graph, id).into_iter().filter(moves).collect();
    for &load in &load {
        let Some(pose) = world.pose(load) else { continue };
        take_along(world, (load, motion * pose), id)?;
        set_pose(graph, load, motion * pose)?;
    }
    Ok(load)
}

/// Moves a thing with its carrier, and holds it to that if it was held.
pub(super) fn take_along(
    world: &mut PhysicsWorld,
    (id, pose): (NodeId, Pose),
    carrier: NodeId,
) -> Result<(), PhysicsError> {
    world.place(id, pose)?;
    if world.role(id) == Some(BodyRole::Hung) { world.pin(id, Some(carrier)) } else { Ok(()) }
}

pub(super) fn set_pose(graph: &mut SceneGraph, id: NodeId, pose: Pose) -> Result<(), EditError> {
    let mut edit = graph.edit();
    edit.set_pose(id, Some(pose))?;
    edit.commit();
    Ok(())
}

/// Agents without a pose stand where they began, until they are put where the graph has them.
pub(super) fn lend_agents(start: &SceneGraph, graph: &mut SceneGraph) -> Result<(), EditError> {
    for agent in graph.agents().to_vec() {
        let began = start.node(agent).and_then(|node| node.pose().copied());
        if let Some(pose) = began.filter(|_| graph.node(agent).is_some_and(|node| node.pose().is_none())) {
            set_pose(graph, agent, pose)?;
        }
    }
    Ok(())
}

/// Puts agents where the graph has them. Returns those that were moved, and those for whom there is no room.
pub(super) fn move_agents(
    (start, known): (&Start, &[&SceneGraph]),
    world: &mut PhysicsWorld,
    graph: &mut SceneGraph,
    floor: &Floor,
) -> Result<(Vec<NodeId>, Vec<Displaced>), super::ResetError> {
    let (mut moved, mut told) = (Vec::new(), Vec::new());
    for agent in graph.agents().to_vec() {
        let Some(place) = place(known, graph, agent) else { continue };
        let room = graph.room_of(place.at).filter(|_| place.relation == Relation::InRoom);
        let feet = |p: &Point2<f32>| Pose::translation(p.x, p.y, floor.options().level);
        let stands =
            |p: &Point2<f32>| floor.is_free(*p) && world.standing(agent, &feet(p)).is_ok_and(|there| there.is_free());
        let free = |room: NodeId| move |p: &Point2<f32>| start.room_at(*p) == Some(room) && stands(p);
        let spot = room.and_then(|room| Some((room, feet(&alter::spot_in(graph, floor, room, free(room))?))));
        let Some((room, feet)) = spot else {
            let why = Some(UnplacedReason::NoFloor(graph.label(place.at)));
            told.push(Displaced { why, ..Displaced::new(graph, agent, place, None) });
            continue;
        };
        let turn = outlook::into_room(world, graph, room, (agent, feet.translation.vector.into()));
        let feet = Pose::from_parts(feet.translation, turn);
        if world.teleport(agent, feet).is_ok() {
            set_pose(graph, agent, feet)?;
            moved.push(agent);
        }
    }
    Ok((moved, told))
}

//! Homes of which only boxes are known: shapes for them, poses that stay, places that stay.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{
    Aabb, Asset, Draft, EditError, Kind, Node, NodeId, Place, Pose, Property, Relation, SceneBuilder, SceneGraph,
};
use vc_physics::{Floor, PhysicsError, Role, World};
use vc_procgen::dress::{self, DressError};

use super::{Assets, Elsewhere};
use crate::figure;

/// How far above its support a thing may hover in the scene, metres, and how far it may fall.
const HOVER: f32 = 0.06;
const REST: f32 = 0.002;
/// How far from the box of its place a thing may be, metres.
const BESIDE: f32 = 0.1;
/// A thing that has moved less is still where the scene has it, metres.
const STILL: f32 = 0.02;
/// How far an agent that stands in something is moved aside at most, metres.
const ASIDE: f32 = 2.5;

/// Things of which a scene has only boxes.
pub(super) fn bare(graph: &SceneGraph) -> Vec<NodeId> {
    graph.nodes().filter(|n| vc_geometry::is_bare(n)).map(Node::id).collect()
}

/// Gives a shape to everything that has only a box, and a figure to people. `None` if nothing lacks one.
pub(super) fn shaped(graph: &SceneGraph, assets: Assets) -> Result<Option<SceneGraph>, DressError> {
    if !graph.nodes().any(|n| vc_geometry::is_bare(n) || is_bare_agent(n)) {
        return Ok(None);
    }
    let shaped = match assets {
        Assets::None => peopled(graph, vc_geometry::shapes(graph)),
        Assets::Generated => peopled(&dress::dressed(graph, dress::seed_of(graph))?, BTreeMap::new()),
    };
    shaped.map(Some)
}

/// The scene with shapes for some of it and a figure for people.
fn peopled(graph: &SceneGraph, mut shapes: BTreeMap<NodeId, Asset>) -> Result<SceneGraph, DressError> {
    let mut library = graph.assets().as_ref().clone();
    let material = library.add_material(vc_geometry::material())?;
    let mut builder = SceneBuilder::with_classes(graph.name(), graph.classes().clone());
    for node in graph.nodes() {
        let mut draft = Draft::of(node);
        if let Some(mut asset) = shapes.remove(&node.id()) {
            asset.parts.iter_mut().for_each(|part| part.material = material);
            draft.asset = Some(library.add(asset)?);
            draft.scale = Some(Vector3::repeat(1.0));
        } else if is_bare_agent(node) {
            draft.asset = Some(figure::add_to(&mut library, builder.graph().agents().len())?);
            stand(&mut draft);
        }
        builder.add_with_id(node.id(), draft)?;
    }
    builder.link_all(&graph.edges().collect::<Vec<_>>())?;
    builder.assets(Arc::new(library));
    Ok(builder.build())
}

fn is_bare_agent(node: &Node) -> bool {
    node.kind() == Kind::Agent && node.spec().asset.is_none() && node.spec().bounds.is_some() && node.pose().is_some()
}

/// An agent's pose is where its feet are: at the bottom of its box.
fn stand(draft: &mut Draft) {
    if let (Some(bounds), Some(pose)) = (draft.bounds, draft.pose.as_mut()) {
        let aabb = bounds.aabb(pose);
        let feet = aabb.centre().xy();
        *pose = Pose::from_parts([feet.x, feet.y, aabb.min.z].into(), UnitQuaternion::new(yaw(pose)));
        draft.bounds = Some(figure::bounds());
    }
}

fn yaw(pose: &Pose) -> Vector3<f32> {
    let front = pose.rotation * Vector3::x();
    let angle = vc_graph::portable::Portable::angle_to(front.y, front.x);
    Vector3::z() * angle
}

/// Pins the things that had only boxes and would not stay where they are, as boxes overlap and hover a
/// little. A thing whose place is at another one goes along with that.
pub(super) fn hold(world: &mut World, graph: &SceneGraph, bare: &[NodeId]) -> Result<(), PhysicsError> {
    let loose: Vec<NodeId> = bare.iter().copied().filter(|id| world.role(*id) == Some(Role::Loose)).collect();
    let mut held = Vec::new();
    for id in loose {
        if would_move(world, graph, id)? {
            held.push(id);
        }
    }
    held.into_iter().try_for_each(|id| pin(world, graph, id))
}

/// Puts back and holds what has moved though it was free to stay: a glass that stands on the edge of a
/// mat falls over. Returns whether there was any.
pub(super) fn hold_moved(world: &mut World, graph: &SceneGraph, bare: &[NodeId]) -> Result<bool, PhysicsError> {
    let wanted = |id: &NodeId| Some((*id, *graph.node(*id)?.pose()?));
    let loose = bare.iter().filter(|id| world.role(**id) == Some(Role::Loose)).filter_map(wanted);
    let far = |a: &Pose, b: &Pose| (a.translation.vector - b.translation.vector).norm() > STILL;
    let moved: Vec<(NodeId, Pose)> =
        loose.filter(|(id, pose)| world.pose(*id).is_some_and(|now| far(&now, pose))).collect();
    for (id, pose) in &moved {
        world.place(*id, *pose)?;
        pin(world, graph, *id)?;
    }
    Ok(!moved.is_empty())
}

fn pin(world: &mut World, graph: &SceneGraph, id: NodeId) -> Result<(), PhysicsError> {
    match graph.place(id).filter(|p| p.at != id && world.aabb(p.at).is_some()) {
        Some(place) => world.pin_to(id, place.at),
        None => world.pin(id),
    }
}

/// Whether a thing is where the scene has it only if it is held there.
fn would_move(world: &World, graph: &SceneGraph, id: NodeId) -> Result<bool, PhysicsError> {
    let (Some(pose), Some(own)) = (world.pose(id), world.aabb(id)) else { return Ok(false) };
    let lowered = |by: f32| world.overlaps(id, &(Pose::translation(0.0, 0.0, -by) * pose)).map(|o| !o.is_empty());
    if lowered(0.0)? {
        return Ok(true);
    }
    if lowered(REST)? {
        return Ok(false);
    }
    let at = |p: Place| world.aabb(p.at).is_some_and(|at| meets(&own, &at));
    Ok(lowered(HOVER)? || graph.places(id).any(at))
}

fn meets(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] < b.max[i] + BESIDE && b.min[i] < a.max[i] + BESIDE)
}

/// Moves agents that the scene has standing in something to free floor.
pub(super) fn step_aside(world: &mut World, graph: &SceneGraph, floor: &Floor) -> Result<(), vc_physics::AgentError> {
    for &agent in graph.agents() {
        let Some(feet) = world.pose(agent) else { continue };
        let at = feet.translation.vector.xy().into();
        if let Some(spot) = floor.nearest(at, ASIDE) {
            let level = nalgebra::Translation3::new(spot.x, spot.y, floor.plan().level);
            world.teleport(agent, Pose::from_parts(level, feet.rotation))?;
        }
    }
    Ok(())
}

/// Keeps the places that the scene gives to things that have not moved, even where their boxes say
/// otherwise: a thing that sticks out of a drawer is still in it. Returns all things for which geometry
/// says another place than the scene.
pub(super) fn keep(
    scene: &SceneGraph,
    graph: &mut SceneGraph,
    world: &World,
    bare: &[NodeId],
) -> Result<Vec<Elsewhere>, EditError> {
    let mut told = Vec::new();
    let rests = |p: &Place| matches!(p.relation, Relation::On | Relation::Inside);
    for &id in bare {
        let Some(wanted) = scene.place(id).filter(rests) else { continue };
        if graph.places(id).any(|p| p == wanted) {
            let held = world.role(id) == Some(Role::Hung);
            let counts = |p: &Place| {
                let inside = wanted.relation != Relation::Inside || p.relation == Relation::Inside;
                inside && (!held || scene.places(id).any(|q| q == *p))
            };
            keep_those(graph, id, counts)?;
            continue;
        }
        let now = graph.place(id);
        told.push(Elsewhere { thing: graph.label(id), wanted, now });
        let carried = scene.node(id).is_some_and(|n| n.affords(Property::Graspable));
        if carried && is_still(scene, graph, id) {
            let mut edit = graph.edit();
            match edit.place_as_seen(id, &[wanted], scene.room_of(id)) {
                Ok(()) | Err(EditError::SupportCycle { .. }) => drop(edit.commit()),
                Err(error) => return Err(error),
            }
        }
    }
    Ok(told)
}

/// Keeps those places of a thing that count: a thing in a container is not also on the container's
/// support, and a thing pinned on a plate is not also on the chair that it reaches into.
fn keep_those(graph: &mut SceneGraph, id: NodeId, counts: impl Fn(&Place) -> bool) -> Result<(), EditError> {
    let all: Vec<Place> = graph.places(id).collect();
    let kept: Vec<Place> = all.iter().copied().filter(counts).collect();
    if kept.len() < all.len() {
        let mut edit = graph.edit();
        edit.place_as_seen(id, &kept, None)?;
        edit.commit();
    }
    Ok(())
}

fn is_still(before: &SceneGraph, now: &SceneGraph, id: NodeId) -> bool {
    let at = |graph: &SceneGraph| graph.node(id).and_then(|n| Some(n.pose()?.translation.vector));
    at(before).zip(at(now)).is_some_and(|(a, b)| (a - b).norm() < STILL)
}

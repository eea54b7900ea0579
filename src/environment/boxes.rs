//! Scenes that give only bounding boxes: they get shapes, and keep the poses and places that the scene states.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::{
    Asset, Draft, EditError, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneBuilder, SceneGraph,
};
use vc_physics::{BodyRole, Floor, PhysicsError, PhysicsWorld, Posture};
use vc_procgen::dress::{self, DressError};

use super::{Assets, Displaced, Start};

/// Height above its support at which a thing may hover in the scene, and the distance it may fall, metres.
const HOVER: f32 = 0.06;
const REST: f32 = 0.002;
/// Distance that a thing may have from the box of its place, and the distance at which it has lost its place,
/// metres.
const BESIDE: f32 = 0.1;
const LOST: f32 = 0.3;
/// A thing that has moved less than this is still where the scene has it, metres.
const STILL: f32 = 0.02;
/// A thing that has turned less is still as the scene has it, radians.
const STRAIGHT: f32 = 0.1;
/// The farthest that an agent standing inside something is moved aside, metres.
const ASIDE: f32 = 2.5;

/// The things for which a scene has only boxes.
pub(super) fn bare(graph: &SceneGraph) -> Vec<NodeId> {
    graph.nodes().filter(|n| vc_geometry::is_bare(n)).map(Node::id).collect()
}

/// Whether a scene was saved from an environment: its people have figures. Such a scene is at rest and stays as
/// it is.
pub(super) fn was_at_rest(graph: &SceneGraph) -> bool {
    let has_figure = |id: &NodeId| graph.node(*id).is_some_and(|n| n.spec().asset.is_some() && n.pose().is_some());
    graph.agents().iter().any(has_figure)
}

/// The things that stay where a scene has them: all things of a scene at rest, otherwise those that have only
/// boxes.
pub(super) fn staying(graph: &SceneGraph) -> Vec<NodeId> {
    if !was_at_rest(graph) {
        return bare(graph);
    }
    graph.nodes().filter(|n| n.kind() == NodeKind::Object && n.pose().is_some()).map(Node::id).collect()
}

/// Gives a shape to every thing that has only a box, and a figure to people. Returns `None` if nothing lacks
/// one.
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

/// The scene with the given shapes, and with a figure for each person.
fn peopled(graph: &SceneGraph, mut shapes: BTreeMap<NodeId, Asset>) -> Result<SceneGraph, DressError> {
    let mut library = graph.assets().as_ref().clone();
    let material = library.add_material(vc_geometry::material()).map_err(DressError::Materials)?;
    let mut builder = SceneBuilder::with_classes(graph.name(), graph.classes().clone());
    for node in graph.nodes() {
        let mut draft = Draft::from_node(node);
        if let Some(mut asset) = shapes.remove(&node.id()) {
            asset.parts.iter_mut().for_each(|part| part.material = material);
            draft.asset = Some(library.add(asset).map_err(|error| DressError::Asset { node: node.label(), error })?);
            draft.scale = Some(Vector3::repeat(1.0));
        } else if is_bare_agent(node) {
            let figure = vc_people::add_to(&mut library, builder.graph().agents().len());
            draft.asset = Some(figure.map_err(|error| DressError::Asset { node: node.label(), error })?);
            stand(&mut draft);
        }
        builder.add_with_id(node.id(), draft)?;
    }
    builder.link_all(&graph.edges().collect::<Vec<_>>())?;
    builder.assets(Arc::new(library));
    Ok(builder.build())
}

fn is_bare_agent(node: &Node) -> bool {
    node.kind() == NodeKind::Agent
        && node.spec().asset.is_none()
        && node.spec().bounds.is_some()
        && node.pose().is_some()
}

/// Sets an agent's pose to its feet, at the bottom of its box.
fn stand(draft: &mut Draft) {
    if let (Some(bounds), Some(pose)) = (draft.bounds, draft.pose.as_mut()) {
        let aabb = bounds.aabb(pose);
        let feet = aabb.centre().xy();
        *pose = Pose::from_parts([feet.x, feet.y, aabb.min.z].into(), UnitQuaternion::new(yaw(pose)));
        draft.bounds = Some(vc_people::bounds());
    }
}

fn yaw(pose: &Pose) -> Vector3<f32> {
    let front = pose.rotation * Vector3::x();
    let angle = vc_graph::portable::Portable::angle_to(front.y, front.x);
    Vector3::z() * angle
}

/// Pins things that had only boxes and would move, since boxes overlap and hover a little. A thing whose place
/// is at a pinned thing moves along with it.
pub(super) fn hold(world: &mut PhysicsWorld, graph: &SceneGraph, bare: &[NodeId]) -> Result<(), PhysicsError> {
    let loose: Vec<NodeId> = bare.iter().copied().filter(|id| world.role(*id) == Some(BodyRole::Loose)).collect();
    let mut held = Vec::new();
    for id in loose {
        if would_move(world, graph, id)? {
            held.push(id);
        }
    }
    held.into_iter().try_for_each(|id| pin(world, graph, id))
}

/// Puts loose things that have moved back to their poses in the scene and pins them there: a glass on the edge
/// of a mat would otherwise fall over. If the scene was at rest, things that have lost their support are not
/// put back and fall. Returns whether any was put back.
pub(super) fn hold_moved(
    world: &mut PhysicsWorld,
    graph: &SceneGraph,
    bare: &[NodeId],
    at_rest: bool,
) -> Result<bool, PhysicsError> {
    let wanted = |id: &NodeId| Some((*id, *graph.node(*id)?.pose()?));
    let loose = bare.iter().filter(|id| world.role(**id) == Some(BodyRole::Loose)).filter_map(wanted);
    let supported = |id: &NodeId| !at_rest || is_by_its_place(world, graph, *id);
    let far = |a: &Pose, b: &Pose| (a.translation.vector - b.translation.vector).norm() > STILL;
    let moved: Vec<(NodeId, Pose)> =
        loose.filter(|(id, pose)| world.pose(*id).is_some_and(|now| far(&now, pose)) && supported(id)).collect();
    for (id, pose) in &moved {
        world.place(*id, *pose)?;
        pin(world, graph, *id)?;
    }
    Ok(!moved.is_empty())
}

/// Puts things that have hardly moved to rest exactly where the scene has them, which was at rest, and agents too.
pub(super) fn rest_as(world: &mut PhysicsWorld, graph: &SceneGraph, things: &[NodeId]) -> Result<(), PhysicsError> {
    let near = |now: &Pose, pose: &Pose| {
        let far = (now.translation.vector - pose.translation.vector).norm();
        now != pose && far <= STILL && now.rotation.angle_to(&pose.rotation) <= STRAIGHT
    };
    let wanted = |id: &NodeId| Some((*id, *graph.node(*id)?.pose()?));
    let moves = |id: &&NodeId| match world.posture(**id) {
        Some(posture) => posture == Posture::Standing,
        None => matches!(world.role(**id), Some(BodyRole::Loose | BodyRole::Hung)),
    };
    let all = things.iter().chain(graph.agents()).filter(moves).filter_map(wanted);
    let back: Vec<(NodeId, Pose)> =
        all.filter(|(id, pose)| world.pose(*id).is_some_and(|now| near(&now, pose))).collect();
    if back.is_empty() { Ok(()) } else { world.rest_at(&back) }
}

/// Pins in a newly built world the things that were pinned at the start and are still where they were.
pub(super) fn hold_as(start: &Start, world: &mut PhysicsWorld, graph: &SceneGraph) -> Result<(), PhysicsError> {
    let same = |id: NodeId| graph.place(id) == start.graph.place(id) && is_still(&start.graph, graph, id);
    let held = |id: &NodeId| start.world.role(*id) == Some(BodyRole::Hung) && world.role(*id) == Some(BodyRole::Loose);
    let held: Vec<NodeId> = graph.nodes().map(Node::id).filter(|id| held(id) && same(*id)).collect();
    held.into_iter().try_for_each(|id| pin(world, graph, id))
}

fn pin(world: &mut PhysicsWorld, graph: &SceneGraph, id: NodeId) -> Result<(), PhysicsError> {
    match graph.place(id).filter(|p| p.at != id && world.aabb(p.at).is_some()) {
        Some(place) => world.pin(id, Some(place.at)),
        None => world.pin(id, None),
    }
}

/// Whether a thing stays at its pose in the scene only if it is pinned.
fn would_move(world: &PhysicsWorld, graph: &SceneGraph, id: NodeId) -> Result<bool, PhysicsError> {
    let (Some(pose), Some(own)) = (world.pose(id), world.aabb(id)) else { return Ok(false) };
    let lowered = |by: f32| world.overlaps(id, &(Pose::translation(0.0, 0.0, -by) * pose)).map(|o| !o.is_empty());
    if lowered(0.0)? {
        return Ok(true);
    }
    if lowered(REST)? {
        return Ok(false);
    }
    let at = |p: Place| world.aabb(p.at).is_some_and(|at| own.gap(&at) < BESIDE);
    Ok(lowered(HOVER)? || graph.places(id).any(at))
}

/// Whether a thing is near the place that the scene gives it. A thing at rest that has lost its table falls.
fn is_by_its_place(world: &PhysicsWorld, graph: &SceneGraph, id: NodeId) -> bool {
    let Some(own) = graph.node(id).and_then(Node::aabb) else { return false };
    graph.places(id).any(|p| world.aabb(p.at).is_some_and(|at| own.gap(&at) < LOST))
}

/// Moves agents that stand inside something in the scene to free floor.
pub(super) fn step_aside(
    world: &mut PhysicsWorld,
    graph: &SceneGraph,
    floor: &Floor,
) -> Result<(), vc_physics::AgentError> {
    for &agent in graph.agents() {
        let standing = world.posture(agent) == Some(Posture::Standing);
        let Some(feet) = world.pose(agent).filter(|_| standing) else { continue };
        let at = feet.translation.vector.xy().into();
        if let Some(spot) = floor.nearest(at, ASIDE) {
            let level = nalgebra::Translation3::new(spot.x, spot.y, floor.options().level);
            world.teleport(agent, Pose::from_parts(level, feet.rotation))?;
        }
    }
    Ok(())
}

/// Keeps the places that the scene gives to things that have not moved, even where their boxes say otherwise: a
/// thing that sticks out of a drawer is still in it. Returns all things for which geometry and scene give
/// different places.
pub(super) fn keep(
    scene: &SceneGraph,
    graph: &mut SceneGraph,
    world: &PhysicsWorld,
    bare: &[NodeId],
) -> Result<Vec<Displaced>, EditError> {
    let mut told = Vec::new();
    for &id in bare {
        let Some(wanted) = scene.place(id).filter(rests) else { continue };
        if graph.places(id).any(|p| p == wanted) {
            let held = world.role(id) == Some(BodyRole::Hung);
            let within = nested(graph, id, wanted);
            let counts = |p: &Place| {
                let inside = wanted.relation != Relation::Inside || p.relation == Relation::Inside;
                inside && (!held || within.contains(p) || scene.places(id).any(|q| q == *p))
            };
            keep_those(graph, id, counts)?;
            let more = within.iter().filter(|p| !graph.places(id).any(|q| q == **p)).copied();
            let all: Vec<Place> = graph.places(id).chain(more).collect();
            if all.len() > graph.places(id).count() {
                place_where_possible(graph, id, &all, None)?;
            }
            continue;
        }
        let now = graph.place(id);
        told.push(Displaced::new(graph, id, wanted, now));
        let carried = scene.node(id).is_some_and(|n| n.affords(Property::Graspable));
        if carried && is_still(scene, graph, id) {
            let places: Vec<Place> = std::iter::once(wanted).chain(nested(graph, id, wanted)).collect();
            place_where_possible(graph, id, &places, scene.room_of(id))?;
        }
    }
    Ok(told)
}

/// The containers that contain a thing by geometry and stand at the place that the scene gives the thing
/// itself: peppers that the scene has on the counter are also in the bowl on that counter.
fn nested(graph: &SceneGraph, id: NodeId, wanted: Place) -> Vec<Place> {
    let there = |p: &Place| p.at != wanted.at && graph.rests_at(p.at, wanted.at);
    let inside = |p: &Place| p.relation == Relation::Inside || sticks_out(graph, id, p.at);
    let within = graph.places(id).filter(|p| there(p) && inside(p));
    within.map(|p| Place { relation: Relation::Inside, at: p.at }).collect()
}

/// Whether a thing is wider than the vessel it lies on and reaches below its rim.
fn sticks_out(graph: &SceneGraph, id: NodeId, vessel: NodeId) -> bool {
    let (Some(own), Some(at)) = (graph.node(id), graph.node(vessel)) else { return false };
    let below = own.aabb().zip(at.aabb()).is_some_and(|(own, at)| own.min.z < at.max.z - STILL);
    below && (at.affords(Property::Recipient) || at.affords(Property::Container))
}

/// Gives a thing its places; leaves it unchanged if one of the places rests on the thing itself.
fn place_where_possible(
    graph: &mut SceneGraph,
    id: NodeId,
    places: &[Place],
    room: Option<NodeId>,
) -> Result<(), EditError> {
    let mut edit = graph.edit();
    match edit.place_as_seen(id, places, room) {
        Ok(()) => drop(edit.commit()),
        Err(EditError::SupportCycle { .. }) => {}
        Err(error) => return Err(error),
    }
    Ok(())
}

/// Keeps all places that a scene at rest gives to things that have not moved.
pub(super) fn keep_all(scene: &SceneGraph, graph: &mut SceneGraph) -> Result<(), EditError> {
    for node in scene.nodes().filter(|n| n.kind() == NodeKind::Object) {
        let (id, wanted) = (node.id(), places(scene, node.id()));
        if wanted.iter().all(rests) && is_still(scene, graph, id) && places(graph, id) != wanted {
            place_where_possible(graph, id, &wanted, scene.room_of(id))?;
        }
    }
    Ok(())
}

/// The places of things that differ from those that geometry gives.
pub(super) fn kept(traced: &SceneGraph, graph: &SceneGraph, staying: &[NodeId]) -> BTreeMap<NodeId, Vec<Place>> {
    let differ = |id: &NodeId| places(traced, *id) != places(graph, *id);
    staying.iter().copied().filter(differ).map(|id| (id, places(graph, id))).collect()
}

/// The places that the scene, but not geometry, gives to a thing and that it still has: it lies there as it lay
/// at the start, and nothing has moved it. `None` if geometry decides.
pub(super) fn still_at(start: &Start, graph: &SceneGraph, world: &PhysicsWorld, id: NodeId) -> Option<Vec<Place>> {
    let holds = |p: &Place| graph.places(id).any(|q| q == *p) && lies_as(&start.world, world, id, p.at);
    let still: Vec<Place> = start.kept.get(&id)?.iter().copied().filter(holds).collect();
    (!still.is_empty()).then_some(still)
}

/// The places of a thing that has not moved and whose doors, lids or drawers stand open: these reach over things that
/// it is not on. An agent that sits or lies is on the seat, whatever is beside it.
pub(super) fn unmoved_at(graph: &SceneGraph, world: &PhysicsWorld, id: NodeId, moved: &[NodeId]) -> Option<Vec<Place>> {
    match world.posture(id) {
        Some(Posture::Sitting(at, _)) => return Some(vec![Place { relation: Relation::SittingOn, at }]),
        Some(Posture::Lying(at, _)) => return Some(vec![Place { relation: Relation::LyingOn, at }]),
        Some(Posture::Standing) => return None,
        None => {}
    }
    let open = !moved.contains(&id) && world.parts(id).all().iter().any(|part| part.position != 0.0);
    let places = places(graph, id);
    (open && !places.is_empty() && places.iter().all(rests)).then_some(places)
}

/// The places of a thing that is carried on or in another: it moves with that as one, however both are turned.
pub(super) fn carried_at(graph: &SceneGraph, world: &PhysicsWorld, id: NodeId) -> Option<Vec<Place>> {
    let is_carried = |id: NodeId| world.role(id) == Some(BodyRole::Carried);
    if !is_carried(id) || world.holder(id).is_some() {
        return None;
    }
    let with: Vec<Place> = places(graph, id).into_iter().filter(|place| is_carried(place.at)).collect();
    (!with.is_empty()).then_some(with)
}

/// The places of a thing that has not moved and is fixed to the building: doors that open before it change nothing.
pub(super) fn fixed_at(graph: &SceneGraph, world: &PhysicsWorld, id: NodeId, moved: &[NodeId]) -> Option<Vec<Place>> {
    let places = places(graph, id);
    let fixed = |id: NodeId| world.role(id) == Some(BodyRole::Fixed);
    let attached =
        (fixed(id) || world.role(id) == Some(BodyRole::Hung)) && places.iter().all(|p| rests(p) && fixed(p.at));
    (attached && !moved.contains(&id) && !places.is_empty()).then_some(places)
}

/// Whether the pose of a thing relative to another, or to one of its moving parts, is unchanged.
fn lies_as(before: &PhysicsWorld, now: &PhysicsWorld, id: NodeId, at: NodeId) -> bool {
    let (Some(was), Some(is)) = (before.pose(id), now.pose(id)) else { return false };
    let against = |frame: Pose, pose: &Pose| (frame.inverse() * pose).translation.vector;
    let mut pairs = frames(before, at).into_iter().zip(frames(now, at));
    pairs.any(|(a, b)| (against(a, &was) - against(b, &is)).norm() < STILL)
}

/// The poses of a thing and of its moving parts; a room has the identity.
fn frames(world: &PhysicsWorld, at: NodeId) -> Vec<Pose> {
    let parts = (0..world.parts(at).all().len()).filter_map(|part| world.parts(at).pose(part));
    std::iter::once(world.pose(at).unwrap_or_else(Pose::identity)).chain(parts).collect()
}

fn rests(place: &Place) -> bool {
    matches!(place.relation, Relation::On | Relation::Inside)
}

/// The places of a thing, sorted.
fn places(graph: &SceneGraph, id: NodeId) -> Vec<Place> {
    let mut places: Vec<Place> = graph.places(id).collect();
    places.sort_unstable();
    places
}

/// Keeps those places of a thing for which `counts` is true: a thing in a container is not also on the
/// container's support, and a thing pinned on a plate is not also on the chair that it reaches into.
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

//! Things that a scene has where nothing can be: below or beside its floors, or several in one
//! place. They are put back where the scene says they are, or left out and named.

use std::collections::BTreeSet;

use nalgebra::{Point2, Point3, Vector3};
use vc_graph::{Change, ChangeSet, Node, NodeId, NodeKind, Place, Pose, Relation, SceneBuilder, SceneGraph};
use vc_physics::{BodyRole, Floor, PhysicsWorld, Posture, SpotOrder, SpotSearch};

use super::make::{RINGS, Spaced, around};
use super::settle::come_to_rest;
use super::{Displaced, MakeError, Unplaced, UnplacedReason, make, reset};

/// A thing that is lower than this below its place in the scene has fallen, metres.
const FALL: f32 = 0.1;
/// Where things wait for their place, metres: how low, and how far from each other.
const BELOW: f32 = -200.0;
const APART: f32 = 5.0;
/// Agents whose feet are nearer than this are in one place, metres.
const TOGETHER: f32 = 0.2;
/// A thing that is farther than this from what it is said to be at, or from all that stands still, is astray, metres.
const FAR: f32 = 3.0;

/// Lets a world come to rest. Things that are astray before or after are put to a free spot at the place
/// that the scene gives them; those for which there is none are taken out of the scene, and named.
pub(super) fn calm(world: &mut PhysicsWorld, builder: &mut SceneBuilder) -> Result<Vec<Unplaced>, MakeError> {
    // Steps would take long to part things that are in one place, and would throw them far.
    let mut astray = world.outside();
    astray.extend(world.coinciding());
    astray.extend(far_off(world, builder.graph()));
    let mut left_out = put_back(world, builder, astray)?;
    come_to_rest(world);
    let fallen = fallen(world, builder.graph());
    if !fallen.is_empty() {
        restore(world, builder.graph(), &fallen)?;
        come_to_rest(world);
    }
    // The things that were taken out may have carried others.
    loop {
        let outside = world.outside();
        if outside.is_empty() {
            return Ok(left_out);
        }
        let fell = outside.into_iter().map(|id| (id, UnplacedReason::FellOut)).collect();
        left_out.extend(leave_out(world, builder, fell)?);
        come_to_rest(world);
    }
}

/// Loose things that are far from where the scene says they are, or from the home.
fn far_off(world: &PhysicsWorld, graph: &SceneGraph) -> Vec<NodeId> {
    let free = |id: &NodeId| matches!(world.role(*id), Some(BodyRole::Loose | BodyRole::Hung));
    let fixed = graph.nodes().map(Node::id).filter(|id| world.role(*id) == Some(BodyRole::Fixed));
    let home = fixed.filter_map(|id| world.aabb(id)).reduce(|a, b| a.joined(&b));
    let things = graph.nodes().filter(|n| n.kind() == NodeKind::Object).map(Node::id).filter(free);
    let is_far = |id: &NodeId| {
        let rests = |p: &Place| matches!(p.relation, Relation::On | Relation::Inside);
        let at = graph.place(*id).filter(rests).and_then(|p| world.aabb(p.at)).or(home);
        world.aabb(*id).zip(at).is_some_and(|(own, at)| own.gap(&at) > FAR)
    };
    things.filter(is_far).collect()
}

/// Places, each with the size of a thing for which there was no room. A search that fails takes long.
#[derive(Default)]
struct Full(Vec<(Place, Vector3<f32>)>);

impl Full {
    /// Whether something no larger had no room at a place.
    fn is_for(&self, place: Option<Place>, size: Option<Vector3<f32>>) -> bool {
        let Some((place, size)) = place.zip(size) else { return false };
        self.0.iter().any(|(at, tried)| *at == place && (0..3).all(|k| tried[k] <= size[k]))
    }
}

/// Puts things where the scene says they are; takes out those for which there is no room.
fn put_back(
    world: &mut PhysicsWorld,
    builder: &mut SceneBuilder,
    mut astray: Vec<NodeId>,
) -> Result<Vec<Unplaced>, MakeError> {
    astray.sort_unstable();
    astray.dedup();
    let wanted: Vec<(NodeId, Pose)> = astray.iter().filter_map(|id| Some((*id, world.pose(*id)?))).collect();
    for (index, (id, _)) in wanted.iter().enumerate() {
        world.place(*id, Pose::translation(APART * index as f32, 0.0, BELOW))?;
    }
    let (mut lost, mut full) = (Vec::new(), Full::default());
    for (id, pose) in wanted {
        let near = SpotOrder::Near(Point3::from(pose.translation.vector));
        let (place, size) = (builder.graph().place(id), world.aabb(id).map(|b| b.max - b.min));
        let found = if full.is_for(place, size) { None } else { spot(world, builder.graph(), id, near)? };
        match found {
            Some(spot) => {
                world.place(id, spot)?;
                let mut edit = builder.edit();
                edit.set_pose(id, Some(spot))?;
                edit.commit();
            }
            None => {
                full.0.extend(place.zip(size));
                let why =
                    place.map_or(UnplacedReason::Astray, |place| reset::no_spot(world, builder.graph(), id, place));
                lost.push((id, why));
            }
        }
    }
    leave_out(world, builder, lost)
}

/// A free spot for a thing where a scene says it is.
fn spot(world: &PhysicsWorld, graph: &SceneGraph, id: NodeId, order: SpotOrder) -> Result<Option<Pose>, MakeError> {
    let there = |place: &Place| world.aabb(place.at).is_some();
    let Some(place) = graph.place(id).filter(there) else { return Ok(None) };
    Ok(SpotSearch::new(id, place.at, place.relation == Relation::Inside).order(order).find(world)?)
}

/// Things that lie deeper than the scene has them, or outside.
fn fallen(world: &PhysicsWorld, graph: &SceneGraph) -> Vec<NodeId> {
    let drop = |n: &Node| Some(n.position()?.z - world.pose(n.id())?.translation.z);
    let things = graph.nodes().filter(|n| n.kind() == NodeKind::Object);
    let mut fallen: Vec<NodeId> = things.filter(|n| drop(n).is_some_and(|d| d > FALL)).map(Node::id).collect();
    fallen.extend(world.outside());
    fallen.sort_unstable();
    fallen.dedup();
    fallen
}

/// Puts each fallen thing to a free spot at its place in the scene, if there is one.
fn restore(world: &mut PhysicsWorld, graph: &SceneGraph, fallen: &[NodeId]) -> Result<(), MakeError> {
    for &id in fallen {
        if let Some(spot) = spot(world, graph, id, SpotOrder::Middle)? {
            world.place(id, spot)?;
        }
    }
    Ok(())
}

/// Takes things out of the scene, and tells which and why.
fn leave_out(
    world: &mut PhysicsWorld,
    builder: &mut SceneBuilder,
    lost: Vec<(NodeId, UnplacedReason)>,
) -> Result<Vec<Unplaced>, MakeError> {
    let told = lost.iter().map(|(id, why)| Unplaced { thing: builder.graph().label(*id), why: why.clone() }).collect();
    for (id, _) in lost {
        world.remove(id)?;
        let mut edit = builder.edit();
        edit.remove(id)?;
        edit.commit();
    }
    Ok(told)
}

/// A thing that has moved and is outside the home now, other than some that nobody answers for.
pub(super) fn fell_out(world: &PhysicsWorld, changes: &ChangeSet, but: &BTreeSet<NodeId>) -> Option<NodeId> {
    let moved = changes.changes().iter().filter_map(|change| match change {
        Change::Pose { id, .. } => Some(*id),
        _ => None,
    });
    let free = |id: &NodeId| matches!(world.role(*id), Some(BodyRole::Loose | BodyRole::Hung | BodyRole::Stopped));
    let free: Vec<NodeId> = moved.filter(free).filter(|id| !but.contains(id)).collect();
    free.into_iter().find(|id| world.body(*id).is_ok_and(|body| body.is_outside()))
}

/// Puts agents that the scene has where no floor is, in walls or furniture, or several in one place, to the nearest
/// free places on the floor. Returns those that were moved.
pub(super) fn stand_on_floor(world: &mut PhysicsWorld, graph: &SceneGraph, floor: &Floor) -> Vec<NodeId> {
    let (mut taken, mut moved, mut base) = (Spaced::new(&[]), Vec::new(), None);
    for agent in world.agents().collect::<Vec<_>>() {
        let standing = world.posture(agent) == Some(Posture::Standing);
        let Some(feet) = world.pose(agent).filter(|_| standing) else { continue };
        let own = Point2::from(feet.translation.vector.xy());
        let on_floor = !world.agent(agent).is_ok_and(|agent| agent.is_off_floor());
        let together = taken.has_within(&own, TOGETHER);
        // Others in the same place are no furniture.
        if on_floor && !together && !world.agent(agent).is_ok_and(|agent| agent.is_stuck()) {
            taken.take(own);
            continue;
        }
        let start = if on_floor { Some(own) } else { floor.nearest(own, f32::INFINITY) };
        let Some(start) = start else { continue };
        let free = || {
            let spots = (0..RINGS).flat_map(move |ring| around(&start, ring));
            spots.filter(|p| floor.is_free(*p) && taken.is_free(p))
        };
        // A spot from which the home is reached comes before one behind a wall.
        let base = *base.get_or_insert_with(|| make::base(graph, floor).unwrap_or(start));
        let reached = free().find(|p| floor.route(base, *p).is_some());
        let Some(spot) = reached.or_else(|| free().next()) else { continue };
        taken.take(spot);
        let to = Pose::from_parts([spot.x, spot.y, floor.options().level].into(), feet.rotation);
        if world.teleport(agent, to).is_ok() {
            moved.push(agent);
        }
    }
    moved
}

/// The entries of a report for agents that were put onto the floor or apart: they are no longer where the graph had them.
pub(super) fn told(graph: &SceneGraph, agents: &[NodeId]) -> Vec<Displaced> {
    let in_room = |agent: NodeId| Some(Place { relation: Relation::InRoom, at: graph.room_of(agent)? });
    let tell = |&agent: &NodeId| Some(Displaced::new(graph, agent, in_room(agent)?, None));
    agents.iter().filter_map(tell).collect()
}

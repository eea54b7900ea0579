//! Carrying out the effects of actions.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

use crate::node::NodeKind;
use crate::portable::Portable;
use crate::rule::aim::{floor_at, room_at};
use crate::rule::check::{origin, vehicle_of};
use crate::rule::effect::Effect;
use crate::{Aim, Edge, Edit, EditError, NodeId, Place, Pose, Property, Relation, SceneGraph, State};

/// Distance from an object at which an agent stops, metres.
const STAND_OFF: f32 = 0.4;
/// Position of a hand relative to the agent's pose, in front of the body and above the floor, metres.
const HAND: Vector3<f32> = Vector3::new(0.3, 0.0, 1.0);

/// Carries out an effect. Poses, if the scene has them, are updated approximately: bodies and exact geometry
/// are the subject of vc-physics.
pub(super) fn carry_out(edit: &mut Edit<'_>, agent: NodeId, effect: Effect<NodeId>) -> Result<(), EditError> {
    match effect {
        Effect::Enter(id, state) => edit.enter_state(id, state),
        Effect::EnterWith(id, state) => enter_with(edit, id, state),
        Effect::Leave(id, state) => edit.leave_state(id, state),
        Effect::EnterOwn(state) => edit.enter_state(agent, state),
        Effect::LeaveOwn(state) => edit.leave_state(agent, state),
        Effect::GoTo(id) => go_to(edit, agent, id),
        Effect::Approach(id) if edit.graph().near(agent, id) => {
            edit.unrelate(agent, &[Relation::Facing])?;
            edit.relate(Edge::new(agent, Relation::Near, id))
        }
        Effect::Approach(id) => go_to(edit, agent, id),
        Effect::Face(id) => {
            edit.unrelate(agent, &[Relation::Facing])?;
            edit.relate(Edge::new(agent, Relation::Facing, id))
        }
        Effect::Hold(id) => hold(edit, agent, id),
        Effect::PutOn(id, at) => put(edit, agent, id, Place { relation: Relation::On, at }),
        Effect::PutInto(id, at) => put(edit, agent, id, Place { relation: Relation::Inside, at }),
        Effect::PutWhereItWas(id) => match origin(edit.graph(), id) {
            Some(place) => put(edit, agent, id, place),
            None => let_go(edit, id),
        },
        Effect::LetGo(id) => let_go(edit, id),
        Effect::SitOn(id) => rest_on(edit, agent, id, Relation::SittingOn, State::Sitting),
        Effect::LieOn(id) => rest_on(edit, agent, id, Relation::LyingOn, State::Lying),
        Effect::StandUp => stand_up(edit, agent),
        Effect::PourInto(id, into) => pour(edit, id, into),
        Effect::FillWithWater(id) => edit.fill(id, Some("water".into())),
        Effect::PutOnBody(id) => {
            forget_origin(edit, id)?;
            edit.place(id, Place { relation: Relation::WornBy, at: agent })
        }
        Effect::Board(id) => {
            edit.place(agent, Place { relation: Relation::Inside, at: id })?;
            edit.enter_state(agent, State::Sitting)
        }
        Effect::Alight => alight(edit, agent),
        Effect::DriveTo(vehicle, to) => drive(edit, vehicle, to),
        Effect::GoToPoint(aim) => go_to_point(edit, agent, &aim),
        Effect::StandAs(aim) => stand_as(edit, agent, &aim),
        Effect::TurnAs(aim) => turn_as(edit, agent, &aim),
        Effect::PoseAs(id, aim) => pose_as(edit, id, &aim),
    }
}

/// Ends nearness to the previous surroundings and takes held objects to a point, which the agent then faces as it came.
fn go_to_point(edit: &mut Edit<'_>, agent: NodeId, aim: &Aim) -> Result<(), EditError> {
    let Some(room) = aim.point().and_then(|point| room_at(edit.graph(), &point)) else { return Ok(()) };
    leave_behind(edit, agent);
    edit.move_to_room(agent, room)?;
    let held: Vec<NodeId> = edit.graph().held(agent).collect();
    held.into_iter().try_for_each(|thing| edit.relate(Edge::new(agent, Relation::Near, thing)))?;
    turn_as(edit, agent, aim)
}

fn stand_as(edit: &mut Edit<'_>, agent: NodeId, aim: &Aim) -> Result<(), EditError> {
    let Some(mut pose) = edit.graph().node(agent).and_then(|n| n.pose()).copied() else { return Ok(()) };
    if let Some(point) = aim.point() {
        (pose.translation.x, pose.translation.y) = (point.plan().x, point.plan().y);
        let floor = edit.graph().room_of(agent).and_then(|room| floor_at(edit.graph(), room, &point.plan()));
        // Without a height the agent stays on its storey.
        pose.translation.z = point.height().and(floor).unwrap_or(pose.translation.z);
    }
    pose.rotation = aim.heading().map_or(pose.rotation, |heading| heading.rotation());
    edit.carry_to(agent, pose)
}

/// Somebody who sits or lies turns no more than the head.
fn turn_as(edit: &mut Edit<'_>, agent: NodeId, aim: &Aim) -> Result<(), EditError> {
    let Some(body) = edit.graph().node(agent) else { return Ok(()) };
    if body.is(State::Sitting) || body.is(State::Lying) {
        return Ok(());
    }
    let pose = body.pose().copied();
    edit.unrelate(agent, &[Relation::Facing])?;
    let Some(pose) = pose else { return Ok(()) };
    let turn = aim.turn_from(&pose.translation.vector.xy().into()).unwrap_or(pose.rotation);
    edit.carry_to(agent, Isometry3::from_parts(pose.translation, turn))
}

/// Puts an object to where an aim says, at the height at which it is.
fn pose_as(edit: &mut Edit<'_>, id: NodeId, aim: &Aim) -> Result<(), EditError> {
    let Some(node) = edit.graph().node(id) else { return Ok(()) };
    let Some(mut pose) = node.pose().copied() else { return Ok(()) };
    let base = |pose: &Pose| node.spec().bounds.map_or(pose.translation.z, |b| b.aabb(pose).min.z);
    let stands = aim.point().and_then(|point| point.height()).unwrap_or_else(|| base(&pose));
    if let Some(point) = aim.point() {
        (pose.translation.x, pose.translation.y) = (point.plan().x, point.plan().y);
    }
    pose.rotation = aim.heading().map_or(pose.rotation, |heading| heading.rotation());
    pose.translation.z += stands - base(&pose);
    edit.carry_to(id, pose)
}

fn enter_with(edit: &mut Edit<'_>, id: NodeId, state: State) -> Result<(), EditError> {
    let object = |id: &NodeId| edit.graph().node(*id).is_some_and(|n| n.kind() == NodeKind::Object);
    let all: Vec<NodeId> = edit.graph().carried_with(id).into_iter().filter(object).collect();
    all.into_iter().try_for_each(|id| edit.enter_state(id, state))
}

const NEARNESS: [Relation; 5] =
    [Relation::Near, Relation::NearFront, Relation::NearBack, Relation::NearLeft, Relation::NearRight];

/// Ends nearness to the previous surroundings and adds it to the destination's, taking held objects along.
fn go_to(edit: &mut Edit<'_>, agent: NodeId, id: NodeId) -> Result<(), EditError> {
    let Some(room) = edit.graph().room_of(id) else { return Ok(()) };
    leave_behind(edit, agent);
    edit.move_to_room(agent, room)?;
    let mut near: Vec<NodeId> = edit.graph().held(agent).collect();
    if room != id {
        near.push(id);
        near.extend(at_hand_with(edit.graph(), id));
    }
    for thing in near.into_iter().filter(|&thing| thing != agent) {
        edit.relate(Edge::new(agent, Relation::Near, thing))?;
    }
    match stand_point(edit.graph(), agent, id) {
        Some(pose) => edit.carry_to(agent, pose),
        None => Ok(()),
    }
}

/// Removes the nearness relations between the objects that move with a node and those that stay, and its
/// facing.
fn leave_behind(edit: &mut Edit<'_>, id: NodeId) {
    let moved = edit.graph().carried_with(id);
    let mut ended = Vec::new();
    for &part in &moved {
        let Some(node) = edit.graph().node(part) else { continue };
        let stays = |id: NodeId| !moved.contains(&id);
        for relation in NEARNESS {
            ended.extend(node.out(relation).filter(|&to| stays(to)).map(|to| Edge::new(part, relation, to)));
            ended.extend(node.inc(relation).filter(|&from| stays(from)).map(|from| Edge::new(from, relation, part)));
        }
        ended.extend(node.out(Relation::Facing).map(|to| Edge::new(part, Relation::Facing, to)));
    }
    ended.into_iter().for_each(|edge| edit.unlink(edge));
}

/// The objects that an agent comes near together with an object: those on it, those inside it unless it is
/// closed, and those that it is inside.
fn at_hand_with(graph: &SceneGraph, id: NodeId) -> Vec<NodeId> {
    let openable = |id: &NodeId| graph.node(*id).is_some_and(|n| n.affords(Property::Openable));
    let shut = graph.node(id).is_none_or(crate::Node::hides_contents);
    let inside = graph.relating(Relation::Inside, id).filter(|_| openable(&id) && !shut);
    let around = graph.related(id, Relation::Inside);
    graph.relating(Relation::On, id).chain(inside).chain(around).collect()
}

/// A pose on the floor in front of an object and facing it, or in the middle of a room.
fn stand_point(graph: &SceneGraph, agent: NodeId, id: NodeId) -> Option<Pose> {
    let body = graph.node(agent)?;
    let (from, target) = (body.position()?, graph.node(id)?);
    let aabb = target.aabb();
    let centre = aabb.map_or_else(|| target.position(), |b| Some(b.centre()))?;
    if target.kind() == NodeKind::Room {
        return Some(facing(Point3::new(centre.x, centre.y, from.z), centre - from));
    }
    let nearest = aabb.map_or(centre, |b| b.nearest(&from));
    let away = Vector3::new(from.x - nearest.x, from.y - nearest.y, 0.0);
    let back = away.try_normalize(1e-3).unwrap_or_else(Vector3::x);
    let gap = away.norm().min(STAND_OFF);
    let spot = Point3::new(nearest.x, nearest.y, from.z) + back * gap;
    Some(facing(spot, centre - spot))
}

fn facing(at: Point3<f32>, towards: Vector3<f32>) -> Pose {
    let yaw = towards.y.angle_to(towards.x);
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw);
    Isometry3::from_parts(Translation3::from(at.coords), turn)
}

fn hold(edit: &mut Edit<'_>, agent: NodeId, id: NodeId) -> Result<(), EditError> {
    if edit.graph().holder(id).is_some_and(|p| p.at == agent) {
        return Ok(());
    }
    let origin = edit.graph().place(id);
    edit.unrelate(id, &NEARNESS)?;
    edit.hold(agent, id)?;
    edit.relate(Edge::new(agent, Relation::Near, id))?;
    forget_origin(edit, id)?;
    if let Some(Place { relation, at }) = origin {
        let kept = match relation {
            Relation::On => Some(Relation::TakenOff),
            Relation::Inside => Some(Relation::TakenOut),
            _ => None,
        };
        if let Some(kept) = kept {
            edit.relate(Edge::new(id, kept, at))?;
            edit.relate(Edge::new(agent, Relation::Near, at))?;
        }
    }
    match edit.graph().node(agent).and_then(|n| n.pose()).copied() {
        Some(pose) => edit.carry_to(id, pose * Translation3::from(HAND)),
        None => Ok(()),
    }
}

fn forget_origin(edit: &mut Edit<'_>, id: NodeId) -> Result<(), EditError> {
    edit.unrelate(id, &[Relation::TakenOff, Relation::TakenOut])
}

fn put(edit: &mut Edit<'_>, agent: NodeId, id: NodeId, place: Place) -> Result<(), EditError> {
    forget_origin(edit, id)?;
    edit.place(id, place)?;
    edit.relate(Edge::new(agent, Relation::Near, place.at))?;
    edit.relate(Edge::new(id, Relation::Near, place.at))?;
    match rest_pose(edit.graph(), id, place) {
        Some(pose) => edit.carry_to(id, pose),
        None => Ok(()),
    }
}

/// The approximate pose of a placed object: in the middle of the top, or of the inside.
fn rest_pose(graph: &SceneGraph, id: NodeId, place: Place) -> Option<Pose> {
    let node = graph.node(id)?;
    let aabb = graph.node(place.at)?.aabb()?;
    let (centre, pose) = (aabb.centre(), node.pose()?);
    let floor = if place.relation == Relation::On { aabb.max.z } else { aabb.min.z + 0.01 };
    let base = node.aabb().map_or(0.0, |b| pose.translation.z - b.min.z);
    let spot = Translation3::new(centre.x, centre.y, floor + base);
    Some(Isometry3::from_parts(spot, pose.rotation))
}

fn let_go(edit: &mut Edit<'_>, id: NodeId) -> Result<(), EditError> {
    forget_origin(edit, id)?;
    edit.detach(id)?;
    let Some(node) = edit.graph().node(id) else { return Ok(()) };
    let floor = edit.graph().room_of(id).and_then(|r| edit.graph().node(r)?.aabb()).map(|b| b.min.z);
    match (node.pose().copied(), node.aabb(), floor) {
        (Some(mut pose), Some(aabb), Some(floor)) => {
            pose.translation.z += floor - aabb.min.z;
            edit.carry_to(id, pose)
        }
        _ => Ok(()),
    }
}

fn rest_on(
    edit: &mut Edit<'_>,
    agent: NodeId,
    seat: NodeId,
    relation: Relation,
    posture: State,
) -> Result<(), EditError> {
    edit.place(agent, Place { relation, at: seat })?;
    edit.enter_state(agent, posture)?;
    if relation == Relation::SittingOn {
        let faced: Vec<NodeId> = edit.graph().related(seat, Relation::Facing).collect();
        for thing in faced {
            edit.relate(Edge::new(agent, Relation::Facing, thing))?;
        }
    }
    Ok(())
}

fn stand_up(edit: &mut Edit<'_>, agent: NodeId) -> Result<(), EditError> {
    let seats: Vec<NodeId> = edit.graph().places(agent).map(|p| p.at).collect();
    edit.detach(agent)?;
    for state in [State::Sitting, State::Lying, State::Asleep] {
        edit.leave_state(agent, state)?;
    }
    seats.into_iter().try_for_each(|seat| edit.relate(Edge::new(agent, Relation::Near, seat)))
}

/// Pouring fills the target. Water is itself the liquid: it leaves the hand and is then inside the target; for
/// a bottle only the relation `poured_into` is recorded.
fn pour(edit: &mut Edit<'_>, id: NodeId, into: NodeId) -> Result<(), EditError> {
    let Some(node) = edit.graph().node(id) else { return Ok(()) };
    let (class, vessel) = (node.class().clone(), node.contents().cloned());
    edit.fill(into, Some(vessel.clone().unwrap_or_else(|| class.clone())))?;
    if &*class == "water" {
        return edit.place(id, Place { relation: Relation::Inside, at: into });
    }
    if vessel.is_some() {
        edit.fill(id, None)?;
    }
    edit.relate(Edge::new(id, Relation::PouredInto, into))
}

fn alight(edit: &mut Edit<'_>, agent: NodeId) -> Result<(), EditError> {
    let vehicle = vehicle_of(edit.graph(), agent);
    stand_up(edit, agent)?;
    vehicle.map_or(Ok(()), |v| edit.relate(Edge::new(agent, Relation::Near, v)))
}

fn drive(edit: &mut Edit<'_>, vehicle: NodeId, to: NodeId) -> Result<(), EditError> {
    edit.detach(vehicle)?;
    leave_behind(edit, vehicle);
    if let Some(room) = edit.graph().room_of(to) {
        edit.move_to_room(vehicle, room)?;
        if room != to {
            edit.relate(Edge::new(vehicle, Relation::Near, to))?;
        }
    }
    let spot = edit.graph().node(to).and_then(|n| n.pose()).map(|p| p.translation);
    let pose = edit.graph().node(vehicle).and_then(|n| n.pose()).copied();
    match (spot, pose) {
        (Some(spot), Some(pose)) => edit.carry_to(vehicle, Isometry3::from_parts(spot, pose.rotation)),
        _ => Ok(()),
    }
}

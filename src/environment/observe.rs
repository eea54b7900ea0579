//! Observation of bodies into the graph: poses and relations, only of things that have moved.

use vc_graph::{ChangeSet, EditError, NodeId, Pose, Relation, SceneGraph};
use vc_physics::{BodyRole, PhysicsWorld};
use vc_relations::{Evidence, Relations};

use super::{PhysicalRefusal, Start, boxes};

/// Height of worn things above the wearer's feet, metres.
const WORN: f32 = 0.9;

/// Writes the poses of bodies and of worn things into the graph, and returns the nodes whose pose changed.
pub(super) fn write_poses(graph: &mut SceneGraph, world: &PhysicsWorld) -> Result<(Vec<NodeId>, ChangeSet), EditError> {
    let elsewhere = |(id, pose): &(NodeId, Pose)| graph.node(*id).is_some_and(|n| n.pose() != Some(pose));
    let poses = world.poses().into_iter().chain(worn(graph, world));
    let moved: Vec<(NodeId, Pose)> = poses.filter(elsewhere).collect();
    let mut edit = graph.edit();
    moved.iter().try_for_each(|(id, pose)| edit.set_pose(*id, Some(*pose)))?;
    Ok((moved.into_iter().map(|(id, _)| id).collect(), edit.commit()))
}

/// Worn things with their poses: they have no body and move with their wearer.
fn worn(graph: &SceneGraph, world: &PhysicsWorld) -> Vec<(NodeId, Pose)> {
    let at = |agent: NodeId| Some(world.pose(agent)? * Pose::translation(0.0, 0.0, WORN));
    let wearers = world.agents().filter_map(|agent| Some((agent, at(agent)?)));
    wearers.flat_map(|(agent, at)| graph.relating(Relation::WornBy, agent).map(move |id| (id, at))).collect()
}

/// The facts that relations cannot observe: the positions of doors and drawers, and the things that hands
/// carry.
pub(super) fn evidence(world: &PhysicsWorld) -> Evidence {
    let carried = world.nodes().into_iter().filter(|id| world.role(*id) == Some(BodyRole::Carried));
    let mut evidence = Evidence::default().carrying(carried);
    for id in world.nodes() {
        for (joint, part) in (0..).zip(world.parts(id).all()) {
            if part.position != 0.0 {
                evidence.positions.insert((id, joint), part.position);
            }
        }
    }
    evidence
}

/// Observes again the things that have moved or changed, and writes poses and relations into the graph. Returns
/// all nodes whose relations may differ, and the changes.
///
/// `changed` lists the nodes that the rule puts elsewhere. The resulting graph equals that of a scene read
/// anew, whatever the graph said before; a thing that has not moved keeps the places that the scene gave it,
/// and one that only opens keeps all its places.
pub(super) fn look_again(
    graph: &mut SceneGraph,
    start: &Start,
    world: &PhysicsWorld,
    relations: &mut Relations,
    changed: &[NodeId],
) -> Result<(Vec<NodeId>, ChangeSet), PhysicalRefusal> {
    let unreadable = |e: &dyn std::fmt::Display| PhysicalRefusal::Unreadable(e.to_string());
    let (moved, poses) = write_poses(graph, world).map_err(|e| unreadable(&e))?;
    let all = [moved.as_slice(), changed].concat();
    let met = relations.update_with(graph, &all, evidence(world)).map_err(|e| unreadable(&e))?;
    let kept = |graph: &SceneGraph, id: NodeId| {
        boxes::still_at(start, graph, world, id).or_else(|| boxes::unmoved_at(graph, world, id, &moved))
    };
    let edges = relations.write_except(graph, &met, kept).map_err(|e| unreadable(&e))?;
    Ok((met, poses.then(edges)))
}

//! Random valid edits.

use proptest::prelude::*;
use vc_graph::{Draft, Edge, Edit, EditError, Node, NodeId, NodeKind, Relation, SceneGraph, State, Word};

use crate::scenes::{CLASSES, places_for, pose};

/// A random edit: operation, node, argument, and destination.
pub type Plan = (u8, usize, usize, [i16; 7]);

/// At most so many random edits.
pub fn plans(most: usize) -> impl Strategy<Value = Vec<Plan>> {
    let pose = prop::array::uniform7(-2000_i16..2000);
    prop::collection::vec((0_u8..14, any::<usize>(), any::<usize>(), pose), 0..most)
}

/// Makes one edit on a graph and keeps it; returns its changes.
pub fn apply(graph: &mut SceneGraph, plan: Plan) -> vc_graph::ChangeSet {
    let mut edit = graph.edit();
    make(&mut edit, plan).unwrap();
    edit.commit()
}

/// Makes one edit; does nothing if no node qualifies.
///
/// # Errors
/// An edit that is not valid, which none should be.
pub fn make(edit: &mut Edit<'_>, (what, which, choice, numbers): Plan) -> Result<(), EditError> {
    let graph = edit.graph();
    let all: Vec<NodeId> = graph.nodes().map(Node::id).collect();
    let Some(&id) = all.get(which % all.len().max(1)) else { return Ok(()) };
    let Some(node) = graph.node(id) else { return Ok(()) };
    let (kind, posture) = (node.kind(), node.states());
    let rooms = graph.rooms().to_vec();
    let room = rooms[choice % rooms.len()];
    let resting = posture.contains(State::Sitting) || posture.contains(State::Lying);
    match what {
        0 | 1 => add(edit, choice, room, numbers),
        2 => remove(edit, id),
        3..=6 if kind != NodeKind::Room && !resting => place(edit, id, kind, choice),
        7 if kind == NodeKind::Object => match edit.graph().agents().first().copied() {
            Some(agent) if edit.graph().free_hand(agent).is_some() && !edit.graph().rests_at(agent, id) => {
                edit.hold(agent, id)
            }
            _ => Ok(()),
        },
        8 if kind != NodeKind::Room => {
            stand(edit, id)?;
            edit.move_to_room(id, room)
        }
        9 => {
            let state = State::ALL[choice % State::ALL.len()];
            if [State::Sitting, State::Lying].contains(&state) { Ok(()) } else { edit.enter_state(id, state) }
        }
        10 => {
            let relation = [Relation::Near, Relation::Touching, Relation::Facing, Relation::TakenOff][choice % 4];
            edit.relate(Edge::new(id, relation, all[choice / 4 % all.len()]))
        }
        11 if kind != NodeKind::Room => stand(edit, id),
        12 => edit.carry_to(id, pose(numbers, true)),
        13 => edit.fill(id, choice.is_multiple_of(2).then(|| "juice".into())),
        _ => Ok(()),
    }
}

fn add(edit: &mut Edit<'_>, choice: usize, room: NodeId, numbers: [i16; 7]) -> Result<(), EditError> {
    let id = edit.add(Draft::new(CLASSES[choice / 8 % CLASSES.len()]).at(pose(numbers, true)))?;
    if edit.graph().node(id).is_some_and(|n| n.kind() == NodeKind::Room) {
        return Ok(());
    }
    edit.move_to_room(id, room)
}

/// Removes a node; a room only if it is empty and not the last.
fn remove(edit: &mut Edit<'_>, id: NodeId) -> Result<(), EditError> {
    let graph = edit.graph();
    let needed = graph.rooms() == [id] || graph.in_room(id).next().is_some();
    let people: Vec<NodeId> = graph.resting_at(id).filter(|&n| graph.agents().contains(&n)).collect();
    if needed {
        return Ok(());
    }
    people.into_iter().try_for_each(|agent| stand(edit, agent))?;
    edit.remove(id)
}

fn place(edit: &mut Edit<'_>, id: NodeId, kind: NodeKind, choice: usize) -> Result<(), EditError> {
    let places = places_for(edit.graph(), id, kind);
    let Some(&place) = places.get(choice % places.len().max(1)) else { return Ok(()) };
    match place.relation {
        Relation::HoldsRight => return edit.hold(place.at, id),
        Relation::SittingOn => edit.enter_state(id, State::Sitting)?,
        Relation::LyingOn => edit.enter_state(id, State::Lying)?,
        _ => {}
    }
    edit.place(id, place)
}

fn stand(edit: &mut Edit<'_>, id: NodeId) -> Result<(), EditError> {
    edit.detach(id)?;
    edit.leave_state(id, State::Sitting)?;
    edit.leave_state(id, State::Lying)
}

//! The deliveries of an agent's next trip, which it can announce to others.

use vc_graph::{Action, NodeId, Place, Relation, SceneGraph, Verb};

/// A thing and its promised place; the place is the agent's hand if the agent keeps the thing.
pub(crate) type Promise = (NodeId, Place);

/// Number of things per trip: the number of hands.
const LOAD: usize = 2;

/// The beginning of a plan.
#[derive(Debug, Default)]
pub(crate) struct Trip {
    /// The number of actions.
    pub(crate) length: usize,
    /// The promised places of things.
    pub(crate) promises: Vec<Promise>,
}

impl Trip {
    /// The first trip of a plan: it ends when the hands are empty, or before the walk to a third thing.
    pub(crate) fn new(graph: &SceneGraph, agent: NodeId, plan: &[Action]) -> Self {
        let mut items: Vec<NodeId> = graph.held(agent).collect();
        let mut hands = items.len();
        let (mut length, mut last) = (plan.len(), 0);
        for (number, action) in plan.iter().enumerate() {
            let Some(item) = action.object.filter(|_| action.verb == Verb::Grab || is_put(action)) else { continue };
            if is_put(action) {
                hands = hands.saturating_sub(1);
                // A thing that is put down to open something is picked up again.
                let again = |a: &Action| a.verb == Verb::Grab && a.object.is_some_and(|id| items.contains(&id));
                if hands == 0 && !plan[number + 1..].iter().any(again) {
                    length = number + 1;
                    break;
                }
            } else {
                if !items.contains(&item) {
                    if items.len() == LOAD {
                        length = last.max(1);
                        break;
                    }
                    items.push(item);
                }
                hands += 1;
            }
            last = number + 1;
        }
        Self { length, promises: ends(graph, agent, plan, &items) }
    }
}

fn is_put(action: &Action) -> bool {
    matches!(action.verb, Verb::Place | Verb::PutIn | Verb::Drop)
}

/// The final places of some things in a plan.
pub(crate) fn ends(graph: &SceneGraph, agent: NodeId, plan: &[Action], items: &[NodeId]) -> Vec<Promise> {
    let mut ends: Vec<Promise> =
        items.iter().map(|&id| (id, Place { relation: Relation::HoldsRight, at: agent })).collect();
    let mut room = graph.room_of(agent);
    for action in plan {
        if action.verb == Verb::Walk {
            room = action.object.and_then(|id| graph.room_of(id));
        }
        let Some((_, end)) = ends.iter_mut().find(|(id, _)| action.object == Some(*id)) else { continue };
        *end = match (action.verb, action.target, room) {
            (Verb::Place, Some(at), _) => Place { relation: Relation::On, at },
            (Verb::PutIn, Some(at), _) => Place { relation: Relation::Inside, at },
            (Verb::Drop, _, Some(at)) => Place { relation: Relation::InRoom, at },
            _ => *end,
        };
    }
    ends
}

/// Puts things at their promised places. Promises that the graph cannot represent are not counted on.
pub(crate) fn imagine(graph: &mut SceneGraph, promises: &[Promise]) {
    let mut edit = graph.edit();
    for &(id, place) in promises {
        let _ = match place.relation {
            Relation::InRoom => edit.detach(id).and_then(|()| edit.move_to_room(id, place.at)),
            Relation::HoldsRight => edit.hold(place.at, id),
            _ => edit.place(id, place),
        };
    }
    edit.commit();
}

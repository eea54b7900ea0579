//! Validation of a scene: every violation, with the nodes concerned.

use std::collections::BTreeSet;
use std::fmt;

use crate::geometry::is_finite;
use crate::node::{Node, NodeKind};
use crate::{Label, NodeId, Relation, SceneGraph, StateSet};

/// A violation of a scene's invariants.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Violation {
    /// Objects rest on each other in a cycle.
    SupportCycle(Vec<Label>),
    /// A node other than a room is in no room.
    NoRoom(Label),
    /// A node is in several rooms.
    SeveralRooms(Label, Vec<Label>),
    /// A room is in a room.
    RoomInRoom(Label, Label),
    /// An object is held more than once.
    HeldTwice(Label, Vec<Label>),
    /// One hand holds several objects.
    HandFull(Label, Relation, Vec<Label>),
    /// A node that is not an agent holds something.
    HeldByNoAgent(Label, Label),
    /// A node is in states that exclude each other.
    ExclusiveStates(Label, StateSet),
    /// An object and its support are in different rooms.
    RoomApart(Label, Label),
    /// An object rests on a node that is not a surface.
    NotASurface(Label, Label),
    /// An object is inside a node that is not a container.
    NotAContainer(Label, Label),
    /// A pose or box is not finite, or a box has no size.
    BadGeometry(Label),
    /// A node has an own word that the scene's vocabulary lacks.
    UndeclaredWord(Label, &'static str),
    /// More agents sit or lie on it than it has places for.
    OverCapacity(Label, usize, u32),
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SupportCycle(ids) => write!(f, "{} rest on each other in a cycle", list(ids)),
            Self::NoRoom(id) => write!(f, "{id} is in no room"),
            Self::SeveralRooms(id, rooms) => write!(f, "{id} is in several rooms: {}", list(rooms)),
            Self::RoomInRoom(inner, outer) => write!(f, "room {inner} is in room {outer}"),
            Self::HeldTwice(id, by) => write!(f, "{id} is held more than once: by {}", list(by)),
            Self::HandFull(agent, hand, ids) => write!(f, "{agent} {hand} several things: {}", list(ids)),
            Self::HeldByNoAgent(by, id) => write!(f, "{by}, which is no agent, holds {id}"),
            Self::ExclusiveStates(id, states) => write!(f, "{id} is at once {states}"),
            Self::RoomApart(id, at) => write!(f, "{id} is in another room than {at}, where it rests"),
            Self::NotASurface(id, at) => write!(f, "{id} is on {at}, which is no surface"),
            Self::NotAContainer(id, at) => write!(f, "{id} is inside {at}, which is no container"),
            Self::BadGeometry(id) => write!(f, "{id} has a pose or box that is not finite, or a box without size"),
            Self::UndeclaredWord(id, word) => write!(f, "{id} is {word}, which the scene's vocabulary lacks"),
            Self::OverCapacity(id, n, places) => write!(f, "{n} agents are on {id}, which has place for {places}"),
        }
    }
}

fn list(labels: &[Label]) -> String {
    labels.iter().map(Label::to_string).collect::<Vec<_>>().join(", ")
}

impl SceneGraph {
    /// Lists every violation of the invariants, in the order of node numbers; empty if there is none. Scene
    /// files of others often have some: a reader keeps them unchanged, and the transition rule tolerates them.
    ///
    /// Costs a walk over all nodes and their placements.
    ///
    /// ```
    /// use vc_graph::{Draft, Edge, Relation, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let graph = scene.build();
    /// assert!(graph.validate().is_empty());
    /// let mut scene = SceneBuilder::from_graph(graph);
    /// scene.link_all(&[Edge::new(table, Relation::On, apple)])?; // readers may do so: each rests on the other
    /// assert!(!scene.build().validate().is_empty());
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    pub fn validate(&self) -> Vec<Violation> {
        let mut found = self.support_cycles();
        for node in self.nodes() {
            self.check_room(node, &mut found);
            self.check_hands(node, &mut found);
            self.check_place(node, &mut found);
            self.check_itself(node, &mut found);
        }
        found
    }

    fn labels(&self, ids: impl IntoIterator<Item = NodeId>) -> Vec<Label> {
        ids.into_iter().map(|id| self.label(id)).collect()
    }

    fn check_room(&self, node: &Node, found: &mut Vec<Violation>) {
        let rooms = self.labels(node.out(Relation::InRoom));
        match (node.kind(), rooms.as_slice()) {
            (NodeKind::Room, []) | (_, [_]) if node.kind() != NodeKind::Room || rooms.is_empty() => {}
            (NodeKind::Room, _) => found.extend(rooms.into_iter().map(|r| Violation::RoomInRoom(node.label(), r))),
            (_, []) => found.push(Violation::NoRoom(node.label())),
            _ => found.push(Violation::SeveralRooms(node.label(), rooms)),
        }
    }

    fn check_hands(&self, node: &Node, found: &mut Vec<Violation>) {
        for hand in Relation::hands() {
            let held = self.labels(node.out(hand));
            if held.len() > 1 {
                found.push(Violation::HandFull(node.label(), hand, held.clone()));
            }
            if node.kind() != NodeKind::Agent {
                found.extend(held.into_iter().map(|h| Violation::HeldByNoAgent(node.label(), h)));
            }
        }
        let holders = self.labels(Relation::hands().into_iter().flat_map(|hand| node.inc(hand)));
        if holders.len() > 1 {
            found.push(Violation::HeldTwice(node.label(), holders));
        }
    }

    fn check_place(&self, node: &Node, found: &mut Vec<Violation>) {
        let room = self.room_of(node.id());
        for place in self.places(node.id()) {
            let Some(at) = self.node(place.at) else { continue };
            if self.room_of(place.at) != room {
                found.push(Violation::RoomApart(node.label(), at.label()));
            }
            // Hanging objects are on a wall or a ceiling.
            let is_borne = at.carries() || at.is_building();
            if place.relation == Relation::On && node.kind() == NodeKind::Object && !is_borne {
                found.push(Violation::NotASurface(node.label(), at.label()));
            }
            if place.relation == Relation::Inside && !at.encloses(self.classes()) && !at.soaks() {
                found.push(Violation::NotAContainer(node.label(), at.label()));
            }
        }
    }

    fn check_itself(&self, node: &Node, found: &mut Vec<Violation>) {
        found.extend(self.vocabulary().conflicts(node.states()).map(|s| Violation::ExclusiveStates(node.label(), s)));
        let lacking = self.vocabulary().word_lacking(node);
        found.extend(lacking.map(|word| Violation::UndeclaredWord(node.label(), word)));
        let sound_box = node.spec().bounds.is_none_or(|b| b.half.iter().all(|h| h.is_finite() && *h >= 0.0));
        if !sound_box || node.pose().is_some_and(|p| !is_finite(p)) {
            found.push(Violation::BadGeometry(node.label()));
        }
        for (relation, kind) in crate::class::OCCUPANCY {
            let (here, places) = (node.inc(relation).count(), node.capacity(kind));
            if here > places as usize {
                found.push(Violation::OverCapacity(node.label(), here, places));
            }
        }
    }

    /// Finds each cycle of the support relation once, by depth-first search with an explicit stack, since
    /// chains may have any length.
    fn support_cycles(&self) -> Vec<Violation> {
        let (mut done, mut found) = (BTreeSet::new(), Vec::new());
        for node in self.nodes() {
            let mut path = Path::default();
            path.enter(node.id(), self.places(node.id()).map(|p| p.at).collect());
            while let Some((id, next)) = path.step() {
                match next {
                    None => {
                        done.insert(id);
                    }
                    Some(next) if done.contains(&next) => {}
                    Some(next) if path.on.contains(&next) => {
                        found.push(Violation::SupportCycle(self.labels(path.since(next))));
                    }
                    Some(next) => path.enter(next, self.places(next).map(|p| p.at).collect()),
                }
            }
        }
        found
    }
}

/// The path of the search from its start to the current node, with the branches still to be visited.
#[derive(Default)]
struct Path {
    steps: Vec<(NodeId, Vec<NodeId>)>,
    on: BTreeSet<NodeId>,
}

impl Path {
    fn enter(&mut self, id: NodeId, open: Vec<NodeId>) {
        self.steps.push((id, open));
        self.on.insert(id);
    }

    /// The current node and its next branch; if it has none, the node is left.
    fn step(&mut self) -> Option<(NodeId, Option<NodeId>)> {
        let (id, open) = self.steps.last_mut()?;
        let (id, next) = (*id, open.pop());
        if next.is_none() {
            self.steps.pop();
            self.on.remove(&id);
        }
        Some((id, next))
    }

    fn since(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        self.steps.iter().map(|(step, _)| *step).skip_while(move |step| *step != id)
    }
}

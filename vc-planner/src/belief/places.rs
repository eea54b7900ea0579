//! Where things can be, and whether that can be seen from where one stands.

use vc_graph::{Node, NodeId, NodeKind, ObjectRole, Observation, Place, Property, Relation, SceneGraph};

use super::Belief;
use crate::prior::Kinds;

impl Belief {
    /// A container that can be carried is a place from when it has been seen; in an unknown home
    /// all surfaces and containers are.
    pub(super) fn learn_places(&mut self, node: &Node, room: Option<NodeId>) {
        let opens = [Property::Graspable, Property::Container, Property::Openable];
        if (self.in_unknown_home || !self.missing.is_empty()) && opens.into_iter().all(|p| node.affords(p)) {
            self.learn_place(Place { relation: Relation::Inside, at: node.id() }, room, false);
        }
        if self.in_unknown_home {
            fixed(node).for_each(|place| self.learn_place(place, room, true));
        }
    }

    /// A place in a room; what does not stay there may be in another later.
    fn learn_place(&mut self, place: Place, room: Option<NodeId>, stays: bool) {
        if self.places.contains(&place) {
            return;
        }
        self.places.push(place);
        self.seen.push(false);
        self.rooms.push(room.filter(|_| stays));
        self.kinds.add(&self.graph, &place, room);
        self.supposed.values_mut().for_each(|class| class.stale = true);
    }

    /// Where things can be in a scene, none of it seen.
    pub(super) fn look_for_places(&mut self, graph: &SceneGraph) {
        self.places = all(graph);
        self.seen = vec![false; self.places.len()];
        self.rooms = self.places.iter().map(|p| graph.room_of(p.at)).collect();
        self.kinds = Kinds::new(graph, &self.places);
    }

    /// Spreads what is supposed anew where places have become known, or things of the class.
    pub(super) fn spread(&mut self) {
        for class in self.supposed.values_mut().filter(|class| class.stale && class.missing > 0) {
            let Some(weights) = &mut class.weights else { continue };
            weights.meet(&self.graph, class.example, &self.kinds);
            let likely = weights.likely(&self.kinds);
            class.left = left(&likely, &self.kinds, &self.seen);
            (class.likely, class.stale) = (Some(likely), false);
        }
    }
}

/// How much of what is likely is at places not seen.
pub(super) fn left(likely: &[[f64; 2]], kinds: &Kinds, seen: &[bool]) -> [f64; 2] {
    let unseen = kinds.each().zip(seen).filter(|(_, seen)| !**seen).map(|(kind, _)| likely[kind]);
    unseen.fold([0.0; 2], |[a, b], [x, y]| [a + x, b + y])
}

/// Every fixed surface and container, floors included; of a room without a floor
/// the room itself.
pub(super) fn all(graph: &SceneGraph) -> Vec<Place> {
    let floors: Vec<NodeId> = graph.of_role(ObjectRole::Floor).map(|n| n.id()).collect();
    let bare = |room: NodeId| !floors.iter().any(|&f| graph.room_of(f) == Some(room));
    let mut places = Vec::new();
    for node in graph.nodes() {
        match node.kind() {
            NodeKind::Room if bare(node.id()) => places.push(Place { relation: Relation::InRoom, at: node.id() }),
            NodeKind::Object => places.extend(fixed(node)),
            _ => {}
        }
    }
    places
}

/// The places that a thing which stays where it is has to offer.
fn fixed(node: &Node) -> impl Iterator<Item = Place> {
    let affords = |p| node.affords(p);
    let fixed = node.kind() == NodeKind::Object && !affords(Property::Graspable);
    let surface = [Property::Surface, Property::Sittable, Property::Lieable].into_iter().any(affords);
    let offers = [(Relation::On, surface), (Relation::Inside, affords(Property::Container))];
    let at = node.id();
    offers.into_iter().filter(move |(_, has)| fixed && *has).map(move |(relation, _)| Place { relation, at })
}

/// Whether a place can be seen to hold what it holds.
pub(super) fn in_view(seen: &Observation, place: &Place) -> bool {
    match place.relation {
        Relation::InRoom => seen.room() == Some(place.at),
        Relation::Inside => seen.get(place.at).is_some_and(|n| !n.hides_contents()),
        _ => seen.sees(place.at),
    }
}

//! Where things can be, and whether that can be seen from where one stands.

use vc_graph::{Kind, Node, NodeId, Observation, Place, Property, Relation, SceneGraph};

use super::Belief;

impl Belief {
    /// A container that can be carried is a place from when it has been seen.
    pub(super) fn learn_place(&mut self, node: &Node) {
        let opens = [Property::Graspable, Property::Container, Property::Openable];
        let place = Place { relation: Relation::Inside, at: node.id() };
        if self.missing.is_empty() || !opens.into_iter().all(|p| node.affords(p)) || self.places.contains(&place) {
            return;
        }
        self.places.push(place);
        self.seen.push(false);
        self.rooms.push(None);
        let share = self.even();
        for class in self.supposed.values_mut() {
            if let Some(places) = &mut class.places {
                let less = |likely: &[f64; 2]| likely.map(|w| w * (1.0 - share));
                *places = places.iter().map(less).chain([[share; 2]]).collect();
                class.left = class.left.map(|left| left * (1.0 - share) + share);
            }
        }
    }
}

/// Every fixed surface and container, floors included; of a room without a floor
/// the room itself.
pub(super) fn all(graph: &SceneGraph) -> Vec<Place> {
    let floors = graph.of_class("floor");
    let bare = |room: NodeId| !floors.iter().any(|&f| graph.room_of(f) == Some(room));
    let mut places = Vec::new();
    for node in graph.nodes() {
        let mut add = |relation| places.push(Place { relation, at: node.id() });
        match node.kind() {
            Kind::Room if bare(node.id()) => add(Relation::InRoom),
            Kind::Room => {}
            Kind::Agent => {}
            Kind::Object => {
                let fixed = !node.affords(Property::Graspable);
                let surface =
                    [Property::Surface, Property::Sittable, Property::Lieable].into_iter().any(|p| node.affords(p));
                if surface && fixed {
                    add(Relation::On);
                }
                if node.affords(Property::Container) && fixed {
                    add(Relation::Inside);
                }
            }
        }
    }
    places
}

/// Whether a place can be seen to hold what it holds.
pub(super) fn in_view(seen: &Observation, place: &Place) -> bool {
    match place.relation {
        Relation::InRoom => seen.room() == Some(place.at),
        Relation::Inside => seen.get(place.at).is_some_and(|n| !n.hides_contents()),
        _ => seen.sees(place.at),
    }
}

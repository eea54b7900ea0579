//! Kinds of places: what is on or in things of one class, in rooms of one class.

use std::sync::Arc;

use vc_graph::{NodeId, ObjectRole, Place, Property, Relation, SceneGraph};

use super::{RelatedClasses, Row};

/// The places of a belief by their kind, in the order in which they became known.
#[derive(Debug, Clone, Default)]
pub(crate) struct Kinds {
    all: Vec<PlaceKind>,
    /// The kind of each place.
    of: Vec<u16>,
    /// The places where the scene's class table keeps things of related classes.
    related: Arc<RelatedClasses>,
}

/// Places that are alike.
#[derive(Debug, Clone)]
pub(crate) struct PlaceKind {
    pub(crate) relation: Relation,
    /// The class of what offers the place, as the class table calls it, and of its room.
    pub(crate) at: Arc<str>,
    pub(crate) room: Arc<str>,
    /// It can be carried away: habit counts on nothing in it.
    pub(crate) carried: bool,
    /// It is the floor of a room itself, and no furniture.
    pub(crate) floor: bool,
    /// Depth, width and height, metres.
    pub(crate) size: Option<[f64; 3]>,
    /// How many there are.
    pub(crate) number: usize,
}

impl Kinds {
    pub(crate) fn new(graph: &SceneGraph, places: &[Place]) -> Self {
        let mut kinds = Self { related: RelatedClasses::new(graph.classes()), ..Self::default() };
        places.iter().for_each(|place| kinds.add(graph, place, graph.room_of(place.at)));
        kinds
    }

    /// One more place, in a room.
    pub(crate) fn add(&mut self, graph: &SceneGraph, place: &Place, room: Option<NodeId>) {
        let new = PlaceKind::new(graph, place, room);
        let known = self.all.iter().position(|kind| kind.is_like(&new));
        let number = known.unwrap_or(self.all.len());
        if known.is_none() {
            self.all.push(new);
        }
        self.all[number].number += 1;
        self.of.push(number as u16);
    }

    pub(crate) fn all(&self) -> &[PlaceKind] {
        &self.all
    }

    pub(crate) fn related(&self) -> &RelatedClasses {
        &self.related
    }

    /// The number of the kind of a place.
    pub(crate) fn of_place(&self, place: usize) -> usize {
        self.of[place] as usize
    }

    /// The number of the kind of each place.
    pub(crate) fn each(&self) -> impl Iterator<Item = usize> + '_ {
        self.of.iter().map(|&kind| kind as usize)
    }
}

impl PlaceKind {
    fn new(graph: &SceneGraph, place: &Place, room: Option<NodeId>) -> Self {
        let node = graph.node(place.at);
        let class = |id| graph.node(id).map_or_else(|| "".into(), |n| n.class().clone());
        Self {
            relation: place.relation,
            at: class(place.at),
            room: room.map_or_else(|| "".into(), class),
            carried: node.is_some_and(|n| n.affords(Property::Graspable)),
            floor: node.is_some_and(|n| matches!(n.role(), ObjectRole::Room | ObjectRole::Floor)),
            size: super::stray::size(graph, place.at),
            number: 0,
        }
    }

    fn is_like(&self, other: &Self) -> bool {
        (self.relation, &self.at, &self.room, self.carried) == (other.relation, &other.at, &other.room, other.carried)
    }

    /// Whether both are on or in the same sort of thing, in whatever room.
    pub(crate) fn offers_like(&self, other: &Self) -> bool {
        (self.relation, &self.at, self.carried) == (other.relation, &other.at, other.carried)
    }

    /// Whether a habit speaks of the room.
    pub(crate) fn is_room(&self, graph: &SceneGraph, row: &Row) -> bool {
        row.room.as_deref().is_none_or(|wanted| graph.classes().is_a(&self.room, wanted))
    }

    /// Whether a habit puts things there.
    pub(crate) fn suits(&self, graph: &SceneGraph, row: &Row) -> bool {
        let suits = match &row.at {
            Some((relation, at)) => *relation == self.relation && graph.classes().is_a(&self.at, at),
            None => self.floor,
        };
        suits && !self.carried && self.is_room(graph, row)
    }
}

//! The facts of a class by which its objects are made.

use vc_graph::class::{Range, Trait, TraitSet};
use vc_graph::{Class, ClassTable, ObjectRole, Property, PropertySet};

/// The columns of a class's row that decide how its objects are made and used.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClassFacts {
    /// The usual depth, width and height, metres.
    pub(crate) size: Option<[Range; 3]>,
    /// The role in a scene.
    pub(crate) role: ObjectRole,
    pub(crate) affordances: PropertySet,
    traits: TraitSet,
}

impl ClassFacts {
    /// The facts of a class without a row.
    const UNKNOWN: Self =
        Self { size: None, role: ObjectRole::Furniture, affordances: PropertySet::EMPTY, traits: TraitSet::EMPTY };

    pub(crate) fn new(row: &Class) -> Self {
        Self { size: row.size, role: row.role(), affordances: row.affordances, traits: row.traits }
    }

    /// The facts of a class by the built-in table.
    pub(crate) fn builtin(class: &str) -> Self {
        ClassTable::builtin().get(class).map_or(Self::UNKNOWN, Self::new)
    }

    /// Whether its objects are flat on a wall, a window or the ceiling, or let into it: their collision shape is their
    /// box.
    pub(crate) fn is_flat(&self) -> bool {
        self.traits.contains(Trait::Flat)
    }

    /// Whether its objects are graspable and hold no others.
    pub(crate) fn is_only_carried(&self) -> bool {
        let holds =
            [Property::Container, Property::Recipient, Property::Surface, Property::Sittable, Property::Lieable];
        self.affordances.contains(Property::Graspable) && !holds.into_iter().any(|p| self.affordances.contains(p))
    }
}

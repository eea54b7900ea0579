//! The role of a node in a scene, decided once from a table.

use std::sync::LazyLock;

use crate::spelling::key;
use crate::vocabulary::{Word, vocabulary};
use crate::{Property, PropertySet};

vocabulary! {
    /// The role of a node in a scene: part of the building, furniture, a loose thing.
    ///
    /// It is decided when a node is made, and every crate goes by it:
    ///
    /// 1. A room is a [`Room`](Self::Room), an agent a [`Person`](Self::Person).
    /// 2. The class decides, or an ancestor of it: a `floor`, `wall` or `ceiling`; a `doorjamb` is a door frame;
    ///    a `curtain`, `blinds` or a `roller_shutter` a cover; a `rug` or `mat` a rug.
    /// 3. If the class has no such ancestor, its category decides: `structure`, `door`, `window`, `lamp`.
    /// 4. For a class that the class table lacks, the category that the scene's author wrote decides, in the words of
    ///    this crate or of VirtualHome: `Floors`, `Walls`, `Ceiling`, `Doors`, `Windows`, `Lamps`.
    /// 5. Any other thing is loose if it can be grasped, and furniture if not.
    ///
    /// The table is `data/roles.txt`. A class of a user's own table has the role of its ancestor.
    ///
    /// ```
    /// use vc_graph::{Draft, ObjectRole, SceneBuilder};
    /// let mut scene = SceneBuilder::new("flat");
    /// let door = scene.add(Draft::new("balcony_door"))?;
    /// let plate = scene.add(Draft::new("plate"))?;
    /// let slab = scene.add(Draft { category: Some("Floors".into()), ..Draft::new("slab") })?;
    /// let scene = scene.build();
    /// let roles = [door, plate, slab].map(|id| scene.node(id).map(|node| node.role()));
    /// assert_eq!(roles, [ObjectRole::Door, ObjectRole::Loose, ObjectRole::Floor].map(Some));
    /// # Ok::<(), vc_graph::EditError>(())
    /// ```
    #[non_exhaustive]
    ObjectRole, "role" {
        /// A room or outdoor region.
        Room = "room",
        /// A person or an animal that acts.
        Person = "person",
        /// A floor.
        Floor = "floor",
        /// A wall.
        Wall = "wall",
        /// A ceiling.
        Ceiling = "ceiling",
        /// Another part of the building: stairs, a railing, a window sill.
        Structure = "structure",
        /// The frame of a door.
        DoorFrame = "door_frame",
        /// A door between rooms.
        Door = "door",
        /// A window.
        Window = "window",
        /// A cover of a window or a door: a curtain, blinds, a shutter.
        Cover = "cover",
        /// A rug or mat: it lies on the floor and is walked on.
        Rug = "rug",
        /// A lamp.
        Light = "light",
        /// Furniture, an appliance, or another thing that nobody picks up.
        Furniture = "furniture",
        /// A thing that can be picked up.
        Loose = "loose",
    }
}

/// A line of the table.
struct Row {
    role: ObjectRole,
    classes: Vec<&'static str>,
    categories: Vec<&'static str>,
}

static TABLE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let lines = include_str!("../data/roles.txt").lines().filter(|line| !line.starts_with('#'));
    let row = |line: &'static str| {
        let mut columns = line.split('|').map(str::split_whitespace);
        let role = ObjectRole::parse(columns.next()?.next()?).ok()?;
        let (classes, categories) = (columns.next()?.collect(), columns.next()?.collect());
        Some(Row { role, classes, categories })
    };
    lines.filter_map(row).collect()
});

impl ObjectRole {
    /// Whether it is a floor, a wall, a ceiling or another part of the building. Doors, windows and their frames are
    /// not.
    pub fn is_building(self) -> bool {
        matches!(self, Self::Floor | Self::Wall | Self::Ceiling | Self::Structure)
    }

    /// Whether it is a door, its frame or a window: what fills an opening of the building.
    pub fn is_opening(self) -> bool {
        matches!(self, Self::Door | Self::DoorFrame | Self::Window)
    }

    /// Whether it is built in: part of the building, or a door, its frame or a window.
    ///
    /// ```
    /// use vc_graph::ObjectRole;
    /// assert!(ObjectRole::Wall.is_built_in() && ObjectRole::Window.is_built_in());
    /// assert!(!ObjectRole::Furniture.is_built_in());
    /// ```
    pub fn is_built_in(self) -> bool {
        self.is_building() || self.is_opening()
    }

    /// The classes that have a role with all their kinds, line by line.
    pub(crate) fn classes() -> impl Iterator<Item = (&'static str, Self)> {
        TABLE.iter().flat_map(|row| row.classes.iter().map(|class| (*class, row.role)))
    }

    /// The role of all things of a category.
    pub(crate) fn of_category(category: &str) -> Option<Self> {
        TABLE.iter().find(|row| row.categories.contains(&category)).map(|row| row.role)
    }

    /// The role that a class has for its name alone, though the class table lacks it.
    pub(crate) fn of_name(name: &str) -> Option<Self> {
        Self::classes().find(|(class, _)| key(class) == name).map(|(_, role)| role)
    }

    /// The role of a thing that no line of the table speaks of.
    pub(crate) fn by_use(affordances: PropertySet) -> Self {
        if affordances.contains(Property::Graspable) { Self::Loose } else { Self::Furniture }
    }
}

//! Object classes: their categories, affordances, sizes and the places where people keep them.
//!
//! The built-in table is parsed from text files compiled into the crate. Users add their own classes in the
//! same format, which [`ClassTable::parse`] describes.

mod name;
mod parse;

use std::collections::HashMap;
use std::sync::{Arc, LazyLock};

use crate::vocabulary::vocabulary;
use crate::{ObjectRole, PropertySet, Relation, StateSet, Vocabulary};

pub use parse::{ClassError, ClassProblem};

vocabulary! {
    /// The category of a class.
    #[non_exhaustive]
    Category, "category" {
        /// A room or outdoor region.
        Room = "room",
        /// Floors, walls, ceilings and built-in elements.
        Structure = "structure",
        /// A door between rooms.
        Door = "door",
        /// A window.
        Window = "window",
        /// Furniture.
        Furniture = "furniture",
        /// A household machine.
        Appliance = "appliance",
        /// Electronics.
        Electronics = "electronics",
        /// A lamp.
        Lamp = "lamp",
        /// Decoration.
        Decor = "decor",
        /// A small object.
        Prop = "prop",
        /// Food and drink.
        Food = "food",
        /// Clothing.
        Clothing = "clothing",
        /// A plant.
        Plant = "plant",
        /// An animal.
        Animal = "animal",
        /// A toy or game.
        Toy = "toy",
        /// Sports gear.
        Sport = "sport",
        /// An outdoor object.
        Outdoor = "outdoor",
        /// A vehicle.
        Vehicle = "vehicle",
        /// A person.
        Character = "character",
        /// An abstract class with subclasses.
        Group = "group",
    }
}

vocabulary! {
    /// A kind of place in or on an object.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// use vc_graph::class::SlotKind;
    /// let classes = ClassTable::builtin();
    /// let stove = classes.get("stove").ok_or("unknown")?;
    /// assert!(stove.slots.iter().any(|slot| slot.kind == SlotKind::Burner && slot.number == 4));
    /// # Ok::<(), &str>(())
    /// ```
    #[non_exhaustive]
    SlotKind, "slot" {
        /// A shelf board.
        Shelf = "shelf",
        /// A drawer.
        Drawer = "drawer",
        /// A space behind a door or under a lid.
        Compartment = "compartment",
        /// An open bowl or tub.
        Basin = "basin",
        /// A hook to hang objects on.
        Hook = "hook",
        /// A rack for many objects of one kind.
        Rack = "rack",
        /// A rod for hangers.
        Rod = "rod",
        /// A place to sit.
        Seat = "seat",
        /// A place to lie.
        Lie = "lie",
        /// A cooking zone of a hob.
        Burner = "burner",
        /// A pocket.
        Pocket = "pocket",
        /// A place for exactly one object.
        Slot = "slot",
    }
}

vocabulary! {
    /// A trait of the things of a class, beside its affordances.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// use vc_graph::class::Trait;
    /// let classes = ClassTable::builtin();
    /// assert!(classes.get("sponge").is_some_and(|class| class.traits.contains(Trait::Squeezable)));
    /// ```
    #[non_exhaustive]
    Trait, "trait" {
        /// A hand can squeeze it: a sponge, a lemon, a tube. So it can clothes, wipers and creams, which affordances
        /// tell.
        Squeezable = "squeezable",
        /// It is mounted flat on a wall, a window or a ceiling, or let into it.
        Flat = "flat",
        /// A room with running water, and so with a tiled floor.
        Wet = "wet",
    }
}

/// A set of [`Trait`]s.
pub type TraitSet = crate::Set<Trait>;

/// The kind of place that each relation takes up.
pub(crate) const OCCUPANCY: [(Relation, SlotKind); 2] =
    [(Relation::SittingOn, SlotKind::Seat), (Relation::LyingOn, SlotKind::Lie)];

/// A number of places of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Slot {
    /// The kind of place.
    pub kind: SlotKind,
    /// The number of places.
    pub number: u32,
}

/// A closed range of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest plausible value.
    pub low: f32,
    /// Largest plausible value.
    pub high: f32,
}

impl Range {
    /// Middle of the range.
    pub fn middle(self) -> f32 {
        f32::midpoint(self.low, self.high)
    }
}

/// A place where people keep objects of a class.
///
/// ```
/// use vc_graph::ClassTable;
/// let classes = ClassTable::builtin();
/// let milk = classes.get("milk").ok_or("unknown")?;
/// let at = milk.kept.iter().filter_map(|place| place.at.as_ref());
/// assert!(at.into_iter().any(|(_, class)| &**class == "fridge"));
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Class of the room; `None` for any room.
    pub room: Option<Arc<str>>,
    /// The class on or inside which it is kept; `None` if it stands in the room itself.
    pub at: Option<(Relation, Arc<str>)>,
    /// Relative weight, at least 1.
    pub weight: u32,
}

/// The description of a class of objects.
#[derive(Debug, Clone, PartialEq)]
pub struct Class {
    /// The class's name, `coffee_table`.
    pub name: Arc<str>,
    /// Parent classes, `table`.
    pub parents: Vec<Arc<str>>,
    /// Other names of the same class.
    pub aliases: Vec<Arc<str>>,
    /// Its category.
    pub category: Category,
    /// Actions that it permits.
    pub affordances: PropertySet,
    /// Depth, width and height, metres; `None` for groups.
    pub size: Option<[Range; 3]>,
    /// Mass, kilograms; `None` for groups and rooms.
    pub mass: Option<Range>,
    /// Initial states.
    pub starts: StateSet,
    /// Places in or on it.
    pub slots: Arc<[Slot]>,
    /// Places where people keep it.
    pub kept: Vec<Kept>,
    /// Its traits.
    pub traits: TraitSet,
    /// The role of its things, if the class or its category decides it.
    pub(crate) listed: Option<ObjectRole>,
    /// Position in the table.
    index: usize,
}

impl Class {
    /// The role of its things; in a scene a node's own properties may say that it cannot be grasped.
    ///
    /// ```
    /// use vc_graph::{ClassTable, ObjectRole};
    /// let classes = ClassTable::builtin();
    /// assert_eq!(classes.get("mug").map(|class| class.role()), Some(ObjectRole::Loose));
    /// ```
    pub fn role(&self) -> ObjectRole {
        self.listed.unwrap_or_else(|| ObjectRole::by_use(self.affordances))
    }

    /// Typical depth, width and height, metres.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// let classes = ClassTable::builtin();
    /// let size = classes.get("fridge").and_then(|class| class.typical_size()).ok_or("unknown")?;
    /// assert!((1.0..2.2).contains(&size.z), "a fridge is {} m high", size.z);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn typical_size(&self) -> Option<nalgebra::Vector3<f32>> {
        self.size.map(|s| nalgebra::Vector3::from(s.map(Range::middle)))
    }
}

/// All known classes, found by name in any usual spelling.
///
/// ```
/// use vc_graph::{ClassTable, Property};
/// let classes = ClassTable::builtin();
/// let table = classes.get("SM_Coffee_Table_03").ok_or("unknown")?;
/// assert_eq!(&*table.name, "coffee_table");
/// assert!(table.affordances.contains(Property::Surface));
/// assert!(classes.is_a("coffeetable", "table"));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Default)]
pub struct ClassTable {
    classes: Vec<Class>,
    by_name: HashMap<String, usize>,
    /// The classes by their names as written in the table.
    written: HashMap<Arc<str>, usize>,
    /// For each class the indices of its descendants, itself included.
    kinds: Vec<Vec<usize>>,
    /// The words that a scene with these classes has.
    vocabulary: Arc<Vocabulary>,
}

/// The texts of the built-in table, by theme.
const BUILTIN: &[(&str, &str)] = &[
    ("groups.txt", include_str!("../../data/classes/groups.txt")),
    ("rooms.txt", include_str!("../../data/classes/rooms.txt")),
    ("structure.txt", include_str!("../../data/classes/structure.txt")),
    ("furniture.txt", include_str!("../../data/classes/furniture.txt")),
    ("appliances.txt", include_str!("../../data/classes/appliances.txt")),
    ("kitchenware.txt", include_str!("../../data/classes/kitchenware.txt")),
    ("household.txt", include_str!("../../data/classes/household.txt")),
    ("food.txt", include_str!("../../data/classes/food.txt")),
    ("tech.txt", include_str!("../../data/classes/tech.txt")),
    ("play.txt", include_str!("../../data/classes/play.txt")),
    ("garden.txt", include_str!("../../data/classes/garden.txt")),
    ("vehicles.txt", include_str!("../../data/classes/vehicles.txt")),
];

/// Prints only the number of classes: the table is too long for a message.
impl std::fmt::Debug for ClassTable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ClassTable({} classes)", self.len())
    }
}

impl ClassTable {
    /// The built-in classes, read once per process (about a millisecond).
    pub fn builtin() -> Arc<Self> {
        static TABLE: LazyLock<Arc<ClassTable>> = LazyLock::new(|| {
            let table = parse::parse(ClassTable::default(), BUILTIN);
            // A test reads the built-in text and shows its errors.
            Arc::new(table.unwrap_or_default())
        });
        TABLE.clone()
    }

    /// The vocabulary of scenes with these classes; the built-in words unless it was set.
    pub fn vocabulary(&self) -> &Arc<Vocabulary> {
        &self.vocabulary
    }

    /// These classes with another vocabulary, whose words classes added later can have. Costs a copy of the table, about
    /// a millisecond.
    ///
    /// ```
    /// use vc_graph::{ClassTable, Property, Vocabulary, Word};
    /// let words = Vocabulary::parse("words.txt", "property polishable")?;
    /// let boots = "leather_boots | boots | | clothing | graspable polishable | 0.3 0.3 0.3 | 1 | | | ";
    /// let classes = ClassTable::builtin().with_vocabulary(words).extended("classes.txt", boots)?;
    /// let polishable = Property::parse("polishable")?;
    /// assert!(classes.get("leather_boots").is_some_and(|class| class.affordances.contains(polishable)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_vocabulary(&self, words: impl Into<Arc<Vocabulary>>) -> Self {
        Self { vocabulary: words.into(), ..self.clone() }
    }

    /// Number of classes.
    pub fn len(&self) -> usize {
        self.classes.len()
    }

    /// Whether the table has no classes.
    pub fn is_empty(&self) -> bool {
        self.classes.is_empty()
    }

    /// All classes, in the order of the text.
    pub fn iter(&self) -> impl Iterator<Item = &Class> {
        self.classes.iter()
    }

    /// Finds a class by name, in any usual spelling: case, `_`, `-` and spaces do not matter, nor do engine
    /// prefixes and numbers (`SM_Coffee_Table_03`). In a longer name the end decides (`SM_Glass_Milk` is milk,
    /// a fridge magnet is not a fridge); words such as colours at the end are skipped.
    pub fn get(&self, name: &str) -> Option<&Class> {
        let plain = name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
        let whole = self.written.get(name).or_else(|| plain.then(|| self.by_name.get(name)).flatten());
        let found = whole.or_else(|| name::candidates(name).find_map(|c| self.by_name.get(&c)));
        found.map(|&i| &self.classes[i])
    }

    /// Finds a class by name up to case and separators, without guessing.
    pub(crate) fn exact(&self, name: &str) -> Option<&Class> {
        let key = crate::spelling::key(name);
        self.by_name.get(&key).map(|&i| &self.classes[i])
    }

    /// The names and aliases nearest to a misspelt name, see [`nearest`](crate::nearest).
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// assert!(ClassTable::builtin().nearest("micorwave").contains(&"microwave"));
    /// ```
    pub fn nearest(&self, name: &str) -> Vec<&str> {
        let named = self.iter().flat_map(|class| std::iter::once(&class.name).chain(&class.aliases));
        crate::nearest(name, named.map(|name| &**name))
    }

    /// The class and all its descendants.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// let classes = ClassTable::builtin();
    /// let seat = classes.get("chair").ok_or("unknown")?;
    /// assert!(classes.kinds_of(seat).any(|class| &*class.name == "office_chair"));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn kinds_of(&self, class: &Class) -> impl Iterator<Item = &Class> {
        self.kinds[class.index].iter().map(|&i| &self.classes[i])
    }

    /// Whether a class equals `ancestor` or descends from it.
    ///
    /// ```
    /// use vc_graph::ClassTable;
    /// let classes = ClassTable::builtin();
    /// assert!(classes.is_a("coffee_table", "table") && !classes.is_a("table", "coffee_table"));
    /// ```
    pub fn is_a(&self, name: &str, ancestor: &str) -> bool {
        match (self.get(name), self.get(ancestor)) {
            (Some(class), Some(ancestor)) => self.kinds[ancestor.index].contains(&class.index),
            _ => crate::spelling::same_word(name, ancestor),
        }
    }
}

//! Affordances: the actions that an object permits.

use crate::vocabulary::{Set, Word, open_vocabulary};

open_vocabulary! {
    /// An affordance or property of an object. The first twenty-three are
    /// VirtualHome's; [`Property::virtualhome`] gives their original names.
    Property, "property" {
        /// Objects can be put on it.
        Surface = "surface",
        /// A person can pick it up and carry it.
        Graspable = "graspable",
        /// A person can sit on it.
        Sittable = "sittable",
        /// A person can lie on it.
        Lieable = "lieable",
        /// It can hang on hooks and hangers.
        Hangable = "hangable",
        /// A person can drink it.
        Drinkable = "drinkable",
        /// A person can eat it.
        Eatable = "eatable",
        /// Liquids can be poured into it.
        Recipient = "recipient",
        /// It can be cut.
        Cuttable = "cuttable",
        /// Its contents can be poured out.
        Pourable = "pourable",
        /// It can be opened and closed.
        Openable = "openable",
        /// It can be switched on and off.
        Switchable = "switchable",
        /// A person can read it.
        Readable = "readable",
        /// A person can watch it: a screen, a picture.
        Lookable = "lookable",
        /// Objects can be put in it.
        Container = "container",
        /// A person can wear it.
        Wearable = "wearable",
        /// It is a person.
        Person = "person",
        /// It is part of a body.
        BodyPart = "body_part",
        /// It can cover something.
        Cover = "cover",
        /// It has a mains plug.
        Plug = "plug",
        /// It is made of paper.
        Paper = "paper",
        /// It can be pushed, pulled and moved.
        Movable = "movable",
        /// It is a cream or paste.
        Cream = "cream",
        /// It can be washed.
        Washable = "washable",
        /// It can be cooked.
        Cookable = "cookable",
        /// It breaks when it falls.
        Breakable = "breakable",
        /// It can be folded.
        Foldable = "foldable",
        /// It can be driven.
        Drivable = "drivable",
        /// It cuts: a knife, scissors.
        Cutter = "cutter",
        /// It heats the objects in or on it while it is on.
        Heater = "heater",
        /// It cools the objects in it.
        Cooler = "cooler",
        /// It cleans the objects in it while it is on.
        Cleaner = "cleaner",
        /// Water comes out of it: a tap, a shower.
        WaterSource = "water_source",
        /// It is a tool for wiping: a cloth, a sponge, a mop.
        Wiper = "wiper",
        /// It emits light.
        Light = "light",
    }
}

/// A set of [`Property`]s.
pub type PropertySet = Set<Property>;

/// VirtualHome's names, in the order of the variants.
const VIRTUALHOME: [&str; 23] = [
    "SURFACES",
    "GRABBABLE",
    "SITTABLE",
    "LIEABLE",
    "HANGABLE",
    "DRINKABLE",
    "EATABLE",
    "RECIPIENT",
    "CUTTABLE",
    "POURABLE",
    "CAN_OPEN",
    "HAS_SWITCH",
    "READABLE",
    "LOOKABLE",
    "CONTAINERS",
    "CLOTHES",
    "PERSON",
    "BODY_PART",
    "COVER_OBJECT",
    "HAS_PLUG",
    "HAS_PAPER",
    "MOVABLE",
    "CREAM",
];

impl Property {
    /// The affordances of which any lets things rest on a node: surfaces, seats and beds, the lid or the rim of a
    /// container, heaters. Books carry things too, see [`Node::carries`](crate::Node::carries).
    pub const CARRYING: &'static [Self] =
        &[Self::Surface, Self::Sittable, Self::Lieable, Self::Container, Self::Recipient, Self::Heater];

    /// VirtualHome's name of the property, if it has one.
    pub fn virtualhome(self) -> Option<&'static str> {
        VIRTUALHOME.get(Word::index(self)).copied()
    }

    /// The property of a VirtualHome name.
    ///
    /// ```
    /// use vc_graph::Property;
    /// assert_eq!(Property::from_virtualhome("CAN_OPEN"), Some(Property::Openable));
    /// assert_eq!(Property::Openable.virtualhome(), Some("CAN_OPEN"));
    /// ```
    pub fn from_virtualhome(name: &str) -> Option<Self> {
        let index = VIRTUALHOME.iter().position(|&n| n == name)?;
        Self::ALL.get(index).copied()
    }
}

//! Parametric object generators: from a class, a size, a style and a seed to an asset.
//!
//! Each family of classes has a module with a table of [`Generator`]s. A generator is a function
//! that builds parts; nothing is loaded from files.

mod joinery;
mod mirror;
mod palette;
mod registry;
mod rest;
// families
mod bath;
mod bed;
mod book;
mod clothes;
mod cooker;
mod decor;
mod food;
mod furnishing;
mod games;
mod garden;
mod kitchenware;
mod lamp;
mod pack;
mod park;
mod plant;
mod play;
mod seat;
mod sport;
mod storage;
mod street;
mod structure;
mod table;
mod tech;
mod textile;
mod tool;
mod vehicle;
mod yard;

use std::collections::HashMap;
use std::sync::LazyLock;

use nalgebra::Vector3;
use vc_graph::class::Range;
use vc_graph::{Asset, Bounds, ObjectRole, Property, Seed};

use crate::facts::ClassFacts;
use crate::solid::Build;
use crate::style::Style;
pub use cooker::fitted;
pub use registry::{Generators, RegisterError};
pub use rest::settled;

/// The generator of one class of objects.
#[derive(Debug, Clone, Copy)]
pub struct Generator {
    /// The class, as in the class table.
    pub class: &'static str,
    /// Whether the class belongs indoors or outdoors.
    pub realm: Realm,
    /// The number of instances in the [catalogue](crate::catalogue).
    pub instances: usize,
    /// The facts of a class of the program's own; those of others are in the built-in table.
    own: Option<ClassFacts>,
    make: fn(&mut Build<'_>),
}

/// The places where objects of a class belong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Realm {
    /// Inside buildings.
    Indoor,
    /// In gardens, streets and parks.
    Outdoor,
}

const fn indoor(class: &'static str, instances: usize, make: fn(&mut Build<'_>)) -> Generator {
    Generator::new(class, Realm::Indoor, instances, make)
}

const fn outdoor(class: &'static str, instances: usize, make: fn(&mut Build<'_>)) -> Generator {
    Generator::new(class, Realm::Outdoor, instances, make)
}

const FAMILIES: &[&[Generator]] = &[
    seat::GENERATORS,
    table::GENERATORS,
    bed::GENERATORS,
    storage::GENERATORS,
    cooker::GENERATORS,
    bath::GENERATORS,
    furnishing::GENERATORS,
    lamp::GENERATORS,
    structure::GENERATORS,
    kitchenware::GENERATORS,
    food::GENERATORS,
    pack::GENERATORS,
    tech::GENERATORS,
    book::GENERATORS,
    decor::GENERATORS,
    plant::GENERATORS,
    textile::GENERATORS,
    clothes::GENERATORS,
    tool::GENERATORS,
    sport::GENERATORS,
    games::GENERATORS,
    play::GENERATORS,
    garden::GENERATORS,
    yard::GENERATORS,
    park::GENERATORS,
    street::GENERATORS,
    vehicle::GENERATORS,
];

/// All generators, by family.
///
/// ```
/// use vc_shapes::object;
/// assert!(object::generators().count() > 200);
/// assert!(object::generators().any(|generator| generator.class == "sofa"));
/// ```
pub fn generators() -> impl Iterator<Item = &'static Generator> {
    FAMILIES.iter().copied().flatten()
}

/// Finds the generator of a class.
pub fn generator(class: &str) -> Option<&'static Generator> {
    static BY_CLASS: LazyLock<HashMap<&'static str, &'static Generator>> =
        LazyLock::new(|| generators().map(|g| (g.class, g)).collect());
    BY_CLASS.get(class).copied()
}

/// An asset of a class, with its size.
///
/// ```
/// use vc_graph::Seed;
/// use vc_shapes::{Style, object};
/// let style = Style::from_seed(Seed(1));
/// let fridge = object::generator("fridge").ok_or("no generator")?.object(&style, Seed(1));
/// assert!(fridge.size().z > fridge.size().x);
/// assert!(fridge.asset.parts.iter().any(|part| part.joint.is_some())); // its doors open
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// The class.
    pub class: &'static str,
    /// The role that it has in a scene, by its class.
    pub role: ObjectRole,
    /// Parts and surfaces.
    pub asset: Asset,
    /// The bounding box of all parts, relative to the object's pose.
    pub bounds: Bounds,
}

impl Object {
    /// An object of a class of the built-in table; furniture if its class is not in that table.
    pub fn new(class: &'static str, asset: Asset, bounds: Bounds) -> Self {
        Self { class, role: ClassFacts::builtin(class).role, asset, bounds }
    }

    /// The depth, width and height, metres.
    pub fn size(&self) -> Vector3<f32> {
        self.bounds.size()
    }
}

impl Generator {
    /// A generator from a function that builds the parts; `instances` is the number in the
    /// [catalogue](Generators::instances).
    pub const fn new(class: &'static str, realm: Realm, instances: usize, make: fn(&mut Build<'_>)) -> Self {
        Self { class, realm, instances, own: None, make }
    }

    fn facts(&self) -> ClassFacts {
        self.own.unwrap_or_else(|| ClassFacts::builtin(self.class))
    }

    /// The role that objects of its class have in a scene.
    pub fn role(&self) -> ObjectRole {
        self.facts().role
    }

    /// Whether objects of its class permit actions of a kind.
    ///
    /// ```
    /// use vc_graph::Property;
    /// use vc_shapes::object::generator;
    /// assert!(generator("mug").is_some_and(|mug| mug.affords(Property::Graspable)));
    /// ```
    pub fn affords(&self, property: Property) -> bool {
        self.facts().affordances.contains(property)
    }

    /// The usual ranges of depth, width and height, metres; `None` if the class table has none.
    pub fn usual_ranges(&self) -> Option<[Range; 3]> {
        self.facts().size
    }

    /// Draws a size from the usual ranges: depth, width, height, metres.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_shapes::object::generator;
    /// let mug = generator("mug").ok_or("no generator")?.usual_size(Seed(1));
    /// assert!((0.05..0.2).contains(&mug.z));
    /// # Ok::<(), &str>(())
    /// ```
    pub fn usual_size(&self, seed: Seed) -> Vector3<f32> {
        let mut rng = seed.child("size").stream();
        let drawn = |ranges: [Range; 3]| ranges.map(|r| rng.between(r.low, r.high)).into();
        self.usual_ranges().map_or_else(|| Vector3::repeat(0.3), drawn)
    }

    /// Generates an instance of the class's usual size.
    pub fn object(&self, style: &Style, seed: Seed) -> Object {
        self.sized(self.usual_size(seed), style, seed)
    }

    /// Generates an instance no larger than `size` (depth, width, height in metres).
    ///
    /// ```
    /// use vc_graph::{Seed, nalgebra::Vector3};
    /// use vc_shapes::{Style, object};
    /// let (style, most) = (Style::from_seed(Seed(1)), Vector3::new(0.8, 1.6, 0.75));
    /// let table = object::generator("dining_table").ok_or("no generator")?.sized(most, &style, Seed(2));
    /// assert!((table.size() - most).max() < 0.01);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn sized(&self, size: Vector3<f32>, style: &Style, seed: Seed) -> Object {
        let facts = self.facts();
        let mut build = Build::with_facts(self.class, facts, size, style, seed.child("object").stream());
        (self.make)(&mut build);
        let (asset, bounds) = build.finish();
        Object { class: self.class, role: facts.role, asset, bounds }
    }
}

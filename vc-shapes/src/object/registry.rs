//! The generators that a program uses: the built-in ones and its own.

use vc_graph::class::Range;
use vc_graph::{Class, ClassTable};

use super::{Generator, generator, generators};
use crate::facts::ClassFacts;

/// A generator that is not registered.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RegisterError {
    /// The class has a generator.
    #[error("the class `{0}` has a generator already: give the object a class of its own, a kind of `{0}`")]
    Duplicate(&'static str),
    /// The class is not in the class table, or only as an alias.
    #[error("the class table has no class `{0}`: add a row for it by `ClassTable::extended`")]
    UnknownClass(&'static str),
    /// The row of the class has no size.
    #[error("the class `{0}` has no size in the class table: give its row the ranges of depth, width and height")]
    NoSize(&'static str),
}

/// Generators by class: the built-in ones, and those that a program registers.
///
/// ```
/// use vc_graph::{ClassTable, Seed};
/// use vc_shapes::material::OAK;
/// use vc_shapes::{Build, Generator, Generators, Realm, Style};
///
/// fn shoe_bench(b: &mut Build<'_>) {
///     let (x, y, z) = (b.size.x / 2.0, b.size.y / 2.0, b.size.z);
///     b.block("board", [-x, -y, z - 0.03], [x, y, z], OAK);
///     for side in [-1.0, 1.0] {
///         let (a, c) = (side * (y - 0.03), side * y);
///         b.block("side", [-x, a.min(c), 0.0], [x, a.max(c), z - 0.03], OAK);
///     }
///     b.top("board", [0.0, 0.0, z], (x, y));
/// }
///
/// let row = "shoe_bench | bench | | furniture | surface sittable | 0.3 0.6-0.9 0.45 | 6 | | | hallway:1";
/// let classes = ClassTable::builtin().extended("mine.txt", row)?;
/// let mut generators = Generators::default();
/// generators.register(&classes, Generator::new("shoe_bench", Realm::Indoor, 1, shoe_bench))?;
/// let bench = generators.get("shoe_bench").ok_or("not registered")?.object(&Style::from_seed(Seed(1)), Seed(1));
/// assert_eq!(bench.asset.parts.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Generators {
    own: Vec<Registered>,
}

/// A generator of the program's own, and the row of its class.
#[derive(Debug, Clone)]
struct Registered {
    generator: Generator,
    row: Class,
}

impl Generators {
    /// The built-in generators.
    pub const BUILTIN: Self = Self { own: Vec::new() };

    /// Adds a generator for a class of a table; the row of the class has the usual size, the role and the places where
    /// its things are kept.
    ///
    /// # Errors
    /// [`RegisterError`] if the class has a generator, is not in the table, or has no size there.
    pub fn register(&mut self, classes: &ClassTable, generator: Generator) -> Result<(), RegisterError> {
        let class = generator.class;
        let row = classes.get(class).filter(|row| &*row.name == class).ok_or(RegisterError::UnknownClass(class))?;
        if self.get(class).is_some() {
            return Err(RegisterError::Duplicate(class));
        }
        row.size.ok_or(RegisterError::NoSize(class))?;
        let own = Some(ClassFacts::new(row));
        self.own.push(Registered { generator: Generator { own, ..generator }, row: row.clone() });
        Ok(())
    }

    /// Finds the generator of a class.
    pub fn get(&self, class: &str) -> Option<&Generator> {
        let own = self.own.iter().map(|own| &own.generator).find(|g| g.class == class);
        own.or_else(|| generator(class))
    }

    /// All generators: the built-in ones by family, then the registered ones in their order.
    pub fn iter<'a>(&'a self) -> impl Iterator<Item = &'a Generator> {
        generators()
            .map(|builtin| -> &'a Generator { builtin })
            .chain(self.registered().map(|(generator, _)| generator))
    }

    /// The registered generators in their order, with the rows of their classes.
    pub fn registered(&self) -> impl Iterator<Item = (&Generator, &Class)> {
        self.own.iter().map(|own| (&own.generator, &own.row))
    }

    /// The usual ranges of a class's depth, width and height, metres; `None` if the class has no generator.
    pub fn usual_ranges(&self, class: &str) -> Option<[Range; 3]> {
        self.get(class)?.usual_ranges()
    }
}

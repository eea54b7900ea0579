//! Dressing by use, as data: the things that rooms of a kind always have, mostly have, and have in scenes of life.
//!
//! A table has a line for each; [`Dressing::parse`] describes its form. `furnish/dress.rs` places those that stand on
//! floors or hang on walls, `clutter/dress.rs` those on, in and from furniture.

mod error;
mod household;
mod read;
mod rule;

use std::sync::{Arc, LazyLock};

use vc_graph::ClassTable;

pub use error::{DressingError, DressingFault};
pub(crate) use household::Household;
use rule::Table;
pub(crate) use rule::{Anchor, Place, Rule, Side, WallAt};

/// A table of what rooms have lying, standing and hanging in them, by kind of room, household and style.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Apartment, Dressing, Specification};
/// let wishes = Specification { dressing: Some(Dressing::builtin()), ..Specification::default() };
/// let (dressed, plain) = (Apartment::generate(&wishes, Seed(7))?, Apartment::from_seed(Seed(7))?);
/// assert!(dressed.items.len() > plain.items.len());
/// assert!(dressed.scene().of_class("towel").len() + dressed.scene().of_class("bath_towel").len() > 0);
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Dressing(Arc<Table>);

impl Dressing {
    /// The table `data/dressing.txt`, read once per process.
    pub fn builtin() -> Self {
        static BUILTIN: LazyLock<Dressing> = LazyLock::new(|| {
            let read = Dressing::parse("dressing.txt", include_str!("../../data/dressing.txt"));
            // A test reads the built-in text and shows its errors.
            read.unwrap_or_else(|_| Dressing(Arc::default()))
        });
        BUILTIN.clone()
    }

    /// Reads a table. `#` begins a comment; there are four kinds of lines:
    ///
    /// - `trait cat | 0.2` names something that a fifth of all households have or are; `trait teenager | 0.5 child` only
    ///   where the words after the chance hold. `child` (the home has a child's room), `studio`, and the manners of a
    ///   home's style, `nordic`, `modern`, `classic`, `country` and `midcentury`, are known without a line.
    /// - `list breakfast = jam, honey, butter` is a name for several classes, used as `@breakfast`.
    /// - `[kitchen living_room]` begins the lines of rooms of these classes; `wc` is a toilet without a bath.
    /// - `0.3 cat !dog | 1-2 pet_bowl | corner` is a rule: its chance and the traits that it needs or excludes; how many
    ///   of which things; and where they go. `4x plate` are four alike. Of several classes, `mug/cup/@breakfast`, one is
    ///   drawn for each thing; a group is all its classes, `fruit`.
    ///
    /// A rule that is indented by two more spaces than a line above is about the thing that that line has put there, and
    /// nothing without it: `it`. Places are:
    ///
    /// | place | |
    /// |---|---|
    /// | `on desk/table`, `in fridge`, `hang coat_rack` | on a top, in a hollow, from a hook of a piece of these classes; `each on bed`: of every such piece |
    /// | `back on sideboard` | along the back edge, facing front |
    /// | `row bookshelf` | upright side by side, as books; the count is that of shelves |
    /// | `seat dining_table` | on the table before its chairs; the count is that of chairs |
    /// | `on it`, `in it`, `hang it` | on, in, from the thing of the line above |
    /// | `beside it`, `left it`, `right it`, `far it` | on the same surface: close by, to its left or right, or behind it |
    /// | `wall`, `corner`, `floor` | on the floor: back to a wall, in a corner, anywhere |
    /// | `before bed`, `next desk` | on the floor: in front of a piece, beside it; `before entrance`: behind the front door |
    /// | `at 1.5`, `over sofa 1.4`, `near toilet 0.7`, `within shower 1` | on a wall, the lower edge at this height in metres: anywhere, above a piece, near it, in it |
    /// | `ceiling`, `ceiling bathtub` | on the ceiling: anywhere, or down over the front edge of a piece |
    /// | `instead chair` | in place of each such piece of the room, in its size |
    ///
    /// ```
    /// use vc_procgen::Dressing;
    /// let mine = "trait smoker | 0.2\n[living_room]\n1 smoker | ashtray | on coffee_table\n  0.5 | lighter | beside it";
    /// assert!(Dressing::parse("mine.txt", mine).is_ok());
    /// let error = Dressing::parse("mine.txt", "[kitchen]\n1 | ketle | back on kitchen_counter").unwrap_err();
    /// assert_eq!(error.to_string(), "mine.txt:2: there is no class `ketle` (did you mean `kettle`?)");
    /// ```
    ///
    /// # Errors
    /// [`DressingError`] with the line of the first fault.
    pub fn parse(file: &str, text: &str) -> Result<Self, DressingError> {
        Self::parse_with(file, text, &ClassTable::builtin())
    }

    /// As [`parse`](Self::parse), with the class table of a program's own classes.
    ///
    /// # Errors
    /// [`DressingError`] with the line of the first fault.
    pub fn parse_with(file: &str, text: &str, classes: &ClassTable) -> Result<Self, DressingError> {
        read::table(Table::default(), (file, text), classes).map(|table| Self(Arc::new(table)))
    }

    /// This table and the lines of another text, which may use its traits and lists. A rule draws by its own words, so that
    /// the other things of a home stay as they were, except where they have no space any more.
    ///
    /// ```
    /// use vc_procgen::Dressing;
    /// let mine = Dressing::builtin().extended("mine.txt", "[hallway]\n1 | bicycle_helmet | on shoe_cabinet")?;
    /// assert_ne!(mine, Dressing::builtin());
    /// # Ok::<(), vc_procgen::DressingError>(())
    /// ```
    ///
    /// # Errors
    /// [`DressingError`] with the line of the first fault.
    pub fn extended(&self, file: &str, text: &str) -> Result<Self, DressingError> {
        read::table((*self.0).clone(), (file, text), &ClassTable::builtin()).map(|table| Self(Arc::new(table)))
    }

    /// The classes that its lines name, sorted.
    pub fn classes(&self) -> Vec<&str> {
        let mut all: Vec<&str> = self.0.rules.iter().flat_map(|rule| rule.classes()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}

//! The lines of a table, read.

use std::sync::Arc;

use vc_graph::Seed;

use crate::plan::RoomKind;

/// A whole table.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Table {
    pub(super) traits: Vec<Trait>,
    pub(super) lists: Vec<(String, Vec<Arc<str>>)>,
    pub(super) rules: Vec<Rule>,
}

/// Something that a household has or is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Trait {
    pub(super) name: String,
    pub(super) chance: f32,
    pub(super) when: Condition,
}

/// Traits that a household must have and must not have, as bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Condition {
    pub(super) needs: u64,
    pub(super) bars: u64,
}

impl Condition {
    pub(super) fn holds(self, traits: u64) -> bool {
        traits & self.needs == self.needs && traits & self.bars == 0
    }
}

/// A line: with a chance, some things go to a place of a room.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rule {
    pub(crate) chance: f32,
    pub(super) when: Condition,
    /// The rooms, as bits by [`RoomKind`].
    pub(super) rooms: u16,
    pub(crate) things: Things,
    pub(crate) place: Place,
    /// The words of its things and place, and how many rules of the same words stand before it: by these it draws.
    pub(super) words: (String, u64),
    /// The rules about each thing that this one places.
    pub(crate) then: Vec<Rule>,
}

/// How many things of which classes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Things {
    pub(crate) count: (usize, usize),
    /// Whether all are the same object.
    pub(crate) alike: bool,
    /// One is drawn for each thing.
    pub(crate) classes: Vec<Arc<str>>,
}

/// The side of a thing on which another one is put, seen from its own front.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Near,
    Left,
    Right,
    Far,
}

/// The piece that a place on, in or from furniture is about.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Anchor {
    /// One piece of these classes, or each.
    Piece { classes: Vec<Arc<str>>, each: bool },
    /// The thing of the rule above.
    It,
}

/// The height of a wall's place, metres, and the piece it is near.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum WallAt {
    Anywhere,
    Over(Vec<Arc<str>>),
    Near(Vec<Arc<str>>),
    Within(Vec<Arc<str>>),
}

/// Where things go.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Place {
    On { anchor: Anchor, back: bool },
    In(Anchor),
    Hang(Anchor),
    Row(Anchor),
    Seat(Anchor),
    Beside(Side),
    Against,
    Corner,
    Floor,
    Before(Vec<Arc<str>>),
    BeforeEntrance,
    Next(Vec<Arc<str>>),
    Wall { height: f32, at: WallAt },
    Ceiling,
    CeilingBefore(Vec<Arc<str>>),
    Instead(Vec<Arc<str>>),
}

impl Place {
    /// Whether things there are placed with the furniture, before anything lies on it.
    pub(crate) fn is_furniture(&self) -> bool {
        !matches!(self, Self::On { .. } | Self::In(_) | Self::Hang(_) | Self::Row(_) | Self::Seat(_) | Self::Beside(_))
    }
}

impl Rule {
    /// Its own seed: rules that are added to a table leave the others their draws.
    pub(crate) fn seed(&self, of: Seed) -> Seed {
        of.child(&self.words.0).nth(self.words.1)
    }

    /// The classes of its things, and of those of the rules below it.
    pub(super) fn classes(&self) -> Vec<&str> {
        let own = self.things.classes.iter().map(|class| &**class);
        own.chain(self.then.iter().flat_map(Rule::classes)).collect()
    }
}

/// The bit of a kind of room.
pub(super) fn bit(kind: RoomKind) -> u16 {
    1 << kind as u16
}

//! Tags as rules read them. Each tag remembers whether a rule asked for it and whether it had a use for its value, so that
//! whatever nobody used can be listed: no rule has to think of that.

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::ops::{Deref, Range};

use super::data::{Node, Relation, Way};
use super::{Element, OsmData, Reason};
use crate::Point;
use crate::geo::Frame;

/// Nodes further from the middle of the map than this in either direction are none of it, metres.
const FARTHEST: f64 = 9e5;

/// How much use was made of a tag.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Use {
    /// No rule asked for its key.
    #[default]
    Unread,
    /// Rules asked for its key, and none knew what to do with its value.
    Asked,
    /// A rule went by it.
    Used,
}

/// Data while a map is made of it.
pub(super) struct Source<'a> {
    data: &'a OsmData,
    /// The places of all nodes.
    pub(super) points: Vec<Point>,
    uses: Vec<Cell<Use>>,
    kept: RefCell<BTreeSet<Element>>,
}

impl Deref for Source<'_> {
    type Target = OsmData;

    fn deref(&self) -> &OsmData {
        self.data
    }
}

impl<'a> Source<'a> {
    pub(super) fn new(data: &'a OsmData) -> Self {
        let uses = vec![Cell::new(Use::Unread); data.tags.len()];
        Self { data, points: Vec::new(), uses, kept: RefCell::new(BTreeSet::new()) }
    }

    /// Gives all nodes their places.
    pub(super) fn lay_out(&mut self, frame: &Frame) {
        self.points = self.data.nodes.iter().map(|node| frame.point(node.degrees())).collect();
    }

    /// The position of a node that the file has and that a map reaches.
    pub(super) fn near(&self, id: i64) -> Option<u32> {
        let position = self.data.node(id)?;
        self.is_near(position).then_some(position as u32)
    }

    pub(super) fn is_near(&self, position: usize) -> bool {
        self.points[position].iter().all(|value| value.abs() <= FARTHEST)
    }

    pub(super) fn point(&self, position: u32) -> Point {
        self.points[position as usize]
    }

    /// Why some of these nodes are not [`near`](Self::near), if any is not.
    pub(super) fn lacks(&self, ids: &[i64]) -> Option<Reason> {
        let mut lost = ids.iter().filter(|id| self.near(**id).is_none()).peekable();
        lost.peek()?;
        Some(if lost.any(|id| self.data.node(*id).is_some()) { Reason::TooFar } else { Reason::CutOff })
    }

    /// Notes that an element is in the map.
    pub(super) fn keep(&self, element: Element) {
        self.kept.borrow_mut().insert(element);
    }

    pub(super) fn is_kept(&self, element: Element) -> bool {
        self.kept.borrow().contains(&element)
    }

    fn tags(&self, tags: &Range<u32>) -> Tags<'_> {
        let range = tags.start as usize..tags.end as usize;
        Tags { data: self.data, tags: &self.data.tags[range.clone()], uses: &self.uses[range] }
    }

    pub(super) fn node_tags(&self, node: &Node) -> Tags<'_> {
        self.tags(&node.tags)
    }

    pub(super) fn way_tags(&self, way: &Way) -> Tags<'_> {
        self.tags(&way.tags)
    }

    pub(super) fn relation_tags(&self, relation: &Relation) -> Tags<'_> {
        self.tags(&relation.tags)
    }
}

/// The tags of an element.
#[derive(Clone, Copy)]
pub(super) struct Tags<'a> {
    data: &'a OsmData,
    tags: &'a [[u32; 2]],
    uses: &'a [Cell<Use>],
}

impl<'a> Tags<'a> {
    /// The value of a key as a rule understands it; a value that gives `None` counts as not used.
    pub(super) fn read<T>(self, key: &str, understand: impl FnOnce(&'a str) -> Option<T>) -> Option<T> {
        let index = self.tags.iter().position(|[k, _]| self.data.word(*k) == key)?;
        let found = understand(self.data.word(self.tags[index][1]));
        let now = if found.is_some() { Use::Used } else { Use::Asked };
        self.uses[index].set(self.uses[index].get().max(now));
        found
    }

    /// The value of a key of which every value is of use, such as a name.
    pub(super) fn text(self, key: &str) -> Option<&'a str> {
        self.read(key, Some)
    }

    /// Whether there is a key; its value is none of the question.
    pub(super) fn has(self, key: &str) -> bool {
        self.read(key, |_| None::<()>);
        self.tags.iter().any(|[k, _]| self.data.word(*k) == key)
    }

    /// Whether a key has one of some values, parted by `|`.
    pub(super) fn is(self, key: &str, values: &str) -> bool {
        self.read(key, |value| values.split('|').any(|other| other == value).then_some(())).is_some()
    }

    /// Whether there is a key with another value than `no`.
    pub(super) fn yes(self, key: &str) -> bool {
        self.read(key, |value| Some(value != "no")).unwrap_or(false)
    }

    pub(super) fn is_empty(self) -> bool {
        self.tags.is_empty()
    }

    /// Each tag with the use that was made of it.
    pub(super) fn uses(self) -> impl Iterator<Item = (&'a str, &'a str, Use)> {
        let word = |number: u32| self.data.word(number);
        self.tags.iter().zip(self.uses).map(move |([key, value], used)| (word(*key), word(*value), used.get()))
    }
}

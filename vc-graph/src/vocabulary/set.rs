//! Small sets of words.

use std::cmp::Ordering;
use std::fmt;
use std::marker::PhantomData;

use super::Word;
use super::own_words::OwnWords;
use crate::hash::Digester;

/// The number of bit masks: the first is of built-in words, the others of own ones.
const MASKS: usize = 4;

/// A set of words of one vocabulary, as bit masks.
///
/// ```
/// use vc_graph::{Property, PropertySet};
/// let set = PropertySet::from_words(&[Property::Graspable, Property::Openable]);
/// assert!(set.contains(Property::Openable) && set.len() == 2);
/// assert_eq!(set.without(Property::Openable).iter().collect::<Vec<_>>(), [Property::Graspable]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Set<W> {
    masks: [u64; MASKS],
    word: PhantomData<W>,
}

impl<W: Word> Set<W> {
    /// The empty set.
    pub const EMPTY: Self = Self { masks: [0; MASKS], word: PhantomData };

    /// The set of the given words.
    pub fn from_words(words: &[W]) -> Self {
        words.iter().copied().collect()
    }

    /// Whether the word is in the set.
    pub fn contains(self, word: W) -> bool {
        let (mask, bit) = place(word);
        self.masks[mask] & bit != 0
    }

    /// Whether any word of `other` is in this set.
    pub fn intersects(self, other: Self) -> bool {
        // All masks at once: most sets have words in the first only, and a branch for each costs more.
        (0..MASKS).fold(0, |both, i| both | (self.masks[i] & other.masks[i])) != 0
    }

    /// This set with the word added.
    #[must_use]
    pub fn with(mut self, word: W) -> Self {
        let (mask, bit) = place(word);
        self.masks[mask] |= bit;
        self
    }

    /// This set without the word.
    #[must_use]
    pub fn without(mut self, word: W) -> Self {
        let (mask, bit) = place(word);
        self.masks[mask] &= !bit;
        self
    }

    /// Words in either set.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        self.joined(other, |own, other| own | other)
    }

    /// Words of this set that are not in `other`.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        self.joined(other, |own, other| own & !other)
    }

    fn joined(self, other: Self, join: impl Fn(u64, u64) -> u64) -> Self {
        Self { masks: std::array::from_fn(|i| join(self.masks[i], other.masks[i])), ..self }
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.masks == [0; MASKS]
    }

    /// Number of words.
    pub fn len(self) -> usize {
        self.masks.iter().map(|mask| mask.count_ones() as usize).sum()
    }

    /// The words: built-in ones in declaration order, then own ones by name.
    pub fn iter(self) -> impl Iterator<Item = W> {
        bits(self.masks[0]).filter_map(|bit| W::ALL.get(bit).copied()).chain(self.own())
    }

    /// The words that are not built in, by name.
    pub fn own(self) -> impl Iterator<Item = W> {
        // Without own words, nothing is allocated or looked through.
        let has_own = self.masks[1..].iter().any(|mask| *mask != 0);
        let masks = self.masks.into_iter().enumerate().skip(1);
        let indices = masks.flat_map(|(at, mask)| bits(mask).map(move |bit| at * OwnWords::FIRST + bit));
        let mut own: Vec<W> = if has_own { indices.filter_map(W::from_index).collect() } else { Vec::new() };
        own.sort_unstable();
        own.into_iter()
    }

    /// The mask of the built-in words: bit `i` is [`Word::ALL`]`[i]`.
    pub fn builtin_bits(self) -> u64 {
        self.masks[0]
    }

    /// Feeds the own words by their names, since their numbers differ from run to run; nothing if there are none.
    pub(crate) fn feed_own(self, hash: &mut Digester) {
        self.own().for_each(|word| _ = hash.text(W::WHAT).text(word.as_str()));
    }
}

/// The mask of a word, and its bit there.
fn place<W: Word>(word: W) -> (usize, u64) {
    let index = word.index();
    (index / OwnWords::FIRST % MASKS, 1 << (index % OwnWords::FIRST))
}

/// The numbers of the bits that are set, in ascending order.
pub(crate) fn bits(mut left: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = left.trailing_zeros() as usize;
        left &= left.wrapping_sub(1);
        (bit < OwnWords::FIRST).then_some(bit)
    })
}

/// By the built-in words, then by the names of the own ones.
impl<W: Word> Ord for Set<W> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.masks[0].cmp(&other.masks[0]).then_with(|| self.own().cmp(other.own()))
    }
}

impl<W: Word> PartialOrd for Set<W> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<W: Word> Default for Set<W> {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl<W: Word> FromIterator<W> for Set<W> {
    fn from_iter<I: IntoIterator<Item = W>>(words: I) -> Self {
        words.into_iter().fold(Self::EMPTY, Self::with)
    }
}

/// A list of words.
impl<W: Word> serde::Serialize for Set<W> {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_seq(self.iter().map(W::as_str))
    }
}

impl<'de, W: Word> serde::Deserialize<'de> for Set<W> {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let words = <Vec<String> as serde::Deserialize>::deserialize(d)?;
        words.iter().map(|word| W::parse(word).map_err(serde::de::Error::custom)).collect()
    }
}

impl<W: Word> fmt::Debug for Set<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter().map(W::as_str)).finish()
    }
}

impl<W: Word> fmt::Display for Set<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, word) in self.iter().enumerate() {
            let gap = if i == 0 { "" } else { " " };
            write!(f, "{gap}{}", word.as_str())?;
        }
        Ok(())
    }
}

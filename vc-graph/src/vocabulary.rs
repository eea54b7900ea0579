//! Closed word lists (states, affordances, verbs, ...) and small sets of them.

use std::fmt;
use std::hash::Hash;
use std::marker::PhantomData;

use crate::spelling::{clip, did_you_mean, same_word};

/// A closed vocabulary: an enum whose variants each have one written word.
///
/// ```
/// use vc_graph::{Relation, Word};
/// assert_eq!(Relation::parse("HOLDS-RIGHT")?, Relation::HoldsRight);
/// assert_eq!(Relation::HoldsRight.as_str(), "holds_right");
/// # Ok::<(), vc_graph::UnknownWord>(())
/// ```
pub trait Word: Copy + Eq + Ord + Hash + fmt::Debug + 'static {
    /// The noun for a word of this vocabulary in messages ("state", "verb").
    const WHAT: &'static str;
    /// Every word, in declaration order.
    const ALL: &'static [Self];
    /// Index in [`Word::ALL`].
    fn index(self) -> usize;
    /// The written form: lower case, words joined by `_`.
    fn as_str(self) -> &'static str;

    /// Finds the word for a spelling, ignoring case, spaces, `_` and `-`.
    ///
    /// # Errors
    /// [`UnknownWord`], which names the vocabulary and lists the allowed words.
    fn parse(text: &str) -> Result<Self, UnknownWord> {
        let exact = Self::ALL.iter().find(|w| w.as_str() == text);
        let found = exact.or_else(|| Self::ALL.iter().find(|w| same_word(w.as_str(), text)));
        found.copied().ok_or_else(|| UnknownWord {
            what: Self::WHAT,
            word: clip(text),
            allowed: Self::ALL.iter().map(|w| w.as_str()).collect::<Vec<_>>().join(" "),
        })
    }
}

/// An error: a word that is not in its vocabulary.
///
/// ```
/// use vc_graph::{State, Word};
/// let error = State::parse("opn").unwrap_err();
/// assert!(error.to_string().contains("open"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("unknown {what} `{word}`{}; use one of: {allowed}", did_you_mean(.word, .allowed.split(' ')))]
pub struct UnknownWord {
    /// The noun for a word of the vocabulary.
    pub what: &'static str,
    /// The spelling that was not found (clipped to a readable length).
    pub word: String,
    /// All words of the vocabulary.
    pub allowed: String,
}

/// A set of words of one vocabulary, as a bit mask (64 words at most).
///
/// ```
/// use vc_graph::{Property, PropertySet};
/// let set = PropertySet::from_words(&[Property::Graspable, Property::Openable]);
/// assert!(set.contains(Property::Openable) && set.len() == 2);
/// assert_eq!(set.without(Property::Openable).iter().collect::<Vec<_>>(), [Property::Graspable]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Set<W> {
    bits: u64,
    word: PhantomData<W>,
}

impl<W: Word> Set<W> {
    /// The empty set.
    pub const EMPTY: Self = Self { bits: 0, word: PhantomData };

    /// The set of the given words.
    pub fn from_words(words: &[W]) -> Self {
        words.iter().copied().collect()
    }

    /// Whether the word is in the set.
    pub fn contains(self, word: W) -> bool {
        self.bits & mask(word) != 0
    }

    /// Whether any word of `other` is in this set.
    pub fn intersects(self, other: Self) -> bool {
        self.bits & other.bits != 0
    }

    /// This set with the word added.
    #[must_use]
    pub fn with(self, word: W) -> Self {
        Self { bits: self.bits | mask(word), ..self }
    }

    /// This set without the word.
    #[must_use]
    pub fn without(self, word: W) -> Self {
        Self { bits: self.bits & !mask(word), ..self }
    }

    /// Words in either set.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { bits: self.bits | other.bits, ..self }
    }

    /// Words of this set that are not in `other`.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self { bits: self.bits & !other.bits, ..self }
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.bits == 0
    }

    /// Number of words.
    pub fn len(self) -> usize {
        self.bits.count_ones() as usize
    }

    /// The words, in declaration order.
    pub fn iter(self) -> impl Iterator<Item = W> {
        let mut left = self.bits;
        std::iter::from_fn(move || {
            let word = W::ALL.get(left.trailing_zeros() as usize)?;
            left &= left - 1;
            Some(*word)
        })
    }

    /// The raw mask: bit `i` is [`Word::ALL`]`[i]`.
    pub fn bits(self) -> u64 {
        self.bits
    }
}

fn mask<W: Word>(word: W) -> u64 {
    1 << word.index()
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

/// Declares a vocabulary: the enum, its words, `Display`, `FromStr` and serde.
macro_rules! vocabulary {
    ($(#[$meta:meta])* $name:ident, $what:literal {
        $($(#[$vmeta:meta])* $variant:ident = $word:literal),* $(,)?
    }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum $name { $($(#[$vmeta])* $variant),* }

        impl $crate::vocabulary::Word for $name {
            const WHAT: &'static str = $what;
            const ALL: &'static [Self] = &[$(Self::$variant),*];
            fn index(self) -> usize { self as usize }
            fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $word),* }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad($crate::vocabulary::Word::as_str(*self))
            }
        }

        impl std::str::FromStr for $name {
            type Err = $crate::vocabulary::UnknownWord;
            fn from_str(text: &str) -> Result<Self, Self::Err> {
                $crate::vocabulary::Word::parse(text)
            }
        }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
                s.serialize_str($crate::vocabulary::Word::as_str(*self))
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
                let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
                $crate::vocabulary::Word::parse(&text).map_err(serde::de::Error::custom)
            }
        }
    };
}
pub(crate) use vocabulary;

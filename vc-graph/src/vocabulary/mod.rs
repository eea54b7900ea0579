//! Word lists: closed ones, and those to which a scene may add its own words (states, affordances, verbs).

mod error;
mod line;
mod own_words;
mod parts;
mod read;
mod scene;
mod set;
mod write;

use std::fmt;
use std::hash::Hash;

use crate::spelling::{clip, did_you_mean, same_word};

pub use error::{VocabularyError, VocabularyProblem};
pub use own_words::NameProblem;
pub(crate) use own_words::OwnWords;
pub(crate) use parts::{Part, Used, forms, next, unknown};
pub use scene::{OwnState, Vocabulary};
pub use set::Set;
pub(crate) use set::bits;
pub(crate) use write::entry;

/// A list of words, each with one written form. Words of closed lists are enums; states, properties and verbs are
/// numbers, as a scene may have [own ones](Vocabulary). They are ordered as they are declared, own ones after these by
/// name.
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
    /// Every built-in word, in declaration order.
    const ALL: &'static [Self];
    /// Index in [`Word::ALL`]; 64 or more for an own word, and below 256. Indices of own words differ from run to run.
    fn index(self) -> usize;
    /// The word with an index.
    fn from_index(index: usize) -> Option<Self> {
        Self::ALL.get(index).copied()
    }
    /// The own word of a spelling, if some scene of this process has declared it.
    fn declared(_: &str) -> Option<Self> {
        None
    }
    /// The written form: lower case, words joined by `_`.
    fn as_str(self) -> &'static str;

    /// Finds the built-in word for a spelling, ignoring case, spaces, `_` and `-`.
    fn builtin(text: &str) -> Option<Self> {
        let exact = Self::ALL.iter().find(|w| w.as_str() == text);
        exact.or_else(|| Self::ALL.iter().find(|w| same_word(w.as_str(), text))).copied()
    }

    /// Finds the word for a spelling, ignoring case, spaces, `_` and `-`.
    ///
    /// # Errors
    /// [`UnknownWord`], which names the vocabulary and lists the built-in words.
    fn parse(text: &str) -> Result<Self, UnknownWord> {
        Self::builtin(text).or_else(|| Self::declared(text)).ok_or_else(|| UnknownWord {
            what: Self::WHAT,
            word: clip(text).into(),
            allowed: Self::ALL.iter().map(|w| w.as_str()).collect::<Vec<_>>().join(" ").into(),
            near: did_you_mean(&clip(text), known::<Self>()).into(),
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
#[error("unknown {what} `{word}`{near}; use one of: {allowed}{}", hint(.what))]
pub struct UnknownWord {
    /// The noun for a word of the vocabulary.
    pub what: &'static str,
    /// The spelling that was not found (clipped to a readable length).
    pub word: Box<str>,
    /// The built-in words of the vocabulary.
    pub allowed: Box<str>,
    /// The words nearest to it, own ones among them, as [`did_you_mean`] writes them; empty if none is near.
    pub near: Box<str>,
}

/// The written forms of all words of a vocabulary: the built-in ones, then those that scenes of this process have declared.
pub(crate) fn known<W: Word>() -> impl Iterator<Item = &'static str> {
    let own = (OwnWords::FIRST..).map_while(W::from_index);
    W::ALL.iter().copied().chain(own).map(W::as_str)
}

/// How to have a word of one's own, where that is possible.
fn hint(what: &str) -> &'static str {
    match what {
        "state" | "property" | "verb" => "; your own are declared in a `Vocabulary` first",
        _ => "",
    }
}

/// Declares a closed list of words: the enum, its words, `Display`, `FromStr` and serde.
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

        $crate::vocabulary::written!($name);
    };
}
pub(crate) use vocabulary;

/// Declares a list of words to which scenes may add their own: numbers, with the built-in words as constants.
macro_rules! open_vocabulary {
    ($(#[$meta:meta])* $name:ident, $what:literal {
        $($(#[$vmeta:meta])* $variant:ident = $word:literal),* $(,)?
    }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct $name(u8);

        #[allow(non_upper_case_globals, reason = "the words are named as the variants of the closed lists are")]
        impl $name {
            $($(#[$vmeta])* pub const $variant: Self = Self(Number::$variant as u8);)*
        }

        /// The numbers of the built-in words.
        #[repr(u8)]
        enum Number { $($variant),* }

        static OWN: $crate::vocabulary::OwnWords = $crate::vocabulary::OwnWords::new();

        const _: () =
            assert!(<$name as $crate::Word>::ALL.len() <= $crate::vocabulary::OwnWords::FIRST, "own words come later");

        impl $name {
            /// Whether the word is built in, and not a scene's own.
            pub const fn is_builtin(self) -> bool {
                (self.0 as usize) < $crate::vocabulary::OwnWords::FIRST
            }

            /// The word of a name, which gets a number if it has none.
            pub(crate) fn declare(word: &str, things: u8) -> Result<Self, $crate::NameProblem> {
                let number = OWN.declare(word, things)?;
                Ok(Self((number + $crate::vocabulary::OwnWords::FIRST) as u8))
            }

            /// Name and number of things of an own word.
            fn own_name(self) -> Option<(&'static str, u8)> {
                OWN.name(usize::from(self.0).checked_sub($crate::vocabulary::OwnWords::FIRST)?)
            }
        }

        impl $crate::vocabulary::Word for $name {
            const WHAT: &'static str = $what;
            const ALL: &'static [Self] = &[$(Self::$variant),*];
            fn index(self) -> usize { usize::from(self.0) }
            fn as_str(self) -> &'static str {
                const WORDS: &[&str] = &[$($word),*];
                let builtin = WORDS.get(usize::from(self.0)).copied();
                builtin.or_else(|| self.own_name().map(|(name, _)| name)).unwrap_or_default()
            }
            fn from_index(index: usize) -> Option<Self> {
                let word = Self(u8::try_from(index).ok()?);
                (index < Self::ALL.len() || word.own_name().is_some()).then_some(word)
            }
            fn declared(text: &str) -> Option<Self> {
                OWN.find(text).map(|number| Self((number + $crate::vocabulary::OwnWords::FIRST) as u8))
            }
        }

        impl Ord for $name {
            fn cmp(&self, other: &Self) -> std::cmp::Ordering {
                match (self.is_builtin(), other.is_builtin()) {
                    (false, false) => $crate::Word::as_str(*self).cmp($crate::Word::as_str(*other)),
                    _ => self.0.cmp(&other.0),
                }
            }
        }

        impl PartialOrd for $name {
            fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
                Some(self.cmp(other))
            }
        }

        /// As a variant of an enum, whose name is the word's.
        impl std::fmt::Debug for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                const NAMES: &[&str] = &[$(stringify!($variant)),*];
                f.write_str(NAMES.get(usize::from(self.0)).copied().unwrap_or($crate::Word::as_str(*self)))
            }
        }

        $crate::vocabulary::written!($name);
    };
}
pub(crate) use open_vocabulary;

/// `Display`, `FromStr` and serde of a list of words.
macro_rules! written {
    ($name:ident) => {
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
pub(crate) use written;

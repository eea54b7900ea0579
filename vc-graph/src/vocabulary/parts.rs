//! Conditions and effects as words: `affords x polishable`.

use crate::goal::DerivedPredicate;
use crate::rule::Argument;
use crate::vocabulary::VocabularyProblem;
use crate::{Action, Aim, NodeId, Property, Relation, State, Verb, Word, clip, did_you_mean};

/// A part of a condition or effect of the rule table.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Used {
    Thing(Argument),
    State(State),
    Property(Property),
    Relation(Relation),
    Verb(Verb),
    Predicate(DerivedPredicate),
    /// An action's aim: no rule of a text has one.
    Aim,
}

impl Used {
    pub(crate) fn as_str(self) -> &'static str {
        match self {
            Self::Thing(Argument::X) => "x",
            Self::Thing(Argument::Y) => "y",
            Self::State(state) => state.as_str(),
            Self::Property(property) => property.as_str(),
            Self::Relation(relation) => relation.as_str(),
            Self::Verb(verb) => verb.as_str(),
            Self::Predicate(predicate) => predicate.as_str(),
            Self::Aim => "",
        }
    }
}

/// A type of these parts.
pub(crate) trait Part: Copy {
    /// The part in the condition or effect of an action.
    type Of;
    /// The part for an action; `None` if the action lacks the object.
    fn ground(self, action: &Action) -> Option<Self::Of>;
    fn used(self) -> Used;
    fn read(word: &str) -> Result<Self, VocabularyProblem>;
}

impl Part for Argument {
    type Of = NodeId;

    fn ground(self, action: &Action) -> Option<NodeId> {
        match self {
            Self::X => action.object,
            Self::Y => action.target,
        }
    }

    fn used(self) -> Used {
        Used::Thing(self)
    }

    fn read(word: &str) -> Result<Self, VocabularyProblem> {
        match word {
            "x" => Ok(Self::X),
            "y" => Ok(Self::Y),
            _ => Err(VocabularyProblem::Thing(clip(word))),
        }
    }
}

/// Parts that are the same for every action.
macro_rules! constant {
    ($($type:ident)*) => {
        $(impl Part for $type {
            type Of = Self;

            fn ground(self, _: &Action) -> Option<Self> {
                Some(self)
            }

            fn used(self) -> Used {
                Used::$type(self)
            }

            fn read(word: &str) -> Result<Self, VocabularyProblem> {
                Ok(Self::parse(word)?)
            }
        })*
    };
}

constant! { State Property Relation }

impl Part for Aim {
    type Of = Self;

    fn ground(self, _: &Action) -> Option<Self> {
        Some(self)
    }

    fn used(self) -> Used {
        Used::Aim
    }

    fn read(_: &str) -> Result<Self, VocabularyProblem> {
        Err(VocabularyProblem::OfAim)
    }
}

/// Lists the forms of conditions or effects: variant, name in texts, and parts. It declares how they are grounded,
/// written and read.
macro_rules! forms {
    ($type:ident, $what:literal { $($variant:ident = $name:literal { $($at:tt: $part:ident),* };)* }) => {
        impl $type<$crate::rule::Argument> {
            #[doc = concat!("The ", $what, " with the objects of an action; `None` if the action lacks one.")]
            pub fn ground(self, action: &$crate::Action) -> Option<$type<$crate::NodeId>> {
                use $crate::vocabulary::Part;
                Some(match self {
                    $(Self::$variant { $($at: $part),* } => $type::$variant { $($at: $part.ground(action)?),* },)*
                })
            }

            /// The name in texts, and the parts in order.
            pub(crate) fn words(self) -> (&'static str, Vec<$crate::vocabulary::Used>) {
                use $crate::vocabulary::Part;
                match self {
                    $(Self::$variant { $($at: $part),* } => ($name, vec![$($part.used()),*]),)*
                }
            }

            /// Reads a name and its parts.
            pub(crate) fn read(text: &str) -> Result<Self, $crate::VocabularyProblem> {
                let mut words = text.split_whitespace();
                let name = words.next().unwrap_or_default();
                let read = match name {
                    $($name => Self::$variant { $($at: $crate::vocabulary::next(&mut words, text)?),* },)*
                    _ => return Err($crate::vocabulary::unknown($what, name, &[$($name),*])),
                };
                match words.next() {
                    None => Ok(read),
                    Some(_) => Err($crate::VocabularyProblem::Parts($crate::clip(text))),
                }
            }
        }
    };
}
pub(crate) use forms;

/// Reads the next part of a condition or effect.
pub(crate) fn next<'t, P: Part>(words: &mut impl Iterator<Item = &'t str>, text: &str) -> Result<P, VocabularyProblem> {
    P::read(words.next().ok_or_else(|| VocabularyProblem::Parts(clip(text)))?)
}

pub(crate) fn unknown(what: &'static str, name: &str, known: &[&str]) -> VocabularyProblem {
    let near = did_you_mean(name, known.iter().copied());
    VocabularyProblem::Unknown { what, word: clip(name), near, known: known.join(" ") }
}

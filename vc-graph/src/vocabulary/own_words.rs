//! Names of own words, each with one number for the whole process.

use std::sync::OnceLock;

use crate::spelling::{clip, key, things as number_of};

/// The own words of one kind. A word gets the first free number and keeps it as long as the process runs, so that a word
/// is a few bits and can be written without its scene. Numbers depend on which scene came first; nothing else may.
pub(crate) struct OwnWords {
    names: [OnceLock<Name>; Self::MOST],
}

/// A declared name.
struct Name {
    word: &'static str,
    /// The folded spelling, by which it is found.
    key: String,
    things: u8,
}

/// The longest name of an own word, characters.
const LONGEST: usize = 40;

/// An error in the name of an own word.
///
/// ```
/// use vc_graph::{NameProblem, Vocabulary, VocabularyProblem};
/// let error = Vocabulary::parse("mine.txt", "state Waxed!").unwrap_err();
/// assert_eq!(error.problem, VocabularyProblem::Name(NameProblem::Form("Waxed!".into())));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NameProblem {
    /// The name has another form than those of built-in words.
    #[error(
        "`{0}` is no name of a word: one to {LONGEST} lower-case letters, digits and single `_` between them, a letter first"
    )]
    Form(String),
    /// The name is spelled as a built-in word of the same kind; that of a state or predicate, as another predicate of goals.
    #[error("`{0}` has a meaning already: choose another name")]
    BuiltIn(String),
    /// The name differs from one that this program knows only by separators.
    #[error("`{word}` is spelled `{known}` elsewhere in this program: use one spelling")]
    Spelling {
        /// The name.
        word: String,
        /// The name as it was declared before.
        known: &'static str,
    },
    /// A verb or predicate of this name takes another number of things.
    #[error("`{word}` takes {} elsewhere in this program, not {things}: choose another name", number_of((*.known).into()))]
    Things {
        /// The name.
        word: String,
        /// The number of things given.
        things: u8,
        /// The number of things declared before.
        known: u8,
    },
    /// No number is left.
    #[error("`{0}` is one word too many: a program has at most {most} own words of a kind", most = OwnWords::MOST)]
    TooMany(String),
}

impl OwnWords {
    /// The index of the first own word; built-in words have smaller ones.
    pub(crate) const FIRST: usize = 64;
    /// The largest number of own words of a kind.
    pub(crate) const MOST: usize = 192;

    pub(crate) const fn new() -> Self {
        Self { names: [const { OnceLock::new() }; Self::MOST] }
    }

    /// The name of a number, and of how many things a verb with it is.
    pub(crate) fn name(&self, number: usize) -> Option<(&'static str, u8)> {
        let name = self.names.get(number)?.get()?;
        Some((name.word, name.things))
    }

    /// The number of a name in any usual spelling.
    pub(crate) fn find(&self, text: &str) -> Option<usize> {
        self.names[0].get()?;
        let key = key(text);
        self.names.iter().map_while(OnceLock::get).position(|name| name.key == key)
    }

    /// The number of a name, which gets one if it has none. A name is kept as long as the process runs.
    pub(crate) fn declare(&self, word: &str, things: u8) -> Result<usize, NameProblem> {
        if !is_name(word) {
            return Err(NameProblem::Form(clip(word)));
        }
        let key = key(word);
        for (number, place) in self.names.iter().enumerate() {
            let known = place.get_or_init(|| Name::new(word, key.clone(), things));
            if known.key == key {
                return known.check(word, things).map(|()| number);
            }
        }
        Err(NameProblem::TooMany(word.to_owned()))
    }
}

impl Name {
    fn new(word: &str, key: String, things: u8) -> Self {
        Self { word: Box::leak(word.into()), key, things }
    }

    fn check(&self, word: &str, things: u8) -> Result<(), NameProblem> {
        let (word_of, known) = (|| word.to_owned(), self.things);
        match (self.word == word, known == things) {
            (false, _) => Err(NameProblem::Spelling { word: word_of(), known: self.word }),
            (_, false) => Err(NameProblem::Things { word: word_of(), things, known }),
            _ => Ok(()),
        }
    }
}

fn is_name(word: &str) -> bool {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let joined = !word.ends_with('_') && !word.contains("__");
    word.len() <= LONGEST && word.starts_with(|c: char| c.is_ascii_lowercase()) && joined && word.chars().all(plain)
}

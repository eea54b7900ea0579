//! Ground atoms and sets of atoms.

use std::fmt;

use vc_graph::goal::{Literal, Predicate, Term};
use vc_graph::hash::finalised;
use vc_graph::{NodeId, Word};

/// A predicate applied to given objects: a statement that is true or false in a scene.
///
/// ```
/// use vc_graph::goal::Situation;
/// use vc_graph::{Draft, History, SceneBuilder};
/// use vc_tasks::compile::GoalProgram;
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
/// let apple = scene.add_on(table, Draft::new("apple"))?;
/// let me = scene.add_in(kitchen, Draft::new("character"))?;
/// let (graph, history) = (scene.build(), History::default());
/// let now = Situation::new(&graph, me, &history);
/// let program = GoalProgram::new(&"On(apple, kitchen_table)".parse()?, &now)?;
/// assert_eq!(program.atoms()[0].things, [Some(apple), Some(table)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GroundAtom {
    /// The predicate.
    pub predicate: Predicate,
    /// The arguments; unused positions, and those that may be any object, are `None`.
    pub things: [Option<NodeId>; 2],
}

impl GroundAtom {
    /// Whether the atom is about an executed action.
    pub(crate) fn is_about_action(&self) -> bool {
        matches!(self.predicate, Predicate::Did(_))
    }

    /// A hash key of predicate and arguments, the same for equal atoms.
    pub(super) fn key(&self) -> u64 {
        let predicate = match self.predicate {
            Predicate::State(state) => state.index(),
            Predicate::Relation(relation) => 256 + relation.index(),
            Predicate::Did(verb) => 512 + verb.index(),
            Predicate::Derived(predicate) => 1024 + predicate.index(),
            Predicate::Holds => 768,
            _ => 769,
        } as u64;
        let [a, b] = self.things.map(|id| u64::from(id.map_or(u32::MAX, |id| id.0)));
        finalised(finalised((predicate << 32) | a) ^ b)
    }
}

impl fmt::Display for GroundAtom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let term = |id: &Option<NodeId>| id.map_or(Term::Anything, |id| Term::Node(None, id));
        let terms = self.things.iter().take(self.predicate.arity()).map(term).collect();
        write!(f, "{}", Literal { predicate: self.predicate, terms })
    }
}

/// A set of atoms, by their indices in a [`GoalProgram`](super::GoalProgram).
///
/// ```
/// use vc_tasks::compile::Bits;
/// let mut bits = Bits::none(70);
/// bits.set(69, true);
/// assert!(bits.has(69) && !bits.has(0));
/// assert_eq!(bits.count(), 1);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Bits {
    words: Vec<u64>,
}

impl Bits {
    /// The empty set for a number of atoms.
    pub fn none(number: usize) -> Self {
        Self { words: vec![0; number.div_ceil(64)] }
    }

    /// Whether an atom is in the set.
    #[inline]
    pub fn has(&self, atom: usize) -> bool {
        self.words.get(atom / 64).is_some_and(|word| (word >> (atom % 64)) & 1 != 0)
    }

    /// Sixty-four atoms as one word; zero beyond the end.
    #[inline]
    pub(crate) fn word(&self, index: usize) -> u64 {
        self.words.get(index).copied().unwrap_or(0)
    }

    /// Adds or removes an atom; an index out of range is ignored.
    #[inline]
    pub fn set(&mut self, atom: usize, value: bool) {
        if let Some(word) = self.words.get_mut(atom / 64) {
            let bit = 1 << (atom % 64);
            *word = if value { *word | bit } else { *word & !bit };
        }
    }

    /// Removes the atoms of another set.
    pub(super) fn remove(&mut self, other: &Self) {
        self.words.iter_mut().zip(&other.words).for_each(|(word, other)| *word &= !other);
    }

    /// Adds the intersection of two other sets.
    pub(super) fn add_of(&mut self, other: &Self, among: &Self) {
        let both = other.words.iter().zip(&among.words).map(|(other, among)| other & among);
        self.words.iter_mut().zip(both).for_each(|(word, both)| *word |= both);
    }

    /// The number of atoms in the set.
    pub fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }
}

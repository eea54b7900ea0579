//! Class numbers.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use vc_graph::class::Class;
use vc_graph::{SceneGraph, Seed, Word};

use crate::RenderError;
use crate::modality::NO_LABEL;

/// The first number for classes that are not in the class table.
const UNKNOWN: u16 = 1 << 15;

/// Class numbers. A class of the scene's class table is numbered by its position there, which is the same in
/// every scene. The number of a class that the table lacks is computed from its name alone, so that it too is
/// the same everywhere; if two names collide, the later one has no number.
#[derive(Debug)]
pub(crate) struct Classes {
    known: Vec<Named>,
    others: BTreeMap<u16, Named>,
    numbers: HashMap<Arc<str>, u16>,
}

/// A class and its category.
type Named = (Arc<str>, Arc<str>);

impl Classes {
    pub(crate) fn new(graph: &SceneGraph) -> Result<Self, RenderError> {
        let named = |c: &Class| (c.name.clone(), c.category.as_str().into());
        let known: Vec<Named> = graph.classes().iter().map(named).collect();
        if known.len() > usize::from(UNKNOWN) {
            return Err(RenderError::TooManyClasses { classes: known.len() });
        }
        let numbers: HashMap<Arc<str>, u16> = known.iter().map(|(name, _)| name.clone()).zip(0..).collect();
        let unknown = graph.nodes().filter(|n| !numbers.contains_key(n.class()));
        let unknown: BTreeSet<Named> = unknown.map(|n| (n.class().clone(), n.spec().category.clone())).collect();
        let classes = known.len() + unknown.len();
        if classes > usize::from(NO_LABEL) {
            return Err(RenderError::TooManyClasses { classes });
        }
        let mut classes = Self { known, others: BTreeMap::new(), numbers };
        unknown.into_iter().for_each(|named| classes.add(named));
        Ok(classes)
    }

    /// These and those of another scene with the same class table; none if the tables differ.
    pub(super) fn with(&self, other: &Self) -> Option<Self> {
        let (known, mut others, mut numbers) = (self.known.clone(), self.others.clone(), self.numbers.clone());
        let is_alike = |(number, named): (&u16, &Named)| others.get(number).is_none_or(|own| own.0 == named.0);
        if self.known != other.known || !other.others.iter().all(is_alike) {
            return None;
        }
        for (number, named) in &other.others {
            numbers.entry(named.0.clone()).or_insert(*number);
            others.entry(*number).or_insert_with(|| named.clone());
        }
        Some(Self { known, others, numbers })
    }

    fn add(&mut self, named: Named) {
        let number = by_name(&named.0);
        // If a class occurs in two categories, the first one counts.
        if let Entry::Vacant(free) = self.others.entry(number) {
            self.numbers.insert(named.0.clone(), number);
            free.insert(named);
        }
    }

    /// The number of a class of the scene; [`NO_LABEL`] for a class without one.
    pub(crate) fn number(&self, class: &Arc<str>) -> u16 {
        self.numbers.get(class).copied().unwrap_or(NO_LABEL)
    }

    /// The class and its category for a number.
    pub(crate) fn named(&self, number: u16) -> Option<&Named> {
        self.known.get(usize::from(number)).or_else(|| self.others.get(&number))
    }
}

fn by_name(class: &str) -> u16 {
    UNKNOWN + (Seed(0).child(class).0 % u64::from(NO_LABEL - UNKNOWN)) as u16
}

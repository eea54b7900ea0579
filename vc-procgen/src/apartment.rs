//! Whole apartments: floor plan, furniture and clutter, checked.

use vc_graph::Seed;

use crate::check::Violation;
use crate::error::SpecificationError;
use crate::furnish::{self, Item, Rest};
use crate::layout::{Layout, attempts, remove, sub_seed};
use crate::plan::FloorPlan;
use crate::{Specification, Style, clutter, structure};

/// An apartment: its rooms and all items in them.
#[derive(Debug, Clone, PartialEq)]
pub struct Apartment {
    /// The seed that it was generated from.
    pub seed: Seed,
    /// The floor plan: rooms, doors and windows.
    pub plan: FloorPlan,
    /// Its materials.
    pub style: Style,
    /// All items: the building first, then furniture, then clutter. A support or container precedes
    /// the items on or in it.
    pub items: Vec<Item>,
}

impl Apartment {
    /// Generates an apartment from a seed alone: from a studio to four bedrooms and more, in the
    /// usual mix.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(42))?;
    /// assert!(home.check().is_empty());
    /// assert_eq!(home, Apartment::from_seed(Seed(42))?);
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::generate`]; no seed is known that fails.
    pub fn from_seed(seed: Seed) -> Result<Self, SpecificationError> {
        Self::generate(&Specification::default(), seed)
    }

    /// Generates an apartment for a specification. Costs some milliseconds.
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, SpecificationError> {
        specification.check()?;
        attempts(|attempt| Self::attempt(specification, seed, attempt))
    }

    fn attempt(specification: &Specification, seed: Seed, attempt: u64) -> Result<Self, SpecificationError> {
        let own = sub_seed(seed, attempt);
        let (Layout { plan, style, mut furniture }, drafts) = Layout::attempt(specification, seed, attempt)?;
        furnish::make(&mut furniture, &drafts, &style);
        let mut items = structure::build(&plan, &style, own.child("structure"));
        append(&mut items, furniture);
        let mut home = Self { seed, plan, style, items };
        clutter::fill(&mut home, specification.clutter.unwrap_or(0.6), own);
        match home.repair() {
            None => Ok(home),
            Some(violation) => {
                Err(SpecificationError::Unsound { attempts: attempt as usize + 1, last: violation.to_string() })
            }
        }
    }

    /// Removes optional items that violate a rule; returns a violation that remains. Removing items
    /// that nothing else needs causes no further violation.
    fn repair(&mut self) -> Option<Violation> {
        let violations = self.check();
        let (spared, wrong): (Vec<_>, Vec<_>) = violations.into_iter().map(|v| (self.spared(&v), v)).unzip();
        let mut out = Vec::with_capacity(spared.len());
        for (item, violation) in spared.into_iter().zip(wrong) {
            let Some(item) = item else { return Some(violation) };
            out.push(item);
        }
        out.sort_unstable();
        out.dedup();
        remove(&mut self.items, &out);
        None
    }

    /// The item whose removal resolves a violation, if it may be removed.
    fn spared(&self, violation: &Violation) -> Option<usize> {
        let may_go = |item: usize| !self.items[item].required && self.items[item].rest != Rest::Built;
        let of = |items: &[usize]| items.iter().copied().filter(|&i| may_go(i)).max();
        match violation {
            Violation::Overlap(a, b) | Violation::Jammed(a, b) => of(&[a.item, b.item]),
            Violation::Outside(a, _)
            | Violation::Unsupported(a, _)
            | Violation::Unreachable(a)
            | Violation::BlockedDoor(_, a) => of(&[a.item]),
            _ => None,
        }
    }
}

/// Appends items whose references are relative to their own list.
fn append(items: &mut Vec<Item>, more: Vec<Item>) {
    let base = items.len();
    items.extend(more.into_iter().map(|mut item| {
        match &mut item.rest {
            Rest::On(at, _) | Rest::Inside(at, _) => *at += base,
            _ => {}
        }
        item
    }));
}

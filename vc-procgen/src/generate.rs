//! Generation of whole apartments: floor plan, furniture and clutter, repaired or rejected.

use vc_graph::Seed;
use vc_shapes::Generators;

use crate::apartment::Apartment;
use crate::error::SpecificationError;
use crate::item::{Item, Support};
use crate::layout::{Layout, attempts, remove, sub_seed};
use crate::specification::Specification;
use crate::violation::ApartmentViolation;
use crate::{clutter, furnish, structure};

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
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::plan::RoomKind;
    /// use vc_procgen::{Apartment, Specification};
    /// let wishes = Specification { bedrooms: Some(1), wc: Some(true), ..Specification::default() };
    /// let home = Apartment::generate(&wishes, Seed(3))?;
    /// assert!(home.plan.rooms.iter().any(|room| room.kind == RoomKind::Wc));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, SpecificationError> {
        Self::generate_by(specification, &Generators::BUILTIN, seed)
    }

    /// As [`generate`](Self::generate), with the generators of a program's own classes beside the built-in ones. The
    /// row of an own class says where its things are:
    ///
    /// - Things that can be grasped lie, by chance, on and in the furniture where they are kept
    ///   (`kitchen/on/kitchen_counter:3`).
    /// - A piece of furniture stands at a wall of each room in which it is kept (`hallway:1`), if there is space for it.
    ///
    /// [`scene_with_classes`](Self::scene_with_classes) makes the scene, with the same class table.
    ///
    /// ```
    /// use vc_graph::{ClassTable, Seed};
    /// use vc_procgen::{Apartment, Specification};
    /// use vc_shapes::material::OAK;
    /// use vc_shapes::{Build, Generator, Generators, Realm};
    ///
    /// fn plinth(b: &mut Build<'_>) {
    ///     let (x, y) = (b.size.x / 2.0, b.size.y / 2.0);
    ///     b.block("block", [-x, -y, 0.0], [x, y, b.size.z], OAK);
    /// }
    ///
    /// let row = "plinth | decoration | | furniture | surface | 0.25 0.25 0.8-1.0 | 9 | | | living_room:1";
    /// let classes = ClassTable::builtin().extended("mine.txt", row)?;
    /// let mut generators = Generators::default();
    /// generators.register(&classes, Generator::new("plinth", Realm::Indoor, 1, plinth))?;
    /// let home = Apartment::generate_by(&Specification::default(), &generators, Seed(42))?;
    /// let scene = home.scene_with_classes(classes.into());
    /// assert_eq!(scene.of_class("plinth").len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate_by(
        specification: &Specification,
        generators: &Generators,
        seed: Seed,
    ) -> Result<Self, SpecificationError> {
        specification.check()?;
        attempts(|attempt| Self::attempt(specification, generators, seed, attempt))
    }

    fn attempt(
        specification: &Specification,
        generators: &Generators,
        seed: Seed,
        attempt: u64,
    ) -> Result<Self, SpecificationError> {
        let own = sub_seed(seed, attempt);
        let (Layout { plan, style, mut furniture }, drafts) =
            Layout::attempt(specification, generators, seed, attempt)?;
        furnish::make(&mut furniture, &drafts, &style);
        let mut items = structure::build(&plan, &style, specification.facade, own.child("structure"));
        append(&mut items, furniture);
        let mut home = Self { seed, plan, style, items };
        let household = specification.household(&home.plan, &home.style, seed);
        clutter::fill(&mut home, generators, household.as_ref(), specification.clutter.unwrap_or(0.6), own);
        match home.repair() {
            None => Ok(home),
            Some(violation) => Err(SpecificationError::Unsound { attempts: attempt as usize + 1, last: violation }),
        }
    }

    /// Removes optional items that violate a rule; returns a violation that remains. Removing items
    /// that nothing else needs causes no further violation.
    fn repair(&mut self) -> Option<ApartmentViolation> {
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
    fn spared(&self, violation: &ApartmentViolation) -> Option<usize> {
        let may_go = |item: usize| !self.items[item].required && self.items[item].support != Support::Built;
        let of = |items: &[usize]| items.iter().copied().filter(|&i| may_go(i)).max();
        match violation {
            ApartmentViolation::Overlap(a, b) | ApartmentViolation::Jammed(a, b) => of(&[a.item, b.item]),
            ApartmentViolation::Outside(a, _)
            | ApartmentViolation::Unsupported(a, _)
            | ApartmentViolation::Unreachable(a)
            | ApartmentViolation::BlockedDoor(_, a) => of(&[a.item]),
            _ => None,
        }
    }
}

/// Appends items whose references are relative to their own list.
fn append(items: &mut Vec<Item>, more: Vec<Item>) {
    let base = items.len();
    items.extend(more.into_iter().map(|mut item| {
        match &mut item.support {
            Support::On(at, _) | Support::Inside(at, _) => *at += base,
            _ => {}
        }
        item
    }));
}

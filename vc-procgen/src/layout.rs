//! A furnished floor plan before any object is generated: rooms, and furniture as boxes.

use vc_graph::Seed;
use vc_shapes::{Generators, Style};

use crate::check;
use crate::draft::Draft;
use crate::error::SpecificationError;
use crate::furnish;
use crate::item::{Item, Support};
use crate::plan::{FloorPlan, Programme, RoomKind};
use crate::reach::Reach;
use crate::specification::Specification;

/// The number of plans drawn before a specification is given up.
pub(crate) const ATTEMPTS: u64 = 24;

/// The number of plans drawn for one programme before another is drawn.
const REDRAW: u64 = 8;

/// The number of pieces that are removed at most to make everything reachable.
const CLEARED: usize = 24;

/// The rooms and the placement of the furniture, each piece as its box: enough for statistics, for
/// navigation and for drawing plans, at a fraction of the cost of a home with all its objects.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Layout, Specification};
/// let layout = Layout::generate(&Specification::default(), Seed(42))?;
/// let beds = layout.furniture.iter().filter(|i| i.object.class.ends_with("bed"));
/// assert!(beds.count() > 0);
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Rooms, doors and windows.
    pub plan: FloorPlan,
    /// The style.
    pub style: Style,
    /// Furniture and fixtures. Their objects have bounds and a class, but no parts.
    pub furniture: Vec<Item>,
}

impl Layout {
    /// Generates the first layout for a specification in which all rooms have their required
    /// furniture and every room and piece is reachable for a person. An [`crate::Apartment`] of the
    /// same seed has this layout or, for one seed in a hundred, a later one because its own check
    /// finds a violation.
    ///
    /// Costs about a millisecond.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::{Layout, Specification};
    /// let layout = Layout::generate(&Specification::studio(), Seed(9))?;
    /// assert!(layout.furniture.iter().any(|item| item.object.class == "fridge"));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, SpecificationError> {
        Self::generate_by(specification, &Generators::BUILTIN, seed)
    }

    /// As [`generate`](Self::generate), with the generators of a program's own classes beside the built-in ones.
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate_by(
        specification: &Specification,
        generators: &Generators,
        seed: Seed,
    ) -> Result<Self, SpecificationError> {
        specification.check()?;
        attempts(|attempt| Self::attempt(specification, generators, seed, attempt)).map(|(layout, _)| layout)
    }

    /// One attempt, with the drafts of the furniture.
    pub(crate) fn attempt(
        specification: &Specification,
        generators: &Generators,
        seed: Seed,
        attempt: u64,
    ) -> Result<(Self, Vec<Draft>), SpecificationError> {
        let style = specification.style.unwrap_or_else(|| Style::from_seed(seed));
        let own = sub_seed(seed, attempt);
        let plan = match &specification.plan {
            Some(plan) => plan.clone(),
            None => Self::drawn(specification, seed, attempt)?,
        };
        let household = specification.household(&plan, &style, seed);
        let (mut furniture, mut drafts) =
            furnish::furnish(&plan, (&style, generators), (household.as_ref(), specification.fitted_kitchens), own)?;
        clear_ways(&plan, &mut furniture, &mut drafts)?;
        Ok((Self { plan, style, furniture }, drafts))
    }

    /// The floor plan of an attempt.
    fn drawn(specification: &Specification, seed: Seed, attempt: u64) -> Result<FloorPlan, SpecificationError> {
        // Programmes that are hard to furnish are not given up at once, otherwise homes would have
        // fewer such rooms than were drawn.
        let programme = Programme::draw(specification, seed.nth(attempt / REDRAW))?;
        let plan = FloorPlan::lay_out(&programme, sub_seed(seed, attempt))?;
        // A facade may have no space for a balcony that was specified.
        let balconies = plan.rooms.iter().filter(|r| r.kind == RoomKind::Balcony).count();
        if specification.balconies.is_some_and(|wished| balconies < wished) {
            return Err(SpecificationError::NoPlan { rooms: programme.wishes.len(), area: programme.area() });
        }
        Ok(plan)
    }
}

/// The seed of an attempt.
pub(crate) fn sub_seed(seed: Seed, attempt: u64) -> Seed {
    seed.child("apartment").nth(attempt)
}

/// The first attempt that succeeds. Contradictory requirements end it at once because every attempt
/// would fail.
pub(crate) fn attempts<T>(mut make: impl FnMut(u64) -> Result<T, SpecificationError>) -> Result<T, SpecificationError> {
    let mut attempt = 0;
    loop {
        let made = make(attempt);
        match &made {
            Err(
                SpecificationError::OutOfRange { .. }
                | SpecificationError::BadPlan(_)
                | SpecificationError::Planned { .. }
                | SpecificationError::TooSmall { .. }
                | SpecificationError::TooLarge { .. },
            ) => return made,
            Err(_) if attempt + 1 < ATTEMPTS => attempt += 1,
            _ => return made,
        }
    }
}

/// Removes optional pieces until every room and every required piece is reachable.
fn clear_ways(plan: &FloorPlan, items: &mut Vec<Item>, drafts: &mut Vec<Draft>) -> Result<(), SpecificationError> {
    for _ in 0..CLEARED {
        let reach = Reach::new(plan, items);
        let shut = (0..plan.rooms.len()).find(|&r| !reach.enters(plan, r));
        let far: Vec<usize> = (0..items.len())
            .filter(|&i| check::is_used(&items[i]) && !reach.touches(items[i].room, &items[i].area()))
            .collect();
        let spared = far.iter().copied().find(|&i| !items[i].required);
        let room = shut.or_else(|| far.first().map(|&i| items[i].room));
        let Some(room) = room else { return Ok(()) };
        // The last optional piece placed on the floor of that room.
        let last = items
            .iter()
            .rposition(|i| i.room == room && !i.required && i.support == Support::Floor && i.corners().1.z > 0.1);
        let Some(out) = last.or(spared) else {
            let kind = plan.rooms[room].kind;
            return Err(SpecificationError::NoPlace { kind, room, piece: "way to walk" });
        };
        let mut gone = remove(items, &[out]).into_iter();
        drafts.retain(|_| !gone.next().unwrap_or(false));
    }
    Ok(())
}

/// Removes items and everything that rests on them; `out` is sorted. Returns for each item whether
/// it was removed.
pub(crate) fn remove(items: &mut Vec<Item>, out: &[usize]) -> Vec<bool> {
    let mut gone = vec![false; items.len()];
    let mut place = Vec::with_capacity(items.len());
    let mut kept = 0;
    for (index, item) in items.iter().enumerate() {
        let under = match item.support {
            Support::On(at, _) | Support::Inside(at, _) => gone[at],
            _ => false,
        };
        gone[index] = under || out.binary_search(&index).is_ok();
        place.push(kept);
        kept += usize::from(!gone[index]);
    }
    let mut index = 0;
    items.retain_mut(|item| {
        let keep = !gone[index];
        index += 1;
        if let Support::On(at, _) | Support::Inside(at, _) = &mut item.support {
            *at = place[*at];
        }
        keep
    });
    gone
}

//! A furnished plan before anything is made: rooms, and furniture as boxes.

use vc_graph::Seed;

use crate::check;
use crate::error::Impossible;
use crate::furnish::{self, Item, Rest};
use crate::object::Draft;
use crate::plan::{Plan, Programme, RoomKind};
use crate::reach::Reach;
use crate::{Specification, Style};

/// How many plans are drawn before a specification is given up.
pub(crate) const ATTEMPTS: u64 = 24;

/// Plans drawn for one programme before another is drawn.
const REDRAW: u64 = 8;

/// Pieces taken out at most until all is reached.
const CLEARED: usize = 24;

/// Where rooms are and where furniture stands, each piece as its box: enough for
/// statistics, for navigation and to look at plans, at a fraction of what a home with
/// all its objects costs.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::{Layout, Specification};
/// let layout = Layout::generate(&Specification::default(), Seed(42))?;
/// let beds = layout.furniture.iter().filter(|i| i.object.class.ends_with("bed"));
/// assert!(beds.count() > 0);
/// # Ok::<(), vc_procgen::Impossible>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Rooms, doors and windows.
    pub plan: Plan,
    /// Its materials.
    pub style: Style,
    /// Furniture and fixtures. Objects have bounds and a class, but no parts.
    pub furniture: Vec<Item>,
}

impl Layout {
    /// The first layout after wishes in which all rooms hold what they need and a
    /// person gets to every room and piece. An [`crate::Apartment`] of the same seed
    /// has this one, or a later one where its own check finds something wrong: with
    /// one seed in a hundred.
    ///
    /// Costs about a millisecond.
    ///
    /// # Errors
    /// [`Impossible`] says which wish cannot be met.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, Impossible> {
        specification.check()?;
        attempts(|attempt| Self::attempt(specification, seed, attempt)).map(|(layout, _)| layout)
    }

    /// One attempt, with what the furniture is to be.
    pub(crate) fn attempt(
        specification: &Specification,
        seed: Seed,
        attempt: u64,
    ) -> Result<(Self, Vec<Draft>), Impossible> {
        let style = specification.style.unwrap_or_else(|| Style::from_seed(seed));
        let own = sub_seed(seed, attempt);
        // Rooms that are hard to furnish are not given up at once: else homes would
        // have fewer of them than were drawn.
        let programme = Programme::draw(specification, seed.nth(attempt / REDRAW))?;
        let plan = Plan::lay_out(&programme, own)?;
        // A facade may have no room for a balcony that was wished for.
        let balconies = plan.rooms.iter().filter(|r| r.kind == RoomKind::Balcony).count();
        if specification.balconies.is_some_and(|wished| balconies < wished) {
            return Err(Impossible::NoPlan { rooms: programme.wishes.len(), area: programme.area() });
        }
        let (mut furniture, mut drafts) = furnish::furnish(&plan, &style, own)?;
        clear_ways(&plan, &mut furniture, &mut drafts)?;
        Ok((Self { plan, style, furniture }, drafts))
    }
}

/// What an attempt draws from.
pub(crate) fn sub_seed(seed: Seed, attempt: u64) -> Seed {
    seed.child("apartment").nth(attempt)
}

/// The first attempt that succeeds. Wishes that contradict each other end it at once:
/// they do so every time.
pub(crate) fn attempts<T>(mut make: impl FnMut(u64) -> Result<T, Impossible>) -> Result<T, Impossible> {
    let mut last = Impossible::Unsound { attempts: ATTEMPTS as usize, last: String::new() };
    for attempt in 0..ATTEMPTS {
        match make(attempt) {
            Err(
                error @ (Impossible::OutOfRange { .. } | Impossible::TooSmall { .. } | Impossible::TooLarge { .. }),
            ) => return Err(error),
            Err(error) => last = error,
            made => return made,
        }
    }
    Err(last)
}

/// Takes out pieces that can be spared until every room and every required piece can
/// be reached.
fn clear_ways(plan: &Plan, items: &mut Vec<Item>, drafts: &mut Vec<Draft>) -> Result<(), Impossible> {
    for _ in 0..CLEARED {
        let reach = Reach::of(plan, items);
        let shut = (0..plan.rooms.len()).find(|&r| !reach.enters(plan, r));
        let far: Vec<usize> = (0..items.len())
            .filter(|&i| check::is_used(&items[i]) && !reach.touches(items[i].room, &items[i].area()))
            .collect();
        let spared = far.iter().copied().find(|&i| !items[i].required);
        let room = shut.or_else(|| far.first().map(|&i| items[i].room));
        let Some(room) = room else { return Ok(()) };
        // The last piece put on the floor of that room that may go.
        let last =
            items.iter().rposition(|i| i.room == room && !i.required && i.rest == Rest::Floor && i.corners().1.z > 0.1);
        let Some(out) = last.or(spared) else {
            let kind = plan.rooms[room].kind;
            return Err(Impossible::NoPlace { kind, room, piece: "way to walk" });
        };
        let mut gone = remove(items, &[out]).into_iter();
        drafts.retain(|_| !gone.next().unwrap_or(false));
    }
    Ok(())
}

/// Removes items and what rests on them; `out` is sorted. Returns which are gone.
pub(crate) fn remove(items: &mut Vec<Item>, out: &[usize]) -> Vec<bool> {
    let mut gone = vec![false; items.len()];
    let mut place = Vec::with_capacity(items.len());
    let mut kept = 0;
    for (index, item) in items.iter().enumerate() {
        let under = match item.rest {
            Rest::On(at, _) | Rest::Inside(at, _) => gone[at],
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
        if let Rest::On(at, _) | Rest::Inside(at, _) = &mut item.rest {
            *at = place[*at];
        }
        keep
    });
    gone
}

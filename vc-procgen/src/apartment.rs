//! Whole apartments: plan, furniture, small things, checked.

use vc_graph::Seed;

use crate::check::{self, Violation};
use crate::error::Impossible;
use crate::furnish::{self, Item, Rest};
use crate::plan::{Plan, Programme, RoomKind};
use crate::reach::Reach;
use crate::{Specification, Style, clutter, structure};

/// How many plans are drawn before a specification is given up.
const ATTEMPTS: u64 = 24;

/// Plans drawn for one programme before another is drawn.
const REDRAW: u64 = 8;

/// An apartment: rooms, and everything in them.
#[derive(Debug, Clone, PartialEq)]
pub struct Apartment {
    /// The seed it was made from.
    pub seed: Seed,
    /// Rooms, doors and windows.
    pub plan: Plan,
    /// Its materials.
    pub style: Style,
    /// Everything in it: the building first, then furniture, then small things. What
    /// carries something comes before it.
    pub items: Vec<Item>,
}

impl Apartment {
    /// An apartment from a seed alone: studio to four bedrooms and more, in the usual
    /// mix.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(42))?;
    /// assert!(home.check().is_empty());
    /// assert_eq!(home, Apartment::from_seed(Seed(42))?);
    /// # Ok::<(), vc_procgen::Impossible>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::generate`]; no seed is known that fails.
    pub fn from_seed(seed: Seed) -> Result<Self, Impossible> {
        Self::generate(&Specification::default(), seed)
    }

    /// An apartment after wishes. Costs some milliseconds.
    ///
    /// # Errors
    /// [`Impossible`] says which wish cannot be met.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, Impossible> {
        specification.check()?;
        let style = specification.style.unwrap_or_else(|| Style::from_seed(seed));
        let mut last = None;
        for attempt in 0..ATTEMPTS {
            match Self::attempt(specification, style, seed, attempt) {
                Ok(home) => return Ok(home),
                // Wishes that contradict each other do so every time.
                Err(
                    error @ (Impossible::OutOfRange { .. } | Impossible::TooSmall { .. } | Impossible::TooLarge { .. }),
                ) => {
                    return Err(error);
                }
                Err(error) => last = Some(error),
            }
        }
        Err(last.unwrap_or(Impossible::Unsound { attempts: ATTEMPTS as usize, last: String::new() }))
    }

    fn attempt(specification: &Specification, style: Style, seed: Seed, attempt: u64) -> Result<Self, Impossible> {
        let own = seed.child("apartment").nth(attempt);
        // Rooms that are hard to furnish are not given up at once: else homes would
        // have fewer of them than were drawn.
        let programme = Programme::draw(specification, seed.nth(attempt / REDRAW))?;
        let plan = Plan::lay_out(&programme, own)?;
        // A facade may have no room for a balcony that was wished for.
        let balconies = plan.rooms.iter().filter(|r| r.kind == RoomKind::Balcony).count();
        if specification.balconies.is_some_and(|wished| balconies < wished) {
            return Err(Impossible::NoPlan { rooms: programme.wishes.len(), area: programme.area() });
        }
        let mut furniture = furnish::furnish(&plan, &style, own)?;
        clear_ways(&plan, &mut furniture)?;
        let mut items = structure::build(&plan, &style, own.child("structure"));
        append(&mut items, furniture);
        let mut home = Self { seed, plan, style, items };
        clutter::fill(&mut home, specification.clutter.unwrap_or(0.6), own);
        match home.repair() {
            None => Ok(home),
            Some(violation) => Err(Impossible::Unsound { attempts: attempt as usize + 1, last: violation.to_string() }),
        }
    }

    /// Takes out what can be spared and is in the way of something; returns what is
    /// wrong all the same. To take out what nothing needs makes nothing else wrong.
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

    /// The item whose removal ends a violation, if it may go.
    fn spared(&self, violation: &Violation) -> Option<usize> {
        let may_go = |item: usize| !self.items[item].required && self.items[item].rest != Rest::Built;
        let of = |items: &[usize]| items.iter().copied().filter(|&i| may_go(i)).max();
        match violation {
            Violation::Overlap(a, b) => of(&[a.item, b.item]),
            Violation::Outside(a, _)
            | Violation::Unsupported(a, _)
            | Violation::Unreachable(a)
            | Violation::BlockedDoor(_, a) => of(&[a.item]),
            _ => None,
        }
    }
}

/// Appends items whose references count from their own list's start.
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

/// Removes items and what rests on them; `out` is sorted.
pub(crate) fn remove(items: &mut Vec<Item>, out: &[usize]) {
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
}

/// Takes out pieces that can be spared until every room and every required piece can
/// be reached.
fn clear_ways(plan: &Plan, items: &mut Vec<Item>) -> Result<(), Impossible> {
    for _ in 0..24 {
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
        remove(items, &[out]);
    }
    Ok(())
}

//! The references between items, rooms and openings, which an edit can break, and the measures of the plan.

use crate::apartment::Apartment;
use crate::item::Support;
use crate::plan::FloorPlan;
use crate::violation::ApartmentViolation;

/// The greatest distance of a plan's lines from its origin and the greatest thickness of its outer walls, cells
/// (200 m): no sum of two overflows, and a grid over the plan fits into memory.
const FARTHEST: i32 = 4000;

impl Apartment {
    /// The references that lead nowhere. All other rules rely on them.
    pub(super) fn broken_references(&self) -> Vec<ApartmentViolation> {
        let mut found = self.plan.broken_references();
        for (index, item) in self.items.iter().enumerate() {
            let unknown = std::iter::once(item.room).chain(item.between).filter(|&room| !self.plan.has(room));
            found.extend(unknown.map(|room| ApartmentViolation::UnknownRoom(self.named(index), room)));
            found.extend(self.broken_support(index));
        }
        found
    }

    /// A support that does not precede its item, and so may be the item itself or rest on it, or that lacks the
    /// surface.
    fn broken_support(&self, index: usize) -> Option<ApartmentViolation> {
        let (Support::On(at, surface) | Support::Inside(at, surface)) = self.items[index].support else { return None };
        if at >= index {
            return Some(ApartmentViolation::UnknownSupport(self.named(index), at));
        }
        let known = surface < self.items[at].object.asset.surfaces.len();
        (!known).then(|| ApartmentViolation::UnknownSurface(self.named(index), self.named(at), surface))
    }
}

impl FloorPlan {
    fn broken_references(&self) -> Vec<ApartmentViolation> {
        let sides = self.openings.iter().enumerate().flat_map(|(i, o)| [o.low, o.high].map(|side| (i, side)));
        let sides = sides.filter_map(|(i, side)| side.filter(|&room| !self.has(room)).map(|room| (i, room)));
        let mut found: Vec<_> = sides.map(|(i, room)| ApartmentViolation::OpensNowhere(i, room)).collect();
        found.extend((!self.is_within_reach()).then_some(ApartmentViolation::TooFar));
        found
    }

    /// Whether it has a room of this index.
    fn has(&self, room: usize) -> bool {
        room < self.rooms.len()
    }

    /// Whether all its lines are near enough to its origin to be added up.
    fn is_within_reach(&self) -> bool {
        let rects = self.rooms.iter().flat_map(|room| &room.rects).flat_map(|r| [r.x0, r.y0, r.x1, r.y1]);
        let mut lines = rects.chain(self.openings.iter().flat_map(|o| [o.at, o.from, o.to])).chain([self.shell]);
        lines.all(|line| (-FARTHEST..=FARTHEST).contains(&line))
    }
}

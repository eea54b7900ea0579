//! Where a person can stand: a disc of 25 cm slides over the floor, from the front
//! door on.

use crate::apartment::Apartment;
use crate::bits::Bits;
use crate::furnish::{Area, Item, Rest};
use crate::plan::{CELLS, OpeningKind, Plan, Rect, RoomKind};

/// Radius of a person, cells.
const BODY: usize = 5;
/// A person's height, metres: what hangs above does not hinder.
const HEIGHT: f32 = 1.7;
/// What one steps over, metres.
const STEP: f32 = 0.03;
/// How far a person reaches from where they stand, cells.
pub(crate) const ARM: usize = 20;
/// Cells around the plan.
const MARGIN: i32 = 10;

/// Where a person can stand, and what they can reach from there.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    west: i32,
    south: i32,
    standing: Bits,
    /// For each room what is reached from within it or its doorways.
    near: Vec<Near>,
}

/// What is reached from within a room: a cut-out of the grid.
#[derive(Debug, Clone)]
struct Near {
    west: i32,
    south: i32,
    bits: Bits,
}

impl Apartment {
    /// Floor that a person of 0.25 m radius and 1.7 m height gets to from the front
    /// door, square metres: the places of their middle.
    ///
    /// Costs some tens of microseconds.
    pub fn standing_area(&self) -> f32 {
        Reach::of(&self.plan, &self.items).standing.count() as f32 / (CELLS * CELLS)
    }
}

impl Reach {
    /// Floods the floor from the front door.
    ///
    /// Costs some tens of microseconds for a home: discs are grown a word at a time.
    pub(crate) fn of(plan: &Plan, items: &[Item]) -> Self {
        let hull = plan.hull().grown(MARGIN);
        let (west, south) = (hull.x0, hull.y0);
        let mut floor = Bits::new(hull.width() as usize, hull.depth() as usize);
        let mut fill = |r: &Rect, value| floor.fill((r.x0 - west, r.x1 - west), (r.y0 - south, r.y1 - south), value);
        for room in &plan.rooms {
            room.net().iter().for_each(|r| fill(r, true));
        }
        for opening in plan.openings.iter().filter(|o| o.is_way() && o.kind != OpeningKind::Entrance) {
            fill(&doorway(plan, opening), true);
        }
        // Walls are what is no floor, and doors are opened.
        for item in items.iter().filter(|i| i.rest != Rest::Built) {
            let (low, high) = item.corners();
            if low.z < HEIGHT && high.z > STEP {
                fill(&outward(&item.area()), false);
            }
        }
        let free = floor.inverted().dilated(BODY).inverted();
        let start = plan.openings.iter().find(|o| o.kind == OpeningKind::Entrance).and_then(|o| {
            let inside = o.before(o.high.is_some(), 2 * BODY as i32 + 6);
            free.first((inside.x0 - west, inside.x1 - west), (inside.y0 - south, inside.y1 - south))
        });
        let standing = start.map_or_else(|| Bits::new(1, 1), |(x, y)| free.flood(x, y));
        let near = (0..plan.rooms.len()).map(|room| Near::of(plan, room, &standing, (west, south))).collect();
        Self { west, south, standing, near }
    }

    /// Whether a person can stand somewhere in a room.
    pub(crate) fn enters(&self, plan: &Plan, room: usize) -> bool {
        plan.rooms[room]
            .net()
            .iter()
            .any(|r| self.standing.any((r.x0 - self.west, r.x1 - self.west), (r.y0 - self.south, r.y1 - self.south)))
    }

    /// Whether a person in a room, or in one of its doorways, reaches some point of a
    /// rectangle.
    pub(crate) fn touches(&self, room: usize, area: &Area) -> bool {
        let (r, near) = (outward(area), &self.near[room]);
        near.bits.any((r.x0 - near.west, r.x1 - near.west), (r.y0 - near.south, r.y1 - near.south))
    }
}

impl Near {
    fn of(plan: &Plan, room: usize, standing: &Bits, origin: (i32, i32)) -> Self {
        let hull = plan.rooms[room].hull().grown(ARM as i32 + MARGIN);
        let (west, south) = (hull.x0, hull.y0);
        let mut bits = Bits::new(hull.width() as usize, hull.depth() as usize);
        let ways = plan.doors_of(room).map(|o| doorway(plan, o));
        for rect in plan.rooms[room].net().into_iter().chain(ways) {
            for y in rect.y0..rect.y1 {
                for x in rect.x0..rect.x1 {
                    if standing.get((x - origin.0) as usize, (y - origin.1) as usize) {
                        bits.set((x - west) as usize, (y - south) as usize);
                    }
                }
            }
        }
        Self { west, south, bits: bits.dilated(ARM) }
    }
}

/// The floor within a wall that a way leads over.
pub(crate) fn doorway(plan: &Plan, opening: &crate::plan::Opening) -> Rect {
    let outer = |room: Option<usize>| room.is_none_or(|r| plan.rooms[r].kind == RoomKind::Balcony);
    let low = if outer(opening.low) { plan.shell } else { 1 };
    let high = if outer(opening.high) { plan.shell } else { 1 };
    opening.across(opening.at - low, opening.at + high)
}

/// The cells that an area touches.
fn outward(area: &Area) -> Rect {
    let low = |v: f32| (v * CELLS + 0.02).floor() as i32;
    let high = |v: f32| (v * CELLS - 0.02).ceil() as i32;
    Rect { x0: low(area.x0), y0: low(area.y0), x1: high(area.x1), y1: high(area.y1) }
}

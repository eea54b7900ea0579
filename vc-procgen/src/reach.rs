//! Reachability: a person, as a disc of 25 cm radius, moves over the floor from the front door on.

use std::sync::LazyLock;

use vc_geometry::grid::{BitGrid, Disc, ceiling, floor};
use vc_graph::Anthropometry;

use crate::apartment::Apartment;
use crate::area::Area;
use crate::item::{Item, Support};
use crate::plan::{CELLS, FloorPlan, OpeningKind, Rect, RoomKind};

/// The person for whom homes are furnished.
const ADULT: Anthropometry = Anthropometry::ADULT;
/// The radius of a person, in cells.
pub(crate) const BODY: usize = (ADULT.clearance * CELLS + 0.5) as usize;
/// The cells that a person takes up.
pub(crate) static PERSON: LazyLock<Disc> = LazyLock::new(|| Disc::touching(BODY));
/// The cells within reach of a person.
pub(crate) static REACH: LazyLock<Disc> = LazyLock::new(|| Disc::within((ADULT.ahead * CELLS).round()));
/// The margin around the plan, in cells.
const MARGIN: i32 = 10;

/// The positions where a person can stand, for tests of what is within reach.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    west: i32,
    south: i32,
    standing: BitGrid,
    /// For each room the standing positions within it or in its doorways.
    within: Vec<BitGrid>,
}

impl Apartment {
    /// The floor area that a person of 0.25 m radius and 1.7 m height can reach from the front
    /// door, square metres: the positions of the disc's centre.
    ///
    /// Costs some tens of microseconds.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(7))?;
    /// assert!(home.standing_area() > 3.0 && home.standing_area() < home.plan.area());
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn standing_area(&self) -> f32 {
        Reach::new(&self.plan, &self.items).standing.count() as f32 / (CELLS * CELLS)
    }
}

impl Reach {
    /// Flood-fills the floor from the front door.
    ///
    /// Costs some tens of microseconds for a home: the obstacles are dilated a word at a time.
    pub(crate) fn new(plan: &FloorPlan, items: &[Item]) -> Self {
        let hull = plan.hull().grown(MARGIN);
        let (west, south) = (hull.x0, hull.y0);
        let mut floor = BitGrid::new(hull.width().max(0) as usize, hull.depth().max(0) as usize);
        let mut fill = |r: &Rect, value| {
            let (x, y) = from_corner(r, (west, south));
            floor.fill(x, y, value);
        };
        for room in &plan.rooms {
            room.net().iter().for_each(|r| fill(r, true));
        }
        for opening in plan.openings.iter().filter(|o| o.is_way() && o.kind != OpeningKind::Entrance) {
            fill(&doorway(plan, opening), true);
        }
        boards(plan).for_each(|(_, board)| fill(&board, false));
        // Cells without floor are walls, and doors count as open.
        for item in items.iter().filter(|i| i.support != Support::Built) {
            let (low, high) = item.corners();
            if is_in_the_way((low.z, high.z)) {
                fill(&outward(&item.area()), false);
            }
        }
        let free = floor.inverted().dilated(&PERSON).inverted();
        let start = plan.openings.iter().find(|o| o.kind == OpeningKind::Entrance).and_then(|o| {
            let inside = o.before(o.high.is_some(), 2 * BODY as i32 + 6);
            let (x, y) = from_corner(&inside, (west, south));
            free.first(x, y)
        });
        let standing = start.map_or_else(|| free.empty(), |(x, y)| free.flood(x, y));
        let mut within = Vec::with_capacity(plan.rooms.len());
        for (index, room) in plan.rooms.iter().enumerate() {
            let mut mask = standing.empty();
            let ways = plan.doors_of(index).map(|o| doorway(plan, o));
            for r in room.net().into_iter().chain(ways) {
                let (x, y) = from_corner(&r, (west, south));
                mask.fill(x, y, true);
            }
            within.push(mask.and(&standing));
        }
        Self { west, south, standing, within }
    }

    /// Whether a person can stand somewhere in a room.
    pub(crate) fn enters(&self, plan: &FloorPlan, room: usize) -> bool {
        plan.rooms[room].net().iter().any(|r| {
            let (x, y) = from_corner(r, (self.west, self.south));
            self.standing.any(x, y)
        })
    }

    /// Whether a person in a room, or in one of its doorways, can reach some point of a rectangle.
    pub(crate) fn touches(&self, room: usize, area: &Area) -> bool {
        let (x, y) = from_corner(&outward(area), (self.west, self.south));
        self.within[room].first_near(x, y, &REACH).is_some()
    }
}

/// The columns and rows of a rectangle in a grid whose corner is at a cell. An item may be as far away as it likes.
fn from_corner(r: &Rect, (west, south): (i32, i32)) -> ((i32, i32), (i32, i32)) {
    let (x, y) = (|v: i32| v.saturating_sub(west), |v: i32| v.saturating_sub(south));
    ((x(r.x0), x(r.x1)), (y(r.y0), y(r.y1)))
}

/// The floor within the wall in an opening.
pub(crate) fn doorway(plan: &FloorPlan, opening: &crate::plan::PlanOpening) -> Rect {
    let outer = |room: Option<usize>| plan.kind_of(room).is_none_or(|kind| kind == RoomKind::Balcony);
    let low = if outer(opening.low) { plan.shell } else { 1 };
    let high = if outer(opening.high) { plan.shell } else { 1 };
    opening.across(opening.at - low, opening.at + high)
}

/// The areas where window sills protrude into their rooms, by room.
pub(crate) fn boards(plan: &FloorPlan) -> impl Iterator<Item = (usize, Rect)> {
    const DEPTH: i32 = 2;
    let windows = plan.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.sill < ADULT.stature);
    windows.filter_map(|o| o.high.or(o.low).map(|room| (room, o.before(o.high.is_some(), DEPTH))))
}

/// Whether an object between two heights is an obstacle for a walking person.
pub(crate) fn is_in_the_way((low, high): (f32, f32)) -> bool {
    low < ADULT.stature && high > ADULT.flat
}

/// The cells that an area touches.
pub(crate) fn outward(area: &Area) -> Rect {
    let low = |v: f32| floor(v * CELLS + 0.02);
    let high = |v: f32| ceiling(v * CELLS - 0.02);
    Rect { x0: low(area.x0), y0: low(area.y0), x1: high(area.x1), y1: high(area.y1) }
}

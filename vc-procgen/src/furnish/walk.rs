//! Whether a room stays passable and its objects reachable, tested before a piece is placed.

use std::cell::RefCell;

use vc_geometry::grid::BitGrid;

use crate::area::Area;
use crate::plan::{FloorPlan, OpeningKind, Rect};
use crate::reach::{BODY, PERSON, REACH, boards, doorway, is_in_the_way, outward};

/// The depth of floor beyond a door that is assumed to be free, cells: the next room keeps it so.
const BEYOND: i32 = 7;

/// A rectangle of cells: columns and rows.
type Span = ((i32, i32), (i32, i32));

/// The floor of one room and its doorways.
#[derive(Debug, Clone)]
pub(super) struct Walk {
    west: i32,
    south: i32,
    floor: Floor,
    /// The room and its doorways, from which objects must be reachable.
    within: BitGrid,
    doorways: Vec<Rect>,
    /// The areas that must be reachable.
    wanted: Vec<Wanted>,
    /// The floor with the object asked about last: most such objects are placed next.
    asked: RefCell<Option<(Span, Floor)>>,
}

/// The walkable floor.
#[derive(Debug, Clone)]
struct Floor {
    /// The possible positions of a person's centre.
    free: BitGrid,
    /// The reachable positions, if all doorways are among them.
    standing: Option<BitGrid>,
}

/// An area to be reached, and a cell from which it was reachable at the last check.
#[derive(Debug, Clone)]
struct Wanted {
    area: Area,
    from: Option<(usize, usize)>,
}

impl Walk {
    pub(super) fn new(plan: &FloorPlan, room: usize, net: &[Rect]) -> Self {
        let hull = plan.rooms[room].hull().grown(BEYOND + plan.shell + 2);
        let blank = BitGrid::new(hull.width() as usize, hull.depth() as usize);
        let doorways: Vec<Rect> = plan.doors_of(room).map(|o| doorway(plan, o)).collect();
        let mut walk = Self {
            west: hull.x0,
            south: hull.y0,
            floor: Floor { free: blank.clone(), standing: None },
            within: blank,
            doorways,
            wanted: Vec::new(),
            asked: RefCell::default(),
        };
        let mut floor = walk.within.clone();
        for rect in net.iter().chain(&walk.doorways) {
            let (x, y) = walk.cells(rect);
            floor.fill(x, y, true);
        }
        walk.within = floor.clone();
        for opening in plan.doors_of(room) {
            let (x, y) = walk.cells(&opening.before(opening.high != Some(room), BEYOND + plan.shell));
            floor.fill(x, y, true);
        }
        for board in boards(plan).filter(|(r, _)| *r == room).map(|(_, board)| board) {
            let (x, y) = walk.cells(&board);
            floor.fill(x, y, false);
        }
        walk.floor.free = floor.inverted().dilated(&PERSON).inverted();
        let windows = plan.openings.iter().filter(|o| o.kind == OpeningKind::Window && o.touches(room));
        walk.floor.standing = walk.flooded(&walk.floor.free);
        windows.for_each(|o| walk.require(Area::from_rect(&o.across(o.at - 1, o.at + 1))));
        walk
    }

    fn cells(&self, r: &Rect) -> Span {
        ((r.x0 - self.west, r.x1 - self.west), (r.y0 - self.south, r.y1 - self.south))
    }

    /// Records an object that was placed.
    pub(super) fn put(&mut self, area: &Area, heights: (f32, f32), wanted: bool) {
        if is_in_the_way(heights) {
            let span = self.cells(&outward(area));
            let asked = self.asked.take().filter(|(asked, _)| *asked == span).map(|(_, floor)| floor);
            if let Some(floor) = asked.or_else(|| self.without(&[span])) {
                self.floor = floor;
                self.look_again();
            }
        }
        if wanted {
            self.require(core(area));
        }
    }

    fn require(&mut self, area: Area) {
        let from = self.floor.standing.as_ref().and_then(|standing| self.reached(&area, standing));
        self.wanted.push(Wanted { area, from });
    }

    /// Finds other cells to reach from, where the old ones are no longer reachable.
    fn look_again(&mut self) {
        let Some(standing) = self.floor.standing.take() else { return };
        let mut wanted = std::mem::take(&mut self.wanted);
        for w in wanted.iter_mut().filter(|w| !w.from.is_some_and(|(x, y)| standing.get(x, y))) {
            w.from = self.reached(&w.area, &standing);
        }
        (self.wanted, self.floor.standing) = (wanted, Some(standing));
    }

    /// A cell from which an area is within reach.
    fn reached(&self, area: &Area, standing: &BitGrid) -> Option<(usize, usize)> {
        let (x, y) = self.cells(&outward(area));
        standing.first_near(x, y, &REACH)
    }

    /// Whether all doorways stay connected and everything wanted stays reachable, including new
    /// objects at these places.
    ///
    /// Costs some microseconds.
    pub(super) fn stays_open(&self, things: &[Area]) -> bool {
        let taken: Vec<Span> = things.iter().map(|area| self.cells(&outward(area))).collect();
        let next = self.without(&taken);
        let Some(standing) = &next.as_ref().unwrap_or(&self.floor).standing else { return false };
        let still = |w: &Wanted| w.from.is_some_and(|(x, y)| standing.get(x, y));
        let reached = |area: &Area| self.reached(area, standing).is_some();
        let open = self.wanted.iter().all(|w| still(w) || reached(&w.area))
            && things.iter().map(core).all(|area| reached(&area));
        if let ([span], Some(floor)) = (&taken[..], next) {
            self.asked.replace(Some((*span, floor)));
        }
        open
    }

    /// The floor after rectangles are taken from it; `None` if nobody could stand there before.
    fn without(&self, taken: &[Span]) -> Option<Floor> {
        if !taken.iter().any(|&(x, y)| self.floor.free.first_near(x, y, &PERSON).is_some()) {
            return None;
        }
        let free = cleared(&self.floor.free, taken);
        let standing = self.standing_on(&free, taken);
        Some(Floor { free, standing })
    }

    /// The reachable positions on the free floor that is left after rectangles are taken from it;
    /// `None` if a doorway is cut off.
    fn standing_on(&self, free: &BitGrid, taken: &[Span]) -> Option<BitGrid> {
        let standing = self.floor.standing.as_ref()?;
        if !taken.iter().all(|&(x, y)| free.is_whole_around(x, y, BODY + 1)) {
            return self.flooded(free);
        }
        // Paths that led through the rectangles go around them.
        let left = cleared(standing, taken);
        let passed = |r: &Rect| {
            let (x, y) = self.cells(r);
            left.any(x, y)
        };
        self.doorways.iter().all(passed).then_some(left)
    }

    /// The reachable positions within the room and its doorways; `None` if a doorway is cut off.
    fn flooded(&self, free: &BitGrid) -> Option<BitGrid> {
        let Some(first) = self.doorways.first() else { return Some(self.within.and(free)) };
        let (x, y) = self.cells(first);
        let (x, y) = free.first(x, y)?;
        let standing = free.flood(x, y);
        let passed = |r: &Rect| {
            let (x, y) = self.cells(r);
            standing.any(x, y)
        };
        self.doorways.iter().all(passed).then(|| standing.and(&self.within))
    }
}

/// The positions without those at which a person's disc would overlap a rectangle.
fn cleared(places: &BitGrid, taken: &[Span]) -> BitGrid {
    let mut left = places.clone();
    taken.iter().for_each(|&(x, y)| left.clear_near(x, y, &PERSON));
    left
}

/// An area without its rim: if it is within reach, so is most of the whole area.
fn core(area: &Area) -> Area {
    const RIM: f32 = 0.25;
    let (centre, size) = (area.centre(), area.size());
    let half = |length: f32| (length / 2.0 - RIM).max(0.02);
    Area::around(centre.0, centre.1, half(size.0), half(size.1))
}

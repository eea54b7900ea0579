//! Faults of floor plans that somebody has drawn: those for which a flat cannot be furnished.

use super::boundaries::boundaries;
use super::{FloorPlan, OpeningKind, PlanOpening, Rect, RoomKind};

/// The farthest line of a plan from its origin and the thickest outer wall, cells; the largest area, square metres, and the most
/// rooms: walls and grids over the plan stay small.
const FARTHEST: i32 = 4000;
const THICKEST: i32 = 40;
const LARGEST: f32 = 2000.0;
const MOST: usize = 200;
/// The least and the greatest height of a ceiling, metres.
const CEILING: (f32, f32) = (2.2, 12.0);

/// A fault of a floor plan. Rooms and openings are named by their positions in the plan.
///
/// ```
/// use vc_procgen::plan::PlanFault;
/// assert_eq!(PlanFault::OffWall(3).to_string(), "opening 3 is not in a wall between the rooms that it names");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanFault {
    /// There are no rooms, or only balconies, or too many.
    #[error("{0} rooms within walls: a plan has from 1 to {MOST}")]
    Rooms(usize),
    /// A room has no floor between its walls.
    #[error("room {0} has no floor: give it rectangles wider than a wall of two cells")]
    NoFloor(usize),
    /// Two rooms overlap.
    #[error("rooms {0} and {1} overlap")]
    Overlap(usize, usize),
    /// A room belongs to a room that the plan does not have.
    #[error("room {0} belongs to room {1}, which the plan does not have")]
    UnknownOwner(usize, usize),
    /// An opening names a room that the plan does not have.
    #[error("opening {0} leads into room {1}, which the plan does not have")]
    UnknownRoom(usize, usize),
    /// An opening is not in a wall.
    #[error("opening {0} is not in a wall between the rooms that it names")]
    OffWall(usize),
    /// An opening begins below the floor, ends above the ceiling, or has no height.
    #[error("opening {0} reaches from {1} m to {2} m, which is not a height within the room")]
    Height(usize, f32, f32),
    /// There is no front door.
    #[error("there is no front door: an opening has to be an entrance")]
    NoEntrance,
    /// A ceiling or an outer wall has measures that no home has, or the plan is too large.
    #[error("the {0} is {1}, it must be from {2} to {3}")]
    Measure(&'static str, f32, f32, f32),
}

impl FloorPlan {
    /// The first fault for which a flat cannot be furnished by this plan; plans that are generated have none. Whether people
    /// get everywhere and pieces have room is found out when it is furnished.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::{FloorPlan, PlanFault};
    /// let mut plan = FloorPlan::generate(&Specification::studio(), Seed(2))?;
    /// assert_eq!(plan.fault(), None);
    /// plan.openings.clear();
    /// assert_eq!(plan.fault(), Some(PlanFault::NoEntrance));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn fault(&self) -> Option<PlanFault> {
        self.measures().or_else(|| self.broken_room()).or_else(|| {
            let entrance = self.openings.iter().any(|opening| opening.kind == OpeningKind::Entrance);
            self.broken_opening().or_else(|| (!entrance).then_some(PlanFault::NoEntrance))
        })
    }

    fn measures(&self) -> Option<PlanFault> {
        let within = |what, value: f32, low: f32, high: f32| {
            let fits = value >= low && value <= high;
            (!fits).then_some(PlanFault::Measure(what, value, low, high))
        };
        let count = self.rooms.iter().filter(|room| room.kind != RoomKind::Balcony).count();
        if !(1..=MOST).contains(&count) || self.rooms.len() > MOST {
            return Some(PlanFault::Rooms(count));
        }
        let lines = self.rooms.iter().flat_map(|room| &room.rects).flat_map(|r| [r.x0, r.y0, r.x1, r.y1]);
        let lines = lines.chain(self.openings.iter().flat_map(|opening| [opening.at, opening.from, opening.to]));
        let farthest = lines.map(i32::unsigned_abs).max().unwrap_or(0);
        within("farthest line in cells", farthest as f32, 0.0, FARTHEST as f32)
            .or_else(|| within("shell in cells", self.shell as f32, 1.0, THICKEST as f32))
            .or_else(|| within("ceiling in metres", self.ceiling, CEILING.0, CEILING.1))
            .or_else(|| within("area in square metres", self.hull().area(), 0.0, LARGEST))
    }

    fn broken_room(&self) -> Option<PlanFault> {
        let rects = |room: usize| self.rooms[room].rects.iter().filter(|rect| !rect.is_empty());
        for (index, room) in self.rooms.iter().enumerate() {
            let small = |rect: &Rect| rect.short() <= 2;
            if room.rects.is_empty() || room.rects.iter().all(small) || room.rects.iter().any(Rect::is_empty) {
                return Some(PlanFault::NoFloor(index));
            }
            if let Some(owner) = room.of.filter(|owner| *owner >= self.rooms.len()) {
                return Some(PlanFault::UnknownOwner(index, owner));
            }
            let meets = |other: &usize| rects(index).any(|one| rects(*other).any(|two| one.overlaps(two)));
            if let Some(other) = (0..index).find(meets) {
                return Some(PlanFault::Overlap(other, index));
            }
        }
        None
    }

    fn broken_opening(&self) -> Option<PlanFault> {
        let edges = boundaries(&self.rooms);
        let in_wall = |opening: &PlanOpening| {
            edges.iter().any(|edge| {
                let along = (edge.vertical, edge.at) == (opening.vertical, opening.at);
                let sides = [(edge.low, opening.low), (edge.high, opening.high)];
                // A balcony stands before the outer wall.
                let outside =
                    |(edge, own): &(Option<usize>, Option<usize>)| edge == own || opening.is_to_balcony(*edge);
                along && edge.from <= opening.from && opening.to <= edge.to && sides.iter().all(outside)
            })
        };
        for (index, opening) in self.openings.iter().enumerate() {
            let mut sides = [opening.low, opening.high].into_iter().flatten();
            if let Some(room) = sides.find(|room| *room >= self.rooms.len()) {
                return Some(PlanFault::UnknownRoom(index, room));
            }
            if opening.from >= opening.to || !in_wall(opening) {
                return Some(PlanFault::OffWall(index));
            }
            let fits = opening.sill >= 0.0 && opening.sill < opening.head && opening.head <= self.ceiling;
            if !fits {
                return Some(PlanFault::Height(index, opening.sill, opening.head));
            }
        }
        None
    }
}

impl PlanOpening {
    /// Whether it leads to a balcony before an outer wall, beyond which the rooms' borders know nobody.
    fn is_to_balcony(&self, beyond: Option<usize>) -> bool {
        self.kind == OpeningKind::BalconyDoor && beyond.is_none()
    }
}

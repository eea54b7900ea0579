//! Floor plans: rooms, walls, doors and windows.
//!
//! Plans use a grid of five centimetres. A room's *gross* rectangles extend to the centre lines of
//! its walls, so that neighbours share lines; its *net* area, which one can walk on, is half a
//! partition wall (one cell) smaller on every side.

mod anneal;
mod boundaries;
mod fault;
mod flat;
mod growth;
mod openings;
mod programme;
mod rect;
mod site;
mod spine;
mod studio;
mod topology;
mod turn;

pub use crate::room_kind::RoomKind;
pub use boundaries::Boundary;
pub(crate) use boundaries::boundaries as boundaries_of;
pub use fault::PlanFault;
pub use openings::{OpeningKind, PlanOpening};
pub(crate) use programme::Programme;
pub use rect::Rect;
pub(crate) use rect::covers;
pub use site::{Side, Site, WindowPlace};
use topology::Topology;

use serde::Serialize;
use vc_graph::{Seed, Stream};

use crate::error::SpecificationError;
use crate::specification::Specification;

/// The number of grid cells per metre.
pub const CELLS: f32 = 20.0;

/// Converts cells to metres.
///
/// ```
/// use vc_procgen::plan::metres;
/// assert_eq!(metres(30), 1.5);
/// ```
pub fn metres(cells: i32) -> f32 {
    cells as f32 / CELLS
}

/// Converts metres to the nearest number of cells.
pub(crate) fn cells(metres: f32) -> i32 {
    (metres * CELLS).round() as i32
}

/// A room of a plan.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Room {
    /// Its purpose.
    pub kind: RoomKind,
    /// Its gross rectangles, which do not overlap and are connected.
    pub rects: Vec<Rect>,
    /// The bedroom it belongs to exclusively, for an en-suite bathroom.
    pub of: Option<usize>,
}

/// Placed rooms, and the sides of the building that have windows: west, east, south, north.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Arrangement {
    rooms: Vec<Room>,
    facades: [bool; 4],
}

impl Room {
    /// A room of one rectangle.
    pub(crate) fn new(kind: RoomKind, rect: Rect) -> Self {
        Self { kind, rects: vec![rect], of: None }
    }

    /// The longest short side of any of its net rectangles, cells.
    pub(crate) fn widest(&self) -> i32 {
        self.net_rects().iter().map(Rect::short).max().unwrap_or(0)
    }

    /// Its bounding rectangle.
    pub fn hull(&self) -> Rect {
        self.rects.iter().copied().reduce(Rect::around).unwrap_or_default()
    }

    /// Its net rectangles, inside the walls. They cover the net area and may overlap where two
    /// gross rectangles meet.
    pub fn net(&self) -> Vec<Rect> {
        self.net_rects().to_vec()
    }

    /// Its net rectangles.
    fn net_rects(&self) -> rect::Rects {
        // A rectangle no wider than its walls has no net area.
        let mut net: rect::Rects = self.rects.iter().map(|r| r.grown(-1)).filter(|r| !r.is_empty()).collect();
        for (i, a) in self.rects.iter().enumerate() {
            for b in &self.rects[i + 1..] {
                // There is no wall at the seam between two rectangles.
                net.extend(a.seam(b).map(|s| s.grown(-1)).filter(|s| !s.is_empty()));
            }
        }
        net
    }

    /// Its net area in square metres.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::FloorPlan;
    /// let plan = FloorPlan::generate(&Specification::with_bedrooms(2), Seed(4))?;
    /// assert!(plan.rooms.iter().all(|room| room.area() > 1.0));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn area(&self) -> f32 {
        rect::union_area(&self.net_rects())
    }

    /// Whether a net point (in cells) is in the room.
    pub fn contains(&self, x: f32, y: f32) -> bool {
        self.net_rects().iter().any(|r| r.holds(x, y))
    }
}

/// A floor plan.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::Specification;
/// use vc_procgen::plan::{FloorPlan, OpeningKind};
/// let plan = FloorPlan::generate(&Specification::with_bedrooms(3), Seed(2))?;
/// assert_eq!(plan.rooms.iter().filter(|room| room.kind.is_bedroom()).count(), 3);
/// assert_eq!(plan.openings.iter().filter(|opening| opening.kind == OpeningKind::Entrance).count(), 1);
/// # Ok::<(), vc_procgen::SpecificationError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FloorPlan {
    /// The scheme of its layout.
    pub scheme: Scheme,
    /// The rooms; balconies come last.
    pub rooms: Vec<Room>,
    /// Doors, passages and windows.
    pub openings: Vec<PlanOpening>,
    /// The sides of the building that may have windows: west, east, south, north.
    pub facades: [bool; 4],
    /// The thickness of outer walls outside the gross line, cells.
    pub shell: i32,
    /// The height of the ceiling, metres.
    pub ceiling: f32,
}

/// The scheme of a plan's layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Scheme {
    /// One main room with a bathroom.
    Studio,
    /// Rooms with windows on one side, wet rooms along the landing.
    Bar,
    /// Rooms on both sides of a corridor.
    Corridor,
    /// Rooms around a broad hall.
    CentralHall,
    /// Kitchen and living room in one; the entrance leads into them.
    OpenPlan,
    /// Two wings.
    LPlan,
    /// Rooms grown on a coarse grid.
    Irregular,
    /// A rectangle divided by annealing, for programmes that no other scheme accommodates.
    Annealed,
}

impl FloorPlan {
    /// Generates a plan for a specification: draws a programme and lays it out.
    ///
    /// # Errors
    /// [`SpecificationError`] states the requirement that cannot be fulfilled.
    pub fn generate(specification: &Specification, seed: Seed) -> Result<Self, SpecificationError> {
        Self::lay_out(&Programme::draw(specification, seed)?, seed)
    }

    /// Generates a plan for a programme.
    ///
    /// Tries schemes with seeded rejection until one accommodates the programme, in a few to a few
    /// hundred microseconds; if none does, uses annealing, in some milliseconds.
    ///
    /// # Errors
    /// [`SpecificationError::NoPlan`] if no scheme accommodates it.
    pub(crate) fn lay_out(programme: &Programme, seed: Seed) -> Result<Self, SpecificationError> {
        let mut rng = seed.child("plan").stream();
        for scheme in programme.schemes(&mut rng) {
            if let Some(plan) = Self::attempt(programme, scheme, &mut rng) {
                return Ok(plan);
            }
        }
        Err(SpecificationError::NoPlan { rooms: programme.wishes.len(), area: programme.area() })
    }

    fn attempt(programme: &Programme, scheme: Scheme, rng: &mut Stream) -> Option<Self> {
        let layout = match scheme {
            Scheme::Studio => studio::lay_out(programme, rng),
            Scheme::Irregular => growth::lay_out(programme, rng),
            Scheme::Annealed => anneal::lay_out(programme, rng),
            _ => spine::lay_out(programme, scheme, rng),
        };
        let Arrangement { mut rooms, mut facades } = layout?;
        let area: f32 = rooms.iter().map(Room::area).sum();
        if programme.wished_area.is_some_and(|wished| (area / wished - 1.0).abs() > 0.045) {
            return None;
        }
        rect::turn(&mut rooms, &mut facades, rng.below(8));
        let shell = rng.count(4, 6) as i32;
        let ceiling = (rng.between(2.45, 2.75) * 20.0).round() / 20.0;
        let mut plan = Self { scheme, rooms, openings: Vec::new(), facades, shell, ceiling };
        openings::open(&mut plan, programme, rng)?;
        Some(plan)
    }

    /// The boundaries between rooms, and between rooms and the outside.
    pub fn boundaries(&self) -> Vec<Boundary> {
        boundaries::boundaries(&self.rooms)
    }

    /// The bounding rectangle of all rooms, balconies included.
    pub fn hull(&self) -> Rect {
        self.rooms.iter().map(Room::hull).reduce(Rect::around).unwrap_or_default()
    }

    /// The net area of all rooms but balconies, square metres.
    pub fn area(&self) -> f32 {
        self.rooms.iter().filter(|r| r.kind != RoomKind::Balcony).map(Room::area).sum()
    }

    /// The kind of the room on a side of an opening; `None` for the outside.
    pub(crate) fn kind_of(&self, side: Option<usize>) -> Option<RoomKind> {
        self.rooms.get(side?).map(|room| room.kind)
    }

    /// The doors and passages of a room.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Specification;
    /// use vc_procgen::plan::FloorPlan;
    /// let plan = FloorPlan::generate(&Specification::with_bedrooms(2), Seed(2))?;
    /// assert!((0..plan.rooms.len()).all(|room| plan.doors_of(room).count() > 0));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn doors_of(&self, room: usize) -> impl Iterator<Item = &PlanOpening> {
        self.openings.iter().filter(move |o| o.kind != OpeningKind::Window && o.touches(room))
    }
}

//! Homes beside a gallery: drawn, turned with the front door towards it, and shifted.

use vc_graph::Seed;
use vc_graph::space::RegionFrame;

use super::error::BuildingError;
use super::measures::{BRIDGE, DECK, GAP};
use crate::apartment::Apartment;
use crate::area::{Area, Facing};
use crate::plan::{FloorPlan, OpeningKind, PlanOpening, Rect, RoomKind, metres};
use crate::reach::doorway;
use crate::specification::Specification;

/// The homes that are drawn for a place before it is given up.
const DRAWN: u64 = 32;

/// A home at its place beside a gallery.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Place {
    /// The seed of the home.
    pub(super) seed: Seed,
    /// Quarter turns from the frame of the home to that of the storey.
    pub(super) turn: Facing,
    /// The origin of the home on the storey.
    pub(super) origin: (f32, f32),
    /// Its rooms with their outer walls, on the storey.
    pub(super) outline: Vec<Area>,
    /// The bridge to its front door.
    pub(super) bridge: Area,
    /// The front door.
    pub(super) door: FrontDoor,
}

/// The front door of a home.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FrontDoor {
    /// The middle of the threshold, in the frame of the home.
    pub(super) at: (f32, f32),
    /// The way out, in the frame of the home.
    pub(super) out: Facing,
    /// The middle of the outer edge of the threshold, on the storey.
    pub(super) outside: (f32, f32),
    /// Width and height, metres.
    pub(super) size: (f32, f32),
    /// The number of the door in the scene of the home, and that of the room that it leads into.
    pub(super) numbers: (u32, u32),
}

impl Place {
    /// The first home of a seed that can be entered from the gallery, in the west or in the east of it.
    pub(super) fn find(wishes: &Specification, seed: Seed, east: bool) -> Result<Self, BuildingError> {
        for drawn in 0..DRAWN {
            let seed = seed.nth(drawn);
            if let Some(place) = Self::of(&Apartment::generate(wishes, seed)?, seed, east) {
                return Ok(place);
            }
        }
        Err(BuildingError::NoHome { drawn: DRAWN })
    }

    /// The place of a home, unless something of it stands before its front door.
    fn of(home: &Apartment, seed: Seed, east: bool) -> Option<Self> {
        let plan = &home.plan;
        let (number, opening) = front_door(home)?;
        let hole = Area::from_rect(&doorway(plan, &opening));
        let out = way_out(&opening);
        // The way out of a home in the west is to the east.
        let turn = Facing(if east { 2 } else { 0 }).turned(4 - out.0);
        let middle = hole.centre();
        let half = if out.is_along_x() { hole.size().0 } else { hole.size().1 } / 2.0;
        let step = out.step();
        let edge = turn.turn((middle.0 + half * step.0, middle.1 + half * step.1));
        let rects: Vec<Area> = outline(plan).map(|area| area.turned(turn)).collect();
        let inner = if east { DECK.x1 + GAP } else { DECK.x0 - GAP };
        let near = if east { least(&rects, |a| a.x0) } else { -least(&rects, |a| -a.x1) };
        let origin = (inner - near, DECK.centre().1 - edge.1);
        let outside = (edge.0 + origin.0, edge.1 + origin.1);
        let (x0, x1) = if east { (DECK.x1, outside.0) } else { (outside.0, DECK.x0) };
        let bridge = Area { x0, x1, y0: outside.1 - BRIDGE / 2.0, y1: outside.1 + BRIDGE / 2.0 };
        let outline: Vec<Area> = rects.iter().map(|area| area.moved(origin)).collect();
        let size = (metres(opening.width()), opening.head - opening.sill);
        let numbers = (number, opening.low.or(opening.high)? as u32);
        let door = FrontDoor { at: middle, out, outside, size, numbers };
        let is_free = !outline.iter().any(|area| area.overlaps(&bridge));
        is_free.then_some(Self { seed, turn, origin, outline, bridge, door })
    }

    /// The frame of the home in that of the storey.
    pub(super) fn frame(&self) -> RegionFrame {
        let (x, y) = self.origin;
        let quarters = f64::from(self.turn.0 % 4);
        RegionFrame::new([f64::from(x), f64::from(y), 0.0], quarters * std::f64::consts::FRAC_PI_2)
    }
}

/// The number of the front door in the scene of a home, and its opening.
fn front_door(home: &Apartment) -> Option<(u32, PlanOpening)> {
    let opening = home.plan.openings.iter().find(|opening| opening.kind == OpeningKind::Entrance)?;
    let item = home.items.iter().position(|item| item.object.class == "main_door")?;
    Some((home.item_id(item).0, *opening))
}

/// The direction out of the home through its front door.
fn way_out(opening: &PlanOpening) -> Facing {
    match (opening.vertical, opening.high.is_none()) {
        (true, true) => Facing(0),
        (false, true) => Facing(1),
        (true, false) => Facing(2),
        (false, false) => Facing(3),
    }
}

/// The rooms of a plan with their outer walls; a balcony has none.
fn outline(plan: &FloorPlan) -> impl Iterator<Item = Area> {
    plan.rooms.iter().flat_map(|room| {
        let shell = if room.kind == RoomKind::Balcony { 0 } else { plan.shell };
        room.rects.iter().map(move |rect: &Rect| Area::from_rect(&rect.grown(shell)))
    })
}

fn least(areas: &[Area], of: impl Fn(&Area) -> f32) -> f32 {
    areas.iter().map(of).fold(f32::INFINITY, f32::min)
}

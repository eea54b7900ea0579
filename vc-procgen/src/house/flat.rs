//! Flats of a house: their plans, where they lie in the house, and their front doors.

use vc_graph::Seed;
use vc_graph::portable::Portable;
use vc_graph::space::RegionFrame;

use super::measures::Measures;
use crate::city::{CityPlan, FlatPlan};
use crate::plan::{FloorPlan, OpeningKind, PlanOpening, metres};
use crate::reach::doorway;
use crate::structure;

/// A flat of a storey.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Flat {
    /// The seed of its contents.
    pub(super) seed: Seed,
    pub(super) plan: FloorPlan,
    /// Its frame in that of the storey.
    pub(super) frame: RegionFrame,
    pub(super) door: FrontDoor,
}

/// The front door of a flat, in the north of its plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FrontDoor {
    /// The middle of its threshold, in the frame of the flat.
    pub(super) at: (f32, f32),
    /// The middle of the outer edge of its threshold, in the frame of the house, and whether the flat is north of it there.
    pub(super) outside: (f32, f32),
    pub(super) is_north: bool,
    /// Width and height.
    pub(super) size: (f32, f32),
    /// The number of the door in the scene of the flat, and that of the room that it leads into.
    pub(super) numbers: (u32, u32),
}

impl Flat {
    /// The flats of a storey, as the plan has them.
    pub(super) fn all(city: &CityPlan, building: usize, storey: usize, measures: &Measures) -> Vec<Self> {
        let seed = city.seed().child("home").nth(building as u64).nth(storey as u64);
        let units = city.buildings()[building].units(storey);
        let flats = units.iter().filter_map(|unit| city.flat(building, unit));
        flats.zip(0..).filter_map(|(flat, number)| Self::new(flat, measures, seed.nth(number))).collect()
    }

    fn new(flat: FlatPlan, measures: &Measures, seed: Seed) -> Option<Self> {
        let (x, y) = measures.local(&flat.at);
        let heading = flat.along.y.angle_to(flat.along.x) - measures.frame.heading;
        let frame = RegionFrame::new([f64::from(x), f64::from(y), 0.0], heading);
        let (place, opening) =
            flat.plan.openings.iter().enumerate().find(|(_, way)| way.kind == OpeningKind::Entrance)?;
        let hole = doorway(&flat.plan, opening);
        let middle = metres(hole.x0 + hole.x1) / 2.0;
        let outside = measures.local(&flat.place(f64::from(middle), f64::from(metres(hole.y1))));
        let door = FrontDoor {
            at: (middle, metres(hole.y0 + hole.y1) / 2.0),
            outside,
            is_north: outside.1 > measures.corridor.centre().1,
            size: (metres(opening.width()), opening.head - opening.sill),
            numbers: (structure::number_of(&flat.plan, place)?, room_of(opening)?),
        };
        Some(Self { seed, plan: flat.plan, frame, door })
    }
}

fn room_of(opening: &PlanOpening) -> Option<u32> {
    Some(opening.low.or(opening.high)? as u32)
}

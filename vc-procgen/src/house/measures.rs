//! The measures of a house, metres. X goes along the corridor, Y towards the main facade, and the origin is behind the corridor, in
//! the middle of the core, so that the core lies north of the corridor:
//!
//! ```text
//!            main facade
//!   +-------+-----------+-------+
//!   |       |   lobby   |       |
//!   | flats | lift | p  | flats |
//!   |       |stairs| p  |       |
//!   +-------+      +    +-------+
//!   |         corridor          |
//!   +---------------------------+
//!           court, or flats
//! ```

use vc_graph::portable::Portable;
use vc_graph::space::RegionFrame;
use vc_map::Point;

use super::error::HouseError;
use crate::area::Area;
use crate::circulation::lift;
use crate::circulation::stairs::Stairs;
use crate::city::{CORE, CORRIDOR, CityBuilding, Core};

/// The thickness of outer walls, of the lining of inner ones, and of slabs.
pub(super) const WALL: f32 = 0.2;
pub(super) const LINING: f32 = 0.08;
pub(super) const SLAB: f32 = 0.2;
/// The side of the corridor at which the core begins, and half the width of the core.
pub(super) const EDGE: f32 = CORRIDOR as f32;
pub(super) const HALF: f32 = CORE as f32 / 2.0;
/// The edge of the lift's landing, and the two flights west of it.
pub(super) const SHAFT: f32 = 0.44;
const FLIGHTS: [(f32, f32); 2] = [(LINING - HALF, -0.84), (-0.64, SHAFT)];
/// The distance between stairs and shaft.
const APART: f32 = 0.05;
/// The least depth of the lobby between shaft and facade.
const LOBBY: f32 = 1.5;
/// The street door: width and height.
pub(super) const STREET_DOOR: (f32, f32) = (1.2, 2.2);

/// The windows of landings: half their width, sill and head; and the distance of those in the corridor.
pub(super) const WINDOW: [f32; 3] = [0.7, 0.9, 2.1];
const APART_WINDOWS: f32 = 3.4;

/// A storey's height from floor to floor, and that of its rooms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Height {
    /// Above the ground.
    pub(super) floor: f64,
    pub(super) storey: f32,
    pub(super) clear: f32,
}

/// Where everything in a house is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Measures {
    /// The frame of the house on the map.
    pub(super) frame: RegionFrame,
    /// The outline of the house in its frame.
    pub(super) outline: Vec<(f32, f32)>,
    /// The corridor and the lobby before the facade, with their walls.
    pub(super) corridor: Area,
    pub(super) facade: f32,
    /// The middle of the lift's door along Y.
    pub(super) lift: f32,
    /// Whether there are flats on both sides of the corridor.
    pub(super) is_between: bool,
    pub(super) heights: Vec<Height>,
}

impl Measures {
    /// Those of a building.
    pub(super) fn of(house: &CityBuilding, number: usize) -> Result<Self, HouseError> {
        let [wing] = house.wings.as_slice() else { return Err(HouseError::NotOneWing(number)) };
        if house.kind.is_whole() {
            return Err(HouseError::NotOneWing(number));
        }
        let core = Core::of(&wing.plan).ok_or(HouseError::NoCore(number))?;
        let origin = core.at + crate::city::left(core.along) * (core.depth + CORRIDOR);
        let heading = core.along.y.angle_to(core.along.x) + std::f64::consts::PI;
        let frame = RegionFrame::new([origin.x, origin.y, 0.0], heading);
        let heights: Vec<Height> = (0..house.storeys)
            .map(|storey| Height {
                floor: (0..storey).map(|below| house.storey_height(below)).sum(),
                storey: house.storey_height(storey) as f32,
                clear: house.clear(storey) as f32,
            })
            .collect();
        let facade = EDGE + core.depth as f32;
        let stairs = heights.iter().map(|height| stairs(height.storey).area().y1).fold(EDGE, f32::max);
        let lift = stairs + APART + lift::around().x1;
        let [from, to] = core.corridor.map(|end| -end as f32);
        let corridor = Area { x0: to, x1: from, y0: 0.0, y1: EDGE };
        let fits = lift + lift::around().x1 + LOBBY + WALL <= facade && corridor.x0 < -HALF && corridor.x1 > HALF;
        if !fits {
            return Err(HouseError::NoCore(number));
        }
        let mut this =
            Self { frame, outline: Vec::new(), corridor, facade, lift, is_between: core.is_between, heights };
        this.outline = wing.plan.corners().iter().map(|corner| this.local(corner)).collect();
        Ok(this)
    }

    /// A point of the map in the frame of the house.
    pub(super) fn local(&self, at: &Point) -> (f32, f32) {
        let (sin, cos) = self.frame.heading.sine_cosine();
        let by = at - Point::new(self.frame.origin.x, self.frame.origin.y);
        ((cos * by.x + sin * by.y) as f32, (cos * by.y - sin * by.x) as f32)
    }

    /// The ground that the lift's shaft takes.
    pub(super) fn shaft(&self) -> Area {
        let around = lift::around();
        Area { x0: SHAFT - around.y1, x1: SHAFT, y0: self.lift + around.x0, y1: self.lift + around.x1 }
    }

    /// The hole in the floors above the ground for the stairs.
    pub(super) fn well(&self) -> Area {
        Area { x0: -HALF, x1: SHAFT, y0: EDGE, y1: self.shaft().y0 }
    }

    /// The inner side of the wall behind the corridor.
    pub(super) fn behind(&self) -> f32 {
        if self.is_between { LINING } else { WALL }
    }

    /// The middles of the windows of the corridor along X; none where there are flats on both sides.
    pub(super) fn corridor_windows(&self) -> Vec<f32> {
        let Area { x0, x1, .. } = self.corridor.grown(-WALL);
        let count = if self.is_between { 0.0 } else { ((x1 - x0) / APART_WINDOWS).floor() };
        (0..count as usize).map(|at| x0 + (x1 - x0) * (at as f32 + 0.5) / count).collect()
    }

    /// The stairs up from a storey.
    pub(super) fn stairs(&self, storey: usize) -> Stairs {
        stairs(self.heights[storey].storey)
    }
}

fn stairs(storey: f32) -> Stairs {
    let [up, back] = FLIGHTS;
    Stairs { up, back, foot: EDGE, storey, rises: Stairs::rises(storey) }
}

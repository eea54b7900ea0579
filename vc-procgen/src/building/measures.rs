//! The measures of a building, metres: X to the east, Y to the north, the origin at the middle of the southern edge of
//! the gallery.
//!
//! ```text
//!             stairs        lift
//!             a    b      +------+
//!             |    |      | cabin|
//! west home   +----+------+------+   east home
//!      bridge |      gallery     | bridge
//!             +--------+---------+
//!                    yard
//! ```

use crate::area::Area;

/// From floor to floor. A home with its slab and its roof is 3.15 high at most.
pub(super) const STOREY: f32 = 3.2;
/// The thickness of slabs.
pub(super) const SLAB: f32 = 0.2;
/// The height of a gallery, up to the slab of the next.
pub(super) const CLEAR: f32 = STOREY - SLAB;

/// The floor of a gallery, without its bridges.
pub(super) const DECK: Area = Area { x0: -3.5, y0: 0.0, x1: 3.5, y1: 3.0 };
/// The least distance from a gallery to a home: windows on that side get light, and no wall is shared.
pub(super) const GAP: f32 = 1.0;
/// The width of the bridge to a front door.
pub(super) const BRIDGE: f32 = 1.4;
/// The gap in the railing to the yard.
pub(super) const GATE: f32 = 1.6;
/// The distance of a railing's line from the edge that it guards.
pub(super) const INSET: f32 = 0.06;

/// The rises of a flight; a storey has two flights.
pub(super) const RISES: usize = 10;
/// The height of a step.
pub(super) const RISE: f32 = STOREY / (2 * RISES) as f32;
/// The depth of a step.
pub(super) const GOING: f32 = 0.29;
/// The length of a flight, from the first riser to the landing.
pub(super) const FLIGHT: f32 = (RISES - 1) as f32 * GOING;
/// The depth of the landing between two flights.
pub(super) const LANDING: f32 = 1.25;
/// The two flights: from the gallery up, and back to the next gallery. Between them is room for the banisters of two
/// storeys side by side.
pub(super) const UP: (f32, f32) = (-3.3, -2.1);
pub(super) const BACK: (f32, f32) = (-1.9, -0.7);

/// The distance of a banister's line from the edge of a flight.
pub(super) const BANISTER: f32 = 0.03;

/// The middle of the lift's door along the northern edge.
pub(super) const LIFT: f32 = 1.7;
/// The lift's door: width and height. Leaves of half the width disappear to both sides.
pub(super) const LIFT_DOOR: (f32, f32) = (1.1, 2.1);
/// The shaft within its walls: half its width, its depth.
pub(super) const SHAFT: (f32, f32) = (1.3, 1.95);
/// The thickness of the shaft's walls.
pub(super) const SHAFT_WALL: f32 = 0.2;
/// The cabin within its walls (1,275 kg): half its width, its depth, its height.
pub(super) const CABIN: [f32; 3] = [1.0, 1.4, 2.3];
/// The thickness of the cabin's walls.
pub(super) const CABIN_WALL: f32 = 0.05;
/// The floor of the gallery reaches so far into the shaft, and that of the cabin begins there; leaves slide above both.
pub(super) const SILL: (f32, f32) = (0.262, 0.268);
/// The front of the cabin.
pub(super) const CABIN_FRONT: f32 = 0.32;

/// The ground that belongs to the building: between the two homes, south of the gallery.
pub(super) const YARD: Area = Area { x0: -4.3, y0: -9.0, x1: 4.3, y1: 0.0 };
/// The path through the yard.
pub(super) const PATH: (f32, f32) = (-0.9, 0.9);
/// How far the ground of a building reaches beyond its walls, metres.
pub(super) const PLOT: f32 = 3.0;
/// How far it goes on beyond that unseen, metres: farther than anybody throws.
pub(super) const BEYOND: f32 = 30.0;

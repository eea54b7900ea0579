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
use crate::circulation::stairs::Stairs;

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

/// The stairs from each gallery to the next.
pub(super) const STAIRS: Stairs =
    Stairs { up: (-3.3, -2.1), back: (-1.9, -0.7), foot: DECK.y1, storey: STOREY, rises: 10 };

/// The middle of the lift's door along the northern edge.
pub(super) const LIFT: f32 = 1.7;
/// The ground that belongs to the building: between the two homes, south of the gallery.
pub(super) const YARD: Area = Area { x0: -4.3, y0: -9.0, x1: 4.3, y1: 0.0 };
/// The path through the yard.
pub(super) const PATH: (f32, f32) = (-0.9, 0.9);
/// How far the ground of a building reaches beyond its walls, metres.
pub(super) const PLOT: f32 = 3.0;
/// How far it goes on beyond that unseen, metres: farther than anybody throws.
pub(super) const BEYOND: f32 = 30.0;

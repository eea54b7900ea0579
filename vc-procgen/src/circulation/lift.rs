//! Lifts at a landing: the shaft with its door and the button that calls, in the frame of the door. X goes along the edge of the
//! landing's floor, Y into the shaft.

use std::f32::consts::FRAC_PI_2;

use super::Looks;
use super::cabin::{CABIN_FRONT, CABIN_WALL};
use super::parts::{Block, Maker, block, mounted, placed, solid};
use crate::area::Area;
use crate::item::{Item, Support};

/// The door: width and height. Leaves of half the width disappear to both sides.
pub(crate) const DOOR: (f32, f32) = (1.1, 2.1);
/// The shaft within its walls: half its width, its depth.
const WITHIN: (f32, f32) = (1.3, 1.95);
/// The thickness of its walls.
pub(crate) const WALL: f32 = 0.2;
/// The floor of the landing reaches so far into the shaft, and that of the cabin begins there; leaves slide above both.
pub(crate) const SILL: (f32, f32) = (0.262, 0.268);
/// The call button: depth, width, height, the height of its lower edge, and its distance from the door.
const CALL_BUTTON: [f32; 3] = [0.02, 0.08, 0.12];
const CALL_HEIGHT: f32 = 0.98;
const BESIDE: f32 = 0.22;

/// The thresholds of a stop, metres from the edge of the floor into the shaft: the landing's and the cabin's.
pub(crate) const THRESHOLDS: [f32; 2] = [WALL / 2.0, CABIN_FRONT + CABIN_WALL / 2.0];

/// The space within the walls.
pub(crate) fn within() -> Area {
    Area { x0: -WITHIN.0, x1: WITHIN.0, y0: WALL, y1: WALL + WITHIN.1 }
}

/// All that a shaft takes.
pub(crate) fn around() -> Area {
    within().grown(WALL)
}

/// The sill under the door.
pub(crate) fn sill() -> Area {
    Area { x0: -DOOR.0 / 2.0, x1: DOOR.0 / 2.0, y0: 0.0, y1: SILL.0 }
}

/// The door of the lift: its leaves slide in the shaft.
pub(crate) fn door(maker: Maker<'_>) -> Option<Item> {
    let door = maker.sized("lift_door", [WALL, DOOR.0, DOOR.1])?;
    Some(mounted(door, [0.0, WALL / 2.0, 0.0], -FRAC_PI_2))
}

/// The button beside it that calls the lift.
pub(crate) fn call_button(maker: Maker<'_>) -> Option<Item> {
    let [depth, width, height] = CALL_BUTTON;
    let button = maker.sized("call_button", [depth, width, height])?;
    let at = [-DOOR.0 / 2.0 - BESIDE, -depth / 2.0, CALL_HEIGHT];
    Some(placed(button, at, -FRAC_PI_2, Support::Wall))
}

/// The walls between two heights, and a roof of a thickness on them if there is one.
pub(crate) fn shaft((low, high): (f32, f32), roof: Option<f32>, looks: &Looks) -> Vec<Item> {
    let (Area { x1: half, y0: south, y1: north, .. }, outer, door) = (within(), around().x1, DOOR.0 / 2.0);
    let part = |x, y, z| -> Block { block(x, y, z, looks.shaft) };
    let (front, height) = ((0.0, south), (low, high));
    let walls = [
        vec![
            part((-outer, -door), front, height),
            part((door, outer), front, height),
            part((-door, door), front, (DOOR.1, high)),
        ],
        vec![part((-outer, -half), (south, north), height)],
        vec![part((half, outer), (south, north), height)],
        vec![part((-outer, outer), (north, north + WALL), height)],
    ];
    let roof =
        roof.and_then(|thick| solid("ceiling", &[part((-outer, outer), (0.0, north + WALL), (high, high + thick))]));
    walls.iter().filter_map(|blocks| solid("wall", blocks)).chain(roof).collect()
}

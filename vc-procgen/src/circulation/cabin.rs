//! The cabin of the lift, in the frame of its sill: X along the sill, Y into the shaft.

use std::f32::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use vc_graph::State;

use super::Looks;
use super::lift::{DOOR as LIFT_DOOR, SILL};
use super::parts::{self, Block, Maker, block, mounted, placed, solid};
use crate::area::Area;
use crate::item::{Item, Support};

/// The places of some items among those of the cabin.
pub(crate) const DOOR: usize = 1;
pub(crate) const BUTTONS: usize = 2;

/// The cabin within its walls (1,275 kg): half its width, its depth, its height.
pub(crate) const CABIN: [f32; 3] = [1.0, 1.4, 2.3];
/// The thickness of its walls.
pub(crate) const CABIN_WALL: f32 = 0.05;
/// Its front, metres from the edge of the landing's floor.
pub(crate) const CABIN_FRONT: f32 = 0.32;

/// The floor's thickness.
const FLOOR: f32 = 0.1;
/// The panel: thickness, width, height, and that of its lower edge above the floor.
const PANEL: [f32; 4] = [0.015, 0.26, 0.46, 0.84];
/// The lowest button above the floor, the distance of two rows, and half that of two columns.
const ROWS: (f32, f32, f32) = (0.9, 0.085, 0.055);
/// The side of a button.
const BUTTON: f32 = 0.045;

/// The items of the cabin: those with a place first, a button for each storey, then the rest.
pub(crate) fn items(storeys: usize, looks: &Looks, maker: Maker<'_>) -> Vec<Item> {
    let [half, depth, height] = CABIN;
    let (south, north) = (CABIN_FRONT + CABIN_WALL, CABIN_FRONT + CABIN_WALL + depth);
    let mut items = Vec::new();
    items.extend(parts::floor(&floor(looks), &[within()]));
    let door = maker.sized("lift_door", [CABIN_WALL, LIFT_DOOR.0, LIFT_DOOR.1]);
    items.extend(door.map(|door| mounted(door, [0.0, CABIN_FRONT + CABIN_WALL / 2.0, 0.0], FRAC_PI_2)));
    let middle = f32::midpoint(south, north);
    for storey in 0..storeys {
        let (row, column) = ((storey / 2) as f32, if storey % 2 == 0 { 1.0 } else { -1.0 });
        let at = [half - PANEL[0] - 0.006, middle + column * ROWS.2, ROWS.0 + row * ROWS.1];
        let button = maker.sized("floor_button", [0.012, BUTTON, BUTTON]);
        items.extend(button.map(|button| placed(button, at, PI, Support::Wall)));
    }
    let panel = maker.sized("lift_panel", [PANEL[0], PANEL[1], PANEL[2]]);
    items.extend(panel.map(|panel| placed(panel, [half - PANEL[0] / 2.0, middle, PANEL[3]], PI, Support::Wall)));
    items.extend(walls(looks).iter().filter_map(|blocks| solid("wall", blocks)));
    let roof = block(
        (-half - CABIN_WALL, half + CABIN_WALL),
        (CABIN_FRONT, north + CABIN_WALL),
        (height, height + 0.05),
        looks.cabin.0,
    );
    items.extend(solid("ceiling", &[roof]));
    if let Some(lamp) = maker.sized("ceiling_lamp", [0.4, 0.4, 0.1]) {
        let up = height - lamp.size().z;
        let lamp = placed(lamp, [0.0, middle, up], 0.0, Support::Ceiling);
        items.push(Item { states: vec![State::On], ..lamp });
    }
    items
}

/// The names of the buttons.
pub(crate) fn names(storeys: usize) -> Vec<(usize, Arc<str>)> {
    (0..storeys).map(|storey| (BUTTONS + storey, format!("storey {storey}").into())).collect()
}

/// The floor within the walls.
pub(crate) fn within() -> Area {
    let south = CABIN_FRONT + CABIN_WALL;
    Area { x0: -CABIN[0], y0: south, x1: CABIN[0], y1: south + CABIN[1] }
}

/// The floor under the walls, and the sill under the door.
fn floor(looks: &Looks) -> [Block; 2] {
    let (half, north) = (CABIN[0] + CABIN_WALL, within().y1 + CABIN_WALL);
    let door = LIFT_DOOR.0 / 2.0;
    let slab = |x, y| block(x, y, (-FLOOR, 0.0), looks.cabin.1);
    [slab((-half, half), (CABIN_FRONT, north)), slab((-door, door), (SILL.1, CABIN_FRONT))]
}

/// The front around the door, both sides, the back.
fn walls(looks: &Looks) -> [Vec<Block>; 4] {
    let (half, door, height) = (CABIN[0], LIFT_DOOR.0 / 2.0, (0.0, CABIN[2]));
    let (outer, south) = (half + CABIN_WALL, CABIN_FRONT + CABIN_WALL);
    let north = south + CABIN[1];
    let front = (CABIN_FRONT, south);
    let part = |x, y, z| block(x, y, z, looks.cabin.0);
    [
        vec![
            part((-outer, -door), front, height),
            part((door, outer), front, height),
            part((-door, door), front, (LIFT_DOOR.1, CABIN[2])),
        ],
        vec![part((-outer, -half), (south, north), height)],
        vec![part((half, outer), (south, north), height)],
        vec![part((-outer, outer), (north, north + CABIN_WALL), height)],
    ]
}

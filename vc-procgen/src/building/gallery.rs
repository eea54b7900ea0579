//! Galleries: a deck with railings, bridges to the front doors, stairs up, the shaft of the lift with its door.

use std::f32::consts::FRAC_PI_2;

use super::looks::Looks;
use super::measures::{BACK, BANISTER, CLEAR, DECK, GATE, INSET, LIFT, LIFT_DOOR, SHAFT, SHAFT_WALL, SILL, SLAB, UP};
use super::parts::{Block, Maker, P, block, mounted, placed, solid};
use super::rail::rail;
use super::stairs::stairs;
use crate::area::Area;
use crate::item::{Item, Support};

/// The places of some items among those of a gallery.
pub(super) const FLOOR: usize = 0;
pub(super) const DOOR: usize = 1;
pub(super) const CALL: usize = 2;

/// Half the side of a column, and half that of the northern edge's rail ends.
const COLUMN: f32 = 0.12;

/// A gallery as it is on one storey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gallery {
    /// Whether it is on the ground, with a gate to the yard.
    pub(super) ground: bool,
    /// Whether no stairs go up from it.
    pub(super) top: bool,
    /// The bridges to the front doors, in the west and in the east.
    pub(super) bridges: [Area; 2],
}

impl Gallery {
    /// All its items; those with a place come first.
    pub(super) fn items(&self, looks: &Looks, maker: Maker<'_>) -> Vec<Item> {
        let mut items = Vec::new();
        items.extend(solid("floor", &self.floor(looks)));
        let (width, height) = LIFT_DOOR;
        let door = maker.sized("lift_door", [SHAFT_WALL, width, height]);
        items.extend(door.map(|door| mounted(door, [LIFT, DECK.y1 + SHAFT_WALL / 2.0, 0.0], -FRAC_PI_2)));
        let call = maker.sized("call_button", [0.02, 0.08, 0.12]);
        let beside = LIFT - width / 2.0 - 0.22;
        items.extend(call.map(|call| placed(call, [beside, DECK.y1 - 0.01, 0.98], -FRAC_PI_2, Support::Wall)));
        items.extend(self.shaft(looks));
        items.extend(self.rails().iter().map(|line| rail("railing", line, looks.rail(), maker.style)));
        if !self.top {
            items.extend(stairs(looks.slab, looks.rail(), maker.style));
            items.extend(columns(looks));
        }
        items
    }

    /// The deck, its bridges, and the sill of the lift.
    fn floor(&self, looks: &Looks) -> Vec<Block> {
        let half = LIFT_DOOR.0 / 2.0;
        let sill = Area { x0: LIFT - half, x1: LIFT + half, y0: DECK.y1, y1: DECK.y1 + SILL.0 };
        let slab = |area: Area| block((area.x0, area.x1), (area.y0, area.y1), (-SLAB, 0.0), looks.floor);
        [DECK].into_iter().chain(self.bridges).chain([sill]).map(slab).collect()
    }

    /// The walls of the shaft as high as the storey and its slab, and a roof above the last.
    fn shaft(&self, looks: &Looks) -> Vec<Item> {
        let (half, door, south) = (SHAFT.0, LIFT_DOOR.0 / 2.0, DECK.y1 + SHAFT_WALL);
        let north = south + SHAFT.1;
        let (outer, height) = (half + SHAFT_WALL, (-SLAB, CLEAR));
        let part = |x: (f32, f32), y, z| block((LIFT + x.0, LIFT + x.1), y, z, looks.shaft);
        let front = (DECK.y1, south);
        let walls = [
            vec![
                part((-outer, -door), front, height),
                part((door, outer), front, height),
                part((-door, door), front, (LIFT_DOOR.1, CLEAR)),
            ],
            vec![part((-outer, -half), (south, north), height)],
            vec![part((half, outer), (south, north), height)],
            vec![part((-outer, outer), (north, north + SHAFT_WALL), height)],
        ];
        let roof = part((-outer, outer), (DECK.y1, north + SHAFT_WALL), (CLEAR, CLEAR + SLAB));
        let roof = if self.top { solid("ceiling", &[roof]) } else { None };
        walls.iter().filter_map(|blocks| solid("wall", blocks)).chain(roof).collect()
    }

    /// The lines of the railings: around the deck and along the bridges, open to the yard, the stairs, the lift.
    fn rails(&self) -> Vec<[P; 2]> {
        let deck = DECK.grown(-INSET);
        // Columns stand in the southern corners where there is a gallery above.
        let corner = if self.top { deck } else { DECK.grown(-2.0 * COLUMN - 0.02) };
        let line = |x0: f32, y0: f32, x1: f32, y1: f32| [[x0, y0, 0.0], [x1, y1, 0.0]];
        let gate = if self.ground { GATE / 2.0 } else { 0.0 };
        let mut lines = if self.ground {
            vec![line(corner.x0, deck.y0, -gate, deck.y0), line(gate, deck.y0, corner.x1, deck.y0)]
        } else {
            vec![line(corner.x0, deck.y0, corner.x1, deck.y0)]
        };
        // No stairs go up from the last gallery, none come up to the ground.
        let west = if self.top { BACK.0 - BANISTER } else { UP.0 + BANISTER };
        let east = if self.ground { UP.1 + BANISTER } else { BACK.1 - BANISTER };
        let outer = SHAFT.0 + SHAFT_WALL;
        lines.push(line(deck.x0, deck.y1, west, deck.y1));
        lines.push(line(east, deck.y1, LIFT - outer, deck.y1));
        lines.push(line(LIFT + outer, deck.y1, deck.x1, deck.y1));
        for (x, bridge) in [deck.x0, deck.x1].into_iter().zip(self.bridges) {
            let far = if x < 0.0 { bridge.x0 + INSET } else { bridge.x1 - INSET };
            for (from, edge) in [(corner.y0, bridge.y0 + INSET), (deck.y1, bridge.y1 - INSET)] {
                lines.push(line(x, from, x, edge));
                lines.push(line(x, edge, far, edge));
            }
        }
        lines
    }
}

/// Two columns under the southern corners of the next gallery.
fn columns(looks: &Looks) -> Vec<Item> {
    let y = (DECK.y0 + 0.01, DECK.y0 + 0.01 + 2.0 * COLUMN);
    let post = |x: f32| solid("column", &[block((x, x + 2.0 * COLUMN), y, (0.0, CLEAR), looks.slab)]);
    [DECK.x0 + 0.01, DECK.x1 - 0.01 - 2.0 * COLUMN].into_iter().filter_map(post).collect()
}

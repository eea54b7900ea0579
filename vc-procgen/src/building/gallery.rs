//! Galleries: a deck with railings, bridges to the front doors, stairs up, the shaft of the lift with its door.

use super::measures::{CLEAR, DECK, GATE, INSET, LIFT, SLAB, STAIRS, STOREY};
use crate::area::Area;
use crate::circulation::parts::{Block, Maker, P, block, floor, solid};
use crate::circulation::rail::rail;
use crate::circulation::stairs::BANISTER;
use crate::circulation::{Looks, lift};
use crate::item::Item;

/// The places of some items among those of a gallery.
pub(super) const FLOOR: usize = 0;
pub(super) const DOOR: usize = 1;
pub(super) const CALL: usize = 2;

/// Half the side of a column.
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
        let mut items = Vec::from_iter(floor(&self.floor(looks), &[DECK]));
        let parts = lift::door(maker).into_iter().chain(lift::call_button(maker)).chain(self.shaft(looks));
        items.extend(parts.map(|item| item.moved([LIFT, DECK.y1, 0.0])));
        items.extend(self.rails().iter().map(|line| rail("railing", line, looks.rail(), maker.style)));
        if !self.top {
            let posts = if self.ground { -SLAB } else { STOREY / 2.0 - STOREY };
            items.extend(STAIRS.items(Some(posts), looks, maker.style));
            items.extend(columns(looks));
        }
        items
    }

    /// The deck, its bridges, and the sill of the lift.
    fn floor(&self, looks: &Looks) -> Vec<Block> {
        let sill = lift::sill().moved((LIFT, DECK.y1));
        let slab = |area: Area| block((area.x0, area.x1), (area.y0, area.y1), (-SLAB, 0.0), looks.floor);
        [DECK].into_iter().chain(self.bridges).chain([sill]).map(slab).collect()
    }

    /// The walls of the shaft as high as the storey and its slab, and a roof above the last.
    fn shaft(&self, looks: &Looks) -> Vec<Item> {
        lift::shaft((-SLAB, CLEAR), self.top.then_some(SLAB), looks)
    }

    /// The lines of the railings: around the deck and along the bridges, open to the yard, the stairs, the lift.
    fn rails(&self) -> Vec<[P; 2]> {
        let bridges = self.bridges.iter().flat_map(|bridge| self.side(bridge));
        self.south().into_iter().chain(self.north()).chain(bridges).collect()
    }

    /// Where the railings begin in the south: at the columns that stand in the corners if there is a gallery above.
    fn corner(&self) -> Area {
        DECK.grown(if self.top { -INSET } else { -2.0 * COLUMN - 0.02 })
    }

    /// The southern edge, with a gap to the yard.
    fn south(&self) -> Vec<[P; 2]> {
        let (corner, y) = (self.corner(), DECK.y0 + INSET);
        let gate = GATE / 2.0;
        if self.ground {
            vec![line((corner.x0, y), (-gate, y)), line((gate, y), (corner.x1, y))]
        } else {
            vec![line((corner.x0, y), (corner.x1, y))]
        }
    }

    /// The northern edge, with gaps for stairs and shaft: no stairs go up from the last gallery, none come up to the ground.
    fn north(&self) -> [[P; 2]; 3] {
        let (deck, shaft) = (DECK.grown(-INSET), lift::around().x1);
        let west = if self.top { STAIRS.back.0 - BANISTER } else { STAIRS.up.0 + BANISTER };
        let east = if self.ground { STAIRS.up.1 + BANISTER } else { STAIRS.back.1 - BANISTER };
        let along = |from: f32, to: f32| line((from, deck.y1), (to, deck.y1));
        [along(deck.x0, west), along(east, LIFT - shaft), along(LIFT + shaft, deck.x1)]
    }

    /// The edge at which a bridge begins, and both sides of the bridge.
    fn side(&self, bridge: &Area) -> [[P; 2]; 4] {
        let (deck, south) = (DECK.grown(-INSET), self.corner().y0);
        let is_west = bridge.x0 < DECK.x0;
        let (near, far) = if is_west { (deck.x0, bridge.x0 + INSET) } else { (deck.x1, bridge.x1 - INSET) };
        let [low, high] = [bridge.y0 + INSET, bridge.y1 - INSET];
        [
            line((near, south), (near, low)),
            line((near, low), (far, low)),
            line((near, deck.y1), (near, high)),
            line((near, high), (far, high)),
        ]
    }
}

/// A line on the floor.
fn line((x0, y0): (f32, f32), (x1, y1): (f32, f32)) -> [P; 2] {
    [[x0, y0, 0.0], [x1, y1, 0.0]]
}

/// Two columns under the southern corners of the next gallery.
fn columns(looks: &Looks) -> Vec<Item> {
    let y = (DECK.y0 + 0.01, DECK.y0 + 0.01 + 2.0 * COLUMN);
    let post = |x: f32| solid("column", &[block((x, x + 2.0 * COLUMN), y, (0.0, CLEAR), looks.slab)]);
    [DECK.x0 + 0.01, DECK.x1 - 0.01 - 2.0 * COLUMN].into_iter().filter_map(post).collect()
}

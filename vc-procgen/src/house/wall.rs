//! Walls with holes for doors and windows.

use vc_shapes::material::MaterialId;

use crate::area::Area;
use crate::circulation::parts::{Block, block, solid};
use crate::facade::{Panel, around};
use crate::item::Item;

/// A wall along X or Y, whichever way it is longer, between two heights and with holes; all of it is one thing.
pub(super) fn wall(area: Area, height: (f32, f32), holes: &[Panel], material: MaterialId) -> Option<Item> {
    let is_along_x = area.size().0 >= area.size().1;
    let part = |[along, height]: Panel| -> Block {
        let (x, y) = if is_along_x { (along, (area.y0, area.y1)) } else { ((area.x0, area.x1), along) };
        block(x, y, height, material)
    };
    let along = if is_along_x { (area.x0, area.x1) } else { (area.y0, area.y1) };
    solid("wall", &around([along, height], holes).into_iter().map(part).collect::<Vec<Block>>())
}

//! Walls with holes for doors and windows.

use vc_shapes::material::MaterialId;

use crate::area::Area;
use crate::circulation::parts::{Block, block, solid};
use crate::item::Item;

/// A part of a wall, or a hole in it: from where to where along it, and from which height to which.
pub(super) type Panel = [(f32, f32); 2];

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

/// The parts of a panel around some holes.
pub(super) fn around([(from, to), (low, high)]: Panel, holes: &[Panel]) -> Vec<Panel> {
    let mut holes: Vec<Panel> = holes.iter().filter(|[(a, b), _]| *b > from && *a < to).copied().collect();
    holes.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
    let (mut found, mut at) = (Vec::new(), from);
    for [(a, b), (sill, head)] in holes {
        let (a, b) = (a.max(at), b.min(to));
        found.extend([[(at, a), (low, high)], [(a, b), (low, sill)], [(a, b), (head, high)]]);
        at = b.max(at);
    }
    found.push([(at, to), (low, high)]);
    found.retain(|panel| panel.iter().all(|(from, to)| to - from > 1e-3));
    found
}

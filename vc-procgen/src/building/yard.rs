//! The yard: a path between lawns, hedges around it, benches, a tree and flowers; and the ground on which the building stands.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_shapes::material::{GRASS, GRAVEL};

use super::measures::{PATH, SLAB, YARD};
use super::parts::{Maker, block, floor, placed};
use crate::area::Area;
use crate::item::{Item, Support};

/// The depth and height of hedges.
const HEDGE: (f32, f32) = (0.5, 1.2);

/// Things of the yard: class, X, Y, and how they are turned.
const THINGS: [(&str, f32, f32, f32); 9] = [
    ("garden_bench", -1.6, -3.2, 0.0),
    ("garden_bench", 1.6, -5.5, PI),
    ("planter", -1.6, -1.2, 0.0),
    ("planter", -1.6, -5.0, 0.0),
    ("rose_bush", -2.9, -6.4, 0.0),
    ("rose_bush", -2.9, -7.6, 0.0),
    ("bush", 2.6, -7.4, 0.0),
    ("watering_can", -1.3, -6.6, 0.4),
    ("garden_gnome", 1.5, -7.6, 2.4),
];

/// The tree: its place, and its size at most, so that its crown touches neither homes nor gallery.
const TREE: ([f32; 3], [f32; 3]) = ([2.3, -2.4, 0.0], [3.0, 3.0, 4.2]);

/// The ground first, then all that stands on it.
pub(super) fn items(plot: &Area, maker: Maker<'_>) -> Vec<Item> {
    let (y, z) = ((YARD.y0, YARD.y1), (-SLAB, 0.0));
    let ground =
        [block((YARD.x0, PATH.0), y, z, GRASS), block(PATH, y, z, GRAVEL), block((PATH.1, YARD.x1), y, z, GRASS)];
    let things = THINGS.iter().zip(0..).filter_map(|(&(class, x, y, yaw), nth)| {
        Some(placed(maker.usual(class, nth)?, [x, y, 0.0], yaw, Support::Floor))
    });
    let tree = maker.sized("fruit_tree", TREE.1).map(|tree| placed(tree, TREE.0, 0.0, Support::Floor));
    let below = floor(&[block((plot.x0, plot.x1), (plot.y0, plot.y1), (-2.0 * SLAB, -SLAB), GRAVEL)], &[]);
    let ground = floor(&ground, &[YARD]).into_iter();
    ground.chain(hedges(maker)).chain(things).chain(tree).chain(below).collect()
}

/// Hedges along three sides, two each.
fn hedges(maker: Maker<'_>) -> Vec<Item> {
    let (deep, high) = HEDGE;
    let (wide, long) = (YARD.x1 - YARD.x0, YARD.y1 - YARD.y0 - deep);
    let along = |x: f32, y: f32, length: f32, yaw: f32| {
        let hedge = maker.sized("hedge", [deep, length, high])?;
        Some(placed(hedge, [x, y, 0.0], yaw, Support::Floor))
    };
    let side = |x: f32| [0.25, 0.75].map(|share| along(x, YARD.y0 + deep + share * long, long / 2.0, 0.0));
    let end = [0.25, 0.75].map(|share| along(YARD.x0 + share * wide, YARD.y0 + deep / 2.0, wide / 2.0, FRAC_PI_2));
    let (west, east) = (side(YARD.x0 + deep / 2.0), side(YARD.x1 - deep / 2.0));
    west.into_iter().chain(east).chain(end).flatten().collect()
}

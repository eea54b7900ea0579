//! The yard: a path between lawns, hedges around it, benches, a tree and flowers; and the ground on which the building stands.

use std::f32::consts::{FRAC_PI_2, PI};

use vc_shapes::material::{GRASS, GRAVEL};

use super::measures::{BEYOND, PATH, SLAB, YARD};
use crate::area::Area;
use crate::circulation::parts::{Maker, block, built, floor, placed};
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
pub(super) fn items(plot: &Area, built_on: &[Area], maker: Maker<'_>) -> Vec<Item> {
    let (y, z) = ((YARD.y0, YARD.y1), (-SLAB, 0.0));
    let ground =
        [block((YARD.x0, PATH.0), y, z, GRASS), block(PATH, y, z, GRAVEL), block((PATH.1, YARD.x1), y, z, GRASS)];
    let things = THINGS.iter().zip(0..).filter_map(|(&(class, x, y, yaw), nth)| {
        Some(placed(maker.usual(class, nth)?, [x, y, 0.0], yaw, Support::Floor))
    });
    let tree = maker.sized("fruit_tree", TREE.1).map(|tree| placed(tree, TREE.0, 0.0, Support::Floor));
    let ground = floor(&ground, &[YARD]).into_iter();
    ground.chain(hedges(maker)).chain(things).chain(tree).chain([below(plot, built_on, maker)]).collect()
}

/// The ground on which all stands. It is drawn where nothing is built, so that light falls on it as it does there, and goes on
/// unseen beyond the plot for what rolls on.
fn below(plot: &Area, built_on: &[Area], maker: Maker<'_>) -> Item {
    let (low, high) = (-2.0 * SLAB, -SLAB);
    built("floor", [0.0; 3], maker.style, |b| {
        b.visual_only(|b| {
            for area in free(plot, built_on) {
                b.block("ground", [area.x0, area.y0, low], [area.x1, area.y1, high], GRAVEL);
            }
        });
        let all = plot.grown(BEYOND);
        b.collision_only(|b| b.block("ground", [all.x0, all.y0, low], [all.x1, all.y1, high], GRAVEL));
    })
}

/// The parts of an area that none of some others cover, in rows.
fn free(all: &Area, covered: &[Area]) -> Vec<Area> {
    let cuts = |low: f32, high: f32, of: [fn(&Area) -> f32; 2]| {
        let within = covered.iter().flat_map(|area| of.map(|side| side(area))).filter(|at| (low..high).contains(at));
        let mut cuts: Vec<f32> = within.chain([low, high]).collect();
        cuts.sort_by(f32::total_cmp);
        cuts.dedup();
        cuts
    };
    let (xs, ys) = (cuts(all.x0, all.x1, [|a| a.x0, |a| a.x1]), cuts(all.y0, all.y1, [|a| a.y0, |a| a.y1]));
    let mut free: Vec<Area> = Vec::new();
    for y in ys.windows(2) {
        for x in xs.windows(2) {
            let cell = Area { x0: x[0], y0: y[0], x1: x[1], y1: y[1] };
            let (at_x, at_y) = cell.centre();
            if covered.iter().any(|a| (a.x0..a.x1).contains(&at_x) && (a.y0..a.y1).contains(&at_y)) {
                continue;
            }
            match free.last_mut().filter(|last| last.x1 == cell.x0 && last.y0 == cell.y0) {
                Some(last) => last.x1 = cell.x1,
                None => free.push(cell),
            }
        }
    }
    free
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

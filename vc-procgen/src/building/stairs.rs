//! Stairs from one gallery to the next: two flights and a landing.

use nalgebra::Point3;
use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Style};

use super::looks::Looks;
use super::measures::{BACK, BANISTER, DECK, FLIGHT, GOING, LANDING, RISE, RISES, SLAB, STOREY, UP};
use super::parts::{P, built};
use super::rail::rail;
use crate::item::Item;

/// How deep a step is below its tread: it rests on the one before.
const DEEP: f32 = 0.3;
/// The foot of the stairs, at the edge of the gallery.
const FOOT: f32 = DECK.y1;
/// The side of the posts that hold the landing.
pub(super) const POST: f32 = 0.2;
/// The distance of banisters from the edge of the gallery.
const CLEAR_OF_DECK: f32 = 0.05;

/// The way over the stairs along the middle of the treads: from the floor before the first riser to the floor behind the last.
pub(super) fn way() -> Vec<Point3<f32>> {
    let (up, back) = (f32::midpoint(UP.0, UP.1), f32::midpoint(BACK.0, BACK.1));
    let (turn, half) = (FOOT + FLIGHT + LANDING / 2.0, STOREY / 2.0);
    let (foot, landing) = (FOOT - GOING / 2.0, FOOT + FLIGHT + GOING / 2.0);
    let points = [
        [up, foot, 0.0],
        [up, landing, half],
        [up, turn, half],
        [back, turn, half],
        [back, landing, half],
        [back, foot, STOREY],
    ];
    points.map(Point3::from).to_vec()
}

/// The treads from the foot up, the landing among them: the top of each as two corners.
pub(super) fn treads() -> Vec<(P, P)> {
    let up = (1..RISES).map(|i| tread(UP, FOOT + (i - 1) as f32 * GOING, i));
    let half = STOREY / 2.0;
    let landing = ([UP.0, FOOT + FLIGHT, half], [BACK.1, FOOT + FLIGHT + LANDING, half]);
    let back = (1..RISES).map(|i| tread(BACK, FOOT + FLIGHT - i as f32 * GOING, RISES + i));
    up.chain([landing]).chain(back).collect()
}

fn tread((x0, x1): (f32, f32), y: f32, rises: usize) -> (P, P) {
    let z = rises as f32 * RISE;
    ([x0, y, z], [x1, y + GOING, z])
}

/// The stairs of a storey with their banisters; the posts of the lowest stand on the ground.
pub(super) fn stairs(ground: bool, looks: &Looks, style: &Style) -> Vec<Item> {
    let at = [f32::midpoint(UP.0, BACK.1), FOOT, 0.0];
    let flights = built("stairs", at, style, |b| {
        b.at(at.map(|axis| -axis), 0.0, |b| {
            for (index, tread) in treads().into_iter().enumerate() {
                step(b, index, tread, looks.slab);
            }
            posts(b, if ground { -SLAB } else { STOREY / 2.0 - STOREY }, looks.slab);
        });
    });
    let banisters = lines().into_iter().map(|line| rail("banister", &line, looks.rail(), style));
    std::iter::once(flights).chain(banisters).collect()
}

fn step(b: &mut Build<'_>, index: usize, (low, high): (P, P), material: MaterialId) {
    let is_landing = index + 1 == RISES;
    let (name, deep) = if is_landing { ("landing".to_owned(), SLAB) } else { (format!("step_{}", index + 1), DEEP) };
    b.block(&name, [low[0], low[1], low[2] - deep], high, material);
    let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), high[2]];
    b.top(&name, centre, (0.45 * (high[0] - low[0]), 0.45 * (high[1] - low[1])));
}

/// Two posts behind the landing, from the one below or from the ground.
fn posts(b: &mut Build<'_>, foot: f32, material: MaterialId) {
    let north = FOOT + FLIGHT + LANDING;
    for west in [UP.0, BACK.1 - POST] {
        b.block("post", [west, north, foot], [west + POST, north + POST, STOREY / 2.0], material);
    }
}

/// The lines of the banisters: both outer sides, the end of the landing, and both inner sides with the landing between.
fn lines() -> [Vec<P>; 4] {
    let (half, end) = (STOREY / 2.0, FOOT + FLIGHT + LANDING - BANISTER);
    let (south, edge) = (FOOT + CLEAR_OF_DECK, FOOT + FLIGHT + GOING / 2.0);
    let foot = RISE / 2.0 + CLEAR_OF_DECK * RISE / GOING;
    let head = STOREY - foot;
    let (west, east) = (UP.0 + BANISTER, BACK.1 - BANISTER);
    let inner = [UP.1 + BANISTER, BACK.0 - BANISTER];
    let outer = |x: f32, z: f32| vec![[x, south, z], [x, edge, half], [x, end, half]];
    let between = [[inner[0], south, foot], [inner[0], edge, half], [inner[1], edge, half], [inner[1], south, head]];
    [outer(west, foot), outer(east, head), vec![[west, end, half], [east, end, half]], between.to_vec()]
}

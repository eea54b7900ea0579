//! Stairs from one storey to the next: two flights and a landing between them, in the frame of the floor from which they go up.

use nalgebra::Point3;
use vc_shapes::material::MaterialId;
use vc_shapes::{Build, Style};

use super::Looks;
use super::parts::{P, built};
use super::rail::rail;
use crate::area::Area;
use crate::item::Item;

/// The depth of a step.
const GOING: f32 = 0.29;
/// The depth of the landing between two flights.
const LANDING: f32 = 1.25;
/// The greatest height of a step.
const STEEP: f32 = 0.178;
/// The distance of a banister's line from the edge of a flight.
pub(crate) const BANISTER: f32 = 0.03;
/// How deep a step is below its tread: it rests on the one before.
const DEEP: f32 = 0.3;
/// The thickness of the landing.
const SLAB: f32 = 0.2;
/// The side of the posts that hold the landing.
pub(crate) const POST: f32 = 0.2;
/// The distance of banisters from the edge of the floor.
const CLEAR_OF_FLOOR: f32 = 0.05;

/// Stairs that go up to the north from the edge of a floor, and back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stairs {
    /// From where to where along X the first flight goes, and the one back. Between them is room for the banisters of two storeys
    /// side by side.
    pub(crate) up: (f32, f32),
    pub(crate) back: (f32, f32),
    /// The edge of the floor, along Y.
    pub(crate) foot: f32,
    /// From floor to floor.
    pub(crate) storey: f32,
    /// The rises of a flight.
    pub(crate) rises: usize,
}

impl Stairs {
    /// The least number of rises of a flight that is not too steep.
    pub(crate) fn rises(storey: f32) -> usize {
        (storey / 2.0 / STEEP).ceil() as usize
    }

    /// The height of a step.
    fn rise(&self) -> f32 {
        self.storey / (2 * self.rises) as f32
    }

    /// The landing's edge, along Y.
    fn turn(&self) -> f32 {
        self.foot + (self.rises - 1) as f32 * GOING
    }

    /// The ground that flights and landing take.
    pub(crate) fn area(&self) -> Area {
        Area { x0: self.up.0, x1: self.back.1, y0: self.foot, y1: self.turn() + LANDING }
    }

    /// The threshold of the floor above: the middle of the last tread but the floor.
    pub(crate) fn head(&self) -> (f32, f32) {
        (f32::midpoint(self.back.0, self.back.1), self.foot - GOING / 2.0)
    }

    /// The way over the stairs along the middle of the treads: from the floor before the first riser to the floor behind the last.
    pub(crate) fn way(&self) -> Vec<Point3<f32>> {
        let (up, back) = (f32::midpoint(self.up.0, self.up.1), f32::midpoint(self.back.0, self.back.1));
        let (turn, half) = (self.turn() + LANDING / 2.0, self.storey / 2.0);
        let (foot, landing) = (self.foot - GOING / 2.0, self.turn() + GOING / 2.0);
        let points = [
            [up, foot, 0.0],
            [up, landing, half],
            [up, turn, half],
            [back, turn, half],
            [back, landing, half],
            [back, foot, self.storey],
        ];
        points.map(Point3::from).to_vec()
    }

    /// The treads from the foot up, the landing among them: the top of each as two corners.
    pub(crate) fn treads(&self) -> Vec<(P, P)> {
        let up = (1..self.rises).map(|i| self.tread(self.up, self.foot + (i - 1) as f32 * GOING, i));
        let half = self.storey / 2.0;
        let landing = ([self.up.0, self.turn(), half], [self.back.1, self.turn() + LANDING, half]);
        let back = (1..self.rises).map(|i| self.tread(self.back, self.turn() - i as f32 * GOING, self.rises + i));
        up.chain([landing]).chain(back).collect()
    }

    fn tread(&self, (x0, x1): (f32, f32), y: f32, rises: usize) -> (P, P) {
        let z = rises as f32 * self.rise();
        ([x0, y, z], [x1, y + GOING, z])
    }

    /// The stairs with their banisters. Posts hold the landing from a height below the floor, if they are given.
    pub(crate) fn items(&self, posts: Option<f32>, looks: &Looks, style: &Style) -> Vec<Item> {
        let at = [f32::midpoint(self.up.0, self.back.1), self.foot, 0.0];
        let flights = built("stairs", at, style, |b| {
            b.at(at.map(|axis| -axis), 0.0, |b| {
                for (index, tread) in self.treads().into_iter().enumerate() {
                    self.step(b, index, tread, looks.slab);
                }
                if let Some(foot) = posts {
                    self.posts(b, foot, looks.slab);
                }
            });
        });
        let banisters = self.lines().into_iter().map(|line| rail("banister", &line, looks.rail(), style));
        std::iter::once(flights).chain(banisters).collect()
    }

    fn step(&self, b: &mut Build<'_>, index: usize, (low, high): (P, P), material: MaterialId) {
        let is_landing = index + 1 == self.rises;
        let (name, deep) =
            if is_landing { ("landing".to_owned(), SLAB) } else { (format!("step_{}", index + 1), DEEP) };
        b.block(&name, [low[0], low[1], low[2] - deep], high, material);
        let centre = [f32::midpoint(low[0], high[0]), f32::midpoint(low[1], high[1]), high[2]];
        b.top(&name, centre, (0.45 * (high[0] - low[0]), 0.45 * (high[1] - low[1])));
    }

    /// Two posts behind the landing, from the one below or from the ground.
    fn posts(&self, b: &mut Build<'_>, foot: f32, material: MaterialId) {
        let north = self.turn() + LANDING;
        for west in [self.up.0, self.back.1 - POST] {
            b.block("post", [west, north, foot], [west + POST, north + POST, self.storey / 2.0], material);
        }
    }

    /// The lines of the banisters: both outer sides, the end of the landing, and both inner sides with the landing between.
    fn lines(&self) -> [Vec<P>; 4] {
        let (half, end) = (self.storey / 2.0, self.turn() + LANDING - BANISTER);
        let (south, edge) = (self.foot + CLEAR_OF_FLOOR, self.turn() + GOING / 2.0);
        let foot = self.rise() / 2.0 + CLEAR_OF_FLOOR * self.rise() / GOING;
        let head = self.storey - foot;
        let (west, east) = (self.up.0 + BANISTER, self.back.1 - BANISTER);
        let inner = [self.up.1 + BANISTER, self.back.0 - BANISTER];
        let outer = |x: f32, z: f32| vec![[x, south, z], [x, edge, half], [x, end, half]];
        let between =
            [[inner[0], south, foot], [inner[0], edge, half], [inner[1], edge, half], [inner[1], south, head]];
        [outer(west, foot), outer(east, head), vec![[west, end, half], [east, end, half]], between.to_vec()]
    }
}

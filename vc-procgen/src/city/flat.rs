//! Flats in buildings: the sites that units leave for them, and the plans of their rooms.

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_map::Point;

use super::building::{CityBuilding, Unit};
use super::convex::{Beyond, left};
use super::floor::Core;
use super::unit_kind::UnitPlace;
use super::window::WindowSlot;
use super::wing::Wing;
use super::{CityPlan, Convex};
use crate::plan::{CELLS, FloorPlan, Side, Site, WindowPlace};

/// The thickness of outer walls outside the border of a plan, cells and metres.
const SHELL: i32 = 4;
const WALL: f64 = 0.2;
/// The thickness of floor and ceiling between storeys, and the greatest height of rooms, metres.
const SLABS: f64 = 0.4;
const HIGH: f64 = 3.2;
/// The greatest sine of the angle between walls that count as parallel.
const STRAIGHT: f64 = 0.01;
/// How far a window's middle may be from the facade of a site, metres.
const NEAR: f64 = 0.1;
/// A front door keeps this far from the ends of the corridor, metres.
const END: f64 = 0.35;
/// The least part of a flat's side at the corridor along which that is so wide.
const REACHED: f64 = 0.6;
/// Windows keep this far from the corners of a site, cells.
const CORNER: i32 = 4;

/// The plan of a flat, and where it lies in the city.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FlatPlan {
    /// Its rooms, doors and windows. Its south is the main facade, its north the corridor.
    pub plan: FloorPlan,
    /// The place of the plan's origin on the map.
    pub at: Point,
    /// The direction of the plan's X on the map, a unit vector.
    pub along: Vector2<f64>,
    /// The height of its floor above the ground, metres.
    pub floor: f64,
}

impl FlatPlan {
    /// The place of a point of the plan on the map, metres from the plan's origin.
    pub fn place(&self, x: f64, y: f64) -> Point {
        self.at + self.along * x + left(self.along) * y
    }
}

/// A site in a building, and where it lies.
pub(super) struct FlatSite {
    pub(super) site: Site,
    at: Point,
    along: Vector2<f64>,
}

impl CityPlan {
    /// The plan of a home of one storey: a flat. Flats above each other are alike, so that their wet rooms stand above one another, and
    /// every window of the building is one of the room behind it. `None` for other units, and where no flat fits: houses of several
    /// storeys, corners without a right angle that are too narrow.
    ///
    /// It follows from the seed of the city and the place of the unit alone, and costs some hundred microseconds.
    ///
    /// ```
    /// use vc_procgen::city::{CityPlan, CitySpecification};
    /// use vc_procgen::{Apartment, Specification};
    /// let wishes = CitySpecification { area: 0.2, ..CitySpecification::default() };
    /// let city = CityPlan::generate(&wishes, vc_graph::Seed(7))?;
    /// let house = city.buildings().iter().position(|building| building.homes() > 6).ok_or("no flats")?;
    /// let flat = city.buildings()[house].units(1).iter().find_map(|unit| city.flat(house, unit)).ok_or("no flat")?;
    /// // Furnish it as any other plan.
    /// let home = Apartment::generate(&Specification { plan: Some(flat.plan), ..Specification::default() }, vc_graph::Seed(1))?;
    /// assert!(home.check().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn flat(&self, building: usize, unit: &Unit) -> Option<FlatPlan> {
        let house = self.buildings.get(building)?;
        let FlatSite { site, at, along } = house.flat_site(unit)?;
        let corner = [at.x, at.y].map(|metres| (metres * 1e3).round() as i64 as u64);
        let seed = corner.into_iter().fold(self.seed.child("flat"), Seed::nth);
        let plan = FloorPlan::on(&site, seed).ok()?;
        let floor = (0..unit.storey).map(|storey| house.storey_height(storey)).sum();
        Some(FlatPlan { plan, at, along, floor })
    }
}

impl CityBuilding {
    /// The height of the rooms of a storey, metres.
    pub(crate) fn clear(&self, storey: usize) -> f64 {
        (self.storey_height(storey) - SLABS).min(HIGH)
    }

    /// The site of a unit that is a flat: the rectangle between its facade and the corridor. `None` where no flat fits.
    pub(super) fn flat_site(&self, unit: &Unit) -> Option<FlatSite> {
        if unit.kind.place() != UnitPlace::Home || unit.storeys != 1 || self.kind.is_whole() {
            return None;
        }
        let here = |wing: &&Wing| wing.from <= unit.storey && unit.storey < wing.to;
        let wing = self.wings.iter().filter(here).find(|wing| wing.plan.contains(&unit.outline.middle(), 0.0))?;
        let core = Core::of(&wing.plan)?;
        let (a, along, [from, to], depth) = to_corridor(&unit.outline, &core.along)?;
        let across = left(along);
        let inside = |length: f64| ((length - 2.0 * WALL) * f64::from(CELLS) + 1e-6).floor() as i32;
        let (width, deep) = (inside(to - from), inside(depth));
        if width.min(deep) < 1 {
            return None;
        }
        let at = a + along * (from + WALL) + across * WALL;
        let ceiling = self.clear(unit.storey) as f32;
        let place = |window: &WindowSlot| {
            let own = window.at - at;
            let (x, y) = (own.dot(&along), own.dot(&across));
            let end = f64::from(width) / f64::from(CELLS) + WALL;
            let (side, middle, length) = match (window.out.dot(&along), window.out.dot(&across)) {
                (_, out) if out < STRAIGHT - 1.0 && (y + WALL).abs() < NEAR => (Side::South, x, width),
                (out, _) if out < STRAIGHT - 1.0 && (x + WALL).abs() < NEAR => (Side::West, y, deep),
                (out, _) if out > 1.0 - STRAIGHT && (x - end).abs() < NEAR => (Side::East, y, deep),
                _ => return None,
            };
            let cell = |metres: f64| (metres * f64::from(CELLS)).round() as i32;
            let (from, to) = (cell(middle - window.size[0] / 2.0), cell(middle + window.size[0] / 2.0));
            let (sill, head) = (window.sill as f32, (window.sill + window.size[1]) as f32);
            let fits = from >= CORNER && to <= length - CORNER && head < ceiling;
            fits.then_some(WindowPlace { side, from, to, sill, head })
        };
        let windows = unit.windows.iter().filter(|window| window.storey == unit.storey).filter_map(place).collect();
        // The part of the corridor before it, as its own facade goes.
        let ends = core.corridor.map(|end| along.dot(&(core.at + core.along * end - at)));
        let cell = |metres: f64| ((metres * f64::from(CELLS)).round() as i32).clamp(0, width);
        let door = (cell(ends[0].min(ends[1]) + END), cell(ends[0].max(ends[1]) - END));
        if f64::from(door.1 - door.0) < f64::from(width) * REACHED {
            return None;
        }
        let site = Site { width, depth: deep, windows, door, ceiling, shell: SHELL };
        site.check().is_ok().then_some(FlatSite { site, at, along })
    }
}

/// The widest rectangle between an open side and the corridor, which goes along a wing: a corner of the open side, its direction, the
/// stretch along it, and the depth, metres.
fn to_corridor(outline: &Convex, wing: &Vector2<f64>) -> Option<(Point, Vector2<f64>, [f64; 2], f64)> {
    let goes_along = |(a, b, _): &(Point, Point, Beyond)| wing.perp(&(b - a).normalize()).abs() < STRAIGHT;
    let fronts = outline.sides().filter(|side| side.2.is_open()).filter(goes_along);
    let pairs = fronts.flat_map(|(a, b, _)| {
        let (along, length) = ((b - a).normalize(), (b - a).norm());
        let behind = outline.sides().filter(|side| side.2 == Beyond::Inside).filter(goes_along);
        behind.filter_map(move |(c, d, _)| {
            let [from, to] = [(d - a).dot(&along).max(0.0), (c - a).dot(&along).min(length)];
            let depth = left(along).dot(&(c - a)).min(left(along).dot(&(d - a)));
            (to > from && depth > 0.0).then_some((a, along, [from, to], depth))
        })
    });
    pairs.max_by(|a, b| (a.2[1] - a.2[0]).total_cmp(&(b.2[1] - b.2[0])))
}

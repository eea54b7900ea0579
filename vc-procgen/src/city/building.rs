//! Buildings: wings with storeys, doors to the street, and units that are worked out when they are asked for.

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_map::Point;

use super::building_type::BuildingType;
use super::convex::{Beyond, Convex, left};
use super::floor::{Floor, floor, main_side};
use super::unit_kind::{UnitKind, UnitPlace};
use super::window::{WindowSlot, windows};
use super::wing::{Wing, wings};

/// The widths of a flat, an office and a shop along the street, metres.
const FLAT: f64 = 6.7;
const OFFICE: f64 = 12.0;
const SHOP: f64 = 7.0;
/// Residents of a house and of a flat, on average.
const RESIDENTS: [f64; 2] = [2.6, 2.1];

/// A door from the street into a building.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StreetDoor {
    /// The middle of its threshold.
    pub at: Point,
    /// The direction in which one leaves by it, a unit vector.
    pub out: Vector2<f64>,
    /// The street to which it leads, by its position in [`CityPlan::streets`](super::CityPlan::streets).
    pub street: usize,
}

/// A unit of a building: a home, a shop, an office.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Unit {
    /// Its kind.
    pub kind: UnitKind,
    /// Its lowest storey, counted from the ground.
    pub storey: usize,
    /// The number of its storeys.
    pub storeys: usize,
    /// Its floor plan; whatever lies beyond a side is a street, a court, a neighbour, or more of the building.
    pub outline: Convex,
    /// Its door: on the street for a shop or a house, else the middle of its side at the corridor; the plan of a
    /// [flat](super::CityPlan::flat) says where along that it is.
    pub door: Point,
    /// The places in its facades where windows may be.
    pub windows: Vec<WindowSlot>,
}

/// A building of a plan.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CityBuilding {
    /// Its type.
    pub kind: BuildingType,
    /// Its parcel, by its position in [`CityPlan::parcels`](super::CityPlan::parcels).
    pub parcel: usize,
    /// Its wings.
    pub wings: Vec<Wing>,
    /// The number of its storeys.
    pub storeys: usize,
    /// The number of its shops on the ground; there are homes or offices if it is zero.
    pub shops: usize,
    /// The kinds of its shops in the order of its units, or its own kind if it is one unit.
    pub places: Vec<UnitKind>,
}

impl CityBuilding {
    /// A building of a type on a parcel, with shops on the ground or without; `None` if the parcel is too small.
    pub(super) fn on(parcel: &Convex, number: usize, kind: BuildingType, storeys: usize, shops: bool) -> Option<Self> {
        let wings = wings(parcel, kind, storeys);
        if wings.is_empty() {
            return None;
        }
        let mut building = Self { kind, parcel: number, wings, storeys, shops: 0, places: Vec::new() };
        if shops && !kind.is_whole() {
            let ground = building.wings.iter().filter(|wing| wing.from == 0);
            building.shops = ground
                .flat_map(|wing| floor(&wing.plan, SHOP).units)
                .filter(|unit| street_side(unit).is_some())
                .count();
        }
        Some(building)
    }

    /// The height of a storey, metres.
    pub fn storey_height(&self, storey: usize) -> f64 {
        let [ground, upper] = self.kind.measures().heights;
        if storey == 0 { ground } else { upper }
    }

    /// The height of its top, metres.
    pub fn height(&self) -> f64 {
        (0..self.storeys).map(|storey| self.storey_height(storey)).sum()
    }

    /// Its doors from the street, one for each core, or one.
    pub fn doors(&self) -> Vec<StreetDoor> {
        let door = |plan: &Convex| {
            let (a, b, beyond) = street_side(plan)?;
            let Beyond::Street(street) = beyond else { return None };
            Some(StreetDoor { at: nalgebra::center(&a, &b), out: -left((b - a).normalize()), street })
        };
        let ground = self.wings.iter().filter(|wing| wing.from == 0);
        if self.kind.is_whole() {
            return ground.take(1).filter_map(|wing| door(&wing.plan)).collect();
        }
        ground
            .filter_map(|wing| floor(&wing.plan, FLAT).core.as_ref().and_then(door).or_else(|| door(&wing.plan)))
            .collect()
    }

    /// The width of its units on a storey, metres.
    fn width(&self, storey: usize) -> f64 {
        match self.kind {
            _ if storey == 0 && self.shops > 0 => SHOP,
            BuildingType::Office => OFFICE,
            _ => FLAT,
        }
    }

    /// The kind of a unit above the shops.
    fn upper(&self) -> UnitKind {
        if self.kind == BuildingType::Office { UnitKind::OFFICE } else { UnitKind::HOME }
    }

    /// The floors of a storey, each with its wing.
    pub(super) fn floors(&self, storey: usize) -> impl Iterator<Item = (&Wing, Floor)> {
        let here = move |wing: &&Wing| wing.from <= storey && storey < wing.to;
        self.wings.iter().filter(here).map(move |wing| (wing, floor(&wing.plan, self.width(storey))))
    }

    /// The units of a storey, worked out anew: they follow from the building alone, whichever storey is asked for first. Costs a
    /// few microseconds a unit.
    pub fn units(&self, storey: usize) -> Vec<Unit> {
        if self.kind.is_whole() {
            return if storey == 0 { self.whole().into_iter().collect() } else { Vec::new() };
        }
        let mut shops = self.places.iter();
        let mut units = Vec::new();
        for (_, floor) in self.floors(storey) {
            for outline in floor.units {
                let shop = storey == 0 && self.shops > 0 && street_side(&outline).is_some();
                let kind = if shop { shops.next().copied() } else { None }.unwrap_or_else(|| self.upper());
                let Some(door) = self.door(&outline, kind.place() == UnitPlace::Shop) else { continue };
                let windows = windows(self, &outline, storey, kind);
                // Behind another wing there are stores.
                if windows.is_empty() && kind.place() != UnitPlace::Shop {
                    continue;
                }
                let unit = Unit { kind, storey, storeys: 1, outline, door, windows };
                // Where no flat fits there are stores, bicycles, plant.
                if kind != UnitKind::HOME || self.flat_site(&unit).is_some() {
                    units.push(unit);
                }
            }
        }
        units
    }

    /// The one unit of a house.
    fn whole(&self) -> Option<Unit> {
        let outline = self.wings.first()?.plan.clone();
        let kind = self.places.first().copied().unwrap_or(UnitKind::HOME);
        let door = self.door(&outline, true)?;
        let windows = (0..self.storeys).flat_map(|storey| windows(self, &outline, storey, kind)).collect();
        Some(Unit { kind, storey: 0, storeys: self.storeys, outline, door, windows })
    }

    /// The door of a unit: to the street, or to the corridor.
    fn door(&self, outline: &Convex, street: bool) -> Option<Point> {
        let (a, b, _) = if street {
            street_side(outline)?
        } else {
            let (a, b, _) = main_side(outline)?;
            let along = (b - a).normalize();
            let beside = |side: &(Point, Point, Beyond)| {
                side.2 == Beyond::Inside && along.dot(&(side.1 - side.0).normalize()).abs() > 0.9
            };
            outline.sides().find(beside).or_else(|| outline.longest(|beyond| beyond == Beyond::Inside))?
        };
        Some(nalgebra::center(&a, &b))
    }

    /// The number of its homes. Costs the units of two storeys, of three with a tower.
    pub fn homes(&self) -> usize {
        let homes = |storey: usize| self.units(storey).iter().filter(|unit| unit.kind == UnitKind::HOME).count();
        let wings = |storey: usize| {
            self.wings.iter().map(|wing| wing.from <= storey && storey < wing.to).collect::<Vec<bool>>()
        };
        let (mut sum, mut same) = (homes(0), None);
        for storey in 1..self.storeys {
            // Storeys above each other are alike.
            let here = wings(storey);
            let count =
                same.take().filter(|(before, _)| *before == here).map_or_else(|| homes(storey), |(_, count)| count);
            sum += count;
            same = Some((here, count));
        }
        sum
    }

    /// The number of its residents, on average.
    pub fn residents(&self) -> f64 {
        self.homes() as f64 * RESIDENTS[usize::from(!self.kind.is_whole())]
    }

    /// The area of the land that it covers, and the sum of its floors, square metres.
    pub fn areas(&self) -> [f64; 2] {
        let covered = self.wings.iter().filter(|wing| wing.from == 0).map(|wing| wing.plan.area()).sum();
        [covered, self.wings.iter().map(|wing| wing.plan.area() * (wing.to - wing.from) as f64).sum()]
    }
}

/// The longest side of a plan on a street.
pub(super) fn street_side(plan: &Convex) -> Option<(Point, Point, Beyond)> {
    plan.longest(|beyond| matches!(beyond, Beyond::Street(_)))
}

/// The number of storeys of a building of a type; those of a block are alike.
pub(super) fn storeys(kind: BuildingType, block: Seed, own: Seed) -> usize {
    let [least, middle, greatest] = kind.measures().storeys;
    let spread = (greatest - least) as f32 / 5.0;
    let alike = block.child("height").stream().normal(0.0, spread);
    let drawn = middle as f32 + alike + own.child("height").stream().normal(0.0, 0.45);
    (drawn.round().max(0.0) as usize).clamp(least, greatest)
}

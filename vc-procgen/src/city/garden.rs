//! Gardens and courts: trees on the part of a parcel where nothing is built.

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_map::Point;

use super::building::CityBuilding;
use super::convex::{Beyond, Convex};
use super::near::Near;
use super::{BuildingType, Parcel, StreetItem};

/// Trees stand about this far apart, and this far from facades, borders, streets and lamps, metres.
const APART: f64 = 8.0;
const FACADE: f64 = 3.2;
const BORDER: f64 = 1.5;
const STREET: f64 = 4.7;
const LAMP: f64 = 4.5;
/// The chance that there is one.
const CHANCE: f32 = 0.75;

/// The trees of all parcels with buildings.
pub(super) fn trees(parcels: &[Parcel], buildings: &[CityBuilding], items: &[StreetItem], seed: Seed) -> Vec<Point> {
    // Lamps of a street around the corner.
    let lamps = Near::of(items.iter().filter(|item| item.class == "street_lamp").map(|item| &item.at));
    let green = |building: &&CityBuilding| !matches!(building.kind, BuildingType::Hall | BuildingType::Tower);
    let walls: Vec<&Convex> =
        buildings.iter().flat_map(|b| &b.wings).filter(|wing| wing.from == 0).map(|wing| &wing.plan).collect();
    let middles: Vec<Point> = walls.iter().map(|wall| wall.middle()).collect();
    let reach = |(wall, middle): (&&Convex, &Point)| {
        wall.corners().iter().map(|corner| (corner - middle).norm()).fold(0.0, f64::max)
    };
    let reach = walls.iter().zip(&middles).map(reach).fold(0.0, f64::max) + FACADE;
    let near = Near::of(&middles);
    let free = |at: &Point| {
        near.around(at, reach).all(|wall| walls[wall].distance(at) >= FACADE) && lamps.around(at, LAMP).next().is_none()
    };
    buildings.iter().filter(green).flat_map(|building| garden(parcels, building, &free, seed)).collect()
}

/// Whether a point keeps its distance from the borders of a parcel.
fn clear(land: &Convex, at: &Point) -> bool {
    land.sides().all(|(a, b, beyond)| {
        let away = if matches!(beyond, Beyond::Street(_)) { STREET } else { BORDER };
        (b - a).normalize().perp(&(at - a)) >= away
    })
}

fn garden(parcels: &[Parcel], building: &CityBuilding, free: &impl Fn(&Point) -> bool, seed: Seed) -> Vec<Point> {
    let Some(parcel) = parcels.get(building.parcel) else { return Vec::new() };
    let mut stream = seed.child("garden").nth(building.parcel as u64).stream();
    let [[west, east], [south, north]] = [Vector2::x(), Vector2::y()].map(|axis| parcel.land.extent(&axis));
    let mut found = Vec::new();
    let (mut x, mut y) = (west, south);
    while y < north {
        let at = Point::new(
            x + f64::from(stream.between(0.0, 0.8)) * APART,
            y + f64::from(stream.between(0.0, 0.8)) * APART,
        );
        if stream.chance(CHANCE) && clear(&parcel.land, &at) && free(&at) {
            found.push(at);
        }
        x += APART;
        if x > east {
            (x, y) = (west, y + APART);
        }
    }
    found
}

//! Hedges and fences before houses.

use nalgebra::Vector2;
use vc_graph::portable::Portable;
use vc_map::Point;

use super::stock::Stock;
use super::{Outdoors, Place};
use crate::city::{Beyond, BuildingType, CityBuilding, left};
use crate::item::Item;

/// The depth and height of a hedge and of a fence, metres.
const HEDGE: (f32, f32) = (0.5, 1.0);
const FENCE: (f32, f32) = (0.08, 1.0);
/// Their distance from the street and from the neighbours, half the width of the way to a door, and the least length of a piece, metres.
const INSIDE: f64 = 0.35;
const END: f64 = 0.3;
const WAY: f64 = 0.9;
const LEAST: f64 = 0.8;

/// Those of all houses within the reach of a place.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place, stock: &Stock<'_>) -> Vec<Item> {
    let near = outdoors.buildings.around(&place.at, place.reach);
    let houses = near.into_iter().map(|number| &outdoors.city.buildings()[number]);
    let houses = houses.filter(|house| matches!(house.kind, BuildingType::Detached | BuildingType::Row));
    houses.flat_map(|house| front(outdoors, house, stock)).collect()
}

/// Along the sides of a house's parcel at streets, with a gap before its door: all houses of a street have the same, or none.
fn front(outdoors: &Outdoors<'_>, house: &CityBuilding, stock: &Stock<'_>) -> Vec<Item> {
    let city = outdoors.city;
    let doors = house.doors();
    let mut items = Vec::new();
    for (a, b, beyond) in city.parcels()[house.parcel].land.sides() {
        let Beyond::Street(street) = beyond else { continue };
        let (class, (deep, high)) = match city.seed().child("front").nth(street as u64).stream().below(5) {
            0..2 => ("hedge", HEDGE),
            2..4 => ("fence", FENCE),
            _ => continue,
        };
        let (along, length) = ((b - a).normalize(), (b - a).norm());
        let gap = doors.iter().filter(|door| door.street == street).map(|door| (door.at - a).dot(&along)).next();
        let pieces = match gap {
            Some(at) => vec![(END, at - WAY), (at + WAY, length - END)],
            None => vec![(END, length - END)],
        };
        for (from, to) in pieces.into_iter().filter(|(from, to)| to - from > LEAST) {
            let middle: Point = a + along * f64::midpoint(from, to) + left(along) * INSIDE;
            let out: Vector2<f64> = -left(along);
            let size = [deep, (to - from) as f32, high];
            items.extend(stock.sized(class, size, &middle, out.y.angle_to(out.x)));
        }
    }
    items
}

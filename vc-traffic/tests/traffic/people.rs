//! Checks on people for tests.

use std::collections::BTreeMap;

use vc_map::Point;
use vc_traffic::{PersonId, Pose, Traffic, VehicleId};

/// Two bodies, discs of 0.2 m, that overlap by more than a centimetre.
pub(crate) fn overlap(people: impl Iterator<Item = [f32; 2]>) -> Option<([f32; 2], [f32; 2])> {
    let mut cells: BTreeMap<[i32; 2], Vec<[f32; 2]>> = BTreeMap::new();
    for at in people {
        let [x, y] = at.map(|metres| metres.floor() as i32);
        for other in
            (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y])).filter_map(|cell| cells.get(&cell))
        {
            let near = |other: &&[f32; 2]| (at[0] - other[0]).powi(2) + (at[1] - other[1]).powi(2) < 0.39 * 0.39;
            if let Some(other) = other.iter().find(near) {
                return Some((at, *other));
            }
        }
        cells.entry([x, y]).or_default().push(at);
    }
    None
}

/// The radius of a body, metres, and what rounding may add.
const RADIUS: f64 = 0.2;
const ROUNDING: f64 = 0.01;
const CELL: f64 = 16.0;

/// Somebody over whose body that of a vehicle comes.
pub(crate) fn hit(traffic: &Traffic) -> Option<(PersonId, VehicleId)> {
    let cell = |at: &Point| [at.x, at.y].map(|metres| (metres / CELL).floor() as i32);
    let mut cells: BTreeMap<[i32; 2], Vec<(VehicleId, Pose)>> = BTreeMap::new();
    traffic.vehicles().for_each(|(id, pose)| cells.entry(cell(&pose.at)).or_default().push((id, pose)));
    traffic.people().find_map(|walker| {
        let at = Point::new(f64::from(walker.at[0]), f64::from(walker.at[1]));
        let [x, y] = cell(&at);
        let around = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y]));
        let mut near = around.filter_map(|cell| cells.get(&cell)).flatten();
        near.find(|(_, pose)| is_under(pose, &at)).map(|(id, _)| (walker.id, *id))
    })
}

fn is_under(pose: &Pose, at: &Point) -> bool {
    let corners = pose.corners();
    let forward = (corners[0] - corners[1]).normalize();
    let from = at - pose.at;
    let [length, width] = pose.size.map(|metres| f64::from(metres) / 2.0);
    let (along, across) = (from.dot(&forward).abs() - length, forward.perp(&from).abs() - width);
    along < RADIUS - ROUNDING && across < RADIUS - ROUNDING
}

//! Rules 3 to 5 and 20: buildings on their parcels, parcels on streets, doors on pavements, places within reach.

use std::collections::BTreeSet;

use vc_map::{Point, WalkNodeId};

use super::super::convex::Beyond;
use super::super::near::Near;
use super::super::{CityBuilding, UnitKind};
use super::{CityPart, CityPlan, CityRule, Found};

const FRONTAGE: f64 = 3.0;
const FIRE: f64 = 45.0;
/// The square before a door that is free, metres.
const FREE: f64 = 1.5;
const TOUCH: f64 = 2e-3;
const SAME: f64 = 0.05;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    for (index, parcel) in plan.parcels.iter().enumerate() {
        let street = |beyond: Beyond| matches!(beyond, Beyond::Street(_));
        let front =
            parcel.land.sides().filter(|side| street(side.2)).map(|(a, b, _)| (b - a).norm()).fold(0.0, f64::max);
        if front < FRONTAGE {
            found.add(CityRule::NoFrontage, CityPart::Parcel(index), parcel.land.middle(), front);
        }
    }
    let items: Vec<Point> = plan.items.iter().map(|item| item.at).collect();
    let near = Near::of(&items);
    let main = main_part(plan);
    for (index, building) in plan.buildings.iter().enumerate() {
        on_parcel(plan, index, building, found);
        doors(plan, index, building, (&near, &main), found);
    }
    places(plan, found);
}

fn on_parcel(plan: &CityPlan, index: usize, building: &CityBuilding, found: &mut Found) {
    let part = CityPart::Building(index);
    let Some(parcel) = plan.parcels.get(building.parcel) else { return };
    for corner in building.wings.iter().flat_map(|wing| wing.plan.corners()) {
        let beyond = parcel
            .land
            .sides()
            .map(|(a, b, _)| -(b - a).normalize().perp(&(corner - a)))
            .fold(f64::NEG_INFINITY, f64::max);
        if beyond > TOUCH {
            found.add(CityRule::BuildingOffParcel, part, *corner, beyond);
        }
    }
    for (place, one) in building.wings.iter().enumerate() {
        for other in building.wings[place + 1..].iter().filter(|other| other.from < one.to && one.from < other.to) {
            let shared = one.plan.shared(&other.plan);
            if shared > SAME {
                found.add(CityRule::WingsOverlap, part, one.plan.middle(), shared);
            }
        }
    }
}

fn doors(
    plan: &CityPlan,
    index: usize,
    building: &CityBuilding,
    (items, main): (&Near, &BTreeSet<WalkNodeId>),
    found: &mut Found,
) {
    let part = CityPart::Building(index);
    let doors = building.doors();
    if doors.is_empty() {
        let at = building.wings.first().map_or(Point::origin(), |wing| wing.plan.middle());
        found.add(CityRule::NoEntrance, part, at, 0.0);
    }
    for door in doors {
        // Straight out of the door there is a pavement.
        let reached =
            (0..8).find_map(|step| plan.map.walk_near(&(door.at + door.out * (1.0 + f64::from(step) * 2.0)), 4.0));
        let Some(edge) = reached.and_then(|(edge, _)| plan.map.walk_edge(edge)) else {
            found.add(CityRule::EntranceOffPavement, part, door.at, FIRE);
            continue;
        };
        if !edge.ends.iter().all(|node| main.contains(node)) {
            found.add(CityRule::PlaceCutOff, part, door.at, 0.0);
        }
        let carriageway = plan.map.lane_near(&door.at, vc_map::Users::CAR, FIRE);
        if carriageway.is_none() {
            found.add(CityRule::FarFromStreet, part, door.at, FIRE);
        }
        let before = door.at + door.out * (FREE / 2.0);
        for item in items.around(&before, 3.0) {
            let away = plan.items[item].at - before;
            let [along, across] = [away.dot(&door.out).abs(), door.out.perp(&away).abs()];
            let reach = along.max(across) - plan.items[item].radius;
            if reach < FREE / 2.0 {
                found.add(CityRule::EntranceBlocked, part, door.at, reach);
            }
        }
    }
}

/// The nodes of the largest part of the walkable network.
fn main_part(plan: &CityPlan) -> BTreeSet<WalkNodeId> {
    let map = &plan.map;
    let mut left: BTreeSet<WalkNodeId> = (0..map.walk_nodes().len()).map(|index| WalkNodeId(index as u32)).collect();
    let mut best = BTreeSet::new();
    while let Some(first) = left.pop_first() {
        let (mut open, mut part) = (vec![first], BTreeSet::from([first]));
        while let Some(at) = open.pop() {
            let ends = map.walk_edges_at(at).iter().filter_map(|id| map.walk_edge(*id)).flat_map(|edge| edge.ends);
            open.extend(ends.filter(|node| left.remove(node)).inspect(|node| _ = part.insert(*node)));
        }
        if part.len() > best.len() {
            best = part;
        }
    }
    best
}

/// The kinds of places that so many residents need.
fn places(plan: &CityPlan, found: &mut Found) {
    let residents = plan.residents();
    let all: BTreeSet<UnitKind> = plan.buildings.iter().flat_map(|building| building.places.iter().copied()).collect();
    for kind in UnitKind::all().filter(|kind| kind.residents().is_some_and(|each| residents >= each)) {
        if !all.contains(&kind) {
            found.add(CityRule::PlaceMissing, CityPart::City, Point::origin(), kind.residents().unwrap_or(0.0));
        }
    }
}

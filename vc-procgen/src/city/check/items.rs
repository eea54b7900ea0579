//! Rules 15 and 16: things in their zone, and parked cars in bays.

use nalgebra::Vector2;
use vc_graph::portable::Portable;
use vc_map::Point;

use super::super::StreetItem;
use super::super::convex::Convex;
use super::super::near::Near;
use super::{CityPart, CityPlan, CityRule, Found};

const KERB: f64 = 0.45;
const FACADE: f64 = 2.5;
const LAMP: f64 = 4.5;
const DOORS: f64 = 0.6;

pub(super) fn check(plan: &CityPlan, found: &mut Found) {
    things(plan, found);
    trees(plan, found);
    cars(plan, found);
}

fn direction(heading: f64) -> Vector2<f64> {
    let (sine, cosine) = heading.sine_cosine();
    Vector2::new(cosine, sine)
}

fn things(plan: &CityPlan, found: &mut Found) {
    let places: Vec<Point> = plan.items.iter().map(|item| item.at).collect();
    let near = Near::of(&places);
    for (index, item) in plan.items.iter().enumerate() {
        let part = CityPart::Item(index);
        for other in near.around(&item.at, 6.0).filter(|other| *other > index) {
            let other = &plan.items[other];
            let gap = (other.at - item.at).norm() - item.radius - other.radius;
            if gap < 0.0 {
                found.add(CityRule::ItemsOverlap, part, item.at, gap);
            }
        }
        on_pavement(plan, part, item, found);
    }
}

/// A thing on its pavement: off the kerb, within the building line, facing the street.
fn on_pavement(plan: &CityPlan, part: CityPart, item: &StreetItem, found: &mut Found) {
    let Some(lane) = item.pavement.and_then(|id| plan.map.lane(id)) else { return };
    let Some(road) = plan.map.road(lane.road) else { return };
    let axis = road.line.project(&item.at);
    let kerb = road.draft.section.surface() / 2.0;
    let behind = axis.left.abs() - kerb;
    if behind - item.radius < KERB - 1e-6 {
        found.add(CityRule::ItemNearKerb, part, item.at, behind - item.radius);
    }
    if behind + item.radius > lane.width + 0.02 {
        found.add(CityRule::ItemOffPavement, part, item.at, behind + item.radius - lane.width);
    }
    let facing = direction(item.heading).dot(&(axis.point - item.at).normalize());
    if facing < 0.9 {
        found.add(CityRule::ItemFacesAway, part, item.at, facing);
    }
}

fn trees(plan: &CityPlan, found: &mut Found) {
    let walls: Vec<&Convex> =
        plan.buildings.iter().flat_map(|b| &b.wings).filter(|w| w.from == 0).map(|w| &w.plan).collect();
    let middles: Vec<Point> = walls.iter().map(|wall| wall.middle()).collect();
    let reach = walls
        .iter()
        .zip(&middles)
        .flat_map(|(wall, middle)| wall.corners().iter().map(move |p| (p - middle).norm()))
        .fold(0.0, f64::max);
    let near = Near::of(&middles);
    let lamps: Vec<Point> = plan.items.iter().filter(|item| item.class == "street_lamp").map(|item| item.at).collect();
    let lamps = (Near::of(&lamps), lamps);
    let streets = plan
        .items
        .iter()
        .enumerate()
        .filter(|(_, item)| item.class == "tree")
        .map(|(index, item)| (CityPart::Item(index), item.at));
    let parks = plan.parks.iter().flat_map(|park| park.trees.iter().map(|at| (CityPart::Block(park.block), *at)));
    let gardens = plan.trees.iter().map(|at| (CityPart::City, *at));
    for (part, at) in streets.chain(parks).chain(gardens) {
        for wall in near.around(&at, reach + FACADE) {
            let away = walls[wall].distance(&at);
            if away < FACADE {
                found.add(CityRule::TreeAtFacade, part, at, away);
            }
        }
        if let Some(lamp) = lamps.0.around(&at, LAMP).next() {
            found.add(CityRule::TreeAtLamp, part, at, (lamps.1[lamp] - at).norm());
        }
    }
}

fn cars(plan: &CityPlan, found: &mut Found) {
    let places: Vec<Point> = plan.cars.iter().map(|car| car.at).collect();
    let near = Near::of(&places);
    let bays: Vec<vc_map::Bay> = plan.map.bays().collect();
    let spots: Vec<Point> = bays.iter().map(|bay| bay.at).collect();
    let spots = Near::of(&spots);
    for (index, car) in plan.cars.iter().enumerate() {
        let part = CityPart::Car(index);
        let outline = car.outline();
        let aside = Vector2::new(-direction(car.heading).y, direction(car.heading).x);
        let inside = |bay: &vc_map::Bay| {
            let along = direction(bay.heading);
            let within = |corner: &Point| {
                (corner - bay.at).dot(&along).abs() <= bay.size[0] / 2.0 + 1e-6
                    && along.perp(&(corner - bay.at)).abs() <= bay.size[1] / 2.0 + 1e-6
            };
            outline.corners().iter().all(within)
        };
        if !spots.around(&car.at, 4.0).any(|bay| inside(&bays[bay])) {
            found.add(CityRule::CarOutsideBay, part, car.at, car.size[0]);
        }
        let mut free = [true; 2];
        for other in near.around(&car.at, 8.0).filter(|other| *other != index) {
            let shared = outline.shared(&plan.cars[other].outline());
            if shared > 1e-6 {
                found.add(CityRule::CarsOverlap, part, car.at, shared);
            }
            for (side, sign) in free.iter_mut().zip([-1.0, 1.0]) {
                let mut beside = *car;
                beside.at += aside * (sign * (car.size[1] + DOORS) / 2.0);
                beside.size = [car.size[0] * 0.6, DOORS];
                *side &= beside.outline().shared(&plan.cars[other].outline()) < 1e-6;
            }
        }
        if !free.contains(&true) {
            found.add(CityRule::CarDoorsShut, part, car.at, DOORS);
        }
    }
}

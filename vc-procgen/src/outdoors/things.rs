//! Things along streets, trees and parked cars, as the plan has them.

use vc_graph::Seed;
use vc_map::Point;

use super::stock::Stock;
use super::{KERB, Outdoors, Place, SMALL};
use crate::city::{Near, StreetItem};
use crate::item::Item;

/// Things that are lower are small, metres.
const TALL: f64 = 3.0;
/// The trees of streets, one kind along each; of gardens; and of parks.
const STREET: [&str; 3] = ["tree", "oak_tree", "birch_tree"];
const GARDEN: [&str; 5] = ["fruit_tree", "fruit_tree", "birch_tree", "tree", "pine_tree"];
const PARK: [&str; 4] = ["oak_tree", "tree", "birch_tree", "pine_tree"];

/// All of them within the reach of a place.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place, stock: &mut Stock<'_>) -> Vec<Item> {
    let city = outdoors.city;
    let mut items = Vec::new();
    for number in near(&outdoors.items, place) {
        let item = &city.items()[number];
        if item.height > TALL || place.distance(&item.at) < SMALL {
            let class = class(outdoors, item);
            // Lamps, bins and benches are alike along a road; each tree grew alone.
            let seed = if item.class == "tree" { stock.seed(class, &item.at) } else { along(outdoors, class, item) };
            items.extend(stock.instance((class, seed), &item.at, item.heading, 0.0));
        }
    }
    for number in near(&outdoors.trees, place) {
        let gardens = city.trees();
        let kinds: &[&str] = if number < gardens.len() { &GARDEN } else { &PARK };
        let parks = || city.parks().iter().flat_map(|park| &park.trees);
        let at: Option<&Point> = gardens.get(number).or_else(|| parks().nth(number - gardens.len()));
        let class = kinds[city.seed().child("tree").nth(number as u64).stream().below(kinds.len())];
        // Each is turned its own way.
        items.extend(at.and_then(|at| stock.instance((class, stock.seed(class, at)), at, number as f64, 0.0)));
    }
    for number in near(&outdoors.cars, place) {
        let car = &city.cars()[number];
        items.extend(stock.instance((car.class, stock.seed(car.class, &car.at)), &car.at, car.heading, -KERB));
    }
    items
}

/// The class of a thing of the plan in the catalogue.
fn class(outdoors: &Outdoors<'_>, item: &StreetItem) -> &'static str {
    match item.class {
        "tree" => STREET[along(outdoors, "trees", item).stream().below(STREET.len())],
        "bench" => "park_bench",
        class => class,
    }
}

/// The seed of what is alike along the road of a thing.
fn along(outdoors: &Outdoors<'_>, of: &str, item: &StreetItem) -> Seed {
    let lane = item.pavement.and_then(|lane| outdoors.city.map().lane(lane));
    outdoors.city.seed().child("along").child(of).nth(lane.map_or(0, |lane| u64::from(lane.road.0)))
}

fn near(all: &Near, place: &Place) -> Vec<usize> {
    let mut found: Vec<usize> = all.around(&place.at, place.reach).collect();
    found.sort_unstable();
    found
}

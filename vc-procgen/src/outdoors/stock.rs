//! Objects of classes along streets, in gardens and parks.

use std::collections::HashMap;
use std::sync::Arc;

use vc_graph::{Seed, State};
use vc_map::Point;
use vc_shapes::Object;
use vc_shapes::object::generator;

use super::{KERB, Outdoors, Place, SMALL};
use crate::circulation::parts::placed;
use crate::item::{Item, Support};

/// The trees of streets, one kind along each; of gardens; and of parks.
const STREET: [&str; 3] = ["tree", "oak_tree", "birch_tree"];
const GARDEN: [&str; 5] = ["fruit_tree", "fruit_tree", "birch_tree", "tree", "pine_tree"];
const PARK: [&str; 4] = ["oak_tree", "tree", "birch_tree", "pine_tree"];

/// The objects that a scene has, each made once.
struct Stock<'a> {
    outdoors: &'a Outdoors<'a>,
    made: HashMap<(&'static str, usize), Arc<Object>>,
}

impl Stock<'_> {
    /// An object of a class, drawn for a place.
    fn item(&mut self, class: &'static str, at: &Point, place: &Place, (yaw, z): (f64, f32)) -> Option<Item> {
        let maker = generator(class)?;
        let centimetres = [at.x, at.y].map(|metres| (metres * 100.0).round() as i64 as u64);
        let seed = centimetres.into_iter().fold(self.outdoors.city.seed().child(class), Seed::nth);
        let index = seed.stream().below(maker.instances.max(1));
        let made =
            self.made.entry((maker.class, index)).or_insert_with(|| Arc::new(maker.instance(Seed(0), index).object));
        let (x, y) = place.local(at);
        let item = placed(Object::clone(made), [x, y, z], yaw as f32, Support::Built);
        let is_lamp = maker.class == "street_lamp" && self.outdoors.are_lamps_on;
        Some(Item { object: made.clone(), states: is_lamp.then_some(State::On).into_iter().collect(), ..item })
    }
}

/// All of them within the reach of a place.
pub(super) fn items(outdoors: &Outdoors<'_>, place: &Place) -> Vec<Item> {
    let mut stock = Stock { outdoors, made: HashMap::new() };
    let city = outdoors.city;
    let mut items = Vec::new();
    for number in sorted(&outdoors.items, place, place.reach) {
        let item = &city.items()[number];
        let is_tall = item.height > 3.0;
        if !is_tall && place.distance(&item.at) > SMALL {
            continue;
        }
        let class = match item.class {
            "tree" => item.pavement.map_or(STREET[0], |lane| {
                let road = city.map().lane(lane).map_or(0, |lane| u64::from(lane.road.0));
                STREET[city.seed().child("trees").nth(road).stream().below(STREET.len())]
            }),
            "bench" => "park_bench",
            class => class,
        };
        items.extend(stock.item(class, &item.at, place, (item.heading, 0.0)));
    }
    for number in sorted(&outdoors.trees, place, place.reach) {
        let gardens = city.trees();
        let parks = || city.parks().iter().flat_map(|park| &park.trees);
        let (at, kinds): (Option<&Point>, &[&'static str]) = match gardens.get(number) {
            Some(at) => (Some(at), &GARDEN),
            None => (parks().nth(number - gardens.len()), &PARK),
        };
        let class = kinds[city.seed().child("tree").nth(number as u64).stream().below(kinds.len())];
        items.extend(at.and_then(|at| stock.item(class, at, place, (number as f64, 0.0))));
    }
    for number in sorted(&outdoors.cars, place, place.reach) {
        let car = &city.cars()[number];
        items.extend(stock.item(car.class, &car.at, place, (car.heading, -KERB)));
    }
    items
}

fn sorted(near: &crate::city::Near, place: &Place, within: f64) -> Vec<usize> {
    let mut found: Vec<usize> = near.around(&place.at, within).collect();
    found.sort_unstable();
    found
}

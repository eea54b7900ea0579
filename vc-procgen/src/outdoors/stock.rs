//! Objects of classes, each made once for a scene.

use std::collections::HashMap;
use std::sync::Arc;

use vc_graph::{Seed, State};
use vc_map::Point;
use vc_shapes::Object;
use vc_shapes::object::generator;

use super::{Outdoors, Place};
use crate::circulation::parts::{placed, shared};
use crate::item::{Item, Support};

/// The number of trees of a class of which one is drawn.
const TREES: usize = 100_000;

/// The objects of a scene.
pub(super) struct Stock<'a> {
    outdoors: &'a Outdoors<'a>,
    place: &'a Place,
    made: HashMap<(&'static str, usize), Arc<Object>>,
}

impl<'a> Stock<'a> {
    pub(super) fn new(outdoors: &'a Outdoors<'a>, place: &'a Place) -> Self {
        Self { outdoors, place, made: HashMap::new() }
    }

    /// The seed of what stands at a place: it goes by class and place alone.
    pub(super) fn seed(&self, class: &str, at: &Point) -> Seed {
        let centimetres = [at.x, at.y].map(|metres| (metres * 100.0).round() as i64 as u64);
        centimetres.into_iter().fold(self.outdoors.city.seed().child(class), Seed::nth)
    }

    /// An instance of the catalogue, drawn by a seed, at a place on the map, which faces a heading and stands at a height.
    pub(super) fn instance(&mut self, (class, seed): (&str, Seed), at: &Point, heading: f64, z: f32) -> Option<Item> {
        let maker = generator(class)?;
        // No two trees of a city grew alike; cars and bins come from few makers.
        let kinds = if class.ends_with("tree") { TREES } else { maker.instances.max(1) };
        let index = seed.stream().below(kinds);
        let made =
            self.made.entry((maker.class, index)).or_insert_with(|| Arc::new(maker.instance(Seed(0), index).object));
        let item = shared(made, self.place.point(at, z), heading as f32, Support::Built);
        let is_lit = maker.class == "street_lamp" && self.outdoors.are_lamps_on;
        Some(Item { states: is_lit.then_some(State::On).into_iter().collect(), ..item })
    }

    /// An object of a size: depth, width, height.
    pub(super) fn sized(&self, class: &str, size: [f32; 3], at: &Point, heading: f64) -> Option<Item> {
        let object = generator(class)?.sized(size.into(), &self.outdoors.style, self.seed(class, at));
        Some(placed(object, self.place.point(at, 0.0), heading as f32, Support::Built))
    }
}

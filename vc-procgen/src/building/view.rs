//! A storey as a whole, for drawings.

use super::measures::{DECK, LIFT, STAIRS, YARD};
use super::scene::Part;
use super::{Building, BuildingError};
use crate::apartment::Apartment;
use crate::area::{Area, Facing};
use crate::item::Item;

/// Everything on a storey, in its frame.
pub(crate) struct StoreyView {
    /// The ground that it takes.
    pub(crate) ground: Area,
    /// The homes, each with its turn and its origin.
    pub(crate) homes: Vec<(Apartment, Facing, (f32, f32))>,
    /// All that is not in homes.
    pub(crate) items: Vec<Item>,
    /// The names of regions, and where to write them.
    pub(crate) names: Vec<(&'static str, [f32; 2])>,
}

impl Building {
    pub(crate) fn storey_view(&self, storey: usize) -> Result<StoreyView, BuildingError> {
        let storeys = self.places.len();
        let places = self.places.get(storey).ok_or(BuildingError::NoStorey { storey, storeys })?;
        let mut homes = Vec::new();
        for (side, place) in places.iter().enumerate() {
            homes.push((self.home(storey, side)?, place.turn, place.origin));
        }
        let tower = Area { y1: STAIRS.area().y1, ..DECK };
        let mut items = self.items(Part::Gallery(storey));
        let mut names = vec![("Gallery", [0.0, DECK.centre().1])];
        let mut ground = places.iter().flat_map(|place| place.outline.iter().copied()).fold(tower, Area::around_both);
        if storey == 0 {
            let cabin = self.items(Part::Cabin).into_iter();
            items.extend(cabin.map(|item| item.moved([LIFT, DECK.y1, 0.0])));
            items.extend(self.items(Part::Yard));
            names.extend([("Lift", [LIFT, DECK.y1 + 1.0]), ("Yard", [YARD.centre().0, YARD.centre().1])]);
            ground = ground.around_both(YARD);
        }
        Ok(StoreyView { ground, homes, items, names })
    }
}

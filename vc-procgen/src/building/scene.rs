//! The scenes of a building's regions, each made from its seed and its part of the plan.

use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::space::RegionId;
use vc_graph::{Draft, SceneBuilder, SceneGraph};

use super::error::BuildingError;
use super::gallery::{self, Gallery};
use super::measures::{CLEAR, DECK, PLOT, STAIRS, YARD};
use super::{Building, yard};
use crate::apartment::Apartment;
use crate::area::Area;
use crate::circulation::cabin::{self, CABIN};
use crate::circulation::parts::Maker;
use crate::item::Item;
use crate::scene::{Contents, room_draft};

/// A part of a building that has a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// A home: its storey, and 0 in the west or 1 in the east.
    Home(usize, usize),
    Gallery(usize),
    Cabin,
    Yard,
}

/// A region of a single room.
struct Shared {
    name: String,
    room: Draft,
    items: Vec<Item>,
    names: Vec<(usize, Arc<str>)>,
}

impl Building {
    /// The scene of a region, as it is made: the same whenever it is asked for, whatever else was. Costs some
    /// milliseconds for a home.
    ///
    /// # Errors
    /// [`BuildingError::NoScene`] for groups and for regions that the building does not have.
    pub fn scene(&self, region: RegionId) -> Result<SceneGraph, BuildingError> {
        let part = self.part(region).zip(self.space().region(region).map(|region| region.numbers));
        let (part, numbers) = part.ok_or(BuildingError::NoScene(region))?;
        if let Part::Home(storey, side) = part {
            return Ok(self.home(storey, side)?.scene_numbered(numbers));
        }
        let shared = self.shared(part);
        let mut builder = SceneBuilder::new(shared.name);
        builder.numbers(numbers);
        let (rooms, items) = (vec![shared.room], shared.items.as_slice());
        Ok(Contents { first: numbers.first, rooms, items, names: &shared.names }.scene(builder))
    }

    pub(super) fn part(&self, region: RegionId) -> Option<Part> {
        let shared = [(self.cabin(), Part::Cabin), (self.yard(), Part::Yard)];
        let storeys = self.storeys().iter().enumerate().flat_map(|(number, storey)| {
            let homes = [0, 1].map(|side| (storey.homes[side], Part::Home(number, side)));
            homes.into_iter().chain([(storey.gallery, Part::Gallery(number))])
        });
        shared.into_iter().chain(storeys).find(|(id, _)| *id == region).map(|(_, part)| part)
    }

    /// A home, made anew.
    pub(super) fn home(&self, storey: usize, side: usize) -> Result<Apartment, BuildingError> {
        Ok(Apartment::generate(&self.wishes.homes, self.places[storey][side].seed)?)
    }

    /// The gallery of a storey.
    fn gallery(&self, storey: usize) -> Gallery {
        let bridges = self.places[storey].each_ref().map(|place| place.bridge);
        Gallery { ground: storey == 0, top: storey + 1 == self.places.len(), bridges }
    }

    /// The items of a part; those of a home are not made here.
    pub(super) fn items(&self, part: Part) -> Vec<Item> {
        let maker = Maker { style: &self.looks.style, seed: self.seed.child("parts") };
        match part {
            Part::Home(..) => Vec::new(),
            Part::Gallery(storey) => self.gallery(storey).items(&self.looks, maker),
            Part::Cabin => cabin::items(self.places.len(), &self.looks, maker),
            Part::Yard => yard::items(&self.plot(), &self.built_on(), maker),
        }
    }

    /// The ground on which the building stands, with the yard.
    pub(super) fn plot(&self) -> Area {
        let homes = self.places.iter().flatten().flat_map(|place| place.outline.iter().copied());
        let tower = Area { y1: STAIRS.area().y1, ..DECK };
        homes.chain([tower, YARD]).reduce(Area::around_both).unwrap_or(YARD).grown(PLOT)
    }

    /// Where homes and the gallery on the ground and the yard cover it.
    fn built_on(&self) -> Vec<Area> {
        let homes = self.places.first().into_iter().flatten();
        let parts = homes.flat_map(|place| place.outline.iter().copied().chain([place.bridge]));
        parts.chain([DECK, YARD]).collect()
    }

    fn shared(&self, part: Part) -> Shared {
        let items = self.items(part);
        let floor = items.get(gallery::FLOOR).map_or(Area::default(), Item::area);
        let (name, room, names) = match part {
            Part::Gallery(storey) => (format!("gallery {storey}"), standing("gallery", &floor, CLEAR), Vec::new()),
            Part::Cabin => {
                ("lift".into(), standing("lift", &cabin::within(), CABIN[2]), cabin::names(self.places.len()))
            }
            Part::Home(..) | Part::Yard => ("yard".into(), standing("garden", &YARD, CLEAR), Vec::new()),
        };
        Shared { name, room, items, names }
    }
}

fn standing(class: &'static str, floor: &Area, height: f32) -> Draft {
    let ((x, y), (width, depth)) = (floor.centre(), floor.size());
    room_draft(class, Vector3::new(x, y, 0.0), Vector3::new(width, depth, height))
}

//! The scenes of a house's regions, each made from its seed and its part of the plan.

use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::space::RegionId;
use vc_graph::{Draft, SceneBuilder, SceneGraph};

use super::House;
use super::error::HouseError;
use super::landing::Landing;
use super::street;
use crate::apartment::Apartment;
use crate::area::Area;
use crate::circulation::cabin::{self, CABIN};
use crate::circulation::parts::Maker;
use crate::item::Item;
use crate::scene::{Contents, room_draft};
use crate::specification::Specification;

/// A part of a house that has a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    /// A flat: its storey, and its place there.
    Flat(usize, usize),
    Landing(usize),
    Cabin,
    Street,
}

impl House {
    /// The scene of a region, as it is made: the same whenever it is asked for, whatever else was. Costs some
    /// milliseconds for a flat.
    ///
    /// # Errors
    /// [`HouseError::NoScene`] for groups and for regions that the house does not have; [`HouseError::Flat`] for a flat that cannot be
    /// furnished.
    pub fn scene(&self, region: RegionId) -> Result<SceneGraph, HouseError> {
        let part = self.part(region).zip(self.space().region(region).map(|region| region.numbers));
        let (part, numbers) = part.ok_or(HouseError::NoScene(region))?;
        if let Part::Flat(storey, place) = part {
            return Ok(self.flat(storey, place)?.scene_numbered(numbers));
        }
        let (name, room, items) = self.shared(part);
        let names = if part == Part::Cabin { cabin::names(self.flats.len()) } else { Vec::<(usize, Arc<str>)>::new() };
        let mut builder = SceneBuilder::new(name);
        builder.numbers(numbers);
        Ok(Contents { first: numbers.first, rooms: vec![room], items: &items, names: &names }.scene(builder))
    }

    fn part(&self, region: RegionId) -> Option<Part> {
        let shared = [(self.cabin(), Part::Cabin), (self.street(), Part::Street)];
        let storeys = self.storeys().iter().enumerate().flat_map(|(number, storey)| {
            let flats = storey.homes.iter().enumerate().map(move |(place, home)| (*home, Part::Flat(number, place)));
            flats.chain([(storey.landing, Part::Landing(number))])
        });
        shared.into_iter().chain(storeys).find(|(id, _)| *id == region).map(|(_, part)| part)
    }

    fn flat(&self, storey: usize, place: usize) -> Result<Apartment, HouseError> {
        let flat = &self.flats[storey][place];
        let wishes = Specification { plan: Some(flat.plan.clone()), ..self.wishes.clone() };
        Ok(Apartment::generate(&wishes, flat.seed)?)
    }

    /// The name, the room and the items of what is not in flats.
    fn shared(&self, part: Part) -> (String, Draft, Vec<Item>) {
        let maker = Maker { style: &self.looks.style, seed: self.seed.child("parts") };
        let measures = &self.measures;
        match part {
            Part::Landing(storey) => {
                let landing = Landing { measures, storey, flats: &self.flats[storey], looks: &self.looks, maker };
                let all = measures.corridor.around_both(Area { y1: measures.facade, ..measures.well() });
                let clear = measures.heights[storey].clear;
                (format!("landing {storey}"), standing("hallway", &all, clear), landing.items())
            }
            Part::Cabin => {
                let items = cabin::items(self.flats.len(), &self.looks, maker);
                ("lift".into(), standing("lift", &cabin::within(), CABIN[2]), items)
            }
            Part::Flat(..) | Part::Street => {
                let (ground, items) = street::items(measures, (&self.flats, &self.fronts), &self.facade, maker);
                ("street".into(), standing("street", &ground, street::CLEAR), items)
            }
        }
    }
}

fn standing(class: &'static str, floor: &Area, height: f32) -> Draft {
    let ((x, y), (width, depth)) = (floor.centre(), floor.size());
    room_draft(class, Vector3::new(x, y, 0.0), Vector3::new(width, depth, height))
}

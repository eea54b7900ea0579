//! Streets as one sees them: the ground, what is painted on it, buildings from outside, and all that stands along the way.
//!
//! [`ground`] makes carriageways, pavements, land and parks, [`paint`] the markings, [`mass`] buildings; [`things`], [`park`] and
//! [`garden`] what stands there, out of one [`stock`]. All of it follows from the [plan](crate::city::CityPlan) and the place alone.

mod error;
mod garden;
mod ground;
mod mass;
mod paint;
mod park;
mod stock;
mod strip;
mod things;

use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::{SceneBuilder, SceneGraph};
use vc_map::{Marking, Point};
use vc_shapes::Style;

use crate::circulation::parts::P;
use crate::city::{CityPlan, Near};
use crate::item::Item;
use crate::scene::{Contents, room_draft};

use stock::Stock;

pub use error::OutdoorsError;

/// The coordinates that a place has at most, metres.
const FAR: f64 = 1e6;
/// The greatest reach of a scene, metres.
const FARTHEST: f64 = 2_000.0;
/// Small things farther than this are left out, metres: a bin has two pixels there.
const SMALL: f64 = 160.0;
/// How high a kerb is, metres: pavements and land are at height zero, carriageways so much lower.
pub(crate) const KERB: f32 = 0.12;
/// The height of the space in which things belong to the street, metres: light above it is that of the open.
const HIGH: f32 = 3.0;

/// The streets of a city and all that stands along them, as scenes of the surroundings of a place.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::Outdoors;
/// use vc_procgen::city::{CityPlan, CitySpecification};
/// let city = CityPlan::generate(&CitySpecification { area: 0.2, ..CitySpecification::default() }, Seed(7))?;
/// let outdoors = Outdoors::of(&city);
/// // All within 40 metres of the middle of a street.
/// let at = city.streets()[3].line[0];
/// let scene = outdoors.scene(&at, 40.0)?;
/// assert!(scene.validate().is_empty());
/// assert!(!scene.of_class("street_lamp").is_empty() && !scene.of_class("pavement").is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Outdoors<'a> {
    city: &'a CityPlan,
    style: Style,
    are_lamps_on: bool,
    blocks: Placed,
    buildings: Placed,
    roads: Placed,
    markings: Vec<Marking>,
    painted: Placed,
    items: Near,
    cars: Near,
    trees: Near,
}

/// Things with their middles and how far they reach from there.
struct Placed {
    near: Near,
    reach: Vec<f64>,
    most: f64,
}

impl Placed {
    /// Those of some sets of corners.
    fn of<'a>(all: impl Iterator<Item = &'a [Point]>) -> Self {
        let (mut middles, mut reach) = (Vec::new(), Vec::new());
        for corners in all {
            let sum = corners.iter().fold(Vector3::zeros(), |sum, at| sum + Vector3::new(at.x, at.y, 1.0));
            let middle = Point::new(sum.x / sum.z.max(1.0), sum.y / sum.z.max(1.0));
            reach.push(corners.iter().map(|at| (at - middle).norm()).fold(0.0, f64::max));
            middles.push(middle);
        }
        let most = reach.iter().copied().fold(0.0, f64::max);
        Self { near: Near::of(&middles), reach, most }
    }

    /// The numbers of those that may be nearer to a point than so many metres, in order.
    fn around(&self, at: &Point, within: f64) -> Vec<usize> {
        let mut found: Vec<usize> = self
            .near
            .found(at, within + self.most)
            .filter(|(number, away)| away - self.reach[*number] <= within)
            .map(|(number, _)| number)
            .collect();
        found.sort_unstable();
        found
    }
}

impl<'a> Outdoors<'a> {
    /// The streets of a city. Costs an index of its parts: microseconds for each.
    pub fn of(city: &'a CityPlan) -> Self {
        let outlines: Vec<Vec<Point>> = city
            .buildings()
            .iter()
            .map(|house| house.wings.iter().flat_map(|wing| wing.plan.corners().to_vec()).collect())
            .collect();
        let gardens = city.trees().iter();
        let markings = city.map().markings();
        Self {
            city,
            style: Style::from_seed(city.seed().child("outdoors")),
            are_lamps_on: false,
            blocks: Placed::of(city.blocks().iter().map(|block| block.face.corners())),
            buildings: Placed::of(outlines.iter().map(Vec::as_slice)),
            roads: Placed::of(city.map().roads().iter().map(|road| road.line.points())),
            painted: Placed::of(markings.iter().map(|marking| marking.points.as_slice())),
            markings,
            items: Near::of(city.items().iter().map(|item| &item.at)),
            cars: Near::of(city.cars().iter().map(|car| &car.at)),
            trees: Near::of(gardens.chain(city.parks().iter().flat_map(|park| &park.trees))),
        }
    }

    /// The same with its street lamps on, or off as they are at first.
    #[must_use]
    pub fn lamps(self, are_on: bool) -> Self {
        Self { are_lamps_on: are_on, ..self }
    }

    /// A scene of all that is within so many metres of a place: its origin is that place, X goes east, Y north, and pavements
    /// are at height zero. All that is farther is left out, windows farther than 60 m lie flat on their walls, and small things end at 160 m.
    ///
    /// Costs some milliseconds for each building near, and some for each object that has not been made before.
    ///
    /// # Errors
    /// [`OutdoorsError::Reach`] and [`OutdoorsError::Place`] for what is no number or too far.
    pub fn scene(&self, at: &Point, reach: f64) -> Result<SceneGraph, OutdoorsError> {
        if !(reach > 0.0 && reach <= FARTHEST) {
            return Err(OutdoorsError::Reach(reach));
        }
        if !(at.x.abs() < FAR && at.y.abs() < FAR) {
            return Err(OutdoorsError::Place(at.x, at.y));
        }
        let place = Place { at: *at, reach };
        let mut items: Vec<Item> = Vec::new();
        items.extend(ground::items(self, &place));
        items.extend(paint::items(self, &place));
        items.extend(
            self.buildings.around(at, reach).into_iter().flat_map(|building| mass::items(self, &place, building)),
        );
        let mut stock = Stock::new(self, &place);
        items.extend(things::items(self, &place, &mut stock));
        items.extend(park::items(self, &place, &mut stock));
        items.extend(garden::items(self, &place, &stock));
        let half = reach as f32;
        let room = room_draft("street", Vector3::zeros(), Vector3::new(2.0 * half, 2.0 * half, HIGH));
        let name = format!("city_{}", self.city.seed().0);
        let names: &[(usize, Arc<str>)] = &[];
        Ok(Contents { first: 0, rooms: vec![room], items: &items, names }.scene(SceneBuilder::new(name)))
    }
}

/// The place of a scene on the map.
struct Place {
    at: Point,
    reach: f64,
}

impl Place {
    fn local(&self, at: &Point) -> (f32, f32) {
        ((at.x - self.at.x) as f32, (at.y - self.at.y) as f32)
    }

    fn point(&self, at: &Point, z: f32) -> P {
        let (x, y) = self.local(at);
        [x, y, z]
    }

    fn distance(&self, at: &Point) -> f64 {
        (at - self.at).norm()
    }
}

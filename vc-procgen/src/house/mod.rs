//! Houses of flats: a building of a [city's plan](crate::city::CityPlan) as regions. A hall with stairs and a lift leads to the
//! flats, and a door to the street.
//!
//! [`measures`] says where stairs, lift and corridor are, [`plan`] which regions there are and how they are joined; [`landing`] and
//! [`street`] make what is not in flats.

mod check;
mod error;
mod flat;
mod landing;
mod measures;
mod plan;
mod scene;
mod street;
mod wall;

use std::sync::Arc;

use vc_graph::space::{PortalId, RegionId, Space};
use vc_graph::{NodeId, Seed};

use crate::circulation::Looks;
use crate::city::CityPlan;
use crate::facade::{Facade, Pane};
use crate::specification::Specification;
use flat::Flat;
use measures::Measures;
use plan::Plan;

pub use error::HouseError;
pub use plan::HouseStorey;

/// A house of flats that stands in a city's plan.
///
/// It keeps plans and seeds, not scenes: some kilobytes a flat. Its windows are those of the plan's facades.
///
/// ```
/// use vc_graph::Seed;
/// use vc_procgen::House;
/// let house = House::from_seed(Seed(7))?;
/// let flat = house.storeys()[1].homes[0];
/// let scene = house.scene(flat)?;
/// assert!(scene.nodes().any(|node| node.class().as_ref() == "main_door"));
/// // The hall on the ground, with the door to the street.
/// assert!(house.scene(house.storeys()[0].landing)?.node(house.street_door()).is_some());
/// # Ok::<(), vc_procgen::HouseError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct House {
    seed: Seed,
    wishes: Specification,
    measures: Measures,
    plan: Plan,
    /// The flats of each storey.
    flats: Vec<Vec<Flat>>,
    /// Windows and doors of what has no interior.
    fronts: Vec<(usize, Pane)>,
    looks: Looks,
    facade: Facade,
}

impl House {
    /// The first house of flats in a small city of a seed: `house/SEED` by name. Costs that city's plan, some tens of milliseconds.
    ///
    /// # Errors
    /// As [`Self::of`]; no seed is known that fails.
    pub fn from_seed(seed: Seed) -> Result<Self, HouseError> {
        let wishes = crate::city::CitySpecification { area: AREA, ..Default::default() };
        let city = CityPlan::generate(&wishes, seed)?;
        let mut found = (0..city.buildings().len()).map(|building| Self::of(&city, building));
        found.find(Result::is_ok).unwrap_or(Err(HouseError::None))
    }

    /// A building of a city's plan, if it is one wing with flats. Costs the plans of its flats: some tenths of a millisecond for
    /// each of a storey.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::city::{CityPlan, CitySpecification};
    /// use vc_procgen::{House, HouseError};
    /// let city = CityPlan::generate(&CitySpecification { area: 0.2, ..CitySpecification::default() }, Seed(7))?;
    /// let houses = (0..city.buildings().len()).filter(|&building| House::of(&city, building).is_ok());
    /// assert!(houses.count() > 10);
    /// assert_eq!(House::of(&city, 100_000).unwrap_err(), HouseError::NoBuilding(100_000));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`HouseError`] says what is missing.
    pub fn of(city: &CityPlan, building: usize) -> Result<Self, HouseError> {
        let house = city.buildings().get(building).ok_or(HouseError::NoBuilding(building))?;
        let seed = city.seed().child("house").nth(building as u64);
        let measures = Measures::of(house, building)?;
        let flats: Vec<Vec<Flat>> =
            (0..house.storeys).map(|storey| Flat::all(city, building, storey, &measures)).collect();
        if flats.iter().all(Vec::is_empty) {
            return Err(HouseError::NoFlats(building));
        }
        let plan = Plan::new(&format!("house/{building}"), &measures, &flats)?;
        let fronts = street::fronts(house, |unit| city.flat(building, unit).is_some(), &measures);
        let facade = Facade::of(city, building);
        let wishes = Specification { facade: Some(facade.wall), ..Specification::default() };
        Ok(Self { seed, wishes, measures, plan, flats, fronts, looks: Looks::new(seed.child("looks")), facade })
    }

    /// The plan of its regions and portals.
    pub fn space(&self) -> &Arc<Space> {
        &self.plan.space
    }

    /// Its storeys, from the ground up.
    pub fn storeys(&self) -> &[HouseStorey] {
        &self.plan.storeys
    }

    /// The cabin of the lift, a region that moves: stop `n` is storey `n`.
    pub fn cabin(&self) -> RegionId {
        self.plan.cabin
    }

    /// The pavement around the house.
    pub fn street(&self) -> RegionId {
        self.plan.street
    }

    /// The leaf of the door between hall and street.
    pub fn street_door(&self) -> NodeId {
        self.plan.street_door
    }

    /// The portal between hall and street.
    pub fn entrance(&self) -> PortalId {
        self.plan.entrance
    }
}

/// The area of the city whose first house is taken, square kilometres.
const AREA: f64 = 0.2;

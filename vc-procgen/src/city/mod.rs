//! Plans of cities from a seed: streets, blocks, parcels, buildings with their units, and what stands outdoors.
//!
//! [`CityPlan::from_seed`] plans a square kilometre with some 15,000 residents, [`CityPlan::generate`] one for a
//! [`CitySpecification`]. Its streets are a [`vc_map::StreetMap`] with lanes, junctions, lights and a walkable network, so
//! that all that maps can do works for it: routes, SUMO, OpenDRIVE. [`CityPlan::violations`] checks the rules that cities
//! keep from the plan's geometry alone, [`CityPlan::figures`] puts its figures beside those of real cities, and
//! [`CityPlan::drawing`] and [`CityPlan::text`] let one look into it.
//!
//! ```
//! use vc_procgen::city::{CityPlan, CitySpecification};
//! let wishes = CitySpecification { area: 0.3, ..CitySpecification::default() };
//! let plan = CityPlan::generate(&wishes, vc_graph::Seed(7))?;
//! assert_eq!(plan.violations(), []);
//! // A unit is worked out when somebody asks for it, always the same.
//! let house = plan.buildings().iter().find(|building| building.homes() > 4).ok_or("a house")?;
//! let home = &house.units(1)[0];
//! assert!(home.outline.area() > 20.0 && !home.windows.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Faces of the network of streets are cut in two until each is a block, the largest first: the first cuts become main
//! streets, the last ones lanes. Cuts follow a field of directions, a grid or rays and rings, and are straight from side to
//! side, so that all faces stay convex, and with them blocks, parcels and the wings of buildings. The contents (classes of
//! streets, types of buildings, kinds of units, things along pavements) are tables in `vc-procgen/data`.

mod block;
mod building;
mod building_type;
mod check;
mod convex;
mod edge;
mod error;
mod face;
mod field;
mod figures;
mod flat;
mod floor;
mod garden;
mod generate;
mod item;
mod near;
mod net;
mod outline;
mod parcel;
mod park;
mod parked;
mod picture;
mod places;
mod specification;
mod storey;
mod street;
mod street_class;
mod text;
mod unit_kind;
mod view;
mod window;
mod wing;
mod zone;

pub use block::CityBlock;
pub use building::{CityBuilding, StreetDoor, Unit};
pub use building_type::BuildingType;
pub use check::{CityPart, CityRule, CityViolation};
pub(crate) use convex::left;
pub use convex::{Beyond, Convex};
pub use edge::{Railway, Shore};
pub use error::CityPlanError;
pub use field::StreetPattern;
pub use figures::CityFigure;
pub use flat::FlatPlan;
pub(crate) use floor::{CORE, CORRIDOR, Core};
pub use item::{StreetItem, TrafficSign};
pub(crate) use near::Near;
pub use park::{Park, ParkFeature};
pub use parked::ParkedCar;
pub use specification::{CitySpecification, Waterside};
pub use street::Street;
pub use street_class::StreetClass;
pub use unit_kind::{UnitKind, UnitPlace};
pub use window::WindowSlot;
pub use wing::Wing;
pub use zone::CityZone;

use vc_graph::Seed;
use vc_map::{Point, StreetMap};

/// A piece of a block with one owner.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Parcel {
    /// Its block, by its position in [`CityPlan::blocks`].
    pub block: usize,
    /// Its land.
    pub land: Convex,
}

/// A city before anybody builds it: streets, blocks, parcels, buildings with their units.
#[derive(Debug, Clone, PartialEq)]
pub struct CityPlan {
    seed: Seed,
    pattern: StreetPattern,
    outline: Vec<Point>,
    map: StreetMap,
    streets: Vec<Street>,
    blocks: Vec<CityBlock>,
    parcels: Vec<Parcel>,
    buildings: Vec<CityBuilding>,
    parks: Vec<Park>,
    shore: Option<Shore>,
    railway: Option<Railway>,
    items: Vec<StreetItem>,
    cars: Vec<ParkedCar>,
    trees: Vec<Point>,
}

impl CityPlan {
    /// The seed that it was generated from.
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// The pattern of its streets.
    pub fn pattern(&self) -> StreetPattern {
        self.pattern
    }

    /// Its streets as a map.
    pub fn map(&self) -> &StreetMap {
        &self.map
    }

    /// Its streets.
    pub fn streets(&self) -> &[Street] {
        &self.streets
    }

    /// Its blocks.
    pub fn blocks(&self) -> &[CityBlock] {
        &self.blocks
    }

    /// Its parcels, block by block.
    pub fn parcels(&self) -> &[Parcel] {
        &self.parcels
    }

    /// Its buildings.
    pub fn buildings(&self) -> &[CityBuilding] {
        &self.buildings
    }

    /// Its parks.
    pub fn parks(&self) -> &[Park] {
        &self.parks
    }

    /// The land at the water.
    pub fn shore(&self) -> Option<&Shore> {
        self.shore.as_ref()
    }

    /// Its railway.
    pub fn railway(&self) -> Option<&Railway> {
        self.railway.as_ref()
    }

    /// The things along its streets, trees among them.
    pub fn items(&self) -> &[StreetItem] {
        &self.items
    }

    /// Its parked cars.
    pub fn cars(&self) -> &[ParkedCar] {
        &self.cars
    }

    /// The trees of its gardens and courts; those of parks and streets are theirs.
    pub fn trees(&self) -> &[Point] {
        &self.trees
    }

    /// The number of its residents, on average. Costs the floors of all buildings.
    pub fn residents(&self) -> f64 {
        self.buildings.iter().map(CityBuilding::residents).sum()
    }
}

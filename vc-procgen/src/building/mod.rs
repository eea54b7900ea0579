//! Small buildings: homes on storeys, joined by open galleries, stairs and a lift, with a yard.
//!
//! A building is a plan of regions, [`Building::space`], and makes the scene of each when it is asked for.

mod check;
mod error;
mod gallery;
mod measures;
mod place;
mod plan;
mod scene;
mod specification;
mod view;
mod violation;
mod yard;

use std::sync::Arc;

use vc_graph::space::{PortalId, RegionId, Space};
use vc_graph::{NodeId, Seed};

use place::Place;
use plan::Plan;

use crate::circulation::Looks;

pub(crate) use check::{overlaps, sound};
pub use error::BuildingError;
pub use plan::BuildingStorey;
pub use specification::BuildingSpecification;
pub(crate) use view::StoreyView;
pub use violation::BuildingViolation;

/// A building: two homes on each storey around an open gallery, stairs and a lift, a yard on the ground.
///
/// It keeps the plan and the seeds of its homes, not their scenes: some kilobytes.
///
/// ```
/// use vc_graph::Seed;
/// use vc_graph::space::RegionGraphs;
/// use vc_procgen::Building;
/// let building = Building::from_seed(Seed(7))?;
/// let storey = &building.storeys()[2];
/// let [west, _] = storey.homes;
/// // The home and the gallery before its door, each a scene of its own.
/// let mut world = RegionGraphs::new(building.space().clone());
/// for region in [west, storey.gallery] {
///     world.insert(region, building.scene(region)?)?;
/// }
/// let door = building.space().portal(storey.front_doors[0]).ok_or("planned")?;
/// assert_eq!(world.label(door.leaf.ok_or("a door")?).class.as_ref(), "main_door");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Building {
    seed: Seed,
    wishes: BuildingSpecification,
    plan: Plan,
    places: Vec<[Place; 2]>,
    looks: Looks,
}

impl Building {
    /// Generates a building of three storeys from a seed.
    ///
    /// # Errors
    /// As [`Self::generate`]; no seed is known that fails.
    pub fn from_seed(seed: Seed) -> Result<Self, BuildingError> {
        Self::generate(&BuildingSpecification::default(), seed)
    }

    /// Generates a building for a specification. Costs its homes, which are generated to find their front doors: some
    /// tens of milliseconds.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::{Building, BuildingSpecification};
    /// let wishes = BuildingSpecification { storeys: 4, ..BuildingSpecification::default() };
    /// let building = Building::generate(&wishes, Seed(1))?;
    /// assert_eq!(building.storeys().len(), 4);
    /// // Four galleries with two homes each, the lift and the yard.
    /// assert_eq!(building.space().regions().filter(|(_, region)| region.has_scene()).count(), 14);
    /// # Ok::<(), vc_procgen::BuildingError>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildingError`] states the requirement that cannot be fulfilled.
    pub fn generate(specification: &BuildingSpecification, seed: Seed) -> Result<Self, BuildingError> {
        specification.check()?;
        let homes = seed.child("homes");
        let place = |storey: u64, side: u64| Place::find(&specification.homes, homes.nth(2 * storey + side), side == 1);
        let storeys = (0..specification.storeys as u64).map(|storey| Ok([place(storey, 0)?, place(storey, 1)?]));
        let places = storeys.collect::<Result<Vec<_>, BuildingError>>()?;
        let plan = Plan::new(&format!("building/{}", seed.0), specification, &places)?;
        let looks = Looks::new(seed.child("looks"));
        Ok(Self { seed, wishes: specification.clone(), plan, places, looks })
    }

    /// The seed that it was generated from.
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// The plan of its regions and portals.
    pub fn space(&self) -> &Arc<Space> {
        &self.plan.space
    }

    /// Its storeys, from the ground up.
    pub fn storeys(&self) -> &[BuildingStorey] {
        &self.plan.storeys
    }

    /// The cabin of the lift, a region that moves: stop `n` is storey `n`.
    pub fn cabin(&self) -> RegionId {
        self.plan.cabin
    }

    /// The door of the cabin, in its scene.
    pub fn cabin_door(&self) -> NodeId {
        self.plan.cabin_door
    }

    /// The yard.
    pub fn yard(&self) -> RegionId {
        self.plan.yard
    }

    /// The passage from the gallery on the ground to the yard.
    pub fn gate(&self) -> PortalId {
        self.plan.gate
    }
}

//! The scenes of regions, by whoever makes them.

use std::collections::BTreeMap;
use std::error::Error;
use std::sync::Arc;

use vc_graph::space::{Region, RegionId, RegionKind, Space};
use vc_graph::{SceneGraph, Seed};
use vc_procgen::{Apartment, Building, House};

use super::CityError;

/// A plan of regions, and the scene of each when somebody comes there: implement it for a generator of your own.
///
/// A scene is the same whenever it is asked for, and its nodes have numbers of the region's
/// [block](vc_graph::space::Region::numbers).
///
/// ```
/// use std::error::Error;
/// use std::sync::Arc;
/// use virtualcity::RegionScenes;
/// use virtualcity::graph::space::{Region, RegionId, RegionKind, Space};
/// use virtualcity::graph::{SceneGraph, Seed};
/// use virtualcity::procgen::Apartment;
///
/// /// A single home.
/// struct Home(Arc<Space>);
///
/// impl RegionScenes for Home {
///     fn space(&self) -> &Arc<Space> {
///         &self.0
///     }
///
///     fn scene(&self, _: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
///         Ok(Apartment::from_seed(Seed(42))?.scene())
///     }
/// }
///
/// let home = Home(Arc::new(Space::single(Region::new(RegionKind::Unit, "apartment/42"))?));
/// let city = virtualcity::City::of(home).agents(2).make()?;
/// assert_eq!(city.agents().count(), 2);
/// # Ok::<(), Box<dyn Error>>(())
/// ```
pub trait RegionScenes: Send + Sync + 'static {
    /// The plan.
    fn space(&self) -> &Arc<Space>;

    /// The scene of a region, as it is before anybody has been there.
    ///
    /// # Errors
    /// Any reason for which it cannot be made.
    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>>;
}

impl RegionScenes for Building {
    fn space(&self) -> &Arc<Space> {
        self.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        Ok(self.scene(region)?)
    }
}

impl RegionScenes for House {
    fn space(&self) -> &Arc<Space> {
        self.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        Ok(self.scene(region)?)
    }
}

/// Why a scene cannot be made.
pub(super) type SceneFault = Box<dyn Error + Send + Sync>;

/// The scenes of some regions as they were once made, of the others as they are made now.
pub(super) struct Known {
    pub(super) known: BTreeMap<RegionId, SceneGraph>,
    pub(super) others: Arc<dyn RegionScenes>,
}

impl RegionScenes for Known {
    fn space(&self) -> &Arc<Space> {
        self.others.space()
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, SceneFault> {
        self.known.get(&region).map_or_else(|| self.others.scene(region), |scene| Ok(scene.clone()))
    }
}

/// A single generated home.
struct Home {
    seed: Seed,
    space: Arc<Space>,
}

impl RegionScenes for Home {
    fn space(&self) -> &Arc<Space> {
        &self.space
    }

    fn scene(&self, _: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        Ok(Apartment::from_seed(self.seed)?.scene())
    }
}

/// The regions of a name: `building/SEED`, `house/SEED`, or `apartment/SEED` for a home as the only region.
pub(super) fn named(name: &str) -> Result<Arc<dyn RegionScenes>, CityError> {
    let unknown = || CityError::Name(name.to_owned());
    let (kind, seed) = name.split_once('/').ok_or_else(unknown)?;
    let is_number = seed.bytes().all(|byte| byte.is_ascii_digit());
    let seed = Seed(seed.parse().ok().filter(|_| is_number).ok_or_else(unknown)?);
    match kind {
        "building" => Ok(Arc::new(Building::from_seed(seed).map_err(|why| CityError::Generation(Arc::new(why)))?)),
        "house" => Ok(Arc::new(House::from_seed(seed).map_err(|why| CityError::Generation(Arc::new(why)))?)),
        "apartment" => Ok(Arc::new(Home { seed, space: Space::single(Region::new(RegionKind::Unit, name))?.into() })),
        _ => Err(unknown()),
    }
}

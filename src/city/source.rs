//! The scenes of regions, by whoever makes them.

use std::error::Error;
use std::sync::Arc;

use vc_graph::SceneGraph;
use vc_graph::space::{RegionId, Space};

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

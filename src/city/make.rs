//! Making a city.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Point2;
use vc_graph::clock::Tick;
use vc_graph::space::{NumberBlock, Region, RegionId, Space};
use vc_graph::{Draft, NodeId, Pose, SceneBuilder};
use vc_physics::{PhysicsWorld, ShapeCache};

use super::lift::Lifts;
use super::{City, CityError, RegionLabel, RegionScenes, source};
use crate::environment::{Departure, TravelError};
use crate::{Environment, EnvironmentBuilder};

/// Makes a [`City`] with settings of your own: [`City::of`].
pub struct CityBuilder {
    source: Arc<dyn RegionScenes>,
    agents: usize,
    settings: EnvironmentBuilder,
}

impl CityBuilder {
    /// The number of agents, 1 unless it is said. They begin in the first [units](vc_graph::space::RegionKind::Unit) of the
    /// plan, one in each, or in the first regions where there are none.
    #[must_use]
    pub fn agents(self, agents: usize) -> Self {
        Self { agents, ..self }
    }

    /// The settings of all environments, but for scene and agents: gravity, hour, durations ...
    #[must_use]
    pub fn settings(self, settings: EnvironmentBuilder) -> Self {
        Self { settings, ..self }
    }

    /// Makes the city. Costs the environments of the regions in which agents begin.
    ///
    /// # Errors
    /// [`CityError`].
    pub fn make(self) -> Result<City, CityError> {
        let Self { source, agents, settings } = self;
        let lifts = Lifts::new(source.space());
        let mut city = City {
            source,
            settings,
            tick: Tick(0),
            active: BTreeMap::new(),
            asleep: BTreeMap::new(),
            whereabouts: BTreeMap::new(),
            agents: Vec::new(),
            homes: BTreeMap::new(),
            journeys: BTreeMap::new(),
            ways: BTreeMap::new(),
            lifts,
            stops: BTreeMap::new(),
            endings: Vec::new(),
            orders: None,
            glances: Arc::default(),
        };
        let begins: Vec<RegionId> = city.beginnings();
        if begins.is_empty() && agents > 0 {
            return Err(CityError::NoScene(city.region_label(RegionId(0))));
        }
        for agent in 0..agents {
            city.add_agent(begins[agent % begins.len()])?;
        }
        Ok(city)
    }
}

impl City {
    /// The city with a name, with so many agents: `building/7` and `house/7` are generated from a seed, the second as
    /// a city's plan has it, `apartment/42` is a home alone.
    ///
    /// ```
    /// use virtualcity::City;
    /// let home = City::make("apartment/42", 1)?;
    /// assert_eq!(home.space().len(), 1);
    /// assert!(City::make("castle/3", 1).is_err());
    /// # Ok::<(), virtualcity::CityError>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError`].
    pub fn make(name: &str, agents: usize) -> Result<Self, CityError> {
        Self::builder(source::named(name)?).agents(agents).make()
    }

    /// A builder of a city of regions whose scenes come from somewhere.
    pub fn of(source: impl RegionScenes) -> CityBuilder {
        Self::builder(Arc::new(source))
    }

    fn builder(source: Arc<dyn RegionScenes>) -> CityBuilder {
        CityBuilder { source, agents: 1, settings: Environment::builder_from_scene(SceneBuilder::new("").build()) }
    }

    /// The regions in which agents begin.
    fn beginnings(&self) -> Vec<RegionId> {
        let with = |is: fn(&Region) -> bool| {
            let regions = self.space().regions().filter(|(_, region)| region.has_scene() && region.stops.is_empty());
            regions.filter(|(_, region)| is(region)).map(|(id, _)| id).collect::<Vec<RegionId>>()
        };
        let units = with(|region| region.kind == vc_graph::space::RegionKind::Unit);
        if units.is_empty() { with(|_| true) } else { units }
    }

    /// Adds an agent, who stands in a room of a region, near its middle: one from where a way leads out, if
    /// there is one.
    ///
    /// # Errors
    /// [`CityError`]; nothing has changed then.
    pub fn add_agent(&mut self, region: RegionId) -> Result<NodeId, CityError> {
        let id = NodeId(NumberBlock::TRAVELLERS.first + self.agents.len() as u32);
        let space = self.space().clone();
        let newcomer = newcomer(id, self.agents.len(), (&space, region))?;
        self.wake(region)?;
        let doors = self.spots_at_portals(region);
        let environment = self.wake(region)?;
        let no_floor = || CityError::of_travel(&space, TravelError::NoFloor { region, within: 0.0 });
        let (room, spot) = environment.room_to_enter(&doors).ok_or_else(no_floor)?;
        let feet = Pose::translation(spot.x, spot.y, environment.floor().options().level);
        let straight = |there: &Environment, other: &Point2<f32>| there.leads_straight(&spot, other);
        let arrived = environment.arrive(&newcomer, (region, room), &Pose::identity(), feet, (spot, straight));
        let (spot, _) = arrived.map_err(|why| CityError::of_travel(&space, why))?;
        environment.stand_at(id, Pose::translation(spot.x, spot.y, feet.translation.z));
        self.whereabouts.insert(id, region);
        self.agents.push(id);
        self.homes.insert(id, region);
        Ok(id)
    }
}

/// Somebody who has not been anywhere.
fn newcomer(id: NodeId, looks: usize, (space, region): (&Space, RegionId)) -> Result<Departure, CityError> {
    let label = || RegionLabel::new(space, region);
    let fault = |why: vc_graph::EditError| CityError::Scene { region: label(), why: Arc::new(why) };
    let mut scene = SceneBuilder::new("nowhere");
    let mut library = vc_graph::AssetLibrary::default();
    let asset = vc_people::add_to(&mut library, looks)
        .map_err(|why| CityError::Scene { region: label(), why: Arc::new(why) })?;
    scene.assets(Arc::new(library));
    scene.number_from(id.0);
    let draft =
        Draft { asset: Some(asset), ..Draft::new("character").at(Pose::identity()).bounds(vc_people::bounds()) };
    let mut edit = scene.edit();
    edit.add_with_id(id, draft).map_err(fault)?;
    edit.commit();
    let scene = scene.build();
    let mut world = PhysicsWorld::build(&scene, &ShapeCache::new(), vc_physics::Settings::default());
    let world = world.as_mut().map_err(|why| CityError::Bodies(why.clone().into()))?;
    Departure::of(&scene, world, region).map_err(|why| CityError::of_travel(space, why))
}

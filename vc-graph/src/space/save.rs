//! Worlds of regions as text: what has changed since their scenes were made, and which scenes those were.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::graphs::{Dormant, Position};
use super::{NumberBlock, RegionGraphs, RegionId, Space, WorldFileError};
use crate::format::native;
use crate::{ClassTable, Digest, NodeId, SceneGraph};

/// The version that is written, and the only one that is read.
const VERSION: u32 = 1;

#[derive(Serialize, Deserialize)]
struct File {
    virtualcity_world: u32,
    plan: u64,
    active: Vec<RegionId>,
    moved: Vec<(NodeId, RegionId)>,
    slices: Vec<RegionId>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    stops: Vec<(RegionId, Position)>,
    regions: Vec<RegionFile>,
}

/// A region that has been active.
#[derive(Serialize, Deserialize)]
struct RegionFile {
    region: RegionId,
    made: u64,
    numbers: NumberBlock,
    next: u32,
    open: Vec<NodeId>,
    /// The changes, as JSON.
    changes: String,
    /// A scene without nodes that has the shapes, if some came from elsewhere.
    shapes: Option<String>,
}

impl RegionGraphs {
    /// The world as text: for each region that has been active the digest of its scene as it was made and what has changed
    /// since; not the scenes themselves. Costs what has changed.
    ///
    /// ```
    /// use vc_graph::space::{Region, RegionGraphs, RegionId, RegionKind, Space};
    /// use vc_graph::{ClassTable, Draft, SceneBuilder};
    /// let space = std::sync::Arc::new(Space::single(Region::new(RegionKind::Unit, "flat"))?);
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let made = scene.build();
    /// let mut world = RegionGraphs::new(space.clone());
    /// world.insert(RegionId(0), made.clone())?;
    /// let mut edit = world.edit(RegionId(0)).ok_or("active")?;
    /// let cup = edit.add(Draft::new("cup"))?;
    /// edit.move_to_room(cup, kitchen)?;
    /// edit.commit();
    /// let again = RegionGraphs::read(&world.write(), space, &ClassTable::builtin(), |_| made.clone())?;
    /// assert_eq!(again, world);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn write(&self) -> String {
        let active = self.active().filter_map(|region| Some((region, self.record(region)?)));
        let dormant = self.dormant.iter().map(|(region, dormant)| (*region, dormant.clone()));
        let all: BTreeMap<RegionId, Dormant> = active.chain(dormant).collect();
        let file = File {
            virtualcity_world: VERSION,
            plan: self.space().digest().0,
            active: self.active().collect(),
            moved: self.moved.iter().map(|(node, region)| (*node, *region)).collect(),
            slices: self.slices.to_vec(),
            stops: self.stops.iter().map(|(region, position)| (*region, *position)).collect(),
            regions: all.iter().map(|(region, dormant)| RegionFile::new(*region, dormant)).collect(),
        };
        // Plain types of this crate, for which serialisation cannot fail.
        serde_json::to_string(&file).unwrap_or_default()
    }

    /// Reads a world. `made` makes the scene of a region anew, as it was made before; it is asked for those that were
    /// active.
    ///
    /// # Errors
    /// [`WorldFileError`]: another format or plan; [`SpaceError::MadeOtherwise`](super::SpaceError::MadeOtherwise) names a
    /// region whose generator makes another scene now.
    pub fn read(
        text: &str,
        space: Arc<Space>,
        classes: &Arc<ClassTable>,
        mut made: impl FnMut(RegionId) -> SceneGraph,
    ) -> Result<Self, WorldFileError> {
        let file: File = serde_json::from_str(text).map_err(|error| WorldFileError::Json(error.to_string()))?;
        if file.virtualcity_world != VERSION {
            return Err(WorldFileError::Version(file.virtualcity_world, VERSION));
        }
        if file.plan != space.digest().0 {
            return Err(WorldFileError::OtherPlan { saved: Digest(file.plan), here: space.digest() });
        }
        let mut world = Self::new(space);
        let known = |region: &RegionId| world.space().region(*region).is_some_and(super::Region::has_scene);
        let named = file.moved.iter().map(|(_, region)| region).chain(&file.slices).chain(&file.active);
        let mut named = named.chain(file.regions.iter().map(|region| &region.region));
        if let Some(region) = named.find(|region| !known(region)) {
            return Err(WorldFileError::NoSuchRegion(*region));
        }
        let dormant = file.regions.into_iter().map(|region| Ok((region.region, region.read(classes)?)));
        world.dormant = Arc::new(dormant.collect::<Result<_, WorldFileError>>()?);
        for (region, position) in file.stops {
            match position {
                Position::At(stop) => world.stop_at(region, stop)?,
                Position::Between(frame) => world.move_between(region, frame)?,
            }
        }
        (world.moved, world.slices) = (Arc::new(file.moved.into_iter().collect()), file.slices.into());
        for region in file.active {
            world.insert(region, made(region))?;
        }
        Ok(world)
    }
}

impl RegionFile {
    fn new(region: RegionId, of: &Dormant) -> Self {
        let shapes = of.assets.clone().map(|assets| {
            let mut empty = SceneGraph::new("shapes", ClassTable::builtin());
            empty.assets = assets;
            native::write(&empty)
        });
        let changes = serde_json::to_string(&of.changes).unwrap_or_default();
        let open = of.open.clone();
        Self { region, made: of.made.0, numbers: of.numbers, next: of.next, open, changes, shapes }
    }

    fn read(self, classes: &Arc<ClassTable>) -> Result<Dormant, WorldFileError> {
        let shapes = self.shapes.map(|text| native::read(&text, classes)).transpose()?;
        Ok(Dormant {
            made: Digest(self.made),
            changes: native::read_changes(&self.changes, classes)?,
            numbers: self.numbers,
            next: self.next,
            assets: shapes.map(|shapes| shapes.assets),
            open: self.open,
        })
    }
}

//! A city, or a part of it, as one scene for files, and whether it is sound.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use nalgebra::Translation3;
use vc_graph::space::RegionId;
use vc_graph::{
    AssetLibrary, Bounds, BoundsFrame, Change, ChangeSet, Draft, Edge, Label, Node, NodeId, ObjectRole, Place, Pose,
    Relation, SceneBuilder, SceneGraph, Violation,
};
use vc_physics::BodyRole;

use super::{City, CityError, RegionLabel};
use crate::Environment;

/// How far below a floor something is that lies on it, metres: less than half a thin thing's height, more than soft ground yields.
const SUNK: f32 = 0.05;

/// Something that is wrong in a city: [`City::validate`].
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum CityViolation {
    /// The scene of a region is not sound.
    Scene {
        /// The region.
        region: RegionLabel,
        /// The fault in it.
        violation: Violation,
    },
    /// A thing is outside its region, or has been stopped there.
    Outside {
        /// The region.
        region: RegionLabel,
        /// The thing.
        thing: Label,
    },
    /// A thing reaches below all floors of its region by more than 5 cm.
    BelowFloor {
        /// The region.
        region: RegionLabel,
        /// The thing.
        thing: Label,
    },
    /// A thing is in a shut door between two regions, or between the shut doors of a lift.
    InDoor {
        /// The region.
        region: RegionLabel,
        /// The thing.
        thing: Label,
    },
    /// A node is in a region and belongs to another.
    Elsewhere {
        /// The region.
        region: RegionLabel,
        /// The node.
        node: Label,
    },
    /// A node that has gone to a region is not there.
    Missing {
        /// The region.
        region: RegionLabel,
        /// Its number.
        node: NodeId,
    },
}

impl fmt::Display for CityViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene { region, violation } => write!(f, "{region}: {violation}"),
            Self::Outside { region, thing } => write!(f, "{region}: {thing} is outside"),
            Self::BelowFloor { region, thing } => write!(f, "{region}: {thing} is below the floor"),
            Self::InDoor { region, thing } => write!(f, "{region}: {thing} is in a shut door"),
            Self::Elsewhere { region, node } => write!(f, "{region}: {node} belongs to another region"),
            Self::Missing { region, node } => write!(f, "{region}: node {node}, which has gone there, is not there"),
        }
    }
}

/// Whether a thing lies on stairs, which lead out of the room that they are of.
fn is_on_stairs(graph: &SceneGraph, thing: NodeId) -> bool {
    let stairs = |place: Place| graph.node(place.at).is_some_and(|node| node.role() == ObjectRole::Structure);
    graph.places(thing).filter(|place| place.relation == Relation::On).any(stairs)
}

impl City {
    /// All that is wrong in the regions that are there and in those that somebody has changed: their scenes
    /// ([`SceneGraph::validate`]), things outside, below the floor or in shut doors, and nodes that are in no region or in two. Nothing is
    /// expected to be.
    ///
    /// ```
    /// let city = virtualcity::City::make("building/7", 2)?;
    /// assert_eq!(city.validate()?, []);
    /// # Ok::<(), virtualcity::CityError>(())
    /// ```
    ///
    /// # Errors
    /// Reasons for which a region cannot be made.
    pub fn validate(&self) -> Result<Vec<CityViolation>, CityError> {
        let known: Vec<RegionId> = self.active.keys().chain(self.asleep.keys()).copied().collect();
        let gone = self.whereabouts.values().copied();
        let all = known.into_iter().chain(gone).map(|region| Ok((region, self.seen(region)?)));
        let all: BTreeMap<RegionId, Cow<'_, Environment>> = all.collect::<Result<_, CityError>>()?;
        let mut found = Vec::new();
        for (region, there) in &all {
            let label = self.region_label(*region);
            let scene = |violation| CityViolation::Scene { region: label.clone(), violation };
            found.extend(there.graph().validate().into_iter().map(scene));
            let outside = there.world().outside().into_iter().filter(|thing| !is_on_stairs(there.graph(), *thing));
            let outside = outside.map(|thing| there.graph().label(thing));
            found.extend(outside.map(|thing| CityViolation::Outside { region: label.clone(), thing }));
            let sunk = below_floor(there).into_iter().map(|thing| there.graph().label(thing));
            found.extend(sunk.map(|thing| CityViolation::BelowFloor { region: label.clone(), thing }));
            let in_doors = self.in_shut_doors(*region, there).into_iter().map(|thing| there.graph().label(thing));
            found.extend(in_doors.map(|thing| CityViolation::InDoor { region: label.clone(), thing }));
            let foreign = there.graph().nodes().filter(|node| self.region_of(node.id()) != Some(*region));
            found.extend(
                foreign.map(|node| CityViolation::Elsewhere { region: label.clone(), node: Node::label(node) }),
            );
        }
        let is_there = |node: NodeId, region| all.get(region).is_some_and(|there| there.graph().node(node).is_some());
        let missing = self.whereabouts.iter().filter(|(node, region)| !is_there(**node, region));
        let missing = missing.map(|(node, region)| (*node, self.region_label(*region)));
        found.extend(missing.map(|(node, region)| CityViolation::Missing { region, node }));
        Ok(found)
    }

    /// Regions as one scene as they are now, in the frame of the first, for files of other programs:
    /// `vc_graph::format::thesis::write` and others write it. No relation leads from one to another. Boxes along the axes of a
    /// region are along those of the whole, and grow where a region is turned by other than right angles. The scene of one
    /// region alone is that of [`peek`](Self::peek).
    ///
    /// ```
    /// use virtualcity::City;
    /// use virtualcity::graph::format::thesis;
    /// let city = City::make("building/7", 1)?;
    /// let regions = city.space().regions().filter(|(_, region)| region.has_scene()).map(|(region, _)| region);
    /// let whole = city.scene(regions)?;
    /// assert!(whole.validate().is_empty());
    /// assert_eq!(thesis::read(&thesis::write(&whole), whole.classes())?.len(), whole.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoScene`] and other reasons for which a region cannot be made.
    pub fn scene(&self, regions: impl IntoIterator<Item = RegionId>) -> Result<SceneGraph, CityError> {
        let regions: Vec<RegionId> = regions.into_iter().collect();
        let first = regions.first().copied().unwrap_or(RegionId(0));
        let mut scene = SceneBuilder::new(self.space().path(RegionId(0)));
        let mut library = Arc::<AssetLibrary>::default();
        for (number, region) in regions.iter().enumerate() {
            let there = self.seen(*region)?;
            if number == 0 {
                scene = SceneBuilder::with_classes(self.space().path(RegionId(0)), there.graph().classes().clone());
                library = there.graph().assets().clone();
            }
            let shift = self.pose_in(first, *region).unwrap_or_else(Pose::identity);
            let fault = |why: Fault| CityError::Scene { region: self.region_label(*region), why: why.into() };
            add(&mut scene, &mut library, (there.graph(), &shift)).map_err(fault)?;
        }
        scene.assets(library);
        Ok(scene.build())
    }
}

/// The loose things of a region that reach below all its floors.
fn below_floor(there: &Environment) -> Vec<NodeId> {
    let world = there.world();
    let tops = there.graph().of_role(ObjectRole::Floor).filter_map(|floor| Some(world.aabb(floor.id())?.max.z));
    let Some(lowest) = tops.reduce(f32::min) else { return Vec::new() };
    let is_loose = |id: &NodeId| world.role(*id) == Some(BodyRole::Loose);
    let sunk = |id: &NodeId| world.body(*id).ok().and_then(|body| body.lowest()).is_some_and(|low| low < lowest - SUNK);
    world.nodes().into_iter().filter(is_loose).filter(sunk).collect()
}

type Fault = Box<dyn std::error::Error + Send + Sync>;

/// Adds a scene to another one, moved by a transformation, with its shapes.
fn add(
    whole: &mut SceneBuilder,
    library: &mut Arc<AssetLibrary>,
    (scene, shift): (&SceneGraph, &Pose),
) -> Result<(), Fault> {
    for node in scene.nodes() {
        let own = Draft::from_node(node);
        let asset = own.asset.map(|asset| match library.find(scene.assets(), asset) {
            Some(known) => Ok(known),
            None => Arc::make_mut(library).import(scene.assets(), asset),
        });
        let bounds = own.bounds.map(|bounds| turned(&bounds, shift));
        let draft = Draft { pose: own.pose.map(|pose| shift * pose), asset: asset.transpose()?, bounds, ..own };
        let mut edit = whole.edit();
        edit.add_with_id(node.id(), draft)?;
        edit.commit();
    }
    let nothing = SceneBuilder::with_classes("", scene.classes().clone()).build();
    let edge = |change: &Change| match change {
        Change::Link(edge) => Some(*edge),
        _ => None,
    };
    let edges: Vec<Edge> = ChangeSet::between(&nothing, scene).changes().iter().filter_map(edge).collect();
    Ok(whole.link_all(&edges)?)
}

/// A box along the axes of a scene as one along those of the whole; others turn with their things.
fn turned(bounds: &Bounds, shift: &Pose) -> Bounds {
    if bounds.frame == BoundsFrame::Object {
        return *bounds;
    }
    let own = Bounds { frame: BoundsFrame::Object, ..*bounds };
    let around = own.aabb(&Pose::from_parts(Translation3::identity(), shift.rotation));
    Bounds { offset: around.centre().coords, half: (around.max - around.min) / 2.0, frame: BoundsFrame::World }
}

//! Shapes for homes of boxes: scenes whose objects have a class and a bounding box but no shape.
//!
//! [`dressed`] gives every such object the asset that its class's [generator](vc_shapes::object) makes in that
//! size, rotated by quarter turns so that it faces the free floor. Walls are cut where doors and windows are;
//! floors and walls get their room's material. An object without a generator gets a plain box of the material
//! that its class suggests.
//!
//! | in the scene | in the result |
//! |---|---|
//! | identifiers, classes, names, states, relations, positions | unchanged |
//! | boxes aligned with the world | unchanged; the node is rotated by quarter turns within them |
//! | boxes of rotated nodes | unchanged; the object fills them, its front along the node's X |
//! | boxes thinner than any object of the class | grow to the class's least size: floors downwards, ceilings upwards |
//! | doors of furniture beside a wall | open only as far as the wall allows, but half of their way at least |
//! | boxes of doors and windows | become those of the object: leaf, frame and handles in the opening of the wall |
//!
//! ```
//! use vc_graph::{Bounds, Draft, Pose, SceneBuilder, Seed};
//! use vc_procgen::dress;
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let fridge = Draft::new("fridge").bounds(Bounds::centred([0.7, 0.7, 1.8].into())).at(Pose::translation(0.0, 0.0, 0.9));
//! let fridge = scene.add_in(kitchen, fridge)?;
//! let scene = scene.build();
//! let shaped = dress::dressed(&scene, dress::seed_of(&scene))?;
//! let asset = shaped.node(fridge).and_then(|n| shaped.assets().get(n.spec().asset?)).ok_or("no shape")?;
//! assert!(asset.parts.iter().any(|part| part.joint.is_some()), "its door opens");
//! assert!(asset.surfaces.len() > 1, "it has shelves");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod compose;
mod fit;
mod house;
mod kind;
mod load;
mod shell;
mod swing;
mod turn;

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::{Translation3, Vector3};
use vc_graph::asset::{AssetError, Merged};
use vc_graph::{
    Asset, AssetId, AssetLibrary, Bounds, BoundsFrame, Draft, EditError, Label, Node, NodeId, NodeKind, Pose,
    SceneBuilder, SceneGraph, Seed,
};
use vc_shapes::{Generator, Generators, Style};

use house::House;

/// The reason why a scene could not be given shapes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DressError {
    /// The shape made for a node cannot be added to the scene's library.
    #[error("{node}: {error}")]
    Asset {
        /// The node.
        node: Label,
        /// The fault of the shape.
        #[source]
        error: AssetError,
    },
    /// The materials of the shapes cannot be added to the scene's library.
    #[error("the materials of the shapes do not fit the scene's library: {0}")]
    Materials(#[source] AssetError),
    /// The scene cannot be rebuilt.
    #[error(transparent)]
    Edit(#[from] EditError),
}

/// The seed that determines a scene's shapes: the number at the end of its name (`apartment_42`), otherwise one
/// derived from the name and the number of nodes.
///
/// ```
/// use vc_graph::{SceneBuilder, Seed};
/// use vc_procgen::dress::seed_of;
/// assert_eq!(seed_of(&SceneBuilder::new("apartment_42").build()), Seed(42));
/// ```
pub fn seed_of(graph: &SceneGraph) -> Seed {
    let name = graph.name();
    let digits = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    name[digits..].parse().map_or_else(|_| Seed(graph.len() as u64).child(name), Seed)
}

/// Gives a shape to every object that has a box and a class but no shape, and to every object that has neither
/// box nor shape if its class has a generator. The same scene and seed give the same bytes.
///
/// Costs some tens of microseconds for each object.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder, Seed};
/// use vc_procgen::dress::dressed;
/// let mut scene = SceneBuilder::new("flat");
/// let room = scene.add(Draft::new("kitchen"))?;
/// let table = Draft::new("kitchen_table").bounds(Bounds::standing([0.8, 1.2, 0.75].into())).at(Pose::identity());
/// let table = scene.add_in(room, table)?;
/// let scene = dressed(&scene.build(), Seed(1))?;
/// assert!(scene.node(table).is_some_and(|node| node.spec().asset.is_some()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DressError`] if a shape cannot be added to the scene.
pub fn dressed(graph: &SceneGraph, seed: Seed) -> Result<SceneGraph, DressError> {
    dressed_by(graph, &Generators::default(), seed)
}

/// As [`dressed`], with the generators of a program's own classes beside the built-in ones.
///
/// # Errors
/// [`DressError`] if a shape cannot be added to the scene.
pub fn dressed_by(graph: &SceneGraph, generators: &Generators, seed: Seed) -> Result<SceneGraph, DressError> {
    let house = House::new(graph, generators);
    let mut wardrobe = Wardrobe::new(graph, generators, seed)?;
    let needs = graph.nodes().map(|node| wardrobe.need(&house, node)).collect::<Vec<_>>();
    needs.iter().for_each(|need| wardrobe.load(need));
    let appearances = graph
        .nodes()
        .zip(needs)
        .map(|(node, need)| wardrobe.appearance(&house, node, need).map_err(of_node(node)))
        .collect::<Result<Vec<_>, _>>()?;
    rebuilt(graph, appearances, wardrobe.library)
}

/// Gives a shape to every object that has neither shape nor box and whose class has a generator: an instance of
/// the usual size. `None` if there is no such object.
///
/// ```
/// use vc_graph::{Draft, SceneBuilder, Seed};
/// use vc_procgen::dress::shaped;
/// let mut scene = SceneBuilder::new("flat");
/// let mug = scene.add(Draft::new("mug"))?;
/// let scene = shaped(&scene.build(), Seed(1))?.ok_or("nothing to shape")?;
/// assert!(scene.node(mug).is_some_and(|node| node.spec().bounds.is_some()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DressError`] if a shape cannot be added to the scene.
pub fn shaped(graph: &SceneGraph, seed: Seed) -> Result<Option<SceneGraph>, DressError> {
    let generators = Generators::default();
    if !graph.nodes().any(|n| lacks_all(&generators, n).is_some()) {
        return Ok(None);
    }
    let mut wardrobe = Wardrobe::new(graph, &generators, seed)?;
    let appearances =
        graph.nodes().map(|node| wardrobe.usual(node).map_err(of_node(node))).collect::<Result<Vec<_>, _>>()?;
    rebuilt(graph, appearances, wardrobe.library).map(Some)
}

/// The new appearance of a node: its asset, with its pose, bounds and scale.
struct Appearance {
    asset: AssetId,
    pose: Option<Pose>,
    bounds: Bounds,
    scale: Vector3<f32>,
}

/// A shape made for a size, with its origin at the centre of its box.
#[derive(Clone)]
struct Made {
    asset: Asset,
    /// The scale factors along its axes.
    scale: Vector3<f32>,
}

/// The shapes made for a scene so far.
struct Wardrobe<'g> {
    generators: &'g Generators,
    library: AssetLibrary,
    /// Where our materials are in the library.
    merged: Merged,
    style: Style,
    seed: Seed,
    made: BTreeMap<Key, (AssetId, Vector3<f32>)>,
    /// Shapes whose doors stop at walls, by the shape and the limits of its joints.
    stopped: BTreeMap<(AssetId, Vec<[i32; 2]>), AssetId>,
    /// The loads of all objects that look the same.
    loads: BTreeMap<Key, Vec<load::Load>>,
}

/// Objects with the same key share a shape. Lengths are in tenths of a millimetre.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    /// The class, and the name if there is one.
    name: String,
    /// The offset and half size of its box.
    size: [i32; 6],
    /// The stretches of its width that other objects occupy.
    taken: Vec<[i32; 2]>,
}

impl Key {
    fn new(node: &Node, place: &turn::Place) -> Self {
        let name = format!("{} {}", place.class, node.spec().name.as_deref().unwrap_or(""));
        let (o, h) = (place.bounds.offset, place.bounds.half);
        let taken = place.taken.iter().map(|(from, to)| [*from, *to].map(ten_thousandths)).collect();
        Self { name, size: [o.x, o.y, o.z, h.x, h.y, h.z].map(ten_thousandths), taken }
    }
}

/// Metres or radians in ten-thousandths.
fn ten_thousandths(value: f32) -> i32 {
    (value * 1e4).round() as i32
}

/// The shape that a node needs.
enum Need {
    Nothing,
    /// A shape of its class's usual size, if there is a generator.
    Usual,
    Built(shell::Built),
    Thing(turn::Place, Key, Vec<load::Load>),
}

impl<'g> Wardrobe<'g> {
    fn new(graph: &SceneGraph, generators: &'g Generators, seed: Seed) -> Result<Self, DressError> {
        let mut library = graph.assets().as_ref().clone();
        let merged = library.merge(&vc_shapes::material::library()).map_err(DressError::Materials)?;
        let (made, stopped, loads) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        Ok(Self { generators, library, merged, style: Style::from_seed(seed), seed, made, stopped, loads })
    }

    /// Determines the shape that a node needs.
    fn need(&self, house: &House, node: &Node) -> Need {
        let (Some(bounds), Some(pose)) = (node.spec().bounds, node.pose()) else { return Need::Usual };
        if node.kind() != NodeKind::Object || node.spec().asset.is_some() {
            return Need::Nothing;
        }
        if let Some(built) = shell::built(house, node, &self.style, self.seed) {
            return Need::Built(built);
        }
        let place = turn::placed(house, node.id(), pose, &bounds);
        let loads = load::resting_on(house, node.id(), &(place.pose * Translation3::from(place.bounds.offset)));
        let key = Key::new(node, &place);
        Need::Thing(place, key, loads)
    }

    /// Records the loads of objects: those that look the same share them all.
    fn load(&mut self, need: &Need) {
        if let Need::Thing(_, key, loads) = need {
            self.loads.entry(key.clone()).or_default().extend(loads);
        }
    }

    fn appearance(&mut self, house: &House, node: &Node, need: Need) -> Result<Option<Appearance>, AssetError> {
        match need {
            Need::Nothing => Ok(None),
            Need::Usual => self.usual(node),
            Need::Built(made) => self.keep(made.asset, made.pose, made.bounds).map(Some),
            Need::Thing(place, key, _) => self.thing(house, place, key).map(Some),
        }
    }

    fn thing(&mut self, house: &House, place: turn::Place, key: Key) -> Result<Appearance, AssetError> {
        let bounds = place.bounds;
        let (asset, scale) = match self.made.get(&key) {
            Some(known) => *known,
            None => {
                let loads = self.loads.get(&key).map_or(&[][..], Vec::as_slice);
                let made = fit::made(house, &place, loads, &self.style, self.seed.child(&key.name));
                let shift = bounds.offset.component_div(&made.scale);
                let asset = self.add(compose::moved(made.asset, shift))?;
                self.made.insert(key, (asset, made.scale));
                (asset, made.scale)
            }
        };
        let asset = self.stopped(house, asset, &place.pose, &scale)?;
        Ok(Appearance { asset, pose: Some(place.pose), bounds, scale })
    }

    /// A shape whose doors stop at the walls around it; the same one if none does.
    fn stopped(
        &mut self,
        house: &House,
        asset: AssetId,
        pose: &Pose,
        scale: &Vector3<f32>,
    ) -> Result<AssetId, AssetError> {
        let made = self.library.get(asset).and_then(|made| swing::within_walls(made, pose, scale, &house.walls));
        let Some(made) = made else { return Ok(asset) };
        let limits = made
            .parts
            .iter()
            .filter_map(|p| p.joint)
            .map(|j| [ten_thousandths(j.limits.0), ten_thousandths(j.limits.1)]);
        let key = (asset, limits.collect());
        if let Some(known) = self.stopped.get(&key) {
            return Ok(*known);
        }
        let id = self.library.add(made)?;
        self.stopped.insert(key, id);
        Ok(id)
    }

    /// A shape of the class's usual size, if the node has neither shape nor box.
    fn usual(&mut self, node: &Node) -> Result<Option<Appearance>, AssetError> {
        let Some(generator) = lacks_all(self.generators, node) else { return Ok(None) };
        let made = generator.object(&self.style, self.seed.nth(u64::from(node.id().0)));
        let asset = self.add(made.asset)?;
        Ok(Some(Appearance { asset, pose: node.pose().copied(), bounds: made.bounds, scale: node.spec().scale }))
    }

    fn keep(&mut self, asset: Asset, pose: Pose, bounds: Bounds) -> Result<Appearance, AssetError> {
        Ok(Appearance { asset: self.add(asset)?, pose: Some(pose), bounds, scale: Vector3::repeat(1.0) })
    }

    fn add(&mut self, asset: Asset) -> Result<AssetId, AssetError> {
        self.library.add(self.merged.renumbered(asset))
    }
}

/// Names the node for which a shape was made.
fn of_node(node: &Node) -> impl FnOnce(AssetError) -> DressError {
    |error| DressError::Asset { node: node.label(), error }
}

/// The generator for a node, if the node has neither shape nor box.
fn lacks_all<'g>(generators: &'g Generators, node: &Node) -> Option<&'g Generator> {
    let bare = node.kind() == NodeKind::Object && node.spec().asset.is_none() && node.spec().bounds.is_none();
    generators.get(node.class()).filter(|_| bare)
}

fn rebuilt(
    graph: &SceneGraph,
    appearances: Vec<Option<Appearance>>,
    library: AssetLibrary,
) -> Result<SceneGraph, DressError> {
    let mut builder = SceneBuilder::with_classes(graph.name(), graph.classes().clone());
    for (node, appearance) in graph.nodes().zip(appearances) {
        let mut draft = Draft::from_node(node);
        if let Some(appearance) = appearance {
            draft.asset = Some(appearance.asset);
            (draft.pose, draft.bounds, draft.scale) =
                (appearance.pose, Some(appearance.bounds), Some(appearance.scale));
        }
        builder.add_with_id(node.id(), draft)?;
    }
    builder.link_all(&graph.edges().collect::<Vec<_>>())?;
    builder.assets(Arc::new(library));
    Ok(builder.build())
}

/// Whether a node's box does not tell its rotation.
fn is_unturned(bounds: &Bounds) -> bool {
    bounds.frame == BoundsFrame::World
}

/// The nodes that a node rests on or in, directly or indirectly, the nearest first.
fn holders(graph: &SceneGraph, id: NodeId) -> impl Iterator<Item = &Node> {
    graph.support_chain(id).into_iter().filter(move |&at| at != id).filter_map(|at| graph.node(at))
}

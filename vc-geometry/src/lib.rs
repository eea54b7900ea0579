//! Geometry that several crates need and that is decided once.
//!
//! | module | contents |
//! |---|---|
//! | [`grid`] | bit grids of the floor: free cells, discs, connected parts, painted outlines |
//! | [`walk`] | shortest walks over free cells |
//! | [`outline`] | convex outlines in the plane: hull, containment, crossing |
//! | [`profile`] | outlines of any form cut into trapezia |
//! | [`hull`] | convex hulls of points in space, exact or rough |
//! | [`cut`] | surfaces cut by planes, into convex pieces |
//! | [`tree`] | which of many boxes overlap: a tree, and all pairs at once |
//! | [`cache`] | values that are computed once for each asset of a library |
//! | [`order`] | comparisons of numbers in few instructions |
//! | this one | [`shapes`] for things of which only a box is known |
//!
//! Lengths are metres unless a name says cells. Nothing here knows scenes, bodies or engines, except for [`shapes`].
//!
//! Scenes from elsewhere (VirtualHome's, the thesis's) give a thing a class and the box around it.
//! [`shapes`] makes an [`Asset`] of each such box: boards, surfaces, hollows, doorways. An asset is
//! plain data of `vc-graph`, so relations, physics and pictures all go by the same one.
//!
//! | box of | shape |
//! |---|---|
//! | walls | the box, or where it is as deep as wide the sides along which the floor ends; doorways and windows are cut out, and [`passages`] to rooms that would be cut off |
//! | floors, ceilings | a slab below their top, as far as the next floor; where the boxes of two rooms overlap, that room's whose things are there |
//! | doors | a leaf on a hinge in the plane of the wall; of their frames two posts and a lintel |
//! | furniture around a corner | two arms, without the corner in which other furniture stands |
//! | tables, seats, beds | boards at the height at which things lie on them, or the class's |
//! | containers | boards around a hollow, shelves where things stand in it; open at the front, or above |
//! | anything else | its box, a surface on top where things can be put |
//!
//! ```
//! use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
//! let mut scene = SceneBuilder::new("kitchen");
//! let fridge = Bounds::standing([0.7, 0.7, 1.8].into());
//! let fridge = scene.add(Draft::new("fridge").bounds(fridge).at(Pose::identity()))?;
//! let shapes = vc_geometry::shapes(&scene.build());
//! assert!(shapes[&fridge].surfaces.len() > 2);
//! # Ok::<(), vc_graph::EditError>(())
//! ```

#![warn(clippy::disallowed_methods)]

mod block;
pub mod cache;
mod corner;
pub mod cut;
mod door;
mod floor;
mod form;
mod furniture;
pub mod grid;
pub mod hull;
mod level;
mod opening;
pub mod order;
pub mod outline;
mod passage;
pub mod profile;
mod share;
pub mod tree;
pub mod walk;
mod wall;

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::asset::{Material, Part};
use vc_graph::{Asset, Node, NodeId, NodeKind, ObjectRole, SceneGraph};

use block::Block;
pub use opening::{WallOpening, openings, passages};

/// Density of things of which only the box is known, kilograms per cubic metre.
const DENSITY: f32 = 150.0;

/// The one material of all shapes that are made here: their parts have number 0.
pub fn material() -> Material {
    Material { density: DENSITY, restitution: 0.0, roughness: 0.8, ..Material::new("plain", [0.6, 0.58, 0.55]) }
}

/// Whether only a box is known of a node: it is an object with a box and a pose and without an asset.
///
/// ```
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// let mut scene = SceneBuilder::new("hall");
/// let bench = scene.add(Draft::new("bench").bounds(Bounds::standing([1.2, 0.4, 0.45].into())).at(Pose::identity()))?;
/// assert!(scene.graph().node(bench).is_some_and(vc_geometry::is_bare));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn is_bare(node: &Node) -> bool {
    let spec = node.spec();
    node.kind() == NodeKind::Object && spec.asset.is_none() && spec.bounds.is_some() && node.pose().is_some()
}

/// A shape for every object that has a box and a pose and no asset, and stands upright: things that
/// lean stay boxes. Sizes are metres. Costs some microseconds for each object.
pub fn shapes(graph: &SceneGraph) -> BTreeMap<NodeId, Asset> {
    let openings = openings(graph);
    let bare = graph.nodes().filter(|n| is_bare(n));
    bare.filter_map(|n| Some((n.id(), shape(graph, n, &Block::new(n)?, &openings)))).collect()
}

fn shape(graph: &SceneGraph, node: &Node, block: &Block, openings: &[WallOpening]) -> Asset {
    let mut asset = Asset { name: node.class().clone(), ..Asset::default() };
    match node.role() {
        ObjectRole::Wall => asset.parts = wall::parts(graph, node, block, openings),
        ObjectRole::Floor => floor::build(graph, node, block, &mut asset),
        ObjectRole::Ceiling if !pieces(graph, node, block).is_empty() => asset.parts = pieces(graph, node, block),
        ObjectRole::DoorFrame => asset.parts = door::frame(block),
        ObjectRole::Door => {
            asset.parts = openings.iter().find(|o| o.door == node.id()).map_or_else(Vec::new, |o| door::leaf(block, o));
        }
        _ => corner::arms(graph, node, block).iter().for_each(|arm| furniture::build(graph, node, arm, &mut asset)),
    }
    if asset.parts.is_empty() {
        asset.parts = vec![block.whole("box")];
    }
    asset
}

/// The pieces of a ceiling, if its box is also around its neighbours.
fn pieces(graph: &SceneGraph, node: &Node, block: &Block) -> Vec<Part> {
    let pieces = share::own_pieces(graph, node, block, (block.low, block.high));
    let pieces = pieces.into_iter().map(|(low, high)| block::part("ceiling", low, high)).collect::<Vec<_>>();
    if pieces.len() > 1 { pieces } else { Vec::new() }
}

/// Whether a node is of a class or of a kind of it.
fn is_a(graph: &SceneGraph, node: &Node, class: &str) -> bool {
    let own: &Arc<str> = node.class();
    &**own == class || graph.classes().is_a(own, class)
}

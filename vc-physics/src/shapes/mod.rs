//! Conversion of assets to collision shapes and masses, computed once and shared.

mod footprint;
mod form;
mod hollow;
mod hull;
mod link;
mod mass;
mod merge;
mod part;
mod piece;
mod scale;

use std::collections::HashMap;
use std::sync::Arc;

use vc_geometry::cache::AssetCache;
use vc_graph::{AssetId, AssetLibrary, Node, Property, Relation, SceneGraph};

pub(crate) use footprint::{Footprint, levels};
pub(crate) use form::Form;
use form::Kind;
pub(crate) use link::Link;

/// A cache of shapes made from assets.
///
/// One cache serves any number of worlds and threads. Its entries for an asset library are dropped after the
/// library is. An asset's shapes depend only on its parts, its materials and the scale of the node.
///
/// **Shapes.** The shapes are the asset's [`collision`](vc_graph::Asset::collision) pieces if it has any,
/// otherwise its parts. A mesh becomes its convex hull, except that the space above a surface that holds things
/// stays free: a bathtub stays hollow. A hull has at most about 24 corners, is accurate to 2 mm where these
/// suffice, and extends as far along its axes as the mesh. Parts that move together form one body of convex
/// pieces. If there are more than 24 pieces, those are merged whose common bounding box wastes the least
/// volume, but never across the free space above a surface that holds things. Pieces of the building are never
/// merged, and its meshes are cut along their concave faces (into at most 64 pieces; a mesh of more than 4096
/// triangles becomes a hull), so that doorways stay open. Mass and inertia always come from the parts and their
/// materials.
#[derive(Default)]
pub struct ShapeCache(AssetCache<Key, Form>);

/// Asset, scale, and kind of form.
type Key = (AssetId, [u32; 3], Kind);

impl std::fmt::Debug for ShapeCache {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ShapeCache({} assets)", self.len())
    }
}

impl ShapeCache {
    /// An empty cache.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of cached shapes.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether the cache is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Gives access to the forms of several nodes, under one lock.
    pub(crate) fn session<R>(&self, library: &Arc<AssetLibrary>, work: impl FnOnce(&mut Session<'_>) -> R) -> R {
        self.0.session(library, |forms| work(&mut Session { library, forms }))
    }
}

/// Access to the forms of one library.
pub(crate) struct Session<'a> {
    library: &'a AssetLibrary,
    forms: &'a mut HashMap<Key, Arc<Form>>,
}

impl Session<'_> {
    /// The form of a node, if it has an asset with parts, or a box.
    pub(crate) fn form(&mut self, graph: &SceneGraph, node: &Node) -> Option<Arc<Form>> {
        let spec = node.spec();
        if let Some((id, asset)) = spec.asset.and_then(|id| Some((id, self.library.get(id)?)))
            && !asset.parts.is_empty()
        {
            let moves = node.affords(Property::Openable) && asset.parts.iter().any(|p| p.joint.is_some());
            let kind = match node.role().is_built_in() {
                _ if moves => Kind::Jointed,
                true => Kind::Building,
                false => Kind::Rigid,
            };
            let key = (id, [spec.scale.x, spec.scale.y, spec.scale.z].map(f32::to_bits), kind);
            if let Some(form) = self.forms.get(&key) {
                return Some(form.clone());
            }
            let form = Arc::new(Form::from_asset(asset, self.library, &spec.scale, kind));
            self.forms.insert(key, form.clone());
            return Some(form);
        }
        let bounds = spec.bounds?;
        let hollow = graph.relating(Relation::Inside, node.id()).next().is_some();
        Some(Arc::new(Form::from_box(&bounds, node.pose()?, hollow)))
    }
}

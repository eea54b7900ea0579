//! Objects from the generators, for tasks and for things that appear.

use std::sync::LazyLock;

use vc_graph::class::Class;
use vc_graph::{AssetLibrary, Draft, SceneGraph, Seed};
use vc_shapes::{material, object};
use vc_tasks::initial::Stock;

/// The catalogue of every object that `vc-shapes` can make, in any number.
#[derive(Debug, Clone, Copy, Default)]
pub struct Catalogue;

impl Stock for Catalogue {
    fn thing(&self, class: &Class, seed: Seed, _: &SceneGraph, assets: &mut AssetLibrary) -> Option<Draft> {
        static MATERIALS: LazyLock<AssetLibrary> = LazyLock::new(material::library);
        let object = object::generator(&class.name)?.instance(seed, 0).object;
        let merged = assets.merge(&MATERIALS).ok()?;
        let asset = assets.add(merged.renumbered(object.asset)).ok()?;
        Some(Draft { asset: Some(asset), ..Draft::new(class.name.clone()).bounds(object.bounds) })
    }
}

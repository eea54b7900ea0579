//! The source of the objects that are added.

use vc_graph::class::Class;
use vc_graph::{AssetLibrary, Bounds, Draft, SceneGraph, Seed};

/// A source of objects that a scene lacks.
///
/// A generator of objects implements it with assets; [`PlainStock`] uses only the scene and its
/// class table.
pub trait Stock {
    /// Makes an object of a class, not yet placed; `None` if the stock has none. Its assets go into
    /// `assets`, the scene's own library with earlier additions. The same seed gives the same
    /// object.
    fn thing(&self, class: &Class, seed: Seed, scene: &SceneGraph, assets: &mut AssetLibrary) -> Option<Draft>;
}

/// Copies of objects of the same class in the scene; otherwise boxes of the class's typical size.
#[derive(Debug, Clone, Copy, Default)]
pub struct PlainStock;

impl Stock for PlainStock {
    fn thing(&self, class: &Class, _: Seed, scene: &SceneGraph, _: &mut AssetLibrary) -> Option<Draft> {
        let same = scene.of_class(&class.name).into_iter().filter_map(|id| scene.node(id));
        let like = same.filter(|n| *n.class() == class.name).find(|n| n.spec().bounds.is_some());
        let draft = Draft::new(class.name.clone());
        match like.map(vc_graph::Node::spec) {
            Some(spec) => Some(Draft { bounds: spec.bounds, asset: spec.asset, scale: Some(spec.scale), ..draft }),
            None => class.typical_size().map(|size| draft.bounds(Bounds::standing(size))),
        }
    }
}

//! Where things that are added come from.

use vc_graph::class::Class;
use vc_graph::{AssetLibrary, Bounds, Draft, SceneGraph, Seed};

/// Makes things that a scene lacks.
///
/// A generator of objects implements it with assets; [`PlainStock`] does with what
/// the scene and its class table know.
pub trait Stock {
    /// A thing of a class, not yet anywhere; `None` if the stock has none. What it is
    /// made of goes into `assets`, the scene's own library with what was added
    /// before. The same seed gives the same thing.
    fn thing(&self, class: &Class, seed: Seed, scene: &SceneGraph, assets: &mut AssetLibrary) -> Option<Draft>;
}

/// Copies of things of the same class in the scene; else boxes of the class's typical
/// size.
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

//! Targets: things that can be looked at.

use std::sync::Arc;

use vc_geometry::tree::BoxTree;
use vc_graph::Aabb;

use crate::body::Body;

/// The lookable bodies of a scene, a small part of all.
#[derive(Debug, Clone, Default)]
pub(crate) struct Targets {
    /// Their numbers, sorted.
    items: Vec<u32>,
    tree: BoxTree,
}

impl Targets {
    pub(crate) fn new(bodies: &[Option<Arc<Body>>]) -> Self {
        let (items, regions): (Vec<u32>, Vec<Aabb>) =
            (0..).zip(bodies).filter_map(|(item, body)| Some((item, region(body)?))).unzip();
        Self { items, tree: BoxTree::new(&regions) }
    }

    /// Whether a body is a target still, or was none before either.
    pub(crate) fn takes(&self, item: usize, body: &Option<Arc<Body>>) -> bool {
        region(body).is_none() || self.items.binary_search(&(item as u32)).is_ok()
    }

    /// Updates a body that has moved, come or gone, if it is a target.
    pub(crate) fn set(&mut self, item: usize, body: &Option<Arc<Body>>) {
        if let Ok(place) = self.items.binary_search(&(item as u32)) {
            self.tree.set(place, region(body).unwrap_or(Aabb::EMPTY));
        }
    }

    /// Calls `found` with every target that overlaps a region, in unspecified order.
    pub(crate) fn each(&self, region: &Aabb, mut found: impl FnMut(usize)) {
        self.tree.for_each(region, |place| found(self.items[place] as usize));
    }
}

/// The region of a body, if it is lookable.
fn region(body: &Option<Arc<Body>>) -> Option<Aabb> {
    body.as_ref().filter(|b| b.traits.lookable).map(|b| b.region)
}

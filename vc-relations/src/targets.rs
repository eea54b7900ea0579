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

    /// Updates a body that has moved, come or gone. `None` if it was not a target before and is one now.
    pub(crate) fn set(&mut self, item: usize, body: &Option<Arc<Body>>) -> Option<()> {
        match (self.items.binary_search(&(item as u32)), region(body)) {
            (Ok(place), now) => self.tree.set(place, now.unwrap_or(Aabb::EMPTY)),
            (Err(_), Some(_)) => return None,
            (Err(_), None) => {}
        }
        Some(())
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

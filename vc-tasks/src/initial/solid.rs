//! Obstacles: the bounding boxes of all objects and of their parts.

use nalgebra::{Point3, Vector3};
use vc_graph::asset::Part;
use vc_graph::{Aabb, AssetLibrary, Bounds, BoundsFrame, Node, NodeId, NodeKind, Pose, SceneGraph};

/// The depth by which boxes may overlap before they count as colliding, metres.
const TOUCH: f32 = 0.002;

/// The bounding boxes of all objects in a scene.
#[derive(Debug, Clone)]
pub(super) struct Solids {
    boxes: Vec<(NodeId, Aabb)>,
}

impl Solids {
    pub(super) fn new(graph: &SceneGraph) -> Self {
        let things = graph.nodes().filter(|n| n.kind() != NodeKind::Room);
        Self { boxes: things.filter_map(|n| Some((n.id(), n.aabb()?))).collect() }
    }

    /// Adds the box of a newly placed object.
    pub(super) fn add(&mut self, id: NodeId, aabb: Aabb) {
        self.boxes.push((id, aabb));
    }

    /// Finds an object that collides with a box, other than the nodes in `besides`.
    ///
    /// Costs a test of every object's box, and of the parts of those that overlap it.
    pub(super) fn hit(
        &self,
        graph: &SceneGraph,
        assets: &AssetLibrary,
        aabb: &Aabb,
        besides: &[NodeId],
    ) -> Option<NodeId> {
        let near = self.boxes.iter().filter(|(id, other)| meet(aabb, other) && !besides.contains(id));
        let solid = |id: NodeId| graph.node(id).is_some_and(|n| part_boxes(n, assets).any(|b| meet(aabb, &b)));
        near.map(|(id, _)| *id).find(|&id| solid(id))
    }
}

/// Whether two boxes overlap.
pub(super) fn meet(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] + TOUCH < b.max[i] && b.min[i] + TOUCH < a.max[i])
}

/// The boxes of an object's parts in the world; its own box if it has no parts.
pub(super) fn part_boxes<'a>(node: &'a Node, assets: &'a AssetLibrary) -> impl Iterator<Item = Aabb> + 'a {
    let asset = node.spec().asset.and_then(|id| assets.get(id)).filter(|asset| !asset.parts.is_empty());
    let whole = node.aabb().filter(|_| asset.is_none());
    let parts = asset.into_iter().flat_map(|asset| &asset.parts);
    parts.filter_map(|part| part_box(part, node.spec().scale, node.pose()?).into()).chain(whole)
}

fn part_box(part: &Part, scale: Vector3<f32>, pose: &Pose) -> Aabb {
    let (low, high) = part.extent();
    let scaled = |p: Point3<f32>| p.coords.component_mul(&scale);
    let (low, high) = (scaled(low), scaled(high));
    Bounds { offset: (low + high) / 2.0, half: (high - low) / 2.0, frame: BoundsFrame::Object }.aabb(pose)
}

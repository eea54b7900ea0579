//! The extent of a node as it is drawn.

use vc_graph::{Aabb, NodeId};

use super::{Instance, Snapshot};
use crate::math::point;

impl Snapshot {
    /// The axis-aligned box in the world around a node as it is drawn, metres: with its doors and limbs in
    /// their current positions, and curtains open or closed. `None` if it has no body or is hidden. Costs a few
    /// operations for each corner of its triangles.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::Renderer;
    /// let mut scene = SceneBuilder::new("table");
    /// let plate = Draft::new("plate").bounds(Bounds::standing([0.2, 0.2, 0.02].into()));
    /// let plate = scene.add(plate.at(Pose::translation(1.0, 0.0, 0.7)))?;
    /// let drawn = Renderer::new().snapshot(&scene.build())?.bounds(plate);
    /// assert!(drawn.is_some_and(|drawn| (drawn.max.x - 1.1).abs() < 1e-5 && (drawn.min.z - 0.7).abs() < 1e-5));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bounds(&self, node: NodeId) -> Option<Aabb> {
        let body = self.body_of(node)?;
        let own = &self.instances[body.instances.start as usize..body.instances.end as usize];
        own.iter().filter(|i| i.is_there()).flat_map(corners).fold(None, |all, corner| {
            let all = all.unwrap_or(Aabb { min: corner, max: corner });
            Some(Aabb { min: all.min.inf(&corner), max: all.max.sup(&corner) })
        })
    }
}

/// Corners of all triangles in the world.
fn corners(instance: &Instance) -> impl Iterator<Item = nalgebra::Point3<f32>> + '_ {
    let (mesh, world) = (&*instance.link.levels[0], instance.world.narrow());
    let triangles =
        mesh.clusters.iter().flat_map(|cluster| cluster.triangles.clone().map(move |t| (cluster, t as usize)));
    triangles.flat_map(move |(cluster, triangle)| mesh.triangle(cluster, triangle).map(|at| point(&world, at).into()))
}

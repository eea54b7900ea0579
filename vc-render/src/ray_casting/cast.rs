//! Ray casting for distance measurements: lidar, line-of-sight tests, picking.

use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use vc_graph::NodeId;

use super::scene::Tracer;
use crate::RenderError;
use crate::bvh::Ray;
use crate::math::three;
use crate::scene::Snapshot;

/// Casts rays in a scene, against the finest meshes.
///
/// The bounding volume hierarchy is eight wide and built by the surface area heuristic over bins (Wald 2007);
/// the boxes of a node are tested together (Wald, Benthin and Boulos 2008); triangles are intersected as in
/// Möller and Trumbore 1997.
///
/// ```
/// use nalgebra::{Point3, Vector3};
/// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{RayCaster, Renderer};
///
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// let caster = RayCaster::new(&Renderer::new().snapshot(&scene.build())?);
///
/// let hit = caster.first(&Point3::new(0.0, 0.0, 1.0), &Vector3::x(), 10.0).ok_or("nothing is met")?;
/// assert_eq!(hit.node, fridge);
/// assert!((hit.distance - 1.7).abs() < 1e-5 && (hit.normal + Vector3::x()).norm() < 1e-5);
/// assert!(!caster.sees(&Point3::new(0.0, 0.0, 1.0), &Point3::new(4.0, 0.0, 1.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct RayCaster {
    tracer: Tracer,
}

/// The first hit of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RayHit {
    /// Distance from the ray's start, metres.
    pub distance: f32,
    /// The hit point in the world.
    pub point: Point3<f32>,
    /// Normal of the triangle, outwards, unit length.
    pub normal: Vector3<f32>,
    /// The graph's node.
    pub node: NodeId,
    /// Position of the part in the node's asset.
    pub part: u16,
}

impl RayCaster {
    /// A ray caster for a scene at one moment. Costs about a microsecond for each triangle.
    pub fn new(snapshot: &Snapshot) -> Self {
        Self { tracer: Tracer::new(snapshot) }
    }

    /// Switches to another moment of the same scene.
    ///
    /// Standing bodies are in one tree. Bodies that have moved since it was built use their mesh's own tree,
    /// shared by all instances of the mesh, under a tree of boxes that is rebuilt each time. A call costs some
    /// tens of microseconds, more when a body moves for the first time. Rays become slower the more bodies have
    /// moved, so if most of them have, a new caster is better.
    ///
    /// # Errors
    /// [`RenderError::OtherScene`] if bodies have come or gone; the caster is then unchanged.
    pub fn follow(&mut self, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.tracer.follow(snapshot)
    }

    /// The first hit of a ray within `reach` metres, glass included, from either side. Also `None` for a
    /// direction of length zero and for numbers that are not finite.
    ///
    /// Costs a fraction of a microsecond.
    pub fn first(&self, from: &Point3<f32>, along: &Vector3<f32>, reach: f32) -> Option<RayHit> {
        let ray = ray(from, &along.try_normalize(1e-12)?, reach)?;
        self.tracer.touched(&ray).map(|met| RayHit {
            distance: met.t,
            point: three(|i| ray.from[i] + met.t * ray.along[i]).into(),
            normal: met.flat.into(),
            node: self.tracer.snapshot.bodies[met.body as usize].node,
            part: met.part,
        })
    }

    /// Calls [`Self::first`] for many rays in parallel.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// use vc_render::{RayCaster, Renderer};
    /// let caster = RayCaster::new(&Renderer::new().snapshot(&scene)?);
    /// // A planar lidar of 36 beams.
    /// let beam = |i: usize| {
    ///     let (sine, cosine) = (i as f32 / 36.0 * std::f32::consts::TAU).sin_cos();
    ///     (Point3::new(0.0, 0.0, 1.0), Vector3::new(cosine, sine, 0.0))
    /// };
    /// let beams: Vec<_> = (0..36).map(beam).collect();
    /// let hits = caster.first_of_each(&beams, 10.0);
    /// assert!(hits[0].is_some_and(|hit| (hit.distance - 1.7).abs() < 1e-4) && hits[18].is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_of_each(&self, rays: &[(Point3<f32>, Vector3<f32>)], reach: f32) -> Vec<Option<RayHit>> {
        rays.par_iter().with_min_len(256).map(|(from, along)| self.first(from, along, reach)).collect()
    }

    /// Whether no opaque thing is between two points; glass does not block the view.
    pub fn sees(&self, from: &Point3<f32>, to: &Point3<f32>) -> bool {
        let way = to - from;
        let Some(along) = way.try_normalize(1e-12) else { return from == to };
        ray(from, &along, way.norm()).is_some_and(|ray| !self.tracer.blocked(&ray))
    }
}

fn ray(from: &Point3<f32>, along: &Vector3<f32>, reach: f32) -> Option<Ray> {
    let finite = from.iter().chain(along.iter()).all(|v| v.is_finite()) && reach > 0.0;
    finite.then(|| Ray { from: (*from).into(), along: (*along).into(), end: reach })
}

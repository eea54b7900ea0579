//! Queries about space: nodes within a distance, nearest points, rays, lines of sight.

use nalgebra::{Point3, Vector3};
use rapier3d::geometry::{Collider, ColliderHandle, Ray, Shape};
use rapier3d::math::{Pose as EnginePose, Vector};
use rapier3d::pipeline::QueryFilter;
use vc_graph::NodeId;

use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{PhysicsError, convert, group};

/// # Spatial queries
impl PhysicsWorld {
    /// The nodes with some part within a distance of a point, with their distances, nearest first; walls and floors
    /// included. Metres.
    pub(crate) fn within(&self, centre: Point3<f32>, radius: f32) -> Vec<(NodeId, f32)> {
        if !centre.iter().all(|c| c.abs() <= convert::FARTHEST) || !radius.is_finite() || radius < 0.0 {
            return Vec::new();
        }
        let radius = radius.min(convert::FARTHEST);
        let ball = rapier3d::parry::shape::Ball::new(radius.max(1e-4));
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors());
        let at = EnginePose::from_translation(convert::point(centre));
        let mut found: Vec<(NodeId, f32)> = Vec::new();
        for (_, collider) in queries.intersect_shape(at, &ball) {
            let distance = collider.shape().distance_to_point(collider.position(), convert::point(centre), true);
            found.push((group::marked(collider.user_data).0, distance));
        }
        found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        found.dedup_by_key(|f| f.0);
        found.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        found
    }

    /// The first node that a ray from one point to another hits, and the point of the hit, metres. Nodes in `ignored`
    /// are transparent.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Point3;
    /// let (above, below) = (Point3::new(1.0, 0.0, 2.0), Point3::new(1.0, 0.0, 0.1));
    /// assert_eq!(world.ray(above, below, &[]).map(|hit| hit.0), Some(home.cup));
    /// assert_eq!(world.ray(above, below, &[home.cup]).map(|hit| hit.0), Some(home.table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn ray(&self, from: Point3<f32>, to: Point3<f32>, ignored: &[NodeId]) -> Option<(NodeId, Point3<f32>)> {
        let way = to - from;
        if !convert::is_finite(&way) || way.norm() < 1e-6 {
            return None;
        }
        let solid = |_: ColliderHandle, c: &Collider| !ignored.contains(&group::marked(c.user_data).0);
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&solid));
        let ray = Ray::new(convert::point(from), convert::vector(way));
        let (collider, at) = queries.cast_ray(&ray, 1.0, true)?;
        Some((self.node_of(collider)?, from + way * at))
    }

    /// The point of a thing's shapes that is nearest to a point.
    pub(crate) fn nearest_point(&self, thing: &Thing, to: Point3<f32>) -> Option<Point3<f32>> {
        let bodies = thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let points = colliders.map(|c| c.shape().project_point(c.position(), convert::point(to), true).point);
        let points = points.map(convert::point3);
        points.min_by(|a, b| (a - to).norm_squared().total_cmp(&(b - to).norm_squared()))
    }

    /// The height of the lowest point of a thing's shapes, metres.
    pub(crate) fn lowest(&self, thing: &Thing) -> Option<f32> {
        let bodies = thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        colliders.map(|c| lowest(c.shape(), c.position())).reduce(f32::min)
    }

    /// Distance of a point from the nearest point of a thing.
    pub(crate) fn distance_to(&self, id: NodeId, point: Point3<f32>) -> Result<f32, PhysicsError> {
        let thing = self.thing(id)?;
        let bodies = thing.bodies().filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let each = colliders.map(|c| c.shape().distance_to_point(c.position(), convert::point(point), true));
        each.reduce(f32::min).ok_or(PhysicsError::NoBody(id))
    }

    pub(crate) fn sees(&self, eye: Point3<f32>, id: NodeId, ignored: &[NodeId]) -> Result<bool, PhysicsError> {
        self.thing(id)?;
        let aabb = self.aabb(id).ok_or(PhysicsError::NoBody(id))?;
        let (centre, half) = (aabb.centre(), (aabb.max - aabb.min) * 0.45);
        let corner = |i: u32| {
            let sign = |bit: u32| if i >> bit & 1 == 0 { -1.0 } else { 1.0 };
            centre + Vector3::new(sign(0) * half.x, sign(1) * half.y, sign(2) * half.z)
        };
        let clear = |to: Point3<f32>| match self.ray(eye, to, ignored) {
            None => true,
            Some((hit, _)) => hit == id,
        };
        Ok(std::iter::once(centre).chain((0..8).map(corner)).any(clear))
    }
}

/// The height of the lowest point of a shape. A compound's box is wider than that of its turned pieces.
fn lowest(shape: &dyn Shape, at: &EnginePose) -> f32 {
    match (shape.as_compound(), shape.as_support_map()) {
        (Some(pieces), _) => {
            let each = pieces.shapes().iter().map(|(own, piece)| lowest(&**piece, &(*at * *own)));
            each.fold(f32::INFINITY, f32::min)
        }
        (None, Some(solid)) => solid.support_point(at, -Vector::Z).z,
        (None, None) => shape.compute_aabb(at).mins.z,
    }
}

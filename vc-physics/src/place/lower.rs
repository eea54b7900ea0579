//! Lowering things onto the support right below them.

use nalgebra::Vector3;
use rapier3d::geometry::{Collider, ColliderHandle};
use rapier3d::parry::query::ShapeCastOptions;
use rapier3d::pipeline::QueryFilter;
use vc_graph::{NodeId, Pose};

use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

/// The gap that is left, metres: a thing at this distance rests at once.
const GAP: f32 = 0.0005;

impl PhysicsWorld {
    /// Lowers a loose thing until it almost touches its support, by at most `within` metres, so that it need
    /// not fall; returns the distance. A thing without a support within that distance is not lowered.
    ///
    /// Costs some ten microseconds.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.place(home.cup, vc_graph::Pose::translation(1.0, 0.3, 0.79))?;
    /// let by = world.lower(home.cup, 0.1)?;
    /// assert!((by - 0.05).abs() < 2e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lower(&mut self, id: NodeId, within: f32) -> Result<f32, PhysicsError> {
        let thing = self.thing(id)?;
        let (base, loose) = (self.engine.pose(thing.state.base), thing.state.role == BodyRole::Loose);
        let Some(pose) = base.filter(|_| loose && within > GAP) else { return Ok(0.0) };
        let bodies: Vec<_> = thing.bodies().filter_map(|b| self.engine.bodies.get(b)).collect();
        let own = bodies.iter().flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let other = |_: ColliderHandle, c: &Collider| group::is_solid(c) && group::marked(c.user_data).0 != id;
        let queries = self.engine.queries(QueryFilter::default().exclude_sensors().predicate(&other));
        let options =
            ShapeCastOptions { max_time_of_impact: within, stop_at_penetration: false, ..ShapeCastOptions::default() };
        let down = convert::vector(-Vector3::z());
        let gap = |c: &Collider| queries.cast_shape(c.position(), down, c.shape(), options);
        let gaps = own.filter_map(gap).map(|(_, hit)| hit.time_of_impact);
        let Some(by) = gaps.reduce(f32::min).map(|gap| gap - GAP).filter(|by| *by > 0.0) else { return Ok(0.0) };
        self.place(id, Pose::translation(0.0, 0.0, -by) * pose)?;
        Ok(by)
    }
}

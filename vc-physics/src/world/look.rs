//! Reading a world.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::{RigidBody, RigidBodyHandle};
use vc_graph::{Aabb, NodeId, Pose};

use super::PhysicsWorld;
use crate::{BodyRole, Settings, convert};

impl PhysicsWorld {
    /// Where a node is: its base, as in the scene graph; an agent's feet. `None`
    /// without a body.
    pub fn pose(&self, id: NodeId) -> Option<Pose> {
        match self.thing(id) {
            Ok(thing) => self.engine.pose(thing.state.base),
            Err(_) => self.agents.get(&id).map(|a| a.pose()),
        }
    }

    /// The nodes that have bodies, agents with them, in the order of their numbers.
    pub fn nodes(&self) -> Vec<NodeId> {
        let mut all: Vec<NodeId> = self.things.iter().map(|t| t.id).chain(self.agents.keys().copied()).collect();
        all.sort_unstable();
        all
    }

    /// Poses of all nodes that have bodies, in the order of their numbers. Costs
    /// some nanoseconds each.
    pub fn poses(&self) -> Vec<(NodeId, Pose)> {
        self.nodes().into_iter().filter_map(|id| Some((id, self.pose(id)?))).collect()
    }

    /// Where a moving part is, in the world's frame: its asset's origin, moved as the
    /// part has moved. Part numbers are those of [`moving_parts`](Self::moving_parts).
    pub fn part_pose(&self, id: NodeId, part: usize) -> Option<Pose> {
        let thing = self.thing(id).ok()?;
        let joint = thing.form.links.get(part + 1)?.joint?;
        Some(self.engine.pose(thing.state.base)? * joint.motion(self.part_position(thing, part)?))
    }

    /// How a node takes part; `None` without a body.
    pub fn role(&self, id: NodeId) -> Option<BodyRole> {
        self.thing(id).ok().map(|t| t.state.role)
    }

    fn body(&self, id: NodeId) -> Option<&RigidBody> {
        self.engine.bodies.get(self.thing(id).ok()?.state.base)
    }

    /// Velocity of a node's centre of mass, metres a second.
    pub fn velocity(&self, id: NodeId) -> Option<Vector3<f32>> {
        self.body(id).map(|b| convert::vector3(b.linvel()))
    }

    /// How fast a node turns, radians a second around each axis of the world.
    pub fn spin(&self, id: NodeId) -> Option<Vector3<f32>> {
        self.body(id).map(|b| convert::vector3(b.angvel()))
    }

    /// Mass of a node, its moving parts with it, kilograms.
    pub fn mass(&self, id: NodeId) -> Option<f32> {
        self.thing(id).ok().map(|t| t.form.mass() * t.state.mass_factor)
    }

    /// Mass of a node as its asset is modelled, by parts and densities, kilograms. It
    /// differs from [`mass`](Self::mass) where no member of the class has such a mass
    /// and [`Settings::class_masses`] is on.
    pub fn modelled_mass(&self, id: NodeId) -> Option<f32> {
        self.thing(id).ok().map(|t| t.form.mass())
    }

    /// Centre of mass of a node's base, in the world's frame, metres.
    pub fn centre_of_mass(&self, id: NodeId) -> Option<Point3<f32>> {
        self.body(id).map(|b| convert::point3(b.center_of_mass()))
    }

    /// The box around a node's shapes as they are now, moving parts with them.
    pub fn aabb(&self, id: NodeId) -> Option<Aabb> {
        let thing = self.thing(id).ok()?;
        let mut around = self.box_around(thing.bodies())?;
        // The ground below a floor is no part of the floor.
        around.min.z += thing.state.ground;
        Some(around)
    }

    /// The box around a node's shapes in the node's own frame, moving parts where its asset has them: its lowest and
    /// its highest corner, metres. An agent has none.
    pub fn own_box(&self, id: NodeId) -> Option<(Point3<f32>, Point3<f32>)> {
        self.thing(id).ok().map(|t| t.form.extent)
    }

    /// The point of a node's shapes, moving parts with them, that is nearest to a point; the point itself where a
    /// shape is around it. `None` without a body, and for agents.
    pub fn nearest_point(&self, id: NodeId, to: Point3<f32>) -> Option<Point3<f32>> {
        let bodies = self.thing(id).ok()?.bodies().filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let points = colliders.map(|c| c.shape().project_point(c.position(), convert::point(to), true).point);
        let points = points.map(convert::point3);
        points.min_by(|a, b| (a - to).norm_squared().total_cmp(&(b - to).norm_squared()))
    }

    /// The box around some bodies.
    pub(crate) fn box_around(&self, bodies: impl Iterator<Item = RigidBodyHandle>) -> Option<Aabb> {
        let bodies = bodies.filter_map(|b| self.engine.bodies.get(b));
        let colliders = bodies.flat_map(|b| b.colliders()).filter_map(|&c| self.engine.colliders.get(c));
        let boxes = colliders.map(|c| c.compute_aabb());
        let joint = boxes.reduce(|a, b| rapier3d::parry::bounding_volume::BoundingVolume::merged(&a, &b))?;
        Some(Aabb { min: convert::point3(joint.mins), max: convert::point3(joint.maxs) })
    }

    /// Whether a node's body sleeps: it lies still until something disturbs it. What
    /// is fixed always does.
    pub fn is_asleep(&self, id: NodeId) -> bool {
        self.body(id).is_none_or(|b| b.is_sleeping() || b.is_fixed())
    }

    /// Number of bodies that are awake.
    pub fn awake(&self) -> usize {
        self.engine.awake()
    }

    /// Steps that have passed.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Time that has passed, seconds.
    pub fn time(&self) -> f64 {
        self.ticks as f64 * f64::from(self.settings.dt)
    }

    /// The settings it was built with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Nodes that became non-finite, flew off or fell below everything, in the order in which they
    /// did: they stand still where they last were, and nothing touches them until they are
    /// [placed](Self::place) elsewhere.
    pub fn stopped(&self) -> &[NodeId] {
        &self.stopped
    }

    /// Number of bodies, and of convex pieces they collide with.
    pub fn size(&self) -> (usize, usize) {
        let pieces = |t: &super::Thing| t.form.links.iter().map(crate::shapes::Link::pieces).sum::<usize>();
        (self.engine.bodies.len(), self.things.iter().map(pieces).sum())
    }
}

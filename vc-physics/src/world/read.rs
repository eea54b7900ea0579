//! Reading a world.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBody;
use rapier3d::geometry::ColliderHandle;
use vc_graph::{Aabb, NodeId, Pose};

use super::PhysicsWorld;
use crate::shapes::Link;
use crate::state::Thing;
use crate::{BodyRole, Settings, convert};

/// # State
impl PhysicsWorld {
    /// The pose of a node's base, as in the scene graph, or of an agent's feet. `None` without a body.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let cup = world.pose(home.cup).ok_or("no body")?;
    /// assert_eq!(cup.translation.vector, nalgebra::Vector3::new(1.0, 0.0, 0.741));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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

    /// The poses of all nodes that have bodies, in the order of their numbers. Costs some nanoseconds each.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// for (id, pose) in world.poses() {
    ///     assert!(pose.translation.z > -0.01, "{id} is below the floor");
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn poses(&self) -> Vec<(NodeId, Pose)> {
        self.nodes().into_iter().filter_map(|id| Some((id, self.pose(id)?))).collect()
    }

    /// The pose of a moving part in the world's frame: that of its asset's origin, moved as the part has moved. Part
    /// numbers are those of [`moving_parts`](Self::moving_parts).
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.put_open(home.cabinet, 0, 1.0)?;
    /// let drawer = world.part_pose(home.cabinet, 0).ok_or("no such part")?;
    /// assert!((drawer.translation.x - -1.2).abs() < 1e-4); // The cabinet is at -1.5, and the drawer slides out 0.3 m.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn part_pose(&self, id: NodeId, part: usize) -> Option<Pose> {
        let thing = self.thing(id).ok()?;
        let joint = thing.form.links.get(part + 1)?.joint?;
        Some(self.engine.pose(thing.state.base)? * joint.motion(self.part_position(thing, part)?))
    }

    /// The role of a node's body; `None` without a body.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_physics::BodyRole;
    /// assert_eq!(world.role(home.floor), Some(BodyRole::Fixed));
    /// assert_eq!(world.role(home.cup), Some(BodyRole::Loose));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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

    /// Angular velocity of a node, radians a second around each axis of the world.
    pub fn angular_velocity(&self, id: NodeId) -> Option<Vector3<f32>> {
        self.body(id).map(|b| convert::vector3(b.angvel()))
    }

    /// Mass of a node, its moving parts with it, kilograms.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// // A cup weighs at most 0.3 kg by the class table.
    /// assert_eq!(world.mass(home.cup), Some(0.3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mass(&self, id: NodeId) -> Option<f32> {
        self.thing(id).ok().map(|t| t.form.mass() * t.state.mass_factor)
    }

    /// Mass of a node as its asset is modelled, by parts and densities, kilograms. It
    /// differs from [`mass`](Self::mass) where no member of the class has such a mass
    /// and [`Settings::class_masses`] is on.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// // A solid cylinder of wood, 600 kg a cubic metre.
    /// let modelled = std::f32::consts::PI * 0.04 * 0.04 * 0.1 * 600.0;
    /// assert!(world.modelled_mass(home.cup).is_some_and(|mass| (mass - modelled).abs() < 1e-3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn modelled_mass(&self, id: NodeId) -> Option<f32> {
        self.thing(id).ok().map(|t| t.form.mass())
    }

    /// Centre of mass of a node's base, in the world's frame, metres.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let centre = world.centre_of_mass(home.cup).ok_or("no body")?;
    /// assert!((centre.z - 0.791).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn centre_of_mass(&self, id: NodeId) -> Option<Point3<f32>> {
        self.body(id).map(|b| convert::point3(b.center_of_mass()))
    }

    /// The box around a node's shapes as they are now, moving parts with them.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let table = world.aabb(home.table).ok_or("no body")?;
    /// assert!((table.max.z - 0.74).abs() < 1e-4 && (table.max.y - 0.7).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn aabb(&self, id: NodeId) -> Option<Aabb> {
        let thing = self.thing(id).ok()?;
        let bodies = thing.bodies().filter_map(|body| self.engine.bodies.get(body));
        let mut around = self.box_around(bodies.flat_map(|body| body.colliders()).copied())?;
        // The ground below a floor is no part of the floor.
        around.min.z += thing.state.ground;
        Some(around)
    }

    /// The box around a node's shapes in the node's own frame, moving parts where its asset has them: its lowest and
    /// its highest corner, metres. An agent has none.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// let (low, high) = world.local_bounds(home.cup).ok_or("no body")?;
    /// assert!((high.z - low.z - 0.1).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn local_bounds(&self, id: NodeId) -> Option<(Point3<f32>, Point3<f32>)> {
        self.thing(id).ok().map(|t| t.form.extent)
    }

    /// The box around some colliders.
    pub(crate) fn box_around(&self, colliders: impl Iterator<Item = ColliderHandle>) -> Option<Aabb> {
        let colliders = colliders.filter_map(|c| self.engine.colliders.get(c));
        let boxes = colliders.map(|c| c.compute_aabb());
        let joint = boxes.reduce(|a, b| rapier3d::parry::bounding_volume::BoundingVolume::merged(&a, &b))?;
        Some(Aabb { min: convert::point3(joint.mins), max: convert::point3(joint.maxs) })
    }

    /// Whether a node's body sleeps: it lies still until something disturbs it. Fixed bodies always do.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(!world.is_asleep(home.cup));
    /// world.settle(300);
    /// assert!(world.is_asleep(home.cup));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.run(60);
    /// assert!((world.time() - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
        let pieces = |t: &Thing| t.form.links.iter().map(Link::pieces).sum::<usize>();
        (self.engine.bodies.len(), self.things.iter().map(pieces).sum())
    }
}

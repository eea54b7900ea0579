//! Reading a world.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::RigidBody;
use rapier3d::geometry::ColliderHandle;
use vc_graph::{Aabb, NodeId, Pose};

use super::PhysicsWorld;
use crate::shapes::Link;
use crate::state::Thing;
use crate::{BodyRole, Settings, convert, group};

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

    /// The nodes that may have moved, turned a part or changed their role since [`forget_moved`](Self::forget_moved),
    /// by number; at first, and in a restored world, all. Some may be where they were; none that has a body is missed. It
    /// follows from what has been awake or was changed by hand, so it costs nothing for what sleeps.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// world.forget_moved();
    /// assert!(world.moved().is_empty());
    /// world.put_open(home.cabinet, None, 1.0)?;
    /// assert!(world.moved().contains(&home.cabinet));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn moved(&self) -> Vec<NodeId> {
        let marks = self.engine.moved().into_iter().map(|body| body.user_data);
        let own = marks.filter(|mark| !group::is_around(*mark));
        let mut nodes: Vec<NodeId> = own.map(|mark| group::marked(mark).0).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// Says that everything has been read: [`moved`](Self::moved) begins anew.
    pub fn forget_moved(&mut self) {
        self.engine.forget_moved();
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

    /// The box around a node's shapes as they are now, moving parts with them; of what is tilted it is the box around its
    /// tilted box, which may be larger.
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

    /// The pose of a moving part in the world's frame.
    pub(crate) fn part_pose(&self, id: NodeId, part: usize) -> Option<Pose> {
        let thing = self.thing(id).ok()?;
        let joint = thing.form.links.get(part + 1)?.joint?;
        Some(self.engine.pose(thing.state.base)? * joint.motion(self.part_position(thing, part)?))
    }

    /// The velocity of a thing's centre of mass, metres a second.
    pub(crate) fn velocity(&self, thing: &Thing) -> Vector3<f32> {
        self.base(thing).map_or_else(Vector3::zeros, |base| convert::vector3(base.linvel()))
    }

    /// The centre of mass of a thing's base, in the world's frame, metres.
    pub(crate) fn centre_of_mass(&self, thing: &Thing) -> Option<Point3<f32>> {
        self.base(thing).map(|base| convert::point3(base.center_of_mass()))
    }

    pub(crate) fn is_asleep(&self, thing: &Thing) -> bool {
        self.base(thing).is_none_or(|base| base.is_sleeping() || base.is_fixed())
    }

    pub(crate) fn base(&self, thing: &Thing) -> Option<&RigidBody> {
        self.engine.bodies.get(thing.state.base)
    }

    /// The box around some colliders.
    pub(crate) fn box_around(&self, colliders: impl Iterator<Item = ColliderHandle>) -> Option<Aabb> {
        let colliders = colliders.filter_map(|c| self.engine.colliders.get(c));
        let boxes = colliders.map(|c| c.compute_aabb());
        let joint = boxes.reduce(|a, b| rapier3d::parry::bounding_volume::BoundingVolume::merged(&a, &b))?;
        Some(Aabb { min: convert::point3(joint.mins), max: convert::point3(joint.maxs) })
    }

    /// The things of which a body is awake, by number.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// world.wake(home.cup)?;
    /// world.step();
    /// assert_eq!(world.awake_things(), [home.cup]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn awake_things(&self) -> Vec<NodeId> {
        let awake = self.engine.awake_bodies().filter_map(|body| self.engine.bodies.get(body));
        let moving = awake.filter(|body| body.is_dynamic() && !body.is_sleeping());
        let mut things: Vec<NodeId> = moving.map(|body| group::marked(body.user_data).0).collect();
        things.sort_unstable();
        things.dedup();
        things.retain(|id| self.index(*id).is_ok());
        things
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

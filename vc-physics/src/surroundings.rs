//! The surroundings of a world: fixed bodies of the worlds beside it, on which its things go on where it ends.

use nalgebra::Vector3;
use rapier3d::dynamics::{RigidBody, RigidBodyBuilder, RigidBodyHandle};
use rapier3d::geometry::{ColliderBuilder, SharedShape};
use vc_graph::{Aabb, Node, NodeId, Pose, SceneGraph};

use crate::role::Roles;
use crate::shapes::ShapeCache;
use crate::world::{HEADROOM, PhysicsWorld};
use crate::{BodyRole, PhysicsError, convert, group};

/// # What stands around
impl PhysicsWorld {
    /// Adds what stands fixed in another scene, of the nodes that are wanted, at poses that are taken over by a
    /// transformation. These bodies are in the way and carry, as walls and floors do, but are no things of this world: only
    /// [contacts](Self::contacts) and [rays](Self::ray) tell their numbers. Returns how many there are.
    ///
    /// Costs as much as to build them.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// let beside = Pose::translation(20.0, 0.0, 0.0);
    /// let bodies = world.surround(&home.graph, |node| node.id() == home.floor, &beside);
    /// world.place(home.cup, Pose::translation(20.0, 0.0, 0.05))?;
    /// world.settle(300);
    /// assert_eq!((bodies, world.supports(home.cup)), (1, vec![home.floor]));
    /// assert!(world.outside().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn surround(&mut self, scene: &SceneGraph, wanted: impl Fn(&Node) -> bool, shift: &Pose) -> usize {
        let (roles, shapes, before) = (Roles::new(scene, self.settings), ShapeCache::new(), self.engine.bodies.len());
        shapes.session(scene.assets(), |session| {
            for node in scene.nodes().filter(|node| wanted(node)) {
                let Some(pose) = node.pose().map(|pose| shift * pose).filter(convert::is_sound) else { continue };
                let Some(form) = session.form(scene, node).filter(|form| form.is_of_this_world()) else { continue };
                let class = scene.classes().get(node.class());
                let link = &form.links[0];
                let fixed = roles.role(node, class, &form, form.mass()) == Some(BodyRole::Fixed);
                if let Some((shape, at)) = link.solid.as_ref().filter(|_| fixed) {
                    self.add_around(group::mark(node.id(), group::AROUND), &pose, link.collider(shape, at, 1.0));
                }
            }
        });
        self.engine.bodies.len() - before
    }

    /// Adds a box that is in the way as a shut door is, around a pose; contacts and rays tell a number for it. It is in the
    /// way until [`set_barred`](Self::set_barred) says otherwise.
    ///
    /// # Errors
    /// [`PhysicsError::NotFinite`].
    pub fn bar(&mut self, id: NodeId, pose: Pose, size: Vector3<f32>) -> Result<(), PhysicsError> {
        if !convert::is_sound(&pose) || !convert::is_finite(&size) {
            return Err(PhysicsError::NotFinite("the pose", id));
        }
        let half = size.abs() / 2.0;
        let shape = ColliderBuilder::new(SharedShape::cuboid(half.x, half.y, half.z));
        self.add_around(group::mark(id, group::BAR), &pose, shape);
        self.find_bars();
        Ok(())
    }

    /// Lets the box of a number be in the way, or not; whatever leans on it then falls.
    pub fn set_barred(&mut self, id: NodeId, barred: bool) {
        let bars: Vec<RigidBodyHandle> = self.bars_of(id).collect();
        bars.into_iter().for_each(|bar| self.engine.set_enabled(bar, barred));
    }

    /// Whether the box of a number is in the way; there may be none.
    pub fn is_barred(&self, id: NodeId) -> bool {
        self.bars_of(id).filter_map(|bar| self.engine.bodies.get(bar)).any(RigidBody::is_enabled)
    }

    fn bars_of(&self, id: NodeId) -> impl Iterator<Item = RigidBodyHandle> + '_ {
        self.bars.iter().filter(move |(own, _)| *own == id).map(|(_, bar)| *bar)
    }

    /// Finds the boxes again that are in the way at times.
    pub(crate) fn find_bars(&mut self) {
        let marks = self.engine.bodies.iter().map(|(handle, body)| (group::marked(body.user_data), handle));
        self.bars = marks.filter(|((_, link), _)| *link == group::BAR).map(|((id, _), bar)| (id, bar)).collect();
    }

    fn add_around(&mut self, mark: u128, pose: &Pose, collider: ColliderBuilder) {
        let body = self.engine.add_body(RigidBodyBuilder::fixed().pose(convert::pose(pose)).user_data(mark));
        let collider = collider.collision_groups(group::base(BodyRole::Fixed)).user_data(mark);
        self.engine.add_collider(collider.build(), body);
    }

    /// The boxes in which things are that rest on what stands around.
    pub(crate) fn around(&self) -> impl Iterator<Item = Aabb> + '_ {
        let bodies = self.engine.bodies.iter().map(|(_, body)| body).filter(|body| group::is_around(body.user_data));
        bodies.filter_map(|body| {
            let own = self.box_around(body.colliders().iter().copied())?;
            Some(Aabb { max: own.max + Vector3::z() * HEADROOM, ..own })
        })
    }
}

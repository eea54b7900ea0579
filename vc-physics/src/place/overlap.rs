//! Overlaps that a thing or a box would have at a pose.

use nalgebra::Vector3;
use rapier3d::geometry::{Collider, SharedShape};
use rapier3d::math::Pose as EnginePose;
use vc_graph::{NodeId, Pose};

use crate::displaced::{Displaced, NONE};
use crate::state::Thing;
use crate::world::PhysicsWorld;
use crate::{PhysicsError, convert, group};

/// The depth of an overlap that counts as contact only, metres.
pub(crate) const SKIN: f32 = 0.001;

/// The distance of a shape from a collider that it meets, at a pose relative to it, metres: negative for an overlap, none
/// where they do not touch after all. `None` if nobody knows.
pub(crate) fn distance(shape: &SharedShape, between: &EnginePose, collider: &Collider) -> Option<Option<f32>> {
    let contact = rapier3d::parry::query::contact(&EnginePose::IDENTITY, &**shape, between, collider.shape(), 0.0);
    contact.ok().map(|contact| contact.map(|contact| contact.dist))
}

/// # Overlaps
impl PhysicsWorld {
    /// The things that a node would overlap at a pose; the node itself, its load and carried things do not count.
    /// Touching is not overlapping.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use vc_graph::Pose;
    /// assert_eq!(world.overlaps(home.cup, &Pose::translation(1.0, 0.0, 0.7))?, [home.table]);
    /// assert!(world.overlaps(home.cup, &Pose::translation(1.0, 0.0, 0.9))?.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn overlaps(&self, id: NodeId, pose: &Pose) -> Result<Vec<NodeId>, PhysicsError> {
        let thing = self.thing(id)?;
        if !convert::is_sound(pose) {
            return Err(PhysicsError::NotFinite("the pose", id));
        }
        Ok(self.overlapped(thing, pose, &NONE))
    }

    /// The nodes of which something is in a box, by number: the sides of the box, metres, and the pose of its middle. Touching
    /// it is not being in it.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Vector3;
    /// use vc_graph::Pose;
    /// let above = |height: f32| world.in_box(Vector3::repeat(0.1), &Pose::translation(1.0, 0.0, 0.74 + height));
    /// assert_eq!((above(0.06), above(0.3)), (vec![home.cup], vec![]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn in_box(&self, size: Vector3<f32>, pose: &Pose) -> Vec<NodeId> {
        let (half, mut found) = (size / 2.0, Vec::new());
        if is_size(&half) && convert::is_sound(pose) {
            let shape = SharedShape::cuboid(half.x, half.y, half.z);
            self.each_overlap((&shape, &convert::pose(pose)), NodeId(u32::MAX), &NONE, &mut |node| {
                found.push(node);
                true
            });
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The nodes that the moving parts of a node overlap by more than some metres when they are shut.
    pub(crate) fn met_when_shut(&self, id: NodeId, deeper: f32) -> Vec<NodeId> {
        let parts = 0..self.thing(id).map_or(0, |thing| thing.state.moving.len());
        let mut found = Vec::new();
        for (shape, at) in parts.filter_map(|part| self.part_at(id, part, 0.0).ok().flatten()) {
            let other = |c: &Collider| group::is_solid(c) && group::marked(c.user_data).0 != id;
            self.each_met((&shape, &at), &other, &NONE, &mut |collider, between| {
                if distance(&shape, &between, collider).flatten().is_some_and(|distance| distance < -deeper) {
                    found.push(group::marked(collider.user_data).0);
                }
                true
            });
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The things that a thing would overlap at a pose, where some bodies are displaced.
    pub(crate) fn overlapped(&self, thing: &Thing, pose: &Pose, displaced: &Displaced) -> Vec<NodeId> {
        let mut found: Vec<NodeId> = Vec::new();
        self.for_overlaps_with(thing, pose, displaced, &mut |node| {
            found.push(node);
            true
        });
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Calls `found` for each thing that a thing would overlap at a pose, until it returns false; returns whether
    /// it never did.
    pub(crate) fn for_overlaps(&self, thing: &Thing, pose: &Pose, found: &mut dyn FnMut(NodeId) -> bool) -> bool {
        self.for_overlaps_with(thing, pose, &NONE, found)
    }

    fn for_overlaps_with(
        &self,
        thing: &Thing,
        pose: &Pose,
        displaced: &Displaced,
        found: &mut dyn FnMut(NodeId) -> bool,
    ) -> bool {
        let solid = thing.form.links.iter().filter_map(|link| link.solid.as_ref());
        let mut bodies = solid.map(|(shape, at)| (shape, convert::pose(pose) * *at));
        bodies.all(|(shape, at)| self.each_overlap((shape, &at), thing.id, displaced, found))
    }

    /// Calls `found` for each solid thing but one that a shape would overlap, where some bodies are displaced, until
    /// it returns false; returns whether it never did.
    pub(super) fn each_overlap(
        &self,
        (shape, at): (&SharedShape, &EnginePose),
        but: NodeId,
        displaced: &Displaced,
        found: &mut dyn FnMut(NodeId) -> bool,
    ) -> bool {
        let other = |c: &Collider| group::is_solid(c) && group::marked(c.user_data).0 != but;
        self.each_met((shape, at), &other, displaced, &mut |collider, between| {
            let overlaps = distance(shape, &between, collider).flatten().is_none_or(|distance| distance < -SKIN);
            !overlaps || found(group::marked(collider.user_data).0)
        })
    }

    /// Whether a box of half lengths at a pose overlaps nothing.
    pub(super) fn is_free(&self, half: Vector3<f32>, pose: &Pose) -> bool {
        if !is_size(&half) || !convert::is_sound(pose) {
            return false;
        }
        let shape = SharedShape::cuboid(half.x, half.y, half.z);
        self.each_overlap((&shape, &convert::pose(pose)), NodeId(u32::MAX), &NONE, &mut |_| false)
    }
}

/// Whether half lengths are those of a box.
fn is_size(half: &Vector3<f32>) -> bool {
    half.iter().all(|h| *h > 0.0 && *h <= convert::LARGEST)
}

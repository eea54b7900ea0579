//! Several scenes as one: homes side by side, and parts of them.

use std::sync::Arc;

use vc_graph::{Aabb, NodeId, ObjectRole, Pose};

use super::{Body, Ground, Instance, NO_ROOM, Snapshot, Stands};
use crate::RenderError;
use crate::math::Affine;

impl Snapshot {
    /// This scene and others as one: a home, and the stairwell before its open door. Each of the others comes with the
    /// pose of its frame in that of this one, by which its bodies and the boxes around its rooms are moved. Light goes from
    /// scene to scene as it goes from room to room.
    ///
    /// Ids stay, so no two scenes should have a node of the same number. Costs a copy of all.
    ///
    /// ```
    /// use nalgebra::{Point3, Vector3};
    /// use vc_graph::{Bounds, Draft, NodeId, Pose, SceneBuilder};
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot, Snapshot};
    /// let mut renderer = Renderer::new();
    /// let mut scenes = Vec::new();
    /// for number in [1, 100] {
    ///     let mut scene = SceneBuilder::new("yard");
    ///     scene.number_from(number);
    ///     let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    ///     scene.add(Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    ///     scenes.push(renderer.snapshot(&scene.build())?);
    /// }
    /// let [here, there] = [scenes[0].clone(), scenes[1].clone()];
    /// let both = here.joined(&[(there, Pose::translation(0.0, 1.0, 0.0))])?;
    /// let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 1.0, 1.0), Point3::new(2.0, 1.0, 1.0));
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&both, &camera, Modality::Instance), &mut frame)?;
    /// assert_eq!(frame.instance[24 * 64 + 32], NodeId(100));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::OtherRenderer`], [`RenderError::OtherClasses`].
    pub fn joined(mut self, others: &[(Self, Pose)]) -> Result<Self, RenderError> {
        others.iter().try_for_each(|(other, pose)| self.take(other, pose))?;
        self.number();
        Ok(self)
    }

    /// The scene from outside: the bodies of some nodes, such as walls, doors and windows. Light does not enter its rooms
    /// with a ceiling, which are dim behind their windows, and so cost nothing when light is made.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::Renderer;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let size = Bounds::standing(Vector3::new(0.2, 3.0, 2.5));
    /// let wall = scene.add_in(kitchen, Draft::new("wall").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// scene.add_in(kitchen, Draft::new("fridge").at(Pose::identity()).bounds(size))?;
    /// let all = Renderer::new().snapshot(&scene.build())?;
    /// assert_eq!(all.from_outside(|node| node == wall).nodes().collect::<Vec<_>>(), [wall]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn from_outside(&self, keeps: impl Fn(NodeId) -> bool) -> Self {
        let (bodies, instances) = (Vec::new(), Vec::new());
        let mut part = Self { bodies, instances, ..self.clone() };
        for body in self.bodies.iter().filter(|body| keeps(body.node)) {
            let stands = if body.stands == Stands::Around { Stands::Outside } else { body.stands };
            part.add(self, Body { stands, ..body.clone() });
        }
        let ceilings = self.bodies.iter().filter(|body| body.role == ObjectRole::Ceiling);
        part.closed = Arc::new(ceilings.map(|body| usize::from(body.room)).collect());
        part.number();
        part
    }

    /// Adds a copy of a body of another snapshot, with its instances.
    fn add(&mut self, of: &Self, mut body: Body) {
        let (first, number) = (self.instances.len() as u32, self.bodies.len() as u32);
        let own = &of.instances[body.instances.start as usize..body.instances.end as usize];
        self.instances.extend(own.iter().map(|instance| Instance { body: number, ..instance.clone() }));
        body.instances = first..self.instances.len() as u32;
        self.bodies.push(body);
    }

    /// Takes over the bodies and rooms of another scene, moved by a pose.
    fn take(&mut self, other: &Self, pose: &Pose) -> Result<(), RenderError> {
        if !Arc::ptr_eq(&self.store, &other.store) {
            return Err(RenderError::OtherRenderer("snapshot to join"));
        }
        self.classes = Arc::new(self.classes.with(&other.classes).ok_or(RenderError::OtherClasses)?);
        let mut moved = other.clone();
        moved.shift(pose);
        let rooms = self.rooms.len();
        for body in &moved.bodies {
            let number = (usize::from(body.room) + rooms).min(usize::from(NO_ROOM)) as u16;
            let room = if body.room == NO_ROOM { NO_ROOM } else { number };
            self.add(&moved, Body { room, ..body.clone() });
        }
        self.is_joined = true;
        let closed = self.closed.iter().copied().chain(other.closed.iter().map(|room| room + rooms));
        self.closed = Arc::new(closed.collect());
        self.rooms = Arc::new([self.rooms.as_slice(), moved.rooms.as_slice()].concat());
        self.bounds = Arc::new([self.bounds.as_slice(), moved.bounds.as_slice()].concat());
        Ok(())
    }

    /// Moves everything by a pose.
    fn shift(&mut self, by: &Pose) {
        let ground = Arc::new(Ground::new(Affine::from_pose(by)));
        self.bodies.iter_mut().for_each(|body| body.pose = by * body.pose);
        self.instances.iter_mut().for_each(|instance| instance.shift(&ground));
        let bounds = self.bounds.iter().map(|bounds| bounds.map(|bounds| shifted(&bounds, by)));
        self.bounds = Arc::new(bounds.collect());
    }

    /// Numbers bodies by their nodes.
    fn number(&mut self) {
        self.by_node = Arc::new(self.bodies.iter().zip(0..).map(|(body, number)| (body.node, number)).collect());
    }
}

/// The box along the axes around a box that is moved.
fn shifted(bounds: &Aabb, by: &Pose) -> Aabb {
    let [first, others @ ..] = bounds.corners().map(|corner| by * corner);
    others.iter().fold(Aabb::around(&first, &first), |all, corner| all.joined(&Aabb::around(corner, corner)))
}

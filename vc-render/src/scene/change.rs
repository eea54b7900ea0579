//! Changes to a snapshot from moment to moment.

use std::ops::Range;

use vc_graph::asset::Joint;
use vc_graph::{NodeId, Pose};

use super::cover::draw;
use super::{NO_ROOM, Snapshot, liquid};
use crate::RenderError;
use crate::math::Affine;
use crate::surface::Coat;

impl Snapshot {
    /// Moves a body. Costs a few operations for each of its links.
    ///
    /// ```
    /// # use nalgebra::{Point3, Vector3};
    /// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// # let mut scene = SceneBuilder::new("flat");
    /// # let kitchen = scene.add(Draft::new("kitchen"))?;
    /// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
    /// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
    /// # let scene = scene.build();
    /// # let fridge_at = |x| Pose::translation(x, 0.0, 0.0);
    /// use vc_render::Renderer;
    /// let mut renderer = Renderer::new();
    /// let mut snapshot = renderer.snapshot(&scene)?;
    /// snapshot.place(fridge, &fridge_at(3.0))?;
    /// assert!(snapshot.bounds(fridge).is_some_and(|bounds| (bounds.max.x - 3.3).abs() < 1e-4));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`], [`RenderError::BadPose`].
    pub fn place(&mut self, node: NodeId, pose: &Pose) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let body = &mut self.bodies[index];
        if !Affine::placed(pose, &body.scale).is_finite() {
            return Err(RenderError::BadPose(node));
        }
        body.pose = *pose;
        for instance in &mut self.instances[body.instances.start as usize..body.instances.end as usize] {
            instance.put(pose, &body.scale);
        }
        Ok(())
    }

    /// Sets the room in which a body is from now on, if any: that room's light falls on it. Without this call a
    /// body moved by [`place`](Self::place) is lit as in its former room. Linear in the number of rooms.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::Renderer;
    /// let mut scene = SceneBuilder::new("flat");
    /// let [kitchen, hall] = [scene.add(Draft::new("kitchen"))?, scene.add(Draft::new("hallway"))?];
    /// let cart = Draft::new("serving_cart").bounds(Bounds::standing([0.4, 0.7, 0.8].into()));
    /// let cart = scene.add_in(kitchen, cart.at(Pose::identity()))?;
    /// let mut snapshot = Renderer::new().snapshot(&scene.build())?;
    /// snapshot.place(cart, &Pose::translation(0.0, 4.0, 0.0))?;
    /// snapshot.enter(cart, Some(hall))?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`] if the scene has no such body or no such room.
    pub fn enter(&mut self, node: NodeId, room: Option<NodeId>) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let number = |room: NodeId| self.rooms.iter().position(|r| *r == room).ok_or(RenderError::NoBody(room));
        self.bodies[index].room = room.map(number).transpose()?.map_or(NO_ROOM, |number| number as u16);
        Ok(())
    }

    /// Moves the joints of a body. `position` gives the new position of a joint, radians or metres, or `None`
    /// where it stays.
    ///
    /// # Errors
    /// [`RenderError::NoBody`], [`RenderError::BadPose`].
    pub fn articulate(
        &mut self,
        node: NodeId,
        mut position: impl FnMut(&Joint) -> Option<f32>,
    ) -> Result<(), RenderError> {
        self.bend(node, |joint, _| position(joint).map(|at| (at, joint.motion(at))))
    }

    /// Places the links of a body along a chain of joints, such as a person's limbs. `place` gives for each
    /// joint how far the link that hangs on it has moved from its rest pose in the asset, in the asset's frame.
    ///
    /// # Errors
    /// [`RenderError::NoBody`], [`RenderError::BadPose`].
    pub fn arrange(&mut self, node: NodeId, mut place: impl FnMut(&Joint) -> Option<Pose>) -> Result<(), RenderError> {
        self.bend(node, |joint, at| place(joint).map(|moved| (at, moved)))
    }

    /// Gives links of a body the positions of their joints and their motions from the rest pose in the asset.
    /// Either all given links move or, if one of them cannot, none.
    fn bend(
        &mut self,
        node: NodeId,
        mut motion: impl FnMut(&Joint, f32) -> Option<(f32, Pose)>,
    ) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let body = &mut self.bodies[index];
        let instances = &mut self.instances[body.instances.start as usize..body.instances.end as usize];
        let moved = instances.iter().map(|i| motion(&i.link.joint?, i.joint));
        let moved: Vec<Option<(f32, Pose)>> = moved.collect();
        let placed = Affine::placed(&body.pose, &body.scale);
        let sound = |(at, own): &(f32, Pose)| at.is_finite() && placed.after(&Affine::from_pose(own)).is_finite();
        if !moved.iter().flatten().all(sound) {
            return Err(RenderError::BadPose(node));
        }
        for (instance, moved) in instances.iter_mut().zip(moved) {
            if let Some((at, own)) = moved {
                instance.joint = at;
                instance.arrange(&body.pose, &body.scale, &own);
            }
        }
        body.bounds = body.measured(instances);
        Ok(())
    }

    /// Switches the luminous parts of a body on or off.
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn switch(&mut self, node: NodeId, on: bool) -> Result<(), RenderError> {
        let index = self.body(node)?;
        self.bodies[index].lit = on;
        Ok(())
    }

    /// Sets the coat on a body. The coats that follow from a graph's states are there from the beginning, by
    /// [`Coat::from_node`].
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Coat, Renderer};
    /// let mut scene = SceneBuilder::new("table");
    /// let plate = Draft::new("plate").bounds(Bounds::standing([0.2, 0.2, 0.02].into()));
    /// let plate = scene.add(plate.at(Pose::identity()))?;
    /// let mut snapshot = Renderer::new().snapshot(&scene.build())?;
    /// snapshot.coat(plate, Coat { colour: [0.1, 0.05, 0.02], share: 0.5, roughness: 1.0 })?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn coat(&mut self, node: NodeId, coat: Coat) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let Range { start, end } = self.bodies[index].instances;
        let solid = self.instances[start as usize..end as usize].iter_mut().filter(|i| i.liquid.is_none());
        solid.for_each(|instance| instance.coat = coat.sound());
        Ok(())
    }

    /// Sets the coat on the links of a body that move on joints, where it differs from the rest of the body,
    /// such as a person's clothes. A later call of [`coat`](Self::coat) covers the whole body again. Costs next
    /// to nothing.
    ///
    /// ```
    /// use vc_graph::asset::JointKind;
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Coat, Renderer};
    /// let mut scene = SceneBuilder::new("shelf");
    /// let doll = Draft::new("doll").bounds(Bounds::standing([0.1, 0.1, 0.3].into()));
    /// let doll = scene.add(doll.at(Pose::identity()))?;
    /// let mut snapshot = Renderer::new().snapshot(&scene.build())?;
    /// let sleeve = Coat { colour: [0.1, 0.2, 0.5], share: 1.0, roughness: 1.0 };
    /// snapshot.coat_links(doll, |joint| (joint.kind == JointKind::Hinge).then_some(sleeve))?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn coat_links(
        &mut self,
        node: NodeId,
        mut coat: impl FnMut(&Joint) -> Option<Coat>,
    ) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let Range { start, end } = self.bodies[index].instances;
        for instance in &mut self.instances[start as usize..end as usize] {
            let other = instance.link.joint.as_ref().and_then(&mut coat);
            instance.coat = other.map_or(instance.coat, Coat::sound);
        }
        Ok(())
    }

    /// Hides a body or shows it again, such as a garment that is drawn as part of its wearer.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
    /// let mut scene = SceneBuilder::new("hall");
    /// let coat = Draft::new("coat").bounds(Bounds::standing([0.2, 0.5, 1.0].into()));
    /// let coat = scene.add(coat.at(Pose::translation(2.0, 0.0, -0.5)))?;
    /// let mut renderer = Renderer::new();
    /// let mut snapshot = renderer.snapshot(&scene.build())?;
    /// snapshot.hide(coat, true)?;
    /// let camera = Camera::with_fov(32, 32, 1.0);
    /// let mut frame = Frame::new();
    /// renderer.render(&Shot::new(&snapshot, &camera, Modality::Instance), &mut frame)?;
    /// assert!(!frame.instance.contains(&coat));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn hide(&mut self, node: NodeId, hidden: bool) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let body = &self.bodies[index];
        for instance in &mut self.instances[body.instances.start as usize..body.instances.end as usize] {
            instance.hidden = hidden;
            instance.put(&body.pose, &body.scale);
        }
        Ok(())
    }

    /// Fills a vessel with a liquid of a class, or empties it. A graph's contents are there from the beginning.
    /// A vessel that is not open above, with walls around, shows no liquid.
    ///
    /// ```
    /// use vc_graph::{Draft, Pose, SceneBuilder};
    /// use vc_render::Renderer;
    /// let mut scene = SceneBuilder::new("table");
    /// let mug = scene.add(Draft::new("mug").at(Pose::identity()).bounds(vc_graph::Bounds::standing([0.1; 3].into())))?;
    /// let mut snapshot = Renderer::new().snapshot(&scene.build())?;
    /// snapshot.fill(mug, Some("coffee"))?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn fill(&mut self, node: NodeId, contents: Option<&str>) -> Result<(), RenderError> {
        let index = self.body(node)?;
        let body = &self.bodies[index];
        for instance in &mut self.instances[body.instances.start as usize..body.instances.end as usize] {
            let Some(liquid) = &mut instance.liquid else { continue };
            instance.coat = contents.map_or(Coat::NONE, liquid::coat);
            if liquid.there != contents.is_some() {
                liquid.there = contents.is_some();
                instance.put(&body.pose, &body.scale);
            }
        }
        Ok(())
    }

    /// Draws a blind or a curtain over the window or door it hangs at, or draws it aside. It is stretched over
    /// the opening, down from above or in from its side, and only to the middle if another one comes from the
    /// other side. It hangs before flat things that stand there, such as radiators, and ends above deep ones;
    /// the places where these were when the snapshot was made count. A curtain that is tied with a band is
    /// untied. A graph's states are there from the beginning. A cover that hangs at no opening stays as it is.
    ///
    /// Light must be computed anew to follow the change: see [`Renderer::relight`](crate::Renderer::relight).
    /// Costs next to nothing.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_render::Renderer;
    /// let mut scene = SceneBuilder::new("study");
    /// let window = Draft::new("window").bounds(Bounds::standing([0.1, 1.2, 1.4].into()));
    /// scene.add(window.at(Pose::translation(0.0, 0.0, 0.9)))?;
    /// let blinds = Draft::new("blinds").bounds(Bounds::standing([0.06, 1.2, 0.3].into()));
    /// let blinds = scene.add(blinds.at(Pose::translation(0.1, 0.0, 2.0)))?;
    /// let mut snapshot = Renderer::new().snapshot(&scene.build())?;
    /// snapshot.draw_cover(blinds, true)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError::NoBody`].
    pub fn draw_cover(&mut self, node: NodeId, closed: bool) -> Result<(), RenderError> {
        let index = self.body(node)?;
        draw((&mut self.bodies[index], &mut self.instances), closed);
        Ok(())
    }
}

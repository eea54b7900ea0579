//! Direct changes of single bodies: they are placed, pushed, pinned, and change their role.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::{RigidBodyHandle, RigidBodyType};
use vc_graph::{NodeId, Pose};

use crate::engine::steady;
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

/// # Changes of single bodies
impl PhysicsWorld {
    /// Moves a node at once, without velocity; its moving parts and the water in it come along, and a stopped
    /// thing takes part again. Check first whether the spot is free, with [`overlaps`](Self::overlaps).
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`]; [`PhysicsError::NotFinite`]; [`PhysicsError::NotFree`] for things that an
    /// agent carries.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.place(home.cup, vc_graph::Pose::translation(1.0, 0.3, 0.741))?;
    /// assert!(world.settle(300).fell.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn place(&mut self, id: NodeId, pose: Pose) -> Result<(), PhysicsError> {
        let thing = self.thing(id)?;
        if !convert::is_sound(&pose) {
            return Err(PhysicsError::NotFinite("the pose", id));
        }
        if thing.state.role == BodyRole::Carried {
            return Err(PhysicsError::NotFree(id));
        }
        let before = self.engine.pose(thing.state.base).unwrap_or(pose);
        let stopped = thing.state.role == BodyRole::Stopped;
        let motion = pose * before.inverse();
        let bodies: Vec<_> = thing.bodies().collect();
        if pose != before {
            self.thing_mut(id)?.state.rides = None;
        }
        for body in bodies {
            let own = self.engine.pose(body).unwrap_or(before);
            let to = if body == self.thing(id)?.state.base { pose } else { motion * own };
            self.engine.place(body, convert::pose(&to));
        }
        if stopped {
            self.set_going(id)?;
        }
        if self.thing(id)?.state.role == BodyRole::Fixed {
            self.find_bottom();
        }
        match self.waters.levels.get(&id) {
            Some(&level) => self.fill(id, level),
            None => Ok(()),
        }
    }

    /// Lets a stopped thing take part again.
    fn set_going(&mut self, id: NodeId) -> Result<(), PhysicsError> {
        self.stopped.retain(|other| *other != id);
        let bodies: Vec<_> = self.thing(id)?.bodies().collect();
        bodies.into_iter().for_each(|body| self.engine.set_enabled(body, true));
        self.set_role(id, BodyRole::Loose)
    }

    /// Pushes a node with an impulse at a point, newton seconds and metres; a hanging thing comes down.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`],
    /// [`PhysicsError::NotFree`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.settle(300);
    /// let middle = world.body(home.cup)?.centre_of_mass();
    /// world.push(home.cup, nalgebra::Vector3::new(0.06, 0.0, 0.0), middle)?;
    /// assert!((world.body(home.cup)?.velocity().x - 0.2).abs() < 1e-3); // 0.06 Ns on 0.3 kg.
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn push(&mut self, id: NodeId, impulse: Vector3<f32>, at: Point3<f32>) -> Result<(), PhysicsError> {
        if !convert::is_finite(&impulse) || !convert::is_finite(&at.coords) {
            return Err(PhysicsError::NotFinite("the impulse", id));
        }
        let body = self.loosen(id)?;
        if let Some(rigid) = self.engine.body_mut(body) {
            rigid.apply_impulse_at_point(convert::vector(impulse), convert::point(at), true);
        }
        Ok(())
    }

    /// Sets the velocity of a node's centre of mass and its angular velocity, metres and radians per second.
    ///
    /// # Errors
    /// As [`Self::push`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// use nalgebra::Vector3;
    /// world.set_velocity(home.cup, Vector3::new(0.0, 0.0, 1.0), Vector3::zeros())?;
    /// assert_eq!(world.body(home.cup)?.velocity(), Vector3::new(0.0, 0.0, 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_velocity(&mut self, id: NodeId, linear: Vector3<f32>, spin: Vector3<f32>) -> Result<(), PhysicsError> {
        if !convert::is_finite(&linear) || !convert::is_finite(&spin) {
            return Err(PhysicsError::NotFinite("the velocity", id));
        }
        let body = self.loosen(id)?;
        if let Some(rigid) = self.engine.body_mut(body) {
            rigid.set_linvel(convert::vector(linear), true);
            rigid.set_angvel(convert::vector(spin), true);
        }
        Ok(())
    }

    /// Wakes a node's body, so that it falls if nothing holds it.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFree`].
    pub fn wake(&mut self, id: NodeId) -> Result<(), PhysicsError> {
        let body = self.loosen(id)?;
        if let Some(rigid) = self.engine.body_mut(body) {
            rigid.wake_up(true);
        }
        Ok(())
    }

    /// Pins a loose thing where it is, as if it hung there, until it is taken or pushed: for things that do not
    /// come to rest. In a drawer or on another moving part it moves along with the part; otherwise with the thing `to`
    /// which it is pinned, as in a box into whose walls it reaches.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], also for the other thing; [`PhysicsError::NotFree`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.place(home.cup, vc_graph::Pose::translation(0.0, 0.5, 1.5))?;
    /// world.pin(home.cup, None)?;
    /// world.run(60);
    /// assert_eq!(world.pose(home.cup).map(|pose| pose.translation.z), Some(1.5));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pin(&mut self, id: NodeId, to: Option<NodeId>) -> Result<(), PhysicsError> {
        to.map_or(Ok(()), |to| self.thing(to).map(drop))?;
        match self.thing(id)?.state.role {
            BodyRole::Loose => {
                let rides = self.rides(id);
                self.set_role(id, BodyRole::Hung)?;
                self.thing_mut(id)?.state.rides = rides;
            }
            BodyRole::Hung => {}
            _ => return Err(PhysicsError::NotFree(id)),
        }
        let state = &mut self.thing_mut(id)?.state;
        state.rides = state.rides.or(to.map(|to| (to, 0)));
        Ok(())
    }

    /// The body of a movable thing; a hanging thing is taken down.
    fn loosen(&mut self, id: NodeId) -> Result<RigidBodyHandle, PhysicsError> {
        let thing = self.thing(id)?;
        let (base, role) = (thing.state.base, thing.state.role);
        match role {
            BodyRole::Loose => {}
            BodyRole::Hung => self.set_role(id, BodyRole::Loose)?,
            _ => return Err(PhysicsError::NotFree(id)),
        }
        Ok(base)
    }

    /// Changes the role of a thing, and adapts its body and colliders.
    pub(crate) fn set_role(&mut self, id: NodeId, role: BodyRole) -> Result<(), PhysicsError> {
        let thing = self.thing_mut(id)?;
        (thing.state.role, thing.state.rides) = (role, None);
        let base = thing.state.base;
        let kind = match role {
            BodyRole::Loose => RigidBodyType::Dynamic,
            BodyRole::Carried => RigidBodyType::KinematicPositionBased,
            _ => RigidBodyType::Fixed,
        };
        let Some(rigid) = self.engine.body_mut(base) else { return Ok(()) };
        rigid.set_body_type(kind, true);
        if rigid.is_fixed() {
            rigid.set_rotation(steady(*rigid.rotation()), true);
        }
        rigid.set_linvel(rapier3d::math::Vector::ZERO, true);
        rigid.set_angvel(rapier3d::math::Vector::ZERO, true);
        let groups = group::base(role);
        for collider in rigid.colliders().to_vec() {
            if let Some(collider) = self.engine.colliders.get_mut(collider) {
                collider.set_collision_groups(groups);
            }
        }
        Ok(())
    }
}

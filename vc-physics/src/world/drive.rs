//! Time steps, and direct changes of bodies.

use nalgebra::{Point3, Vector3};
use rapier3d::dynamics::{RigidBodyHandle, RigidBodyType};
use vc_graph::{NodeId, Pose};

use super::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

impl PhysicsWorld {
    /// Lets one step of time pass: agents walk, vehicles drive, water carries, motors turn, bodies fall.
    ///
    /// Costs a microsecond or two while everything sleeps.
    pub fn step(&mut self) {
        let awake: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        let fixed = self.engine.fixed_among(&awake);
        self.move_agents();
        for _ in 0..self.settings.substeps {
            self.push_vehicles();
            self.push_floating();
            self.resist_rolling();
            let stopped = self.engine.step().to_vec();
            stopped.into_iter().for_each(|b| self.stop(b));
        }
        self.engine.keep(&fixed);
        self.tend_motors();
        self.watch();
        self.note_sleepers(&awake);
        self.ticks += 1;
    }

    /// Lets a number of steps pass.
    pub fn run(&mut self, steps: u32) {
        (0..steps).for_each(|_| self.step());
    }

    /// Puts everything to sleep in its present state, for a scene that is known to be at rest: one step passes,
    /// which finds the contacts, and then nothing moves until it is disturbed. (Bodies inserted asleep would
    /// have no contacts.)
    pub fn rest(&mut self) {
        self.step();
        let all: Vec<RigidBodyHandle> = self.engine.awake_bodies().collect();
        for &body in &all {
            if let Some(rigid) = self.engine.bodies.get_mut(body).filter(|b| b.is_dynamic()) {
                rigid.sleep();
            }
        }
        self.note_sleepers(&all);
    }

    /// Puts things to sleep at poses at which they are known to be at rest, and lets agents stand at them, to the
    /// bit; everything else [rests](Self::rest) where it is.
    ///
    /// # Errors
    /// As [`Self::place`].
    pub fn rest_at(&mut self, poses: &[(NodeId, Pose)]) -> Result<(), PhysicsError> {
        for (id, pose) in poses.iter().filter(|(id, _)| !self.agents.contains_key(id)).collect::<Vec<_>>() {
            let rides = self.thing(*id)?.state.rides;
            self.place(*id, *pose)?;
            self.thing_mut(*id)?.state.rides = rides;
        }
        self.rest();
        for (id, pose) in poses {
            let body = match self.agents.get_mut(id) {
                Some(agent) => {
                    agent.feet = *pose;
                    agent.body
                }
                None => self.thing(*id)?.state.base,
            };
            if let Some(rigid) = self.engine.bodies.get_mut(body) {
                rigid.set_position(convert::pose(pose), false);
            }
            self.engine.refresh(body);
        }
        Ok(())
    }

    /// Stops and lists a body that has become non-finite.
    fn stop(&mut self, body: RigidBodyHandle) {
        let Some(id) = self.engine.bodies.get(body).map(|b| group::marked(b.user_data).0) else { return };
        if let Ok(thing) = self.thing_mut(id) {
            thing.state.role = BodyRole::Stopped;
        }
        if !self.stopped.contains(&id) {
            self.stopped.push(id);
        }
    }

    /// Moves a node at once, without velocity; its moving parts and the water in it come along, and a stopped
    /// thing takes part again. Check first whether the spot is free, with [`overlaps`](Self::overlaps).
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`]; [`PhysicsError::NotFinite`]; [`PhysicsError::NotFree`] for things that an
    /// agent carries.
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
        match self.fills.get(&id) {
            Some(&level) => self.fill(id, level),
            None => Ok(()),
        }
    }

    /// Lets a stopped thing take part again.
    fn set_going(&mut self, id: NodeId) -> Result<(), PhysicsError> {
        self.stopped.retain(|other| *other != id);
        let bodies: Vec<_> = self.thing(id)?.bodies().collect();
        bodies.into_iter().for_each(|body| self.engine.enable(body));
        self.set_role(id, BodyRole::Loose)
    }

    /// Pushes a node with an impulse at a point, newton seconds and metres; a hanging thing comes down.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`],
    /// [`PhysicsError::NotFree`].
    pub fn push(&mut self, id: NodeId, impulse: Vector3<f32>, at: Point3<f32>) -> Result<(), PhysicsError> {
        if !convert::is_finite(&impulse) || !convert::is_finite(&at.coords) {
            return Err(PhysicsError::NotFinite("the impulse", id));
        }
        let body = self.loosen(id)?;
        if let Some(rigid) = self.engine.bodies.get_mut(body) {
            rigid.apply_impulse_at_point(convert::vector(impulse), convert::point(at), true);
        }
        Ok(())
    }

    /// Sets the velocity of a node's centre of mass and its angular velocity, metres and radians per second.
    ///
    /// # Errors
    /// As [`Self::push`].
    pub fn set_velocity(&mut self, id: NodeId, linear: Vector3<f32>, spin: Vector3<f32>) -> Result<(), PhysicsError> {
        if !convert::is_finite(&linear) || !convert::is_finite(&spin) {
            return Err(PhysicsError::NotFinite("the velocity", id));
        }
        let body = self.loosen(id)?;
        if let Some(rigid) = self.engine.bodies.get_mut(body) {
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
        if let Some(rigid) = self.engine.bodies.get_mut(body) {
            rigid.wake_up(true);
        }
        Ok(())
    }

    /// Pins a loose thing where it is, as if it hung there, until it is taken or pushed: for things that do not
    /// come to rest. In a drawer or on another moving part it moves along with the part.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFree`].
    pub fn pin(&mut self, id: NodeId) -> Result<(), PhysicsError> {
        match self.thing(id)?.state.role {
            BodyRole::Loose => {
                let rides = self.rides(id);
                self.set_role(id, BodyRole::Hung)?;
                self.thing_mut(id)?.state.rides = rides;
                Ok(())
            }
            BodyRole::Hung => Ok(()),
            _ => Err(PhysicsError::NotFree(id)),
        }
    }

    /// As [`Self::pin`], as a part of another thing, with which it then moves. For things in a box that reach
    /// into its walls.
    ///
    /// # Errors
    /// As [`Self::pin`]; [`PhysicsError::NoBody`] also for the other thing.
    pub fn pin_to(&mut self, id: NodeId, at: NodeId) -> Result<(), PhysicsError> {
        self.thing(at)?;
        self.pin(id)?;
        let part = Some((at, 0));
        let thing = self.thing_mut(id)?;
        thing.state.rides = thing.state.rides.or(part);
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
        let Some(rigid) = self.engine.bodies.get_mut(base) else { return Ok(()) };
        rigid.set_body_type(kind, true);
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

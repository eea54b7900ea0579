//! Opening, closing and locking.

use rapier3d::dynamics::{MotorModel, RigidBodyType};
use rapier3d::geometry::SharedShape;
use rapier3d::math::Pose as EnginePose;
use vc_graph::asset::JointKind;
use vc_graph::{NodeId, Pose};

use super::make::{axis, friction, idle};
use super::motion::{closed, opened};
use crate::shapes::Link;
use crate::state::{Moving, Thing};
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError, convert, group};

/// Speed of the motor per unit of remaining distance, per second: like an arm, it slows down before it arrives.
const EAGER: f32 = 8.0;
/// Time for the whole range without slowing down, seconds.
const WHOLE_WAY: f32 = 0.8;
/// Velocity gain of the motor, per second.
const FIRM: f32 = 1000.0;
/// Largest torque or force of the motor, newton metres or newtons.
const STRENGTH: f32 = 80.0;
/// Time after which a motor that does not arrive gives up, seconds.
const PATIENCE: f32 = 4.0;
/// Largest speed of a part that has arrived, metres or radians per second.
const SLOW: f32 = 0.02;
/// Largest distance from the target of a part that has arrived, as a fraction of the range.
const ARRIVED: f32 = 0.005;

/// # Motors
impl PhysicsWorld {
    /// Starts a part's motor, which takes the part to a fraction of its range (0 closed, 1 open) in about a
    /// second, as an arm would, if nothing is in the way. A part without a motor is moved at once.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchPart`],
    /// [`PhysicsError::Locked`], [`PhysicsError::NotFinite`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.drive(home.cabinet, 0, 1.0)?;
    /// world.run(120);
    /// assert!(world.parts(home.cabinet).openness().is_some_and(|open| open > 0.98));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn drive(&mut self, id: NodeId, part: usize, open: f32) -> Result<(), PhysicsError> {
        let target = self.target(id, part, open)?;
        if self.thing(id)?.state.moving[part].body.is_none() {
            self.pinned_on((id, part + 1)).into_iter().try_for_each(|rider| self.wake(rider))?;
            return self.put_part(id, part, open);
        }
        self.loosen_part(id, part)?;
        let index = self.index(id)?;
        let patience = (PATIENCE / self.settings.dt) as u32;
        let thing = &mut self.things[index];
        let (moving, kind) = (&mut thing.state.moving[part], joint_kind(&thing.form.links[part + 1]));
        (moving.target, moving.patience) = (Some(target), patience);
        if let Some(joint) = moving.joint.and_then(|j| self.engine.joints.get_mut(j, true)) {
            joint.data.set_motor_model(axis(kind), MotorModel::AccelerationBased);
            joint.data.set_motor_max_force(axis(kind), STRENGTH);
        }
        self.driven.push((id, part));
        let position = self.part_position(&self.things[index], part).unwrap_or(target);
        self.things[index].state.moving[part].position = position;
        self.turn_on(index, part);
        Ok(())
    }

    /// Lets a part with a body of its own move between its limits, if it is not locked: its latch is off, and things that
    /// were pinned to it are free.
    pub(crate) fn loosen_part(&mut self, id: NodeId, part: usize) -> Result<(), PhysicsError> {
        if self.check_part(id, part)?.locked {
            return Err(PhysicsError::Locked(id));
        }
        self.pinned_on((id, part + 1)).into_iter().try_for_each(|rider| self.wake(rider))?;
        self.driven.retain(|d| *d != (id, part));
        let index = self.index(id)?;
        let thing = &mut self.things[index];
        let (moving, kind) = (&mut thing.state.moving[part], joint_kind(&thing.form.links[part + 1]));
        (moving.target, moving.latched) = (None, false);
        if let Some(rigid) = moving.body.and_then(|body| self.engine.body_mut(body)) {
            rigid.set_body_type(RigidBodyType::Dynamic, true);
            rigid.wake_up(true);
        }
        if let Some(joint) = moving.joint.and_then(|j| self.engine.joints.get_mut(j, true)) {
            joint.data.set_limits(axis(kind), [moving.limits.0, moving.limits.1]);
        }
        Ok(())
    }

    /// Leaves a part as far open as it is: friction holds it there, or its latch.
    pub(crate) fn leave_part(&mut self, id: NodeId, part: usize) -> Result<(), PhysicsError> {
        self.check_part(id, part)?;
        let index = self.index(id)?;
        self.settle_part(index, part);
        Ok(())
    }

    /// Opens or closes a part at once, or every part of the node; the contents of a drawer move along.
    ///
    /// # Errors
    /// As [`Self::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.put_open(home.cabinet, Some(0), 0.5)?;
    /// assert!((world.parts(home.cabinet).all()[0].position - 0.15).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn put_open(&mut self, id: NodeId, part: Option<usize>, open: f32) -> Result<(), PhysicsError> {
        let count = self.thing(id)?.state.moving.len();
        let mut parts = part.map_or(0..count, |part| part..part + 1);
        parts.try_for_each(|part| self.put_part(id, part, open))
    }

    pub(super) fn put_part(&mut self, id: NodeId, part: usize, open: f32) -> Result<(), PhysicsError> {
        let target = self.target(id, part, open)?;
        let index = self.index(id)?;
        self.driven.retain(|d| *d != (id, part));
        let poses = self.poses_when_put(&self.things[index], part, target);
        self.engine.note(self.things[index].state.base);
        let moving = &mut self.things[index].state.moving[part];
        moving.position = target;
        let body = moving.body;
        let Some((before, after)) = poses else { return Ok(()) };
        let load = self.load_of_part(id, part);
        match body {
            Some(body) => self.engine.place(body, convert::pose(&after)),
            None => self.turn_welded(index, part, target),
        }
        self.carry_along(&load, &(after * before.inverse()));
        if body.is_some() {
            self.settle_part(index, part);
        }
        Ok(())
    }

    /// The pose of a part, and its pose at a position on its joint.
    pub(super) fn poses_when_put(&self, thing: &Thing, part: usize, target: f32) -> Option<(Pose, Pose)> {
        let (moving, joint) = (thing.state.moving[part], thing.form.links[part + 1].joint?);
        let base = self.engine.pose(thing.state.base)?;
        let before = match moving.body {
            Some(body) => self.engine.pose(body).unwrap_or(base),
            None => base * joint.motion(moving.position),
        };
        Some((before, base * joint.motion(target)))
    }

    /// The shape of a node's moving part, if it has any, and its pose when open by a fraction.
    ///
    /// # Errors
    /// As [`Self::drive`].
    pub(crate) fn part_at(
        &self,
        id: NodeId,
        part: usize,
        open: f32,
    ) -> Result<Option<(SharedShape, EnginePose)>, PhysicsError> {
        let target = self.target(id, part, open)?;
        let thing = self.thing(id)?;
        let base = self.engine.pose(thing.state.base).ok_or(PhysicsError::NoBody(id))?;
        let link = &thing.form.links[part + 1];
        let solid = link.joint.zip(link.solid.as_ref());
        Ok(solid.map(|(joint, (shape, at))| (shape.clone(), convert::pose(&(base * joint.motion(target))) * *at)))
    }

    /// Locks or unlocks a part; a locked part neither moves nor can be opened.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NoSuchPart`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// world.lock(home.cabinet, 0, true)?;
    /// let refused = world.drive(home.cabinet, 0, 1.0);
    /// assert_eq!(refused, Err(vc_physics::PhysicsError::Locked(home.cabinet)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lock(&mut self, id: NodeId, part: usize, locked: bool) -> Result<(), PhysicsError> {
        self.check_part(id, part)?;
        let index = self.index(id)?;
        let moving = &mut self.things[index].state.moving[part];
        moving.locked = locked;
        self.driven.retain(|d| *d != (id, part));
        self.settle_part(index, part);
        Ok(())
    }

    /// Whether a part is there and locked.
    pub(crate) fn is_locked(&self, id: NodeId, part: usize) -> bool {
        self.check_part(id, part).is_ok_and(|moving| moving.locked)
    }

    fn check_part(&self, id: NodeId, part: usize) -> Result<&Moving, PhysicsError> {
        let parts = &self.thing(id)?.state.moving;
        parts.get(part).ok_or(PhysicsError::NoSuchPart { id, part, count: parts.len() })
    }

    pub(super) fn target(&self, id: NodeId, part: usize, open: f32) -> Result<f32, PhysicsError> {
        let moving = self.check_part(id, part)?;
        if moving.locked {
            return Err(PhysicsError::Locked(id));
        }
        if !open.is_finite() {
            return Err(PhysicsError::NotFinite("the open fraction", id));
        }
        let (shut, wide) = (closed(moving.limits), opened(moving.limits));
        Ok(shut + open.clamp(0.0, 1.0) * (wide - shut))
    }

    /// Updates the motors: those that have arrived, or are stuck after they have tried long enough, stop.
    pub(crate) fn tend_motors(&mut self) {
        if self.driven.is_empty() {
            return;
        }
        let driven = std::mem::take(&mut self.driven);
        for (id, part) in driven {
            let Ok(index) = self.index(id) else { continue };
            let (position, slow) = self.pace(index, part);
            let moving = &mut self.things[index].state.moving[part];
            moving.position = position;
            moving.patience = moving.patience.saturating_sub(1);
            // One that moves again after it was stuck goes on.
            if slow && (moving.has_arrived() || moving.patience == 0) {
                self.settle_part(index, part);
            } else {
                self.turn_on(index, part);
                self.driven.push((id, part));
            }
        }
    }

    /// Sets the speed of a part's motor by the remaining distance.
    fn turn_on(&mut self, index: usize, part: usize) {
        let thing = &self.things[index];
        let (moving, kind) = (&thing.state.moving[part], joint_kind(&thing.form.links[part + 1]));
        let Some(target) = moving.target else { return };
        let most = (moving.limits.1 - moving.limits.0) / WHOLE_WAY;
        let speed = ((target - moving.position) * EAGER).clamp(-most, most);
        if let Some(joint) = moving.joint.and_then(|j| self.engine.joints.get_mut(j, true)) {
            joint.data.set_motor_velocity(axis(kind), speed, FIRM);
        }
    }

    /// The position of a part, and whether it is slow relative to its base.
    fn pace(&self, index: usize, part: usize) -> (f32, bool) {
        let thing = &self.things[index];
        let before = thing.state.moving[part].position;
        let now = self.part_position(thing, part).unwrap_or(before);
        (now, (now - before).abs() < SLOW * self.settings.dt)
    }

    /// Ends a motor's motion: a closed part latches.
    fn settle_part(&mut self, index: usize, part: usize) {
        let position = self.part_position(&self.things[index], part);
        let moving = &mut self.things[index].state.moving[part];
        let (Some(_), Some(position)) = (moving.body, position) else { return };
        let slack = ARRIVED * (moving.limits.1 - moving.limits.0);
        let shut = (position - closed(moving.limits)).abs() <= slack;
        moving.target = None;
        moving.latched = self.settings.latches && shut;
        self.hold_part(index, part);
    }

    /// Holds a part where it is, as its state says: friction does, or a latch or a lock.
    pub(crate) fn hold_part(&mut self, index: usize, part: usize) {
        let position = self.part_position(&self.things[index], part);
        let thing = &self.things[index];
        let (link, fixed_base) = (&thing.form.links[part + 1], thing.state.role == BodyRole::Fixed);
        let friction = link.joint.map_or(0.0, |j| friction(&j, link, &self.settings)) * thing.state.mass_factor;
        let moving = thing.state.moving[part];
        let (Some(body), Some(position)) = (moving.body, position) else { return };
        let stuck = moving.locked || moving.latched;
        if let Some(rigid) = self.engine.body_mut(body) {
            let fixed = stuck && fixed_base;
            rigid.set_body_type(if fixed { RigidBodyType::Fixed } else { RigidBodyType::Dynamic }, true);
        }
        if let Some(joint) = moving.joint.and_then(|j| self.engine.joints.get_mut(j, true)) {
            let kind = joint_kind(link);
            let held = if moving.latched { closed(moving.limits) } else { position };
            let limits = if stuck { [held, held] } else { [moving.limits.0, moving.limits.1] };
            joint.data.set_limits(axis(kind), limits);
            idle(&mut joint.data, kind, friction);
        }
    }

    fn turn_welded(&mut self, index: usize, part: usize, position: f32) {
        let thing = &self.things[index];
        let link = &thing.form.links[part + 1];
        let (Some((_, at)), Some(joint)) = (&link.solid, link.joint) else { return };
        let at = convert::pose(&joint.motion(position)) * *at;
        let (base, mark) = (thing.state.base, group::mark(thing.id, part + 1));
        let handles = self.engine.bodies.get(base).map(|b| b.colliders().to_vec()).unwrap_or_default();
        // The engine keeps contact points by the centre of mass, which moves with the part: a collider that is set to its
        // place anew gets new ones. With the old ones the thing would sink into the floor, or be thrown off it.
        for handle in handles {
            let Some(collider) = self.engine.colliders.get_mut(handle) else { continue };
            let own = collider.position_wrt_parent().copied().unwrap_or_default();
            collider.set_position_wrt_parent(if collider.user_data == mark { at } else { own });
        }
        self.engine.refresh(base);
    }
}

fn joint_kind(link: &Link) -> JointKind {
    link.joint.map_or(JointKind::Hinge, |j| j.kind)
}

impl Moving {
    /// Whether it is where its motor takes it.
    fn has_arrived(&self) -> bool {
        let slack = ARRIVED * (self.limits.1 - self.limits.0);
        self.target.is_none_or(|target| (self.position - target).abs() <= slack)
    }
}

//! Bodies and joints of moving parts.

use rapier3d::dynamics::{
    GenericJoint, JointAxis, MotorModel, PrismaticJointBuilder, RevoluteJointBuilder, RigidBodyBuilder, RigidBodyType,
};
use rapier3d::math::Pose as EnginePose;
use vc_graph::asset::{Joint, JointKind};

use super::motion::{closed, opened};
use crate::engine::Engine;
use crate::shapes::Link;
use crate::state::{Moving, Thing};
use crate::{BodyRole, Settings, convert, group};

/// The mass from which on a base carries jointed bodies, kilograms.
const STURDY: f32 = 10.0;

/// Creates the bodies of a thing's moving parts, all open or all closed.
pub(crate) fn add(engine: &mut Engine, thing: &mut Thing, settings: &Settings, open: bool) {
    let fixed = thing.state.role == BodyRole::Fixed;
    let sturdy = fixed || thing.form.mass() * thing.state.mass_factor > STURDY;
    let base = engine.pose(thing.state.base).filter(|_| sturdy);
    for index in 1..thing.form.links.len() {
        let Some(joint) = thing.form.links[index].joint else { continue };
        let position = if open { opened(joint.limits) } else { closed(joint.limits) };
        let latched = sturdy && fixed && settings.latches && position == closed(joint.limits);
        let moving = Moving {
            body: None,
            joint: None,
            limits: joint.limits,
            position,
            target: None,
            patience: 0,
            locked: false,
            latched,
        };
        let at = base.map(|base| convert::pose(&(base * joint.motion(position))));
        add_part(engine, thing, settings, (index, moving), at);
    }
}

/// Creates the bodies of moving parts again: those that have bodies at poses, in their order, and the others as far open
/// as they are.
pub(crate) fn add_again(engine: &mut Engine, thing: &mut Thing, settings: &Settings, poses: &[EnginePose]) {
    let mut poses = poses.iter();
    for part in (1..).zip(std::mem::take(&mut thing.state.moving)) {
        let at = part.1.body.and_then(|_| poses.next().copied());
        add_part(engine, thing, settings, part, at);
    }
}

/// Adds a part, by the number of its link, with a body of its own at a pose, or none.
fn add_part(
    engine: &mut Engine,
    thing: &mut Thing,
    settings: &Settings,
    (index, moving): (usize, Moving),
    at: Option<EnginePose>,
) {
    let moving = match at {
        Some(at) => jointed(engine, thing, settings, (index, moving), at),
        None => {
            weld(engine, thing, index, moving.position);
            moving
        }
    };
    thing.state.moving.push(moving);
}

/// A part with a body of its own, which does not move while it is latched.
fn jointed(
    engine: &mut Engine,
    thing: &Thing,
    settings: &Settings,
    (index, moving): (usize, Moving),
    at: EnginePose,
) -> Moving {
    let link = &thing.form.links[index];
    let Some(joint) = link.joint else { return moving };
    let kind = if moving.latched { RigidBodyType::Fixed } else { RigidBodyType::Dynamic };
    let builder = RigidBodyBuilder::new(kind)
        .pose(at)
        .gravity_scale(if settings.balanced { 0.0 } else { 1.0 })
        .user_data(group::mark(thing.id, index));
    let body = engine.add_body(builder);
    if let Some((shape, at)) = &link.solid {
        let collider = link.collider(shape, at, thing.state.mass_factor).collision_groups(group::leaf());
        engine.add_collider(collider.user_data(group::mark(thing.id, index)).build(), body);
    }
    let mut data = engine_joint(&joint);
    idle(&mut data, joint.kind, friction(&joint, link, settings) * thing.state.mass_factor);
    let handle = engine.joints.insert(thing.state.base, body, data, true);
    Moving { body: Some(body), joint: Some(handle), ..moving }
}

/// A part that moves with its base: only its local pose changes.
fn weld(engine: &mut Engine, thing: &Thing, index: usize, position: f32) {
    let link = &thing.form.links[index];
    let (Some((shape, at)), Some(joint)) = (&link.solid, link.joint) else { return };
    let moved = convert::pose(&joint.motion(position)) * *at;
    let collider = link.collider(shape, at, thing.state.mass_factor).position(moved);
    let collider = collider.collision_groups(group::base(thing.state.role));
    engine.add_collider(collider.user_data(group::mark(thing.id, index)).build(), thing.state.base);
}

fn engine_joint(joint: &Joint) -> GenericJoint {
    let (axis, anchor) = (convert::vector(joint.axis).normalize(), convert::point(joint.anchor));
    let limits = [joint.limits.0, joint.limits.1];
    match joint.kind {
        JointKind::Hinge => {
            let builder = RevoluteJointBuilder::new(axis).local_anchor1(anchor).local_anchor2(anchor);
            builder.limits(limits).contacts_enabled(false).build().into()
        }
        JointKind::Slide => {
            let builder = PrismaticJointBuilder::new(axis).local_anchor1(anchor).local_anchor2(anchor);
            builder.limits(limits).contacts_enabled(false).build().into()
        }
    }
}

pub(super) fn axis(kind: JointKind) -> JointAxis {
    match kind {
        JointKind::Hinge => JointAxis::AngX,
        JointKind::Slide => JointAxis::LinX,
    }
}

/// Coulomb friction: a motor with target speed zero and limited strength.
pub(super) fn idle(data: &mut GenericJoint, kind: JointKind, friction: f32) {
    let axis = axis(kind);
    if friction > 0.0 {
        data.set_motor_model(axis, MotorModel::AccelerationBased);
        data.set_motor(axis, 0.0, 0.0, 0.0, 1000.0);
        data.set_motor_max_force(axis, friction);
    } else {
        data.motor_axes.remove(axis.into());
    }
}

pub(super) fn friction(joint: &Joint, link: &Link, settings: &Settings) -> f32 {
    link.mass.mass()
        * match joint.kind {
            JointKind::Hinge => settings.hinge_friction,
            JointKind::Slide => settings.slide_friction,
        }
}

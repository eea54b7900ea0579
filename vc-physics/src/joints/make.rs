//! Bodies and joints of moving parts.

use rapier3d::dynamics::{
    GenericJoint, JointAxis, MotorModel, PrismaticJointBuilder, RevoluteJointBuilder, RigidBodyBuilder, RigidBodyType,
};
use vc_graph::asset::{Joint, JointKind};

use super::motion::{closed, opened};
use crate::engine::Engine;
use crate::shapes::Link;
use crate::state::{Moving, Thing};
use crate::{BodyRole, Settings, convert, group};

/// The mass from which on a base carries jointed bodies, kilograms.
const STURDY: f32 = 10.0;

/// Creates the bodies of a thing's moving parts.
pub(crate) fn add(engine: &mut Engine, thing: &mut Thing, settings: &Settings, open: bool) {
    let sturdy = thing.state.role == BodyRole::Fixed || thing.form.mass() * thing.state.mass_factor > STURDY;
    for index in 1..thing.form.links.len() {
        let form = thing.form.clone();
        let link = &form.links[index];
        let Some(joint) = link.joint else { continue };
        let position = if open { opened(joint.limits) } else { closed(joint.limits) };
        let moving = Moving {
            body: None,
            joint: None,
            limits: joint.limits,
            position,
            target: None,
            patience: 0,
            locked: false,
            latched: false,
        };
        let moving = if sturdy { jointed(engine, thing, index, moving, settings) } else { moving };
        if !sturdy {
            weld(engine, thing, index, position);
        }
        thing.state.moving.push(moving);
    }
}

/// A part with a body of its own.
fn jointed(engine: &mut Engine, thing: &Thing, index: usize, moving: Moving, settings: &Settings) -> Moving {
    let link = &thing.form.links[index];
    let (Some(joint), Some(base)) = (link.joint, engine.pose(thing.state.base)) else { return moving };
    let latched = settings.latches && moving.position == closed(joint.limits) && thing.state.role == BodyRole::Fixed;
    let kind = if latched { RigidBodyType::Fixed } else { RigidBodyType::Dynamic };
    let builder = RigidBodyBuilder::new(kind)
        .pose(convert::pose(&(base * joint.motion(moving.position))))
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
    Moving { body: Some(body), joint: Some(handle), latched, ..moving }
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

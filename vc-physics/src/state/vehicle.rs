//! A vehicle: a body on springs, with ray-cast wheels.
//!
//! The engine's ray-cast controller (after Bullet's `btRaycastVehicle`), Z up, X forward. Springs and dampers
//! have SI units and forces are in newtons; friction limits the force of the wheels.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use rapier3d::control::{DynamicRayCastVehicleController, WheelTuning};
use rapier3d::dynamics::{RigidBody, RigidBodyHandle};
use rapier3d::math::Vector;
use rapier3d::pipeline::QueryFilter;
use serde::{Deserialize, Serialize};
use vc_graph::hash::Digester;
use vc_graph::{NodeId, Pose};

use crate::convert;
use crate::engine::Engine;

/// The largest imbalance between spring force and weight at rest, as a fraction of the weight.
const CARRIED: f32 = 0.005;

/// A wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WheelPlan {
    /// Upper end of its spring, in the chassis's frame, metres.
    pub at: Point3<f32>,
    /// Radius, metres.
    pub radius: f32,
    /// Whether the wheel is steered.
    pub steered: bool,
    /// Whether the engine drives the wheel.
    pub driven: bool,
}

/// The design of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct VehiclePlan {
    /// Its wheels.
    pub wheels: Vec<WheelPlan>,
    /// Rate of each spring, newtons per metre.
    pub spring: f32,
    /// Rate of each damper, newton seconds per metre.
    pub damper: f32,
    /// Length of an unloaded spring, metres.
    pub travel: f32,
    /// Friction coefficient between tyres and road.
    pub grip: f32,
    /// The largest force of the engine, all wheels together, newtons.
    pub engine: f32,
    /// The largest force of the brakes, all wheels together, newtons.
    pub brakes: f32,
    /// The largest steering angle, radians.
    pub steering: f32,
}

impl VehiclePlan {
    /// A car with four wheels, front wheels steered and driven, for a chassis with a mass in kilograms. The
    /// wheels stand `base` apart along X and `track` along Y; the springs have a bounce frequency of 1.5 hertz
    /// and the dampers 0.3 of the critical rate, as in road cars. `axle` is the height of the axles above the
    /// chassis's origin at rest, metres.
    ///
    /// ```
    /// let car = vc_physics::VehiclePlan::car(1200.0, 2.6, 1.5, 0.32, 0.32);
    /// assert_eq!(car.wheels.len(), 4);
    /// assert!(car.wheels.iter().filter(|wheel| wheel.driven).all(|wheel| wheel.at.x > 0.0));
    /// ```
    pub fn car(mass: f32, base: f32, track: f32, radius: f32, axle: f32) -> Self {
        let share = mass / 4.0;
        let frequency = std::f32::consts::TAU * 1.5;
        let spring = share * frequency * frequency;
        let travel = 0.3;
        // At rest the spring is compressed by the weight.
        let top = axle + travel - share * 9.81 / spring;
        let wheel = |x: f32, y: f32| WheelPlan {
            at: Point3::new(x * base / 2.0, y * track / 2.0, top),
            radius,
            steered: x > 0.0,
            driven: x > 0.0,
        };
        Self {
            wheels: vec![wheel(1.0, 1.0), wheel(1.0, -1.0), wheel(-1.0, 1.0), wheel(-1.0, -1.0)],
            spring,
            damper: 0.3 * 2.0 * share * frequency,
            travel,
            grip: 0.9,
            engine: mass * 4.0,
            brakes: mass * 12.0,
            steering: 0.6,
        }
    }

    pub(crate) fn fault(&self) -> Option<&'static str> {
        let positive = |v: f32| v.is_finite() && v > 0.0;
        let figures = [self.spring, self.damper, self.travel, self.grip, self.engine, self.brakes];
        let wheels = self.wheels.iter().all(|w| positive(w.radius) && convert::is_finite(&w.at.coords));
        match () {
            () if self.wheels.is_empty() => Some("it has no wheels"),
            () if !wheels => Some("a wheel has a measure that is not finite or not positive"),
            () if !figures.into_iter().all(positive) => Some("a figure is not finite or not positive"),
            () if !self.steering.is_finite() => Some("the steering angle is not finite"),
            () => None,
        }
    }
}

/// The driver's controls.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct VehicleControls {
    /// Throttle, -1 (full backwards) to 1 (full ahead).
    pub throttle: f32,
    /// Brake pedal, 0 to 1.
    pub brake: f32,
    /// Steering wheel, -1 (right) to 1 (left).
    pub steering: f32,
}

#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct Vehicle {
    controller: DynamicRayCastVehicleController,
    pub(crate) controls: VehicleControls,
    engine: f32,
    brakes: f32,
    steering: f32,
    steered: Vec<bool>,
    driven: Vec<bool>,
}

impl Vehicle {
    /// A vehicle on a chassis with a mass in kilograms, its brakes on.
    pub(crate) fn new(plan: &VehiclePlan, chassis: RigidBodyHandle, mass: f32) -> Self {
        let mut controller = DynamicRayCastVehicleController::new(chassis);
        (controller.index_up_axis, controller.index_forward_axis) = (2, 0);
        let tuning = tuning(plan, mass);
        for wheel in &plan.wheels {
            controller.add_wheel(convert::point(wheel.at), -Vector::Z, -Vector::Y, plan.travel, wheel.radius, &tuning);
        }
        Self {
            controller,
            controls: VehicleControls { brake: 1.0, ..VehicleControls::default() },
            engine: plan.engine,
            brakes: plan.brakes,
            steering: plan.steering,
            steered: plan.wheels.iter().map(|w| w.steered).collect(),
            driven: plan.wheels.iter().map(|w| w.driven).collect(),
        }
    }

    /// The poses of the wheels, whose centres are turned by rolling and steering.
    pub(crate) fn wheels(&self, chassis: &Pose) -> Vec<Pose> {
        let pose = |wheel: &rapier3d::control::Wheel| {
            let steer = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), wheel.steering);
            let roll = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), wheel.rotation);
            Pose::from_parts(convert::vector3(wheel.center()).into(), chassis.rotation * steer * roll)
        };
        self.controller.wheels().iter().map(pose).collect()
    }

    /// Applies the wheels' forces. A sleeping vehicle without throttle stays asleep, and a vehicle that its
    /// springs do not carry yet does not fall asleep, although it is slow at the turn of a bounce.
    pub(crate) fn push(&mut self, engine: &mut Engine, gravity: f32) {
        let (dt, chassis) = (engine.dt(), self.controller.chassis);
        if !engine.bodies.get(chassis).is_some_and(|b| b.is_dynamic() && !b.is_sleeping() && b.is_enabled()) {
            return;
        }
        self.apply(dt);
        let filter = QueryFilter::default().exclude_rigid_body(chassis).exclude_sensors();
        self.controller.update_vehicle(dt, engine.queries_mut(filter));
        if engine.bodies.get(chassis).is_some_and(|b| self.bounces(engine, b, gravity))
            && let Some(body) = engine.body_mut(chassis)
        {
            body.activation_mut().time_since_can_sleep = 0.0;
        }
    }

    /// Whether the spring forces differ from the weight while nothing else carries the vehicle.
    fn bounces(&self, engine: &Engine, body: &RigidBody, gravity: f32) -> bool {
        let pressed: f32 = self.controller.wheels().iter().map(|w| w.wheel_suspension_force).sum();
        let weight = body.mass() * gravity;
        let across = weight * (*body.rotation() * Vector::Z).z;
        let mut pairs = body.colliders().iter().flat_map(|&c| engine.narrow.contact_pairs_with(c));
        (pressed - across).abs() > CARRIED * weight && !pairs.any(|p| p.has_any_active_contact())
    }

    /// Adds the controls and the state of the wheels to a hash.
    pub(crate) fn feed(&self, id: NodeId, hash: &mut Digester) {
        hash.word(u64::from(id.0));
        hash.reals([self.controls.throttle, self.controls.brake, self.controls.steering]);
        self.controller.wheels().iter().for_each(|w| _ = hash.reals([w.steering, w.rotation]));
    }

    /// Distributes the driver's controls over the wheels.
    fn apply(&mut self, dt: f32) {
        let driven = self.driven.iter().filter(|d| **d).count().max(1) as f32;
        let all = self.driven.len() as f32;
        let force = self.controls.throttle.clamp(-1.0, 1.0) * self.engine / driven;
        let brake = self.controls.brake.clamp(0.0, 1.0) * self.brakes * dt / all;
        let angle = self.controls.steering.clamp(-1.0, 1.0) * self.steering;
        for (i, wheel) in self.controller.wheels_mut().iter_mut().enumerate() {
            // The controller itself would let wheels pull twice as hard as they grip.
            let limit = wheel.friction_slip * wheel.wheel_suspension_force;
            wheel.engine_force = if self.driven[i] { force.clamp(-limit, limit) } else { 0.0 };
            wheel.steering = if self.steered[i] { angle } else { 0.0 };
            wheel.brake = brake.min(limit * dt);
        }
    }
}

/// The engine takes springs and dampers per kilogram of the chassis.
fn tuning(plan: &VehiclePlan, mass: f32) -> WheelTuning {
    WheelTuning {
        suspension_stiffness: plan.spring / mass,
        suspension_compression: plan.damper / mass,
        suspension_damping: plan.damper / mass,
        max_suspension_travel: plan.travel,
        side_friction_stiffness: 1.0,
        friction_slip: plan.grip,
        max_suspension_force: plan.spring * plan.travel * 2.0,
    }
}

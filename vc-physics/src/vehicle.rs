//! Vehicles of a world: loose things that drive.

use vc_graph::NodeId;

use crate::state::{Vehicle, VehicleControls, VehiclePlan};
use crate::world::PhysicsWorld;
use crate::{BodyRole, PhysicsError};

/// # Vehicles
impl PhysicsWorld {
    /// Makes a loose thing a vehicle, with its brakes on.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFree`],
    /// [`PhysicsError::BadVehicle`].
    pub fn add_vehicle(&mut self, id: NodeId, plan: &VehiclePlan) -> Result<(), PhysicsError> {
        let thing = self.thing(id)?;
        if thing.state.role != BodyRole::Loose {
            return Err(PhysicsError::NotFree(id));
        }
        if let Some(fault) = plan.fault() {
            return Err(PhysicsError::BadVehicle(id, fault));
        }
        let mass = thing.mass();
        let vehicle = Vehicle::new(plan, thing.state.base, mass);
        self.vehicles.insert(id, vehicle);
        Ok(())
    }

    /// Sets the driver's controls until they are set again.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`], [`PhysicsError::NotFinite`]; [`PhysicsError::NoVehicle`] if the thing is none.
    pub fn steer(&mut self, id: NodeId, controls: VehicleControls) -> Result<(), PhysicsError> {
        let all = [controls.throttle, controls.brake, controls.steering];
        if all.iter().any(|v| !v.is_finite()) {
            return Err(PhysicsError::NotFinite("the controls", id));
        }
        let base = self.thing(id)?.state.base;
        let vehicle = self.vehicles.get_mut(&id).ok_or(PhysicsError::NoVehicle(id))?;
        vehicle.controls = controls;
        if let Some(body) = self.engine.body_mut(base).filter(|_| controls.throttle != 0.0) {
            body.wake_up(true);
        }
        Ok(())
    }

    /// Applies the wheels' forces of all vehicles.
    pub(crate) fn push_vehicles(&mut self) {
        let Self { vehicles, engine, settings, .. } = self;
        vehicles.values_mut().for_each(|vehicle| vehicle.push(engine, settings.gravity));
    }
}

//! Reading one vehicle.

use nalgebra::Vector3;
use vc_graph::{NodeId, Pose};

use crate::PhysicsError;
use crate::state::{Thing, Vehicle};
use crate::world::PhysicsWorld;

/// A vehicle in its present state, as [`PhysicsWorld::vehicle`] gives it.
#[derive(Clone, Copy)]
pub struct VehicleView<'w> {
    world: &'w PhysicsWorld,
    thing: &'w Thing,
    vehicle: &'w Vehicle,
}

/// # Reading one vehicle
impl PhysicsWorld {
    /// A vehicle, to read it.
    ///
    /// # Errors
    /// [`PhysicsError::NoBody`]; [`PhysicsError::NoVehicle`] if the thing is none.
    pub fn vehicle(&self, id: NodeId) -> Result<VehicleView<'_>, PhysicsError> {
        let vehicle = self.vehicles.get(&id).ok_or(PhysicsError::NoVehicle(id));
        Ok(VehicleView { world: self, thing: self.thing(id)?, vehicle: vehicle? })
    }
}

impl VehicleView<'_> {
    /// Forward speed, metres a second.
    pub fn speed(&self) -> f32 {
        self.world.velocity(self.thing).dot(&(self.chassis().rotation * Vector3::x()))
    }

    /// The poses of its wheels, in the order of its plan: their centres, rotated by rolling and steering; Y is the
    /// axle.
    pub fn wheels(&self) -> Vec<Pose> {
        self.vehicle.wheels(&self.chassis())
    }

    fn chassis(&self) -> Pose {
        self.world.engine.pose(self.thing.state.base).unwrap_or_else(Pose::identity)
    }
}

//! The sensors of an environment, by number and name.

use std::fmt;
use std::sync::Arc;

use vc_graph::Seed;

use super::{Reading, Sensor, SensorError, SensorView};
use crate::environment::{CameraError, Environment, Mount, Named};

/// The number of a sensor of an environment: [`Environment::sensors`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SensorId(pub u32);

impl fmt::Display for SensorId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "sensor {}", self.0)
    }
}

/// A sensor of an environment.
#[derive(Debug, Clone)]
pub(crate) struct NamedSensor {
    pub(crate) name: String,
    pub(crate) mount: Mount,
    pub(crate) sensor: Arc<dyn Sensor>,
}

impl Named for NamedSensor {
    const KIND: &'static str = "sensor";

    fn name(&self) -> &str {
        &self.name
    }
}

impl Environment {
    /// Adds a sensor, also to clones that are made from now on. It is a setting, as the options of pictures are: neither
    /// the state of the home nor the [`digest`](Self::digest) depends on it, and saved environments are without. Shared
    /// sensors (`Arc<dyn Sensor>`) can be added too.
    ///
    /// # Errors
    /// [`CameraError`] if the name is taken, or the mount is on something that is not there or is no place.
    pub fn add_sensor(
        &mut self,
        name: impl Into<String>,
        mount: Mount,
        sensor: impl Sensor + 'static,
    ) -> Result<SensorId, CameraError> {
        self.with_sensor(NamedSensor { name: name.into(), mount, sensor: Arc::new(sensor) })
    }

    pub(crate) fn with_sensor(&mut self, sensor: NamedSensor) -> Result<SensorId, CameraError> {
        self.check_mount(&sensor.mount)?;
        Arc::make_mut(&mut self.sensors).add(0, &[], sensor).map(SensorId)
    }

    /// The sensors that were added: number, name and mount.
    pub fn sensors(&self) -> impl Iterator<Item = (SensorId, &str, &Mount)> {
        self.sensors.iter().map(|(number, sensor)| (SensorId(number), sensor.name.as_str(), &sensor.mount))
    }

    /// The number of the sensor with a name.
    ///
    /// # Errors
    /// [`CameraError::NoSuchName`], with the nearest names.
    pub fn sensor_named(&self, name: &str) -> Result<SensorId, CameraError> {
        self.sensors.find(name).map(SensorId).ok_or_else(|| self.sensors.unknown(name, &[]))
    }

    /// Removes a sensor; no other gets its number.
    ///
    /// # Errors
    /// [`CameraError::NoSuchNumber`].
    pub fn remove_sensor(&mut self, id: SensorId) -> Result<(), CameraError> {
        Arc::make_mut(&mut self.sensors).remove(id.0).map(drop).ok_or_else(|| unknown(id))
    }

    /// The measurement of a sensor now. Changes nothing; twice in one state it is the same.
    ///
    /// # Errors
    /// [`SensorError`].
    pub fn sense(&self, id: SensorId) -> Result<Reading, SensorError> {
        let sensor = self.sensors.get(id.0).ok_or_else(|| unknown(id))?;
        self.measure(sensor)
    }

    /// The measurements of all sensors now, by name, in the order of their numbers.
    ///
    /// # Errors
    /// That of the first sensor that fails.
    pub fn sense_all(&self) -> Result<Vec<(String, Reading)>, SensorError> {
        self.sensors.iter().map(|(_, sensor)| Ok((sensor.name.clone(), self.measure(sensor)?))).collect()
    }

    fn measure(&self, sensor: &NamedSensor) -> Result<Reading, SensorError> {
        let at = Seed::default().child(self.graph().name()).child(&sensor.name);
        let seed = at.nth(self.world().ticks()).nth(self.history().events().len() as u64);
        self.threads.run(|| sensor.sensor.sense(&SensorView { environment: self, mount: &sensor.mount, seed }))
    }
}

/// Sensors that are shared.
impl<S: Sensor + ?Sized> Sensor for Arc<S> {
    fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
        self.as_ref().sense(view)
    }
}

fn unknown(id: SensorId) -> CameraError {
    CameraError::NoSuchNumber { kind: NamedSensor::KIND, number: id.0 }
}

//! Sensors other than cameras: a trait, and a fisheye, a depth camera with noise and a lidar as examples of it.
//!
//! A [`Sensor`] is mounted like a camera ([`Mount`](crate::Mount)), has a number and a name, and gives a [`Reading`] of
//! the environment as it is. Noise comes from a seed of the environment, its tick and the sensor's name, never from a
//! clock: the same state gives the same bytes, on any number of threads.
//!
//! ```
//! use virtualcity::graph::Pose;
//! use virtualcity::sensors::{Fisheye, Lidar, NoisyDepth};
//! use virtualcity::{Environment, Mount};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let hat = Mount::Head { agent: me, offset: Pose::translation(-0.14, 0.0, 0.25) };
//! home.add_sensor("lidar", hat, Lidar { columns: 90, ..Lidar::default() })?;
//! home.add_sensor("depth", Mount::head(me), NoisyDepth { width: 64, height: 48, ..NoisyDepth::default() })?;
//! home.add_sensor("fisheye", Mount::head(me), Fisheye { side: 64, ..Fisheye::default() })?;
//! for (name, reading) in home.sense_all()? {
//!     println!("{name}: {reading:?}");
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A sensor of your own is a type with one function:
//!
//! ```
//! use virtualcity::nalgebra::Vector3;
//! use virtualcity::sensors::{Reading, Sensor, SensorError, SensorView};
//! use virtualcity::{Environment, Mount};
//!
//! /// Measures the distance straight ahead.
//! #[derive(Debug)]
//! struct Rangefinder;
//!
//! impl Sensor for Rangefinder {
//!     fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError> {
//!         let (rays, pose) = (view.environment().ray_caster()?, view.pose()?);
//!         let met = rays.first(&pose.translation.vector.into(), &(pose.rotation * Vector3::x()), 10.0);
//!         let error = view.seed().stream().normal(0.0, 0.005);
//!         let distance = met.map_or(f32::INFINITY, |hit| hit.distance + error);
//!         Ok(Reading::Numbers { values: vec![distance], shape: vec![1] })
//!     }
//! }
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let ahead = home.add_sensor("ahead", Mount::head(home.agents()[0]), Rangefinder)?;
//! let Reading::Numbers { values, .. } = home.sense(ahead)? else { return Err("no numbers".into()) };
//! assert!(values[0] > 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod depth;
mod fisheye;
mod lidar;

pub use self::depth::{DepthNoise, NoisyDepth};
pub use self::fisheye::Fisheye;
pub use self::lidar::Lidar;
pub use crate::environment::{LidarScan, Reading, Sensor, SensorError, SensorId, SensorView};

//! Sensors of an environment: the trait, what a sensor is given and gives, and those that were added (`suite`).

mod scan;
mod suite;

use std::fmt;

use vc_graph::{Label, Pose, Seed};
use vc_render::{Camera, Frame, Modalities, RenderError};

pub use self::scan::LidarScan;
pub(super) use self::suite::NamedSensor;
pub use self::suite::SensorId;
use super::{CameraError, Environment, Lens, Mount, PictureError, PictureOptions, Viewpoint};

/// A sensor: it measures something of an environment from where it is mounted. The [module](crate::sensors) has an example of
/// your own.
pub trait Sensor: fmt::Debug + Send + Sync {
    /// Measures. The reading is to depend on the view alone, noise on its [`seed`](SensorView::seed).
    ///
    /// # Errors
    /// [`SensorError`]; [`SensorError::Own`] is for reasons of sensors of your own.
    fn sense(&self, view: &SensorView<'_>) -> Result<Reading, SensorError>;
}

/// The measurement of a sensor.
#[non_exhaustive]
pub enum Reading {
    /// A picture: colours, distances, labels.
    Picture(Box<Frame>),
    /// Distances along rays.
    Scan(LidarScan),
    /// Any numbers, row by row; `shape` is the length along each axis, the slowest first.
    Numbers {
        /// The numbers.
        values: Vec<f32>,
        /// Lengths whose product is the count of numbers.
        shape: Vec<usize>,
    },
}

impl Reading {
    /// The picture, if it is one.
    pub fn picture(&self) -> Option<&Frame> {
        if let Self::Picture(frame) = self { Some(frame) } else { None }
    }

    /// The scan, if it is one.
    pub fn scan(&self) -> Option<&LidarScan> {
        if let Self::Scan(scan) = self { Some(scan) } else { None }
    }
}

impl fmt::Debug for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Picture(frame) => write!(f, "Picture({} x {}, {:?})", frame.width, frame.height, frame.modalities),
            Self::Scan(scan) => write!(f, "Scan({} lines of {})", scan.lines, scan.columns),
            Self::Numbers { shape, .. } => write!(f, "Numbers({shape:?})"),
        }
    }
}

/// Why a sensor gave no reading.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SensorError {
    /// The mount is gone, or nothing can be rendered there.
    #[error(transparent)]
    Render(#[from] RenderError<Label>),
    /// There is no such sensor.
    #[error(transparent)]
    Mounted(#[from] CameraError),
    /// A sensor's numbers make no sense; the text says which, and the range.
    #[error("the {sensor} cannot be used: its {wrong}")]
    Settings {
        /// The kind of sensor.
        sensor: &'static str,
        /// The number and its range.
        wrong: &'static str,
    },
    /// A reason of a sensor of your own.
    #[error("{0}")]
    Own(String),
}

impl From<PictureError> for SensorError {
    fn from(error: PictureError) -> Self {
        match error {
            PictureError::Camera(error) => error.into(),
            PictureError::Render(error) => error.into(),
        }
    }
}

/// Everything a sensor is given to measure with: the environment, where the sensor is, and a seed.
#[derive(Debug, Clone, Copy)]
pub struct SensorView<'a> {
    environment: &'a Environment,
    mount: &'a Mount,
    seed: Seed,
}

impl<'a> SensorView<'a> {
    /// The environment as it is.
    pub fn environment(&self) -> &'a Environment {
        self.environment
    }

    /// The seed of this sensor's noise now: of the environment's name, the sensor's name, the ticks that have passed and
    /// the number of actions done.
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// The pose of the sensor: it looks along X, its left is along Y, its top along Z.
    ///
    /// # Errors
    /// [`SensorError`] if the thing that it is mounted on has gone.
    pub fn pose(&self) -> Result<Pose, SensorError> {
        Ok(self.camera(Lens::Options, 64, 48)?.body())
    }

    /// A camera where the sensor is, for pictures of a size in pixels.
    ///
    /// # Errors
    /// As [`pose`](Self::pose).
    pub fn camera(&self, lens: Lens, width: u32, height: u32) -> Result<Camera, SensorError> {
        let lens = lens.camera(self.environment.pictures(), width, height);
        Ok(self.environment.mounted(self.mount, lens)?)
    }

    /// A picture from a camera, which may be turned or shifted.
    ///
    /// # Errors
    /// As [`Environment::render`].
    pub fn render(&self, camera: &Camera, wanted: impl Into<Modalities>) -> Result<Frame, SensorError> {
        self.render_as(self.environment.pictures(), camera, wanted.into())
    }

    /// A picture with other options.
    pub(crate) fn render_as(
        &self,
        how: &PictureOptions,
        camera: &Camera,
        wanted: Modalities,
    ) -> Result<Frame, SensorError> {
        let view = Viewpoint::Free(*camera);
        Ok(self.environment.picture(how, None, (view, wanted), (camera.width, camera.height))?)
    }
}

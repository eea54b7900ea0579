//! Lenses: which part of the view a camera shows.

use vc_render::Camera;
use vc_render::camera::MAX_SIDE;

use super::{CameraError, PictureOptions};

/// Longest focal length, and farthest principal point, pixels.
const LONGEST: f32 = 1e6;

/// The lens of a camera of an environment.
///
/// ```
/// use virtualcity::Lens;
/// let text = serde_json::to_string(&Lens::FieldOfView(1.2))?;
/// assert_eq!(text, r#"{"field_of_view":1.2}"#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Lens {
    /// The field of view that the environment's [`PictureOptions`] have for eyes and rooms.
    #[default]
    Options,
    /// A vertical field of view, radians, with square pixels and the principal point in the middle.
    FieldOfView(f32),
    /// A calibrated camera. Pictures of another size show the same part of the view.
    Intrinsics {
        /// Pixels across and down for which the other numbers are.
        size: (u32, u32),
        /// Focal lengths across and down (`fx`, `fy`), pixels.
        focal: (f32, f32),
        /// Principal point from the top left corner (`cx`, `cy`), pixels.
        centre: (f32, f32),
    },
}

impl Lens {
    /// A camera with this lens for pictures of a size.
    pub(crate) fn camera(&self, options: &PictureOptions, width: u32, height: u32) -> Camera {
        match *self {
            Self::Options => Camera::with_fov(width, height, options.field_of_view),
            Self::FieldOfView(field) => Camera::with_fov(width, height, field),
            Self::Intrinsics { size: (across, down), focal, centre } => {
                Camera::with_intrinsics(across, down, focal, centre).resized(width, height)
            }
        }
    }

    /// Refuses a lens with which no picture can be made.
    pub(crate) fn check(&self) -> Result<(), CameraError> {
        let length = |v: f32| v.is_finite() && v > 0.0 && v <= LONGEST;
        let side = 1..=MAX_SIDE;
        match *self {
            Self::FieldOfView(field) if !(field > 0.0 && field < std::f32::consts::PI) => {
                Err(CameraError::FieldOfView(field))
            }
            Self::Intrinsics { size, .. } if !side.contains(&size.0) || !side.contains(&size.1) => {
                Err(CameraError::Intrinsics("size is to be 1 to 8192 pixels along each side"))
            }
            Self::Intrinsics { focal, .. } if !length(focal.0) || !length(focal.1) => {
                Err(CameraError::Intrinsics("focal lengths are to be above 0 and at most a million pixels"))
            }
            Self::Intrinsics { centre, .. } if !(centre.0.abs() < LONGEST && centre.1.abs() < LONGEST) => {
                Err(CameraError::Intrinsics("principal point is to be within a million pixels"))
            }
            _ => Ok(()),
        }
    }
}

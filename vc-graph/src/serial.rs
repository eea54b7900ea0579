//! How poses and vectors are written: plain arrays. The public modules are for `#[serde(with)]`.

use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::{Bounds, BoundsFrame, Pose};

/// A pose: position in metres, rotation as quaternion x, y, z, w.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PoseFile {
    position: [f32; 3],
    rotation: [f32; 4],
}

impl From<&Pose> for PoseFile {
    fn from(pose: &Pose) -> Self {
        Self { position: pose.translation.vector.into(), rotation: pose.rotation.coords.into() }
    }
}

/// Farthest from the origin that any format places a thing, metres.
pub(crate) const FARTHEST: f32 = 1e7;
/// Largest scale that any format has.
pub(crate) const LARGEST_SCALE: f32 = 1e9;
/// Largest size and offset of a box, metres: things may be scaled by [`LARGEST_SCALE`].
const LARGEST_BOX: f32 = 1e12;

/// Whether numbers are finite and no larger than a limit, either sign.
pub(crate) fn within(numbers: &[f32], limit: f32) -> bool {
    numbers.iter().all(|v| v.abs() <= limit)
}

/// Whether the numbers of a box are within the limits of every format.
pub(crate) fn is_box(numbers: &[f32]) -> bool {
    within(numbers, LARGEST_BOX)
}

/// Whether a quaternion is of unit length. If so it is kept to the bit: to normalise it would change the
/// file's numbers.
fn is_unit(rotation: &Quaternion<f32>) -> bool {
    (rotation.norm() - 1.0).abs() < 1e-3
}

/// The rotation of a quaternion of any length; one of no length turns nothing.
pub(crate) fn mended(rotation: Quaternion<f32>) -> UnitQuaternion<f32> {
    if is_unit(&rotation) {
        return UnitQuaternion::new_unchecked(rotation);
    }
    UnitQuaternion::try_new(rotation, f32::MIN_POSITIVE).unwrap_or_else(UnitQuaternion::identity)
}

impl PoseFile {
    /// The pose, if its numbers are sensible and its rotation has unit length.
    pub(crate) fn pose(&self) -> Option<Pose> {
        let rotation = Quaternion::from(nalgebra::Vector4::from(self.rotation));
        let sound = is_unit(&rotation) && within(&self.position, FARTHEST);
        let rotation = UnitQuaternion::new_unchecked(rotation);
        sound.then(|| Isometry3::from_parts(Translation3::from(Vector3::from(self.position)), rotation))
    }
}

/// A box.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BoundsFile {
    offset: [f32; 3],
    half: [f32; 3],
    #[serde(default, skip_serializing_if = "is_false")]
    world: bool,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde asks for a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

impl From<&Bounds> for BoundsFile {
    fn from(bounds: &Bounds) -> Self {
        Self { offset: bounds.offset.into(), half: bounds.half.into(), world: bounds.frame == BoundsFrame::World }
    }
}

impl BoundsFile {
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        let sound = is_box(&self.offset) && is_box(&self.half) && self.half.iter().all(|v| *v >= 0.0);
        let frame = if self.world { BoundsFrame::World } else { BoundsFrame::Object };
        sound.then(|| Bounds { offset: self.offset.into(), half: self.half.into(), frame })
    }
}

/// `#[serde(with)]` for a pose: `{"position": [x, y, z], "rotation": [x, y, z, w]}`, metres and a unit quaternion.
///
/// ```
/// use vc_graph::Pose;
/// #[derive(serde::Serialize, serde::Deserialize)]
/// struct Mark {
///     #[serde(with = "vc_graph::serial::pose")]
///     at: Pose,
/// }
/// let text = serde_json::to_string(&Mark { at: Pose::translation(1.0, 2.0, 0.5) })?;
/// assert_eq!(text, r#"{"at":{"position":[1.0,2.0,0.5],"rotation":[0.0,0.0,0.0,1.0]}}"#);
/// assert_eq!(serde_json::from_str::<Mark>(&text)?.at, Pose::translation(1.0, 2.0, 0.5));
/// # Ok::<(), serde_json::Error>(())
/// ```
pub mod pose {
    use serde::de::Error;

    use super::{Deserialize, Pose, PoseFile, Serialize};

    /// Writes a pose.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: serde::Serializer>(pose: &Pose, s: S) -> Result<S::Ok, S::Error> {
        PoseFile::from(pose).serialize(s)
    }

    /// Reads a pose.
    ///
    /// # Errors
    /// Those of the deserializer; a position that is not finite or farther than 10,000 km away; a rotation that is not
    /// of unit length.
    pub fn deserialize<'de, D: serde::Deserializer<'de>>(d: D) -> Result<Pose, D::Error> {
        sound(&PoseFile::deserialize(d)?)
    }

    fn sound<E: Error>(file: &PoseFile) -> Result<Pose, E> {
        file.pose().ok_or_else(|| E::custom("a pose has finite numbers and a rotation of unit length"))
    }

    /// A pose that may be unknown.
    pub(crate) mod known {
        use super::{Deserialize, Pose, PoseFile, Serialize, sound};

        pub(crate) fn serialize<S: serde::Serializer>(pose: &Option<Pose>, s: S) -> Result<S::Ok, S::Error> {
            pose.as_ref().map(PoseFile::from).serialize(s)
        }

        pub(crate) fn deserialize<'de, D: serde::Deserializer<'de>>(d: D) -> Result<Option<Pose>, D::Error> {
            Option::<PoseFile>::deserialize(d)?.as_ref().map(sound).transpose()
        }
    }
}

/// `#[serde(with)]` for a vector: `[x, y, z]`.
pub mod vector {
    use super::{Deserialize, Serialize, Vector3};

    /// Writes a vector.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: serde::Serializer>(v: &Vector3<f32>, s: S) -> Result<S::Ok, S::Error> {
        <[f32; 3]>::from(*v).serialize(s)
    }

    /// Reads a vector.
    ///
    /// # Errors
    /// Those of the deserializer.
    pub fn deserialize<'de, D: serde::Deserializer<'de>>(d: D) -> Result<Vector3<f32>, D::Error> {
        <[f32; 3]>::deserialize(d).map(Vector3::from)
    }
}

/// `#[serde(with)]` for a point.
pub(crate) mod point {
    use super::{Deserialize, Point3, Serialize};
    pub(crate) fn serialize<S: serde::Serializer>(p: &Point3<f32>, s: S) -> Result<S::Ok, S::Error> {
        [p.x, p.y, p.z].serialize(s)
    }
    pub(crate) fn deserialize<'de, D: serde::Deserializer<'de>>(d: D) -> Result<Point3<f32>, D::Error> {
        <[f32; 3]>::deserialize(d).map(Point3::from)
    }
}

/// `#[serde(with)]` for a list of points.
pub(crate) mod points {
    use super::{Deserialize, Point3, Serialize};
    pub(crate) fn serialize<S: serde::Serializer>(points: &[Point3<f32>], s: S) -> Result<S::Ok, S::Error> {
        points.iter().map(|p| [p.x, p.y, p.z]).collect::<Vec<_>>().serialize(s)
    }
    pub(crate) fn deserialize<'de, D: serde::Deserializer<'de>>(d: D) -> Result<Vec<Point3<f32>>, D::Error> {
        Ok(Vec::<[f32; 3]>::deserialize(d)?.into_iter().map(Point3::from).collect())
    }
}

//! The numbers of an aim: whole millimetres and hundredths of a degree.

use std::fmt;

use nalgebra::{Point2, UnitQuaternion, Vector3};

use super::AimError;

/// Millimetres of a metre.
const PER_METRE: f64 = 1000.0;
/// The largest coordinate, metres.
const FARTHEST: f64 = 1e6;
/// Hundredths of a degree in a degree and in half a turn.
const PER_DEGREE: f64 = 100.0;
const HALF_TURN: i16 = 18_000;

/// A point of the world, in whole millimetres.
///
/// ```
/// use vc_graph::AimPoint;
/// let point = AimPoint::new(1.2, -0.4, None)?;
/// assert_eq!((point.to_string(), point.height()), ("1.20 -0.40".to_owned(), None));
/// assert_eq!(AimPoint::new(0.0, 0.0014, Some(0.75))?.to_string(), "0.00 0.001 0.75");
/// assert!(AimPoint::new(f64::NAN, 0.0, None).is_err());
/// # Ok::<(), vc_graph::AimError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AimPoint {
    x: i32,
    y: i32,
    z: Option<i32>,
}

impl AimPoint {
    /// A point in the world's frame, metres, rounded to millimetres; the height if it matters.
    ///
    /// # Errors
    /// [`AimError::OutOfRange`].
    pub fn new(x: f64, y: f64, z: Option<f64>) -> Result<Self, AimError> {
        Ok(Self { x: millimetres(x)?, y: millimetres(y)?, z: z.map(millimetres).transpose()? })
    }

    /// The point seen from above, metres.
    pub fn plan(&self) -> Point2<f32> {
        Point2::new(metres(self.x), metres(self.y))
    }

    /// The height, metres, if it is stated.
    pub fn height(&self) -> Option<f32> {
        self.z.map(metres)
    }
}

fn millimetres(metres: f64) -> Result<i32, AimError> {
    let fits = metres.abs() <= FARTHEST;
    if fits { Ok((metres * PER_METRE).round() as i32) } else { Err(AimError::OutOfRange(format!("{metres:e}"))) }
}

fn metres(millimetres: i32) -> f32 {
    (f64::from(millimetres) / PER_METRE) as f32
}

impl fmt::Display for AimPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let write = |f: &mut fmt::Formatter<'_>, gap: &str, value: i32| {
            let sign = if value < 0 { "-" } else { "" };
            let (whole, part) = (value.unsigned_abs() / 1000, value.unsigned_abs() % 1000);
            match part % 10 {
                0 => write!(f, "{gap}{sign}{whole}.{:02}", part / 10),
                _ => write!(f, "{gap}{sign}{whole}.{part:03}"),
            }
        };
        write(f, "", self.x)?;
        write(f, " ", self.y)?;
        self.z.map_or(Ok(()), |z| write(f, " ", z))
    }
}

impl serde::Serialize for AimPoint {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

/// A heading, in whole hundredths of a degree from more than -180 to 180 degrees, counter-clockwise from the world's X.
///
/// ```
/// use vc_graph::Heading;
/// assert_eq!(Heading::new(270.0)?, Heading::new(-90.0)?);
/// assert_eq!(Heading::new(-90.0)?.to_string(), "-90");
/// assert_eq!(Heading::new(12.25)?.degrees(), 12.25);
/// # Ok::<(), vc_graph::AimError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Heading(i16);

impl Heading {
    /// A heading of any number of degrees.
    ///
    /// # Errors
    /// [`AimError::OutOfRange`] if it is not finite.
    pub fn new(degrees: f64) -> Result<Self, AimError> {
        if !degrees.is_finite() {
            return Err(AimError::OutOfRange(degrees.to_string()));
        }
        let turn = (degrees.rem_euclid(360.0) * PER_DEGREE).round() as i32 % (2 * i32::from(HALF_TURN));
        let turn = if turn > i32::from(HALF_TURN) { turn - 2 * i32::from(HALF_TURN) } else { turn };
        Ok(Self(turn as i16))
    }

    /// Degrees.
    pub fn degrees(self) -> f32 {
        f32::from(self.0) / PER_DEGREE as f32
    }

    /// The rotation around the vertical that turns X to this heading.
    pub fn rotation(self) -> UnitQuaternion<f32> {
        UnitQuaternion::from_axis_angle(&Vector3::z_axis(), self.degrees().to_radians())
    }
}

impl fmt::Display for Heading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.0 < 0 { "-" } else { "" };
        let (whole, part) = (self.0.unsigned_abs() / 100, self.0.unsigned_abs() % 100);
        match (part, part % 10) {
            (0, _) => write!(f, "{sign}{whole}"),
            (_, 0) => write!(f, "{sign}{whole}.{}", part / 10),
            _ => write!(f, "{sign}{whole}.{part:02}"),
        }
    }
}

//! The sky, the sun and the ground outside the house.

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use crate::RenderError;

/// The light outside. Radiance is in units of 5000 candela per square metre, about that of an overcast sky,
/// linear RGB; the sun's irradiance is in these units times steradians, 5000 lux.
///
/// ```
/// use vc_render::Daylight;
/// let evening = Daylight::clear(0.2, 3.9);
/// assert!(evening.sun.x < Daylight::noon().sun.x); // less of the sun comes through
/// assert_eq!(Daylight::night().sun.norm(), 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Daylight {
    /// Direction to the sun, unit length.
    pub towards_sun: Vector3<f32>,
    /// Irradiance of the sun on a surface that faces it, linear RGB.
    pub sun: Vector3<f32>,
    /// Radiance of the sky at the zenith.
    pub zenith: Vector3<f32>,
    /// Radiance of the sky at the horizon.
    pub horizon: Vector3<f32>,
    /// Radiance of the ground far away.
    pub ground: Vector3<f32>,
}

/// Elevation and azimuth of the sun at noon, radians.
const NOON: (f32, f32) = (0.85, 0.7);
/// Least elevation of the sun while it lights a home, radians.
const LOW: f32 = 0.12;
/// Radiance of the zenith below which people switch lamps on.
const DARK: f32 = 0.1;
/// Beginning and end of dusk, hours from midday.
const DUSK: (f32, f32) = (5.5, 7.5);

impl Daylight {
    /// A clear day with the sun at an elevation above the horizon and an azimuth from X towards Y, radians. The
    /// lower the sun, the redder it is, by the air mass that its light passes (Kasten and Young's formula,
    /// rounded).
    ///
    /// ```
    /// use vc_render::Daylight;
    /// // The sun half a right angle high.
    /// let daylight = Daylight::clear(0.785, 0.0);
    /// assert!((daylight.towards_sun.z - 0.707).abs() < 1e-2);
    /// assert!(!daylight.is_dark() && Daylight::night().is_dark());
    /// ```
    pub fn clear(elevation: f32, azimuth: f32) -> Self {
        let (rise, level) = elevation.sine_cosine();
        let (s, c) = azimuth.sine_cosine();
        // The air mass (Kasten and Young's formula, rounded), and the transmission of each colour through it.
        let air = 1.0 / (rise.max(0.0) + 0.05);
        let through = Vector3::new(0.12, 0.19, 0.32).map(|k: f32| (-k * air).exponential());
        let day = (rise * 1.6).clamp(0.0, 1.0);
        let warm = 1.0 - (rise * 1.6).clamp(0.0, 1.0);
        let blue = Vector3::new(0.30 + 0.25 * warm, 0.52, 0.95 - 0.25 * warm) * (0.9 * day);
        let haze = Vector3::new(0.95 + 0.9 * warm, 1.02, 1.10 - 0.6 * warm) * (1.1 * day);
        Self {
            towards_sun: Vector3::new(level * c, level * s, rise),
            sun: if rise > 0.0 { through * 16.0 } else { Vector3::zeros() },
            zenith: blue,
            horizon: haze,
            ground: Vector3::new(0.20 + 0.08 * warm, 0.22, 0.14 - 0.04 * warm) * (0.3 + day),
        }
    }

    /// A clear day with the sun high.
    pub fn noon() -> Self {
        Self::clear(NOON.0, NOON.1)
    }

    /// A clear day's light at an hour of the day, 0 to 24: [`noon`](Self::noon) at 12; the sun half as high at
    /// 8 in the east and at 16 in the west; dusk from 17.5 to 19.5; [`night`](Self::night); and dawn from 4.5
    /// to 6.5. Hours beyond 0 to 24 wrap around to the day before or after; an hour that is not finite counts
    /// as midday.
    ///
    /// ```
    /// use vc_render::Daylight;
    /// assert_eq!(Daylight::at(12.0), Daylight::noon());
    /// assert_eq!(Daylight::at(23.0), Daylight::night());
    /// assert_eq!(Daylight::at(f32::NAN), Daylight::noon());
    /// let [morning, evening] = [Daylight::at(8.0), Daylight::at(19.0)];
    /// assert!(morning.sun.x > 0.0 && evening.sun.x == 0.0 && evening.zenith.z < morning.zenith.z);
    /// ```
    pub fn at(hour: f32) -> Self {
        use std::f32::consts::PI;
        let hour = if hour.is_finite() { hour } else { 12.0 };
        // Hours from midday, -12 to 12.
        let off = (hour - 12.0) - 24.0 * ((hour - 12.0) / 24.0).round();
        let rise = NOON.0 * (off * PI / 12.0).cosine();
        let day = Self::clear(rise.max(LOW), NOON.1 - off * PI / 12.0);
        let (since, night) = ((off.abs() - DUSK.0) / (DUSK.1 - DUSK.0), Self::night());
        match since {
            s if s <= 0.0 => day,
            s if s < 1.0 => {
                // Light falls off exponentially.
                let between = |day: Vector3<f32>, night: Vector3<f32>| {
                    day.zip_map(&night, |day, night| day.max(night) * (night / day.max(night)).power(s))
                };
                let (zenith, horizon) = (between(day.zenith, night.zenith), between(day.horizon, night.horizon));
                let ground = between(day.ground, night.ground);
                Self { sun: Vector3::zeros(), zenith, horizon, ground, ..day }
            }
            _ => night,
        }
    }

    /// An evenly grey sky without sun.
    pub fn overcast() -> Self {
        let grey = Vector3::new(0.95, 1.0, 1.06);
        Self { sun: Vector3::zeros(), zenith: grey * 1.2, horizon: grey * 0.7, ..Self::clear(0.85, 0.7) }
    }

    /// Darkness, except for a little light of the sky.
    pub fn night() -> Self {
        // The night sky of a town has some tenths of a candela per square metre: it is far darker than walls by
        // lamplight.
        let dark = Vector3::new(1.0e-5, 1.5e-5, 3.0e-5);
        Self { sun: Vector3::zeros(), zenith: dark, horizon: dark * 1.8, ground: dark * 0.4, ..Self::noon() }
    }

    /// Whether people would have their lamps on: after sunset and before sunrise, or under an equally dark sky.
    ///
    /// ```
    /// use vc_render::Daylight;
    /// assert!(Daylight::at(19.0).is_dark() && Daylight::night().is_dark());
    /// assert!(!Daylight::at(8.0).is_dark() && !Daylight::overcast().is_dark());
    /// ```
    pub fn is_dark(&self) -> bool {
        self.sun == Vector3::zeros() && crate::colour::luminance(self.zenith.into()) < DARK
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let bad = |v: &Vector3<f32>| v.iter().any(|c| !(0.0..1e6).contains(c));
        let colours = [
            (&self.sun, "sun is to be from 0 to 1e6 in each colour"),
            (&self.zenith, "zenith is to be from 0 to 1e6 in each colour"),
            (&self.horizon, "horizon is to be from 0 to 1e6 in each colour"),
            (&self.ground, "ground is to be from 0 to 1e6 in each colour"),
        ];
        if let Some((_, wrong)) = colours.into_iter().find(|(colour, _)| bad(colour)) {
            return Err(RenderError::BadDaylight(wrong));
        }
        let length = self.towards_sun.norm();
        let there = (0.99..1.01).contains(&length);
        if there { Ok(()) } else { Err(RenderError::BadDaylight("direction to the sun is to be of unit length")) }
    }

    /// Radiance from a direction of unit length, without the sun's disc.
    pub(crate) fn radiance(&self, towards: [f32; 3]) -> [f32; 3] {
        let rise = towards[2];
        if rise < 0.0 {
            let far = (1.0 + rise * 6.0).max(0.0);
            return (self.ground + (self.horizon - self.ground) * (far * far * 0.8)).into();
        }
        let share = 1.0 - rise;
        let low = share * share * share;
        let glow = self.towards_sun.dot(&Vector3::from(towards)).max(0.0).raised(32) * 0.02;
        (self.zenith + (self.horizon - self.zenith) * low + self.sun * glow).into()
    }
}

impl Default for Daylight {
    fn default() -> Self {
        Self::noon()
    }
}

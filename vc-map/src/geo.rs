//! Degrees and metres.

use vc_graph::portable::Portable;

use crate::{Origin, Point};

/// The equatorial radius of the Earth, metres, and the square of its eccentricity (WGS 84).
const RADIUS: f64 = 6_378_137.0;
const ECCENTRICITY: f64 = 0.006_694_379_990_14;
/// The square of the second eccentricity.
const SECOND: f64 = ECCENTRICITY / (1.0 - ECCENTRICITY);

/// An angle in degrees between -180 and 180.
pub(crate) fn turned(degrees: f64) -> f64 {
    if degrees.abs() <= 180.0 { degrees } else { degrees - 360.0 * (degrees / 360.0).round() }
}

/// Differences of longitude beyond this are not projected but only scaled, radians; no map reaches so far.
const WIDEST: f64 = 0.5;

/// The transverse Mercator projection of the ellipsoid whose middle meridian and point zero are those of an origin: X east, Y
/// north, without a scale factor. Angles are right everywhere, lengths to a part in a thousand within 280 km east and
/// west of the origin. The series are those of Snyder, Map Projections: A Working Manual, USGS 1987, pages 60 to 64.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) origin: Origin,
    /// The length of the meridian from the equator to the origin, metres.
    zero: f64,
}

/// The length of a meridian from the equator to a latitude in radians, metres.
fn meridian(latitude: f64) -> f64 {
    let e = ECCENTRICITY;
    let waves = [
        1.0 - e / 4.0 - 3.0 * e * e / 64.0 - 5.0 * e * e * e / 256.0,
        3.0 * e / 8.0 + 3.0 * e * e / 32.0 + 45.0 * e * e * e / 1024.0,
        15.0 * e * e / 256.0 + 45.0 * e * e * e / 1024.0,
        35.0 * e * e * e / 3072.0,
    ];
    let sine = |times: f64| (times * latitude).sine();
    RADIUS * (waves[0] * latitude - waves[1] * sine(2.0) + waves[2] * sine(4.0) - waves[3] * sine(6.0))
}

/// The latitude in radians at which a meridian has a length in metres.
fn foot(metres: f64) -> f64 {
    let e = ECCENTRICITY;
    let root = (1.0 - e).sqrt();
    let f = (1.0 - root) / (1.0 + root);
    let mean = metres / (RADIUS * (1.0 - e / 4.0 - 3.0 * e * e / 64.0 - 5.0 * e * e * e / 256.0));
    let sine = |times: f64| (times * mean).sine();
    mean + (1.5 * f - 27.0 * f * f * f / 32.0) * sine(2.0)
        + (21.0 * f * f / 16.0 - 55.0 * f * f * f * f / 32.0) * sine(4.0)
        + 151.0 * f * f * f / 96.0 * sine(6.0)
        + 1097.0 * f * f * f * f / 512.0 * sine(8.0)
}

/// For a latitude in radians: tangent and cosine, the radius of curvature across the meridian in metres, the square of the
/// tangent, and the square of the second eccentricity times that of the cosine.
fn curved(latitude: f64) -> [f64; 5] {
    let (sine, cosine) = latitude.sine_cosine();
    let tangent = latitude.tangent();
    let across = RADIUS / (1.0 - ECCENTRICITY * sine * sine).sqrt();
    [tangent, cosine, across, tangent * tangent, SECOND * cosine * cosine]
}

impl Frame {
    pub(crate) fn new(origin: Origin) -> Self {
        Self { origin, zero: meridian(origin.latitude.to_radians()) }
    }

    /// The point at degrees of latitude and longitude.
    pub(crate) fn point(&self, [latitude, longitude]: [f64; 2]) -> Point {
        let (latitude, east) = (latitude.to_radians(), turned(longitude - self.origin.longitude).to_radians());
        let [tangent, cosine, across, t, c] = curved(latitude);
        let a = east * cosine;
        let north = meridian(latitude) - self.zero;
        if east.abs() > WIDEST {
            return Point::new(across * a, north);
        }
        let x = a
            + (1.0 - t + c) * a.raised(3) / 6.0
            + (5.0 - 18.0 * t + t * t + 72.0 * c - 58.0 * SECOND) * a.raised(5) / 120.0;
        let y = a * a / 2.0
            + (5.0 - t + 9.0 * c + 4.0 * c * c) * a.raised(4) / 24.0
            + (61.0 - 58.0 * t + t * t + 600.0 * c - 330.0 * SECOND) * a.raised(6) / 720.0;
        Point::new(across * x, north + across * tangent * y)
    }

    /// The degrees of latitude and longitude of a point.
    pub(crate) fn degrees(&self, point: &Point) -> [f64; 2] {
        let foot = foot(self.zero + point.y);
        let [tangent, cosine, across, t, c] = curved(foot);
        let d = point.x / across;
        // The radius of curvature across the meridian is 1 + c times that along it.
        let down = d * d / 2.0 - (5.0 + 3.0 * t + 10.0 * c - 4.0 * c * c - 9.0 * SECOND) * d.raised(4) / 24.0
            + (61.0 + 90.0 * t + 298.0 * c + 45.0 * t * t - 252.0 * SECOND - 3.0 * c * c) * d.raised(6) / 720.0;
        let east = d - (1.0 + 2.0 * t + c) * d.raised(3) / 6.0
            + (5.0 - 2.0 * c + 28.0 * t - 3.0 * c * c + 8.0 * SECOND + 24.0 * t * t) * d.raised(5) / 120.0;
        let latitude = (foot - tangent * (1.0 + c) * down).to_degrees().clamp(-90.0, 90.0);
        [latitude, turned(self.origin.longitude + (east / cosine).to_degrees()).clamp(-180.0, 180.0)]
    }
}

//! Degrees and metres.

use vc_graph::portable::Portable;

use crate::{Origin, Point};

/// The equatorial radius of the Earth, metres, and the square of its eccentricity (WGS 84).
const RADIUS: f64 = 6_378_137.0;
const ECCENTRICITY: f64 = 0.006_694_379_990_14;

/// The plane that touches the Earth at an origin: X east, Y north. Within 20 km of it lengths are right to a part in
/// a thousand at most latitudes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) origin: Origin,
    /// Metres for a degree of longitude and of latitude.
    scale: [f64; 2],
}

impl Frame {
    pub(crate) fn new(origin: Origin) -> Self {
        let (sine, cosine) = origin.latitude.to_radians().sine_cosine();
        let flat = 1.0 - ECCENTRICITY * sine * sine;
        let across = RADIUS.to_radians() / flat.sqrt();
        Self { origin, scale: [across * cosine, across * (1.0 - ECCENTRICITY) / flat] }
    }

    /// The point at degrees of latitude and longitude.
    pub(crate) fn point(&self, [latitude, longitude]: [f64; 2]) -> Point {
        let [x, y] = self.scale;
        Point::new((longitude - self.origin.longitude) * x, (latitude - self.origin.latitude) * y)
    }

    /// The degrees of latitude and longitude of a point.
    pub(crate) fn degrees(&self, point: &Point) -> [f64; 2] {
        let [x, y] = self.scale;
        [self.origin.latitude + point.y / y, self.origin.longitude + point.x / x]
    }
}

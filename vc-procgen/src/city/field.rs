//! The directions of streets: a field of crosses over the plan, the sum of a grid and of rays from centres (Chen and others,
//! "Interactive procedural street modeling", 2008).

use nalgebra::Vector2;
use vc_graph::Seed;
use vc_graph::portable::Portable;
use vc_map::Point;

/// The pattern of a city's streets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum StreetPattern {
    /// Streets in two directions, whose distances vary.
    Grid,
    /// Rays from the middle, and rings around it.
    Radial,
    /// A grid with rays and rings about the middle.
    Mixed,
}

impl StreetPattern {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Grid, Self::Radial, Self::Mixed];

    /// The word in texts.
    pub fn word(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Radial => "radial",
            Self::Mixed => "mixed",
        }
    }
}

/// A centre of rays and rings.
struct Centre {
    at: Point,
    /// The distance at which its influence has fallen to a third, metres.
    reach: f64,
    weight: f64,
}

pub(super) struct Field {
    /// The direction of the grid as the angle's double, which is the same for all four arms of a cross but for its sign.
    grid: Vector2<f64>,
    centres: Vec<Centre>,
}

impl Field {
    pub(super) fn new(pattern: StreetPattern, heading: f64, size: f64, middle: Point, seed: Seed) -> Self {
        let mut stream = seed.child("field").stream();
        let (sine, cosine) = (2.0 * heading).sine_cosine();
        let mut aside = || {
            Point::new(
                middle.x + size * f64::from(stream.between(-0.12, 0.12)),
                middle.y + size * f64::from(stream.between(-0.12, 0.12)),
            )
        };
        let centres = match pattern {
            StreetPattern::Grid => Vec::new(),
            StreetPattern::Radial => vec![Centre { at: aside(), reach: size, weight: 6.0 }],
            StreetPattern::Mixed => vec![Centre { at: aside(), reach: size * 0.22, weight: 4.0 }],
        };
        Self { grid: Vector2::new(cosine, sine), centres }
    }

    /// One of the two directions at a point, as a unit vector; the other is across.
    pub(super) fn at(&self, point: &Point) -> Vector2<f64> {
        let double = self.centres.iter().fold(self.grid, |sum, centre| {
            let away = point - centre.at;
            let square = away.norm_squared().max(1.0);
            let ray = Vector2::new(away.x * away.x - away.y * away.y, 2.0 * away.x * away.y) / square;
            sum + ray * (centre.weight * (-square / (centre.reach * centre.reach)).exponential())
        });
        let heading = double.y.angle_to(double.x) / 2.0;
        let (sine, cosine) = heading.sine_cosine();
        Vector2::new(cosine, sine)
    }
}

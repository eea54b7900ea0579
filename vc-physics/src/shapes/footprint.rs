//! Footprints: the areas that pieces cover of the floor, computed once for all upright things.

use std::f32::consts::FRAC_1_SQRT_2;
use std::sync::OnceLock;

use nalgebra::{Point2, Point3, Vector2, Vector3};
use vc_geometry::outline::{Outline, contains, hull, rectangle};

use super::piece::Piece;
use super::scale;

/// The area that a piece covers of the floor while its asset stands upright.
///
/// Its box is computed at once, its outline on demand: most pieces are too high or too low to obstruct anyone,
/// or covered by a box.
pub(crate) struct Footprint {
    piece: Piece,
    /// Its minimal and maximal corners in the asset's frame, metres.
    low: Point3<f32>,
    high: Point3<f32>,
    outline: OnceLock<Outline>,
    /// The index of another piece that covers all of it, as a table's top covers its legs.
    pub(crate) within: Option<usize>,
}

/// Tolerance by which an outline's box may exceed that of an outline that covers it, metres: rounding.
const SLACK: f32 = 1e-3;
/// Largest relative difference of volumes for which a box equals its bounding box.
const SAME: f32 = 1e-4;
/// Tolerance for the height of a unit vector that is upright or level.
const LEVEL: f32 = 1e-5;

impl Footprint {
    fn of(piece: &Piece) -> Self {
        let (low, high) = piece.extent();
        Self { piece: piece.clone(), low, high, outline: OnceLock::new(), within: None }
    }

    /// The range of its heights along Z, metres.
    pub(crate) fn levels(&self) -> (f32, f32) {
        (self.low.z, self.high.z)
    }

    /// The outline in the asset's frame, seen from above.
    pub(crate) fn outline(&self) -> &Outline {
        self.outline.get_or_init(|| {
            if self.is_its_box() {
                return rectangle(&self.low.xy(), &self.high.xy());
            }
            cylinder(&self.piece).unwrap_or_else(|| hull(scale::corners(&self.piece).iter().map(Point3::xy)))
        })
    }

    /// Whether it covers all of an outline, given with its minimal and maximal corners.
    pub(crate) fn covers(&self, outline: &[Point2<f32>], low: &Point2<f32>, high: &Point2<f32>) -> bool {
        self.is_around(low, high, SLACK) && contains(self.outline(), outline)
    }

    fn is_around(&self, low: &Point2<f32>, high: &Point2<f32>, slack: f32) -> bool {
        (0..2).all(|k| self.low[k] <= low[k] + slack && self.high[k] + slack >= high[k])
    }

    /// Whether it covers all of another footprint.
    fn hides(&self, other: &Self) -> bool {
        let (low, high) = (other.low.xy(), other.high.xy());
        self.is_around(&low, &high, SLACK)
            && (self.is_its_box() && self.is_around(&low, &high, 0.0) || contains(self.outline(), other.outline()))
    }

    /// Whether seen from above it is its own bounding rectangle.
    fn is_its_box(&self) -> bool {
        let volume = |size: Vector3<f32>| size.x * size.y * size.z;
        let own = self.piece.shape.as_cuboid().map(|c| 8.0 * c.half_extents.x * c.half_extents.y * c.half_extents.z);
        own.is_some_and(|own| volume(self.high - self.low) <= own * (1.0 + SAME))
    }
}

/// The outline of a cylinder, whose axis is the engine's Y: sixteen corners if it stands, four if it lies.
fn cylinder(piece: &Piece) -> Option<Outline> {
    const ARC: [(f32, f32); 4] =
        [(1.0, 0.0), (0.923_879_5, 0.382_683_43), (FRAC_1_SQRT_2, FRAC_1_SQRT_2), (0.382_683_43, 0.923_879_5)];
    let cylinder = piece.shape.as_cylinder()?;
    let axis = piece.at.rotation * Vector3::y();
    let (along, across) = (axis.xy() * cylinder.half_height, Vector2::new(-axis.y, axis.x) * cylinder.radius);
    let turned = |quarter: usize| ARC.map(|(x, y)| [(x, y), (-y, x), (-x, -y), (y, -x)][quarter]);
    let corners: Vec<Vector2<f32>> = if axis.z.abs() > 1.0 - LEVEL {
        (0..4).flat_map(turned).map(|(x, y)| Vector2::new(x, y) * cylinder.radius).collect()
    } else if axis.z.abs() < LEVEL {
        vec![along + across, -along + across, -along - across, along - across]
    } else {
        return None;
    };
    Some(corners.into_iter().map(|c| piece.at.translation.vector.xy() + c).map(Point2::from).collect())
}

/// The footprints of pieces. Costs the square of their number.
pub(super) fn footprints(pieces: &[Piece]) -> Vec<Footprint> {
    let mut all: Vec<Footprint> = pieces.iter().map(Footprint::of).collect();
    for i in 0..all.len() {
        // If two cover each other, the first one counts.
        let covers = |&j: &usize| j != i && all[j].hides(&all[i]) && (j < i || !all[i].hides(&all[j]));
        all[i].within = (0..all.len()).find(covers);
    }
    all
}

/// The smallest and largest height of points.
pub(crate) fn levels(points: &[Point3<f32>]) -> (f32, f32) {
    let start = (f32::INFINITY, f32::NEG_INFINITY);
    points.iter().fold(start, |(low, high), p| (low.min(p.z), high.max(p.z)))
}

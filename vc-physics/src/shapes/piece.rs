//! Decomposition of shapes into convex pieces.
//!
//! Boxes, cylinders, cones, capsules and balls keep their shape; rounded boxes become boxes. Hulls and meshes
//! become convex hulls. Lathed and extruded shapes are cut into slabs at the corners of their outline: a bowl
//! becomes a bottom and a ring of wedges; a vase too narrow to put anything in becomes solid.

use nalgebra::{Matrix3, Point3, Rotation3, UnitQuaternion, Vector2, Vector3};
use rapier3d::geometry::SharedShape;
use vc_geometry::profile::{Slab, simplified, slabs};
use vc_graph::Pose;
use vc_graph::asset::Shape;

use super::hull;
use crate::convert;

/// Half of the smallest thickness of a piece, metres: the engine does not keep thinner pieces apart.
const LEAST: f32 = 0.001;
/// Half of the thickness up to which a hull is replaced by its bounding box, metres. The engine uses one face
/// of a hull at a time, and a small thing would tip over its edge within a step.
const THIN: f32 = 0.0025;
/// The height over which the curved bottom of a hull is flattened, metres: on facets it would rock to and fro.
const PRESSED: f32 = 0.0015;
/// Number of wedges in a ring.
const WEDGES: usize = 10;
/// The radius below which a cavity is filled, metres: nothing is put into it.
const NARROW: f32 = 0.02;
/// Radius of the polygon between two discs, as a fraction of the discs' radius there.
const INNER: f32 = 0.97;
/// Height of the discs on which a cone stands, metres.
const FOOT: f32 = 0.006;
/// The largest deviation of a simplified outline from the true one, metres.
const TOLERANCE: f32 = 0.002;

/// A convex piece of a body: its shape, and the pose of the shape in the asset's frame.
#[derive(Clone)]
pub(crate) struct Piece {
    pub(crate) shape: SharedShape,
    pub(crate) at: Pose,
}

impl Piece {
    fn new(shape: SharedShape) -> Self {
        Self { shape, at: Pose::identity() }
    }

    /// The approximate hull of points, where `up` is the asset's Z in their frame; their bounding box if it is
    /// thin, `None` if the points are missing or not finite.
    pub(crate) fn hull(points: &[Point3<f32>], up: &Vector3<f32>) -> Option<Self> {
        let finite = points.iter().all(|p| p.iter().all(|c| c.is_finite() && c.abs() < 1e6));
        if points.is_empty() || !finite {
            return None;
        }
        let (low, high) = points.iter().fold((points[0], points[0]), |(l, h), p| (l.inf(p), h.sup(p)));
        let half = (high - low) / 2.0;
        if half.min() > THIN
            && let Some(shape) = hull::hull(points, up, half.min())
        {
            return Some(Self::new(shape));
        }
        let centre = nalgebra::center(&low, &high);
        Some(Self { shape: cuboid(half), at: Pose::translation(centre.x, centre.y, centre.z) })
    }

    /// As [`Self::hull`], for eight corners: four around a face, counter-clockwise seen from outside, and the
    /// opposite ones. They are known to be the corners of a hull, which need not be computed.
    fn hexahedron(face: [Point3<f32>; 4], across: [Point3<f32>; 4]) -> Option<Self> {
        let all = [face, across].concat();
        let (low, high) = all.iter().fold((all[0], all[0]), |(l, h), p| (l.inf(p), h.sup(p)));
        let thick = (high - low).min() > 2.0 * LEAST && all.iter().all(|p| p.iter().all(|c| c.abs() < 1e6));
        let shape = if thick { hull::hexahedron(face, across) } else { None };
        shape.map(Self::new).or_else(|| Self::hull(&all, &Vector3::z()))
    }

    /// The minimal and maximal corner in the asset's frame.
    pub(crate) fn extent(&self) -> (Point3<f32>, Point3<f32>) {
        let aabb = self.shape.compute_aabb(&convert::pose(&self.at));
        (convert::point3(aabb.mins), convert::point3(aabb.maxs))
    }
}

pub(super) fn cuboid(half: Vector3<f32>) -> SharedShape {
    let half = half.map(|h| h.max(LEAST));
    SharedShape::cuboid(half.x, half.y, half.z)
}

/// A shape along Y, turned so that its axis is Z.
fn upright(shape: SharedShape) -> Piece {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f32::consts::FRAC_PI_2);
    Piece { shape, at: Pose::from_parts(Vector3::zeros().into(), turn) }
}

/// The points with a flat bottom: points within [`PRESSED`] of the lowest one are levelled.
fn footed(points: &[Point3<f32>], up: &Vector3<f32>) -> Vec<Point3<f32>> {
    let height = |p: &Point3<f32>| p.coords.dot(up);
    let ground = points.iter().map(height).fold(f32::INFINITY, f32::min);
    let lowered = |p: &Point3<f32>| {
        let above = height(p) - ground;
        if above < PRESSED { p - up * above } else { *p }
    };
    points.iter().map(lowered).collect()
}

/// The convex pieces of a shape in its own frame, where `up` is the asset's Z; empty if its measures are
/// invalid.
pub(crate) fn pieces(shape: &Shape, up: &Vector3<f32>) -> Vec<Piece> {
    if !shape.measures_are_positive() {
        return Vec::new();
    }
    match shape {
        Shape::Box { half } | Shape::RoundedBox { half, .. } => vec![Piece::new(cuboid(*half))],
        Shape::Cylinder { radius, half_height } => vec![cylinder(*radius, *half_height)],
        Shape::Cone { radius, half_height } => {
            vec![upright(SharedShape::cone(half_height.max(LEAST), radius.max(LEAST)))]
        }
        Shape::Capsule { radius, half_height } => vec![Piece::new(SharedShape::capsule_z(*half_height, *radius))],
        Shape::Sphere { radius } => vec![Piece::new(SharedShape::ball(*radius))],
        Shape::Hull { points } | Shape::Mesh { vertices: points, .. } => {
            Piece::hull(&footed(points, up), up).into_iter().collect()
        }
        Shape::Lathe { profile } => turned(profile),
        Shape::Extrusion { outline, height } => drawn_up(outline, *height),
        // A shape kind of a later version is replaced by its bounding box.
        other => {
            let (low, high) = other.extent();
            Piece::hull(&[low, high], up).into_iter().collect()
        }
    }
}

fn cylinder(radius: f32, half_height: f32) -> Piece {
    upright(SharedShape::cylinder(half_height.max(LEAST), radius.max(LEAST)))
}

fn drawn_up(outline: &[(f32, f32)], height: f32) -> Vec<Piece> {
    let at = |slab: &Slab, z: f32| slab.corners().map(|(x, y)| Point3::new(x, y, z));
    let prism = |slab: &Slab| {
        let straight = slab.low == slab.high && height.abs() > 2.0 * LEAST;
        if straight { Some(block(slab, height)) } else { Piece::hexahedron(at(slab, height), at(slab, 0.0)) }
    };
    slabs(&simplified(outline, TOLERANCE)).iter().filter_map(prism).collect()
}

/// An extruded rectangular slab.
fn block(slab: &Slab, height: f32) -> Piece {
    let ((left, right), (bottom, top)) = (slab.low, (slab.bottom, slab.top));
    let half = Vector3::new(right - left, top - bottom, height) / 2.0;
    let centre = Pose::translation(f32::midpoint(left, right), f32::midpoint(bottom, top), height / 2.0);
    Piece { shape: cuboid(half.abs()), at: centre }
}

/// A profile of (radius, height) rotated around Z.
fn turned(profile: &[(f32, f32)]) -> Vec<Piece> {
    let mut outline = simplified(profile, TOLERANCE);
    // Closes the profile to the axis if it is open.
    if let (Some(&first), Some(&last)) = (outline.first(), outline.last())
        && first != last
    {
        outline.extend([(0.0, last.1), (0.0, first.1)]);
    }
    let mut slabs = slabs(&outline);
    let widest = slabs.iter().map(|s| s.low.0.max(s.high.0)).fold(0.0, f32::max);
    for slab in &mut slabs {
        if widest < NARROW || slab.low.0.max(slab.high.0) < NARROW {
            (slab.low.0, slab.high.0) = (0.0, 0.0);
        }
    }
    slabs.iter().flat_map(ring).collect()
}

/// The pieces of a slab of a profile rotated around Z: solid if the slab reaches the axis, otherwise a ring of
/// rotated wedges.
fn ring(slab: &Slab) -> Vec<Piece> {
    let (inner, outer) = ((slab.low.0, slab.high.0), (slab.low.1, slab.high.1));
    if inner.0 > 0.0 || inner.1 > 0.0 {
        let all = |first: Piece| (0..WEDGES).map(move |i| Piece { at: turn(i) * first.at, ..first.clone() });
        // The box around a wedge that is too thin for a hull would stand out of the ring once it is turned.
        let sound = |first: Piece| if first.shape.as_cuboid().is_some() { plank(slab) } else { first };
        return wedge(slab, 0, 1).map(sound).into_iter().flat_map(all).collect();
    }
    if (outer.0 - outer.1).abs() < TOLERANCE {
        return vec![disc(outer.0.max(outer.1), slab.bottom, slab.top)];
    }
    // It stands and lies on discs: the engine keeps discs still, but lets polygons with many corners rock.
    let height = slab.top - slab.bottom;
    let foot = (height / 3.0).min(FOOT);
    // The piece rolls on its discs: the polygon is within them.
    let radius = |z: f32| INNER * (outer.0 + (outer.1 - outer.0) * (z - slab.bottom) / height);
    let (low, high) = (slab.bottom + foot / 2.0, slab.top - foot / 2.0);
    let middle = Slab { bottom: low, top: high, low: (0.0, radius(low)), high: (0.0, radius(high)) };
    let ends = [disc(outer.0, slab.bottom, slab.bottom + foot), disc(outer.1, slab.top - foot, slab.top)];
    ends.into_iter().chain(wedge(&middle, 0, WEDGES - 1)).collect()
}

/// A box along the chord between the first two corners of a ring, in place of a wedge.
fn plank(slab: &Slab) -> Piece {
    let (inner, outer) = (slab.low.0.min(slab.high.0), slab.low.1.max(slab.high.1));
    let [first, next] = [0, 1].map(direction).map(|(x, y)| Vector2::new(x, y));
    let (middle, chord) = ((first + next) / 2.0, next - first);
    let size = Vector3::new((outer - inner) * middle.norm(), outer * chord.norm(), slab.top - slab.bottom);
    let centre = (middle * f32::midpoint(inner, outer)).push(f32::midpoint(slab.bottom, slab.top));
    let way = middle.normalize();
    Piece { shape: cuboid(size / 2.0), at: Pose::from_parts(centre.into(), towards((way.x, way.y))) }
}

/// The rotation from a ring's first corner to another.
fn turn(corner: usize) -> Pose {
    Pose::from_parts(Vector3::zeros().into(), towards(direction(corner)))
}

/// The rotation around Z that turns X to a unit vector.
fn towards((cos, sin): (f32, f32)) -> UnitQuaternion<f32> {
    let turn = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turn))
}

/// A disc between two heights.
fn disc(radius: f32, bottom: f32, top: f32) -> Piece {
    let mut piece = cylinder(radius, (top - bottom) / 2.0);
    piece.at = Pose::translation(0.0, 0.0, f32::midpoint(top, bottom)) * piece.at;
    piece
}

/// The part of a ring between two of its corners.
fn wedge(slab: &Slab, from: usize, to: usize) -> Option<Piece> {
    let section = |corner: usize| {
        let (x, y) = direction(corner);
        slab.corners().map(|(r, z)| Point3::new(r * x, r * y, z))
    };
    if to == from + 1 {
        return Piece::hexahedron(section(from), section(to));
    }
    let points: Vec<_> = (from..=to).flat_map(section).collect();
    Piece::hull(&points, &Vector3::z())
}

/// The unit vector to a corner of a regular polygon, identical on every machine.
fn direction(corner: usize) -> (f32, f32) {
    const STEP: (f64, f64) = (0.809_016_994_374_947_5, 0.587_785_252_292_473_1);
    let turn = |(x, y): (f64, f64)| (x * STEP.0 - y * STEP.1, x * STEP.1 + y * STEP.0);
    let (x, y) = (0..corner % WEDGES).fold((1.0, 0.0), |d, _| turn(d));
    (x as f32, y as f32)
}

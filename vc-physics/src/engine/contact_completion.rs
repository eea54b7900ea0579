//! Additional contact points for hulls, so that they stand on all corners of their bottom.
//!
//! For contacts, the engine takes the single face of a hull that points most towards the other body. A bottom
//! with more than four corners is bevelled (`shapes/hull`), so a hull that leans by a degree has its contact
//! points on a bevel, at one side. Within a step its other side sinks in and is lifted out, then the first side
//! sinks in: it rocks for ever. Therefore, where all points are on one side of the hull's middle, the corners
//! on the other side at about the same height become contact points too. They form a manifold of their own: in
//! the same manifold they would crowd out the points that touch, since the engine solves four points of each.

use rapier3d::geometry::{ContactData, ContactManifold, ContactManifoldData};
use rapier3d::math::{Pose, Vector};
use rapier3d::parry::query::TrackedContact;
use rapier3d::parry::shape::{ConvexPolyhedron, PackedFeatureId, PolygonalFeature, Shape};

type Point = TrackedContact<ContactData>;

/// Number of points per manifold that the engine solves.
const SOLVED: usize = 4;
/// Largest distance of two points that count as the same, metres.
const SAME: f32 = 0.0001;
/// Slope up to which a leaning hull may still come to stand within a step.
const LEANS: f32 = 0.15;
/// Smallest cosine of the angle between a face and the contact normal for which the face carries.
const FACES: f32 = 0.999;

/// Adds a second manifold for two convex shapes whose points are in the first one: the corners that the engine
/// leaves out. Once added, the second manifold stays, since the engine keeps count.
pub(crate) fn complete(manifolds: &mut Vec<ContactManifold>, pos12: &Pose, shapes: (&dyn Shape, &dyn Shape)) {
    let Some(first) = manifolds.first() else { return };
    let (n1, n2) = (first.local_n1, first.local_n2);
    let mut found = left_out(first, pos12, shapes);
    if let Some(second) = manifolds.get_mut(1) {
        for point in &mut found {
            let same = |p: &&Point| p.fid1 == point.fid1 && p.fid2 == point.fid2;
            point.data = second.points.iter().find(same).map_or_else(ContactData::default, |p| p.data);
        }
        (second.points, second.local_n1, second.local_n2) = (found, n1, n2);
    } else if !found.is_empty() {
        let second = ContactManifold::with_data(0, 0, ContactManifoldData::default());
        manifolds.push(ContactManifold { points: found, local_n1: n1, local_n2: n2, ..second });
    }
}

fn left_out(manifold: &ContactManifold, pos12: &Pose, (first, second): (&dyn Shape, &dyn Shape)) -> Vec<Point> {
    if let Some(hull) = second.as_convex_polyhedron() {
        return corners(hull, pos12, (first, manifold.local_n1), manifold, |p| p.local_p2);
    }
    let Some(hull) = first.as_convex_polyhedron() else { return Vec::new() };
    let found = corners(hull, &pos12.inverse(), (second, manifold.local_n2), manifold, |p| p.local_p1);
    found.into_iter().map(flipped).collect()
}

/// The corners of a hull that are above a face of the ground and at about the height of the hull's contact
/// points, if these points do not surround its middle. The first body of the returned points is the ground.
fn corners(
    hull: &ConvexPolyhedron,
    pose: &Pose,
    (ground, up): (&dyn Shape, Vector),
    manifold: &ContactManifold,
    own: impl Fn(&Point) -> Vector,
) -> Vec<Point> {
    let Some(lowest) = manifold.points.iter().min_by(|a, b| a.dist.total_cmp(&b.dist)) else { return Vec::new() };
    let (foot, deepest) = (own(lowest), lowest.dist);
    let feet: Vec<Vector> = manifold.points.iter().map(|p| *pose * own(p)).collect();
    let middle = *pose * (hull.points().iter().sum::<Vector>() / hull.points().len() as f32);
    if surrounds(&feet, middle, up) {
        return Vec::new();
    }
    let Some(face) = face(ground, up) else { return Vec::new() };
    let point = |(number, &corner): (u32, &Vector)| {
        let at = *pose * corner;
        let dist = (at - face.vertices[0]).dot(up);
        let leans = dist - deepest <= LEANS * corner.distance(foot);
        let known = || feet.iter().any(|f| f.distance(at) < SAME);
        let vertex = PackedFeatureId::vertex(number);
        let carries = leans && is_over(&face, at, up) && !known();
        carries.then(|| TrackedContact::new(at - up * dist, corner, face.fid, vertex, dist))
    };
    let found: Vec<Point> = (0..).zip(hull.points()).filter_map(point).collect();
    outermost(found, foot_of(&feet), up)
}

/// The mean of some points.
fn foot_of(points: &[Vector]) -> Vector {
    points.iter().sum::<Vector>() / points.len().max(1) as f32
}

/// Whether points surround another point, seen along a direction.
fn surrounds(points: &[Vector], middle: Vector, up: Vector) -> bool {
    let ways = || points.iter().map(|p| *p - middle);
    let sided = |way: Vector, sign: f32| ways().any(|other| sign * up.cross(way).dot(other) > 0.0);
    points.len() > 2 && ways().all(|way| sided(way, 1.0) && sided(way, -1.0))
}

/// The face of a shape that points in a direction, if there is one.
fn face(shape: &dyn Shape, up: Vector) -> Option<PolygonalFeature> {
    let (features, border) = shape.as_polygonal_feature_map()?;
    let mut face = PolygonalFeature::default();
    features.local_support_feature(up, &mut face);
    let [a, b, c, _] = face.vertices;
    let normal = (c - b).cross(a - b).normalize_or_zero();
    (border == 0.0 && face.num_vertices > 2 && normal.dot(up).abs() >= FACES).then_some(face)
}

/// Whether a point is above a face.
fn is_over(face: &PolygonalFeature, point: Vector, up: Vector) -> bool {
    let ring = &face.vertices[..face.num_vertices];
    let side = |(from, to): (&Vector, &Vector)| up.cross(*to - *from).dot(point - *from);
    let mut sides = ring.iter().zip(ring.iter().cycle().skip(1)).map(side);
    let mut others = sides.clone();
    sides.all(|s| s >= 0.0) || others.all(|s| s <= 0.0)
}

fn flipped(point: Point) -> Point {
    Point { local_p1: point.local_p2, local_p2: point.local_p1, fid1: point.fid2, fid2: point.fid1, ..point }
}

/// Selects four points: the one farthest from a position, the one farthest from that, and those farthest to
/// both sides.
fn outermost(points: Vec<Point>, from: Vector, up: Vector) -> Vec<Point> {
    if points.len() <= SOLVED {
        return points;
    }
    let most = |score: &dyn Fn(Vector) -> f32| {
        let better =
            |best: usize, i: usize| if score(points[i].local_p1) > score(points[best].local_p1) { i } else { best };
        (1..points.len()).fold(0, better)
    };
    let first = most(&|p| p.distance(from));
    let at = points[first].local_p1;
    let second = most(&|p| p.distance(at));
    let across = up.cross(points[second].local_p1 - at).normalize_or_zero();
    let kept = [first, second, most(&|p| (p - at).dot(across)), most(&|p| (at - p).dot(across))];
    let all = points.into_iter().enumerate();
    all.filter(|(i, _)| kept.contains(i)).map(|(_, point)| point).collect()
}

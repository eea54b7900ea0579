//! Reduction of the contact points of a body with several feet to the outermost ones.
//!
//! The engine finds contact points separately for every two parts of two bodies, and its solver pays for each:
//! a table on a rug has sixteen, a cupboard's carcass as many. Among points in one plane, four that surround
//! all others can carry the same loads. The engine's own clusters merge points whenever normals agree, and so
//! keep points that hover where others carry; this module leaves points as they are unless nothing is lost.

use super::contact_completion;
use rapier3d::geometry::{ContactData, ContactManifold, ContactManifoldData};
use rapier3d::math::{Pose, Vector};
use rapier3d::parry::query::details::NormalConstraints;
use rapier3d::parry::query::{
    ClosestPoints, Contact, ContactManifoldsWorkspace, DefaultQueryDispatcher, NonlinearRigidMotion,
    PersistentQueryDispatcher, QueryDispatcher, ShapeCastHit, ShapeCastOptions, ShapeDistance, ShapeIntersection,
    TrackedContact, Unsupported,
};
use rapier3d::parry::shape::Shape;

type Point = TrackedContact<ContactData>;

/// The mark of a merged manifold.
const MERGED: u32 = u32::from_le_bytes(*b"feet");
/// Smallest cosine of the angle between normals that agree.
const AGREE: f32 = 0.9998;
/// Largest distance from a plane for points that carry alike, metres.
const LEVEL: f32 = 0.001;
/// Largest distance of other points outside the four corners, as a fraction of the longer diagonal.
const OUTSIDE: f32 = 0.02;
/// Largest motion of a point that counts as the same as before, metres.
const SAME: f32 = 0.005;

/// The dispatcher for the engine's contact queries: the engine's own, with this reduction.
pub(crate) fn dispatcher() -> impl PersistentQueryDispatcher<ContactManifoldData, ContactData> {
    Reduction.chain(DefaultQueryDispatcher)
}

struct Reduction;

impl PersistentQueryDispatcher<ContactManifoldData, ContactData> for Reduction {
    fn contact_manifolds(
        &self,
        pos12: &Pose,
        g1: &dyn Shape,
        g2: &dyn Shape,
        prediction: f32,
        manifolds: &mut Vec<ContactManifold>,
        workspace: &mut Option<ContactManifoldsWorkspace>,
    ) -> Result<(), Unsupported> {
        if g1.as_compound().is_none() && g2.as_compound().is_none() {
            DefaultQueryDispatcher.contact_manifolds(pos12, g1, g2, prediction, manifolds, workspace)?;
            contact_completion::complete(manifolds, pos12, (g1, g2));
            return Ok(());
        }
        // The workspace records which manifold belongs to which parts. It has no entry for merged manifolds, so
        // all are computed anew. The workspace itself is left in place, since the engine uses it to detect that
        // a pair's manifolds may differ from before.
        let mut before = Vec::new();
        if manifolds.iter().any(|m| m.data.user_data == MERGED) {
            before = std::mem::take(manifolds);
            *workspace = None;
        }
        DefaultQueryDispatcher.contact_manifolds(pos12, g1, g2, prediction, manifolds, workspace)?;
        warm(manifolds, &before);
        merge(manifolds);
        Ok(())
    }

    fn contact_manifold_convex_convex(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Option<&dyn NormalConstraints>,
        _: Option<&dyn NormalConstraints>,
        _: f32,
        _: &mut ContactManifold,
    ) -> Result<(), Unsupported> {
        Err(Unsupported)
    }
}

/// Merges manifolds whose points lie in one plane and within four of them.
fn merge(manifolds: &mut Vec<ContactManifold>) {
    let mut left: Vec<ContactManifold> = Vec::new();
    let mut any = false;
    let filled = |m: &ContactManifold| !m.points.is_empty();
    for first in 0..manifolds.len() {
        if !filled(&manifolds[first]) {
            continue;
        }
        let normal = normals(&manifolds[first]).0;
        let agrees = |m: &ContactManifold| filled(m) && normals(m).0.dot(normal) >= AGREE;
        let members: Vec<usize> = (first..manifolds.len()).filter(|&i| agrees(&manifolds[i])).collect();
        let points: Vec<Point> = members.iter().flat_map(|&i| of_bodies(&manifolds[i])).collect();
        match (members.len() > 1).then(|| corners(&points, normal)).flatten() {
            Some(corners) => {
                let (local_n1, local_n2) = normals(&manifolds[first]);
                let (a, b) = (manifolds[first].subshape1, manifolds[first].subshape2);
                let mut whole = ContactManifold::with_data(a, b, ContactManifoldData::default());
                whole.data.user_data = MERGED;
                let points = corners.into_iter().map(|i| points[i]).collect();
                left.push(ContactManifold { points, local_n1, local_n2, ..whole });
                members.iter().for_each(|&i| manifolds[i].points.clear());
                any = true;
            }
            None => left.push(manifolds[first].clone()),
        }
    }
    if any {
        *manifolds = left;
    }
}

/// A manifold's normals in the frames of the two bodies' colliders.
fn normals(manifold: &ContactManifold) -> (Vector, Vector) {
    let turned = |pose: Option<&Pose>, normal: Vector| pose.map_or(normal, |p| p.rotation * normal);
    (turned(manifold.subshape_pos1(), manifold.local_n1), turned(manifold.subshape_pos2(), manifold.local_n2))
}

/// A manifold's points in the frames of the two bodies' colliders.
fn of_bodies(manifold: &ContactManifold) -> impl Iterator<Item = Point> + '_ {
    let moved = |pose: Option<&Pose>, point: Vector| pose.map_or(point, |p| *p * point);
    manifold.points.iter().map(move |point| Point {
        local_p1: moved(manifold.subshape_pos1(), point.local_p1),
        local_p2: moved(manifold.subshape_pos2(), point.local_p2),
        ..*point
    })
}

/// Three or four points that surround all others, if all are in a plane.
fn corners(points: &[Point], normal: Vector) -> Option<Vec<usize>> {
    let gap = |least: f32, point: &Point| least.min(point.dist);
    let deepest = points.iter().fold(f32::MAX, gap);
    if points.len() <= 4 || points.iter().any(|p| p.dist > deepest + LEVEL) {
        return None;
    }
    let at = |i: usize| points[i].local_p1;
    let farthest = |of: &dyn Fn(usize) -> f32| {
        (1..points.len()).fold((0, of(0)), |best, i| if of(i) > best.1 { (i, of(i)) } else { best }).0
    };
    let middle = points.iter().map(|p| p.local_p1).sum::<Vector>() / points.len() as f32;
    let a = farthest(&|i| at(i).distance_squared(middle));
    let c = farthest(&|i| at(i).distance_squared(at(a)));
    let across = normal.cross(at(c) - at(a));
    let b = farthest(&|i| (at(i) - at(a)).dot(across));
    let d = farthest(&|i| -(at(i) - at(a)).dot(across));
    let mut ring = vec![a, d, c, b];
    ring.dedup();
    let margin = OUTSIDE * at(a).distance(at(c));
    let inside = |i: usize| {
        ring.iter().zip(ring.iter().cycle().skip(1)).all(|(&from, &to)| {
            let edge = at(to) - at(from);
            normal.cross(edge).dot(at(i) - at(from)) >= -margin * edge.length()
        })
    };
    let apart = (at(b) - at(d)).dot(across) > margin * across.length();
    (apart && (0..points.len()).all(inside)).then_some(ring)
}

/// Copies the solver's impulses to points at the same positions, for warm starting.
fn warm(manifolds: &mut [ContactManifold], before: &[ContactManifold]) {
    let known: Vec<(Vector, Point)> = before
        .iter()
        .flat_map(|m| of_bodies(m).map(|p| (normals(m).0, p)))
        .filter(|(_, p)| p.data.impulse != 0.0)
        .collect();
    if known.is_empty() {
        return;
    }
    for manifold in manifolds {
        let normal = normals(manifold).0;
        let places: Vec<Vector> = of_bodies(manifold).map(|p| p.local_p1).collect();
        for (point, place) in manifold.points.iter_mut().zip(places) {
            let same = |(n, p): &&(Vector, Point)| n.dot(normal) >= AGREE && p.local_p1.distance(place) < SAME;
            if let Some((_, same)) = known.iter().find(same) {
                point.data = same.data;
            }
        }
    }
}

/// All queries except those for contacts are left to the engine.
impl QueryDispatcher for Reduction {
    fn intersection_test(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape) -> Result<ShapeIntersection, Unsupported> {
        Err(Unsupported)
    }

    fn distance(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape) -> Result<ShapeDistance, Unsupported> {
        Err(Unsupported)
    }

    fn contact(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape, _: f32) -> Result<Option<Contact>, Unsupported> {
        Err(Unsupported)
    }

    fn closest_points(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape, _: f32) -> Result<ClosestPoints, Unsupported> {
        Err(Unsupported)
    }

    fn cast_shapes(
        &self,
        _: &Pose,
        _: Vector,
        _: &dyn Shape,
        _: &dyn Shape,
        _: ShapeCastOptions,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        Err(Unsupported)
    }

    fn cast_shapes_nonlinear(
        &self,
        _: &NonlinearRigidMotion,
        _: &dyn Shape,
        _: &NonlinearRigidMotion,
        _: &dyn Shape,
        _: f32,
        _: f32,
        _: bool,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        Err(Unsupported)
    }
}

#[cfg(test)]
mod tests {
    use rapier3d::parry::shape::PackedFeatureId;

    use super::*;

    fn points(places: &[(f32, f32, f32)]) -> Vec<Point> {
        let at = |&(x, y, gap): &(f32, f32, f32)| {
            let on = Vector::new(x, y, 0.0);
            TrackedContact::new(on, on, PackedFeatureId::UNKNOWN, PackedFeatureId::UNKNOWN, gap)
        };
        places.iter().map(at).collect()
    }

    fn outer(places: &[(f32, f32, f32)]) -> Option<Vec<usize>> {
        let mut found = corners(&points(places), Vector::Z)?;
        found.sort_unstable();
        Some(found)
    }

    #[test]
    fn four_feet_stand_on_their_outer_corners() {
        let mut feet = Vec::new();
        for (x, y) in [(-1.0_f32, -0.5_f32), (1.0, -0.5), (1.0, 0.5), (-1.0, 0.5)] {
            // The outer corner first, then the one towards the middle.
            feet.extend([(x, y, 0.001), (x * 0.9, y * 0.9, 0.001)]);
        }
        assert_eq!(outer(&feet), Some(vec![0, 2, 4, 6]));
        // One foot hovers: the solver has to find out which three carry.
        feet[2].2 = 0.003;
        assert_eq!(outer(&feet), None);
    }

    #[test]
    fn round_feet_and_rows_are_left_alone() {
        let six = [(1.0, 0.0), (0.5, 0.9), (-0.5, 0.9), (-1.0, 0.0), (-0.5, -0.9), (0.5, -0.9)];
        assert_eq!(outer(&six.map(|(x, y)| (x, y, 0.0))), None);
        let row = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5];
        assert_eq!(outer(&row.map(|x| (x, 0.0, 0.0))), None);
        assert_eq!(outer(&[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]), None);
    }

    #[test]
    fn three_corners_are_enough_for_a_triangle() {
        let triangle = [(0.0, 0.0), (1.0, 0.0), (0.5, 0.9), (0.5, 0.3), (0.4, 0.2)];
        assert_eq!(outer(&triangle.map(|(x, y)| (x, y, 0.0))), Some(vec![0, 1, 2]));
    }
}

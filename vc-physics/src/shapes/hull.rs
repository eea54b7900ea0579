//! Convex hulls that stand still.
//!
//! The engine uses only four adjacent corners of a face with more: a pot would stand on one edge of its bottom,
//! and things on a round table would sink in. Therefore four corners of such a face that lie far apart are
//! kept, and the others are set back a little, as if the face were bevelled there.

use nalgebra::{Point3, Vector3};
use rapier3d::geometry::SharedShape;
use rapier3d::math::Vector;
use rapier3d::parry::transformation::try_convex_hull;
use vc_geometry::hull::{self, HullTolerance};

use crate::convert;

/// The setback of the corners that are not kept, per metre outside of the four. The engine merges faces that
/// differ by less than 0.026.
const BEVEL: f32 = 0.03;
/// The largest length of an edge that counts as zero, metres.
const SHORT: f32 = 1e-5;
/// The smallest cosine of the angle between triangles of one face.
const FLAT: f32 = 0.9996;

/// The largest deviation of a hull from the true one, metres.
const TRUE: f32 = 0.002;
/// The same as a fraction of half the shortest side: the deviation of a ring of wedges from a round thing.
const ROUGH: f32 = 0.05;
/// The deviation below which no further accuracy is needed, metres.
const FINE: f32 = 0.0005;
/// The number of corners from which on the larger deviation is allowed.
const CORNERS: usize = 24;
/// Rounding tolerance, as a fraction of the largest coordinate.
const ROUNDING: f32 = 1e-6;

/// The approximate hull of points; `None` if they have no volume. `up` is the upward direction in their frame,
/// `thick` half of their shortest side.
pub(super) fn hull(points: &[Point3<f32>], up: &Vector3<f32>, thick: f32) -> Option<SharedShape> {
    let mut all: Vec<Vector> = points.iter().map(|p| convert::point(*p)).collect();
    let first = footed(&mut all, convert::vector(*up));
    let rough = HullTolerance { first: &first, by: (ROUGH * thick).clamp(FINE, TRUE), corners: CORNERS };
    let points: Vec<Point3<f32>> = all.into_iter().map(convert::point3).collect();
    let (corners, triangles) = mesh(&points, Some(&rough))?;
    bevelled(corners, &triangles)
}

/// Bevels the faces of the points' bounding box, and the one they stand on; returns the kept corners of each.
fn footed(points: &mut [Vector], up: Vector) -> Vec<u32> {
    let start = (Vector::splat(f32::INFINITY), Vector::splat(f32::NEG_INFINITY));
    let (low, high) = points.iter().fold(start, |(low, high), p| (low.min(*p), high.max(*p)));
    let slack = ROUNDING * low.abs().max(high.abs()).max_element();
    let axes = [Vector::X, Vector::Y, Vector::Z, -Vector::X, -Vector::Y, -Vector::Z];
    let tilted = axes.iter().all(|a| a.dot(up) < FLAT);
    let mut first = Vec::new();
    for (number, way) in axes.into_iter().enumerate() {
        // A setback along one axis keeps the coordinates along the others.
        let axis = number % 3;
        let face = if number < 3 {
            of_face(points, |p| p[axis] >= high[axis] - slack)
        } else {
            of_face(points, |p| p[axis] <= low[axis] + slack)
        };
        bevel(points, face, way, &mut first);
    }
    if tilted {
        let lowest = points.iter().fold(f32::INFINITY, |least, p| least.min(p.dot(up)));
        let face = of_face(points, |p| p.dot(up) <= lowest + slack);
        bevel(points, face, -up, &mut first);
    }
    first.sort_unstable();
    first.dedup();
    first
}

fn of_face(points: &[Vector], is_in: impl Fn(&Vector) -> bool) -> Vec<u32> {
    (0..).zip(points).filter(|(_, p)| is_in(p)).map(|(i, _)| i).collect()
}

/// Sets back the corners of a face except four, and adds those four to the kept ones.
fn bevel(points: &mut [Vector], face: Vec<u32>, way: Vector, kept: &mut Vec<u32>) {
    let Some(four) = farthest_four(&face, way, |i| points[*i as usize]) else {
        kept.extend(face);
        return;
    };
    let corners = four.map(|k| points[k as usize]);
    for i in face.into_iter().filter(|i| !four.contains(i)) {
        let point = &mut points[i as usize];
        *point -= way * (BEVEL * outside(*point, corners, way));
    }
    kept.extend(four);
}

/// The hull of eight corners: four around a face, counter-clockwise seen from outside, and the four opposite
/// ones; `None` if two of them coincide.
pub(super) fn hexahedron(face: [Point3<f32>; 4], across: [Point3<f32>; 4]) -> Option<SharedShape> {
    let next = |k: usize| (k + 1) % 4;
    let long = |a: &Point3<f32>, b: &Point3<f32>| (a - b).norm() > SHORT;
    let sound =
        |k: usize| long(&face[k], &face[next(k)]) && long(&across[k], &across[next(k)]) && long(&face[k], &across[k]);
    if !(0..4).all(sound) {
        return None;
    }
    let corners = face.into_iter().chain(across).map(convert::point).collect();
    let mut triangles: Vec<[u32; 3]> = vec![[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]];
    for (k, n) in (0..4).map(|k| (k as u32, next(k) as u32)) {
        triangles.extend([[n, k, k + 4], [n, k + 4, n + 4]]);
    }
    bevelled(corners, &triangles)
}

fn bevelled(mut corners: Vec<Vector>, triangles: &[[u32; 3]]) -> Option<SharedShape> {
    let set_back = bevels(&corners, triangles);
    if set_back.is_empty() {
        return SharedShape::convex_mesh(corners, triangles);
    }
    set_back.into_iter().for_each(|(corner, by)| corners[corner] -= by);
    let corners: Vec<Point3<f32>> = corners.into_iter().map(convert::point3).collect();
    let (corners, triangles) = mesh(&corners, None)?;
    SharedShape::convex_mesh(corners, &triangles)
}

/// The triangles of the hull of points.
pub(super) fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    hull::triangles(points)
}

/// The corners and the triangles of the hull of points, from the engine's own algorithm if ours finds no
/// volume.
fn mesh(points: &[Point3<f32>], rough: Option<&HullTolerance<'_>>) -> Option<(Vec<Vector>, Vec<[u32; 3]>)> {
    let triangles = rough.map_or_else(|| hull::triangles(points), |rough| hull::approximate(points, rough));
    let Some(mut triangles) = triangles else {
        let all: Vec<Vector> = points.iter().map(|p| convert::point(*p)).collect();
        return try_convex_hull(&all).ok();
    };
    let mut used: Vec<u32> = triangles.as_flattened().to_vec();
    used.sort_unstable();
    used.dedup();
    let corners = used.iter().map(|&i| convert::point(points[i as usize])).collect();
    let mut number = vec![0; points.len()];
    (0..).zip(&used).for_each(|(new, &old)| number[old as usize] = new);
    triangles.as_flattened_mut().iter_mut().for_each(|i| *i = number[*i as usize]);
    Some((corners, triangles))
}

/// The corners to be set back, and their displacements.
fn bevels(corners: &[Vector], triangles: &[[u32; 3]]) -> Vec<(usize, Vector)> {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| corners[i as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let at = |i: &u32| corners[*i as usize];
    let mut left: Vec<(Vector, &[u32; 3])> = triangles.iter().map(|t| (normal(t), t)).collect();
    let (mut found, mut face) = (Vec::new(), Vec::new());
    while let Some((up, first)) = left.pop() {
        face.clear();
        face.extend_from_slice(first);
        let mut next = 0;
        while let Some((other, triangle)) = left.get(next) {
            if other.dot(up) > FLAT {
                face.extend_from_slice(*triangle);
                left.swap_remove(next);
            } else {
                next += 1;
            }
        }
        // Faces of one or two triangles need no setback.
        if face.len() <= 6 {
            continue;
        }
        face.sort_unstable();
        face.dedup();
        if let Some(kept) = farthest_four(&face, up, at) {
            let others = face.iter().filter(|i| !kept.contains(i));
            found.extend(others.map(|i| (*i as usize, up * (BEVEL * outside(at(i), kept.map(|k| at(&k)), up)))));
        }
    }
    found
}

/// Four corners of a face that lie far apart, in order around it; `None` if it has no more than four.
fn farthest_four(face: &[u32], up: Vector, at: impl Fn(&u32) -> Vector) -> Option<[u32; 4]> {
    if face.len() <= 4 {
        return None;
    }
    let middle = face.iter().map(&at).sum::<Vector>() / face.len() as f32;
    let farthest =
        |score: &dyn Fn(Vector) -> f32| face.iter().copied().max_by(|a, b| score(at(a)).total_cmp(&score(at(b))));
    let first = farthest(&|p| p.distance_squared(middle))?;
    let third = farthest(&|p| p.distance_squared(at(&first)))?;
    let aside = up.cross(at(&third) - at(&first));
    let (second, fourth) = (farthest(&|p| -p.dot(aside))?, farthest(&|p| p.dot(aside))?);
    Some([first, second, third, fourth])
}

/// The distance of a point of a face outside a quadrangle in it, whose corners go around `up`.
fn outside(point: Vector, corners: [Vector; 4], up: Vector) -> f32 {
    let beyond = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 4]);
        (to - from).cross(up).normalize_or_zero().dot(point - from)
    };
    (0..4).map(beyond).fold(0.0, f32::max)
}

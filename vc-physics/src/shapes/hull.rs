//! Convex hulls that stand still.
//!
//! Of a face with more than four corners the engine sees four, side by side: a pot would
//! stand on one edge of its bottom, and what stands on a round table would sink in. So of
//! such a face four corners are kept that lie far apart, and the others are set back a
//! little, as if the face were bevelled there.

use nalgebra::Point3;
use rapier3d::geometry::SharedShape;
use rapier3d::math::Vector;
use rapier3d::parry::transformation::try_convex_hull;

use super::quick;
use crate::convert;

/// How much the corners that are not kept are set back, for each metre they are outside of
/// the four. The engine takes faces for one that differ by less than 0.026.
const BEVEL: f32 = 0.03;
/// Up to which length an edge is none, metres.
const SHORT: f32 = 1e-5;
/// Cosine of the angle up to which triangles are one face.
const FLAT: f32 = 0.9996;

/// The hull of points, `None` where they have no volume.
pub(super) fn hull(points: &[Point3<f32>]) -> Option<SharedShape> {
    let (corners, triangles) = mesh(points)?;
    bevelled(corners, &triangles)
}

/// The hull of eight corners: four around a face, counter-clockwise seen from outside, and
/// those across from them; `None` where two of them are one.
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
    let (corners, triangles) = mesh(&corners)?;
    SharedShape::convex_mesh(corners, &triangles)
}

/// The triangles of the hull of points.
pub(super) fn triangles(points: &[Point3<f32>]) -> Option<Vec<[u32; 3]>> {
    quick::triangles(points)
}

/// The corners of the hull of points and its triangles; by the engine's own way where ours
/// finds no volume.
fn mesh(points: &[Point3<f32>]) -> Option<(Vec<Vector>, Vec<[u32; 3]>)> {
    let Some(mut triangles) = quick::triangles(points) else {
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

/// Corners to be set back, and by how much.
fn bevels(corners: &[Vector], triangles: &[[u32; 3]]) -> Vec<(usize, Vector)> {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| corners[i as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let mut left: Vec<(Vector, &[u32; 3])> = triangles.iter().map(|t| (normal(t), t)).collect();
    let mut found = Vec::new();
    while let Some((up, first)) = left.pop() {
        let mut face = first.to_vec();
        left.retain(|(other, t)| {
            let same = other.dot(up) > FLAT;
            if same {
                face.extend_from_slice(*t);
            }
            !same
        });
        face.sort_unstable();
        face.dedup();
        let at = |i: &u32| corners[*i as usize];
        if let Some(kept) = farthest_four(&face, up, at) {
            let others = face.iter().filter(|i| !kept.contains(i));
            found.extend(others.map(|i| (*i as usize, up * (BEVEL * outside(at(i), kept.map(|k| at(&k)), up)))));
        }
    }
    found
}

/// Four corners of a face that lie far apart, in order around it; `None` where it has no
/// more than four.
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

/// How far a point of a face is outside a quadrangle in it, whose corners go around `up`.
fn outside(point: Vector, corners: [Vector; 4], up: Vector) -> f32 {
    let beyond = |i: usize| {
        let (from, to) = (corners[i], corners[(i + 1) % 4]);
        (to - from).cross(up).normalize_or_zero().dot(point - from)
    };
    (0..4).map(beyond).fold(0.0, f32::max)
}

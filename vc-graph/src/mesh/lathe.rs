//! Solids of revolution around Z.

use nalgebra::{Point3, Vector2, Vector3};

use super::circle::{circle, corners};
use super::{CREASE, TriangleMesh};

type Radial = Vector2<f64>;

/// A segment of a profile: radius and height of both ends, and their outward normals.
struct Stretch {
    ends: [(f32, f32); 2],
    normals: [Radial; 2],
}

/// A capsule, or a sphere if it has no straight part.
pub(super) fn capsule(radius: f32, half_height: f32, tolerance: f32) -> TriangleMesh {
    let n = corners(radius, tolerance);
    let (table, quarter) = (circle(n), n / 4);
    let arc = |k: usize, lift: f32| {
        let (c, s) = table[(k + 3 * quarter) % n];
        (((radius as f64 * c) as f32, (radius as f64 * s) as f32 + lift), Radial::new(c, s))
    };
    let south = (0..=quarter).map(|k| arc(k, -half_height));
    let north = (quarter..=2 * quarter).map(|k| arc(k, half_height));
    let points: Vec<_> = south.chain(north).collect();
    let piece = |w: &[((f32, f32), Radial)]| Stretch { ends: [w[0].0, w[1].0], normals: [w[0].1, w[1].1] };
    revolved(&points.windows(2).map(piece).collect::<Vec<_>>(), n)
}

/// Any profile, closed to the axis, with creases at sharp bends.
pub(super) fn turned(profile: &[(f32, f32)], tolerance: f32) -> TriangleMesh {
    let widest = profile.iter().fold(0.0, |most: f32, p| most.max(p.0));
    revolved(&stretches(&closed(profile)), corners(widest, tolerance))
}

/// The profile with its closing discs, the solid on its left, without consecutive duplicates. A ring ends in
/// its starting point.
fn closed(profile: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let (Some(&first), Some(&last)) = (profile.first(), profile.last()) else { return Vec::new() };
    let disc = |end: (f32, f32)| (end.0 > 0.0 && first != last).then_some((0.0, end.1));
    let mut points: Vec<_> = disc(first).into_iter().chain(profile.iter().copied()).chain(disc(last)).collect();
    points.dedup();
    let cross = |a: (f32, f32), b: (f32, f32)| f64::from(a.0) * f64::from(b.1) - f64::from(b.0) * f64::from(a.1);
    let next = points.iter().cycle().skip(1);
    let area: f64 = points.iter().zip(next).map(|(&a, &b)| cross(a, b)).sum();
    if area == 0.0 {
        return Vec::new();
    }
    if area < 0.0 {
        points.reverse();
    }
    points
}

fn stretches(points: &[(f32, f32)]) -> Vec<Stretch> {
    let outward = |w: &[(f32, f32)]| {
        let [a, b] = [w[0], w[1]].map(|(r, z)| Radial::new(r.into(), z.into()));
        Radial::new(b.y - a.y, a.x - b.x).normalize()
    };
    let normals: Vec<Radial> = points.windows(2).map(outward).collect();
    let ring = points.first() == points.last();
    let count = normals.len();
    // The normal across a segment's end: that of its neighbour, or on the axis that of its own mirror image.
    let meets = |i: usize, other: Option<usize>, radius: f32| match other {
        _ if radius == 0.0 => Radial::new(-normals[i].x, normals[i].y),
        Some(k) => normals[k],
        None => normals[i],
    };
    let normal = |i: usize, other: Radial| {
        if normals[i].dot(&other) < CREASE { normals[i] } else { (normals[i] + other).normalize() }
    };
    (0..count)
        .map(|i| {
            let before = if i > 0 { Some(i - 1) } else { ring.then_some(count - 1) };
            let after = if i + 1 < count { Some(i + 1) } else { ring.then_some(0) };
            let ends = [points[i], points[i + 1]];
            let others = [meets(i, before, ends[0].0), meets(i, after, ends[1].0)];
            Stretch { ends, normals: others.map(|other| normal(i, other)) }
        })
        .collect()
}

/// Revolves the segments of a profile around Z in `n` steps.
fn revolved(stretches: &[Stretch], n: usize) -> TriangleMesh {
    let table = circle(n);
    let mut mesh = TriangleMesh::default();
    let mut last: Option<((f32, f32), Radial, Ring)> = None;
    for stretch in stretches.iter().filter(|s| s.ends.iter().any(|e| e.0 > 0.0)) {
        let [(a, na), (b, nb)] = [0, 1].map(|i| (stretch.ends[i], stretch.normals[i]));
        let lower = match &last {
            Some((end, normal, ring)) if *end == a && *normal == na => *ring,
            _ => ring(&mut mesh, &table, a, na),
        };
        let upper = ring(&mut mesh, &table, b, nb);
        for k in 0..n {
            if a.0 > 0.0 {
                mesh.triangles.push([lower.at(k), lower.at(k + 1), upper.at(k)]);
            }
            if b.0 > 0.0 {
                let foot = if a.0 > 0.0 { k + 1 } else { k };
                mesh.triangles.push([lower.at(foot), upper.at(k + 1), upper.at(k)]);
            }
        }
        last = Some((b, nb, upper));
    }
    mesh
}

/// The vertices around the axis at one point of a profile.
#[derive(Clone, Copy)]
struct Ring {
    first: u32,
    count: usize,
}

impl Ring {
    fn at(self, k: usize) -> u32 {
        self.first + (k % self.count) as u32
    }
}

fn ring(mesh: &mut TriangleMesh, table: &[(f64, f64)], (radius, height): (f32, f32), normal: Radial) -> Ring {
    let first = mesh.positions.len() as u32;
    let n = table.len();
    let count = if radius == 0.0 && normal.x.abs() < 1e-9 { 1 } else { n };
    for k in 0..count {
        let (c, s) = table[k];
        // The tip of a cone has a vertex for every slice, whose normal points along the middle of the slice.
        let (facing_x, facing_y) =
            if radius == 0.0 { (c + table[(k + 1) % n].0, s + table[(k + 1) % n].1) } else { (c, s) };
        let facing = Vector2::new(facing_x, facing_y).normalize() * normal.x;
        let position = Point3::new((radius as f64 * c) as f32, (radius as f64 * s) as f32, height);
        mesh.push(position, Vector3::new(facing.x, facing.y, normal.y));
    }
    Ring { first, count }
}

//! Skins over rings that may end in tips: zones of spheres, springs, seams, closed rings.

use std::f32::consts::TAU;

use nalgebra::Vector3;
use vc_graph::portable::Portable;

use super::build::{Build, P};
use crate::material::MaterialId;

/// A ring: its centre and its two half axes.
pub(crate) type Skin = (Vector3<f32>, Vector3<f32>, Vector3<f32>);

/// Whether consecutive rings follow `normal` (1) or run against it (-1).
pub(crate) fn heading(rings: &[Skin], normal: Vector3<f32>) -> f32 {
    match (rings.first(), rings.last()) {
        (Some(first), Some(last)) => (last.0 - first.0).dot(&normal).signum(),
        _ => 1.0,
    }
}

/// The closed surface over rings; `way` is negative if the rings run against their normals.
pub(crate) fn skinned(rings: &[Skin], n: u32, way: f32) -> (Vec<P>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles): (Vec<P>, Vec<[u32; 3]>) = (Vec::new(), Vec::new());
    let mut before: Option<(u32, u32)> = None;
    let last = rings.len().saturating_sub(1);
    for (i, &(centre, a, b)) in rings.iter().enumerate() {
        let tip = a.norm() < 1e-7 || b.norm() < 1e-7;
        let mut ring = (vertices.len() as u32, if tip { 1 } else { n });
        if tip {
            vertices.push(centre.into());
        } else {
            let turns = (0..n).map(|k| (TAU * k as f32 / n as f32).sine_cosine());
            vertices.extend(turns.map(|(s, c)| P::from(centre + a * c + b * s)));
        }
        let cap = |vertices: &mut Vec<P>| {
            vertices.push(centre.into());
            (vertices.len() as u32 - 1, 1)
        };
        if i == 0 && !tip {
            let pole = cap(&mut vertices);
            join(&mut triangles, pole, ring, n);
        }
        if let Some(below) = before {
            join(&mut triangles, below, ring, n);
        }
        if i == last && !tip {
            let pole = cap(&mut vertices);
            join(&mut triangles, ring, pole, n);
            ring = pole;
        }
        before = Some(ring);
    }
    if way < 0.0 {
        triangles.iter_mut().for_each(|t| t.swap(1, 2));
    }
    (vertices, triangles)
}

/// Triangles between two rings, each given by its first vertex and its vertex count.
fn join(triangles: &mut Vec<[u32; 3]>, below: (u32, u32), above: (u32, u32), n: u32) {
    let at = |ring: (u32, u32), k: u32| ring.0 + if ring.1 == 1 { 0 } else { k % n };
    for k in 0..n {
        let [a, b, c, d] = [at(below, k), at(below, k + 1), at(above, k + 1), at(above, k)];
        if a != b {
            triangles.push([a, b, c]);
        }
        if c != d {
            triangles.push([a, c, d]);
        }
    }
}

/// A zone of a sphere between two angles from an axis through its `centre`.
pub fn zone(
    b: &mut Build<'_>,
    name: &str,
    (centre, radius): (P, f32),
    towards: P,
    angles: (f32, f32),
    mat: MaterialId,
) {
    let way = Vector3::from(towards).try_normalize(1e-6).unwrap_or_else(Vector3::z);
    let across = way.cross(&Vector3::x()).try_normalize(0.1).unwrap_or_else(|| way.cross(&Vector3::y()).normalize());
    let other = way.cross(&across);
    let steps = ((angles.1 - angles.0) / 0.16).ceil().max(1.0) as usize;
    let n = match angles.1 {
        most if most < 0.5 => 12,
        most if most < 0.7 => 24,
        _ => 36,
    };
    let ring = |i: usize| {
        let (s, c) = (angles.0 + (angles.1 - angles.0) * i as f32 / steps as f32).sine_cosine();
        (Vector3::from(centre) + way * (radius * c), across * (radius * s), other * (radius * s))
    };
    let rings: Vec<Skin> = (0..=steps).map(ring).collect();
    let (vertices, triangles) = skinned(&rings, n, -1.0);
    b.mesh(name, vertices, triangles, mat);
}

/// A coil spring standing on `base`: radii of the coil and of its wire, height.
pub fn coil(b: &mut Build<'_>, name: &str, base: P, radii: (f32, f32), height: f32, mat: MaterialId) {
    let (turns, steps) = (5, 14);
    let count = turns * steps;
    let rise = (height - 2.0 * radii.1).max(height * 0.5);
    let ring = |i: usize| {
        let (s, c) = (TAU * (i % steps) as f32 / steps as f32).sine_cosine();
        let out = Vector3::new(c, s, 0.0);
        let up = Vector3::z() * ((height - rise) / 2.0 + rise * i as f32 / count as f32);
        (Vector3::from(base) + out * radii.0 + up, out * radii.1, Vector3::z() * radii.1)
    };
    let rings: Vec<Skin> = (0..=count).map(ring).collect();
    let (vertices, triangles) = skinned(&rings, 8, -1.0);
    b.mesh(name, vertices, triangles, mat);
}

/// A line along a closed curve of positions in metres, raised away from `centre`, such as a ball's
/// seam.
pub fn seam(b: &mut Build<'_>, name: &str, centre: P, curve: &[P], half: f32, mat: MaterialId) {
    let n = curve.len();
    let (middle, at) = (Vector3::from(centre), |i: usize| Vector3::from(curve[i % n]));
    let mut vertices = Vec::with_capacity(n * 4);
    for i in 0..n {
        let out = (at(i) - middle).try_normalize(1e-9).unwrap_or_else(Vector3::z);
        let way = at(i + 1) - at(i + n - 1);
        let side = out.cross(&way).try_normalize(1e-9).unwrap_or_else(Vector3::x) * half;
        let up = out * half;
        vertices.extend([up, side, -up, -side].map(|d| P::from(at(i) + d)));
    }
    let (n, mut triangles) = (n as u32, Vec::with_capacity(n * 8));
    for (i, k) in (0..n).flat_map(|i| (0..4).map(move |k| (i, k))) {
        let (next, turn) = ((i + 1) % n * 4, (k + 1) % 4);
        let [a, c, d, e] = [i * 4 + k, next + k, next + turn, i * 4 + turn];
        triangles.extend([[a, c, d], [a, d, e]]);
    }
    b.mesh(name, vertices, triangles, mat);
}

/// A ring of any shape in plan: the surface over rings whose last one joins the first.
pub(crate) fn ring_skin(b: &mut Build<'_>, name: &str, rings: &[Vec<P>], mat: MaterialId) {
    let n = rings.first().map_or(0, Vec::len);
    let rows = rings.len().saturating_sub(1);
    let vertices: Vec<_> = rings.iter().take(rows).flatten().copied().collect();
    let at = |row: usize, k: usize| (row % rows.max(1) * n + k % n.max(1)) as u32;
    let quads = (0..rows).flat_map(|row| (0..n).map(move |k| (row, k)));
    let sides = |(row, k): (usize, usize)| {
        let [a, b] = [at(row, k), at(row, k + 1)];
        let [c, d] = [at(row + 1, k + 1), at(row + 1, k)];
        [[a, b, c], [a, c, d]]
    };
    b.mesh(name, vertices, quads.flat_map(sides).collect(), mat);
}

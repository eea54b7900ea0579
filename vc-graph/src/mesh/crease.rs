//! Normals for triangles that have none.

use std::collections::HashMap;

use nalgebra::{Point3, Vector3};

use super::weld::Welded;
use super::{CREASE, TriangleMesh};

/// Triangle corners, three per triangle, in groups that share a vertex.
struct Groups(Vec<usize>);

impl Groups {
    fn root(&mut self, mut corner: usize) -> usize {
        while self.0[corner] != corner {
            self.0[corner] = self.0[self.0[corner]];
            corner = self.0[corner];
        }
        corner
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// Builds the mesh with vertices shared across smooth edges and split at sharp ones. Triangles with missing or
/// coinciding corners are left out.
pub(super) fn with_normals(vertices: &[Point3<f32>], triangles: &[[u32; 3]], uvs: &[[[f32; 2]; 3]]) -> TriangleMesh {
    let welded = Welded::new(vertices);
    let faces: Vec<[u32; 3]> = triangles.iter().filter_map(|&t| welded.triangle(t)).collect();
    let kept = triangles.iter().zip(uvs).filter(|(t, _)| welded.triangle(**t).is_some());
    let place = |v: u32| vertices[v as usize].cast::<f64>();
    let flat = |&[a, b, c]: &[u32; 3]| (place(b) - place(a)).cross(&(place(c) - place(a)));
    let normals: Vec<Vector3<f64>> = faces.iter().map(|f| flat(f).try_normalize(0.0).unwrap_or_default()).collect();
    let mut groups = smooth(&faces, &normals);
    let mut sums = vec![Vector3::zeros(); faces.len() * 3];
    for corner in 0..sums.len() {
        let (face, i) = (faces[corner / 3], corner % 3);
        let [own, next, last] = [i, i + 1, i + 2].map(|k| place(face[k % 3]));
        sums[groups.root(corner)] += normals[corner / 3] * angle(next - own, last - own);
    }
    let mut mesh = TriangleMesh { uvs: kept.map(|(_, uvs)| *uvs).collect(), ..TriangleMesh::default() };
    let mut made = vec![None; sums.len()];
    for (t, face) in faces.iter().enumerate() {
        let corners = [0, 1, 2].map(|i| {
            let root = groups.root(t * 3 + i);
            *made[root].get_or_insert_with(|| {
                let normal = if sums[root] == Vector3::zeros() { normals[t] } else { sums[root] };
                mesh.push(vertices[face[i] as usize], normal)
            })
        });
        mesh.triangles.push(corners);
    }
    mesh
}

/// Joins the corners on both sides of every edge that is not a crease.
fn smooth(faces: &[[u32; 3]], normals: &[Vector3<f64>]) -> Groups {
    let mut groups = Groups((0..faces.len() * 3).collect());
    let edge = |corner: usize| (faces[corner / 3][corner % 3], faces[corner / 3][(corner + 1) % 3]);
    let after = |corner: usize| corner / 3 * 3 + (corner + 1) % 3;
    let mut starts = HashMap::with_capacity(faces.len() * 3);
    for corner in 0..faces.len() * 3 {
        starts.entry(edge(corner)).or_insert(corner);
    }
    for corner in 0..faces.len() * 3 {
        let (from, to) = edge(corner);
        let Some(&other) = starts.get(&(to, from)) else { continue };
        if normals[corner / 3].dot(&normals[other / 3]) >= CREASE {
            groups.join(corner, after(other));
            groups.join(after(corner), other);
        }
    }
    groups
}

/// The weight of a triangle at a corner: its angle there, so that the triangulation of a face does not matter.
/// Abramowitz and Stegun 4.4.45, accurate to 7e-5 radians and the same on every machine.
fn angle(a: Vector3<f64>, b: Vector3<f64>) -> f64 {
    let lengths = a.norm() * b.norm();
    let cosine = if lengths > 0.0 { (a.dot(&b) / lengths).clamp(-1.0, 1.0) } else { 1.0 };
    let x = cosine.abs();
    let acute = (1.0 - x).sqrt() * (1.570_728_8 + x * (-0.212_114_4 + x * (0.074_261_0 - x * 0.018_729_3)));
    if cosine < 0.0 { std::f64::consts::PI - acute } else { acute }
}

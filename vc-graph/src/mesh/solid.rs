//! Boxes, and solids with flat triangles.

use nalgebra::{Point3, Vector3};

use super::TriangleMesh;
use super::circle::{circle, corners};

/// A box: six faces of four vertices.
pub(super) fn cuboid(half: Vector3<f32>) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = Vector3::ith(axis, sign);
            let across = Vector3::ith((axis + 1) % 3, 1.0);
            let along = normal.cross(&across);
            let corner = |(u, v): (f32, f32)| Point3::from((normal + across * u + along * v).component_mul(&half));
            let [a, b, c, d] =
                [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|uv| mesh.push(corner(uv), normal.cast()));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A box with rounded edges: a sphere whose eight octants are moved apart.
pub(super) fn rounded(half: Vector3<f32>, radius: f32, tolerance: f32) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let around = pulled_apart(corners(radius, tolerance));
    let (rows, columns) = (around.len() / 2, around.len());
    let core = half.map(|h| h - radius);
    // Rows go up from the south pole: the last quarter of the circle, then the first.
    for &(level, rise, _, up) in around[rows + rows / 2..].iter().chain(&around[..rows / 2]) {
        for &(c, s, x, y) in &around {
            let normal = Vector3::new(level * c, level * s, rise);
            let middle = core.component_mul(&Vector3::new(x, y, up));
            mesh.push(Point3::from(middle + normal.cast::<f32>() * radius), normal);
        }
    }
    let at = |row: usize, column: usize| (row * columns + column % columns) as u32;
    for (row, column) in (1..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let [a, b] = [at(row - 1, column), at(row - 1, column + 1)];
        let [c, d] = [at(row, column + 1), at(row, column)];
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
    for cap in [at(rows - 1, 0), 0] {
        let quarter = columns as u32 / 4;
        let [a, b, c, d] = [0, 1, 2, 3].map(|q| cap + q * quarter);
        let faces = if cap > 0 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
        mesh.triangles.extend(faces);
    }
    mesh
}

/// Cosine and sine around a circle, with each end of a quadrant twice, and with the signs of the quadrant.
fn pulled_apart(n: usize) -> Vec<(f64, f64, f32, f32)> {
    let (table, quarter) = (circle(n), n / 4);
    let signs = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let point = |q: usize, k: usize| {
        let (c, s) = table[(q * quarter + k) % n];
        (c, s, signs[q].0, signs[q].1)
    };
    (0..4).flat_map(|q| (0..=quarter).map(move |k| (q, k))).map(|(q, k)| point(q, k)).collect()
}

/// A solid with flat triangles: every corner is a separate vertex.
pub(super) fn faceted(points: &[Point3<f32>], triangles: &[[usize; 3]]) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| points[v].cast::<f64>());
        let normal = (b - a).cross(&(c - a));
        let corners = triangle.map(|v| mesh.push(points[v], normal));
        mesh.triangles.push(corners);
    }
    mesh
}

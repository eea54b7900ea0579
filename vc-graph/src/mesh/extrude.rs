//! Outlines extruded along Z.

use nalgebra::{Point3, Vector2, Vector3};

use super::{CREASE, TriangleMesh, polygon};

pub(super) fn drawn_up(outline: &[(f32, f32)], height: f32) -> TriangleMesh {
    let outline = counter_clockwise(outline);
    let mut mesh = TriangleMesh::default();
    let faces = polygon::triangles(&outline);
    for (z, up) in [(0.0, -1.0), (height, 1.0)] {
        let first = mesh.positions.len() as u32;
        for &(x, y) in &outline {
            mesh.push(Point3::new(x, y, z), Vector3::new(0.0, 0.0, up));
        }
        let corners = faces.iter().map(|f| f.map(|v| first + v as u32));
        mesh.triangles.extend(corners.map(|[a, b, c]| if up > 0.0 { [a, b, c] } else { [a, c, b] }));
    }
    walls(&mut mesh, &outline, height);
    mesh
}

/// The outline in counter-clockwise order without consecutive duplicates; empty if it has no area.
fn counter_clockwise(outline: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let mut points = outline.to_vec();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let next = points.iter().cycle().skip(1);
    let cross = |a: (f32, f32), b: (f32, f32)| f64::from(a.0) * f64::from(b.1) - f64::from(b.0) * f64::from(a.1);
    let area: f64 = points.iter().zip(next).map(|(&a, &b)| cross(a, b)).sum();
    if points.len() < 3 || area == 0.0 {
        return Vec::new();
    }
    if area < 0.0 {
        points.reverse();
    }
    points
}

fn walls(mesh: &mut TriangleMesh, outline: &[(f32, f32)], height: f32) {
    let n = outline.len();
    let point = |i: usize| Vector2::new(f64::from(outline[i % n].0), f64::from(outline[i % n].1));
    let outward = |i: usize| {
        let along = point(i + 1) - point(i);
        Vector2::new(along.y, -along.x).normalize()
    };
    let smooth = |own: Vector2<f64>, other: Vector2<f64>| if own.dot(&other) < CREASE { own } else { own + other };
    for i in 0..n {
        let normals = [smooth(outward(i), outward(i + n - 1)), smooth(outward(i), outward(i + 1))];
        let [a, d, b, c] = [(0, 0.0), (0, height), (1, 0.0), (1, height)].map(|(end, z)| {
            let (x, y) = outline[(i + end) % n];
            mesh.push(Point3::new(x, y, z), normals[end].push(0.0))
        });
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
}

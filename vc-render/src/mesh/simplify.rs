//! Mesh simplification by edge collapse while the surface stays nearly in place.
//!
//! Vertices are moved onto neighbours, cheapest first. The cost is the sum of squared distances to the planes
//! of all triangles that have been there (Garland and Heckbert 1997), which is never less than the square of
//! the greatest distance.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use nalgebra::{Point3, Vector3};
use vc_graph::TriangleMesh;
use vc_graph::asset::Shape;

/// Least cosine of the angle by which a collapse may turn a triangle.
const TURN: f64 = 0.5;

/// A quadric: a sum of squared distances to planes, stored as the upper half of a symmetric matrix.
#[derive(Debug, Clone, Copy, Default)]
struct Quadric([f64; 10]);

/// A candidate collapse: its cost as ordered bits, the vertex that moves and its target, and the total of
/// changes both had seen.
type Entry = Reverse<(u64, u32, u32, u32)>;

/// A mesh being simplified.
#[derive(Debug, Default)]
pub(super) struct Simplifier {
    points: Vec<Point3<f32>>,
    triangles: Vec<Option<[u32; 3]>>,
    /// Triangles around each vertex.
    around: Vec<Vec<u32>>,
    quadrics: Vec<Quadric>,
    /// Vertices that must not move.
    fixed: Vec<bool>,
    changes: Vec<u32>,
    heap: BinaryHeap<Entry>,
}

impl Quadric {
    fn of_plane(normal: &Vector3<f64>, at: &Point3<f32>) -> Self {
        let [a, b, c] = (*normal).into();
        let d = -normal.dot(&at.cast().coords);
        Self([a * a, a * b, a * c, a * d, b * b, b * c, b * d, c * c, c * d, d * d])
    }

    fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(own, more)| *own += more);
    }

    fn at(&self, p: &Point3<f32>) -> f64 {
        let [aa, ab, ac, ad, bb, bc, bd, cc, cd, dd] = self.0;
        let [x, y, z] = p.cast::<f64>().into();
        let mixed = ab * x * y + ac * x * z + bc * y * z + ad * x + bd * y + cd * z;
        (aa * x * x + bb * y * y + cc * z * z + 2.0 * mixed + dd).max(0.0)
    }
}

impl Simplifier {
    pub(super) fn new(mesh: &TriangleMesh) -> Self {
        let mut made = Self::default();
        let mut known = HashMap::new();
        let mut welded = Vec::with_capacity(mesh.positions.len());
        for p in &mesh.positions {
            let next = made.points.len() as u32;
            let number = *known.entry([p.x, p.y, p.z].map(|v| (v + 0.0).to_bits())).or_insert(next);
            if number == next {
                made.points.push(*p);
            }
            welded.push(number);
        }
        let triangles = mesh.triangles.iter().map(|t| t.map(|v| welded[v as usize]));
        made.triangles = triangles.filter(|[a, b, c]| a != b && b != c && c != a).map(Some).collect();
        let count = made.points.len();
        made.around = vec![Vec::new(); count];
        made.quadrics = vec![Quadric::default(); count];
        (made.fixed, made.changes) = (vec![false; count], vec![0; count]);
        made.planes();
        made.borders();
        (0..count as u32).for_each(|v| made.offer(v));
        made
    }

    fn planes(&mut self) {
        for (index, corners) in (0..).zip(self.triangles.iter().flatten()) {
            let normal = self.normal(*corners).try_normalize(0.0).unwrap_or_default();
            let plane = Quadric::of_plane(&normal, &self.points[corners[0] as usize]);
            for corner in corners {
                self.around[*corner as usize].push(index);
                self.quadrics[*corner as usize].add(&plane);
            }
        }
    }

    /// Adds planes across border edges, which keep these in place, and fixes the vertices of edges with more
    /// than two triangles.
    fn borders(&mut self) {
        let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * self.triangles.len());
        for (index, [a, b, c]) in (0..).zip(self.triangles.iter().flatten().copied()) {
            edges.extend([[a, b], [b, c], [c, a]].map(|[p, q]| ([p.min(q), p.max(q)], index)));
        }
        edges.sort_unstable();
        for same in edges.chunk_by(|a, b| a.0 == b.0) {
            let ([p, q], index) = same[0];
            if same.len() > 2 {
                (self.fixed[p as usize], self.fixed[q as usize]) = (true, true);
            }
            if let (1, Some(corners)) = (same.len(), self.triangles[index as usize]) {
                let along = (self.points[q as usize] - self.points[p as usize]).cast::<f64>();
                let across = along.cross(&self.normal(corners)).try_normalize(0.0).unwrap_or_default();
                let plane = Quadric::of_plane(&across, &self.points[p as usize]);
                self.quadrics[p as usize].add(&plane);
                self.quadrics[q as usize].add(&plane);
            }
        }
    }

    /// Normal of a triangle, with twice its area as length.
    fn normal(&self, corners: [u32; 3]) -> Vector3<f64> {
        let [a, b, c] = corners.map(|v| self.points[v as usize].cast::<f64>());
        (b - a).cross(&(c - a))
    }

    fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let mut all: Vec<u32> = self.around[vertex as usize]
            .iter()
            .filter_map(|t| self.triangles[*t as usize])
            .flatten()
            .filter(|v| *v != vertex)
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Pushes the costs of collapsing a vertex's edges, in both directions.
    fn offer(&mut self, vertex: u32) {
        for other in self.neighbours(vertex) {
            let mut both = self.quadrics[vertex as usize];
            both.add(&self.quadrics[other as usize]);
            let stamp = self.changes[vertex as usize].wrapping_add(self.changes[other as usize]);
            for (from, to) in [(vertex, other), (other, vertex)] {
                if !self.fixed[from as usize] {
                    let cost = both.at(&self.points[to as usize]).to_bits();
                    self.heap.push(Reverse((cost, from, to, stamp)));
                }
            }
        }
    }

    /// Collapses edges while the surface moves by at most this tolerance, metres.
    pub(super) fn collapse(&mut self, tolerance: f32) {
        let most = f64::from(tolerance) * f64::from(tolerance);
        while let Some(Reverse((cost, from, to, stamp))) = self.heap.peek().copied() {
            if f64::from_bits(cost) > most {
                return;
            }
            self.heap.pop();
            let current = self.changes[from as usize].wrapping_add(self.changes[to as usize]);
            if stamp == current && !self.around[from as usize].is_empty() && self.allowed(from, to) {
                self.merge(from, to);
            }
        }
    }

    /// Whether a collapse keeps the surface a manifold and flips no triangle.
    fn allowed(&self, from: u32, to: u32) -> bool {
        let others = self.neighbours(to);
        let shared = self.neighbours(from).iter().filter(|v| others.binary_search(v).is_ok()).count();
        let around = || self.around[from as usize].iter().filter_map(|t| self.triangles[*t as usize]);
        let edge = around().filter(|t| t.contains(&to)).count();
        shared == edge
            && edge > 0
            && around().filter(|t| !t.contains(&to)).all(|t| {
                let (before, after) = (self.normal(t), self.normal(t.map(|v| if v == from { to } else { v })));
                before.dot(&after) > TURN * before.norm() * after.norm()
            })
    }

    fn merge(&mut self, from: u32, to: u32) {
        for index in std::mem::take(&mut self.around[from as usize]) {
            let Some(corners) = self.triangles[index as usize] else { continue };
            if corners.contains(&to) {
                self.triangles[index as usize] = None;
            } else {
                self.triangles[index as usize] = Some(corners.map(|v| if v == from { to } else { v }));
                self.around[to as usize].push(index);
            }
        }
        let quadric = self.quadrics[from as usize];
        self.quadrics[to as usize].add(&quadric);
        let triangles = &self.triangles;
        self.around[to as usize].retain(|t| triangles[*t as usize].is_some());
        self.changes[to as usize] += 1;
        self.offer(to);
    }

    /// The remaining mesh, with new normals.
    pub(super) fn mesh(&self) -> TriangleMesh {
        let triangles = self.triangles.iter().flatten().copied().collect();
        Shape::Mesh { vertices: self.points.clone(), triangles, uvs: Vec::new() }.mesh(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn simplified(shape: &Shape, tolerance: f32) -> [TriangleMesh; 2] {
        let mesh = shape.mesh(0.0002);
        let mut simplifier = Simplifier::new(&mesh);
        simplifier.collapse(tolerance);
        [mesh, simplifier.mesh()]
    }

    #[test]
    fn flat_sides_need_few_triangles() {
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for i in 0..11_u32 {
            vertices.extend((0..11).map(|j| Point3::new(0.1 * i as f32, 0.1 * j as f32, 0.0)));
        }
        for at in (0..110).filter(|at| at % 11 != 10) {
            triangles.extend([[at, at + 11, at + 12], [at, at + 12, at + 1]]);
        }
        let [_, few] = simplified(&Shape::Mesh { vertices, triangles, uvs: Vec::new() }, 1e-4);
        assert_eq!(few.triangles.len(), 2);
        let size = few.bounds().map(|b| b.max - b.min);
        assert!(size.is_some_and(|s| (s - Vector3::new(1.0, 1.0, 0.0)).norm() < 1e-6));
    }

    #[test]
    fn balls_stay_closed_and_within_the_tolerance() {
        let (whole, mut last) = (Shape::Sphere { radius: 0.5 }.mesh(0.0002).triangles.len(), usize::MAX);
        for tolerance in [1e-5, 0.001, 0.01] {
            let [all, few] = simplified(&Shape::Sphere { radius: 0.5 }, tolerance);
            assert!(few.is_closed() && few.triangles.len() <= last.min(all.triangles.len()));
            last = few.triangles.len();
            for triangle in &few.triangles {
                let [a, b, c] = triangle.map(|v| few.positions[v as usize].coords);
                let middle = ((a + b + c) / 3.0).norm();
                assert!(0.5 - middle < 3.0 * tolerance + 0.0015, "{middle}");
            }
        }
        assert!(last < whole, "{last} triangles are left");
    }
}

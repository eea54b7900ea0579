//! Merging vertices at the same position.

use std::collections::HashMap;

use nalgebra::Point3;

/// For every vertex the index of the first vertex at its position.
pub(super) struct Welded(Vec<u32>);

impl Welded {
    pub(super) fn new(positions: &[Point3<f32>]) -> Self {
        let mut first = HashMap::with_capacity(positions.len());
        // Adding zero makes a negative zero positive.
        let key = |p: &Point3<f32>| [p.x, p.y, p.z].map(|v| (v + 0.0).to_bits());
        Self(positions.iter().zip(0..).map(|(p, at)| *first.entry(key(p)).or_insert(at)).collect())
    }

    /// The merged vertices of a triangle; `None` if one does not exist or two coincide.
    pub(super) fn triangle(&self, triangle: [u32; 3]) -> Option<[u32; 3]> {
        let at = |v: u32| self.0.get(v as usize).copied();
        let [a, b, c] = [at(triangle[0])?, at(triangle[1])?, at(triangle[2])?];
        (a != b && b != c && c != a).then_some([a, b, c])
    }

    /// The number of occurrences of each directed edge.
    pub(super) fn edges(&self, triangles: &[[u32; 3]]) -> HashMap<(u32, u32), u32> {
        let mut edges = HashMap::with_capacity(triangles.len() * 3);
        for [a, b, c] in triangles.iter().filter_map(|&t| self.triangle(t)) {
            [(a, b), (b, c), (c, a)].into_iter().for_each(|edge| *edges.entry(edge).or_insert(0) += 1);
        }
        edges
    }
}

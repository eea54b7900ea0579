//! A bounding volume hierarchy with eight children to a node and up to eight triangles in a leaf.
//!
//! The boxes of a node are tested together, as are the triangles of a leaf (Wald, Benthin and Boulos 2008).
//! Triangles are intersected as in Möller and Trumbore 1997.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use pulp::Simd;

use super::walk::{Beam, walk};
use crate::math::simd::at_most;

/// Number of children of a node, and of triangles in a leaf.
pub(super) const WIDE: usize = 8;

/// Marks a child that is a leaf.
pub(super) const LEAF: u32 = 1 << 31;

/// Marks an absent child.
pub(super) const EMPTY: u32 = u32::MAX;

pub(super) type Lanes = [f32; WIDE];

/// The boxes of eight children: least x, y, z, then greatest.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Node {
    pub(super) bounds: [Lanes; 6],
    pub(super) children: [u32; WIDE],
}

/// Eight triangles: a corner and two edges, and their numbers.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct Leaf {
    pub(super) corner: [Lanes; 3],
    pub(super) edges: [[Lanes; 3]; 2],
    pub(super) numbers: [u32; WIDE],
}

/// A tree of triangles for ray casting.
#[derive(Debug, Default, Clone)]
pub(crate) struct Bvh {
    pub(super) nodes: Vec<Node>,
    pub(super) leaves: Vec<Leaf>,
}

/// A ray of limited length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) from: [f32; 3],
    pub(crate) along: [f32; 3],
    /// Its end, in lengths of `along`.
    pub(crate) end: f32,
}

/// The intersection of a ray with a triangle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hit {
    /// Distance in lengths of the ray's direction.
    pub(crate) t: f32,
    pub(crate) number: u32,
    /// Barycentric weights of the second and the third corner.
    pub(crate) weights: [f32; 2],
    /// Edges from the first corner to the others.
    pub(crate) edges: [[f32; 3]; 2],
}

/// Compact record of a hit within a tree, as nearer and nearer hits are kept during traversal.
#[derive(Debug, Clone, Copy)]
struct Touch {
    leaf: u32,
    lane: u32,
    weights: [f32; 2],
}

impl Bvh {
    /// The first triangle that a ray hits before an end, from either side; with `ANY`, the first one found.
    #[inline(always)]
    pub(crate) fn meet<S: Simd, const ANY: bool>(
        &self,
        simd: S,
        (ray, end): (&Ray, f32),
        beam: &Beam<S>,
    ) -> Option<Hit> {
        let (t, Touch { leaf, lane, weights }) = walk::<S, Touch, ANY>(
            simd,
            &self.nodes,
            (beam, end),
            #[inline(always)]
            |leaf, end| {
                let (t, lane, weights) = self.leaves[leaf as usize].meet(simd, ray, end)?;
                Some((t, Touch { leaf, lane, weights }))
            },
        )?;
        let (leaf, lane) = (&self.leaves[leaf as usize], lane as usize);
        let edges = leaf.edges.map(|edge| edge.map(|axis| axis[lane]));
        Some(Hit { t, number: leaf.numbers[lane], weights, edges })
    }

    /// Removes triangles; the boxes around them stay.
    pub(crate) fn remove(&mut self, gone: impl Fn(u32) -> bool) {
        for leaf in &mut self.leaves {
            for lane in 0..WIDE {
                if leaf.numbers[lane] != EMPTY && gone(leaf.numbers[lane]) {
                    leaf.numbers[lane] = EMPTY;
                    leaf.corner.iter_mut().for_each(|axis| axis[lane] = f32::NAN);
                }
            }
        }
    }
}
/// The `number`-th vector of eight numbers.
#[inline(always)]
pub(super) fn part<S: Simd>(lanes: &Lanes, number: usize) -> S::f32s {
    S::as_simd_f32s(lanes).0[number]
}

/// Three vectors: coordinates of several points.
type Three<S> = [<S as Simd>::f32s; 3];

#[inline(always)]
fn parts<S: Simd>(lanes: &[Lanes; 3], number: usize) -> Three<S> {
    [part::<S>(&lanes[0], number), part::<S>(&lanes[1], number), part::<S>(&lanes[2], number)]
}

#[inline(always)]
fn cross<S: Simd>(simd: S, a: Three<S>, b: Three<S>) -> Three<S> {
    [
        simd.sub_f32s(simd.mul_f32s(a[1], b[2]), simd.mul_f32s(a[2], b[1])),
        simd.sub_f32s(simd.mul_f32s(a[2], b[0]), simd.mul_f32s(a[0], b[2])),
        simd.sub_f32s(simd.mul_f32s(a[0], b[1]), simd.mul_f32s(a[1], b[0])),
    ]
}

#[inline(always)]
fn dot<S: Simd>(simd: S, a: Three<S>, b: Three<S>) -> S::f32s {
    let two = simd.add_f32s(simd.mul_f32s(a[0], b[0]), simd.mul_f32s(a[1], b[1]));
    simd.add_f32s(two, simd.mul_f32s(a[2], b[2]))
}

impl Leaf {
    /// The first hit of a ray in the leaf: its distance, the triangle's lane and the weights of its corners.
    #[inline(always)]
    fn meet<S: Simd>(&self, simd: S, ray: &Ray, end: f32) -> Option<(f32, u32, [f32; 2])> {
        let (mut t, mut u, mut v) = ([0.0; WIDE], [0.0; WIDE], [0.0; WIDE]);
        let along = [simd.splat_f32s(ray.along[0]), simd.splat_f32s(ray.along[1]), simd.splat_f32s(ray.along[2])];
        let (zero, one, end) = (simd.splat_f32s(0.0), simd.splat_f32s(1.0), simd.splat_f32s(end));
        for i in 0..WIDE / S::F32_LANES {
            let (ab, ac) = (parts::<S>(&self.edges[0], i), parts::<S>(&self.edges[1], i));
            let mut s = parts::<S>(&self.corner, i);
            for axis in 0..3 {
                s[axis] = simd.sub_f32s(simd.splat_f32s(ray.from[axis]), s[axis]);
            }
            let p = cross(simd, along, ac);
            let over = simd.div_f32s(one, dot(simd, ab, p));
            let a = simd.mul_f32s(dot(simd, s, p), over);
            let q = cross(simd, s, ab);
            let b = simd.mul_f32s(dot(simd, along, q), over);
            let at = simd.mul_f32s(dot(simd, ac, q), over);
            // Comparisons with NaN are false.
            let inside = simd.and_m32s(
                simd.and_m32s(simd.greater_than_or_equal_f32s(a, zero), simd.greater_than_or_equal_f32s(b, zero)),
                simd.less_than_or_equal_f32s(simd.add_f32s(a, b), one),
            );
            let between = simd.and_m32s(simd.greater_than_f32s(at, zero), simd.less_than_f32s(at, end));
            let met = simd.and_m32s(inside, between);
            S::as_mut_simd_f32s(&mut t).0[i] = simd.select_f32s(met, at, simd.splat_f32s(f32::INFINITY));
            S::as_mut_simd_f32s(&mut u).0[i] = a;
            S::as_mut_simd_f32s(&mut v).0[i] = b;
        }
        let mut met = at_most(simd, &t, &[f32::MAX; WIDE]);
        let mut best = met.trailing_zeros() as usize;
        while met != 0 {
            let lane = met.trailing_zeros() as usize;
            met &= met - 1;
            best = if t[lane] < t[best] { lane } else { best };
        }
        // None if no bit was set.
        let t = *t.get(best)?;
        Some((t, best as u32, [u[best], v[best]]))
    }
}

//! A tree of boxes, eight to a node, with up to eight triangles in a leaf.
//!
//! Boxes and triangles of a node are tested at once (Wald, Benthin and Boulos 2008).
//! Triangles by Möller and Trumbore 1997.

/// Children of a node, triangles of a leaf.
pub(super) const WIDE: usize = 8;

/// Marks a child that is a leaf.
pub(super) const LEAF: u32 = 1 << 31;

/// A child that is not there.
pub(super) const EMPTY: u32 = u32::MAX;

type Lanes = [f32; WIDE];

/// The boxes of eight children: least x, y, z, then greatest.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct Node {
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

/// Triangles, found along rays.
#[derive(Debug, Default, Clone)]
pub(crate) struct Bvh {
    pub(super) nodes: Vec<Node>,
    pub(super) leaves: Vec<Leaf>,
}

/// A half line, or a piece of one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) from: [f32; 3],
    pub(crate) along: [f32; 3],
    /// Where it ends, in lengths of `along`.
    pub(crate) end: f32,
}

/// What a ray meets.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hit {
    /// In lengths of the ray's direction.
    pub(crate) t: f32,
    pub(crate) number: u32,
    /// Weights of the second and the third corner.
    pub(crate) weights: [f32; 2],
    /// From the first corner to the others.
    pub(crate) edges: [[f32; 3]; 2],
}

/// Most nodes that wait to be visited; [`Bvh::build`](super::build) makes no deeper trees.
const STACK: usize = 128;

impl Bvh {
    /// The first triangle along a ray, from either side.
    #[inline]
    pub(crate) fn first(&self, ray: &Ray) -> Option<Hit> {
        crate::simd::widest(
            #[inline(always)]
            || self.walk::<false>(ray),
        )
    }

    /// Whether there is any triangle along a ray.
    #[inline]
    pub(crate) fn any(&self, ray: &Ray) -> bool {
        crate::simd::widest(
            #[inline(always)]
            || self.walk::<true>(ray),
        )
        .is_some()
    }

    #[inline(always)]
    fn walk<const ANY: bool>(&self, ray: &Ray) -> Option<Hit> {
        if self.nodes.is_empty() {
            return None;
        }
        let over = ray.along.map(|d| 1.0 / if d.abs() < 1e-20 { 1e-20_f32.copysign(d) } else { d });
        let mut best: Option<Hit> = None;
        let mut end = ray.end;
        let mut stack = [(0_u32, 0.0_f32); STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let (child, enters) = stack[height & (STACK - 1)];
            if enters > end {
                continue;
            }
            if child & LEAF != 0 {
                let found = self.leaves[(child & !LEAF) as usize].meet(ray, end);
                if let Some(hit) = found {
                    (end, best) = (hit.t, found);
                    if ANY {
                        return best;
                    }
                }
                continue;
            }
            let node = &self.nodes[child as usize];
            let enters = node.enters(ray.from, over, end);
            let mut met = bits(enters.map(|enter| enter <= end));
            let first = height;
            while met != 0 {
                let lane = met.trailing_zeros() as usize;
                met &= met - 1;
                let enter = enters[lane];
                let mut at = height & (STACK - 1);
                // Nearest on top; any is as good as another where any will do.
                while !ANY && at > first && stack[at - 1].1 < enter {
                    stack[at] = stack[at - 1];
                    at -= 1;
                }
                stack[at] = (node.children[lane], enter);
                height += 1;
            }
        }
        best
    }
}

impl Node {
    /// Where the ray enters each box; infinite where it does not.
    #[inline(always)]
    fn enters(&self, from: [f32; 3], over: [f32; 3], end: f32) -> Lanes {
        let mut enters = [0.0_f32; WIDE];
        let mut leaves = [end; WIDE];
        for axis in 0..3 {
            let (near, far) = if over[axis] >= 0.0 { (axis, axis + 3) } else { (axis + 3, axis) };
            let boxes = self.bounds[near].iter().zip(&self.bounds[far]);
            for ((near, far), (enters, leaves)) in boxes.zip(enters.iter_mut().zip(&mut leaves)) {
                let a = (near - from[axis]) * over[axis];
                let b = (far - from[axis]) * over[axis] * 1.000_001;
                *enters = if a > *enters { a } else { *enters };
                *leaves = if b < *leaves { b } else { *leaves };
            }
        }
        for (enters, leaves) in enters.iter_mut().zip(leaves) {
            *enters = if *enters <= leaves { *enters } else { f32::INFINITY };
        }
        enters
    }
}

impl Leaf {
    #[inline(always)]
    fn meet(&self, ray: &Ray, end: f32) -> Option<Hit> {
        let [dx, dy, dz] = ray.along;
        let (mut t, mut u, mut v) = ([f32::INFINITY; WIDE], [0.0; WIDE], [0.0; WIDE]);
        for i in 0..WIDE {
            let [ab, ac] = [0, 1].map(|e: usize| [0, 1, 2].map(|k: usize| self.edges[e][k][i]));
            let p = [dy * ac[2] - dz * ac[1], dz * ac[0] - dx * ac[2], dx * ac[1] - dy * ac[0]];
            let determinant = ab[0] * p[0] + ab[1] * p[1] + ab[2] * p[2];
            let over = 1.0 / determinant;
            let s = [0, 1, 2].map(|k: usize| ray.from[k] - self.corner[k][i]);
            let a = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * over;
            let q = [s[1] * ab[2] - s[2] * ab[1], s[2] * ab[0] - s[0] * ab[2], s[0] * ab[1] - s[1] * ab[0]];
            let b = (dx * q[0] + dy * q[1] + dz * q[2]) * over;
            let at = (ac[0] * q[0] + ac[1] * q[1] + ac[2] * q[2]) * over;
            // Comparisons with NaN are false.
            let inside = (a >= 0.0) & (b >= 0.0) & (a + b <= 1.0) & (at > 0.0) & (at < end);
            t[i] = if inside { at } else { f32::INFINITY };
            u[i] = a;
            v[i] = b;
        }
        if bits(t.map(|t| t < f32::INFINITY)) == 0 {
            return None;
        }
        let mut best = 0;
        for i in 1..WIDE {
            best = if t[i] < t[best] { i } else { best };
        }
        let edges = self.edges.map(|edge| edge.map(|axis| axis[best]));
        Some(Hit { t: t[best], number: self.numbers[best], weights: [u[best], v[best]], edges })
    }
}

/// A bit for each lane.
#[inline(always)]
fn bits(lanes: [bool; WIDE]) -> u32 {
    (0..WIDE).fold(0, |all, lane| all | u32::from(lanes[lane]) << lane)
}

//! A tree of boxes, eight to a node, with up to eight triangles in a leaf.
//!
//! Boxes and triangles of a node are tested at once (Wald, Benthin and Boulos 2008).
//! Triangles by Möller and Trumbore 1997.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use pulp::{Simd, WithSimd};

use crate::simd::at_most;

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

/// Where in a tree a ray meets a triangle; little, because nearer and nearer ones are kept on the way.
#[derive(Debug, Clone, Copy)]
struct Touch {
    leaf: u32,
    lane: u32,
    weights: [f32; 2],
}

/// Most nodes that wait to be visited; [`Bvh::build`](super::build) makes no deeper trees.
const STACK: usize = 128;

/// A search along a ray, in the version for a processor.
struct Walk<'a, const ANY: bool> {
    tree: &'a Bvh,
    ray: &'a Ray,
}

impl<const ANY: bool> WithSimd for Walk<'_, ANY> {
    type Output = Option<Hit>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<Hit> {
        self.tree.meet::<S, ANY>(simd, self.ray)
    }
}

/// A ray as boxes want it.
struct Beam<S: Simd> {
    from: [S::f32s; 3],
    /// One over the direction, and a little more for the far sides, against rounding (Ize 2013).
    over: [S::f32s; 3],
    more: [S::f32s; 3],
    /// By axis, the bounds that the ray meets first and last.
    sides: [[usize; 2]; 3],
}

impl Bvh {
    /// The first triangle along a ray, from either side.
    #[inline]
    pub(crate) fn first(&self, ray: &Ray) -> Option<Hit> {
        crate::simd::dispatch(Walk::<false> { tree: self, ray })
    }

    /// Whether there is any triangle along a ray.
    #[inline]
    pub(crate) fn any(&self, ray: &Ray) -> bool {
        crate::simd::dispatch(Walk::<true> { tree: self, ray }).is_some()
    }

    #[inline(always)]
    pub(super) fn meet<S: Simd, const ANY: bool>(&self, simd: S, ray: &Ray) -> Option<Hit> {
        let (t, Touch { leaf, lane, weights }) = walk::<S, Touch, ANY>(
            simd,
            &self.nodes,
            ray,
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

    /// Takes triangles out; their boxes stay.
    pub(super) fn remove(&mut self, gone: impl Fn(u32) -> bool) {
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

/// Goes along a ray through nodes: `meet` finds what is met in a leaf before an end, and where.
#[inline(always)]
pub(super) fn walk<S: Simd, H, const ANY: bool>(
    simd: S,
    nodes: &[Node],
    ray: &Ray,
    mut meet: impl FnMut(u32, f32) -> Option<(f32, H)>,
) -> Option<(f32, H)> {
    if nodes.is_empty() {
        return None;
    }
    let beam = Beam::new(simd, ray);
    let (mut best, mut end) = (None, ray.end);
    let mut current = 0_u32;
    // Most rays that meet little of a tree need no stack, which costs more than a node to set up.
    let (mut enters, mut met) = loop {
        if current & LEAF != 0 {
            return meet(current & !LEAF, end);
        }
        let node = &nodes[current as usize];
        let (enters, met) = node.enters(simd, &beam, end);
        if met == 0 {
            return None;
        }
        if !met.is_power_of_two() {
            break (enters, met);
        }
        current = node.children[met.trailing_zeros() as usize];
    };
    let mut stack = [(0_u32, 0.0_f32); STACK];
    let mut height = 0_usize;
    loop {
        let children = &nodes[current as usize].children;
        current = if ANY {
            any_child(children, met, &mut stack, &mut height)
        } else {
            nearest_child(children, (&enters, met), &mut stack, &mut height)
        };
        // Down to the next node of which more than one child is met.
        loop {
            if current & LEAF != 0 {
                if let Some((at, hit)) = meet(current & !LEAF, end) {
                    (end, best) = (at, Some((at, hit)));
                    if ANY {
                        return best;
                    }
                }
                met = 0;
            } else {
                let node = &nodes[current as usize];
                (enters, met) = node.enters(simd, &beam, end);
                if met.is_power_of_two() {
                    current = node.children[met.trailing_zeros() as usize];
                    continue;
                }
            }
            if met != 0 {
                break;
            }
            // What begins behind the nearest hit is left out.
            current = loop {
                if height == 0 {
                    return best;
                }
                height -= 1;
                let (child, enter) = stack[height % STACK];
                if enter <= end {
                    break child;
                }
            };
        }
    }
}

/// Nodes that wait: which, and where the ray enters them.
type Stack = [(u32, f32); STACK];

/// Any of the children that are met, several of them; the others have to wait.
#[inline(always)]
fn any_child(children: &[u32; WIDE], mut met: u32, stack: &mut Stack, height: &mut usize) -> u32 {
    loop {
        let child = children[met.trailing_zeros() as usize % WIDE];
        met &= met - 1;
        if met == 0 {
            return child;
        }
        stack[*height % STACK] = (child, 0.0);
        *height += 1;
    }
}

/// The nearest of the children that are met, several of them; the others have to wait, the farthest longest.
#[inline(always)]
fn nearest_child(
    children: &[u32; WIDE],
    (enters, mut met): (&Lanes, u32),
    stack: &mut Stack,
    height: &mut usize,
) -> u32 {
    let mut next = || {
        let lane = met.trailing_zeros() as usize % WIDE;
        met &= met.wrapping_sub(1);
        ((children[lane], enters[lane]), met)
    };
    let ((a, _), (b, mut left)) = (next(), next());
    let (mut near, far) = if b.1 < a.1 { (b, a) } else { (a, b) };
    let first = *height;
    stack[first % STACK] = far;
    *height += 1;
    while left != 0 {
        let (child, after) = next();
        left = after;
        let (nearer, other) = if child.1 < near.1 { (child, near) } else { (near, child) };
        near = nearer;
        // Nearest on top.
        let mut at = *height;
        while at > first && stack[(at - 1) % STACK].1 < other.1 {
            stack[at % STACK] = stack[(at - 1) % STACK];
            at -= 1;
        }
        stack[at % STACK] = other;
        *height += 1;
    }
    near.0
}

impl<S: Simd> Beam<S> {
    #[inline(always)]
    fn new(simd: S, ray: &Ray) -> Self {
        let mut beam = Self {
            from: [simd.splat_f32s(0.0); 3],
            over: [simd.splat_f32s(0.0); 3],
            more: [simd.splat_f32s(0.0); 3],
            sides: [[0, 3], [1, 4], [2, 5]],
        };
        for axis in 0..3 {
            let along = ray.along[axis];
            let over = 1.0 / if along.abs() < 1e-20 { 1e-20_f32.copysign(along) } else { along };
            beam.from[axis] = simd.splat_f32s(ray.from[axis]);
            beam.over[axis] = simd.splat_f32s(over);
            beam.more[axis] = simd.splat_f32s(over * 1.000_001);
            if over < 0.0 {
                beam.sides[axis] = [axis + 3, axis];
            }
        }
        beam
    }
}

/// Some of eight numbers.
#[inline(always)]
fn part<S: Simd>(lanes: &Lanes, number: usize) -> S::f32s {
    S::as_simd_f32s(lanes).0[number]
}

impl Node {
    /// Where the ray enters each box, and which boxes it meets at all, a bit each.
    #[inline(always)]
    fn enters<S: Simd>(&self, simd: S, beam: &Beam<S>, end: f32) -> (Lanes, u32) {
        let (mut enters, mut leaves) = ([0.0; WIDE], [0.0; WIDE]);
        for i in 0..WIDE / S::F32_LANES {
            let (mut enter, mut leave) = (simd.splat_f32s(0.0), simd.splat_f32s(end));
            for axis in 0..3 {
                let [near, far] = beam.sides[axis];
                let near = simd.sub_f32s(part::<S>(&self.bounds[near], i), beam.from[axis]);
                let far = simd.sub_f32s(part::<S>(&self.bounds[far], i), beam.from[axis]);
                enter = simd.max_f32s(simd.mul_f32s(near, beam.over[axis]), enter);
                leave = simd.min_f32s(simd.mul_f32s(far, beam.more[axis]), leave);
            }
            S::as_mut_simd_f32s(&mut enters).0[i] = enter;
            S::as_mut_simd_f32s(&mut leaves).0[i] = leave;
        }
        (enters, at_most(simd, &enters, &leaves))
    }
}

/// Eight vectors.
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
    /// How far along a ray its first triangle is, which of them, and the weights of its corners.
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
        // None, where no bit was set.
        let t = *t.get(best)?;
        Some((t, best as u32, [u[best], v[best]]))
    }
}

//! Traversal of a tree by a ray, nearest nodes first.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use arrayvec::ArrayVec;
use pulp::Simd;

use super::build::LEVELS;
use super::tree::{LEAF, Lanes, Node, Ray, WIDE, part};
use crate::math::simd::at_most;

/// Greatest number of pending nodes: at each level but the last, all children but one.
const STACK: usize = (WIDE - 1) * LEVELS;

/// A ray prepared for tests with boxes.
pub(crate) struct Beam<S: Simd> {
    from: [S::f32s; 3],
    /// Reciprocals of the direction, and slightly larger ones for the far sides, to allow for rounding (Ize
    /// 2013).
    over: [S::f32s; 3],
    more: [S::f32s; 3],
    /// For each axis, the bounds that the ray crosses first and last.
    sides: [[usize; 2]; 3],
}

/// Traverses nodes along a ray up to an end; `meet` intersects a leaf and returns its hit before an end, and
/// the distance.
#[inline(always)]
pub(crate) fn walk<S: Simd, H, const ANY: bool>(
    simd: S,
    nodes: &[Node],
    (beam, mut end): (&Beam<S>, f32),
    mut meet: impl FnMut(u32, f32) -> Option<(f32, H)>,
) -> Option<(f32, H)> {
    if nodes.is_empty() {
        return None;
    }
    let mut best = None;
    // The stack is not zeroed beforehand, which would cost more than a node.
    let mut stack = Stack::new();
    let mut current = 0_u32;
    loop {
        if current & LEAF != 0 {
            if let Some((at, hit)) = meet(current & !LEAF, end) {
                (end, best) = (at, Some((at, hit)));
                if ANY {
                    return best;
                }
            }
        } else {
            let node = &nodes[current as usize];
            let (enters, met) = node.enters(simd, beam, end);
            if met != 0 {
                current = match met.is_power_of_two() {
                    true => node.children[met.trailing_zeros() as usize % WIDE],
                    false if ANY => any_child(&node.children, met, &mut stack),
                    false => nearest_child(&node.children, &enters, met, &mut stack),
                };
                continue;
            }
        }
        // Nodes that begin behind the nearest hit are skipped.
        current = loop {
            match stack.pop() {
                None => return best,
                Some((child, enter)) if enter <= end => break child,
                Some(_) => {}
            }
        };
    }
}

/// Pending nodes, each with the distance at which the ray enters it.
type Stack = ArrayVec<(u32, f32), STACK>;

/// One of several children that the ray hits; the others become pending.
#[inline(always)]
fn any_child(children: &[u32; WIDE], mut met: u32, stack: &mut Stack) -> u32 {
    loop {
        let child = children[met.trailing_zeros() as usize % WIDE];
        met &= met - 1;
        if met == 0 {
            return child;
        }
        stack.push((child, 0.0));
    }
}

/// The nearest of several children that the ray hits; the others become pending, the nearest on top.
#[inline(always)]
fn nearest_child(children: &[u32; WIDE], enters: &Lanes, mut met: u32, stack: &mut Stack) -> u32 {
    let mut next = || {
        let lane = met.trailing_zeros() as usize % WIDE;
        met &= met.wrapping_sub(1);
        ((children[lane], enters[lane]), met)
    };
    let ((a, _), (b, mut left)) = (next(), next());
    let (mut near, far) = if b.1 < a.1 { (b, a) } else { (a, b) };
    let first = stack.len();
    stack.push(far);
    while left != 0 {
        let (child, after) = next();
        left = after;
        let (nearer, other) = if child.1 < near.1 { (child, near) } else { (near, child) };
        near = nearer;
        stack.push(other);
        // Keeps the nearest on top.
        let mut at = stack.len() - 1;
        while at > first && stack[at - 1].1 < other.1 {
            stack[at] = stack[at - 1];
            at -= 1;
        }
        stack[at] = other;
    }
    near.0
}

impl<S: Simd> Beam<S> {
    #[inline(always)]
    pub(crate) fn new(simd: S, ray: &Ray) -> Self {
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

impl Node {
    /// Distances at which the ray enters the boxes, and a bit mask of the boxes that it hits.
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

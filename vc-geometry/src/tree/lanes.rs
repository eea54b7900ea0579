//! Boxes in structure-of-arrays layout, compared several at a time.

use vc_graph::Aabb;
use wide::f32x8;

use crate::order::{greater, lesser};

/// Number of boxes compared together.
pub(super) const LANES: usize = 8;

/// Eight boxes, coordinate by coordinate.
#[derive(Debug, Clone)]
pub(super) struct Group {
    low: [f32x8; 3],
    high: [f32x8; 3],
}

/// A box to compare with groups.
#[derive(Debug)]
pub(super) struct Probe {
    low: [f32x8; 3],
    high: [f32x8; 3],
}

impl Probe {
    pub(super) fn new(region: &Aabb) -> Self {
        let wide = |axis: usize| (f32x8::splat(region.min[axis]), f32x8::splat(region.max[axis]));
        let [x, y, z] = [wide(0), wide(1), wide(2)];
        Self { low: [x.0, y.0, z.0], high: [x.1, y.1, z.1] }
    }
}

impl Group {
    const EMPTY: Self =
        Self { low: [f32x8::new([f32::INFINITY; LANES]); 3], high: [f32x8::new([f32::NEG_INFINITY; LANES]); 3] };

    pub(super) fn put(&mut self, lane: usize, region: &Aabb) {
        for axis in 0..3 {
            self.low[axis].as_mut_array()[lane] = region.min[axis];
            self.high[axis].as_mut_array()[lane] = region.max[axis];
        }
    }

    /// The boxes of the group that overlap another.
    #[inline]
    pub(super) fn meeting(&self, probe: &Probe) -> Lanes {
        let along = |axis: usize| self.low[axis].simd_le(probe.high[axis]) & self.high[axis].simd_ge(probe.low[axis]);
        Lanes((along(0) & along(1) & along(2)).to_bitmask())
    }

    /// The bounding box of the group.
    pub(super) fn whole(&self) -> Aabb {
        let mut whole = Aabb::EMPTY;
        for axis in 0..3 {
            whole.min[axis] = self.low[axis].as_array().iter().copied().fold(f32::INFINITY, lesser);
            whole.max[axis] = self.high[axis].as_array().iter().copied().fold(f32::NEG_INFINITY, greater);
        }
        whole
    }
}

/// Packs boxes into groups, in their order; unused lanes of the last group overlap nothing.
pub(super) fn grouped(regions: impl ExactSizeIterator<Item = Aabb>) -> Vec<Group> {
    let mut groups = vec![Group::EMPTY; regions.len().div_ceil(LANES)];
    regions.enumerate().for_each(|(at, region)| groups[at / LANES].put(at % LANES, &region));
    groups
}

/// A subset of a group's boxes as a bit mask.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lanes(u32);

impl Lanes {
    /// The subset without the lanes up to a number.
    pub(super) fn after(self, lane: usize) -> Self {
        Self(self.0 & (u32::MAX << lane << 1))
    }
}

impl Iterator for Lanes {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    }
}

//! Boxes in structure-of-arrays layout, compared several at a time.

use wide::f32x8;

use crate::region::{Region, less, more};

/// Number of boxes compared together.
pub(crate) const LANES: usize = 8;

/// Eight boxes, coordinate by coordinate.
#[derive(Debug, Clone)]
pub(crate) struct Group {
    low: [f32x8; 3],
    high: [f32x8; 3],
}

/// A box to compare with groups.
#[derive(Debug)]
pub(crate) struct Probe {
    low: [f32x8; 3],
    high: [f32x8; 3],
}

impl Probe {
    pub(crate) fn new(region: &Region) -> Self {
        let wide = |axis: usize| (f32x8::splat(region.low[axis]), f32x8::splat(region.high[axis]));
        let [x, y, z] = [wide(0), wide(1), wide(2)];
        Self { low: [x.0, y.0, z.0], high: [x.1, y.1, z.1] }
    }
}

impl Group {
    const EMPTY: Self =
        Self { low: [f32x8::new([f32::INFINITY; LANES]); 3], high: [f32x8::new([f32::NEG_INFINITY; LANES]); 3] };

    pub(crate) fn put(&mut self, lane: usize, region: &Region) {
        for axis in 0..3 {
            self.low[axis].as_mut_array()[lane] = region.low[axis];
            self.high[axis].as_mut_array()[lane] = region.high[axis];
        }
    }

    /// The boxes of the group that overlap another.
    #[inline]
    pub(crate) fn meeting(&self, probe: &Probe) -> Lanes {
        let along = |axis: usize| self.low[axis].simd_le(probe.high[axis]) & self.high[axis].simd_ge(probe.low[axis]);
        Lanes((along(0) & along(1) & along(2)).to_bitmask())
    }

    /// The bounding box of the group.
    pub(crate) fn whole(&self) -> Region {
        let mut whole = Region::EMPTY;
        for axis in 0..3 {
            whole.low[axis] = self.low[axis].as_array().iter().copied().fold(f32::INFINITY, less);
            whole.high[axis] = self.high[axis].as_array().iter().copied().fold(f32::NEG_INFINITY, more);
        }
        whole
    }
}

/// Packs boxes into groups, in their order; unused lanes of the last group overlap nothing.
pub(crate) fn grouped(regions: impl ExactSizeIterator<Item = Region>) -> Vec<Group> {
    let mut groups = vec![Group::EMPTY; regions.len().div_ceil(LANES)];
    regions.enumerate().for_each(|(at, region)| groups[at / LANES].put(at % LANES, &region));
    groups
}

/// A subset of a group's boxes as a bit mask.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lanes(u32);

impl Lanes {
    /// The subset without the lanes up to a number.
    pub(crate) fn after(self, lane: usize) -> Self {
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

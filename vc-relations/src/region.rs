//! World-aligned boxes.

use nalgebra::Vector3;

/// The lesser of two numbers, neither of them NaN: a single instruction, unlike `f32::min`.
#[inline]
pub(crate) fn less(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}

/// The larger of two numbers; see [`less`].
#[inline]
pub(crate) fn more(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// Sorts items by a number, and by their index where it is equal; integer keys compare faster.
pub(crate) fn sorted(keys: impl Iterator<Item = (f32, u32)>) -> Vec<u32> {
    let key = |(value, item): (f32, u32)| {
        let bits = value.to_bits();
        let ordered = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
        u64::from(ordered) << 32 | u64::from(item)
    };
    let mut order: Vec<u64> = keys.map(key).collect();
    order.sort_unstable();
    order.into_iter().map(|key| key as u32).collect()
}

/// A world-aligned box, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Region {
    pub(crate) low: Vector3<f32>,
    pub(crate) high: Vector3<f32>,
}

impl Region {
    /// A box that overlaps nothing.
    pub(crate) const EMPTY: Self = Self {
        low: Vector3::new(f32::INFINITY, f32::INFINITY, f32::INFINITY),
        high: Vector3::new(f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY),
    };

    #[inline]
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.meets_in_plan(other) && self.low.z <= other.high.z && self.high.z >= other.low.z
    }

    /// Whether the two overlap in plan.
    #[inline]
    pub(crate) fn meets_in_plan(&self, other: &Self) -> bool {
        (self.low.x <= other.high.x)
            & (self.high.x >= other.low.x)
            & (self.low.y <= other.high.y)
            & (self.high.y >= other.low.y)
    }

    /// Squared distance between two boxes, square metres.
    #[inline]
    pub(crate) fn distance_squared(&self, other: &Self) -> f32 {
        let apart = |i: usize| more(more(self.low[i] - other.high[i], other.low[i] - self.high[i]), 0.0);
        let (x, y, z) = (apart(0), apart(1), apart(2));
        x * x + y * y + z * z
    }

    #[inline]
    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self { low: self.low.zip_map(&other.low, less), high: self.high.zip_map(&other.high, more) }
    }

    /// The box around two points.
    #[inline]
    pub(crate) fn around(one: &Vector3<f32>, other: &Vector3<f32>) -> Self {
        Self { low: one.zip_map(other, less), high: one.zip_map(other, more) }
    }

    pub(crate) fn grown(&self, sides: f32, up_and_down: f32) -> Self {
        let by = Vector3::new(sides, sides, up_and_down);
        Self { low: self.low - by, high: self.high + by }
    }
}

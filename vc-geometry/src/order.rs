//! Comparisons of numbers that are known to be no NaN, in few instructions.
//!
//! ```
//! use vc_geometry::order::{greater, lesser, sorted};
//! assert_eq!((lesser(2.0, -1.0), greater(2.0, -1.0)), (-1.0, 2.0));
//! assert_eq!(sorted([(0.5, 0), (-3.0, 1), (0.5, 2), (-0.1, 3)].into_iter()), [1, 3, 0, 2]);
//! ```

/// The lesser of two numbers, neither of them NaN: a single instruction, unlike `f32::min`.
#[inline]
pub fn lesser(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}

/// The larger of two numbers; see [`lesser`].
#[inline]
pub fn greater(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// Sorts items by a number, as `f32::total_cmp` orders it, and by their index where it is equal; integer keys compare
/// faster.
///
/// ```
/// let distances = [(2.5, 0), (-1.0, 1), (2.5, 2)];
/// assert_eq!(vc_geometry::order::sorted(distances.into_iter()), [1, 0, 2]);
/// ```
pub fn sorted(keys: impl Iterator<Item = (f32, u32)>) -> Vec<u32> {
    let key = |(value, item): (f32, u32)| {
        let bits = value.to_bits();
        let ordered = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
        u64::from(ordered) << 32 | u64::from(item)
    };
    let mut order: Vec<u64> = keys.map(key).collect();
    order.sort_unstable();
    order.into_iter().map(|key| key as u32).collect()
}

//! Fronts and lids that swing about an edge.

use crate::solid::{Build, P};

/// The edge of a front at which its hinge is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::object) enum Swing {
    /// The higher Y.
    Left,
    /// The lower Y.
    Right,
    /// The bottom.
    Down,
    /// The top.
    Up,
}

/// The parts built swing outwards about an edge of the front `low..high`.
pub(in crate::object) fn swing(
    b: &mut Build<'_>,
    at: Swing,
    low: P,
    high: P,
    most: f32,
    build: impl FnOnce(&mut Build<'_>),
) {
    let (y, z, axis) = match at {
        Swing::Left => (high[1], low[2], [0.0, 0.0, 1.0]),
        Swing::Right => (low[1], low[2], [0.0, 0.0, -1.0]),
        Swing::Down => (low[1], low[2], [0.0, 1.0, 0.0]),
        Swing::Up => (low[1], high[2], [0.0, -1.0, 0.0]),
    };
    b.hinge([high[0], y, z], axis, most, build);
}

/// The parts built open upwards about a line along Y through `anchor`, with the front edge rising.
pub(in crate::object) fn lid(b: &mut Build<'_>, anchor: P, most: f32, build: impl FnOnce(&mut Build<'_>)) {
    b.hinge(anchor, [0.0, -1.0, 0.0], most, build);
}

/// A front reduced by the gap to its neighbours.
pub(in crate::object) fn gapped(low: P, high: P, gap: f32) -> (P, P) {
    ([low[0], low[1] + gap, low[2] + gap], [high[0], high[1] - gap, high[2] - gap])
}

//! Points around a circle, from tables: most round shapes use the same few numbers of sides.

use std::f32::consts::TAU;
use std::sync::LazyLock;

use vc_graph::portable::Portable;

/// The number of tables, indexed by the number of sides.
const TABLES: usize = 65;

/// The sine and cosine of the `k`th of `n` equal parts of a turn, `k` below `n`.
pub(crate) fn part(k: usize, n: usize) -> (f32, f32) {
    static PARTS: LazyLock<Vec<Vec<(f32, f32)>>> =
        LazyLock::new(|| (0..TABLES).map(|n| (0..n).map(|k| angle(k, n)).collect()).collect());
    match PARTS.get(n).and_then(|table| table.get(k)) {
        Some(&part) => part,
        None => angle(k, n),
    }
}

fn angle(k: usize, n: usize) -> (f32, f32) {
    (TAU * k as f32 / n as f32).sine_cosine()
}

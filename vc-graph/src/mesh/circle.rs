//! Corners of regular polygons.

use std::f64::consts::TAU;

use crate::portable::Portable;

const LEAST: usize = 8;
const MOST: usize = 64;

/// The number of corners with which a circle's chords stay within `tolerance`.
pub(super) fn corners(radius: f32, tolerance: f32) -> usize {
    let sagitta = |n: usize| f64::from(radius) * (1.0 - turn(1, 2 * n).0);
    (LEAST..MOST).step_by(4).find(|&n| sagitta(n) <= f64::from(tolerance)).unwrap_or(MOST)
}

/// Cosine and sine of `n` evenly spaced angles; `n` is a multiple of four, and the quadrants are exact mirror
/// images.
pub(super) fn circle(n: usize) -> Vec<(f64, f64)> {
    (0..n)
        .map(|k| {
            let (c, s) = turn(k % (n / 4), n);
            [(c, s), (-s, c), (-c, -s), (s, -c)][k / (n / 4) % 4]
        })
        .collect()
}

/// Cosine and sine of the angle `k / n` of a full turn, at most a quarter turn.
fn turn(k: usize, n: usize) -> (f64, f64) {
    let angle = |k: f64| TAU * k / n as f64;
    if 8 * k <= n {
        (angle(k as f64).cosine(), angle(k as f64).sine())
    } else {
        let rest = angle(n as f64 / 4.0 - k as f64);
        (rest.sine(), rest.cosine())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the comparison is with them")]
    fn agrees_with_the_standard_library() {
        for n in (LEAST..=MOST).step_by(4) {
            for (k, (c, s)) in circle(n).into_iter().enumerate() {
                let (sin, cos) = (TAU * k as f64 / n as f64).sin_cos();
                assert!((c - cos).abs() < 4e-15 && (s - sin).abs() < 4e-15, "{k} of {n}");
            }
        }
    }

    #[test]
    fn corners_keep_within_the_tolerance() {
        assert_eq!(corners(1.0, 10.0), LEAST);
        assert_eq!(corners(1.0, 0.0), MOST);
        assert_eq!(corners(1.0, f32::NAN), MOST);
        let n = corners(1.0, 0.02) as f64;
        assert!(1.0 - (TAU / 2.0 / n).cosine() <= 0.02 && 1.0 - (TAU / 2.0 / (n - 4.0)).cosine() > 0.02);
    }
}

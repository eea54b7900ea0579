//! Value noise: a random number at each of evenly spaced moments, and a smooth course between them.

use super::tick::Span;
use crate::Seed;

/// Noise of one period: between 0 and 1, uniform at the knots.
#[derive(Debug, Clone, Copy)]
pub(super) struct Noise {
    seed: Seed,
    /// Time from one knot to the next.
    period: Span,
}

impl Noise {
    pub(super) fn new(seed: Seed, name: &str, period: Span) -> Self {
        Self { seed: seed.child(name), period: Span(period.0.max(1)) }
    }

    /// The value at a moment. The slope never exceeds 1.5 per period. The knot and the position after it are exact, as
    /// they are found in integers.
    pub(super) fn at(&self, moment: Span) -> f64 {
        let (knot, rest) = (moment.0 / self.period.0, moment.0 % self.period.0);
        let (from, to) = (self.knot(knot), self.knot(knot.saturating_add(1)));
        from + (to - from) * smooth(rest as f64 / self.period.0 as f64)
    }

    fn knot(&self, index: u64) -> f64 {
        // An f64 holds 53 bits exactly.
        (self.seed.nth(index).0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// From 0 to 1 with level ends: Hermite's cubic polynomial. Numbers outside of 0 to 1 count as the nearer end.
pub(super) fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

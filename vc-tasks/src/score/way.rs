//! Ways to make a goal true, and their values.

/// The limit up to which conditions are counted, so that products do not overflow.
pub(super) const LONGEST: u32 = 1 << 30;

/// The conditions of a way: their number, and how many are fulfilled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Way {
    pub(super) met: u32,
    pub(super) of: u32,
    pub(super) possible: bool,
}

impl Way {
    /// There is no way.
    pub(super) const NONE: Self = Self { met: 0, of: 0, possible: false };
    /// A way without conditions.
    pub(super) const NOTHING: Self = Self { met: 0, of: 0, possible: true };

    /// A way with the given number of conditions.
    pub(super) fn new(met: u32, of: u32) -> Self {
        Self { met, of, possible: true }
    }

    /// The conditions of both ways together.
    #[inline]
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            met: (self.met + other.met).min(LONGEST),
            of: (self.of + other.of).min(LONGEST),
            possible: self.possible && other.possible,
        }
    }
}

/// The value of ways when a share of p/q is to be beaten.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Worth {
    pub(super) p: u32,
    pub(super) q: u32,
}

/// The value of an impossible way.
pub(super) const WORTHLESS: i64 = i64::MIN / 4;

impl Worth {
    /// Positive if a larger share of its conditions is fulfilled than p/q.
    #[inline]
    pub(super) fn value(self, way: Way) -> i64 {
        if !way.possible {
            return WORTHLESS;
        }
        i64::from(self.q) * i64::from(way.met) - i64::from(self.p) * i64::from(way.of)
    }

    /// Larger is better; among equals the way with fewer conditions wins.
    #[inline]
    pub(super) fn rank(self, way: Way) -> (i64, i64) {
        (self.value(way), -i64::from(way.of))
    }

    /// The better of two ways.
    #[inline]
    pub(super) fn better(self, a: Way, b: Way) -> Way {
        if self.rank(b) > self.rank(a) { b } else { a }
    }
}

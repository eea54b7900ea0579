//! Ticks and spans of time.

use std::fmt;
use std::ops::{Add, AddAssign, Mul, Sub};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::spelling::clip;

/// Number of ticks in a second.
pub const TICKS_PER_SECOND: u64 = 60;

/// A moment: the number of ticks of 1/60 s since the beginning. It prints as seconds; arithmetic stops at the first and
/// at the last tick, some ten thousand million years later.
///
/// ```
/// use vc_graph::clock::{Span, Tick};
/// let tick = Tick(700) + Span(41);
/// assert_eq!(tick.to_string(), "12.350 s");
/// assert_eq!(tick - Tick(700), Span(41));
/// assert_eq!(Tick(700) - tick, Span(0));
/// assert_eq!(Tick(u64::MAX) + Span(1), Tick(u64::MAX));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Tick(pub u64);

/// A span of time: a number of ticks of 1/60 s. It prints as seconds and is read with a unit; arithmetic stops at the
/// largest span.
///
/// ```
/// use vc_graph::clock::Span;
/// assert_eq!("1.5 min".parse(), Ok(Span::from_seconds(90.0)));
/// assert_eq!("2 h".parse::<Span>()?.to_string(), "7200.000 s");
/// assert_eq!(Span(30).seconds(), 0.5);
/// # Ok::<(), vc_graph::clock::SpanError>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Span(pub u64);

impl Tick {
    /// Seconds since the beginning.
    pub fn seconds(self) -> f64 {
        Span(self.0).seconds()
    }
}

impl Span {
    /// The longest span.
    pub const MAX: Self = Self(u64::MAX);

    /// The span that is nearest to a number of seconds; zero for negative numbers and for NaN.
    ///
    /// ```
    /// use vc_graph::clock::Span;
    /// assert_eq!(Span::from_seconds(0.26), Span(16));
    /// assert_eq!(Span::from_seconds(-1.0), Span(0));
    /// assert_eq!(Span::from_seconds(f64::INFINITY), Span::MAX);
    /// ```
    pub fn from_seconds(seconds: f64) -> Self {
        // A conversion of a float stops at the bounds of the integer.
        Self((seconds * TICKS_PER_SECOND as f64).round() as u64)
    }

    /// Its length in seconds.
    pub fn seconds(self) -> f64 {
        self.0 as f64 / TICKS_PER_SECOND as f64
    }
}

impl Add<Span> for Tick {
    type Output = Self;
    fn add(self, span: Span) -> Self {
        Self(self.0.saturating_add(span.0))
    }
}

impl AddAssign<Span> for Tick {
    fn add_assign(&mut self, span: Span) {
        *self = *self + span;
    }
}

impl Sub<Span> for Tick {
    type Output = Self;
    fn sub(self, span: Span) -> Self {
        Self(self.0.saturating_sub(span.0))
    }
}

/// The span from the second tick to the first; zero if the second is later.
impl Sub for Tick {
    type Output = Span;
    fn sub(self, earlier: Self) -> Span {
        Span(self.0.saturating_sub(earlier.0))
    }
}

impl Add for Span {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
}

impl Mul<u64> for Span {
    type Output = Self;
    fn mul(self, times: u64) -> Self {
        Self(self.0.saturating_mul(times))
    }
}

/// Seconds with three digits.
impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (seconds, rest) = (self.0 / TICKS_PER_SECOND, self.0 % TICKS_PER_SECOND);
        let thousandths = (rest * 1000 + TICKS_PER_SECOND / 2) / TICKS_PER_SECOND;
        f.pad(&format!("{seconds}.{thousandths:03} s"))
    }
}

/// Seconds since the beginning with three digits.
impl fmt::Display for Tick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Span(self.0).fmt(f)
    }
}

/// Text that is no span.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no span of time; write a number and its unit, as in `0.5 s`, `45 min`, `2 h` or `3 days`")]
pub struct SpanError(pub String);

/// The units in which spans are written, and their lengths in seconds.
const UNITS: [(&str, f64); 5] = [("s", 1.0), ("min", 60.0), ("h", 3600.0), ("day", 86_400.0), ("days", 86_400.0)];

impl FromStr for Span {
    type Err = SpanError;

    fn from_str(text: &str) -> Result<Self, SpanError> {
        let text = text.trim();
        let (number, unit) = text.split_at(text.find(|c: char| c.is_alphabetic() || c == ' ').unwrap_or(text.len()));
        let plain = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        let number: Option<f64> = number.parse().ok().filter(|_| plain);
        let unit = UNITS.iter().find(|(name, _)| *name == unit.trim());
        let seconds = number.zip(unit).map(|(number, (_, seconds))| number * seconds);
        seconds.map(Self::from_seconds).ok_or_else(|| SpanError(clip(text)))
    }
}

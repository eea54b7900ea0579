//! The day and the time of day.

use std::fmt;
use std::str::FromStr;

use super::tick::{Span, TICKS_PER_SECOND, Tick};
use crate::spelling::clip;

/// Seconds in a day.
pub const DAY: u32 = 86_400;

/// A day and the time of day, to the second. Days are counted from zero; day 0 is the first of January and a year has
/// 365 days, see [`weather`](super::weather()). It prints as `day 3, 07:30:05`, and the day may be left out on reading.
///
/// ```
/// use vc_graph::clock::{DayTime, Span, Tick};
/// let morning: DayTime = "07:30".parse()?;
/// let later = DayTime::at(Tick::default() + "3 days".parse::<Span>()? + Span::from_seconds(5.0), morning);
/// assert_eq!(later.to_string(), "day 3, 07:30:05");
/// assert_eq!("day 3, 07:30:05".parse(), Ok(later));
/// assert_eq!((later.day(), morning.hour()), (3, 7.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DayTime {
    day: u32,
    second: u32,
}

impl DayTime {
    /// A time of a day, in seconds since midnight; more than a day's go on into the days after it.
    ///
    /// ```
    /// use vc_graph::clock::{DAY, DayTime};
    /// assert_eq!(DayTime::new(2, DAY + 60), DayTime::new(3, 60));
    /// ```
    pub fn new(day: u32, seconds: u32) -> Self {
        Self::from_seconds(u64::from(day) * u64::from(DAY) + u64::from(seconds))
    }

    /// The day and time at a tick, if it was `start` at tick zero. It stops at the end of the last day that a `u32` can
    /// count.
    pub fn at(tick: Tick, start: Self) -> Self {
        Self::from_seconds(start.seconds().saturating_add(tick.0 / TICKS_PER_SECOND))
    }

    /// The day, counted from zero.
    pub fn day(self) -> u32 {
        self.day
    }

    /// Seconds since midnight, below [`DAY`].
    pub fn second(self) -> u32 {
        self.second
    }

    /// The hour with its fraction, from 0 up to 24, 24 excluded: 7.5 at half past seven.
    pub fn hour(self) -> f32 {
        self.second as f32 / 3600.0
    }

    /// Seconds since the midnight before day 0.
    pub fn seconds(self) -> u64 {
        u64::from(self.day) * u64::from(DAY) + u64::from(self.second)
    }

    /// The time from the midnight before day 0 until now.
    pub(super) fn since_day_zero(self) -> Span {
        Span(self.seconds()) * TICKS_PER_SECOND
    }

    fn from_seconds(seconds: u64) -> Self {
        let last = u64::from(u32::MAX) * u64::from(DAY) + u64::from(DAY) - 1;
        let seconds = seconds.min(last);
        // Both fit, as the last second has the largest day.
        let (day, second) = (seconds / u64::from(DAY), seconds % u64::from(DAY));
        Self { day: day as u32, second: second as u32 }
    }
}

impl fmt::Display for DayTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (hours, minutes, seconds) = (self.second / 3600, self.second / 60 % 60, self.second % 60);
        f.pad(&format!("day {}, {hours:02}:{minutes:02}:{seconds:02}", self.day))
    }
}

/// Text that is no time of day.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no time of day; write hours and minutes, as in `07:30`, `07:30:05` or `day 3, 07:30:05`")]
pub struct DayTimeError(pub String);

impl FromStr for DayTime {
    type Err = DayTimeError;

    fn from_str(text: &str) -> Result<Self, DayTimeError> {
        read(text.trim()).ok_or_else(|| DayTimeError(clip(text)))
    }
}

fn read(text: &str) -> Option<DayTime> {
    let (day, time) = match text.strip_prefix("day ") {
        Some(rest) => rest.split_once(',')?,
        None => ("0", text),
    };
    let mut parts = time.trim().split(':');
    let (hours, minutes) = (part(parts.next()?, 24)?, part(parts.next()?, 60)?);
    let seconds = parts.next().map_or(Some(0), |seconds| part(seconds, 60))?;
    let whole = parts.next().is_none();
    whole.then_some(())?;
    Some(DayTime { day: number(day.trim())?, second: hours * 3600 + minutes * 60 + seconds })
}

/// A number of at most two digits below a bound.
fn part(text: &str, bound: u32) -> Option<u32> {
    number(text).filter(|&n| text.len() <= 2 && n < bound)
}

/// A number of digits only: no sign.
fn number(text: &str) -> Option<u32> {
    text.bytes().all(|b| b.is_ascii_digit()).then(|| text.parse().ok())?
}

/// As it prints.
impl serde::Serialize for DayTime {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for DayTime {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'de, str>>::deserialize(d)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}

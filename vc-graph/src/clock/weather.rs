//! The weather as a function of a seed and the moment.

use std::f64::consts::TAU;

use nalgebra::Vector2;

use super::day::{DAY, DayTime};
use super::noise::{Noise, smooth};
use super::tick::{Span, TICKS_PER_SECOND, Tick};
use crate::Seed;
use crate::portable::Portable;

/// The weather at a moment, out of doors.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Weather {
    /// Share of the sky that clouds cover, 0 to 1.
    pub clouds: f32,
    /// Rain, 0 to 8 millimetres an hour; snow counts as the water in it. Zero while clouds cover less than 0.6 of the
    /// sky.
    pub rain: f32,
    /// Velocity of the air in the world's axes, metres a second; x counts as east and y as north.
    pub wind: Vector2<f32>,
    /// Temperature of the air, °C.
    pub temperature: f32,
}

impl Weather {
    /// Speed of the wind, metres a second.
    pub fn wind_speed(&self) -> f32 {
        self.wind.norm()
    }

    /// The angle of the direction in which the wind blows, from x (east) towards y (north), radians; zero in a calm.
    pub fn wind_direction(&self) -> f32 {
        self.wind.y.angle_to(self.wind.x)
    }
}

/// The climate, all figures ours: round numbers for a temperate place inland, about 50 degrees north. A test holds a
/// year of it to a mean of 10 °C, three fifths of the sky in clouds, rain in a tenth of the hours and 800 mm of it, and
/// wind of 4 m/s.
mod climate {
    /// Mean temperature of the year, °C.
    pub(super) const MEAN: f64 = 10.0;
    /// The warmest and the coldest day of the year are so much from the mean, °C.
    pub(super) const YEARLY: f64 = 9.0;
    /// The warmest day of the year, counted from the first of January: the end of July.
    pub(super) const WARMEST_DAY: f64 = 205.0;
    /// The warmest and the coldest hour of a cloudless and of an overcast day are so much from the day's mean, °C.
    pub(super) const DAILY: [f64; 2] = [5.5, 1.5];
    /// The warmest hour of the day.
    pub(super) const WARMEST_HOUR: f64 = 15.0;
    /// Masses of air are at most so much warmer or colder than the season, °C.
    pub(super) const AIR_MASS: f64 = 7.0;
    /// Days of a year.
    pub(super) const YEAR: f64 = 365.0;
    /// The wind that prevails, from the south-west, m/s: east and north.
    pub(super) const PREVAILING: [f64; 2] = [1.5, 0.6];
    /// How much the wind of a front, and gusts, add in each direction at most, m/s.
    pub(super) const GALE: f64 = 5.5;
    pub(super) const GUST: f64 = 1.5;
    /// Clouds below which no rain falls.
    pub(super) const RAIN_CLOUDS: f64 = 0.6;
    /// The heaviest rain, mm/h.
    pub(super) const DOWNPOUR: f64 = 8.0;
    /// How wet the air is, -1.5 to 1.5, when rain begins to fall.
    pub(super) const WET: f64 = 0.38;
}

/// The weather at a tick, if it was `start` at tick zero.
///
/// Only the moment counts: the weather of a day is the same whether a run began on it or the week before. The day of
/// `start` gives the season: day 0 is the first of January of a place with winters, day 180 is in midsummer. The same
/// arguments give the same bytes on every machine.
///
/// Each quantity is value noise, random numbers at knots with smooth courses between them: fronts have knots every 30
/// hours, showers every two, gusts every four minutes. Within a minute no quantity jumps: clouds change by less than
/// 0.02, rain by less than 0.6 mm/h, temperature by less than 0.1 °C, each component of the wind by less than 1.3 m/s.
/// Costs ten values of noise, whatever the tick.
///
/// ```
/// use vc_graph::Seed;
/// use vc_graph::clock::{DayTime, Span, Tick, weather};
/// let noon: DayTime = "day 180, 12:00".parse()?;
/// let now = weather(Seed(42), Tick(0), noon);
/// let soon = weather(Seed(42), Tick(0) + Span::from_seconds(60.0), noon);
/// assert!((now.temperature - soon.temperature).abs() < 0.1);
/// assert_eq!(now, weather(Seed(42), Tick::default() + "12 h".parse()?, "day 180, 00:00".parse()?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn weather(seed: Seed, tick: Tick, start: DayTime) -> Weather {
    let moment = start.since_day_zero() + Span(tick.0);
    let seed = seed.child("weather");
    let clouds = clouds(seed, moment);
    let noise = |name: &str, minutes| centred(seed, name, minutes, moment);
    let [east, north] = climate::PREVAILING;
    let gusty = |way: &str, prevailing: f64| {
        let front = noise(&format!("wind {way}"), 20 * 60) * climate::GALE;
        (prevailing + front + noise(&format!("gust {way}"), 4) * climate::GUST) as f32
    };
    Weather {
        clouds: clouds as f32,
        rain: rain(seed, moment, clouds) as f32,
        wind: Vector2::new(gusty("east", east), gusty("north", north)),
        temperature: temperature(seed, moment, clouds) as f32,
    }
}

/// Noise around zero, from -1 to 1.
fn centred(seed: Seed, name: &str, minutes: u64, moment: Span) -> f64 {
    2.0 * Noise::new(seed, name, Span(minutes * 60 * TICKS_PER_SECOND)).at(moment) - 1.0
}

/// Fronts, and lesser clouds in them. Clear and overcast skies are more frequent than those between.
fn clouds(seed: Seed, moment: Span) -> f64 {
    let front = centred(seed, "front", 30 * 60, moment);
    let field = centred(seed, "cloud field", 5 * 60, moment);
    let cloud = centred(seed, "cloud", 50, moment);
    smooth(0.62 + 0.55 * front + 0.25 * field + 0.1 * cloud)
}

/// Showers under thick clouds; heavy ones are rare.
fn rain(seed: Seed, moment: Span, clouds: f64) -> f64 {
    let thick = ((clouds - climate::RAIN_CLOUDS) / (1.0 - climate::RAIN_CLOUDS)).max(0.0);
    let wet = centred(seed, "wet", 9 * 60, moment) + 0.5 * centred(seed, "shower", 2 * 60, moment);
    let heavy = ((wet - climate::WET) / (1.5 - climate::WET)).max(0.0);
    climate::DOWNPOUR * thick * heavy * heavy
}

/// The season, the hour, of which clouds take the edge, and masses of air.
fn temperature(seed: Seed, moment: Span, clouds: f64) -> f64 {
    let day = moment.0 as f64 / (f64::from(DAY) * TICKS_PER_SECOND as f64);
    let (today, hour) = (day - day.floor(), climate::WARMEST_HOUR / 24.0);
    let season = climate::YEARLY * ((day - climate::WARMEST_DAY) % climate::YEAR / climate::YEAR * TAU).cosine();
    let [clear, overcast] = climate::DAILY;
    let daily = (clear + (overcast - clear) * clouds) * ((today - hour) * TAU).cosine();
    let air = climate::AIR_MASS * centred(seed, "air mass", 66 * 60, moment);
    climate::MEAN + season + daily + air
}

//! Ticks, spans, days and the weather.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::Seed;
use vc_graph::clock::{DAY, DayTime, Span, TICKS_PER_SECOND, Tick, Weather, weather};
use vc_graph::hash::Digester;
use vc_testkit::cases;

#[test]
fn time_stops_at_its_ends() {
    let last = Tick(u64::MAX);
    assert_eq!((last + Span(1), last + Span::MAX, Tick(3) - Span(4)), (last, last, Tick(0)));
    assert_eq!((Span::MAX + Span::MAX, Span::MAX * 3, Tick(3) - Tick(4)), (Span::MAX, Span::MAX, Span(0)));
    let spans = [f64::NAN, f64::NEG_INFINITY, -1.0, 1e-9, 1.0, 1e300].map(Span::from_seconds);
    assert_eq!(spans, [Span(0), Span(0), Span(0), Span(0), Span(60), Span::MAX]);
    let end = DayTime::at(last, DayTime::new(u32::MAX, u32::MAX));
    assert_eq!((end.day(), end.second()), (u32::MAX, DAY - 1));
    weather(Seed(1), last, end);
}

#[test]
fn times_are_read_and_refused_with_an_example() {
    let ticks = |text: &str| text.parse::<Span>().map(|span| span.0);
    for (text, seconds) in
        [("0 s", 0), ("90s", 90), ("1.5 min", 90), (" 2 h ", 7200), ("1 day", 86_400), ("2 days", 172_800)]
    {
        assert_eq!(ticks(text), Ok(seconds * TICKS_PER_SECOND), "{text}");
    }
    for text in ["", "5", "s", "-1 s", "+1 s", "1e3 s", "nan s", "inf s", "1.2.3 s", "2 weeks", "2 H", "1 s 2"] {
        assert!(ticks(text).unwrap_err().to_string().contains("`45 min`"), "{text}");
    }
    let day = |text: &str| text.parse::<DayTime>().map(|time| (time.day(), time.second()));
    for (text, seconds) in [("07:30", 27_000), ("7:30", 27_000), ("00:00:01", 1), (" 23:59:59 ", DAY - 1)] {
        assert_eq!(day(text), Ok((0, seconds)), "{text}");
    }
    assert_eq!(day("day 3, 07:30:05"), Ok((3, 27_005)));
    for text in [
        "",
        ":",
        "7",
        "24:00",
        "07:60",
        "07:30:60",
        "7:30:00:00",
        "-1:30",
        "+1:30",
        "day 3",
        "day x, 07:30",
        "day , 1:00",
        "é7:30",
        "007:30",
    ] {
        assert!(day(text).unwrap_err().to_string().contains("`07:30`"), "{text}");
    }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn times_are_read_as_they_print(ticks in 0..1_u64 << 50, day: u32, second in 0..DAY) {
        prop_assert_eq!(Span(ticks).to_string().parse(), Ok(Span(ticks)));
        let time = DayTime::new(day, second);
        prop_assert_eq!(time.to_string().parse(), Ok(time));
        let written = serde_json::to_string(&time).unwrap();
        prop_assert_eq!(serde_json::from_str::<DayTime>(&written).unwrap(), time);
    }

    #[test]
    fn the_clock_goes_on_in_seconds(ticks: u32, more: u32, start in 0..3 * DAY) {
        let start = DayTime::new(0, start);
        let at = |ticks: u64| DayTime::at(Tick(ticks), start).seconds();
        let both = u64::from(ticks) + u64::from(more);
        prop_assert_eq!(at(both) - start.seconds(), both / TICKS_PER_SECOND);
        prop_assert!(at(both) >= at(u64::from(ticks)));
    }
}

const MINUTE: u64 = 60 * TICKS_PER_SECOND;

/// The weather of a seed, a number of minutes after the first midnight.
fn at_minute(seed: u64, minute: u64) -> Weather {
    weather(Seed(seed), Tick(minute * MINUTE), DayTime::default())
}

fn numbers(weather: Weather) -> [f32; 5] {
    [weather.clouds, weather.rain, weather.wind.x, weather.wind.y, weather.temperature]
}

#[test]
fn weather_has_the_same_bytes_on_every_machine() {
    let mut digest = Digester::new();
    for hour in 0..24 * 14 {
        digest.reals(numbers(at_minute(42, 60 * hour)));
    }
    assert_eq!(digest.digest().to_string(), "51e9f4baeec797fc");
    assert_ne!(at_minute(42, 600), at_minute(43, 600));
}

#[test]
fn weather_is_of_the_moment() {
    for day in [0, 17, 364, 365] {
        let start = DayTime::new(day, 0);
        for minute in [0, 1, 61, 3000] {
            let before = u64::from(day) * 1440 + minute;
            assert_eq!(
                weather(Seed(7), Tick(minute * MINUTE), start),
                at_minute(7, before),
                "day {day}, minute {minute}"
            );
        }
    }
}

#[test]
fn weather_changes_little_within_a_minute_and_not_within_a_tick() {
    // In the order of `numbers`; the documentation promises them.
    let (minute, tick) = ([0.02, 0.6, 1.3, 1.3, 0.1], [1e-4, 2e-3, 2e-3, 2e-3, 1e-3]);
    for seed in 0..8 {
        for now in (0..3 * 1440).map(|minute| seed * 50 * 1440 + minute) {
            let next = Tick(now * MINUTE + 1);
            let (this, soon) = (numbers(at_minute(seed, now)), numbers(at_minute(seed, now + 1)));
            let at_once = numbers(weather(Seed(seed), next, DayTime::default()));
            for (i, ((a, b), c)) in this.into_iter().zip(soon).zip(at_once).enumerate() {
                assert!(
                    (a - b).abs() < minute[i] && (a - c).abs() < tick[i],
                    "seed {seed}, minute {now}: {this:?} {soon:?}"
                );
            }
        }
    }
}

#[test]
fn rain_falls_from_clouds_only_and_all_stays_in_bounds() {
    for seed in 0..20 {
        for hour in 0..24 * 60 {
            let now = at_minute(seed, 60 * hour + seed);
            assert!((0.0..=1.0).contains(&now.clouds) && (0.0..=8.0).contains(&now.rain), "{now:?}");
            assert!(now.rain == 0.0 || now.clouds >= 0.6, "{now:?}");
            assert!(now.wind_speed() < 12.0 && (-25.0..45.0).contains(&now.temperature), "{now:?}");
            let (east, north) = (now.wind_direction().cos(), now.wind_direction().sin());
            assert!(
                (now.wind_speed() * east - now.wind.x).abs() < 1e-4
                    && (now.wind_speed() * north - now.wind.y).abs() < 1e-4
            );
        }
    }
}

fn mean(values: impl Iterator<Item = f32> + Clone) -> f32 {
    values.clone().sum::<f32>() / values.count() as f32
}

/// The figures of a temperate place inland; they are ours, see `climate` in the source.
#[test]
fn a_year_is_that_of_a_temperate_place() {
    for seed in 0..4 {
        let year: Vec<Weather> = (0..24 * 365).map(|hour| at_minute(seed, 60 * hour)).collect();
        let share =
            |test: &dyn Fn(&Weather) -> bool| year.iter().filter(|w| test(w)).count() as f32 / year.len() as f32;
        let temperature = |hours: &dyn Fn(usize) -> bool| {
            mean(
                year.iter()
                    .enumerate()
                    .filter(|(hour, _)| hours(*hour))
                    .map(|(_, w)| w.temperature)
                    .collect::<Vec<_>>()
                    .into_iter(),
            )
        };
        let (clouds, rain) = (mean(year.iter().map(|w| w.clouds)), mean(year.iter().map(|w| w.rain)) * 24.0 * 365.0);
        let (rainy, clear) = (share(&|w| w.rain >= 0.1), share(&|w| w.clouds < 0.1));
        let wind = mean(year.iter().map(Weather::wind_speed));
        assert!((0.54..0.68).contains(&clouds) && clear > 0.05, "clouds {clouds}, clear {clear}");
        assert!((600.0..1000.0).contains(&rain) && (0.07..0.13).contains(&rainy), "{rain} mm in {rainy} of the hours");
        assert!((3.4..4.4).contains(&wind), "{wind} m/s");
        assert!((temperature(&|_| true) - 10.0).abs() < 1.5);
        let (winter, summer) = (temperature(&|h| h < 24 * 31), temperature(&|h| (24 * 181..24 * 212).contains(&h)));
        assert!(summer - winter > 12.0, "{winter} {summer}");
        let (night, afternoon) = (temperature(&|h| h % 24 == 4), temperature(&|h| h % 24 == 15));
        assert!((3.0..10.0).contains(&(afternoon - night)), "{night} {afternoon}");
    }
}

//! Demand: the people of a city, where they live, and the journeys that they mean to make in a week.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;
use vc_graph::clock::DAY;
use vc_map::EntranceId;

/// The days of a week, as they are written. Day 0 is a Monday.
const DAYS: [&str; 7] = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"];

/// The reason for a journey: what somebody does at its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Errand {
    /// To be at home.
    Home,
    /// To work.
    Work,
    /// To learn.
    School,
    /// To shop, or to have something done.
    Shop,
    /// To meet others, do sports, eat out.
    Leisure,
}

impl Errand {
    const WORDS: [(Self, &'static str); 5] = [
        (Self::Home, "home"),
        (Self::Work, "work"),
        (Self::School, "school"),
        (Self::Shop, "shop"),
        (Self::Leisure, "leisure"),
    ];
}

impl fmt::Display for Errand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = Self::WORDS.iter().find(|(errand, _)| errand == self);
        f.write_str(word.map_or("", |(_, word)| word))
    }
}

impl FromStr for Errand {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let known = Self::WORDS.iter().find(|(_, known)| *known == word);
        let words = || Self::WORDS.map(|(_, known)| known).join(", ");
        known.map(|(errand, _)| *errand).ok_or_else(|| format!("`{}` is none of: {}", vc_graph::clip(word), words()))
    }
}

/// A journey that somebody means to make each week.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outing {
    /// The day, from 0 for Monday to 6.
    pub day: u8,
    /// When it begins, seconds since midnight; later if one has not come back from the one before.
    pub leaves: u32,
    /// The door at its end.
    pub to: EntranceId,
    /// The reason.
    pub errand: Errand,
    /// Whether it is made in one's car, and not on foot.
    pub by_car: bool,
}

/// Somebody with a home and a week.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Resident {
    /// The door of their home, where they are at first, and their car.
    pub home: EntranceId,
    /// Whether they have a car.
    pub car: bool,
    /// Their journeys, in the order of their times.
    pub week: Vec<Outing>,
}

/// The people of a city and their weeks: made of its land use ([`Demand::of_land_use`]), read from a table of one's own ([`Demand::read`]), or
/// put together. It prints as its table.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Demand {
    /// The people; the position of each is their number.
    pub people: Vec<Resident>,
}

/// A line of a table of demand, or of land use, that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("line {line} of the table: {reason}")]
pub struct DemandError {
    /// The line, from one.
    pub line: usize,
    /// The reason.
    pub reason: String,
}

/// The lines of a table that hold something, with their numbers from one; `#` begins a comment.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, Vec<&str>)> {
    let words = |line| str::split_whitespace(str::split(line, '#').next().unwrap_or("")).collect::<Vec<&str>>();
    let lines = text.lines().enumerate().map(move |(number, line)| (number + 1, words(line)));
    lines.filter(|(_, words)| !words.is_empty())
}

impl Demand {
    /// Demand as a table: a line `home DOOR car` or `home DOOR` for each person, and below it one for each journey of their week: days, time, reason,
    /// door, and `car` or `foot`. Days are a range or a list (`mon-fri`, `sat,sun`); `#` begins a comment.
    ///
    /// ```
    /// use vc_traffic::{Demand, Errand};
    /// let demand = Demand::read("
    ///     home 12 car
    ///     mon-fri 07:45 work 3 car
    ///     mon-fri 16:30 home 12 car
    ///     sat,sun 10:00 shop 5 foot   # and back
    ///     sat,sun 11:00 home 12 foot
    /// ")?;
    /// let week = &demand.people[0].week;
    /// assert_eq!((week.len(), week[0].leaves, week[10].errand), (14, 27_900, Errand::Shop));
    /// assert_eq!(Demand::read(&demand.to_string())?, demand);
    /// assert!(Demand::read("mon 07:45 work 3 car").is_err_and(|error| error.line == 1));
    /// # Ok::<(), vc_traffic::DemandError>(())
    /// ```
    ///
    /// # Errors
    /// [`DemandError`]: the first line with other words, a time that is none, a journey before the first home.
    pub fn read(text: &str) -> Result<Self, DemandError> {
        let mut people: Vec<Resident> = Vec::new();
        for (line, words) in lines(text) {
            let fault = |reason| DemandError { line, reason };
            match words[..] {
                ["home", door, ..] => people.push(home(door, &words[2..]).map_err(fault)?),
                _ => {
                    let person = people.last_mut();
                    let person =
                        person.ok_or_else(|| fault("a journey of nobody: begin with `home DOOR`".to_owned()))?;
                    person.week.extend(outings(&words).map_err(fault)?);
                }
            }
        }
        people.iter_mut().for_each(|person| person.week.sort_by_key(|outing| (outing.day, outing.leaves)));
        Ok(Self { people })
    }
}

fn door(word: &str) -> Result<EntranceId, String> {
    word.parse().map(EntranceId).map_err(|_| format!("door `{}`: give the number of an entrance", vc_graph::clip(word)))
}

fn home(number: &str, rest: &[&str]) -> Result<Resident, String> {
    let car = match rest {
        [] => false,
        ["car"] => true,
        _ => return Err("give `home DOOR`, or `home DOOR car`".to_owned()),
    };
    Ok(Resident { home: door(number)?, car, week: Vec::new() })
}

fn outings(words: &[&str]) -> Result<impl Iterator<Item = Outing> + use<>, String> {
    let [days, time, errand, to, by] = words[..] else {
        return Err(format!("{} words: give days, time, reason, door, and `car` or `foot`", words.len()));
    };
    let by_car = match by {
        "car" => true,
        "foot" => false,
        _ => return Err(format!("`{}` is neither `car` nor `foot`", vc_graph::clip(by))),
    };
    let (leaves, errand, to) = (seconds(time)?, errand.parse()?, door(to)?);
    let days = self::days(days)?;
    Ok(days.into_iter().map(move |day| Outing { day, leaves, to, errand, by_car }))
}

fn day(word: &str) -> Result<u8, String> {
    let known = DAYS.iter().position(|known| *known == word);
    known.map(|day| day as u8).ok_or_else(|| format!("`{}` is none of: {}", vc_graph::clip(word), DAYS.join(", ")))
}

fn days(words: &str) -> Result<Vec<u8>, String> {
    let mut all = Vec::new();
    for part in words.split(',') {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let (first, last) = (day(first)?, day(last)?);
        if first > last {
            return Err(format!("`{part}` ends before it begins: weeks begin on `mon`"));
        }
        all.extend(first..=last);
    }
    Ok(all)
}

/// A time of the day as seconds.
fn seconds(word: &str) -> Result<u32, String> {
    let fault = || format!("time `{}`: give hours and minutes, such as 07:45", vc_graph::clip(word));
    let numbers: Option<Vec<u32>> = word.split(':').map(|part| part.parse().ok().filter(|n| *n < 60)).collect();
    let seconds = match numbers.ok_or_else(fault)?[..] {
        [hours, minutes] => hours * 3600 + minutes * 60,
        [hours, minutes, seconds] => hours * 3600 + minutes * 60 + seconds,
        _ => return Err(fault()),
    };
    if seconds < DAY { Ok(seconds) } else { Err(fault()) }
}

impl fmt::Display for Demand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for person in &self.people {
            writeln!(f, "home {}{}", person.home.0, if person.car { " car" } else { "" })?;
            for Outing { day, leaves, to, errand, by_car } in &person.week {
                let [hours, minutes, seconds] = [leaves / 3600, leaves / 60 % 60, leaves % 60];
                let day = DAYS.get(usize::from(*day)).copied().unwrap_or("day beyond the week");
                let by = if *by_car { "car" } else { "foot" };
                writeln!(f, "{day} {hours:02}:{minutes:02}:{seconds:02} {errand} {} {by}", to.0)?;
            }
        }
        Ok(())
    }
}

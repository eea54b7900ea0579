//! Kinds of vehicles as a table of numbers, which users can replace.

use thiserror::Error;
use vc_map::Users;

const BUILT_IN: &str = include_str!("../data/vehicles.txt");

/// A kind of vehicle: how it is driven, and its size.
///
/// ```
/// use vc_traffic::VehicleClass;
/// let classes = VehicleClass::built_in();
/// let bus = classes.iter().find(|class| class.name == "bus").ok_or("a bus")?;
/// assert!(bus.length == 12.0 && bus.acceleration < classes[0].acceleration);
/// // A table of one's own.
/// let own = VehicleClass::read("tram 1.0 0.0 20 2 3 1.0 1.2 30 2.65 bus")?;
/// assert_eq!(own[0].name, "tram");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleClass {
    /// Its name.
    pub name: String,
    /// The desired speed as a share of the limit.
    pub share: f32,
    /// The deviation of this share among drivers.
    pub deviation: f32,
    /// The most that it goes, metres per second.
    pub top_speed: f32,
    /// The time gap to the vehicle ahead, seconds.
    pub time_gap: f32,
    /// The gap at a standstill, metres.
    pub standing_gap: f32,
    /// Acceleration, metres per second squared.
    pub acceleration: f32,
    /// Comfortable deceleration, metres per second squared.
    pub deceleration: f32,
    /// Its length, metres.
    pub length: f32,
    /// Its width, metres.
    pub width: f32,
    /// The lanes that it may use: those of cars or of buses.
    pub users: Users,
}

/// A line of a table of vehicles that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("line {line} of the table of vehicles: {reason}")]
pub struct ClassError {
    /// The line, from one.
    pub line: usize,
    /// The reason.
    pub reason: String,
}

impl VehicleClass {
    /// Its numbers, in the order of the table.
    pub(crate) fn numbers(&self) -> [f32; 9] {
        let Self {
            share, deviation, top_speed, time_gap, standing_gap, acceleration, deceleration, length, width, ..
        } = *self;
        [share, deviation, top_speed, time_gap, standing_gap, acceleration, deceleration, length, width]
    }

    /// The built-in kinds: car, van, truck, bus, motorcycle.
    pub fn built_in() -> Vec<Self> {
        Self::read(BUILT_IN).unwrap_or_default()
    }

    /// Kinds as a table: a line each with a name, nine numbers and `car` or `bus`, in the order of the fields; `#` begins a comment.
    ///
    /// # Errors
    /// [`ClassError`]: the first line with too few or too many words, a number out of its range, or other users.
    pub fn read(text: &str) -> Result<Vec<Self>, ClassError> {
        let lines = text.lines().enumerate().map(|(number, line)| (number + 1, line.split('#').next().unwrap_or("")));
        let lines = lines.filter(|(_, line)| !line.trim().is_empty());
        lines.map(|(line, text)| class(text).map_err(|reason| ClassError { line, reason })).collect()
    }
}

fn class(text: &str) -> Result<VehicleClass, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let [name, numbers @ .., users] = &words[..] else { return Err("a name, nine numbers and `car` or `bus`".into()) };
    let ranges: [(&str, f32, f32); 9] = [
        ("share", 0.1, 3.0),
        ("deviation", 0.0, 0.3),
        ("top speed", 0.5, 100.0),
        ("time gap", 0.1, 10.0),
        ("standing gap", 0.5, 20.0),
        ("acceleration", 0.1, 10.0),
        ("deceleration", 0.1, 9.0),
        ("length", 0.5, 40.0),
        ("width", 0.3, 3.5),
    ];
    if numbers.len() != ranges.len() {
        return Err(format!("{} numbers, and nine are needed", numbers.len()));
    }
    let mut values = [0.0; 9];
    for ((value, word), (what, low, high)) in values.iter_mut().zip(numbers).zip(ranges) {
        let read = word.parse::<f32>().ok().filter(|number| (low..=high).contains(number));
        *value = read.ok_or_else(|| format!("the {what} `{word}` is no number from {low} to {high}"))?;
    }
    let users = match *users {
        "car" => Users::CAR,
        "bus" => Users::BUS,
        other => return Err(format!("users `{other}` are neither `car` nor `bus`")),
    };
    let [share, deviation, top_speed, time_gap, standing_gap, acceleration, deceleration, length, width] = values;
    Ok(VehicleClass {
        name: (*name).to_owned(),
        share,
        deviation,
        top_speed,
        time_gap,
        standing_gap,
        acceleration,
        deceleration,
        length,
        width,
        users,
    })
}

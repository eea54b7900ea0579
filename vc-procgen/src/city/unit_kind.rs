//! Kinds of units, from `data/units.txt`.

use std::sync::LazyLock;

/// The uses of a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum UnitPlace {
    /// A home.
    Home,
    /// An office.
    Office,
    /// A unit of a ground storey with a door to the street.
    Shop,
    /// A hall of its own.
    Hall,
    /// A public building.
    Civic,
}

/// The kind of a unit: its position in the table of kinds.
///
/// ```
/// use vc_procgen::city::UnitKind;
/// let cafe = UnitKind::named("cafe").ok_or("a cafe")?;
/// assert_eq!((cafe.word(), cafe.hours()), ("cafe", Some([7, 19])));
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct UnitKind(u8);

struct Row {
    word: &'static str,
    place: UnitPlace,
    residents: Option<f64>,
    weight: f32,
    hours: Option<[u8; 2]>,
}

static TABLE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    let lines = include_str!("../../data/units.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(row).collect()
});

fn row(line: &'static str) -> Option<Row> {
    let words: Vec<&'static str> = line.split('|').map(str::trim).collect();
    let [word, place, residents, weight, hours] = <[&'static str; 5]>::try_from(words).ok()?;
    let place = match place {
        "home" => UnitPlace::Home,
        "office" => UnitPlace::Office,
        "shop" => UnitPlace::Shop,
        "hall" => UnitPlace::Hall,
        _ => UnitPlace::Civic,
    };
    let hours: Vec<u8> = hours.split_whitespace().filter_map(|hour| hour.parse().ok()).collect();
    Some(Row {
        word,
        place,
        residents: residents.parse().ok(),
        weight: weight.parse().ok()?,
        hours: hours.try_into().ok(),
    })
}

impl UnitKind {
    /// A home.
    pub const HOME: Self = Self(0);
    /// An office.
    pub const OFFICE: Self = Self(1);

    fn row(self) -> &'static Row {
        &TABLE[usize::from(self.0)]
    }

    /// All kinds, in the order of the table.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..TABLE.len()).map(|index| Self(index as u8))
    }

    /// The kind of a word, as [`Self::word`] has it.
    pub fn named(word: &str) -> Option<Self> {
        Self::all().find(|kind| kind.word() == word)
    }

    /// Its word.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// Where it is.
    pub fn place(self) -> UnitPlace {
        self.row().place
    }

    /// How many residents one serves; `None` if there are as many as there is room for.
    pub fn residents(self) -> Option<f64> {
        self.row().residents
    }

    pub(super) fn weight(self) -> f32 {
        self.row().weight
    }

    /// The hours at which it opens and closes; homes have none.
    pub fn hours(self) -> Option<[u8; 2]> {
        self.row().hours
    }
}

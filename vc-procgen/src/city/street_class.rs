//! Classes of streets and their cross-sections, from `data/streets.txt`.

use std::sync::LazyLock;

use vc_map::{CrossSection, RoadClass, Strip, StripKind, Users};

/// A class of streets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum StreetClass {
    /// Two lanes each way with a median.
    Boulevard,
    /// A main street of a quarter.
    Avenue,
    /// A street with shops on both sides.
    Shopping,
    /// A street on which people live.
    Residential,
    /// A narrow street with traffic one way.
    Lane,
}

/// The measures of a class, as its line in the table has them.
#[derive(Debug, Clone, PartialEq)]
struct Measures {
    road: RoadClass,
    lanes: usize,
    lane: f64,
    median: f64,
    cycle: f64,
    parking: f64,
    pavement: f64,
    limit: f64,
    corner: f64,
}

static TABLE: LazyLock<Vec<Measures>> = LazyLock::new(|| {
    let lines = include_str!("../../data/streets.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(measures).collect()
});

fn measures(line: &str) -> Option<Measures> {
    let words: Vec<&str> = line.split('|').map(str::trim).collect();
    let number = |column: usize| words.get(column)?.parse::<f64>().ok();
    Some(Measures {
        road: RoadClass::ALL.into_iter().find(|class| Some(&class.word()) == words.get(1))?,
        lanes: number(2)? as usize,
        lane: number(3)?,
        median: number(4)?,
        cycle: number(5)?,
        parking: number(6)?,
        pavement: number(7)?,
        limit: number(8)? / 3.6,
        corner: number(9)?,
    })
}

impl StreetClass {
    /// All of them, the widest first, as the table has them.
    pub const ALL: [Self; 5] = [Self::Boulevard, Self::Avenue, Self::Shopping, Self::Residential, Self::Lane];

    fn measures(self) -> &'static Measures {
        &TABLE[self as usize]
    }

    /// The word in texts and pictures.
    pub fn word(self) -> &'static str {
        match self {
            Self::Boulevard => "boulevard",
            Self::Avenue => "avenue",
            Self::Shopping => "shopping street",
            Self::Residential => "residential street",
            Self::Lane => "one-way lane",
        }
    }

    /// Its class on the map.
    pub fn road(self) -> RoadClass {
        self.measures().road
    }

    /// Whether through traffic and buses use it.
    pub fn is_main(self) -> bool {
        self <= Self::Avenue
    }

    /// Its strips.
    ///
    /// ```
    /// use vc_procgen::city::StreetClass;
    /// let widths = StreetClass::ALL.map(|class| class.section().width());
    /// assert!(widths.is_sorted_by(|a, b| a > b) && (widths[3] - 14.5).abs() < 1e-9);
    /// ```
    pub fn section(self) -> CrossSection {
        let m = self.measures();
        let strip = |kind, width, users| (width > 0.0).then(|| Strip::new(kind, width, users, m.limit));
        let mut side = vec![Strip::driving(m.lane, m.limit); m.lanes];
        side.extend(strip(StripKind::Parking, m.parking, Users::NONE));
        side.extend(strip(StripKind::Cycle, m.cycle, Users::BICYCLE));
        side.push(Strip::pavement(m.pavement));
        let other = if self == Self::Lane { vec![Strip::pavement(m.pavement)] } else { side.clone() };
        CrossSection { forward: side, backward: other, median: m.median }
    }

    /// From the middle of its carriageway to the kerb, metres.
    pub fn kerb(self) -> f64 {
        self.section().surface() / 2.0
    }

    /// From the middle of its carriageway to the building line, metres.
    pub fn edge(self) -> f64 {
        self.kerb() + self.pavement()
    }

    /// The width of its pavements, metres.
    pub fn pavement(self) -> f64 {
        self.measures().pavement
    }

    /// Its speed limit, metres per second.
    pub fn limit(self) -> f64 {
        self.measures().limit
    }

    /// The radius of kerbs at its corners, metres.
    pub fn corner(self) -> f64 {
        self.measures().corner
    }
}

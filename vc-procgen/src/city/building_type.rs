//! Types of buildings, from `data/buildings.txt`.

use std::sync::LazyLock;

/// A type of buildings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum BuildingType {
    /// A house in a garden.
    Detached,
    /// A house between two others.
    Row,
    /// Flats along one stair or several, free on all sides.
    Slab,
    /// Flats along the street with a court behind.
    Perimeter,
    /// Offices along the street.
    Office,
    /// A tower above lower wings.
    Tower,
    /// A large shop, cinema or warehouse.
    Hall,
    /// A school or library.
    Civic,
}

pub(super) struct Measures {
    /// Weights in the core, among flats, homes, and in quarters of work.
    pub(super) weights: [f32; 4],
    /// Width and depth of parcels, metres.
    pub(super) parcel: [f64; 2],
    /// Setbacks at the street and at other sides, metres.
    pub(super) setback: [f64; 2],
    /// The depth of a wing, metres.
    pub(super) depth: f64,
    /// The least, middle and greatest number of storeys.
    pub(super) storeys: [usize; 3],
    /// The heights of the ground storey and of those above, metres.
    pub(super) heights: [f64; 2],
}

static TABLE: LazyLock<Vec<Measures>> = LazyLock::new(|| {
    let lines = include_str!("../../data/buildings.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(measures).collect()
});

fn measures(line: &str) -> Option<Measures> {
    let columns: Vec<Vec<f64>> = line
        .split('|')
        .skip(1)
        .map(|words| words.split_whitespace().filter_map(|word| word.parse().ok()).collect())
        .collect();
    let [weights, parcel, setback, depth, storeys, heights] = <[Vec<f64>; 6]>::try_from(columns).ok()?;
    Some(Measures {
        weights: <[f64; 4]>::try_from(weights).ok()?.map(|weight| weight as f32),
        parcel: parcel.try_into().ok()?,
        setback: setback.try_into().ok()?,
        depth: *depth.first()?,
        storeys: <[f64; 3]>::try_from(storeys).ok()?.map(|count| count as usize),
        heights: heights.try_into().ok()?,
    })
}

impl BuildingType {
    /// All of them, as the table has them.
    pub const ALL: [Self; 8] =
        [Self::Detached, Self::Row, Self::Slab, Self::Perimeter, Self::Office, Self::Tower, Self::Hall, Self::Civic];

    pub(super) fn measures(self) -> &'static Measures {
        &TABLE[self as usize]
    }

    /// How far a building stands from the building line of its street, metres.
    pub fn setback(self) -> f64 {
        self.measures().setback[0]
    }

    /// The word in texts and on maps.
    pub fn word(self) -> &'static str {
        match self {
            Self::Detached => "detached",
            Self::Row => "row",
            Self::Slab => "slab",
            Self::Perimeter => "perimeter",
            Self::Office => "office",
            Self::Tower => "tower",
            Self::Hall => "hall",
            Self::Civic => "civic",
        }
    }

    /// Whether a whole building is one unit.
    pub fn is_whole(self) -> bool {
        matches!(self, Self::Detached | Self::Row | Self::Hall | Self::Civic)
    }

    /// Whether there is a wing along each street.
    pub(super) fn turns_corners(self) -> bool {
        matches!(self, Self::Perimeter | Self::Office | Self::Tower)
    }
}

//! Conflicts at junctions, and the lights that keep them apart.

use crate::JunctionId;

/// Which movements and crossings of a junction are in each other's way: a bit for each pair. Movements come first, by
/// their position in [`Junction::movements`](crate::Junction::movements), then [`Junction::crossings`](crate::Junction::crossings).
///
/// ```
/// use vc_map::ConflictTable;
/// let mut table = ConflictTable::new(3);
/// table.set(0, 2);
/// assert!(table.has(2, 0) && !table.has(0, 1));
/// // A junction in which movement 0 is under way: 2 waits.
/// assert_eq!((0..3).filter(|m| table.free(*m, &[0b001])).collect::<Vec<_>>(), [0, 1]);
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ConflictTable {
    size: usize,
    words: usize,
    bits: Vec<u64>,
}

impl ConflictTable {
    /// A table for a number of movements and crossings, none in another's way. It takes a bit for each pair.
    pub fn new(size: usize) -> Self {
        let words = size.div_ceil(64);
        Self { size, words, bits: vec![0; size * words] }
    }

    /// The number of movements and crossings.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Notes that two are in each other's way; numbers beyond the table are passed over.
    pub fn set(&mut self, one: usize, other: usize) {
        self.put(one, other, true);
    }

    /// Notes that two are not in each other's way.
    pub fn clear(&mut self, one: usize, other: usize) {
        self.put(one, other, false);
    }

    fn put(&mut self, one: usize, other: usize, bit: bool) {
        for (row, column) in [(one, other), (other, one)] {
            if row < self.size && column < self.size {
                let word = &mut self.bits[row * self.words + column / 64];
                *word = *word & !(1 << (column % 64)) | u64::from(bit) << (column % 64);
            }
        }
    }

    /// Whether two are in each other's way.
    pub fn has(&self, one: usize, other: usize) -> bool {
        one < self.size && other < self.size && self.bits[one * self.words + other / 64] >> (other % 64) & 1 == 1
    }

    /// Whether one is in the way of none of those whose bits are set, the lowest bit of the first word being number 0. Costs a
    /// step for each 64 movements; numbers beyond the table are never free.
    pub fn free(&self, one: usize, busy: &[u64]) -> bool {
        one < self.size
            && self.bits[one * self.words..][..self.words].iter().zip(busy).all(|(row, busy)| row & busy == 0)
    }

    pub(crate) fn bytes(&self) -> usize {
        self.bits.capacity() * size_of::<u64>()
    }

    /// All pairs, the smaller number first. Costs the square of the size.
    ///
    /// ```
    /// let mut table = vc_map::ConflictTable::new(3);
    /// table.set(2, 0);
    /// assert_eq!(table.pairs().collect::<Vec<_>>(), [(0, 2)]);
    /// ```
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.size).flat_map(move |one| {
            (one + 1..self.size).filter(move |other| self.has(one, *other)).map(move |other| (one, other))
        })
    }
}

/// The light for a movement or crossing in a phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Light {
    /// Wait.
    Red,
    /// Go; nobody who conflicts has green as well.
    Green,
    /// Go, and give way to those who conflict.
    GreenYield,
    /// Stop if that is possible.
    Yellow,
}

/// A phase of a signal: the lights that show for some time.
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    /// How long it lasts, seconds.
    pub seconds: f64,
    /// The light of each movement and crossing of the junction, in the order of its conflict table.
    pub lights: Vec<Light>,
}

/// A signal with fixed times, which begin with the first phase.
///
/// ```
/// use vc_map::Light;
/// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, Strip};
/// # let mut draft = MapDraft::new("corner", 48.1, 11.6);
/// # let middle = draft.junction([0.0, 0.0], Control::Signals);
/// # for at in [[-100.0, 0.0], [100.0, 0.0], [0.0, 100.0]] {
/// #     let (end, side) = (draft.junction(at, Control::Edge), vec![Strip::driving(3.0, 8.3), Strip::pavement(2.4)]);
/// #     let section = CrossSection { forward: side.clone(), backward: side, median: 0.0 };
/// #     draft.road(end, middle, RoadClass::Residential, section);
/// # }
/// # let map = draft.build()?; // streets to the west, east and north
/// let signal = &map.signals()[0];
/// let green = |row: usize| -> f64 {
///     let phases = signal.phases.iter().filter(|phase| matches!(phase.lights[row], Light::Green | Light::GreenYield));
///     phases.map(|phase| phase.seconds).sum()
/// };
/// let size = map.junction(signal.junction).map_or(0, |junction| junction.conflicts.size());
/// assert!(size > 6 && (0..size).all(|row| green(row) > 0.0 && green(row) < signal.cycle()));
/// # Ok::<(), vc_map::MapError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Signal {
    /// Its junction.
    pub junction: JunctionId,
    /// Its phases, which follow each other without end.
    pub phases: Vec<Phase>,
}

impl Signal {
    /// The time of all phases, seconds.
    pub fn cycle(&self) -> f64 {
        self.phases.iter().map(|phase| phase.seconds).sum()
    }
}

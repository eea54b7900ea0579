//! Comparison of the measured statistics with those of real homes, and the report.

use std::fmt::Write;

use serde::Serialize;

use super::zone::pair;
use super::{Histogram, Statistics, Zone, reference};
use crate::plan::RoomKind;

/// The tolerance of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Tolerance {
    /// The relative difference allowed.
    Relative(f64),
    /// The absolute difference allowed.
    Absolute(f64),
    /// The reference is a lower bound.
    AtLeast,
    /// No requirement; the value is only shown.
    None,
}

/// A measured value and that of real homes.
///
/// ```
/// use vc_procgen::statistics::Statistics;
/// let empty = Statistics::default().compare();
/// assert!(empty.iter().all(|comparison| comparison.measured.is_none() && comparison.holds().is_none()));
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ReferenceComparison {
    /// The name of the quantity.
    pub quantity: String,
    /// The measured value; `None` where no home has one.
    pub measured: Option<f64>,
    /// The value of real homes.
    pub reference: f64,
    /// The tolerance.
    pub tolerance: Tolerance,
}

impl ReferenceComparison {
    /// Whether the tolerance is kept; `None` where there is nothing to compare.
    pub fn holds(&self) -> Option<bool> {
        let (measured, off) = (self.measured?, self.difference()?);
        match self.tolerance {
            Tolerance::Relative(share) => Some(off.abs() <= share * self.reference),
            Tolerance::Absolute(most) => Some(off.abs() <= most),
            Tolerance::AtLeast => Some(measured >= self.reference),
            Tolerance::None => None,
        }
    }

    /// The measured value minus the reference.
    pub fn difference(&self) -> Option<f64> {
        Some(self.measured? - self.reference)
    }

    fn row(&self) -> String {
        let figure = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:.2}"));
        let off = match (self.difference(), self.tolerance) {
            (Some(d), Tolerance::Relative(_)) => format!("{:+.1} %", 100.0 * d / self.reference),
            (Some(d), _) => format!("{d:+.2}"),
            (None, _) => "-".to_owned(),
        };
        let tolerance = match self.tolerance {
            Tolerance::Relative(share) => format!("within {:.0} %", 100.0 * share),
            Tolerance::Absolute(most) => format!("within {most:.2}"),
            Tolerance::AtLeast => format!("at least {:.2}", self.reference),
            Tolerance::None => String::new(),
        };
        let verdict = self.holds().map_or("", |holds| if holds { "yes" } else { "NO" });
        let (measured, reference) = (figure(self.measured), figure(Some(self.reference)));
        format!("| {} | {measured} | {reference} | {off} | {tolerance} | {verdict} |", self.quantity)
    }
}

impl Statistics {
    /// Compares with real homes: median areas, shares of plans with walls and doors between kinds
    /// of rooms, windows.
    ///
    /// All values but those of windows are taken from homes with two or three bedrooms and as many
    /// bathrooms, as most of the real homes have.
    pub fn compare(&self) -> Vec<ReferenceComparison> {
        let mut all = self.area_medians();
        all.extend(self.pairs().into_iter().map(|(_, comparison)| comparison));
        all.extend(self.windows());
        all.extend(reference::DOORS_PER_ROOM.map(|(zone, reference)| ReferenceComparison {
            quantity: format!("doors per {}", zone.name()),
            measured: self.comparable.doors_of(zone),
            reference,
            tolerance: Tolerance::None,
        }));
        all
    }

    fn area_medians(&self) -> Vec<ReferenceComparison> {
        let medians = reference::AREAS.map(|(zone, [_, median, _])| ReferenceComparison {
            quantity: format!("{} area, median m²", zone.name()),
            measured: self.comparable.areas.get(&zone).and_then(|s| s.quantile(0.5)).map(f64::from),
            reference: f64::from(median),
            tolerance: Tolerance::Relative(0.15),
        });
        medians.into()
    }

    /// Walls, doors and passages, each with its type.
    pub(super) fn pairs(&self) -> Vec<(&'static str, ReferenceComparison)> {
        let sample = &self.comparable;
        let of = |kind: &'static str, counts, (a, b, reference): (Zone, Zone, f64)| {
            let measured = sample.share(counts, a, b);
            (
                kind,
                ReferenceComparison {
                    quantity: format!("{kind} {}", pair(a, b)),
                    measured,
                    reference,
                    tolerance: Tolerance::Absolute(0.05),
                },
            )
        };
        let mut pairs: Vec<_> = reference::WALLS.map(|p| of("wall", &sample.walls, p)).into();
        pairs.extend(reference::DOORS.map(|p| of("door", &sample.doors, p)));
        pairs.extend(reference::PASSAGES.map(|p| of("open", &sample.passages, p)));
        pairs
    }

    fn windows(&self) -> Vec<ReferenceComparison> {
        let kinds = [RoomKind::Living, RoomKind::Bedroom, RoomKind::Kids];
        let rows = kinds.map(|kind| ReferenceComparison {
            quantity: format!("{} with window or balcony door", kind.title().to_lowercase()),
            measured: self.glazed(kind),
            reference: reference::WINDOWED,
            tolerance: Tolerance::AtLeast,
        });
        rows.into()
    }

    /// The report as Markdown: a description of the homes, and the comparison.
    pub fn report(&self) -> String {
        let mut text = String::from("# Statistics\n\n");
        // Writing to a string does not fail.
        let _ = self.write_homes(&mut text);
        let _ = self.write_rooms(&mut text);
        let _ = self.write_comparison(&mut text);
        text
    }

    fn write_homes(&self, text: &mut String) -> std::fmt::Result {
        writeln!(text, "{} homes, p5 - median - p95 of each:\n", self.homes)?;
        writeln!(text, "- rooms: {}", three(&self.rooms_per_home, 0))?;
        writeln!(text, "- net area: {} m²", three(&self.area, 1))?;
        writeln!(text, "- objects: {}", three(&self.objects_per_home, 0))?;
        writeln!(text, "- of these on or in others: {}\n", three(&self.small_per_home, 0))?;
        let share = |n: &u64| 100.0 * *n as f64 / self.homes.max(1) as f64;
        let list = |parts: Vec<String>| if parts.is_empty() { "-".to_owned() } else { parts.join(", ") };
        let schemes = self.schemes.iter().map(|(name, n)| format!("{name} {:.1} %", share(n)));
        writeln!(text, "Schemes: {}.\n", list(schemes.collect()))?;
        for (what, counts) in [("Bedrooms", &self.bedrooms), ("Bathrooms", &self.bathrooms)] {
            let parts = counts.iter().map(|(count, n)| format!("{count}: {:.1} %", share(n)));
            writeln!(text, "{what}: {}.\n", list(parts.collect()))?;
        }
        Ok(())
    }

    fn write_rooms(&self, text: &mut String) -> std::fmt::Result {
        writeln!(text, "## Rooms of all homes\n\np5 - median - p95.\n")?;
        writeln!(text, "| room | count | area m² | aspect | doors and passages | window | or balcony door |")?;
        writeln!(text, "|---|---|---|---|---|---|---|")?;
        for (kind, room) in &self.rooms {
            let (count, area, aspect) = (room.area.count(), three(&room.area, 1), three(&room.aspect, 2));
            let share = |n: u64| 100.0 * n as f64 / count.max(1) as f64;
            let (ways, windowed, glazed) = (three(&room.ways, 0), share(room.windowed), share(room.glazed));
            writeln!(text, "| {kind} | {count} | {area} | {aspect} | {ways} | {windowed:.1} % | {glazed:.1} % |")?;
        }
        writeln!(text)
    }

    fn write_comparison(&self, text: &mut String) -> std::fmt::Result {
        let homes = self.comparable.homes;
        writeln!(text, "## Beside real homes\n\nReference: {}.\n", reference::SOURCE)?;
        writeln!(
            text,
            "Ours: the {homes} homes with two or three bedrooms and as many bathrooms; windows: all homes.\n"
        )?;
        writeln!(
            text,
            "| quantity | measured | reference | difference | tolerance | kept |\n|---|---|---|---|---|---|"
        )?;
        self.compare().iter().try_for_each(|c| writeln!(text, "{}", c.row()))
    }
}

/// The 5th percentile, median and 95th percentile.
fn three(spread: &Histogram, digits: usize) -> String {
    let at = |share| spread.quantile(share).map_or_else(|| "?".to_owned(), |v| format!("{v:.digits$}"));
    format!("{} - {} - {}", at(0.05), at(0.5), at(0.95))
}

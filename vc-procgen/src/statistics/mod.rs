//! Statistics of many apartments, and their comparison with real homes.
//!
//! [`Statistics`] are built by adding one apartment after another; those of subsets
//! [merge](Statistics::merge) to those of the whole set, in any order. Plans of real homes mostly
//! have two or three bedrooms and as many bathrooms, so only homes with the same numbers are
//! [compared](Statistics::compare) with them.
//!
//! ```
//! use vc_graph::Seed;
//! use vc_procgen::Specification;
//! use vc_procgen::plan::FloorPlan;
//! use vc_procgen::statistics::Statistics;
//!
//! let mut statistics = Statistics::default();
//! for seed in 0..20 {
//!     statistics.add_plan(&FloorPlan::generate(&Specification::with_bedrooms(2), Seed(seed))?);
//! }
//! assert_eq!(statistics.homes, 20);
//! assert!(statistics.report().contains("| bedroom"));
//! # Ok::<(), vc_procgen::SpecificationError>(())
//! ```

mod compare;
mod histogram;
mod plot;
mod reference;
mod zone;
mod zone_statistics;

pub use compare::{ReferenceComparison, Tolerance};
pub use histogram::Histogram;
pub use zone::Zone;
pub use zone_statistics::ZoneStatistics;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::apartment::Apartment;
use crate::item::Support;
use crate::plan::{FloorPlan, OpeningKind, RoomKind};

/// The bin width of areas, m².
const AREA: f32 = 0.05;

/// Statistics of apartments.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// The number of apartments.
    pub homes: u64,
    /// The number of apartments of each scheme.
    pub schemes: BTreeMap<String, u64>,
    /// The number of apartments for each number of bedrooms.
    pub bedrooms: BTreeMap<u32, u64>,
    /// The number of apartments for each number of bathrooms.
    pub bathrooms: BTreeMap<u32, u64>,
    /// Rooms per home, balconies included.
    pub rooms_per_home: Histogram,
    /// Objects per home, without the building itself.
    pub objects_per_home: Histogram,
    /// Objects per home that rest on or in others.
    pub small_per_home: Histogram,
    /// The net area of a home without balconies, m².
    pub area: Histogram,
    /// Statistics of rooms by kind.
    pub rooms: BTreeMap<String, RoomStatistics>,
    /// Areas and adjacency of the zones of all homes.
    pub all: ZoneStatistics,
    /// The same for homes that resemble the plans of real homes.
    pub comparable: ZoneStatistics,
}

/// Statistics of the rooms of one kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoomStatistics {
    /// The net area, m²; its count is the number of rooms.
    pub area: Histogram,
    /// The ratio of the longer to the shorter side of the room's bounding rectangle.
    pub aspect: Histogram,
    /// Doors and passages per room.
    pub ways: Histogram,
    /// The number of rooms that have a window.
    pub windowed: u64,
    /// The number of rooms that have a window or a balcony door.
    pub glazed: u64,
}

impl Default for Statistics {
    fn default() -> Self {
        Self {
            homes: 0,
            schemes: BTreeMap::new(),
            bedrooms: BTreeMap::new(),
            bathrooms: BTreeMap::new(),
            rooms_per_home: Histogram::new(1.0),
            objects_per_home: Histogram::new(1.0),
            small_per_home: Histogram::new(1.0),
            area: Histogram::new(AREA),
            rooms: BTreeMap::new(),
            all: ZoneStatistics::default(),
            comparable: ZoneStatistics::default(),
        }
    }
}

impl Default for RoomStatistics {
    fn default() -> Self {
        let (area, aspect, ways) = (Histogram::new(AREA), Histogram::new(0.01), Histogram::new(1.0));
        Self { area, aspect, ways, windowed: 0, glazed: 0 }
    }
}

impl Statistics {
    /// Adds an apartment.
    ///
    /// Costs some microseconds.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// use vc_procgen::statistics::Statistics;
    /// let mut statistics = Statistics::default();
    /// statistics.add(&Apartment::from_seed(Seed(7))?);
    /// assert!(statistics.objects_per_home.mean().is_some_and(|objects| objects > 30.0));
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn add(&mut self, home: &Apartment) {
        self.add_plan(&home.plan);
        let objects = || home.items.iter().filter(|i| i.support != Support::Built);
        let small = objects().filter(|i| matches!(i.support, Support::On(..) | Support::Inside(..)));
        self.small_per_home.add(small.count() as f32);
        self.objects_per_home.add(objects().count() as f32);
    }

    /// Adds a plan without furniture.
    pub fn add_plan(&mut self, plan: &FloorPlan) {
        let count = |f: fn(RoomKind) -> bool| plan.rooms.iter().filter(|r| f(r.kind)).count() as u32;
        let (bedrooms, bathrooms) = (count(RoomKind::is_bedroom), count(|k| k == RoomKind::Bathroom));
        self.homes += 1;
        *self.schemes.entry(plan.scheme.title().to_owned()).or_default() += 1;
        *self.bedrooms.entry(bedrooms).or_default() += 1;
        *self.bathrooms.entry(bathrooms).or_default() += 1;
        self.rooms_per_home.add(plan.rooms.len() as f32);
        self.area.add(plan.area());
        for (index, room) in plan.rooms.iter().enumerate() {
            self.rooms.entry(room.kind.title().to_owned()).or_default().add(plan, index);
        }
        self.all.add(plan);
        if matches!(bedrooms, 2 | 3) && bathrooms == bedrooms {
            self.comparable.add(plan);
        }
    }

    /// Adds the statistics of other apartments.
    pub fn merge(&mut self, other: &Self) {
        self.homes += other.homes;
        add_counts(&mut self.schemes, &other.schemes);
        add_counts(&mut self.bedrooms, &other.bedrooms);
        add_counts(&mut self.bathrooms, &other.bathrooms);
        self.rooms_per_home.merge(&other.rooms_per_home);
        self.objects_per_home.merge(&other.objects_per_home);
        self.small_per_home.merge(&other.small_per_home);
        self.area.merge(&other.area);
        for (kind, figures) in &other.rooms {
            self.rooms.entry(kind.clone()).or_default().merge(figures);
        }
        self.all.merge(&other.all);
        self.comparable.merge(&other.comparable);
    }

    /// The share of rooms of a kind that have a window or a balcony door.
    pub fn glazed(&self, kind: RoomKind) -> Option<f64> {
        let figures = self.rooms.get(kind.title())?;
        Some(figures.glazed as f64 / figures.area.count() as f64)
    }
}

impl RoomStatistics {
    fn add(&mut self, plan: &FloorPlan, index: usize) {
        let room = &plan.rooms[index];
        let hull = room.hull().grown(-1);
        self.area.add(room.area());
        self.aspect.add(hull.width().max(hull.depth()) as f32 / hull.short().max(1) as f32);
        self.ways.add(plan.doors_of(index).count() as f32);
        let has = |kind| plan.openings.iter().any(|o| o.kind == kind && o.touches(index));
        let windowed = has(OpeningKind::Window);
        self.windowed += u64::from(windowed);
        self.glazed += u64::from(windowed || has(OpeningKind::BalconyDoor));
    }

    fn merge(&mut self, other: &Self) {
        self.area.merge(&other.area);
        self.aspect.merge(&other.aspect);
        self.ways.merge(&other.ways);
        self.windowed += other.windowed;
        self.glazed += other.glazed;
    }
}

/// Adds counts by key.
fn add_counts<K: Ord + Clone>(to: &mut BTreeMap<K, u64>, from: &BTreeMap<K, u64>) {
    from.iter().for_each(|(key, count)| *to.entry(key.clone()).or_default() += count);
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::Specification;
    use vc_graph::Seed;

    fn of(seeds: std::ops::Range<u64>) -> Statistics {
        let mut statistics = Statistics::default();
        let plans = seeds.filter_map(|seed| FloorPlan::generate(&Specification::default(), Seed(seed)).ok());
        plans.for_each(|plan| statistics.add_plan(&plan));
        statistics
    }

    #[test]
    fn parts_merge_to_the_whole() {
        let mut merged = of(20..60);
        merged.merge(&of(0..20));
        assert_eq!(merged, of(0..60));
    }

    #[test]
    fn json_brings_them_back() {
        let statistics = of(0..30);
        let text = serde_json::to_string(&statistics).unwrap();
        assert_eq!(serde_json::from_str::<Statistics>(&text).unwrap(), statistics);
    }

    #[test]
    fn nothing_yet_is_no_figure() {
        let none = Statistics::default();
        assert!(none.compare().iter().all(|c| c.measured.is_none() && c.holds().is_none()));
        assert!(none.report().contains("0 homes"));
        assert!(none.area_plot().to_svg(900).contains("bedroom"));
    }

    #[test]
    fn turning_changes_nothing() {
        let plan = FloorPlan::generate(&Specification::with_bedrooms(2), Seed(9)).unwrap();
        let of = |plan: &FloorPlan| {
            let mut statistics = Statistics::default();
            statistics.add_plan(plan);
            statistics
        };
        (1..8).for_each(|way| assert_eq!(of(&plan.turned(way)), of(&plan)));
    }
}

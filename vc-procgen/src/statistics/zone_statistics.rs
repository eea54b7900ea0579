//! Areas and adjacency of the zones of homes: shared walls, doors.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::zone::{Zone, pair};
use super::{AREA, Histogram, add_counts};
use crate::plan::{FloorPlan, OpeningKind};

/// The contact length below which rooms do not count as sharing a wall, cells.
const CONTACT: i32 = 6;

/// Statistics by zone over a set of homes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ZoneStatistics {
    /// The number of homes.
    pub homes: u64,
    /// The net area of a home without balconies, m².
    pub area: Option<Histogram>,
    /// The net area by zone: of each room; of living room and halls together.
    pub areas: BTreeMap<Zone, Histogram>,
    /// The number of homes in which rooms of two zones share a wall of 30 cm or more.
    pub walls: BTreeMap<String, u64>,
    /// The number of homes in which a door connects rooms of two zones.
    pub doors: BTreeMap<String, u64>,
    /// The number of homes in which an open passage connects rooms of two zones.
    pub passages: BTreeMap<String, u64>,
    /// The number of doors with a leaf at the rooms of a zone, without the entrance.
    pub door_ends: BTreeMap<Zone, u64>,
}

impl ZoneStatistics {
    pub(super) fn add(&mut self, plan: &FloorPlan) {
        self.homes += 1;
        self.area.get_or_insert_with(|| Histogram::new(AREA)).add(plan.area());
        self.add_areas(plan);
        let zone = |room: Option<usize>| plan.kind_of(room).and_then(Zone::from_room_kind);
        let both = |a, b| zone(a).zip(zone(b)).filter(|&(a, b)| a != b || a != Zone::Living);
        let walls = plan.boundaries().into_iter().filter(|e| e.length() >= CONTACT).filter_map(|e| both(e.low, e.high));
        count(&mut self.walls, walls);
        let ways = |open: bool| {
            let kind = move |k| if open { k == OpeningKind::Passage } else { k != OpeningKind::Passage };
            plan.openings.iter().filter(move |o| kind(o.kind)).filter_map(|o| both(o.low, o.high))
        };
        count(&mut self.doors, ways(false));
        count(&mut self.passages, ways(true));
        for zone in ways(false).flat_map(|(a, b)| [a, b]) {
            *self.door_ends.entry(zone).or_default() += 1;
        }
    }

    fn add_areas(&mut self, plan: &FloorPlan) {
        let mut living = 0.0;
        for room in &plan.rooms {
            match Zone::from_room_kind(room.kind) {
                Some(Zone::Living) => living += room.area(),
                Some(zone) => self.spread(zone).add(room.area()),
                None => {}
            }
        }
        self.spread(Zone::Living).add(living);
    }

    fn spread(&mut self, zone: Zone) -> &mut Histogram {
        self.areas.entry(zone).or_insert_with(|| Histogram::new(AREA))
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.homes += other.homes;
        if let Some(area) = &other.area {
            self.area.get_or_insert_with(|| Histogram::new(AREA)).merge(area);
        }
        other.areas.iter().for_each(|(zone, spread)| self.spread(*zone).merge(spread));
        add_counts(&mut self.walls, &other.walls);
        add_counts(&mut self.doors, &other.doors);
        add_counts(&mut self.passages, &other.passages);
        add_counts(&mut self.door_ends, &other.door_ends);
    }

    /// A count of homes as a share of all; `None` if there are none.
    pub(super) fn share(&self, counts: &BTreeMap<String, u64>, a: Zone, b: Zone) -> Option<f64> {
        let count = counts.get(&pair(a, b)).copied().unwrap_or(0);
        (self.homes > 0).then(|| count as f64 / self.homes as f64)
    }

    /// The mean number of doors per room of a zone.
    pub(super) fn doors_of(&self, zone: Zone) -> Option<f64> {
        let rooms = self.areas.get(&zone)?.count();
        (rooms > 0).then(|| self.door_ends.get(&zone).copied().unwrap_or(0) as f64 / rooms as f64)
    }
}

/// Counts each pair of zones once.
fn count(counts: &mut BTreeMap<String, u64>, pairs: impl Iterator<Item = (Zone, Zone)>) {
    let distinct: BTreeSet<String> = pairs.map(|(a, b)| pair(a, b)).collect();
    distinct.into_iter().for_each(|name| *counts.entry(name).or_default() += 1);
}

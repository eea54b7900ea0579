//! A uniform grid over the floor plan, for radius queries.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::Arc;

use nalgebra::Point3;

use crate::NodeId;

/// Side of a cell, metres: a home's room spans a few cells, a city some ten thousand.
const CELL: f32 = 2.0;
/// Largest cell number; positions beyond share the outermost cells.
const LIMIT: f32 = 1e6;

type Cell = (i32, i32);

#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    at: Point3<f32>,
    id: NodeId,
}

/// Mixes two small integers; the default hasher costs more than scanning a cell.
#[derive(Default)]
struct CellHasher(u64);

impl Hasher for CellHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&b| self.write_i32(i32::from(b)));
    }
    fn write_i32(&mut self, value: i32) {
        let mixed = (self.0.rotate_left(26) ^ u64::from(value as u32)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed ^ (mixed >> 29);
    }
}

/// Points by cell. Clones share the cells until they are edited.
#[derive(Debug, Clone, Default)]
pub(crate) struct Grid {
    cells: HashMap<Cell, Arc<Vec<Entry>>, BuildHasherDefault<CellHasher>>,
}

fn coordinate(value: f32) -> i32 {
    (value / CELL).floor().clamp(-LIMIT, LIMIT) as i32
}

fn cell(at: &Point3<f32>) -> Cell {
    (coordinate(at.x), coordinate(at.y))
}

impl Grid {
    pub(crate) fn insert(&mut self, id: NodeId, at: Point3<f32>) {
        let entries = self.cells.entry(cell(&at)).or_default();
        Arc::make_mut(entries).push(Entry { at, id });
    }

    pub(crate) fn remove(&mut self, id: NodeId, at: Point3<f32>) {
        let key = cell(&at);
        let Some(entries) = self.cells.get_mut(&key) else { return };
        let entries = Arc::make_mut(entries);
        entries.retain(|e| e.id != id);
        if entries.is_empty() {
            self.cells.remove(&key);
        }
    }

    /// Nodes whose position is within `radius` of `centre`, in number order.
    pub(crate) fn within(&self, centre: Point3<f32>, radius: f32) -> Vec<NodeId> {
        let mut found = Vec::new();
        if radius < 0.0 || radius.is_nan() {
            return found;
        }
        let near = |e: &&Entry| nalgebra::distance_squared(&e.at, &centre) <= radius * radius;
        let mut scan = |entries: &Arc<Vec<Entry>>| found.extend(entries.iter().filter(near).map(|e| e.id));
        let (low, high) = (centre.map(|v| v - radius), centre.map(|v| v + radius));
        let (from, to) = (cell(&low), cell(&high));
        let span = (i64::from(to.0) - i64::from(from.0) + 1) * (i64::from(to.1) - i64::from(from.1) + 1);
        if span > self.cells.len() as i64 {
            self.cells.values().for_each(&mut scan);
        } else {
            for x in from.0..=to.0 {
                (from.1..=to.1).filter_map(|y| self.cells.get(&(x, y))).for_each(&mut scan);
            }
        }
        found.sort_unstable();
        found
    }
}

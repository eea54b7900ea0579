//! The best assignment of a given number of pairs in a table.

use super::way::{Way, Worth};
use crate::compile::Table;

/// The cells of the best assignment of the needed number of pairs, at most one in each row and
/// column; `None` if fewer pairs are possible. Adds pairs one by one along best augmenting paths
/// (Bellman and Ford on the residual graph), so that the assignment is always the best of its size
/// (Edmonds and Karp 1972). Costs at most need * (rows + columns) * cells, and rows * cells where
/// each cell is one condition.
pub(super) fn best_pairs(table: Table, ways: &[Way], worth: Worth) -> Option<Vec<usize>> {
    let mut pairs = Pairing::new(table, ways, worth);
    for _ in 0..table.need {
        if !pairs.augment() {
            return None;
        }
    }
    Some(pairs.cells())
}

/// A value below every sum.
const NONE: (i64, i64) = (i64::MIN / 4, 0);

struct Pairing {
    rows: usize,
    columns: usize,
    /// The value of each cell; `None` if the cell is not possible.
    values: Vec<Option<(i64, i64)>>,
    /// For each column its row.
    row_of: Vec<Option<usize>>,
    /// For each row its column.
    column_of: Vec<Option<usize>>,
}

impl Pairing {
    fn new(table: Table, ways: &[Way], worth: Worth) -> Self {
        let (rows, columns) = (table.rows as usize, table.columns as usize);
        let values = ways.iter().map(|&way| way.possible.then(|| worth.rank(way))).collect();
        Self { rows, columns, values, row_of: vec![None; columns], column_of: vec![None; rows] }
    }

    fn value(&self, row: usize, column: usize) -> Option<(i64, i64)> {
        self.values[row * self.columns + column]
    }

    /// Adds the pair with the best gain; `false` if none can be added.
    fn augment(&mut self) -> bool {
        // The best gain with which each column can be reached, and the row before it.
        let mut gain = vec![NONE; self.columns];
        let mut from = vec![usize::MAX; self.columns];
        let free: Vec<usize> = (0..self.rows).filter(|&r| self.column_of[r].is_none()).collect();
        for row in free {
            self.relax(row, (0, 0), &mut gain, &mut from);
        }
        for _ in 0..self.rows {
            let mut changed = false;
            for column in 0..self.columns {
                let Some(row) = self.row_of[column].filter(|_| gain[column] > NONE) else { continue };
                let Some((a, b)) = self.value(row, column) else { continue };
                let left = (gain[column].0 - a, gain[column].1 - b);
                changed |= self.relax(row, left, &mut gain, &mut from);
            }
            if !changed {
                break;
            }
        }
        let open = (0..self.columns).filter(|&c| self.row_of[c].is_none() && gain[c] > NONE);
        match open.max_by_key(|&c| gain[c]) {
            Some(column) => {
                self.turn(column, &from);
                true
            }
            None => false,
        }
    }

    /// Improves the columns reached from a row whose gain is `base`.
    fn relax(&self, row: usize, base: (i64, i64), gain: &mut [(i64, i64)], from: &mut [usize]) -> bool {
        let mut changed = false;
        for column in 0..self.columns {
            let Some((a, b)) = self.value(row, column).filter(|_| self.column_of[row] != Some(column)) else {
                continue;
            };
            let reached = (base.0 + a, base.1 + b);
            if reached > gain[column] {
                (gain[column], from[column]) = (reached, row);
                changed = true;
            }
        }
        changed
    }

    /// Applies the path that ends at a free column: each row on it is paired anew.
    fn turn(&mut self, last: usize, from: &[usize]) {
        let mut column = last;
        // A best path visits each row once.
        for _ in 0..=self.rows {
            let row = from[column];
            let before = self.column_of[row].replace(column);
            self.row_of[column] = Some(row);
            match before {
                Some(before) => column = before,
                None => break,
            }
        }
    }

    fn cells(&self) -> Vec<usize> {
        let cell = |(row, column): (usize, &Option<usize>)| column.map(|c| row * self.columns + c);
        self.column_of.iter().enumerate().filter_map(cell).collect()
    }
}

//! What is supposed about one class of things, kind of place by kind of place.

use std::sync::Arc;

use vc_graph::{NodeId, SceneGraph};

use super::stray::stray;
use super::{Kin, Kinds, Row};

/// For each place the chance of what is where habit puts it, and of what is astray.
pub(crate) type Likely = Arc<[[f64; 2]]>;
pub(crate) const HABIT: usize = 0;
pub(crate) const STRAY: usize = 1;

/// For each kind of place how much habit puts there, and how likely it is for what is astray.
#[derive(Debug, Clone)]
pub(crate) struct Weights {
    rows: Vec<Row>,
    /// For each kind of place the rows that speak of it.
    suits: Vec<Vec<usize>>,
    stray: Vec<f64>,
}

impl Weights {
    pub(crate) fn new(rows: Vec<Row>) -> Self {
        Self { rows, suits: Vec::new(), stray: Vec::new() }
    }

    /// Whether habit says anything.
    pub(crate) fn is_habitual(&self) -> bool {
        !self.rows.is_empty()
    }

    /// Takes note of kinds of places that are new.
    pub(crate) fn meet(&mut self, graph: &SceneGraph, id: NodeId, kinds: &Kinds) {
        let new = &kinds.all()[self.stray.len()..];
        if new.is_empty() {
            return;
        }
        let kin = Kin::of(graph.classes());
        for kind in new {
            let suiting = |(i, row): (usize, &Row)| kind.suits(graph, row).then_some(i);
            self.suits.push(self.rows.iter().enumerate().filter_map(suiting).collect());
            let home = self.rows.iter().any(|row| kind.is_room(graph, row));
            self.stray.push(stray(graph, &kin, id, kind, home));
        }
    }

    /// How likely each place is for a thing that is where habit puts it, and for one that is
    /// not; both sum to one. The weight of a habit is shared by the places it speaks of, that of
    /// a kind of place by the places of the kind. Where no habit speaks of any place, all is astray.
    pub(crate) fn likely(&self, kinds: &Kinds) -> Likely {
        let mut number = vec![0.0; self.rows.len()];
        for (kind, suits) in kinds.all().iter().zip(&self.suits) {
            suits.iter().for_each(|&row| number[row] += kind.number as f64);
        }
        let each = kinds.all().iter().zip(&self.suits).zip(&self.stray).map(|((kind, suits), stray)| {
            let habit: f64 = suits.iter().map(|&row| self.rows[row].weight / number[row]).sum();
            [habit, stray / kind.number as f64]
        });
        let each: Vec<[f64; 2]> = each.collect();
        let sum = |i: usize| kinds.each().map(|kind| each[kind][i]).sum::<f64>();
        let sums = [sum(HABIT), sum(STRAY)];
        let part = |kind: usize| {
            let astray = each[kind][STRAY] / sums[STRAY];
            [if sums[HABIT] > 0.0 { each[kind][HABIT] / sums[HABIT] } else { astray }, astray]
        };
        kinds.each().map(part).collect()
    }
}

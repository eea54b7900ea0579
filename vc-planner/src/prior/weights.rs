//! The weights of kinds of place for the things of one class.

use std::sync::Arc;

use vc_graph::{NodeId, SceneGraph};

use super::stray::stray;
use super::{Kinds, Row};

/// For a place of each kind the chance of what is where habit puts it, and of what is astray.
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
    /// How many of the class have been found at each kind.
    found: Vec<u32>,
}

/// How many must have been found for where they were to count as much as what was supposed.
const DOUBT: f64 = 1.0;

impl Weights {
    pub(crate) fn new(rows: Vec<Row>) -> Self {
        Self { rows, suits: Vec::new(), stray: Vec::new(), found: Vec::new() }
    }

    /// Whether habit says anything.
    pub(crate) fn is_habitual(&self) -> bool {
        !self.rows.is_empty()
    }

    /// Takes note of kinds of places that are new.
    pub(crate) fn meet(&mut self, graph: &SceneGraph, id: NodeId, kinds: &Kinds) {
        for kind in &kinds.all()[self.stray.len()..] {
            let suiting = |(i, row): (usize, &Row)| kind.suits(graph, row).then_some(i);
            self.suits.push(self.rows.iter().enumerate().filter_map(suiting).collect());
            let home = self.rows.iter().any(|row| kind.is_room(graph, row));
            self.stray.push(stray(graph, kinds.related(), id, kind, home));
            self.found.push(0);
        }
    }

    /// One of the class was found at a place of a kind: the others may be at such places as well.
    pub(crate) fn find(&mut self, kind: usize) {
        if let Some(found) = self.found.get_mut(kind) {
            *found += 1;
        }
    }

    /// How likely a place of each kind is for a thing that is where habit puts it, and for one that is
    /// not; over all places both sum to one. The weight of a habit is shared by the places it speaks of, that of
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
        let sum =
            |i: usize| kinds.all().iter().zip(&each).map(|(kind, each)| kind.number as f64 * each[i]).sum::<f64>();
        let sums = [sum(HABIT), sum(STRAY)];
        let (trust, found) = self.like_the_found(kinds);
        let part = |kind: usize| {
            let astray = each[kind][STRAY] / sums[STRAY];
            let supposed = [if sums[HABIT] > 0.0 { each[kind][HABIT] / sums[HABIT] } else { astray }, astray];
            supposed.map(|part| (1.0 - trust) * part + trust * found[kind])
        };
        (0..each.len()).map(part).collect()
    }

    /// How much what has been found of the class counts, and how likely each place of a kind is by
    /// that alone: those on or in the same furniture, in whatever room, share alike.
    fn like_the_found(&self, kinds: &Kinds) -> (f64, Vec<f64>) {
        let mut likely = vec![0.0; kinds.all().len()];
        let all = f64::from(self.found.iter().sum::<u32>());
        if all == 0.0 {
            return (0.0, likely);
        }
        for (kind, found) in kinds.all().iter().zip(&self.found).filter(|(_, found)| **found > 0) {
            let alike = || kinds.all().iter().enumerate().filter(|(_, other)| other.offers_like(kind));
            let number: usize = alike().map(|(_, other)| other.number).sum();
            alike().for_each(|(i, _)| likely[i] += f64::from(*found) / all / number as f64);
        }
        (all / (all + DOUBT), likely)
    }
}

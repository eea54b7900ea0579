//! Beam search: breadth-first with a limited number of states kept.

use super::Search;
use crate::packed::{Op, Problem, State};

impl Search {
    /// Expands, among the states reached by the same number of macros, the `width` most promising. Returns the
    /// cheapest plan found and its cost, if it costs less than `under`.
    pub(super) fn beam(&mut self, problem: &Problem, start: State, width: usize, under: u32) -> Option<(Vec<Op>, u32)> {
        self.begin(problem, start, under, 0, 2);
        let mut best = None;
        loop {
            self.take_layer(width);
            if self.layer.is_empty() {
                return best;
            }
            for i in 0..self.layer.len() {
                let number = self.layer[i] as usize;
                let visit = &self.visits[number];
                if !problem.is_goal(&visit.state) {
                    self.expand(problem, number);
                } else if visit.cost < self.under {
                    self.under = visit.cost;
                    best = Some((self.path(number), self.under));
                }
            }
        }
    }

    /// Takes the most promising of the states just reached; the others are forgotten.
    fn take_layer(&mut self, width: usize) {
        self.layer.clear();
        while self.layer.len() < width {
            let Some(number) = self.next() else { break };
            self.layer.push(number as u32);
        }
        self.open.clear();
    }
}

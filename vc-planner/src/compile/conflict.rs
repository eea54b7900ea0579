//! Detection of conflicting needs.

use vc_graph::Relation;
use vc_graph::goal::largest_matching;

use super::Compiled;
use crate::packed::{Problem, ones};

/// The number of things that can be held at the end.
const HANDS: u32 = Relation::hands().len() as u32;

impl Compiled {
    /// Whether the needs conflict: more things are to be held than there are hands, or there are too few items
    /// for all needs at once if each item serves one. Used to explain why there is no plan. Problems in which
    /// one item can serve two needs are not examined.
    pub(crate) fn conflicts(&self) -> bool {
        let problem = &self.problem;
        let kept: u32 = ones(u64::from(problem.keeps)).map(|n| problem.needs[n].units.count_ones()).sum();
        kept > HANDS || (!problem.shared && !matched(problem, &self.items()))
    }

    /// For each item that is carried or put somewhere, the needs it serves.
    pub(super) fn items(&self) -> Vec<u32> {
        let in_hands = self.start.hands.iter().map(|&h| self.problem.kind(h));
        let pile = |p: &crate::packed::Pile| vec![self.problem.kinds[p.kind as usize]; p.items.len()];
        in_hands.chain(self.problem.piles.iter().flat_map(pile)).collect()
    }
}

/// Whether every unit that must be carried can have an item of its own.
fn matched(problem: &Problem, items: &[u32]) -> bool {
    let serving = |unit: usize| {
        let need = problem.index.need_of[unit];
        (0..items.len()).filter(|&i| items[i] >> need & 1 != 0).collect()
    };
    let rows: Vec<Vec<usize>> = ones(problem.index.carried).map(serving).collect();
    largest_matching(&rows, items.len()) == rows.len()
}

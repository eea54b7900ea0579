//! Whether the needs of a problem ask for more than there is.

use super::Compiled;
use crate::packed::{Problem, ones};

/// How many things can be held in the end.
const HANDS: u32 = 2;

impl Compiled {
    /// Whether the needs conflict: more is to be held than there are hands, or there are
    /// not enough items for all needs at once, each of which serves one. For saying why
    /// there is no plan; where one item can serve two needs it is not looked into.
    pub(crate) fn conflicts(&self) -> bool {
        let problem = &self.problem;
        let kept: u32 = ones(u64::from(problem.keeps)).map(|n| problem.needs[n].units.count_ones()).sum();
        kept > HANDS || (!problem.shared && !matched(problem, &self.items()))
    }

    /// The needs that each item serves that is carried or put somewhere.
    fn items(&self) -> Vec<u32> {
        let in_hands = self.start.hands.iter().map(|&h| self.problem.kind(h));
        let pile = |p: &crate::packed::Pile| vec![self.problem.kinds[p.kind as usize]; p.items.len()];
        in_hands.chain(self.problem.piles.iter().flat_map(pile)).collect()
    }
}

/// Whether every unit that must be carried has an item of its own: a matching, by
/// augmenting paths (Kuhn 1955).
fn matched(problem: &Problem, items: &[u32]) -> bool {
    let mut taken: Vec<Option<usize>> = vec![None; items.len()];
    let units: Vec<usize> = ones(problem.index.carried).map(|u| problem.index.need_of[u] as usize).collect();
    (0..units.len()).all(|unit| assign(unit, &units, items, &mut taken, &mut vec![false; items.len()]))
}

fn assign(unit: usize, units: &[usize], items: &[u32], taken: &mut [Option<usize>], tried: &mut [bool]) -> bool {
    for i in 0..items.len() {
        if tried[i] || items[i] >> units[unit] & 1 == 0 {
            continue;
        }
        tried[i] = true;
        let free = match taken[i] {
            None => true,
            Some(other) => assign(other, units, items, taken, tried),
        };
        if free {
            taken[i] = Some(unit);
            return true;
        }
    }
    false
}

//! Numbers of things, or of pairs of things, for which a part is to hold.

use vc_graph::NodeId;
use vc_graph::goal::{Comparison, Goal, Pairs, Quantified};

use super::{Bindings, Found, View, bind, sift};
use crate::open_condition::{OpenCondition, Subgoal, Unreachable};

/// The required number.
#[derive(Debug, Clone, Copy)]
pub(super) enum Limit {
    AtLeast(usize),
    AtMost(usize),
}

/// Finds the open subgoals under a limit.
type Find<'f> = &'f mut dyn FnMut(Limit) -> Found;

/// The open subgoals of each pair: the indices of the two things, and the ways to make the pair hold.
type Table = Vec<(usize, usize, Vec<Subgoal>)>;

impl View<'_> {
    /// The subgoals for a number that satisfies a comparison.
    pub(super) fn number(&self, comparison: Comparison, number: u32, find: Find<'_>) -> Found {
        let number = number as usize;
        match comparison {
            Comparison::AtLeast => find(Limit::AtLeast(number)),
            Comparison::AtMost => find(Limit::AtMost(number)),
            Comparison::Exactly => Ok([find(Limit::AtMost(number))?, find(Limit::AtLeast(number))?].concat()),
        }
    }

    /// The subgoals for any number that violates a comparison.
    pub(super) fn other_number(&self, goal: &Goal, comparison: Comparison, number: u32, find: Find<'_>) -> Found {
        let more = Limit::AtLeast(number as usize + 1);
        let fewer = |find: Find<'_>| match (number as usize).checked_sub(1) {
            Some(less) => find(Limit::AtMost(less)),
            None => Err(Unreachable::NoInstance(goal.to_string())),
        };
        match comparison {
            Comparison::AtLeast => fewer(find),
            Comparison::AtMost => find(more),
            Comparison::Exactly => {
                let ways = vec![fewer(find), find(more)];
                self.any(goal, ways)
            }
        }
    }

    /// The part for a number of things of a class, or its negation for all but a number: those with the fewest
    /// subgoals.
    pub(super) fn so_many<'g>(&self, goal: &Goal, q: &'g Quantified, limit: Limit, bound: &mut Bindings<'g>) -> Found {
        let (ways, number) = match limit {
            Limit::AtLeast(number) => (self.each(q, bound, |b| self.open(&q.body, b)), number),
            Limit::AtMost(number) => {
                let ways = self.each(q, bound, |b| self.not(&q.body, b));
                let others = ways.len().saturating_sub(number);
                (ways, others)
            }
        };
        let (mut possible, reason) = sift(ways);
        if possible.len() < number {
            return Err(reason.unwrap_or_else(|| Unreachable::NoInstance(goal.to_string())));
        }
        // Ways that only need a look come before ways that would undo something.
        possible.sort_by_key(|way| (matches!(limit, Limit::AtMost(_)) && !is_observation(way), way.len()));
        Ok(possible.into_iter().take(number).flatten().collect())
    }

    /// The number of wanted pairs: if none is given, the number of things of the rarer class.
    pub(super) fn pairs_wanted(&self, pairs: &Pairs) -> (Comparison, u32) {
        pairs.number.unwrap_or_else(|| {
            let [first, second] = self.sides(pairs).map(|side| side.len());
            (Comparison::AtLeast, first.min(second) as u32)
        })
    }

    fn sides(&self, pairs: &Pairs) -> [Vec<NodeId>; 2] {
        [&pairs.first, &pairs.second].map(|side| self.range(side.class.as_deref()))
    }

    /// A number of pairs of things, each thing in at most one pair.
    pub(super) fn pairs<'g>(&self, goal: &Goal, pairs: &'g Pairs, limit: Limit, bound: &mut Bindings<'g>) -> Found {
        let [firsts, seconds] = self.sides(pairs);
        let mut table = |find: &dyn Fn(&mut Bindings<'g>) -> Found| -> (Table, Option<Unreachable>) {
            let (mut table, mut reason) = (Table::new(), None);
            for (i, &a) in firsts.iter().enumerate() {
                for (j, _) in seconds.iter().enumerate().filter(|(_, b)| **b != a) {
                    let with = |b: &mut Bindings<'g>| bind(&pairs.second.name, seconds[j], b, find);
                    match bind(&pairs.first.name, a, bound, with) {
                        Ok(open) => table.push((i, j, open)),
                        Err(why) => reason = reason.or(Some(why)),
                    }
                }
            }
            (table, reason)
        };
        match limit {
            Limit::AtLeast(number) => {
                let (table, reason) = table(&|b| self.open(&pairs.body, b));
                pair_up(pairs, table, [firsts.len(), seconds.len()], number)
                    .ok_or_else(|| reason.unwrap_or_else(|| Unreachable::NoInstance(goal.to_string())))
            }
            Limit::AtMost(number) => {
                let (table, reason) = table(&|b| self.not(&pairs.body, b));
                let mut rows: Vec<Vec<usize>> = vec![(0..seconds.len()).collect(); firsts.len()];
                // These are known to be no pairs.
                for (i, j, _) in table.iter().filter(|(.., open)| open.is_empty()) {
                    rows[*i].retain(|other| other != j);
                }
                for (row, first) in rows.iter_mut().zip(&firsts) {
                    row.retain(|&j| seconds[j] != *first);
                }
                if pairs.pairing.number(&rows, seconds.len()) <= number {
                    return Ok(Vec::new());
                }
                let open = table.into_iter().map(|(.., open)| open).filter(|open| !open.is_empty());
                let (looks, undoing): (Vec<_>, Vec<_>) = open.partition(|way| is_observation(way));
                let ways: Vec<Found> = if looks.is_empty() { undoing } else { looks }.into_iter().map(Ok).collect();
                match reason {
                    Some(why) if ways.is_empty() => Err(why),
                    _ => self.any(goal, ways),
                }
            }
        }
    }
}

/// Whether a way consists only of looks, or of nothing.
fn is_observation(way: &[Subgoal]) -> bool {
    way.iter().all(|s| s.options.first().is_some_and(OpenCondition::is_observation))
}

/// The open subgoals of a number of pairs: pairs with few subgoals are preferred, and no pair that holds is
/// given up unless its things are needed for others. `None` if there cannot be that many.
fn pair_up(pairs: &Pairs, table: Table, [firsts, seconds]: [usize; 2], number: usize) -> Option<Vec<Subgoal>> {
    let up_to = |most: usize| {
        let mut rows = vec![Vec::new(); firsts];
        table.iter().filter(|(.., open)| open.len() <= most).for_each(|(i, j, _)| rows[*i].push(*j));
        rows
    };
    if pairs.pairing.number(&up_to(0), seconds) >= number {
        return Some(Vec::new());
    }
    let mut matching = Matching { partner: vec![None; seconds], size: 0 };
    let mut levels: Vec<usize> = table.iter().map(|(.., open)| open.len()).collect();
    levels.sort_unstable();
    levels.dedup();
    for level in levels {
        matching.grow(&up_to(level), number);
    }
    if matching.size < number {
        return None;
    }
    let chosen = |(i, j, _): &(usize, usize, Vec<Subgoal>)| matching.partner[*j] == Some(*i);
    Some(table.into_iter().filter(chosen).flat_map(|(.., open)| open).collect())
}

/// A bipartite matching by augmenting paths (Kuhn 1955).
struct Matching {
    /// For each second thing, the first thing paired with it.
    partner: Vec<Option<usize>>,
    size: usize,
}

impl Matching {
    /// Adds pairs from a table until the number is reached, or no more can be added.
    fn grow(&mut self, rows: &[Vec<usize>], number: usize) {
        for row in 0..rows.len() {
            if self.size < number && !self.partner.contains(&Some(row)) {
                let mut tried = vec![false; self.partner.len()];
                self.size += usize::from(self.augment(row, rows, &mut tried));
            }
        }
    }

    /// Finds a second thing for a first one, possibly reassigning the partners of others.
    fn augment(&mut self, row: usize, rows: &[Vec<usize>], tried: &mut [bool]) -> bool {
        for &column in &rows[row] {
            if std::mem::replace(&mut tried[column], true) {
                continue;
            }
            let free = match self.partner[column] {
                None => true,
                Some(other) => self.augment(other, rows, tried),
            };
            if free {
                self.partner[column] = Some(row);
                return true;
            }
        }
        false
    }
}

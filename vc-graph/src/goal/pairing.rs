//! Pairings of the objects of two classes.

use super::{Comparison, Goal};

/// A variable and the class that it ranges over.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Variable {
    /// Its name, without `?`.
    pub name: String,
    /// The class; `None` for all objects.
    pub class: Option<String>,
}

/// A pairing of the objects of two classes: BDDL's `forpairs` and `fornpairs`. No object is paired with itself.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Pairs {
    /// The first of a pair.
    pub first: Variable,
    /// The second.
    pub second: Variable,
    /// The number of pairs; `None` for the number of objects of the smaller class.
    pub number: Option<(Comparison, u32)>,
    /// How pairs are counted.
    pub pairing: Pairing,
    /// The condition that a pair satisfies.
    pub body: Box<Goal>,
}

impl Pairs {
    /// Whether `found` pairs suffice if the classes have `first` and `second` objects.
    pub fn admits(&self, found: usize, first: usize, second: usize) -> bool {
        match self.number {
            Some((comparison, number)) => comparison.admits(found, number),
            None => found >= first.min(second),
        }
    }
}

/// How pairs are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Pairing {
    /// The largest number of pairs that can be formed at once, each object in at most one of them.
    #[default]
    Matching,
    /// The number of first objects that have a second, or of second objects that have a first, whichever is
    /// less: the test of BDDL's Python package (3.6.0), which can also pass when objects share partners and no
    /// pairing exists.
    Marginal,
}

impl Pairing {
    /// The number of pairs in a table: `rows[i]` are the second objects, counted from zero, that match the
    /// first object `i`. Costs edges times rows at most.
    pub fn number(self, rows: &[Vec<usize>], seconds: usize) -> usize {
        match self {
            Self::Matching => largest_matching(rows, seconds),
            Self::Marginal => {
                let mut met = vec![false; seconds];
                rows.iter().flatten().filter(|&&s| s < seconds).for_each(|&s| met[s] = true);
                let firsts = rows.iter().filter(|row| !row.is_empty()).count();
                firsts.min(met.into_iter().filter(|&m| m).count())
            }
        }
    }
}

/// The largest number of pairs that can be formed at once, with each row and each column in at most one of
/// them: a maximum bipartite matching by augmenting paths (Kuhn, Naval Research Logistics Quarterly 1955).
///
/// ```
/// // Two bowls, both suitable only for the first guest.
/// assert_eq!(vc_graph::goal::largest_matching(&[vec![0], vec![0]], 2), 1);
/// ```
pub fn largest_matching(rows: &[Vec<usize>], columns: usize) -> usize {
    let mut partner = vec![None; columns];
    let mut seen = vec![usize::MAX; columns];
    (0..rows.len()).filter(|&row| augment(row, row, rows, &mut partner, &mut seen)).count()
}

/// Finds a column for a row, reassigning other rows if necessary. Columns visited in this round are not tried
/// again; the depth is the number of rows reassigned.
fn augment(row: usize, round: usize, rows: &[Vec<usize>], partner: &mut [Option<usize>], seen: &mut [usize]) -> bool {
    // An explicit stack instead of recursion: a path may be as long as there are rows.
    let mut path = vec![(row, 0)];
    while let Some(&mut (at, ref mut next)) = path.last_mut() {
        let Some(&column) = rows[at].get(*next) else {
            path.pop();
            continue;
        };
        *next += 1;
        if column >= seen.len() || seen[column] == round {
            continue;
        }
        seen[column] = round;
        match partner[column] {
            Some(other) => path.push((other, 0)),
            None => {
                path.iter().for_each(|&(row, next)| partner[rows[row][next - 1]] = Some(row));
                return true;
            }
        }
    }
    false
}

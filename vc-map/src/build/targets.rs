//! The arms by which one can go on, and the marks of lanes that lead there.

use crate::parts::Turn;
use crate::{LaneId, Turns};

/// An arm that one can leave by, with its direction seen from the arm that one comes from.
pub(super) struct Target {
    pub(super) arm: usize,
    pub(super) turn: Turn,
    /// See [`leftward`].
    pub(super) leftward: f64,
}

/// How far a way leads to the left, as a number that grows with the angle, -2 to 2.
pub(super) fn leftward(cosine: f64, sine: f64) -> f64 {
    match () {
        () if cosine >= 0.0 => sine,
        () if sine >= 0.0 => 2.0 - sine,
        () => -2.0 - sine,
    }
}

/// One turns back only where there is nothing else, and a street that only bends goes on, whatever paths meet it there.
pub(super) fn straighten(mut targets: Vec<Target>, bends: bool) -> Vec<Target> {
    if targets.iter().any(|target| target.turn != Turn::Back) {
        targets.retain(|target| target.turn != Turn::Back);
        targets.iter_mut().filter(|_| bends).for_each(|target| target.turn = Turn::Through);
    }
    targets
}

/// Whether one of some lanes is marked.
pub(super) fn has(marked: &[Turns], flag: Turns) -> bool {
    marked.iter().any(|turns| turns.any(flag))
}

/// The mark that leads to a target. Where a street forks, its outer branches stand for the turns that lanes are marked for
/// and that nothing else makes.
pub(super) fn mark(marked: &[Turns], open: &[(&Target, Vec<LaneId>)], target: &Target) -> Turns {
    let through: Vec<&Target> = open.iter().map(|(other, _)| *other).filter(|o| o.turn == Turn::Through).collect();
    let made = |turn: Turn| open.iter().any(|(other, _)| other.turn == turn);
    let stands = |branch: Option<&&Target>, turn: Turn| {
        through.len() > 1 && branch.is_some_and(|b| b.arm == target.arm) && !made(turn) && has(marked, turn.mark())
    };
    match () {
        () if stands(through.first(), Turn::Left) => Turns::LEFT,
        () if stands(through.last(), Turn::Right) => Turns::RIGHT,
        () => target.turn.mark(),
    }
}

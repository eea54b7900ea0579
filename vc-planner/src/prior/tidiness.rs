//! How tidy a home is: supposed at first, and learned from where things are found.

use vc_graph::NodeId;
use vc_graph::portable::Portable;

use super::{HABIT, Likely, STRAY, Weights};

/// The kinds of home that there may be: which parts of the things are where habit puts them, astray,
/// and simply anywhere; and how likely the kind is before anything has been seen. Each kind has some
/// things anywhere, so that no place is ever ruled out.
pub(crate) const HYPOTHESES: [([f64; 3], f64); 5] = [
    ([0.0, 0.0, 1.0], 0.05),
    ([0.0, 0.9, 0.1], 0.2),
    ([0.5, 0.45, 0.05], 0.15),
    ([0.8, 0.19, 0.01], 0.25),
    ([0.95, 0.049, 0.001], 0.35),
];

/// How much a thing found, or not found, tells: things of a home are not put away independently
/// of each other, and ten books on a desk are hardly more than one.
pub(crate) const CAUTION: f64 = 0.3;

/// Guards a logarithm and a division.
const LEAST: f64 = 1e-12;

/// The chances of places for the things of one class that have not been found.
#[derive(Debug, Clone)]
pub(crate) struct Supposed {
    /// One of them.
    pub(crate) example: NodeId,
    /// The weights that habits and related classes give to kinds of place, if they say anything.
    pub(crate) weights: Option<Weights>,
    /// How likely a place of each kind is by that.
    pub(crate) likely: Option<Likely>,
    /// Since that was reckoned one of the class was found, or a place became known.
    pub(crate) stale: bool,
    /// How much of it is left in places not seen.
    pub(crate) left: [f64; 2],
    /// How many of the class are missing.
    pub(crate) missing: usize,
}

impl Supposed {
    /// One of the class was found at a kind of place.
    pub(crate) fn find(&mut self, kind: usize) {
        if let Some(weights) = &mut self.weights {
            weights.find(kind);
            self.stale = true;
        }
    }

    /// Expects nothing at a place of a kind any more.
    pub(crate) fn leave_out(&mut self, kind: usize) {
        let [habit, stray] = self.likely.as_ref().and_then(|likely| likely.get(kind)).copied().unwrap_or_default();
        self.left = [self.left[HABIT] - habit, self.left[STRAY] - stray];
    }
}

/// How likely each hypothesis is after what has been found and not found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tidiness {
    /// Logarithms of how well each explains what has been found.
    found: [f64; HYPOTHESES.len()],
    /// The chance of each, what was not found taken into account.
    chances: [f64; HYPOTHESES.len()],
}

impl Default for Tidiness {
    fn default() -> Self {
        Self { found: [0.0; HYPOTHESES.len()], chances: HYPOTHESES.map(|(_, chance)| chance) }
    }
}

impl Tidiness {
    /// Takes note that a thing was found where habit and chance put it so often.
    pub(crate) fn found(&mut self, likely: [f64; 2], even: f64) {
        for (weight, (parts, _)) in self.found.iter_mut().zip(HYPOTHESES) {
            *weight += (chance(parts, likely, even) / even).logarithm();
        }
    }

    /// Weighs what is still missing, with the share of places not seen.
    pub(crate) fn settle<'a>(&mut self, classes: impl Iterator<Item = &'a Supposed>, unseen: f64) {
        let mut logs = self.found;
        for class in classes.filter(|c| c.likely.is_some() && c.missing > 0) {
            for (log, (parts, _)) in logs.iter_mut().zip(HYPOTHESES) {
                *log += class.missing as f64 * chance(parts, class.left, unseen).max(LEAST).logarithm();
            }
        }
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let raw: [f64; HYPOTHESES.len()] =
            std::array::from_fn(|i| HYPOTHESES[i].1 * (CAUTION * (logs[i] - most)).exponential());
        let sum: f64 = raw.iter().sum();
        self.chances = raw.map(|w| w / sum);
    }

    /// The chances of places for a class: so much for each, and so much for each unit of
    /// habit and of being astray.
    pub(crate) fn mix(&self, class: &Supposed, unseen: f64, even: f64) -> (f64, [f64; 2]) {
        if class.likely.is_none() {
            return (even / unseen.max(LEAST), [0.0; 2]);
        }
        let mut mixed = (0.0, [0.0; 2]);
        for (weight, (parts, _)) in self.chances.iter().zip(HYPOTHESES) {
            let each = weight / chance(parts, class.left, unseen).max(LEAST);
            mixed.0 += each * parts[2] * even;
            mixed.1[HABIT] += each * parts[HABIT];
            mixed.1[STRAY] += each * parts[STRAY];
        }
        mixed
    }
}

/// The chance of a place, or of places together, by a hypothesis.
pub(crate) fn chance(parts: [f64; 3], likely: [f64; 2], even: f64) -> f64 {
    parts[HABIT] * likely[HABIT] + parts[STRAY] * likely[STRAY] + parts[2] * even
}

//! How values are spread: counts in narrow bins, which add up over any number of parts.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// Counts of values, rounded to steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    step: f32,
    /// How many values are nearest to so many steps.
    bins: BTreeMap<i32, u64>,
}

impl Spread {
    /// No values yet; values will be rounded to multiples of a step.
    pub fn new(step: f32) -> Self {
        Self { step, bins: BTreeMap::new() }
    }

    /// Takes in a value.
    pub fn add(&mut self, value: f32) {
        *self.bins.entry((value / self.step).round() as i32).or_default() += 1;
    }

    /// Takes in all values of another, of the same step.
    pub fn merge(&mut self, other: &Self) {
        other.bins.iter().for_each(|(bin, count)| *self.bins.entry(*bin).or_default() += count);
    }

    /// How many values there are.
    pub fn count(&self) -> u64 {
        self.bins.values().sum()
    }

    /// The value below which a share of all values lies, to a step (nearest rank);
    /// `None` of none.
    ///
    /// ```
    /// use vc_procgen::statistics::Spread;
    /// let mut ages = Spread::new(1.0);
    /// (1..=9).for_each(|age| ages.add(age as f32));
    /// assert_eq!(ages.quantile(0.5), Some(5.0));
    /// assert_eq!(ages.quantile(1.0), Some(9.0));
    /// ```
    pub fn quantile(&self, share: f64) -> Option<f32> {
        let wanted = ((share * self.count() as f64).ceil() as u64).max(1);
        let mut below = 0;
        self.bins.iter().find_map(|(bin, count)| {
            below += count;
            (below >= wanted).then_some(*bin as f32 * self.step)
        })
    }

    /// The mean, of the rounded values.
    pub fn mean(&self) -> Option<f64> {
        let sum: f64 = self.bins.iter().map(|(bin, n)| f64::from(*bin) * f64::from(self.step) * *n as f64).sum();
        (!self.bins.is_empty()).then(|| sum / self.count() as f64)
    }

    /// How many values lie in each of several equal ranges from zero to `high`; the
    /// last takes what is beyond.
    pub(super) fn histogram(&self, high: f32, ranges: usize) -> Vec<u64> {
        let mut counts = vec![0; ranges];
        for (bin, count) in &self.bins {
            let at = (*bin as f32 * self.step / high * ranges as f32).max(0.0) as usize;
            counts[at.min(ranges - 1)] += count;
        }
        counts
    }
}

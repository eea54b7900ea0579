//! Distributions of values: counts in narrow bins, which add up over any number of subsets.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A histogram of values, rounded to multiples of a step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Histogram {
    step: f32,
    /// The number of values nearest to each multiple of the step.
    bins: BTreeMap<i32, u64>,
}

impl Histogram {
    /// An empty distribution; values will be rounded to multiples of `step`.
    pub fn new(step: f32) -> Self {
        Self { step, bins: BTreeMap::new() }
    }

    /// Adds a value.
    pub fn add(&mut self, value: f32) {
        *self.bins.entry((value / self.step).round() as i32).or_default() += 1;
    }

    /// Adds all values of another distribution with the same step.
    ///
    /// ```
    /// use vc_procgen::statistics::Histogram;
    /// let (mut one, mut other) = (Histogram::new(0.5), Histogram::new(0.5));
    /// one.add(1.0);
    /// other.add(3.0);
    /// one.merge(&other);
    /// assert_eq!((one.count(), one.mean()), (2, Some(2.0)));
    /// ```
    pub fn merge(&mut self, other: &Self) {
        other.bins.iter().for_each(|(bin, count)| *self.bins.entry(*bin).or_default() += count);
    }

    /// The number of values.
    pub fn count(&self) -> u64 {
        self.bins.values().sum()
    }

    /// A quantile, up to the step (nearest rank); `None` if there are no values.
    ///
    /// ```
    /// use vc_procgen::statistics::Histogram;
    /// let mut ages = Histogram::new(1.0);
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

    /// The mean of the rounded values.
    pub fn mean(&self) -> Option<f64> {
        let sum: f64 = self.bins.iter().map(|(bin, n)| f64::from(*bin) * f64::from(self.step) * *n as f64).sum();
        (!self.bins.is_empty()).then(|| sum / self.count() as f64)
    }

    /// The numbers of values in several equal ranges from zero to `high`; the last range includes
    /// everything beyond.
    pub(super) fn histogram(&self, high: f32, ranges: usize) -> Vec<u64> {
        let mut counts = vec![0; ranges];
        for (bin, count) in &self.bins {
            let at = (*bin as f32 * self.step / high * ranges as f32).max(0.0) as usize;
            counts[at.min(ranges - 1)] += count;
        }
        counts
    }
}

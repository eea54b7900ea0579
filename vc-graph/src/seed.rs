//! Randomness: seeds, sub-seeds for independent choices, and the random stream of a seed.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng};
use serde::{Deserialize, Serialize};

use crate::hash::{fnv1a, splitmix};

/// The source of all randomness. The same seed gives the same result on every machine; sub-seeds by label and
/// index make each choice independent of the number of choices made before it.
///
/// ```
/// use vc_graph::Seed;
/// let kitchen = Seed(42).child("room").nth(2);
/// assert_eq!(kitchen.stream().below(100), kitchen.stream().below(100));
/// assert_ne!(kitchen, Seed(42).child("room").nth(3));
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Seed(pub u64);

impl Seed {
    /// The sub-seed of a label.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// let home = Seed(42);
    /// assert_eq!(home.child("walls"), home.child("walls"));
    /// assert_ne!(home.child("walls"), home.child("doors"));
    /// ```
    #[must_use]
    pub fn child(self, label: &str) -> Self {
        Self(splitmix(self.0 ^ splitmix(fnv1a(label.bytes()))))
    }

    /// The sub-seed of a number.
    #[must_use]
    pub fn nth(self, index: u64) -> Self {
        Self(splitmix(self.0.rotate_left(32) ^ splitmix(index.wrapping_add(1))))
    }

    /// The random stream of this seed.
    pub fn stream(self) -> Stream {
        Stream { numbers: ChaCha8Rng::seed_from_u64(self.0) }
    }
}

/// A stream of random numbers (ChaCha with eight rounds): the same on every machine.
///
/// ```
/// use vc_graph::Seed;
/// let (mut one, mut other) = (Seed(7).stream(), Seed(7).stream());
/// let draws = [(); 4].map(|()| one.between(0.0, 10.0));
/// assert_eq!(draws, [(); 4].map(|()| other.between(0.0, 10.0)));
/// assert!(draws.iter().all(|value| (0.0..10.0).contains(value)));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Stream {
    numbers: ChaCha8Rng,
}

impl Stream {
    /// A number from 0 up to 1, 1 excluded.
    pub fn unit(&mut self) -> f32 {
        // An f32 holds 24 bits exactly.
        (self.numbers.next_u32() >> 8) as f32 / (1 << 24) as f32
    }

    /// A uniform number from `low` to `high`; `low` if the range is empty.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + self.unit() * (high - low).max(0.0)
    }

    /// A uniform integer below `count`; zero if `count` is zero.
    pub fn below(&mut self, count: usize) -> usize {
        // The high half of a product: its bias is negligible below 2^32.
        ((u64::from(self.numbers.next_u32()) * count as u64) >> 32) as usize
    }

    /// A uniform integer from `low` to `high`, both included.
    pub fn count(&mut self, low: usize, high: usize) -> usize {
        low + self.below(high.saturating_sub(low) + 1)
    }

    /// True with a given probability.
    pub fn chance(&mut self, probability: f32) -> bool {
        self.unit() < probability
    }

    /// One of several elements, all equally likely; `None` if there are none.
    pub fn pick<'a, T>(&mut self, of: &'a [T]) -> Option<&'a T> {
        of.get(self.below(of.len()))
    }

    /// Chooses an index with probability proportional to its weight. Zero weights are never chosen; `None` if
    /// no weight is positive.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// let mut rng = Seed(1).stream();
    /// assert_eq!(rng.weighted([0.0, 1.0, 0.0].into_iter()), Some(1));
    /// assert_eq!(rng.weighted(std::iter::empty()), None);
    /// ```
    pub fn weighted(&mut self, weights: impl Iterator<Item = f32> + Clone) -> Option<usize> {
        let total: f32 = weights.clone().map(|w| w.max(0.0)).sum();
        let mut left = self.unit() * total;
        let mut last = None;
        for (index, weight) in weights.enumerate().filter(|(_, w)| *w > 0.0) {
            last = Some(index);
            left -= weight;
            if left < 0.0 {
                break;
            }
        }
        last
    }

    /// A normally distributed number (the sum of twelve uniform ones, hence never more than six standard
    /// deviations from the mean).
    pub fn normal(&mut self, mean: f32, deviation: f32) -> f32 {
        mean + deviation * ((0..12).map(|_| self.unit()).sum::<f32>() - 6.0)
    }

    /// Shuffles a list.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// let mut cards = [1, 2, 3, 4, 5];
    /// Seed(3).stream().shuffle(&mut cards);
    /// cards.sort();
    /// assert_eq!(cards, [1, 2, 3, 4, 5]);
    /// ```
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last + 1));
        }
    }
}

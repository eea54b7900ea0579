//! Sampled homes for rollouts: possible places of the wanted things.

use super::{ALL, MOST_OBJECTS, ObjectSearch, STAGES, SoughtObject};

/// A home with its probability, and the sought objects at each site as bits.
#[derive(Debug, Clone, Default)]
pub(super) struct World {
    pub(super) chance: f64,
    at: Vec<u32>,
}

impl World {
    /// The sought objects at a site, as bits.
    pub(super) fn things_at(&self, site: u16) -> u32 {
        self.at.get(site as usize).copied().unwrap_or(0)
    }
}

impl ObjectSearch {
    /// The homes for rollouts, and whether they are an enumeration of all rather than a sample.
    pub(super) fn worlds(&self) -> (Vec<World>, bool) {
        let mut supports = self.sought_objects.iter().map(|q| q.chances.iter().filter(|c| **c > 0.0).count());
        match supports.try_fold(1usize, |all, n| all.checked_mul(n)) {
            Some(n) if n <= ALL => (self.all_worlds(), true),
            _ => (self.draw(STAGES[2]), false),
        }
    }

    fn all_worlds(&self) -> Vec<World> {
        let mut worlds = vec![World { chance: 1.0, at: vec![0; self.sites.len()] }];
        for (number, object) in self.sought_objects.iter().enumerate() {
            let possible = || object.chances.iter().enumerate().filter(|(_, chance)| **chance > 0.0);
            let with = |world: &World| -> Vec<World> {
                let put = |(site, chance): (usize, &f64)| {
                    let mut next = World { chance: world.chance * chance, at: world.at.clone() };
                    next.at[site] |= 1 << number;
                    next
                };
                possible().map(put).collect()
            };
            worlds = worlds.iter().flat_map(with).collect();
        }
        worlds
    }

    /// Samples a number of homes: for each object the points of a Kronecker sequence, which are more evenly
    /// distributed than random ones.
    fn draw(&self, homes: usize) -> Vec<World> {
        let mut worlds = vec![World { chance: 1.0, at: vec![0; self.sites.len()] }; homes];
        for (number, object) in self.sought_objects.iter().enumerate() {
            let step = f64::from(PRIMES[number % PRIMES.len()]).sqrt().fract();
            let Some(last) = object.chances.iter().rposition(|chance| *chance > 0.0) else { continue };
            let sums = running_sums(object);
            for (home, world) in worlds.iter_mut().enumerate() {
                let point = (0.5 + (home + 1) as f64 * step).fract() * sums[last];
                let site = sums.partition_point(|sum| *sum <= point).min(last);
                world.at[site] |= 1 << number;
            }
        }
        worlds
    }
}

fn running_sums(object: &SoughtObject) -> Vec<f64> {
    let add = |sum: &mut f64, chance: &f64| {
        *sum += chance;
        Some(*sum)
    };
    object.chances.iter().scan(0.0, add).collect()
}

const PRIMES: [u8; MOST_OBJECTS] =
    [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89];

//! Code shared by several test files: hand-made and random scenes.
#![allow(dead_code, reason = "each test file uses a part")]

pub(crate) mod documents;
pub(crate) mod edits;
pub(crate) mod flat;
pub(crate) mod goals;
pub(crate) mod scenes;

use proptest::test_runner::{Config, RngSeed};

/// A configuration with this number of cases, the same in every run. `PROPTEST_CASES` and `PROPTEST_RNG_SEED`
/// set more or other cases.
pub(crate) fn cases(number: u32) -> Config {
    let given = Config::default();
    let cases = std::env::var_os("PROPTEST_CASES").map_or(number, |_| given.cases);
    let rng_seed = match given.rng_seed {
        RngSeed::Random => RngSeed::Fixed(1),
        fixed => fixed,
    };
    Config { cases, rng_seed, failure_persistence: None, ..given }
}

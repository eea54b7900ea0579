//! Everything that the tests of several crates use: the shared data, small valid documents, hand-made and random
//! scenes, edits and goals, golden files, and the tables of benches. It is a dev-dependency only and is not published.
#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

pub mod data;
pub mod documents;
pub mod edits;
pub mod flat;
pub mod goals;
pub mod golden;
pub mod kitchen;
pub mod page;
pub mod scenes;

use std::io::Write;

use proptest::test_runner::{Config, RngSeed};

/// A configuration with a quarter of this number of cases, the same in every run, or with all of them where the whole
/// of long checks is done: see [`amount`]. `PROPTEST_CASES` and `PROPTEST_RNG_SEED` set more or other cases.
pub fn cases(number: u32) -> Config {
    let given = Config::default();
    let number = amount(number.div_ceil(4), number);
    let cases = std::env::var_os("PROPTEST_CASES").map_or(number, |_| given.cases);
    let rng_seed = match given.rng_seed {
        RngSeed::Random => RngSeed::Fixed(1),
        fixed => fixed,
    };
    Config { cases, rng_seed, failure_persistence: None, ..given }
}

/// How much of a long check a test does: the usual amount, or the whole if `VC_WHOLE` is set, as `proofs/whole` does.
pub fn amount<T>(usual: T, whole: T) -> T {
    if std::env::var_os("VC_WHOLE").is_some() { whole } else { usual }
}

/// Says that a test is skipped, and why. Written past the test harness, which captures the output of passing
/// tests.
pub fn skipped(why: &str) {
    std::io::stderr().write_all(format!("SKIPPED: {why}\n").as_bytes()).unwrap();
}

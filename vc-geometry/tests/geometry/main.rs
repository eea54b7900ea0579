//! Geometry against slow and obvious versions of it.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod boxes;
mod grids;
mod hulls;
mod outlines;
mod profiles;
mod trees;
mod walks;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// So many cases, the same ones each time.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(0), failure_persistence: None, ..ProptestConfig::default() }
}

//! Geometry against slow and obvious versions of it.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

#[path = "geometry/grids.rs"]
mod grids;
#[path = "geometry/hulls.rs"]
mod hulls;
#[path = "geometry/outlines.rs"]
mod outlines;
#[path = "geometry/profiles.rs"]
mod profiles;
#[path = "geometry/trees.rs"]
mod trees;
#[path = "geometry/walks.rs"]
mod walks;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// So many cases, the same ones each time.
fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(0), failure_persistence: None, ..ProptestConfig::default() }
}

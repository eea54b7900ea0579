//! Environments: generated homes with bodies, in which agents act.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use std::time::Instant;

use virtualcity::graph::Seed;
use virtualcity::{Environment, run};

/// Random actions do no harm. (Few here; `many_random_actions` has the thousands.)
#[test]
fn random_actions_do_no_harm() {
    let from: u64 = std::env::var("FROM").ok().and_then(|s| s.parse().ok()).unwrap_or(42);
    let homes: u64 = std::env::var("HOMES").ok().and_then(|s| s.parse().ok()).unwrap_or(1);
    let actions: usize = std::env::var("ACTIONS").ok().and_then(|s| s.parse().ok()).unwrap_or(100);
    for seed in from..from + homes {
        let start = Instant::now();
        let mut home = Environment::make(&format!("apartment/{seed}"), 2).unwrap();
        println!("made {home:?} in {:?}", start.elapsed());
        let start = Instant::now();
        let tally = run(&mut home, actions, Seed(seed));
        println!("{} done, {} refused, {:?}", tally.done, tally.refused, start.elapsed());
        tally.impossible.iter().for_each(|i| println!("  impossible {i}"));
        tally.disagreements.iter().for_each(|i| println!("  DISAGREE {i}"));
        tally.breaches.iter().for_each(|i| println!("  BREACH {i}"));
    }
}

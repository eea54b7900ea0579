//! An agent opens a kitchen drawer and takes a spoon out of it, by the velocity of its body and the poses of its hand
//! alone: no action is given, and nobody is put anywhere.
//!
//! ```text
//! cargo run --release --example hands -- [SEED...]
//! ```
//!
//! prints what the graph says after each stage, and writes the stages as a strip and a film of each home into `out/hands`.

#[path = "../support/mod.rs"]
mod support;

mod body;
mod sight;
mod target;

use body::Body;
use sight::Witness;
use support::{Complaint, say};
use target::Target;
use virtualcity::Environment;
use virtualcity::graph::Pose;
use virtualcity::physics::Hand;

/// Homes with a spoon in a drawer that has a handle, and no closed door on the way to it.
const SEEDS: [u64; 3] = [8, 14, 23];

fn main() -> Result<(), Complaint> {
    let seed =
        |word: String| word.parse().map_err(|_| Complaint::new(format!("usage: hands [SEED...]; `{word}` is none")));
    let seeds: Result<Vec<u64>, _> = std::env::args().skip(1).map(seed).collect();
    let seeds = Some(seeds?).filter(|seeds| !seeds.is_empty()).unwrap_or_else(|| SEEDS.to_vec());
    seeds.into_iter().try_for_each(take_spoon)
}

fn take_spoon(seed: u64) -> Result<(), Complaint> {
    let home = Environment::make(&format!("apartment/{seed}"), 1)?;
    let target = Target::find(&home).ok_or_else(|| {
        Complaint::new(format!("apartment/{seed}: no spoon is in a drawer that can be reached; {SEEDS:?} have one"))
    })?;
    let names = [target.spoon, target.cabinet].map(|id| home.graph().label(id));
    say!("apartment/{seed}: {} in {}", names[0], names[1]);
    let witness = Witness::new(&home, &target);
    let mut body = Body::new(home, witness)?;
    let handle = target.handle(&body.home);

    body.walk(&target.stand(&body.home))?;
    body.tell("at the cabinet", &target)?;
    let before = handle * Pose::translation(-0.1, 0.0, 0.0);
    body.reach(&before, 0.0)?;
    body.reach(&handle, 0.0)?;
    body.reach(&handle, 1.0)?;
    body.tell("hand on the handle", &target)?;
    let pulled = handle * Pose::translation(-target.way - 0.02, 0.0, 0.0);
    body.reach(&pulled, 1.0)?;
    body.tell("drawer pulled", &target)?;
    body.reach(&pulled, 0.0)?;
    body.reach(&(pulled * Pose::translation(-0.08, 0.0, 0.0)), 0.0)?;
    let up = pulled.translation.vector + nalgebra::Vector3::new(0.0, 0.0, 0.25);
    body.reach(&Pose::from_parts(up.into(), pulled.rotation), 0.0)?;
    let spoon = target.around_spoon(&body.home);
    let high = up.z - spoon.translation.z;
    body.reach(&(spoon * Pose::translation(-high, 0.0, 0.0)), 0.0)?;
    body.reach(&spoon, 0.6)?;
    body.tell("hand in the drawer", &target)?;
    body.reach(&spoon, 1.0)?;
    body.tell("spoon in the hand", &target)?;
    body.reach(&(spoon * Pose::translation(-high, 0.0, 0.0)), 1.0)?;
    body.tell("spoon lifted", &target)?;
    body.witness.write(seed)?;
    match body.home.world().held(body.me, Hand::Right) {
        Some(held) if held == target.spoon => Ok(()),
        _ => Err(Complaint::new(format!("apartment/{seed}: the spoon is not in the hand"))),
    }
}

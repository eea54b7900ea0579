//! The shortest program: a home, an agent at its fridge, and what the agent sees.
//!
//! `cargo run --release --example first_home`

#![expect(clippy::print_stdout, reason = "an example prints")]

use virtualcity::Environment;
use virtualcity::graph::{Action, Verb};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut home = Environment::make("apartment/9", 1)?;
    let (agent, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    home.set_action(agent, Action::one(Verb::Walk, fridge))?;
    home.set_action(agent, Action::one(Verb::Open, fridge))?;
    println!("{} sees {} nodes", home.graph().label(agent), home.room_observation(agent).len());
    Ok(())
}

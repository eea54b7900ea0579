//! The shortest program: a home, an agent at its fridge, and what the agent sees.
//!
//! `cargo run --release --example first_home`

mod support;

use support::{Complaint, say};
use virtualcity::Environment;
use virtualcity::graph::{Action, Verb};

fn main() -> Result<(), Complaint> {
    let mut home = Environment::make("apartment/9", 1)?;
    let (agent, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
    home.set_action(agent, Action::one(Verb::Walk, fridge))?;
    home.set_action(agent, Action::one(Verb::Open, fridge))?;
    say!("{} sees {} nodes", home.graph().label(agent), home.room_observation(agent).len());
    Ok(())
}

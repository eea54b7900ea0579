//! One operation, a number of times: the program that `proofs/costs` counts instructions of.
//!
//! `costs NAME TIMES`, with a name of [`OPERATIONS`]. Each runs on fixed input and on one thread. The difference
//! between two numbers of times is the cost of the operation without what it needs beforehand.

#![expect(clippy::unwrap_used, clippy::print_stderr, reason = "a measurement stops where something is wrong")]

use std::hint::black_box;

use virtualcity::graph::{Scope, Seed, Simulator};
use virtualcity::planner::{Agent, Decision};
use virtualcity::render::Modalities;
use virtualcity::{Environment, Viewpoint, legal_action};

/// An operation, done a number of times.
type Operation = fn(usize);

/// The operations, by name.
const OPERATIONS: [(&str, Operation); 7] = [
    ("make", make),
    ("reset", reset),
    ("action", action),
    ("legal", legal),
    ("observation", observation),
    ("modalities", modalities),
    ("decision", decision),
];

fn home() -> Environment {
    Environment::make("apartment/42", 1).unwrap()
}

fn make(times: usize) {
    for _ in 0..times {
        black_box(home());
    }
}

fn reset(times: usize) {
    let mut home = home();
    let start = home.start().clone();
    for _ in 0..times {
        black_box(home.reset(&start).unwrap());
    }
}

/// Random legal actions, refused by bodies or not.
fn action(times: usize) {
    let mut home = home();
    let agent = home.agents()[0];
    let mut stream = Seed(1).stream();
    for _ in 0..20 * times {
        let action = legal_action(home.graph(), agent, &mut stream);
        let _ = black_box(home.set_action(agent, action));
    }
}

/// All legal actions of an agent.
fn legal(times: usize) {
    let home = home();
    for _ in 0..20 * times {
        black_box(home.legal_actions(home.agents()[0]).len());
    }
}

fn observation(times: usize) {
    let home = home();
    for _ in 0..1000 * times {
        black_box(home.room_observation(home.agents()[0]).len());
        black_box(home.observation(home.agents()[0], 3.0).len());
    }
}

fn modalities(times: usize) {
    let home = home();
    let view = Viewpoint::Agent(home.agents()[0]);
    // The first picture uploads the meshes.
    for _ in 0..=2 * times {
        black_box(home.render_until(&home, view, Modalities::SIX, 300, 300).unwrap());
    }
}

/// An agent that sees its room, decides and acts by the rule alone.
fn decision(times: usize) {
    let home = home();
    for _ in 0..times {
        let mut rule = Simulator::new(home.graph().clone());
        let me = home.agents()[0];
        let mut agent = Agent::in_known_home(rule.graph(), me, "On(novel, table), 2".parse().unwrap(), 7);
        for _ in 0..20 {
            agent.see(&rule.graph().observe(me, Scope::Room));
            let Decision::Act(action, _) = agent.decide() else { break };
            if rule.step(me, &action).is_err() {
                break;
            }
            agent.did(&action);
        }
    }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let operation = OPERATIONS.iter().find(|(name, _)| words.first().is_some_and(|w| w == name));
    match (operation, words.get(1).and_then(|times| times.parse().ok())) {
        (Some((_, run)), Some(times)) => run(times),
        _ => {
            eprintln!("costs NAME TIMES, with a name of {:?}", OPERATIONS.map(|(name, _)| name));
            std::process::exit(2);
        }
    }
}

//! A breadth-first search of many states of a home: the program that `proofs/search` runs for each home.
//!
//! `search SEED STATES` prints one line: the memory of copies of a home in which somebody has acted, also when they are compacted,
//! of states, and of homes restored from them, what the search took, and how fast it was. Memory is that which the system gives the
//! process (Linux).

#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    clippy::disallowed_methods,
    reason = "a measurement reads the clock, and stops where something is wrong"
)]

use std::collections::HashSet;
use std::time::Instant;

use virtualcity::graph::{NodeId, Seed};
use virtualcity::{Environment, EnvironmentState, legal_action};

/// Copies of which the mean memory is taken, and restored homes, which take less.
const COPIES: usize = 100;
const RESTORED: usize = 2000;
/// The states after each of which progress is shown.
const PROGRESS: usize = 5000;

/// A figure of the process's memory, bytes: `VmRSS` or `VmHWM`.
fn memory(figure: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with(figure));
    let number = line.and_then(|line| line.split_whitespace().nth(1)?.parse::<f64>().ok());
    number.unwrap_or(f64::NAN) * 1024.0
}

/// Some things, and their mean kilobytes. They have to be kept, or those that are made later take their memory.
fn weighed<T>(number: usize, make: impl FnMut(usize) -> T) -> (f64, Vec<T>) {
    let before = memory("VmRSS");
    let all: Vec<T> = (0..number).map(make).collect();
    ((memory("VmRSS") - before) / number as f64 / 1e3, all)
}

/// A copy in which an agent has done an action of its own, if any of some is done.
fn acted(home: &Environment, me: NodeId, seed: usize) -> Environment {
    let (mut copy, mut stream) = (home.clone(), Seed(seed as u64).stream());
    for _ in 0..20 {
        let action = legal_action(copy.graph(), me, &mut stream);
        if copy.set_action(me, action).is_ok() {
            break;
        }
    }
    copy
}

/// The findings of a search, and its costs.
#[derive(Default)]
struct Search {
    /// All states, as a search keeps them that looks up the way to its goal in the end.
    states: Vec<EnvironmentState>,
    refused: usize,
    failed: usize,
    /// How often homes were restored and woken, actions done and states saved, and the seconds that it took.
    woken: Spent,
    done: Spent,
    saved: Spent,
}

/// How often something was done, and the seconds that it took.
#[derive(Default)]
struct Spent {
    times: usize,
    seconds: f64,
}

impl Spent {
    fn on<T>(&mut self, what: impl FnOnce() -> T) -> T {
        let begin = Instant::now();
        let made = what();
        (self.times, self.seconds) = (self.times + 1, self.seconds + begin.elapsed().as_secs_f64());
        made
    }

    fn milliseconds(&self) -> f64 {
        self.seconds * 1e3 / self.times as f64
    }
}

fn search(home: &mut Environment, me: NodeId, most: usize) -> Search {
    let (mut found, mut seen) = (Search::default(), HashSet::from([home.graph().digest()]));
    found.states.push(home.save_state().unwrap());
    let mut next = 0;
    while next < found.states.len() && found.states.len() < most {
        let parent = found.woken.on(|| {
            let parent = home.restore_state(&found.states[next]).unwrap();
            parent.world();
            parent
        });
        next += 1;
        for action in parent.legal_actions(me) {
            let mut child = parent.clone();
            if found.states.len() == most {
                break;
            } else if found.done.on(|| child.set_action(me, action)).is_err() {
                found.failed += 1;
            } else if seen.insert(child.graph().digest()) {
                match found.saved.on(|| child.save_state()) {
                    Ok(state) => {
                        found.states.push(state);
                        if found.states.len().is_multiple_of(PROGRESS) {
                            eprintln!("{} states of {most}, peak {:.0} MB", found.states.len(), memory("VmHWM") / 1e6);
                        }
                    }
                    Err(why) => {
                        found.refused += 1;
                        eprintln!("{}: {why}", action.describe(parent.graph()));
                    }
                }
            }
        }
    }
    found
}

fn main() {
    let mut words = std::env::args().skip(1).map(|word| word.parse::<usize>());
    let (Some(Ok(seed)), Some(Ok(states))) = (words.next(), words.next()) else {
        eprintln!("search SEED STATES");
        std::process::exit(2);
    };
    let mut home = Environment::make(&format!("apartment/{seed}"), 1).unwrap();
    let (me, nodes) = (home.agents()[0], home.graph().len());
    let kept: Vec<_> = (0..COPIES).map(|seed| acted(&home, me, seed).save_state().unwrap()).collect();
    let (light, restored) = weighed(RESTORED, |at| home.restore_state(&kept[at % COPIES]).unwrap());
    drop(restored);
    let (fixed, begin) = (memory("VmRSS") / 1e6, Instant::now());
    let found = search(&mut home, me, states);
    let (seconds, peak) = (begin.elapsed().as_secs_f64(), memory("VmHWM") / 1e6);
    let (copy, copies) = weighed(COPIES, |_| home.clone());
    let (heavy, all) = weighed(COPIES, |seed| acted(&home, me, seed));
    let (compact, small) = weighed(COPIES, |seed| {
        let mut copy = acted(&home, me, seed);
        copy.compact().unwrap();
        copy
    });
    let bytes: Vec<usize> = found.states.iter().map(EnvironmentState::bytes).collect();
    let number = bytes.len();
    println!(
        "home {seed} of {nodes} nodes: a copy {copy:.0} kB, one that acted {heavy:.0} kB, compacted {compact:.0} kB, one restored \
         from a state {light:.0} kB; {number} states ({} not saved, {} actions failed), {:.1} kB each, {:.1} at most, {:.0} states per \
         second: {:.1} ms to wake, {:.1} to act, {:.1} to save; {fixed:.0} MB before, peak {peak:.0} MB",
        found.refused,
        found.failed,
        bytes.iter().sum::<usize>() as f64 / number as f64 / 1e3,
        bytes.iter().max().copied().unwrap_or(0) as f64 / 1e3,
        number as f64 / seconds,
        found.woken.milliseconds(),
        found.done.milliseconds(),
        found.saved.milliseconds(),
    );
    drop((copies, all, small));
}

//! Two agents with one goal need less time than one.

use vc_tasks::library::{Activity, Benchmark};
use virtualcity::Environment;
use virtualcity::graph::{NodeId, Seed};
use virtualcity::initial::{AtHome, at_home_that, feasible, generator};
use virtualcity::planner::Team;
use virtualcity::tasks::{Outcome, WorldError};

/// How a team of so many did a task.
struct Done {
    won: bool,
    rounds: usize,
    actions: usize,
    seconds: f64,
}

fn at_home(activity: &Activity, seed: u64) -> Option<AtHome<Environment>> {
    let open = |scene| Environment::from_scene(scene, 2).map_err(WorldError::failed);
    at_home_that(activity, Seed(seed), &generator(), open, |home, initial| feasible(activity, home, initial)).ok()
}

/// Lets a team do a task that is prepared, `known` whether it knows where everything is.
fn team(made: &AtHome<Environment>, known: bool, number: usize, seed: u64) -> Done {
    let (mut home, task) = (made.world.clone(), &made.initial.task);
    let first = made.initial.agent;
    let mut ids: Vec<NodeId> = home.agents().iter().copied().filter(|id| *id != first).collect();
    ids.insert(0, first);
    let graph = home.graph().clone();
    let mut team = match known {
        true => Team::oracles(&graph, &ids[..number], &task.goal),
        false => Team::in_known_home(&graph, &ids[..number], &task.goal, seed),
    };
    let begin = home.tick();
    let episode = team.run(task, &mut home);
    let seconds = (home.tick() - begin).0 as f64 / 60.0;
    Done { won: episode.outcome == Outcome::Won, rounds: episode.rounds, actions: episode.actions, seconds }
}

/// Prints how long one agent and two take for the tasks; `FROM`, `TASKS` and `SEED` choose them.
#[test]
#[ignore = "takes minutes: proofs/teams"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn one_and_two_take_their_time() {
    let number = |name: &str, otherwise| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    let (from, tasks, seed) = (number("FROM", 0), number("TASKS", 1), number("SEED", 0) as u64);
    for activity in Benchmark::v1().activities.iter().skip(from).take(tasks) {
        let Some(made) = at_home(activity, seed) else {
            println!("task {}: no home", activity.id);
            continue;
        };
        for (known, policy) in [(true, "oracle"), (false, "planner")] {
            for number in [1, 2] {
                let Done { won, rounds, actions, seconds } = team(&made, known, number, seed);
                let how = if won { "won" } else { "lost" };
                println!("task {} {policy} {number} {how} {rounds} {actions} {seconds:.1}", activity.id);
            }
        }
    }
}

#[test]
fn two_take_less_time_than_one() {
    let benchmark = Benchmark::v1();
    let made = at_home(benchmark.get("setup_table-01").unwrap(), 0).unwrap();
    let [one, two] = [1, 2].map(|number| team(&made, true, number, 0));
    assert!(one.won && two.won);
    assert!(two.seconds < 0.9 * one.seconds, "{} s and {} s", one.seconds, two.seconds);
    // Both act at the same time: the time is not that of all their actions in turn.
    assert!(two.actions > two.rounds && one.rounds == one.actions);
}

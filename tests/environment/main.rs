//! Environments: generated homes with bodies, in which agents act, their pictures and records. One program, because
//! each links the physics engine anew.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

mod acting;
mod agreement;
mod aims;
mod alter;
mod astray;
mod bodies;
mod boxes;
mod city;
mod clock;
mod control;
mod curtains;
mod fitting;
mod golden;
mod hostile;
mod initial;
mod made;
mod own_words;
mod pictures;
mod record;
mod single_actions;
mod states;
mod stays;
mod teams;
mod windows;
mod wishes;

use std::sync::OnceLock;

use single_actions::kept_thing;
use vc_testkit::amount;
use virtualcity::graph::{Action, NodeId, SceneGraph, Seed, Verb};
use virtualcity::{Batch, Environment, MakeError, check_environment, run};

/// Homes in which many tests begin: each test gets a copy, which shares the light of its pictures with the others.
const COMMON: [(u64, usize); 3] = [(7, 1), (42, 1), (42, 2)];

fn home(seed: u64, agents: usize) -> Environment {
    static MADE: [OnceLock<Environment>; COMMON.len()] = [const { OnceLock::new() }; COMMON.len()];
    match COMMON.iter().position(|common| *common == (seed, agents)) {
        Some(at) => MADE[at].get_or_init(|| fresh(seed, agents)).clone(),
        None => fresh(seed, agents),
    }
}

/// A home that shares nothing with others.
fn fresh(seed: u64, agents: usize) -> Environment {
    Environment::make(&format!("apartment/{seed}"), agents).unwrap()
}

fn act(home: &mut Environment, agent: NodeId, verb: Verb, things: &[NodeId]) {
    let action = Action::with(verb, things).unwrap();
    let done = home.set_action(agent, action);
    assert!(done.is_ok(), "{}: {}", action.describe(home.graph()), done.unwrap_err());
}

/// Random actions, legal or not, do no harm, and the bodies act as the rule says.
#[test]
fn random_actions_do_no_harm() {
    for seed in [8, 42] {
        let mut home = home(seed, 2);
        let tally = run(&mut home, 80, Seed(seed));
        assert!(tally.breaches.is_empty(), "{:?}", tally.breaches);
        assert!(tally.done > 20, "{tally:?}");
        assert_eq!(tally.disagreements, []);
    }
}

/// The number of actions required for a release; `HOMES`, `ACTIONS` and `FROM` set other ranges.
#[test]
#[ignore = "takes long"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn many_random_actions() {
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    let (from, homes, actions) = (number("FROM", 1), number("HOMES", 20), number("ACTIONS", 10_000));
    let (mut done, mut breaches, mut disagreements, mut impossible) = (0, 0, 0, 0);
    for seed in from..from + homes {
        let mut home = home(seed, 2);
        let tally = run(&mut home, actions as usize, Seed(seed));
        println!("{}: {} done, {} refused", home.graph().name(), tally.done, tally.refused);
        tally.impossible.iter().take(12).for_each(|why| println!("  impossible: {why}"));
        tally.disagreements.iter().take(12).for_each(|why| println!("  disagreement: {why}"));
        tally.breaches.iter().take(4).for_each(|breach| println!("  breach: {breach}"));
        done += tally.done;
        breaches += tally.breaches.len();
        disagreements += tally.disagreements.len();
        impossible += tally.impossible.len();
    }
    println!("{done} done, {impossible} impossible, {disagreements} disagreements, {breaches} breaches");
    assert_eq!(breaches, 0);
}

/// Environments with equal scenes and bodies but different histories have different digests.
#[test]
fn digests_tell_what_was_done() {
    let (mut first, mut second) = (home(42, 1), home(42, 1));
    let me = first.agents()[0];
    act(&mut first, me, Verb::Dance, &[]);
    act(&mut second, me, Verb::Wave, &[]);
    assert_ne!(first.digest(), second.digest());
}

/// More agents than fit on the floor are refused before any object is allocated for them.
#[test]
fn crowds_are_refused() {
    let crowd = Environment::make("apartment/42", 1_000_000_000);
    assert!(matches!(crowd, Err(MakeError::NoRoom { .. })));
}

/// The contract of Gymnasium's checker, and more.
#[test]
fn the_contract_is_kept() {
    for (name, agents) in [("apartment/8", 2), ("apartment/5", 1), ("apartment/21", 3)] {
        let breaches = check_environment(|| Environment::make(name, agents), amount(20, 40), Seed(3)).unwrap();
        assert!(breaches.is_empty(), "{name}: {breaches:?}");
    }
}

/// Results are the same bytes in any thread, in a batch or alone, in any order.
#[test]
fn threads_change_nothing() {
    let actions = |home: &Environment| -> Vec<(NodeId, Action)> {
        let cupboard = kept_thing(home).map(|(_, at)| at).unwrap_or(home.graph().rooms()[0]);
        vec![(home.agents()[1], Action::zero(Verb::Dance)), (home.agents()[0], Action::one(Verb::Walk, cupboard))]
    };
    let names = || [8_u64, 42, 8].map(|s| format!("apartment/{s}"));
    let mut batch = Batch::make(names(), 2).unwrap();
    let all: Vec<_> = batch.environments().iter().map(&actions).collect();
    assert!(batch.set_actions(&all).iter().flatten().all(Result::is_ok));
    let handles = names().map(|name| {
        std::thread::spawn(move || {
            let mut home = Environment::make(&name, 2).unwrap();
            let mut own = actions(&home);
            own.reverse();
            home.set_actions(&own);
            home.digest()
        })
    });
    let alone: Vec<_> = handles.into_iter().map(|h| h.join().unwrap()).collect();
    let together: Vec<_> = batch.environments().iter().map(Environment::digest).collect();
    assert_eq!(alone, together);
    assert_eq!(alone[0], alone[2]);
}

/// The planner's human-like agent performs a task in a home with bodies, through `World`.
#[test]
fn the_planner_works_with_bodies() {
    use virtualcity::graph::Scope;
    use virtualcity::planner::{Agent, Decision};
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let (thing, _) = kept_thing(&home).unwrap();
    let goal = format!("Holds({})", home.graph().node(thing).unwrap().class()).parse().unwrap();
    let mut agent = Agent::in_known_home(home.graph(), me, goal, 7);
    let world: &mut dyn virtualcity::tasks::World = &mut home;
    for _ in 0..120 {
        agent.see(&world.graph().observe(me, Scope::Room));
        let Decision::Act(action, _) = agent.decide() else { break };
        let words = action.describe(world.graph()).to_string();
        let done = world.step(me, &action);
        assert!(done.is_ok(), "{words}: {}", done.unwrap_err());
        agent.did(&action);
    }
    let class = home.start().node(thing).unwrap().class().clone();
    assert!(SceneGraph::held(home.graph(), me).any(|id| home.graph().node(id).unwrap().class() == &class));
    let start = home.start().clone();
    virtualcity::tasks::World::step(&mut home, me, &Action::zero(Verb::Dance)).unwrap();
    virtualcity::tasks::World::reset(&mut home, &start).unwrap();
    assert_eq!(home.graph(), &start);
}

/// Prints times of actions, in groups of five hundred, and figures that could slow actions down; `HOMES`,
/// `ACTIONS` and `FROM` set the range.
#[test]
#[ignore = "takes a minute: proofs/drift"]
#[allow(clippy::print_stdout, reason = "it is a report")]
fn actions_cost_what_the_first_did() {
    const PART: u64 = 500;
    let number =
        |name: &str, otherwise: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(otherwise);
    let (from, homes, actions) = (number("FROM", 42), number("HOMES", 1), number("ACTIONS", 5_000));
    for seed in from..from + homes {
        let (mut home, mut stream) = (home(seed, 2), Seed(seed).stream());
        let mut costs = Vec::new();
        for part in 0..actions / PART {
            let (mut times, mut done, ticks) = (Vec::new(), 0, home.world().ticks());
            for _ in 0..PART {
                let agent = *stream.pick(home.agents()).unwrap();
                let action = virtualcity::legal_action(home.graph(), agent, &mut stream);
                let fullness = fullness(&home, agent);
                let start = cpu_time::ThreadTime::now();
                let succeeded = home.set_action(agent, action).is_ok();
                let cost = start.elapsed();
                times.push(cost);
                done += u64::from(succeeded);
                costs.push(((action.verb.to_string(), succeeded, fullness), cost.as_secs_f64()));
            }
            times.sort_unstable();
            let mean = times.iter().sum::<std::time::Duration>().as_secs_f64() * 1e3 / PART as f64;
            let median = times[times.len() / 2].as_secs_f64() * 1e3;
            let (steps, contacts) = (home.world().ticks() - ticks, home.world().contacts().len());
            let bytes = home.world().save().unwrap().len() / 1000;
            println!(
                "home {seed}, actions {} : {done} done, mean {mean:.2} ms, median {median:.2} ms, {steps} steps, \
                 {contacts} contacts, {bytes} kB",
                part * PART
            );
        }
        let compared = (costs.len() / 2).min(1000);
        let ratio = like_with_like(&costs[..compared], &costs[costs.len() - compared..]);
        let (start, mut stream) = (home.start().clone(), Seed(seed).stream());
        home.reset(&start).unwrap();
        let again: f64 = (0..compared)
            .map(|_| {
                let agent = *stream.pick(home.agents()).unwrap();
                let action = virtualcity::legal_action(home.graph(), agent, &mut stream);
                let start = cpu_time::ThreadTime::now();
                drop(home.set_action(agent, action));
                start.elapsed().as_secs_f64()
            })
            .sum();
        let same = again / costs[..compared].iter().map(|(_, cost)| cost).sum::<f64>();
        println!("home {seed}, the first {compared} once more after a reset, as a part: {same:.2}");
        println!("home {seed}, ratio of the last {compared} to the first, like with like: {ratio:.2}");
    }
}

/// The kind of an action, whether it succeeded, and how full the place was.
type Sort = (String, bool, u32);

/// How often the number of things near an agent can be halved: an action looks at each of them again.
fn fullness(home: &Environment, agent: NodeId) -> u32 {
    let near = home.graph().related(agent, virtualcity::graph::Relation::Near).count();
    near.checked_ilog2().unwrap_or_default()
}

/// The cost of some actions relative to that of others: each sort is weighted by the number that both have, at
/// its mean cost in each.
fn like_with_like(first: &[(Sort, f64)], last: &[(Sort, f64)]) -> f64 {
    let by_sort = |costs: &[(Sort, f64)]| {
        let mut all: std::collections::BTreeMap<Sort, Vec<f64>> = std::collections::BTreeMap::new();
        costs.iter().for_each(|(sort, cost)| all.entry(sort.clone()).or_default().push(*cost));
        all
    };
    let mean = |costs: &[f64]| costs.iter().sum::<f64>() / costs.len() as f64;
    let (first, last) = (by_sort(first), by_sort(last));
    let both = first.iter().filter_map(|(sort, before)| Some((before, last.get(sort)?)));
    let (before, after) = both.fold((0.0, 0.0), |(a, b), (before, after)| {
        let count = before.len().min(after.len()) as f64;
        (a + count * mean(before), b + count * mean(after))
    });
    after / before
}

#[test]
fn like_is_compared_with_like() {
    let costs =
        |of: &[(&str, f64)]| of.iter().map(|(verb, cost)| ((verb.to_string(), true, 3), *cost)).collect::<Vec<_>>();
    let (first, last) =
        (costs(&[("walk", 1.0), ("walk", 3.0), ("open", 9.0)]), costs(&[("walk", 3.0), ("grab", 50.0)]));
    assert_eq!(like_with_like(&first, &last), 1.5);
}

/// A program can keep any of these in another thread, or share it between threads.
#[test]
fn public_types_can_be_sent_and_shared() {
    use virtualcity::{geometry, graph, physics, planner, procgen, relations, render, shapes, tasks};
    fn check<T: Send + Sync>() {}
    macro_rules! check {
        ($($type:ty),* $(,)?) => { $(check::<$type>();)* };
    }
    check!(graph::SceneGraph, graph::SceneBuilder, graph::Simulator, graph::Action, graph::Goal, graph::ClassTable);
    check!(graph::AssetLibrary, graph::Observation, graph::ChangeSet, graph::Refusal, graph::EditError, graph::Stream);
    check!(geometry::WallOpening, relations::Relations, relations::Explanation, relations::InputError);
    check!(physics::PhysicsWorld, physics::ShapeCache, physics::Floor, physics::Occupancy, physics::PhysicsError);
    check!(render::Renderer, render::Snapshot, render::Lighting, render::Frame, render::Camera, render::RenderError);
    check!(render::ReferencePicture, render::RayCaster, render::BoxLabel, render::Mask<'static>, render::Shot<'static>);
    check!(procgen::Apartment, procgen::Layout, procgen::Specification, shapes::Style, procgen::SpecificationError);
    check!(tasks::Task, tasks::Trial<Environment>, tasks::GoalProgress, tasks::TaskError, tasks::MinimalSets);
    check!(planner::Agent, planner::Belief, planner::KnownNodes, planner::Planner, planner::Plan, planner::Prior);
    check!(planner::Episode, planner::Trajectory, planner::Transition, planner::ScriptedPolicy, planner::Team);
    check!(Environment, Batch, MakeError, virtualcity::Recorder, virtualcity::Dataset, virtualcity::Page);
}

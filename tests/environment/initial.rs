//! The benchmark's initial environments in generated homes.
//!
//! `VC_SEEDS=20 cargo test --test environment initial` makes twenty environments per task.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

mod legal;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use vc_graph::goal::Situation;
use vc_graph::{Aabb, Edge, History, NodeId, Relation, SceneGraph, Seed, Simulator, Verb};
use vc_tasks::initial::{InitialGenerator, Purpose};
use vc_tasks::library::{Activity, Benchmark, List, THESIS_VERBS, thesis_tasks};
use virtualcity::initial::{AtHome, Catalogue, at_home};

/// Number of environments per task unless specified.
const SEEDS: u64 = 1;

type Home = AtHome<Simulator>;

/// A task's environment for a seed, or the reason why there is none.
type Made = (Activity, u64, Result<Home, String>);

/// Every task's environments, by task and seed.
static MADE: LazyLock<Vec<Made>> = LazyLock::new(all);

fn all() -> Vec<Made> {
    let seeds = std::env::var("VC_SEEDS").ok().and_then(|s| s.parse().ok()).unwrap_or(SEEDS);
    let jobs: Vec<(Activity, u64)> =
        Benchmark::v1().activities.into_iter().flat_map(|a| (0..seeds).map(move |seed| (a.clone(), seed))).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        while let Some((index, (activity, seed))) =
            Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| Some((i, jobs.get(i)?)))
        {
            done.push((index, make(activity, *seed, 2)));
        }
        done
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut done: Vec<_> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|w| w.join().unwrap()).collect()
    });
    done.sort_by_key(|(index, _)| *index);
    jobs.iter().cloned().zip(done).map(|((activity, seed), (_, made))| (activity, seed, made)).collect()
}

fn make(activity: &Activity, seed: u64, distractors: usize) -> Result<Home, String> {
    let catalogue = Catalogue::default();
    let generator = InitialGenerator::new(&catalogue).distractors(distractors);
    at_home(activity, Seed(seed), &generator, |home| Ok(Simulator::new(home))).map_err(|e| e.to_string())
}

fn each() -> impl Iterator<Item = (&'static str, u64, &'static Home)> {
    MADE.iter().filter_map(|(a, seed, made)| Some((a.id.as_str(), *seed, made.as_ref().ok()?)))
}

#[test]
fn all_of_the_benchmark_can_begin() {
    let failed: Vec<String> =
        MADE.iter().filter_map(|(a, seed, made)| Some(format!("{} {seed}: {}", a.id, made.as_ref().err()?))).collect();
    let mut homes: BTreeMap<usize, usize> = BTreeMap::new();
    let mut tries: BTreeMap<usize, usize> = BTreeMap::new();
    for (_, _, made) in each() {
        *homes.entry(made.homes).or_default() += 1;
        *tries.entry(made.initial.tries).or_default() += 1;
    }
    let credit: f64 = each().map(|(_, _, m)| m.initial.credit).sum::<f64>() / MADE.len() as f64;
    println!("{} environments; homes tried: {homes:?}; tries in the last: {tries:?}", MADE.len());
    println!("goal met at the start: {credit:.3} on average");
    let slow: Vec<_> =
        each().filter(|(_, _, m)| m.homes > 8).map(|(id, seed, m)| format!("{id} {seed}: {}", m.homes)).collect();
    println!("more than 8 homes: {slow:?}");
    assert!(failed.is_empty(), "{} failed:\n{}", failed.len(), failed.join("\n"));
}

#[test]
fn no_goal_holds_at_the_start_and_scenes_are_sound() {
    for (activity, seed, made) in MADE.iter().filter_map(|(a, seed, m)| Some((a, seed, m.as_ref().ok()?))) {
        let history = History::default();
        let initial = &made.initial;
        let now = Situation::new(&initial.scene, initial.agent, &history);
        assert!(!activity.goal.holds(&now) && !initial.task.goal.holds(&now), "{} {seed}", activity.id);
        assert!(initial.credit < 1.0);
        let wrong: Vec<String> = initial.scene.validate().iter().map(ToString::to_string).collect();
        assert!(wrong.is_empty(), "{} {seed}: {wrong:?}", activity.id);
    }
}

#[test]
fn what_was_there_stays_where_it_was() {
    for (id, seed, made) in each() {
        let (before, after) = (&made.bare, &made.initial.scene);
        for node in before.nodes() {
            let now = after.node(node.id()).unwrap_or_else(|| panic!("{id} {seed}: {} is gone", node.label()));
            assert_eq!(now.pose(), node.pose(), "{id} {seed}: {}", node.label());
            assert_eq!(now.spec().scale, node.spec().scale);
        }
        let moved = before.edges().find(|edge| !after.has(*edge));
        assert_eq!(moved, None, "{id} {seed}");
        assert_eq!(after.len(), before.len() + made.initial.added.len());
    }
}

#[test]
fn what_is_added_is_where_it_should_be_and_free() {
    for (id, seed, made) in each() {
        let scene = &made.initial.scene;
        for added in &made.initial.added {
            let label = scene.label(added.id);
            if let Some(place) = added.place {
                assert!(scene.has(Edge::new(added.id, place.relation, place.at)), "{id} {seed}: {label}");
                assert!(stands(scene, added.id, place.at), "{id} {seed}: {label} {:?}", place);
            }
            let besides = scene.support_chain(added.id);
            let aabb = scene.node(added.id).unwrap().aabb().unwrap();
            // Compares its box with the parts of the objects that were there before.
            let hit = scene.nodes().find(|n| {
                let other = n.id() < added.id && n.kind() != vc_graph::NodeKind::Room && !besides.contains(&n.id());
                other && parts(scene, n.id()).iter().any(|b| share_space(&aabb, b))
            });
            let seated = added.purpose == Purpose::Agent;
            assert!(seated || hit.is_none(), "{id} {seed}: {label} and {}", hit.unwrap().label());
        }
    }
}

/// Whether an object's box is above, in or under that of its support or container.
fn stands(scene: &SceneGraph, id: NodeId, at: NodeId) -> bool {
    let sits = scene.related(id, Relation::SittingOn).next().is_some();
    let (thing, carrier) = (scene.node(id).unwrap().aabb().unwrap(), scene.node(at).unwrap().aabb().unwrap());
    sits || (0..2).all(|i| thing.min[i] < carrier.max[i] && carrier.min[i] < thing.max[i])
}

/// Boxes of an object's parts, from its asset.
fn parts(scene: &SceneGraph, id: NodeId) -> Vec<Aabb> {
    let node = scene.node(id).unwrap();
    let Some(asset) = node.spec().asset.and_then(|a| scene.assets().get(a)) else {
        return node.aabb().into_iter().collect();
    };
    let boxed = |part: &vc_graph::asset::Part| {
        let (low, high) = part.extent();
        let (offset, half) = ((low.coords + high.coords) / 2.0, (high - low) / 2.0);
        vc_graph::Bounds { offset, half, frame: vc_graph::BoundsFrame::Object }.aabb(node.pose().unwrap())
    };
    asset.parts.iter().map(boxed).collect()
}

fn share_space(a: &Aabb, b: &Aabb) -> bool {
    (0..3).all(|i| a.min[i] + 0.003 < b.max[i] && b.min[i] + 0.003 < a.max[i])
}

/// Tasks of the thesis with objects that no generated home has, although it has the rooms: another person, a
/// ceiling fan, an air conditioner, a piano.
const NOT_AT_HOME: [&str; 6] = ["indoor-3", "indoor-22", "outdoor-30", "outdoor-34", "outdoor-39", "outdoor-46"];

#[test]
fn the_thesis_tasks_can_begin_where_the_home_has_what_they_name() {
    let outside = ["beach", "garage", "garden", "street"];
    let classes = vc_graph::ClassTable::builtin();
    let tasks = [List::Indoor, List::Outdoor].into_iter().flat_map(thesis_tasks);
    let at_home = tasks.filter(|t| {
        t.unknown_places(&classes).next().is_none()
            && !t.places.iter().any(|p| outside.contains(&p.as_str()))
            && !NOT_AT_HOME.contains(&t.id.as_str())
    });
    let at_home: Vec<Activity> = at_home.collect();
    let failed: Vec<String> =
        at_home.iter().filter_map(|t| Some(format!("{}: {}", t.id, make(t, 0, 0).err()?))).collect();
    println!("{} of 100 are at home, {} of them cannot begin", at_home.len(), failed.len());
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn the_same_seed_gives_the_same_scene() {
    let benchmark = Benchmark::v1();
    for id in ["put_fridge-01", "tidy_toys-06", "move_about-03"] {
        let activity = benchmark.get(id).unwrap();
        let (one, two, other) =
            (make(activity, 3, 2).unwrap(), make(activity, 3, 2).unwrap(), make(activity, 4, 2).unwrap());
        assert_eq!(one, two);
        assert_ne!(one.initial.scene, other.initial.scene);
    }
}

#[test]
fn an_agent_that_knows_everything_has_a_plan_for_each_and_uses_all_verbs() {
    let mut verbs: BTreeSet<Verb> = BTreeSet::new();
    let mut without = Vec::new();
    for (id, seed, made) in each() {
        let mut scene = made.initial.scene.clone();
        match vc_planner::plan(&mut scene, made.initial.agent, &made.initial.task.goal, &History::default()) {
            Ok(plan) => verbs.extend(plan.actions.iter().map(|a| a.verb)),
            Err(why) => without.push(format!("{id} {seed}: {why}")),
        }
    }
    println!("verbs in plans: {verbs:?}");
    assert!(without.is_empty(), "{} without a plan:\n{}", without.len(), without.join("\n"));
    let missing: Vec<&Verb> = THESIS_VERBS.iter().filter(|v| !verbs.contains(v)).collect();
    assert!(missing.is_empty(), "no plan has {missing:?}");
}

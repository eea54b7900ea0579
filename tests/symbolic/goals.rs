//! The agent reaches goals: those of the Embodied Agent Interface under full knowledge, and everyday ones in
//! VirtualHome's scenes under partial observability of its room.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use vc_graph::format::eai;
use vc_graph::goal::Situation;
use vc_graph::{Action, ClassTable, Goal, SceneGraph, Simulator, Verb};
use vc_planner::{Episode, EpisodeOptions, PlannerPolicy, Policy};
use vc_tasks::{Outcome, Task, household};

/// Unreachable goals, with the reasons.
const UNREACHABLE: [(&str, &str); 1] = [("file688_1", "wants one glass in both hands at once")];

fn attempt(scene: &SceneGraph, task: &Task, policy: &mut dyn Policy, seed: u64) -> (Episode, Simulator) {
    let mut world = Simulator::new(scene.clone());
    let episode = EpisodeOptions::seeded(seed).episode(policy, task, &mut world, &mut |_| {});
    (episode, world)
}

#[test]
fn eai_goals_with_full_knowledge() {
    let Some(goals) = vc_testkit::data::text("eai/goals_dev.json") else { return };
    let tasks = eai::read_tasks(&goals).unwrap();
    let (mut won, mut attempted, mut counted, mut all, mut longer) = (0, 0, 0, 0, Vec::new());
    for line in vc_testkit::data::text("eai/programs_dev.jsonl.gz").unwrap().lines() {
        let record = eai::read_record(line).unwrap();
        let Some(wanted) = tasks.get(&record.id) else { continue };
        let scene = record.initial.build(&record.id, &ClassTable::builtin()).unwrap();
        let me = scene.agents()[0];
        let task = Task::new(&wanted.title, wanted.goal.clone());
        let (episode, world) = attempt(&scene, &task, &mut PlannerPolicy::oracle(), 0);
        attempted += 1;
        let unreachable = UNREACHABLE.iter().any(|(id, _)| *id == record.id);
        assert_eq!(episode.outcome == Outcome::Won, !unreachable, "{}: {} {:?}", record.id, task.goal, episode);
        if unreachable {
            continue;
        }
        won += 1;
        // The formula states the same with an order. No plan is longer than the effective actions of the
        // human-written program plus two.
        let now = Situation::new(world.graph(), me, world.history());
        let formula = wanted.formula.as_ref().unwrap();
        assert!(formula.holds(&now), "{}", record.id);
        let actions: Vec<Action> = record.program.actions().collect();
        let most = effective(&scene, &actions, &[&wanted.goal, formula]);
        (all, counted) = (all + actions.len(), counted + most);
        if episode.steps > most + 2 {
            longer.push(format!("{}: {} steps against {most} of {}", record.id, episode.steps, actions.len()));
        }
    }
    println!("{counted} of {all} actions of the programs count");
    assert!(longer.is_empty(), "{longer:#?}");
    assert_eq!(attempted, 62);
    assert!(won >= 60, "{won}");
}

/// The number of effective actions of a program. Actions do not count if they change nothing (finding an object
/// at hand, looking at it) or only the facing, and neither the goals nor later actions need them.
fn effective(scene: &SceneGraph, program: &[Action], goals: &[&Goal]) -> usize {
    let mut kept = program.to_vec();
    let (reached, _) = replayed(scene, program, goals);
    for index in (0..program.len()).rev() {
        let shorter: Vec<Action> = [&kept[..index], &kept[index + 1..]].concat();
        let idle = matches!(kept[index].verb, Verb::Find | Verb::LookAt | Verb::TurnTo | Verb::PointAt);
        if !idle && !changes_nothing(scene, &kept, index) {
            continue;
        }
        let (still, refused) = replayed(scene, &shorter, goals);
        if still == reached && refused <= replayed(scene, &kept, goals).1 {
            kept = shorter;
        }
    }
    kept.len()
}

/// The goals that hold after a program, and the number of its refused actions.
fn replayed(scene: &SceneGraph, program: &[Action], goals: &[&Goal]) -> (Vec<bool>, usize) {
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene.clone());
    let refused = program.iter().filter(|action| world.step(me, action).is_err()).count();
    let now = Situation::new(world.graph(), me, world.history());
    (goals.iter().map(|goal| goal.holds(&now)).collect(), refused)
}

fn changes_nothing(scene: &SceneGraph, program: &[Action], index: usize) -> bool {
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene.clone());
    program[..index].iter().for_each(|action| drop(world.step(me, action)));
    world.step(me, &program[index]).is_ok_and(|changes| changes.is_empty())
}

#[test]
fn everyday_goals_seeing_only_the_room() {
    let (mut made_sense, mut scenes) = (std::collections::BTreeSet::new(), 0);
    for number in vc_testkit::data::SCENES {
        let Some(scene) = vc_testkit::data::scene(number) else { return };
        scenes += 1;
        for task in household() {
            if task.obstacles(&scene).is_empty() {
                win_with_some_seeds(&scene, &task, &format!("scene {number}"));
                made_sense.insert(task.title);
            }
        }
    }
    assert_eq!(scenes, 5);
    assert!(made_sense.len() >= 40, "{}", made_sense.len());
}

#[test]
fn everyday_goals_in_the_apartment() {
    let home = vc_testkit::data::apartment();
    let tasks: Vec<Task> = household().into_iter().filter(|t| t.obstacles(&home).is_empty()).collect();
    assert!(tasks.len() >= 40, "{}", tasks.len());
    for task in tasks {
        win_with_some_seeds(&home, &task, "apartment");
    }
}

fn win_with_some_seeds(scene: &SceneGraph, task: &Task, name: &str) {
    for seed in 0..3 {
        for policy in [&mut PlannerPolicy::best() as &mut dyn Policy, &mut PlannerPolicy::faithful()] {
            let (episode, _) = attempt(scene, task, policy, seed);
            let who = policy.name();
            assert_eq!(episode.outcome, Outcome::Won, "{name}, {}, {who}, seed {seed}: {episode:?}", task.title);
        }
    }
}

#[test]
fn same_seed_same_trajectory() {
    let home = vc_testkit::data::apartment();
    let task = Task::new("apples", "On(apple, kitchentable), 3 & Closed(fridge)".parse().unwrap());
    let run = |seed| {
        let (episode, world) = attempt(&home, &task, &mut PlannerPolicy::faithful(), seed);
        assert_eq!(episode.outcome, Outcome::Won);
        (episode.digest, world.history().events().to_vec())
    };
    assert_eq!(run(3), run(3));
    assert_ne!(run(3).1, run(4).1);
}

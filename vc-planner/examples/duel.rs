//! Policies on given scenes and goals, for `proofs/judge` to compare with others.
//!
//! Reads a line of JSON for each instance: `name`, `graph` (a VirtualHome environment graph),
//! `goal` (Watch-And-Help's), `agent` (its number) and `limit` (steps). Writes a line for each
//! instance and policy: whether it won, in how many steps, the classes of what it opened, and
//! why it lost. `cargo run --release -p vc-planner --example duel -- planner oracle < FILE`

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops where something is wrong")]

use serde::{Deserialize, Serialize};
use vc_graph::format::virtualhome::EnvironmentGraph;
use vc_graph::{ClassTable, NodeId, SceneGraph, Seed, Simulator, Verb};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Prior};
use vc_tasks::format::watch_and_help;
use vc_tasks::{Outcome, Task};

#[derive(Deserialize)]
struct Instance {
    name: String,
    graph: EnvironmentGraph,
    goal: serde_json::Value,
    agent: u32,
    limit: usize,
}

#[derive(Serialize)]
struct Result {
    name: String,
    policy: String,
    won: bool,
    steps: usize,
    opened: Vec<String>,
    actions: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<String>,
}

fn main() {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let names = if names.is_empty() { vec!["planner".to_owned()] } else { names };
    for line in std::io::stdin().lines() {
        let instance: Instance = serde_json::from_str(&line.unwrap()).unwrap();
        let scene = instance.graph.build(&instance.name, &ClassTable::builtin()).unwrap();
        for name in &names {
            println!("{}", serde_json::to_string(&attempt(&instance, &scene, name)).unwrap());
        }
    }
}

fn policy(name: &str) -> Box<dyn Policy> {
    match name {
        "planner" => Box::new(PlannerPolicy::best()),
        "uniform" => Box::new(PlannerPolicy::best().with_prior(Prior::Uniform)),
        "faithful" => Box::new(PlannerPolicy::faithful()),
        "oracle" => Box::new(PlannerPolicy::oracle()),
        other => panic!("no policy `{other}`; there are planner, uniform, faithful and oracle"),
    }
}

fn attempt(instance: &Instance, scene: &SceneGraph, name: &str) -> Result {
    let mut task = Task::new(&*instance.name, watch_and_help::read(&instance.goal.to_string()).unwrap());
    task.step_limit = instance.limit;
    let (mut opened, mut actions) = (Vec::new(), Vec::new());
    let how = EpisodeOptions { agent: Some(NodeId(instance.agent)), seed: Seed(1), ..EpisodeOptions::default() };
    let mut world = Simulator::new(scene.clone());
    let episode = how.episode(policy(name).as_mut(), &task, &mut world, &mut |step| {
        let class = step.action.object.and_then(|id| scene.node(id)).map(|n| n.class().to_string());
        opened.extend(class.filter(|_| step.action.verb == Verb::Open));
        actions.push(step.described.clone() + step.refused.as_deref().map_or("", |_| " (refused)"));
    });
    let won = episode.outcome == Outcome::Won;
    Result {
        name: instance.name.clone(),
        policy: name.into(),
        won,
        steps: episode.steps,
        opened,
        actions,
        why: episode.reason,
    }
}

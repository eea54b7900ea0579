//! Goals with words of time: each is judged on the trace, pursued by stages, or given up with the part that stands in
//! the way.

use vc_graph::goal::Trace;
use vc_graph::{Draft, Event, Goal, NodeId, SceneBuilder, SceneGraph, Scope, Simulator};
use vc_planner::{Newcomer, Policy, Resident, Run, Trajectory};
use vc_tasks::{Outcome, Task};

/// A kitchen with milk and an egg in the fridge, which is closed, and an apple on the table.
fn kitchen() -> SceneGraph {
    let mut scene = SceneBuilder::new("kitchen");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(kitchen, Draft::new("microwave")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    scene.add_in(fridge, Draft::new("milk")).unwrap();
    scene.add_in(fridge, Draft::new("egg")).unwrap();
    scene.add_on(table, Draft::new("apple")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    scene.build()
}

/// Goals that can be reached, with the most actions that an oracle may take.
const REACHED: &[(&str, usize)] = &[
    ("Open(fridge) then Closed(fridge)", 3),
    ("eventually Open(fridge) & Closed(fridge)", 3),
    ("Closed(fridge) then Holds(milk)", 3),
    ("Open(fridge) then Closed(fridge) then Holds(milk)", 5),
    ("eventually Holds(apple) & On(apple, kitchen_table)", 3),
    ("Holds(apple) then On(apple, kitchen_table) then did wave()", 4),
    ("did wave() then did dance() then did wave()", 3),
    ("Closed(fridge) until Holds(apple)", 2),
    ("(Closed(fridge) until Holds(apple)) & Holds(milk)", 6),
    ("always Closed(fridge) & Holds(apple)", 2),
    ("Holds(apple) before Open(fridge)", 2),
    ("(Holds(apple) before Open(fridge)) & Holds(milk)", 6),
    ("within 2 steps Holds(apple) & Holds(milk)", 6),
    ("at end Holds(milk) & eventually Holds(apple)", 6),
    ("forall ?f: fridge. (Open(?f) then Closed(?f))", 3),
    ("!(always Closed(fridge)) & Closed(fridge)", 3),
    ("always Closed(fridge) & Holds(milk) | eventually Open(microwave)", 2),
];

/// Goals that cannot be reached, and what the reason names.
const LOST: &[(&str, &str)] = &[
    ("always Closed(fridge) & Holds(egg)", "`always Closed(fridge)`: `open fridge"),
    ("within 1 steps Holds(milk)", "`within 1 steps Holds(me, milk)`"),
    ("Closed(fridge) until Holds(milk)", "`Closed(fridge) until Holds(me, milk)`: `open fridge"),
    ("always !Holds(milk) & Inside(milk, microwave)", "`always !Holds(me, milk)`: `grab milk"),
    ("Open(fridge) until Holds(apple)", "`Open(fridge) until Holds(me, apple)` does not hold any more"),
    ("always (Closed(fridge) => eventually Open(microwave)) & Holds(apple)", "does not plan for words of time"),
];

fn policies() -> [Box<dyn Policy>; 4] {
    [
        Box::new(Resident::default()),
        Box::new(Newcomer::best()),
        Box::new(Newcomer::faithful()),
        Box::new(Newcomer::stranger()),
    ]
}

fn attempt(policy: &mut dyn Policy, text: &str) -> (Trajectory, Goal) {
    let task = Task { step_limit: 60, ..Task::new("in time", text.parse().unwrap()) };
    (Trajectory::record(&Run::default(), policy, &task, &mut Simulator::new(kitchen())), task.goal)
}

/// Whether a goal holds on the trace of a record, and how much of it.
fn on_trace(trajectory: &Trajectory, goal: &Goal) -> (bool, f64) {
    let me: NodeId = trajectory.header.agent;
    let mut scenes = trajectory.replay(&kitchen()).unwrap().into_iter();
    let mut trace = Trace::new(scenes.next().unwrap(), me);
    for (graph, step) in scenes.zip(&trajectory.steps) {
        trace.push(graph, [Event { agent: me, action: step.action }]);
    }
    (goal.holds_on(&trace), goal.score_on(&trace))
}

#[test]
fn stages_are_gone_through_in_order() {
    for (text, most) in REACHED {
        for mut policy in policies() {
            let (trajectory, goal) = attempt(policy.as_mut(), text);
            let told = || {
                let done: Vec<&str> = trajectory.steps.iter().map(|step| &*step.described).collect();
                format!("{} {text}: {done:?}", policy.name())
            };
            assert_eq!(trajectory.summary.outcome, Outcome::Won, "{} {:?}", told(), trajectory.summary);
            assert_eq!(on_trace(&trajectory, &goal), (true, 1.0), "{}", told());
            assert!(policy.name() != "oracle" || trajectory.steps.len() <= *most, "{}", told());
            assert!(trajectory.check(&kitchen()).is_empty(), "{}: {:?}", told(), trajectory.check(&kitchen()));
        }
    }
}

#[test]
fn what_stands_in_the_way_is_told() {
    for (text, why) in LOST {
        for mut policy in policies() {
            let (trajectory, goal) = attempt(policy.as_mut(), text);
            let told = || format!("{} {text}: {:?}", policy.name(), trajectory.summary);
            assert_eq!(trajectory.summary.outcome, Outcome::Lost, "{}", told());
            let (holds, score) = on_trace(&trajectory, &goal);
            assert!(!holds && score == trajectory.summary.score && score < 1.0, "{}", told());
            assert!(trajectory.check(&kitchen()).is_empty(), "{}", told());
            if policy.name() == "oracle" {
                assert!(trajectory.summary.reason.as_ref().unwrap().contains(why), "{}", told());
                assert!(trajectory.steps.len() <= 2, "{}", told());
            }
        }
    }
}

/// The rewards of transitions are those on the trace.
#[test]
fn transitions_sum_to_the_score_on_the_trace() {
    let (trajectory, goal) = attempt(&mut Resident::default(), "Open(fridge) then Closed(fridge) then Holds(milk)");
    let transitions = trajectory.transitions(&kitchen(), Scope::Room).unwrap();
    let sum: f64 = transitions.iter().map(|t| t.reward).sum();
    let start = Trace::new(kitchen(), trajectory.header.agent);
    assert!((sum - (1.0 - goal.score_on(&start))).abs() < 1e-9, "{sum}");
    assert!(transitions.last().unwrap().terminated);
}

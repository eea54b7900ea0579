//! Goals with words of time: each is judged on the trace, pursued by stages, or given up with the part that stands in
//! the way.

use vc_graph::goal::EpisodeTrace;
use vc_graph::{Draft, Event, Goal, NodeId, SceneBuilder, SceneGraph, Scope, Simulator};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Trajectory};
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
        Box::new(PlannerPolicy::oracle()),
        Box::new(PlannerPolicy::best()),
        Box::new(PlannerPolicy::faithful()),
        Box::new(PlannerPolicy::in_unknown_home()),
    ]
}

fn attempt(policy: &mut dyn Policy, text: &str) -> (Trajectory, Goal) {
    let task = Task { step_limit: 60, ..Task::new("in time", text.parse().unwrap()) };
    (Trajectory::record(&EpisodeOptions::default(), policy, &task, &mut Simulator::new(kitchen())), task.goal)
}

/// Whether a goal holds on the trace of a record, and how much of it.
fn on_trace(trajectory: &Trajectory, goal: &Goal) -> (bool, f64) {
    let me: NodeId = trajectory.header.agent;
    let mut scenes = trajectory.replay(&kitchen()).unwrap().into_iter();
    let mut trace = EpisodeTrace::new(scenes.next().unwrap(), me);
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
    let (trajectory, goal) = attempt(&mut PlannerPolicy::oracle(), "Open(fridge) then Closed(fridge) then Holds(milk)");
    let transitions = trajectory.transitions(&kitchen(), Scope::Room).unwrap();
    let sum: f64 = transitions.iter().map(|t| t.reward).sum();
    let start = EpisodeTrace::new(kitchen(), trajectory.header.agent);
    assert!((sum - (1.0 - goal.score_on(&start))).abs() < 1e-9, "{sum}");
    assert!(transitions.last().unwrap().terminated);
}

/// A goal with words of time that has been broken is lost for a reason, whoever broke it.
#[test]
fn what_was_broken_is_told() {
    let task = Task::new("in time", "Holds(apple) until Holds(milk)".parse().unwrap());
    let episode = vc_planner::run_episode(&mut PlannerPolicy::best(), &task, &mut Simulator::new(kitchen()));
    assert_eq!(episode.outcome, Outcome::Lost);
    assert!(episode.reason.unwrap().contains("does not hold any more"));
    let me = kitchen().agents()[0];
    for (text, actions, is_lost) in [
        ("always Closed(fridge)", &["walk fridge.2", "open fridge.2"][..], true),
        ("always Closed(fridge)", &["walk fridge.2"], false),
        ("eventually Open(fridge)", &["dance", "dance"], false),
        ("within 1 steps Open(fridge)", &["walk fridge.2"], true),
        ("within 2 steps Open(fridge)", &["walk fridge.2"], false),
        ("Holds(apple) before Open(fridge)", &["walk fridge.2", "open fridge.2"], true),
        ("!(eventually Open(fridge))", &["walk fridge.2", "open fridge.2"], true),
        ("always Closed(fridge) | Holds(milk)", &["walk fridge.2", "open fridge.2"], false),
        ("forall ?f: fridge. always Closed(?f)", &["walk fridge.2", "open fridge.2"], true),
        ("always (Open(fridge) => eventually Closed(fridge))", &["walk fridge.2", "open fridge.2"], false),
    ] {
        let task = Task::new("in time", text.parse().unwrap());
        let mut trial = vc_tasks::Trial::new(Simulator::new(kitchen()), task, me);
        let lost = actions.iter().map(|action| trial.step(&action.parse().unwrap()).lost).last().unwrap();
        assert_eq!(lost.is_some(), is_lost, "{text}: {lost:?}");
    }
}

/// Nothing is won by waiting once a goal is lost.
#[test]
fn nobody_is_rewarded_after_a_breach() {
    let me = kitchen().agents()[0];
    let task = Task::new("in time", "always Closed(fridge) & Holds(apple)".parse().unwrap());
    let mut trial = vc_tasks::Trial::new(Simulator::new(kitchen()), task, me);
    assert!(trial.step(&"walk fridge.2".parse().unwrap()).lost.is_none());
    let breach = trial.step(&"open fridge.2".parse().unwrap());
    assert!(breach.lost.is_some() && breach.reward <= 0.0, "{breach:?}");
    for _ in 0..5 {
        let idle = trial.step(&"dance".parse().unwrap());
        assert!(idle.lost.is_some() && !idle.terminated && idle.reward <= 0.0, "{idle:?}");
    }
    trial.reset().unwrap();
    assert!(trial.step(&"dance".parse().unwrap()).lost.is_none());
}

/// Misspelt classes do not win by being absent; classes of which the scene has no object do.
#[test]
fn misspelt_classes_win_nothing() {
    let me = kitchen().agents()[0];
    let attempt = |text: &str| {
        let task = Task::new("t", text.parse().unwrap());
        let mut trial = vc_tasks::Trial::new(Simulator::new(kitchen()), task.clone(), me);
        let step = trial.step(&"dance".parse().unwrap());
        let episode = vc_planner::run_episode(&mut PlannerPolicy::oracle(), &task, &mut Simulator::new(kitchen()));
        assert_eq!(step.terminated, episode.outcome == Outcome::Won, "{text}: {step:?} {episode:?}");
        let told: Vec<String> = task.obstacles(&kitchen()).iter().map(ToString::to_string).collect();
        (episode, step, told.join("; "))
    };
    for text in [
        "!On(mugg, kitchen_table)",
        "On(mugg, kitchen_table), = 0",
        "On(mugg, kitchen_table), <= 2",
        "always !Broken(mugg)",
        "forall ?x: mugg. On(?x, kitchen_table)",
        "On(mugg, kitchen_table) => Open(fridge)",
        "at most 1 ?x: mugg. Clean(?x)",
        "pairs ?x: mugg, ?y: kitchen_table. On(?x, ?y)",
    ] {
        let (episode, step, told) = attempt(text);
        assert_eq!((episode.outcome, episode.steps), (Outcome::Lost, 0), "{text}");
        assert!(step.lost.is_some() && step.reward == 0.0, "{text}");
        assert!(episode.reason.unwrap().contains("no class `mugg` (did you mean `mug`?)"), "{text}");
        assert!(told.contains("`mugg` (did you mean "), "{text}: {told}");
    }
    for text in ["!On(mug, kitchen_table)", "forall ?x: mug. On(?x, kitchen_table)", "On(mug, kitchen_table), = 0"] {
        assert_eq!(attempt(text).0.outcome, Outcome::Won, "{text}");
    }
}

//! Records contain the observations, which are checked, and allow the states to be reconstructed.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::homes;

use homes::{GOALS, home};
use vc_graph::{Action, NodeId, SceneGraph, Scope, Simulator, Verb};
use vc_planner::{EpisodeOptions, Fault, PlannerPolicy, Policy, RandomPolicy, ScriptedPolicy, Trajectory};
use vc_tasks::{Outcome, Task};

fn record(run: &EpisodeOptions, policy: &mut dyn Policy, scene: &SceneGraph, goal: &str) -> Trajectory {
    let task = Task { step_limit: 60, ..Task::new("recorded", goal.parse().unwrap()) };
    Trajectory::record(run, policy, &task, &mut Simulator::new(scene.clone()))
}

#[test]
fn what_was_seen_is_recorded_and_checked() {
    let scene = home(4);
    let scopes = [Scope::Room, Scope::Room, Scope::Whole];
    let policies =
        [&mut PlannerPolicy::best() as &mut dyn Policy, &mut RandomPolicy::default(), &mut PlannerPolicy::oracle()];
    for (policy, scope) in policies.into_iter().zip(scopes) {
        let good = record(&EpisodeOptions::seeded(4), policy, &scene, GOALS[1]);
        assert_eq!(good.header.scope, scope, "{}", policy.name());
        let own = |f: &Fault| !matches!(f, Fault::Duplicate(_));
        assert!(!good.check(&scene).iter().any(own), "{}: {:?}", policy.name(), good.check(&scene));
        let tamper: [fn(&mut vc_planner::Step); 4] = [
            |step| step.room = Some("attic.99".into()),
            |step| step.room = None,
            |step| step.seen += 1,
            |step| step.sight = "0123456789abcdef".into(),
        ];
        for change in tamper {
            let mut other = good.clone();
            change(&mut other.steps[1]);
            let faults: Vec<Fault> = other.check(&scene).into_iter().filter(own).collect();
            assert_eq!(faults, [Fault::OtherSight(2)], "{}", policy.name());
        }
    }
    // A record that claims a larger scope of observation.
    let mut other = record(&EpisodeOptions::seeded(4), &mut PlannerPolicy::best(), &scene, GOALS[1]);
    other.header.scope = Scope::Whole;
    let blamed = other.check(&scene).iter().filter(|f| matches!(f, Fault::OtherSight(_))).count();
    assert_eq!(blamed, other.steps.len());
}

#[test]
fn what_was_seen_can_be_kept_whole() {
    let scene = home(5);
    let run = EpisodeOptions { keeps_observations: true, ..EpisodeOptions::seeded(5) };
    let whole = record(&run, &mut PlannerPolicy::best(), &scene, GOALS[0]);
    assert_eq!(whole.check(&scene), []);
    let told = whole.steps.iter().map(|s| s.observation.as_ref().unwrap().to_string());
    let seen = whole.transitions(&scene, Scope::Room).unwrap().into_iter().map(|t| t.observation);
    assert!(told.eq(seen));
    let again = Trajectory::read_json_lines(&whole.to_json_lines().unwrap()).unwrap();
    assert_eq!(again, whole);
    let mut other = whole.clone();
    other.steps[0].observation = other.steps[1].observation.clone();
    other.steps[0].observation.as_mut().unwrap()["room"] = "attic.99".into();
    assert_eq!(other.check(&scene), [Fault::OtherSight(1)]);
    // Without the option there are only the digests, with the same values.
    let brief = record(&EpisodeOptions::seeded(5), &mut PlannerPolicy::best(), &scene, GOALS[0]);
    assert!(brief.steps.iter().all(|s| s.observation.is_none()));
    assert!(brief.steps.iter().map(|s| &s.sight).eq(whole.steps.iter().map(|s| &s.sight)));
    assert!(brief.to_json_lines().unwrap().len() < whole.to_json_lines().unwrap().len());
}

#[test]
fn a_record_gives_the_states_back() {
    let scene = home(6);
    for policy in [&mut PlannerPolicy::best() as &mut dyn Policy, &mut RandomPolicy::default()] {
        let trajectory = record(&EpisodeOptions::seeded(6), policy, &scene, GOALS[1]);
        let states = trajectory.replay(&scene).unwrap();
        assert_eq!(states.len(), trajectory.steps.len() + 1);
        assert_eq!(states[0], scene);
        for (step, state) in trajectory.steps.iter().zip(&states[1..]) {
            assert_eq!(state.digest().to_string(), step.digest, "{}", step.step);
        }
        let goal = &trajectory.header.goal;
        let (last, me) = (states.last().unwrap(), trajectory.header.agent);
        let history = vc_graph::History::default();
        let holds = goal.holds(&vc_graph::goal::Situation::new(last, me, &history));
        assert_eq!(holds, trajectory.summary.outcome == Outcome::Won);
        assert_eq!(trajectory.replay(&home(7)), Err(Fault::OtherScene));
    }
    let mut odd = record(&EpisodeOptions::seeded(6), &mut PlannerPolicy::best(), &scene, GOALS[1]);
    odd.steps[0].action = Action::one(Verb::Open, NodeId(u32::MAX));
    assert!(matches!(odd.replay(&scene), Err(Fault::Refused(1, _))));
}

/// A refused action is recorded, and changes nothing in a replay.
#[test]
fn refused_steps_are_skipped() {
    let scene = home(0);
    let fridge = scene.of_class("fridge")[0];
    let script = [Verb::Walk, Verb::Open].map(|verb| Action::one(verb, fridge));
    let mut trajectory =
        record(&EpisodeOptions::seeded(0), &mut ScriptedPolicy::new(script.to_vec()), &scene, "Open(fridge)");
    assert_eq!(trajectory.check(&scene), []);
    trajectory.steps[1].refused = Some("the door is stuck".into());
    assert!(trajectory.check(&scene).contains(&Fault::NotRefused(2)));
    let states = trajectory.replay(&scene).unwrap();
    assert_eq!(states[1], states[2]);
}

/// Headings and points go through records and replays as they are.
#[test]
fn aims_are_recorded() {
    let scene = home(0);
    let fridge = scene.of_class("fridge")[0];
    let script = [Action::walk(fridge).turned(-12.5).unwrap(), "turn_to yaw 90".parse().unwrap(), Action::open(fridge)];
    let trajectory =
        record(&EpisodeOptions::seeded(0), &mut ScriptedPolicy::new(script.to_vec()), &scene, "Open(fridge)");
    assert_eq!(trajectory.check(&scene), []);
    let text = trajectory.to_json_lines().unwrap();
    assert!(text.contains("yaw -12.5"), "{text}");
    let again = Trajectory::read_json_lines(&text).unwrap();
    assert!(again.steps.iter().map(|step| step.action).eq(script));
    assert_eq!(again.replay(&scene).unwrap().len(), 4);
    let answer = vc_planner::language::read_answer("1. walk at 1.20 0.40 yaw 90", &scene);
    assert_eq!(answer, Ok(vc_planner::language::Answer::Act("walk at 1.2 0.4 yaw 90".parse().unwrap())));
}

#[test]
fn a_header_is_whole_or_refused() {
    let scene = home(2);
    let trajectory = record(&EpisodeOptions::seeded(2), &mut PlannerPolicy::best(), &scene, GOALS[0]);
    let text = trajectory.to_json_lines().unwrap();
    let (first, rest) = text.split_once('\n').unwrap();
    for field in ["scene", "digest", "task", "goal", "agent", "policy", "scope", "seed"] {
        let mut header: serde_json::Value = serde_json::from_str(first).unwrap();
        header.as_object_mut().unwrap().remove(field).unwrap();
        let error = Trajectory::read_json_lines(&format!("{header}\n{rest}")).unwrap_err().to_string();
        assert!(error.starts_with("line 1") && error.contains(field), "{error}");
    }
}

/// A recorder of bodies writes another format, and the error says so.
#[test]
fn records_with_bodies_are_told_apart() {
    let text = "{\"scene\":\"home\",\"digest\":\"0\",\"agent\":\"character.4\",\"task\":\"t\",\"goal\":\"Holds(mug)\"}\n\
                {\"step\":1}\n{\"outcome\":\"won\"}\n";
    let error = Trajectory::read_json_lines(text).unwrap_err().to_string();
    assert!(error.contains("with bodies") && error.contains("`Recorder`"), "{error}");
}

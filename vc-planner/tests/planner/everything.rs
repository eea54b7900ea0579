//! Every action and every state that is possible can be planned in a home with the necessary things.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::BTreeSet;

use vc_graph::goal::{Predicate, Situation, Term};
use vc_graph::rule::{Argument, Effect};
use vc_graph::{Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, Simulator, State, Verb, Word};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, plan};
use vc_tasks::format::alfred::Template;
use vc_tasks::{Outcome, Task};

/// States that no verb brings about: they exist from the beginning, or arise by themselves.
const NOBODYS: [State; 9] = [
    State::Raw,
    State::Broken,
    State::Wet,
    // A vessel that is poured out does not become empty.
    State::Empty,
    State::Frozen,
    State::OnFire,
    State::Dusty,
    State::Stained,
    State::Future,
];

/// A home with something for every verb.
fn home() -> SceneGraph {
    let mut scene = SceneBuilder::new("rich");
    let [kitchen, living, garage] = ["kitchen", "living_room", "garage"].map(|r| scene.add(Draft::new(r)).unwrap());
    let mut fixed = |room: NodeId, class: &str| scene.add_in(room, Draft::new(class)).unwrap();
    let [table, counter, fridge] = ["kitchen_table", "kitchen_counter", "fridge"].map(|c| fixed(kitchen, c));
    for class in ["stove", "dishwasher", "sink"] {
        fixed(kitchen, class);
    }
    let mut as_left = |class: &str, state| scene.add_in(garage, Draft::new(class).state(state)).unwrap();
    as_left("closet", State::Open);
    as_left("washing_machine", State::On);
    as_left("freezer", State::PluggedOut);
    let mut fixed = |room: NodeId, class: &str| scene.add_in(room, Draft::new(class)).unwrap();
    let [desk, _, _, _] = ["desk", "sofa", "bed", "television"].map(|c| fixed(living, c));
    fixed(garage, "car");
    for class in ["plate", "apple", "knife", "water_glass", "pot", "bread", "kettle", "faucet"] {
        scene.add_on(counter, Draft::new(class)).unwrap();
    }
    for class in ["milk", "chicken"] {
        scene.add_in(fridge, Draft::new(class)).unwrap();
    }
    for class in ["book", "towel", "jacket", "laptop", "keyboard", "sponge", "piano", "toy", "newspaper"] {
        scene.add_on(desk, Draft::new(class)).unwrap();
    }
    scene.add_on(table, Draft::new("mug").state(State::Dirty)).unwrap();
    scene.add_in(living, Draft::new("chair")).unwrap();
    scene.add_in(living, Draft::new("character")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    scene.build()
}

/// Whether a goal has a plan that the rule accepts and that reaches the goal.
fn is_planned(scene: &SceneGraph, goal: &Goal) -> bool {
    let me = scene.agents()[0];
    let Ok(found) = plan(&mut scene.clone(), me, goal, &History::default()) else { return false };
    let mut world = Simulator::new(scene.clone());
    for action in &found.actions {
        world.step(me, action).unwrap_or_else(|r| panic!("{goal}: {action}: {}", r[0]));
    }
    assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{goal}: {:?}", found.actions);
    !found.actions.is_empty()
}

fn classes(scene: &SceneGraph) -> Vec<Term> {
    let all: BTreeSet<String> = scene.nodes().map(|n| n.class().to_string()).collect();
    all.into_iter().map(Term::Class).collect()
}

#[test]
fn every_verb_can_be_planned() {
    let scene = home();
    let classes = classes(&scene);
    for verb in Verb::ALL {
        let terms: Vec<Vec<Term>> = match verb.arity() {
            0 => vec![Vec::new()],
            1 => classes.iter().map(|c| vec![c.clone()]).collect(),
            _ => classes.iter().flat_map(|a| classes.iter().map(|b| vec![a.clone(), b.clone()])).collect(),
        };
        let mut goals = terms.into_iter().map(|terms| Goal::literal(Predicate::Did(*verb), terms));
        assert!(goals.any(|goal| is_planned(&scene, &goal)), "nothing to {} in a whole home", verb.as_str());
    }
}

#[test]
fn every_state_can_be_planned() {
    let scene = home();
    for state in State::ALL {
        let terms = classes(&scene).into_iter().chain([Term::Me]);
        let mut goals = terms.map(|t| Goal::literal(Predicate::State(*state), vec![t]));
        let planned = goals.any(|goal| is_planned(&scene, &goal));
        assert_eq!(planned, !NOBODYS.contains(state), "{}", state.as_str());
        let enters = |effect: &Effect<Argument>| matches!(effect, Effect::Enter(_, s) | Effect::EnterWith(_, s) | Effect::EnterOwn(s) if s == state);
        let brought = scene.vocabulary().rules().any(|rule| rule.effects.iter().any(enters));
        assert!(planned || !brought, "some verb makes things {}", state.as_str());
    }
}

/// Tasks of ALFRED, including those about hot or cold things and whole vessels, are done by agents that know
/// the home and by agents that see it for the first time.
#[test]
fn alfreds_tasks_can_be_done() {
    let scene = home();
    let tasks = [
        ("pick_heat_then_place_in_recep", "Apple", "CounterTop", ""),
        ("pick_heat_then_place_in_recep", "Mug", "Desk", ""),
        ("pick_heat_then_place_in_recep", "Pot", "Fridge", ""),
        ("pick_cool_then_place_in_recep", "Apple", "Desk", ""),
        ("pick_cool_then_place_in_recep", "Pot", "CounterTop", ""),
        ("pick_cool_then_place_in_recep", "Mug", "Sink", ""),
        ("pick_clean_then_place_in_recep", "Plate", "Desk", ""),
        ("pick_and_place_with_movable_recep", "Apple", "Desk", "Plate"),
    ];
    for (kind, object, at, vessel) in tasks {
        let text = format!(
            r#"{{"task_type": "{kind}", "pddl_params": {{"object_target": "{object}", "parent_target": "{at}",
                "mrecep_target": "{vessel}", "toggle_target": "", "object_sliced": false}}}}"#
        );
        let goal = Template::read(&text).unwrap().to_goal();
        assert!(is_planned(&scene, &goal), "{kind}: {goal}");
        let task = Task::new(kind, goal);
        for mut policy in [PlannerPolicy::best(), PlannerPolicy::in_unknown_home()] {
            let mut world = Simulator::new(scene.clone());
            let episode = EpisodeOptions::seeded(1).episode(&mut policy, &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome, Outcome::Won, "{}: {}: {episode:?}", policy.name(), task.goal);
        }
    }
}

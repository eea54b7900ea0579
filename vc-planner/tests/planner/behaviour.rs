//! The behaviour of agents during an episode: its end and the reason, no useless steps, no undone parts of the
//! goal, and no needless replanning.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use crate::homes;
mod time;

use homes::{GOALS, home};
use vc_graph::goal::Situation;
use vc_graph::{Action, Draft, Goal, History, NodeId, SceneBuilder, SceneGraph, Scope, Simulator, Verb};
use vc_planner::{Agent, Decision, EpisodeOptions, PlannerPolicy, Policy, Step, plan, run_episode};
use vc_tasks::{Outcome, Task};

#[test]
fn a_step_limit_is_told_apart_from_what_cannot_be() {
    let scene = home(1);
    let attempt = |policy: &mut dyn Policy, goal: &str, step_limit| {
        let task = Task { step_limit, ..Task::new("limited", goal.parse().unwrap()) };
        run_episode(policy, &task, &mut Simulator::new(scene.clone()))
    };
    for policy in
        [&mut PlannerPolicy::oracle() as &mut dyn Policy, &mut PlannerPolicy::best(), &mut PlannerPolicy::faithful()]
    {
        let late = attempt(policy, GOALS[1], 2);
        assert_eq!((late.outcome, late.steps), (Outcome::TimedOut, 2), "{}: {late:?}", policy.name());
        assert_eq!(late.reason.as_deref(), Some("step limit reached"));
        let never = attempt(policy, "Holds(unicorn)", 2);
        assert_eq!(never.outcome, Outcome::Lost, "{}: {never:?}", policy.name());
        assert!(never.reason.unwrap().contains("unicorn"));
        let done = attempt(policy, GOALS[1], 500);
        assert_eq!((done.outcome, done.reason), (Outcome::Won, None), "{}", policy.name());
    }
}

/// The parts of a goal that hold, before the first action and after each.
fn truths(scene: &SceneGraph, me: NodeId, goal: &Goal, actions: &[Action]) -> Vec<Vec<bool>> {
    let mut world = Simulator::new(scene.clone());
    let now = |world: &Simulator| {
        let now = Situation::new(world.graph(), me, world.history());
        goal.conjuncts().iter().map(|part| part.holds(&now)).collect()
    };
    let mut all = vec![now(&world)];
    for action in actions {
        world.step(me, action).unwrap();
        all.push(now(&world));
    }
    all
}

/// Goals all of whose parts are about the places of things.
const DELIVERIES: [&str; 6] = [
    "On(apple, kitchen_table) & Inside(milk, fridge)",
    "On(mug, coffee_table) & On(book, coffee_table) & On(plate, coffee_table)",
    "Inside(plate, kitchen_cabinet), 2 & Inside(mug, kitchen_cabinet), 2",
    "On(apple, desk) & On(apple, coffee_table) & Inside(towel, closet)",
    "On(fork, desk), 2 & Inside(book, closet) & Inside(milk, fridge), 2",
    "On(towel, nightstand) & On(cellphone, nightstand) & On(mug, desk) & On(plate, kitchen_table)",
];

#[test]
fn nothing_achieved_is_undone() {
    let mut achieved = 0;
    for seed in 0..20 {
        let scene = home(seed);
        let me = scene.agents()[0];
        for text in DELIVERIES {
            let goal: Goal = text.parse().unwrap();
            let found = plan(&mut scene.clone(), me, &goal, &History::default()).unwrap();
            let truths = truths(&scene, me, &goal, &found.actions);
            for part in 0..goal.conjuncts().len() {
                let ends = truths.windows(2).filter(|w| w[0][part] && !w[1][part]).count();
                assert_eq!(ends, 0, "{seed} {text}: part {part} in {:?}", found.actions);
                achieved += truths.windows(2).filter(|w| !w[0][part] && w[1][part]).count();
            }
        }
    }
    assert!(achieved > 200, "{achieved}");
}

/// The steps of policies in random homes, with the homes.
fn episodes(policies: &mut [&mut dyn Policy]) -> Vec<(String, SceneGraph, Vec<Step>)> {
    let mut all = Vec::new();
    for seed in 0..12 {
        for goal in GOALS {
            for policy in policies.iter_mut() {
                let scene = home(seed);
                let task = Task::new("behaviour", goal.parse().unwrap());
                let mut steps = Vec::new();
                let mut world = Simulator::new(scene.clone());
                EpisodeOptions::seeded(seed).episode(*policy, &task, &mut world, &mut |step| steps.push(step.clone()));
                all.push((format!("{seed} {} {goal}", policy.name()), scene, steps));
            }
        }
    }
    all
}

/// Whether the observation after a step was new: a thing, or a place not looked at before.
fn taught(before: &Step, after: &Step) -> bool {
    !after.found.is_empty() || after.places < before.places
}

#[test]
fn no_walk_is_in_vain() {
    let (mut walks, mut vain) = (0, Vec::new());
    for (name, _, steps) in episodes(&mut [&mut PlannerPolicy::best(), &mut PlannerPolicy::oracle()]) {
        for pair in steps.windows(2).filter(|w| w[0].action.verb == Verb::Walk && w[1].action.verb == Verb::Walk) {
            walks += 1;
            if !taught(&pair[0], &pair[1]) {
                vain.push(format!("{name}: `{}`, `{}`", pair[0].described, pair[1].described));
            }
        }
    }
    println!("{walks} walks after a walk");
    assert!(walks > 0);
    assert!(vain.is_empty(), "{vain:#?}");
}

/// No agent walks to the middle of a room on the way to a known thing.
#[test]
fn what_is_known_is_walked_up_to() {
    let (mut rooms, mut vain) = (0, Vec::new());
    for (name, scene, steps) in episodes(&mut [&mut PlannerPolicy::best(), &mut PlannerPolicy::oracle()]) {
        for (i, step) in steps.iter().enumerate() {
            let to_room = step.action.object.is_some_and(|id| scene.rooms().contains(&id));
            if step.action.verb != Verb::Walk || !to_room {
                continue;
            }
            rooms += 1;
            let Some(next) = steps.get(i + 1) else { continue };
            let dropped = next.action.verb == Verb::Drop;
            if !dropped && !taught(step, next) {
                vain.push(format!("{name}: `{}`, `{}`", step.described, next.described));
            }
        }
    }
    println!("{rooms} walks to a room, each to see it or to leave something there");
    assert!(rooms > 0);
    assert!(vain.is_empty(), "{vain:#?}");
}

/// Two rooms with equally much work: one is finished before the other is begun.
#[test]
fn rooms_are_toured_one_after_the_other() {
    let mut scene = SceneBuilder::new("twins");
    let mut goal = Vec::new();
    let rooms = ["bedroom", "office"].map(|r| scene.add(Draft::new(r)).unwrap());
    for room in rooms {
        let [from, to] = ["desk", "dresser"].map(|c| scene.add_in(room, Draft::new(c)).unwrap());
        for class in ["book", "mug"] {
            let item = scene.add_on(from, Draft::new(class)).unwrap();
            goal.push(format!("On({class}.{}, dresser.{})", item.0, to.0));
        }
    }
    let me = scene.add_in(rooms[0], Draft::new("character")).unwrap();
    let scene = scene.build();
    // In any order of the goal's parts.
    for order in [[0, 1, 2, 3], [0, 2, 1, 3], [3, 1, 2, 0], [2, 3, 0, 1]] {
        let text = order.map(|i| goal[i].as_str()).join(" & ");
        let found = plan(&mut scene.clone(), me, &text.parse().unwrap(), &History::default()).unwrap();
        let mut world = Simulator::new(scene.clone());
        let mut visited = vec![world.graph().room_of(me)];
        for action in &found.actions {
            world.step(me, action).unwrap();
            visited.push(world.graph().room_of(me));
        }
        visited.dedup();
        assert_eq!(visited, [Some(rooms[0]), Some(rooms[1])], "{text}: {:?}", found.actions);
        assert_eq!(found.actions.len(), 12, "{:?}", found.actions);
    }
}

/// Finding an irrelevant thing on the way leaves the rest of the plan unchanged.
#[test]
fn an_irrelevant_find_keeps_the_plan() {
    let mut scene = SceneBuilder::new("flat");
    let [kitchen, bedroom] = ["kitchen", "bedroom"].map(|r| scene.add(Draft::new(r)).unwrap());
    scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let desk = scene.add_in(bedroom, Draft::new("desk")).unwrap();
    scene.add_on(desk, Draft::new("apple")).unwrap();
    let hidden = scene.add_in(fridge, Draft::new("banana")).unwrap();
    let me = scene.add_in(bedroom, Draft::new("character")).unwrap();
    let mut world = Simulator::new(scene.build());
    let goal = "Inside(apple, fridge) & Closed(fridge)".parse().unwrap();
    let mut agent = Agent::in_known_home(world.graph(), me, goal, 3);
    let mut expected: Option<Vec<Action>> = None;
    let mut found_by_the_way = false;
    loop {
        let learned = agent.see(&world.graph().observe(me, Scope::Room));
        let Decision::Act(action, plan) = agent.decide() else { break };
        if let Some(expected) = expected {
            assert_eq!(plan.actions, expected, "after {learned:?}");
            found_by_the_way |= learned.found.contains(&hidden);
        }
        assert_eq!(plan.actions.first(), Some(&action));
        world.step(me, &action).unwrap();
        agent.did(&action);
        expected = Some(plan.actions[1..].to_vec());
    }
    assert!(found_by_the_way, "the banana was never seen");
    assert_eq!(expected, Some(Vec::new()), "the plan was left");
}

//! Reactions to actions that bodies cannot do: another thing is taken, another place is found.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::homes;

use std::collections::BTreeMap;

use homes::{GOALS, home};
use vc_graph::{
    Action, ChangeSet, Draft, History, NodeId, Refusal, SceneBuilder, SceneGraph, Seed, Simulator, State, Stream, Verb,
};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Step};
use vc_tasks::{Outcome, Task, World, WorldError};

/// A world in which some actions fail, whatever the transition rule says.
struct Clumsy {
    world: Simulator,
    cannot: Vec<Action>,
    /// Whether the failure is reported as forbidden by the rule, rather than as failed.
    forbids: bool,
    failures: usize,
}

impl World for Clumsy {
    fn graph(&self) -> &SceneGraph {
        World::graph(&self.world)
    }

    fn history(&self) -> &History {
        World::history(&self.world)
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        if self.cannot.contains(action) {
            self.failures += 1;
            return Err(match self.forbids {
                true => WorldError::Refused(vec![vc_graph::Refusal::NoFreeHand(self.world.graph().label(agent))]),
                false => WorldError::Failed("no room".into()),
            });
        }
        World::step(&mut self.world, agent, action)
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.world, graph)
    }
}

#[test]
fn another_thing_is_taken_and_another_place_found() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let counter = scene.add_in(kitchen, Draft::new("kitchen_counter")).unwrap();
    let near = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let far = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let mugs = [(); 2].map(|()| scene.add_on(counter, Draft::new("mug")).unwrap());
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let scene = scene.build();
    let place = |mug: NodeId, at: NodeId| Action::two(Verb::Place, mug, at);
    let cannot = vec![Action::one(Verb::Grab, mugs[0]), place(mugs[1], near)];
    let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
    for mut policy in policies {
        let mut world =
            Clumsy { world: Simulator::new(scene.clone()), cannot: cannot.clone(), forbids: false, failures: 0 };
        let task = Task::new("lay", "On(mug, kitchen_table)".parse().unwrap());
        let episode = EpisodeOptions::seeded(1).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
        assert_eq!(episode.outcome, Outcome::Won, "{}: {episode:?}", policy.name());
        assert!(World::graph(&world).place(mugs[1]).is_some_and(|p| p.at == far), "{}", policy.name());
        assert!(world.failures <= 4, "{}: {} times what cannot be done", policy.name(), world.failures);
    }
    // A goal without any substitute is given up.
    let cannot = vec![Action::one(Verb::Open, fridge)];
    let mut world = Clumsy { world: Simulator::new(scene), cannot, forbids: false, failures: 0 };
    let task = Task::new("air", "Open(fridge)".parse().unwrap());
    let episode = EpisodeOptions::seeded(1).episode(&mut PlannerPolicy::oracle(), &task, &mut world, &mut |_| {});
    assert!(episode.outcome != Outcome::Won && episode.steps <= 8, "{episode:?}");
    assert!(!World::graph(&world).node(fridge).unwrap().states().contains(State::Open));
}

/// If two things in a row do not fit into a container, another container is taken, or the goal is given up.
#[test]
fn what_is_full_is_left_alone() {
    for (fridges, wins) in [(1, false), (2, true)] {
        let mut scene = SceneBuilder::new("flat");
        let kitchen = scene.add(Draft::new("kitchen")).unwrap();
        scene.add_in(kitchen, Draft::new("character")).unwrap();
        let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
        let milk = scene.add_on(table, Draft::new("milk")).unwrap();
        let fridges: Vec<NodeId> = (0..fridges).map(|_| scene.add_in(kitchen, Draft::new("fridge")).unwrap()).collect();
        let scene = scene.build();
        let task = Task::new("tidy", "Inside(milk, fridge) & Closed(fridge)".parse().unwrap());
        for seed in 0..5 {
            let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
            for mut policy in policies {
                let cannot = vec![Action::two(Verb::PutIn, milk, fridges[0])];
                let mut world = Clumsy { world: Simulator::new(scene.clone()), cannot, forbids: false, failures: 0 };
                let episode = EpisodeOptions::seeded(seed).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
                assert_eq!(episode.outcome == Outcome::Won, wins, "{} {seed}: {episode:?}", policy.name());
                assert!(world.failures <= 2, "{}: {} times what cannot be done", policy.name(), world.failures);
            }
        }
    }
}

/// Unreachable places are excluded, with all known and supposed contents.
#[test]
fn what_there_is_no_way_to_is_left_alone() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    let cabinets = [(); 3].map(|()| scene.add_in(kitchen, Draft::new("kitchen_cabinet")).unwrap());
    let mugs = [0, 2].map(|i| scene.add_in(cabinets[i], Draft::new("mug")).unwrap());
    let scene = scene.build();
    let task = Task::new("lay", "On(mug, kitchen_table)".parse().unwrap());
    // The first cabinet cannot be reached, and the second does not open.
    let cannot = vec![Action::one(Verb::Walk, cabinets[0]), Action::one(Verb::Open, cabinets[1])];
    for seed in 0..20 {
        let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
        for mut policy in policies {
            let mut world =
                Clumsy { world: Simulator::new(scene.clone()), cannot: cannot.clone(), forbids: false, failures: 0 };
            let episode = EpisodeOptions::seeded(seed).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome, Outcome::Won, "{} {seed}: {episode:?}", policy.name());
            assert!(World::graph(&world).place(mugs[1]).is_some_and(|p| p.at == table));
            assert!(world.failures <= 4, "{}: {} times what cannot be done", policy.name(), world.failures);
        }
    }
}

/// A world that refuses at random, sometimes in the name of the rule and sometimes not.
struct Moody {
    world: Simulator,
    stream: Stream,
    /// The refusals, in percent.
    percent: usize,
    /// The actions refused since the last successful one.
    vain: Vec<Action>,
    refused: BTreeMap<Action, usize>,
}

impl World for Moody {
    fn graph(&self) -> &SceneGraph {
        World::graph(&self.world)
    }

    fn history(&self) -> &History {
        World::history(&self.world)
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        let refuses = self.stream.below(100) < self.percent;
        let done = if refuses {
            let by_rule = self.stream.below(2) == 0;
            Err(if by_rule {
                WorldError::Refused(vec![Refusal::NoFreeHand(self.world.graph().label(agent))])
            } else {
                WorldError::Failed("slipped".into())
            })
        } else {
            World::step(&mut self.world, agent, action)
        };
        match &done {
            Ok(_) => {
                self.vain.clear();
                self.refused.remove(action);
            }
            Err(why) => {
                assert!(!self.vain.contains(action), "{action} again, though nothing has changed: {why}");
                self.vain.push(*action);
                let times = self.refused.entry(*action).or_default();
                *times += 1;
                assert!(*times <= 3, "{action} was refused {times} times: {why}");
            }
        }
        done
    }

    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.world, graph)
    }
}

/// An agent learns from every refusal: it does not repeat the action while nothing has changed, tries another
/// way, and ends with a verdict.
#[test]
fn what_was_refused_is_not_tried_again_while_nothing_changes() {
    for (percent, least) in [(10, 88), (30, 50), (100, 0)] {
        let (mut won, mut all) = (0, 0);
        for seed in 0..6 {
            let scene = home(seed);
            for goal in GOALS {
                let policies: [Box<dyn Policy>; 4] = [
                    Box::new(PlannerPolicy::oracle()),
                    Box::new(PlannerPolicy::best()),
                    Box::new(PlannerPolicy::in_unknown_home()),
                    Box::new(PlannerPolicy::faithful()),
                ];
                for mut policy in policies {
                    let stream = Seed(seed).child(goal).stream();
                    let (vain, refused) = (Vec::new(), BTreeMap::new());
                    let mut world = Moody { world: Simulator::new(scene.clone()), stream, percent, vain, refused };
                    let task = Task::new("moody", goal.parse().unwrap());
                    let episode = EpisodeOptions::seeded(seed).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
                    let told = format!("{} {seed} {goal} {percent}%: {episode:?}", policy.name());
                    assert!(episode.outcome != Outcome::TimedOut, "{told}");
                    // An agent in an unknown home takes unknown things as absent.
                    let told_why = episode.reason.is_some() || policy.name() == "unknown home";
                    assert!(episode.outcome == Outcome::Won || told_why, "{told}");
                    all += 1;
                    won += usize::from(episode.outcome == Outcome::Won);
                }
            }
        }
        assert!(won * 100 >= all * least, "{percent}%: {won} of {all}");
    }
}

/// The agent learns from a refusal, whatever the reason: it does not repeat the action again and again, and
/// uses another place if there is one.
#[test]
fn what_is_forbidden_is_not_tried_for_ever() {
    for (tables, wins) in [(1, false), (2, true)] {
        let mut scene = SceneBuilder::new("flat");
        let kitchen = scene.add(Draft::new("kitchen")).unwrap();
        scene.add_in(kitchen, Draft::new("character")).unwrap();
        let counter = scene.add_in(kitchen, Draft::new("kitchen_counter")).unwrap();
        let mug = scene.add_on(counter, Draft::new("mug")).unwrap();
        let tables = (0..tables).map(|_| scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap());
        let tables: Vec<NodeId> = tables.collect();
        let scene = scene.build();
        let task = Task::new("lay", "On(mug, kitchen_table)".parse().unwrap());
        let policies: [Box<dyn Policy>; 2] = [Box::new(PlannerPolicy::oracle()), Box::new(PlannerPolicy::best())];
        for mut policy in policies {
            let cannot = vec![Action::two(Verb::Place, mug, tables[0])];
            let mut world = Clumsy { world: Simulator::new(scene.clone()), cannot, forbids: true, failures: 0 };
            let episode = EpisodeOptions::seeded(1).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome == Outcome::Won, wins, "{}: {episode:?}", policy.name());
            assert!(episode.outcome != Outcome::Aborted, "{}: {episode:?}", policy.name());
            assert!(world.failures <= 3, "{}: {} times what is forbidden", policy.name(), world.failures);
        }
    }
}

/// A container that stays shut takes nothing: the agent gives up without trying to put something in.
#[test]
fn nothing_is_put_into_what_does_not_open() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let fridge = scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    scene.add_on(table, Draft::new("apple")).unwrap();
    scene.add_in(kitchen, Draft::new("character")).unwrap();
    let task = Task::new("chill", "Inside(apple, fridge)".parse().unwrap());
    let cannot = vec![Action::one(Verb::Open, fridge)];
    let mut world = Clumsy { world: Simulator::new(scene.build()), cannot, forbids: false, failures: 0 };
    let (mut policy, mut tried) = (PlannerPolicy::oracle(), Vec::new());
    let mut note = |step: &Step| tried.push(step.action.verb);
    let episode = EpisodeOptions::seeded(1).episode(&mut policy, &task, &mut world, &mut note);
    assert!(episode.outcome == Outcome::Lost && world.failures == 2, "{episode:?}");
    assert!(!tried.contains(&Verb::PutIn), "{tried:?}");
}

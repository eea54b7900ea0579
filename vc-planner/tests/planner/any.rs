//! For any goal and any behaviour of the world: plans are correct, no policy loops, unreachable goals are
//! reported with a reason, and reachable goals are not refused.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap and tell")]

use crate::brute;

use vc_graph::goal::Situation;
use vc_graph::rule::{self, Effect};
use vc_graph::{
    Action, ChangeSet, Draft, Event, Goal, History, NodeId, NodeKind, Property, PropertySet, SceneBuilder, SceneGraph,
    Seed, Simulator, State, Stream, Verb, Word,
};
use vc_planner::{EpisodeOptions, PlannerPolicy, Policy, Unreachable, plan};
use vc_tasks::{Outcome, Task, World, WorldError};
use vc_testkit::amount;

const FIXED: [&str; 8] =
    ["kitchen_table", "fridge", "kitchen_cabinet", "desk", "sofa", "television", "dishwasher", "closet"];
const ITEMS: [&str; 8] = ["apple", "plate", "mug", "book", "milk", "fork", "towel", "cellphone"];

fn home(seed: u64) -> SceneGraph {
    let mut stream = Seed(seed).child("any").stream();
    let mut scene = SceneBuilder::new("any");
    let rooms = ["kitchen", "living_room", "bedroom"].map(|r| scene.add(Draft::new(r)).unwrap());
    let fixed: Vec<NodeId> =
        FIXED.iter().map(|f| scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(*f)).unwrap()).collect();
    for class in ITEMS.iter().chain(&ITEMS[..4]) {
        // Surfaces and containers; not every one can hold every thing.
        let at = *stream.pick(&[fixed[0], fixed[1], fixed[2], fixed[3], fixed[7]]).unwrap();
        let inside = at != fixed[0] && at != fixed[3];
        if inside { scene.add_in(at, Draft::new(*class)) } else { scene.add_on(at, Draft::new(*class)) }.unwrap();
    }
    scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new("character")).unwrap();
    scene.build()
}

/// Any goal that the language can express, sensible or not.
fn any_goal(stream: &mut Stream, depth: usize) -> String {
    let mut class = |all: &[&str]| (*stream.pick(all).unwrap()).to_owned();
    let things = ["apple", "plate", "mug", "book", "fridge", "sofa", "television", "unicorn", "kitchen", "closet"];
    let (a, b) = (class(&things), class(&["kitchen_table", "fridge", "desk", "closet", "sofa", "mug", "bedroom"]));
    let unary = class(&[
        "Open",
        "Closed",
        "SwitchedOn",
        "SwitchedOff",
        "Holds",
        "Eat",
        "Drink",
        "Sit",
        "Clean",
        "Dirty",
        "Near",
        "Grab",
        "Touch",
        "Read",
        "Wash",
        "Filled",
        "Broken",
        "Facing",
    ]);
    let binary = class(&["On", "Inside"]);
    let number = class(&["1", "2", "3", "7", "<= 0", "= 1"]);
    if depth > 0 {
        let (p, q) = (any_goal(stream, depth - 1), any_goal(stream, depth - 1));
        let (number, other) = (stream.below(3), stream.below(20));
        return match stream.below(20) {
            8 => format!("({p}) => ({q})"),
            9 => format!("!(({p}) => ({q}))"),
            10 => format!("exactly {number} ?x: {a}. ({binary}(?x, {b}))"),
            11 => format!("at most {number} ?x: {a}. (({binary}(?x, {b})) & ({q}))"),
            12 => format!("!(at least {number} ?x: {a}. ({binary}(?x, {b})))"),
            13 => format!("exists ?x: {a}. (?x != #{other} & ({binary}(?x, {b})))"),
            14 => format!("pairs ?x: {a}, ?y: {b}. ({binary}(?x, ?y) & ({q}))"),
            15 => format!("at most {number} pairs ?x: {a}, ?y: {b}. {binary}(?x, ?y)"),
            16 => format!("eventually ({p}) & always ({q})"),
            17 => format!("({p}) before ({q})"),
            18 => format!("({p}) until ({q})"),
            19 => format!("within {other} steps ({p})"),
            0 => format!("({p}) | ({q})"),
            1 => format!("!({p}) & ({q})"),
            2 => format!("({p}) then ({q})"),
            3 => format!("forall ?x: {a}. ({p})"),
            4 => format!("exists ?x: {a}. (({binary}(?x, {b})) & ({q}))"),
            _ => format!("({p}) & ({q})"),
        };
    }
    match stream.below(3) {
        0 => format!("{unary}({a})"),
        1 => format!("{binary}({a}, {b}), {number}"),
        _ => format!("{binary}({a}, {b})"),
    }
}

/// Goals that can be parsed, with the number of the home in which they are asked.
fn any_goals(number: u64) -> impl Iterator<Item = (u64, String, Goal)> {
    (0..number).filter_map(|seed| {
        let text = any_goal(&mut Seed(seed).child("goal").stream(), seed as usize % 3);
        let goal = text.parse().ok()?;
        Some((seed, text, goal))
    })
}

/// The possible actions on the things that a goal names, and on their supports and containers.
fn actions_about(scene: &SceneGraph, text: &str) -> Vec<Action> {
    let named = scene.nodes().filter(|n| n.kind() != NodeKind::Agent && text.contains(&**n.class())).map(|n| n.id());
    let mut things: Vec<NodeId> = named.flat_map(|id| [Some(id), scene.place(id).map(|p| p.at)]).flatten().collect();
    things.sort_unstable();
    things.dedup();
    // Actions such as looking change nothing, so they are left out unless the goal names them.
    let idle =
        |verb: Verb| !scene.vocabulary().rule(verb).unwrap().effects.iter().any(|e| !matches!(e, Effect::Face(_)));
    let named = |verb: Verb| text.contains(&format!("{verb:?}("));
    let useful = |verb: &Verb| *verb != Verb::Run && *verb != Verb::Find && (named(*verb) || !idle(*verb));
    let turn = text.contains("Facing(").then_some(Verb::TurnTo);
    let verbs: Vec<Verb> = Verb::ALL.iter().copied().filter(useful).chain(turn).collect();
    let mut all: Vec<Action> = Vec::new();
    for &verb in &verbs {
        match verb.arity() {
            0 => all.push(Action::zero(verb)),
            1 => all.extend(things.iter().map(|&id| Action::one(verb, id))),
            _ => all.extend(things.iter().flat_map(|&a| things.iter().map(move |&b| Action::two(verb, a, b)))),
        }
    }
    let me = scene.agents()[0];
    all.retain(|a| {
        rule::preconditions(scene.vocabulary(), a).iter().filter(|c| c.is_lasting()).all(|c| c.holds(scene, me))
    });
    all
}

/// A goal that is refused cannot be reached by any few actions.
#[test]
fn what_is_refused_cannot_be_had_by_a_few_actions() {
    const DEPTH: usize = 5;
    let (mut whole, mut cut) = (0, 0);
    for (seed, text, goal) in any_goals(amount(60, 300)) {
        let scene = home(seed);
        let me = scene.agents()[0];
        let Err(why) = plan(&mut scene.clone(), me, &goal, &History::default()) else { continue };
        let asked = |a: &Action| text.contains(&format!("{:?}(", a.verb));
        let did = |events: &[Event]| events.iter().map(|e| e.action).filter(asked).collect();
        let actions = actions_about(&scene, &text);
        let world = brute::World { scene: &scene, me, actions: &actions, remembered: &did };
        match brute::shortest(&world, &goal, DEPTH + 1, 3_000) {
            Ok(found) => assert_eq!((found, whole += 1).0, None, "{seed} {text}: {why}"),
            Err(()) => cut += 1,
        }
    }
    println!("{whole} refused goals searched to {DEPTH} actions, {cut} to so many states");
    assert!(whole >= amount(4, 20), "{whole} {cut}");
}

#[test]
fn plans_for_any_goal_are_accepted_and_reach_it() {
    let (mut planned, mut refused) = (0, 0);
    for (seed, text, goal) in any_goals(amount(60, 300)) {
        let mut scene = home(seed);
        let (me, before) = (scene.agents()[0], scene.clone());
        let found = plan(&mut scene, me, &goal, &History::default());
        assert_eq!(scene, before, "{text}");
        let Ok(plan) = found else {
            refused += 1;
            continue;
        };
        planned += 1;
        let mut world = Simulator::new(scene);
        for action in &plan.actions {
            world.step(me, action).unwrap_or_else(|r| panic!("{seed} {text}: {action}: {}", r[0]));
        }
        assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{seed} {text}: {:?}", plan.actions);
    }
    println!("{planned} planned, {refused} refused");
    assert!(planned >= amount(10, 50) && refused >= amount(4, 20), "{planned} {refused}");
}

/// More steps than anybody needs in such a small home.
const LIMIT: usize = 1_500;

#[test]
fn no_goal_makes_an_agent_loop() {
    for (seed, text, goal) in any_goals(amount(50, 150)) {
        let scene = home(seed);
        let task = Task { step_limit: LIMIT, ..Task::new("any", goal) };
        for policy in [
            &mut PlannerPolicy::best() as &mut dyn Policy,
            &mut PlannerPolicy::faithful(),
            &mut PlannerPolicy::oracle(),
        ] {
            let episode =
                EpisodeOptions::seeded(seed).episode(policy, &task, &mut Simulator::new(scene.clone()), &mut |_| {});
            assert_ne!(episode.outcome, Outcome::TimedOut, "{seed} {}: {text}: {episode:?}", policy.name());
        }
    }
}

/// A world that does not obey: it refuses an action now and then, or changes into another home.
struct Contrary {
    homes: Vec<SceneGraph>,
    history: History,
    steps: usize,
    refuses: usize,
}

impl World for Contrary {
    fn graph(&self) -> &SceneGraph {
        &self.homes[self.steps % self.homes.len()]
    }

    fn history(&self) -> &History {
        &self.history
    }

    fn step(&mut self, _: NodeId, _: &Action) -> Result<ChangeSet, WorldError> {
        self.steps += 1;
        if self.steps.is_multiple_of(self.refuses) {
            return Err(WorldError::Failed("contrary".into()));
        }
        Ok(ChangeSet::default())
    }

    fn reset(&mut self, _: &SceneGraph) -> Result<(), WorldError> {
        Ok(())
    }
}

#[test]
fn no_world_makes_an_agent_loop() {
    for (seed, text, goal) in any_goals(amount(20, 60)) {
        let task = Task { step_limit: LIMIT, ..Task::new("any", goal) };
        for (homes, refuses) in [(1, 1), (1, 2), (1, usize::MAX), (3, 3), (2, usize::MAX)] {
            for policy in [
                &mut PlannerPolicy::best() as &mut dyn Policy,
                &mut PlannerPolicy::faithful(),
                &mut PlannerPolicy::oracle(),
            ] {
                // The same things at other places.
                let homes = (0..homes).map(|i| home(1_000 + seed + i)).collect();
                let mut world = Contrary { homes, history: History::default(), steps: 0, refuses };
                let episode = EpisodeOptions::seeded(seed).episode(policy, &task, &mut world, &mut |_| {});
                assert_ne!(episode.outcome, Outcome::TimedOut, "{seed} {refuses} {}: {text}", policy.name());
            }
        }
    }
}

/// A flat in which some goals are unreachable.
fn flat() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    scene.add_in(kitchen, Draft::new("desk")).unwrap();
    scene.add_in(kitchen, Draft::new("fridge")).unwrap();
    scene.add_in(kitchen, Draft::new("television")).unwrap();
    for item in ["apple", "mug", "mug", "book"] {
        scene.add_on(table, Draft::new(item)).unwrap();
    }
    // The thing runs for ever, and nothing can stop it.
    let endless = Draft {
        properties: Some(PropertySet::from_words(&[Property::Container, Property::Openable])),
        ..Draft::new("washing_machine")
    };
    let washing = scene.add_in(kitchen, endless.state(State::Closed).state(State::On)).unwrap();
    scene.add_in(washing, Draft::new("towel")).unwrap();
    // The thing is in no room.
    scene.add(Draft::new("cellphone")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), me)
}

#[test]
fn parts_that_conflict_are_told_and_no_others() {
    let (mut scene, me) = flat();
    let mut find = |text: &str| plan(&mut scene, me, &text.parse().unwrap(), &History::default());
    for text in [
        "On(apple, desk) & Inside(apple, fridge)",
        "On(mug, desk), 2 & Inside(mug, fridge)",
        "Open(fridge) & Closed(fridge)",
        "SwitchedOn(television) & SwitchedOff(television)",
        "Holds(apple) & Holds(book) & Holds(mug)",
        "Holds(mug) & On(mug, desk), 2",
        "Holds(apple) & Inside(apple, fridge)",
    ] {
        let found = find(text);
        assert!(matches!(found, Err(Unreachable::Conflicting(_))), "{text}: {found:?}");
    }
    for text in [
        "On(mug, desk) & Inside(mug, fridge)",
        "Holds(apple) & Holds(book)",
        "Holds(mug) & On(mug, desk)",
        "On(apple, desk) | Inside(apple, fridge)",
        "Open(fridge) | Closed(fridge)",
        "Grab(apple) then Grab(book)",
        "Eat(apple) & Holds(book)",
        "SwitchedOn(television) & Open(fridge)",
    ] {
        assert!(find(text).is_ok(), "{text}: {:?}", find(text));
    }
}

#[test]
fn what_is_sealed_or_nowhere_is_told() {
    let (mut scene, me) = flat();
    let mut why = |text: &str| plan(&mut scene, me, &text.parse().unwrap(), &History::default()).unwrap_err();
    assert!(matches!(why("On(towel, desk)"), Unreachable::Sealed(_)), "{:?}", why("On(towel, desk)"));
    assert!(matches!(why("Holds(towel)"), Unreachable::Sealed(_)));
    assert!(matches!(why("On(cellphone, desk)"), Unreachable::NoRoute(_)), "{:?}", why("On(cellphone, desk)"));
    assert!(matches!(why("Holds(cellphone)"), Unreachable::NoRoute(_)));
}

#[test]
fn what_another_holds_is_told() {
    let (scene, me) = flat();
    let kitchen = scene.of_class("kitchen")[0];
    let mut builder = SceneBuilder::from_graph(scene);
    let other = builder.add_in(kitchen, Draft::new("character")).unwrap();
    let mut world = Simulator::new(builder.build());
    for (class, verb) in ["book", "mug"].into_iter().flat_map(|c| [(c, Verb::Walk), (c, Verb::Grab)]) {
        let id = world.graph().of_class(class)[0];
        world.step(other, &Action::one(verb, id)).unwrap();
    }
    let scene = world.into_graph();
    let find = |text: &str| plan(&mut scene.clone(), me, &text.parse().unwrap(), &History::default());
    for text in ["Holds(book)", "On(book, desk) & On(apple, desk)", "On(mug, desk), 2"] {
        assert!(matches!(find(text), Err(Unreachable::HeldByAnother(_))), "{text}: {:?}", find(text));
    }
    // There is another mug.
    assert!(find("On(mug, desk) & Holds(apple)").is_ok());
}

#[test]
fn what_has_been_done_cannot_be_undone() {
    let (scene, me) = flat();
    let apple = scene.of_class("apple")[0];
    let mut world = Simulator::new(scene);
    for action in [Action::one(Verb::Walk, apple), Action::one(Verb::Grab, apple), Action::one(Verb::Eat, apple)] {
        world.step(me, &action).unwrap();
    }
    let history = world.history().clone();
    let mut scene = world.into_graph();
    let why = plan(&mut scene, me, &"!Eat(apple)".parse().unwrap(), &history).unwrap_err();
    assert!(matches!(why, Unreachable::Irrevocable(_)), "{why:?}");
}

/// A thing that a real graph places both on one thing and inside another one elsewhere counts as inside: it is
/// hidden while the container is closed, and is reached there.
#[test]
fn what_is_both_on_and_inside_is_got_out_of_what_it_is_inside() {
    for apart in [false, true] {
        for box_first in [false, true] {
            for poses in [false, true] {
                let (scene, pot) = contradiction(apart, box_first, poses);
                for (text, most) in [
                    ("Holds(pot)", 4),
                    ("On(pot, sofa)", 6),
                    ("Inside(pot, fridge) & Closed(fridge)", 9),
                    ("On(pot, stove) & Closed(dishwasher)", 8),
                    ("HoldsLeft(me, pot)", 8),
                ] {
                    let task = Task::new("contradiction", text.parse().unwrap());
                    // A policy that does not know the place of the pot can only search one of its two rooms.
                    let mut policies: Vec<Box<dyn Policy>> = vec![Box::new(PlannerPolicy::oracle())];
                    if !apart {
                        policies.extend([
                            Box::new(PlannerPolicy::best()) as Box<dyn Policy>,
                            Box::new(PlannerPolicy::in_unknown_home()),
                        ]);
                    }
                    for (mut policy, spare) in policies.into_iter().zip([0, 8, 8]) {
                        let mut world = Simulator::new(scene.clone());
                        let episode =
                            EpisodeOptions::seeded(1).episode(policy.as_mut(), &task, &mut world, &mut |_| {});
                        let told = format!("{text} {apart} {box_first} {poses} {}: {episode:?}", policy.name());
                        assert_eq!(episode.outcome, Outcome::Won, "{told}");
                        assert!(episode.steps <= most + spare, "{told}");
                        assert!(World::graph(&world).places(pot).count() <= 1, "{told}");
                    }
                }
            }
        }
    }
}

/// A pot both on a table and in a closed dishwasher, which are in one room or in two.
fn contradiction(apart: bool, box_first: bool, poses: bool) -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("contradiction");
    let rooms = ["kitchen", "living_room"].map(|r| scene.add(Draft::new(r)).unwrap());
    let there = rooms[usize::from(apart)];
    let mut x = 0.0;
    let mut draft = |class: &str| {
        x += 4.0;
        let pose = vc_graph::Pose::translation(x, 0.0, 0.5);
        if poses { Draft::new(class).at(pose) } else { Draft::new(class) }
    };
    let [stove, fridge] = ["stove", "fridge"].map(|c| scene.add_in(rooms[0], draft(c)).unwrap());
    let order = if box_first { ["dishwasher", "kitchen_table"] } else { ["kitchen_table", "dishwasher"] };
    let both = order.map(|c| scene.add_in(if c == "dishwasher" { there } else { rooms[0] }, draft(c)).unwrap());
    let (dishwasher, table) = if box_first { (both[0], both[1]) } else { (both[1], both[0]) };
    scene.add_in(rooms[1], draft("sofa")).unwrap();
    scene.add_on(stove, draft("mug")).unwrap();
    let pot = scene.add_on(table, draft("pot")).unwrap();
    scene.add_in(rooms[1], draft("character")).unwrap();
    scene.link_all(&[vc_graph::Edge::new(pot, vc_graph::Relation::Inside, dishwasher)]).unwrap();
    assert!(scene.graph().hidden_in(pot) == Some(dishwasher) && fridge != dishwasher);
    (scene.build(), pot)
}

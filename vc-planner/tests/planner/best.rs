//! Optimal plans: brute force through the transition rule finds none that is shorter.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

#[path = "../../benches/support/homes.rs"]
mod homes;

use crate::brute;

use vc_graph::goal::Situation;
use vc_graph::{
    Action, Draft, Event, Goal, History, NodeId, Property, SceneBuilder, SceneGraph, Scope, Seed, Simulator, State,
    Verb, rule,
};
use vc_planner::{Agent, Decision, PlannerPolicy, plan, run_episode};
use vc_tasks::{Outcome, Task};
use vc_testkit::amount;

/// A small random home, its movable things, and the places where they can be put.
struct World {
    scene: SceneGraph,
    me: NodeId,
    items: Vec<NodeId>,
    places: Vec<NodeId>,
}

fn world(seed: u64) -> World {
    let mut stream = Seed(seed).stream();
    let mut scene = SceneBuilder::new("small");
    let rooms = ["kitchen", "living_room"].map(|r| scene.add(Draft::new(r)).unwrap());
    let mut places = Vec::new();
    for class in ["kitchen_table", "fridge", "nightstand", "desk"] {
        places.push(scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(class)).unwrap());
    }
    let mut items = Vec::new();
    for class in ["apple", "apple", "book", "mug"] {
        let at = *stream.pick(&places).unwrap();
        let inside = at == places[1];
        let draft = Draft::new(class);
        items.push(if inside { scene.add_in(at, draft) } else { scene.add_on(at, draft) }.unwrap());
    }
    let me = scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new("character")).unwrap();
    World { scene: scene.build(), me, items, places }
}

fn goal(seed: u64) -> Goal {
    let mut stream = Seed(seed).child("goal").stream();
    let literals = [
        "On(apple, kitchen_table)",
        "On(apple, desk), 2",
        "On(book, kitchen_table)",
        "Inside(mug, fridge)",
        "Inside(apple, fridge)",
        "Inside(book, fridge)",
        "On(mug, desk)",
        "Closed(fridge)",
        "Open(fridge)",
        "Holds(book)",
        "Holds(mug)",
        "Eat(apple)",
        "Read(book)",
        "Clean(mug)",
    ];
    let mut chosen: Vec<&str> = (0..stream.count(1, 3)).map(|_| *stream.pick(&literals).unwrap()).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen.join(" & ").parse().unwrap()
}

/// All possible actions, whatever their purpose.
fn actions(world: &World) -> Vec<Action> {
    let mut all = Vec::new();
    for &id in world.items.iter().chain(&world.places) {
        for verb in [Verb::Walk, Verb::Open, Verb::Close, Verb::Eat, Verb::Read, Verb::Wash, Verb::Grab, Verb::Drop] {
            all.push(Action::one(verb, id));
        }
    }
    for &item in &world.items {
        for &at in &world.places {
            let surface = world.scene.node(at).unwrap().affords(Property::Surface);
            all.push(Action::two(if surface { Verb::Place } else { Verb::PutIn }, item, at));
            all.push(Action::two(Verb::PutIn, item, at));
        }
    }
    let lasting = |a: &Action| {
        rule::preconditions(world.scene.vocabulary(), a)
            .iter()
            .filter(|c| c.is_lasting())
            .all(|c| c.holds(&world.scene, world.me))
    };
    all.retain(lasting);
    all.dedup();
    all
}

/// The length of the shortest plan; see [`brute::shortest`].
fn shortest(world: &World, goal: &Goal, below: usize, most: usize) -> Result<Option<usize>, ()> {
    let did = |events: &[Event]| -> Vec<Action> {
        let done = |verb| events.iter().find(|e| e.action.verb == verb).map(|_| Action::zero(verb));
        [Verb::Eat, Verb::Read].into_iter().filter_map(done).collect()
    };
    let within = brute::World { scene: &world.scene, me: world.me, actions: &actions(world), remembered: &did };
    brute::shortest(&within, goal, below, most)
}

#[test]
fn no_plan_is_shorter() {
    let (mut compared, mut worst) = (0, Vec::new());
    for seed in 0..amount(40, 120) {
        let world = world(seed);
        let goal = goal(seed);
        let mut scene = world.scene.clone();
        let found = match plan(&mut scene, world.me, &goal, &History::default()) {
            Ok(found) => found,
            Err(why) => {
                assert!(shortest(&world, &goal, 9, 4_000).unwrap_or(None).is_none(), "{goal}: {why}");
                continue;
            }
        };
        let mut simulator = Simulator::new(world.scene.clone());
        for action in &found.actions {
            simulator.step(world.me, action).unwrap();
        }
        assert!(goal.holds(&Situation::new(simulator.graph(), world.me, simulator.history())), "{goal}");
        if let Ok(shorter) = shortest(&world, &goal, found.actions.len(), 12_000) {
            compared += 1;
            if let Some(length) = shorter {
                worst.push(format!("{seed} {goal}: {} against {length}: {:?}", found.actions.len(), found.actions));
            }
        }
    }
    assert!(compared >= amount(20, 60), "{compared}");
    assert!(worst.is_empty(), "{} of {compared}:\n{}", worst.len(), worst.join("\n"));
}

/// Counts, pairs, conditions and negations, which the packed problem cannot express.
const FORMS: [&str; 12] = [
    "exists ?a: apple. (?a != apple.7 & On(?a, desk))",
    "forall ?a: apple. (?a = apple.7 | On(?a, kitchen_table))",
    "exactly 1 ?a: apple. On(?a, kitchen_table)",
    "exactly 0 ?a: apple. Inside(?a, fridge)",
    "at most 1 ?a: apple. (On(?a, desk) | On(?a, nightstand))",
    "pairs ?a: apple, ?b: book. (On(?a, desk) & On(?b, desk))",
    "exactly 1 pairs ?a: apple, ?m: mug. (On(?a, desk) & On(?m, desk))",
    "at most 0 pairs ?a: apple, ?m: mug. (On(?a, desk) & On(?m, desk))",
    "!(Closed(fridge) => Inside(apple, fridge))",
    "!(at least 1 ?a: apple. On(?a, desk)) & Holds(mug)",
    "(On(mug, desk) | Holds(book)) & exactly 0 ?a: apple. Inside(?a, fridge)",
    "forall ?a: apple. (Inside(?a, fridge) => Open(fridge))",
];

#[test]
fn no_form_is_refused_that_can_be_met() {
    let (mut compared, mut ours, mut least) = (0, 0, 0);
    for (seed, text) in (0..amount(4, 12)).flat_map(|seed| FORMS.map(|text| (seed, text))) {
        let world = world(seed);
        let goal: Goal = text.parse().unwrap();
        let Ok(Some(length)) = shortest(&world, &goal, 7, 6_000) else { continue };
        let found = plan(&mut world.scene.clone(), world.me, &goal, &History::default());
        let found = found.unwrap_or_else(|why| panic!("{seed} {text}: {why}, but {length} actions do"));
        (compared, ours, least) = (compared + 1, ours + found.actions.len(), least + length);
    }
    println!("{compared} compared: {ours} actions against {least}");
    assert!(compared >= amount(33, 100), "{compared}");
    // Regression finds some plan, not the shortest.
    assert!(ours * 100 <= least * 105, "{ours} {least}");
}

/// A plan with many parts is not proved optimal at its beginning: its rest is improved on the way, and never
/// made longer.
#[test]
fn long_plans_are_improved_on_the_way() {
    let (mut planned, mut done) = (0, 0);
    for seed in 0..amount(20, 60) {
        let scene = homes::home(120, seed);
        let me = scene.agents()[0];
        let goal: Goal = homes::errands(&scene, 12, seed).join(" & ").parse().unwrap();
        let mut agent = Agent::oracle(&scene, me, goal.clone());
        let mut world = Simulator::new(scene);
        let (mut first, mut steps) = (None, 0);
        loop {
            agent.see(&world.graph().observe(me, Scope::Whole));
            let Decision::Act(action, plan) = agent.decide() else { break };
            first.get_or_insert(plan.actions.len());
            world.step(me, &action).unwrap();
            agent.did(&action);
            steps += 1;
        }
        assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{seed} {goal}");
        assert!(first.is_some_and(|first| steps <= first), "{seed}: {steps} of {first:?} {goal}");
        (planned, done) = (planned + first.unwrap_or(0), done + steps);
    }
    println!("{planned} actions planned at first, {done} done");
    assert!(done < planned, "{done} {planned}");
}

/// The length of a plan that has been executed and has reached its goal.
fn length(scene: &SceneGraph, goal: &Goal) -> usize {
    let me = scene.agents()[0];
    let found = plan(&mut scene.clone(), me, goal, &History::default()).unwrap_or_else(|why| panic!("{goal}: {why}"));
    let mut world = Simulator::new(scene.clone());
    found.actions.iter().for_each(|a| drop(world.step(me, a).unwrap()));
    assert!(goal.holds(&Situation::new(world.graph(), me, world.history())), "{goal}");
    found.actions.len()
}

/// A goal that is too large to be packed at once is planned in parts, using both hands throughout.
#[test]
fn an_errand_of_forty_costs_no_more_than_one_of_twenty() {
    let (mut few, mut many) = (0, 0);
    let (mut done_few, mut done_many) = (0, 0);
    for seed in 0..amount(7, 20) {
        let scene = homes::home(200, seed);
        let goal = |parts| homes::errands(&scene, parts, seed).join(" & ").parse::<Goal>().unwrap();
        few += length(&scene, &goal(20));
        many += length(&scene, &goal(40));
        [done_few, done_many] = [(done_few, 20), (done_many, 40)].map(|(done, parts)| {
            let task = Task { step_limit: 500, ..Task::new("errands", goal(parts)) };
            let episode = run_episode(&mut PlannerPolicy::oracle(), &task, &mut Simulator::new(scene.clone()));
            assert_eq!(episode.outcome, Outcome::Won, "{seed}: {episode:?}");
            done + episode.steps
        });
    }
    println!("planned {few} actions for 20, {many} for 40 errands; done {done_few} and {done_many}");
    assert!(many <= 2 * few && done_many <= 2 * done_few, "{few} {many} {done_few} {done_many}");
}

/// If any of many things would do, needed things are packed before alternatives.
#[test]
fn a_large_goal_about_classes_is_planned_with_both_hands() {
    const THINGS: [&str; 12] =
        ["plate", "fork", "mug", "apple", "book", "milk", "towel", "cellphone", "bowl", "knife", "banana", "pillow"];
    for seed in 0..6 {
        let scene = homes::home(600, seed);
        let (desk, fridge) = (scene.of_class("desk")[3], scene.of_class("fridge")[2]);
        let both = |class: &&str| format!("On({class}, desk.{}), 2 & Inside({class}, fridge.{}), 2", desk.0, fridge.0);
        let goal: Goal = THINGS.iter().map(both).collect::<Vec<_>>().join(" & ").parse().unwrap();
        let there = |id: NodeId| scene.rests_at(id, desk) || scene.rests_at(id, fridge);
        let met = THINGS.iter().flat_map(|class| scene.of_class(class)).filter(|&id| there(id)).count();
        let actions = length(&scene, &goal);
        println!("{actions} actions, {met} of 48 things are there at first");
        assert!(actions <= 4 * (48 - met), "{seed}: {actions} for {met}");
    }
}

/// A thing that already serves one part may be the only one for another.
#[test]
fn what_holds_is_given_up_where_that_is_best() {
    let (mut compared, mut moved) = (0, 0);
    for seed in 0..amount(5, 14) {
        let mut world = world(seed);
        // Only the two apples matter.
        world.items.truncate(2);
        let (first, other) = (world.items[0], world.items[1]);
        for text in [
            format!("On(apple, kitchen_table) & Inside(apple.{}, fridge)", first.0),
            format!("On(apple, desk) & Inside(apple.{}, fridge)", other.0),
            format!("On(apple, desk) & On(apple.{}, nightstand) & Closed(fridge)", first.0),
            format!("Inside(apple, fridge) & On(apple.{}, desk) & On(apple.{}, desk), <= 1", first.0, other.0),
        ] {
            let goal: Goal = text.parse().unwrap();
            let found = plan(&mut world.scene.clone(), world.me, &goal, &History::default());
            let found = found.unwrap_or_else(|why| panic!("{seed} {text}: {why}"));
            if let Ok(shorter) = shortest(&world, &goal, found.actions.len(), 12_000) {
                assert_eq!(shorter, None, "{seed} {text}: {:?}", found.actions);
                compared += 1;
                moved += usize::from(found.actions.iter().filter(|a| a.verb == Verb::Grab).count() > 1);
            }
        }
    }
    println!("{compared} compared, {moved} of which move both");
    assert!(compared >= amount(10, 30) && moved >= amount(2, 8), "{compared} {moved}");
}

/// A book and a mug on a desk, and a closed nightstand elsewhere: with both hands full the nightstand cannot be
/// opened, unless the agent puts something down.
#[test]
fn a_hand_is_freed_in_between() {
    let mut scene = SceneBuilder::new("hands");
    let study = scene.add(Draft::new("office")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    let desk = scene.add_in(study, Draft::new("desk")).unwrap();
    let cabinet = scene.add_in(bedroom, Draft::new("bathroom_cabinet")).unwrap();
    scene.add_on(desk, Draft::new("book")).unwrap();
    scene.add_on(desk, Draft::new("mug")).unwrap();
    let me = scene.add_in(study, Draft::new("character")).unwrap();
    let mut graph = scene.build();
    assert!(graph.node(cabinet).unwrap().is(State::Closed));
    let goal = "Inside(book, bathroom_cabinet) & Inside(mug, bathroom_cabinet)".parse().unwrap();
    let found = plan(&mut graph, me, &goal, &History::default()).unwrap();
    // Opening the nightstand first saves the putting down, since a walk is one action at any distance.
    assert_eq!(found.actions.len(), 8, "{:?}", found.actions);
}

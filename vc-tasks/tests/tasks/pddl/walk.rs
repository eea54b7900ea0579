//! Domains agree with the transition rules: every action that the domain allows is allowed by the rules, and
//! the facts that the domain then predicts hold in the scene.

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::rule::{self, Refusal};
use vc_graph::{Draft, NodeId, Place, Relation, SceneBuilder, SceneGraph, Seed, Simulator, State, Stream};
use vc_tasks::format::pddl::{AtomicFormula, Formula, Keep, Operator, OperatorEffect, planning, read_plan};

/// The facts stated only for the initial scene: about space for objects and people, reachable spots, and the
/// agent's position.
const OF_THE_START: [&str; 8] = ["fits", "seat_free", "bed_free", "loose", "spot", "at", "leaves", "still"];
const ACTIONS: usize = 80;
/// At most one in this many actions may change nothing.
const IDLE: usize = 6;

/// A home in which many actions are possible; another person sits in it holding a seat, and the agent holds a
/// laid tray.
fn home() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("home");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let bedroom = scene.add(Draft::new("bedroom")).unwrap();
    let [table, fridge, stove, oven] = ["kitchen_table", "fridge", "stove", "oven"].map(|class| {
        let draft = if class == "kitchen_table" { Draft::new(class) } else { Draft::new(class).state(State::Open) };
        scene.add_in(kitchen, draft.state(State::On)).unwrap()
    });
    let [sofa, bed] = ["sofa", "bed"].map(|class| scene.add_in(bedroom, Draft::new(class)).unwrap());
    let cabinet = scene.add_in(kitchen, Draft::new("kitchen_cabinet")).unwrap();
    for (class, at) in [("knife", table), ("cup", table), ("towel", sofa), ("novel", bed)] {
        scene.add_on(at, Draft::new(class)).unwrap();
    }
    for (class, at) in [("milk", fridge), ("plate", cabinet), ("chicken", oven)] {
        scene.add_in(at, Draft::new(class)).unwrap();
    }
    let pan = scene.add_on(stove, Draft::new("frying_pan")).unwrap();
    scene.add_in(pan, Draft::new("egg")).unwrap();
    let bowl = scene.add_in(fridge, Draft::new("bowl")).unwrap();
    scene.add_in(bowl, Draft::new("apple")).unwrap();
    let jacket = scene.add_in(kitchen, Draft::new("jacket")).unwrap();
    let [me, other] = [kitchen, bedroom].map(|room| scene.add_in(room, Draft::new("character")).unwrap());
    let balls = ["exercise_ball"; 3].map(|class| scene.add_in(kitchen, Draft::new(class)).unwrap());
    let tray = scene.add_in(kitchen, Draft::new("tray")).unwrap();
    let mut graph = scene.build();
    let mut edit = graph.edit();
    edit.place(balls[0], Place { relation: Relation::On, at: tray }).unwrap();
    edit.place(other, Place { relation: Relation::SittingOn, at: balls[2] }).unwrap();
    edit.hold(me, tray).unwrap();
    edit.hold(me, jacket).unwrap();
    edit.hold(other, balls[1]).unwrap();
    edit.commit();
    (graph, me)
}

type Facts = BTreeSet<AtomicFormula>;
type Bound<'o> = BTreeMap<&'o str, String>;

fn facts(graph: &SceneGraph, me: NodeId) -> Facts {
    let goal = "Open(kitchen_cabinet)".parse().unwrap();
    planning(graph, me, &goal, Keep::Everything).unwrap().problem.initial.into_iter().collect()
}

fn grounded(atom: &AtomicFormula, bound: &Bound<'_>) -> AtomicFormula {
    let name = |argument: &String| bound.get(argument.as_str()).unwrap_or(argument).clone();
    AtomicFormula { predicate: atom.predicate.clone(), arguments: atom.arguments.iter().map(name).collect() }
}

/// A random binding of an operator's variables for which all its preconditions are facts.
fn bind<'o>(needs: &[&'o AtomicFormula], facts: &Facts, bound: Bound<'o>, stream: &mut Stream) -> Option<Bound<'o>> {
    let Some((need, others)) = needs.split_first() else { return Some(bound) };
    let fits = |fact: &&AtomicFormula| fact.predicate == need.predicate && fact.arguments.len() == need.arguments.len();
    let mut ways: Vec<Bound<'o>> = facts.iter().filter(fits).filter_map(|fact| unify(need, fact, &bound)).collect();
    while !ways.is_empty() {
        let way = ways.swap_remove(stream.below(ways.len()));
        if let Some(all) = bind(others, facts, way, stream) {
            return Some(all);
        }
    }
    None
}

fn unify<'o>(need: &'o AtomicFormula, fact: &AtomicFormula, bound: &Bound<'o>) -> Option<Bound<'o>> {
    let mut all = bound.clone();
    for (name, thing) in need.arguments.iter().zip(&fact.arguments) {
        let known =
            if name.starts_with('?') { all.entry(name).or_insert_with(|| thing.clone()) } else { &mut name.clone() };
        if known != thing {
            return None;
        }
    }
    Some(all)
}

fn fact(part: &Formula) -> &AtomicFormula {
    match part {
        Formula::Atom(atom) => atom,
        other => panic!("{other} is no fact"),
    }
}

fn needs(operator: &Operator) -> Vec<&AtomicFormula> {
    match &operator.precondition {
        Formula::And(parts) => parts.iter().map(fact).collect(),
        other => vec![fact(other)],
    }
}

/// An applicable operator with objects for all its variables.
fn some_step<'o>(operator: &'o Operator, facts: &Facts, things: &[String], stream: &mut Stream) -> Option<Bound<'o>> {
    let mut bound = bind(&needs(operator), facts, Bound::new(), stream)?;
    for parameter in &operator.parameters {
        bound.entry(&parameter.name).or_insert_with(|| stream.pick(things).unwrap().clone());
    }
    Some(bound)
}

fn apply(operator: &Operator, bound: &Bound<'_>, facts: &mut Facts) {
    for change in &operator.effect {
        if let OperatorEffect::Delete(atom) = change {
            facts.remove(&grounded(atom, bound));
        }
    }
    for change in &operator.effect {
        if let OperatorEffect::Add(atom) = change {
            facts.insert(grounded(atom, bound));
        }
    }
}

/// Executes random actions of a domain in the scene, and counts them by operator.
fn walk(seed: u64, done: &mut BTreeMap<String, usize>) {
    let (graph, me) = home();
    let planning = planning(&graph, me, &"Open(kitchen_cabinet)".parse().unwrap(), Keep::Everything).unwrap();
    let things: Vec<String> = planning.problem.objects.iter().map(|object| object.name.clone()).collect();
    let (mut state, mut world, mut stream) = (facts(&graph, me), Simulator::new(graph), Seed(seed).stream());
    let all: Vec<&Operator> = planning.domain.operators.iter().collect();
    let telling: Vec<&Operator> = all.iter().copied().filter(|operator| operator.effect.len() > 1).collect();
    for number in 0..ACTIONS {
        let operator = *stream.pick(if number % IDLE == 0 { &all } else { &telling }).unwrap();
        let Some(bound) = some_step(operator, &state, &things, &mut stream) else { continue };
        let arguments: Vec<&str> = operator.parameters.iter().map(|p| bound[p.name.as_str()].as_str()).collect();
        let text = format!("({} {})", operator.name, arguments.join(" "));
        let action = read_plan(&text).unwrap()[0];
        let refused = rule::refusals(world.graph(), me, &action);
        if refused.iter().any(|why| matches!(why, Refusal::DoesNotFit { .. })) {
            continue;
        }
        assert!(refused.is_empty(), "{text}: {}", refused[0]);
        world.step(me, &action).unwrap();
        apply(operator, &bound, &mut state);
        let now = facts(world.graph(), me);
        let begun = |fact: &&AtomicFormula| {
            !OF_THE_START.contains(&fact.predicate.as_str()) && !fact.predicate.starts_with("did_")
        };
        let wrong: Vec<String> = state.difference(&now).filter(begun).map(ToString::to_string).collect();
        assert!(wrong.is_empty(), "after {text}: {wrong:?}");
        *done.entry(operator.name.clone()).or_default() += 1;
    }
}

#[test]
fn what_a_domain_allows_the_rule_allows() {
    let mut done = BTreeMap::new();
    (0..40).for_each(|seed| walk(seed, &mut done));
    let verbs = ["walk", "grab", "place", "put_in", "open", "close", "sit", "stand", "heat", "cool", "cook", "wear"];
    for name in verbs {
        assert!(done.keys().any(|known| known.split('-').next() == Some(name)), "{name} was never done: {done:?}");
    }
}

//! Goals of the Embodied Agent Interface on its own trajectories.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::BTreeMap;
use std::sync::Arc;

use vc_graph::format::eai::{EaiTask, Record, read_record, read_tasks};
use vc_graph::format::virtualhome::EnvironmentGraph;
use vc_graph::goal::{EpisodeTrace, Goal, Quantified};
use vc_graph::{Action, ClassTable, Event, NodeId, SceneGraph, Semantics, Simulator};
use vc_tasks::compile::Monitor;
use vc_tasks::format::eai;
use vc_testkit::data;

fn tasks() -> BTreeMap<String, EaiTask> {
    data::text("eai/goals_dev.json").map_or_else(BTreeMap::new, |text| read_tasks(&text).unwrap())
}

fn records() -> Vec<Record> {
    let text = data::text("eai/programs_dev.jsonl.gz").unwrap_or_default();
    text.lines().map(|line| read_record(line).unwrap()).collect()
}

#[test]
fn every_goal_and_formula_is_written_as_it_is_read() {
    let tasks = tasks();
    let mut formulas = 0;
    for (id, task) in &tasks {
        let json = format!("{{\"a\": {{\"vh_goal\": {}}}}}", eai::goal(&task.goal).unwrap());
        assert_eq!(read_tasks(&json).unwrap()["a"].goal, task.goal, "{id}");
        if let Some(formula) = &task.formula {
            let text = eai::formula(formula).unwrap_or_else(|e| panic!("{id}: {e}"));
            assert_eq!(Goal::from_eai(&text).as_ref(), Ok(formula), "{id}");
            formulas += 1;
        }
    }
    assert!(tasks.is_empty() || formulas >= 50, "{formulas} formulas");
}

/// The trace of a program's execution; refused actions are left out. The last state is the one that
/// their simulator left: a glass that it puts into both hands is in one hand here.
fn trace(start: &SceneGraph, me: NodeId, actions: &[Action], end: &SceneGraph) -> EpisodeTrace {
    let mut world = Simulator::new(start.clone());
    let mut trace = EpisodeTrace::new(start.clone(), me);
    for (i, &action) in actions.iter().enumerate() {
        let last = i + 1 == actions.len();
        if world.step(me, &action).is_ok() || last {
            let graph = if last { end } else { world.graph() };
            trace.push(graph.clone(), [Event { agent: me, action }]);
        }
    }
    trace
}

/// The same trajectory backwards: states and actions.
fn reversed(trace: &EpisodeTrace) -> EpisodeTrace {
    let last = trace.steps();
    let mut back = EpisodeTrace::new(trace.graph(last).unwrap().clone(), trace.agent());
    for step in (0..last).rev() {
        back.push(trace.graph(step).unwrap().clone(), trace.events(step + 1).iter().copied());
    }
    back
}

#[test]
fn goals_hold_at_the_end_and_formulas_only_in_order() {
    let (tasks, classes) = (tasks(), ClassTable::builtin());
    let (mut ends, mut forwards, mut backwards, mut ordered) = (0, 0, 0, 0);
    for record in records() {
        let Some(task) = tasks.get(&record.id) else { continue };
        let build = |g: &vc_graph::format::virtualhome::EnvironmentGraph, classes: &Arc<ClassTable>| {
            g.build(&record.id, classes).unwrap()
        };
        let (start, end) = (build(&record.initial, &classes), build(&record.last, &classes));
        let me = *start.agents().first().unwrap();
        let actions: Vec<Action> = record.program.actions().collect();
        // The actions come from the program, the state from their final graph.
        let events: Vec<Event> = actions.iter().map(|&action| Event { agent: me, action }).collect();
        let now = vc_graph::goal::Situation { graph: &end, agent: me, events: &events };
        assert!(task.goal.holds(&now), "{}: {}", record.id, task.goal);
        ends += 1;
        let Some(formula) = &task.formula else { continue };
        let there = trace(&start, me, &actions, &end);
        assert!(formula.holds_on(&there), "{}: {formula}", record.id);
        forwards += 1;
        assert!(Monitor::from_trace(formula, &there).unwrap().holds(), "{}: {formula}", record.id);
        let back = reversed(&there);
        let holds = formula.holds_on(&back);
        assert_eq!(Monitor::from_trace(formula, &back).unwrap().holds(), holds, "{}: {formula}", record.id);
        ordered += usize::from(matters(formula));
        if matters(formula) && holds {
            // Both orders occur in the trace: something is grabbed, something washed, and something
            // grabbed again; the formula does not say that it is the same object.
            assert!(turned(formula).holds_on(&there), "{}: {formula}", record.id);
            backwards += 1;
        }
    }
    eprintln!(
        "{ends} goals hold, {forwards} formulas; order matters in {ordered}, backwards {backwards} of these hold"
    );
    assert!(backwards * 10 <= ordered, "{backwards} of {ordered} hold backwards");
    assert!(tasks.is_empty() || ends == tasks.len(), "{ends} of {}", tasks.len());
}

/// The formula with its order reversed.
fn turned(formula: &Goal) -> Goal {
    match formula {
        Goal::Then(parts) => Goal::Then(parts.iter().rev().map(turned).collect()),
        Goal::And(parts) => Goal::And(parts.iter().map(turned).collect()),
        Goal::Or(parts) => Goal::Or(parts.iter().map(turned).collect()),
        Goal::Exists(q) => Goal::Exists(Quantified { body: Box::new(turned(&q.body)), ..q.clone() }),
        Goal::ForAll(q) => Goal::ForAll(Quantified { body: Box::new(turned(&q.body)), ..q.clone() }),
        other => other.clone(),
    }
}

/// Whether a formula depends on an order.
fn matters(formula: &Goal) -> bool {
    matches!(formula, Goal::Then(_)) || formula.parts().into_iter().any(matters)
}

/// By VirtualHome's own rules every program can be executed, and ends in exactly the states and edges
/// that their simulator left.
#[test]
fn programs_end_as_theirs_do_by_virtual_homes_semantics() {
    let classes = ClassTable::builtin();
    for record in records() {
        let start = record.initial.build(&record.id, &classes).unwrap();
        let me = start.agents()[0];
        let mut world = Simulator::with(start, Semantics::VirtualHome);
        for action in record.program.actions() {
            world.step(me, &action).unwrap_or_else(|r| panic!("{}: {action}: {}", record.id, r[0]));
        }
        let difference = EnvironmentGraph::from_scene(world.graph()).difference(&record.last);
        assert!(difference.is_empty(), "{}: {difference:?}", record.id);
    }
}

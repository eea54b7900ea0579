//! Environments without bodies: the rule says what actions bring about, the clock when.

use virtualcity::graph::clock::{Durations, ProcessTable, Span};
use virtualcity::graph::{Action, ClassTable, SceneGraph, Seed, Simulator, State, Verb};
use virtualcity::{Environment, MakeError, legal_action};

/// Relations and states, without poses.
fn said(graph: &SceneGraph) -> Vec<String> {
    let states = graph.nodes().map(|n| format!("{} {}", n.label(), n.states()));
    states.chain(graph.edges().map(|e| format!("{} {} {}", e.from, e.relation, e.to))).collect()
}

/// Random legal actions have the outcomes of the symbolic simulator.
#[test]
fn actions_have_the_outcomes_of_the_rule() {
    for seed in [8, 42] {
        let builder = Environment::builder(format!("apartment/{seed}")).agents(2).bodies(false);
        // Processes are for the next test.
        let builder = builder.processes(ProcessTable::default()).durations(Durations::default());
        let mut home = builder.clone().make().unwrap();
        let mut rule = Simulator::new(home.graph().clone());
        let mut stream = Seed(seed).stream();
        for number in 0..60 {
            let agent = home.agents()[number % 2];
            let action = legal_action(rule.graph(), agent, &mut stream);
            rule.step(agent, &action).unwrap();
            home.set_action(agent, action).unwrap();
            assert!(said(home.graph()) == said(rule.graph()), "after {}", action.describe(rule.graph()));
        }
        let saved = home.save().unwrap();
        let other = builder.make().unwrap();
        assert_eq!(other.restore(&saved).unwrap().digest(), home.digest());
    }
}

/// Machines run, and two agents act side by side, as they do with bodies.
#[test]
fn time_passes() {
    let mut home = Environment::builder("apartment/42").agents(2).bodies(false).make().unwrap();
    let (a, b) = (home.agents()[0], home.agents()[1]);
    let machine = home.graph().first_of_class("dishwasher").unwrap();
    let begin = home.tick();
    let switch = Action::one(Verb::SwitchOn, machine);
    for action in [Action::walk(machine), switch] {
        home.set_action(a, action).unwrap();
    }
    assert!(home.graph().node(machine).unwrap().is(State::On));
    home.step(Span::from_seconds(6.0 * 3600.0));
    assert!(home.graph().node(machine).unwrap().is(State::Off), "it has washed");
    let fridge = home.graph().first_of_class("fridge").unwrap();
    let before = home.tick();
    for outcome in home.set_actions(&[(a, Action::walk(fridge)), (b, Action::walk(machine))]) {
        outcome.unwrap();
    }
    assert!(before > begin && home.tick() - before < Span::from_seconds(3.0), "side by side");
}

/// A process that opens something needs a home without bodies, which would stay shut.
#[test]
fn no_process_moves_bodies() {
    let text = "springing | affords:openable | closed | | | open -closed | | | 1 s";
    let table = ProcessTable::parse("springs.txt", text, &ClassTable::builtin()).unwrap();
    let builder = Environment::builder("apartment/42").processes(table);
    let with = builder.clone().make();
    assert!(matches!(with, Err(MakeError::Process(State::Open))));
    let mut home = builder.bodies(false).make().unwrap();
    home.step(Span::from_seconds(2.0));
    assert!(home.graph().node(home.graph().first_of_class("fridge").unwrap()).unwrap().is(State::Open));
}

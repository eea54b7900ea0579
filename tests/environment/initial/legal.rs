//! The legal actions are exactly those without a refusal: every verb with every object.

use std::collections::BTreeSet;

use vc_graph::{Action, Draft, Node, NodeId, SceneGraph, Seed, Simulator, Stream, Verb, Word, rule};
use virtualcity::procgen::Apartment;

/// Actions between two states that are checked.
const STRIDE: usize = 10;
/// In one of this number of states all pairs of objects are tried; in the others only a few objects, and the
/// held ones, are tried with all.
const THOROUGH: usize = 10;
/// Number of objects, besides the held ones, that are tried with all in the other states.
const FEW: usize = 3;

/// A generated home with two people in it.
fn home(seed: u64) -> SceneGraph {
    let mut graph = Apartment::from_seed(Seed(seed)).unwrap().scene();
    let room = graph.rooms()[0];
    let mut edit = graph.edit();
    while edit.graph().agents().len() < 2 {
        let person = edit.add(Draft::new("character")).unwrap();
        edit.move_to_room(person, room).unwrap();
    }
    edit.commit();
    graph
}

/// A random verb that has legal actions, and a random action of it.
fn some_action(legal: &[Action], stream: &mut Stream) -> Action {
    let verbs: BTreeSet<Verb> = legal.iter().map(|a| a.verb).collect();
    let verbs: Vec<Verb> = verbs.into_iter().collect();
    let verb = *stream.pick(&verbs).unwrap();
    let of: Vec<Action> = legal.iter().copied().filter(|a| a.verb == verb).collect();
    *stream.pick(&of).unwrap()
}

/// Checks a list of legal actions against every verb with all objects; for verbs with two objects the first is
/// one of the given objects.
fn compare(graph: &SceneGraph, agent: NodeId, legal: &[Action], first: &[NodeId]) {
    let legal: BTreeSet<Action> = legal.iter().copied().collect();
    let ids: Vec<NodeId> = graph.nodes().map(Node::id).collect();
    let check = |action: Action| {
        let free = rule::refusals(graph, agent, &action).is_empty();
        assert_eq!(legal.contains(&action), free, "{}", action.describe(graph));
        assert_eq!(rule::allows(graph, agent, &action), free, "{}", action.describe(graph));
    };
    for verb in Verb::ALL.iter().copied() {
        match verb.arity() {
            0 => check(Action::zero(verb)),
            1 => ids.iter().for_each(|&id| check(Action::one(verb, id))),
            _ => first.iter().for_each(|&x| ids.iter().for_each(|&y| check(Action::two(verb, x, y)))),
        }
    }
    legal.iter().for_each(|action| check(*action));
}

/// Checks some states of a home that random actions reach.
fn look_at_states(seed: u64, states: usize) {
    let mut world = Simulator::new(home(seed));
    let mut stream = Seed(seed).child("legal").stream();
    let agents = world.graph().agents().to_vec();
    for number in 0..states * STRIDE {
        let agent = *stream.pick(&agents).unwrap();
        let legal = rule::legal_actions(world.graph(), agent);
        if number % STRIDE == STRIDE - 1 {
            let ids: Vec<NodeId> = world.graph().nodes().map(Node::id).collect();
            let few = |stream: &mut Stream| (0..FEW).map(|_| *stream.pick(&ids).unwrap()).collect::<Vec<_>>();
            let held = world.graph().held(agent).chain(few(&mut stream)).collect::<Vec<_>>();
            let all = number / STRIDE % THOROUGH == THOROUGH - 1;
            compare(world.graph(), agent, &legal, if all { &ids } else { &held });
        }
        world.step(agent, &some_action(&legal, &mut stream)).unwrap();
    }
}

/// A hundredth of the states that `proofs/legal` checks.
#[test]
fn a_hundred_states_of_twenty_homes() {
    (0..20).for_each(|seed| look_at_states(seed, 5));
}

/// A hundred states of the home `VC_HOME`: for `proofs/legal`.
#[test]
#[ignore = "takes a minute for each home; proofs/legal runs it for a hundred"]
fn a_hundred_states_of_a_home() {
    let seed = std::env::var("VC_HOME").ok().and_then(|seed| seed.parse().ok()).unwrap_or(0);
    look_at_states(seed, 100);
}

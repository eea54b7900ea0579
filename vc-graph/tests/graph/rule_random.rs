//! After any actions the scene stays valid; refusals change nothing; and regression finds actions with the
//! promised effects.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::rule::{allows, legal_actions, preconditions, refusals, regress::achievers, step};
use vc_graph::{Action, Condition, Node, NodeId, NodeKind, Relation, State, Verb, Word};
use vc_testkit::cases;
use vc_testkit::flat::{Flat, plain};

/// A random step: agent, verb, and objects.
type Wish = (bool, usize, usize, usize);

fn wishes(most: usize) -> impl Strategy<Value = Vec<Wish>> {
    prop::collection::vec((any::<bool>(), any::<usize>(), any::<usize>(), any::<usize>()), 0..most)
}

/// Any action, on near or held objects if `choice` says so.
fn any_action(flat: &Flat, agent: NodeId, (verb, x, y): (usize, usize, usize)) -> Action {
    let verb = Verb::ALL[verb % Verb::ALL.len()];
    let graph = flat.graph();
    let things: Vec<NodeId> = match x % 4 {
        0 => graph.nodes().map(Node::id).collect(),
        1 => graph.held(agent).chain(graph.related(agent, Relation::Near)).collect(),
        _ => graph.nodes().map(Node::id).filter(|&id| graph.near(agent, id)).collect(),
    };
    let pick = |n: usize| things.get(n / 4 % things.len().max(1)).copied().unwrap_or(agent);
    Action::with(verb, &[pick(x), pick(y)][..verb.arity()]).unwrap()
}

/// The legal action on existing objects that the random numbers select.
fn legal_action(flat: &Flat, agent: NodeId, (verb, x, y): (usize, usize, usize)) -> Option<Action> {
    let ids: Vec<NodeId> = flat.graph().nodes().map(Node::id).collect();
    let verb = Verb::ALL[verb % Verb::ALL.len()];
    let things =
        |n: usize| (0..ids.len()).map(move |i| (i + n) % ids.len()).map(|i| flat.graph().nodes().nth(i).unwrap().id());
    let legal = |action: &Action| refusals(flat.graph(), agent, action).is_empty();
    match verb.arity() {
        0 => Some(Action::zero(verb)).filter(legal),
        1 => things(x).map(|id| Action::one(verb, id)).find(legal),
        _ => {
            let held: Vec<NodeId> = flat.graph().held(agent).chain([flat.id("car")]).collect();
            let first = held[x % held.len()];
            things(y).map(|at| Action::two(verb, first, at)).find(legal)
        }
    }
}

/// The legal actions are exactly those without a refusal: every verb with all objects.
fn all_legal(flat: &Flat, agent: NodeId) -> Result<(), TestCaseError> {
    let graph = flat.graph();
    let ids: Vec<NodeId> = graph.nodes().map(Node::id).collect();
    let of = |verb: &Verb| -> Vec<Action> {
        let two = |x: &NodeId| ids.iter().map(|y| Action::two(*verb, *x, *y)).collect::<Vec<_>>();
        match verb.arity() {
            0 => vec![Action::zero(*verb)],
            1 => ids.iter().map(|id| Action::one(*verb, *id)).collect(),
            _ => ids.iter().flat_map(two).collect(),
        }
    };
    let mut every: Vec<Action> = Verb::ALL.iter().flat_map(of).collect();
    prop_assert!(every.iter().all(|a| allows(graph, agent, a) == refusals(graph, agent, a).is_empty()));
    every.retain(|action| refusals(graph, agent, action).is_empty());
    prop_assert_eq!(legal_actions(graph, agent), every);
    Ok(())
}

/// Acts; checks that a refusal changes nothing.
fn act(flat: &mut Flat, agent: NodeId, action: &Action) -> Result<bool, TestCaseError> {
    let before = flat.graph().clone();
    let refused = refusals(&before, agent, action);
    match flat.sim.step(agent, action) {
        Ok(changes) => {
            prop_assert_eq!(refused, []);
            let mut back = flat.graph().clone();
            changes.undo(&mut back).unwrap();
            prop_assert!(back == before, "{} is not undone", action.describe(&before));
            Ok(true)
        }
        Err(why) => {
            prop_assert!(!why.is_empty() && *flat.graph() == before, "{}", plain(&why));
            Ok(false)
        }
    }
}

/// The scene is valid, and the agents' states fit their relations.
fn sound(flat: &Flat) -> Result<(), TestCaseError> {
    prop_assert_eq!(flat.graph().validate(), []);
    let agents = flat.graph().agents().iter();
    for (agent, node) in agents.map(|&id| (id, flat.graph().node(id).unwrap())) {
        let seated =
            flat.graph().related(agent, Relation::SittingOn).chain(flat.graph().related(agent, Relation::Inside));
        prop_assert_eq!(node.is(State::Sitting), seated.count() == 1);
        prop_assert_eq!(node.is(State::Lying), flat.graph().related(agent, Relation::LyingOn).count() == 1);
        for held in flat.graph().held(agent) {
            prop_assert_eq!(flat.graph().room_of(held), flat.graph().room_of(agent));
        }
    }
    Ok(())
}

fn who(flat: &Flat, other: bool) -> NodeId {
    if other { flat.other } else { flat.me }
}

/// Conditions on objects of every sort, of the kinds that one action achieves.
fn conditions(flat: &Flat, agent: NodeId) -> Vec<Condition> {
    let mut all = vec![Condition::FreeHand, Condition::Upright];
    for node in flat.graph().nodes().filter(|n| n.id() != agent) {
        let id = node.id();
        all.extend([Condition::Near(id), Condition::Holding(id), Condition::Facing(id), Condition::Accessible(id)]);
        all.extend([Condition::Worn(id), Condition::SameRoom(id), Condition::Accepts(id), Condition::AboardOf(id)]);
        all.extend(State::ALL.iter().flat_map(|&s| [Condition::In(id, s), Condition::NotIn(id, s)]));
        if node.kind() == NodeKind::Room {
            continue;
        }
        all.extend(
            flat.graph().held(agent).flat_map(|held| {
                [Relation::On, Relation::Inside].map(|relation| Condition::Related(held, relation, id))
            }),
        );
    }
    all.extend([State::Sitting, State::Lying, State::Asleep].map(|s| Condition::In(agent, s)));
    all
}

/// Every possible achiever has the required effect.
fn promises(flat: &Flat, agent: NodeId) -> Result<(), TestCaseError> {
    for want in conditions(flat, agent) {
        if want.holds(flat.graph(), agent) {
            continue;
        }
        for action in achievers(flat.graph(), agent, &want) {
            let possible =
                preconditions(flat.graph().vocabulary(), &action).iter().all(|c| c.holds(flat.graph(), agent));
            prop_assert_eq!(possible, refusals(flat.graph(), agent, &action).is_empty());
            let mut graph = flat.graph().clone();
            if possible && step(&mut graph, agent, &action).is_ok() {
                let shown = action.describe(flat.graph()).to_string();
                prop_assert!(want.holds(&graph, agent), "{shown} does not achieve {want:?}");
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn anything_tried_leaves_a_sound_scene(wishes in wishes(120)) {
        let mut flat = Flat::new();
        for (other, verb, x, y) in wishes {
            let agent = who(&flat, other);
            let action = any_action(&flat, agent, (verb, x, y));
            if act(&mut flat, agent, &action)? {
                sound(&flat)?;
            }
        }
    }

    #[test]
    fn anything_done_leaves_a_sound_scene(wishes in wishes(120)) {
        let mut flat = Flat::new();
        for (other, verb, x, y) in wishes {
            let agent = who(&flat, other);
            if let Some(action) = legal_action(&flat, agent, (verb, x, y)) {
                prop_assert!(act(&mut flat, agent, &action)?);
                sound(&flat)?;
            }
        }
    }

    #[test]
    fn achievers_achieve(wishes in wishes(25)) {
        let mut flat = Flat::new();
        for (other, verb, x, y) in wishes {
            let agent = who(&flat, other);
            if let Some(action) = legal_action(&flat, agent, (verb, x, y)) {
                act(&mut flat, agent, &action)?;
            }
        }
        promises(&flat, flat.me)?;
        all_legal(&flat, flat.other)?;
    }
}

#[test]
fn the_first_achiever_needs_least() {
    let flat = Flat::after(&["walk kitchen_table", "grab cup"]);
    let first = |want: Condition| {
        let action = achievers(flat.graph(), flat.me, &want).into_iter().next();
        action.map(|a| a.describe(flat.graph()).to_string().split('.').next().unwrap().to_owned())
    };
    let [milk, plate, cup, book] = ["milk", "plate", "cup", "book"].map(|n| flat.id(n));
    assert_eq!(first(Condition::Accessible(milk)).as_deref(), Some("open fridge"));
    assert_eq!(first(Condition::Near(book)).as_deref(), Some("walk book"));
    assert_eq!(first(Condition::Holding(plate)).as_deref(), Some("grab plate"));
    assert_eq!(first(Condition::Facing(book)).as_deref(), Some("turn_to book"));
    assert_eq!(first(Condition::Upright), Some("stand".into()));
    assert_eq!(first(Condition::Related(cup, Relation::On, plate)).as_deref(), Some("place cup"));
    assert_eq!(first(Condition::In(plate, State::Broken)), None, "nothing breaks a plate");
    assert_eq!(first(Condition::Affords(plate, vc_graph::Property::Eatable)), None);
}

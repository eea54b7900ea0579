//! Objects that no agent moves keep their positions and placements, however a home is made and whatever is done
//! beside them.

use virtualcity::graph::format::{native, read_scene};
use virtualcity::graph::{ClassTable, Edge, NodeId, Place, Relation, SceneGraph, Verb};
use virtualcity::{Environment, SceneOptions};

use super::boxes::one;
use super::{act, common, home};

/// The distance above which an object counts as moved, metres.
const STILL: f32 = 0.005;

/// The placements and rooms of all objects except some.
fn places(graph: &SceneGraph, but: &[NodeId]) -> Vec<Edge> {
    let counts = |e: &Edge| Relation::places().contains(&e.relation) || e.relation == Relation::InRoom;
    graph.edges().filter(|e| counts(e) && !but.contains(&e.from)).collect()
}

fn differences(was: &SceneGraph, now: &SceneGraph, but: &[NodeId]) -> Vec<String> {
    let (was_at, is_at) = (places(was, but), places(now, but));
    let told = |e: &Edge| format!("{} {} {}", was.label(e.from), e.relation, was.label(e.to));
    let lost = was_at.iter().filter(|e| !is_at.contains(e)).map(|e| format!("not {}", told(e)));
    lost.chain(is_at.iter().filter(|e| !was_at.contains(e)).map(told)).collect()
}

fn moved(was: &SceneGraph, now: &SceneGraph) -> Vec<String> {
    let far = |id: NodeId| {
        let at = |graph: &SceneGraph| graph.node(id)?.pose().map(|p| p.translation.vector);
        at(was).zip(at(now)).map(|(a, b)| (a - b).norm())
    };
    let all = was.nodes().map(|n| n.id()).filter(|id| far(*id).is_some_and(|far| far > STILL));
    all.map(|id| was.label(id).to_string()).collect()
}

/// A scene of VirtualHome, if the shared data exists.
fn scene(number: u32) -> Option<Environment> {
    common::scene(number).map(|graph| Environment::of_with(graph, 1, &SceneOptions::default()).unwrap())
}

fn kept() -> Environment {
    let graph = read_scene(include_str!("../data/boxes_kept.json"), &ClassTable::builtin()).unwrap();
    Environment::of_with(graph, 1, &SceneOptions::default()).unwrap()
}

/// Pictures hang, books lean and boxes overlap as before: in a home made from another one's graph, from its
/// file, and after a reset to either.
#[test]
fn a_home_stands_the_same_however_it_is_made() {
    let homes = [Some(home(42, 1)), Some(home(7123, 1)), Some(kept()), scene(1)];
    for mut home in homes.into_iter().flatten() {
        let graph = home.graph().clone();
        let name = graph.name().to_owned();
        let read = native::read(&native::write(&graph), graph.classes()).unwrap();
        for form in [graph.clone(), read.clone()] {
            let again = Environment::of(form, 1).unwrap();
            assert!(again.left_out().is_empty(), "{name}");
            assert_eq!(moved(&graph, again.graph()), Vec::<String>::new(), "{name}");
            assert_eq!(differences(&graph, again.graph(), &[]), Vec::<String>::new(), "{name}");
        }
        home.reset(&read).unwrap();
        assert_eq!(moved(&graph, home.graph()), Vec::<String>::new(), "{name} after a reset");
        assert_eq!(differences(&graph, home.graph(), &[]), Vec::<String>::new(), "{name} after a reset");
    }
}

/// Wherever an agent walks first, plates that a scene has on a table stay there, even if the table's box
/// contains them.
#[test]
fn who_walks_by_changes_nothing() {
    let homes = [(Some(kept()), 1), (scene(1), 16), (scene(2), 16)];
    for (home, every) in homes.into_iter().filter_map(|(home, every)| Some((home?, every))) {
        let me = home.agents()[0];
        let walks = home.legal_actions(me).into_iter().filter(|a| a.verb == Verb::Walk);
        for action in walks.step_by(every) {
            let mut then = home.clone();
            if then.set_action(me, action).is_ok() {
                let changed = differences(home.graph(), then.graph(), &[me]);
                assert_eq!(changed, Vec::<String>::new(), "{}", action.describe(home.graph()));
            }
        }
    }
}

/// A pepper that sticks out of a bowl is carried with the bowl, and stays inside it.
#[test]
fn what_is_wider_than_its_bowl_goes_along() {
    let mut home = kept();
    let [me, table, plate, bowl, pepper, sofa] = [
        home.agents()[0],
        one(&home, "kitchen_table"),
        one(&home, "plate"),
        one(&home, "bowl"),
        one(&home, "bell_pepper"),
        one(&home, "sofa"),
    ];
    let on_table = Place { relation: Relation::On, at: table };
    for id in [plate, bowl, pepper] {
        assert!(home.graph().places(id).any(|p| p == on_table), "{}", home.graph().label(id));
    }
    let within = |home: &Environment| {
        let pose = |id| home.world().pose(id).unwrap();
        (pose(bowl).inverse() * pose(pepper)).translation.vector
    };
    let (was, in_bowl) = (within(&home), Place { relation: Relation::Inside, at: bowl });
    act(&mut home, me, Verb::Walk, &[bowl]);
    act(&mut home, me, Verb::Grab, &[bowl]);
    for thing in [sofa, table] {
        act(&mut home, me, Verb::Walk, &[thing]);
        assert!((within(&home) - was).norm() < STILL, "{:?}", home.start().places(pepper).collect::<Vec<_>>());
        assert!(home.graph().places(pepper).eq([in_bowl]));
    }
    assert!(home.graph().places(plate).any(|p| p == on_table));
}

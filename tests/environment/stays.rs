//! Things that nobody moves keep their spots and their places, however a home is made and whatever is done beside them.

use virtualcity::graph::format::{native, read_scene, thesis};
use virtualcity::graph::{Action, ClassTable, Edge, Node, NodeId, Place, Pose, Property, Relation, SceneGraph, Verb};
use virtualcity::physics::Role;
use virtualcity::{Environment, SceneOptions};

use super::boxes::one;
use super::{act, common, home};

/// Farther than this a thing has moved, metres.
const STILL: f32 = 0.005;

/// Where things are, and in which room, but for some.
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

/// A scene of VirtualHome, where the shared data is.
fn scene(number: u32) -> Option<Environment> {
    common::scene(number).map(|graph| Environment::of_with(graph, 1, &SceneOptions::default()).unwrap())
}

fn kept() -> Environment {
    let graph = read_scene(include_str!("../data/boxes_kept.json"), &ClassTable::builtin()).unwrap();
    Environment::of_with(graph, 1, &SceneOptions::default()).unwrap()
}

/// Pictures hang, books lean and boxes overlap as they did: in a home made from another one's graph, from its file,
/// and after a reset to either.
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

/// The thesis's JSON carries no shapes: what is read back gets those of its classes anew, and stands as it stood.
#[test]
fn a_home_comes_back_from_the_thesis_form_as_it_stood() {
    for home in [Some(home(0, 1)), scene(6)].into_iter().flatten() {
        let graph = home.graph();
        let read = thesis::read(&thesis::write(graph), graph.classes()).unwrap();
        let all: Vec<Edge> = graph.edges().collect();
        assert!(read.edges().eq(all.iter().copied()), "{}: relations are read as they are written", graph.name());
        for (was, is) in graph.nodes().zip(read.nodes()) {
            assert_eq!(
                (was.label(), was.states(), &was.spec().properties),
                (is.label(), is.states(), &is.spec().properties)
            );
        }
        let again = Environment::of_with(read, 1, &SceneOptions::default()).unwrap();
        let (now, share) = (again.graph(), |part: usize, of: usize| 100.0 * part as f64 / of as f64);
        assert_eq!(again.left_out(), []);
        let name = graph.name();
        let strayed = strayed(graph, now);
        assert!(share(strayed.len(), graph.len()) <= 1.0, "{name}: {strayed:?}");
        let rooms = graph.nodes().filter(|n| graph.room_of(n.id()) != now.room_of(n.id())).count();
        assert!(share(rooms, graph.len()) <= 1.0, "{name}: {rooms} are in another room");
        let kept = now.edges().filter(|e| graph.has(*e)).count();
        assert!(share(kept, all.len()) >= 99.0, "{name}: {kept} relations of {}", all.len());
        let elsewhere = differences(graph, now, &[]);
        assert!(share(elsewhere.len(), places(graph, &[]).len()) <= 1.5, "{name}: {elsewhere:?}");
    }
}

/// Things that are more than a centimetre or a degree from where they were.
fn strayed(was: &SceneGraph, now: &SceneGraph) -> Vec<String> {
    let is_near = |a: &Pose, b: &Pose| {
        (a.translation.vector - b.translation.vector).norm() < 0.01
            && a.rotation.angle_to(&b.rotation).to_degrees() < 1.0
    };
    let pose = |graph: &SceneGraph, id| graph.node(id).and_then(|n| n.pose().copied());
    let strayed = |n: &&Node| pose(was, n.id()).zip(pose(now, n.id())).is_none_or(|(a, b)| !is_near(&a, &b));
    was.nodes().filter(strayed).map(|n| n.label().to_string()).collect()
}

/// Wherever one walks first: plates that a scene has on a table stay there, though the table's box is around them.
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

/// A pepper that sticks out through a bowl's side is carried with the bowl, and is in it wherever that goes.
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

/// A thing that its scene has where there is hardly room for it is taken, and goes back to where it was: a bowl into
/// the pile it was in, a towel onto its rack.
#[test]
fn what_lies_tight_goes_back_where_it_lay() {
    let (mut tried, mut back) = (0, 0);
    for (home, every) in [(Some(kept()), 1), (scene(6), 3)].into_iter().filter_map(|(home, every)| Some((home?, every)))
    {
        let (graph, me) = (home.graph(), home.agents()[0]);
        let held = |n: &&Node| n.affords(Property::Graspable) && home.world().role(n.id()) == Some(Role::Hung);
        let hidden = |n: &&Node| graph.hidden_in(n.id()).is_some();
        for id in graph.nodes().filter(held).filter(|n| !hidden(n)).map(Node::id).step_by(every) {
            let holds = |p: &Place| graph.node(p.at).is_some_and(|at| at.affords(Property::Surface));
            let Some(place) = graph.places(id).find(|p| p.relation == Relation::On && holds(p)) else { continue };
            let mut then = home.clone();
            let steps = [
                Action::one(Verb::Walk, id),
                Action::one(Verb::Grab, id),
                Action::one(Verb::Walk, place.at),
                Action::two(Verb::Place, id, place.at),
            ];
            tried += 1;
            if steps.into_iter().all(|action| then.set_action(me, action).is_ok()) {
                back += 1;
                let pose = |home: &Environment| home.world().pose(id).unwrap().translation.vector;
                assert!((pose(&home) - pose(&then)).norm() < 0.01, "{}", graph.label(id));
                assert!(then.graph().places(id).any(|p| p == place), "{}", graph.label(id));
            }
        }
    }
    assert!(back > 0 && back * 10 >= tried * 9, "{back} of {tried}");
}

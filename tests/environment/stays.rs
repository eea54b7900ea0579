//! Objects that no agent moves keep their positions and placements, however a home is made and whatever is done
//! beside them.

use std::sync::OnceLock;

use vc_testkit::amount;
use virtualcity::graph::format::{native, read_scene, thesis};
use virtualcity::graph::{
    Action, Bounds, ClassTable, Draft, Edge, Node, NodeId, Place, Pose, Property, Relation, SceneBuilder, SceneGraph,
    State, Verb,
};
use virtualcity::physics::{BodyRole, Posture};
use virtualcity::{Assets, Environment, MakeError};

use super::boxes::one;
use super::{act, home};

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

/// A home of boxes with the looks of its classes.
fn generated(graph: SceneGraph) -> Result<Environment, MakeError> {
    Environment::builder_from_scene(graph).assets(Assets::Generated).make()
}

/// A scene of VirtualHome, if the shared data exists.
fn scene(number: u32) -> Option<Environment> {
    static MADE: [OnceLock<Option<Environment>>; 7] = [const { OnceLock::new() }; 7];
    let make = || vc_testkit::data::scene(number).map(|graph| generated(graph).unwrap());
    MADE[number as usize].get_or_init(make).clone()
}

fn kept() -> Environment {
    let graph = read_scene(include_str!("../data/boxes_kept.json"), &ClassTable::builtin()).unwrap();
    generated(graph).unwrap()
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
            let again = Environment::from_scene(form, 1).unwrap();
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
        let again = generated(read).unwrap();
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

/// Wherever an agent walks first, plates that a scene has on a table stay there, even if the table's box
/// contains them.
#[test]
fn who_walks_by_changes_nothing() {
    let homes = [(Some(kept()), 1), (scene(1), amount(32, 16)), (scene(2), amount(32, 16))];
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

/// A thing that its scene has where there is hardly room for it is taken, and goes back to where it was: a bowl into
/// the pile it was in, a towel onto its rack.
#[test]
fn what_lies_tight_goes_back_where_it_lay() {
    let (mut tried, mut back) = (0, 0);
    for (home, every) in [(Some(kept()), 1), (scene(6), 3)].into_iter().filter_map(|(home, every)| Some((home?, every)))
    {
        let (graph, me) = (home.graph(), home.agents()[0]);
        let held = |n: &&Node| n.affords(Property::Graspable) && home.world().role(n.id()) == Some(BodyRole::Hung);
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

/// An agent that gets up from a bed in a corner, or from a mat, gets to a spot from which the home is reached as before.
#[test]
fn who_gets_up_gets_on() {
    for (seed, verb, thing) in [(970_002, Verb::Sit, "double_bed.187"), (970_008, Verb::Lie, "bath_mat.39")] {
        let mut home = home(seed, 1);
        let (me, seat) = (home.agents()[0], thing.rsplit('.').next().unwrap().parse().map(NodeId).unwrap());
        assert_eq!(home.graph().label(seat).to_string(), thing);
        act(&mut home, me, Verb::Walk, &[seat]);
        act(&mut home, me, verb, &[seat]);
        act(&mut home, me, Verb::Stand, &[]);
        for room in home.graph().rooms().to_vec() {
            let mut then = home.clone();
            act(&mut then, me, Verb::Walk, &[room]);
        }
    }
}

/// Those who sit in a scene sit in the home made from it, and get up; after a reset, too.
#[test]
fn who_sits_in_a_scene_sits() {
    let scene = read_scene(include_str!("../data/seated.json"), &ClassTable::builtin()).unwrap();
    let of_boxes = generated(scene).unwrap();
    let mut sitting = home(42, 1);
    let (me, sofa) = (sitting.agents()[0], one(&sitting, "sofa"));
    act(&mut sitting, me, Verb::Walk, &[sofa]);
    act(&mut sitting, me, Verb::Sit, &[sofa]);
    let again = Environment::from_scene(sitting.graph().clone(), 1).unwrap();
    assert_eq!(again.posture(me), sitting.posture(me));
    assert_eq!(again.world().pose(me), sitting.world().pose(me));
    let mut reset = home(42, 1);
    assert!(reset.reset(sitting.graph()).unwrap().elsewhere.is_empty());
    for mut home in [of_boxes, again, reset] {
        let (me, sofa) = (home.agents()[0], one(&home, "sofa"));
        assert!(home.elsewhere().iter().all(|e| e.thing.id != me));
        assert!(matches!(home.posture(me), Some(Posture::Sitting(on, _)) if on == sofa));
        assert_eq!(home.graph().place(me), Some(Place { relation: Relation::SittingOn, at: sofa }));
        act(&mut home, me, Verb::Stand, &[]);
        let fridge = one(&home, "fridge");
        act(&mut home, me, Verb::Walk, &[fridge]);
    }
}

/// A reset to a home's own graph, from there or from the start, keeps what is in an open fridge, on its door too.
#[test]
fn an_open_fridge_stays_full() {
    let mut home = home(42, 1);
    let (start, me, fridge) = (home.clone(), home.agents()[0], one(&home, "fridge"));
    act(&mut home, me, Verb::Walk, &[fridge]);
    act(&mut home, me, Verb::Open, &[fridge]);
    let graph = home.graph().clone();
    let full = |home: &Environment| home.graph().relating(Relation::Inside, fridge).count();
    let (was, poses) = (full(&home), home.world().poses());
    assert!(home.reset(&graph).unwrap().unplaced.is_empty());
    assert!(home.world().poses() == poses && home.graph() == &graph);
    let mut moved = graph.clone();
    let mut edit = moved.edit();
    edit.enter_state(one(&home, "television"), State::On).unwrap();
    edit.commit();
    for mut home in [home, start] {
        let report = home.reset(&moved).unwrap();
        assert!(report.unplaced.is_empty() && report.elsewhere.is_empty(), "{report:?}");
        assert_eq!(full(&home), was);
    }
}

/// An agent that a graph has in a wall or in furniture is put on free floor, and that is told.
#[test]
fn nobody_stays_in_a_wall() {
    let mut home = home(42, 1);
    let (me, start) = (home.agents()[0], home.start().clone());
    for class in ["wall", "fridge"] {
        let middle = start.node(start.of_class(class)[0]).unwrap().aabb().unwrap().centre();
        let mut graph = start.clone();
        let mut edit = graph.edit();
        edit.set_pose(me, Some(Pose::translation(middle.x, middle.y, 0.0))).unwrap();
        edit.commit();
        let report = home.reset(&graph).unwrap();
        assert!(report.elsewhere.iter().any(|e| e.thing.id == me), "{class}: {report:?}");
        let at = home.world().pose(me).unwrap().translation.vector.xy();
        assert!(home.floor().is_free(at.into()), "{class}");
    }
}

/// A home made from its own graph is the same, as everything is at rest there.
#[test]
fn a_home_of_its_own_graph_is_the_same() {
    let home = home(7123, 1);
    let again = Environment::from_scene(home.graph().clone(), 1).unwrap();
    let shifted: Vec<String> = moved_at_all(home.graph(), again.graph());
    assert_eq!(shifted, Vec::<String>::new());
    assert!(home.graph().edges().eq(again.graph().edges()));
}

fn moved_at_all(was: &SceneGraph, now: &SceneGraph) -> Vec<String> {
    // Unit quaternions are rounded wherever they are read.
    let alike =
        |a: &Pose, b: &Pose| a.translation == b.translation && (a.rotation.coords - b.rotation.coords).norm() < 1e-6;
    let pose = |graph: &SceneGraph, id: NodeId| graph.node(id).and_then(|n| n.pose().copied());
    let same = |id: NodeId| match (pose(was, id), pose(now, id)) {
        (Some(a), Some(b)) => alike(&a, &b),
        (a, b) => a == b,
    };
    was.nodes().filter(|n| !same(n.id())).map(|n| n.label().to_string()).collect()
}

/// An agent that sits in a bathtub stays there, whatever opens beside it; and a thing that opens stays where it is.
#[test]
fn a_thing_that_opens_keeps_its_places() {
    let mut home = home(880_001, 1);
    let (me, tub, cabinet) = (home.agents()[0], one(&home, "bathtub"), one(&home, "bathroom_cabinet"));
    act(&mut home, me, Verb::Walk, &[tub]);
    act(&mut home, me, Verb::Sit, &[tub]);
    let before: Vec<Place> = home.graph().places(cabinet).collect();
    act(&mut home, me, Verb::Open, &[cabinet]);
    assert_eq!(home.graph().place(me), Some(Place { relation: Relation::SittingOn, at: tub }));
    assert!(home.graph().places(cabinet).eq(before));
}

/// A thing whose box is far from its origin is put on its table, and takes part.
#[test]
fn a_box_far_from_its_origin_rests_on_the_table() {
    let scene = read_scene(include_str!("../data/box_above.json"), &ClassTable::builtin()).unwrap();
    let home = generated(scene).unwrap();
    let (apple, table) = (one(&home, "apple"), one(&home, "kitchen_table"));
    assert!(home.left_out().is_empty());
    assert_eq!(home.world().role(apple), Some(BodyRole::Loose));
    let (own, at) = (home.world().aabb(apple).unwrap(), home.world().aabb(table).unwrap());
    assert!((own.min.z - at.max.z).abs() < STILL, "{own:?}");
    assert_eq!(home.graph().place(apple), Some(Place { relation: Relation::On, at: table }));
}

/// A home whose floor is in no room of the scene is restored as it was saved: the rooms of all things, the walkable
/// floor, and the number of the next node, after nodes were removed too.
#[test]
fn what_is_restored_is_what_was_saved() {
    let mut scene = SceneBuilder::new("narrow");
    let standing = |x: f32, y: f32, z: f32| Bounds::standing([x, y, z].into());
    let mut add = |class: &str, bounds: Bounds, at: [f32; 3]| {
        scene.add(Draft::new(class).bounds(bounds).at(Pose::translation(at[0], at[1], at[2]))).unwrap()
    };
    add("kitchen", standing(3.0, 6.0, 2.5), [0.0; 3]);
    add("floor", standing(6.0, 6.0, 0.1), [0.0, 0.0, -0.1]);
    let table = add("kitchen_table", standing(1.0, 1.0, 0.8), [0.0, 1.5, 0.0]);
    add("apple", standing(0.08, 0.08, 0.08), [0.0, 1.5, 0.8]);
    let mut home = Environment::from_scene(scene.build(), 1).unwrap();
    let mut graph = home.graph().clone();
    let pear = home.spawn("pear", Place { relation: Relation::On, at: table }).unwrap();
    let mut with = home.graph().clone();
    let mut edit = with.edit();
    edit.remove(pear).unwrap();
    edit.commit();
    for (name, wanted) in [("without", &mut graph), ("removed", &mut with)] {
        home.reset(wanted).unwrap();
        let restored = home.restore(&home.save().unwrap()).unwrap();
        assert_eq!(restored.graph(), home.graph(), "{name}");
        assert_eq!(restored.graph().next_number(), home.graph().next_number(), "{name}");
        assert!(restored.relations().edges() == home.relations().edges(), "{name}");
        assert!((restored.floor().area() - home.floor().area()).abs() < 1e-6, "{name}");
    }
}

/// A box of a hundred kilometres is refused before bodies are made.
#[test]
fn a_huge_box_is_refused_at_once() {
    let mut scene = SceneBuilder::new("huge");
    let bounds = Bounds::standing([0.7, 0.7, 1e5].into());
    scene.add(Draft::new("fridge").bounds(bounds).at(Pose::identity())).unwrap();
    let error = Environment::from_scene(scene.build(), 1).unwrap_err();
    assert!(matches!(error, MakeError::Relations(_)), "{error}");
}

/// A cabinet, a counter and a book of VirtualHome's scenes that open stay where they are, and so does what lies on a
/// microwave whose door opens.
#[test]
fn scenes_of_boxes_keep_places_through_an_opening() {
    let opened: [(u32, &[(u32, &str)]); 3] = [
        (5, &[(132, "kitchen_cabinet")]),
        (2, &[(123, "kitchen_counter")]),
        (6, &[(121, "book"), (234, "fridge"), (238, "microwave")]),
    ];
    for (number, things) in opened {
        let Some(home) = scene(number) else { return };
        for &(id, class) in things {
            let (mut home, id) = (home.clone(), NodeId(id));
            assert_eq!(&**home.graph().node(id).unwrap().class(), class);
            let (me, before): (NodeId, Vec<Place>) = (home.agents()[0], home.graph().places(id).collect());
            act(&mut home, me, Verb::Walk, &[id]);
            act(&mut home, me, Verb::Open, &[id]);
            assert!(home.graph().places(id).eq(before), "{class}");
        }
    }
}

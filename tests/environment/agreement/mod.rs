//! Rule and bodies agree, and the graph equals a scene derived anew.

use vc_testkit::amount;
use virtualcity::graph::{
    Action, Bounds, Draft, Edge, Node, NodeId, NodeKind, Place, Pose, Property, Relation, SceneBuilder, SceneGraph,
    Seed, State, Verb,
};
use virtualcity::physics::{BodyRole, Posture};
use virtualcity::relations::{Evidence, RelationRule, Relations};
use virtualcity::{ActionError, Environment, PhysicalRefusal, legal_action};

use super::{act, home};

/// All edges except those that only the rule knows: agents can turn towards anything.
fn edges(graph: &SceneGraph) -> Vec<Edge> {
    let turned = |e: &Edge| e.relation == Relation::Facing && graph.agents().contains(&e.from);
    let mut edges: Vec<Edge> = graph.edges().filter(|e| !turned(e)).collect();
    edges.sort_unstable();
    edges
}

/// The positions of all doors and the things that hands carry, read anew.
fn evidence(home: &Environment) -> Evidence {
    let world = home.world();
    let carried = world.nodes().into_iter().filter(|id| world.role(*id) == Some(BodyRole::Carried));
    let mut evidence = Evidence::default().carrying(carried);
    for id in world.nodes() {
        let turned = (0..).zip(world.parts(id).all()).filter(|(_, part)| part.position != 0.0);
        evidence.positions.extend(turned.map(|(joint, part)| ((id, joint), part.position)));
    }
    evidence
}

/// The scene's relations read anew from its poses, the positions of its doors and the things that hands carry. A
/// thing that stands open keeps its places, as it has not moved: its open door may touch another wall.
fn rebuilt(home: &Environment) -> SceneGraph {
    let world = home.world();
    let relations = Relations::new(home.graph(), RelationRule::Contacts, evidence(home)).unwrap();
    let mut graph = home.graph().clone();
    let all: Vec<NodeId> = graph.nodes().map(Node::id).collect();
    let is_open = |id: NodeId| world.parts(id).all().iter().any(|part| part.position != 0.0);
    let places = |graph: &SceneGraph, id: NodeId| graph.places(id).collect::<Vec<Place>>();
    let rests = |p: &Place| matches!(p.relation, Relation::On | Relation::Inside);
    let kept = |graph: &SceneGraph, id| Some(places(graph, id)).filter(|all| is_open(id) && all.iter().all(rests));
    relations.write_except(&mut graph, &all, |graph, id| kept(graph, id).filter(|all| !all.is_empty())).unwrap();
    graph
}

/// The entries that only one of two lists has, as text.
fn apart(graph: &SceneGraph, one: &[Edge], other: &[Edge]) -> Vec<String> {
    let only = one.iter().filter(|e| other.binary_search(e).is_err());
    only.map(|e| format!("{} {} {}", graph.label(e.from), e.relation, graph.label(e.to))).collect()
}

/// The graph has all bodies where they are, and its relations are as read anew, though only what has moved is read.
fn assert_as_rebuilt(home: &Environment, after: &str) {
    for (id, pose) in home.world().poses() {
        assert_eq!(home.graph().node(id).unwrap().pose(), Some(&pose), "{after}: {}", home.graph().label(id));
    }
    assert!(home.relations().evidence() == &evidence(home), "{after}: doors or hands");
    let (kept, read) = (edges(home.graph()), edges(&rebuilt(home)));
    let (lost, left) = (apart(home.graph(), &read, &kept), apart(home.graph(), &kept, &read));
    assert!(lost.is_empty() && left.is_empty(), "{after}: not in the graph {lost:?}, only in the graph {left:?}");
}

/// Agents perform random legal actions; after each the graph is compared with one derived anew.
fn act_and_read_anew(seed: u64, actions: usize) {
    let (mut home, mut stream) = (home(seed, 2), Seed(seed).child("anew").stream());
    assert_as_rebuilt(&home, "made");
    for _ in 0..actions {
        let agent = *stream.pick(home.agents()).unwrap();
        let action = legal_action(home.graph(), agent, &mut stream);
        let words = action.describe(home.graph()).to_string();
        if home.set_action(agent, action).is_ok() {
            assert_as_rebuilt(&home, &words);
        }
    }
}

#[test]
fn graphs_are_as_read_anew_after_every_action() {
    act_and_read_anew(42, 50);
}

/// A thing in a hand carries nothing that it carried not before, however much of it brushes: neither the poster on
/// the wall nor the dress on the rail. So one can leave the room with it.
#[test]
fn things_in_hands_carry_nothing_new() {
    for (seed, classes) in [(0, vec!["hanger"]), (7, vec!["toy_car", "skipping_rope"])] {
        let fresh = home(seed, 1);
        let me = fresh.agents()[0];
        for id in classes.into_iter().flat_map(|class| fresh.graph().of_class(class)) {
            let mut home = fresh.clone();
            let hidden = home.graph().hidden_in(id);
            act(&mut home, me, Verb::Walk, &[hidden.unwrap_or(id)]);
            hidden.into_iter().for_each(|at| act(&mut home, me, Verb::Open, &[at]));
            act(&mut home, me, Verb::Walk, &[id]);
            let before = home.graph().carried_with(id);
            act(&mut home, me, Verb::Grab, &[id]);
            let label = home.graph().label(id);
            assert!(home.graph().carried_with(id).iter().all(|on| before.contains(on)), "{label}");
            let here = home.graph().room_of(me);
            let other = home.graph().rooms().iter().copied().find(|room| Some(*room) != here).unwrap();
            act(&mut home, me, Verb::Walk, &[other]);
            assert_as_rebuilt(&home, &label.to_string());
        }
    }
}

/// `FROM`, `HOMES` and `ACTIONS` choose how many; see `proofs/bodies`.
#[test]
#[ignore = "takes long"]
fn many_graphs_are_as_read_anew() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(usual);
    let from = number("FROM", 1);
    (from..from + number("HOMES", 10)).for_each(|seed| act_and_read_anew(seed, number("ACTIONS", 200) as usize));
}

/// An object that is opened keeps touching the objects beside it.
#[test]
fn what_opens_keeps_its_relations() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    for cabinet in home.graph().of_class("kitchen_wall_cabinet") {
        act(&mut home, me, Verb::Walk, &[cabinet]);
        act(&mut home, me, Verb::Open, &[cabinet]);
        assert_as_rebuilt(&home, "open");
        assert!(home.graph().related(cabinet, Relation::Touching).next().is_some());
    }
}

/// A fridge opens beside a dishwasher and cupboards that stand open: the agent finds the remaining space, and
/// makes way for the door.
#[test]
fn doors_swing_past_who_opens_them() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let first = |class: &str| home.graph().of_class(class)[0];
    let (kitchen, dishwasher, fridge) = (first("kitchen"), first("dishwasher"), first("fridge"));
    let cabinets = home.graph().of_class("kitchen_cabinet");
    act(&mut home, me, Verb::Walk, &[kitchen]);
    for id in std::iter::once(dishwasher).chain(cabinets) {
        act(&mut home, me, Verb::Walk, &[id]);
        act(&mut home, me, Verb::Open, &[id]);
        let mut copy = home.clone();
        let within: Vec<NodeId> = copy.graph().relating(Relation::Inside, fridge).collect();
        act(&mut copy, me, Verb::Walk, &[fridge]);
        act(&mut copy, me, Verb::Open, &[fridge]);
        assert!(copy.world().parts(fridge).openness() > Some(0.9));
        assert!(copy.graph().relating(Relation::Inside, fridge).eq(within));
        assert_eq!(copy.world().standing(me, &copy.world().pose(me).unwrap()).map(|there| there.is_free()), Ok(true));
    }
}

/// Furniture, appliances and bins of new homes open, each from the initial state.
fn assert_all_opens(seed: u64) -> usize {
    let fresh = home(seed, 1);
    let me = fresh.agents()[0];
    let (graph, world) = (fresh.graph(), fresh.world());
    let built = |id: NodeId| graph.places(id).all(|p| graph.node(p.at).is_some_and(Node::is_building));
    let opens = |n: &&Node| n.affords(Property::Openable) && n.is(State::Closed) && built(n.id());
    let small = |n: &Node| n.affords(Property::Graspable) && world.role(n.id()) == Some(BodyRole::Loose);
    let all: Vec<NodeId> = graph.nodes().filter(opens).filter(|n| !small(n)).map(Node::id).collect();
    for &id in &all {
        let mut home = fresh.clone();
        act(&mut home, me, Verb::Walk, &[id]);
        act(&mut home, me, Verb::Open, &[id]);
    }
    all.len()
}

#[test]
fn what_stands_in_fresh_homes_opens() {
    let seeds = amount(&[4][..], &[1, 4, 7]);
    let opened: usize = seeds.iter().copied().map(assert_all_opens).sum();
    assert!(opened > 15 * seeds.len(), "{opened}");
}

/// `FROM` and `HOMES` set the range; see `proofs/bodies`.
#[test]
#[ignore = "takes long"]
fn what_stands_in_many_fresh_homes_opens() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|s| s.parse().ok()).unwrap_or(usual);
    let from = number("FROM", 1);
    let opened: usize = (from..from + number("HOMES", 100)).map(assert_all_opens).sum();
    assert!(opened > 0);
}

/// After a reset to its start an environment equals the newly made one.
#[test]
fn a_reset_to_the_start_is_the_start() {
    let mut home = home(8, 2);
    let (made, start, me) = (home.digest(), home.start().clone(), home.agents()[0]);
    assert_eq!(start.validate(), []);
    home.reset(&start).unwrap();
    assert_eq!(home.digest(), made);
    let door = home.graph().of_class("door")[0];
    act(&mut home, me, Verb::Walk, &[door]);
    home.reset(&start).unwrap();
    assert_eq!(home.digest(), made);
}

/// Puts on the first wearable object that can be taken from its place.
fn put_something_on(home: &mut Environment, me: NodeId) -> Option<NodeId> {
    let wearable = |n: &&Node| n.affords(Property::Wearable) && n.affords(Property::Graspable);
    let all: Vec<NodeId> = home.graph().nodes().filter(wearable).map(Node::id).collect();
    all.into_iter().find(|&id| {
        let hidden = home.graph().hidden_in(id);
        let mut all = vec![Action::one(Verb::Walk, hidden.unwrap_or(id))];
        all.extend(hidden.map(|at| Action::one(Verb::Open, at)));
        all.extend([Action::one(Verb::Grab, id), Action::one(Verb::Wear, id)]);
        all.into_iter().all(|action| home.set_action(me, action).is_ok())
    })
}

/// Worn clothes are where their wearer is, in the relations too; and a restored copy continues alike.
#[test]
fn clothes_go_with_who_wears_them() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let worn = put_something_on(&mut home, me).unwrap();
    let here = home.graph().room_of(me).unwrap();
    let before: Vec<NodeId> = home.graph().related(worn, Relation::Near).collect();
    let other = home.graph().rooms().iter().copied().find(|r| *r != here).unwrap();
    act(&mut home, me, Verb::Walk, &[other]);
    assert_eq!(home.graph().room_of(worn), Some(other));
    let still = |id: &NodeId| *id != me && home.graph().has(Edge::new(worn, Relation::Near, *id));
    let in_old_room = |id: &NodeId| home.graph().room_of(*id) == Some(here);
    assert!(!before.is_empty() && !before.iter().any(|id| still(id) && in_old_room(id)));
    assert_as_rebuilt(&home, "walk away in clothes");
    let mut copy = home.restore(&home.save().unwrap()).unwrap();
    let mut stream = Seed(5).stream();
    for _ in 0..15 {
        let action = legal_action(home.graph(), me, &mut stream);
        assert_eq!(home.set_action(me, action), copy.set_action(me, action));
        assert_eq!(home.digest(), copy.digest());
    }
}

/// A room with generated furniture at given poses, and with agents.
fn room(furniture: &[(&str, Pose)], agents: usize) -> (Environment, Vec<NodeId>) {
    let mut scene = SceneBuilder::new("room");
    let bounds = Bounds::standing([8.0, 8.0, 2.5].into());
    let room = scene.add(Draft::new("living_room").bounds(bounds).at(Pose::identity())).unwrap();
    let slab = Bounds::standing([8.0, 8.0, 0.1].into());
    scene.add_in(room, Draft::new("floor").bounds(slab).at(Pose::translation(0.0, 0.0, -0.1))).unwrap();
    let put = |(class, pose): &(&str, Pose)| scene.add_in(room, Draft::new(*class).at(*pose)).unwrap();
    let ids = furniture.iter().map(put).collect();
    (Environment::from_scene(scene.build(), agents).unwrap(), ids)
}

/// Seats and beds hold as many agents as the class table says, and no more.
#[test]
fn seats_take_as_many_as_the_classes_say() {
    let furniture = [("sofa", Pose::translation(-2.0, -2.0, 0.0)), ("double_bed", Pose::translation(2.0, 2.0, 0.0))];
    let (mut home, ids) = room(&furniture, 4);
    let agents = home.agents().to_vec();
    for (at, verb, places) in [(ids[0], Verb::Sit, 3), (ids[1], Verb::Lie, 2)] {
        for &agent in &agents[..places] {
            act(&mut home, agent, Verb::Walk, &[at]);
            act(&mut home, agent, verb, &[at]);
        }
        let feet: Vec<Pose> = agents[..places].iter().map(|a| home.world().pose(*a).unwrap()).collect();
        let far = |a: &Pose, b: &Pose| (a.translation.vector - b.translation.vector).norm();
        assert!(feet.iter().enumerate().all(|(i, a)| feet[..i].iter().all(|b| far(a, b) > 0.35)), "{feet:?}");
        act(&mut home, agents[3], Verb::Walk, &[at]);
        let refused = home.set_action(agents[3], Action::one(verb, at));
        assert!(matches!(refused, Err(ActionError::Refused(_))), "{refused:?}");
        for &agent in &agents[..places] {
            act(&mut home, agent, Verb::Stand, &[]);
        }
    }
}

/// No agent is carried off on a chair, or sits on one that another carries.
#[test]
fn seats_stay_below_who_sits_on_them() {
    use virtualcity::physics::{AgentError, Hand};
    let (mut home, ids) = room(&[("stool", Pose::translation(1.0, 0.0, 0.0))], 2);
    let (sitter, other, stool) = (home.agents()[0], home.agents()[1], ids[0]);
    act(&mut home, other, Verb::Walk, &[stool]);
    act(&mut home, sitter, Verb::Walk, &[stool]);
    act(&mut home, sitter, Verb::Sit, &[stool]);
    let mut world = home.world().clone();
    let taken = world.grab(other, Hand::Right, stool);
    assert_eq!(taken, Err(AgentError::Occupied { seat: stool, by: sitter }));
    world.stand_up(sitter).unwrap();
    world.grab(other, Hand::Right, stool).unwrap();
    assert_eq!(world.sit(sitter, stool, None), Err(AgentError::Held(stool)));
}

/// The error about a door that does not open names the objects in its way.
#[test]
fn what_is_in_the_way_has_a_name() {
    let (mut home, ids) = room(&[("trash_can", Pose::translation(0.0, 0.0, 0.0))], 1);
    let (me, can) = (home.agents()[0], ids[0]);
    let mut graph = home.start().clone();
    let room = graph.rooms()[0];
    let high = graph.node(can).and_then(Node::aabb).unwrap().max.z;
    let mut edit = graph.edit();
    let slab = Bounds::standing([0.6, 0.6, 0.1].into());
    let shelf = Draft::new("wall").bounds(slab).at(Pose::translation(0.0, 0.0, high + 0.01));
    let shelf = edit.add(shelf).unwrap();
    edit.move_to_room(shelf, room).unwrap();
    edit.commit();
    home.reset(&graph).unwrap();
    act(&mut home, me, Verb::Walk, &[can]);
    let stuck = home.set_action(me, Action::one(Verb::Open, can)).unwrap_err();
    let ActionError::Impossible { why: PhysicalRefusal::Stuck { by, .. }, .. } = &stuck else { panic!("{stuck}") };
    assert_eq!(by.iter().map(|b| b.id).collect::<Vec<_>>(), [shelf]);
    assert!(stuck.to_string().ends_with(&format!("wall.{} is in the way", shelf.0)), "{stuck}");
}

/// The action `find` ends near the object, by the rule and by the bodies, even if it begins near it or behind a
/// wall.
#[test]
fn whatever_is_found_is_near() {
    let fresh = home(42, 1);
    let me = fresh.agents()[0];
    let things: Vec<NodeId> = fresh.graph().nodes().filter(|n| n.kind() == NodeKind::Object).map(Node::id).collect();
    let mut found = 0;
    for id in things.into_iter().step_by(amount(12, 4)) {
        let mut home = fresh.clone();
        match home.set_action(me, Action::one(Verb::Find, id)) {
            Ok(_) => {
                found += 1;
                assert!(home.graph().near(me, id));
            }
            Err(ActionError::Impossible { .. }) => {}
            Err(other) => panic!("{other}"),
        }
    }
    assert!(found > amount(30, 90), "{found}");
}

/// A seated agent draws a curtain within reach, and stays seated even if it cannot.
#[test]
fn curtains_are_drawn_from_seats() {
    let mut tried = 0;
    for seed in [5, 8, 42] {
        let fresh = home(seed, 1);
        let (me, graph) = (fresh.agents()[0], fresh.graph());
        let seats: Vec<NodeId> = graph.nodes().filter(|n| n.affords(Property::Sittable)).map(Node::id).collect();
        let open = |id: &NodeId| graph.node(*id).is_some_and(|n| n.is(State::Open));
        let covers = ["curtain", "blinds"].into_iter().flat_map(|class| graph.of_class(class)).filter(open);
        let near = |cover: NodeId, seat: &NodeId| graph.distance(*seat, cover).is_some_and(|d| d < 1.2);
        let pairs: Vec<(NodeId, NodeId)> =
            covers.flat_map(|c| seats.iter().filter(move |s| near(c, s)).map(move |s| (c, *s))).collect();
        for (cover, seat) in pairs {
            let mut home = fresh.clone();
            let seated = [Verb::Walk, Verb::Sit].map(|verb| home.set_action(me, Action::one(verb, seat)).is_ok());
            if seated != [true, true] || !home.graph().near(me, cover) {
                continue;
            }
            tried += 1;
            let drawn = home.set_action(me, Action::one(Verb::Close, cover));
            assert!(!matches!(drawn, Err(ActionError::Disagreement(_))), "{drawn:?}");
            assert!(matches!(home.posture(me), Some(Posture::Sitting(on, _)) if on == seat));
            let sits = Place { relation: Relation::SittingOn, at: seat };
            assert!(home.graph().places(me).any(|p| p == sits));
        }
    }
    assert!(tried > 0);
}

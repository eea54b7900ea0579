//! Fitting and reaching: bodies find space and get at objects as people do at home.

#![allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]

use std::sync::LazyLock;

use virtualcity::graph::{Action, NodeId, Place, Property, Relation, SceneGraph, Seed, Verb, Violation};
use virtualcity::initial::{at_home_that, feasible, generator};
use virtualcity::tasks::WorldError;
use virtualcity::tasks::library::Benchmark;
use virtualcity::{ActionError, Environment, NoRoom, PhysicalRefusal};

/// An environment of a benchmark task whose actions are all possible with bodies.
fn environment(task: &str) -> (Environment, NodeId) {
    environment_of(task, 0)
}

/// The same in another home.
fn environment_of(task: &str, seed: u64) -> (Environment, NodeId) {
    let benchmark = Benchmark::v1();
    let activity = benchmark.get(task).unwrap();
    let open = |home: SceneGraph| Environment::from_scene(home, 1).map_err(WorldError::failed);
    let made =
        at_home_that(activity, Seed(seed), &generator(), open, |home, initial| feasible(activity, home, initial));
    let made = made.unwrap();
    (made.world, made.initial.agent)
}

/// The first object of a class within the agent's reach.
fn first(home: &Environment, agent: NodeId, class: &str) -> NodeId {
    let all = home.graph().of_class(class);
    all.into_iter().find(|id| home.can_get_at(agent, *id)).unwrap()
}

fn act(home: &mut Environment, agent: NodeId, verb: Verb, things: &[NodeId]) {
    let action = Action::with(verb, things).unwrap();
    let done = home.set_action(agent, action);
    assert!(done.is_ok(), "{}: {}", action.describe(home.graph()), done.unwrap_err());
}

/// Two hanging shirts and a washing machine.
static LAUNDRY: LazyLock<(Environment, NodeId)> = LazyLock::new(|| environment("do_laundry-01"));

#[test]
fn laundry_is_folded_into_the_drum() {
    let (mut home, agent) = LAUNDRY.clone();
    let machine = first(&home, agent, "washing_machine");
    let shirts: Vec<NodeId> = home.graph().of_class("shirt");
    let shirts: Vec<NodeId> = shirts.into_iter().filter(|id| home.can_get_at(agent, *id)).take(2).collect();
    assert_eq!(shirts.len(), 2);
    for &shirt in &shirts {
        let mass = home.world().body(shirt).unwrap().mass();
        if let Some(around) = home.graph().hidden_in(shirt) {
            act(&mut home, agent, Verb::Walk, &[around]);
            act(&mut home, agent, Verb::Open, &[around]);
        }
        act(&mut home, agent, Verb::Walk, &[shirt]);
        act(&mut home, agent, Verb::Grab, &[shirt]);
        act(&mut home, agent, Verb::Walk, &[machine]);
        if home.graph().node(machine).unwrap().hides_contents() {
            act(&mut home, agent, Verb::Open, &[machine]);
        }
        let before = home.digest();
        act(&mut home, agent, Verb::PutIn, &[shirt, machine]);
        assert_ne!(home.digest(), before);
        assert!((home.world().body(shirt).unwrap().mass() - mass).abs() < 1e-4, "it weighs what it weighed");
    }
    let (graph, drum) = (home.graph(), home.world().aabb(machine).unwrap());
    for &shirt in &shirts {
        assert!(graph.places(shirt).any(|p| p == Place { relation: Relation::Inside, at: machine }));
        let (low, high) = home.world().aabb(shirt).map(|b| (b.min, b.max)).unwrap();
        assert!(drum.contains(&low) && drum.contains(&high), "{low} to {high} sticks out");
        // The graph has the present size, and the box is where the body is.
        let said = graph.node(shirt).unwrap().aabb().unwrap();
        assert!((said.max - high).norm() < 0.05 && (said.min - low).norm() < 0.05, "{said:?}");
    }
    // Observed objects can lie on nodes that are not surfaces by their class, such as shirts on shirts.
    let unsound = graph.validate().into_iter().filter(|v| !matches!(v, Violation::NotASurface(..)));
    assert_eq!(unsound.collect::<Vec<_>>(), []);
    // It is saved and restored unchanged, and a reset unfolds everything.
    let saved = home.save().unwrap();
    assert_eq!(home.restore(&saved).unwrap().digest(), home.digest());
    let before = LAUNDRY.0.graph().clone();
    home.reset(&before).unwrap();
    for &shirt in &shirts {
        let (now, then) = (home.graph().node(shirt).unwrap(), before.node(shirt).unwrap());
        assert_eq!(now.spec().scale, then.spec().scale);
        let size = |b: virtualcity::graph::Aabb| b.max - b.min;
        let (now, then) = (home.world().aabb(shirt).unwrap(), LAUNDRY.0.world().aabb(shirt).unwrap());
        assert!((size(now) - size(then)).norm() < 0.02);
    }
}

#[test]
fn there_is_room_for_laundry_and_not_for_the_wardrobe() {
    let (home, agent) = &*LAUNDRY;
    let machine = first(home, *agent, "washing_machine");
    let inside = |id: NodeId| (id, vec![Place { relation: Relation::Inside, at: machine }]);
    let shirts: Vec<_> = home.graph().of_class("shirt").into_iter().map(inside).collect();
    assert_eq!(home.has_room(*agent, &shirts), Ok(()));
    let wardrobe = home.graph().of_class("wardrobe")[0];
    assert_eq!(
        home.has_room(*agent, &[shirts[0].clone(), inside(wardrobe)]),
        Err(NoRoom(home.graph().label(wardrobe)))
    );
}

/// An agent can turn towards anything, and keeps facing it while it stands there.
#[test]
fn what_one_turns_to_one_faces() {
    let (mut home, agent) = environment("show_around-04");
    let shelf = first(&home, agent, "bookshelf");
    act(&mut home, agent, Verb::Walk, &[shelf]);
    act(&mut home, agent, Verb::TurnTo, &[shelf]);
    assert!(home.graph().facing(agent, shelf));
    act(&mut home, agent, Verb::LookAt, &[shelf]);
    act(&mut home, agent, Verb::PointAt, &[shelf]);
    assert!(home.graph().facing(agent, shelf));
    let other = first(&home, agent, "sofa");
    act(&mut home, agent, Verb::Walk, &[other]);
    act(&mut home, agent, Verb::TurnTo, &[other]);
    assert!(home.graph().facing(agent, other) && !home.graph().facing(agent, shelf));
}

/// Whoever has turned to a thing looks at it and points at it, wherever it is in the room.
#[test]
fn what_one_has_turned_to_one_looks_at() {
    for seed in [0, 42] {
        let mut home = super::home(seed, 1);
        let (agent, graph) = (home.agents()[0], home.graph().clone());
        let room = graph.room_of(agent).unwrap();
        let things = graph.in_room(room).filter(|id| graph.node(*id).unwrap().affords(Property::Surface));
        for thing in things {
            for verb in [Verb::TurnTo, Verb::LookAt, Verb::PointAt] {
                act(&mut home, agent, verb, &[thing]);
            }
        }
    }
}

/// An agent that walks up to a container can reach into it and is near its contents, wherever its door stands.
#[test]
fn open_doors_do_not_keep_one_away() {
    let (mut home, agent) = environment("put_dishwasher-04");
    let machine = first(&home, agent, "dishwasher");
    act(&mut home, agent, Verb::Walk, &[machine]);
    act(&mut home, agent, Verb::Open, &[machine]);
    for room in home.graph().rooms().to_vec() {
        act(&mut home, agent, Verb::Walk, &[room]);
        act(&mut home, agent, Verb::Walk, &[machine]);
        let distance = home.graph().distance(agent, machine).unwrap();
        assert!(distance < 1.5, "{distance} m");
    }
}

/// Drawers stay open with their contents, and are pushed shut in passing.
#[test]
fn nobody_is_trapped_behind_open_drawers() {
    let (mut home, agent) = environment("setup_table-02");
    let rooms = home.graph().rooms().to_vec();
    let classes = ["dresser", "nightstand", "bookshelf", "wardrobe"];
    let furniture: Vec<NodeId> = classes.iter().flat_map(|class| home.graph().of_class(class)).collect();
    let mut opened = 0;
    for id in furniture {
        let walk = Action::one(Verb::Walk, id);
        if home.set_action(agent, walk).is_ok() && home.set_action(agent, Action::one(Verb::Open, id)).is_ok() {
            opened += 1;
        }
        for &room in &rooms {
            act(&mut home, agent, Verb::Walk, &[room]);
        }
    }
    assert!(opened > 3, "{opened} opened");
}

/// A held object can be opened in the hand.
#[test]
fn a_book_opens_in_the_hand() {
    let (mut home, agent) = LAUNDRY.clone();
    let book = first(&home, agent, "novel");
    act(&mut home, agent, Verb::Walk, &[book]);
    act(&mut home, agent, Verb::Grab, &[book]);
    act(&mut home, agent, Verb::Open, &[book]);
    assert!(home.world().parts(book).openness() > Some(0.9));
    act(&mut home, agent, Verb::Close, &[book]);
    assert_eq!(home.world().parts(book).openness(), Some(0.0));
}

/// Fetches a thing out of what it is in, to another.
fn fetch(home: &mut Environment, agent: NodeId, id: NodeId, to: NodeId) {
    let hidden = home.graph().hidden_in(id);
    if let Some(around) = hidden {
        act(home, agent, Verb::Walk, &[around]);
        act(home, agent, Verb::Open, &[around]);
    } else {
        act(home, agent, Verb::Walk, &[id]);
    }
    act(home, agent, Verb::Grab, &[id]);
    act(home, agent, Verb::Walk, &[to]);
}

/// An oval table of eighty centimetres with a pie and apples in the middle: what is put at its far edge is put there
/// from where one does not stand in it, and four plates find room between the others.
#[test]
fn a_table_is_set_around_what_stands_on_it() {
    let (mut home, agent) = environment_of("setup_table-09", 1);
    let table = first(&home, agent, "dining_table");
    let before = home.graph().relating(Relation::On, table).count();
    assert!(before > 3);
    let plates: Vec<NodeId> = home.graph().of_class("plate");
    let plates: Vec<NodeId> = plates.into_iter().filter(|id| home.can_get_at(agent, *id)).collect();
    let size = |id: &NodeId| home.world().aabb(*id).map_or(0.0, |b| (b.max - b.min).norm());
    let mut largest = plates.clone();
    largest.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let largest: Vec<NodeId> = largest.into_iter().take(4).collect();
    for id in largest {
        fetch(&mut home, agent, id, table);
        act(&mut home, agent, Verb::Place, &[id, table]);
        assert!(home.graph().places(id).any(|p| p == Place { relation: Relation::On, at: table }));
    }
    assert_eq!(home.graph().relating(Relation::On, table).count(), before + 4);
    let (mut home, agent) = environment_of("setup_table-11", 1);
    let (table, bowl) = (first(&home, agent, "dining_table"), first(&home, agent, "salad_bowl"));
    for id in [first(&home, agent, "bowl"), bowl] {
        fetch(&mut home, agent, id, table);
        act(&mut home, agent, Verb::Place, &[id, table]);
    }
}

/// A pot that does not stay between the bowls and would roll off them: they are pushed together.
#[test]
fn a_pot_stands_in_the_dishwasher() {
    let (mut home, agent) = environment_of("put_dishwasher-09", 2);
    let (machine, pot) = (first(&home, agent, "dishwasher"), home.graph().of_class("pot"));
    let pot = pot.into_iter().rfind(|id| home.can_get_at(agent, *id)).unwrap();
    fetch(&mut home, agent, pot, machine);
    act(&mut home, agent, Verb::Open, &[machine]);
    act(&mut home, agent, Verb::PutIn, &[pot, machine]);
    assert!(home.graph().places(pot).any(|p| p == Place { relation: Relation::Inside, at: machine }));
    let mut later = home.world().clone();
    later.settle(120);
    let at = |world: &virtualcity::physics::PhysicsWorld| world.pose(pot).unwrap().translation.vector;
    assert!((at(home.world()) - at(&later)).norm() < 0.01, "it stays");
}

/// Pots and pans, most of them lidded, do not press each other out of shallow wall cabinets.
#[test]
fn full_wall_cabinets_shut_again() {
    let mut home = Environment::make("apartment/13", 1).unwrap();
    let (agent, pan) = (home.agents()[0], home.graph().of_class("saute_pan")[0]);
    let cabinet = home.graph().hidden_in(pan).unwrap();
    act(&mut home, agent, Verb::Walk, &[cabinet]);
    for verb in [Verb::Open, Verb::Close, Verb::Open, Verb::Close] {
        act(&mut home, agent, verb, &[cabinet]);
    }
}

/// A lamp whose shade reaches out of a shallow cabinet is not put in there, as its door could not shut; what is put in
/// lets it shut.
#[test]
fn what_is_put_in_lets_the_door_shut() {
    let home = Environment::make("apartment/106", 1).unwrap();
    let (agent, graph) = (home.agents()[0], home.graph());
    let (cabinet, lamps) = (graph.of_class("bathroom_cabinet")[0], graph.of_class("table_lamp"));
    let mut refused = 0;
    for lamp in lamps {
        let mut home = home.clone();
        fetch(&mut home, agent, lamp, cabinet);
        act(&mut home, agent, Verb::Open, &[cabinet]);
        match home.set_action(agent, Action::two(Verb::PutIn, lamp, cabinet)) {
            Ok(_) => act(&mut home, agent, Verb::Close, &[cabinet]),
            Err(ActionError::Impossible { why: PhysicalRefusal::KeepsOpen { .. }, .. }) => refused += 1,
            Err(ActionError::Impossible { why: PhysicalRefusal::NoSpot { .. }, .. }) => {}
            Err(other) => panic!("{other}"),
        }
    }
    assert!(refused > 0);
}

/// One side of the bed is out of reach: things are put on the other.
#[test]
fn things_are_put_where_hands_reach_on_a_bed() {
    let mut home = Environment::make("apartment/102", 1).unwrap();
    let (agent, bed) = (home.agents()[0], home.graph().of_class("double_bed")[0]);
    let novel = first(&home, agent, "novel");
    assert_eq!(home.has_room(agent, &[(novel, vec![Place { relation: Relation::On, at: bed }])]), Ok(()));
    fetch(&mut home, agent, novel, bed);
    act(&mut home, agent, Verb::Place, &[novel, bed]);
}

/// A pillow fills a corridor: one does not step into its dead end to put the pillow down between oneself and the home.
#[test]
fn nobody_shuts_oneself_in() {
    let mut home = Environment::make("apartment/106", 1).unwrap();
    let (agent, graph) = (home.agents()[0], home.graph());
    let narrow = |id: &NodeId| graph.node(*id).and_then(|n| n.aabb()).map_or(f32::INFINITY, |b| b.max.y - b.min.y);
    let floor = graph.of_class("floor").into_iter().min_by(|a, b| narrow(a).total_cmp(&narrow(b))).unwrap();
    let (pillow, bed) = (graph.of_class("pillow")[0], graph.of_class("double_bed")[0]);
    act(&mut home, agent, Verb::Walk, &[pillow]);
    act(&mut home, agent, Verb::Grab, &[pillow]);
    act(&mut home, agent, Verb::Walk, &[floor]);
    act(&mut home, agent, Verb::Place, &[pillow, floor]);
    act(&mut home, agent, Verb::Walk, &[bed]);
}

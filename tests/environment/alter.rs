//! Spawning and placing objects, and teleporting agents.

use virtualcity::graph::clock::{ProcessTable, Span};
use virtualcity::graph::{Action, ChangeSet, ClassTable, Edge, NodeId, Place, Pose, Relation, Seed, State, Verb};
use virtualcity::nalgebra::{Point2, Vector2};
use virtualcity::physics::{HandGoal, Posture};
use virtualcity::procgen::Apartment;
use virtualcity::relations::{RelationRule, Relations};
use virtualcity::{AlterError, Control, Environment, Spot, Steering};

use super::{act, home};

/// The relations equal those derived anew from the home.
pub(super) fn is_as_read(home: &Environment) {
    let read = Relations::new(home.graph(), RelationRule::Contacts, home.relations().evidence().clone()).unwrap();
    assert_eq!(home.relations().edges(), read.edges());
}

/// A spawned object behaves as if it had always been there: it stands, has relations, can be taken, saved and
/// restored.
/// Plates stand side by side: each is on the table and on no other plate.
#[test]
fn plates_stand_beside_each_other() {
    let mut home = home(42, 1);
    let table = home.graph().of_class("dining_table")[0];
    let on_table = Place { relation: Relation::On, at: table };
    let plates: Vec<NodeId> = (0..3).map_while(|_| home.spawn("plate", on_table).ok()).collect();
    assert!(plates.len() > 1);
    for &plate in &plates {
        assert!(home.graph().places(plate).eq([on_table]), "{:?}", home.graph().places(plate).collect::<Vec<_>>());
    }
}

/// Furniture that is put into a room keeps clear of the doors of what stands there.
#[test]
fn furniture_stands_before_no_door() {
    let (mut stood, mut opened) = (0, 0);
    for (seed, room) in [3, 9, 42].into_iter().flat_map(|seed| [(seed, "bedroom"), (seed, "kitchen")]) {
        let mut home = home(seed, 1);
        let room = home.graph().of_class(room)[0];
        let Ok(chair) = home.spawn("armchair", Place { relation: Relation::On, at: room }) else { continue };
        let mut world = home.world().clone();
        let pose = world.pose(chair).unwrap();
        // Some kitchens have no such spot.
        if !world.body(chair).unwrap().leaves_openings_free(&pose) {
            continue;
        }
        stood += 1;
        for id in world.nodes().into_iter().filter(|id| home.graph().room_of(*id) == Some(room)) {
            if id != chair && world.put_open(id, None, 1.0).is_ok() && !world.parts(id).all().is_empty() {
                opened += 1;
                let met = world.overlaps(chair, &pose).unwrap();
                assert!(!met.contains(&id), "{} opens into it", home.graph().label(id));
            }
        }
    }
    assert!(stood > 3 && opened > 10, "{stood} stand, {opened} open");
}

#[test]
fn things_appear_where_they_are_wanted() {
    let mut home = home(42, 1);
    let me = home.agents()[0];
    let first = |home: &Environment, class: &str| home.graph().of_class(class)[0];
    let (table, fridge, kitchen) = (first(&home, "coffee_table"), first(&home, "fridge"), first(&home, "kitchen"));
    let on = |at| Place { relation: Relation::On, at };
    let apple = home.spawn("apple", on(table)).unwrap();
    let milk = home.spawn("milk", Place { relation: Relation::Inside, at: fridge }).unwrap();
    let chair = home.spawn("chair", on(kitchen)).unwrap();
    assert!(home.graph().has(virtualcity::graph::Edge::new(apple, Relation::On, table)));
    assert_eq!((home.graph().hidden_in(milk), home.graph().room_of(milk)), (Some(fridge), Some(kitchen)));
    assert_eq!(home.graph().room_of(chair), Some(kitchen));
    is_as_read(&home);
    // The apple is put into a basket, and moves with the basket.
    let bedroom = first(&home, "bedroom");
    let basket = home.spawn("laundry_basket", on(kitchen)).unwrap();
    home.put(apple, Place { relation: Relation::Inside, at: basket }).unwrap();
    home.put(basket, on(bedroom)).unwrap();
    let where_it_is = (home.graph().place(apple).map(|p| p.at), home.graph().room_of(apple));
    assert_eq!(
        where_it_is,
        (Some(basket), Some(bedroom)),
        "{:?} {:?}",
        home.world().pose(apple),
        home.world().aabb(basket)
    );
    is_as_read(&home);
    let mut restored = home.restore(&home.save().unwrap()).unwrap();
    assert_eq!(restored.digest(), home.digest());
    for home in [&mut home, &mut restored] {
        act(home, me, Verb::Walk, &[apple]);
        act(home, me, Verb::Grab, &[apple]);
        assert!(home.graph().held(me).eq([apple]));
        assert_eq!(home.history().events().len(), 2);
    }
    assert_eq!(restored.digest(), home.digest());
    let start = home.start().clone();
    assert_eq!(home.reset(&start).unwrap().removed, []);
    assert!(home.graph().node(apple).is_none());
}

#[test]
fn what_cannot_appear_is_said_and_changes_nothing() {
    let mut home = home(42, 1);
    let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
    let sofa = home.graph().of_class("sofa")[0];
    let before = home.digest();
    let place = |relation, at| Place { relation, at };
    let spawned = [
        home.spawn("flooble", place(Relation::On, table)).unwrap_err(),
        home.spawn("apple", place(Relation::WornBy, me)).unwrap_err(),
        home.spawn("apple", place(Relation::On, NodeId(9_999_999))).unwrap_err(),
        home.spawn("double_bed", place(Relation::Inside, table)).unwrap_err(),
    ];
    assert!(spawned[0].to_string().starts_with("there is no class `flooble`: "), "{}", spawned[0]);
    let misspelt = home.spawn("aple", place(Relation::On, table)).unwrap_err();
    let AlterError::NoSuchClass { class, nearest } = &misspelt else { panic!("{misspelt:?}") };
    assert_eq!((class.as_str(), &nearest[..]), ("aple", &["apple".to_owned()][..]));
    assert!(misspelt.to_string().contains("(did you mean `apple`?)"), "{misspelt}");
    assert_eq!(spawned[1], AlterError::NotAPlace(Relation::WornBy));
    assert_eq!(spawned[2], AlterError::NoSuchNode(NodeId(9_999_999)));
    assert!(matches!(spawned[3], AlterError::Unplaced(_)), "{:?}", spawned[3]);
    // The error about a thing too large for a room gives its size.
    let bathroom = home.graph().of_class("bathroom")[0];
    let large = home.spawn("double_bed", place(Relation::InRoom, bathroom)).unwrap_err().to_string();
    assert!(large.contains("large enough for its ") && large.contains(" m"), "{large}");
    let wall = home.graph().of_class("wall")[0];
    assert!(matches!(home.put(wall, place(Relation::On, table)), Err(AlterError::NotLoose(_))));
    assert!(matches!(home.teleport(sofa, table), Err(AlterError::NotAnAgent(_))));
    let middle = home.graph().node(table).unwrap().position().unwrap();
    let refused = home.teleport(me, middle.xy()).unwrap_err();
    assert!(refused.to_string().contains("the free floor nearest to it is at"), "{refused}");
    assert_eq!(home.digest(), before);
}

/// A teleported agent stands at the new place, still holds its objects, and can act.
#[test]
fn agents_are_elsewhere_at_once() {
    let mut home = home(42, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let seen = home.room_observation(me);
    let novel = seen.nodes().find(|n| &**n.class() == "novel").unwrap().id();
    act(&mut home, me, Verb::Walk, &[novel]);
    act(&mut home, me, Verb::Grab, &[novel]);
    let sofa = home.graph().of_class("sofa")[0];
    act(&mut home, me, Verb::Walk, &[sofa]);
    act(&mut home, me, Verb::Sit, &[sofa]);
    for room in home.graph().rooms().to_vec() {
        match home.teleport(me, room) {
            Ok(()) => {}
            Err(AlterError::FullRoom(_)) => continue,
            Err(other) => panic!("{other}"),
        }
        assert_eq!(home.posture(me), Some(Posture::Standing));
        assert!(home.graph().related(me, Relation::SittingOn).next().is_none());
        assert_eq!((home.graph().room_of(me), home.graph().room_of(novel)), (Some(room), Some(room)));
        assert!(home.graph().held(me).eq([novel]));
        is_as_read(&home);
    }
    // An agent cannot stand where another stands.
    let taken = home.world().pose(other).unwrap().translation.vector.xy();
    assert!(home.teleport(me, Spot::At(taken.into())).is_err());
    let table = home.graph().of_class("coffee_table")[0];
    act(&mut home, me, Verb::Walk, &[table]);
    act(&mut home, me, Verb::Place, &[novel, table]);
}

/// A home whose floors are elsewhere than at zero height works as before.
#[test]
fn homes_stand_at_any_height() {
    for height in [-1.0, 3.0] {
        let mut graph = Apartment::from_seed(Seed(7)).unwrap().scene();
        let posed: Vec<(NodeId, Pose)> = graph.nodes().filter_map(|n| Some((n.id(), *n.pose()?))).collect();
        let mut edit = graph.edit();
        for (id, pose) in posed {
            edit.set_pose(id, Some(Pose::translation(0.0, 0.0, height) * pose)).unwrap();
        }
        edit.commit();
        let mut home = Environment::from_scene(graph, 1).unwrap();
        let me = home.agents()[0];
        assert!((home.world().pose(me).unwrap().translation.z - height).abs() < 0.02);
        for room in home.graph().rooms().to_vec() {
            act(&mut home, me, Verb::Walk, &[room]);
        }
    }
}

/// Another graph follows by the changes, whatever else is done between actions.
#[test]
fn changes_between_actions_are_told() {
    let mut home = home(27, 1);
    let (me, fridge) = (home.agents()[0], home.graph().first_of_class("fridge").unwrap());
    let table = home.graph().first_of_class("coffee_table").unwrap();
    let mut mirror = home.graph().clone();
    let mut follow = |home: &mut Environment| {
        for target in [table, fridge] {
            let changes = home.set_action(me, Action::walk(target)).unwrap();
            changes.apply(&mut mirror).unwrap();
            assert!(ChangeSet::between(&mirror, home.graph()).is_empty());
        }
    };
    follow(&mut home);
    home.switch_lamps(true).unwrap();
    follow(&mut home);
    home.teleport(me, home.graph().rooms()[1]).unwrap();
    follow(&mut home);
    let mug = home.spawn("mug", Place { relation: Relation::On, at: table }).unwrap();
    follow(&mut home);
    home.put(mug, Place { relation: Relation::InRoom, at: home.graph().rooms()[0] }).unwrap();
    follow(&mut home);
    for _ in 0..20 {
        home.steer(me, &Steering { velocity: Vector2::new(0.3, 0.2), ..Steering::default() }).unwrap();
    }
    follow(&mut home);
}

/// Whoever steers meanwhile takes nothing from the changes of an action that ends then.
#[test]
fn actions_that_end_while_somebody_steers_keep_their_changes() {
    let mut home = home(27, 2);
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().first_of_class("fridge").unwrap();
    act(&mut home, me, Verb::Walk, &[fridge]);
    home.give(me, Action::one(Verb::Open, fridge));
    while home.current_action(me).is_some() {
        home.steer(other, &Steering::default()).unwrap();
    }
    let endings = home.step(Span(0));
    let changes = endings[0].outcome.as_ref().unwrap();
    assert!(changes.nodes().any(|id| id == fridge), "{changes:?}");
}

/// Without bodies, only what is altered changes: others stay where the rule has brought them.
#[test]
fn without_bodies_others_stay_where_they_are() {
    let mut home = Environment::builder("apartment/27").agents(2).bodies(false).make().unwrap();
    let (me, other) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().first_of_class("fridge").unwrap();
    let table = home.graph().first_of_class("coffee_table").unwrap();
    let room = home.graph().room_of(table).unwrap();
    act(&mut home, me, Verb::Walk, &[fridge]);
    act(&mut home, me, Verb::Open, &[fridge]);
    let there: Vec<Edge> = home.graph().edges().filter(|edge| edge.from == me).collect();
    let apple = home.spawn("apple", Place { relation: Relation::On, at: table }).unwrap();
    home.put(apple, Place { relation: Relation::Inside, at: fridge }).unwrap();
    home.teleport(other, room).unwrap();
    let now: Vec<Edge> = home.graph().edges().filter(|edge| edge.from == me && edge.to != apple).collect();
    assert_eq!(now, there);
    assert_eq!((home.graph().room_of(other), home.graph().place(apple).map(|p| p.at)), (Some(room), Some(fridge)));
    act(&mut home, me, Verb::Grab, &[apple]);
    act(&mut home, me, Verb::Close, &[fridge]);
    act(&mut home, other, Verb::Walk, &[me]);
    assert!(home.steer(me, &Steering::default()).is_err(), "bodies do nothing here");
}

/// A refused call changes nothing, not even where hands are whose control has ended.
#[test]
fn refused_alterations_change_nothing() {
    let mut home = home(27, 1);
    let (me, table) = (home.agents()[0], home.graph().first_of_class("coffee_table").unwrap());
    let goal = HandGoal { pose: Pose::translation(0.4, -0.2, 1.2), ..HandGoal::default() };
    home.control(me, &Control { hands: [Some(goal), None], ..Control::default() }).unwrap();
    home.step(Span(60));
    home.interrupt(me);
    let (before, on) = (home.digest(), |at| Place { relation: Relation::On, at });
    home.spawn("flooble", on(table)).unwrap_err();
    home.spawn("mug", on(me)).unwrap_err();
    home.put(NodeId(9_999_999), on(table)).unwrap_err();
    home.put(table, on(table)).unwrap_err();
    home.teleport(me, Point2::new(-90.0, 0.0)).unwrap_err();
    assert_eq!(home.digest(), before);
}

/// Lamps that are switched at once burn down as others do.
#[test]
fn processes_heed_switched_lamps() {
    let table = "timer | ceiling_lamp | on | | | off | | | 10 s\n";
    let table = ProcessTable::parse("timer.txt", table, &ClassTable::builtin()).unwrap();
    let mut home = Environment::builder("apartment/27").processes(table).make().unwrap();
    home.step(Span(5));
    let lamps = home.switch_lamps(true).unwrap();
    home.step(Span::from_seconds(5.0));
    let timed: Vec<NodeId> = home.processes().map(|since| since.node).filter(|id| lamps.contains(id)).collect();
    assert!(!timed.is_empty());
    home.step(Span::from_seconds(6.0));
    assert!(timed.iter().all(|id| home.graph().node(*id).is_some_and(|node| node.is(State::Off))));
}

/// Agents whose pose a scene leaves open stand where the scene has them, as things do.
#[test]
fn agents_without_a_pose_are_put_into_their_rooms() {
    let mut home = home(27, 1);
    let (me, rooms) = (home.agents()[0], home.graph().rooms().to_vec());
    for room in rooms {
        let mut wanted = home.start().clone();
        let mut edit = wanted.edit();
        edit.move_to_room(me, room).unwrap();
        edit.set_pose(me, None).unwrap();
        edit.commit();
        let report = home.reset(&wanted).unwrap();
        assert!(home.world().pose(me).is_some(), "{report:?}");
        assert!(home.graph().room_of(me) == Some(room) || !report.elsewhere.is_empty(), "{report:?}");
    }
}

//! Spawning and placing objects, and teleporting agents.

use virtualcity::graph::{NodeId, Place, Pose, Relation, Seed, Verb};
use virtualcity::physics::Posture;
use virtualcity::procgen::Apartment;
use virtualcity::relations::{RelationRule, Relations};
use virtualcity::{AlterError, Environment, Spot};

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

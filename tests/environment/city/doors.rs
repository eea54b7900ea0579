//! Front doors as things of both their sides, and orders about what is elsewhere.

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::PortalKind;
use virtualcity::graph::{Action, NodeId, Refusal, Seed, State, Verb};
use virtualcity::nalgebra::Point3;
use virtualcity::procgen::{Building, BuildingStorey};
use virtualcity::{ActionError, City, CityError, GoalScope};

use super::{YARD, city, is_lift, landing};

/// Somebody on the gallery of a building, and the door of the neighbours there, who are in.
fn on_the_gallery() -> (City, BuildingStorey, NodeId) {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storey = building.storeys()[0].clone();
    let mut city = City::of(building).make().unwrap();
    let me = city.agents().next().unwrap();
    city.go(me, storey.gallery).unwrap();
    let door = city.space().portal(storey.front_doors[1]).unwrap().leaf.unwrap();
    (city, storey, door)
}

/// A shut front door is seen from the gallery, walked to, opened and shut there, and nobody goes in.
#[test]
fn a_front_door_is_a_thing_of_the_gallery() {
    let (mut city, storey, door) = on_the_gallery();
    let me = city.agents().next().unwrap();
    let home = storey.homes[1];
    for seen in [city.room_observation(me).unwrap(), city.observation(me, 20.0).unwrap()] {
        let found = seen.references().find(|(_, node)| node.id() == door).map(|(region, node)| (region, node.clone()));
        let (region, node) = found.expect("the door is seen");
        assert!(region == home && node.is(State::Closed));
        let inside = seen.references().filter(|(region, _)| *region == home).count();
        assert!(inside <= 2, "{inside} things of a home whose door is shut");
    }
    for verb in [Verb::Walk, Verb::Find] {
        assert!(city.legal_actions(me).unwrap().contains(&Action::one(verb, door)));
        city.set_action(me, Action::one(verb, door)).unwrap();
        assert_eq!(city.region_of(me), Some(storey.gallery), "{verb} ends before the door");
    }
    let there = city.environment_of(me).unwrap();
    let pose = there.world().pose(me).unwrap();
    let side = city.space().portal(storey.front_doors[1]).unwrap().side(storey.gallery).unwrap().pose;
    let at = pose.inverse() * side * Point3::origin();
    assert!(at.x > 0.0 && at.coords.norm() < 1.6, "it stands before the door and looks at it: {at}");
    assert!(city.legal_actions(me).unwrap().contains(&Action::one(Verb::Open, door)));
    let is = |city: &City, state| city.peek(home).unwrap().graph().node(door).unwrap().is(state);
    let changes = city.set_action(me, format!("open main_door.{}", door.0).parse().unwrap()).unwrap();
    assert!(changes.nodes().any(|id| id == door));
    assert!(is(&city, State::Open) && city.region_of(me) == Some(storey.gallery));
    let refused = city.set_action(me, Action::one(Verb::Open, door)).unwrap_err();
    assert!(
        matches!(&refused, CityError::Action(ActionError::Refused(why)) if matches!(why[..], [Refusal::NotInState(..)])),
        "{refused}"
    );
    assert!(city.legal_actions(me).unwrap().contains(&Action::one(Verb::Close, door)));
    let goal = "Open(main_door)".parse().unwrap();
    assert!(city.holds(&goal, me, GoalScope::Place(home)).unwrap());
    city.set_action(me, Action::one(Verb::Close, door)).unwrap();
    assert!(is(&city, State::Closed));
    // It is remembered, though all is as before, and restored.
    city.step(Span(120));
    let restored = City::of(Building::from_seed(Seed(7)).unwrap()).make().unwrap().restore(&city.save().unwrap());
    assert_eq!(restored.unwrap().digest(), city.digest());
}

/// Nobody opens a door from afar, or through the floor.
#[test]
fn a_front_door_is_opened_from_where_one_reaches_it() {
    let (mut city, storey, door) = on_the_gallery();
    let me = city.agents().next().unwrap();
    city.go(me, storey.homes[0]).unwrap();
    city.go(me, storey.gallery).unwrap();
    let refused = city.set_action(me, Action::one(Verb::Open, door)).unwrap_err();
    assert!(
        matches!(&refused, CityError::Action(ActionError::Refused(why)) if matches!(why[..], [Refusal::NotNear { .. }])),
        "{refused}"
    );
    assert!(!city.legal_actions(me).unwrap().contains(&Action::one(Verb::Open, door)));
}

/// A walk to a door from another storey ends before it as well.
#[test]
fn a_walk_to_a_front_door_ends_on_the_side_where_one_is() {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storeys = building.storeys().to_vec();
    let mut city = City::of(building).make().unwrap();
    let me = city.agents().next().unwrap();
    let door = city.space().portal(storeys[1].front_doors[0]).unwrap().leaf.unwrap();
    city.set_action(me, Action::walk(door)).unwrap();
    assert_eq!(city.region_of(me), Some(storeys[1].gallery));
    city.go(me, storeys[1].homes[0]).unwrap();
    city.set_action(me, Action::walk(door)).unwrap();
    assert_eq!(city.region_of(me), Some(storeys[1].homes[0]), "from within it is a door of the home");
}

/// Orders that cannot be carried out are refused before anybody sets out.
#[test]
fn wrong_orders_about_what_is_elsewhere_are_refused_at_once() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    let cup = city.peek(landing(2)).unwrap().graph().of_class("cup")[0];
    let before = city.digest();
    for wrong in [format!("walk fridge.{}", cup.0), format!("find cup.{}", cup.0 + 50), format!("run table.{}", cup.0)]
    {
        let error = city.set_action(me, wrong.parse().unwrap()).unwrap_err();
        let why = match &error {
            CityError::Action(ActionError::Refused(why)) => &why[0],
            other => panic!("{wrong}: {other}"),
        };
        assert!(matches!(why, Refusal::Misnamed(_) | Refusal::NoSuchThing(_)), "{wrong}: {why}");
        assert!(city.digest() == before && city.tick().0 == 0, "{wrong}");
    }
    city.set_ways(me, |plan| plan.kind == PortalKind::Passage && !is_lift(plan));
    assert!(matches!(city.send(me, landing(2)), Err(CityError::NoWay { .. })));
    assert!(matches!(city.give(me, Action::walk(cup)), Err(CityError::NoWay { .. })));
    assert_eq!((city.digest(), city.region_of(me)), (before, Some(YARD)));
    city.set_ways(me, |_| true);
    city.set_action(me, format!("walk cup.{}", cup.0).parse().unwrap()).unwrap();
    assert_eq!(city.region_of(me), Some(landing(2)));
}

/// A front door is touched and pushed from outside as from within; nothing moves by that.
#[test]
fn a_front_door_is_touched_from_the_gallery() {
    let (mut city, storey, door) = on_the_gallery();
    let me = city.agents().next().unwrap();
    city.set_action(me, Action::walk(door)).unwrap();
    let before = city.peek(storey.homes[1]).unwrap().graph().clone();
    for verb in [Verb::Touch, Verb::Push] {
        assert!(city.legal_actions(me).unwrap().contains(&Action::one(verb, door)), "{verb}");
        city.set_action(me, Action::one(verb, door)).unwrap();
        assert_eq!(city.region_of(me), Some(storey.gallery));
    }
    assert!(city.peek(storey.homes[1]).unwrap().graph() == &before);
}

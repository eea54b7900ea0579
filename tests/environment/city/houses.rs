//! Houses of a city's plan: from flats to the street and back, by stairs and by lift, with what one carries.

use virtualcity::City;
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{PortalKind, RegionId};
use virtualcity::graph::{Action, NodeId, Property, Relation};
use virtualcity::procgen::House;

fn house(agents: usize) -> (House, City) {
    let house = House::from_seed(virtualcity::graph::Seed(7)).unwrap();
    (house.clone(), City::of(house).agents(agents).make().unwrap())
}

/// Lets an agent take the lift only, or stairs only.
fn takes(city: &mut City, agent: NodeId, lift: bool) {
    city.set_ways(agent, move |plan| plan.kind != PortalKind::Landing || plan.stairs.is_empty() == lift);
}

fn until_idle(city: &mut City, span: Span) {
    let agents: Vec<NodeId> = city.agents().collect();
    for _ in 0..200_000 / span.0 {
        city.step(span);
        if !agents.iter().any(|agent| city.is_busy(*agent)) {
            return;
        }
    }
    panic!("still on their way");
}

/// Somebody takes a thing to the top by lift while another goes to the street by stairs, both from home; each thing stays held.
#[test]
fn a_house_is_walked_through_from_flats_to_the_street() {
    let (house, mut city) = house(2);
    let (top, street) = (house.storeys().last().unwrap().homes[0], house.street());
    let [one, other] = city.agents().collect::<Vec<NodeId>>()[..] else { panic!("two agents") };
    takes(&mut city, one, true);
    takes(&mut city, other, false);
    let thing = {
        let home = city.environment_of(one).unwrap().graph();
        let grasped = home.nodes().filter(|node| node.affords(Property::Graspable) && node.affords(Property::Eatable));
        let lies = |id: &NodeId| home.place(*id).is_some_and(|place| place.relation == Relation::On);
        grasped.map(virtualcity::graph::Node::id).find(lies).unwrap()
    };
    city.set_action(one, Action::walk(thing)).unwrap();
    city.set_action(one, Action::grab(thing)).unwrap();
    let mut twin = city.clone();
    for city in [&mut city, &mut twin] {
        city.send(one, top).unwrap();
        city.send(other, street).unwrap();
    }
    until_idle(&mut city, Span(600));
    until_idle(&mut twin, Span(600));
    let place = |city: &City, id: NodeId| city.region_of(id).unwrap();
    let (far, near): (RegionId, RegionId) = (place(&city, one), place(&city, other));
    assert_eq!((far, near, place(&city, thing)), (top, street, top));
    assert_eq!(city.digest(), twin.digest());
    assert_eq!(city.validate().unwrap(), []);
    // Half way home it is saved and restored.
    let home = house.storeys()[0].landing;
    city.send(one, home).unwrap();
    city.send(other, home).unwrap();
    city.step(Span(500));
    let saved = city.save().unwrap();
    let mut restored = city.restore(&saved).unwrap();
    for (agent, lift) in [(one, true), (other, false)] {
        takes(&mut restored, agent, lift);
    }
    until_idle(&mut city, Span(600));
    until_idle(&mut restored, Span(600));
    assert_eq!(city.digest(), restored.digest());
    assert_eq!([one, other].map(|agent| place(&city, agent)), [home; 2]);
    assert_eq!(city.validate().unwrap(), []);
}

/// Every flat of some houses can be reached from the street, by stairs and by lift.
#[test]
fn every_flat_is_reached_from_the_street() {
    let city = virtualcity::procgen::city::CitySpecification { area: 0.2, ..Default::default() };
    let plan = virtualcity::procgen::city::CityPlan::generate(&city, virtualcity::graph::Seed(3)).unwrap();
    let houses = (0..plan.buildings().len()).filter_map(|building| House::of(&plan, building).ok());
    for (number, house) in houses.step_by(vc_testkit::amount(40, 8) as usize).enumerate() {
        let street = house.street();
        let homes: Vec<RegionId> = house.storeys().iter().flat_map(|storey| storey.homes.clone()).collect();
        let mut city = City::of(house).make().unwrap();
        let me = city.agents().next().unwrap();
        takes(&mut city, me, number % 2 == 0);
        for home in homes.into_iter().step_by(3) {
            city.go(me, street).unwrap();
            city.go(me, home).unwrap_or_else(|why| panic!("house {number}: {why}"));
        }
        assert_eq!(city.validate().unwrap(), []);
    }
}

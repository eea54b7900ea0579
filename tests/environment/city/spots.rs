//! Where people stand and walk at portals: on free floor, in the right room, in no doorway, with a way out.

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{PortalId, PortalKind, RegionId};
use virtualcity::graph::{Action, NodeId, Seed, State, Verb};
use virtualcity::nalgebra::{Point2, Point3, distance};
use virtualcity::procgen::{Building, BuildingStorey};
use virtualcity::{ActionError, City, CityError, Interruption};

/// How far from a threshold walls are near, metres.
const IN_WALLS: f32 = 0.5;

fn building(seed: u64) -> (City, Vec<BuildingStorey>) {
    let building = Building::from_seed(Seed(seed)).unwrap();
    let storeys = building.storeys().to_vec();
    (City::of(building).agents(0).make().unwrap(), storeys)
}

fn feet(city: &City, agent: NodeId) -> Point2<f32> {
    city.environment_of(agent).unwrap().world().pose(agent).unwrap().translation.vector.xy().into()
}

/// Where somebody is, seen from a threshold of its region: metres out of the region, and to the left.
fn from_threshold(city: &City, agent: NodeId, portal: PortalId) -> Option<Point3<f32>> {
    let side = *city.space().portal(portal)?.side(city.region_of(agent)?)?;
    let at = feet(city, agent);
    Some(side.pose.inverse() * Point3::new(at.x, at.y, side.pose.translation.z))
}

/// Puts somebody on a side of a portal, so far behind its threshold.
fn walk_behind(city: &mut City, agent: NodeId, portal: PortalId, back: f32) {
    let side = *city.space().portal(portal).unwrap().side(city.region_of(agent).unwrap()).unwrap();
    let spot = side.pose * Point3::new(-back, 0.0, 0.0);
    city.set_action(agent, format!("walk at {:.2} {:.2}", spot.x, spot.y).parse().unwrap()).unwrap();
}

/// Whoever comes in by a front door goes over free floor to a place in the room of the door, and gets out again.
#[test]
fn who_comes_in_walks_over_free_floor_into_the_room_of_the_door() {
    for seed in [35, 38, 39] {
        let (mut city, storeys) = building(seed);
        let storey = &storeys[1];
        for (home, door) in storey.homes.iter().zip(&storey.front_doors) {
            for _ in 0..4 {
                let me = city.add_agent(storey.gallery).unwrap();
                city.send(me, *home).unwrap();
                while city.is_busy(me) {
                    assert!(city.step(Span(1)).iter().all(|ending| ending.outcome.is_ok()));
                    let off = from_threshold(&city, me, *door).map_or(f32::INFINITY, |at| at.xy().coords.norm());
                    let is_free = city.environment_of(me).unwrap().floor().is_free(feet(&city, me));
                    let inside = city.region_of(me) == Some(*home) && off > IN_WALLS;
                    assert!(!inside || is_free, "{seed} {home:?}: through something in tick {:?}", city.tick());
                }
                assert_eq!(city.region_of(me), Some(*home));
                let side = *city.space().portal(*door).unwrap().side(*home).unwrap();
                let before: Point2<f32> = (side.pose * Point3::new(-0.7, 0.0, 0.0)).xy();
                let way = city.environment(*home).unwrap().floor().route(feet(&city, me), before).expect("a way out");
                assert!(way.length < 2.0, "{seed} {home:?}: {} m of way", way.length);
            }
        }
    }
}

/// Many come and go by two front doors, a lift and stairs: those with nothing to do stand in no doorway, and no way ends
/// for want of floor, nor as somebody else has passed a portal.
#[test]
fn who_makes_way_steps_into_no_doorway() {
    for seed in [33, 35] {
        let (mut city, storeys) = building(seed);
        let (gallery, homes) = (storeys[1].gallery, storeys[1].homes);
        let within = [homes[0], homes[0], homes[1], homes[1], gallery, gallery];
        let mut agents: Vec<NodeId> = within.iter().map(|region| city.add_agent(*region).unwrap()).collect();
        for _ in 0..2 {
            let by_stairs = city.add_agent(storeys[0].gallery).unwrap();
            city.set_ways(by_stairs, |plan| plan.kind != PortalKind::Landing || plan.stairs.is_empty());
            agents.push(by_stairs);
        }
        let mut orders = 0;
        for round in 0..14 {
            for (at, agent) in agents.iter().enumerate().filter(|(at, _)| (round + at) % 2 == 0) {
                if city.is_busy(*agent) {
                    continue;
                }
                orders += 1;
                let to = [homes[0], homes[1], gallery, storeys[round % 3].gallery][(at + round * 3 + orders) % 4];
                city.send(*agent, to).unwrap();
            }
            for _ in 0..25 {
                for ending in city.step(Span(20)) {
                    assert!(ending.outcome.is_ok(), "{seed}: {}", ending.outcome.unwrap_err());
                }
                for agent in agents.iter().filter(|agent| !city.is_busy(**agent)) {
                    assert_eq!(doorway(&city, *agent), None, "{seed}: {agent} idle in tick {:?}", city.tick());
                }
            }
        }
    }
}

/// The doorway in which somebody stands.
fn doorway(city: &City, agent: NodeId) -> Option<PortalId> {
    let region: RegionId = city.region_of(agent)?;
    city.space().portals_of(region).find(|portal| {
        let plan = city.space().portal(*portal).unwrap();
        let is_in = |at: Point3<f32>| at.x.abs() < 0.3 && at.y.abs() < plan.width / 2.0;
        plan.stairs.is_empty() && from_threshold(city, agent, *portal).is_some_and(is_in)
    })
}

/// Two who walk to a door stand before it, in reach of it, not in it; one for whom there is no room within reach is told so.
#[test]
fn walks_to_a_front_door_end_before_it_within_reach() {
    let (mut city, storeys) = building(7);
    let storey = &storeys[0];
    let door = city.space().portal(storey.front_doors[1]).unwrap().leaf.unwrap();
    let agents: Vec<NodeId> = (0..6).map(|_| city.add_agent(storey.gallery).unwrap()).collect();
    let mut there = 0;
    for agent in &agents {
        match city.set_action(*agent, Action::walk(door)) {
            Ok(_) => {
                there += 1;
                let at = from_threshold(&city, *agent, storey.front_doors[1]).unwrap();
                assert!((0.4..1.5).contains(&at.xy().coords.norm()), "{at}");
                assert!(city.legal_actions(*agent).unwrap().contains(&Action::one(Verb::Open, door)));
            }
            Err(why) => assert!(matches!(why, CityError::NoFloor { .. }), "{why}"),
        }
    }
    assert!(there >= 2, "{there} have come to the door");
}

/// No front door is shut on somebody in its doorway, from either side, and none is opened through somebody.
#[test]
fn no_front_door_is_moved_through_somebody() {
    let (mut city, storeys) = building(7);
    let (storey, portal) = (&storeys[0], storeys[0].front_doors[1]);
    let (home, door) = (storey.homes[1], city.space().portal(portal).unwrap().leaf.unwrap());
    let (inside, outside) = (city.add_agent(home).unwrap(), city.add_agent(storey.gallery).unwrap());
    let is_open = |city: &City| city.environment(home).unwrap().graph().node(door).unwrap().is(State::Open);
    city.set_action(outside, Action::walk(door)).unwrap();
    // Whoever stands where the leaf swings makes way first.
    walk_behind(&mut city, inside, portal, 0.6);
    let stood = feet(&city, inside);
    city.set_action(outside, Action::one(Verb::Open, door)).unwrap();
    assert!(is_open(&city) && distance(&stood, &feet(&city, inside)) > 0.3);
    // One who is busy in the doorway does not.
    for (stands, shuts) in [(inside, outside), (outside, inside)] {
        let mut city = city.clone();
        city.set_action(shuts, Action::walk(door)).unwrap();
        walk_behind(&mut city, stands, portal, 0.2);
        for _ in 0..20 {
            city.give(stands, "dance".parse().unwrap()).unwrap();
            city.step(Span(1));
        }
        let is_busy = city.is_busy(stands);
        let shut = city.set_action(shuts, Action::one(Verb::Close, door));
        let refused = |why: &CityError| {
            matches!(why, CityError::Action(ActionError::Interrupted { why, .. })
                if matches!(**why, Interruption::InDoorway { .. }))
        };
        match shut {
            Ok(_) => assert!(!is_open(&city) && doorway(&city, stands).is_none(), "shut on {stands}"),
            Err(why) => assert!(is_open(&city) && refused(&why), "{is_busy} {why}"),
        }
    }
}

/// Agents begin where they get out, and one who is walled in is told so at once.
#[test]
fn who_begins_in_a_home_gets_out() {
    for seed in [977, 5031] {
        let building = Building::from_seed(Seed(seed)).unwrap();
        let storeys = building.storeys().to_vec();
        let mut city = City::of(building).agents(6).make().unwrap();
        for agent in city.agents().collect::<Vec<NodeId>>() {
            let home = city.region_of(agent).unwrap();
            let storey = storeys.iter().find(|storey| storey.homes.contains(&home)).unwrap();
            city.go(agent, storey.gallery).unwrap();
        }
    }
}

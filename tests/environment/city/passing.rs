//! Many at one portal: nobody walks through anybody, no lift shuts on anybody, and all arrive.

use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{PortalKind, RegionId};
use virtualcity::graph::{Action, NodeId, Seed, Verb};
use virtualcity::nalgebra::{Point3, Vector3, distance};
use virtualcity::procgen::Building;
use virtualcity::{City, LiftState};

use super::{CABIN, YARD, city, is_lift, landing};

/// The nearest that two come to each other where one squeezes past another one who moves, metres: bodies are as deep.
const NEAREST: f32 = 0.25;

fn feet(city: &City, agent: NodeId) -> Point3<f32> {
    city.environment_of(agent).unwrap().world().pose(agent).unwrap().translation.vector.into()
}

/// The least distance of two in the same region, metres.
fn nearest(city: &City) -> f32 {
    let agents: Vec<NodeId> = city.agents().collect();
    let pairs =
        agents.iter().enumerate().flat_map(|(at, one)| agents[at + 1..].iter().map(move |other| (*one, *other)));
    let together = pairs.filter(|(one, other)| city.region_of(*one) == city.region_of(*other));
    together.map(|(one, other)| distance(&feet(city, one), &feet(city, other))).fold(f32::INFINITY, f32::min)
}

/// How many stand between the doors of the lift, in the cabin or before it.
fn between_doors(city: &City) -> usize {
    let stops = city.space().portals().filter(|(_, plan)| is_lift(plan));
    let sides = stops.flat_map(|(_, plan)| plan.sides).collect::<Vec<_>>();
    let stands = |agent: &NodeId| {
        let here = city.region_of(*agent).unwrap();
        let at = feet(city, *agent);
        sides.iter().any(|side| side.region == here && distance(&at, &side.pose.translation.vector.into()) < 0.3)
    };
    city.agents().filter(stands).count()
}

fn crowd(agents: usize) -> City {
    let mut city = city(0);
    for _ in 0..agents {
        city.add_agent(YARD).unwrap();
    }
    city
}

/// More than the cabin takes: whoever has no room waits beside the door, and comes by the next ride.
#[test]
fn a_full_lift_leaves_others_for_the_next_ride() {
    let mut city = crowd(9);
    let agents: Vec<NodeId> = city.agents().collect();
    for agent in &agents {
        city.set_ways(*agent, |plan| plan.kind == PortalKind::Passage || is_lift(plan));
        city.send(*agent, landing(2)).unwrap();
    }
    let (mut rides, mut before, mut ended) = (0, city.lift(CABIN), Vec::new());
    for tick in 0..60 * 600 {
        ended.extend(city.step(Span(1)));
        let lift = city.lift(CABIN).unwrap();
        rides += usize::from(matches!(lift, LiftState::Moving { to: 2, .. }) && before != Some(lift));
        before = Some(lift);
        let is_shut = matches!(lift, LiftState::Shut(_) | LiftState::Moving { .. });
        assert!(!is_shut || between_doors(&city) == 0, "the doors are shut on somebody in tick {tick}");
        assert!(nearest(&city) > NEAREST, "{} in tick {tick}", nearest(&city));
        if ended.len() == agents.len() {
            break;
        }
    }
    let faults: Vec<String> = ended.iter().filter_map(|e| Some(e.outcome.as_ref().err()?.to_string())).collect();
    assert!(ended.len() == agents.len() && faults.is_empty(), "{} have ended: {faults:?}", ended.len());
    assert!(agents.iter().all(|agent| city.region_of(*agent) == Some(landing(2))));
    assert!(rides > 1, "all had room in one ride");
}

/// Those who want out of a cabin leave before others enter.
#[test]
fn those_in_a_cabin_leave_first() {
    let mut city = crowd(6);
    let agents: Vec<NodeId> = city.agents().collect();
    agents.iter().for_each(|agent| city.set_ways(*agent, |plan| plan.kind == PortalKind::Passage || is_lift(plan)));
    // Some come down while others want up.
    for agent in &agents[..3] {
        city.send(*agent, landing(2)).unwrap();
    }
    city.step_until_idle(Span::from_seconds(300.0));
    for (at, agent) in agents.iter().enumerate() {
        city.send(*agent, if at < 3 { landing(0) } else { landing(2) }).unwrap();
    }
    let mut ended = Vec::new();
    for tick in 0..60 * 300 {
        let there: Vec<bool> = agents.iter().map(|agent| city.region_of(*agent) == Some(CABIN)).collect();
        ended.extend(city.step(Span(1)));
        let enters = |at: usize| !there[at] && city.region_of(agents[at]) == Some(CABIN);
        let leaves = |at: usize| there[at] && at < 3 && matches!(city.lift(CABIN), Some(LiftState::Open(0)));
        assert!(!(3..6).any(enters) || !(0..3).any(leaves), "tick {tick}");
        assert!(nearest(&city) > NEAREST, "{} in tick {tick}", nearest(&city));
    }
    assert!(ended.len() == 6 && ended.iter().all(|e| e.outcome.is_ok()), "{ended:?}");
}

/// In a lift one looks at its door, not at its back wall.
#[test]
fn in_a_lift_one_turns_to_the_door() {
    let mut city = city(1);
    let me = city.agents().next().unwrap();
    city.go(me, CABIN).unwrap();
    let pose = city.environment_of(me).unwrap().world().pose(me).unwrap();
    let to_door = -pose.translation.vector.xy().normalize();
    let looks = (pose.rotation * Vector3::x()).xy();
    assert!(looks.dot(&to_door) > 0.99, "{looks}");
}

/// Whoever stands behind a front door with nothing to do makes way.
#[test]
fn who_stands_behind_a_front_door_makes_way() {
    let building = Building::from_seed(Seed(7)).unwrap();
    let storey = building.storeys()[0].clone();
    for back in [0.35, 0.5, 0.7, 1.0] {
        let mut city = City::of(Building::from_seed(Seed(7)).unwrap()).agents(2).make().unwrap();
        let agents: Vec<NodeId> = city.agents().collect();
        let home = storey.homes[0];
        let side = *city.space().portal(storey.front_doors[0]).unwrap().side(home).unwrap();
        let spot = side.pose * Point3::new(-back, 0.0, 0.0);
        let walk: Action = format!("walk at {:.2} {:.2}", spot.x, spot.y).parse().unwrap();
        if city.set_action(agents[0], walk).is_err() {
            continue;
        }
        city.send(agents[1], home).unwrap();
        let mut ended = Vec::new();
        while ended.is_empty() {
            ended = city.step(Span(1));
            assert!(nearest(&city) > NEAREST, "{} with one {back} m behind the door", nearest(&city));
            assert!(city.tick().0 < 60 * 300);
        }
        assert!(ended[0].outcome.is_ok(), "{:?}", ended[0].outcome);
        assert_eq!(city.region_of(agents[1]), Some(home));
    }
}

/// Two who go through a door in opposite directions go one after the other.
#[test]
fn two_who_meet_at_a_door_pass_one_after_the_other() {
    for later in [0, 60, 120, 180] {
        let mut city = city(2);
        let agents: Vec<NodeId> = city.agents().collect();
        let regions: Vec<RegionId> = agents.iter().map(|agent| city.region_of(*agent).unwrap()).collect();
        assert_eq!(regions, [YARD, landing(0)]);
        city.send(agents[0], regions[1]).unwrap();
        let mut ended = city.step(Span(later));
        city.send(agents[1], regions[0]).unwrap();
        for _ in 0..60 * 120 {
            ended.extend(city.step(Span(1)));
            assert!(nearest(&city) > NEAREST, "{}", nearest(&city));
        }
        assert!(ended.len() == 2 && ended.iter().all(|ending| ending.outcome.is_ok()), "{ended:?}");
        assert_eq!(agents.iter().map(|a| city.region_of(*a).unwrap()).collect::<Vec<_>>(), [regions[1], regions[0]]);
    }
}

/// All orders in which a crowd is told where to go in one tick lead to the same city.
#[test]
fn the_order_of_orders_makes_no_difference() {
    let seeds = if std::env::var_os("VC_WHOLE").is_some() { 300 } else { 12 };
    for seed in 0..seeds {
        let mut stream = Seed(seed).child("orders").stream();
        let start = crowd(9);
        let agents: Vec<NodeId> = start.agents().collect();
        let mut cities = [start.clone(), start];
        for round in 0..5 {
            let mut orders: Vec<(NodeId, Order)> = Vec::new();
            for agent in &agents {
                orders.extend((stream.below(3) > 0).then(|| (*agent, order(&mut stream))));
            }
            for (which, city) in cities.iter_mut().enumerate() {
                if which == 1 {
                    stream.shuffle(&mut orders);
                }
                for (agent, order) in &orders {
                    tell(city, *agent, order);
                }
                city.step(Span(100));
            }
            assert_eq!(cities[0].digest(), cities[1].digest(), "seed {seed}, round {round}");
        }
    }
}

enum Order {
    Go(RegionId),
    Do(&'static str),
    Table,
    Stop,
}

fn order(stream: &mut virtualcity::graph::Stream) -> Order {
    match stream.below(8) {
        0..4 => Order::Go([YARD, landing(0), landing(1), landing(2)][stream.below(4)]),
        4 => Order::Do("wave"),
        5 => Order::Do("dance"),
        6 => Order::Table,
        _ => Order::Stop,
    }
}

fn tell(city: &mut City, agent: NodeId, order: &Order) {
    match order {
        Order::Go(region) => _ = city.send(agent, *region),
        Order::Do(action) => _ = city.give(agent, action.parse().unwrap()),
        Order::Table => {
            let table = city.environment_of(agent).unwrap().graph().of_class("table").first().copied();
            table.into_iter().for_each(|table| _ = city.give(agent, Action::walk(table)));
        }
        Order::Stop => city.interrupt(agent),
    }
}

/// Nobody jumps from region to region: over a threshold, into a cabin and out of it one makes a step in a tick, as everywhere.
#[test]
fn nobody_jumps_between_regions() {
    let mut city = crowd(4);
    let agents: Vec<NodeId> = city.agents().collect();
    let at = |city: &City, agent: NodeId| {
        let (at, region) = (feet(city, agent), city.region_of(agent).unwrap());
        (region, city.frame(region).unwrap().point(&Point3::new(f64::from(at.x), f64::from(at.y), f64::from(at.z))))
    };
    let mut crossings = 0;
    for goal in [landing(2), YARD] {
        agents.iter().for_each(|agent| city.send(*agent, goal).unwrap());
        let mut before: Vec<_> = agents.iter().map(|agent| at(&city, *agent)).collect();
        for _ in 0..60 * 120 {
            city.step(Span(1));
            for (agent, before) in agents.iter().zip(&mut before) {
                let now = at(&city, *agent);
                let step = (now.1 - before.1).norm();
                assert!(now.0 == before.0 || step < 0.05, "{agent} comes {step} m in a tick, to {}", now.0);
                crossings += usize::from(now.0 != before.0);
                *before = now;
            }
        }
        assert!(agents.iter().all(|agent| city.region_of(*agent) == Some(goal)));
    }
    assert!(crossings >= 16, "{crossings}");
}

/// A walk that leads by lift pushes the buttons outside and within, as bodies do.
#[test]
fn a_walk_by_lift_pushes_its_buttons() {
    let building = Building::from_seed(Seed(7)).unwrap();
    let (storeys, cabin) = (building.storeys().to_vec(), building.cabin());
    let mut city = City::of(building).make().unwrap();
    let me = city.agents().next().unwrap();
    city.set_ways(me, |plan| plan.stairs.is_empty());
    city.go(me, storeys[2].gallery).unwrap();
    let pushed = |region: RegionId, button: NodeId| {
        let there = city.peek(region).unwrap();
        let pushes = there.history().events().iter().filter(|event| event.action == Action::one(Verb::Push, button));
        pushes.count()
    };
    assert_eq!(pushed(storeys[0].gallery, storeys[0].call_button), 1);
    assert_eq!(pushed(cabin, storeys[2].floor_button), 1);
}

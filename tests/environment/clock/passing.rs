//! Walkers who meet: at doorways, in corridors, and before those who stand.

use nalgebra::Point2;
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Aabb, Action, NodeId, Place, Relation, State, Verb};
use virtualcity::{Control, Environment, Interruption, Spot};

use super::{LONG, home, interruption, now, outcome};

/// The nearest that walkers come to each other, and to one who stands in a narrow place and does not leave, metres.
const TOUCHING: f32 = 0.38;
const SQUEEZED: f32 = 0.28;

fn feet(home: &Environment, agent: NodeId) -> Point2<f32> {
    home.world().pose(agent).unwrap().translation.vector.xy().into()
}

/// Doors between rooms, with the two.
fn doorways(home: &Environment) -> Vec<(NodeId, [NodeId; 2])> {
    let graph = home.graph();
    let rooms = |door: NodeId| <[NodeId; 2]>::try_from(graph.related(door, Relation::Between).collect::<Vec<_>>()).ok();
    graph.nodes().filter_map(|n| Some((n.id(), rooms(n.id())?))).collect()
}

/// Two agents in the rooms on both sides of a doorway.
fn beside(home: &Environment, rooms: [NodeId; 2]) -> Option<Environment> {
    let mut home = home.clone();
    let agents = home.agents().to_vec();
    let stands = |(agent, room): (&NodeId, NodeId)| home.teleport(*agent, Spot::Room(room)).is_ok();
    agents.iter().zip(rooms).all(stands).then_some(home)
}

/// The smallest distance between two agents while they walk.
fn nearest(home: &Environment, orders: &[(NodeId, Action)]) -> f32 {
    let (mut home, mut least) = (home.clone(), f32::INFINITY);
    let [a, b] = [home.agents()[0], home.agents()[1]];
    home.set_actions_in_time(orders, Span(3), |now| least = least.min((feet(now, a) - feet(now, b)).norm()));
    least
}

/// Two agents exchange rooms through one doorway; neither goes through the other, however time is divided.
#[test]
fn two_exchange_places_through_a_doorway() {
    let mut tried = 0;
    for seed in 0..20 {
        let home = home(seed, 2);
        let [a, b] = [home.agents()[0], home.agents()[1]];
        let found = doorways(&home).into_iter().find_map(|(_, rooms)| Some((beside(&home, rooms)?, rooms)));
        let Some((home, rooms)) = found else { continue };
        let orders = [now(a, Action::walk(rooms[1])), now(b, Action::walk(rooms[0]))];
        let (end, endings) = outcome(&home, &orders);
        assert!(endings.iter().all(|ending| ending.outcome.is_ok()), "home {seed}: {endings:?}");
        assert_eq!([a, b].map(|agent| end.graph().room_of(agent)), [Some(rooms[1]), Some(rooms[0])], "home {seed}");
        let least = nearest(&home, &orders.map(|(_, agent, action)| (agent, action)));
        assert!(least > SQUEEZED, "home {seed}: {least} m");
        tried += 1;
    }
    assert_eq!(tried, 20);
}

/// The points of the way of an agent into a room, while the other one is elsewhere.
fn way_into(home: &Environment, [agent, other]: [NodeId; 2], room: NodeId) -> Option<Vec<Point2<f32>>> {
    let (mut home, mut points) = (home.clone(), Vec::new());
    let away = home.graph().rooms().iter().copied().filter(|away| *away != room).collect::<Vec<_>>();
    away.into_iter().rev().find(|away| home.teleport(other, Spot::Room(*away)).is_ok())?;
    home.set_action_in_time(agent, Action::walk(room), Span(3), |now| points.push(feet(now, agent))).ok()?;
    Some(points)
}

/// Homes with two agents, of which the second stands on the way of the first into a room.
fn on_the_way(seeds: std::ops::Range<u64>) -> Vec<(u64, Environment, NodeId)> {
    let mut found = Vec::new();
    for seed in seeds {
        let home = home(seed, 2);
        let [a, b] = [home.agents()[0], home.agents()[1]];
        for (_, rooms) in doorways(&home).into_iter().take(2) {
            let Some(home) = beside(&home, rooms) else { continue };
            let Some(way) = way_into(&home, [a, b], rooms[1]) else { continue };
            for at in way.iter().skip(20).step_by(25) {
                let (mut home, far) = (home.clone(), |to: Point2<f32>| (at - to).norm());
                let between = far(feet(&home, a)) > 0.6 && far(way[way.len() - 1]) > 0.6;
                if between && home.teleport(b, Spot::At(*at)).is_ok() {
                    found.push((seed, home, rooms[1]));
                }
            }
        }
    }
    found
}

/// Whoever stands on the way of another with nothing to do is walked round, or makes way and is then where it was.
#[test]
fn those_who_stand_are_passed() {
    let (mut passed, mut wide, all) = (0, 0, on_the_way(0..vc_testkit::amount(6, 20) as u64));
    for (seed, home, room) in &all {
        let [a, b] = [home.agents()[0], home.agents()[1]];
        let (end, endings) = outcome(home, &[now(a, Action::walk(*room))]);
        match interruption(&endings[0]) {
            Some(Interruption::Blocked { by }) => assert_eq!(by.iter().map(|by| by.id).collect::<Vec<_>>(), [b]),
            _ => passed += usize::from(endings[0].outcome.is_ok()),
        }
        assert!((feet(&end, b) - feet(home, b)).norm() < 2e-3, "home {seed}");
        let least = nearest(home, &[(a, Action::walk(*room))]);
        assert!(least > SQUEEZED, "home {seed}: {least} m, {endings:?}");
        wide += usize::from(least > TOUCHING);
    }
    let all = all.len();
    assert!(passed * 10 >= all * 9 && wide * 2 > all, "{passed} of {all} were passed, {wide} of them not narrowly");
}

/// Whoever is under control makes no way: it is walked round where there is room, else the walker is told who blocks it,
/// and goes on if the other one leaves.
#[test]
fn those_under_control_block() {
    let (mut passed, mut blocked, mut went_on) = (0, 0, 0);
    for (seed, mut home, room) in on_the_way(0..vc_testkit::amount(6, 20) as u64) {
        let [a, b] = [home.agents()[0], home.agents()[1]];
        home.control(b, &Control::default()).unwrap();
        let walk = now(a, Action::walk(room));
        let begin = home.tick();
        let mut stands = home.clone();
        stands.give(a, walk.2);
        let endings = stands.step_until_idle(LONG);
        let Some(why) = interruption(&endings[0]) else {
            passed += usize::from(endings[0].outcome.is_ok());
            continue;
        };
        let Interruption::Blocked { by } = why else { panic!("home {seed}: {why}") };
        assert_eq!(by.iter().map(|by| by.id).collect::<Vec<_>>(), [b]);
        assert!(endings[0].tick - begin >= Span(600) && stands.graph().room_of(a) != Some(room), "home {seed}");
        blocked += 1;
        home.give(a, walk.2);
        home.step(Span(200));
        home.interrupt(b);
        home.step(Span(1));
        let endings = home.step_until_idle(LONG);
        went_on += usize::from(endings.iter().any(|ending| ending.agent == a && ending.outcome.is_ok()));
    }
    assert!(passed > 0 && blocked > 0 && went_on > 0, "{passed} passed, {blocked} blocked, {went_on} went on");
}

/// A door that somebody passes is shut again, and its leaf and the graph agree whenever nobody is under way; what others
/// do meanwhile neither pushes it nor leaves it open.
#[test]
fn passed_doors_agree_with_the_graph() {
    let mut passed = 0;
    for seed in 0..vc_testkit::amount(4, 20) {
        let home = home(seed, 2);
        let [a, b] = [home.agents()[0], home.agents()[1]];
        let shut = |home: &Environment, door: NodeId| home.graph().node(door).unwrap().is(State::Closed);
        let found = doorways(&home).into_iter().find_map(|(door, rooms)| {
            let third = home.graph().rooms().iter().copied().find(|room| !rooms.contains(room))?;
            let mut there = beside(&home, [rooms[0], third])?;
            if !shut(&there, door) {
                there.set_action(a, Action::walk(door)).ok()?;
                there.set_action(a, Action::close(door)).ok()?;
                there.set_action(a, Action::walk(rooms[0])).ok()?;
            }
            Some((there, door, rooms))
        });
        let Some((mut home, door, rooms)) = found else { continue };
        home.give(a, Action::walk(rooms[1]));
        let mut widest: f32 = 0.0;
        while home.current_action(a).is_some() {
            if home.current_action(b).is_none() {
                home.give(b, "wave".parse().unwrap());
            }
            let endings = home.step(Span(1));
            assert!(endings.iter().all(|ending| ending.outcome.is_ok()), "home {seed}: {endings:?}");
            widest = widest.max(home.world().parts(door).openness().unwrap());
            assert!(shut(&home, door), "home {seed}");
        }
        home.step_until_idle(LONG);
        assert_eq!(home.graph().room_of(a), Some(rooms[1]), "home {seed}");
        let is = home.world().parts(door).openness().unwrap();
        assert!(is < 0.01 && home.world().parts(door).state() == Some(State::Closed), "home {seed}: {is}");
        passed += usize::from(widest > 0.5);
    }
    assert!(passed > 0, "no door was seen open in the world");
}

/// A door that is pushed open presses nobody into anybody.
#[test]
fn a_door_presses_nobody() {
    let mut home = home(30043, 2);
    let (a, b) = (home.agents()[0], home.agents()[1]);
    home.give(a, Action::open(home.graph().of_class("dishwasher")[0]));
    let cabinet = home.graph().of_class("kitchen_cabinet").into_iter().find(|id| id.0 == 38).unwrap();
    home.give(b, Action::walk(cabinet));
    while home.is_busy() {
        home.step(Span(6));
        let now = home.moment();
        assert!((feet(&now, a) - feet(&now, b)).norm() > 0.4, "{:?}", home.tick());
    }
    home.step(Span(300));
    assert!((feet(&home, a) - feet(&home, b)).norm() > 0.4);
}

/// The contents of a dishwasher that stands open in a narrow kitchen stay in it, whoever passes, and it shuts again.
#[test]
fn what_stands_open_keeps_its_contents() {
    let mut open = home(48_558, 2);
    let (a, b) = (open.agents()[0], open.agents()[1]);
    let dishwasher = open.graph().first_of_class("dishwasher").unwrap();
    let contents: Vec<NodeId> = open.graph().relating(Relation::Inside, dishwasher).collect();
    assert!(contents.len() > 5);
    open.set_action(a, Action::walk(dishwasher)).unwrap();
    open.set_action(a, Action::open(dishwasher)).unwrap();
    let cabinets = open.graph().of_class("kitchen_cabinet");
    for cabinet in cabinets.iter().take(3) {
        let mut home = open.clone();
        for (agent, goal) in [(b, *cabinet), (b, cabinets[0]), (b, *cabinet), (a, cabinets[3]), (a, dishwasher)] {
            home.give(agent, Action::walk(goal));
            home.step_until_idle(LONG);
        }
        let closed = home.set_action(a, Action::close(dishwasher));
        assert!(closed.is_ok(), "{:?}", closed.err());
        let machine = home.world().aabb(dishwasher).unwrap();
        for thing in &contents {
            assert!(home.graph().relating(Relation::Inside, dishwasher).any(|id| id == *thing));
            let at = home.world().aabb(*thing).unwrap().centre();
            assert!(machine.gap(&Aabb { min: at, max: at }) < 0.01, "{} is at {at}", home.graph().label(*thing));
        }
    }
}

/// Two who put things into one machine at once find room beside each other.
#[test]
fn two_put_things_into_one_machine() {
    for seed in [271_126, 20_261_127, 48_558] {
        let mut home = home(seed, 2);
        let (a, b) = (home.agents()[0], home.agents()[1]);
        let machine = ["dishwasher", "fridge"].iter().find_map(|class| home.graph().first_of_class(class)).unwrap();
        let table =
            ["dining_table", "coffee_table", "desk"].iter().find_map(|c| home.graph().first_of_class(c)).unwrap();
        let on_table = Place { relation: Relation::On, at: table };
        let (plate, mug) = (home.spawn("dessert_plate", on_table).unwrap(), home.spawn("mug", on_table).unwrap());
        let mut together = |actions: [Action; 2]| {
            for outcome in home.set_actions(&[(a, actions[0]), (b, actions[1])]) {
                assert!(outcome.is_ok(), "home {seed}: {}", outcome.unwrap_err());
            }
        };
        together([Action::walk(plate), Action::walk(mug)]);
        together([Action::grab(plate), Action::grab(mug)]);
        together([Action::walk(machine), Action::walk(machine)]);
        together([Action::open(machine), "wave".parse().unwrap()]);
        together([Action::two(Verb::PutIn, plate, machine), Action::two(Verb::PutIn, mug, machine)]);
        together(["wave".parse().unwrap(), Action::walk(table)]);
        together([Action::close(machine), "wave".parse().unwrap()]);
        assert_eq!([plate, mug].map(|id| home.graph().place(id).map(|p| p.at)), [Some(machine); 2]);
    }
}

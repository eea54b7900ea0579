//! Walkers who meet doors, and what others do meanwhile.

use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, Relation, State};
use virtualcity::{Environment, Spot};

use super::{LONG, home};

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

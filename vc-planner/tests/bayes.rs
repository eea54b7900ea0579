//! In small homes the agent needs hardly more steps than the best possible policy,
//! found by brute force over all it could know.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use std::collections::HashMap;

use vc_graph::{Draft, NodeId, Place, Property, PropertySet, Relation, SceneBuilder, SceneGraph, Simulator};
use vc_planner::{Belief, Newcomer, Prior, Run};
use vc_tasks::{Outcome, Task};

/// Three rooms, eight places (the rooms' floors among them), two things.
const ROOMS: [&str; 3] = ["kitchen", "living_room", "bedroom"];
/// Class, room, whether it is a container.
const FURNITURE: [(&str, usize, bool); 5] = [
    ("kitchen_table", 0, false),
    ("coffer", 0, true),
    ("strongbox", 0, true),
    ("coffee_table", 1, false),
    ("casket", 2, true),
];
const PLACES: usize = 8;
/// The table, where the things are to go.
const TABLE: usize = 3;

fn room_of(place: usize) -> usize {
    if place < 3 { place } else { FURNITURE[place - 3].1 }
}

fn is_box(place: usize) -> bool {
    place >= 3 && FURNITURE[place - 3].2
}

/// Where a thing is, as far as is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Known {
    Unknown,
    At(usize),
    Held,
    Done,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct State {
    room: usize,
    /// The piece of furniture at hand, if any, or the thing on the floor.
    at: Option<usize>,
    seen: u8,
    things: [Known; 2],
}

/// The expected number of steps of the best policy.
fn value(s: State, memo: &mut HashMap<State, f64>) -> f64 {
    if s.things == [Known::Done; 2] {
        return 0.0;
    }
    if let Some(&known) = memo.get(&s) {
        return known;
    }
    let mut best = f64::INFINITY;
    let held = s.things.iter().filter(|t| **t == Known::Held).count();
    let walk = |at: usize| if s.at == Some(at) { 0.0 } else { 1.0 };
    for room in (0..3).filter(|&r| r != s.room) {
        let next = State { room, at: None, ..s };
        if unseen(&next) != 0 {
            best = best.min(1.0 + looked(next, unseen(&next), memo));
        }
    }
    // A room is as well entered by walking up to something in it.
    for place in (3..PLACES).filter(|&p| room_of(p) != s.room) {
        let next = State { room: room_of(place), at: Some(place), ..s };
        if unseen(&next) != 0 {
            best = best.min(1.0 + looked(next, unseen(&next), memo));
        }
    }
    for place in (0..PLACES).filter(|&p| is_box(p) && s.seen >> p & 1 == 0 && held < 2) {
        let next = State { room: room_of(place), at: Some(place), ..s };
        let new = unseen(&next) | 1 << place;
        best = best.min(walk(place) + 1.0 + looked(next, new, memo));
    }
    for i in 0..2 {
        match s.things[i] {
            Known::At(place) if held < 2 => {
                // On the floor it is itself what one walks up to.
                let spot = if place < 3 { PLACES + i } else { place };
                let mut next = State { room: room_of(place), at: Some(spot), ..s };
                next.things[i] = Known::Held;
                let new = unseen(&next);
                best = best.min(walk(spot) + 1.0 + looked(next, new, memo));
            }
            Known::Held => {
                let mut next = State { room: 0, at: Some(TABLE), ..s };
                next.things[i] = Known::Done;
                let new = unseen(&next);
                best = best.min(walk(TABLE) + 1.0 + looked(next, new, memo));
            }
            _ => {}
        }
    }
    memo.insert(s, best);
    best
}

/// What is in view in the room and has not been seen.
fn unseen(s: &State) -> u8 {
    (0..PLACES).filter(|&p| room_of(p) == s.room && !is_box(p)).fold(0, |bits, p| bits | 1 << p) & !s.seen
}

/// The expectation over what is found in places that are seen now.
fn looked(s: State, new: u8, memo: &mut HashMap<State, f64>) -> f64 {
    if new == 0 {
        return value(s, memo);
    }
    let open = (PLACES as u32 - s.seen.count_ones()) as f64;
    let mut total = 0.0;
    let outcomes = |thing: Known| -> Vec<(Known, f64)> {
        if thing != Known::Unknown {
            return vec![(thing, 1.0)];
        }
        let found = (0..PLACES).filter(|p| new >> p & 1 == 1);
        let found = found.map(|p| (if p == TABLE { Known::Done } else { Known::At(p) }, 1.0 / open));
        let rest = (Known::Unknown, 1.0 - f64::from(new.count_ones()) / open);
        found.chain([rest]).filter(|(_, p)| *p > 1e-12).collect()
    };
    for (a, p) in outcomes(s.things[0]) {
        for (b, q) in outcomes(s.things[1]) {
            total += p * q * value(State { seen: s.seen | new, things: [a, b], ..s }, memo);
        }
    }
    total
}

struct Home {
    scene: SceneGraph,
    places: Vec<Place>,
}

fn home(a: usize, b: usize) -> Home {
    let mut scene = SceneBuilder::new("small");
    let rooms: Vec<NodeId> = ROOMS.iter().map(|r| scene.add(Draft::new(*r)).unwrap()).collect();
    let mut places: Vec<Place> = rooms.iter().map(|&at| Place { relation: Relation::InRoom, at }).collect();
    for (class, room, container) in FURNITURE {
        let relation = if container { Relation::Inside } else { Relation::On };
        // The class table's containers are surfaces as well: these are none.
        let properties = container.then(|| PropertySet::of(&[Property::Container, Property::Openable]));
        let mut draft = Draft { properties, ..Draft::new(class) };
        if container {
            draft = draft.state(vc_graph::State::Closed);
        }
        places.push(Place { relation, at: scene.add_in(rooms[room], draft).unwrap() });
    }
    for (class, place) in [("apple", a), ("book", b)] {
        match places[place] {
            Place { relation: Relation::On, at } => scene.add_on(at, Draft::new(class)),
            Place { at, .. } => scene.add_in(at, Draft::new(class)),
        }
        .unwrap();
    }
    scene.add_in(rooms[1], Draft::new("character")).unwrap();
    Home { scene: scene.build(), places }
}

#[test]
fn hardly_more_steps_than_the_best_policy() {
    let first = home(0, 0);
    let belief = Belief::of_newcomer(&first.scene, first.scene.agents()[0], 0);
    let mut believed: Vec<Place> = belief.possible_places().collect();
    believed.sort_unstable();
    let mut real = first.places.clone();
    real.sort_unstable();
    assert_eq!(believed, real, "the model has other places than the belief");

    let start = State { room: 1, at: None, seen: 0, things: [Known::Unknown; 2] };
    let best = looked(start, unseen(&start), &mut HashMap::new());
    let task = Task::new("both", "On(apple, kitchen_table) & On(book, kitchen_table)".parse().unwrap());
    let mut steps = 0;
    for a in 0..PLACES {
        for b in 0..PLACES {
            let mut policy = Newcomer::best().supposing(Prior::Uniform);
            let mut world = Simulator::new(home(a, b).scene);
            let episode = Run::seeded(1).episode(&mut policy, &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome, Outcome::Won, "{a} {b}: {episode:?}");
            steps += episode.steps;
        }
    }
    let mean = steps as f64 / (PLACES * PLACES) as f64;
    assert!(mean >= best - 1e-9, "{mean} is below the best possible {best}");
    println!("{mean:.3} steps on average, the best possible {best:.3}: {:.3}", mean / best);
    assert!(mean <= 1.05 * best, "{mean} steps on average, the best possible {best}");
}

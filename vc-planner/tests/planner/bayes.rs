//! In small homes the agent needs hardly more steps than the optimal policy, which is found by brute force over
//! all belief states.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests may unwrap, and print counts")]

use std::collections::HashMap;

use vc_graph::{Draft, NodeId, Place, Property, PropertySet, Relation, SceneBuilder, SceneGraph, Simulator};
use vc_planner::{Belief, EpisodeOptions, PlannerPolicy, Prior};
use vc_tasks::{Outcome, Task};

/// Three rooms, eight places (including the rooms' floors), two things.
const ROOMS: [&str; 3] = ["kitchen", "living_room", "bedroom"];
const PLACES: usize = 8;
const THINGS: [&str; 2] = ["apple", "book"];

struct Layout {
    name: &'static str,
    /// Class, room, and whether it is a container: the places after the floors.
    furniture: [(&'static str, usize, bool); 5],
    /// The room in which the agent begins.
    start: usize,
    /// The target of each thing.
    targets: [usize; 2],
}

const LAYOUTS: [Layout; 6] = [
    Layout {
        name: "both to a table",
        furniture: [
            ("kitchen_table", 0, false),
            ("coffer", 0, true),
            ("strongbox", 0, true),
            ("coffee_table", 1, false),
            ("casket", 2, true),
        ],
        start: 1,
        targets: [3, 3],
    },
    Layout {
        name: "to tables in two rooms",
        furniture: [
            ("kitchen_table", 0, false),
            ("coffer", 0, true),
            ("coffee_table", 1, false),
            ("casket", 1, true),
            ("strongbox", 2, true),
        ],
        start: 2,
        targets: [3, 5],
    },
    Layout {
        name: "a box for both",
        furniture: [
            ("kitchen_table", 0, false),
            ("coffer", 0, true),
            ("coffee_table", 1, false),
            ("desk", 2, false),
            ("casket", 2, true),
        ],
        start: 1,
        targets: [4, 4],
    },
    Layout {
        name: "a box for one, a table for the other",
        furniture: [
            ("kitchen_table", 0, false),
            ("coffer", 0, true),
            ("coffee_table", 1, false),
            ("strongbox", 2, true),
            ("casket", 2, true),
        ],
        start: 0,
        targets: [7, 3],
    },
    Layout {
        name: "boxes in every room",
        furniture: [
            ("desk", 2, false),
            ("coffer", 0, true),
            ("casket", 1, true),
            ("strongbox", 2, true),
            ("kitchen_table", 0, false),
        ],
        start: 0,
        targets: [3, 7],
    },
    Layout {
        name: "two boxes side by side",
        furniture: [
            ("coffer", 2, true),
            ("casket", 2, true),
            ("desk", 2, false),
            ("strongbox", 0, true),
            ("kitchen_table", 0, false),
        ],
        start: 1,
        targets: [3, 4],
    },
];

impl Layout {
    fn room_of(&self, place: usize) -> usize {
        if place < ROOMS.len() { place } else { self.furniture[place - ROOMS.len()].1 }
    }

    fn is_box(&self, place: usize) -> bool {
        place >= ROOMS.len() && self.furniture[place - ROOMS.len()].2
    }

    fn goal(&self) -> String {
        let part = |i: usize| {
            let (class, _, container) = self.furniture[self.targets[i] - ROOMS.len()];
            format!("{}({}, {class})", if container { "Inside" } else { "On" }, THINGS[i])
        };
        format!("{} & {}", part(0), part(1))
    }
}

/// The known state of a thing.
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

type Memo = HashMap<State, f64>;

impl Layout {
    /// The expected number of steps of the optimal policy.
    fn value(&self, s: State, memo: &mut Memo) -> f64 {
        if s.things == [Known::Done; 2] {
            return 0.0;
        }
        if let Some(&known) = memo.get(&s) {
            return known;
        }
        let mut best = f64::INFINITY;
        let held = s.things.iter().filter(|t| **t == Known::Held).count();
        let walk = |at: usize| if s.at == Some(at) { 0.0 } else { 1.0 };
        // A room can also be entered by walking up to something in it.
        let into = (0..ROOMS.len()).map(|room| (room, None));
        let up_to = (ROOMS.len()..PLACES).map(|p| (self.room_of(p), Some(p)));
        for (room, at) in into.chain(up_to).filter(|(room, _)| *room != s.room) {
            let next = State { room, at, ..s };
            if self.unseen(&next) != 0 {
                best = best.min(1.0 + self.looked(next, self.unseen(&next), memo));
            }
        }
        for place in (0..PLACES).filter(|&p| self.is_box(p) && s.seen >> p & 1 == 0) {
            let next = State { room: self.room_of(place), at: Some(place), ..s };
            let new = self.unseen(&next) | 1 << place;
            // With both hands full, a thing is put down first and taken up afterwards.
            let free = if held == 2 { 2.0 } else { 0.0 };
            best = best.min(walk(place) + 1.0 + free + self.looked(next, new, memo));
        }
        for i in 0..2 {
            match s.things[i] {
                Known::At(place) if held < 2 => {
                    // A thing on the floor is walked up to individually.
                    let spot = if place < ROOMS.len() { PLACES + i } else { place };
                    let mut next = State { room: self.room_of(place), at: Some(spot), ..s };
                    next.things[i] = Known::Held;
                    best = best.min(walk(spot) + 1.0 + self.looked(next, self.unseen(&next), memo));
                }
                Known::Held => {
                    let target = self.targets[i];
                    if self.is_box(target) && s.seen >> target & 1 == 0 {
                        continue;
                    }
                    let mut next = State { room: self.room_of(target), at: Some(target), ..s };
                    next.things[i] = Known::Done;
                    best = best.min(walk(target) + 1.0 + self.looked(next, self.unseen(&next), memo));
                }
                _ => {}
            }
        }
        memo.insert(s, best);
        best
    }

    /// The places in view in the room that have not been seen.
    fn unseen(&self, s: &State) -> u8 {
        let in_view = (0..PLACES).filter(|&p| self.room_of(p) == s.room && !self.is_box(p));
        in_view.fold(0, |bits, p| bits | 1 << p) & !s.seen
    }

    /// The expectation over the things found in newly seen places.
    fn looked(&self, s: State, new: u8, memo: &mut Memo) -> f64 {
        if new == 0 {
            return self.value(s, memo);
        }
        let open = (PLACES as u32 - s.seen.count_ones()) as f64;
        let outcomes = |i: usize| -> Vec<(Known, f64)> {
            if s.things[i] != Known::Unknown {
                return vec![(s.things[i], 1.0)];
            }
            let found = (0..PLACES).filter(|p| new >> p & 1 == 1);
            let found = found.map(|p| (if p == self.targets[i] { Known::Done } else { Known::At(p) }, 1.0 / open));
            let rest = (Known::Unknown, 1.0 - f64::from(new.count_ones()) / open);
            found.chain([rest]).filter(|(_, p)| *p > 1e-12).collect()
        };
        let mut total = 0.0;
        for (a, p) in outcomes(0) {
            for (b, q) in outcomes(1) {
                total += p * q * self.value(State { seen: s.seen | new, things: [a, b], ..s }, memo);
            }
        }
        total
    }

    /// The expected number of steps of the optimal policy from the start.
    fn best(&self) -> f64 {
        let start = State { room: self.start, at: None, seen: 0, things: [Known::Unknown; 2] };
        self.looked(start, self.unseen(&start), &mut Memo::new())
    }
}

struct Home {
    scene: SceneGraph,
    places: Vec<Place>,
}

fn home(layout: &Layout, at: [usize; 2]) -> Home {
    let mut scene = SceneBuilder::new("small");
    let rooms: Vec<NodeId> = ROOMS.iter().map(|r| scene.add(Draft::new(*r)).unwrap()).collect();
    let mut places: Vec<Place> = rooms.iter().map(|&at| Place { relation: Relation::InRoom, at }).collect();
    for (class, room, container) in layout.furniture {
        let relation = if container { Relation::Inside } else { Relation::On };
        // The class table's containers are surfaces as well; these are not.
        let properties = container.then(|| PropertySet::from_words(&[Property::Container, Property::Openable]));
        let mut draft = Draft { properties, ..Draft::new(class) };
        if container {
            draft = draft.state(vc_graph::State::Closed);
        }
        places.push(Place { relation, at: scene.add_in(rooms[room], draft).unwrap() });
    }
    for (class, place) in THINGS.into_iter().zip(at) {
        match places[place] {
            Place { relation: Relation::On, at } => scene.add_on(at, Draft::new(class)),
            Place { at, .. } => scene.add_in(at, Draft::new(class)),
        }
        .unwrap();
    }
    scene.add_in(rooms[layout.start], Draft::new("character")).unwrap();
    Home { scene: scene.build(), places }
}

/// The mean number of steps over all possible homes.
fn mean_steps(layout: &Layout) -> f64 {
    let task = Task::new(layout.name, layout.goal().parse().unwrap());
    let mut steps = 0;
    for a in 0..PLACES {
        for b in 0..PLACES {
            let mut policy = PlannerPolicy::best().with_prior(Prior::Uniform);
            let mut world = Simulator::new(home(layout, [a, b]).scene);
            let episode = EpisodeOptions::seeded(1).episode(&mut policy, &task, &mut world, &mut |_| {});
            assert_eq!(episode.outcome, Outcome::Won, "{}: {a} {b}: {episode:?}", layout.name);
            steps += episode.steps;
        }
    }
    steps as f64 / (PLACES * PLACES) as f64
}

#[test]
fn hardly_more_steps_than_the_best_policy() {
    for layout in &LAYOUTS {
        let first = home(layout, [0, 0]);
        let belief = Belief::in_known_home(&first.scene, first.scene.agents()[0], 0);
        let mut believed: Vec<Place> = belief.possible_places().collect();
        believed.sort_unstable();
        let mut real = first.places.clone();
        real.sort_unstable();
        assert_eq!(believed, real, "{}: the model has other places than the belief", layout.name);
        let (mean, best, name) = (mean_steps(layout), layout.best(), layout.name);
        println!("{name}: {mean:.3} steps on average, the best possible {best:.3}: {:.3}", mean / best);
        assert!(mean >= best - 1e-9, "{name}: {mean} is below the best possible {best}");
        assert!(mean <= 1.05 * best, "{name}: {mean} steps on average, the best possible {best}");
    }
}

//! Small random homes, and goals in them.

#![allow(dead_code, clippy::unwrap_used, reason = "each test file uses a part, and tests may unwrap")]

use vc_graph::{Draft, NodeId, SceneBuilder, SceneGraph, Seed};

const ROOMS: [&str; 4] = ["kitchen", "living_room", "bedroom", "bathroom"];
const SURFACES: [&str; 6] = ["kitchen_table", "kitchen_counter", "coffee_table", "desk", "nightstand", "dresser"];
const BOXES: [&str; 5] = ["fridge", "kitchen_cabinet", "microwave", "bathroom_cabinet", "closet"];
/// There are two of each item.
pub(crate) const ITEMS: [&str; 8] = ["apple", "book", "mug", "plate", "milk", "cellphone", "towel", "fork"];

/// A random home: some furniture, some of it closed, two of each item anywhere.
pub(crate) fn home(seed: u64) -> SceneGraph {
    let mut stream = Seed(seed).child("home").stream();
    let mut scene = SceneBuilder::new("home");
    let rooms: Vec<NodeId> = ROOMS.iter().map(|r| scene.add(Draft::new(*r)).unwrap()).collect();
    let mut places = Vec::new();
    for class in SURFACES.iter().chain(&SURFACES) {
        places.push((scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(*class)).unwrap(), false));
    }
    for class in BOXES.iter().chain(&BOXES) {
        places.push((scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(*class)).unwrap(), true));
    }
    for class in ITEMS.iter().chain(&ITEMS) {
        let (at, inside) = *stream.pick(&places).unwrap();
        if inside { scene.add_in(at, Draft::new(*class)) } else { scene.add_on(at, Draft::new(*class)) }.unwrap();
    }
    scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new("character")).unwrap();
    scene.build()
}

/// Goals of many kinds that are reachable in these homes.
pub(crate) const GOALS: &[&str] = &[
    "On(apple, kitchen_table)",
    "On(apple, kitchen_table), 2 & Inside(milk, fridge) & Closed(fridge)",
    "On(mug, coffee_table) & On(book, coffee_table) & On(plate, coffee_table)",
    "Inside(plate, kitchen_cabinet), 2 & Inside(mug, kitchen_cabinet), 2",
    "Holds(book) & Holds(cellphone)",
    "Holds(book) & Read(book)",
    "Eat(apple) & Closed(fridge)",
    "On(towel, nightstand) | On(unicorn, nightstand)",
    "forall ?f: fork. On(?f, kitchen_table)",
    "Inside(towel, bathroom), 2",
    "!On(mug, coffee_table) & On(fork, desk)",
    "at least 2 ?i: apple. On(?i, desk)",
    "Wash(apple) then Eat(apple)",
    "exists ?t: table. (On(plate, ?t) & On(fork, ?t))",
];

//! Random homes of any size, and goals in them.

use vc_graph::{Draft, NodeId, SceneBuilder, SceneGraph, Seed};

const ITEMS: [&str; 12] =
    ["plate", "fork", "mug", "apple", "book", "milk", "towel", "cellphone", "bowl", "knife", "banana", "pillow"];
const SURFACES: [&str; 6] = ["kitchen_table", "kitchen_counter", "coffee_table", "desk", "nightstand", "dresser"];
const BOXES: [&str; 4] = ["fridge", "kitchen_cabinet", "bathroom_cabinet", "closet"];

/// A home with five rooms and a number of objects: a tenth of them are surfaces and containers, the rest are
/// things in and on these.
pub(crate) fn home(objects: usize, seed: u64) -> SceneGraph {
    let mut stream = Seed(seed).stream();
    let mut scene = SceneBuilder::new("home");
    let rooms = ["kitchen", "living_room", "bedroom", "bathroom", "hallway"];
    let rooms: Vec<NodeId> = rooms.iter().map(|r| scene.add(Draft::new(*r)).unwrap()).collect();
    let places: Vec<(NodeId, bool)> = (0..objects / 10)
        .map(|i| {
            let (class, inside) = match i % 5 {
                0 | 1 => (BOXES[(i / 5 * 2 + i % 5) % BOXES.len()], true),
                _ => (SURFACES[(i / 5 * 3 + i % 5 - 2) % SURFACES.len()], false),
            };
            (scene.add_in(*stream.pick(&rooms).unwrap(), Draft::new(class)).unwrap(), inside)
        })
        .collect();
    scene.add_in(rooms[1], Draft::new("sofa")).unwrap();
    scene.add_in(rooms[1], Draft::new("television")).unwrap();
    for i in places.len()..objects {
        let (at, inside) = *stream.pick(&places).unwrap();
        let draft = Draft::new(ITEMS[i % ITEMS.len()]);
        if inside { scene.add_in(at, draft) } else { scene.add_on(at, draft) }.unwrap();
    }
    scene.add_in(rooms[0], Draft::new("character")).unwrap();
    scene.build()
}

/// A goal that asks for a number of single things to be at places, named as in household tasks.
pub(crate) fn errands(scene: &SceneGraph, parts: usize, seed: u64) -> Vec<String> {
    let mut stream = Seed(seed).child("goal").stream();
    let targets = [("On", "kitchen_table"), ("On", "coffee_table"), ("Inside", "fridge"), ("Inside", "closet")];
    let mut used = Vec::new();
    let mut text = Vec::new();
    while text.len() < parts {
        let class = *stream.pick(&ITEMS).unwrap();
        let item = *stream.pick(&scene.of_class(class)).unwrap();
        let (relation, target) = *stream.pick(&targets).unwrap();
        let at = scene.of_class(target)[0];
        if !used.contains(&item) && !scene.rests_at(item, at) {
            used.push(item);
            text.push(format!("{relation}({}, {})", scene.label(item), scene.label(at)));
        }
    }
    text
}

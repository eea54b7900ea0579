//! What pictures of generated homes cost: the living room, kitchen, bath and bedroom of four homes, in four
//! sizes, all lamps on, as `cargo bench -p vc-render --bench render` does for a home that is made for it. Run with
//! `cargo bench --bench pictures`.

#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, reason = "benches stop where something is wrong")]

#[path = "../vc-render/benches/support/stage.rs"]
mod stage;
#[path = "../examples/support/mod.rs"]
#[allow(dead_code, unused_imports, unused_macros, reason = "only its error is of use here")]
mod support;
#[path = "../examples/render/viewpoint.rs"]
mod viewpoint;

use stage::{Stage, table};
use virtualcity::graph::Seed;
use virtualcity::procgen::Apartment;

fn main() {
    for seed in [1, 2, 3, 42] {
        let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let lamp = |class: &str| ["lamp", "light", "chandelier"].iter().any(|word| class.contains(word));
        let lamps = scene.nodes().filter(|node| lamp(node.class()) && node.pose().is_some());
        let lamps: Vec<_> = lamps.map(virtualcity::graph::Node::id).collect();
        let stage = Stage::new(&scene, &lamps);
        let rooms = ["livingroom", "kitchen", "bathroom", "bedroom"];
        let best = |room| viewpoint::best(&stage.renderer, &stage.snapshot, &scene, room, (64, 64)).ok();
        let poses: Vec<_> = rooms.into_iter().filter_map(best).map(|camera| camera.pose).collect();
        table(&format!("home {seed}"), &stage, &poses);
    }
}

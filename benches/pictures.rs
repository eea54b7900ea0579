//! Costs of pictures of generated homes: the living room, kitchen, bath and bedroom of four homes, in four
//! sizes, with all lamps on. `cargo bench -p vc-render --bench render` does the same for a home built for that
//! purpose. Run with `cargo bench --bench pictures`.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches stop where something is wrong")]

#[path = "../vc-render/benches/support/stage.rs"]
mod stage;

use stage::{HEAD, Stage, rows};
use vc_testkit::page::Page;
use virtualcity::graph::Seed;
use virtualcity::procgen::Apartment;
use virtualcity::render::{Camera, Renderer};

fn main() {
    let (mut page, mut costs) = (Page::new("pictures"), Vec::new());
    for seed in [1, 2, 3, 42] {
        let scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
        let lamps: Vec<_> = Renderer::new().snapshot(&scene).unwrap().lamps().collect();
        let stage = Stage::new(&scene, &lamps);
        let rooms = ["livingroom", "kitchen", "bathroom", "bedroom"];
        let camera = Camera::with_fov(64, 64, 1.15);
        let best = |class| stage.renderer.viewpoint(&stage.snapshot, *scene.of_class(class).first()?, &camera).ok();
        let poses: Vec<_> = rooms.into_iter().filter_map(best).map(|camera| camera.pose).collect();
        costs.extend(rows(&format!("home {seed}"), &stage, &poses));
    }
    page.table(&HEAD, &costs);
    page.finish();
}

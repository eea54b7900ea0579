//! A stock of your own: the objects that a task needs and a home lacks come from it.
//!
//! `cargo run --release --example own_stock`

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use support::{Complaint, say};
use vc_graph::class::Class;
use vc_graph::{AssetLibrary, Bounds, Draft, SceneGraph, Seed, Simulator};
use vc_tasks::initial::{InitialGenerator, PlainStock, Stock};
use vc_tasks::library::Benchmark;
use virtualcity::procgen::Apartment;

/// Boxes that differ from seed to seed by a tenth, as a shop's do; other classes come from the scene.
struct Varied;

impl Stock for Varied {
    fn thing(&self, class: &Class, seed: Seed, scene: &SceneGraph, assets: &mut AssetLibrary) -> Option<Draft> {
        let Some(size) = class.typical_size() else { return PlainStock.thing(class, seed, scene, assets) };
        let scale = 0.95 + 0.1 * seed.stream().unit();
        Some(Draft::new(class.name.clone()).bounds(Bounds::standing(size * scale)))
    }
}

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let home = Apartment::from_seed(Seed(9))?.scene();
    let benchmark = Benchmark::v1();
    let activity = benchmark.get("put_fridge-02").ok_or_else(|| Complaint::new("the benchmark has no such task"))?;
    for seed in 0..3 {
        let initial =
            InitialGenerator::new(&Varied).make(activity, &home, Seed(seed), &mut Simulator::new(home.clone()))?;
        for added in &initial.added {
            let Some(bounds) = initial.scene.node(added.id).and_then(|n| n.aabb()) else { continue };
            let size = bounds.max - bounds.min;
            say!("seed {seed}: {}, {:.2} m x {:.2} m x {:.2} m", initial.scene.label(added.id), size.x, size.y, size.z);
        }
    }
    Ok(())
}

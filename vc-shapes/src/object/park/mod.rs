//! Objects of gardens and parks: trees, bushes, beds, rocks, benches.

mod bed;
pub(super) mod bench;
mod shrub;
mod tree;

use super::{Generator, outdoor};

pub(super) const GENERATORS: &[Generator] = &[
    outdoor("tree", 500, tree::tree),
    outdoor("oak_tree", 250, tree::oak),
    outdoor("birch_tree", 200, tree::birch),
    outdoor("fruit_tree", 200, tree::fruit),
    outdoor("pine_tree", 250, tree::pine),
    outdoor("palm_tree", 150, tree::palm),
    outdoor("bush", 300, shrub::bush),
    outdoor("rose_bush", 100, shrub::rose_bush),
    outdoor("hedge", 200, shrub::hedge),
    outdoor("rock", 300, shrub::rock),
    outdoor("tree_stump", 60, shrub::stump),
    outdoor("flower_bed", 150, bed::flower_bed),
    outdoor("vegetable_patch", 60, bed::vegetable_patch),
    outdoor("lawn", 30, bed::lawn),
    outdoor("sunflower", 40, bed::sunflower),
    outdoor("stepping_stone", 60, bed::stepping_stone),
    outdoor("park_bench", 150, bench::bench),
];

//! Seats: chairs, stools, benches and sofas.

mod chair;
mod folding;
mod sofa;
mod stool;
mod swivel;

use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("sofa", 22, sofa::sofa),
    indoor("loveseat", 8, sofa::sofa),
    indoor("corner_sofa", 8, sofa::corner_sofa),
    indoor("sofa_bed", 5, sofa::sofa_bed),
    indoor("chaise_longue", 5, sofa::chaise_longue),
    indoor("armchair", 20, sofa::armchair),
    indoor("recliner", 6, sofa::recliner),
    indoor("chair", 18, chair::chair),
    indoor("dining_chair", 18, chair::chair),
    indoor("kitchen_chair", 10, chair::chair),
    indoor("kids_chair", 6, chair::chair),
    indoor("office_chair", 10, swivel::office_chair),
    indoor("gaming_chair", 5, swivel::gaming_chair),
    indoor("rocking_chair", 5, folding::rocking_chair),
    indoor("folding_chair", 4, folding::folding_chair),
    indoor("high_chair", 5, folding::high_chair),
    indoor("stool", 10, stool::stool),
    indoor("bar_stool", 9, stool::bar_stool),
    indoor("step_stool", 5, stool::step_stool),
    indoor("bench", 12, stool::bench),
    indoor("storage_bench", 6, stool::storage_bench),
    indoor("piano_bench", 5, stool::piano_bench),
    indoor("ottoman", 8, stool::ottoman),
    indoor("bean_bag", 5, stool::bean_bag),
];

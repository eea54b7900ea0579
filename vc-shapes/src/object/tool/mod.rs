//! Tools, sewing equipment, power strips, pets and pet equipment.

mod hand;
pub(in crate::object) mod pet;
mod pet_gear;
mod sewing;
mod workshop;

use super::rest::settled;
use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("toolbox", 4, workshop::toolbox),
    indoor("hammer", 4, hand::hammer),
    indoor("screwdriver", 4, hand::screwdriver),
    indoor("wrench", 3, hand::wrench),
    indoor("pliers", 3, hand::pliers),
    indoor("drill", 3, hand::drill),
    indoor("saw", 3, |b| settled(b, hand::saw)),
    indoor("utility_knife", 2, hand::knife),
    indoor("nail", 1, hand::nail),
    indoor("screw", 1, hand::nail),
    indoor("paint_can", 3, workshop::paint_can),
    indoor("rope", 2, workshop::rope),
    indoor("fire_extinguisher", 3, workshop::extinguisher),
    indoor("lighter", 2, workshop::lighter),
    indoor("matches", 2, workshop::matches),
    indoor("extension_cord", 3, workshop::power_strip),
    indoor("power_strip", 4, workshop::power_strip),
    indoor("battery", 3, workshop::battery),
    indoor("needle", 1, sewing::needle),
    indoor("thread", 2, sewing::thread),
    indoor("button", 2, sewing::button),
    indoor("sewing_kit", 2, sewing::kit),
    indoor("yarn", 3, |b| settled(b, sewing::yarn)),
    indoor("tape_measure", 2, sewing::tape_measure),
    indoor("clothespin", 2, sewing::clothespin),
    indoor("cat", 5, pet::cat),
    indoor("dog", 6, pet::dog),
    indoor("goldfish", 2, pet::goldfish),
    indoor("hamster", 2, pet::hamster),
    indoor("parrot", 3, pet::parrot),
    indoor("pet_cage", 3, pet_gear::cage),
    indoor("pet_bowl", 3, pet_gear::bowl),
    indoor("pet_carrier", 2, pet_gear::carrier),
    indoor("leash", 2, pet_gear::leash),
];

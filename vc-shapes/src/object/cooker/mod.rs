//! Kitchen units and appliances.

mod cool;
pub mod fitted;
pub(super) mod fitting;
mod heat;
mod pot;
mod prep;
mod sink;
mod small;
mod unit;
mod wash;

use super::rest::settled;
use super::{Generator, indoor};

pub(super) use unit::bathroom_counter;

pub(super) const GENERATORS: &[Generator] = &[
    // units
    indoor("kitchen_cabinet", 12, unit::kitchen_cabinet),
    indoor("kitchen_wall_cabinet", 10, unit::kitchen_wall_cabinet),
    indoor("kitchen_counter", 6, unit::kitchen_counter),
    indoor("kitchen_island", 6, unit::kitchen_island),
    indoor("backsplash", 4, unit::backsplash),
    indoor("kitchen_sink", 8, sink::kitchen_sink),
    indoor("sink", 5, sink::sink),
    indoor("utility_sink", 4, sink::utility_sink),
    // cooling
    indoor("fridge", 9, cool::fridge),
    indoor("mini_fridge", 5, cool::mini_fridge),
    indoor("freezer", 4, cool::freezer),
    indoor("chest_freezer", 4, cool::chest_freezer),
    indoor("wine_cooler", 4, cool::wine_cooler),
    indoor("commercial_fridge", 6, cool::commercial_fridge),
    indoor("blast_chiller", 5, cool::blast_chiller),
    indoor("ice_machine", 5, cool::ice_machine),
    indoor("refrigerated_counter", 5, cool::refrigerated_counter),
    // cooking
    indoor("stove", 9, heat::stove),
    indoor("hob", 6, heat::hob),
    indoor("oven", 6, heat::oven),
    indoor("steam_oven", 5, heat::steam_oven),
    indoor("pizza_oven", 5, heat::pizza_oven),
    indoor("microwave", 6, heat::microwave),
    indoor("toaster_oven", 4, heat::toaster_oven),
    indoor("extractor", 7, heat::extractor),
    indoor("kettle", 6, small::kettle),
    indoor("toaster", 6, small::toaster),
    indoor("coffee_maker", 6, small::coffee_maker),
    indoor("espresso_machine", 5, small::espresso_machine),
    indoor("coffee_grinder", 4, small::coffee_grinder),
    indoor("hot_plate", 4, pot::hot_plate),
    indoor("deep_fryer", 5, pot::deep_fryer),
    indoor("air_fryer", 4, pot::air_fryer),
    indoor("griddle", 5, pot::griddle),
    indoor("electric_grill", 4, pot::electric_grill),
    indoor("waffle_maker", 4, pot::waffle_maker),
    indoor("rice_cooker", 4, pot::rice_cooker),
    indoor("slow_cooker", 4, pot::slow_cooker),
    indoor("bread_maker", 4, pot::bread_maker),
    indoor("bain_marie", 5, pot::bain_marie),
    indoor("plate_warmer", 4, pot::plate_warmer),
    // preparing
    indoor("blender", 5, prep::blender),
    indoor("hand_blender", 3, prep::hand_blender),
    indoor("stand_mixer", 6, prep::stand_mixer),
    indoor("hand_mixer", 3, |b| settled(b, prep::hand_mixer)),
    indoor("food_processor", 4, prep::food_processor),
    indoor("juicer", 4, prep::juicer),
    indoor("citrus_juicer", 3, prep::citrus_juicer),
    indoor("meat_slicer", 5, prep::meat_slicer),
    indoor("meat_grinder", 4, prep::meat_grinder),
    indoor("ice_cream_maker", 3, prep::ice_cream_maker),
    indoor("vacuum_sealer", 4, prep::vacuum_sealer),
    indoor("kitchen_scale", 4, prep::kitchen_scale),
    indoor("water_dispenser", 4, prep::water_dispenser),
    indoor("garbage_disposal", 3, prep::garbage_disposal),
    // washing
    indoor("dishwasher", 6, wash::dishwasher),
    indoor("commercial_dishwasher", 5, wash::commercial_dishwasher),
    indoor("washing_machine", 6, wash::washing_machine),
    indoor("dryer", 4, wash::dryer),
];

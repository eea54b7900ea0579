//! Garden objects: fire and cooking, sheds, tools, decoration and furniture.

mod bag;
mod bird;
mod decor;
mod figure;
mod fire;
mod fountain;
mod grill;
mod hang;
mod motor;
mod pot;
mod roof;
mod seat;
mod shade;
mod shed;
mod store;
mod table;
mod tool;
mod water;

use super::park::bench;
use super::rest::settled;
use super::{Generator, outdoor};

pub(super) const GENERATORS: &[Generator] = &[
    // Fire and cooking.
    outdoor("campfire", 12, fire::campfire),
    outdoor("fire_pit", 12, fire::fire_pit),
    outdoor("firewood", 12, fire::firewood),
    outdoor("firewood_rack", 12, fire::firewood_rack),
    outdoor("barbecue", 16, grill::barbecue),
    outdoor("gas_grill", 12, grill::gas_grill),
    outdoor("smoker", 10, grill::smoker),
    outdoor("charcoal_bag", 8, bag::bag),
    outdoor("grill_tongs", 5, grill::grill_tongs),
    outdoor("gas_tank", 10, fire::gas_tank),
    outdoor("patio_heater", 8, fire::patio_heater),
    // Sheds and storage.
    outdoor("garden_shed", 60, shed::garden_shed),
    outdoor("garden_storage_box", 20, store::storage_box),
    outdoor("carport", 16, roof::carport),
    outdoor("greenhouse", 16, shed::greenhouse),
    outdoor("composter", 14, store::composter),
    outdoor("rain_barrel", 12, store::rain_barrel),
    outdoor("kennel", 14, shed::kennel),
    outdoor("rabbit_hutch", 12, shed::rabbit_hutch),
    outdoor("gazebo", 16, roof::gazebo),
    outdoor("awning", 10, roof::awning),
    outdoor("clothesline", 10, roof::clothesline),
    // Water and tools.
    outdoor("garden_hose", 12, water::garden_hose),
    outdoor("hose_reel", 10, water::hose_reel),
    outdoor("sprinkler", 8, water::sprinkler),
    outdoor("watering_can", 20, |b| settled(b, water::watering_can)),
    outdoor("wheelbarrow", 14, tool::wheelbarrow),
    outdoor("ladder", 12, tool::ladder),
    outdoor("step_ladder", 12, tool::step_ladder),
    outdoor("lawnmower", 14, motor::lawnmower),
    outdoor("ride_on_mower", 8, motor::ride_on_mower),
    outdoor("robot_mower", 8, motor::robot_mower),
    outdoor("hedge_trimmer", 6, motor::hedge_trimmer),
    outdoor("grass_trimmer", 6, motor::grass_trimmer),
    outdoor("leaf_blower", 6, motor::leaf_blower),
    outdoor("chainsaw", 6, motor::chainsaw),
    outdoor("axe", 8, tool::hand_tool),
    outdoor("rake", 8, |b| settled(b, tool::lying_tool)),
    outdoor("shovel", 8, tool::hand_tool),
    outdoor("spade", 8, tool::hand_tool),
    outdoor("garden_fork", 8, tool::hand_tool),
    outdoor("hoe", 6, |b| settled(b, tool::lying_tool)),
    outdoor("trowel", 6, tool::hand_tool),
    outdoor("pruning_shears", 6, tool::pruning_shears),
    outdoor("gardening_gloves", 5, tool::gloves),
    outdoor("fertilizer", 8, bag::bag),
    outdoor("potting_soil", 8, bag::bag),
    outdoor("seed_packet", 6, bag::seed_packet),
    // Decoration.
    outdoor("flower_pot", 120, pot::flower_pot),
    outdoor("planter", 100, pot::planter),
    outdoor("hanging_basket", 15, pot::hanging_basket),
    outdoor("garden_gnome", 20, figure::gnome),
    outdoor("bird_bath", 15, bird::bird_bath),
    outdoor("bird_feeder", 15, bird::bird_feeder),
    outdoor("bird_house", 15, bird::bird_house),
    outdoor("fountain", 20, fountain::fountain),
    outdoor("pond", 15, fountain::pond),
    outdoor("garden_statue", 25, figure::statue),
    outdoor("garden_lantern", 15, decor::lantern),
    outdoor("solar_light", 12, decor::solar_light),
    outdoor("wind_chime", 10, decor::wind_chime),
    outdoor("scarecrow", 10, figure::scarecrow),
    outdoor("weather_vane", 10, decor::weather_vane),
    // Furniture.
    outdoor("garden_chair", 40, seat::chair),
    outdoor("deck_chair", 15, seat::deck_chair),
    outdoor("sun_lounger", 15, seat::lounger),
    outdoor("adirondack_chair", 12, seat::adirondack),
    outdoor("garden_sofa", 30, seat::sofa),
    outdoor("garden_table", 40, table::table),
    outdoor("bistro_table", 15, table::table),
    outdoor("garden_bench", 40, bench::bench),
    outdoor("picnic_table", 15, table::picnic_table),
    outdoor("parasol", 20, shade::parasol),
    outdoor("parasol_base", 10, shade::parasol_base),
    outdoor("hammock", 10, hang::hammock),
    outdoor("porch_swing", 10, hang::porch_swing),
    outdoor("hanging_chair", 8, hang::hanging_chair),
];

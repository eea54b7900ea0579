//! Indoor toys, prams, skates and scooters, and the playground behind the house.

mod blocks;
mod cuddly;
mod figure;
mod pram;
mod roller;
mod room;
mod small;
mod vehicle;
mod yard;
mod yard_house;

use super::rest::settled;
use super::{Generator, indoor, outdoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("teddy_bear", 3, cuddly::cuddly),
    indoor("plush_toy", 4, cuddly::cuddly),
    indoor("doll", 3, figure::doll),
    indoor("puppet", 2, figure::puppet),
    indoor("action_figure", 2, figure::action_figure),
    indoor("toy_robot", 2, figure::robot),
    indoor("toy_dinosaur", 3, cuddly::dinosaur),
    indoor("toy_animal", 4, cuddly::animal),
    indoor("rocking_horse", 2, cuddly::rocking_horse),
    indoor("toy_car", 4, vehicle::car),
    indoor("rc_car", 2, vehicle::car),
    indoor("ride_on_car", 2, vehicle::ride_on),
    indoor("toy_truck", 2, vehicle::truck),
    indoor("toy_train", 2, vehicle::train),
    indoor("train_track", 2, vehicle::track),
    indoor("toy_airplane", 2, vehicle::airplane),
    indoor("toy_boat", 2, vehicle::boat),
    indoor("building_blocks", 3, blocks::wooden),
    indoor("toy_bricks", 2, blocks::bricks),
    indoor("stacking_rings", 2, blocks::rings),
    indoor("shape_sorter", 2, blocks::sorter),
    indoor("marble_run", 2, blocks::marble_run),
    indoor("marbles", 1, blocks::marbles),
    indoor("abacus", 2, blocks::abacus),
    indoor("spinning_top", 2, small::top),
    indoor("yo_yo", 1, small::yo_yo),
    indoor("baby_rattle", 2, small::rattle),
    indoor("rubber_duck", 1, small::duck),
    indoor("play_dough", 2, small::dough),
    indoor("toy_phone", 2, small::phone),
    indoor("toy_tea_set", 2, small::tea_set),
    indoor("toy_tool_set", 2, small::tool_set),
    indoor("water_gun", 2, |b| settled(b, small::water_gun)),
    indoor("bubble_wand", 1, small::bubble_wand),
    indoor("kite", 2, small::kite),
    indoor("sand_bucket", 2, small::bucket),
    indoor("sand_shovel", 2, small::shovel),
    indoor("dollhouse", 2, room::dollhouse),
    indoor("toy_kitchen", 2, room::kitchen),
    indoor("play_tent", 2, room::tent),
    indoor("play_mat", 3, room::mat),
    indoor("playpen", 2, room::playpen),
    indoor("baby_walker", 2, room::walker),
    indoor("baby_bouncer", 2, room::bouncer),
    indoor("kids_easel", 3, room::easel),
    indoor("doll_pram", 2, pram::pram),
    indoor("stroller", 4, pram::stroller),
    indoor("pram", 3, pram::pram),
    indoor("double_stroller", 2, pram::stroller),
    indoor("hoverboard", 2, roller::hoverboard),
    indoor("skateboard", 3, roller::skateboard),
    indoor("roller_skates", 2, roller::skates),
    indoor("kick_scooter", 2, roller::kick_scooter),
    outdoor("tricycle", 4, roller::tricycle),
    outdoor("balance_bike", 3, roller::balance_bike),
    outdoor("swing", 4, yard::swing),
    outdoor("swing_set", 4, yard::swing_set),
    outdoor("tire_swing", 3, yard::tire_swing),
    outdoor("slide", 4, yard::slide),
    outdoor("sandbox", 4, yard::sandbox),
    outdoor("trampoline", 4, yard::trampoline),
    outdoor("seesaw", 4, yard::seesaw),
    outdoor("climbing_frame", 4, yard::climbing_frame),
    outdoor("monkey_bars", 3, yard::monkey_bars),
    outdoor("spring_rider", 4, cuddly::spring_rider),
    outdoor("playground_carousel", 4, yard::carousel),
    outdoor("rope_ladder", 3, yard::rope_ladder),
    outdoor("zip_line", 2, yard::zip_line),
    outdoor("play_tunnel", 4, yard::tunnel),
    outdoor("croquet_set", 3, yard::croquet),
    outdoor("water_play_table", 4, yard::water_table),
    outdoor("play_tower", 4, yard_house::tower),
    outdoor("playhouse", 4, yard_house::playhouse),
    outdoor("tree_house", 4, yard_house::tree_house),
    outdoor("bouncy_castle", 4, yard_house::castle),
    outdoor("mud_kitchen", 4, yard_house::mud_kitchen),
];

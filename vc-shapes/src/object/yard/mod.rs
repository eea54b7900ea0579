//! Pools and bathing: pools, tubs, floats and cleaning equipment.

mod basin;
mod care;
mod edge;
mod float;
mod game;
mod worn;

use super::{Generator, outdoor};
use crate::material::*;

pub(super) const GENERATORS: &[Generator] = &[
    outdoor("pool", 50, basin::pool),
    outdoor("kiddie_pool", 20, basin::kiddie_pool),
    outdoor("jacuzzi", 16, basin::jacuzzi),
    outdoor("diving_board", 8, edge::diving_board),
    outdoor("pool_ladder", 8, edge::pool_ladder),
    outdoor("pool_slide", 8, edge::pool_slide),
    outdoor("pool_goal", 8, game::pool_goal),
    outdoor("pool_volleyball", 8, game::pool_volleyball),
    outdoor("pool_basketball", 8, game::pool_basketball),
    outdoor("pool_float", 12, float::pool_float),
    outdoor("swim_ring", 12, float::swim_ring),
    outdoor("buoy", 10, float::buoy),
    outdoor("pool_noodle", 6, float::pool_noodle),
    outdoor("beach_ball", 8, float::beach_ball),
    outdoor("pool_skimmer", 6, care::pool_skimmer),
    outdoor("pool_robot", 6, care::pool_robot),
    outdoor("pool_pump", 8, care::pool_pump),
    outdoor("pool_cover", 8, basin::pool_cover),
    outdoor("solar_shower", 8, edge::solar_shower),
    outdoor("diving_mask", 6, worn::diving_mask),
    outdoor("swim_fins", 6, worn::swim_fins),
    outdoor("life_jacket", 6, worn::life_jacket),
];

const BRIGHT: &[MaterialId] =
    &[RED_PLASTIC, YELLOW_PLASTIC, BLUE_PLASTIC, GREEN_PLASTIC, ORANGE_PLASTIC, PINK_PLASTIC, PURPLE_PLASTIC];

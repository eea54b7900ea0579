//! Storage: shelves, cabinets, racks, hooks and bins.

mod bin;
mod board;
mod cabinet;
pub(super) mod case;
pub(super) mod chest;
mod hall;
mod metal;
mod rack;
mod shelf;
mod wardrobe;

use super::table::trolley::ironing_board;
use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("bookshelf", 26, shelf::bookshelf),
    indoor("low_bookcase", 12, shelf::low_bookcase),
    indoor("corner_bookcase", 4, shelf::corner_bookcase),
    indoor("glass_door_bookcase", 6, cabinet::display),
    indoor("cube_shelf", 8, shelf::cube_shelf),
    indoor("shelf", 10, shelf::open_shelf),
    indoor("wall_shelf", 12, shelf::wall_shelf),
    indoor("storage_shelf", 7, metal::storage_shelf),
    indoor("garage_shelf", 7, metal::storage_shelf),
    indoor("kitchen_rack", 9, metal::kitchen_rack),
    indoor("plate_rack_cart", 4, metal::plate_rack_cart),
    indoor("pot_rack", 5, rack::pot_rack),
    indoor("wine_rack", 7, rack::wine_rack),
    indoor("magazine_rack", 4, rack::magazine_rack),
    indoor("shoe_rack", 7, rack::shoe_rack),
    indoor("drying_rack", 4, rack::drying_rack),
    indoor("clothes_rail", 4, rack::clothes_rail),
    indoor("plant_stand", 6, rack::plant_stand),
    indoor("ironing_board", 3, ironing_board),
    indoor("tv_stand", 16, cabinet::tv_stand),
    indoor("sideboard", 16, cabinet::sideboard),
    indoor("cabinet", 12, cabinet::cabinet),
    indoor("cupboard", 9, cabinet::cabinet),
    indoor("china_cabinet", 7, cabinet::display),
    indoor("dresser", 16, cabinet::dresser),
    indoor("kids_dresser", 6, cabinet::dresser),
    indoor("linen_cabinet", 6, cabinet::tall_cabinet),
    indoor("pantry_cabinet", 6, cabinet::tall_cabinet),
    indoor("utility_cabinet", 5, cabinet::tall_cabinet),
    indoor("laundry_cabinet", 5, cabinet::cabinet),
    indoor("shoe_cabinet", 9, cabinet::shoe_cabinet),
    indoor("filing_cabinet", 5, cabinet::office_drawers),
    indoor("drawer_pedestal", 5, cabinet::office_drawers),
    indoor("tool_cabinet", 5, cabinet::tool_cabinet),
    indoor("locker", 4, cabinet::locker),
    indoor("safe", 4, cabinet::safe),
    indoor("wardrobe", 20, wardrobe::wardrobe),
    indoor("closet", 7, wardrobe::wardrobe),
    indoor("closet_drawer", 4, wardrobe::closet_drawer),
    indoor("trunk", 6, bin::trunk),
    indoor("toy_box", 7, bin::toy_box),
    indoor("laundry_hamper", 6, bin::hamper),
    indoor("trash_can", 12, bin::trash_can),
    indoor("wastebasket", 6, bin::wastebasket),
    indoor("recycling_bin", 5, bin::recycling_bin),
    indoor("umbrella_stand", 5, bin::umbrella_stand),
    indoor("cat_litter_box", 4, bin::litter_box),
    indoor("pet_bed", 5, bin::pet_bed),
    indoor("scratching_post", 5, bin::scratching_post),
    indoor("coat_rack", 8, hall::coat_rack),
    indoor("wall_hook_rack", 9, hall::wall_hook_rack),
    indoor("hall_stand", 5, hall::hall_stand),
    indoor("key_holder", 5, hall::key_holder),
    indoor("room_divider", 6, board::room_divider),
    indoor("whiteboard", 4, board::whiteboard),
    indoor("bulletin_board", 4, board::bulletin_board),
    indoor("pegboard", 4, board::pegboard),
];

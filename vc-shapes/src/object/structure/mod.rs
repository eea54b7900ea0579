//! Parts of the building in walls: doors, windows with their curtains and blinds, switches, stairs
//! and railings, doors and buttons of lifts.

mod door;
mod fixed;
mod lift;
mod window;

pub(super) use window::pleated;

use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("door", 10, door::door),
    indoor("main_door", 6, door::main_door),
    indoor("sliding_door", 5, door::sliding_door),
    indoor("balcony_door", 5, door::balcony_door),
    indoor("lift_door", 3, lift::lift_door),
    indoor("garage_door", 3, door::garage_door),
    indoor("doorjamb", 2, door::doorjamb),
    indoor("doorknob", 3, door::doorknob),
    indoor("doorstep", 2, fixed::slab),
    indoor("window", 8, window::window),
    indoor("roof_window", 3, window::roof_window),
    indoor("windowsill", 2, fixed::slab),
    indoor("curtain", 8, window::curtain),
    indoor("curtain_rod", 4, window::curtain_rod),
    indoor("blinds", 8, window::blinds),
    indoor("roller_shutter", 3, window::roller_shutter),
    indoor("lightswitch", 5, fixed::lightswitch),
    indoor("powersocket", 5, fixed::powersocket),
    indoor("fuse_box", 3, fixed::fuse_box),
    indoor("column", 4, fixed::column),
    indoor("railing", 4, fixed::railing),
    indoor("banister", 3, fixed::railing),
    indoor("stairs", 4, fixed::stairs),
    indoor("ventilation_grille", 4, fixed::ventilation_grille),
    indoor("lift_panel", 2, lift::lift_panel),
    indoor("call_button", 2, lift::call_button),
    indoor("floor_button", 2, lift::floor_button),
];

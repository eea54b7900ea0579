//! Street furniture: fences, signs, lamps, bins and other objects along streets.

mod bin;
mod fence;
mod furniture;
mod lantern;
mod shelter;
mod sign;

use super::{Generator, outdoor};

pub(super) const GENERATORS: &[Generator] = &[
    outdoor("fence", 200, fence::fence),
    outdoor("garden_gate", 80, fence::gate),
    outdoor("mailbox", 80, bin::mailbox),
    outdoor("wheelie_bin", 60, bin::wheelie_bin),
    outdoor("street_bin", 80, bin::street_bin),
    outdoor("street_lamp", 100, lantern::street_lamp),
    outdoor("hydrant", 40, furniture::hydrant),
    outdoor("traffic_sign", 200, sign::traffic_sign),
    outdoor("traffic_light", 40, sign::traffic_light),
    outdoor("traffic_cone", 20, furniture::cone),
    outdoor("bollard", 40, furniture::bollard),
    outdoor("parking_meter", 25, furniture::parking_meter),
    outdoor("charging_station", 30, furniture::charging_station),
    outdoor("bus_stop", 25, shelter::bus_stop),
    outdoor("bicycle_rack", 30, shelter::bicycle_rack),
    outdoor("billboard", 30, sign::billboard),
    outdoor("phone_booth", 20, shelter::phone_booth),
    outdoor("manhole_cover", 15, furniture::manhole_cover),
    outdoor("curb", 25, furniture::curb),
    outdoor("dog_chain", 8, furniture::dog_chain),
];

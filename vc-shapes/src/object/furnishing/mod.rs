//! Radiators, climate devices, cleaning devices, and small devices on walls.

mod air;
mod clean;
mod heat;
mod wall;

use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("radiator", 8, heat::radiator),
    indoor("heater", 5, heat::heater),
    indoor("boiler", 3, heat::boiler),
    indoor("water_heater", 4, heat::water_heater),
    indoor("fireplace", 6, heat::fireplace),
    indoor("fan", 6, air::fan),
    indoor("ceiling_fan", 4, air::ceiling_fan),
    indoor("extractor_fan", 3, air::extractor_fan),
    indoor("air_conditioner", 4, air::air_conditioner),
    indoor("air_purifier", 4, air::air_purifier),
    indoor("humidifier", 4, air::humidifier),
    indoor("dehumidifier", 3, air::dehumidifier),
    indoor("vacuum_cleaner", 6, clean::vacuum_cleaner),
    indoor("robot_vacuum", 4, clean::robot_vacuum),
    indoor("steam_cleaner", 3, clean::steam_cleaner),
    indoor("iron", 4, clean::iron),
    indoor("garment_steamer", 3, clean::garment_steamer),
    indoor("sewing_machine", 4, clean::sewing_machine),
    indoor("thermostat", 4, wall::thermostat),
    indoor("smoke_detector", 3, wall::smoke_detector),
    indoor("doorbell", 4, wall::doorbell),
    indoor("intercom", 4, wall::intercom),
];

//! A map that parses is written and read as the same, and can be written in every form.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_map::format::{geojson, native, opendrive, sumo};
use vc_map::picture::Drawing;

fuzz_target!(|text: &str| {
    let Ok(map) = native::read(text) else { return };
    assert!(native::read(&native::write(&map)).is_ok_and(|again| again == map));
    map.validate();
    let _ = (sumo::write(&map, "map"), opendrive::write(&map), geojson::write(&map), Drawing::of(&map).svg(1.0));
});

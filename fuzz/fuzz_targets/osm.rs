//! A file of OpenStreetMap that parses gives a map, which is written and read as the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_map::format::native;
use vc_map::osm::{ImportOptions, OsmData};

fuzz_target!(|file: &[u8]| {
    let Ok(data) = OsmData::read(file) else { return };
    assert!(data.bytes() <= 20 * file.len() + (1 << 20));
    let Ok((draft, _)) = data.draft(&ImportOptions::default()) else { return };
    let Ok(map) = draft.build_of_file(file.len()) else { return };
    map.validate();
    assert!(native::read(&native::write(&map)).is_ok_and(|again| again == map));
});

//! A block of OpenStreetMap's PBF: the bytes are what one unpacks to, so that nothing has to be guessed that frames it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_map::osm::{ImportOptions, OsmData};

/// A field of bytes, of less than two megabytes.
fn field(number: u8, bytes: &[u8]) -> Vec<u8> {
    let length = bytes.len();
    let digits = [length as u8 | 128, (length >> 7) as u8 | 128, (length >> 14) as u8 & 127];
    [&[number << 3 | 2], &digits[..], bytes].concat()
}

fn block(kind: &[u8], content: &[u8]) -> Vec<u8> {
    let blob = field(1, content);
    let size = blob.len();
    let digits = [3 << 3, size as u8 | 128, (size >> 7) as u8 | 128, (size >> 14) as u8 & 127];
    let header = [&field(1, kind)[..], &digits].concat();
    [&(header.len() as u32).to_be_bytes()[..], &header, &blob].concat()
}

fuzz_target!(|content: &[u8]| {
    let content = &content[..content.len().min(1 << 20)];
    let file = [block(b"OSMHeader", &[]), block(b"OSMData", content)].concat();
    let Ok(data) = OsmData::from_pbf(&file) else { return };
    assert!(data.bytes() <= 20 * file.len() + (1 << 20));
    let Ok((draft, _)) = data.draft(&ImportOptions::default()) else { return };
    if let Ok(map) = draft.build_of_file(file.len()) {
        map.validate();
    }
});

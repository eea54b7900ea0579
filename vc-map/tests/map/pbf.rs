//! OpenStreetMap's PBF: an encoder for tests, and the reader held against that of XML.

use proptest::prelude::*;
use vc_map::osm::{ImportOptions, OsmData};
use vc_testkit::cases;

use crate::hostile::bound;
use crate::memory::most;

/// Whole numbers of variable length and fields of protocol buffers, as PBF has them.
pub(crate) mod pack {
    pub(crate) fn number(mut value: u64, to: &mut Vec<u8>) {
        while value > 0x7f {
            to.push(value as u8 | 0x80);
            value >>= 7;
        }
        to.push(value as u8);
    }

    pub(crate) fn bytes(field: u64, content: &[u8], to: &mut Vec<u8>) {
        number(field << 3 | 2, to);
        number(content.len() as u64, to);
        to.extend(content);
    }

    pub(crate) fn folded(value: i64) -> u64 {
        (value << 1) as u64 ^ (value >> 63) as u64
    }

    pub(crate) fn list(field: u64, values: impl Iterator<Item = u64>, to: &mut Vec<u8>) {
        let mut packed = Vec::new();
        values.for_each(|value| number(value, &mut packed));
        bytes(field, &packed, to);
    }

    /// Numbers as differences.
    pub(crate) fn differences(field: u64, values: &[i64], to: &mut Vec<u8>) {
        let before = std::iter::once(&0).chain(values);
        list(field, values.iter().zip(before).map(|(value, before)| folded(value - before)), to);
    }

    pub(crate) fn block(kind: &str, content: &[u8], zlib: bool) -> Vec<u8> {
        let mut blob = Vec::new();
        if zlib {
            use std::io::Write;
            let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
            packer.write_all(content).unwrap();
            bytes(3, &packer.finish().unwrap(), &mut blob);
        } else {
            bytes(1, content, &mut blob);
        }
        let mut header = Vec::new();
        bytes(1, kind.as_bytes(), &mut header);
        number(3 << 3, &mut header);
        number(blob.len() as u64, &mut header);
        [(header.len() as u32).to_be_bytes().to_vec(), header, blob].concat()
    }
}

/// The two ends of a street with lights at one, and a building's relation, as PBF.
fn pbf(zlib: bool, dense: bool) -> Vec<u8> {
    let words = ["", "highway", "residential", "traffic_signals", "type", "restriction", "from"];
    let mut table = Vec::new();
    words.iter().for_each(|word| pack::bytes(1, word.as_bytes(), &mut table));
    let (ids, latitudes, longitudes) =
        ([5i64, 2, 9], [481_000_000i64, 481_010_000, 481_000_500], [-115_000_000i64, -115_010_000, -115_020_000]);
    let mut nodes = Vec::new();
    if dense {
        let mut message = Vec::new();
        pack::differences(1, &ids, &mut message);
        pack::differences(8, &latitudes, &mut message);
        pack::differences(9, &longitudes, &mut message);
        pack::list(10, [0, 1, 3, 0, 0].into_iter(), &mut message);
        pack::bytes(2, &message, &mut nodes);
    } else {
        for index in 0..3 {
            let mut message = Vec::new();
            for (field, value) in [(1, ids[index]), (8, latitudes[index]), (9, longitudes[index])] {
                pack::number(field << 3, &mut message);
                pack::number(pack::folded(value), &mut message);
            }
            let marked = u64::from(index == 1);
            pack::list(2, (0..marked).map(|_| 1), &mut message);
            pack::list(3, (0..marked).map(|_| 3), &mut message);
            pack::bytes(1, &message, &mut nodes);
        }
    }
    let (mut way, mut relation, mut others) = (vec![1 << 3, 7], vec![1 << 3, 8], Vec::new());
    pack::list(2, [1].into_iter(), &mut way);
    pack::list(3, [2].into_iter(), &mut way);
    pack::differences(8, &[5, 2, 9], &mut way);
    pack::list(2, [4].into_iter(), &mut relation);
    pack::list(3, [5].into_iter(), &mut relation);
    pack::list(8, [6].into_iter(), &mut relation);
    pack::differences(9, &[7], &mut relation);
    pack::list(10, [1].into_iter(), &mut relation);
    pack::bytes(3, &way, &mut others);
    pack::bytes(4, &relation, &mut others);
    let mut block = Vec::new();
    pack::bytes(1, &table, &mut block);
    pack::bytes(2, &nodes, &mut block);
    pack::bytes(2, &others, &mut block);
    let mut header = Vec::new();
    pack::bytes(4, b"OsmSchema-V0.6", &mut header);
    pack::bytes(4, b"DenseNodes", &mut header);
    [pack::block("OSMHeader", &header, zlib), pack::block("OSMData", &block, zlib)].concat()
}

#[test]
fn pbf_and_xml_of_the_same_content_give_the_same_map() {
    let xml = br#"<osm><node id="5" lat="48.1" lon="-11.5"/><node id="2" lat="48.101" lon="-11.501"><tag k="highway" v="traffic_signals"/></node>
        <node id="9" lat="48.10005" lon="-11.502"/><way id="7"><nd ref="5"/><nd ref="2"/><nd ref="9"/><tag k="highway" v="residential"/></way>
        <relation id="8"><member type="way" ref="7" role="from"/><tag k="type" v="restriction"/></relation></osm>"#;
    let same = OsmData::read(xml).unwrap().draft(&ImportOptions::default()).unwrap();
    assert_eq!(same.0.roads.len(), 2);
    for (zlib, dense) in [(false, false), (true, false), (false, true), (true, true)] {
        let read = OsmData::read(&pbf(zlib, dense)).unwrap();
        assert_eq!(read.counts(), [3, 1, 1]);
        assert!(read.draft(&ImportOptions::default()).unwrap() == same, "{zlib} {dense}");
    }
}

#[test]
fn blocks_that_unpack_to_far_too_much_are_refused() {
    let header = pack::block("OSMHeader", &[], false);
    let zeros = vec![0; 30 << 20];
    let mut dense = Vec::new();
    pack::list(1, std::iter::repeat_n(2, 1 << 20), &mut dense);
    pack::list(8, std::iter::repeat_n(0, 1 << 20), &mut dense);
    pack::list(9, std::iter::repeat_n(0, 1 << 20), &mut dense);
    let (mut group, mut block) = (Vec::new(), Vec::new());
    pack::bytes(2, &dense, &mut group);
    pack::bytes(2, &group, &mut block);
    for content in [zeros, block] {
        let file = [header.clone(), pack::block("OSMData", &content, true)].concat();
        assert!(file.len() < 100_000);
        let error = OsmData::from_pbf(&file).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("byte {}: a block is not packed by zlib, or unpacks to far more", header.len())),
            "{error}"
        );
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn pbf_survives_any_change(at in 0usize..400, byte: u8, cut in 0usize..400, zlib: bool, dense: bool) {
        let mut file = pbf(zlib, dense);
        let length = file.len();
        file[at % length] = byte;
        file.truncate(cut.max(at % length));
        let mut short = pbf(false, dense);
        short.truncate(cut);
        for bytes in [file, short] {
            let (most, read) = most(|| OsmData::from_pbf(&bytes));
            prop_assert!(most <= bound(&bytes), "{} for {}", most, bytes.len());
            let Ok(data) = read else { continue };
            let Ok((draft, _)) = data.draft(&ImportOptions::default()) else { continue };
            if let Ok(map) = draft.build() {
                map.validate();
            }
        }
    }
}

//! Files that are made to take all time or all memory.

use std::fmt::Write;

use vc_map::osm::{ImportOptions, OsmData};

use crate::memory::most;
use crate::pbf::pack;

/// The most bytes that a reader may have in use for a file: twenty times its size, and a fixed part.
pub(crate) fn bound(file: &[u8]) -> usize {
    20 * file.len() + (1 << 20)
}

fn draft(text: &str) -> (usize, usize) {
    let data = OsmData::from_xml(text.as_bytes()).unwrap();
    let (bytes, made) = most(|| data.draft(&ImportOptions::default()));
    (bytes, made.map_or(0, |(draft, _)| draft.roads.len()))
}

#[test]
fn parallel_tracks_before_a_signal_are_walked_once() {
    let mut text = r#"<osm><node id="1" lat="48" lon="11"><tag k="highway" v="traffic_signals"/></node>
        <node id="2" lat="48.00001" lon="11"/>"#
        .to_owned();
    for id in 1..=3 {
        write!(text, r#"<way id="{id}"><nd ref="1"/><nd ref="2"/><tag k="highway" v="track"/></way>"#).unwrap();
    }
    assert_eq!(draft(&(text + "</osm>")).1, 3);
}

#[test]
fn a_way_that_a_relation_names_again_and_again_is_part_of_it_once() {
    let refs = r#"<nd ref="1"/>"#.repeat(10_000);
    let members = r#"<member type="way" ref="1" role="outer"/>"#.repeat(10_000);
    let tags = r#"<tag k="type" v="multipolygon"/><tag k="building" v="yes"/>"#;
    let node = r#"<node id="1" lat="48" lon="11"/>"#;
    let text = format!(r#"<osm>{node}<way id="1">{refs}</way><relation id="1">{members}{tags}</relation></osm>"#);
    let (bytes, _) = draft(&text);
    assert!(bytes <= bound(text.as_bytes()), "{bytes}");
}

#[test]
fn a_way_that_many_relations_name_does_not_make_a_file_large() {
    let place = |id: usize| {
        let angle = id as f64 * std::f64::consts::TAU / 2000.0;
        let (lat, lon) = (48.0 + 0.01 * angle.sin(), 11.0 + 0.01 * angle.cos());
        format!(r#"<node id="{id}" lat="{lat:.6}" lon="{lon:.6}"/>"#)
    };
    let nodes: String = (0..2000).map(place).collect();
    let refs: String = (0..2000).chain([0]).map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
    let relation = |id: usize| {
        format!(
            r#"<relation id="{id}"><member type="way" ref="1" role=""/><tag k="type" v="multipolygon"/><tag k="natural" v="water"/></relation>"#
        )
    };
    let relations: String = (0..2000).map(relation).collect();
    let text = format!(r#"<osm>{nodes}<way id="1">{refs}</way>{relations}</osm>"#);
    let (bytes, _) = draft(&text);
    assert!(bytes <= bound(text.as_bytes()), "{bytes} for {}", text.len());
}

/// A file of PBF with a block of these words and the elements of this message.
fn blocks(words: &[&[u8]], group: &[u8], zlib: bool) -> Vec<u8> {
    let (mut table, mut block) = (Vec::new(), Vec::new());
    words.iter().for_each(|word| pack::bytes(1, word, &mut table));
    pack::bytes(1, &table, &mut block);
    pack::bytes(2, group, &mut block);
    [pack::block("OSMHeader", &[], false), pack::block("OSMData", &block, zlib)].concat()
}

/// A way with as many tags as there are numbers of words.
fn way(words: impl Iterator<Item = u64> + Clone) -> Vec<u8> {
    let (mut way, mut group) = (vec![1 << 3, 7], Vec::new());
    pack::list(2, words.clone(), &mut way);
    pack::list(3, words, &mut way);
    pack::bytes(3, &way, &mut group);
    group
}

#[test]
fn a_long_word_that_is_named_often_is_looked_at_once() {
    let word = "x".repeat(1_000_000);
    let file = blocks(&[b"", word.as_bytes()], &way(std::iter::repeat_n(1, 500_000)), false);
    let (bytes, data) = most(|| OsmData::from_pbf(&file));
    assert!(bytes <= bound(&file), "{bytes}");
    assert_eq!(data.unwrap().counts(), [0, 1, 0]);
}

#[test]
fn long_words_whose_hashes_collide_are_kept_once() {
    // These two collide in FNV-1a of 64 bits, and so do all texts that begin with them and go on alike.
    let end = "x".repeat(1_000_000);
    let words = ["8yn0iYCKYHlIj4-BwPqk", "GReLUrM4wMqfg9yzV3KQ"].map(|word| word.to_owned() + &end);
    let file =
        blocks(&[b"", words[0].as_bytes(), words[1].as_bytes()], &way([1, 2].into_iter().cycle().take(200)), false);
    let (bytes, data) = most(|| OsmData::from_pbf(&file));
    assert!(bytes <= bound(&file), "{bytes}");
    assert!(data.is_ok());
}

#[test]
fn blocks_of_the_smallest_elements_are_refused_before_they_take_much() {
    // Noise, so that the block unpacks to little more than it has, or not at all; behind it elements of no content.
    let mut noise = 1u64;
    let mut noise = || {
        noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (noise >> 33) as u8
    };
    for (count, padding) in [(500_000, 100_000), (500_000, 0), (3_000_000, 400_000)] {
        for zlib in [true, false] {
            let words: Vec<u8> = (0..padding).map(|_| noise()).collect();
            // Nodes, ways and relations without a number, of two bytes each.
            for kind in [1u8, 3, 4] {
                let group: Vec<u8> = [kind << 3 | 2, 0].repeat(count);
                let file = blocks(&[&words], &group, zlib);
                let (bytes, _) = most(|| OsmData::from_pbf(&file));
                assert!(bytes <= bound(&file), "{kind} {count} {padding} {zlib}: {bytes} for {}", file.len());
            }
            let words: Vec<&[u8]> = vec![b""; count];
            let file = blocks(&words, &[], zlib);
            let (bytes, _) = most(|| OsmData::from_pbf(&file));
            assert!(bytes <= bound(&file), "words {count} {zlib}: {bytes} for {}", file.len());
        }
    }
}

#[test]
fn ten_megabytes_of_garbage_are_refused_by_every_reader() {
    let mut byte = 1u32;
    let noise: Vec<u8> = (0..10_000_000)
        .map(|_| {
            byte = byte.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (byte >> 24) as u8
        })
        .collect();
    let framed =
        |content: &[u8]| [pack::block("OSMHeader", &[], false), pack::block("OSMData", content, false)].concat();
    for file in [noise.clone(), vec![0; 10_000_000], framed(&noise), framed(&[0xff; 10_000_000])] {
        let (bytes, read) = most(|| OsmData::from_pbf(&file));
        let error = read.map(|data| data.counts()).unwrap_err().to_string();
        assert!(bytes <= bound(&file) && error.starts_with("byte "), "{bytes} {error}");
    }
    for file in
        [noise, b"<".repeat(10_000_000), b"<a>".repeat(3_333_333), b"<osm>".repeat(2_000_000), b"x\n".repeat(5_000_000)]
    {
        let (bytes, read) = most(|| OsmData::from_xml(&file));
        let error = read.map(|data| data.counts()).unwrap_err().to_string();
        assert!(bytes <= bound(&file) && error.contains("line "), "{bytes} {error}");
    }
    for text in ["[".repeat(10_000_000), "{\"virtualcity_map\":1,\"map\":".repeat(400_000), "x\n".repeat(5_000_000)] {
        let (bytes, read) = most(|| vc_map::format::native::read(&text).map(|_| ()));
        assert!(bytes <= bound(text.as_bytes()), "{bytes}");
        assert!(read.unwrap_err().to_string().starts_with("line "));
    }
}

#[test]
fn packed_files_take_at_most_twenty_times_their_bytes() {
    let nodes: String = (0..20_000).map(|id| format!(r#"<node id="{id}" lat="1" lon="1"/>"#)).collect();
    let refs: String = (0..20_000).map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
    let tags: String = (0..20_000).map(|id| format!(r#"<tag k="{id}" v=""/>"#)).collect();
    let ways =
        r#"<way id="1"/>"#.to_owned() + &(0..20_000).map(|id| format!(r#"<way id="{id}"/>"#)).collect::<String>();
    for content in [nodes, format!(r#"<way id="1">{refs}</way>"#), format!(r#"<way id="1">{tags}</way>"#), ways] {
        let file = format!("<osm>{content}</osm>");
        let (bytes, read) = most(|| OsmData::from_xml(file.as_bytes()));
        assert!(read.is_ok() && bytes <= 20 * file.len(), "{bytes} for {}", file.len());
    }
}

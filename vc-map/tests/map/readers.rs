//! Readers survive everything: property tests of each.

use proptest::prelude::*;
use vc_map::format::native;
use vc_map::osm::{ImportOptions, OsmData};
use vc_testkit::cases;

use crate::hostile::bound;
use crate::memory::most;

/// Words of which files consist, so that random texts come far.
const WORDS: [&str; 24] = [
    "<osm>",
    "</osm>",
    "<node id=\"",
    "<way id=\"",
    "<nd ref=\"",
    "\"/>",
    "\">",
    "</way>",
    "</node>",
    "1",
    "2",
    "3",
    "-9",
    "\" lat=\"",
    "\" lon=\"",
    "48.1",
    "1e300",
    "<tag k=\"highway\" v=\"residential\"/>",
    "<tag k=\"lanes\" v=\"9\"/>",
    "<relation id=\"5\">",
    "</relation>",
    "<member type=\"way\" ref=\"",
    "\u{fffd}",
    "&#x;",
];

/// Tags of ways and of nodes.
const WAYS: [&str; 20] = [
    "highway=primary",
    "highway=residential",
    "highway=footway",
    "highway=service access=private",
    "highway=motorway_link",
    "highway=cycleway",
    "highway=living_street",
    "highway=steps",
    "highway=track",
    "highway=busway oneway=-1",
    "highway=tertiary oneway=-1 lanes=2 cycleway:left=lane",
    "highway=secondary lanes=4 turn:lanes:forward=left|through turn:lanes=left||right",
    "highway=secondary lanes=3 lanes:both_ways=1",
    "highway=unclassified oneway=yes oneway:bicycle=no lanes:backward=1 busway=opposite_lane",
    "highway=trunk lanes=3 bicycle:lanes=|designated|| bus:lanes=||designated oneway=yes",
    "highway=residential bridge=yes parking:both=diagonal lanes=1",
    "highway=residential junction=roundabout",
    "railway=tram",
    "highway=pedestrian area=yes",
    "building=yes",
];
const MARKS: [&str; 14] = [
    "",
    "highway=traffic_signals",
    "highway=traffic_signals traffic_signals:direction=backward",
    "highway=traffic_signals crossing=traffic_signals",
    "highway=crossing crossing=traffic_signals",
    "highway=crossing crossing=zebra",
    "highway=stop stop=all",
    "highway=stop direction=backward",
    "highway=give_way",
    "highway=mini_roundabout",
    "barrier=gate",
    "entrance=main",
    "barrier=bollard",
    "highway=bus_stop",
];

fn tags(text: &str) -> String {
    let tag = |(key, value): (&str, &str)| format!(r#"<tag k="{key}" v="{value}"/>"#);
    text.split_whitespace().filter_map(|tag| tag.split_once('=')).map(tag).collect()
}

fn survives(file: &[u8]) {
    let (bytes, read) = most(|| OsmData::from_xml(file));
    assert!(bytes <= bound(file), "{bytes} for {}", file.len());
    let Ok(data) = read else { return };
    let Ok((draft, _)) = data.draft(&ImportOptions::default()) else { return };
    if let Ok(map) = draft.build_of_file(file.len()) {
        map.validate();
        assert!(native::read(&native::write(&map)).unwrap() == map);
    }
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn osm_survives_any_change_of_a_real_file(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..30),
        from in any::<prop::sample::Index>(),
        onto in any::<prop::sample::Index>(),
        length in 0usize..5000,
    ) {
        let mut file = include_bytes!("../../data/riverside.osm").to_vec();
        // Mostly characters that a number or a word could have, so that many files can still be read.
        changes.iter().for_each(|(at, byte)| *at.get_mut(&mut file) = b"0123456789.-ab \"<>/="[*byte as usize % 20]);
        survives(&file);
        // A stretch of it in another place.
        let (from, onto) = (from.index(file.len()), onto.index(file.len()));
        let piece = file[from..file.len().min(from + length)].to_vec();
        file.splice(onto..onto, piece);
        survives(&file);
    }
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn osm_survives_any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        survives(&bytes);
    }

    #[test]
    fn osm_survives_any_order_of_its_words(words in prop::collection::vec(0usize..24, 0..60)) {
        survives(format!("<osm>{}</osm>", words.into_iter().map(|word| WORDS[word]).collect::<String>()).as_bytes());
    }

    #[test]
    fn osm_survives_any_streets(
        nodes in prop::collection::vec((-300i32..300, -300i32..300), 2..14),
        ways in prop::collection::vec((prop::collection::vec(0usize..14, 2..8), 0..WAYS.len()), 1..12),
        marks in prop::collection::vec(0..MARKS.len(), 14),
    ) {
        let mut text = "<osm>".to_owned();
        for (id, (x, y)) in nodes.iter().enumerate() {
            let (lat, lon) = (48.0 + f64::from(*y) * 1e-6, 11.0 + f64::from(*x) * 1e-6);
            text += &format!(r#"<node id="{id}" lat="{lat}" lon="{lon}">{}</node>"#, tags(MARKS[marks[id]]));
        }
        for (id, (refs, kind)) in ways.iter().enumerate() {
            let refs: String = refs.iter().map(|node| format!(r#"<nd ref="{node}"/>"#)).collect();
            text += &format!(r#"<way id="{id}">{refs}{}</way>"#, tags(WAYS[*kind]));
        }
        survives((text + "</osm>").as_bytes());
    }

    #[test]
    fn own_maps_survive_any_text(text in ".{0,200}") {
        let _ = native::read(&text);
        let _ = native::read(&format!(r#"{{"virtualcity_map": 1, "map": {text}}}"#));
    }
}

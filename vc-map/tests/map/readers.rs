//! Readers survive everything: property tests of each.

use proptest::prelude::*;
use vc_map::format::native;
use vc_map::osm::{ImportOptions, OsmData};
use vc_testkit::cases;

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

fn survives(file: &[u8]) {
    let Ok(data) = OsmData::from_xml(file) else { return };
    assert!(data.bytes() <= 20 * file.len() + 4096);
    let Ok((draft, _)) = data.draft(&ImportOptions::default()) else { return };
    if let Ok(map) = draft.build() {
        map.validate();
        assert!(native::read(&native::write(&map)).unwrap() == map);
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
        ways in prop::collection::vec((prop::collection::vec(0usize..14, 2..8), 0usize..8), 1..12),
    ) {
        let kinds = [
            "primary", "residential", "footway", "service", "motorway_link", "cycleway", "living_street", "steps",
        ];
        let mut text = "<osm>".to_owned();
        for (id, (x, y)) in nodes.iter().enumerate() {
            let (lat, lon) = (48.0 + f64::from(*y) * 1e-6, 11.0 + f64::from(*x) * 1e-6);
            let lights = if id % 3 == 0 { r#"<tag k="highway" v="traffic_signals"/>"# } else { "" };
            text += &format!(r#"<node id="{id}" lat="{lat}" lon="{lon}">{lights}</node>"#);
        }
        for (id, (refs, kind)) in ways.iter().enumerate() {
            let refs: String = refs.iter().map(|node| format!(r#"<nd ref="{node}"/>"#)).collect();
            text += &format!(r#"<way id="{id}">{refs}<tag k="highway" v="{}"/></way>"#, kinds[*kind]);
        }
        survives((text + "</osm>").as_bytes());
    }

    #[test]
    fn own_maps_survive_any_text(text in ".{0,200}") {
        let _ = native::read(&text);
        let _ = native::read(&format!(r#"{{"virtualcity_map": 1, "map": {text}}}"#));
    }
}

#[test]
fn ten_megabytes_of_garbage_are_refused() {
    let mut byte = 1u32;
    let noise: Vec<u8> = (0..10_000_000)
        .map(|_| {
            byte = byte.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (byte >> 24) as u8
        })
        .collect();
    for file in
        [noise, b"<".repeat(10_000_000), b"<a>".repeat(3_333_333), b"<osm>".repeat(2_000_000), b"x\n".repeat(5_000_000)]
    {
        let error = OsmData::from_xml(&file).unwrap_err().to_string();
        assert!(error.contains("line "), "{error}");
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
        let data = OsmData::from_xml(file.as_bytes()).unwrap();
        assert!(data.bytes() <= 20 * file.len(), "{} {}", data.bytes(), file.len());
    }
}

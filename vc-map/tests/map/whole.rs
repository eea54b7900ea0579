//! The memory of a whole run, from the bytes of a file to a map: everything that is in use at a time is counted.

use vc_map::format::native;
use vc_map::osm::{ImportOptions, OsmData};
use vc_map::{Control, MapDraft, RoadClass};
use vc_testkit::{data, skipped};

use crate::memory::most;
use crate::pbf::pack;
use crate::town::street;

/// The most bytes in use while a file of OpenStreetMap's is read and a map made of it, and whether one came of it.
fn of_osm(file: &[u8]) -> (usize, bool) {
    let map = || {
        let (draft, _) = OsmData::read(file).ok()?.draft(&ImportOptions::default()).ok()?;
        draft.build_of_file(file.len()).ok()
    };
    let (bytes, map) = most(map);
    (bytes, map.is_some())
}

fn of_own(text: &str) -> (usize, bool) {
    let (bytes, map) = most(|| native::read(text));
    (bytes, map.is_ok())
}

/// That a run takes at most sixteen megabytes and twenty times the file.
fn holds(name: &str, size: usize, (bytes, _): (usize, bool)) {
    assert!(bytes <= 20 * size + (16 << 20), "{name}: {bytes} for {size}");
}

/// A map of the own form with one long list of some name.
fn own(list: &str, item: &str) -> String {
    let items = format!("\"{list}\":[{}]", vec![item; 2_000_000 / item.len()].join(","));
    let strip = |users: &str| format!(r#"{{"kind":"path","width":1,{users},"limit":1}}"#);
    let road = |line: &str, strips: &str, rest: &str| {
        format!(
            r#""junctions":[{{"at":[0,0]}},{{"at":[9,9]}}],"roads":[{{"from":0,"to":1,"class":"path",{line},"section":{{{strips}}}{rest}}}]"#
        )
    };
    let (line, feet) = (r#""line":[[0,0],[9,9]]"#, format!("\"forward\":[{}]", strip(r#""users":["foot"]"#)));
    let content = match list {
        "courts" => {
            format!(
                r#""buildings":[{{"height":3,"base":0,"storeys":1,"kind":"yes","outline":[[0,0],[1,0],[0,1]],{items}}}]"#
            )
        }
        "line" => road(&items, &feet, ""),
        "source" => road(line, &feet, &format!(",{items}")),
        "users" => road(line, &format!("\"forward\":[{}]", strip(&items)), ""),
        "forward" => road(line, &items, ""),
        _ => items,
    };
    format!(r#"{{"virtualcity_map":1,"map":{{"name":"","origin":{{"latitude":0,"longitude":0}},{content}}}}}"#)
}

#[test]
fn own_maps_take_at_most_twenty_times_their_text() {
    let building = r#"{"outline":[[0,0],[1,0],[0,1]],"height":3,"base":0,"storeys":1,"kind":"y"}"#;
    for (list, item) in [
        ("courts", "[]"),
        ("courts", "[[0,0],[1,0],[0,1]]"),
        ("line", "[0,0]"),
        ("line", "[0,1],[1,0]"),
        ("source", "0"),
        ("users", "\"foot\""),
        ("users", "\"\""),
        ("forward", r#"{"kind":"path","width":1,"users":[],"limit":1}"#),
        ("junctions", r#"{"at":[0,0]}"#),
        ("bans", r#"{"from":0,"at":0,"to":0}"#),
        ("buildings", building),
        ("areas", r#"{"kind":"water","outline":[]}"#),
        ("stops", r#"{"kind":"bus","at":[0,0]}"#),
        ("stops", "[[[[[["),
    ] {
        let text = own(list, item);
        holds(&format!("{list} {item}"), text.len(), of_own(&text));
    }
    for text in ["[".repeat(1_000_000), "\"".repeat(1_000_000), format!("{{\"{}\":1}}", "x".repeat(1_000_000))] {
        holds("garbage", text.len(), of_own(&text));
        let inside = format!(r#"{{"virtualcity_map":1,"map":{text}}}"#);
        holds("garbage within", inside.len(), of_own(&inside));
    }
}

#[test]
fn a_small_map_takes_no_more() {
    let mut draft = MapDraft::new("star", 48.0, 11.0);
    let middle = draft.junction([0.0, 0.0], Control::Signals);
    for arm in 0..8 {
        let (y, x) = (f64::from(arm) * std::f64::consts::TAU / 8.0).sin_cos();
        let end = draft.junction([150.0 * x, 150.0 * y], Control::Edge);
        draft.road(end, middle, RoadClass::Secondary, street(8));
    }
    let text = native::write(&draft.build().unwrap());
    holds("a junction of 64 lanes", text.len(), of_own(&text));
    holds("empty", 10, of_osm(b"<osm></osm>"));
}

#[test]
fn files_of_openstreetmap_take_at_most_twenty_times_their_size() {
    let town = include_bytes!("../../data/riverside.osm").to_vec();
    let extract = |name| Some((name, data::text(&format!("osm/{name}.osm.gz"))?.into_bytes()));
    let real: Vec<_> = ["munich_altstadt", "midtown", "leeds_cycleway"].into_iter().filter_map(extract).collect();
    if real.is_empty() {
        skipped("the extracts of the shared data are not there");
    }
    for (name, file) in [("the town", town)].into_iter().chain(real) {
        holds(name, file.len(), of_osm(&file));
        let (draft, _) = OsmData::read(&file).unwrap().draft(&ImportOptions::default()).unwrap();
        let own = native::write(&draft.build().unwrap());
        holds(&format!("{name}, own form"), own.len(), of_own(&own));
    }
}

/// Ways of two nodes each, and the tags of every one, as PBF or as XML.
fn ways(count: u64, tags: &[(&str, &str)], packed: bool) -> Vec<u8> {
    let place = |id: u64| (48.0 + id as f64 * 1e-5, 11.0);
    if !packed {
        let tags: String = tags.iter().map(|(key, value)| format!(r#"<tag k="{key}" v="{value}"/>"#)).collect();
        let node = |id| format!(r#"<node id="{id}" lat="{:.5}" lon="{}"/>"#, place(id).0, place(id).1);
        let nodes: String = (0..=count).map(node).collect();
        let refs = |id: u64| format!(r#"<way id="{id}"><nd ref="{id}"/><nd ref="{}"/>{tags}</way>"#, id + 1);
        return format!("<osm>{nodes}{}</osm>", (0..count).map(refs).collect::<String>()).into_bytes();
    }
    let (mut table, mut dense, mut group, mut block) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    pack::bytes(1, b"", &mut table);
    tags.iter()
        .for_each(|(key, value)| [key, value].into_iter().for_each(|word| pack::bytes(1, word.as_bytes(), &mut table)));
    let ids: Vec<i64> = (0..=count as i64).collect();
    pack::differences(1, &ids, &mut dense);
    pack::differences(8, &ids.iter().map(|id| 480_000_000 + id * 100).collect::<Vec<_>>(), &mut dense);
    pack::differences(9, &ids.iter().map(|_| 110_000_000).collect::<Vec<_>>(), &mut dense);
    pack::bytes(2, &dense, &mut group);
    for id in 0..count {
        let mut way = vec![1 << 3];
        pack::number(id, &mut way);
        pack::list(2, (0..tags.len() as u64).map(|tag| 2 * tag + 1), &mut way);
        pack::list(3, (0..tags.len() as u64).map(|tag| 2 * tag + 2), &mut way);
        pack::differences(8, &[id as i64, id as i64 + 1], &mut way);
        pack::bytes(3, &way, &mut group);
    }
    pack::bytes(1, &table, &mut block);
    pack::bytes(2, &group, &mut block);
    [pack::block("OSMHeader", &[], false), pack::block("OSMData", &block, false)].concat()
}

#[test]
fn long_words_and_many_lanes_of_many_ways_take_no_more() {
    let (long, longer) = ("x".repeat(1_000_000), "ж".repeat(500_000));
    let road = ("highway", "residential");
    for (name, tags) in [
        ("names", vec![road, ("name", &long)]),
        ("other names", vec![("name", &longer), road]),
        ("lanes", vec![road, ("lanes", "40"), ("oneway", "no")]),
        (
            "values of no use",
            vec![road, ("lanes", &long), ("oneway", &long), ("access", &long), ("maxspeed", &long), ("layer", &long)],
        ),
        ("buildings", vec![("building", "yes"), ("name", &long), ("addr:street", &long)]),
    ] {
        for packed in [true, false] {
            let count = if !packed && tags.iter().any(|tag| tag.1.len() > 1000) { 5 } else { 20_000 };
            let file = ways(count, &tags, packed);
            holds(&format!("{name}, packed: {packed}"), file.len(), of_osm(&file));
        }
    }
    // One way with a long name that others cut in pieces.
    let node = |id: u32| format!(r#"<node id="{id}" lat="{:.5}" lon="11"/>"#, 48.0 + f64::from(id) * 1e-5);
    let nodes: String = (0..10_000).map(node).collect();
    let refs: String = (0..10_000).map(|id| format!(r#"<nd ref="{id}"/>"#)).collect();
    let name = format!(r#"<tag k="name" v="{long}"/>"#);
    let ways: String = ["residential", "service"]
        .iter()
        .zip(1..)
        .map(|(class, id)| format!(r#"<way id="{id}">{refs}<tag k="highway" v="{class}"/>{name}</way>"#))
        .collect();
    let file = format!("<osm>{nodes}{ways}</osm>");
    holds("pieces", file.len(), of_osm(file.as_bytes()));
}
